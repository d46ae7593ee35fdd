//! `plan`: units and figures of scenes, for people and as JSON, and refusals.

mod common;

use common::{keys, Folder};
use serde_json::Value;

fn scene(name: &str) -> String {
    format!("{}/../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

fn needed(v: &Value, unit: &str) -> bool {
    let units = v["units"].as_array().unwrap();
    let unit = units.iter().find(|u| u["unit"] == unit).unwrap();
    assert!(!unit["because"].as_str().unwrap().is_empty());
    unit["needed"].as_bool().unwrap()
}

#[test]
fn units_follow_from_the_scene() {
    let f = Folder::new();
    let plan = |name: &str| f.json(&format!("plan {}", scene(name)), 0);
    let sphere = plan("sphere-690");
    assert_eq!(
        keys(&sphere),
        [
            "frames",
            "height",
            "max_error",
            "needs",
            "scene",
            "shading",
            "units",
            "width"
        ]
    );
    assert!(!needed(&sphere, "depth test") && needed(&sphere, "highlight"));
    assert!(!needed(&sphere, "texture") && !needed(&sphere, "lines"));
    assert_eq!(sphere["needs"]["perspective"], 1.0);
    let textures = plan("textures");
    assert!(needed(&textures, "texture") && needed(&textures, "perspective divider"));
    assert!(needed(&textures, "depth test"));
    let wires = plan("wire-40");
    assert!(needed(&wires, "lines") && !needed(&wires, "shading"));
    assert!(wires["shading"].is_null() && wires["needs"]["colour"].is_null());
    assert!(needed(&plan("bump"), "bump"));
    assert!(needed(&plan("one-spot"), "light per pixel"));
}

#[test]
fn all_frames_of_an_animation_are_looked_at() {
    let f = Folder::new();
    let spin = f.json(&format!("plan {} --size 64x48", scene("spin")), 0);
    let frames = spin["frames"].as_u64().unwrap();
    assert!(frames > 1);
    let one = spin["needs"]["triangles"].as_u64().unwrap() / frames;
    assert!(one > 10, "{one}");
}

#[test]
fn people_read_a_table_and_errors_decide() {
    let f = Folder::new();
    let text = |arguments: &str| {
        let done = f.run(arguments).code(0).stderr("");
        String::from_utf8(done.get_output().stdout.clone()).unwrap()
    };
    let sphere = scene("sphere-690");
    let near = text(&format!("plan {sphere}"));
    assert!(near.starts_with("sphere-690, 320x240\n"), "{near}");
    assert!(near.contains("no pixel is covered twice"), "{near}");
    let far = f.json(&format!("plan {sphere} --max-error 60"), 0);
    assert_eq!(far["shading"], "linear");
    assert_eq!(text(&format!("plan {sphere} -q")), "");
    for (arguments, said) in [
        ("--max-error x", "max-error 'x' cannot be used"),
        ("--max-error 256", "max-error '256' cannot be used"),
        ("--size 0x9", "size '0x9' cannot be drawn"),
    ] {
        let done = f.run(&format!("plan {sphere} {arguments}")).code(2);
        let said_so = String::from_utf8(done.get_output().stderr.clone()).unwrap();
        assert!(said_so.contains(said), "{said_so}");
    }
    f.run("plan missing.toml").code(2);
}

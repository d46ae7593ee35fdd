//! `list`: tables for people, objects for programs.

mod common;

use common::{keys, Folder, GOOD};
use shadegate_reference::Method;

#[test]
fn everything_is_one_object() {
    let f = Folder::new();
    let all = f.json("list --dir .", 0);
    assert_eq!(
        keys(&all),
        ["boards", "cores", "engines", "methods", "scenes", "skips", "targets"]
    );
    assert!(keys(&all)
        .iter()
        .all(|k| !all[k].as_array().unwrap().is_empty()));
    assert_eq!(keys(&f.json("list methods", 0)), ["methods"]);
    assert_eq!(all["methods"][0]["name"], "exact");
    assert!(all["methods"][0]["core"].is_null());
    assert_eq!(all["methods"][2]["core"], "gouraud");
    assert_eq!(all["cores"][0]["format"]["frac"], 12);
}

#[test]
fn names_alone_when_quiet() {
    let f = Folder::new();
    f.run("list methods -q")
        .code(0)
        .stdout(Method::NAMES.join("\n") + "\n");
    f.run("list cores -q")
        .code(0)
        .stdout("gouraud\nquadratic\nquadratic-dots\nduff\nslerp\nslerp-chebyshev\nspherical-cos2-rom4\nspherical-cos2-rom6\nspherical-cos2-rom8\nspherical-cosn\nblake\nblake-refit\nblake-trapezium\nquadratic-dots-kappa\nquadratic-dots-spot\nbump-newton\nbump-reflection\ntextured-affine\ntextured-quadratic\ntextured-perspective\nbresenham\nbox\ncone\nquadratic-engine\n");
    f.run("list scenes -q --dir .").code(0).stdout("ball\n");
    f.run("list engines -q")
        .code(0)
        .stdout("rust-hdl\ncompiled\nicarus\nverilator\ncxxrtl\n");
}

#[test]
fn scenes_are_listed_with_what_is_wrong() {
    let f = Folder::new();
    f.write("broken.toml", &GOOD.replace("width = 48", "width = 0"));
    f.write("note.txt", "not a scene");
    f.run("list scenes --dir .").code(0).stderr("").stdout(
        "scene   size   triangles  method     file
\
         ball    48x32        690  quadratic  ./ball.toml
\
         broken  -              -  -          ./broken.toml:2: image.width: is 0; expected an integer from 1 to 16384
",
    );
    let scenes = f.json("list scenes --dir .", 0);
    assert_eq!(
        keys(&scenes["scenes"][0]),
        ["file", "height", "method", "name", "triangles", "width"]
    );
    assert_eq!(keys(&scenes["scenes"][1]), ["error", "file", "name"]);
    f.run("list scenes")
        .code(0)
        .stdout("no scenes in 'scenes'; --dir names another folder\n");
    f.refuses("list scenes --dir none", "'none' is not a directory");
}

#[test]
fn engines_say_how_to_install_them() {
    let f = Folder::new();
    let none = f.0.path().join("empty");
    std::fs::create_dir(&none).unwrap();
    f.shadegate("list engines")
        .env("PATH", &none)
        .assert()
        .code(0)
        .stderr("")
        .stdout(
            "engine     installed  version, or how to install it\n\
         rust-hdl   yes        part of this program\n\
         compiled   yes        part of this program\n\
         icarus     no         missing iverilog, vvp: apt install iverilog\n\
         verilator  no         missing verilator, make, g++: apt install verilator make g++\n\
         cxxrtl     no         missing yosys, yosys-config, g++: apt install yosys yosys-dev g++\n",
        );
    let engines = f.json("list engines", 0);
    assert_eq!(
        keys(&engines["engines"][1]),
        [
            "install",
            "installed",
            "missing",
            "name",
            "tools",
            "version"
        ]
    );
}

#[test]
fn colours_only_when_wanted() {
    let f = Folder::new();
    let coloured = |set: &str, value: &str| {
        let done = f
            .shadegate("list methods")
            .env_remove("NO_COLOR")
            .env_remove("CLICOLOR_FORCE")
            .env(set, value)
            .assert()
            .code(0);
        done.get_output().stdout.contains(&0x1b)
    };
    assert!(coloured("CLICOLOR_FORCE", "1"));
    assert!(!coloured("NO_COLOR", "1"));
}

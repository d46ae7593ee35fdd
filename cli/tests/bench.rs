//! `bench`: rows, files, fronts and refusals, on a tiny set.

mod common;

use common::{keys, Folder};
use serde_json::Value;

const TINY: &str = "bench --quick --only exact,flat,gouraud,sphere-168";

/// Rows of one exponent.
fn rows(v: &Value, exponent: u64) -> Vec<&Value> {
    let all = v["rows"].as_array().unwrap();
    all.iter().filter(|r| r["exponent"] == exponent).collect()
}

#[test]
fn rows_have_the_documented_keys_and_the_front_is_right() {
    let f = Folder::new();
    let r = f.json(TINY, 0);
    assert_eq!(
        keys(&r),
        ["empty_rasteriser", "files", "machine", "rows", "threads"]
    );
    assert_eq!(r["files"].as_array().map(Vec::len), Some(0));
    let documented = [
        "drawn",
        "exponent",
        "flip_mean",
        "front_max",
        "front_rms",
        "height",
        "max_lsb",
        "method",
        "ns_per_frame",
        "ns_per_frame_scalar",
        "ns_per_pixel",
        "ns_per_triangle",
        "ns_setup",
        "pixels",
        "psnr_db",
        "rms_lsb",
        "rounds",
        "scene",
        "triangles",
        "width",
    ];
    for exponent in [20, 100] {
        let rows = rows(&r, exponent);
        let methods: Vec<&str> = rows.iter().map(|r| r["method"].as_str().unwrap()).collect();
        assert_eq!(methods, ["exact", "flat", "gouraud"]);
        for r in &rows {
            assert_eq!(keys(r), documented);
            assert_eq!(
                (&r["scene"], &r["triangles"]),
                (&"sphere-168".into(), &168.into())
            );
            assert!(r["rounds"].as_u64().unwrap() >= 3);
            // The front, from the rows as printed.
            for (front, error) in [("front_rms", "rms_lsb"), ("front_max", "max_lsb")] {
                let of = |r: &Value| {
                    (
                        r["ns_per_frame"].as_f64().unwrap(),
                        r[error].as_f64().unwrap(),
                    )
                };
                let (t, e) = of(r);
                let beaten = rows
                    .iter()
                    .map(|o| of(o))
                    .any(|(u, d)| u <= t && d <= e && (u < t || d < e));
                assert_eq!(r[front], !beaten, "{r}");
            }
        }
        assert!(rows[0]["max_lsb"] == 0 && rows[0]["psnr_db"].is_null());
        assert!(rows[1]["rms_lsb"].as_f64() > rows[2]["rms_lsb"].as_f64());
        assert_eq!(rows[1]["ns_per_pixel"], 0.0);
    }
    assert_eq!(f.names(), ["ball.toml"]);
}

#[test]
fn files_are_written_and_agree_with_the_rows() {
    let f = Folder::new();
    let r = f.json(&format!("{TINY} -o out"), 0);
    let names = [
        "bench.csv",
        "bench.json",
        "bench.md",
        "sphere-168-160x120.svg",
    ];
    let written: Vec<String> = names.iter().map(|n| format!("out/{n}")).collect();
    assert_eq!(r["files"], serde_json::json!(written));
    let read = |name: &str| std::fs::read_to_string(f.0.path().join("out").join(name)).unwrap();
    let json: Value = serde_json::from_str(&read("bench.json")).unwrap();
    assert_eq!(json["rows"], r["rows"]);
    assert_eq!(read("bench.csv").lines().count(), 1 + 6);
    assert_eq!(read("bench.md").matches("| gouraud |").count(), 2);
    assert!(read("sphere-168-160x120.svg").contains("sphere-168, n = 100, 160x120"));
    assert_eq!(
        std::fs::read_dir(f.0.path().join("out")).unwrap().count(),
        4
    );
}

#[test]
fn people_read_the_front_or_with_v_everything() {
    let f = Folder::new();
    let text = |arguments: &str| {
        let done = f.run(arguments).code(0).stderr("");
        String::from_utf8(done.get_output().stdout.clone()).unwrap()
    };
    let short = text(TINY);
    assert!(
        short.contains("\nsphere-168, n = 20, 160x120: the front\nmethod "),
        "{short}"
    );
    let (_, answers) = short
        .split_once("The fastest method by the largest error")
        .unwrap();
    let words: Vec<&str> = answers.lines().nth(2).unwrap().split_whitespace().collect();
    assert_eq!(
        words[..5],
        ["sphere-168", "20", "160x120", "exact", "exact"]
    );
    let long = text(&format!("{TINY} -v"));
    let names = |m: &str| long.lines().filter(|l| l.starts_with(m)).count();
    assert_eq!(
        (names("exact "), names("flat "), names("gouraud ")),
        (2, 2, 2),
        "{long}"
    );
    assert_eq!(text(&format!("{TINY} -q")), "");
}

#[test]
fn skips_of_the_scenes_of_a_folder() {
    let f = Folder::new();
    let r = f.json("bench --skips --quick --dir . --only gouraud -o out", 0);
    let all = r["skips"].as_array().unwrap();
    let back = all.iter().find(|r| r["skip"] == "back-face").unwrap();
    assert_eq!(
        keys(back),
        [
            "count",
            "max_lsb",
            "method",
            "ns_with",
            "ns_without",
            "rounds",
            "scene",
            "skip",
            "speedup_alone",
            "speedup_among_all"
        ]
    );
    assert_eq!(
        (&back["scene"], &back["method"]),
        (&"ball".into(), &"gouraud".into())
    );
    assert!(back["count"].as_u64() > Some(100) && back["max_lsb"] == 0);
    assert_eq!(all.last().unwrap()["skip"], "all");
    assert_eq!(
        r["files"],
        serde_json::json!(["out/skips.md", "out/skips.json"])
    );
    f.run("bench --skips --quick --dir .").code(0).stderr("");
}

#[test]
fn the_papers_tables_are_checked() {
    let f = Folder::new();
    let r = f.json("bench --papers --quick", 0);
    let all = r["claims"].as_array().unwrap();
    let blake: Vec<&Value> = all
        .iter()
        .filter(|c| c["source"] == "Blake et al. 1992, Table 3")
        .collect();
    assert_eq!(blake.len(), 40);
    assert_eq!(blake.iter().filter(|c| c["reproduced"] == true).count(), 34);
    assert!(all
        .iter()
        .any(|c| c["unit"] == "ratio" && c["ours"].as_f64() > Some(0.0)));
    assert_eq!(
        keys(&all[0]),
        [
            "note",
            "ours",
            "paper",
            "reproduced",
            "same_winner",
            "source",
            "unit",
            "what"
        ]
    );
}

#[test]
fn what_cannot_be_measured_is_refused() {
    let f = Folder::new();
    let refused = |arguments: &str, start: &str| {
        let done = f.run(arguments).code(2).stdout("");
        let said = String::from_utf8(done.get_output().stderr.clone()).unwrap();
        assert!(
            said.starts_with(start) && said.lines().count() == 1,
            "{said}"
        );
    };
    refused(
        "bench --quick --only goraud",
        "error: unknown method or scene 'goraud'; the nearest is 'gouraud' of exact, ",
    );
    refused(
        "bench --quick --only flat,sphere-16",
        "error: unknown method or scene 'sphere-16'; the nearest is 'sphere-168' of ",
    );
    f.refuses(
        "bench --skips --only sphere-168",
        "--skips takes its scenes from a folder; --only may name methods alone",
    );
    f.refuses(
        "bench --skips --dir none",
        "'none' cannot be read (No such file or directory (os error 2))",
    );
    f.refuses(
        "bench --quick -o ball.toml",
        "cannot write to 'ball.toml': it is not a directory",
    );
    f.write("broken.toml", "[image]\nwidth = 0\n");
    refused("bench --skips --dir .", "error: ./broken.toml:");
}

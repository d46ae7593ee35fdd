//! `render` and `compare`: what they print, what they write, what their JSON holds.

mod common;

use common::{keys, Folder};
use image::{Rgb, RgbImage};

#[test]
fn the_json_of_a_frame_has_the_documented_keys() {
    let f = Folder::new();
    let r = f.json("render ball.toml", 0);
    let documented = [
        "antialias",
        "edges",
        "filter",
        "frame",
        "height",
        "method",
        "output",
        "pixels",
        "samples",
        "scene",
        "skipped",
        "subframes",
        "threads",
        "time_ns",
        "triangles",
        "width",
    ];
    assert_eq!(keys(&r), documented);
    assert_eq!(keys(&r["triangles"]), ["clipped", "culled", "drawn", "in"]);
    assert_eq!(keys(&r["pixels"]), ["shaded", "tested", "written"]);
    assert_eq!(keys(&r["time_ns"]), ["raster", "setup", "total"]);
    assert_eq!(r["scene"], "ball");
    assert_eq!(r["method"], "quadratic");
    assert_eq!((&r["width"], &r["height"]), (&48.into(), &32.into()));
    assert_eq!(r["triangles"]["in"], 690);
    assert_eq!(r["output"], "ball-quadratic.png");
    let ns = |key: &str| r["time_ns"][key].as_u64().unwrap();
    assert!(ns("total") >= ns("setup") + ns("raster") && ns("raster") > 0);
    assert_eq!(f.names(), ["ball-quadratic.png", "ball.toml"]);

    let r = f.json(
        "render ball.toml --method gouraud --against exact --threads 1 --size 20x10",
        0,
    );
    assert_eq!(
        keys(&r["error"]),
        ["against", "flip_mean", "max_lsb", "psnr_db", "rms_lsb"]
    );
    assert_eq!(r["error"]["against"], "exact");
    assert_eq!((&r["width"], &r["threads"]), (&20.into(), &1.into()));
    let own = f.json("render ball.toml --method exact --against exact", 0);
    assert_eq!(own["error"]["max_lsb"], 0);
    assert!(own["error"]["psnr_db"].is_null());
}

#[test]
fn anti_aliasing_and_wires() {
    let f = Folder::new();
    let plain = f.json("render ball.toml -o plain.png", 0);
    assert_eq!(
        (&plain["antialias"], &plain["edges"]),
        (&"none".into(), &0.into())
    );
    for name in ["a-buffer", "cubic"] {
        let r = f.json(
            &format!("render ball.toml --antialias {name} --against exact -o {name}.png"),
            0,
        );
        assert_eq!(r["antialias"], name);
        assert!(r["error"]["max_lsb"].as_u64() < Some(40), "{r}");
        let apart = f.json(&format!("compare plain.png {name}.png"), 1);
        assert!(
            apart["max_lsb"].as_u64() > Some(10),
            "edges are softer: {apart}"
        );
    }
    let wires = format!(
        "{}draw = \"wireframe\"\n[render]\nline = \"box\"\n",
        common::GOOD
    );
    f.write("wire.toml", &wires);
    let r = f.json("render wire.toml", 0);
    // 690 faces have 1035 edges, about half of them in front.
    let (drawn, left_out) = (
        r["edges"].as_u64().unwrap(),
        r["skipped"]["back-edge"].as_u64().unwrap(),
    );
    assert_eq!(drawn + left_out, 1035);
    assert!((300..600).contains(&drawn), "{r}");
    let done = f.run("render wire.toml -o w.png").code(0).stderr("");
    let text = String::from_utf8(done.get_output().stdout.clone()).unwrap();
    assert!(
        text.contains("\nedges      ") && text.contains(" drawn by box\n"),
        "{text}"
    );
}

#[test]
fn people_read_where_the_picture_is_and_how_good() {
    let f = Folder::new();
    let done = f
        .run("render ball.toml --method flat -o x.png --against exact --size 24x16 -v")
        .code(0)
        .stderr("");
    let text = String::from_utf8(done.get_output().stdout.clone()).unwrap();
    let starts: Vec<&str> = text
        .lines()
        .map(|l| l.split_whitespace().next().unwrap())
        .collect();
    let lines = [
        "ball:",
        "triangles",
        "pixels",
        "time",
        "skipped",
        "back-face",
        "uncovered",
        "vertex",
        "error",
        "max",
        "RMS",
        "PSNR",
        "FLIP",
        "wrote",
    ];
    assert_eq!(starts, lines, "{text}");
    assert!(text.starts_with("ball: 24x16, flat\ntriangles  690 in, "));
    assert!(text.ends_with("\nwrote x.png\n"));
    assert!(!text.contains('\u{1b}'), "no colours: not a terminal");
    f.run("render ball.toml -q -o y.png")
        .code(0)
        .stdout("")
        .stderr("");
    assert_eq!(f.names(), ["ball.toml", "x.png", "y.png"]);
}

#[test]
fn skips_change_counts_and_not_the_frame() {
    let f = Folder::new();
    let with = f.json("render ball.toml -o a.png", 0);
    let without = f.json("render ball.toml -o b.png --no-skip all", 0);
    assert!(with["skipped"]["back-face"].as_u64() > Some(0));
    assert!(without["skipped"]["back-face"].is_null());
    f.run("compare a.png b.png -q").code(0).stdout("");
}

/// The good scene, spinning: a box, since a ball shows nothing of it.
fn spinning() -> String {
    let spin = "[animation]\nframes = 3\nspin = { degrees = 45 }\nsubframes = 2\nshutter = 1\n";
    common::GOOD.replace("sphere", "box") + spin
}

#[test]
fn frames_of_a_scene_that_moves() {
    let f = Folder::new();
    f.write("spin.toml", &spinning());
    let r = f.json("render spin.toml --frames --method flat -o a.png", 0);
    assert_eq!((&r["frame"], &r["subframes"]), (&2.into(), &6.into()));
    let files = ["a-0000.png", "a-0001.png", "a-0002.png"];
    assert_eq!(r["outputs"].as_array().unwrap().len(), 3);
    assert_eq!(
        (&r["outputs"][0], &r["output"]),
        (&files[0].into(), &files[2].into())
    );
    assert_eq!(f.names()[..3], files);
    // One of them alone is the same picture, under its own name or the one that is wanted.
    f.run("render spin.toml --frame 1 --method flat").code(0);
    f.run("compare a-0001.png spin-flat-0001.png -q").code(0);
    let text = f
        .run("render spin.toml --frame 1 --method flat -o b.png")
        .code(0);
    let text = String::from_utf8(text.get_output().stdout.clone()).unwrap();
    assert!(
        text.starts_with("spin: 48x32, flat, frame 1 of 3\nsamples    1x1, box; 2 sub-frames\n"),
        "{text}"
    );
    f.run("compare a-0001.png b.png -q").code(0);
    f.run("compare a-0001.png a-0002.png -q").code(1);
    f.run("render spin.toml --frame 3").code(2).stdout("");
    f.run("render spin.toml --frames --frame 1")
        .code(2)
        .stdout("");
}

#[test]
fn samples_and_filters() {
    let f = Folder::new();
    let r = f.json("render ball.toml --samples 3 --filter tent -o a.png", 0);
    assert_eq!((&r["samples"], &r["filter"]), (&3.into(), &"tent".into()));
    assert_eq!((&r["width"], &r["subframes"]), (&48.into(), &1.into()));
    let one = f.json("render ball.toml -o b.png", 0);
    let pixels = |r: &serde_json::Value| r["pixels"]["written"].as_f64().unwrap();
    assert!((pixels(&r) / pixels(&one) - 9.0).abs() < 0.5);
    // Between the ball and the background there is now something.
    let grey = image::open(f.0.path().join("a.png")).unwrap().into_rgb8();
    assert!(grey.pixels().filter(|p| (1..20).contains(&p[0])).count() > 10);
    f.write(
        "fine.toml",
        &(common::GOOD.to_owned() + "[render]\nsamples = 3\nfilter = \"tent\"\n"),
    );
    f.run("render fine.toml -o c.png").code(0);
    f.run("compare a.png c.png -q").code(0);
}

#[test]
fn compare_says_how_far_and_where() {
    let f = Folder::new();
    let mut picture = RgbImage::from_pixel(8, 4, Rgb([10, 20, 30]));
    picture.save(f.0.path().join("a.png")).unwrap();
    picture.put_pixel(5, 2, Rgb([10, 24, 30]));
    picture.save(f.0.path().join("b.png")).unwrap();
    f.run("compare a.png a.png").code(0).stderr("").stdout(
        "32 pixels, all equal\n  max   0 LSB\n  RMS   0.0000 LSB\n  PSNR  infinite\n  FLIP  0.000000\n",
    );
    let done = f.run("compare a.png b.png -o d.png -v").code(1).stderr("");
    let text = String::from_utf8(done.get_output().stdout.clone()).unwrap();
    let (start, end) = text.split_once("  FLIP  0.").unwrap();
    assert_eq!(
        start,
        "32 pixels, 1 differ\n  max   4 LSB\n  RMS   0.4082 LSB\n  PSNR  55.91 dB\n"
    );
    assert!(
        end.ends_with(
            "\nfirst difference at column 5, row 2: 10 20 30 and 10 24 30\n\
             channels by difference in LSB\n    0  95\n    4  1\nwrote d.png\n"
        ),
        "{end}"
    );
    let d = image::open(f.0.path().join("d.png")).unwrap().into_rgb8();
    assert_eq!(d.get_pixel(5, 2), &Rgb([0, 127, 0]));
    assert_eq!(d.get_pixel(0, 0), &Rgb([0, 0, 0]));

    let r = f.json("compare a.png b.png", 1);
    let documented = [
        "a",
        "b",
        "differing",
        "first_mismatch",
        "flip_mean",
        "histogram",
        "max_lsb",
        "output",
        "pixels",
        "psnr_db",
        "rms_lsb",
    ];
    assert_eq!(keys(&r), documented);
    assert_eq!((&r["differing"], &r["max_lsb"]), (&1.into(), &4.into()));
    assert_eq!(r["first_mismatch"]["x"], 5);
    assert!(r["output"].is_null());
}

#[test]
fn compare_refuses_what_is_no_pair_of_pictures() {
    let f = Folder::new();
    RgbImage::new(8, 4).save(f.0.path().join("a.png")).unwrap();
    RgbImage::new(4, 8).save(f.0.path().join("b.png")).unwrap();
    f.refuses(
        "compare a.png b.png -o d.png",
        "the images differ in size: 8x4 and 4x8",
    );
    f.refuses(
        "compare a.png none.png -o d.png",
        "cannot read \"none.png\": No such file or directory (os error 2)",
    );
    f.refuses(
        "compare ball.toml a.png",
        "\"ball.toml\" is not a PNG image",
    );
    f.refuses(
        "compare a.png a.png -o ./a.png",
        "cannot write './a.png': it is one of the inputs",
    );
}

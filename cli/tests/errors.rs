//! What is said about input that cannot be used, word for word: one line, exit code 2, nothing written.

mod common;

use common::{Folder, GOOD};
use shadegate_gen::scene::{BY_SCENE, CORES, ENGINES, LINES, TEXTURED};
use shadegate_reference::{Method, Skips};
use std::sync::LazyLock;

static METHODS: LazyLock<String> = LazyLock::new(|| Method::NAMES.join(", "));

#[test]
fn scenes() {
    let f = Folder::new();
    let commands = ["render", "cosim", "gen --scene"];
    let all = |scene: &str, message: &str| {
        for command in commands {
            f.refuses(&format!("{command} {scene}"), message);
        }
    };
    all(
        "none.toml",
        "none.toml:1: scene: cannot be read (No such file or directory (os error 2)); expected a readable TOML file",
    );
    f.write("key.toml", &GOOD.replace("fov = 40", "fow = 40"));
    all(
        "key.toml",
        "key.toml:8: camera.fow: unknown key; the nearest known key is 'fov' of eye, target, up, fov, height, near, far",
    );
    f.write("zero.toml", &GOOD.replace("width = 48", "width = 0"));
    all(
        "zero.toml",
        "zero.toml:2: image.width: is 0; expected an integer from 1 to 16384",
    );
    let with_mesh = GOOD.replace("shape = \"sphere\"", "mesh = \"m.obj\"");
    f.write("mesh.toml", &with_mesh);
    all(
        "mesh.toml",
        "mesh.toml:18: object[0].mesh: m.obj: cannot be read (No such file or directory (os error 2)); expected a \
         readable OBJ file",
    );
    f.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 NaN 0\nf 1 2 3\n");
    all(
        "mesh.toml",
        "mesh.toml:18: object[0].mesh: m.obj:3: vertex has 'NaN'; expected three finite numbers",
    );
}

/// Software draws them, cores do not; `--method` is named because a core's method is asked for first.
#[test]
fn scenes_beyond_cores() {
    let f = Folder::new();
    for (keys, what) in [
        (
            "texture = \"checker\"",
            "has a texture with a filter of several levels, which the textured core does not draw; expected filter = \
             'nearest' or 'bilinear', or the command render",
        ),
        (
            "bump = \"bumps\"",
            "has a bump map, which no core of this method draws; expected method phong, materials without bump, or the \
             command render",
        ),
    ] {
        f.write(
            "rich.toml",
            &GOOD.replace("name = \"clay\"", &format!("name = \"clay\"\n{keys}")),
        );
        for command in ["cosim", "gen --scene", "synth --scene"] {
            f.refuses(
                &format!("{command} rich.toml --method gouraud"),
                &format!("rich.toml: material 'clay' {what}"),
            );
        }
        f.run("render rich.toml -o rich.png").code(0);
        std::fs::remove_file(f.0.path().join("rich.png")).unwrap();
    }
}

#[test]
fn sizes() {
    let f = Folder::new();
    for size in ["0x5", "5x0", "64", "axb", "16385x1", "64x48x2"] {
        for command in ["render ball.toml", "cosim ball.toml", "gen gouraud"] {
            f.refuses(
                &format!("{command} --size {size}"),
                &format!("size '{size}' cannot be drawn; expected WxH from 1x1 to 16384x16384"),
            );
        }
    }
    for command in ["cosim ball.toml", "gen gouraud", "gen --scene ball.toml"] {
        f.refuses(
            &format!("{command} --size 3000x4"),
            "frame 3000x4 exceeds the core's coordinate range: at most 2040 columns and \
             1024 rows",
        );
    }
}

#[test]
fn methods_that_cannot_draw_a_scene() {
    let f = Folder::new();
    let able = METHODS.replace("hemisphere, ", "");
    let table =
        |what: &str| format!("method 'hemisphere' cannot draw {what}; methods that can: {able}");
    f.refuses(
        "render ball.toml --method hemisphere",
        &table("with perspective"),
    );
    f.refuses(
        "render ball.toml --against hemisphere",
        &table("with perspective"),
    );
    let flat = GOOD.replace("fov = 40", "height = 3");
    let kind = "kind = \"directional\"";
    f.write(
        "point.toml",
        &flat
            .replace(kind, "kind = \"point\"")
            .replace("direction =", "position ="),
    );
    f.refuses(
        "render point.toml --method hemisphere",
        &table("a point light"),
    );
    let spot = "kind = \"spot\"\nposition = [1, 2, 3]\nfield = 30";
    f.write("spot.toml", &flat.replace(kind, spot));
    f.refuses("render spot.toml --method hemisphere", &table("a spot"));
}

#[test]
fn names() {
    let f = Folder::new();
    for command in [
        "render ball.toml",
        "cosim ball.toml",
        "gen --scene ball.toml",
    ] {
        f.refuses(
            &format!("{command} --method quadratik"),
            &format!(
                "unknown method 'quadratik'; the nearest is 'quadratic' of {}",
                *METHODS
            ),
        );
    }
    f.refuses(
        "render ball.toml --against exakt",
        &format!(
            "unknown method 'exakt'; the nearest is 'exact' of {}",
            *METHODS
        ),
    );
    f.refuses(
        "render ball.toml --no-skip hiden",
        &format!(
            "unknown skip 'hiden'; the nearest is 'hidden' of {}",
            Skips::NAMES.join(", ")
        ),
    );
    let core = format!(
        "unknown core 'goraud'; the nearest is 'gouraud' of {}, {}",
        cores(),
        ENGINES[0].0
    );
    f.refuses("cosim ball.toml --core goraud", &core);
    f.refuses("gen goraud", &core);
    f.refuses(
        "gen ball.toml",
        "'ball.toml' is not a core; for a scene: shadegate gen --scene ball.toml",
    );
    f.refuses(
        "cosim ball.toml --engine ikarus",
        "unknown engine 'ikarus'; the nearest is 'icarus' of rust-hdl, compiled, icarus, verilator, cxxrtl",
    );
    f.refuses(
        "gen gouraud --target xc7s5",
        "unknown device 'xc7s5'; did you mean 'xc7s50'? known: xc2s100e, xc3s200, xc3s500e, xc6slx9, xc6slx16, \
         xc7s15, xc7s25, xc7s50, ice40up5k, lfe5u-25f",
    );
    f.refuses(
        "gen gouraud --board arti-s7-50",
        "unknown board 'arti-s7-50'; did you mean 'arty-s7-50'? known: papilio-pro, mojo-v3, mimas-v2, arty-s7-50, \
         cmod-s7, icebreaker, ulx3s-25f",
    );
}

/// The names of all cores.
fn cores() -> String {
    let triangles = CORES.iter().chain(&BY_SCENE).map(|c| c.0);
    let textured = TEXTURED.iter().map(|t| t.0);
    let lines = LINES.iter().map(|l| l.0);
    let all: Vec<_> = triangles.chain(textured).chain(lines).collect();
    all.join(", ")
}

#[test]
fn methods_without_a_core() {
    let f = Folder::new();
    f.write("flat.toml", &format!("{GOOD}[render]\nmethod = \"flat\"\n"));
    for arguments in [
        "cosim ball.toml --method flat",
        "gen --scene ball.toml --method flat",
        "cosim flat.toml",
        "gen --scene flat.toml",
    ] {
        let message = format!("method 'flat' has no core; cores: {}", cores());
        f.refuses(arguments, &message);
    }
    f.refuses(
        "cosim ball.toml --method gouraud --core quadratic",
        "core 'quadratic' does not draw method 'gouraud'; leave out one of --core and --method",
    );
}

/// What only software draws is refused where a core is to draw it.
#[test]
fn mixtures_and_anti_aliasing_have_no_core() {
    let f = Folder::new();
    f.write("wire.toml", &format!("{GOOD}draw = \"wireframe\"\n"));
    let second = "[[object]]\nshape = \"box\"\nmaterial = \"clay\"\n";
    f.write(
        "mixed.toml",
        &format!("{GOOD}draw = \"wireframe\"\n{second}"),
    );
    f.write(
        "smooth.toml",
        &format!("{GOOD}[render]\nantialias = \"cubic\"\n"),
    );
    for command in ["cosim", "gen --scene"] {
        f.refuses(
            &format!("{command} mixed.toml"),
            "object[0] of the scene is a wireframe and object[1] is shaded, and no core draws both; expected the same draw for every object",
        );
        f.refuses(
            &format!("{command} wire.toml --method gouraud"),
            "core 'gouraud' does not draw wireframes, and object[0] of the scene is one; cores that do: bresenham, box, cone",
        );
        f.refuses(
            &format!("{command} ball.toml --method cone"),
            &format!(
                "core 'cone' draws wireframes, and the scene has none; cores of triangles: {}",
                CORES.map(|c| c.0).join(", ")
            ),
        );
        f.refuses(
            &format!("{command} smooth.toml"),
            "the scene asks for antialias = 'cubic', which no core draws; expected antialias = 'none'",
        );
    }
    f.refuses(
        "render ball.toml --antialias abuffer",
        "unknown anti-aliasing 'abuffer'; the nearest is 'a-buffer' of none, a-buffer, cubic",
    );
}

#[test]
fn numbers() {
    let f = Folder::new();
    for n in ["0", "1025", "two", "99999999999999999999"] {
        f.refuses(
            &format!("render ball.toml --threads {n}"),
            &format!("threads '{n}' cannot be used; expected a number from 1 to 1024"),
        );
    }
    for n in ["0", "17", "two", "-1"] {
        f.refuses(
            &format!("render ball.toml --samples={n}"),
            &format!("samples '{n}' cannot be used; expected a number from 1 to 16"),
        );
    }
    f.refuses(
        "render ball.toml --filter bax",
        "unknown filter 'bax'; the nearest is 'box' of box, tent",
    );
    f.refuses(
        "render ball.toml --frame 1",
        "frame '1' cannot be drawn; the scene has only frame 0",
    );
    for ns in ["0", "nan", "inf", "1e7", "soon", "0.01"] {
        f.refuses(
            &format!("gen gouraud --target xc7s50 --period {ns}"),
            &format!("period '{ns}' cannot be kept; expected 0.1 to 1000000 nanoseconds"),
        );
    }
    f.refuses(
        "cosim ball.toml --wave w.vcd --from x",
        "--from 'x' is not a clock; expected a whole number from 0",
    );
    f.refuses(
        "cosim ball.toml --wave w.vcd --from 9 --to 9",
        "the waveform from clock 9 to clock 9 is empty; expected --from below --to",
    );
}

#[test]
fn usage() {
    let f = Folder::new();
    f.refuses(
        "render",
        "the following required arguments were not provided: <SCENE>; try '--help'",
    );
    f.refuses(
        "render ball.toml --sise 3x3",
        "unexpected argument '--sise' found; tip: a similar argument exists: '--size'; try '--help'",
    );
    f.refuses(
        "rendr",
        "unrecognized subcommand 'rendr'; tip: a similar subcommand exists: 'render'; try '--help'",
    );
    f.refuses(
        "cosim ball.toml --from 3",
        "the following required arguments were not provided: --wave <FILE.vcd>; try '--help'",
    );
    f.refuses(
        "gen gouraud --target xc7s50 --board arty-s7-50",
        "the argument '--target <DEVICE>' cannot be used with '--board <BOARD>'; try '--help'",
    );
    f.refuses(
        "gen gouraud --period 8",
        "the following required arguments were not provided: <--target <DEVICE>|--board <BOARD>>; try '--help'",
    );
    f.refuses(
        "gen",
        "the following required arguments were not provided: <CORE|--scene <FILE>>; try '--help'",
    );
}

#[test]
fn places_to_write() {
    let f = Folder::new();
    f.write("file", "");
    std::fs::create_dir(f.0.path().join("dir.png")).unwrap();
    let picture = ["render ball.toml -o", "compare ball.toml ball.toml -o"];
    for command in picture {
        let refuses = |name: &str, why: &str| {
            f.refuses(
                &format!("{command} {name}"),
                &format!("cannot write '{name}': {why}"),
            );
        };
        refuses("no/where.png", "'no' is not a directory");
        refuses("file/x.png", "'file' is not a directory");
        refuses("x.jpg", "expected a name that ends in .png");
        refuses("x", "expected a name that ends in .png");
        refuses("dir.png", "it is there and not a file");
    }
    for command in ["cosim ball.toml", "gen gouraud", "man"] {
        f.refuses(
            &format!("{command} -o file/where"),
            "cannot write to 'file': it is not a directory",
        );
        f.refuses(
            &format!("{command} -o file"),
            "cannot write to 'file': it is not a directory",
        );
    }
    f.refuses(
        "cosim ball.toml --wave no/w.vcd",
        "cannot write 'no/w.vcd': 'no' is not a directory",
    );
    f.refuses(
        "cosim ball.toml --wave w.fst --engine rust-hdl",
        "cannot write 'w.fst': expected a name that ends in .vcd",
    );
    f.refuses(
        "cosim ball.toml --engine compiled --wave w.txt",
        "cannot write 'w.txt': expected a name that ends in .vcd or .fst",
    );
    f.refuses(
        "cosim ball.toml --engine icarus --wave w.vcd --signals shell",
        "engine icarus shows all signals; use --engine compiled for --signals",
    );
    // The name that is taken by default may be taken already.
    std::fs::create_dir(f.0.path().join("ball-flat.png")).unwrap();
    f.refuses(
        "render ball.toml --method flat",
        "cannot write 'ball-flat.png': it is there and not a file",
    );
    f.write("gouraud-core", "");
    f.refuses(
        "gen gouraud",
        "cannot write to 'gouraud-core': it is not a directory",
    );
}

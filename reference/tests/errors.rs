//! What is said about scenes that cannot be used, word for word, and that nothing else than an error ever comes of them.

mod common;

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_reference::{scene, Method, Prepared, Skips};
use std::path::{Path, PathBuf};

const GOOD: &str = r#"[image]
width = 64
height = 48

[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
fov = 40

[[light]]
kind = "directional"
direction = [0, 0, -1]

[[material]]
name = "clay"

[[object]]
shape = "sphere"
material = "clay"
"#;

/// A folder of its own for one test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path =
            Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.join(name), text).unwrap();
    }

    /// The error of a scene, the folder taken off.
    fn error(&self, text: &str) -> String {
        self.write("s.toml", text);
        let e = scene::load(&self.0.join("s.toml")).unwrap_err().to_string();
        assert!(!e.contains('\n'), "one line: {e}");
        e.replace(&format!("{}/", self.0.display()), "")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // A folder left behind does no harm.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn the_good_scene_is_good() {
    let f = Folder::new("good");
    f.write("s.toml", GOOD);
    let s = scene::load(&f.0.join("s.toml")).unwrap();
    assert_eq!(
        (s.name.as_str(), s.image.width, s.objects.len()),
        ("s", 64, 1)
    );
}

#[test]
fn every_error_names_file_line_field_and_what_would_do() {
    let f = Folder::new("errors");
    // What to replace in the good scene, by what, and the error.
    let cases = [
        ("width = 64", "widht = 64", "s.toml:2: image.widht: unknown key; the nearest known key is 'width' of width, height, background"),
        ("[image]", "[imago]", "s.toml:1: imago: unknown key; the nearest known key is 'image' of image, camera, light, material, object, render, animation"),
        ("fov = 40", "fow = 40", "s.toml:8: camera.fow: unknown key; the nearest known key is 'fov' of eye, target, up, fov, height, near, far"),
        ("name = \"clay\"", "name = \"clay\"\nshinyness = 3", "s.toml:16: material[0].shinyness: unknown key; the nearest known key is 'shininess' of name, brdf, ambient, diffuse, specular, shininess, highlight, degree, roughness, f0, emission, shadow, texture, mapping, filter, bump, bump_scale, bump_gradient, bump_normalise, wrap, repeat"),
        ("width = 64\n", "", "s.toml:1: image.width: missing; expected an integer from 1 to 16384"),
        ("width = 64", "width = 0", "s.toml:2: image.width: is 0; expected an integer from 1 to 16384"),
        ("width = 64", "width = 16385", "s.toml:2: image.width: is 16385; expected an integer from 1 to 16384"),
        ("width = 64", "width = \"64\"", "s.toml:2: image.width: is a string; expected an integer from 1 to 16384"),
        ("height = 48", "height = 48\nbackground = [1, 2, 256]", "s.toml:4: image.background: has 256; expected [r, g, b], each an integer from 0 to 255"),
        ("eye = [0, 0, 5]", "eye = [0, nan, 5]", "s.toml:6: camera.eye: is not a finite number below 1e12; expected three numbers [x, y, z]"),
        ("eye = [0, 0, 5]", "eye = [0, 0]", "s.toml:6: camera.eye: has 2 elements; expected three numbers [x, y, z]"),
        ("eye = [0, 0, 5]", "eye = [0, 0, 0]", "s.toml:7: camera.target: is where the eye is; expected a point apart from camera.eye"),
        ("fov = 40", "fov = 180", "s.toml:8: camera.fov: is 180; expected degrees above 0 and below 180"),
        ("fov = 40", "fov = 40\nheight = 2", "s.toml:9: camera.height: given together with fov; expected one of fov and height"),
        ("fov = 40\n", "", "s.toml:5: camera.fov: missing; expected fov (perspective, degrees) or height (orthographic)"),
        ("fov = 40", "fov = 40\nnear = 3\nfar = 3", "s.toml:9: camera.near: is 3, not below far = 3; expected near < far"),
        ("fov = 40", "fov = 40\nup = [0, 0, 2]", "s.toml:9: camera.up: is parallel to the view; expected a direction across target - eye"),
        ("direction = [0, 0, -1]", "direction = [0, 0, 0]", "s.toml:12: light[0].direction: has no length; expected the direction in which the light travels"),
        ("kind = \"directional\"", "kind = \"sport\"", "s.toml:11: light[0].kind: unknown 'sport'; the nearest is 'spot' of directional, point, spot"),
        ("kind = \"directional\"", "kind = \"point\"", "s.toml:12: light[0].direction: does not belong to a point light; expected it only with kind = 'directional' or 'spot'"),
        ("name = \"clay\"", "name = \"clay\"\nbrdf = \"phongg\"", "s.toml:16: material[0].brdf: unknown 'phongg'; the nearest is 'phong' of lambert, phong, blinn, cook-torrance"),
        ("name = \"clay\"", "name = \"clay\"\ndiffuse = [0.1, -0.2, 0]", "s.toml:16: material[0].diffuse: has -0.2; expected a number or [r, g, b], each from 0 to 100"),
        ("material = \"clay\"", "material = \"caly\"", "s.toml:19: object[0].material: unknown 'caly'; the nearest is 'clay' of clay"),
        ("shape = \"sphere\"", "shape = \"spere\"", "s.toml:18: object[0].shape: unknown 'spere'; the nearest is 'sphere' of sphere, torus, plane, box, teapot"),
        ("shape = \"sphere\"", "shape = \"sphere\"\nslices = 2", "s.toml:19: object[0].slices: is 2; expected an integer from 3 to 2048"),
        ("shape = \"sphere\"", "shape = \"sphere\"\nmajor = 2", "s.toml:19: object[0].major: does not belong to sphere; expected only slices, stacks, radius"),
        ("shape = \"sphere\"", "shape = \"sphere\"\nscale = 0", "s.toml:19: object[0].scale: has 0; expected a number or [x, y, z], each of size 1e-6 to 1e6"),
        ("shape = \"sphere\"", "mesh = \"none.obj\"", "s.toml:18: object[0].mesh: none.obj: cannot be read (No such file or directory (os error 2)); expected a readable OBJ file"),
        ("shape = \"sphere\"", "mesh = \"none.stl\"", "s.toml:18: object[0].mesh: 'none.stl' has no known ending; expected a file ending in .obj, .gltf or .glb"),
        ("[[light]]", "[render]\nmethod = \"exakt\"\n[[light]]", "s.toml:11: render.method: unknown 'exakt'; the nearest is 'exact' of METHODS"),
        ("[[light]]", "[render]\nsamples = 17\n[[light]]", "s.toml:11: render.samples: is 17; expected an integer from 1 to 16"),
        ("[[light]]", "[render]\nfilter = \"bax\"\n[[light]]", "s.toml:11: render.filter: unknown 'bax'; the nearest is 'box' of box, tent"),
        ("shape = \"sphere\"", "shape = \"sphere\"\nnormals = \"area\"", "s.toml:19: object[0].normals: does not belong to a shape; expected it only with a mesh"),
        ("shape = \"sphere\"", "mesh = \"x.obj\"\nnormals = \"angel\"", "s.toml:19: object[0].normals: unknown 'angel'; the nearest is 'angle' of face, uniform, area, angle"),
        ("material = \"clay\"", "[animation]", "s.toml:19: animation.frames: missing; expected an integer from 1 to 100000"),
        ("material = \"clay\"", "[animation]\nframes = 0", "s.toml:20: animation.frames: is 0; expected an integer from 1 to 100000"),
        ("material = \"clay\"", "[animation]\nframes = 2\nspin = { axis = [0, 0, 0] }", "s.toml:21: animation.spin.axis: has no length; expected a direction such as [0, 1, 0]"),
        ("material = \"clay\"", "[animation]\nframes = 2\nshutter = 2", "s.toml:21: animation.shutter: is 2; expected a number from 0 to 1, in frames"),
        ("material = \"clay\"", "[animation]\nframes = 2\nsubframes = 257", "s.toml:21: animation.subframes: is 257; expected an integer from 1 to 256"),
        ("material = \"clay\"", "[animation]\nframes = 2\n[[animation.object]]\nobject = 1\ntime = 0", "s.toml:22: animation.object[0].object: is 1; expected an integer from 0 to 0"),
        ("material = \"clay\"", "[animation]\nframes = 2\n[[animation.object]]\nobject = 0", "s.toml:21: animation.object[0].time: missing; expected a number of frames"),
        ("material = \"clay\"", "[animation]\nframes = 2\n[[animation.camera]]\ntime = 0\n[[animation.camera]]\ntime = 0", "s.toml:24: animation.camera[1].time: is 0, as of a key before; expected a time of its own"),
        ("material = \"clay\"", "[animation]\nframes = 2\n[[animation.camera]]\ntime = 0\ntarget = [0, 0, 5]", "s.toml:23: animation.camera[0].target: is where the eye is; expected a point apart from camera.eye"),
        ("[[light]]", "[render]\nline = \"con\"\n[[light]]", "s.toml:11: render.line: unknown 'con'; the nearest is 'cone' of bresenham, box, cone"),
        ("[[light]]", "[render]\nantialias = \"abuffer\"\n[[light]]", "s.toml:11: render.antialias: unknown 'abuffer'; the nearest is 'a-buffer' of none, a-buffer, cubic"),
        ("[[light]]", "[render]\ncue = 0.5\n[[light]]", "s.toml:11: render.cue: is a number; expected [nearest, farthest], two factors from 0 to 1"),
        ("[[light]]", "[render]\ncue = [1]\n[[light]]", "s.toml:11: render.cue: has 1 elements; expected [nearest, farthest], two factors from 0 to 1"),
        ("[[light]]", "[render]\ncue = [1, -0.5]\n[[light]]", "s.toml:11: render.cue: has -0.5; expected [nearest, farthest], two factors from 0 to 1"),
        ("shape = \"sphere\"", "shape = \"sphere\"\ndraw = \"wirefram\"", "s.toml:19: object[0].draw: unknown 'wirefram'; the nearest is 'wireframe' of shaded, wireframe"),
        ("[[object]]\nshape = \"sphere\"\nmaterial = \"clay\"", "", "s.toml:1: object: missing; expected at least one table [[object]]"),
    ];
    for (from, to, want) in cases {
        assert!(GOOD.contains(from), "{from}");
        let want = want.replace("METHODS", &Method::NAMES.join(", "));
        assert_eq!(f.error(&GOOD.replacen(from, to, 1)), want);
    }
    let e = f.error("width == 3");
    assert!(
        e.starts_with("s.toml:1: scene: ") && e.ends_with("; expected TOML 1.0"),
        "{e}"
    );
}

#[test]
fn every_key_of_lights_says_what_it_takes() {
    let f = Folder::new("lights");
    // The keys of the light, and the error without file name; the light begins on line 10.
    let directional = "kind = \"directional\"\ndirection = [0, 0, -1]\n";
    let point = "kind = \"point\"\nposition = [0, 1, 2]\n";
    let spot = "kind = \"spot\"\nposition = [0, 1, 2]\ndirection = [0, -1, 0]\n";
    let cases = [
        (directional, "position = [1, 2, 3]", ":13: light[0].position: does not belong to a directional light; expected it only with kind = 'point' or 'spot'"),
        (directional, "attenuation = [1, 0, 1]", ":13: light[0].attenuation: does not belong to a directional light; expected it only with kind = 'point' or 'spot'"),
        (directional, "falloff = \"soft\"", ":13: light[0].falloff: does not belong to a directional light; expected it only with kind = 'spot'"),
        (point, "beam = 20", ":13: light[0].beam: does not belong to a point light; expected it only with kind = 'spot'"),
        (point, "field = 20", ":13: light[0].field: does not belong to a point light; expected it only with kind = 'spot'"),
        (point, "attenuation = [0, 0, 0]", ":13: light[0].attenuation: is all 0; expected [constant, linear, quadratic], each at least 0, not all 0"),
        (point, "attenuation = [1, -0.5, 0]", ":13: light[0].attenuation: has -0.5; expected [constant, linear, quadratic], each at least 0, not all 0"),
        (point, "attenuation = 2", ":13: light[0].attenuation: is an integer; expected [constant, linear, quadratic], each at least 0, not all 0"),
        (spot, "", ":10: light[0].field: missing; expected one of beam and field, degrees from 0.1 to 179"),
        (spot, "beam = 20\nfield = 30", ":15: light[0].field: given together with beam; expected one of beam and field; the other follows from the fall-off"),
        (spot, "beam = 0", ":14: light[0].beam: is 0; expected degrees from 0.1 to 179"),
        (spot, "field = 180", ":14: light[0].field: is 180; expected degrees from 0.1 to 179"),
        (spot, "field = 30\nfalloff = \"softer\"", ":15: light[0].falloff: unknown 'softer'; the nearest is 'soft' of warn, soft, hard"),
        ("kind = \"spot\"\ndirection = [0, -1, 0]\n", "field = 30", ":10: light[0].position: missing; expected three numbers [x, y, z]"),
        ("kind = \"spot\"\nposition = [0, 1, 0]\n", "field = 30", ":10: light[0].direction: missing; expected three numbers [x, y, z]"),
    ];
    for (keys, more, want) in cases {
        let text = GOOD.replacen(directional, &format!("{keys}{more}\n"), 1);
        assert_eq!(f.error(&text), format!("s.toml{want}"));
    }
}

#[test]
fn every_key_of_materials_says_what_it_takes() {
    let f = Folder::new("materials");
    // Keys of the material, from line 16 on.
    let cases = [
        ("brdf = \"lambert\"\nspecular = 1", ":17: material[0].specular: does not belong to the lambert model; expected it only with brdf = 'phong' or 'blinn'"),
        ("brdf = \"lambert\"\nhighlight = \"pow\"", ":17: material[0].highlight: does not belong to the lambert model; expected it only with brdf = 'phong' or 'blinn'"),
        ("brdf = \"cook-torrance\"\nshininess = 9", ":17: material[0].shininess: does not belong to the cook-torrance model; expected it only with brdf = 'phong' or 'blinn'"),
        ("brdf = \"cook-torrance\"\nspecular = 1", ":17: material[0].specular: does not belong to the cook-torrance model; expected it only with brdf = 'phong' or 'blinn'"),
        ("brdf = \"cook-torrance\"\nroughness = 0", ":17: material[0].roughness: is 0; expected a number from 0.01 to 1"),
        ("brdf = \"cook-torrance\"\nf0 = [0.5, 0.5, 1.5]", ":17: material[0].f0: has 1.5; expected a number or [r, g, b], each from 0 to 1"),
        ("f0 = 0.5", ":16: material[0].f0: does not belong to the blinn model; expected it only with brdf = 'cook-torrance'"),
        ("brdf = \"phong\"\nroughness = 0.5", ":17: material[0].roughness: does not belong to the phong model; expected it only with brdf = 'cook-torrance'"),
        ("highlight = \"kapa\"", ":16: material[0].highlight: unknown 'kapa'; the nearest is 'kappa' of pow, kappa, cos2, blake, schlick"),
        ("degree = 3", ":16: material[0].degree: does not belong to highlight 'pow'; expected it only with highlight = 'kappa'"),
        ("highlight = \"kappa\"\ndegree = 7", ":17: material[0].degree: is 7; expected an integer from 2 to 6"),
        ("highlight = \"kappa\"\ndegree = 4\nshininess = 3", ":17: material[0].degree: is 4, above shininess = 3; expected a degree up to the shininess"),
        ("highlight = \"kappa\"\nshininess = 1.5", ":17: material[0].shininess: is 1.5; expected a number from 2 to 10000 with highlight 'kappa'"),
        ("highlight = \"blake\"\nshininess = 0.5", ":17: material[0].shininess: is 0.5; expected a number from 1 to 10000 with highlights other than 'pow'"),
        ("shininess = 10001", ":16: material[0].shininess: is 10001; expected a number from 0 to 10000"),
        ("shadow = 1.1", ":16: material[0].shadow: is 1.1; expected a number from 0 to 1"),
        ("emission = [0, 0, 101]", ":16: material[0].emission: has 101; expected a number or [r, g, b], each from 0 to 100"),
    ];
    for (keys, want) in cases {
        let text = GOOD.replacen("name = \"clay\"", &format!("name = \"clay\"\n{keys}"), 1);
        assert_eq!(f.error(&text), format!("s.toml{want}"));
    }
}

#[test]
fn broken_meshes_are_named_with_their_line() {
    let f = Folder::new("meshes");
    let scene = |file: &str| GOOD.replacen("shape = \"sphere\"", &format!("mesh = \"{file}\""), 1);
    f.write("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 NaN 0\nf 1 2 3\n");
    assert_eq!(
        f.error(&scene("nan.obj")),
        "s.toml:18: object[0].mesh: nan.obj:3: vertex has 'NaN'; expected three finite numbers"
    );
    f.write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    assert_eq!(
        f.error(&scene("index.obj")),
        "s.toml:18: object[0].mesh: index.obj:4: vertex 9 does not exist; expected 1 to 3 or -1 to -3"
    );
    f.write("empty.obj", "# nothing\n");
    assert_eq!(
        f.error(&scene("empty.obj")),
        "s.toml:18: object[0].mesh: empty.obj: the mesh has no triangles; expected at least one"
    );
    f.write("broken.gltf", "{\"asset\":");
    let e = f.error(&scene("broken.gltf"));
    assert!(
        e.starts_with("s.toml:18: object[0].mesh: broken.gltf: not readable ("),
        "{e}"
    );
    assert!(e.ends_with("); expected glTF 2.0 with triangles"), "{e}");
}

#[test]
fn a_missing_scene_and_a_wrong_size() {
    let e = scene::load(Path::new("nowhere.toml"))
        .unwrap_err()
        .to_string();
    assert_eq!(
        e,
        "nowhere.toml:1: scene: cannot be read (No such file or directory (os error 2)); expected a readable TOML file"
    );
    let s = common::load("gem");
    let e = Prepared::new(&s, Some((0, 5)), &Skips::all())
        .unwrap_err()
        .to_string();
    assert!(
        e.ends_with("gem.toml:1: size: is 0x5; expected 1x1 to 16384x16384"),
        "{e}"
    );
}

/// Cut and garbled scenes give an error or a scene that can be prepared, never a panic.
#[test]
fn damaged_text_never_panics() {
    let f = Folder::new("damage");
    let file = f.0.join("s.toml");
    let mut rng = StdRng::seed_from_u64(7);
    let mut good: Vec<String> = common::SCENES
        .iter()
        .filter(|n| !["teapot", "gem", "rings"].contains(n))
        .map(|n| std::fs::read_to_string(common::path(n)).unwrap())
        // Coarser meshes with the same keys.
        .map(|text| text.replace("s = 24", "s = 4").replace("s = 32", "s = 4"))
        .collect();
    good.extend(["tiles", "bump"].map(|n| std::fs::read_to_string(common::path(n)).unwrap()));
    good.push(GOOD.to_owned());
    let attempt = |bytes: &[u8]| {
        std::fs::write(&file, bytes).unwrap();
        if let Ok(s) = scene::load(&file) {
            let small = Some((16, 12));
            let _ = Prepared::new(&s, small, &Skips::all());
            let _ = Prepared::new(&s, small, &Skips::none());
        }
    };
    for cut in 0..GOOD.len() {
        attempt(&GOOD.as_bytes()[..cut]);
    }
    let pieces = [
        "-",
        "0",
        "9e99",
        "nan",
        "inf",
        "[",
        "]",
        "\"",
        "\n",
        "=",
        "1e-300",
        "[[object]]",
        "4294967296",
        "é",
    ];
    for _ in 0..3000 {
        let mut text = good[rng.random_range(0..good.len())].clone().into_bytes();
        for _ in 0..rng.random_range(1..4) {
            let at = rng.random_range(0..text.len());
            match rng.random_range(0..3) {
                0 => text[at] = rng.random(),
                1 => {
                    let piece = pieces[rng.random_range(0..pieces.len())].as_bytes();
                    text.splice(
                        at..(at + rng.random_range(0..3)).min(text.len()),
                        piece.iter().copied(),
                    );
                }
                _ => {
                    let end = (at + rng.random_range(1..20)).min(text.len());
                    text.drain(at..end);
                }
            }
        }
        attempt(&text);
    }
}

#[test]
fn errors_of_textures_and_bumps() {
    let f = Folder::new("textures");
    let with = |keys: &str| {
        f.error(&GOOD.replacen("name = \"clay\"", &format!("name = \"clay\"\n{keys}"), 1))
    };
    let png = "expected a PNG file of 1x1 to 4096x4096 texels";
    f.write("no.png", "no picture");
    shadegate_reference::Frame::new(4097, 1, [0; 3])
        .save_png(&f.0.join("wide.png"))
        .unwrap();
    let texture = "texture = \"checker\"";
    let bump = "bump = \"bumps\"";
    for (keys, want) in [
        ("texture = \"chekcer\"".to_owned(), "16: material[0].texture: unknown 'chekcer'; the nearest is 'checker' of checker, tiles; expected one of them or a file ending in .png".to_owned()),
        ("texture = 3".into(), "16: material[0].texture: is an integer; expected checker, tiles or the name of a PNG file".into()),
        ("texture = \"none.png\"".into(), format!("16: material[0].texture: none.png: cannot be read (No such file or directory (os error 2)); {png}")),
        ("texture = \"wide.png\"".into(), format!("16: material[0].texture: wide.png: 4097x1 texels; {png}")),
        ("bump = \"bump\"".into(), "16: material[0].bump: unknown 'bump'; the nearest is 'bumps' of bumps, tiles; expected one of them or a file ending in .png".into()),
        (format!("{texture}\nfilter = \"mipmap\""), "17: material[0].filter: unknown 'mipmap'; the nearest is 'mip-map' of nearest, bilinear, mip-map, ripmap, summed-area".into()),
        (format!("{texture}\nmapping = \"perspektive\""), "17: material[0].mapping: unknown 'perspektive'; the nearest is 'perspective' of perspective, affine, quadratic".into()),
        (format!("{texture}\nwrap = \"repeats\""), "17: material[0].wrap: unknown 'repeats'; the nearest is 'repeat' of repeat, clamp".into()),
        (format!("{texture}\nrepeat = [2, 0]"), "17: material[0].repeat: has 0; expected a number or [u, v], each of size 0.001 to 1000".into()),
        (format!("{texture}\nrepeat = [1, 2, 3]"), "17: material[0].repeat: has 3 elements; expected a number or [u, v], each of size 0.001 to 1000".into()),
        ("filter = \"nearest\"".into(), "16: material[0].filter: given without a picture; expected it only together with texture".into()),
        ("mapping = \"affine\"".into(), "16: material[0].mapping: given without a picture; expected it only together with texture".into()),
        ("repeat = 2".into(), "16: material[0].repeat: given without a picture; expected it only together with texture or bump".into()),
        (format!("{texture}\nbump_scale = 1"), "17: material[0].bump_scale: given without a picture; expected it only together with bump".into()),
        (format!("{bump}\nbump_scale = 1e4"), "17: material[0].bump_scale: is 10000; expected a number from -1000 to 1000".into()),
        (format!("{bump}\nbump_gradient = \"catmul\""), "17: material[0].bump_gradient: unknown 'catmul'; the nearest is 'catmull-rom' of nearest, linear, catmull-rom, b-spline".into()),
        (format!("{bump}\nbump_normalise = \"newtn\""), "17: material[0].bump_normalise: unknown 'newtn'; the nearest is 'newton' of exact, reflection, newton".into()),
    ] {
        assert_eq!(with(&keys), format!("s.toml:{want}"), "{keys}");
    }
    let e = with("texture = \"no.png\"");
    assert!(
        e.starts_with("s.toml:16: material[0].texture: no.png: not readable ("),
        "{e}"
    );
    assert!(e.ends_with(png), "{e}");
    // Meshes without coordinates.
    let mesh = |file: &str, keys: &str| {
        let text = GOOD.replacen("name = \"clay\"", &format!("name = \"clay\"\n{keys}"), 1);
        f.error(&text.replacen("shape = \"sphere\"", &format!("mesh = \"{file}\""), 1))
    };
    f.write(
        "bare.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2 3/1\n",
    );
    assert_eq!(
        mesh("bare.obj", texture),
        "s.toml:19: object[0].mesh: material 'clay' has a texture, but bare.obj:5: corner '2' has no texture coordinates; expected v/t or v/t/n"
    );
    let ring = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/meshes/ring.glb");
    std::fs::copy(ring, f.0.join("ring.glb")).unwrap();
    assert_eq!(
        mesh("ring.glb", bump),
        "s.toml:19: object[0].mesh: material 'clay' has a bump map, but ring.glb has no texture coordinates; expected TEXCOORD_0"
    );
}

//! What is read, and what is said about files that cannot be.

use super::*;

fn parse(text: &str) -> Result<Mesh, MeshError> {
    super::parse(text, Weighting::default())
}

fn error(text: &str) -> String {
    parse(text).unwrap_err().to_string()
}

#[test]
fn what_is_wrong_is_said_with_its_line() {
    assert_eq!(
        error("v 0 0 0\nv 1 nan 0\n"),
        "2: vertex has 'nan'; expected three finite numbers"
    );
    assert_eq!(
        error("v 1 2"),
        "1: vertex has 2 numbers; expected three finite numbers"
    );
    assert_eq!(
        error("v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n"),
        "5: vertex 4 does not exist; expected 1 to 3 or -1 to -3"
    );
    assert_eq!(
        error("v 0 0 0\nf 1 1\n"),
        "2: a face of 2 corners; expected at least three"
    );
    assert_eq!(
        error("v 0 0 0\nf 1 x 1\n"),
        "2: 'x' is not an index; expected v, v/t, v//n or v/t/n"
    );
}

/// What the library would take, or take amiss, is refused as well.
#[test]
fn no_fault_slips_through_the_library() {
    let with = |line: &str| {
        error(&format!(
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1 2 3\n{line}\n"
        ))
    };
    let three = "expected three finite numbers";
    let normal = "expected 1 to 1 or -1 to -1";
    let vertex = "expected 1 to 3 or -1 to -3";
    for (line, want) in [
        ("v 1 inf 0", format!("6: vertex has 'inf'; {three}")),
        (
            "v 1e999 0 0\nf 1 2 4",
            format!("6: vertex has '1e999'; {three}"),
        ),
        ("vn 1 2", format!("6: normal has 2 numbers; {three}")),
        ("v 1 2 x", format!("6: vertex has 'x'; {three}")),
        (
            "f",
            "6: a face of 0 corners; expected at least three".into(),
        ),
        (
            "f 1//0 2//1 3//1",
            format!("6: normal 0 does not exist; {normal}"),
        ),
        (
            "f 1//2 2//2 3//2",
            format!("6: normal 2 does not exist; {normal}"),
        ),
        (
            "f 1//3 2//3 3//3",
            format!("6: normal 3 does not exist; {normal}"),
        ),
        (
            "f 1//-2 2 3",
            format!("6: normal -2 does not exist; {normal}"),
        ),
        ("f 0 2 3", format!("6: vertex 0 does not exist; {vertex}")),
        ("f -4 2 3", format!("6: vertex -4 does not exist; {vertex}")),
        (
            "f 1//6148914691236517206 2 3",
            format!("6: normal 6148914691236517206 does not exist; {normal}"),
        ),
        (
            "f 1 99999999999999999999 3",
            "6: '99999999999999999999' is not an index; expected v, v/t, v//n or v/t/n".into(),
        ),
        (
            "f /1 2 3",
            "6: '' is not an index; expected v, v/t, v//n or v/t/n".into(),
        ),
    ] {
        assert_eq!(with(line), want, "{line}");
    }
}

#[test]
fn polygons_become_fans_and_normals_smooth() {
    let m = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n").unwrap();
    assert_eq!(m.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert!(m.normals.iter().all(|n| *n == DVec3::Z));
}

/// A concave face is covered once, whichever corner comes first; one that crosses itself is still read.
#[test]
fn polygons_are_cut_inside() {
    let corners = ["0 0 0", "4 0 0", "4 4 0", "2 1 0", "0 4 0"];
    for first in 0..5 {
        let mut text = String::new();
        for k in 0..5 {
            text += &format!("v {}\n", corners[(first + k) % 5]);
        }
        let m = parse(&(text + "v 9 9 9\nf 1 2 3 4 5\nf 1 2 6\n")).unwrap();
        assert_eq!(m.triangles.len(), 4);
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| m.positions[i as usize]);
            (b - a).cross(c - a).z / 2.0
        };
        assert!(m.triangles[..3].iter().all(|t| area(t) > 0.0));
        assert_eq!(m.triangles[..3].iter().map(area).sum::<f64>(), 10.0);
    }
    let m = parse("v 0 0 0\nv 3 0 0\nv 0 2 0\nv 3 2 0\nv 1 5 0\nf 1 2 3 4 5\n").unwrap();
    assert_eq!(m.triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
}

#[test]
fn missing_normals_are_made_as_wanted() {
    // Two faces of unequal area at a right angle.
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -3\nf 1 2 3\nf 1 2 4\n";
    let at = |w| super::parse(text, w).unwrap().normals[0];
    assert!(at(Weighting::Uniform).distance(DVec3::new(0.0, 1.0, 1.0).normalize()) < 1e-12);
    assert!(at(Weighting::Area).distance(DVec3::new(0.0, 3.0, 1.0).normalize()) < 1e-12);
    assert!(at(Weighting::Angle).distance(DVec3::new(0.0, 1.0, 1.0).normalize()) < 1e-12);
    assert_eq!(at(Weighting::Face), DVec3::ZERO);
}

/// Given normals are kept and missing ones made; the rest of the format neither splits vertices nor stops the reader.
#[test]
fn what_is_not_used_does_not_matter() {
    let m = parse(
        "mtllib none.mtl\no one\nv 0 0 0 # corner\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 2\nv 1 1 0\nvt 0.5\nvt 1 1\n\
         vn 0 3 4\ng left\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/1/1\ng right\nf 4/2 3/2 2/1\nl 1 2 3\np 1\n",
    )
    .unwrap();
    let given = DVec3::new(0.0, 3.0, 4.0);
    assert_eq!(m.triangles, [[0, 1, 2], [3, 4, 5]]);
    assert_eq!(m.positions[2], DVec3::Y);
    assert_eq!(m.positions[4], DVec3::Y);
    assert_eq!(m.normals[..3], [given; 3]);
    assert_eq!(m.normals[3..], [DVec3::Z; 3]);
    // Without normals, faces of two groups share their vertices.
    let m = parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\ng b\nf 2/7 4 3\n").unwrap();
    assert_eq!(m.triangles, [[0, 1, 2], [1, 3, 2]]);
}

/// Numbers keep the precision of f64.
#[test]
fn numbers_are_double() {
    let m = parse("v 0.1 0.2 0.3\nv 1 0 0\nv 0 1e-300 0\nf 1 2 3\n").unwrap();
    assert_eq!(m.positions[0], DVec3::new(0.1, 0.2, 0.3));
    assert_eq!(m.positions[2].y, 1e-300);
}

/// The mesh that comes with Shadegate: Euler's formula, and its numbers read again by hand.
#[test]
fn the_gem() {
    let text = include_str!("../../../../scenes/meshes/gem.obj");
    let m = parse(text).unwrap();
    assert_eq!(m.check(), Ok(()));
    crate::mesh::assert_closed(&m);
    let given: Vec<DVec3> = text
        .lines()
        .filter_map(|l| l.strip_prefix("v "))
        .map(|l| {
            let v: Vec<f64> = l.split_whitespace().map(|w| w.parse().unwrap()).collect();
            DVec3::new(v[0], v[1], v[2])
        })
        .collect();
    assert!(m.positions.iter().all(|p| given.contains(p)));
    assert!(given.iter().all(|p| m.positions.contains(p)));
}

/// Damaged files are refused or read, but never bring the program down.
#[test]
fn damage_never_panics() {
    let good = include_str!("../../../../scenes/meshes/gem.obj");
    let pieces = [
        "/",
        "//",
        "-",
        "0",
        "-9999999999",
        "9999999999",
        "f ",
        "\nvn ",
        "\nv ",
        "nan",
        "e",
        " ",
    ];
    let mut seed = 1u32;
    let mut random = |below: usize| {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 8) as usize % below
    };
    for _ in 0..3000 {
        let mut text = good.to_owned();
        for _ in 0..3 {
            let at = random(text.len());
            if text.is_char_boundary(at) {
                text.insert_str(at, pieces[random(pieces.len())]);
            }
        }
        let _ = parse(&text).map(|m| m.check());
    }
}

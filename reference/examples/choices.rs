//! scratch
use shadegate_reference::{scene, shade::auto::Auto, shade::bound::Tables, Prepared, Skips};
use std::path::Path;
fn main() {
    for f in std::env::args().skip(1) {
        let scene = scene::load(Path::new(&f)).unwrap();
        let p = Prepared::new(&scene, None, &Skips::all()).unwrap();
        for e in [0.3, 1.0, 2.0, 4.0] {
            let a = Auto::new(&p, e, &Skips::all());
            println!("{f} {e}: {:?}", a.skipped());
        }
        let t = Tables::new(&p);
        for k in (0..p.triangles.len()).step_by(p.triangles.len() / 12) {
            println!("  {:?}", t.bounds(&p, &p.triangles[k]));
        }
    }
}

//! The spheres of the sweep: one scene, `scenes/sphere-690.toml`, with its sphere cut into other numbers of triangles
//! (168, 374 and 690 as in Abbas 2003, ch. 7) and with other exponents.

use shadegate_reference::mesh::sphere::sphere;
use shadegate_reference::{scene, Scene, SceneError};
use std::path::Path;

/// A sphere of the sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tessellation {
    /// Name of the scene.
    pub name: &'static str,
    slices: u32,
    stacks: u32,
}

impl Tessellation {
    /// From coarse to fine.
    pub const ALL: [Self; 5] = [
        Self::new("sphere-168", 12, 8),
        Self::new("sphere-374", 17, 12),
        Self::new("sphere-690", 23, 16),
        Self::new("sphere-10k", 100, 51),
        Self::new("sphere-100k", 250, 201),
    ];

    const fn new(name: &'static str, slices: u32, stacks: u32) -> Self {
        Self {
            name,
            slices,
            stacks,
        }
    }

    /// The one of the papers' timings.
    #[must_use]
    pub fn of_690() -> Self {
        Self::ALL[2]
    }

    /// Triangles of the whole sphere.
    #[must_use]
    pub fn triangles(self) -> u64 {
        2 * u64::from(self.slices) * u64::from(self.stacks - 1)
    }

    /// The scene, with this exponent for all materials.
    ///
    /// # Errors
    /// None with the scene that this is built with.
    pub fn scene(self, exponent: u32) -> Result<Scene, SceneError> {
        const TEXT: &str = include_str!("../../../scenes/sphere-690.toml");
        let mut scene = scene::parse(Path::new("sphere-690.toml"), TEXT)?;
        self.name.clone_into(&mut scene.name);
        for m in &mut scene.materials {
            m.shininess = exponent.into();
        }
        for o in &mut scene.objects {
            o.mesh = sphere(self.slices, self.stacks, 1.0);
        }
        Ok(scene)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spheres_have_the_triangles_of_their_names() {
        let counts = Tessellation::ALL.map(Tessellation::triangles);
        assert_eq!(counts, [168, 374, 690, 10_000, 100_000]);
        for t in Tessellation::ALL {
            let s = t.scene(7).unwrap();
            assert_eq!(s.name, t.name);
            assert_eq!(s.objects.len(), 1);
            assert_eq!(s.objects[0].mesh.triangles.len() as u64, t.triangles());
            assert!(s.materials.iter().all(|m| m.shininess == 7.0));
        }
    }

    #[test]
    fn the_sphere_of_the_file_is_the_one_of_690() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/sphere-690.toml");
        let read = scene::load(&file).unwrap();
        let made = Tessellation::of_690().scene(20).unwrap();
        assert_eq!(read.objects[0].mesh, made.objects[0].mesh);
        assert_eq!(read.materials, made.materials);
        assert_eq!(read.name, made.name);
    }
}

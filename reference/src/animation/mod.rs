//! What moves: objects that spin, and paths of objects and of the camera from key to key. Positions follow smooth curves
//! through the keys ([`catmull_rom`]), orientations turn evenly between them ([`orientation`]). A frame is worked out from
//! its time alone, so that frames may be drawn in any order and nothing adds up.

pub mod catmull_rom;
pub mod orientation;

use crate::scene::{Camera, Scene};
use catmull_rom::{segment, Path};
use glam::{DMat3, DMat4, DQuat, DVec3};
use orientation::{looking, quaternion, slerp};

/// The greatest number of frames.
pub const FRAME_LIMIT: u32 = 100_000;
/// The greatest number of sub-frames of a frame.
pub const SUBFRAME_LIMIT: u32 = 256;

/// How a scene moves. Time is counted in frames: frame k is seen at time k.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// Frames in all, 1 to [`FRAME_LIMIT`].
    pub frames: u32,
    /// All objects turn about an axis (unit vector) through their own origins, by so many degrees in all frames together.
    pub spin: Option<(DVec3, f64)>,
    /// Where the camera goes.
    pub camera: Option<CameraPath>,
    /// Where objects go.
    pub objects: Vec<ObjectPath>,
    /// How long the shutter is open, in frames, 0 to 1; about the time of the frame.
    pub shutter: f64,
    /// Temporal samples of a frame, 1 to [`SUBFRAME_LIMIT`]; 1 for no motion blur.
    pub subframes: u32,
}

/// Orientations at keys.
#[derive(Clone, Debug, PartialEq)]
struct Turns(Vec<(f64, DQuat)>);

impl Turns {
    fn new(mut keys: Vec<(f64, DQuat)>) -> Self {
        keys.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self(keys)
    }

    fn at(&self, time: f64) -> DQuat {
        let (k, t) = segment(self.0.iter().map(|k| k.0), time);
        match self.0.get(k + 1) {
            Some(next) => slerp(self.0[k].1, next.1, t),
            None => self.0[k].1,
        }
    }
}

/// The path of an object, which takes the place of its own translation and rotation; its scale stays.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectPath {
    /// Index of the object.
    pub object: usize,
    /// Applied first, as without a path.
    scale: DVec3,
    places: Path,
    turns: Turns,
}

/// Where an object is at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectKey {
    /// In frames.
    pub time: f64,
    /// Position of the object's origin.
    pub place: DVec3,
    /// Its orientation, a unit quaternion.
    pub turn: DQuat,
}

impl ObjectPath {
    /// The path through these keys; none without keys or when two have one time.
    #[must_use]
    pub fn new(object: usize, scale: DVec3, keys: &[ObjectKey]) -> Option<Self> {
        Some(Self {
            object,
            scale,
            places: Path::new(keys.iter().map(|k| (k.time, k.place)).collect())?,
            turns: Turns::new(keys.iter().map(|k| (k.time, k.turn)).collect()),
        })
    }

    /// The transform at a time.
    #[must_use]
    pub fn at(&self, time: f64) -> DMat4 {
        DMat4::from_scale_rotation_translation(
            self.scale,
            self.turns.at(time),
            self.places.at(time),
        )
    }
}

/// The path of the camera: the eye on a curve, the view turning evenly.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraPath {
    eyes: Path,
    turns: Turns,
    /// Distances of the target along the view.
    targets: Path,
}

/// Where the camera is at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraKey {
    /// In frames.
    pub time: f64,
    /// The eye.
    pub eye: DVec3,
    /// What it looks at.
    pub target: DVec3,
    /// A direction that appears upwards.
    pub up: DVec3,
}

impl CameraPath {
    /// The path through these keys; none without keys, when two have one time, or when one looks nowhere or along its up.
    #[must_use]
    pub fn new(keys: &[CameraKey]) -> Option<Self> {
        let frame = |k: &CameraKey| Some((k.time, quaternion(looking(k.target - k.eye, k.up)?)));
        let turns = keys.iter().map(frame).collect::<Option<Vec<_>>>()?;
        let distance = |k: &CameraKey| (k.time, DVec3::splat(k.eye.distance(k.target)));
        Some(Self {
            eyes: Path::new(keys.iter().map(|k| (k.time, k.eye)).collect())?,
            turns: Turns::new(turns),
            targets: Path::new(keys.iter().map(distance).collect())?,
        })
    }

    /// `camera`, moved to where it is at a time.
    #[must_use]
    pub fn at(&self, camera: &Camera, time: f64) -> Camera {
        let eye = self.eyes.at(time);
        // Turns are unit quaternions, so this frame is orthonormal to the last bit or two.
        let frame = DMat3::from_quat(self.turns.at(time));
        let distance = self.targets.at(time).x.max(1e-9 * (1.0 + eye.length()));
        Camera {
            eye,
            target: eye - frame.z_axis * distance,
            up: frame.y_axis,
            ..*camera
        }
    }
}

/// A scene that can be put at any time. The meshes are there once.
#[derive(Clone, Debug)]
pub struct Player {
    scene: Scene,
    camera: Camera,
    transforms: Vec<DMat4>,
}

impl Player {
    /// Plays a scene; one without animation stands still.
    #[must_use]
    pub fn new(scene: Scene) -> Self {
        Self {
            camera: scene.camera,
            transforms: scene.objects.iter().map(|o| o.transform).collect(),
            scene,
        }
    }

    /// The scene at a time, in frames.
    pub fn at(&mut self, time: f64) -> &Scene {
        let Some(animation) = &self.scene.animation else {
            return &self.scene;
        };
        if let Some(path) = &animation.camera {
            self.scene.camera = path.at(&self.camera, time);
        }
        for (object, own) in self.scene.objects.iter_mut().zip(&self.transforms) {
            object.transform = *own;
        }
        for path in &animation.objects {
            if let Some(object) = self.scene.objects.get_mut(path.object) {
                object.transform = path.at(time);
            }
        }
        if let Some((axis, degrees)) = animation.spin {
            let angle = degrees.to_radians() * (time / f64::from(animation.frames));
            let turn = DMat4::from_axis_angle(axis, angle);
            for object in &mut self.scene.objects {
                let origin = object.transform.w_axis.truncate();
                object.transform = DMat4::from_translation(origin)
                    * turn
                    * DMat4::from_translation(-origin)
                    * object.transform;
            }
        }
        &self.scene
    }
}

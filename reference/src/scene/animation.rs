//! `[animation]`: how many frames, what spins, and the keys of paths.

use super::object;
use super::read::Table;
use super::{Camera, SceneError};
use crate::animation::{
    Animation, CameraKey, CameraPath, ObjectKey, ObjectPath, FRAME_LIMIT, SUBFRAME_LIMIT,
};
use glam::DVec3;
use std::collections::BTreeMap;

const KEYS: &[&str] = &["frames", "spin", "shutter", "subframes", "camera", "object"];

/// A time that no other key of the path has.
fn time(t: &Table<'_>, taken: &mut Vec<f64>) -> Result<f64, SceneError> {
    let time = t
        .number_if("time", "a number of frames", |_| true)?
        .ok_or_else(|| t.missing("time", "a number of frames"))?;
    if taken.contains(&time) {
        return Err(t.error(
            "time",
            &format!("is {time}, as of a key before"),
            "expected a time of its own",
        ));
    }
    taken.push(time);
    Ok(time)
}

fn spin(t: &Table<'_>) -> Result<Option<(DVec3, f64)>, SceneError> {
    let Some(t) = t.table("spin", &["axis", "degrees"])? else {
        return Ok(None);
    };
    let axis = t.vector("axis")?.unwrap_or(DVec3::Y);
    if axis.length() < 1e-9 {
        return Err(t.error(
            "axis",
            "has no length",
            "expected a direction such as [0, 1, 0]",
        ));
    }
    let degrees = t.number_if("degrees", "degrees for all frames together", |_| true)?;
    Ok(Some((axis.normalize(), degrees.unwrap_or(360.0))))
}

fn camera_path(t: &Table<'_>, camera: &Camera) -> Result<Option<CameraPath>, SceneError> {
    let mut taken = Vec::new();
    let mut keys = Vec::new();
    for t in t.tables("camera", &["time", "eye", "target", "up"])? {
        let key = CameraKey {
            time: time(&t, &mut taken)?,
            eye: t.vector("eye")?.unwrap_or(camera.eye),
            target: t.vector("target")?.unwrap_or(camera.target),
            up: t.vector("up")?.unwrap_or(camera.up),
        };
        super::build::check_view(&t, key.eye, key.target, key.up)?;
        keys.push(key);
    }
    Ok(CameraPath::new(&keys))
}

fn object_paths(t: &Table<'_>, objects: &[Table<'_>]) -> Result<Vec<ObjectPath>, SceneError> {
    let mut paths: BTreeMap<usize, (Vec<f64>, Vec<ObjectKey>)> = BTreeMap::new();
    for t in t.tables("object", &["object", "time", "translate", "rotate"])? {
        let last = objects.len().saturating_sub(1) as u32;
        let index = t
            .integer("object", 0, last)?
            .ok_or_else(|| t.missing("object", &format!("an integer from 0 to {last}")))?
            as usize;
        let own = &objects[index];
        let (taken, keys) = paths.entry(index).or_default();
        let place = match t.vector("translate")? {
            Some(place) => place,
            None => object::translation(own)?,
        };
        keys.push(ObjectKey {
            time: time(&t, taken)?,
            place,
            turn: object::rotation(if t.has("rotate") { &t } else { own })?,
        });
    }
    let path = |(index, (_, keys)): (usize, (_, Vec<ObjectKey>))| {
        let scale = object::scale(&objects[index])?;
        Ok(ObjectPath::new(index, scale, &keys))
    };
    let all: Result<Vec<_>, SceneError> = paths.into_iter().map(path).collect();
    Ok(all?.into_iter().flatten().collect())
}

/// The animation of a scene, if it has one; `objects` are the tables of its objects.
pub(super) fn animation(
    root: &Table<'_>,
    camera: &Camera,
    objects: &[Table<'_>],
) -> Result<Option<Animation>, SceneError> {
    let Some(t) = root.table("animation", KEYS)? else {
        return Ok(None);
    };
    let frames = t
        .integer("frames", 1, FRAME_LIMIT)?
        .ok_or_else(|| t.missing("frames", &format!("an integer from 1 to {FRAME_LIMIT}")))?;
    let shutter = t.number_if("shutter", "a number from 0 to 1, in frames", |s| {
        (0.0..=1.0).contains(&s)
    })?;
    Ok(Some(Animation {
        frames,
        spin: spin(&t)?,
        camera: camera_path(&t, camera)?,
        objects: object_paths(&t, objects)?,
        shutter: shutter.unwrap_or(0.5),
        subframes: t.integer("subframes", 1, SUBFRAME_LIMIT)?.unwrap_or(1),
    }))
}

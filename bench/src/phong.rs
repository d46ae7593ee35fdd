//! A teapot shaded per pixel: euc and we draw the same mesh under the same lights, at 640 by 480.
//!
//! euc interpolates position and normal with perspective, normalises, and evaluates Blinn's model with `powf`, all in
//! f32, in a fragment shader that is the same reflection model as ours. Its frame is compared with `exact`, so that a
//! mistake here could not pass for speed.

use crate::report::Report;
use crate::turns::{cell, time, Job, Times, Took, PART, WHOLE};
use euc::buffer::Buffer2d;
use euc::rasterizer::Triangles;
use euc::{Pipeline, Target};
use shadegate_reference::scene::{LightKind, Projection};
use shadegate_reference::{render, scene, with_threads};
use shadegate_reference::{Frame, Method, Prepared, RenderOptions, Scene, Skips};
use shadegate_testbench::bench::clock::Effort;
use shadegate_testbench::compare::{compare as apart, Rgb8Ref};
use std::path::Path;
use std::time::Instant;
use vek::{Mat4, Vec3, Vec4};

const SIZE: (u32, u32) = (640, 480);
const TEXT: &str = include_str!("../../scenes/teapot.toml");

/// A light as the fragment shader wants it.
enum Light {
    /// Unit vector towards it.
    Far(Vec3<f32>),
    /// Where it is.
    Near(Vec3<f32>),
}

/// A corner: position and normal in the world.
type Corner = (Vec3<f32>, Vec3<f32>);

/// The scene in euc's terms.
struct Teapot {
    to_clip: Mat4<f32>,
    eye: Vec3<f32>,
    lights: Vec<(Light, Vec3<f32>)>,
    ambient: Vec3<f32>,
    diffuse: Vec3<f32>,
    specular: Vec3<f32>,
    shininess: f32,
}

impl Pipeline for Teapot {
    type Vertex = Corner;
    type VsOut = Corner;
    type Pixel = [u8; 3];

    #[inline(always)]
    fn vert(&self, (position, normal): &Corner) -> ([f32; 4], Corner) {
        let clip = self.to_clip * Vec4::from_point(*position);
        (clip.into_array(), (*position, *normal))
    }

    #[inline(always)]
    fn frag(&self, (position, normal): &Corner) -> [u8; 3] {
        let normal = normal.normalized();
        let view = (self.eye - *position).normalized();
        let mut sum = self.ambient;
        for (light, colour) in &self.lights {
            let to_light = match light {
                Light::Far(l) => *l,
                Light::Near(p) => (*p - *position).normalized(),
            };
            let half = (to_light + view).normalized();
            let highlight = normal.dot(half).max(0.0).powf(self.shininess);
            let lit = self.diffuse * normal.dot(to_light).max(0.0) + self.specular * highlight;
            sum += *colour * lit;
        }
        // The conversion saturates.
        (sum * 255.0).map(|v| (v + 0.5) as u8).into_array()
    }
}

/// Takes a scene of one object with one material over.
fn teapot(scene: &Scene) -> Result<(Teapot, Vec<Corner>), String> {
    let v = |v: [f64; 3]| Vec3::from(v).map(|c: f64| c as f32);
    let (Some(material), Some(object)) = (scene.materials.first(), scene.objects.first()) else {
        return Err("the scene has no object".to_owned());
    };
    let camera = &scene.camera;
    let Projection::Perspective { fov } = camera.projection else {
        return Err("the scene has no perspective".to_owned());
    };
    let eye = v(camera.eye.to_array());
    let projection = Mat4::perspective_fov_rh_no(
        fov.to_radians() as f32,
        SIZE.0 as f32,
        SIZE.1 as f32,
        camera.near as f32,
        camera.far as f32,
    );
    let look = Mat4::look_at_rh(eye, v(camera.target.to_array()), v(camera.up.to_array()));
    let lights = scene.lights.iter().map(|l| {
        let light = if let LightKind::Directional { direction, .. } = l.kind {
            Light::Far(-v(direction.to_array()))
        } else if let LightKind::Point { position, .. } = l.kind {
            Light::Near(v(position.to_array()))
        } else {
            return Err("the scene has a light that is not for euc".to_owned());
        };
        Ok((light, v(l.colour.to_array())))
    });
    let lights = lights.collect::<Result<_, String>>()?;
    let mesh = &object.mesh;
    let corners = mesh.triangles.iter().flatten().map(|i| {
        let i = *i as usize;
        let world = object.transform.transform_point3(mesh.positions[i]);
        (v(world.to_array()), v(mesh.normals[i].to_array()))
    });
    let out = Teapot {
        to_clip: projection * look,
        eye,
        lights,
        ambient: v(material.ambient.to_array()),
        diffuse: v(material.diffuse.to_array()),
        specular: v(material.specular.to_array()),
        shininess: material.shininess as f32,
    };
    Ok((out, corners.collect()))
}

/// Measures euc and our methods that shade per pixel.
pub fn compare(effort: Effort, report: &mut Report) -> Result<(), String> {
    let scene = scene::parse(Path::new("teapot.toml"), TEXT).map_err(|e| e.to_string())?;
    let (pipeline, corners) = teapot(&scene)?;
    let size = [SIZE.0 as usize, SIZE.1 as usize];
    let mut colour = Buffer2d::new(size, [0u8; 3]);
    let mut depth = Buffer2d::new(size, 1.0f32);
    let background = scene.image.background;
    let euc = |colour: &mut Buffer2d<[u8; 3]>, depth: &mut Buffer2d<f32>| {
        colour.clear(background);
        depth.clear(1.0);
        pipeline.draw::<Triangles<'_, _>, _>(&corners, colour, Some(depth));
    };
    euc(&mut colour, &mut depth);
    let drawn = colour.as_ref().to_vec();
    let prepared = || Prepared::new(&scene, Some(SIZE), &Skips::all()).map_err(|e| e.to_string());
    let truth = render(&prepared()?, Method::Exact, &RenderOptions::default()).0;
    let methods: Vec<Method> = ["phong", "exact"]
        .iter()
        .filter_map(|m| m.parse().ok())
        .collect();
    let mut jobs: Vec<Job<'_>> = vec![Box::new(|| time(|| euc(&mut colour, &mut depth)))];
    for method in &methods {
        jobs.push(Box::new(|| ours(&scene, *method)));
    }
    let times = Times::measure(jobs, effort);
    let mut rows = vec![vec![
        "euc 0.5.3".to_owned(),
        "-".to_owned(),
        cell(times.ns(0, WHOLE), ms),
        "1".to_owned(),
        error(&truth, &drawn)?,
    ]];
    for (i, method) in methods.iter().enumerate() {
        let frame = render(&prepared()?, *method, &RenderOptions::default()).0;
        rows.push(vec![
            method.name().to_owned(),
            cell(times.ns(1 + i, PART), ms),
            cell(times.ns(1 + i, WHOLE), ms),
            cell(times.ratio((0, WHOLE), (1 + i, WHOLE)), |r| {
                format!("{r:.2}")
            }),
            error(&truth, &frame.pixels)?,
        ]);
    }
    let triangles = corners.len() / 3;
    report.section(
        "Per-pixel Phong",
        &format!(
            "scenes/teapot.toml, {triangles} triangles, two lights, exponent {}, 640x480, one thread, milliseconds. Both \
             clear, transform, cull back faces, test depth and shade every visible pixel when it is met. *Drawing* is ours \
             without transform, culling and clipping. Ratios are euc's time over the whole of ours. Errors are against \
             `exact`.",
            pipeline.shininess
        ),
    );
    report.table(
        &["renderer", "drawing", "whole", "ratio", "RMS, max LSB"],
        1,
        &rows,
    );
    Ok(())
}

fn ms(ns: f64) -> String {
    format!("{:.2}", ns / 1e6)
}

/// A frame of ours, from the scene in memory.
fn ours(scene: &Scene, method: Method) -> Took {
    let options = RenderOptions {
        threads: Some(1),
        ..RenderOptions::default()
    };
    let begin = Instant::now();
    // The size is one that scenes may have.
    let prepare = || Prepared::new(scene, Some(SIZE), &Skips::all());
    let Ok(p) = with_threads(options.threads, prepare) else {
        return Took::NOTHING;
    };
    let before = begin.elapsed().as_nanos() as f64;
    let s = render(&p, method, &options).1;
    let part = (s.setup_ns + s.raster_ns) as f64;
    Took {
        part,
        whole: before + part,
    }
}

fn error(truth: &Frame, pixels: &[[u8; 3]]) -> Result<String, String> {
    let view = |pixels| Rgb8Ref::new(SIZE.0, SIZE.1, pixels).map_err(|e| e.to_string());
    let c = apart(view(&truth.pixels)?, view(pixels)?).map_err(|e| e.to_string())?;
    Ok(format!("{:.3}, {}", c.rms_lsb, c.max_lsb))
}

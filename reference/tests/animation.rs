//! Scenes that move, and frames of many samples.

mod common;

use common::{difference, draw, load, path, prepare};
use glam::{DMat4, DVec3};
use shadegate_reference::animation::{Animation, Player};
use shadegate_reference::antialias::Antialias;
use shadegate_reference::sample::{self, filter, Filter, Wanted};
use shadegate_reference::{
    render, scene, Frame, Method, Prepared, RenderOptions, Scene, SceneError, Skips,
};

fn wanted(method: Method) -> Wanted {
    Wanted {
        size: Some((96, 72)),
        method,
        samples: 1,
        filter: Filter::Box,
        antialias: Antialias::None,
        options: RenderOptions::default(),
    }
}

fn spinning(degrees: f64, subframes: u32) -> Scene {
    let mut scene = load("gem");
    scene.animation = Some(Animation {
        frames: 12,
        spin: Some((DVec3::Y, degrees)),
        camera: None,
        objects: Vec::new(),
        shutter: 0.5,
        subframes,
    });
    scene
}

#[test]
fn a_scene_that_stands_still_is_its_frame() {
    for name in ["gem", "two-lights"] {
        let drawn =
            sample::draw(&mut Player::new(load(name)), 0, &wanted(Method::Gouraud)).unwrap();
        let p = prepare(name, Some((96, 72)));
        let (frame, stats) = render(&p, Method::Gouraud, &RenderOptions::default());
        assert_eq!(drawn.frame, frame);
        assert_eq!(drawn.stats.pixels_written, stats.pixels_written);
        assert_eq!((drawn.subframes, drawn.prepared.counts), (1, p.counts));
    }
}

#[test]
fn objects_spin_about_their_own_origins_and_come_round() {
    let mut scene = spinning(360.0, 1);
    scene.objects[0].transform =
        DMat4::from_translation(DVec3::new(0.4, -0.1, 0.3)) * scene.objects[0].transform;
    let own = scene.objects[0].transform;
    let mut player = Player::new(scene);
    for frame in [0u32, 1, 5, 11] {
        let angle = f64::from(frame) / 12.0 * std::f64::consts::TAU;
        let t = player.at(f64::from(frame)).objects[0].transform;
        // The origin stays; a direction turns.
        assert!(t.w_axis.distance(own.w_axis) < 1e-12);
        let turned = DMat4::from_rotation_y(angle) * DMat4::from_mat3(glam::DMat3::from_mat4(own));
        assert!(
            t.x_axis.distance(turned.x_axis) < 1e-12 && t.z_axis.distance(turned.z_axis) < 1e-12
        );
    }
    let round = player.at(12.0).objects[0].transform;
    assert!(round.abs_diff_eq(own, 1e-12));
    // And back at any time: nothing adds up.
    assert_eq!(player.at(0.0).objects[0].transform, own);
}

#[test]
fn paths_go_through_their_keys() {
    let scene = load("spin");
    let (camera, objects) = (scene.camera, scene.objects.clone());
    let mut player = Player::new(scene);
    let mut without_spin = player.at(0.0).clone();
    if let Some(a) = &mut without_spin.animation {
        a.spin = None;
    }
    let mut player = {
        without_spin.camera = camera;
        without_spin.objects = objects;
        let _ = player.at(1.0);
        Player::new(without_spin)
    };
    let c = player.at(30.0).camera;
    assert!(c.eye.distance(DVec3::new(1.5, 2.6, 5.2)) < 1e-12);
    assert!(c.target.distance(DVec3::ZERO) < 1e-12);
    let (view, up) = ((c.target - c.eye).normalize(), c.up);
    assert!(view.dot(up).abs() < 1e-12 && (up.length() - 1.0).abs() < 1e-12 && up.y > 0.5);
    let c = player.at(0.0).camera;
    assert!(c.eye.distance(camera.eye) < 1e-12 && c.target.distance(camera.target) < 1e-12);
    let ring = player.at(12.0).objects[1].transform;
    assert!(ring.w_axis.truncate().distance(DVec3::new(0.0, 0.3, 0.0)) < 1e-12);
    let turn = DMat4::from_rotation_z(25f64.to_radians());
    assert!(ring.x_axis.distance(turn.x_axis) < 1e-12);
    // In between it stays a rotation, whatever the time.
    for k in 0..100 {
        let m = glam::DMat3::from_mat4(player.at(f64::from(k) * 0.61 - 5.0).objects[1].transform);
        let defect = m.transpose() * m - glam::DMat3::IDENTITY;
        assert!(defect.to_cols_array().iter().all(|v| v.abs() < 1e-14));
    }
}

#[test]
fn every_frame_of_the_scene_that_spins_can_be_drawn() {
    let scene = load("spin");
    let a = scene.animation.clone().unwrap();
    assert_eq!((a.frames, a.subframes), (48, 8));
    let mut w = wanted(scene.render.method);
    (w.samples, w.filter) = (scene.render.samples, scene.render.filter);
    let mut player = Player::new(scene);
    let mut frames: Vec<Frame> = Vec::new();
    for k in (0..48).step_by(8) {
        let drawn = sample::draw(&mut player, k, &w).unwrap();
        assert_eq!(drawn.subframes, 8, "it moves by more than a pixel");
        assert!(frames.iter().all(|f| *f != drawn.frame));
        frames.push(drawn.frame);
    }
    // In any order: the first again.
    assert_eq!(sample::draw(&mut player, 0, &w).unwrap().frame, frames[0]);
}

#[test]
fn motion_blur_is_the_mean_of_its_sub_frames() {
    let scene = spinning(600.0, 5);
    let drawn = sample::draw(&mut Player::new(scene.clone()), 3, &wanted(Method::Exact)).unwrap();
    assert_eq!(drawn.subframes, 5);
    let own = scene.objects[0].transform;
    let mut sums = vec![[0u32; 3]; 96 * 72];
    for k in 0..5 {
        let time = 3.0 + 0.5 * ((f64::from(k) + 0.5) / 5.0 - 0.5);
        let mut still = scene.clone();
        let (origin, angle) = (own.w_axis.truncate(), (600.0 * (time / 12.0)).to_radians());
        still.objects[0].transform = DMat4::from_translation(origin)
            * DMat4::from_axis_angle(DVec3::Y, angle)
            * DMat4::from_translation(-origin)
            * own;
        let p = Prepared::new(&still, Some((96, 72)), &Skips::all()).unwrap();
        for (s, v) in sums.iter_mut().zip(&draw(&p, Method::Exact).pixels) {
            *s = [0, 1, 2].map(|c| s[c] + u32::from(v[c]));
        }
    }
    let want: Vec<[u8; 3]> = sums
        .iter()
        .map(|s| s.map(|s| ((s + 2) / 5) as u8))
        .collect();
    assert!(drawn.frame.pixels == want);
    assert_eq!(drawn.stats.skipped.get("blur"), None);
}

/// What moves by less than a pixel is drawn once. Every point is then less than a pixel from where it would be, so that
/// no pixel leaves the range of its neighbours, but for the change of light, which is slight.
#[test]
fn slow_motion_is_not_blurred() {
    let scene = spinning(6.0, 8);
    let mut player = Player::new(scene);
    let mut w = wanted(Method::Exact);
    let still = sample::draw(&mut player, 2, &w).unwrap();
    assert_eq!((still.subframes, still.stats.skipped["blur"]), (1, 7));
    w.options.skips = Skips::without("blur").unwrap();
    let blurred = sample::draw(&mut player, 2, &w).unwrap();
    assert_eq!(blurred.subframes, 8);
    assert_eq!(blurred.stats.skipped.get("blur"), None);
    assert!(blurred.frame != still.frame, "there is something to skip");
    let at = |x: i32, y: i32| {
        let inside = (0..96).contains(&x) && (0..72).contains(&y);
        inside.then(|| still.frame.pixels[(y * 96 + x) as usize])
    };
    for (k, pixel) in blurred.frame.pixels.iter().enumerate() {
        let (x, y) = ((k % 96) as i32, (k / 96) as i32);
        let around: Vec<_> = (0..9)
            .filter_map(|n| at(x + n % 3 - 1, y + n / 3 - 1))
            .collect();
        for c in 0..3 {
            let least = around.iter().map(|p| p[c]).min().unwrap();
            let most = around.iter().map(|p| p[c]).max().unwrap();
            let range = i32::from(least) - 2..=i32::from(most) + 2;
            assert!(range.contains(&i32::from(pixel[c])), "{x} {y}");
        }
    }
    // A whole turn while the shutter is open ends where it began and is motion all the same.
    let mut player = Player::new(spinning(12.0 * 2.0 * 360.0, 4));
    assert_eq!(
        sample::draw(&mut player, 2, &wanted(Method::Flat))
            .unwrap()
            .subframes,
        4
    );
}

#[test]
fn supersampling_is_a_larger_frame_filtered() {
    for f in [Filter::Box, Filter::Tent] {
        let mut w = wanted(Method::Quadratic);
        (w.samples, w.filter) = (3, f);
        let drawn = sample::draw(&mut Player::new(load("two-lights")), 0, &w).unwrap();
        let large = draw(&prepare("two-lights", Some((288, 216))), Method::Quadratic);
        assert_eq!(drawn.frame, filter::down(large, 3, f));
    }
}

/// More samples come nearer to many more, of which 16 × 16 stand for the truth.
#[test]
fn samples_converge() {
    let mut player = Player::new(load("gem"));
    let mut at = |samples| {
        let mut w = wanted(Method::Flat);
        w.samples = samples;
        sample::draw(&mut player, 0, &w).unwrap().frame
    };
    let truth = at(16);
    let rms: Vec<f64> = [1, 2, 4, 8].map(|n| difference(&truth, &at(n)).1).to_vec();
    assert!(rms.windows(2).all(|w| w[1] < 0.6 * w[0]), "{rms:?}");
    assert!(rms[3] < 0.5, "{rms:?}");
}

#[test]
fn more_samples_than_a_frame_may_have_are_refused() {
    let mut w = wanted(Method::Flat);
    (w.size, w.samples) = (Some((2000, 8)), 9);
    let e: SceneError = sample::draw(&mut Player::new(load("gem")), 0, &w).unwrap_err();
    let line = e.to_string();
    assert!(
        line.ends_with("gem.toml:1: size: is 2000x8 with 9 samples in each direction; expected at most 1820x1820 with so many"),
        "{line}"
    );
    assert!(scene::load(&path("spin")).is_ok());
}

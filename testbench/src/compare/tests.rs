//! Tests of the comparison against slow, independent recomputations and known pictures.

use super::*;
use image::{DynamicImage, ImageBuffer, Luma, LumaA, Rgb, Rgba};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::path::Path;

fn frame(width: u32, height: u32, pixels: Vec<[u8; 3]>) -> Rgb8Image {
    Rgb8Image::new(width, height, pixels).unwrap()
}

/// A random frame, and one that differs from it by at most `most` LSB in some channels.
fn pair(seed: u64, width: u32, height: u32, most: i16) -> (Rgb8Image, Rgb8Image) {
    let mut rng = StdRng::seed_from_u64(seed);
    let count = width as usize * height as usize;
    let a: Vec<[u8; 3]> = (0..count).map(|_| rng.random()).collect();
    let b = a
        .iter()
        .map(|p| p.map(|c| (i16::from(c) + rng.random_range(-most..=most)).clamp(0, 255) as u8))
        .collect();
    (frame(width, height, a), frame(width, height, b))
}

/// Mean square error from its definition, pixel by pixel in floating point, by a running mean
/// rather than a histogram of integers.
fn mean_square(a: &Rgb8Image, b: &Rgb8Image) -> f64 {
    let mut mean = 0.0;
    let mut n = 0.0;
    for y in 0..a.height {
        for x in 0..a.width {
            for c in 0..3 {
                let at = |f: &Rgb8Image| f64::from(f.pixels[(y * f.width + x) as usize][c]);
                n += 1.0;
                mean += ((at(a) - at(b)).powi(2) - mean) / n;
            }
        }
    }
    mean
}

#[test]
fn rms_and_psnr_agree_with_their_definitions() {
    for (seed, most) in [(1, 1), (2, 3), (3, 40), (4, 255)] {
        let (a, b) = pair(seed, 37, 23, most);
        let got = compare(a.view(), b.view()).unwrap();
        let mse = mean_square(&a, &b);
        assert!((got.rms_lsb - mse.sqrt()).abs() < 1e-10, "{}", got.rms_lsb);
        let psnr = 10.0 * (255.0f64.powi(2) / mse).log10();
        assert!((got.psnr_db - psnr).abs() < 1e-10, "{}", got.psnr_db);
        let differing = a
            .pixels
            .iter()
            .zip(&b.pixels)
            .filter(|(p, q)| p != q)
            .count();
        assert_eq!(got.differing, differing as u64);
        assert_eq!(got.pixels, 37 * 23);
        assert_eq!(got.histogram.len(), usize::from(got.max_lsb) + 1);
        assert_eq!(got.histogram.iter().sum::<u64>(), 3 * 37 * 23);
        assert!(i16::from(got.max_lsb) <= most && !got.equal());
        assert!(got.flip_mean > 0.0 && got.flip_mean <= 1.0);
    }
}

#[test]
fn one_channel_of_one_pixel() {
    let a = frame(4, 3, vec![[10, 20, 30]; 12]);
    let mut pixels = a.pixels.clone();
    pixels[6] = [10, 24, 30];
    pixels[11] = [10, 20, 29];
    let b = frame(4, 3, pixels);
    let got = compare(a.view(), b.view()).unwrap();
    assert_eq!((got.differing, got.max_lsb), (2, 4));
    assert_eq!(got.histogram, [34, 1, 0, 0, 1]);
    assert_eq!(got.rms_lsb, (17.0f64 / 36.0).sqrt());
    let first = PixelMismatch {
        x: 2,
        y: 1,
        a: [10, 20, 30],
        b: [10, 24, 30],
    };
    assert_eq!(got.first_mismatch, Some(first));
}

#[test]
fn equal_frames() {
    let (a, _) = pair(5, 19, 7, 0);
    let got = compare(a.view(), a.view()).unwrap();
    assert!(got.equal());
    assert_eq!((got.max_lsb, got.rms_lsb, got.flip_mean), (0, 0.0, 0.0));
    assert_eq!(got.psnr_db, f64::INFINITY);
    assert_eq!(got.first_mismatch, None);
    let json = serde_json::to_string(&got).unwrap();
    assert_eq!(
        json,
        "{\"pixels\":133,\"differing\":0,\"max_lsb\":0,\"rms_lsb\":0.0,\"psnr_db\":null,\
         \"flip_mean\":0.0,\"first_mismatch\":null,\"histogram\":[399]}"
    );
}

/// The short cut for equal frames says what FLIP itself says.
#[test]
fn flip_of_equal_frames_is_zero_and_of_black_and_white_is_nearly_one() {
    let (a, _) = pair(6, 16, 16, 0);
    let image = || nv_flip::FlipImageRgb8::with_data(16, 16, a.pixels.as_flattened());
    let map = nv_flip::flip(image(), image(), FLIP_PIXELS_PER_DEGREE).to_vec();
    assert!(map.iter().all(|&e| e == 0.0));
    for side in [1, 64] {
        let count = (side * side) as usize;
        let black = frame(side, side, vec![[0; 3]; count]);
        let white = frame(side, side, vec![[255; 3]; count]);
        let got = compare(black.view(), white.view()).unwrap();
        assert!(
            got.flip_mean > 0.9 && got.flip_mean <= 1.0,
            "{}",
            got.flip_mean
        );
        assert_eq!((got.max_lsb, got.rms_lsb, got.psnr_db), (255, 255.0, 0.0));
    }
}

#[test]
fn difference_is_black_where_equal_and_visible_elsewhere() {
    let a = frame(3, 1, vec![[0, 100, 255], [7, 7, 7], [0, 0, 0]]);
    let b = frame(3, 1, vec![[1, 100, 253], [7, 7, 7], [11, 12, 255]]);
    let expected = vec![[79, 0, 95], [0, 0, 0], [239, 255, 255]];
    assert_eq!(difference_image(a.view(), b.view()).unwrap(), expected);
    assert_eq!(difference_image(b.view(), a.view()).unwrap(), expected);
}

#[test]
fn sizes_are_checked() {
    let a = frame(4, 3, vec![[0; 3]; 12]);
    let b = frame(3, 4, vec![[0; 3]; 12]);
    let text = "the images differ in size: 4x3 and 3x4";
    assert_eq!(compare(a.view(), b.view()).unwrap_err().to_string(), text);
    let difference = difference_image(a.view(), b.view());
    assert_eq!(difference.unwrap_err().to_string(), text);
    let refused = |w, h, n| {
        let pixels = vec![[0; 3]; n];
        Rgb8Ref::new(w, h, &pixels).unwrap_err().to_string()
    };
    let short = "a frame of 4x3 pixels cannot be made of 11";
    assert_eq!(refused(4, 3, 11), short);
    assert_eq!(refused(0, 3, 0), "a frame cannot be 0x3 pixels");
    let huge = "a frame cannot be 4294967295x4294967295 pixels";
    assert_eq!(refused(u32::MAX, u32::MAX, 1), huge);
}

#[test]
fn png_comes_back_and_replaces_what_was_there() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("frame.png");
    std::fs::write(&path, "old").unwrap();
    let (a, b) = pair(7, 33, 9, 20);
    for f in [&a, &b] {
        save_png(&path, f.view()).unwrap();
        assert_eq!(&load_png(&path).unwrap(), f);
    }
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
}

#[test]
fn png_of_every_kind_becomes_rgb8() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("kind.png");
    let grey8 = ImageBuffer::from_pixel(2, 1, Luma([200u8]));
    let grey_alpha = ImageBuffer::from_pixel(2, 1, LumaA([200u8, 3]));
    let rgba8 = ImageBuffer::from_pixel(2, 1, Rgba([1u8, 2, 3, 0]));
    // 16 bits to 8, rounded to nearest: v / 257.
    let grey16 = ImageBuffer::from_pixel(2, 1, Luma([0x80ffu16]));
    let rgb16 = ImageBuffer::from_pixel(2, 1, Rgb([128u16, 129, 65535]));
    let cases: [(DynamicImage, [u8; 3]); 5] = [
        (DynamicImage::ImageLuma8(grey8), [200; 3]),
        (DynamicImage::ImageLumaA8(grey_alpha), [200; 3]),
        (DynamicImage::ImageRgba8(rgba8), [1, 2, 3]),
        (DynamicImage::ImageLuma16(grey16), [128; 3]),
        (DynamicImage::ImageRgb16(rgb16), [0, 1, 255]),
    ];
    for (image, colour) in cases {
        image.save(&path).unwrap();
        assert_eq!(load_png(&path).unwrap(), frame(2, 1, vec![colour; 2]));
    }
}

#[test]
fn files_that_are_no_frames_are_refused_in_one_line() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    let text = |path: &Path| load_png(path).unwrap_err().to_string();
    let path = at("missing.png");
    assert_eq!(
        text(&path),
        format!("cannot read {path:?}: No such file or directory (os error 2)")
    );
    for (name, contents) in [("empty.png", ""), ("text.png", "hello\nworld, not a PNG")] {
        std::fs::write(at(name), contents).unwrap();
        assert_eq!(
            text(&at(name)),
            format!("{:?} is not a PNG image", at(name))
        );
    }
    let whole = at("whole.png");
    save_png(&whole, pair(8, 20, 20, 1).0.view()).unwrap();
    let bytes = std::fs::read(&whole).unwrap();
    let mut flipped = bytes.clone();
    flipped[40] ^= 0x10;
    let mut huge = bytes.clone();
    huge[16..24].fill(0x7f);
    for (name, contents) in [
        ("cut.png", &bytes[..bytes.len() / 2]),
        ("start.png", &bytes[..8]),
        ("flipped.png", &flipped),
        ("huge.png", &huge),
    ] {
        std::fs::write(at(name), contents).unwrap();
        let message = text(&at(name));
        let start = format!("{:?} is not a whole PNG image: ", at(name));
        assert!(message.starts_with(&start), "{message}");
        assert!(!message.contains('\n'), "{message}");
    }
}

#[test]
fn places_that_cannot_be_written_are_named() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("no/such/place.png");
    let f = frame(1, 1, vec![[0; 3]]);
    let error = save_png(&path, f.view()).unwrap_err().to_string();
    assert_eq!(
        error,
        format!("cannot write {path:?}: its directory does not exist")
    );
}

//! An adversary: looks for the input on which something is worst, by selection and mutation of numbers from 0 to 1.

// Every test file takes what it needs.
#![allow(dead_code)]

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use shadegate_gen::vectors::Pixel;
use shadegate_reference::raster::Point;

/// What it found.
#[derive(Debug)]
pub struct Found {
    /// The worst of the first generation, which is random.
    pub random: f64,
    /// The worst of all.
    pub worst: f64,
    /// Where that was, for messages.
    pub genome: Vec<f64>,
}

/// How hard it tries.
#[derive(Clone, Copy)]
pub struct Effort {
    pub genes: usize,
    pub generations: usize,
    pub population: usize,
}

/// Of every generation the three worst are kept; the others are theirs with some genes moved, set to an end, or new.
pub fn hunt(effort: Effort, seed: u64, mut score: impl FnMut(&[Vec<f64>]) -> Vec<f64>) -> Found {
    let mut r = StdRng::seed_from_u64(seed);
    let random = |r: &mut StdRng| (0..effort.genes).map(|_| r.random()).collect();
    let mut crowd: Vec<Vec<f64>> = (0..effort.population).map(|_| random(&mut r)).collect();
    let mut kept: Vec<(f64, Vec<f64>)> = vec![];
    let mut first = None;
    for _ in 0..effort.generations {
        let scores = score(&crowd);
        assert_eq!(scores.len(), crowd.len());
        kept.extend(scores.into_iter().zip(crowd));
        kept.sort_by(|a, b| b.0.total_cmp(&a.0));
        kept.truncate(3);
        first.get_or_insert(kept[0].0);
        crowd = (0..effort.population)
            .map(|i| mutant(&kept[i % kept.len()].1, &mut r))
            .collect();
    }
    let (worst, genome) = kept.swap_remove(0);
    Found {
        random: first.expect("a generation"),
        worst,
        genome,
    }
}

/// A corner by two genes: in the frame, or up to a part of it `beside` it on any side.
pub fn corner(genes: &[f64], beside: f64, size: (u32, u32)) -> Point {
    let at = |gene: f64, side: u32| {
        ((gene * (1.0 + 2.0 * beside) - beside) * f64::from(256 * side)) as i32
    };
    Point {
        x: at(genes[0], size.0),
        y: at(genes[1], size.1),
    }
}

/// By triangle the largest distance of a channel from the definition, in LSB beyond the rounding to a byte.
pub fn errors(
    triangles: usize,
    pixels: &[Pixel],
    definition: impl Fn(&Pixel) -> [f64; 3],
) -> Vec<f64> {
    let mut worst = vec![0.0f64; triangles];
    for p in pixels {
        for (got, want) in p.rgb.into_iter().zip(definition(p)) {
            let error = (f64::from(got) - want).abs() - 0.5;
            worst[p.triangle] = worst[p.triangle].max(error);
        }
    }
    worst
}

fn mutant(parent: &[f64], r: &mut StdRng) -> Vec<f64> {
    let often = [0.05, 0.2, 0.5][r.random_range(0..3)];
    let far = [1e-4, 0.01, 0.2][r.random_range(0..3)];
    let mut child = parent.to_vec();
    for gene in &mut child {
        if !r.random_bool(often) {
            continue;
        }
        *gene = match r.random_range(0..8) {
            0 => 0.0,
            1 => 1.0,
            2 => r.random(),
            _ => (*gene + r.random_range(-far..=far)).clamp(0.0, 1.0),
        };
    }
    child
}

/// It climbs to a corner that chance would not find.
#[test]
fn the_adversary_climbs() {
    let effort = Effort {
        genes: 12,
        generations: 120,
        population: 16,
    };
    let found = hunt(effort, 1, |crowd| {
        crowd.iter().map(|g| g.iter().product()).collect()
    });
    assert!(found.worst > 0.9 && found.random < 0.1, "{found:?}");
}

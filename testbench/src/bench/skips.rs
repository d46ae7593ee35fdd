//! What each skip saves: every scene with no skip at all, with each skip alone, with all but one, and with all.

use super::clock::{in_turns, median, Effort};
use super::sweep::{apart, one_thread};
use super::{BenchError, OnStep};
use serde::Serialize;
use shadegate_reference::{render, scene, with_threads};
use shadegate_reference::{Frame, Method, Prepared, RenderOptions, Scene, Skips};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What stands for all skips together.
pub const ALL: &str = "all";

/// A skip on a scene. Times are of the whole frame on one thread, from the scene in memory to the picture, because some
/// skips save work before anything is drawn.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SkipRow {
    /// Name of the scene.
    pub scene: String,
    /// Name of the method.
    pub method: &'static str,
    /// Name of the skip, or `all`.
    pub skip: &'static str,
    /// Triangles or pixels that it skipped when it alone was on, by the name they are counted under. Of `all` the sum.
    pub count: u64,
    /// Time without any skip.
    pub ns_without: f64,
    /// Time with this skip alone.
    pub ns_with: f64,
    /// How many times faster the frame is with this skip alone than without any.
    pub speedup_alone: f64,
    /// How many times faster the frame is with all skips than with all but this one; of `all` than without any.
    pub speedup_among_all: f64,
    /// Largest difference of a channel between the frames with this skip alone and without any.
    pub max_lsb: u8,
    /// Rounds of which the times are medians.
    pub rounds: usize,
}

/// The scenes of a folder, in order of their names.
///
/// # Errors
/// A folder that cannot be read or holds no scene, and the first scene that is wrong.
pub fn scenes_in(folder: &Path) -> Result<Vec<Scene>, BenchError> {
    let fault = |why: String| BenchError::Folder {
        folder: folder.display().to_string(),
        why,
    };
    let entries = std::fs::read_dir(folder).map_err(|e| fault(format!("cannot be read ({e})")))?;
    let mut files: Vec<PathBuf> = entries
        .filter_map(|e| Some(e.ok()?.path()))
        .filter(|p| p.is_file() && p.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    if files.is_empty() {
        return Err(fault(
            "holds no scene; expected files that end in .toml".to_owned(),
        ));
    }
    let scenes = files.iter().map(|f| scene::load(f));
    Ok(scenes.collect::<Result<_, _>>()?)
}

/// Only this skip.
fn only(name: &str) -> Skips {
    let others: Vec<&str> = Skips::NAMES
        .iter()
        .copied()
        .filter(|n| *n != name)
        .collect();
    without(&others.join(","))
}

/// All but this list of names that are known to exist.
fn without(list: &str) -> Skips {
    Skips::without(list).unwrap_or_default()
}

/// A frame from the scene in memory, how long it took, and what was skipped.
fn draw(scene: &Scene, method: Method, skips: Skips) -> Result<(Duration, Drawn), BenchError> {
    let options = RenderOptions {
        skips,
        ..one_thread()
    };
    let begin = Instant::now();
    let p = with_threads(options.threads, || Prepared::new(scene, None, &skips))?;
    let prepare = begin.elapsed();
    let (frame, stats) = render(&p, method, &options);
    // Not the making of a thread of its own, which no skip changes.
    let time = prepare + Duration::from_nanos(stats.setup_ns + stats.raster_ns);
    let skipped = stats.skipped.iter().map(|(n, c)| (*n, *c)).collect();
    Ok((time, Drawn { frame, skipped }))
}

struct Drawn {
    frame: Frame,
    skipped: Vec<(&'static str, u64)>,
}

/// Measures every skip on every scene; each step is one scene with one method. Without methods, each scene is drawn with
/// its own.
///
/// # Errors
/// When a scene cannot be prepared or frames cannot be compared.
pub fn skips(
    scenes: &[Scene],
    methods: &[Method],
    effort: Effort,
    on_step: &mut OnStep<'_>,
) -> Result<Vec<SkipRow>, BenchError> {
    let mut tasks: Vec<(&Scene, Method)> = Vec::new();
    for s in scenes {
        if methods.is_empty() {
            tasks.push((s, s.render.method));
        }
        tasks.extend(methods.iter().map(|m| (s, *m)));
    }
    let mut rows = Vec::new();
    for (i, (scene, method)) in tasks.iter().enumerate() {
        on_step(i, tasks.len(), &format!("{}, {method}", scene.name));
        rows.extend(task(scene, *method, effort)?);
    }
    Ok(rows)
}

fn task(scene: &Scene, method: Method, effort: Effort) -> Result<Vec<SkipRow>, BenchError> {
    let names = Skips::NAMES;
    // None, all, then each alone, then all but each.
    let mut jobs = vec![Skips::none(), Skips::all()];
    jobs.extend(names.iter().map(|n| only(n)));
    jobs.extend(names.iter().map(|n| without(n)));
    let mut first = Vec::with_capacity(jobs.len());
    for s in &jobs {
        first.push(draw(scene, method, *s)?);
    }
    let once = first.iter().map(|f| f.0).sum();
    let rounds = effort.rounds(once);
    let times: Vec<Vec<f64>> = in_turns(jobs.len(), rounds, |job| {
        draw(scene, method, jobs[job]).map(|d| d.0.as_nanos() as f64)
    })
    .into_iter()
    .map(|runs| runs.into_iter().collect::<Result<_, _>>())
    .collect::<Result<_, BenchError>>()?;
    let time = |job: usize| median(times[job].iter().copied());
    // Ratios are taken within rounds, where both sides met the same disturbance.
    let faster = |slow: usize, fast: usize| {
        let pairs = times[slow].iter().zip(&times[fast]);
        median(pairs.map(|(s, f)| s / f.max(1.0)))
    };
    let (none, all) = (0, 1);
    let mut rows = Vec::with_capacity(names.len() + 1);
    let mut row =
        |skip, job: usize, against: usize, fast: usize, count| -> Result<(), BenchError> {
            rows.push(SkipRow {
                scene: scene.name.clone(),
                method: method.name(),
                skip,
                count,
                ns_without: time(none),
                ns_with: time(job),
                speedup_alone: faster(none, job),
                speedup_among_all: faster(against, fast),
                max_lsb: apart(&first[none].1.frame, &first[job].1.frame)?.max_lsb,
                rounds,
            });
            Ok(())
        };
    for (k, name) in names.iter().enumerate() {
        let skipped = &first[2 + k].1.skipped;
        let count = skipped.iter().find(|s| s.0 == *name).map_or(0, |s| s.1);
        row(*name, 2 + k, 2 + names.len() + k, all, count)?;
    }
    let count = |s: &&(&str, u64)| names.contains(&s.0);
    let total = first[all].1.skipped.iter().filter(count).map(|s| s.1).sum();
    row(ALL, all, none, all, total)?;
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::scenes::Tessellation;

    #[test]
    fn one_skip_alone_and_all_but_one() {
        for name in Skips::NAMES {
            for other in Skips::NAMES {
                assert_eq!(only(name).is_on(other), name == other);
                assert_eq!(without(name).is_on(other), name != other);
            }
        }
    }

    #[test]
    fn a_sphere_has_back_faces_and_nothing_hidden() {
        let mut scene = Tessellation::ALL[0].scene(20).unwrap();
        (scene.image.width, scene.image.height) = (64, 48);
        let method = [Method::Gouraud];
        let rows = skips(&[scene], &method, Effort::QUICK, &mut |_, _, _| ()).unwrap();
        let names: Vec<&str> = rows.iter().map(|r| r.skip).collect();
        let expected: Vec<&str> = Skips::NAMES.iter().copied().chain([ALL]).collect();
        assert_eq!(names, expected);
        let of = |name: &str| rows.iter().find(|r| r.skip == name).unwrap();
        let back = of("back-face");
        assert!(
            back.count > 60 && back.count < 100 && back.max_lsb == 0,
            "{back:?}"
        );
        assert_eq!((of("frustum").count, of("outside").count), (0, 0));
        assert!(of(ALL).count >= back.count);
        assert!(rows
            .iter()
            .all(|r| r.speedup_alone > 0.0 && r.speedup_among_all > 0.0));
    }

    #[test]
    fn folders_without_scenes_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let e = scenes_in(folder.path()).unwrap_err().to_string();
        assert!(
            e.ends_with("' holds no scene; expected files that end in .toml"),
            "{e}"
        );
        let e = scenes_in(&folder.path().join("none"))
            .unwrap_err()
            .to_string();
        assert!(e.contains("/none' cannot be read (No such file"), "{e}");
    }
}

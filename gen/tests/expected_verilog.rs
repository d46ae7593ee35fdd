//! The emitted Verilog is the Verilog under `tests/expected/`, byte for byte, and emitting twice gives the same bytes.
//! After a deliberate change: `SHADEGATE_BLESS=1 cargo test --release -p shadegate-gen --test expected_verilog`.

use shadegate_gen::package::rtl;
use shadegate_gen::scene::TEXTURED;
use shadegate_hdl::bump::Bend;
use shadegate_hdl::light::Glint;
use shadegate_hdl::shade::device::Core;
use shadegate_hdl::shade::model::Order;
use shadegate_hdl::shade::span_core::SpanKind;
use std::path::Path;

#[test]
fn cores_of_triangles() {
    expected(&[
        Order::Linear,
        Order::Quadratic,
        Order::QuadraticDots,
        Order::Duff,
        Order::Glint(Glint::Kappa),
        Order::Glint(Glint::Spot),
    ]);
}

#[test]
fn textured_cores() {
    expected(&TEXTURED.map(|t| t.1));
}

#[test]
fn bump_cores() {
    expected(&[Order::Bump(Bend::Newton), Order::Bump(Bend::Reflection)]);
}

#[test]
fn core_with_a_set_up_engine() {
    expected(&[Order::QuadraticEngine]);
}

#[test]
fn span_cores() {
    let kinds = [
        SpanKind::Slerp,
        SpanKind::Chebyshev,
        SpanKind::Spherical(6),
        SpanKind::Blake,
    ];
    expected(&kinds.map(Order::Span));
}

fn expected(orders: &[Order]) {
    for order in orders.iter().copied() {
        let core = Core::for_frame(order, 320, 240).expect("in range");
        let files = rtl(&core).expect("emits").files;
        assert_eq!(
            files,
            rtl(&core).expect("emits").files,
            "emission is not deterministic"
        );
        let directory = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/expected")
            .join(core.name());
        if std::env::var_os("SHADEGATE_BLESS").is_some() {
            let _ = std::fs::remove_dir_all(&directory);
            std::fs::create_dir_all(&directory).expect("writable");
            for f in &files {
                std::fs::write(directory.join(f.file_name()), &f.text).expect("writable");
            }
        }
        for f in &files {
            let path = directory.join(f.file_name());
            let want = std::fs::read_to_string(&path)
                .unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            let line = want.lines().zip(f.text.lines()).position(|(a, b)| a != b);
            assert_eq!(
                want,
                f.text,
                "{}: first difference at line {:?}",
                path.display(),
                line.map(|l| l + 1)
            );
        }
        assert_eq!(
            std::fs::read_dir(&directory).expect("exists").count(),
            files.len(),
            "stray files in {directory:?}"
        );
    }
}

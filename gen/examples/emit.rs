use shadegate_hdl::shade::device::{Core, CoreSimulator};
use shadegate_hdl::shade::model::Order;
fn main() {
    let core = Core {
        order: Order::Quadratic,
        wide: false,
        pixels: 320 * 240,
    };
    let s = CoreSimulator::new(core).unwrap();
    let m = shadegate_gen::netlist::collect(s.design()).unwrap();
    let files = shadegate_gen::verilog::emit(&m, "Generated").unwrap();
    std::fs::create_dir_all("/tmp/v").unwrap();
    for f in files {
        if let Err(e) = shadegate_gen::verilog::check::check(&f.file_name(), &f.text) {
            println!("{e}");
        }
        std::fs::write(format!("/tmp/v/{}", f.file_name()), f.text).unwrap();
    }
}

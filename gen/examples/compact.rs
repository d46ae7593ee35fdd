//! Writes the Verilog of the compact quadratic unit, one file per module:
//! `cargo run --release -p shadegate-gen --example compact -- FOLDER [32|29]`.
//!
//! 32: colours Q11.20, as the quadratic core has them; 29: the word lengths of triangles of up to 512 pixels.

use shadegate_gen::compact::unit;
use shadegate_gen::write::write_file;
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().ok_or("expected a folder")?;
    let files = match arguments.next().as_deref() {
        None | Some("32") => unit::<32, 11, 20, 20>()?,
        Some("29") => unit::<29, 8, 20, 11>()?,
        Some(other) => {
            return Err(format!("unknown word length '{other}'; expected 32 or 29").into())
        }
    };
    for f in files {
        let path = Path::new(&folder).join(f.file_name());
        write_file(&path, f.text.as_bytes())?;
        println!("{}", path.display());
    }
    Ok(())
}

//! What a device is: capacities, packages, and the names its tools know it by.

use serde::Deserialize;
use std::fmt;

/// The constraint language of a device's vendor tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// User constraints file, of ISE.
    Ucf,
    /// Xilinx design constraints, of Vivado: Tcl commands.
    Xdc,
    /// Physical constraints file of the iCE40 tools.
    Pcf,
    /// Logical preference file of the ECP5 tools.
    Lpf,
}

impl Format {
    /// The file extension, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Format::Ucf => "ucf",
            Format::Xdc => "xdc",
            Format::Pcf => "pcf",
            Format::Lpf => "lpf",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Format::Ucf => "UCF",
            Format::Xdc => "XDC",
            Format::Pcf => "PCF",
            Format::Lpf => "LPF",
        })
    }
}

/// How the pins of a package are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PackageShape {
    /// Pins along four edges, numbered: `P1`, `P2`, ...
    Quad,
    /// Pins along four edges, by number alone: `1`, `2`, ...
    Numbered,
    /// A grid of balls, by row letter and column number: `A1`, `B7`, ...
    Grid,
}

/// One package a device is sold in.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Package {
    /// Name as the vendor tool writes it in a part, for instance `tqg144`.
    pub name: String,
    /// Pins or balls, power included.
    pub pins: u32,
    /// How pins are named.
    pub shape: PackageShape,
    /// Pins a design may use.
    pub user_io: u32,
    /// Rows and columns of a grid with a hole in it; a full grid has the root of `pins`.
    pub side: Option<u32>,
}

impl Package {
    /// Whether `pin` could be a pin of this package by its name (not whether it is a user pin).
    ///
    /// Row letters of a grid skip I, O, Q, S, X and Z, then go on with AA, AB, ...
    pub fn accepts_pin(&self, pin: &str) -> bool {
        let split = pin.find(|c: char| c.is_ascii_digit()).unwrap_or(pin.len());
        let (letters, digits) = pin.split_at(split);
        let plain = !digits.is_empty()
            && digits.bytes().all(|b| b.is_ascii_digit())
            && !digits.starts_with('0');
        let Some(number) = digits.parse::<u32>().ok().filter(|_| plain) else {
            return false;
        };
        match self.shape {
            PackageShape::Quad => letters == "P" && number <= self.pins,
            PackageShape::Numbered => letters.is_empty() && number <= self.pins,
            PackageShape::Grid => {
                let root = || (1..=self.pins).find(|s| s * s >= self.pins);
                let side = self.side.or_else(root).unwrap_or(0);
                row_index(letters).is_some_and(|row| row < side) && number <= side
            }
        }
    }
}

/// The row number of a ball's letters, from zero.
fn row_index(letters: &str) -> Option<u32> {
    const ROWS: &str = "ABCDEFGHJKLMNPRTUVWY";
    let index = |c: char| ROWS.find(c).and_then(|i| u32::try_from(i).ok());
    let mut chars = letters.chars();
    match (chars.next(), chars.next(), chars.next()) {
        (Some(c), None, None) => index(c),
        (Some('A'), Some(c), None) => index(c).map(|i| i + 20),
        _ => None,
    }
}

/// One FPGA.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Device {
    /// Short name, lower case: `xc7s50`.
    pub name: String,
    /// Family: `spartan-2e`, `spartan-3`, `spartan-3e`, `spartan-6`, `spartan-7`, `ice40-ultraplus` or `ecp5`.
    pub family: String,
    /// The word for `synth_xilinx -family` of Yosys; `ice40` and `ecp5` have commands of their own
    /// (see [`Device::yosys_synthesis`]).
    pub yosys_family: String,
    /// Package taken when no board says otherwise.
    pub package: String,
    /// Speed grade taken when no board says otherwise; the tools write it with a minus sign. 0 where there is none.
    pub speed: u8,
    /// Slices; logic blocks of an iCE40.
    pub slices: u32,
    /// Inputs of one look-up table: 4 or 6.
    pub lut_inputs: u8,
    /// Look-up tables.
    pub luts: u32,
    /// Flip-flops.
    pub flip_flops: u32,
    /// Block RAMs.
    pub block_rams: u32,
    /// Kilobits (1024 bits) in one block RAM, parity bits included.
    pub block_ram_kbit: u32,
    /// Hard multipliers or DSP slices.
    pub multipliers: u32,
    /// Operand widths of one multiplier, signed; zero where there is none.
    pub multiplier_bits: [u8; 2],
    /// Constraint language of the vendor tool.
    pub constraints: Format,
    /// Last vendor tool that knows the device, or the free tool whose constraint language is written.
    pub vendor_tool: String,
    /// Where the numbers come from.
    pub source: String,
    /// Packages it is sold in.
    pub packages: Vec<Package>,
}

impl Device {
    /// The package called `name`, if the device is sold in it.
    pub fn package_named(&self, name: &str) -> Option<&Package> {
        self.packages.iter().find(|p| p.name == name)
    }

    /// The whole part name in its vendor tool's spelling, in its default package and speed.
    pub fn part(&self) -> String {
        self.part_in(&self.package, self.speed)
    }

    /// The whole part name for a given package and speed: `xc6slx9-2-tqg144`, `xc7s50csga324-1`, `ICE40UP5K-SG48I`,
    /// `LFE5U-25F-6BG381C`.
    pub fn part_in(&self, package: &str, speed: u8) -> String {
        match self.constraints {
            Format::Pcf => format!("{}-{package}I", self.name).to_ascii_uppercase(),
            Format::Lpf => format!("{}-{speed}{package}C", self.name).to_ascii_uppercase(),
            Format::Ucf => format!("{}-{speed}-{package}", self.name),
            Format::Xdc => format!("{}{package}-{speed}", self.name),
        }
    }

    /// The Yosys command, with options, that maps a design to this device's family.
    pub fn yosys_synthesis(&self) -> String {
        match self.constraints {
            Format::Pcf => "synth_ice40 -device u".to_owned(),
            Format::Lpf => "synth_ecp5".to_owned(),
            Format::Ucf | Format::Xdc => format!("synth_xilinx -family {}", self.yosys_family),
        }
    }

    /// All block RAM, in kilobits.
    pub fn block_ram_total_kbit(&self) -> u32 {
        self.block_rams * self.block_ram_kbit
    }
}

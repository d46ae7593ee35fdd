//! What a board is: a device in a package, and the things soldered to its pins.

use serde::Deserialize;
use std::fmt;

/// What a pin of a board is wired to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ResourceKind {
    /// An oscillator.
    Clock,
    /// The button that the maker means for reset.
    Reset,
    /// A push button.
    Button,
    /// A slide or DIP switch.
    Switch,
    /// A light-emitting diode of one colour.
    Led,
    /// Serial data into the FPGA.
    UartRx,
    /// Serial data out of the FPGA.
    UartTx,
}

impl ResourceKind {
    /// Whether the board drives the pin, so that only an input port may be bound to it.
    pub fn drives_fpga(self) -> bool {
        !matches!(self, ResourceKind::Led | ResourceKind::UartTx)
    }

    /// `a button`, `an LED`.
    pub(crate) fn with_article(self) -> String {
        let article = if self == ResourceKind::Led { "an" } else { "a" };
        format!("{article} {self}")
    }
}

impl fmt::Display for ResourceKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ResourceKind::Clock => "clock",
            ResourceKind::Reset => "reset button",
            ResourceKind::Button => "button",
            ResourceKind::Switch => "switch",
            ResourceKind::Led => "LED",
            ResourceKind::UartRx => "serial input",
            ResourceKind::UartTx => "serial output",
        })
    }
}

/// A pull resistor to be switched on inside the device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Pull {
    /// To the supply.
    Up,
    /// To ground.
    Down,
}

/// The level at which a button counts as pressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ActiveLevel {
    /// Pressed is 1.
    High,
    /// Pressed is 0.
    Low,
}

/// One named thing on a board, on one pin.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Resource {
    /// Name used in bindings: `clk100`, `led0`, `btn1`.
    pub name: String,
    /// What it is.
    pub kind: ResourceKind,
    /// The device's pin.
    pub pin: String,
    /// The I/O standard the maker gives for the pin.
    pub io: String,
    /// Frequency of a clock, in hertz.
    pub hz: Option<u64>,
    /// Output drive strength in mA, where the maker's file gives one.
    pub drive: Option<u8>,
    /// Pull resistor the pin needs.
    pub pull: Option<Pull>,
    /// Level of a pressed button, where the source says it.
    pub active: Option<ActiveLevel>,
}

impl Resource {
    /// Period of a clock in nanoseconds; `None` for anything else.
    pub fn period_ns(&self) -> Option<f64> {
        self.hz.filter(|&hz| hz > 0).map(|hz| 1e9 / hz as f64)
    }

    /// Frequency and other remarks, for a comment beside the pin.
    pub(crate) fn remark(&self) -> String {
        let mut text = format!("{}: {}", self.name, self.kind);
        if let Some(hz) = self.hz {
            text.push_str(&format!(", {} MHz", hz as f64 / 1e6));
        }
        match self.active {
            Some(ActiveLevel::High) => text.push_str(", pressed = 1"),
            Some(ActiveLevel::Low) => text.push_str(", pressed = 0"),
            None => {}
        }
        text
    }
}

/// A reference voltage that a bank makes for itself.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InternalVref {
    /// I/O bank.
    pub bank: u32,
    /// Volts, as the tool wants them written.
    pub volts: String,
}

/// One board.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Board {
    /// Short name: `arty-s7-50`.
    pub name: String,
    /// Name as the maker writes it.
    pub title: String,
    /// Maker.
    pub maker: String,
    /// Name of its device.
    pub device: String,
    /// The device's package.
    pub package: String,
    /// The device's speed grade.
    pub speed: u8,
    /// The maker's constraint file that the pins were read in.
    pub source: String,
    /// Auxiliary supply in volts, where ISE must be told (Spartan-6).
    pub vccaux: Option<String>,
    /// Configuration bank supply in volts, where Vivado must be told.
    pub config_voltage: Option<String>,
    /// Banks that must make their own reference.
    #[serde(default)]
    pub internal_vref: Vec<InternalVref>,
    /// Pins that automatic placement must not use.
    #[serde(default)]
    pub prohibit: Vec<String>,
    /// What can be bound.
    pub resources: Vec<Resource>,
}

impl Board {
    /// The resource called `name`.
    pub fn resource(&self, name: &str) -> Option<&Resource> {
        self.resources.iter().find(|r| r.name == name)
    }

    /// The resources of one kind, in the order of the data file.
    pub fn of_kind(&self, kind: ResourceKind) -> impl Iterator<Item = &Resource> {
        self.resources.iter().filter(move |r| r.kind == kind)
    }
}

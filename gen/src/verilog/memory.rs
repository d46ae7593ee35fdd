//! Memories and tables in the shapes from which Yosys, Vivado and ISE infer block RAM and ROM.

use super::expression::literal;
use crate::netlist::{Format, Memory, Module};
use std::fmt::Write;

/// The text of a memory's module between its ports and `endmodule`, indented by two.
pub fn memory_body(m: &Module, memory: &Memory) -> String {
    let address_bits = |port: &str| m.signal(port).map_or(1, |s| s.format.width());
    let data = &memory.read.data;
    let signal = m
        .signal(data)
        .map_or(Format::Unsigned(memory.width), |s| s.format);
    if memory.write.is_none() {
        return table(memory, address_bits(&memory.read.address), signal);
    }
    let mut out = String::new();
    let last = memory.words - 1;
    // Bits that an address inside the memory needs.
    let top = (usize::BITS - last.leading_zeros()).max(1) as usize - 1;
    let bits = address_bits(&memory.read.address);
    let partial = bits < 64 && memory.words < 1 << bits;
    let write = memory.write.as_ref();
    let write_address = write.map_or("", |w| w.address.as_str());
    if partial {
        out += "// Addresses beyond the memory are not accessed.\n";
        let _ = writeln!(
            out,
            "wire read_inside = ({} < {bits}'d{});",
            memory.read.address, memory.words
        );
        let _ = writeln!(
            out,
            "wire write_inside = ({write_address} < {bits}'d{});\n",
            memory.words
        );
    }
    let range = Format::Unsigned(memory.width).range();
    let zeros = memory.initial.iter().all(|c| *c == 0);
    if zeros {
        out += "// All zeros at power-up. Block RAM powers up as zeros without being told; a loop over the memory would only cost\n\
                // the synthesiser minutes.\n";
    } else {
        out += "// The memory, with its words at power-up.\n";
    }
    let _ = writeln!(out, "reg {range}words [0:{last}];");
    if memory.read.clock.is_some() {
        let _ = writeln!(out, "initial {data} = {};\n", literal(0, signal));
    } else {
        out.push('\n');
    }
    if zeros {
        let zero = literal(0, Format::Unsigned(memory.width));
        let _ = writeln!(
            out,
            "`ifndef SYNTHESIS\ninteger i;\ninitial begin\n  for (i = 0; i < {}; i = i + 1) words[i] = {zero};\nend\n`endif\n",
            memory.words
        );
    } else {
        out += "initial begin\n";
        for i in 0..memory.words {
            let code = memory.initial.get(i).copied().unwrap_or(0);
            let _ = writeln!(
                out,
                "  words[{}] = {};",
                literal(i as u128, Format::Unsigned(top + 1)),
                literal(code, Format::Unsigned(memory.width))
            );
        }
        out += "end\n\n";
    }
    let guard = |enable: Option<&str>, inside: &str| -> String {
        let mut all: Vec<&str> = enable.into_iter().collect();
        if partial {
            all.push(inside);
        }
        if all.is_empty() {
            String::new()
        } else {
            format!("if ({}) ", all.join(" && "))
        }
    };
    let cut = |name: &str| format!("{name}[{top}:0]");
    let write_line = write.map(|w| {
        format!(
            "  {}words[{}] <= {};\n",
            guard(Some(&w.enable), "write_inside"),
            cut(&w.address),
            w.data
        )
    });
    let write_clock = write.map_or("", |w| w.clock.as_str());
    let mut read_line = format!(
        "  {}{data} <= words[{}];\n",
        guard(memory.read.enable.as_deref(), "read_inside"),
        cut(&memory.read.address)
    );
    if partial && memory.outside_is_zero {
        read_line += &format!(
            "  {}{data} <= {};\n",
            guard(memory.read.enable.as_deref(), "!read_inside"),
            literal(0, signal)
        );
    }
    match &memory.read.clock {
        Some(clock) if clock == write_clock => {
            let _ = write!(
                out,
                "always @(posedge {clock}) begin\n{}{read_line}end\n",
                write_line.unwrap_or_default()
            );
        }
        Some(clock) => {
            let _ = write!(
                out,
                "always @(posedge {write_clock}) begin\n{}end\n\n",
                write_line.unwrap_or_default()
            );
            let _ = write!(out, "always @(posedge {clock}) begin\n{read_line}end\n");
        }
        None => {
            let _ = write!(
                out,
                "always @(posedge {write_clock}) begin\n{}end\n\n",
                write_line.unwrap_or_default()
            );
            let _ = writeln!(out, "assign {data} = words[{}];", cut(&memory.read.address));
        }
    }
    indent(&out)
}

/// A table: a `case` of its words, clocked or not.
fn table(memory: &Memory, bits: usize, signal: Format) -> String {
    let read = &memory.read;
    let mut lines = vec![];
    let operator = if read.clock.is_some() { "<=" } else { "=" };
    // The commonest word is the default.
    let words: Vec<u128> = (0..memory.words)
        .map(|i| memory.initial.get(i).copied().unwrap_or(0))
        .collect();
    let full = bits < 64 && memory.words == 1 << bits;
    let default = if full { words[words.len() - 1] } else { 0 };
    for (i, code) in words.iter().enumerate().filter(|(_, c)| **c != default) {
        lines.push(format!(
            "    {}: {} {operator} {};",
            literal(i as u128, Format::Unsigned(bits)),
            read.data,
            literal(*code, signal)
        ));
    }
    lines.push(format!(
        "    default: {} {operator} {};",
        read.data,
        literal(default, signal)
    ));
    let (head, extra) = match (&read.clock, &read.enable) {
        (Some(clock), _) => (
            format!("always @(posedge {clock}) begin"),
            format!("initial {} = {};\n\n", read.data, literal(0, signal)),
        ),
        (None, _) => ("always @* begin".to_string(), String::new()),
    };
    let case = format!("  case ({})\n{}\n  endcase", read.address, lines.join("\n"));
    let case = match &read.enable {
        Some(enable) => format!("  if ({enable}) begin\n{}\n  end", indent(&case).trim_end()),
        None => case,
    };
    indent(&format!(
        "// {} words of {} bits.\n{extra}{head}\n{case}\nend\n",
        memory.words, memory.width
    ))
}

fn indent(text: &str) -> String {
    let line = |l: &str| {
        if l.is_empty() {
            "\n".to_string()
        } else {
            format!("  {l}\n")
        }
    };
    text.lines().map(line).collect()
}

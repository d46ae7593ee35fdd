//! One clock domain: the clock of every register and memory port is a name of one clock input of the top module.

use super::build::Builder;
use super::report::error;
use super::{Driver, SignalId};
use crate::netlist::{Format, NetlistError};

/// Follows every clock to the top module; all must meet in one input. Clock ports become names of it.
pub(super) fn resolve(b: &mut Builder<'_>) -> Result<(), NetlistError> {
    let name = b.flat.name.clone();
    let mut first: Option<(String, SignalId)> = None;
    for (owner, clock) in &b.clocked {
        let source = source(b, *clock).ok_or_else(|| {
            let clock = &b.flat.signals[clock.index()].name;
            let what = format!("clock {clock} of {owner} is no input of the top module");
            error(&name, "", what)
        })?;
        match &first {
            None => first = Some((owner.clone(), source)),
            Some((_, s)) if *s == source => {}
            Some((other, s)) => {
                let signal = |id: SignalId| b.flat.signals[id.index()].name.as_str();
                let what = format!(
                    "two clocks: {other} is clocked by {}, {owner} by {}",
                    signal(*s),
                    signal(source)
                );
                return Err(error(&name, "", what));
            }
        }
    }
    b.flat.clock = first.map(|f| f.1).or_else(|| {
        let mut ids = (0..b.flat.signals.len() as u32).map(SignalId);
        ids.find(|id| b.flat.signals[id.index()].driver == Driver::Clock)
    });
    Ok(())
}

/// The top module's clock input behind a clock; `None` when there is none.
fn source(b: &Builder<'_>, clock: SignalId) -> Option<SignalId> {
    let mut id = clock;
    // A ring of aliases ends after as many steps as there are signals.
    for _ in 0..=b.flat.signals.len() {
        let s = &b.flat.signals[id.index()];
        match s.driver {
            Driver::Clock => return Some(id),
            Driver::Alias(of) if s.format == Format::Clock => id = of,
            _ => return None,
        }
    }
    None
}

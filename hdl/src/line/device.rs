//! The ports that all cores share, for line cores.

use super::box_filter::BoxCore;
use super::bresenham::BresenhamCore;
use super::cone::ConeCore;
use crate::format::U;
use crate::shade::device::CorePorts;
use crate::shade::model::{CoreInputs, CoreOutputs};

macro_rules! line_ports {
    ($type:ident) => {
        impl<const A: usize> CorePorts for $type<A> {
            fn set(&mut self, i: &CoreInputs) {
                self.write.next = i.write;
                self.select.next = U::new(u64::from(i.select));
                self.data.next = U::new(i.data);
                self.start.next = i.start;
                self.clear.next = i.clear;
                self.ready.next = i.ready;
            }

            fn get(&self) -> CoreOutputs {
                let byte = |v: U<8>| v.get() as u8;
                CoreOutputs {
                    load_ready: self.load_ready.val(),
                    valid: self.valid.val(),
                    x: self.x.val().get() as u16,
                    y: self.y.val().get() as u16,
                    rgb: [
                        byte(self.red.val()),
                        byte(self.green.val()),
                        byte(self.blue.val()),
                    ],
                    depth: self.depth.val().get() as u16,
                    busy: self.busy.val(),
                    done: self.done.val(),
                }
            }
        }
    };
}
line_ports!(BresenhamCore);
line_ports!(BoxCore);
line_ports!(ConeCore);

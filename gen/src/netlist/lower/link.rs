//! `join` and `link` of interfaces, written as the assignments that they are.

use super::expression::Lowering;
use super::scope::{Driven, Meaning};
use super::statement::Lowered;
use crate::netlist::{Expression, NetlistError, Node, Statement};
use rust_hdl_core::ast::{VerilogLink, VerilogLinkDetails, VerilogStatement as S};

impl Lowering<'_> {
    pub(super) fn link(
        &self,
        link: &VerilogLink,
        s: &S,
        out: &mut Lowered,
        into: &mut Vec<Statement>,
    ) -> Result<(), NetlistError> {
        let side = |base: &str, d: &VerilogLinkDetails| {
            let field = d.my_name.trim_start_matches('.');
            if field.is_empty() {
                base.to_string()
            } else {
                format!("{base}${field}")
            }
        };
        let (to, from) = match link {
            VerilogLink::Forward(d) => (side(&d.other_name, d), side(&d.owner_name, d)),
            VerilogLink::Backward(d) => (side(&d.owner_name, d), side(&d.other_name, d)),
            VerilogLink::Bidirectional(_) => {
                return Err(self.refuse("wires that are driven from both ends are not supported", s))
            }
        };
        let Driven::Target(target, format, _) = self.scope.driven(&to)? else {
            return Err(self.refuse("the clock of a register is set with dff_setup", s));
        };
        let Meaning::Value(name, own, _) = self.scope.read(&from)? else {
            return Err(self.refuse(format!("{from} is not a signal"), s));
        };
        if own != format {
            return Err(self.refuse(format!("a {own} is joined to a {format}"), s));
        }
        if !out.linked.insert(target.clone()) {
            return Err(self.refuse(format!("{} is joined twice", to.replace('$', ".")), s));
        }
        let value = Expression::new(own, Node::Read(name));
        into.push(Statement::Assign {
            target,
            bits: None,
            value,
        });
        Ok(())
    }
}

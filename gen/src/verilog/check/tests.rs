//! Each known way in which emitted Verilog can mean something else than its description, as text: all are refused.

use super::check;

fn module(body: &str) -> String {
    format!(
        "`default_nettype none\nmodule m (\n  input  wire clock,\n  input  wire [7:0] a,\n  input  wire [7:0] b,\n  \
         input  wire signed [7:0] sa,\n  input  wire signed [7:0] sb,\n  output wire [7:0] o,\n  output wire flag\n);\n{body}\nendmodule\n"
    )
}

fn refused(body: &str, why: &str) {
    let e = check("m.v", &module(body)).expect_err(body);
    assert_eq!(e.to_string(), format!("m.v:11: {why}: {}", body.trim()));
}

#[test]
fn safe_shapes_pass() {
    for body in [
        "  assign o = a + b;",
        "  assign flag = (a + b) == 8'd0;",
        "  assign flag = sa < sb;",
        "  assign o = {4'd0, a[7:4]};",
        "  assign o = {{4{a[7]}}, a[7:4]};",
        "  assign flag = (a == b) && !(|a);",
        "  assign flag = sa <= sb;",
        "  assign o = (a << b) ^ (-b);",
        "  wire [15:0] p = {8'd0, a} * {8'd0, b};",
        "  wire [2:0] i = a[2:0];\n  assign flag = b[i] && (^a);",
        "  case (a)\n    8'd1: begin\n      o[3:0] = b[7:4];\n    end\n    default: o = b;\n  endcase",
    ] {
        check("m.v", &module(body)).expect(body);
    }
}

#[test]
fn a_carry_kept_by_a_wider_context() {
    refused("  assign o = {a + b, 1'b0};", "9 bits are assigned to 8");
    refused("  wire [8:0] w = a + b;", "8 bits are assigned to 9");
}

#[test]
fn literals_that_widen() {
    refused("  assign flag = (a - b) > 5;", "a literal without a width");
    refused(
        "  assign flag = (a - b) > 32'h5;",
        "`>` joins 8 and 32 bits",
    );
}

#[test]
fn precedence_of_comparison_and_bit_operators() {
    refused(
        "  assign flag = a & b == a;",
        "operators are not fully parenthesised",
    );
}

#[test]
fn unsigned_literals_and_slices_make_a_comparison_unsigned() {
    refused(
        "  assign flag = sa < 8'd0;",
        "`<` joins a signed and an unsigned operand",
    );
    refused(
        "  assign flag = sa < sb[7:0];",
        "`<` joins a signed and an unsigned operand",
    );
}

#[test]
fn shifts_products_and_casts() {
    refused("  assign o = a << sa;", "`<<` by a signed count");
    refused(
        "  assign o = a >>> 2'd2;",
        "operator `>>>` is not in the safe subset",
    );
    refused("  wire [15:0] p = a * b;", "8 bits are assigned to 16");
    refused("  wire [8:0] w = a << 1'd1;", "8 bits are assigned to 9");
    refused(
        "  assign o = $signed(sa);",
        "`$` in an identifier or a system function",
    );
}

#[test]
fn choices() {
    refused(
        "  case (a + b == o)",
        "operators are not fully parenthesised",
    );
    refused("  12: o = a;", "a literal without a width");
    refused(
        "  assign flag = a[b];",
        "a position that can leave the 8 bits",
    );
}

#[test]
fn slices_of_expressions_and_beyond_the_word() {
    refused(
        "  assign o = (a + b)[3:0];",
        "operator `[` is not in the safe subset",
    );
    refused("  assign flag = a[8];", "bits 8:8 of `a`, which has 8 bits");
}

#[test]
fn names_that_do_not_exist_and_names_with_dollars() {
    refused("  assign o = FOO;", "`FOO` is not declared");
    refused(
        "  assign o = top$a;",
        "`$` in an identifier or a system function",
    );
}

#[test]
fn a_word_as_a_condition() {
    refused("  if (a) begin", "a condition of 8 bits");
}

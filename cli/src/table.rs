//! Tables in columns, for people.

use anstyle::Style;

/// Rows of cells under headings.
pub struct Table {
    headings: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub fn new(headings: &[&'static str]) -> Self {
        Self {
            headings: headings.to_vec(),
            rows: Vec::new(),
        }
    }

    /// Adds a row, one cell per heading.
    pub fn row<const N: usize>(&mut self, cells: [String; N]) {
        self.rows.push(cells.to_vec());
    }

    /// The table as lines. Columns of numbers are set to the right.
    pub fn text(&self) -> String {
        let width = |column: usize| {
            let cells = self.rows.iter().map(|r| r[column].chars().count());
            cells.chain([self.headings[column].chars().count()]).max()
        };
        let widths: Vec<usize> = (0..self.headings.len())
            .map(|c| width(c).unwrap_or(0))
            .collect();
        let right: Vec<bool> = (0..self.headings.len())
            .map(|c| {
                let number = |s: &String| s == "-" || s.parse::<f64>().is_ok();
                !self.rows.is_empty() && self.rows.iter().all(|r| number(&r[c]))
            })
            .collect();
        let line = |cells: &[&str]| {
            let mut out = String::new();
            for (c, cell) in cells.iter().enumerate() {
                let gap = " ".repeat(widths[c] - cell.chars().count());
                if right[c] {
                    out += &gap;
                    out += cell;
                } else {
                    out += cell;
                    out += &gap;
                }
                out += "  ";
            }
            out.truncate(out.trim_end().len());
            out
        };
        let bold = Style::new().bold();
        let mut out = format!("{bold}{}{bold:#}\n", line(&self.headings));
        for row in &self.rows {
            let cells: Vec<&str> = row.iter().map(String::as_str).collect();
            out += &line(&cells);
            out.push('\n');
        }
        out
    }

    /// The first column alone, a line for each name.
    pub fn names(&self) -> String {
        let mut names: Vec<&String> = self.rows.iter().filter_map(|r| r.first()).collect();
        names.dedup();
        names.iter().map(|n| format!("{n}\n")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up() {
        let mut t = Table::new(&["name", "luts"]);
        t.row(["é".into(), "7".into()]);
        t.row(["longer".into(), "1200".into()]);
        let plain = anstream::adapter::strip_str(&t.text()).to_string();
        assert_eq!(plain, "name    luts\né          7\nlonger  1200\n");
        assert_eq!(t.names(), "é\nlonger\n");
    }
}

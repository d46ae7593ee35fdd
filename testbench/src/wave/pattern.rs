//! Patterns of hierarchical names: `*` is any text, `?` any one character; a name without either means that signal or
//! everything below that instance.

/// Whether some pattern fits a name; without patterns every name is chosen.
pub fn chosen(name: &str, patterns: &[String]) -> bool {
    patterns.is_empty() || patterns.iter().any(|p| fits(name, p))
}

fn fits(name: &str, pattern: &str) -> bool {
    if !pattern.contains(['*', '?']) {
        let rest = name.strip_prefix(pattern);
        return rest.is_some_and(|r| r.is_empty() || r.starts_with('.'));
    }
    let (name, pattern): (Vec<char>, Vec<char>) =
        (name.chars().collect(), pattern.chars().collect());
    let (mut n, mut p) = (0, 0);
    // Where the last `*` was, and the text that it has taken so far.
    let mut star: Option<(usize, usize)> = None;
    while n < name.len() {
        match (pattern.get(p), star) {
            (Some('*'), _) => {
                star = Some((p, n));
                p += 1;
            }
            (Some(c), _) if *c == '?' || *c == name[n] => {
                n += 1;
                p += 1;
            }
            (_, Some((at, taken))) => {
                star = Some((at, taken + 1));
                (p, n) = (at + 1, taken + 1);
            }
            (_, None) => return false,
        }
    }
    pattern[p..].iter().all(|c| *c == '*')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_choose_names() {
        for (name, pattern, want) in [
            ("shell.walk.column", "shell", true),
            ("shell.walk.column", "shell.walk.column", true),
            ("shell_2.x", "shell", false),
            ("shell.walk.column", "walk", false),
            ("shell.walk.column", "*column", true),
            ("shell.walk.column", "*.col", false),
            ("shell.walk.column", "s*.w*.c*n", true),
            ("red", "r?d", true),
            ("reed", "r?d", false),
            ("red", "*", true),
            ("aab", "*ab", true),
        ] {
            assert_eq!(fits(name, pattern), want, "{name} {pattern}");
        }
        assert!(chosen("anything", &[]));
    }
}

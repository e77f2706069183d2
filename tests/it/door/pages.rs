//! Every command that the README or `docs/commands.md` shows is run, and prints what is shown.

use crate::house::files;
use crate::program::{Scratch, said, shell};

const PAGES: [(&str, &str); 3] = [
    ("README.md", include_str!("../../../README.md")),
    ("docs/commands.md", include_str!("../../../docs/commands.md")),
    ("docs/surveys.md", include_str!("../../../docs/surveys.md")),
];

/// A command and what is shown of its output.
struct Example<'a> {
    command: &'a str,
    shown: Vec<&'a str>,
}

/// The commands of the blocks marked `console`, in their order.
fn examples(page: &str) -> Vec<Example<'_>> {
    let mut found: Vec<Example<'_>> = Vec::new();
    let mut inside = false;
    for line in page.lines() {
        match (inside, line.strip_prefix("$ ")) {
            (_, None) if line.starts_with("```") => inside = line == "```console",
            (true, Some(command)) => found.push(Example { command, shown: Vec::new() }),
            (true, None) => found.last_mut().expect("a command first").shown.push(line),
            (false, _) => {}
        }
    }
    found
}

/// Whether a line is as shown; `…` at its end stands for its rest.
fn is_as_shown(line: &str, shown: &str) -> bool {
    line == shown || shown.strip_suffix('…').is_some_and(|begin| line.starts_with(begin))
}

/// The first line shown that is missing. `…` alone stands for any lines.
fn missing<'a>(printed: &str, shown: &[&'a str]) -> Option<&'a str> {
    // A command is followed by an empty line before the next.
    let end = shown.iter().rposition(|line| !line.is_empty()).map_or(0, |last| last + 1);
    let mut lines = printed.lines().peekable();
    let mut skips = false;
    for &line in &shown[..end] {
        if line == "…" {
            skips = true;
            continue;
        }
        let found = match skips {
            true => lines.any(|printed| is_as_shown(printed, line)),
            false => lines.next().is_some_and(|printed| is_as_shown(printed, line)),
        };
        if !found {
            return Some(line);
        }
        skips = false;
    }
    match lines.peek() {
        Some(_) if !skips => Some("(the end)"),
        _ => None,
    }
}

#[test]
fn what_is_missing_is_seen() {
    let shown = |lines: &'static str| missing("a b\nc d\ne\n", &lines.lines().collect::<Vec<_>>());
    assert_eq!(shown("a b\nc d\ne\n\n"), None);
    assert_eq!(shown("a …\n…\ne"), None);
    assert_eq!(shown("…\nc d\n…"), None);
    assert_eq!(shown("a b\ne"), Some("e"));
    assert_eq!(shown("…\nx"), Some("x"));
    assert_eq!(shown("a b\nc d"), Some("(the end)"));
    assert_eq!(shown(""), Some("(the end)"));
}

/// In an empty folder; a file that is shown by `cat` is written first.
fn run(page: &str, name: &str) -> usize {
    let (scratch, all) = (Scratch::new(), examples(page));
    for Example { command, shown } in &all {
        if let Some(file) = command.strip_prefix("cat ") {
            scratch.write(file, format!("{}\n", shown.join("\n").trim_end()));
        }
        let (code, printed, said) = said(&shell(command, scratch.folder()));
        assert!(code == Some(0) && said.is_empty(), "{name}: {command}: {said}");
        if let Some(line) = missing(&printed, shown) {
            panic!("{name}: {command} does not print\n{line}\nbut\n{printed}");
        }
    }
    all.len()
}

#[test]
fn every_command_shown_prints_what_is_shown() {
    let [readme, commands, surveys] = PAGES.map(|(name, page)| run(page, name));
    assert!(readme >= 3 && commands >= 10 && surveys >= 3, "{readme} {commands} {surveys}");
}

/// No command is shown outside of a block that is run.
#[test]
fn no_command_hides() {
    for (name, page) in PAGES {
        let shown = page.lines().filter(|line| line.trim_start().starts_with("$ ")).count();
        assert_eq!(shown, examples(page).len(), "{name}");
    }
}

/// A page has a row for every command, and no link leads nowhere.
#[test]
fn the_pages_are_complete() {
    for name in super::manual::commands() {
        let row = format!("| `couplet {name}` |");
        assert!(PAGES[1].1.contains(&row), "docs/commands.md lacks {row}");
    }
}

#[test]
fn no_link_of_a_page_leads_nowhere() {
    for page in [files("", "md"), files("docs", "md")].concat() {
        let text = std::fs::read_to_string(&page).unwrap();
        for link in text.split("](").skip(1).map(|rest| rest.split(')').next().unwrap()) {
            let file = link.split('#').next().unwrap();
            let local = !link.starts_with("http") && !file.is_empty() && !link.contains("::");
            let there = page.parent().unwrap().join(file).exists();
            assert!(!local || there, "{}: {link}", page.display());
        }
    }
}

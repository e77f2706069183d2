//! The page of columns has every one that is written.

use std::collections::BTreeSet;

const PAGE: &str = include_str!("../../../docs/columns.md");

/// The names of a page, between backticks.
fn named() -> BTreeSet<&'static str> {
    PAGE.split('`').skip(1).step_by(2).collect()
}

/// The names in the header of what a command makes of a table.
fn header(arguments: &str, table: &str) -> Vec<String> {
    crate::program::header(arguments, table).split(',').map(str::to_owned).collect()
}

#[test]
fn every_column_is_on_the_page() {
    let named = named();
    let is_named = |name: &str| {
        let of_number = |start: &str| {
            let rest = name.strip_prefix(start).filter(|rest| !rest.is_empty());
            rest.is_some_and(|rest| named.contains(format!("NAME{rest}").as_str()))
        };
        let numbers = named.iter().filter(|number| name.starts_with(**number));
        named.contains(name) || numbers.into_iter().any(|number| of_number(number))
    };
    assert!(is_named("thrust_double") && !is_named("thrust_shade") && !is_named("colour"));
    let states = "alpha,mu,eta\n1,1,1\n";
    let results = "alpha,mu,given_thickness,least_thickness,thrust,mode\n1,1,1,1,1,rrr\n";
    for name in [
        header("states --columns all", "alpha,mu\n1,1\n"),
        header("states --columns all", states),
        header("states --ranges", "span,rise,mu,eta\n1m,1m,1,1m\n"),
        header("judge - --format csv", results),
        header("sample --count 0", ""),
        header("map --curve limit --format csv", ""),
        header("map point limit --at 1.5 --format csv", ""),
        header("complementarity --alpha 2.21 --branch --format csv", ""),
        header("map difference --tolerance 1e-2 --format csv", ""),
    ]
    .concat()
    {
        assert!(is_named(&name), "{name} is not on the page");
    }
}

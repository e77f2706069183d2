//! Texts with holes.

/// The template with each hole `<<name>>` filled.
pub(super) fn fill(template: &str, values: &[(&str, String)]) -> String {
    values.iter().fold(template.to_owned(), |text, (name, value)| {
        text.replace(&format!("<<{name}>>"), value)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_hole_of_a_name_is_filled() {
        let values = [("x", "1".to_owned()), ("y", "2".to_owned())];
        assert_eq!(fill("<<x>> <<y>> <<x>>", &values), "1 2 1");
    }
}

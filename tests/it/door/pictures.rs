//! The pictures of the front page and of the manual are those that the commands draw. The last digits of a place on the
//! page are the machine's, so that only what stands between the numbers is compared.

use crate::house::read;
use crate::program::{Scratch, command};

#[test]
fn the_pictures_are_those_of_the_commands() {
    let scratch = Scratch::new();
    let shapes = |text: &str| -> String {
        text.chars().filter(|c| !c.is_ascii_digit() && !".-e".contains(*c)).collect()
    };
    let [page, surveys] = ["README.md", "docs/surveys.md"].map(read);
    let arches = "draw --span 8m±3cm --rise 4m±3cm --thickness 47cm..49cm --friction 0.55..0.75 -o arches.svg";
    let survey = "map --plane opening-friction --mark 87deg..93deg,0.55..0.75 -o survey.svg";
    for (name, line, page) in [
        ("map.svg", "map -o map.svg", &page),
        ("arch.svg", "draw --half-opening 80deg --friction 0.35 -o arch.svg", &page),
        ("arches.svg", arches, &surveys),
        ("survey.svg", survey, &surveys),
    ] {
        let drawn = command(line).current_dir(scratch.folder()).status().unwrap();
        assert!(drawn.success(), "{name}");
        let drawn = scratch.read(name);
        let kept = read(&format!("docs/pictures/{name}"));
        assert_eq!(shapes(&drawn), shapes(&kept), "{name}: make pictures");
        assert!(page.contains(&format!("pictures/{name}")) && kept.len() > 9_000);
    }
}

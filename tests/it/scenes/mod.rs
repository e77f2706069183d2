//! Scenes as a user meets them: every fault with its place, nothing computed that is not needed, nothing
//! written that is not whole, nothing computed again that is complete.

mod cost;
mod drawing;
mod examples;
mod faults;
mod folder;
mod map;
mod outputs;
mod ranges;
mod reading;
mod resume;
mod same;

use crate::program::{Scratch, Words, ended, rows};
use couplet::scene::{Fault, read};

const HEAD: &str = "schema = \"couplet.scene/1\"\n";

/// The path of a new scene, of which this comes after the first line.
fn scene_in(scratch: &Scratch, text: &str) -> String {
    scratch.write("scene.toml", format!("{HEAD}{text}"));
    scratch.path("scene.toml")
}

/// Runs a scene of this text into `out`, where it does all that it is asked; what it says on standard error.
fn run(scratch: &Scratch, text: &str, options: &str) -> String {
    let (scene, out) = (scene_in(scratch, text), scratch.path("out"));
    let all = [&["run", &scene, "--output", &out][..], &options.words()].concat();
    ended(0, all, "").1
}

/// The words of the command that the caption of a picture names.
fn caption(picture: &str) -> &str {
    picture.split("Command: couplet ").nth(1).unwrap().split('<').next().unwrap()
}

/// A picture but for the command in its caption.
fn body(svg: &str) -> String {
    let drawn = svg.split("<g id=\"caption\">").next().unwrap();
    drawn.lines().skip(3).collect::<Vec<_>>().join("\n")
}

fn place(fault: &Fault) -> String {
    format!("{}:{}: {}", fault.place.line, fault.place.column, fault.message)
}

/// The faults of a scene after its first line, as `line:column: message`.
fn faults(text: &str) -> Vec<String> {
    read(&format!("{HEAD}{text}")).err().unwrap_or_default().iter().map(place).collect()
}

/// A column of a CSV file.
fn column(csv: &str, name: &str) -> Vec<String> {
    rows(csv).into_iter().map(|mut row| row.remove(name).unwrap()).collect()
}

const ONE_THICKNESS: &str =
    "[[arches]]\nhalf_opening = \"pi/2\"\nfriction = \"inf\"\nquantities = \"thickness\"\n";

const THREE: &str = "digits = 20\n\
    [[constants]]\nlandmarks = \"T\"\noutput = \"constants.json\"\n\
    [[arches]]\nhalf_opening = { from = 0.5, to = 2.5, steps = 9 }\nfriction = [0.5, 1.5]\n\
    output = \"deep/arches.csv\"\n\
    [[claims]]\nprove = [\"eq-7\", \"eq-16\"]\nshow = true\noutput = \"claims.json\"\n\
    [[arches]]\nhalf_opening = 1\nfriction = 1\n";

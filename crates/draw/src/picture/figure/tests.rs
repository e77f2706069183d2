use super::*;
#[cfg(feature = "plots")]
use crate::picture::PaperLength;
use crate::picture::Print;
use crate::picture::reading::texts;

fn axis(label: &str, scale: Scale) -> Axis {
    Axis { label: label.into(), scale }
}

fn line(label: &str, kind: Kind, points: impl IntoIterator<Item = (f64, f64)>) -> PlottedLine {
    PlottedLine { label: label.into(), points: points.into_iter().collect(), kind }
}

/// Numbers that look measured, from 0 to 1.
fn noise(seed: usize) -> f64 {
    (seed as f64 * 12.9898).sin().mul_add(43758.5453, 0.0).rem_euclid(1.0)
}

/// Error against time: six methods on six problems.
fn errors() -> Figure {
    let methods = [
        "Newton, f64",
        "Newton, MPFR",
        "double-double",
        "printed closed form",
        "Krawczyk",
        "astro-float",
    ];
    let panel = |p: usize, title: &str| {
        let lines = methods.iter().enumerate().map(|(m, name)| {
            let count = [3, 9, 4, 7, 9, 8][m];
            let points = (0..count).map(|k| {
                let seed = 97 * p + 13 * m + k;
                let time = -5.5 + 0.35 * m as f64 + 0.42 * k as f64 + 0.12 * noise(seed);
                let floor = [-15.6, -300.0, -31.0, -120.0 + 20.0 * p as f64, -300.0, -300.0][m];
                let error = (-4.0 * 1.62f64.powi(k as i32)).max(floor) - 2.0 * noise(seed + 5);
                (10f64.powf(time), error)
            });
            line(name, Kind::Measured, points.collect::<Vec<_>>())
        });
        Panel {
            title: title.into(),
            x: axis("CPU time (s)", Scale::Log10),
            y: axis("relative error", Scale::Exponent),
            lines: lines.collect(),
        }
    };
    let titles = [
        "Triple point T, Milankovitch",
        "Border point S, Heyman",
        "Least thickness at α = 140°",
        "Cubic in A at β = 0.95",
        "End of rotation B",
        "Purely rotational state, η ≈ 0.1075",
    ];
    Figure {
        title: "Error against run time (the truth is a certified enclosure at a higher precision)"
            .into(),
        panels: titles.iter().enumerate().map(|(p, title)| panel(p, title)).collect(),
        columns: 3,
    }
}

/// Digits lost against distance, eight panels of four lines and a reference.
fn losses() -> Figure {
    let panel = |p: usize| {
        let lost = |m: usize, k: i32| {
            let steep = [0.5, 1.0, 1.5, 2.0][m] * if p.is_multiple_of(2) { 1.0 } else { 0.6 };
            steep * f64::from(k) * 0.98 + 0.8 * noise(31 * p + 7 * m + k as usize)
        };
        let mut lines: Vec<PlottedLine> =
            ["as printed", "real form", "Newton on the system", "Newton on the cubic"]
                .iter()
                .enumerate()
                .map(|(m, name)| {
                    let all = (1..=60).step_by(if m == 1 { 3 } else { 1 });
                    let known = all.filter(|k| !(p == 3 && m == 2 && (20..30).contains(k)));
                    let gap = |k: i32| {
                        if p == 5 && (30..34).contains(&k) { f64::NAN } else { lost(m, k) }
                    };
                    line(
                        name,
                        Kind::Measured,
                        known.map(|k| (-f64::from(k), gap(k))).collect::<Vec<_>>(),
                    )
                })
                .collect();
        let bound = (1..=60).map(|k| (-f64::from(k), 0.5 * f64::from(k)));
        lines.push(line("square root", Kind::Reference, bound));
        Panel {
            title: format!("Joint {} of the {} branch", p / 2 + 1, ["upper", "lower"][p % 2]),
            x: axis("distance to the double root (rad)", Scale::Approach),
            y: axis("decimal digits lost", Scale::Linear),
            lines,
        }
    };
    Figure {
        title: "Digits lost near a double root".into(),
        panels: (0..8).map(panel).collect(),
        columns: 2,
    }
}

/// A performance profile.
fn profile() -> Figure {
    let names =
        ["Newton, MPFR", "Newton, astro-float", "Krawczyk", "printed closed form", "secant"];
    let lines = names.iter().enumerate().map(|(m, name)| {
        let steps = (0..30).map(|k| {
            let share = [1.0, 1.0, 1.0, 0.62, 0.84][m];
            let grown = share * (1.0 - (-f64::from(k) / [2.0, 6.0, 9.0, 3.0, 7.0][m]).exp());
            let solved = (grown.mul_add(40.0, 3.0 * noise(m))).round().min(40.0 * share) / 40.0;
            (10f64.powf(0.1 * f64::from(k)), solved)
        });
        line(name, Kind::Steps, steps.collect::<Vec<_>>())
    });
    let panel = Panel {
        title: "100 digits, 40 problems".into(),
        x: axis("time relative to the fastest", Scale::Log10),
        y: axis("share of problems solved", Scale::Linear),
        lines: lines.collect(),
    };
    Figure { title: "Performance profile".into(), panels: vec![panel], columns: 1 }
}

/// Figure with things that there should not be, and yet may be.
fn odd() -> Figure {
    let nan = f64::NAN;
    let cases: [&[(f64, f64)]; 8] = [
        &[],
        &[(nan, nan)],
        &[(1.0, 1.0)],
        &[(0.5, -1e-7); 5],
        &[(1.0, 2.0), (2.0, nan), (3.0, f64::INFINITY), (4.0, 5.0), (5.0, 1.0)],
        &[(1e-300, 1e300), (1e-308, -1e299)],
        &[(1.0, 1e9), (2.0, 1.000001e9)],
        &[(0.0, 0.0), (-1.0, 3e-12)],
    ];
    let panel = |points: &&[(f64, f64)], scale: Scale, kind: Kind| Panel {
        title: "A title so long that it takes several lines, since it says in full what is shown"
            .into(),
        x: axis("x < y & \"z\" (1)", scale),
        y: axis("an ordinate with a long description of what it is (mm)", Scale::Linear),
        lines: ["one", "another", "a third"].map(|name| line(name, kind, points.to_vec())).into(),
    };
    let mut panels = Vec::new();
    for scale in [Scale::Linear, Scale::Log10, Scale::Exponent] {
        for kind in [Kind::Measured, Kind::Reference, Kind::Steps] {
            panels.extend(cases.iter().map(|points| panel(points, scale, kind)));
        }
    }
    let many =
        (0..30).map(|k| line(&format!("line {k}"), Kind::Measured, [(0.0, 0.0), (1.0, 1.0)]));
    panels.push(Panel { lines: many.collect(), ..panel(&cases[0], Scale::Linear, Kind::Steps) });
    panels.push(Panel { lines: Vec::new(), ..panel(&cases[0], Scale::Linear, Kind::Steps) });
    Figure { title: "<odd> & 'odd'".into(), panels, columns: 5 }
}

fn svg(figure: &Figure) -> String {
    figure.svg(&Print::default()).unwrap()
}

fn all() -> [Figure; 5] {
    let empty = Figure { title: String::new(), panels: Vec::new(), columns: 0 };
    [errors(), losses(), profile(), odd(), empty]
}

#[test]
fn documents_are_well_formed_and_finite() {
    for figure in all() {
        let svg = svg(&figure);
        assert!(texts(&svg).is_some());
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}

#[test]
fn a_figure_is_always_drawn_alike() {
    for figure in all() {
        assert_eq!(svg(&figure), svg(&figure.clone()));
    }
}

#[test]
fn everything_is_labelled() {
    for figure in all() {
        let svg = svg(&figure);
        let shown = texts(&svg).unwrap().join(" ");
        let escaped = |text: &str| {
            let marks = [("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("\"", "&quot;")];
            marks.iter().fold(text.to_owned(), |text, (mark, name)| text.replace(mark, name))
        };
        // A label may take several lines, but its words are there.
        let has = |label: &str| escaped(label).split(' ').all(|word| shown.contains(word));
        assert!(has(&figure.title));
        for panel in &figure.panels {
            assert!(has(&panel.title) && has(&panel.x.label) && has(&panel.y.label));
            assert!(panel.lines.iter().all(|line| has(&line.label)));
        }
    }
}

#[cfg(feature = "plots")]
mod pixels {
    use super::*;
    use crate::picture::reading::trouble;

    #[test]
    fn texts_are_whole_and_apart() {
        for figure in all() {
            assert_eq!(trouble(&svg(&figure)), None);
        }
    }

    /// On paper too, where panels stand below each other and letters keep their size.
    #[test]
    fn texts_are_whole_and_apart_in_a_column() {
        let width = Some(PaperLength::width("120mm").unwrap());
        for figure in [errors(), losses(), profile()] {
            let svg = figure.svg(&Print { width, ..Print::default() }).unwrap();
            assert!(svg.contains("width=\"340.157pt\""));
            assert_eq!(trouble(&svg), None);
        }
    }

    #[test]
    fn pictures_have_the_size_of_the_drawing() {
        let png = crate::picture::png::render(&svg(&profile()), &Print::default()).unwrap();
        let side = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        let svg = svg(&profile());
        // Twice as many pixels as units.
        let size = format!("width=\"{}\" height=\"{}\"", side(16) / 2, side(20) / 2);
        assert!(svg.contains(&size), "{size}");
    }

    #[test]
    #[ignore = "writes pictures to look at"]
    fn pictures() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/target/figures");
        std::fs::create_dir_all(folder).unwrap();
        for (name, figure) in
            [("errors", errors()), ("losses", losses()), ("profile", profile()), ("odd", odd())]
        {
            std::fs::write(format!("{folder}/{name}.svg"), svg(&figure)).unwrap();
            std::fs::write(
                format!("{folder}/{name}.png"),
                crate::picture::png::render(&svg(&figure), &Print::default()).unwrap(),
            )
            .unwrap();
        }
    }
}

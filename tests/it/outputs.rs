//! Whole outputs of every command, as in `snapshots/`; `snapshot.rs` tells how to write them anew.

use crate::snapshot::{Terminal, left_behind};

/// One test for each output, and the list of all.
macro_rules! outputs {
    ($($name:ident: $terminal:expr;)*) => {
        $(
            #[test]
            fn $name() {
                $terminal.is(stringify!($name));
            }
        )*

        #[test]
        fn every_stored_output_is_compared() {
            assert_eq!(left_behind(&[$(stringify!($name)),*]), [""; 0]);
        }
    };
}

fn run(line: &str) -> Terminal {
    Terminal::new().run(line)
}

fn each(lines: &[&str]) -> Terminal {
    Terminal::new().each(lines)
}

/// The constants of a landmark that has few.
fn export(format: &str) -> Terminal {
    run(&format!("couplet constants sb --weight heyman --digits 8 --format {format}"))
}

const ARCH: &str = "--half-opening 2.45 --friction 1.35 --digits 12";
const VAULT: &str = "--half-opening 80deg --thickness 0.12 --friction 0.6 --digits 12";

/// The same arch in every format.
fn formats(command: &str, arch: &str) -> Terminal {
    let line = |format| format!("couplet {command} {arch} --format {format}");
    ["table", "csv", "json"].iter().fold(Terminal::new(), |seen, format| seen.run(&line(format)))
}

const QUERIES: &str = "weight,alpha,mu\nmilankovitch,2.45,27/20\nheyman,pi/2,0.38\nheyman,90deg,inf\n\
    heyman,2.6,0.3\nheyman,2.8,9\nheyman,banana,1\nheyman,1\n";

const THICKNESSES: &str =
    "id;Alpha;phi;eta\na;80deg;31deg;0,12\nb;1,5D0;0x1p-1;\nc;80deg;31deg;0,05\n";

const RESULTS: &str = "alpha,mu,t_over_r,mode\n90,0.5,0.107426,rrr\n90,0.39,0.112750,srr\n90,0.38,0.2,\n\
    90,0.30,0.1,\n90,0.34,,srr\n90,x,1,\n";

fn judged(format: &str) -> Terminal {
    let columns = "alpha=half_opening:deg,mu=friction,t_over_r=thickness,mode";
    Terminal::new().file("results.csv", RESULTS).run(&format!(
        "couplet judge results.csv --weight heyman --columns {columns} --format {format}"
    ))
}

const SCENE: &str = "schema = \"couplet.scene/1\"\ndigits = 10\n\n\
    [[constants]]\nlandmarks = \"T\"\nquantities = [\"thickness\", \"friction\"]\noutput = \"T.csv\"\n\n\
    [[arches]]\nhalf_opening = { from = 0.5, to = 2.5, steps = 3 }\nfriction = [0.5, 1.5]\n\
    quantities = \"thickness\"\noutput = \"arches/thickness.csv\"\n\n\
    [[claims]]\nprove = \"eq-16\"\n";

const FAULTS: &str = "schema = \"couplet.scene/1\"\ncolour = 1\n\n\
    [[constants]]\nlandmarks = \"X\"\n\n[[arches]]\nhalf_opening = \"200deg\"\nfrictio = 1\n";

fn scene() -> Terminal {
    Terminal::new().file("scene.toml", SCENE)
}

outputs! {
    constants: run("couplet constants T sb --digits 12");
    constants_csv: export("csv");
    constants_json: export("json");
    constants_toml: export("toml");
    constants_latex: export("latex");
    constants_c: export("c");
    constants_rust: export("rust");
    constants_python: export("python");
    constants_julia: export("julia");
    constants_matlab: export("matlab");
    constants_fortran: export("fortran");

    map: run("couplet map point rrr/srr --weight both --at 80deg --digits 12");

    state: formats("state", ARCH);
    state_at_a_landmark: run("couplet state --at T --weight heyman --digits 12");
    state_that_falls: each(&[
        "couplet state --half-opening 2.6 --friction 0.3",
        "couplet state --half-opening 2.8 --friction 9",
        "couplet state --half-opening 2.8 --friction 9 --format json",
    ]);
    assess: formats("assess", VAULT);
    assess_what_falls: run("couplet assess --half-opening 80deg --thickness 0.05 --friction 0.6");
    find: each(&[
        "couplet find half-opening --thickness 0.15 --friction 0.6 --digits 12",
        "couplet find half-opening --friction 0.6 --weight both --digits 8 --format csv",
        "couplet find friction --half-opening 80deg --thickness 0.1 --digits 12 --format json",
        "couplet find boundary rrs/rsr --half-opening 2.54 --digits 12",
        "couplet find boundary rsr/rs --friction 1.2 --digits 12",
        "couplet find half-opening --friction 0",
        "couplet find friction --half-opening 2.65 --digits 12",
    ]);
    states: Terminal::new()
        .file("queries.csv", QUERIES)
        .run("couplet states --digits 8 < queries.csv")
        .run("couplet states --digits 3 --format jsonl < queries.csv");

    states_of_a_given_thickness: Terminal::new()
        .file("queries.csv", THICKNESSES)
        .run("couplet states queries.csv --digits 6 --keep id")
        .run("couplet states queries.csv --digits 3 --keep all --format jsonl");
    sample: each(&[
        "couplet sample --count 3",
        "couplet sample --hard --count 12 --seed 7",
        "couplet sample --hard --count 2 --format jsonl",
    ]);

    judge: judged("table");
    judge_csv: judged("csv");
    judge_jsonl: judged("jsonl");
    judge_json: judged("json");
    audit: each(&["couplet audit | head -20", "couplet audit | tail -20", "couplet audit --format csv | head -4"]);

    prove: run("couplet prove");
    prove_with_derivations: run("couplet prove eq-7-eta eq-8 eq-16 --show");
    prove_index: run("couplet prove --index");
    prove_json: run("couplet prove eq-16 --show --format json");
    prove_latex: run("couplet prove eq-8 --show --format latex");

    certify: run("couplet certify l --weight heyman --digits 3");
    certify_state: run("couplet certify state --half-opening 1 --friction inf --digits 3");
    check: each(&[
        "couplet certify all --digits 8 --output all",
        "couplet check all/*.json",
        "sed s/milankovitch/heyman/ all/triple-point-milankovitch.json > other-weight.json",
        "sed 's/0.61831824/0.61831825/' all/triple-point-milankovitch.json > last-digit.json",
        "echo '{}' > empty.json",
        "couplet check all/triple-point-heyman.json other-weight.json last-digit.json empty.json",
    ]);

    run_plan: scene().run("couplet run scene.toml --plan");
    run_outputs: scene().each(&[
        "couplet run scene.toml --output out",
        "cat out/T.csv",
        "cat out/arches/thickness.csv",
        "cat out/couplet-run.json",
        "couplet run scene.toml --output out --resume",
    ]);
    run_explained: scene().run("couplet run scene.toml --output out --explain");
    run_faults: Terminal::new().file("scene.toml", FAULTS).run("couplet run scene.toml");

    study: run("couplet study stability --quick --only eta-to-two");

    states_by_value: each(&[
        "couplet state --rotation-joint 1.0 --digits 12",
        "couplet state --rotation-joint 0.66 --friction 1.6 --digits 12",
        "couplet state --thrust 0.01 --friction 0.6 --digits 12 --format csv",
        "couplet state --opening-variable 0.7 --digits 12 --weight both",
        "couplet state --thickness 0.15 --friction 0.6 --quantity half_opening --plain",
    ]);

    equations: each(&[
        "couplet equation 4 --half-opening pi/2 --thickness 0.1 --digits 12",
        "couplet equation 18 --thrust 0.2 --digits 12",
        "couplet equation 7 --rotation-joint 1.0 --digits 12 --weight both",
        "couplet equation 8 --rotation-joint pi/3 --digits 12",
        "couplet equation 10 --rotation-joint 57deg --digits 12",
        "couplet equation 12 --rotation-joint 1.2 --digits 12",
    ]);

    help: each(&["couplet --help", "couplet -V"]);
    help_constants: run("couplet constants --help");
    help_state: run("couplet state --help");
    help_assess: run("couplet assess --help");
    help_find: run("couplet find --help");
    help_equation: run("couplet equation --help");
    help_voussoirs: run("couplet voussoirs --help");
    help_complementarity: run("couplet complementarity --help");
    help_map: run("couplet map --help");
    help_draw: run("couplet draw --help");
    help_figure: run("couplet figure --help");
    help_states: run("couplet states --help");
    help_sweep: run("couplet sweep --help");
    help_sample: run("couplet sample --help");
    help_judge: run("couplet judge --help");
    help_audit: run("couplet audit --help");
    help_prove: run("couplet prove --help");
    help_run: run("couplet run --help");
    help_certify: run("couplet certify --help");
    help_check: run("couplet check --help");
    help_study: each(&[
        "couplet study --help",
        "couplet study accuracy --help",
        "couplet study stability --help",
    ]);

    wrong_usage: each(&[
        "couplet",
        "couplet constant",
        "couplet constants X",
        "couplet constants --digit 3",
        "couplet constants --digits",
        "couplet constants --digits ten",
        "couplet constants --format yaml",
        "couplet constants --weight heymann",
        "couplet prove eq-99",
        "couplet prove --format toml",
        "couplet prove --index eq-16",
        "couplet study accuracy --only T",
        "couplet certify T --half-opening 1",
        "couplet judge",
    ]);
    wrong_arches: each(&[
        "couplet state --half-opening 0 --friction 1",
        "couplet state --half-opening 180deg --friction 1",
        "couplet state --half-opening nan --friction 1",
        "couplet state --half-opening 1e-1000000000 --friction 1",
        "couplet state --half-opening 1 --friction -1",
        "couplet state --half-opening 1 --friction-angle 91deg",
        "couplet state --half-opening 1",
        "couplet state --half-opening 1 --friction 1 --digits 0",
        "couplet assess --half-opening 1 --friction 1 --thickness 2.5",
        "couplet assess --half-opening 1 --friction 1",
        "couplet certify state --half-opening 1.5 --friction 0.1",
        "couplet find",
        "couplet find thickness --half-opening 1 --friction 1",
        "couplet find widest --friction 1",
        "couplet find half-opening --thickness 0.1",
        "couplet find half-opening --half-opening 1 --friction 1",
        "couplet find friction --half-opening 200deg",
        "couplet find boundary --friction 1",
        "couplet find boundary rrs/rrr/ss --friction 1",
        "couplet find boundary rrs/rsr",
        "couplet find boundary rrs/rsr --friction 1 --half-opening 1",
        "couplet find boundary rrs/rsr --friction inf",
    ]);
    wrong_files: each(&[
        "couplet check missing.json",
        "couplet judge missing.csv",
        "couplet run missing.toml",
        "couplet constants sb --output missing/sb.csv",
        "echo a,b | couplet states",
        "printf '' | couplet states",
        "echo a,b | couplet judge - --weight heyman",
    ]);
}

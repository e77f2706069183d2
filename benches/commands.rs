//! What whole commands cost: those that answer at once, beyond what `--version` takes; and certificates, beside the
//! constants that are in them.
//!
//! Each command is started anew, on one thread, in turns with the others; the shortest time of many runs is kept.
//! Nothing is asserted.

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Runs of each short command.
const RUNS: usize = 200;
/// No further round of long commands is begun after this time.
const BUDGET: Duration = Duration::from_secs(20);

const COLD: [&str; 9] = [
    "constants T",
    "constants T --digits 1000",
    "constants",
    "state --half-opening 80deg --friction 0.6",
    "state --half-opening 100deg --friction 0.5",
    "assess --half-opening 80deg --friction 0.6 --thickness 0.12",
    "voussoirs --half-opening pi/2 --friction 0.35 --stones 1000000 --digits 30",
    "assess --half-opening pi/2 --friction 0.4 --thickness 0.15 --tilt 0.05",
    "prove eq-2",
];

fn timed(arguments: &str) -> Duration {
    let mut command = Command::new(env!("CARGO_BIN_EXE_couplet"));
    command.args(arguments.split_whitespace()).env("RAYON_NUM_THREADS", "1");
    command.stdout(Stdio::null()).stderr(Stdio::null());
    let start = Instant::now();
    command.status().expect("couplet starts");
    start.elapsed()
}

/// The shortest time of each command, all of them once a round.
fn shortest(commands: &[String], runs: usize, budget: Duration) -> Vec<Duration> {
    let mut times = vec![Duration::MAX; commands.len()];
    let start = Instant::now();
    for _ in 0..runs {
        for (time, arguments) in times.iter_mut().zip(commands) {
            *time = (*time).min(timed(arguments));
        }
        if start.elapsed() > budget {
            break;
        }
    }
    times
}

fn milliseconds(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}

fn cold() {
    let commands: Vec<String> = ["--version"].into_iter().chain(COLD).map(String::from).collect();
    let times = shortest(&commands, RUNS, Duration::MAX);
    println!("| command | ms | beyond `--version` |\n|---|---|---|");
    for (command, time) in commands.iter().zip(&times) {
        let [all, beyond] = [*time, time.saturating_sub(times[0])].map(milliseconds);
        println!("| `{command}` | {all:.1} | {beyond:.1} |");
    }
}

fn certificates(digits: usize) {
    let file = std::env::temp_dir().join(format!("couplet-{}.json", std::process::id()));
    let file = file.display();
    let commands = [
        format!("constants T --weight milankovitch --digits {digits} --format csv"),
        format!("certify T --digits {digits} -o {file}"),
        format!("check --engine mpfr {file}"),
        format!("check {file}"),
    ];
    // In pure Rust a check of more digits would take as long as all of this.
    let commands = if digits <= 10_000 { &commands[..] } else { &commands[..3] };
    let times = shortest(commands, 20, BUDGET);
    let shown = times.iter().map(|time| {
        let ratio = time.as_secs_f64() / times[0].as_secs_f64();
        format!(" {:.1} ({ratio:.2}) |", milliseconds(*time))
    });
    println!("| {digits} |{}", shown.collect::<String>());
    let _ = std::fs::remove_file(file.to_string());
}

fn main() {
    // `cargo test` runs this too.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    cold();
    println!(
        "\n| digits | constants of T, ms | certify | check, MPFR | check, astro-float |\n|---|---|---|---|---|"
    );
    [1_000, 10_000, 100_000, 1_000_000].into_iter().for_each(certificates);
}

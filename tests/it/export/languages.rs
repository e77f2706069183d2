//! Each language reads its file and prints the bits it got.

use super::expected::{Expected, all};
use super::{constants, has};
use crate::program::Scratch;
use rug::Float;
use rug::float::Round;

const SUFFIXES: [&str; 4] = ["", "_LOWER", "_UPPER", "_ERROR"];

/// Compares lines `bits bits bits bits …`, one for each value in the order of the names.
fn compare(printed: &str, mut more: impl FnMut(&Expected, &[&str])) {
    let all = all();
    let lines: Vec<&str> = printed.lines().collect();
    assert_eq!(lines.len(), all.len());
    for (value, line) in all.values().zip(lines) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let bits: Vec<u64> =
            words[..4].iter().map(|word| u64::from_str_radix(word, 16).unwrap()).collect();
        value.check(bits.try_into().unwrap());
        more(value, &words[4..]);
    }
}

fn has_its_digits(value: &Expected, rest: &[&str]) {
    assert_eq!(rest, [value.text.as_str()], "{}", value.name());
}

/// A folder with the constants in a language, and a program over each of them.
fn written(
    [format, file, main]: [&str; 3],
    begin: &str,
    each: impl Fn(&str, &Expected) -> String,
    end: &str,
) -> Scratch {
    let scratch = Scratch::new();
    scratch.write(file, constants(format));
    let each: String = all().iter().map(|(name, value)| each(name, value)).collect();
    scratch.write(main, format!("{begin}{each}{end}"));
    scratch
}

/// The four doubles of a value, each as `of` has its name.
fn doubles(of: impl Fn(&str) -> String, between: &str) -> String {
    SUFFIXES.map(of).join(between)
}

fn compiled_as(compiler: &str, arguments: &[&str], source: &str) {
    if !has(compiler, "--version") {
        return;
    }
    // Twice, because a header may be.
    let begin = "#include <inttypes.h>\n#include <stdio.h>\n#include <string.h>\n#include \"couplet.h\"\n\
         #include \"couplet.h\"\n\
         static void bits(double x) {\n  uint64_t n;\n  memcpy(&n, &x, sizeof n);\n\
           printf(\"%016\" PRIx64 \" \", n);\n}\n\
         static const double constant = COUPLET_T_HEYMAN_THICKNESS;\nint main(void) {\n";
    let each = |name: &str, _: &Expected| {
        let bits = doubles(|suffix| format!("  bits(COUPLET_{name}{suffix});\n"), "");
        format!("{bits}  puts(COUPLET_{name}_TEXT);\n")
    };
    let files = ["c", "couplet.h", source];
    let scratch = written(files, begin, each, "  return constant > 0 ? 0 : 1;\n}\n");
    let strict = ["-Wall", "-Wextra", "-pedantic", "-Werror", source, "-o", "program"];
    scratch.run(compiler, &[arguments, &strict].concat());
    compare(&scratch.run(scratch.path("program"), &[]), has_its_digits);
}

#[test]
fn c_reads_every_bit() {
    compiled_as("gcc", &["-std=c99"], "main.c");
}

#[test]
fn cpp_reads_every_bit() {
    compiled_as("g++", &["-std=c++17"], "main.cpp");
}

#[test]
fn rust_reads_every_bit() {
    let begin = "mod constants;\nuse constants::*;\nfn main() {\n";
    let each = |name: &str, _: &Expected| {
        let print =
            |suffix: &str| format!("    print!(\"{{:016x}} \", {name}{suffix}.to_bits());\n");
        format!("{}    println!(\"{{{name}_TEXT}}\");\n", doubles(print, ""))
    };
    let scratch = written(["rust", "constants.rs", "main.rs"], begin, each, "}\n");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    scratch.run(rustc, &["--edition", "2021", "-D", "warnings", "main.rs", "-o", "program"]);
    compare(&scratch.run(scratch.path("program"), &[]), has_its_digits);
}

#[test]
fn python_reads_every_bit() {
    if !has("python3", "--version") {
        return;
    }
    let begin = "import struct, constants as c\ndef bits(x): return struct.pack('>d', x).hex()\n";
    let each = |name: &str, _: &Expected| {
        let doubles = doubles(|suffix| format!("bits(c.{name}{suffix})"), ", ");
        format!("print({doubles}, str(c.{name}_DECIMAL).lower())\n")
    };
    let scratch = written(["python", "constants.py", "main.py"], begin, each, "");
    compare(&scratch.run("python3", &["-W", "error", "main.py"]), |value, rest| {
        let text = if value.quad.is_none() { "infinity" } else { &value.text };
        assert_eq!(rest, [text]);
    });
}

#[test]
fn julia_reads_every_bit() {
    if !has("julia", "--version") {
        return;
    }
    let begin = "include(\"constants.jl\")\nusing .CoupletConstants\nconst C = CoupletConstants\n\
         bits(x::Float64) = string(reinterpret(UInt64, x), base = 16, pad = 16)\n";
    let each = |name: &str, _: &Expected| {
        let doubles = doubles(|suffix| format!("bits(C.{name}{suffix})"), ", \" \", ");
        let big = format!("Float64(round(C.{name}_BIG, sigdigits = 3))");
        format!("println({doubles}, \" \", bits({big}))\n")
    };
    let scratch = written(["julia", "constants.jl", "main.jl"], begin, each, "");
    compare(&scratch.run("julia", &["--startup-file=no", "main.jl"]), |value, rest| {
        let read = f64::from_bits(u64::from_str_radix(rest[0], 16).unwrap());
        assert_eq!(read, value.text.parse::<f64>().unwrap(), "{}", value.name());
    });
}

#[test]
fn octave_reads_every_bit() {
    if !has("octave-cli", "--version") {
        return;
    }
    let each = |_: &str, value: &Expected| {
        let point = match value.point {
            long if long.contains("END") => long.to_lowercase(),
            "SB" => "sb".into(),
            short => short.into(),
        };
        let name = format!("c.{point}.{}.{}", value.weight, value.quantity);
        let doubles = ["value", "lower", "upper", "error"];
        let doubles = doubles.map(|field| format!("num2hex({name}.{field})")).join(", ");
        let print = format!("printf('%s %s %s %s %s\\n', {doubles}, {name}.text);");
        format!("{print}\nassert(isempty({name}.digits));\n")
    };
    let files = ["matlab", "couplet_constants.m", "main.m"];
    let scratch = written(files, "c = couplet_constants();\n", each, "");
    compare(&scratch.run("octave-cli", &["--norc", "--quiet", "main.m"]), has_its_digits);
}

#[test]
fn fortran_reads_every_bit() {
    if !has("gfortran", "--version") {
        return;
    }
    let begin = "program main\n  use couplet_constants\n  implicit none\n";
    let each = |name: &str, value: &Expected| {
        let doubles = doubles(|suffix| format!("{name}{suffix}"), ", &\n    ");
        // Infinity is no constant of that kind.
        let quad = if value.quad.is_some() { format!("{name}_quad") } else { "0.0_real128".into() };
        format!("  print '(4(z16.16,1x),z32.32)', {doubles}, &\n    {quad}\n")
    };
    let files = ["fortran", "constants.f90", "main.f90"];
    let scratch = written(files, begin, each, "end program main\n");
    let strict = ["-std=f2008", "-Wall", "-Wextra", "-pedantic", "-Werror"];
    let files = ["constants.f90", "main.f90", "-o", "program"];
    scratch.run("gfortran", &[&strict[..], &files].concat());
    compare(&scratch.run(scratch.path("program"), &[]), |value, rest| {
        let read = u128::from_str_radix(rest[0], 16).unwrap();
        assert_eq!(read, quad_bits(value.quad.as_ref()), "{} {:?}", value.name(), value.quad);
    });
}

/// The bits of an IEEE quadruple that is zero, or normal and positive.
fn quad_bits(quad: Option<&Float>) -> u128 {
    let Some((quad, exponent)) = quad.and_then(|quad| Some((quad, quad.get_exp()?))) else {
        return 0;
    };
    let (mantissa, _) = Float::with_val_round(113, quad << (113 - exponent), Round::Zero)
        .0
        .to_integer_round(Round::Zero)
        .unwrap();
    let mantissa = mantissa.to_u128().unwrap() & ((1 << 112) - 1);
    ((exponent + 16382) as u128) << 112 | mantissa
}

#[test]
fn latex_takes_the_table() {
    if !has("pdflatex", "--version") || !has("kpsewhich", "siunitx.sty") {
        return;
    }
    let table = String::from_utf8(constants("latex")).unwrap();
    for value in all().values().filter(|value| value.quad.is_some()) {
        assert!(table.contains(&format!(r"\num{{{}}}", value.text)), "{}", value.name());
    }
    assert!(table.contains(r"& \num{0.680} & \num{0.6796047320988860} \\"), "beside the paper");
    let scratch = Scratch::new();
    scratch.write("table.tex", &table);
    scratch.write(
        "main.tex",
        "\\documentclass{article}\n\\usepackage{booktabs,longtable,siunitx}\n\
         \\begin{document}\n\\input{table}\n\\end{document}\n",
    );
    let log = scratch.run("pdflatex", &["-interaction=nonstopmode", "-halt-on-error", "main.tex"]);
    assert!(log.contains("Output written on main.pdf"), "{log}");
}

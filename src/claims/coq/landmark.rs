//! The file of a landmark: the claim in printed equations, the table, and its check.

use super::numeral::text;
use super::table::{Cleared, DECIMALS, Table};
use super::{Symbols, argument, head, printed, symbol, weight_name};
use crate::arch::{Equation, Landmark, System, Unknown};
use crate::certify::{Audited, CertifiedLandmark, Undecided};
use rug::Rational;
use std::fmt::{Display, Write};

/// Bits for the residuals at the centre: its decimals and a few more.
const RESIDUAL_BITS: u32 = 140;

/// The whole file.
pub fn file(point: &CertifiedLandmark, audited: &[Audited]) -> Result<String, Undecided> {
    let system = *point.isolated().system();
    let cleared = Cleared::new(&system);
    let table = Table::new(point, &cleared)?;
    let symbols = Symbols::of(&system);
    let mut out = head(
        &format!("{}, {}", title(point.landmark()), weight_name(point.weight())),
        "    The equations of the landmark as the paper prints them, the box in which they have exactly\n    \
         one solution, its digits, and what follows for the values that the paper prints.  The table of\n    \
         numbers between the claim and the theorem is what [Contraction] asks for.",
    );
    claim(&mut out, &system, &symbols, &table);
    numbers(&mut out, &symbols, &cleared, &table);
    check(&mut out, &symbols, &table);
    link(&mut out, &system, &symbols);
    theorem(&mut out, &symbols);
    if system.equations.contains(&Equation::DoubleThickness) {
        radicand(&mut out, &system, &symbols);
    }
    out.push_str(&printed::corollaries(point, audited, &symbols));
    Ok(out)
}

fn title(landmark: Landmark) -> String {
    let name = landmark.name();
    let article = if landmark == Landmark::WidestJoint { "The joint" } else { "The point" };
    format!("{article} {}: {name}", landmark.symbol())
}

/// Writes to a string, which cannot fail.
macro_rules! put {
    ($out:expr, $($text:tt)*) => {{
        let _ = writeln!($out, $($text)*);
    }};
}

fn claim(out: &mut String, system: &System, symbols: &Symbols, table: &Table) {
    let args = symbols.arguments();
    let labels: Vec<&str> = system.equations.iter().map(|equation| equation.label()).collect();
    put!(out, "\n(** ** What is claimed *)\n");
    put!(out, "(** {}. *)", labels.join("; "));
    put!(out, "Definition equations ({args} : R) : Prop :=");
    let printed: Vec<String> = system.equations.iter().map(|&e| equation(e, system)).collect();
    put!(out, "  {}.", printed.join(" /\\\n  "));
    put!(out, "\n(** In this box nothing else solves them. *)");
    put!(out, "Definition wide ({args} : R) : Prop :=");
    let bounds = symbols.iter().zip(&table.wide);
    let bounds: Vec<String> =
        bounds.map(|(x, (lo, hi))| format!("{} <= {x} <= {}", text(lo), text(hi))).collect();
    put!(out, "  {}.", bounds.join(" /\\\n  "));
    put!(out, "\n(** In this one lies the solution. *)");
    put!(out, "Definition narrow ({args} : R) : Prop :=");
    let digits = symbols.iter().zip(&table.centre);
    let digits: Vec<String> =
        digits.map(|(x, c)| format!("Rabs ({x} - {}) <= 1e-{DECIMALS}", text(c))).collect();
    put!(out, "  {}.", digits.join(" /\\\n  "));
}

/// An equation as the paper prints it, in the names of `Arch.v` and `Instance.v`.
fn equation(equation: Equation, system: &System) -> String {
    let of = |unknown| argument(system, unknown);
    let (alpha, eta) = (of(Unknown::HalfOpening), of(Unknown::Thickness));
    let (beta, h, mu) = (of(Unknown::RotationJoint), of(Unknown::Thrust), of(Unknown::Friction));
    let joint = of(Unknown::SlidingJoint);
    let delta = system.weight.flag();
    match equation {
        Equation::LowerThrust => format!("{h} = h_lower {delta} {beta} {eta}"),
        Equation::UpperThrust => format!("{h} = h_upper {delta} {alpha} {beta} {eta}"),
        Equation::WholeThrust => format!("{h} = h_whole {delta} {alpha} {eta}"),
        Equation::Tangency => format!("{h} = h_tangency {delta} {beta} {eta}"),
        Equation::TangencyAtCrown => format!("{h} = end_of_rotation {delta} {eta}"),
        Equation::DoubleThickness => format!("double_thickness {delta} {beta} {eta}"),
        Equation::ShoulderSliding => format!("{mu} = mu_ss {alpha} {h}"),
        Equation::InnerSliding => format!("{mu} = mu_is {h}"),
        Equation::Steepest => format!("{joint} = Arch.beta_s {h}"),
    }
}

/// A list in brackets, one element a line.
fn list(elements: impl IntoIterator<Item = impl Display>) -> String {
    let elements: Vec<String> = elements.into_iter().map(|x| x.to_string()).collect();
    format!("  [ {} ]", elements.join(";\n    "))
}

fn row<'a>(numbers: impl IntoIterator<Item = &'a Rational>) -> String {
    let numbers: Vec<String> = numbers.into_iter().map(text).collect();
    format!("[{}]", numbers.join("; "))
}

fn matrix(rows: &[Vec<Rational>]) -> String {
    list(rows.iter().map(row))
}

fn numbers(out: &mut String, symbols: &Symbols, cleared: &Cleared, table: &Table) {
    let args = symbols.arguments();
    put!(out, "\n(** ** The table *)\n");
    put!(out, "(** The equations cleared of denominators, and their partial derivatives. *)");
    put!(out, "Definition residuals ({args} : R) : list R :=\n{}.", list(&cleared.residuals));
    put!(out, "Definition jacobian ({args} : R) : list (list R) :=");
    let rows = cleared.jacobian.iter().map(|row| {
        let row: Vec<String> = row.iter().map(|term| term.to_string()).collect();
        format!("[{}]", row.join(";\n     "))
    });
    put!(out, "{}.", list(rows));
    put!(out, "\nDefinition centre : list R :=\n{}.", list(table.centre.iter().map(text)));
    put!(out, "Definition radii : list R :=\n  {}.", row(&table.radii));
    put!(out, "\n(** About the inverse of the Jacobian at the centre. *)");
    put!(out, "Definition inverse : list (list R) :=\n{}.", matrix(&table.inverse));
    put!(
        out,
        "\n(** The Jacobian at the centre, and how far it can be from that in the wide box. *)"
    );
    put!(out, "Definition slopes : list (list R) :=\n{}.", matrix(&table.slopes));
    put!(out, "Definition spreads : list (list R) :=\n{}.", matrix(&table.spreads));
    put!(out, "\n(** The residuals at the centre, and the factor of contraction. *)");
    put!(out, "Definition size : R := {}.", text(&table.residual));
    put!(out, "Definition factor : R := {}.", text(&table.factor));
    put!(
        out,
        "\nDefinition F (j : nat) (x : point) : R := entry ({}) j.",
        at("residuals", symbols)
    );
    put!(
        out,
        "Definition J (j k : nat) (x : point) : R := entries ({}) j k.",
        at("jacobian", symbols)
    );
}

/// A function of the unknowns at the point `x`.
fn at(function: &str, symbols: &Symbols) -> String {
    let arguments: Vec<String> =
        symbols.iter().enumerate().map(|(k, _)| format!("(x {k}%nat)")).collect();
    format!("{function} {}", arguments.join(" "))
}

/// The checks of the table, each a lemma of its own.
fn check(out: &mut String, symbols: &Symbols, table: &Table) {
    let n = table.centre.len();
    let args = symbols.arguments();
    let coordinates: Vec<String> = (0..n).map(|k| format!("(x {k}%nat)")).collect();
    let bounds: Vec<String> = (0..n).map(|k| format!("B{k}")).collect();
    put!(out, "\n(** ** Its check *)\n");
    put!(
        out,
        "Ltac reduce := cbv beta iota zeta delta [F J residuals jacobian centre radii inverse slopes \
         spreads\n  size factor entry entries nth sum unit_entry Nat.eqb].\n"
    );
    put!(out, "Notation box d x := (within {n} (entry radii) d x (entry centre)).\n");
    put!(out, "Lemma derivatives j : (j < {n})%nat -> forall (x u : point) (t : R),");
    put!(out, "  box 1 (fun i => x i + t * u i) ->");
    put!(out, "  is_derive (fun s => F j (fun i => x i + s * u i)) t");
    put!(out, "    (sum {n} (fun k => J j k (fun i => x i + t * u i) * u k)).");
    put!(
        out,
        "Proof. intros Hj x u t _. each j ltac:(reduce; auto_derive; [exact I | field]). Qed.\n"
    );
    put!(out, "Lemma slopes_hold x : box 1 x -> forall j k, (j < {n})%nat -> (k < {n})%nat ->");
    put!(out, "  Rabs (J j k x - entries slopes j k) <= entries spreads j k.");
    put!(out, "Proof.");
    put!(out, "  intros Hx j k Hj Hk.");
    for k in 0..n {
        put!(out, "  pose proof (bounds Hx {k} ltac:(lia)) as B{k}.");
    }
    put!(out, "  clear Hx. unfold J. revert {}.", bounds.join(" "));
    put!(out, "  generalize {}. clear x.", coordinates.join(" "));
    put!(out, "  intros {args} {}.", bounds.join(" "));
    put!(out, "  cbv [entry centre radii nth] in {}.", bounds.join(", "));
    put!(out, "  each j ltac:(each k ltac:(reduce; slope)).\nQed.\n");
    put!(out, "Lemma residuals_hold j : (j < {n})%nat -> Rabs (F j (entry centre)) <= size.");
    put!(
        out,
        "Proof. intros Hj. each j ltac:(reduce; interval with (i_prec {RESIDUAL_BITS})). Qed.\n"
    );
    put!(out, "Lemma contracts i : (i < {n})%nat ->");
    put!(
        out,
        "  sum {n} (fun k => (Rabs (unit_entry i k - sum {n} (fun j => entries inverse i j * entries slopes j k))"
    );
    put!(
        out,
        "    + sum {n} (fun j => Rabs (entries inverse i j) * entries spreads j k)) * entry radii k)"
    );
    put!(out, "  <= factor * entry radii i.");
    put!(out, "Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.\n");
    put!(out, "Lemma starts i : (i < {n})%nat ->");
    put!(
        out,
        "  sum {n} (fun j => Rabs (entries inverse i j) * size) <= (1 - factor) * 1e-{DECIMALS} * entry radii i."
    );
    put!(out, "Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.\n");
    put!(out, "Lemma regular j : (j < {n})%nat ->");
    put!(
        out,
        "  sum {n} (fun k => Rabs (unit_entry j k - sum {n} (fun i => entries slopes j i * entries inverse i k)))"
    );
    put!(out, "  <= 1 / 2.");
    put!(out, "Proof. intros Hj. each j ltac:(reduce; arithmetic). Qed.\n");
    put!(out, "Lemma radii_positive i : (i < {n})%nat -> 0 < entry radii i.");
    put!(out, "Proof. intros Hi. each i ltac:(reduce; arithmetic). Qed.\n");
    put!(out, "Lemma root : exists x, box 1e-{DECIMALS} x /\\ solves {n} F x /\\");
    put!(out, "  (forall y, box 1 y -> solves {n} F y -> forall i, (i < {n})%nat -> y i = x i).");
    put!(out, "Proof.");
    put!(
        out,
        "  apply (one_root_from_table {n} F J (entries inverse) (entries slopes) (entries spreads)"
    );
    put!(out, "    (entry centre) (entry radii) (fun _ => size) factor 1e-{DECIMALS});");
    put!(
        out,
        "    [ exact radii_positive | reduce; lra | lra | exact derivatives | exact slopes_hold"
    );
    put!(out, "    | exact residuals_hold | exact contracts | exact starts | exact regular ].");
    put!(out, "Qed.");
}

/// The cleared equations and the printed ones.
fn link(out: &mut String, system: &System, symbols: &Symbols) {
    let args = symbols.arguments();
    put!(out, "\n(** ** The cleared equations are the printed ones *)\n");
    put!(out, "Lemma cleared {args} : wide {args} ->");
    put!(out, "  (equations {args} <-> vanish (residuals {args})).");
    put!(out, "Proof.");
    put!(out, "  unfold wide, equations, residuals; intros W; conjuncts; cbn [vanish].");
    let last = system.equations.len() - 1;
    for (index, equation) in system.equations.iter().enumerate() {
        let lemma = match equation {
            Equation::LowerThrust => "cleared_lower",
            Equation::UpperThrust => "cleared_upper",
            Equation::WholeThrust => "cleared_whole",
            Equation::Tangency => "cleared_tangency",
            Equation::TangencyAtCrown => "cleared_tangency_at_crown",
            Equation::DoubleThickness => "cleared_double_thickness",
            Equation::ShoulderSliding => "cleared_shoulder_sliding",
            Equation::InnerSliding => "cleared_inner_sliding",
            // It belongs to the equation before it.
            Equation::Steepest => continue,
        };
        let pair = system.equations.get(index + 1) == Some(&Equation::Steepest);
        if index == last || pair {
            put!(out, "  apply {lemma}; clearing.");
        } else {
            put!(out, "  apply both_under; [apply {lemma}; clearing | intros E{index}].");
        }
    }
    put!(out, "Qed.");
}

fn theorem(out: &mut String, symbols: &Symbols) {
    let args = symbols.arguments();
    let n = symbols.iter().count();
    let primed: Vec<String> = symbols.iter().map(|x| format!("{x}'")).collect();
    let others = primed.join(" ");
    let equal: Vec<String> = symbols.iter().map(|x| format!("{x}' = {x}")).collect();
    let coordinates: Vec<String> = (0..n).map(|k| format!("(x {k}%nat)")).collect();
    let point = coordinates.join(" ");
    put!(out, "\n(** ** The theorem *)\n");
    put!(out, "Lemma narrow_is_wide {args} : narrow {args} -> wide {args}.");
    put!(out, "Proof. narrow_to_wide narrow wide. Qed.\n");
    put!(out, "Theorem one_solution : exists {args},");
    put!(out, "  narrow {args} /\\ equations {args} /\\");
    put!(out, "  (forall {others}, wide {others} -> equations {others} ->");
    put!(out, "     {}).", equal.join(" /\\ "));
    put!(out, "Proof.");
    put!(out, "  destruct root as [x [Hx [Hroot Hunique]]]. exists {}.", coordinates.join(", "));
    put!(out, "  assert (N : narrow {point}) by (unfold narrow; repeat split; digits Hx reduce).");
    put!(out, "  split; [exact N | split].");
    put!(out, "  - apply (cleared {point}); [now apply narrow_is_wide |].");
    put!(out, "    apply vanish_entries. exact Hroot.");
    put!(out, "  - intros {others} W E. apply cleared in E; [| exact W].");
    put!(
        out,
        "    assert (same : forall i, (i < {n})%nat -> entry [{}] i = x i).",
        primed.join("; ")
    );
    put!(
        out,
        "    {{ apply Hunique; [intros i Hi; unfold wide in W; each i ltac:(reduce; inside) |]."
    );
    put!(out, "      intros j Hj. exact (proj1 (vanish_entries _) E j Hj). }}");
    put!(
        out,
        "    repeat split; [{}].",
        (0..n).map(|k| format!("exact (same {k}%nat ltac:(lia))")).collect::<Vec<_>>().join(" | ")
    );
    put!(out, "Qed.\n");
    put!(out, "Corollary digits {args} : wide {args} -> equations {args} -> narrow {args}.");
    put!(out, "Proof.");
    let found: Vec<String> = symbols.iter().map(|x| format!("{x}'")).collect();
    put!(out, "  destruct one_solution as ({} & N & _ & unique).", found.join(" & "));
    put!(out, "  intros W E. specialize (unique {args} W E). clear W E.");
    put!(out, "  conjuncts. subst. exact N.");
    put!(out, "Qed.");
}

/// That the radicand (12) vanishes at a double thickness.
fn radicand(out: &mut String, system: &System, symbols: &Symbols) {
    let args = symbols.arguments();
    let delta = system.weight.flag();
    let beta = symbol(Unknown::RotationJoint);
    put!(out, "\nCorollary radicand_vanishes {args} : wide {args} -> equations {args} ->");
    put!(out, "  radicand {delta} (f_of {beta}) (g_of {beta}) (sin {beta}) = 0.");
    put!(out, "Proof.");
    put!(out, "  unfold wide, equations. intros W E. conjuncts.");
    put!(out, "  apply radicand_at_double_thickness with eta; try assumption; clearing.");
    put!(out, "Qed.");
}

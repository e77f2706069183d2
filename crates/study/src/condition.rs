//! The condition number of a problem: how many digits of the result its input decides.

use super::Task;
use crate::solve::inverse;
use rug::Float;

/// `log10` of the condition number of unknown number `index` of a problem at its root: the sum over the
/// parameters of the relative change of the result over that of the parameter. `None` where the problem
/// has no parameters or is singular.
///
/// The derivatives are those of the equations, from dual numbers: with `F(x, a) = 0` the root changes by
/// `-F_x⁻¹ F_a` times the change of `a`.
pub fn condition(problem: &Task, root: &[Float], index: usize) -> Option<f64> {
    let n = root.len();
    let equations = problem.residuals_with_parameters(root);
    let parameters = problem.parameters(&root[0]);
    let column = |k: usize| equations.iter().map(move |e| e.derivative(k));
    let jacobian = equations.iter().map(|e| (0..n).map(|k| e.derivative(k)).collect()).collect();
    let row = inverse(jacobian)?.swap_remove(index);
    let sum = parameters.iter().enumerate().fold(Float::new(root[0].prec()), |sum, (k, a)| {
        let zero = Float::new(root[0].prec());
        let change = row.iter().zip(column(n + k)).fold(zero, |sum, (y, f)| sum + f * y);
        sum + (change * a / &root[index]).abs()
    });
    (!parameters.is_empty()).then(|| sum.log10().to_f64())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::newton::newton;
    use rug::Rational;

    #[test]
    fn it_is_the_change_of_the_root_with_the_parameter() {
        // A(alpha) = a: d alpha/da = 1/A', and A' = (sin alpha - alpha)/(1 - cos alpha).
        let problem = Task::HalfOpening { a: Rational::from(1) };
        let root = newton(&problem, &[Float::with_val(100, 2.33)], 100).unwrap().root;
        let alpha = root[0].to_f64();
        let slope = (alpha.sin() - alpha) / (1.0 - alpha.cos());
        let expected = (1.0 / (slope * alpha)).abs().log10();
        approx::assert_relative_eq!(
            condition(&problem, &root, 0).unwrap(),
            expected,
            max_relative = 1e-9
        );
    }

    #[test]
    fn a_problem_without_parameters_has_none() {
        use crate::arch::SelfWeight;
        use crate::problem::Landmark;
        let problem = Task::Landmark { weight: SelfWeight::Heyman, landmark: Landmark::Triple };
        let start = crate::solve::start::landmark(Landmark::Triple, SelfWeight::Heyman);
        let start: Vec<Float> = start.iter().map(|x| Float::with_val(100, x)).collect();
        assert!(condition(&problem, &newton(&problem, &start, 100).unwrap().root, 0).is_none());
    }
}

"""Double precision: scipy, SymPy and plain Python.

fsolve  scipy's `fsolve` on the six equations, differences for the Jacobian
root    scipy's `root`, method hybr, on the three equations of `triple.py`, with their Jacobian
nsolve  SymPy's `nsolve` on the six equations, written as expressions; any number of digits
newton  Newton's method on the three equations, Python's own floats
"""

import math

import harness
import triple


def decimals(values):
    return [f"{float(x):.15g}" for x in values]


def cos_sin(x):
    return math.cos(x), math.sin(x)


def all_six(here):
    return (*here.angles, here.eta, here.h, triple.friction(here))


def fsolve(_):
    from scipy.optimize import fsolve

    equations = lambda x: triple.residuals(x.tolist(), cos_sin)  # noqa: E731
    return lambda: fsolve(equations, triple.START, xtol=1e-13), decimals


def root(_):
    from scipy.optimize import root

    def at(x):
        return triple.evaluated(x.tolist(), triple.FLOATS)

    def equations(x):
        here = at(x)
        return triple.reduced(here), triple.slopes(here)[0]

    def job():
        return all_six(at(root(equations, triple.START[:3], jac=True, tol=1e-14).x))

    return job, decimals


def nsolve(digits):
    import sympy

    unknowns = sympy.symbols(triple.UNKNOWNS, positive=True)
    equations = triple.residuals(unknowns, lambda x: (sympy.cos(x), sympy.sin(x)))

    def job():
        return sympy.nsolve(equations, unknowns, triple.START, prec=digits, maxsteps=100)

    return job, lambda values: [str(x) for x in values]


def newton(_):
    return lambda: all_six(triple.evaluated(triple.floats(), triple.FLOATS)), decimals


if __name__ == "__main__":
    harness.main({"fsolve": fsolve, "root": root, "nsolve": nsolve, "newton": newton})

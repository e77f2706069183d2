"""mpmath with gmpy2 behind it.

findroot  the library's multidimensional Newton method on the six equations: finite differences and
          full precision from the first step to the last
newton    precision doubling by hand, on the three equations of `triple.py`
bare      the yardstick: sines and cosines of the three angles
"""

import harness
import triple
from mpmath import libmp, mp, mpf

assert libmp.BACKEND == "gmpy", "mpmath does not use gmpy2"

GUARD = 8


class Numbers:
    number = mpf
    cos_sin = mp.cos_sin
    sqrt = mp.sqrt

    def precision(bits):
        mp.prec = bits

    def exact(x):
        return x


def bits_of(digits):
    return digits * 3322 // 1000 + 1


def decimals(digits):
    return lambda values: [mp.nstr(x, digits, strip_zeros=False) for x in values]


def findroot(digits):
    def job():
        mp.prec = bits_of(digits) + GUARD + 10  # `findroot` stops ten bits short
        function = lambda *x: triple.residuals(x, mp.cos_sin)  # noqa: E731
        return list(mp.findroot(function, triple.START, solver="mdnewton", maxsteps=100))

    return job, decimals(digits)


def newton(digits):
    return lambda: triple.newton(bits_of(digits) + GUARD, Numbers), decimals(digits)


def bare(digits):
    angles = triple.newton(bits_of(digits) + GUARD, Numbers)[:3]
    return lambda: triple.bare(angles, mp.cos_sin), lambda _: None


if __name__ == "__main__":
    harness.main({"findroot": findroot, "newton": newton, "bare": bare})

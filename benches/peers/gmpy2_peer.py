"""MPFR through gmpy2, without mpmath above it.

newton  precision doubling by hand, on the three equations of `triple.py`
bare    the yardstick: sines and cosines of the three angles
"""

import gmpy2
import harness
import triple

GUARD = 8
CONTEXT = gmpy2.get_context()


class Numbers:
    number = gmpy2.mpfr
    sqrt = gmpy2.sqrt

    def precision(bits):
        CONTEXT.precision = bits

    def cos_sin(x):
        sin, cos = gmpy2.sin_cos(x)
        return cos, sin

    def exact(x):
        return x


def bits_of(digits):
    return digits * 3322 // 1000 + 1


def newton(digits):
    job = lambda: triple.newton(bits_of(digits) + GUARD, Numbers)  # noqa: E731
    return job, lambda values: [f"{x:.{digits}g}" for x in values]


def bare(digits):
    angles = triple.newton(bits_of(digits) + GUARD, Numbers)[:3]
    return lambda: triple.bare(angles, Numbers.cos_sin), lambda _: None


if __name__ == "__main__":
    harness.main({"newton": newton, "bare": bare})

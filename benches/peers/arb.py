"""Arb through python-flint: Newton's method over balls, and a proof by the Krawczyk operator.

newton   The balls' radii are dropped at every step: approximate, nothing is proved.
proof    The last step encloses: m the approximation, X a box about it, Y an inverse of the Jacobian,
         K = m - Y F(m) + (I - Y F'(X)) (X - m). K inside X proves that X holds one root and K holds it.
quantities  The same, and from it the 13 quantities that couplet gives, as decimals.
bare     The yardstick: sines and cosines of the three angles.
"""

import harness
import triple
from flint import arb, ctx

GUARD = 8
PROOF_GUARD = 32


class Balls:
    number = arb
    sqrt = arb.sqrt
    exact = arb.mid

    def precision(bits):
        ctx.prec = bits

    def cos_sin(x):
        sin, cos = x.sin_cos()
        return cos, sin


def bits_of(digits):
    return digits * 3322 // 1000 + 1


def newton(digits):
    return lambda: triple.newton(bits_of(digits) + GUARD, Balls), decimals(digits)


def decimals(digits):
    def strings(values):
        ctx.prec = bits_of(digits) + PROOF_GUARD
        return [x.str(digits, radius=False) for x in values]

    return strings


def widened(here, radius, bits):
    """Everything at all points of the box of a radius about `here`, to `bits` bits."""
    ctx.prec = bits
    about = arb(0, radius)
    alpha, beta, beta_s = (+x + about for x in here.angles)
    # Sine and cosine move no further than their argument.
    circle = [(+cos + r, +sin + r) for (cos, sin), r in zip(here.circle, (about, about, about * 2))]
    return triple.at((alpha, beta, beta_s), circle, arb.sqrt)


def proof(digits):
    bits = bits_of(digits) + PROOF_GUARD
    half = bits // 2 + triple.LOST

    def job():
        centre = triple.newton(half, Balls)[:3]
        ctx.prec = bits
        here = triple.evaluated(centre, Balls)
        values, mu = triple.reduced(here), triple.friction(here)
        for widening in range(8):
            radius = arb(2) ** (16 * widening - half + 8)
            enclosed = krawczyk(centre, here, values, mu, radius)
            if enclosed:
                return enclosed
        raise ArithmeticError("not proved")

    def krawczyk(centre, here, values, mu, radius):
        box = widened(here, radius, half)
        jacobian, gradients = triple.slopes(box)
        approximate = triple.inverse([[arb(x).mid() for x in row] for row in jacobian])
        y = [[x.mid() for x in row] for row in approximate]
        step = triple.product(y, [+x for x in values])
        product = [
            [sum((y[i][k] * jacobian[k][j] for k in range(3)), arb(0)) for j in range(3)] for i in range(3)
        ]
        about = arb(0, radius)
        spread = [sum((int(i == j) - product[i][j]) * about for j in range(3)) for i in range(3)]
        step = [dx - dy for dx, dy in zip(step, spread)]
        if not (all(about.contains_interior(dx) for dx in step) and is_admissible(box)):
            return None
        ctx.prec = half
        others = triple.product(gradients, step)
        ctx.prec = bits
        return triple.moved(centre, step) + triple.moved((here.eta, here.h, mu), others)

    return job, decimals(digits)


def quantities(digits):
    """The proof, and the decimals of what follows from it."""
    enclose, strings = proof(digits)

    def job():
        alpha, beta, beta_s, eta, h, mu = enclose()
        phi = mu.atan()
        degrees = 180 / arb.pi()
        derived = [phi, eta * h, alpha * (alpha / 2).cot()]
        derived += [degrees * angle for angle in (phi, alpha, beta, beta_s)]
        return strings([alpha, beta, beta_s, eta, h, mu, *derived])

    return job, lambda decimals: decimals[:6]


def is_admissible(box):
    """The physical range, and no denominator that the equations have lost contains zero."""
    ctx.prec = 53
    (alpha, beta, beta_s), ((ca, sa), (cb, sb), _), h, eta = triple.rounded(box)
    ss, cs = beta_s.sin_cos()
    positive = [alpha, beta, beta_s, eta, h, 1 - h, 2 - eta, arb.pi() - alpha, alpha - beta, alpha - beta_s]
    positive += [sb, 1 - ca, h * sa - alpha * ca, h * ca + alpha * sa, (1 - h) * ss + beta_s * cs]
    positive += [2 + eta - (2 - eta) * cb]
    return all(x > 0 for x in positive)


def bare(digits):
    angles = triple.newton(bits_of(digits) + GUARD, Balls)[:3]
    return lambda: triple.bare(angles, Balls.cos_sin), lambda _: None


if __name__ == "__main__":
    harness.main({"newton": newton, "proof": proof, "quantities": quantities, "bare": bare})

"""The triple point T of Milankovitch's weight, over any number type.

`residuals` are the six equations as `docs/certificate.md` prints them. The peers that write their own
Newton iteration solve three instead: with h, eta and mu eliminated the three angles remain,

    h    from beta_s^2 = h (1 - h)                h = (1 - sqrt(1 - 4 beta_s^2))/2
    eta  from (4), A = alpha cot(alpha/2)         A - h = q = (2 + eta^2/6)/(2 + eta)
    mu   from (17)

    R1 = 0   (17) = (18), with gamma = alpha + beta_s
    R2 = 0   (5)
    R3 = 0   (2)

That is one sine and cosine for each of alpha, beta and gamma, all of short arguments while the angles
are known to half the digits, and 3 x 3 matrices in place of 6 x 6.
"""

import math
from collections import namedtuple

UNKNOWNS = ("half_opening", "rotation_joint", "sliding_joint", "thickness", "thrust", "friction")

# The same four digits from which couplet starts.
START = (2.430, 1.043, 0.3187, 0.6183, 0.1148, 1.277)


def residuals(unknowns, cos_sin):
    """The six residuals, denominators cleared."""
    alpha, beta, beta_s, eta, h, mu = unknowns
    (ca, sa), (cb, sb), (cs, ss) = cos_sin(alpha), cos_sin(beta), cos_sin(beta_s)
    fac2 = 2 + eta * eta / 6
    return (
        (2 + eta - (2 - eta) * cb) * h - ((2 - eta) * beta * sb - (1 - cb) * fac2),
        (1 - ca) * (2 + eta) * h - ((2 + eta) * alpha * sa - fac2 * (1 - ca)),
        (2 - eta) * h - ((1 + beta * cb / sb) * (2 - eta) - fac2),
        (h * ca + alpha * sa) * mu - (h * sa - alpha * ca),
        ((1 - h) * ss + beta_s * cs) * mu - ((1 - h) * cs - beta_s * ss),
        beta_s * beta_s - h * (1 - h),
    )


def bare(unknowns, cos_sin):
    """The yardstick: the sines and cosines of the three angles."""
    return [cos_sin(angle) for angle in unknowns[:3]]


# Angles with what belongs to them; `circle` is the cosine and sine of alpha, beta and gamma.
At = namedtuple("At", "angles circle h eta")


def at(angles, circle, sqrt):
    """The eliminated unknowns, at angles whose cosines and sines are known."""
    alpha, _, beta_s = angles
    cos, sin = circle[0]
    h = (1 - sqrt(1 - 4 * beta_s * beta_s)) / 2
    q = alpha * sin / (1 - cos) - h
    return At(angles, circle, h, 3 * q - sqrt(9 * q * q - 12 * (1 - q)))


def reduced(at):
    """R1, R2, R3."""
    (alpha, beta, beta_s), (_, (cb, sb), (cg, sg)), h, eta = at
    fac2, inner = 2 + eta * eta / 6, 2 - eta
    return (
        (h * beta_s - alpha * (1 - h)) * sg - beta_s * (alpha + beta_s) * cg,
        (fac2 - inner * (1 - h)) * sb - inner * beta * cb,
        (2 + eta) * h + fac2 - (inner * h + fac2) * cb - inner * beta * sb,
    )


def friction(at):
    """mu."""
    alpha, (cos, sin), h = at.angles[0], at.circle[0], at.h
    return (h * sin - alpha * cos) / (h * cos + alpha * sin)


def slopes(at):
    """The Jacobian of `reduced`, and the gradients of eta, h and mu; all by alpha, beta and beta_s."""
    (alpha, beta, beta_s), ((ca, sa), (cb, sb), (cg, sg)), h, eta = at
    fac2, inner, gamma = 2 + eta * eta / 6, 2 - eta, alpha + beta_s
    h_s = 2 * beta_s / (1 - 2 * h)
    per_a = 1 / (1 - ca)
    eta_q = (2 + eta) / (eta / 3 - fac2 / (2 + eta))
    eta_a = eta_q * (sa - alpha) * per_a
    eta_s = -eta_q * h_s
    p = h * beta_s - alpha * (1 - h)
    r1_a = (p - beta_s) * cg + (beta_s * gamma - (1 - h)) * sg
    r1_s = (p - gamma - beta_s) * cg + (h + h_s * gamma + beta_s * gamma) * sg
    r2_h = inner * sb
    r2_eta = (1 - h + eta / 3) * sb + beta * cb
    r2_b = (fac2 - inner * (2 - h)) * cb + inner * beta * sb
    r3_h = 2 + eta - inner * cb
    r3_eta = h + eta / 3 - (eta / 3 - h) * cb + beta * sb
    r3_b = (inner * (h - 1) + fac2) * sb - inner * beta * cb
    numerator, denominator = h * sa - alpha * ca, h * ca + alpha * sa
    mu = numerator / denominator
    mu_a = (h * ca - ca + alpha * sa - mu * (sa + alpha * ca - h * sa)) / denominator
    mu_h = (sa - mu * ca) / denominator
    jacobian = (
        (r1_a, 0, r1_s),
        (r2_eta * eta_a, r2_b, r2_h * h_s + r2_eta * eta_s),
        (r3_eta * eta_a, r3_b, r3_h * h_s + r3_eta * eta_s),
    )
    return jacobian, ((eta_a, 0, eta_s), (0, 0, h_s), (mu_a, 0, mu_h * h_s))


def inverse(m):
    """Of a 3 x 3 matrix whose entry (0, 1) is zero."""
    (a, _, c), (d, e, f), (g, h, i) = m
    x, y, z = e * i - f * h, f * g - d * i, d * h - e * g
    over = 1 / (a * x + c * z)
    return (
        (x * over, c * h * over, -c * e * over),
        (y * over, (a * i - c * g) * over, (c * d - a * f) * over),
        (z * over, -a * h * over, a * e * over),
    )


def product(matrix, vector):
    x, y, z = vector
    return tuple(a * x + b * y + c * z for a, b, c in matrix)


class FLOATS:
    """Python's own."""

    sqrt = math.sqrt

    def cos_sin(x):
        return math.cos(x), math.sin(x)


# Newton's method with precision doubling, the same over every number type. A `field` has
#   precision(bits)   sets the working precision; `+x` rounds to it
#   number(float), cos_sin(x), sqrt(x)
#   exact(x)          the number without what it knows of its error

START_BITS = 50  # what `floats` gives
LOST = 4  # bits by which a step may fall short


def floats():
    """The angles in double precision, from the four digits."""
    angles = START[:3]
    for _ in range(3):
        here = evaluated(angles, FLOATS)
        angles = moved(angles, correction(here, reduced(here))[0])
    return angles


def evaluated(angles, field):
    alpha, beta, beta_s = angles
    circle = [field.cos_sin(x) for x in (alpha, beta, alpha + beta_s)]
    return at(angles, circle, field.sqrt)


def correction(here, values):
    """The Newton step, and what belongs to it of eta, h and mu."""
    jacobian, gradients = slopes(here)
    step = product(inverse(jacobian), values)
    return step, product(gradients, step)


def moved(values, step):
    return tuple(x - dx for x, dx in zip(values, step))


def levels(bits):
    """The bits of each step, which needs half of them from the one before."""
    steps = [bits]
    while steps[-1] // 2 + LOST > START_BITS:
        steps.append(steps[-1] // 2 + LOST)
    return steps[::-1]


def rounded(here):
    """Everything at a point, rounded to the working precision."""
    angles, circle, h, eta = here
    return At([+x for x in angles], [(+cos, +sin) for cos, sin in circle], +h, +eta)


def newton(bits, field):
    """All six unknowns to nearly `bits` bits. Sines and cosines are computed once a step, at its full
    precision; the Jacobian is made of their leading halves, and inverted in half the precision."""
    angles = tuple(field.number(x) for x in floats())
    for step_bits in levels(bits):
        field.precision(step_bits)
        here = evaluated(angles, field)
        values = reduced(here)
        field.precision(step_bits // 2 + LOST)
        step, others = correction(rounded(here), [+x for x in values])
        field.precision(step_bits)
        angles = tuple(field.exact(x) for x in moved(angles, step))
    # The other three move along with the angles: nothing is evaluated again.
    eta, h, mu = moved((here.eta, here.h, friction(here)), others)
    return angles + (eta, h, mu)

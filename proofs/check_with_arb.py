#!/usr/bin/env python3
"""Checks certificates with Arb, independently of the program that made them.

    python3 proofs/check_with_arb.py [--statement] FILE...

One line per file, `FILE: accepted ...` or `FILE: refused: reason`; with --statement what is accepted is told in a whole
sentence with every digit, in the words of `couplet check --statement`. The exit status is 0 if all are accepted,
1 if one is refused, 2 if one cannot be read or the call is wrong. Needs Python 3.10, python-flint 0.8 or newer.

What an acceptance proves. The large box X of the certificate holds exactly one common zero of the
equations of the claim, this zero lies in the small box, there it has the signs which the claim demands, and
each decimal number listed is the true value, correctly rounded. Of a survey: each certificate in it is accepted, and these
are the arches that decide its verdict. A refusal says only that this was not shown.

What is trusted. Arb (FLINT) encloses sums, products, quotients, roots, sine, cosine, arctangent and pi as it
says; Python and its JSON parser; `docs/certificate.md` for the meaning of a claim, from which alone this file
was written: no line is taken over from the program. Behind the page stands the theory of the arch: that the
equations describe it, and that for a state the listed signs are enough.

Nothing is computed in machine floating point. Numbers of the file become exact balls of radius zero, every
operation rounds outward, and a comparison of balls is true only if it holds for all their points (never for
a ball that is not a number), so that everything is written as "refuse unless shown".
"""
import json
import re
import sys

from flint import arb, ctx, fmpq, fmpz

MAX_BYTES, MAX_DIGITS, MAX_GIVEN, MAX_ENTRIES = 64 << 20, 1_000_000, 100_000, 32
MAX_PARTS, MAX_LENGTH = 4096, 300  # of a survey; digits of its lengths
MAX_POWER, MAX_EXPONENT = 3_000_000, 10_000_000  # of ten and of two
SHORT, LONG, GUARD = 256, 24_000, 128  # bits: radii, the centre of `unique` and inverse, of precision besides


class Refused(Exception):
    """The certificate does not show its claim."""


def need(shown, reason):
    if not shown:
        raise Refused(reason)


class Dual:
    """A value with its gradient; the entries are integers, balls, or again such numbers."""

    def __init__(self, value, gradient):
        self.v, self.d = value, gradient

    def lift(self, other):
        return other if isinstance(other, Dual) else Dual(other, [0] * len(self.d))

    def __add__(self, other):
        o = self.lift(other)
        return Dual(self.v + o.v, [x + y for x, y in zip(self.d, o.d, strict=True)])

    def __mul__(self, other):
        o = self.lift(other)
        return Dual(self.v * o.v, [x * o.v + self.v * y for x, y in zip(self.d, o.d, strict=True)])

    def __truediv__(self, other):
        o, q = self.lift(other), self.v / self.lift(other).v
        return Dual(q, [(x - q * y) / o.v for x, y in zip(self.d, o.d, strict=True)])

    __radd__, __rmul__ = __add__, __mul__
    __neg__ = lambda self: self * -1
    __sub__ = lambda self, other: self + -other
    __rsub__ = lambda self, other: -self + other
    sin = lambda self: Dual(sin(self.v), [cos(self.v) * x for x in self.d])
    cos = lambda self: Dual(cos(self.v), [-sin(self.v) * x for x in self.d])


# The variables, and the equations: each gives one variable as numerator / denominator of the page.
sin, cos = (lambda x: x.sin()), (lambda x: x.cos())
fac = lambda η, δ: 1 + δ * η * η / 12
SYMBOL = {"half_opening": "α", "rotation_joint": "β", "sliding_joint": "βs", "thickness": "η", "thrust": "h",
          "friction": "μ", "crown_hinge": "b0", "crown_moment": "p", "vertical_force": "v"}
QUOTIENT = {
    "(2)": ("h", lambda β, η, δ, **_: (
        (2 - η) * β * sin(β) - 2 * (1 - cos(β)) * fac(η, δ), 2 + η - (2 - η) * cos(β))),
    "(3)": ("h", lambda α, β, η, δ, **_: (
        (2 + η) * α * sin(α) - (2 - η) * β * sin(β) - 2 * (cos(β) - cos(α)) * fac(η, δ),
        (2 - η) * cos(β) - (2 + η) * cos(α))),
    "(4)": ("h", lambda α, η, δ, **_: (
        (2 + η) * α * sin(α) - 2 * fac(η, δ) * (1 - cos(α)), (1 - cos(α)) * (2 + η))),
    "(5)": ("h", lambda β, η, δ, **_: ((1 + β * cos(β) / sin(β)) * (2 - η) - 2 * fac(η, δ), 2 - η)),
    "(5) at beta_r -> 0": ("h", lambda η, δ, **_: (2 * (2 - η) - 2 * fac(η, δ), 2 - η)),
    "(17)": ("μ", lambda α, h, **_: (h * sin(α) - α * cos(α), h * cos(α) + α * sin(α))),
    "(18)": ("μ", lambda βs, h, **_: ((1 - h) * cos(βs) - βs * sin(βs), (1 - h) * sin(βs) + βs * cos(βs))),
}
quotient = lambda label, v: QUOTIENT[label][1](**v)


# The margins of the whole arch at a joint x, with their first and second derivatives.
def margin(name, order, x, v):
    h, p, η, δ, μ, y, c, s = *(v[name] for name in "h p η δ μ".split()), x - v["v"], cos(x), sin(x)
    N = (h * c + y * s, (1 - h) * s + y * c, (2 - h) * c - y * s)[order]
    T = (y * c - h * s, (1 - h) * c - y * s, (h - 2) * s - y * c)[order]
    M = (p + fac(η, δ) * (1 - c), fac(η, δ) * s, fac(η, δ) * c)[order]
    return {"E": (2 + η) * N / 2 - M, "I": M - (2 - η) * N / 2, "S": μ * N - T, "O": μ * N + T}[name]


MARGIN = {
    "E(b0) = 0": ("E", 0, lambda v: v["b0"]), "E'(b0) = 0": ("E", 1, lambda v: v["b0"]),
    "I(-b1) = 0": ("I", 0, lambda v: -v["β"]), "I'(-b1) = 0": ("I", 1, lambda v: -v["β"]),
    "O(alpha) = 0": ("O", 0, lambda v: v["α"]), "E(alpha) = 0": ("E", 0, lambda v: v["α"]),
    "O(-b2) = 0": ("O", 0, lambda v: -v["βs"]), "O'(-b2) = 0": ("O", 1, lambda v: -v["βs"]),
}
FITS = "(2 - eta) cos(b1 + alpha) = (2 + eta) cos(alpha - b0)"


def residual(label, v):
    if label in MARGIN:
        name, order, joint = MARGIN[label]
        return margin(name, order, joint(v), v)
    if label == FITS:
        return (2 - v["η"]) * cos(v["β"] + v["α"]) - (2 + v["η"]) * cos(v["α"] - v["b0"])
    if label == "beta_s^2 = h (1 - h)":
        return v["βs"] * v["βs"] - v["h"] * (1 - v["h"])
    if label == "d/d eta of (2) = (5)":
        v = {name: Dual(x, [1 if name == "η" else 0]) for name, x in v.items()}
        (n2, d2), (n5, d5) = quotient("(2)", v), quotient("(5)", v)
        return (n2 * d5 - n5 * d2).d[0]
    n, d = quotient(label, v)
    return d * v[QUOTIENT[label][0]] - n


# The claims: unknowns, equations, and what is fixed, as functions of the unknowns and for any precision.
ZERO, TWO, INFINITE = (lambda v: arb(0)), (lambda v: arb(2)), (lambda v: arb.pos_inf())
OVERTURNING = {"h": ZERO, "β": ZERO, "βs": ZERO, "μ": INFINITE}
LANDMARKS = {
    "T": ("half_opening, rotation_joint, sliding_joint, thickness, thrust, friction",
          "(2), (4), (5), (17), (18), beta_s^2 = h (1 - h)", {}),
    "S": ("half_opening, sliding_joint, thickness, thrust, friction",
          "(3), (5), (17), (18), beta_s^2 = h (1 - h)", {"β": lambda v: v["βs"]}),
    "J": ("half_opening, sliding_joint, thickness, thrust, friction",
          "(3), (5) at beta_r -> 0, (17), (18), beta_s^2 = h (1 - h)", {"β": ZERO}),
    "B": ("half_opening, sliding_joint, thrust, friction",
          "(3), (17), (18), beta_s^2 = h (1 - h)", {"β": ZERO, "η": TWO}),
    "l": ("half_opening, thickness", "(4), (5) at beta_r -> 0", OVERTURNING),
    "L": ("half_opening", "(4)", OVERTURNING | {"η": TWO}),
    "sb": ("half_opening, rotation_joint, thickness, thrust", "(2), (4), (5), d/d eta of (2) = (5)", {}),
}
MODES = {
    "[r,r,r]": ("rotation_joint, thickness, thrust", "(2), (4), (5)", {}),
    "[s,r,r]": ("rotation_joint, thickness, thrust", "(2), (5), (17)", {}),
    "[r,r,s]": ("rotation_joint, thickness, thrust, sliding_joint", "(3), (5), (18), beta_s^2 = h (1 - h)", {}),
    "[r,s,r]": ("rotation_joint, thickness, thrust, sliding_joint", "(3), (5), (18), beta_s^2 = h (1 - h)", {}),
    "[r,s]": ("thickness, thrust, sliding_joint", "(3), (18), beta_s^2 = h (1 - h)", {"β": ZERO}),
    "[r]": ("thickness", "(4)", {"h": ZERO, "β": ZERO}),
}
SLIDES = ("friction, thrust, sliding_joint", "(17), (18), beta_s^2 = h (1 - h)", {})
TOO_WIDE = ("half_opening, thrust, sliding_joint", "(3), (18), beta_s^2 = h (1 - h)", {"β": ZERO, "η": TWO})
STANDS = {"crown": ("", "", {"β": ZERO}), "haunch": ("rotation_joint", "(5)", {}), "shoulder": ("", "", {})}


# The kinds of asymmetric solutions: unknowns, equations, and the joints that give way.
WHOLE = "thrust, crown_moment, vertical_force, thickness, crown_hinge, rotation_joint"
COMMON = "E(b0) = 0, E'(b0) = 0, I(-b1) = 0, I'(-b1) = 0, O(alpha) = 0, "
SLIDES_OUT, CROWN_HINGE, HAUNCH_HINGE = (
    "slides outwards, right shoulder", "hinge at the extrados, right crown", "hinge at the intrados, left haunch")
ASYMMETRIC = {
    "inner_sliding": (WHOLE + ", sliding_joint", COMMON + "O(-b2) = 0, O'(-b2) = 0", {}),
    "shoulder_opening": (WHOLE, COMMON + "E(alpha) = 0", {}),
    "shoulder_sliding": (WHOLE, COMMON + FITS, {}),
}
CONTACTS = {
    "inner_sliding": [SLIDES_OUT, CROWN_HINGE, "slides inwards, left inner", HAUNCH_HINGE],
    "shoulder_opening": [SLIDES_OUT, "hinge at the extrados, right shoulder", CROWN_HINGE, HAUNCH_HINGE],
    "shoulder_sliding": [SLIDES_OUT, CROWN_HINGE, HAUNCH_HINGE],
}


def short_integer(text, limit, where):
    """An integer of at most eight digits, whatever its leading zeros, and at most `limit` in size."""
    parts = re.fullmatch(r"(-?)0*([0-9]{1,8})", text)
    need(parts and int(parts[2]) <= limit, f"{where}: too large an exponent")
    return int(parts[1] + parts[2])


def fields(thing, where, **types):
    need(type(thing) is dict and set(thing) == set(types), f"{where}: not an object with {', '.join(types)}")
    for name, kind in types.items():
        need(type(thing[name]) is kind, f"{where}: {name} is no {kind.__name__}")


def exact_ratio(text):
    parts = re.fullmatch(r"(2 atan )?([0-9]+)/([0-9]+)( pi)?", text)
    need(parts and max(len(parts[2]), len(parts[3])) <= MAX_GIVEN and fmpz(parts[3]) != 0
         and not (parts[1] and parts[4]), f"{text[:40]!a} is no exact number")
    ratio = lambda: arb(fmpz(parts[2])) / fmpz(parts[3])
    if parts[1]:
        return lambda v: 2 * ratio().atan()
    return lambda v: ratio() * (arb.pi() if parts[4] else 1)


def exact_friction(text):
    if text == "inf":
        return INFINITE
    if not text.startswith("tan "):
        return exact_ratio(text)
    angle = exact_ratio(text[4:])
    need(angle({}) < arb.pi() / 2, "claim: no acute friction angle")
    return lambda v: sin(angle(v)) / cos(angle(v))


KINDS = {"landmark": {}, "slides": {}, "too_wide": {}, "state": {"mode": str}, "too_thin": {"mode": str, "thickness": str},
         "stands": {"thickness": str, "thrust": str, "crown_moment": str, "nearest": str},
         "asymmetric": {"mode": str, "contacts": list}}


class Claim:
    def __init__(self, claim):
        kinds = [kind for kind in KINDS if kind in claim]
        need(len(kinds) == 1, "claim: not exactly one subject")
        self.kind, self.bits = kinds[0], 0
        fields(claim, "claim", weight=str, unknowns=list, equations=list,
               **{self.kind: str if self.kind == "landmark" else dict})
        thing, self.given = claim[self.kind], {}
        if self.kind == "landmark":
            self.name, subject = thing, LANDMARKS.get(thing)
        else:
            fields(thing, self.kind, half_opening=str, friction=str, **KINDS[self.kind])
            unlimited = thing["friction"] == "inf"
            self.given = {"α": exact_ratio(thing["half_opening"]), "μ": exact_friction(thing["friction"])}
            α = self.given["α"]({})
            need(0 < α and α < arb.pi(), "claim: half opening not between 0 and pi")
            self.name = thing.get("mode", self.kind)
            subject = self.subject(thing, unlimited)
        need(subject, "claim: no such subject")
        unknowns, equations, fixed = subject
        self.unknowns, self.equations = unknowns.split(", ") * bool(unknowns), equations.split(", ") * bool(equations)
        need(claim["unknowns"] == self.unknowns, "claim: not the unknowns of the subject")
        need(claim["equations"] == self.equations, "claim: not the equations of the subject")
        need(claim["weight"] in ("heyman", "milankovitch"), "claim: no such weight")
        self.weight, self.fixed = claim["weight"], fixed | self.given
        for name in self.unknowns:  # a limit is solved for, and compared with what is given
            self.fixed.pop(SYMBOL[name], None)

    def subject(self, thing, unlimited):
        if "mode" in thing:
            need(self.name == "[r,r,r]" or unlimited == (self.name == "[r]"), "claim: not the friction of the mode")
        if "thickness" in thing:
            η = self.given["η"] = exact_ratio(thing["thickness"])
            need(re.fullmatch("[0-9/]+", thing["thickness"]) and 0 < η({}) and η({}) <= 2, "claim: no thickness")
        if self.kind == "slides":
            need(not unlimited, "claim: unlimited friction that slides")
            return SLIDES
        if self.kind == "too_wide":
            return LANDMARKS["L"] if unlimited else TOO_WIDE
        if self.kind == "stands":
            h, self.p = (number(thing[name], LONG, "claim") for name in ("thrust", "crown_moment"))
            self.bits, self.nearest = max(bits_of(thing["thrust"]), bits_of(thing["crown_moment"])), thing["nearest"]
            self.given["h"] = lambda v: h
            return STANDS.get(self.nearest)
        if self.kind == "asymmetric":
            need(thing["contacts"] == CONTACTS.get(self.name), "claim: not the joints of the kind")
            return ASYMMETRIC.get(self.name)
        return MODES.get(self.name)

    def variables(self, x):
        v = {SYMBOL[name]: entry for name, entry in zip(self.unknowns, x, strict=True)}
        v["δ"] = 0 if self.weight == "heyman" else 1
        return v | {name: value(v) for name, value in self.fixed.items()}

    def beyond(self, symbol, v):
        """How far what is given is beyond the limit that the root is."""
        distance = self.given[symbol]({}) - v[symbol]
        return distance if symbol == "α" else -distance

    def residuals(self, x):
        return [residual(label, self.variables(x)) for label in self.equations]

    def jacobian(self, x):
        n = range(len(x))
        return [f.d for f in self.residuals([Dual(x[i], [int(i == j) for j in n]) for i in n])]


def number(text, bits, where):
    parts = type(text) is str and re.fullmatch(r"(-?)0x([0-9a-f]+)p(-?[0-9]+)", text)
    need(parts, f"{where}: no number")
    mantissa, exponent = int(parts[2], 16), short_integer(parts[3], MAX_EXPONENT, where)
    need(mantissa.bit_length() <= bits, f"{where}: too large a number")
    return arb((-mantissa if parts[1] else mantissa, exponent))  # exact, whatever the precision


def bits_of(text):
    """How many bits a number of the file has."""
    return int(re.fullmatch(r"-?0x([0-9a-f]+)p.*", text)[1], 16).bit_length()


class Box:
    def __init__(self, box, n, bits, where):
        fields(box, where, centre=list, radius=list)
        need(len(box["centre"]) == len(box["radius"]) == n, f"{where}: not of dimension {n}")
        self.centre = [number(x, bits, where) for x in box["centre"]]
        self.radius = [number(x, SHORT, where) for x in box["radius"]]
        need(all(r > 0 for r in self.radius), f"{where}: a radius is not positive")

    def ball(self):
        return [(m - r).union(m + r) for m, r in zip(self.centre, self.radius, strict=True)]

    def contracts(self, F, Y, M):
        """Does m - Y F + (I - Y M) (box - m) lie in the interior of the box, m its centre?"""
        r, n = self.radius, range(len(self.radius))
        move = [-sum(Y[i][j] * F[j] for j in n)
                + sum(((i == k) - sum(Y[i][j] * M[j][k] for j in n)) * (-r[k]).union(r[k]) for k in n) for i in n]
        return all(-r[i] < move[i] and move[i] < r[i] for i in n)


SHOULDER, INSIDE, CROWN = "mu - (17)", "mu - (18)", "fac - (2 - eta) (2 - h)/2"
ABOUT_EXTRADOS = {"(2 + eta) N(alpha)/2 - fac (1 - cos alpha) - (2 + eta) h/2",
                  "(2 + eta) h/2 - [(2 + eta) N(alpha)/2 - fac (1 - cos alpha)]"}
AT_LIMIT = {"2 - eta", "2 N(alpha) - (1 - cos alpha) (1 + delta/3)"}
# The modes that meet at a landmark, but for [s,s], and what is zero there by its equations.
MEET = {
    "T": ("[r,r,r] [s,r,r] [r,r,s]", {SHOULDER, INSIDE} | ABOUT_EXTRADOS),
    "S": ("[r,r,s] [r,s,r]", {SHOULDER, "the order of the joints"}),
    "J": ("[r,s,r] [r,s]", {SHOULDER, CROWN, "beta"}),
    "B": ("[r,s]", {SHOULDER} | AT_LIMIT),
    "l": ("[r,r,r] [r]", {"h", "beta", CROWN}),
    "L": ("[r]", AT_LIMIT),
    "sb": ("[r,r,r]", set()),
}


def landmark_signs(claim, v):
    """What has to be positive at a landmark: each unknown, what it lacks to its upper bound, and what its modes need."""
    bound = {"β": v["α"], "βs": v["α"], "η": 2, "h": 1}
    for name in claim.unknowns:
        yield name, v[SYMBOL[name]]
        if SYMBOL[name] in bound:
            yield f"upper bound - {name}", bound[SYMBOL[name]] - v[SYMBOL[name]]
    modes, zero = MEET[claim.name]
    if claim.name == "L" and v["δ"] == 1:
        zero = zero | {"W/2 + ..."}
    for mode in modes.split():
        yield from ((what, x) for what, x in state_signs(mode, {"μ": INFINITE({}), **v}) if what not in zero)


def state_signs(mode, v):
    """What has to be positive in a state."""
    α, β, η, h, μ, δ = (v[name] for name in ("α", "β", "η", "h", "μ", "δ"))
    inner_slides = mode in ("[r,r,s]", "[r,s,r]", "[r,s]")
    βs = v["βs"] if inner_slides else (h * (1 - h)).sqrt()
    N = h * cos(α) + α * sin(α)
    upper = (2 + η) * N / 2 - fac(η, δ) * (1 - cos(α))
    yield from [("N(alpha)", N), ("eta", η), ("2 - eta", 2 - η)]
    if μ.is_finite():
        yield "alpha - beta*", α - βs
    yield "2 N(alpha) - (1 - cos alpha) (1 + delta/3)", 2 * N - (1 - cos(α)) * (1 + arb(δ) / 3)
    if mode != "[r]":
        yield from [("h", h), ("1 - h", 1 - h)]
    if mode in ("[r,s]", "[r]"):  # no haunch hinge
        yield CROWN, fac(η, δ) - (2 - η) * (2 - h) / 2
    else:
        yield from [("beta", β), ("alpha - beta", α - β)]
    if mode == "[s,r,r]":
        yield "(2 + eta) N(alpha)/2 - fac (1 - cos alpha) - (2 + eta) h/2", upper - (2 + η) * h / 2
        yield "sin alpha - mu cos alpha", sin(α) - μ * cos(α)
    if mode in ("[r,r,s]", "[r,s,r]"):
        yield "(2 + eta) h/2 - [(2 + eta) N(alpha)/2 - fac (1 - cos alpha)]", (2 + η) * h / 2 - upper
        yield "the order of the joints", β - βs if mode == "[r,r,s]" else βs - β
    for label, slides in [("(17)", mode == "[s,r,r]"), ("(18)", inner_slides)]:
        if μ.is_finite() and not slides:
            n, d = quotient(label, {"α": α, "βs": βs, "h": h})
            yield f"mu - {label}", μ - n / d

    a1, a2 = ((2 + η) - (2 - η) * cos(β)) / 2, ((2 - η) * cos(β) - (2 + η) * cos(α)) / 2
    table = {"[r,r,r]": (1, 1 + a1 / a2, a1 / a2, a1 / a2), "[s,r,r]": (1, 1, 0, a1)}
    c, b, s, rate = table.get(mode, (0, 1, 1, a2))
    yield "the rate of the mechanism", rate
    slope, bounds = c + b * cos(β) + s * cos(α), [arb(0)]
    if not slope > 0:
        need(μ.is_finite(), "not shown to be positive: c + b cos beta + s cos alpha")
        yield "sin alpha - mu cos alpha", sin(α) - μ * cos(α)
        bounds.append(α * (cos(α) + μ * sin(α)) / (sin(α) - μ * cos(α)))
    for x in bounds:
        W = b * β * sin(β) + s * α * sin(α) + slope * x
        yield "W", W
        yield "W/2 + ...", W / 2 + δ * (η / 6) * (b * (1 - cos(β)) - s * (1 - cos(α)))


def standing_signs(claim, v):
    """What has to be positive for a line of thrust to be inside the arch, and for no joint to slide."""
    α, β, η, h, μ, δ, p = *(v.get(name) for name in ("α", "β", "η", "h", "μ", "δ")), claim.p
    N = lambda x: h * cos(x) + x * sin(x)
    L = lambda x: p + fac(η, δ) * (1 - cos(x)) - (2 - η) * N(x) / 2
    yield from [("h", h), ("1 - h", 1 - h), ("N(alpha)", N(α)), ("U(0)", (2 + η) * h / 2 - p),
                ("U(alpha)", (2 + η) * N(α) / 2 - p - fac(η, δ) * (1 - cos(α)))]
    if claim.nearest == "crown":
        yield from [("L(0)", L(arb(0))), ("fac - (2 - eta) (2 - h)/2", fac(η, δ) - (2 - η) * (2 - h) / 2)]
    elif claim.nearest == "haunch":
        yield from [("beta", β), ("alpha - beta", α - β), ("L(beta)", L(β))]
    else:
        yield from [("L(alpha)", L(α)),
                    ("-L'(alpha)", (2 - η) * ((1 - h) * sin(α) + α * cos(α)) / 2 - fac(η, δ) * sin(α))]
    if μ.is_finite():
        n, d = quotient("(17)", {"α": α, "h": h})
        yield "mu - (17)", μ - n / d
        βs = (h * (1 - h)).sqrt()
        inside, deepest = quotient("(18)", {"βs": βs, "h": h})
        yield "mu - the most inside", μ + n / d if βs > α else μ - inside / deepest


def verdict_signs(claim, v):
    """What has to be positive for the verdict to hold."""
    if claim.kind == "stands":
        yield from standing_signs(claim, v)
    elif claim.kind == "too_thin":
        yield from state_signs(claim.name, v)
        yield "least thickness - thickness", claim.beyond("η", v)
    else:
        if "βs" in map(SYMBOL.get, claim.unknowns):
            yield from [("beta_s", v["βs"]), ("alpha - beta_s", v["α"] - v["βs"])]
        if claim.kind == "slides":
            yield "N(alpha)", v["h"] * cos(v["α"]) + v["α"] * sin(v["α"])
            yield "purely sliding friction - friction", claim.beyond("μ", v)
        else:
            yield "half opening - widest half opening", claim.beyond("α", v)


def rates(kind, v):
    """The rates of the joints that give way, by their names, where the hinge next to the crown turns by one."""
    α, β, b0, outer, inner = v["α"], v["β"], v["b0"], (2 + v["η"]) / 2, (2 - v["η"]) / 2
    across, up = outer * cos(b0) - inner * cos(β), -outer * sin(b0) - inner * sin(β)
    if kind == "shoulder_sliding":
        return {"shoulder_slip": across / sin(α)}
    a, b, other = ((-sin(v["βs"]), cos(v["βs"]), "inner_slip") if kind == "inner_sliding" else
                   (inner * cos(β) - outer * cos(α), outer * sin(α) + inner * sin(β), "shoulder_opening"))
    det = sin(α) * b - a * cos(α)
    return {"shoulder_slip": (across * b - a * up) / det, other: (sin(α) * up - cos(α) * across) / det}


def asymmetric_signs(claim, v):
    """What has to be positive of an asymmetric solution besides the margins."""
    next_joint = v["βs"] if claim.name == "inner_sliding" else v["β"]
    yield from [("eta", v["η"]), ("2 - eta", 2 - v["η"]), ("v", v["v"]), ("alpha - b0", v["α"] - v["b0"]),
                ("the order of the hinges", v["b0"] + next_joint), ("alpha - b1", v["α"] - v["β"])]
    if claim.name == "inner_sliding":
        yield "b1 - b2", v["β"] - v["βs"]
    yield from rates(claim.name, v).items()


PIECE, LAST, FEW = 3, 30, 192  # pieces from 2^-3 to 2^-30; bits in which they are looked at


def nowhere_negative(name, v, touching, springing):
    """Is a margin nowhere negative on [-alpha, alpha], if it and its slope are zero at some joints, and it at alpha if
    `springing`?"""
    near = []
    around = lambda x, k: x + (-arb((1, -k))).union(arb((1, -k)))
    for x in touching:
        near += [y for y in (around(x, k) for k in range(2, 24)) if margin(name, 2, y, v) > 0][:1]
    if springing:
        near += [y for y in (around(v["α"], k) for k in range(2, 24)) if margin(name, 1, y, v) < 0][:1]
    if len(near) < len(touching) + springing:
        return False
    most = 4 << PIECE
    pieces = [(2 * i + 1 - most, PIECE) for i in range(most)]
    while pieces:
        m, k = pieces.pop()
        middle, offset = arb((m, -k)), around(arb(0), k)
        x = middle + offset
        least = lambda: (margin(name, 0, middle, v) + margin(name, 1, middle, v) * offset
                         + margin(name, 2, x, v) * offset * offset / 2)
        if x > v["α"] or x < -v["α"] or any(y.contains_interior(x) for y in near) or least() > 0:
            continue
        if k == LAST:
            return False
        pieces += [(2 * m - 1, k + 1), (2 * m + 1, k + 1)]
    return True


def admissible_everywhere(claim, v):
    """Is no margin negative on the whole arch?"""
    opens, slides = claim.name == "shoulder_opening", claim.name == "inner_sliding"
    joints = {"E": ([v["b0"]], opens), "I": ([-v["β"]], False), "S": ([], False), "O": ([-v["βs"]] if slides else [], True)}
    for name, (touching, springing) in joints.items():
        need(nowhere_negative(name, v, touching, springing), f"{name} is not shown to be nowhere negative")


def quantities(claim, v):
    kind = claim.kind
    q = {name: v[symbol] for name, symbol in SYMBOL.items() if symbol in v}
    if "friction" in q:
        q["friction_angle"] = q["friction"].atan() if q["friction"].is_finite() else arb.pi() / 2
    for name in q.keys() & {"half_opening", "friction_angle", "rotation_joint", "sliding_joint", "crown_hinge"}:
        q[name + "_degrees"] = 180 * q[name] / arb.pi()
    if "η" in v and "h" in v:
        q["intrinsic_thrust"] = v["η"] * v["h"]
    if kind not in ("landmark", "state"):  # only what is solved for
        solved = lambda name: any(name.startswith(unknown) for unknown in claim.unknowns)
        both = {"thickness", "thrust"} <= set(claim.unknowns)
        motion = {}
        if kind == "asymmetric":
            motion = rates(claim.name, v)
            N = lambda x: v["h"] * cos(x) + (x - v["v"]) * sin(x)
            taken = N(v["α"]) * motion["shoulder_slip"]
            if claim.name == "inner_sliding":
                taken += N(-v["βs"]) * motion["inner_slip"]
            motion["power"] = v["μ"] * taken
        return motion | {name: x for name, x in q.items() if (both if name == "intrinsic_thrust" else solved(name))}
    if kind != "landmark":  # what is given is not a result
        return {name: x for name, x in q.items() if name.split("_")[0] not in ("half", "friction")}
    q["A"] = v["α"] * sin(v["α"]) / (1 - cos(v["α"]))
    return q


def is_rounding(text, x, digits):
    """Is the text the correct rounding of every point of the ball x to so many significant digits?"""
    if text in ("0", "inf"):
        return x == (arb.pos_inf() if text == "inf" else 0)
    parts = re.fullmatch(r"(-?)(0|[1-9][0-9]*)(?:\.([0-9]+))?(?:e(-?[0-9]+))?", text)
    need(parts, f"{text[:40]!a} is no decimal number")
    behind, power = parts[3] or "", short_integer(parts[4] or "0", MAX_POWER, "values")
    mantissa, exponent = (parts[2] + behind).lstrip("0"), power - len(behind)
    if parts[3] is None:  # the zeros at the end of a whole number only show its size
        exponent += len(mantissa) - len(mantissa.rstrip("0"))
        mantissa = mantissa.rstrip("0")
    if not 1 <= len(mantissa) <= digits:
        return False
    value = fmpz(mantissa) * arb(10) ** exponent
    x = -x if parts[1] else x
    above = arb(10) ** (exponent + len(mantissa) - digits) / 2
    below = above / 10 if mantissa.rstrip("0") == "1" else above
    return value - below < x and x < value + above


def parse(data):
    def once(pairs):
        need(len(dict(pairs)) == len(pairs), "a field stands twice")
        need(all(type(x) is not list or len(x) <= (MAX_PARTS if name == "parts" else MAX_ENTRIES)
                 for name, x in pairs), "too long a list")
        return dict(pairs)

    try:  # NaN, Infinity and 1.0 become floats, and no field admits a float
        file = json.loads(data.decode("utf-8-sig"), object_pairs_hook=once)
        json.dumps(file, ensure_ascii=False).encode("utf-8")  # half of a surrogate pair cannot be written
        return file
    except (ValueError, RecursionError) as error:
        raise Refused(f"no JSON: {error}") from None


# Surveys: which arches decide the verdict on all of them. An exact number is its form and its fraction.
def exact(text):
    form = next((form for form in ("tan ", "2 atan ") if text.startswith(form)), "")
    if form == "tan ":
        return (form, *exact(text[4:]))
    exact_ratio(text)
    n, d = text.removeprefix(form).removesuffix(" pi").split("/")
    q = fmpq(fmpz(n), fmpz(d))
    if form and q == 1:
        return (" pi", q / 2)
    return (form + " pi" * text.endswith(" pi"), q)


def exact_grip(text):
    """A friction; an angle is known by its size. A right angle is written as `inf`."""
    exact_friction(text)
    return (text,) if text == "inf" else exact(text)


def length(text):
    parts = re.fullmatch("([0-9]{1,%d})/([0-9]{1,%d})" % (MAX_LENGTH, MAX_LENGTH), text)
    need(parts and int(parts[1]) > 0 and int(parts[2]) > 0, f"{text[:40]!a} is no length")
    return fmpq(int(parts[1]), int(parts[2]))


def ends(thing, read, where):
    need(type(thing) is list and len(thing) == 2 and all(type(x) is str for x in thing), f"{where}: not two ends")
    return [read(x) for x in thing]


def in_order(texts, read, value, where):
    """Two ends in their exact forms, the first not above the last."""
    first, last = ends(texts, read, where)
    if len(first) == len(last) > 1 and first[:-1] == last[:-1]:
        need(first[-1] <= last[-1], f"{where}: not in order")
    elif first != last:
        need(value(texts[0])({}) < value(texts[1])({}), f"{where}: not in order")
    return first, last


class Survey:
    def __init__(self, survey):
        self.free = type(survey) is dict and "free" in survey
        shape = "free" if self.free else "spanned"
        fields(survey, "survey", weight=str, friction=list, **{shape: dict})
        self.weight, thing = survey["weight"], survey[shape]
        self.friction = in_order(survey["friction"], exact_grip, exact_friction, "friction")
        if self.free:
            fields(thing, shape, half_opening=list, thickness=list)
            self.opening = in_order(thing["half_opening"], exact, exact_ratio, "half_opening")
            self.thickness = in_order(thing["thickness"], exact, exact_ratio, "thickness")
            for text in thing["half_opening"]:
                need(0 < exact_ratio(text)({}) and exact_ratio(text)({}) < arb.pi(), "half opening not between 0 and pi")
            need(all(form == "" and 0 < η <= 2 for form, η in self.thickness), "no thickness")
        else:
            fields(thing, shape, circle=str, span=list, rise=list, thickness=list)
            self.outwards = {"intrados": 1, "centreline": 0, "extrados": -1}.get(thing["circle"])
            need(self.outwards is not None, "no such circle")
            self.span, self.rise, self.thickness = (ends(thing[name], length, name) for name in ("span", "rise", "thickness"))
            need(all(a <= b for a, b in (self.span, self.rise, self.thickness)), "lengths not in order")
            half = self.span[0] / 2
            least = self.radius([self.span[0], min(max(half, self.rise[0]), self.rise[1])])
            most = {1: None, 0: 2 * least, -1: least}[self.outwards]
            need(most is None or self.thickness[1] <= most, "too thick for its circle")

    @staticmethod
    def radius(place):
        s, f = place
        return (s * s / 4 + f * f) / (2 * f)

    def course(self, side):
        (short, long), (low, high) = self.span, self.rise
        return [[long, low], [long, high] if side == "unsafe" else [short, low], [short, high]]

    def deciding(self, side, step):
        """Weight, half opening, friction and thickness of the arch that decides a step, or all."""
        unsafe = side == "unsafe"
        friction = self.friction[0 if unsafe else 1]
        if self.free:
            return self.weight, self.opening[1 if unsafe else 0], friction, self.thickness[0 if unsafe else 1][1]
        legs = zip(self.course(side), self.course(side)[1:])
        need(any(all(leg[0][i] <= step[0][i] <= step[1][i] <= leg[1][i] or leg[0][i] >= step[0][i] >= step[1][i] >= leg[1][i]
                     for i in (0, 1)) for leg in legs), "a step that is not on a leg of the course")
        radii, half = [self.radius(place) for place in step], step[0][0] / 2
        if unsafe:
            (s, f), t, R = step[1], self.thickness[0], max(radii)
        else:
            (s, f), t, R = step[0], self.thickness[1], min(radii)
            if step[0][0] == step[1][0] and step[0][1] < half < step[1][1]:
                R = half
        q = 2 * f / s
        opening = (" pi", q / 2) if q == 1 else ("2 atan ", q)
        return self.weight, opening, friction, t / (R + t * self.outwards / 2)


def check_survey(file):
    fields(file, "survey", schema=str, tool=str, survey=dict, verdict=str, parts=list)
    survey, verdict, parts = Survey(file["survey"]), file["verdict"], file["parts"]
    needed = {"all_stand": [("unsafe", True)], "none_stands": [("safe", False)],
              "both_occur": [("unsafe", False), ("safe", True)]}.get(verdict)
    need(needed, "no such verdict")
    covers = not survey.free and len(needed) == 1
    need(parts if covers else len(parts) == len(needed), "not the parts of the verdict")
    at = survey.course(needed[0][0])[0] if covers else None
    for (side, stands), part in zip(needed * (len(parts) if covers else 1), parts, strict=True):
        fields(part, "part", side=str, certificate=dict, **({} if survey.free else {"step": dict}))
        need(part["side"] == side, "a part on another side")
        step = None
        if not survey.free:
            fields(part["step"], "step", span=list, rise=list)
            step = [list(place) for place in zip(*(ends(part["step"][name], length, name) for name in ("span", "rise")))]
            need(step[0] == (at if covers else step[1]), "a gap in the course" if covers else "no single arch")
            at = step[1]
        expected = survey.deciding(side, step)
        check_certificate(part["certificate"])
        claim = part["certificate"]["claim"]
        kind = next(kind for kind in KINDS if kind in claim)
        need(kind in (["stands"] if stands else ["too_thin", "slides", "too_wide"]), f"a part that says {kind}")
        thing = claim[kind]
        η = exact(thing["thickness"])[1] if "thickness" in thing else expected[3]
        found = claim["weight"], exact(thing["half_opening"]), exact_grip(thing["friction"]), η
        need(found == expected, "a part of another arch than the one that decides")
    need(not covers or at == survey.course(needed[0][0])[2], "the course is not covered")
    return f"survey, {verdict}, {survey.weight}, by {len(parts)} certificates"


def check(data):
    ctx.prec = LONG + GUARD
    need(len(data) <= MAX_BYTES, "too large a file")
    file = parse(data)
    is_survey = type(file) is dict and file.get("schema") == "couplet.survey-certificate/1"
    return check_survey(file) if is_survey else check_certificate(file)


def check_certificate(file):
    ctx.prec = LONG + GUARD
    fields(file, "certificate", schema=str, tool=str, claim=dict, digits=int, unique=dict, inverse=list,
           root=dict, values=list)
    need(file["schema"] == "couplet.certificate/1", "another schema")
    claim, digits, Y = Claim(file["claim"]), file["digits"], file["inverse"]
    need(1 <= digits <= MAX_DIGITS, "not a possible number of digits")
    n = len(claim.unknowns)
    need(file["values"] or claim.kind == "stands", "no values")
    large = Box(file["unique"], n, LONG, "unique")
    small = Box(file["root"], n, LONG + 10 * digits // 3, "root")
    need(len(Y) == n and all(type(row) is list and len(row) == n for row in Y), "inverse: not n by n")
    Y = [[number(x, LONG, "inverse") for x in row] for row in Y]

    # Points 2, 3: exactly one root in the large box.
    ctx.prec = LONG + GUARD
    X = large.ball()
    for label in filter(QUOTIENT.get, claim.equations):
        _, d = quotient(label, claim.variables(X))
        need(d > 0 or d < 0, f"the denominator of {label} may vanish")
    M = claim.jacobian(X)
    need(large.contracts(claim.residuals(large.centre), Y, M), "no contraction of the large box")

    # Point 4: it lies in the small box. What its numbers do not have in bits no digit can be shown with.
    ctx.prec = max(LONG, claim.bits, *map(bits_of, file["root"]["centre"])) + GUARD
    need(all(abs(m1 - m) + r1 < r for m, r, m1, r1
             in zip(large.centre, large.radius, small.centre, small.radius)), "the small box is not in the large one")
    need(small.contracts(claim.residuals(small.centre), Y, M), "no contraction of the small box")

    # Point 5: signs.
    v = claim.variables(small.ball())
    need(v["α"] > 0 and v["α"] < arb.pi(), "half opening not between 0 and pi")
    signs = (landmark_signs(claim, v) if claim.kind == "landmark" else
             state_signs(claim.name, v) if claim.kind == "state" else
             asymmetric_signs(claim, v) if claim.kind == "asymmetric" else verdict_signs(claim, v))
    for name, value in signs:
        need(value > 0, f"not shown to be positive: {name}")
    if claim.kind == "asymmetric":
        with ctx.workprec(FEW):
            admissible_everywhere(claim, {name: +x for name, x in v.items()})

    # Point 6: decimals.
    known, seen = quantities(claim, v), set()
    for entry in file["values"]:
        fields(entry, "values", quantity=str, value=str)
        name = entry["quantity"]
        need(name in known and name not in seen, f"{name[:40]!a} is not known here or stands twice")
        need(is_rounding(entry["value"], known[name], digits), f"{name} is not shown to round so")
        seen.add(name)
    return f"{claim.kind} {claim.name}, {claim.weight}, {len(seen)} values to {digits} digits"


MEANS = "an admissible symmetric state exists"


def given(text):
    """An exact number, or a friction, as it is given."""
    if text == "inf" or text.startswith("tan "):
        return text if text == "inf" else "tan " + given(text[4:])
    numerator, denominator = map(fmpz, re.search("([0-9]+)/([0-9]+)", text).groups())
    if text.startswith("2 atan ") and numerator == denominator:
        return "1/2 pi"
    return "2 atan " * text.startswith("2 atan ") + f"{numerator}/{denominator}" + " pi" * text.endswith(" pi")


def statement(file):
    """What an accepted file proves, in a whole sentence."""
    if "survey" in file:
        survey = file["survey"]
        thing, says = survey.get("free") or survey["spanned"], {
            "all_stand": "every arch stands", "none_stands": "no arch stands", "both_occur": "one arch stands and one does not"}
        between = lambda range: " to ".join(given(x) for x in range)
        lowest = lambda x: f"{length(x).p}/{length(x).q}"
        metres = lambda name: f"{name} {' to '.join(lowest(x) for x in thing[name])} m"
        shape = (f"half opening {between(thing['half_opening'])}, thickness {between(thing['thickness'])}"
                 if "free" in survey else f"{metres('span')} and {metres('rise')} at the {thing['circle']}, {metres('thickness')}")
        return (f"all arches with {shape}, friction {between(survey['friction'])}, {survey['weight']} weight: "
                f"{says[file['verdict']]} ({MEANS})")
    claim = file["claim"]
    kind = next(kind for kind in KINDS if kind in claim)
    thing = claim[kind]
    if kind == "landmark":
        slides = thing in "TSJB"
        modes = (MEET[thing][0] + " [s,s]" * slides).split()
        subject, says = f"landmark {thing}", (
            f"its equations have a solution, the only one in the large box, that is a state of {', '.join(modes)}, admissible "
            "at every joint, and no thinner arch of its half opening and friction stands"
            + ", and none of its half opening with less friction" * slides)
    else:
        subject = f"half opening {given(thing['half_opening'])}, friction {given(thing['friction'])}"
        subject += f", thickness {given(thing['thickness'])}" if "thickness" in thing else ""
        says = {
            "state": lambda mode, **_: f"the arch stands ({MEANS}) exactly from a least thickness on, up to 2, and at the least "
                                       f"one it has a state of {mode}, the only solution of its equations in the large box",
            "too_thin": lambda mode, **_: f"the arch does not stand, as its least thickness, of {mode}, is larger",
            "slides": lambda **_: "the arch stands at no thickness, as its friction is below that of pure sliding",
            "too_wide": lambda **_: "the arch stands at no thickness up to 2, as its half opening is beyond a bound for its "
                                    "friction",
            "stands": lambda **_: f"the arch stands ({MEANS})",
            "asymmetric": lambda mode, **_: "the complementarity problem (19) of the whole arch has an asymmetric solution, "
                                            f"{mode}, admissible at every joint",
        }[kind](**thing)
    values = ", ".join(f"{entry['quantity']} = {entry['value']}" for entry in file["values"])
    plural = "" if file["digits"] == 1 else "s"
    there = f"; there {values}, each correctly rounded to {file['digits']} significant digit{plural}" if values else ""
    return f"{subject}, {claim['weight']} weight: {says}{there}"


def main(paths):
    whole = paths[:1] == ["--statement"]
    paths = paths[1:] if whole else paths
    if not paths:
        print("usage: check_with_arb.py [--statement] FILE...", file=sys.stderr)
        return 2
    status = 0
    for path in paths:
        name = ascii(path)[1:-1]  # one line, whatever is in it
        try:
            with open(path, "rb") as file:
                data = file.read(MAX_BYTES + 1)
            said = check(data)
            print(f"{name}: accepted {' ' + statement(parse(data)) if whole else said}", flush=True)
        except Refused as reason:
            print(f"{name}: refused: {reason}", flush=True)
            status = max(status, 1)
        except OSError as error:
            print(f"{name}: cannot be read: {error.strerror}", file=sys.stderr)
            status = 2
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""Which certificates the bundle has: the arches are drawn, listed and searched for by the program, the same each time.

Each is a request: a folder, a name, what lies there (the edge), and the words after `couplet` that make the file. Where the
rotational joint of [r,s,r] is as good as in the crown `couplet certify` finds no certificate, though `couplet state` proves the
state: of states there are some in reserve."""

import collections
import csv
import decimal
import itertools
import json
import pathlib
import subprocess

PROOFS = pathlib.Path(__file__).resolve().parent.parent
WEIGHTS = ("heyman", "milankovitch")
DIGITS = ("--digits", "30")
RESERVE = 40

Request = collections.namedtuple("Request", "folder name edge words")


class Program:
    """The program couplet."""

    def __init__(self, path):
        self.path = path

    def run(self, *words, given=None):
        """Exit code and standard output."""
        done = subprocess.run([self.path, *words], input=given, capture_output=True, text=True)
        if done.returncode not in (0, 1):
            raise SystemExit(f"couplet: {' '.join(words)}: {done.stderr.strip()}")
        return done.returncode, done.stdout

    def json(self, *words):
        return json.loads(self.run(*words, "--format", "json")[1])


def arch(kind, weight, half_opening, friction, *more):
    return ["certify", kind, "--weight", weight, "--half-opening", half_opening, "--friction", friction, *more, *DIGITS]


def by_turns(groups, count):
    """One of each group, one more of each, and so on, until there are as many as asked."""
    turns = itertools.zip_longest(*(groups[key] for key in sorted(groups)))
    return list(itertools.islice((one for turn in turns for one in turn if one), count))


def landmarks(program, folder):
    """All landmarks with both weights; `folder` is one to write into."""
    program.run("certify", "all", "--digits", "1", "--output", str(folder))
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        claim = json.loads(path.read_text())["claim"]
        words = ["certify", claim["landmark"], "--weight", claim["weight"], "--digits", "1000"]
        yield Request("landmarks", path.stem, f"landmark {claim['landmark']}", words)


def drawn(program, count):
    """Arches of `couplet sample`, ordinary ones and hard ones, with their states: those that stand at some thickness and
    those that do not."""
    stand, fall = collections.defaultdict(list), collections.defaultdict(list)
    for hard in (["--hard"], []):
        sample = program.run("sample", *hard, "--seed", "1", "--count", str(count), "--format", "csv")[1]
        family = {row["id"]: row.get("family", "ordinary") for row in csv.DictReader(sample.splitlines())}
        states = program.run("states", "-", "--keep", "id", "--quantity", "thickness", "--format", "csv", given=sample)[1]
        for row in csv.DictReader(states.splitlines()):
            row["family"] = family[row["id"]]
            if row["can_stand"] == "true":
                stand[row["family"], row["mode"], row["weight"]].append(row)
            elif row["can_stand"] == "false":
                fall[row["family"], row["reason"], row["weight"]].append(row)
    return stand, fall


def listed_states():
    """The arches that are stored in proofs/states."""
    for line in (PROOFS / "states/arches.txt").read_text().splitlines():
        name, weight, alpha, mu = line.split()
        yield Request("examples", name, "example", arch("state", weight, alpha, mu))


def states(stand, count):
    """Drawn arches that stand at some thickness: each family, mode and weight in turn."""
    for at, row in enumerate(by_turns(stand, count + RESERVE), 1):
        words = arch("state", row["weight"], row["half_opening"], row["friction"])
        yield Request("states", f"{at:04}", row["family"], words)


def verdicts(stand, fall, count):
    """Arches that stand at no thickness; others just below and just above their least thickness, and at the physical limit."""
    for at, row in enumerate(by_turns(fall, count), 1):
        words = arch("state", row["weight"], row["half_opening"], row["friction"])
        yield Request("verdicts", f"nowhere-{at:03}", row["family"], words)
    for at, row in enumerate(by_turns(stand, count), 1):
        least = decimal.Decimal(row["thickness"])
        for name, rounding in (("below", decimal.ROUND_FLOOR), ("above", decimal.ROUND_CEILING)):
            eta = decimal.Context(prec=12, rounding=rounding).plus(least)
            if eta != least and eta <= 2:
                words = arch("arch", row["weight"], row["half_opening"], row["friction"], "--thickness", str(eta))
                yield Request("verdicts", f"{name}-{at:03}", f"{row['family']}, {name} the least thickness", words)
        if at % 5 == 0:
            words = arch("arch", row["weight"], row["half_opening"], row["friction"], "--thickness", "2")
            yield Request("verdicts", f"limit-{at:03}", f"{row['family']}, at the limit", words)


def examples():
    for line in (PROOFS / "asymmetric/arches.txt").read_text().splitlines():
        yield tuple(line.split()[1:])


def searched(program):
    """Asymmetric solutions of (19) that are found on a grid."""
    openings, frictions = ("2.22", "2.25", "2.28", "2.31", "2.34", "2.37", "2.4"), [f"{mu / 100}" for mu in range(90, 125, 2)]
    kinds = ("inner_sliding", "shoulder_opening", "shoulder_sliding")
    for weight, alpha, mu, mode in itertools.product(WEIGHTS, openings, frictions, kinds):
        if program.run(*arch("asymmetric", weight, alpha, mu, "--mode", mode))[0] == 0:
            yield weight, alpha, mu, mode


def asymmetric(solutions, count):
    """Asymmetric solutions, each kind and weight in turn."""
    found = collections.defaultdict(list)
    for solution in solutions:
        found[solution[3], solution[0]].append(solution)
    for at, (weight, alpha, mu, mode) in enumerate(by_turns(found, count), 1):
        yield Request("asymmetric", f"{at:03}", mode, arch("asymmetric", weight, alpha, mu, "--mode", mode))


def surveys():
    """Verdicts on all arches between measured ends: each shape, circle, weight and verdict."""
    for line in (PROOFS / "surveys/arches.txt").read_text().splitlines():
        name, *words = line.split()
        yield Request("surveys", name, "example", ["certify", "survey", *words, "--digits", "10"])
    shapes = {
        "free": (["--half-opening", "75deg..80deg", "--friction", "0.5..0.6"], ("0.1..0.2", "0.01..0.02", "0.02..0.2")),
        **{circle: (["--span", "10m±5cm", "--rise", "3m±5cm", "--measured-at", circle, "--friction", "0.6..0.8"],
                    ("40cm..60cm", "3cm..5cm", "5cm..60cm")) for circle in ("intrados", "centreline", "extrados")},
    }
    for weight, (shape, (words, thicknesses)) in itertools.product(WEIGHTS, shapes.items()):
        for verdict, eta in zip(("all", "none", "both"), thicknesses):
            words_of = ["certify", "survey", "--weight", weight, *words, "--thickness", eta, "--digits", "10"]
            yield Request("surveys", f"{shape}-{weight}-{verdict}", shape, words_of)


def curves(program, count):
    """Points of each curve of the map. Where two modes meet, the arches on both sides of the friction, rounded down and up
    to 15 digits; along pure sliding, and where the thickness reaches 2, the certificate has the point itself."""
    for curve in program.json("map", "--weight", "both")["curves"]:
        name, nodes = curve["curve"], curve["nodes"]
        ends = sorted(nodes[end]["half_opening_lower"] for end in (0, -1))
        for weight, at in itertools.product([curve["weight"]] if curve["weight"] else WEIGHTS, range(1, count + 1)):
            alpha = f"{ends[0] + (ends[1] - ends[0]) * at / (count + 1):.6g}"
            of = f"{name.replace('/', '-')}-{weight}-{at}"
            point = lambda side, kind, friction, opening=alpha: Request(
                "curves", of + side, f"curve {name}", arch(kind, weight, opening, friction))
            if name in ("rotation", "overturning"):
                yield point("", "state", "inf")
            elif name == "sliding":
                yield point("", "state", "0")
            elif name == "limit":
                low = min(float(nodes[end]["friction_upper"]) for end in (0, -1))
                yield point("", "state", f"{low * (1 + at):.6g}", f"{ends[1] + 0.001:.6g}")
            else:
                found = program.json("find", "boundary", name, "--half-opening", alpha, "--weight", weight, "--digits", "15")
                yield point("-below", "state", found["friction"]["lower"])
                yield point("-above", "state", found["friction"]["upper"])


def requests(program, folder, few):
    """How many states there have to be, and requests for every certificate of the bundle, or for a few of each kind."""
    of = lambda many, some: some if few else many
    return of(1000, 20), list(requested(program, folder, of))


def requested(program, folder, of):
    stand, fall = drawn(program, of(5000, 100))
    yield from landmarks(program, folder)
    yield from listed_states()
    yield from states(stand, of(1000, 20))
    yield from verdicts(stand, fall, of(100, 4))
    yield from asymmetric(itertools.chain(examples(), of(searched(program), ())), of(60, 6))
    yield from itertools.islice(surveys(), of(None, 4))
    yield from curves(program, of(5, 1))


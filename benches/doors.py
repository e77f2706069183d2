#!/usr/bin/env python3
"""What a row costs at each door: processor time of the same arches as text, as Parquet, swept, judged, and in Python.

    python benches/doors.py [--rows 1e5] [--turns 5] target/release/couplet

Prints microseconds of one thread a row, the least of some turns in which every door is asked once, without what it takes a
command to start; and the time over that of arrays with the same question. The last table has arches that rotate beside
Newton's method in NumPy, and in numba if it is installed, with start values from a fit: unproved, to about 2e-12.
"""

import argparse
import os
import resource
import shutil
import subprocess
import tempfile
import time

import numpy as np

import couplet

STATE = ("thickness", "thrust", "intrinsic_thrust", "rotation_joint", "sliding_joint", "sliding_friction", "rotational_friction")
ASSESSMENT = ("least_thickness", "geometric_safety", "required_friction", "friction_safety", "least_thrust", "largest_thrust")


def table(columns, rows):
    """A table of text, with as many digits as tell a double."""
    cells = zip(*(column[:rows].tolist() for column in columns.values()))
    return "\n".join([",".join(columns), *(",".join(map(repr, row)) for row in cells), ""])


class Command:
    """What a command takes for each row of a file: the time for all of them less that for one."""

    def __init__(self, arguments, rows, files):
        self.arguments, self.rows, self.files = arguments, rows, files

    def __call__(self):
        return (self.run(0) - self.run(1)) / (self.rows - 1)

    def run(self, which):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([of.format(file=self.files[which]) for of in self.arguments], capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        assert done.returncode in (0, 1) and (done.stdout or self.arguments[1] == "sweep"), done.stderr
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def call(rows, work):
    """What a call in this process takes for each row."""

    def timed():
        start = time.process_time()
        work()
        return (time.process_time() - start) / rows

    return timed


def newton(steps):
    """The least thickness of arches of Milankovitch's weight that rotate, by Newton's method from a fit."""
    alpha = 1.3 + 1.1 * np.cos((np.arange(200) + 0.5) / 200 * np.pi)
    known = couplet.states(alpha, np.inf, quantities=["thickness", "rotation_joint"])
    fit = lambda name: np.polynomial.Chebyshev.fit(alpha, known[name], 10).convert(kind=np.polynomial.Polynomial).coef[::-1].copy()
    of_beta, of_eta = fit("rotation_joint"), fit("thickness")

    def least(alpha):
        beta, eta = 0 * alpha, 0 * alpha
        for power in range(11):
            beta, eta = beta * alpha + of_beta[power], eta * alpha + of_eta[power]
        cot = alpha / np.tan(alpha / 2)
        for _ in range(steps):
            s, c = np.sin(beta), np.cos(beta)
            fac, inner, outer = 1 + eta * eta / 12, 1 - eta / 2, 1 + eta / 2
            thrust = cot - fac / outer
            slope = (fac / 2 - eta / 6 * outer) / (outer * outer)
            arm, side = inner * thrust, s + beta * c
            # Moment about the hinge, whose derivative by the joint is the tangency.
            moment = inner * beta * s - fac * (1 - c) - thrust * (outer - inner * c)
            touch = inner * side - (fac + arm) * s
            by_eta = -beta * s / 2 - eta / 6 * (1 - c) - slope * (outer - inner * c) - thrust * (1 + c) / 2
            touch_beta = inner * (2 * c - beta * s) - (fac + arm) * c
            touch_eta = -side / 2 - (eta / 6 + inner * slope - thrust / 2) * s
            determinant = touch * touch_eta - by_eta * touch_beta
            beta = beta - (moment * touch_eta - by_eta * touch) / determinant
            eta = eta - (touch * touch - touch_beta * moment) / determinant
        return eta

    return least


def of_numba(rows):
    """The same in numba, where it is installed."""
    try:
        import numba
    except ImportError:
        return None
    fast = numba.vectorize(["f8(f8)"])(newton(2))
    fast(rows)
    return fast


def least_times(doors, turns):
    times = {name: [] for name in doors}
    for _ in range(turns):
        for name, door in doors.items():
            times[name].append(door())
    return {name: 1e6 * min(all_of) for name, all_of in times.items()}


def told(times, beside):
    for name, (time, over) in {name: (time, time / times[beside(name)]) for name, time in times.items()}.items():
        print(f"| {' | '.join(name)} | {time:.2f} | {over:.1f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", type=float, default=1e5)
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("couplet")
    asked = parser.parse_args()
    rows = int(asked.rows)
    part = lambda step: np.arange(1, rows + 1) * step % 1
    arches = {"half_opening": 2.648 * part(0.754877666), "friction": 5 * part(0.569840291)}
    thick = {**arches, "thickness": 1.2 * part(0.618033988) + 1e-3}
    folder = tempfile.mkdtemp()
    doors = {}

    def door(name, of, question, answer, number=rows):
        doors[name, "with a thickness" if of is thick else "state", question] = call(number, answer)

    def command(name, question, arguments, of, text=None):
        files = []
        for number in (rows, 1):
            path = os.path.join(folder, f"{len(doors)}-{number}.csv")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text(number) if text else table(of, number))
            files.append(path)
        whole = [asked.couplet, *arguments, "--threads", "1"]
        doors[name, "with a thickness" if of is thick else "state", question] = Command(whole, rows, files)

    for of, quantities in ((arches, STATE), (thick, ASSESSMENT)):
        usual = "geometric_safety" if of is thick else "thickness"
        arrays = list(of.values())
        for question, names in (("one", [usual]), ("all", list(quantities))):
            some = ["--quantity", usual] if question == "one" else []
            door("arrays of Python, `states`", of, question, lambda arrays=arrays, names=names: couplet.states(*arrays, quantities=names, threads=1))
            named = {**dict(zip(of, of)), "quantities": names}
            door("`add_states`", of, question, lambda of=of, named=named: couplet.add_states(of, **named))
            for form in ("csv", "jsonl", "parquet"):
                command(f"`states` of CSV, {form}", question, ["states", "{file}", "--format", form, *some], of)
        few = [{name: float(column[row]) for name, column in of.items()} for row in range(200)]
        ask = couplet.assess if of is thick else couplet.state
        door("one row, of Python", of, "all", lambda few=few, ask=ask: [ask(**row, digits=17) for row in few], len(few))
    plan = lambda number: (
        f'schema = "couplet.sweep/1"\nquantities = ["thickness"]\n[data]\nfiles = "{folder}/rows-{number}.csv"\n'
    )
    for number in (rows, 1):
        with open(f"{folder}/rows-{number}.csv", "w", encoding="utf-8") as file:
            file.write(table(arches, number))
    command("`sweep` of CSV", "one", ["sweep", "{file}", "-o", folder + "/swept"], arches, plan)
    swept = doors["`sweep` of CSV", "state", "one"]
    doors["`sweep` of CSV", "state", "one"] = lambda: (shutil.rmtree(folder + "/swept", ignore_errors=True), swept())[1]
    results = couplet.states(*arches.values(), quantities=STATE)
    claims = {**arches, **{name: results[name] for name in STATE}}
    claims = {name: column[results["verdict"] == 0] for name, column in claims.items()}
    stand = len(claims["friction"])
    some = min(stand, 10_000)
    files = []
    for number in (some, 1):
        files.append(f"{folder}/claims-{number}.csv")
        with open(files[-1], "w", encoding="utf-8") as file:
            file.write(table(claims, number).replace("nan", ""))
    whole = [asked.couplet, "judge", "{file}", "--threads", "1", "--format", "csv"]
    doors["`judge` of seven numbers", "state", "all"] = Command(whole, some, files)
    print("| door | question | quantities | µs a row | over arrays |\n|---|---|---|--:|--:|")
    told(least_times(doors, asked.turns), lambda name: ("arrays of Python, `states`", *name[1:]))

    alpha = 0.3 + 2.0 * part(0.754877666)
    proved = couplet.states(alpha, np.inf)["thickness"]
    fast = of_numba(alpha)
    doors = {("proved",): call(rows, lambda: couplet.states(alpha, np.inf, threads=1))}
    for steps in (2, 3):
        least = newton(steps)
        assert np.allclose(least(alpha), proved, rtol=1e-9, atol=0), "it converges"
        doors[f"NumPy, {steps} steps",] = call(rows, lambda least=least: [least(some) for some in np.array_split(alpha, 1 + rows // 4096)])
    if fast:
        doors["numba, 2 steps",] = call(rows, lambda: fast(alpha))
    print("\n| arches that rotate | µs a row | over NumPy |\n|---|--:|--:|")
    told(least_times(doors, asked.turns), lambda name: ("NumPy, 2 steps",))
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""What `couplet.add_states` costs inside engines: processor time beside the bare library and the engine's own copy.

    python benches/engines.py [--rows 1e7] [--mixed] [--turns 3] [--degrees] [--files 100] [polars] [ray]

Prints, of each engine, the processor seconds (user and system, all processes) of `couplet.states` over the same arrays, of a map
that hands every batch on, and of the map with states; and the last over the sum of the first two. Engines that are not installed
are left out. `--degrees` compares a column of degrees, whose numbers are exact, with one of radians instead. `--files N` asks polars
whether the arches of N files of a million rows stand, from Parquet to Parquet, and prints seconds, memory and bytes instead.
"""

import argparse
import glob
import os
import resource
import tempfile
import time
from importlib.util import find_spec

import numpy as np

import couplet

COLUMNS = {"half_opening": "alpha", "friction": "mu"}
PIECES = 40


def processor(root):
    """Processor seconds of a process and of all below it, those that have ended included."""
    seconds, parents = {}, {}
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/stat", encoding="utf-8", errors="replace") as file:
                fields = file.read().rpartition(")")[2].split()
        except OSError:
            continue
        parents[int(name)] = int(fields[1])
        seconds[int(name)] = sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")
    total = 0.0
    for process in seconds:
        above = process
        while above not in (root, 0, 1) and above in parents:
            above = parents[above]
        total += seconds[process] if above == root else 0.0
    return total


def timed(work):
    start = processor(os.getpid())
    work()
    return processor(os.getpid()) - start


def arches(rows, mixed):
    random = np.random.default_rng(1)
    if mixed:
        return random.uniform(0.05, 2.9, rows), random.uniform(0.01, 2.5, rows)
    # They collapse by rotation alone, which is proved fastest.
    return random.uniform(0.2, 2.3, rows), random.uniform(1.5, 3, rows)


def same(batch):
    return batch


def polars_works(alpha, mu):
    os.environ["POLARS_MAX_THREADS"] = "1"
    import polars

    frame = polars.DataFrame({"alpha": alpha, "mu": mu})

    def plan(of):
        return frame.lazy().map_batches(of, streamable=True).collect(engine="in-memory")

    bare = lambda: couplet.states(alpha, mu, threads=1)
    return bare, lambda: plan(lambda batch: batch.clone()), lambda: couplet.add_states(frame.lazy(), **COLUMNS).collect()


def ray_works(alpha, mu):
    os.environ.update(RAY_USAGE_STATS_ENABLED="0", RAY_DATA_DISABLE_PROGRESS_BARS="1")
    import pyarrow
    import ray

    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    data = ray.data.from_arrow(pyarrow.table({"alpha": alpha, "mu": mu})).repartition(PIECES).materialize()
    halves = [(ray.put(alpha[half::2].copy()), ray.put(mu[half::2].copy())) for half in (0, 1)]

    @ray.remote(num_cpus=1)
    def states(alpha, mu):
        for half in np.array_split(np.arange(len(alpha)), PIECES // 2):
            couplet.states(alpha[half[0] : half[-1] + 1], mu[half[0] : half[-1] + 1], threads=1)

    bare = lambda: ray.get([states.remote(*half) for half in halves])
    of = lambda work, **named: data.map_batches(work, batch_format="pyarrow", batch_size=None, **named).materialize()
    return bare, lambda: of(same), lambda: of(couplet.add_states, fn_kwargs=COLUMNS)


def from_files(count):
    """Answers arches with thicknesses of 0.001 to 2, half of them thick enough, from files to a file."""
    os.environ["POLARS_MAX_THREADS"] = "2"
    import polars

    with tempfile.TemporaryDirectory() as folder:
        random = np.random.default_rng(1)
        for name in range(count):
            alpha, mu = random.uniform(0.05, 2.9, 10**6), random.uniform(0.01, 2.5, 10**6)
            frame = polars.DataFrame({"alpha": alpha, "mu": mu, "eta": 10 ** random.uniform(-3, 0.3, 10**6)})
            frame.write_parquet(f"{folder}/{name}.parquet")
        start, before = time.time(), sum(resource.getrusage(resource.RUSAGE_SELF)[:2])
        read = polars.scan_parquet(f"{folder}/*.parquet")
        table = couplet.add_states(read, **COLUMNS, thickness="eta", quantities=["geometric_safety", "least_thickness"])
        table.sink_parquet(f"{folder}/answered", engine="streaming")
        used, clock = resource.getrusage(resource.RUSAGE_SELF), time.time() - start
        verdicts = polars.scan_parquet(f"{folder}/answered").group_by("verdict").len().collect(engine="streaming")
        given = sum(map(os.path.getsize, glob.glob(f"{folder}/*.parquet")))
        print(dict(verdicts.iter_rows()), f"of {count} million rows: {sum(used[:2]) - before:.0f} s of the processor, {clock:.0f} s on the clock,")
        print(f"{used.ru_maxrss / 1024:.0f} MB of memory, {given / 1e6:.0f} MB read, {os.path.getsize(folder + '/answered') / 1e6:.0f} MB written")


def main():
    reader = argparse.ArgumentParser()
    reader.add_argument("engines", nargs="*")
    reader.add_argument("--rows", type=float, default=1e7)
    reader.add_argument("--turns", type=int, default=3)
    reader.add_argument("--mixed", action="store_true")
    reader.add_argument("--degrees", action="store_true")
    reader.add_argument("--files", type=int)
    asked = reader.parse_args()
    if asked.files:
        from_files(asked.files)
        return
    alpha, mu = arches(int(asked.rows), asked.mixed)
    for _ in range(asked.turns if asked.degrees else 0):
        radians = timed(lambda: couplet.add_states({"alpha": alpha, "mu": mu}, **COLUMNS))
        degrees = timed(lambda: couplet.add_states({"alpha": np.rad2deg(alpha), "mu": mu}, half_opening="alpha:deg", friction="mu"))
        print(f"radians {radians:.2f} s, degrees {degrees:.2f} s: {degrees / radians:.1f}", flush=True)
    if asked.degrees:
        return
    for name, works in (("polars", polars_works), ("ray", ray_works)):
        if find_spec(name) is None or asked.engines and name not in asked.engines:
            continue
        works = works(alpha, mu)
        [work() for work in works[1:]]
        for _ in range(asked.turns):
            bare, copy, states = map(timed, works)
            print(f"{name}: states {bare:.2f} s, the same batches {copy:.2f} s, add_states {states:.2f} s: {states / (bare + copy):.3f}", flush=True)


if __name__ == "__main__":
    main()

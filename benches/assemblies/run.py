"""Asks programs the questions of `couplet sample --assemblies`, and prints how many each gets right.

    couplet sample --assemblies --format json -o assemblies.json
    python benches/assemblies/run.py assemblies.json [READER ...] [--limit SECONDS] [--answers FOLDER]
"""

import argparse
import csv
import importlib
import multiprocessing
import os
import pathlib
import resource
import signal

import assembly

READERS = ["highs", "rbe", "cra", "lmgc90", "rapier_", "box2d_", "chipmunk", "mujoco_"]


def asked(reader, question, limit):
    """Answer of one reader to one question, in a process of its own, with its processor time, s."""
    here, there = multiprocessing.Pipe(duplex=False)
    process = multiprocessing.Process(target=answer, args=(reader, question, limit, there))
    process.start()
    # Its own end alone keeps the pipe open.
    there.close()
    try:
        found = here.recv()
    except EOFError:
        found = None
    process.join()
    # Without an answer it was ended at the limit, or by its own fault.
    return found or (None, limit if process.exitcode == -signal.SIGKILL else 0.0)


def answer(reader, question, limit, pipe):
    resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
    # Programs speak of themselves.
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    module = importlib.import_module(reader)
    begun = sum(os.times()[:4])
    found = module.stands(question)
    pipe.send((found, sum(os.times()[:4]) - begun))


def answers(reader, questions, arguments):
    for question in questions:
        verdict, seconds = asked(reader, question, arguments.limit)
        yield question.id, question.mode, question.stands, verdict, f"{seconds:.3f}"


def keep(reader, rows, folder):
    """Writes the answers so far, if they are kept."""
    if folder:
        folder.mkdir(parents=True, exist_ok=True)
        with open(folder / f"{reader}.csv", "w", newline="") as file:
            csv.writer(file).writerows([("id", "mode", "stands", "answer", "seconds"), *rows])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("questions")
    parser.add_argument("readers", nargs="*", default=READERS)
    parser.add_argument("--limit", type=int, default=60, help="processor seconds after which a question stays open")
    parser.add_argument("--answers", type=pathlib.Path, help="a folder for each answer, a CSV a reader")
    arguments = parser.parse_args()
    questions = assembly.read(arguments.questions)
    print("| program | version | right | unsafe | safe | undecided | processor s a question |")
    print("|---|---|---|---|---|---|---|")
    for reader in arguments.readers:
        module = importlib.import_module(reader)
        rows = []
        for row in answers(reader, questions, arguments):
            rows.append(row)
            keep(reader, rows, arguments.answers)
        count = lambda stands, verdict: sum(row[2] == stands and row[3] == verdict for row in rows)
        right = count(True, True) + count(False, False)
        told = [right, count(False, True), count(True, False), sum(row[3] is None for row in rows)]
        seconds = sum(float(row[4]) for row in rows) / len(rows)
        print("| " + " | ".join(map(str, [module.NAME, module.version(), *told, f"{seconds:.2g}"])) + " |", flush=True)
    for reader in arguments.readers:
        module = importlib.import_module(reader)
        print(f"{module.NAME}: {module.RULE}")


if __name__ == "__main__":
    main()

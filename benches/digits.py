#!/usr/bin/env python3
"""Digits against time of every question that has digits: a table on standard output, and a figure.

Whole commands, one thread, processor time beyond that of `--version`, the least of some runs in turns; a question that
takes longer than PATIENCE is not asked for more digits.

    benches/digits.py [PROGRAM] [FIGURE.svg] [DIGITS ...]
"""

import math
import pathlib
import resource
import subprocess
import sys

QUESTIONS = [
    ("landmark T", "constants T --weight milankovitch"),
    ("state", "state --half-opening 80deg --friction 0.6"),
    ("assess", "assess --half-opening 80deg --friction 0.6 --thickness 0.3"),
    ("assess, tilted", "assess --half-opening pi/2 --friction inf --thickness 0.15 --tilt 0.1"),
    ("state, in metres", "state --span 8m --rise 3.1m --friction 0.6"),
    ("state by its joint", "state --rotation-joint 57deg --friction 0.6"),
    ("survey", "assess --half-opening 80deg..81deg --friction 0.35..0.36 --thickness 0.12..0.13"),
    ("survey in metres", "assess --span 8m..8.1m --rise 3.1m..3.2m --friction 0.35 --thickness 60cm"),
    ("find half opening", "find half-opening --friction 0.6"),
    ("find boundary", "find boundary rrs/rsr --friction 1.6"),
    ("point of a curve", "map point rotation --at 1.0"),
    ("equation (7)", "equation 7 --rotation-joint 1 --weight milankovitch"),
    ("10 stones", "voussoirs --half-opening pi/2 --friction 0.6 --stones 10"),
    ("10 stones, tilted", "voussoirs --half-opening pi/2 --friction 0.4 --thickness 0.15 --stones 10 --tilt 0.05"),
    ("(19), 8 stones", "complementarity --half-opening 2.3 --friction 1.05 --stones 8"),
    ("certificate of T", "certify T --weight milankovitch"),
]
DIGITS = [30, 100, 1_000, 10_000, 100_000]
PATIENCE = 60.0


def seconds(program, question):
    """Processor time of a run, or nothing if it takes too long or fails."""
    before = spent()
    try:
        done = subprocess.run([program, *question.split(), "--threads", "1"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return None
    return spent() - before if done.returncode == 0 else None


def spent():
    """Processor time of all runs."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measured(program, sizes):
    """Seconds by question and digits."""
    empty = min(seconds(program, "--version") for _ in range(20))
    found = {name: {} for name, _ in QUESTIONS}
    for digits in sizes:
        runs = {30: 15, 100: 15, 1_000: 7, 10_000: 3}.get(digits, 1)
        for _ in range(runs):
            for name, question in QUESTIONS:
                if digits > sizes[0] and not found[name].get(sizes[sizes.index(digits) - 1]):
                    continue
                time = seconds(program, f"{question} --digits {digits}")
                if time is not None:
                    found[name][digits] = min(found[name].get(digits, math.inf), max(time - empty, 1e-4))
    return found


def table(found, sizes):
    print("| question | " + " | ".join(f"{digits:,}" for digits in sizes) + " |")
    print("|---|" + "---:|" * len(sizes))
    for name, times in found.items():
        shown = (f"{times[digits] * 1e3:.1f}" if digits in times else "" for digits in sizes)
        print(f"| {name} | " + " | ".join(shown) + " |")


def figure(found, sizes, path):
    """Both axes are logarithmic; a line is named at its end, where names have room."""
    width, height, left, right, top, bottom = 760, 460, 64, 170, 36, 48
    all_times = [time for times in found.values() for time in times.values()]
    low, high = math.floor(math.log10(min(all_times))), math.ceil(math.log10(max(all_times)))
    first, last = math.log10(sizes[0]), math.log10(sizes[-1])

    def x(digits):
        return left + (math.log10(digits) - first) / (last - first) * (width - left - right)

    def y(time):
        return height - bottom - (math.log10(time) - low) / (high - low) * (height - top - bottom)

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
        f'<text x="{left}" y="20" font-size="14">Processor time of a command by its digits, one thread</text>',
    ]
    for power in range(low, high + 1):
        at = y(10**power)
        parts.append(f'<path d="M{left} {at:.1f}H{width - right}" stroke="#ccc"/>')
        parts.append(f'<text x="{left - 6}" y="{at + 4:.1f}" text-anchor="end">{10**power:g} s</text>')
    for digits in sizes:
        parts.append(f'<path d="M{x(digits):.1f} {top}V{height - bottom}" stroke="#ccc"/>')
        parts.append(f'<text x="{x(digits):.1f}" y="{height - bottom + 18}" text-anchor="middle">{digits:,}</text>')
    parts.append(f'<text x="{(left + width - right) / 2}" y="{height - 8}" text-anchor="middle">significant digits</text>')
    dashes = ["", "7 3", "2 3", "9 3 2 3"]
    ends = sorted((y(times[max(times)]), name) for name, times in found.items() if times)
    room, labels = 14.0, {}
    lowest = -math.inf
    for at, name in ends:
        lowest = max(at, lowest + room)
        labels[name] = lowest
    for number, (name, times) in enumerate(found.items()):
        if not times:
            continue
        points = " ".join(f"{x(digits):.1f},{y(time):.1f}" for digits, time in sorted(times.items()))
        grey = ["#000", "#444", "#777", "#aaa"][number // len(dashes)]
        thick = 2.6 if number == 0 else 1.4
        parts.append(f'<polyline points="{points}" fill="none" stroke="{grey}" stroke-width="{thick}" stroke-dasharray="{dashes[number % 4]}"/>')
        end, at = x(max(times)), labels[name]
        parts.append(f'<path d="M{end + 2:.1f} {y(times[max(times)]):.1f}L{width - right + 14} {at:.1f}" stroke="{grey}" stroke-width="0.6"/>')
        parts.append(f'<text x="{width - right + 18}" y="{at + 4:.1f}" fill="{grey}">{name}</text>')
    parts.append("</svg>\n")
    pathlib.Path(path).write_text("\n".join(parts))


def main():
    arguments = sys.argv[1:]
    program = arguments[0] if arguments else "target/release/couplet"
    path = arguments[1] if len(arguments) > 1 else "benches/digits.svg"
    sizes = [int(digits) for digits in arguments[2:]] or DIGITS
    found = measured(program, sizes)
    table(found, sizes)
    figure(found, sizes, path)


main()

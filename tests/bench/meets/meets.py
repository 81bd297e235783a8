#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Where surfaces meet, by this library, SISL and Open CASCADE: one table, all of it measured in the same run, by turns.

    meets.py PROGRAMS [--passes N] [--limit SECONDS]

PROGRAMS is the folder of bench_meets_nurbs, and of those for SISL and Open CASCADE that were built. Each meet is that of a process of
its own, in one thread, of surfaces with nothing kept from other calls; times are milliseconds of process time, the best of all
runs. "Off" is the largest distance of a sample of the curves in space from the true ones; what ours proves is behind it.
Ours and SISL make curves in both domains, too. What does not find all curves is told so, with the length that it finds, in parts of
the true one. The exit status is 1 if ours are not the true curves to within the tolerance, proven to be all.
"""

import argparse
import json
import pathlib
import subprocess
import sys

LIBRARIES = {"libnurbs": "bench_meets_nurbs", "Open CASCADE": "bench_meets_occt", "SISL": "bench_meets_sisl"}
PAIRS = {"six": ("six curves, far from each other", ["1e-4", "1e-6"], 5),
         "near": ("six curves, two side by side each, at small angles", ["1e-6"], 12)}


def one(program, pair, tolerance, limit):
    """What a program tells; a text where it fails."""
    try:
        run = subprocess.run([program, pair, tolerance], capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return f"over {limit} s"
    return json.loads(run.stdout.splitlines()[-1]) if run.returncode == 0 else "fails"


def best(runs):
    told = [run for run in runs if not isinstance(run, str)]
    return min(told, key=lambda run: run["ms"]) if told else runs[0] if runs else "–"


def is_right(run):
    return run["curves"] == run["true_curves"] and abs(run["length"] / run["true_length"] - 1) < 1e-4


def cell(run):
    if isinstance(run, str):
        return run
    wrong = "" if is_right(run) else f", {run['curves']} curves, {run['length'] / run['true_length']:.3g} of the length"
    proven = f" (proven {run['proven']:.1e})" if run["proven"] >= 0 else ""
    return f"{run['ms']:.3g}, off {run['off']:.1e}{proven}{wrong}"


def ratio(ours, others):
    times = [run["ms"] for run in others if not isinstance(run, str) and is_right(run)]
    return f"{min(times) / ours['ms']:.2g}" if times and not isinstance(ours, str) else "–"


def wrong(title, tolerance, run):
    """What is not right about our own meet."""
    if isinstance(run, str):
        return [f"{title}: {run}"]
    found = [] if is_right(run) else [f"{title}: {run['curves']} curves of length {run['length']}"]
    found += [] if 0 <= run["proven"] <= float(tolerance) else [f"{title}: not proven to {tolerance}"]
    return found + ([] if run["off"] <= 2 * abs(run["proven"]) + 1e-14 else [f"{title}: off by {run['off']}"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--passes", type=int, default=3)
    parser.add_argument("--limit", type=float, default=60, metavar="SECONDS", help="for one process")
    options = parser.parse_args()
    programs = {library: options.programs / name for library, name in LIBRARIES.items() if (options.programs / name).exists()}
    print(f"| milliseconds | {' | '.join(LIBRARIES)} | best right one / ours | aim |\n| --- |{' ---: |' * (len(LIBRARIES) + 2)}")
    problems = []
    for pair, (title, tolerances, aim) in PAIRS.items():
        for tolerance in tolerances:
            runs = {library: [] for library in LIBRARIES}
            for _ in range(options.passes):
                for library, program in programs.items():
                    if not runs[library] or not isinstance(runs[library][-1], str):
                        runs[library].append(one(program, pair, tolerance, options.limit))
            told = {library: best(each) for library, each in runs.items()}
            others = [run for library, run in told.items() if library != "libnurbs"]
            cells = " | ".join(cell(run) for run in told.values())
            print(f"| {title}, to {tolerance} | {cells} | {ratio(told['libnurbs'], others)} | {aim} |", flush=True)
            problems += wrong(f"{title}, to {tolerance}", tolerance, told["libnurbs"])
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

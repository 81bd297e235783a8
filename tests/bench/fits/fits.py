#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fits by this library and by others: one table, all of it measured in the same run, a job by one library after the other.

    fits.py PROGRAMS [--passes N] [--only REGEX]

PROGRAMS is the folder of bench_fits_nurbs, and of those for SISL and Open CASCADE that were built; SciPy's jobs are in this
file. Every job is a process of its own with one thread; times are those of the process, not of the clock. What a job does is in JOBS; data are made once, in PROGRAMS/data.
"""

import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

try:
    import numpy as np
except ImportError as error:
    print(f"SKIPPED: {error}")
    sys.exit(77)

# What a job does, what it should take in milliseconds (megabytes for memory), and the largest distance that is right.
JOBS = {
    "curve_1e3": ("cubic through 1e3 points of space", 0.05, 1e-9),
    "curve_1e5": ("cubic through 1e5 points of space", 4, 1e-9),
    "residual_1e5": ("the same, and its largest distance from them", None, 1e-9),
    "surface_100": ("bicubic through 100^2 points of space", 0.3, 1e-9),
    "surface_300": ("bicubic through 300^2 points of space", 3, 1e-9),
    "lsq_1e5": ("least squares, 1e5 points of space, 1000 control points", 7, 0.1),
    "lsq_1e7": ("least squares, 1e7 points of space, 1000 control points", 700, 0.1),
    "merge_100": ("statistics of 100 chunks of 1e4 points merged, 997 cells", 10, None),
    "tolerance_1e5": ("1e5 points of space to 1e-4", 15, 1.0001e-4),
    "gcv_1e3": ("smoothing by GCV, 1e3 values, 1000 control points", None, None),
    "gcv_1e5": ("smoothing by GCV, 1e5 values, 1000 control points", 20, None),
    "scattered_1e5_30": ("bicubic of 30 x 30 for 1e5 scattered heights", None, None),
    "scattered_1e6_100": ("bicubic of 100 x 100 for 1e6 scattered heights", 900, None),
    "growth_1e3": ("least squares, 100 control points, 1e3 points", None, 0.1),
    "growth_1e4": ("the same, 1e4", None, 0.1),
    "growth_1e5": ("the same, 1e5", None, 0.1),
    "growth_1e6": ("the same, 1e6", None, 0.1),
    "growth_1e7": ("the same, 1e7", None, 0.1),
    "memory_1e7": ("memory of least squares beyond that of 1e7 points, MB", 100, None),
}
LIBRARIES = {"libnurbs": "bench_fits_nurbs", "SISL": "bench_fits_sisl", "Open CASCADE": "bench_fits_occt", "SciPy": None}
NOISE = 0.01
LIMIT = 300  # seconds for one job


# --- Data ---

def wave(t):
    return np.sin(20 * t) + 0.3 * np.cos(71 * t)


def spiral(n):
    a = 0.01 * np.arange(n)
    return {f"spiral_{n}": np.stack([a * np.cos(a), a * np.sin(a), np.sin(0.1 * a)], axis=-1)}


def heights(n):
    x, y = np.meshgrid(np.arange(float(n)), np.arange(float(n)), indexing="ij")
    return {f"heights_{n}": np.stack([x, y, np.sin(0.1 * x) * np.cos(0.2 * y)], axis=-1)}


def noisy(n):
    """Points of space at random parameters, in order as a scanner gives them."""
    random = np.random.default_rng(n)
    t = np.sort(random.random(n))
    points = np.stack([np.cos(12 * t), np.sin(12 * t), t], axis=-1)
    points += NOISE * random.uniform(-1, 1, points.shape)
    return {f"noisy_{n}_params": t, f"noisy_{n}_values": points}


def flower(n):
    t = np.linspace(0, 1, n)
    r = 1 + 0.3 * np.cos(14 * np.pi * t)
    points = np.stack([r * np.cos(2 * np.pi * t), r * np.sin(2 * np.pi * t), 0.2 * np.sin(6 * np.pi * t)], axis=-1)
    return {f"flower_{n}_params": t, f"flower_{n}_values": points}


def waves(n):
    random = np.random.default_rng(n)
    t = np.sort(random.random(n))
    return {f"wave_{n}_params": t, f"wave_{n}_values": wave(t) + random.normal(scale=0.2, size=n)}


def scattered(n):
    random = np.random.default_rng(n)
    at = random.random((n, 2))
    z = np.sin(10 * at[:, 0]) * np.cos(8 * at[:, 1]) + random.normal(scale=0.05, size=n)
    return {f"scattered_{n}_params": at, f"scattered_{n}_values": z}


DATA = {"spiral": spiral, "heights": heights, "noisy": noisy, "flower": flower, "wave": waves, "scattered": scattered}
OF_JOB = {"curve_1e3": "spiral_1000", "curve_1e5": "spiral_100000",
          "residual_1e5": "spiral_100000", "surface_100": "heights_100",
          "surface_300": "heights_300", "lsq_1e5": "noisy_100000", "lsq_1e7": "noisy_10000000",
          "merge_100": "noisy_1000000", "tolerance_1e5": "flower_100000", "gcv_1e3": "wave_1000",
          "gcv_1e5": "wave_100000", "scattered_1e5_30": "scattered_100000", "scattered_1e6_100": "scattered_1000000",
          "memory_1e7": "noisy_10000000", **{f"growth_1e{k}": f"noisy_{10**k}" for k in range(3, 8)}}


def make_data(folder, names):
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        if not (folder / f"{name}.f64").exists() and not (folder / f"{name}_values.f64").exists():
            kind, n = name.split("_")
            for file, values in DATA[kind](int(n)).items():
                np.ascontiguousarray(values).tofile(folder / f"{file}.f64")


# --- SciPy ---

def measured(work):
    """The median of milliseconds, and what the last call gave."""
    times = []
    while sum(times) < 250 and len(times) < 1001:
        start = time.process_time()
        result = work()
        times.append(1e3 * (time.process_time() - start))
    return statistics.median(times), result


def chords(points):
    t = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    return t / t[-1]


def scipy_job(folder, job):
    """{"ms", "count", "error"} as the programs print them, or None: SciPy cannot, or is known to need minutes or GB."""
    from scipy import interpolate

    def read(what=""):
        return np.fromfile(folder / f"{OF_JOB[job]}{what}.f64")

    def even(count):
        return np.concatenate([[0] * 3, np.linspace(0, 1, count - 2), [1] * 3])

    if job.startswith("curve"):
        points = read().reshape(-1, 3)
        ms, made = measured(lambda: interpolate.make_interp_spline(chords(points), points, 3))
        return ms, len(made.c), None
    if job.startswith("surface"):
        n = int(job[8:])
        points = read().reshape(n, n, 3)
        u = v = np.linspace(0, 1, n)  # SciPy leaves parameters to its user: even ones, which these data have

        def through():
            rows = interpolate.make_interp_spline(u, points, 3, axis=0)
            return interpolate.make_interp_spline(v, np.moveaxis(rows.c, 1, 0), 3, axis=0)

        return measured(through)[0], n * n, None
    if job.startswith(("lsq", "growth")):
        t, points = read("_params"), read("_values").reshape(-1, 3)
        knots = even(1000 if job.startswith("lsq") else 100)
        ms, made = measured(lambda: interpolate.make_lsq_spline(t, points, knots, 3))
        return ms, len(made.c), None
    if job == "tolerance_1e5":
        # splprep() bounds a sum of squares: the tolerance, once for each point, is the loosest that it can be told.
        t, points = read("_params"), read("_values").reshape(-1, 3)
        ms, (tck, _) = measured(lambda: interpolate.splprep(points.T, u=t, s=len(t) * 1e-8 / 9, k=3))
        error = np.linalg.norm(np.stack(interpolate.splev(t, tck), axis=-1) - points, axis=1).max()
        return ms, len(tck[1][0]), error
    if job == "gcv_1e3":
        t, y = read("_params"), read("_values")
        return measured(lambda: interpolate.make_smoothing_spline(t, y))[0], len(t), None
    if job == "gcv_1e5":
        # No criterion: the sum of squares, which is known here, is given.
        t, y = read("_params"), read("_values")
        ms, made = measured(lambda: interpolate.splrep(t, y, s=len(t) * 0.04))
        return ms, len(made[1]), None
    if job == "scattered_1e5_30":
        at, z = read("_params").reshape(-1, 2), read("_values")
        inner = np.linspace(0, 1, 28)[1:-1]
        return measured(lambda: interpolate.LSQBivariateSpline(*at.T, z, inner, inner, bbox=[0, 1, 0, 1]))[0], 900, None
    return None


def run_scipy(folder, job):
    try:
        found = scipy_job(folder, job)
    except ImportError:
        found = None
    if found is None:
        sys.exit(77)
    print(json.dumps({"ms": found[0], "count": found[1], "error": -1 if found[2] is None else found[2]}))


# --- The table ---

def commands(programs):
    """How the jobs of each library are started."""
    found = {name: [str(programs / program)] for name, program in LIBRARIES.items()
             if program and (programs / program).exists()}
    return {**found, "SciPy": [sys.executable, "-B", __file__, "--scipy"]}


def run(command, folder, job):
    """What a program tells of a job; None if it does not do it."""
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    try:
        done = subprocess.run([*command, str(folder), job], env=environment, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return {"ms": 1e3 * LIMIT, "count": -1, "error": -1, "late": True}
    if done.returncode == 77:
        return None
    if done.returncode:
        print(f"{command[0]} {job}: exit status {done.returncode} {done.stderr.strip()[-200:]}", file=sys.stderr)
        return {"failed": True}
    return json.loads(done.stdout)


def cell(runs):
    if not runs:
        return "–"
    if any("failed" in found for found in runs):
        return "fails"
    if any("late" in found for found in runs):
        return f"over {LIMIT} s"
    median = statistics.median(found["ms"] for found in runs)
    count, error = runs[-1]["count"], runs[-1]["error"]
    points = f" ({count} points, off by {error:.2g})" if count > 0 and error >= 0 and count < 1000 else ""
    return f"{median:.3g}{points}"


def ratio(runs):
    """The best other that does the same, over ours."""
    times = {name: statistics.median(found["ms"] for found in each) for name, each in runs.items()
             if each and not any("failed" in found for found in each)}
    others = [value for name, value in times.items() if name != "libnurbs"]
    return f"{min(others) / times['libnurbs']:.2g}" if others and "libnurbs" in times else "–"


def wrong(job, runs):
    """What is not right about our own results, which is what is to be tested."""
    found, limit = runs.get("libnurbs", []), JOBS[job][2]
    if not found or any("failed" in each for each in found):
        return [f"{job}: no result"]
    return [f"{job}: {each['error']} off the data" for each in found
            if limit is not None and not 0 <= each["error"] <= limit]


def main():
    if sys.argv[1:2] == ["--scipy"]:
        run_scipy(pathlib.Path(sys.argv[2]), sys.argv[3])
        return 0
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--passes", type=int, default=5)
    parser.add_argument("--only", default="", metavar="REGEX", help="jobs whose name matches")
    given = parser.parse_args()
    jobs = [job for job in JOBS if re.search(given.only, job)]
    folder, known = given.programs / "data", commands(given.programs)
    make_data(folder, {OF_JOB[job] for job in jobs})
    print(f"| milliseconds | {' | '.join(LIBRARIES)} | best other / ours | aim |")
    print(f"| --- |{' ---: |' * (len(LIBRARIES) + 2)}")
    errors = []
    for job in jobs:
        runs = {name: [] for name in LIBRARIES}
        for _ in range(given.passes):
            for name, command in known.items():
                if not runs[name] or "late" not in runs[name][-1]:
                    runs[name] += filter(None, [run(command, folder, job)])
        title, aim, _ = JOBS[job]
        cells = " | ".join(cell(runs[name]) for name in LIBRARIES)
        print(f"| {title} | {cells} | {ratio(runs)} | {'–' if aim is None else f'{aim:g}'} |", flush=True)
        errors += wrong(job, runs)
    print("\n".join(errors), file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())

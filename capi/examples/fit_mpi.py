#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fits a curve to more points than memory holds, on many processes or machines, with MPI.

    mpirun -n 2 python3 fit_mpi.py                      # a million points
    mpirun -n 2 python3 fit_mpi.py --points 100000000   # a hundred million in some ten seconds, and no more memory

Each process makes statistics of its chunks of points. They are small, and MPI adds them as a tree; one fit at the end needs
nothing else. The sums are exact: whoever adds whatever first, the curve is the same, bit for bit.
"""

import argparse
import pickle
import resource

import numpy as np
from mpi4py import MPI

import nurbs

CHUNK = 100_000  # points that a process has in memory at a time
EMPTY = nurbs.Statistics(3, np.linspace(0, 1, 1025), dim=3, value_scale=2)  # what the statistics are to be about
KNOTS = nurbs.knots_open_uniform(3, 131)  # chosen among the breaks above, perhaps after the data are gone


def exact(t):
    """The curve that is measured."""
    return np.stack([np.cos(12 * t), np.sin(12 * t), t], axis=-1)


def chunk(index):
    """The parameters and points of a chunk, with noise. Of a file it would be a slice of a memory map:
    numpy.load("points.npy", mmap_mode="r")[index * CHUNK : (index + 1) * CHUNK]."""
    random = np.random.default_rng([2024, index])
    t = random.random(CHUNK)
    return t, exact(t) + 0.01 * random.uniform(-1, 1, (CHUNK, 3))


def collect(chunks, world):
    """The statistics of that many chunks, for process 0; None for the others."""
    mine = EMPTY
    for index in range(world.rank, chunks, world.size):
        mine = mine.add(*chunk(index))
    return world.reduce(mine, op=MPI.SUM)  # of Python objects MPI makes the sum by +


def megabytes():
    """The most memory that this process has had."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=1_000_000, help=f"rounded up to a multiple of {CHUNK}")
    parser.add_argument("--save", metavar="FILE", help="pickles the statistics and the curve")
    given = parser.parse_args()
    world = MPI.COMM_WORLD
    total = collect(-(-given.points // CHUNK), world)
    most = world.reduce(megabytes(), op=MPI.MAX)
    if world.rank != 0:
        return
    curve, report = total.fit(3, KNOTS, smoothing="gcv")
    t = np.linspace(0, 1, 10001)
    print(f"{report.data_count} points, {len(curve.points)} control points, rms {report.rms:.6f}")
    print(f"off the exact curve by at most {np.linalg.norm(curve(t) - exact(t), axis=1).max():.1e}")
    print(f"at most {most} MB in each of {world.size} processes")
    if given.save:
        with open(given.save, "wb") as file:
            pickle.dump((total, curve), file)


if __name__ == "__main__":
    main()

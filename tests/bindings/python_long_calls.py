# SPDX-License-Identifier: MIT
"""Long calls in Python: progress, exceptions and signals that end a call, limits of work."""

import os
import signal
import sys
import threading
import time
import types
import unittest

import nurbs
from helpers import np, same


def winding(count):
    """A curve that runs to and fro, so that its length takes a while."""
    i = np.arange(count, dtype=float)
    return nurbs.Spline(3, nurbs.knots_open_uniform(3, count), np.stack([np.sin(i * i), np.cos(3 * i * i)], axis=1))


CURVE = winding(200_000)
LENGTH = CURVE.length(1e-9)


class Ended(Exception):
    pass


class LongCalls(unittest.TestCase):
    def answers_as_before(self):
        self.assertEqual(CURVE.length(1e-9), LENGTH)

    def test_progress_rises_and_the_answer_is_the_same(self):
        seen = []
        self.assertEqual(CURVE.length(1e-9, progress=seen.append), LENGTH)
        self.assertTrue(seen and seen == sorted(seen) and 0 <= seen[0] and seen[-1] <= 1)

    def test_a_progress_may_call(self):
        points = np.zeros((3, 2))
        inside = []
        CURVE.length(1e-9, progress=lambda done: inside.append(CURVE.closest_points(points).distances))
        same(inside[0], CURVE.closest_points(points).distances)

    def test_exceptions_come_out(self):
        def end(done):
            raise Ended("own")
        with self.assertRaisesRegex(Ended, "own"):
            CURVE.length(1e-9, progress=end)
        with self.assertRaises(nurbs.CancelledError):
            CURVE.length(1e-9, progress=lambda done: False)
        self.answers_as_before()

    def test_signals_interrupt(self):
        points = np.random.default_rng(1).uniform(-1, 1, (2_000_000, 2))
        threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            CURVE.closest_points(points)
        self.assertLess(time.monotonic() - start, 5)
        self.answers_as_before()

    def test_work_is_limited(self):
        with self.assertRaises(nurbs.WorkError):
            CURVE.length(1e-9, work=1)
        limited = CURVE.closest_points(np.zeros((5, 2)), work=1)
        self.assertTrue((limited.status & nurbs.NURBS_CLOSEST_BUDGET != 0)[1:].all())
        with self.assertRaises(nurbs.ArgumentError):
            CURVE.length(work=-1)
        with self.assertRaises(TypeError):
            CURVE.length(progress=7)

    def test_a_bar_is_shown(self):
        shown = []

        class Bar:
            def __init__(self, **settings):
                shown.append(settings["desc"])

            def update(self, more):
                shown.append(more)

            def close(self):
                shown.append("closed")

        modules = {"tqdm": types.ModuleType("tqdm"), "tqdm.auto": types.ModuleType("tqdm.auto")}
        modules["tqdm.auto"].tqdm = Bar
        before = {name: sys.modules.get(name) for name in modules}
        sys.modules.update(modules)
        try:
            CURVE.length(1e-9, progress=True)
        finally:
            for name, module in before.items():
                sys.modules.pop(name) if module is None else sys.modules.update({name: module})
        self.assertEqual((shown[0], shown[-1]), ("curve_length", "closed"))
        self.assertAlmostEqual(sum(shown[1:-1]), 1)


if __name__ == "__main__":
    unittest.main()

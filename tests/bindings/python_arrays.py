# SPDX-License-Identifier: MIT
"""Arrays in Python that are used where they are, the interpreter's lock, and exceptions."""

import threading
import time
import tracemalloc
import unittest

import nurbs
from helpers import circle, near, np, patch, replaced, same, spied

T = np.linspace(0, 1, 999)


def strided():
    """(name, array) of views with the values of T that have to be read where they are."""
    table = np.zeros((999, 3))
    table[:, 1] = T
    spaced = np.zeros(1998)
    spaced[::2] = T
    return [("packed", T), ("every other", spaced[::2]), ("column", table[:, 1]),
            ("field", np.rec.fromarrays([T, T + 1, T])["f0"])]


def pairs():
    """The same for parameters (T, T^2) of a surface."""
    packed = np.stack([T, T * T], axis=-1)
    table = np.zeros((999, 5))
    table[:, 1:3] = packed
    apart = np.zeros((999, 4))
    apart[:, ::2] = packed
    return [("packed", packed), ("Fortran", np.asfortranarray(packed)), ("columns", table[:, 1:3]),
            ("apart", apart[:, ::2]), ("rows", np.repeat(packed, 2, axis=0)[::2])]


class NoCopies(unittest.TestCase):
    def assert_used(self, calls, array, argument):
        """The last call got the memory of the array."""
        self.assertEqual(calls[-1][argument], array.ctypes.data)

    def test_parameters_are_read_where_they_are(self):
        with spied("nurbs_eval") as calls:
            for s, views, wanted in ((circle(), strided(), circle()(T)), (patch(), pairs(), patch()(T, T * T))):
                for name, array in views:
                    same(s(array), wanted, name)
                    self.assert_used(calls, array, 2)

    def test_grids_of_parameters_too(self):
        grid = T[:998].reshape(2, 499)
        with spied("nurbs_eval") as calls:
            self.assertEqual(circle()(grid).shape, (2, 499, 2))
            self.assert_used(calls, grid, 2)
            whole = np.zeros((4, 5, 2))
            patch()(whole)
            self.assert_used(calls, whole, 2)

    def test_results_are_written_where_they_go(self):
        wide = np.zeros((999, 5))
        outs = [np.zeros((999, 2)), np.zeros((999, 2), order="F"), wide[:, 1:3], wide[:, ::4], np.zeros((1998, 2))[::2]]
        with spied("nurbs_eval") as calls:
            for out in outs:
                self.assertIs(circle()(T, out=out), out)
                self.assert_used(calls, out, 5)
                same(out, circle()(T))
            made = circle()(T)
            self.assert_used(calls, made, 5)

    def test_every_out(self):
        c, p, u = circle(), patch(), np.linspace(0, 1, 5)
        for call in (lambda out: c(T, out=out), lambda out: c(T, nu=1, out=out), lambda out: c.eval(T, out=out),
                     lambda out: c.eval_derivs(T, 2, out=out), lambda out: c.eval_f32(T, out=out),
                     lambda out: c.hull_size(T, out=out), lambda out: c.rational_basis(T, out=out)[1],
                     lambda out: p.eval_grid(u, u, out=out), lambda out: p.eval_grid_derivs(u, u, order=1, out=out),
                     lambda out: p.eval_grid_f32(u, u, out=out), lambda out: nurbs.bernstein(3, T, 1, out=out),
                     lambda out: nurbs.basis(2, c.knots[0], T, 1, out=out)[1], lambda out: c.lengths(T, out=out),
                     lambda out: c.params_at_lengths(T, out=out)):
            wanted = call(None)
            for out in (np.zeros_like(wanted), np.zeros_like(wanted, order="F"), np.zeros_like(wanted[::-1])[::-1]):
                self.assertIs(call(out), out)
                same(out, wanted)
            for bad in (np.zeros(3), np.zeros(wanted.shape, np.int64), wanted.tolist()):
                self.assertRaisesRegex(ValueError, "out must be", call, bad)
            wanted.flags.writeable = False
            self.assertRaisesRegex(ValueError, "writeable", call, wanted)

    def test_a_million_parameters(self):
        t, out, c = np.linspace(0, 1, 10**6), np.empty((10**6, 2)), circle()
        c(t, out=out)
        tracemalloc.start()
        try:
            c(t, out=out)
            used = tracemalloc.get_traced_memory()[1]
            tracemalloc.reset_peak()
            made = c(t)
            whole = tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()
        self.assertLess(used, 10**5)
        self.assertLess(whole, made.nbytes + 10**5)
        same(out, made)

    def test_points_and_weights(self):
        c, p = circle(), patch()
        net, flat = np.zeros((9, 4)), np.zeros(18)
        net[:, 1:3], flat[::2] = c.points, c.weights
        for points in (np.asfortranarray(c.points), net[:, 1:3], c.points):
            with spied("nurbs_create") as created, spied("nurbs_with_points") as changed:
                self.assertEqual(nurbs.Spline(2, c.knots, points, flat[::2]), c)
                self.assert_used(created, points, 6)
                self.assert_used(created, flat, 9)
                self.assertEqual(c.with_points(points, flat[::2]), c)
                self.assert_used(changed, points, 1)
        # Points of a surface in Fortran order have no two strides: they are copied.
        self.assertEqual(p.with_points(np.asfortranarray(p.points)), p)

    def test_queries(self):
        points = np.asfortranarray(np.random.default_rng(1).normal(size=(50, 2)))
        with spied("nurbs_closest_points") as calls:
            found = circle().closest_points(points)
            self.assert_used(calls, points, 2)
        near(found.distances, np.abs(np.hypot(*points.T) - 1))
        for array, argument in zip(found, (8, 11, 14, 16)):
            self.assert_used(calls, array, argument)

    def test_anything_else_is_converted(self):
        wanted, backwards = circle()(T), T[::-1]
        same(circle()(backwards), wanted[::-1])
        same(circle()(list(T)), wanted)
        same(circle()(T.astype(">f8")), wanted)
        near(circle()(T.astype(np.float32)), wanted, by=1e-6)
        same(circle()(np.array([0, 1])), [[1, 0], [1, 0]])
        same(circle()(np.broadcast_to(0.25, 3)), [[0, 1]] * 3)
        unaligned = np.frombuffer(b"x" + T.tobytes(), np.uint8)[1:].view(np.float64)
        self.assertFalse(unaligned.flags.aligned)
        same(circle()(unaligned), wanted)


class Threads(unittest.TestCase):
    def test_the_lock_is_released_during_a_call(self):
        ticks, done = [0], threading.Event()

        def tick():
            while not done.is_set():
                ticks[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        try:
            count, during = 1000, 0
            while during <= 10 and count < 10**6:
                points = np.random.default_rng(2).normal(size=(count, 3))
                surface, before = nurbs.torus(2, 0.5), ticks[0]
                surface.closest_points(points)
                during = ticks[0] - before
                count *= 2
        finally:
            done.set()
            thread.join()
        # A thread that has to wait for the lock would come to a few ticks before and after each call, however long it is.
        self.assertGreater(during, 10)

    def test_errors_belong_to_their_thread(self):
        found = {}

        def fail(param):
            for _ in range(300):
                try:
                    circle()(param)
                except nurbs.DomainError as error:
                    found.setdefault(param, set()).add(error.message)

        threads = [threading.Thread(target=fail, args=(param,)) for param in (2, 3, 4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, {param: {f"params[0] = {param} outside [0, 1]"} for param in (2, 3, 4)})


class Exceptions(unittest.TestCase):
    def assert_raised(self, kinds, status, call):
        with self.assertRaises(nurbs.NurbsError) as caught:
            call()
        error = caught.exception
        self.assertEqual((error.status, error.name, nurbs.status_name(status)), (status, error.name, error.name))
        self.assertEqual(str(error), f"{error.name}: {error.message}")
        for kind in kinds:
            self.assertIsInstance(error, kind)
        return error

    def test_each_class(self):
        c, missing = circle(), "/no/such/file"
        for kinds, status, call in (
                ((nurbs.ArgumentError, ValueError), nurbs.NURBS_ERROR_TIMES, lambda: c.elevate(-1)),
                ((nurbs.RangeError, nurbs.ArgumentError, IndexError), nurbs.NURBS_ERROR_AXIS,
                 lambda: c.elevate(axis=1)),
                ((nurbs.RangeError, IndexError), nurbs.NURBS_ERROR_INDEX, lambda: c.set_weights([9], [1])),
                ((nurbs.DomainError, ValueError), nurbs.NURBS_ERROR_OUTSIDE_DOMAIN, lambda: c(2)),
                ((nurbs.NumericError, ArithmeticError), nurbs.NURBS_ERROR_KNOTS_MERGE,
                 lambda: c.reparametrize(1, 1 + 2**-52)),
                ((nurbs.ResourceError, RuntimeError), nurbs.NURBS_ERROR_TOO_LARGE,
                 lambda: nurbs.read(b"abc", max_bytes=1)),
                ((nurbs.FileError, OSError), nurbs.NURBS_ERROR_FILE, lambda: nurbs.read_file(missing)),
                ((nurbs.ContentsError, ValueError), nurbs.NURBS_ERROR_FORMAT, lambda: nurbs.read(b"abc"))):
            error = self.assert_raised(kinds, status, call)
            self.assertTrue(error.message)
        for kinds, status in (((nurbs.OutOfMemoryError, MemoryError), nurbs.NURBS_ERROR_MEMORY),
                              ((nurbs.InternalError, RuntimeError), nurbs.NURBS_ERROR_INTERNAL),
                              ((nurbs.NurbsError,), 777)):
            with replaced("nurbs_clone", lambda *_: status):
                error = self.assert_raised(kinds, status, c.copy)
            self.assertTrue(type(error) is kinds[0])

    def test_every_status_has_a_class(self):
        for name, status in vars(nurbs).items():
            if name.startswith("NURBS_ERROR_"):
                with replaced("nurbs_clone", lambda *_: status):
                    error = self.assert_raised((), status, circle().copy)
                self.assertEqual(error.name, name)
                self.assertIsNot(type(error), nurbs.NurbsError)

    def test_arguments_of_other_types(self):
        c = circle()
        for kind, call in ((TypeError, lambda: c.insert_knot("a")), (TypeError, lambda: c.elevate(1.5)),
                           (TypeError, lambda: c.sum(3)), (OverflowError, lambda: c.elevate(2**31)),
                           (OverflowError, lambda: c(0.5, flags=-1)), (ValueError, lambda: c(["a"])),
                           (ValueError, lambda: nurbs.Spline(2, [0, 1], [1, 2])),
                           (TypeError, lambda: nurbs.read("text")),
                           (ValueError, lambda: nurbs.Spline([1, 1], [[0, 1]], np.zeros((2, 2, 3))))):
            self.assertRaises(kind, call)


if __name__ == "__main__":
    unittest.main()

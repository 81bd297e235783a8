# SPDX-License-Identifier: MIT
"""What the tests of the Python binding share; without NumPy they are skipped."""

import contextlib
import sys

try:
    import numpy as np
except ImportError:
    print("SKIPPED: NumPy is not installed")
    sys.exit(77)

import nurbs

EPS = np.finfo(float).eps
same = np.testing.assert_array_equal


def near(actual, expected, by=1e-12):
    np.testing.assert_allclose(actual, expected, rtol=0, atol=by)


def status_of(call, *arguments, **options):
    """The status with which a call fails, NURBS_OK if it does not."""
    try:
        call(*arguments, **options)
    except nurbs.NurbsError as error:
        return error.status
    return nurbs.NURBS_OK


def circle():
    """The unit circle as four rational quadratic quarters."""
    s = 0.5**0.5
    points = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]]
    return nurbs.Spline(2, nurbs.knots_bezier(2, 4), points, [1, s, 1, s, 1, s, 1, s, 1])


def patch():
    """z = u v over the unit square, as a Bezier patch of degrees 1 and 2 with counts 2 and 3."""
    u, v = np.meshgrid([0.0, 1.0], [0.0, 0.5, 1.0], indexing="ij")
    return nurbs.Spline.bezier(np.stack([u, v, u * v], axis=-1))


def _knots(random, degree, form):
    """A knot vector with a few inner knots of any multiplicity."""
    breaks = np.cumsum(random.uniform(0.1, 1, random.integers(2, 5))) - 1
    times = random.integers(1, degree + 2, breaks.size)
    if form == "periodic":
        times[:] = random.integers(1, max(degree, 1) + 1)
        return nurbs.knots_periodic(degree, breaks, times)
    if form == "clamped":
        times[[0, -1]] = degree + 1
        return np.repeat(breaks, times)
    outside = np.cumsum(random.uniform(0.1, 1, degree)) if degree else np.empty(0)
    times[[0, -1]] = 1
    return np.concatenate([breaks[0] - outside[::-1], np.repeat(breaks, times), breaks[-1] + outside])


def _net(random, degrees, knots, periodic, width):
    """Random records that wrap on periodic axes."""
    net = random.normal(size=(*(t.size - p - 1 for t, p in zip(knots, degrees)), width))
    for axis, wraps in enumerate(periodic):
        layers = np.moveaxis(net, axis, 0)
        for i in range(degrees[axis] if wraps else 0):
            layers[len(layers) - degrees[axis] + i] = layers[i]
    return net


def random_spline(random):
    """A curve, surface or volume of any form: with and without weights, of weight 0, homogeneous with any signs."""
    axes = random.integers(1, 4)
    degrees = random.integers(0, 5, axes)
    forms = random.choice(["clamped", "unclamped", "periodic"], axes)
    knots = [_knots(random, degree, form) for degree, form in zip(degrees, forms)]
    periodic = [form == "periodic" for form in forms]
    flags = sum(nurbs.on_axis(k, nurbs.NURBS_PERIODIC) for k, wraps in enumerate(periodic) if wraps)
    kind, dim = random.choice(["polynomial", "rational", "zeros", "homogeneous", "infinite"]), random.integers(1, 5)
    net = _net(random, degrees, knots, periodic, dim + 1)
    points, weights = net[..., :-1], np.exp(net[..., -1])
    if kind == "polynomial":
        return nurbs.Spline(degrees, knots, points, flags=flags)
    if kind in ("zeros", "infinite"):
        net[..., -1] = weights = np.where(net[..., -1] > 1.2, 0, weights)
    try:
        if kind in ("homogeneous", "infinite"):
            return nurbs.Spline.create_homogeneous(degrees, knots, net, flags)
        return nurbs.Spline(degrees, knots, points, weights, flags)
    except nurbs.NurbsError as error:
        # Weights of 0 may be too many.
        if error.status != nurbs.NURBS_ERROR_WEIGHTS_VANISH:
            raise
        return random_spline(random)


def random_splines(count, seed):
    random = np.random.default_rng(seed)
    return [random_spline(random) for _ in range(count)]


@contextlib.contextmanager
def replaced(name, function):
    """A function of the library replaced for a while."""
    real = nurbs.lib.__dict__[name]
    function.__name__ = name
    nurbs.lib.__dict__[name] = function
    try:
        yield
    finally:
        nurbs.lib.__dict__[name] = real


@contextlib.contextmanager
def spied(name):
    """The arguments of the calls of a function of the library."""
    real, calls = nurbs.lib.__dict__[name], []

    def spy(*arguments):
        calls.append(arguments)
        return real(*arguments)

    with replaced(name, spy):
        yield calls

"""SciPy on the jobs of the other programs, with their options and their form of output.

Splines are evaluated in homogeneous space and divided by the weight. Curves: BSpline and PPoly. Surfaces and volumes at
scattered points: NdPPoly, and FITPACK where its degrees reach. Grids: dense basis matrices, multiplied by BLAS.
"""

import argparse
import json
import math
import re
import sys
import time
from pathlib import Path

try:
    import numpy as np
    from scipy import interpolate
except ImportError as error:
    print(f"SKIPPED: {error}")
    sys.exit(77)

TOLERANCE = 1e3  # in bounds of nurbs.h, as for the other peers
BLOCK = 50  # rows of a grid whose intermediate arrays stay in the cache


class Case:
    """The arrays of one file, in the order that case.h gives."""

    def __init__(self, path):
        raw = np.fromfile(path, dtype=np.int64)
        arrays, at = [], 0
        while at < raw.size:
            arrays.append(raw[at + 1 : at + 1 + raw[at]])
            at += 1 + raw[at]
        self.degrees, self.counts, dim, self.grid, self.sample = arrays[:5]
        knots, points, weights, params, expected, bounds = (a.view(np.float64) for a in arrays[5:])
        self.axes, self.dim = len(self.degrees), int(dim[0])
        self.knots = np.split(knots, np.cumsum(self.counts + self.degrees + 1)[:-1])
        cartesian, weights = points.reshape(-1, self.dim), weights[:, None]
        self.homogeneous = np.hstack([cartesian * weights, weights]).reshape(*self.counts, self.dim + 1)
        self.params = np.split(params, [self.grid[0]]) if self.grid.size else params.reshape(-1, self.axes)
        self.points = int(np.prod(self.grid)) if self.grid.size else len(self.params)
        self.expected = expected.reshape(len(self.sample), -1, self.dim)
        self.bounds = bounds.reshape(self.expected.shape)


def orders(axes, order):
    """Multi-indices in the order of nurbs_eval_derivs()."""
    if axes == 1:
        return [(k,) for k in range(order + 1)]
    if axes == 2:
        return [(total - b, b) for total in range(order + 1) for b in range(total + 1)]
    return [(0, 0, 0)]


def divide(slots, axes, order):
    """The quotient rule; every slot has its components first."""
    weights = [h[-1] for h in slots]
    result = [slots[0][:-1] / weights[0]]
    if order >= 1:
        for a in range(1, axes + 1):
            result.append((slots[a][:-1] - weights[a] * result[0]) / weights[0])
    if order >= 2:
        pairs = [(a, b) for a in range(1, axes + 1) for b in range(a, axes + 1)]
        for slot, (a, b) in enumerate(pairs, axes + 1):
            upper = slots[slot][:-1] - weights[a] * result[b] - weights[b] * result[a] - weights[slot] * result[0]
            result.append(upper / weights[0])
    return result


def unit_normal(du, dv):
    x = du[1] * dv[2] - du[2] * dv[1]
    y = du[2] * dv[0] - du[0] * dv[2]
    z = du[0] * dv[1] - du[1] * dv[0]
    scale = 1 / np.sqrt(x * x + y * y + z * z)
    return np.stack([x * scale, y * scale, z * scale])


def finish(slots, job, axes):
    vectors = divide(slots, axes, job["order"])
    if job["normal"]:
        vectors.append(unit_normal(vectors[1], vectors[2]))
    return vectors


def power_form(knots, degree):
    """[power][span][function]: every basis function as polynomials, highest power first, and the breaks.

    By Taylor's formula, because PPoly.from_spline() calls FITPACK, which ends with degree 5.
    """
    count = len(knots) - degree - 1
    breaks = knots[degree : count + 1]
    functions = interpolate.BSpline(knots, np.eye(count), degree)
    powers = [functions(breaks[:-1], nu=m) / math.factorial(m) for m in range(degree, -1, -1)]
    return np.stack(powers), breaks


def finished(case, job, evaluate):
    """A function that evaluates one partial derivative, turned into one that does the job."""
    return lambda: finish([evaluate(nu) for nu in orders(case.axes, job["order"])], job, case.axes)


def prepare_bspline(case, job):
    spline = interpolate.BSpline(case.knots[0], case.homogeneous, int(case.degrees[0]))
    return finished(case, job, lambda nu: spline(case.params[:, 0], nu=nu[0]).T)


def prepare_ppoly(case, job):
    power, breaks = power_form(case.knots[0], int(case.degrees[0]))
    spline = interpolate.PPoly(power @ case.homogeneous, breaks)
    return finished(case, job, lambda nu: spline(case.params[:, 0], nu=nu[0]).T)


def prepare_ndppoly(case, job):
    forms = [power_form(knots, int(degree)) for knots, degree in zip(case.knots, case.degrees)]
    coefficients = case.homogeneous
    for axis, (power, _) in enumerate(forms):
        # takes the first axis of control points, appends powers and spans
        coefficients = np.tensordot(coefficients, power, axes=(0, 2))
    coefficients = np.moveaxis(coefficients, 0, -1)
    coefficients = coefficients.transpose(*range(0, 2 * case.axes, 2), *range(1, 2 * case.axes, 2), -1)
    spline = interpolate.NdPPoly(np.ascontiguousarray(coefficients), [breaks for _, breaks in forms])
    return finished(case, job, lambda nu: spline(case.params, nu=nu).T)


class Fitpack(interpolate.BivariateSpline):
    """One component, from knots and coefficients that are known."""

    def __init__(self, knots, degrees, coefficients):
        self.tck = (*knots, coefficients)
        self.degrees = degrees


def prepare_fitpack(case, job):
    degrees = tuple(int(degree) for degree in case.degrees)
    components = [Fitpack(case.knots, degrees, case.homogeneous[..., c].ravel()) for c in range(case.dim + 1)]
    u, v = np.ascontiguousarray(case.params.T)
    return finished(
        case, job, lambda nu: np.stack([component.ev(u, v, dx=nu[0], dy=nu[1]) for component in components])
    )


def basis_matrices(params, knots, degree, order):
    """The matrix of all functions at all parameters, and its derivatives to an order of at most 1."""
    result = [interpolate.BSpline.design_matrix(params, knots, degree).toarray()]
    if order >= 1:
        lower = interpolate.BSpline.design_matrix(params, knots[1:-1], degree - 1).toarray()
        scaled = lower * (degree / (knots[degree + 1 : -1] - knots[1 : -degree - 1]))
        zero = np.zeros((len(params), 1))
        result.append(np.hstack([zero, scaled]) - np.hstack([scaled, zero]))
    return result


def prepare_matrices(case, job):
    planes = np.ascontiguousarray(np.moveaxis(case.homogeneous, -1, 0))
    pairs = orders(2, job["order"])
    out = np.full((len(pairs) + job["normal"], case.dim, *case.grid), np.nan)

    def work():
        u, v = (
            basis_matrices(params, knots, int(degree), job["order"])
            for params, knots, degree in zip(case.params, case.knots, case.degrees)
        )
        for first in range(0, case.grid[0], BLOCK):
            rows = slice(first, first + BLOCK)
            slots = [(u[a][rows] @ planes) @ v[b].T for a, b in pairs]
            for place, vector in zip(out, finish(slots, job, case.axes)):
                place[:, rows] = vector
        return out

    return work


def routes(case):
    if case.grid.size:
        return {"matrices": prepare_matrices}
    if case.axes == 1:
        return {"BSpline": prepare_bspline, "PPoly": prepare_ppoly}
    if case.axes == 2 and max(case.degrees) <= 5:
        return {"NdPPoly": prepare_ndppoly, "FITPACK": prepare_fitpack}
    return {"NdPPoly": prepare_ndppoly}


def worst_error(case, vectors):
    values = np.stack([vector.reshape(case.dim, -1)[:, case.sample] for vector in vectors])
    errors = np.abs(values.transpose(2, 0, 1) - case.expected) / case.bounds
    return float(np.max(np.where(np.isnan(errors), np.inf, errors)))


def measure(work, min_time):
    """Nanoseconds of process time for one call, and its result."""
    result, calls, spent = work(), 0, 0  # one call to warm up
    while spent < min_time * 1e9:
        start = time.process_time_ns()
        result = work()
        spent += time.process_time_ns() - start
        calls += 1
    return spent / max(calls, 1), result


def run_route(case, job, name, prepare, min_time):
    nanoseconds, vectors = measure(prepare(case, job), min_time)
    worst = worst_error(case, vectors)
    entry = {"name": f"{job['name']}/{name}/process_time", "run_type": "iteration", "cpu_time": nanoseconds}
    entry.update(points=case.points, worst=worst)
    if worst > TOLERANCE:
        entry.update(error_occurred=True, error_message=f"wrong by {worst} bounds")
    return entry


def offered(job):
    # one point for each call is not what an array language is for
    return job["group"] == "main" and job["name"] != "curve_single"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("data", type=Path)
    parser.add_argument("--benchmark_filter", default="")
    parser.add_argument("--benchmark_min_time", type=float, default=0.5)
    parser.add_argument("--benchmark_format", default="json")
    arguments = parser.parse_args()
    entries = []
    for job in filter(offered, json.loads((arguments.data / "jobs.json").read_text())):
        if re.search(arguments.benchmark_filter, job["name"] + "/"):
            case = Case(arguments.data / f"{job['name']}.case")
            for name, prepare in routes(case).items():
                entries.append(run_route(case, job, name, prepare, arguments.benchmark_min_time))
    json.dump({"benchmarks": entries}, sys.stdout, indent=1)
    return any("error_occurred" in entry for entry in entries)


if __name__ == "__main__":
    sys.exit(main())

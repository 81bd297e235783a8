# SPDX-License-Identifier: MIT
"""Where shapes meet; every answer says whether it is complete."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple

import numpy

from ._arrays import exactly
from ._base import SplineBase
from ._calls import listed, watched
from ._library import lib

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int32s
    from ._calls import Progress

__all__ = ["Hits"]


class Hits(NamedTuple):
    """Parameters (n,) in rising order, a NURBS_HIT_ constant each, ranges (n, 2) of parameters outside of which there is no
    solution, and whether none of them is undecided."""

    params: Floats
    kinds: Int32s
    ranges: Floats
    complete: bool


def _arrays(n: int) -> Tuple[Any, ...]:
    return numpy.empty(n), numpy.empty(n, numpy.int32), numpy.empty((n, 2))


class Intersections(SplineBase):
    """Where the shape meets others."""

    def roots(self, value: float = 0.0, tolerance: float = 0.0, *, progress: Progress = None,
              work: Optional[int] = None) -> Hits:
        """Where a scalar curve has a value, with proof that there are no other places."""
        return listed(Hits, _arrays, watched(lib.nurbs_roots, progress, work, 2), self._handle, value, tolerance)

    def curve_level(self, degree: int, coefficients: ArrayLike, tolerance: float = 0.0, *, progress: Progress = None,
                    work: Optional[int] = None) -> Hits:
        """Where a curve meets a line, a plane, a conic, a quadric or another set on which a polynomial of a degree is 0.
        Its coefficients are those of the products x_i x_j ... of `degree` factors with i <= j <= ..., in lexicographic
        order, where x_dim stands for 1: of a line (a, b, c), of a plane (a, b, c, d), of a conic those of xx, xy, x, yy,
        y and 1."""
        given = exactly(coefficients, math.comb(self.dimension + max(degree, 0), max(degree, 0)), "coefficients")
        return listed(Hits, _arrays, watched(lib.nurbs_curve_level, progress, work, 2), self._handle, degree,
                      given.ctypes.data, tolerance)

# SPDX-License-Identifier: MIT
"""Grids of points with derivatives at the ends of axes, put together for nurbs_interpolate_derivatives()."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Mapping, Tuple

import numpy

from .constants import NURBS_END, NURBS_START

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int32s

    #: By axis and end: derivatives of orders 1, 2, ... along the axis, (orders, counts of the other axes..., dimension).
    Derivatives = Mapping[Tuple[int, int], ArrayLike]


class Layers:
    """Values (counts..., dimension), and the parameters and orders of their layers for each axis; mixed derivatives are
    NaN."""

    def __init__(self, params: List[Floats], points: Floats, derivatives: Derivatives) -> None:
        self.points, self.axes = points, points.ndim - 1
        self.given = {key: self._checked(key, values) for key, values in derivatives.items()}
        self.params: List[Floats] = []
        self.orders: List[Int32s] = []
        self.sites: List[Int32s] = []
        for axis, own in enumerate(params):
            start, end = self._many(axis, NURBS_START), self._many(axis, NURBS_END)
            self.params.append(numpy.concatenate([own[:1].repeat(start), own, own[-1:].repeat(end)]))
            orders = numpy.zeros(self.params[-1].size, numpy.int32)
            orders[1:start + 1] = numpy.arange(1, start + 1)
            orders[orders.size - end:] = numpy.arange(1, end + 1)
            self.orders.append(orders)
            self.sites.append(numpy.flatnonzero(orders == 0).astype(numpy.int32))
        self.values = numpy.full([own.size for own in self.params] + [points.shape[-1]], numpy.nan)
        self.values[numpy.ix_(*self.sites)] = points
        for (axis, end), values in self.given.items():
            self.values[numpy.ix_(*self._places(axis, end, len(values)))] = numpy.moveaxis(values, 0, axis)

    def _checked(self, key: Tuple[int, int], values: ArrayLike) -> Floats:
        axis, end = key
        if axis not in range(self.axes) or end not in (NURBS_START, NURBS_END):
            raise ValueError(f"derivatives at {key}, expected an axis below {self.axes}, and NURBS_START or NURBS_END")
        array = numpy.asarray(values, numpy.float64)
        expected = self.points.shape[:axis] + self.points.shape[axis + 1:]
        if array.shape[1:] != expected:
            raise ValueError(f"derivatives of shape {array.shape} at {key}, expected (orders, "
                             f"{', '.join(map(str, expected))})")
        return array

    def _many(self, axis: int, end: int) -> int:
        return len(self.given.get((axis, end), ()))

    def _places(self, axis: int, end: int, many: int) -> List[Int32s]:
        places = list(self.sites)
        first = 1 if end == NURBS_START else self.orders[axis].size - many
        places[axis] = numpy.arange(first, first + many, dtype=numpy.int32)
        return places

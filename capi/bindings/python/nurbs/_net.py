# SPDX-License-Identifier: MIT
"""What the constructors of the library take: degrees, counts, knots, points and weights."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional, Tuple

import numpy

from ._arrays import one_each, records, vector

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, DTypeLike, NDArray


def concatenated(vectors: Any, axes: int, dtype: DTypeLike = numpy.float64) -> Tuple[NDArray[Any], List[int]]:
    """The vectors of all axes one after the other, and their lengths; a curve may give its own alone."""
    if axes == 1 and (len(vectors) == 0 or numpy.ndim(vectors[0]) == 0):
        vectors = [vectors]
    if len(vectors) != axes:
        raise ValueError(f"{len(vectors)} vectors for {axes} axes")
    parts = [vector(values, dtype) for values in vectors]
    return parts[0] if axes == 1 else numpy.concatenate(parts), [part.size for part in parts]


class Net:
    """Degrees, counts, points and weights."""

    def __init__(self, degrees: ArrayLike, points: ArrayLike, weights: Optional[ArrayLike]) -> None:
        self.degrees = vector(degrees, numpy.int32)
        self.axes = self.degrees.size
        given = numpy.asarray(points, dtype=numpy.float64)
        if given.ndim != self.axes + 1:
            raise ValueError(f"points of shape {given.shape}, expected {self.axes + 1} dimensions: one for each "
                             "degree, one for the coordinates")
        self.counts = vector(given.shape[:-1], numpy.int64)
        self.width = given.shape[-1]
        self.points = records(given, self.width)
        self.weights = None if weights is None else one_each(weights, given.shape[:-1], "weights")

    @property
    def sizes(self) -> Tuple[int, int, int]:
        """Axes, degrees and counts."""
        return self.axes, self.degrees.ctypes.data, self.counts.ctypes.data

    @property
    def weight_layout(self) -> Tuple[Optional[int], int]:
        """Pointer and stride of the weights."""
        return (None, 0) if self.weights is None else self.weights.layout[:2]

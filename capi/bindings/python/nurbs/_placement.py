# SPDX-License-Identifier: MIT
"""Where shapes stand: vectors of one length as the library's pointers."""

import numpy

from ._arrays import vector

FULL_TURN = 2 * numpy.pi


class Vectors:
    """Vectors, or None, of one length `dim`: that of the first one, or `otherwise` if all are None."""

    def __init__(self, *values, otherwise=None):
        self._arrays = [None if value is None else vector(value, numpy.float64) for value in values]
        sizes = [array.size for array in self._arrays if array is not None]
        self.dim = sizes[0] if sizes else otherwise
        if any(size != self.dim for size in sizes):
            raise ValueError(f"vectors of different lengths: {sizes}")

    @property
    def addresses(self):
        return tuple(None if array is None else array.ctypes.data for array in self._arrays)


def place(origin, axis, x, otherwise=2):
    """The arguments dim, origin, axis and x of a shape of the plane or of space, and what keeps them alive."""
    vectors = Vectors(origin, axis, x, otherwise=otherwise)
    return (vectors.dim, *vectors.addresses), vectors


def space(origin, axis, x):
    """The arguments origin, axis and x of a shape of space, and what keeps them alive."""
    vectors = Vectors(origin, axis, x, otherwise=3)
    if vectors.dim != 3:
        raise ValueError(f"a placement of dimension {vectors.dim} for a shape of dimension 3")
    return vectors.addresses, vectors

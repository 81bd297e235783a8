# SPDX-License-Identifier: MIT
"""Where shapes stand: vectors of one length as the library's pointers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple

import numpy

from ._arrays import addresses, vector

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

FULL_TURN = 2 * numpy.pi


class Vectors:
    """Vectors, or None, of one length `dim`: that of the first one, or `otherwise` if all are None."""

    def __init__(self, *values: Optional[ArrayLike], otherwise: int = 0) -> None:
        self._arrays = [None if value is None else vector(value) for value in values]
        sizes = [array.size for array in self._arrays if array is not None]
        self.dim = sizes[0] if sizes else otherwise
        if any(size != self.dim for size in sizes):
            raise ValueError(f"vectors of different lengths: {sizes}")

    @property
    def addresses(self) -> Tuple[Optional[int], ...]:
        """The pointers, NULL for None."""
        return addresses(*self._arrays)


def place(origin: Optional[ArrayLike], axis: Optional[ArrayLike], x: Optional[ArrayLike],
          otherwise: int = 2) -> Tuple[Tuple[Any, ...], Vectors]:
    """The arguments dim, origin, axis and x of a shape of the plane or of space, and what keeps them alive."""
    vectors = Vectors(origin, axis, x, otherwise=otherwise)
    return (vectors.dim, *vectors.addresses), vectors


def space(origin: Optional[ArrayLike], axis: Optional[ArrayLike],
          x: Optional[ArrayLike]) -> Tuple[Tuple[Any, ...], Vectors]:
    """The arguments origin, axis and x of a shape of space, and what keeps them alive."""
    vectors = Vectors(origin, axis, x, otherwise=3)
    if vectors.dim != 3:
        raise ValueError(f"a placement of dimension {vectors.dim} for a shape of dimension 3")
    return vectors.addresses, vectors

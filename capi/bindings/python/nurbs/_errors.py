# SPDX-License-Identifier: MIT
"""The exceptions: one class for each class of statuses, each also a natural exception of Python."""

from __future__ import annotations

from typing import Dict, Tuple, Type

from .constants import (NURBS_ERROR_AXIS, NURBS_ERROR_CANCELLED, NURBS_ERROR_FILE, NURBS_ERROR_INDEX,
                        NURBS_ERROR_MEMORY, NURBS_ERROR_WORK)

__all__ = ["NurbsError", "ArgumentError", "RangeError", "DomainError", "NumericError", "ResourceError",
           "WorkError", "CancelledError", "OutOfMemoryError", "FileError", "ContentsError", "InternalError"]


class NurbsError(Exception):
    """A call that failed: `status` (a NURBS_ERROR_ constant), `name` (that of the constant) and `message` (the
    library's, with the array, the index, the value and what was expected)."""

    def __init__(self, status: int, name: str, message: str) -> None:
        super().__init__(status, name, message)
        self.status = status
        self.name = name
        self.message = message

    def __reduce__(self) -> Tuple[Type[NurbsError], Tuple[int, str, str]]:
        return type(self), (self.status, self.name, self.message)

    def __str__(self) -> str:
        return f"{self.name}: {self.message}"


class ArgumentError(NurbsError, ValueError):
    """An argument that the call is not for; statuses 1 to 99."""


class RangeError(ArgumentError, IndexError):
    """An axis or an index that does not exist: NURBS_ERROR_AXIS, NURBS_ERROR_INDEX."""


class DomainError(NurbsError, ValueError):
    """A parameter or knot outside the domain; statuses 100 to 199."""


class NumericError(NurbsError, ArithmeticError):
    """A result that does not fit double precision, or an iteration without a result; statuses 200 to 299."""


class ResourceError(NurbsError, RuntimeError):
    """A limit that was reached; statuses 300 to 399 but for CancelledError, OutOfMemoryError and FileError."""


class WorkError(ResourceError):
    """The limit `work` of a call, reached before its end: NURBS_ERROR_WORK."""


class CancelledError(NurbsError, RuntimeError):
    """A call that `progress` ended by returning False: NURBS_ERROR_CANCELLED."""


class OutOfMemoryError(NurbsError, MemoryError):
    """NURBS_ERROR_MEMORY."""


class FileError(NurbsError, OSError):
    """A file that cannot be opened or read: NURBS_ERROR_FILE."""

    def __init__(self, status: int, name: str, message: str) -> None:
        super().__init__(status, name, message)
        # OSError takes its arguments for an errno and a path, which the library does not tell apart.
        self.errno, self.strerror, self.filename = None, message, None  # type: ignore[assignment]


class ContentsError(NurbsError, ValueError):
    """A file that holds something else; statuses 400 to 499."""


class InternalError(NurbsError, RuntimeError):
    """A defect of the library; statuses from 900."""


_OF_ONE_STATUS: Dict[int, Type[NurbsError]] = {
    NURBS_ERROR_AXIS: RangeError, NURBS_ERROR_INDEX: RangeError, NURBS_ERROR_MEMORY: OutOfMemoryError,
    NURBS_ERROR_FILE: FileError, NURBS_ERROR_WORK: WorkError, NURBS_ERROR_CANCELLED: CancelledError}
_OF_HUNDREDS: Dict[int, Type[NurbsError]] = {
    0: ArgumentError, 1: DomainError, 2: NumericError, 3: ResourceError, 4: ContentsError, 9: InternalError}


def error_class(status: int) -> Type[NurbsError]:
    """The exception of a status; NurbsError itself for classes that a later library may add."""
    return _OF_ONE_STATUS.get(status, _OF_HUNDREDS.get(status // 100, NurbsError))

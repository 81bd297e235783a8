# SPDX-License-Identifier: MIT
"""libnurbs for Python: NURBS curves, surfaces and volumes on NumPy arrays.

    import numpy, nurbs
    circle = nurbs.circle(2.0)                        # exact, as is everything that is one call
    points = circle(numpy.linspace(0, 1, 1_000_000))  # (1000000, 2)
    finer = circle.insert_knot(0.3, 2)
    finer.length(), finer.closest_points([3, 4]), finer.knots, finer.points, finer.plot()

The manual is the header nurbs.h; this package keeps its names, its indices from 0 and its flags. One rule tells where a
C function is: if its first argument is one spline it is a method of Spline, of what the spline is made of a property;
constructors from points are class methods of Spline; what makes statistics of data, or is made of them, is in the class
Statistics, what makes or asks faces in the class Face, models in the class Model, what asks meets in the class Meet, and
meshes in the class Mesh; everything else (shapes, several splines, knots, files) is a function of this module. Prefixes
(nurbs_, curve_, surface_, volume_, statistics_, face_, model_, meet_, mesh_) are left out where the name is clear without.

- Arrays have natural shapes: control points (counts..., dimension), parameters of a curve S, of a surface S + (2,),
  results S + (dimension,). Arrays of float64 with positive strides are passed without a copy, in either memory order;
  others are converted. Results are new arrays, or `out` where a method takes it; properties that are arrays are copies.
- A failure raises a NurbsError with `status`, `name` and `message`, which also is the exception that Python would
  raise: ArgumentError and DomainError are ValueError, RangeError is IndexError too, NumericError is ArithmeticError,
  OutOfMemoryError is MemoryError, FileError is OSError, ContentsError is ValueError, ResourceError (WorkError is one),
  CancelledError and InternalError are RuntimeError. Arrays of a wrong shape raise ValueError, arguments of a wrong type
  TypeError, numbers that do not fit OverflowError. A failing call writes nothing to `out`.
- What can take long has two arguments more. `progress` is called with the part that is done, an estimate from 0 to 1
  that never falls, at most every 10 ms, so that a short call may end without that; it may use any spline. If it returns
  False the call raises CancelledError, and what it raises itself leaves the call. True shows tqdm's bar where tqdm is
  installed, else percents on the standard error output. `work` is the most multiply-adds, of which a processor does
  some 10^9 in a second or two: searches then answer with what is proven so far and say so in `status` (the bit
  NURBS_CLOSEST_BUDGET), `complete` or `result`, anything else raises WorkError. Methods that list what they find, and
  those whose answer overflows, ask the library again, each time with this limit.
- Ctrl-C interrupts all of these, as does what other handlers of signals raise, with progress or without; splines are as
  they were.
- The interpreter's lock is released during every call, and one spline may be used by many threads at once.
- Splines and statistics are values: they never change, can be compared, hashed, copied and pickled, bit for bit. Their
  to_bytes() are the same on every machine; pickles of protocol 5 hold them beside the pickle, so that they can be sent
  without a copy.

The library is $NURBS_LIBRARY, a path to libnurbs.so, if that is set, else the system's libnurbs.so.1. The C functions
themselves are attributes of `nurbs.lib`.
"""

from ._base import DistinctKnots as DistinctKnots
from ._errors import *  # noqa: F403
from ._library import last_error as last_error, lib as lib, status_name as status_name, version as version
from ._analysis import *  # noqa: F403
from ._bounds import *  # noqa: F403
from ._bytes import *  # noqa: F403
from ._closest import *  # noqa: F403
from ._cloud import *  # noqa: F403
from .constants import *  # noqa: F403 - the names of the header
from ._constrain import *  # noqa: F403
from ._continuation import *  # noqa: F403
from ._coons import *  # noqa: F403
from ._curves import *  # noqa: F403
from ._deform import *  # noqa: F403
from ._edit import *  # noqa: F403
from ._evaluation import *  # noqa: F403
from ._faces import *  # noqa: F403
from ._faces import _restored_face
from ._files import *  # noqa: F403
from ._files import _restored_list
from ._fit import *  # noqa: F403
from ._fitting import *  # noqa: F403
from ._fitting import _restored_statistics
from ._frames import *  # noqa: F403
from ._intersections import *  # noqa: F403
from ._knots import *  # noqa: F403
from ._linear import *  # noqa: F403
from ._measure import *  # noqa: F403
from ._meets import *  # noqa: F403
from ._mesh import *  # noqa: F403
from ._models import *  # noqa: F403
from ._models import _restored_model
from ._reduce import *  # noqa: F403
from ._refinement import *  # noqa: F403
from ._segments import *  # noqa: F403
from ._shapes import *  # noqa: F403
from ._spline import Spline as Spline, _restored, _restored_spline
from ._together import *  # noqa: F403

#: The version of this package; version() is that of the library that is loaded.
__version__ = "1.1.0"

# Results, exceptions, and what is pickled are known by the names they have here.
for _value in list(globals().values()):
    if isinstance(_value, type) and issubclass(  # noqa: F405
        _value, (tuple, Exception, Spline, SplineList, Statistics, Face, Model, Meet, Mesh)):  # noqa: F405
        _value.__module__ = __name__
for _value in (_restored, _restored_spline, _restored_list, _restored_statistics, _restored_face, _restored_model):
    _value.__module__ = __name__
del _value

# SPDX-License-Identifier: MIT
"""libnurbs for Python: NURBS curves, surfaces and volumes on NumPy arrays.

    import numpy, nurbs
    arc = nurbs.Spline.bezier([[1, 0], [1, 1], [0, 1]], weights=[1, 0.5**0.5, 1])
    points = arc.eval(numpy.linspace(0, 1, 100))

The manual is the header nurbs.h; this package keeps its names, its indices from 0 and its flags. What differs:

- A failure raises NurbsError with `status`, `name` and `message`.
- Arrays have natural shapes: control points (counts..., dim), parameters of a curve (...), of a surface (..., 2),
  results (..., dim). Arrays of float64 with positive strides are passed without a copy, in either memory order; others
  are converted. Each evaluating method fills `out` if it is given.
- The interpreter's lock is released during every call, and one spline may be used by many threads at once.

The library is $NURBS_LIBRARY, a path to libnurbs.so, if that is set, else the system's libnurbs.so.1. The C functions
themselves are attributes of `nurbs.lib`.
"""

from ._library import NurbsError, last_error, lib, status_name, version
from .analysis import (BoundaryContacts, CurveFeatures, Fold, MonotonePieces, Planarity, SingularPoints, Straightness,
                       boundary_contacts, convexity, features, fold_test, monotone_pieces, planarity, singular_points,
                       straightness)
from .bounds import (Box, DirectionCone, ExtremePoint, OrientedBox, box, extreme_point, normal_cone, oriented_box,
                     tangent_cone)
from .closest import (ClosestAll, ClosestPoints, CriticalPoints, Distance, HausdorffDistance, SignedDistances,
                      closest_all, closest_local, closest_points, critical_points, distance, farthest_points,
                      hausdorff_distance, signed_distances)
from .compatible import Compatible, Snapped, make_compatible, snap_knots
from .constrain import Constrained, constrain
from .continuation import PeriodicForm, detect_periodic, extend, make_periodic, unclamp
from .continuity import EndContinuity, KnotContinuity, continuity, continuity_between
from .constants import *  # noqa: F401,F403 - the names of the header
from .coons import CoonsGaps, HermiteCoons, boundaries, coons, coons_gaps, coons_hermite, coons_volume
from .curves import (ConicAxes, Helix, ShapeFactor, arc, arc_tangent, arc_through, circle, conic_axes, conic_focus,
                     conic_implicit, conic_point, conic_shoulder, conic_through, conic_triangle, ellipse, helix,
                     hyperbola, line, parabola, polygon, polyline, rounded_rectangle, shape_factor)
from .deform import Deformed, Faired, bend, fair, flatten, free_form_deform, snap_boundary, warp
from .edit import (Influences, LegEdit, PointEdit, WeightEdit, WeightPoints, WeightsEdit, insert_at_point,
                   insert_on_leg, most_influential, pull_point, pull_weight, pull_weights, set_weights, weight_cross_ratio,
                   weight_points, weight_through)
from .files import Note, SplineList, read, read_file
from .calculus import (antiderivative, blossom, compose, derivative, equalize_end_weights, normalize_weights,
                       product, reparametrize_moebius, sum)
from .frames import (CurveFrames, Curvatures, MinimalFrames, SurfaceFrames, curve_frames, rotation_minimizing_frames,
                     surface_curvatures, surface_frames, surface_grid_frames)
from .knots import (basis, bernstein, find_spans, knots_averaged, knots_bezier, knots_open_uniform,
                    knots_periodic, knots_uniform)
from .linear import (Gradients, bezier_extraction, collocation, eval_adjoint, rational_collocation,
                     refinement_matrix)
from .measure import (Division, EnclosedArea, EnclosedVolume, Measured, Moments, area, divide, enclosed_area,
                      enclosed_volume, length, lengths, moments, params_at_lengths)
from .parts import Joined, decompose, join, split_at_knots
from .projections import mirror, project_from, project_to_plane
from .recognize import Recognized, recognize
from .segments import Hermite, PowerForm, basis_matrix, create_hermite, create_power, to_hermite, to_power
from .shapes import (bilinear, cone, cylinder, ellipsoid, extrude, hyperboloid, paraboloid, plane, revolve, ruled,
                     saddle, sphere, sphere_patches, spherical_patch, swung, tensor_product, tensor_sum, torus,
                     trilinear)
from .reduce import (Deviation, KnotRemoval, Reduced, deviation, reduce_degree, reduce_knots, remove_knot,
                     simplify)
from .spline import Spline, derivative_slots

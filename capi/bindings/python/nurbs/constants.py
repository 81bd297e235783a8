# SPDX-License-Identifier: MIT
# Generated from include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
"""The constants of nurbs.h, with its names and values, and its macros for flags."""

# --- Version and limits
NURBS_VERSION_MAJOR = 1  # Changes when programs built with an earlier version may stop working.
NURBS_VERSION_MINOR = 1  # Changes when functions, constants or options are added.
NURBS_VERSION_PATCH = 0  # Changes when defects are mended.
# major * 10000 + minor * 100 + patch, as returned by nurbs_version().
NURBS_VERSION = NURBS_VERSION_MAJOR * 10000 + NURBS_VERSION_MINOR * 100 + NURBS_VERSION_PATCH
NURBS_MAX_DEGREE = 31  # Highest degree accepted on any axis.
NURBS_MAX_AXES = 3  # Highest number of parametric axes.
NURBS_MAX_ORDER = 255  # Highest order of derivatives that the evaluating functions compute.

# --- Statuses
NURBS_OK = 0  # success
NURBS_ERROR_NULL = 1  # a required pointer is NULL
NURBS_ERROR_AXES = 2  # number of axes not 1 to 3, or not one that the function is for
NURBS_ERROR_AXIS = 3  # axis index not in [0, axes)
NURBS_ERROR_DEGREE = 4  # degree not in [0, NURBS_MAX_DEGREE]
NURBS_ERROR_COUNT = 5  # a count is negative, or zero where something is needed
NURBS_ERROR_TOO_FEW_POINTS = 6  # fewer control points than degree + 1
NURBS_ERROR_OVERFLOW = 7  # the sizes asked for do not fit in memory addresses
NURBS_ERROR_SIZE = 8  # a stated array length is not the one required
NURBS_ERROR_DIMENSION = 9  # dimension not in [1, 2^31 - 2], or not one allowed here
NURBS_ERROR_STRIDE = 10  # negative stride, or neither records nor components lie apart
NURBS_ERROR_OVERLAP = 11  # an output array overlaps another array
NURBS_ERROR_FLAGS = 12  # unknown flag bits, or flags that exclude each other
NURBS_ERROR_ORDER = 13  # derivative order not in [0, NURBS_MAX_ORDER]
NURBS_ERROR_KNOT_NOT_FINITE = 14  # a knot is NaN or infinite, or the knots' range overflows
NURBS_ERROR_KNOTS_DECREASING = 15  # a knot is smaller than the one before it
NURBS_ERROR_END_MULTIPLICITY = 16  # the first or last knot occurs more than degree + 1 times
NURBS_ERROR_MULTIPLICITY = 17  # an interior knot occurs, or would occur, more than degree + 1 times
NURBS_ERROR_EMPTY_DOMAIN = 18  # knots[degree] == knots[count], or an empty interval
NURBS_ERROR_POINT_NOT_FINITE = 19  # a coordinate is NaN or infinite
NURBS_ERROR_WEIGHT_NOT_FINITE = 20  # a weight is NaN or infinite
NURBS_ERROR_WEIGHT_NEGATIVE = 21  # a weight is < 0
NURBS_ERROR_WEIGHTS_VANISH = 22  # all weights that are active at some parameter are 0
NURBS_ERROR_PARAMETER_NOT_FINITE = 23  # a parameter is NaN or infinite
NURBS_ERROR_PERIODIC_KNOTS = 24  # knots of an axis flagged periodic do not repeat with the period
NURBS_ERROR_PERIODIC_POINTS = 25  # points or weights of an axis flagged periodic do not wrap bit for bit
NURBS_ERROR_TIMES = 26  # a number of repetitions is negative
NURBS_ERROR_OPTIONS = 27  # an options struct has a wrong size or a value out of range
NURBS_ERROR_INDEX = 28  # an index is outside its list
NURBS_ERROR_DIRECTION = 29  # a direction is zero, not finite, or parallel to another one
NURBS_ERROR_END_KNOT = 30  # a knot at an end of the domain, where it cannot be removed
NURBS_ERROR_NOT_A_KNOT = 31  # a value that has to be a knot of the axis is not one
NURBS_ERROR_MATRIX = 32  # an entry of a matrix or translation is NaN or infinite
NURBS_ERROR_RATIONAL = 33  # the spline is rational, which the function is not for
NURBS_ERROR_INCOMPATIBLE = 40  # splines differ in what they have to share
NURBS_ERROR_GAP = 41  # ends that are to be joined lie farther apart than the tolerance
NURBS_ERROR_TOLERANCE = 42  # a tolerance is negative or NaN, or otherwise out of range
NURBS_ERROR_NOT_PERIODIC = 43  # an axis that has to be periodic was not declared so
NURBS_ERROR_END_WEIGHTS = 44  # no one factor makes the weights at the ends of an axis equal
NURBS_ERROR_FACTOR = 45  # a factor is not finite, or not positive where it has to be
NURBS_ERROR_CONTINUITY = 46  # a knot is less smooth than the function needs
NURBS_ERROR_WEIGHT_SIGN = 47  # a weight of the result would not be positive
NURBS_ERROR_PERIODIC = 48  # an axis is periodic, which the function is not for
NURBS_ERROR_END = 49  # an end is neither NURBS_START nor NURBS_END
NURBS_ERROR_BASIS = 50  # not one of the NURBS_BASIS_ constants
NURBS_ERROR_NOT_MONOTONE = 51  # a function neither increases nor decreases strictly
NURBS_ERROR_ANGLE = 52  # an angle is not finite or above 2^22, or a sweep is 0 or above a turn
NURBS_ERROR_LENGTH = 53  # a radius or another length is not finite or out of range
NURBS_ERROR_COLLINEAR = 54  # points that must not be on a line are on one
NURBS_ERROR_CONIC = 55  # no conic, or no arc of one in one piece, fulfils the conditions
NURBS_ERROR_FORM = 56  # not one of the NURBS_ARC_ constants that are allowed here
NURBS_ERROR_TANGENT = 57  # tangents that have to agree differ by more than the tolerance
NURBS_ERROR_TWIST = 58  # twists that have to agree differ by more than the tolerance
NURBS_ERROR_TWIST_RULE = 59  # not one of the NURBS_TWIST_ constants, or one that does not suit
NURBS_ERROR_INFLUENCE = 60  # a control point has no influence at the parameter
NURBS_ERROR_CONTRADICTION = 61  # constraints contradict each other
NURBS_ERROR_CONSTRAINT = 62  # not one of the NURBS_CONSTRAIN_ constants
NURBS_ERROR_OFF_POLYGON = 63  # a point is not on the control polygon
NURBS_ERROR_RULE = 64  # not one of the constants of a rule, or one that does not suit
NURBS_ERROR_SCHOENBERG_WHITNEY = 65  # data lie outside the support of the control point that they have to determine
NURBS_ERROR_RANK = 66  # data or conditions do not determine the result
NURBS_ERROR_SCALE = 67  # a value or weight is above the scale of the statistics
NURBS_ERROR_ORIENTATION = 68  # loops of a face have no common inside, or enclose nothing
NURBS_ERROR_SAME = 69  # one handle where two different shapes are needed
NURBS_ERROR_CROSSING = 70  # loops of a face cross themselves or each other
NURBS_ERROR_OUTSIDE_DOMAIN = 100  # a parameter or knot lies outside the domain
NURBS_ERROR_NOT_REPRESENTABLE = 200  # a value of the result overflows double precision
NURBS_ERROR_KNOTS_MERGE = 202  # knots that differ would become equal or change their order
NURBS_ERROR_NOT_CONVERGED = 203  # an iteration did not reach its goal
NURBS_ERROR_MEMORY = 300  # an allocation failed
NURBS_ERROR_FILE = 301  # a file cannot be opened or read
NURBS_ERROR_TOO_LARGE = 302  # a file exceeds the size limit of the options
NURBS_ERROR_CANCELLED = 303  # the callback of a long call asked for its end
NURBS_ERROR_WORK = 304  # the limit of work of a long call was reached before its end
NURBS_ERROR_FORMAT = 400  # not a file of a known format
NURBS_ERROR_TRUNCATED = 401  # the file ends, or a section is missing, before its contents are complete
NURBS_ERROR_SYNTAX = 402  # the file breaks the rules of its format
NURBS_ERROR_UNSUPPORTED = 403  # an entity that this version does not read (only in notes)
NURBS_ERROR_CHECKSUM = 404  # bytes of a handle are not those that were written
NURBS_ERROR_VERSION = 405  # bytes of a handle have a later version of the form
NURBS_ERROR_CYCLE = 406  # entities of a file contain each other (only in notes)
NURBS_ERROR_INTERNAL = 900  # a defect of the library; please report it

# --- Flags by axis
NURBS_LEFT = 0x01  # Evaluation: at a knot take the limit from below.
NURBS_CLAMP = 0x02  # Evaluation: move a parameter outside the domain (infinite ones too) to the nearer end.
NURBS_EXTRAPOLATE = 0x04  # Evaluation: outside the domain continue the first or last polynomial piece.
# Evaluation: reduce the parameter by multiples of the domain's length; the start and the end are the same place, seen
# from the right unless NURBS_LEFT is set. Allowed on every axis, periodic or not.
NURBS_WRAP = 0x08
# Evaluation: a parameter that cannot be evaluated gives NaN instead of an error. NURBS_CLAMP, NURBS_EXTRAPOLATE and
# NURBS_WRAP exclude each other; each may be combined with NURBS_NAN.
NURBS_NAN = 0x10
# Creation: the axis is periodic with period knots[count] - knots[degree]: knots[i + m] = knots[i] + period to within
# the rounding of the largest knot, and the last `degree` layers of points and weights equal the first ones bit for bit,
# where m = count - degree is the number of distinct layers. Operations keep the axis periodic.
NURBS_PERIODIC = 0x01

# --- Global flags
# nurbs_eval_adjoint() and the other adjoints: add to what the outputs hold instead of overwriting it.
NURBS_ACCUMULATE = 0x01000000
NURBS_KEEP_DOMAIN = 0x02000000  # nurbs_reverse(): map the domain to itself instead of negating the parameter.
# nurbs_join(): ends that do not meet become a jump instead of an error; nurbs_face_create(): segments close what curves
# leave open.
NURBS_KEEP_GAPS = 0x04000000
NURBS_PRODUCT_DOT = 0x08000000  # nurbs_product(): the dot product.
NURBS_PRODUCT_CROSS = 0x10000000  # nurbs_product(): the cross product in dimension 3.
NURBS_HOMOGENEOUS = 0x20000000  # nurbs_create_power(), nurbs_unclamp(): homogeneous records (w x, w y, ..., w).
NURBS_MAP_DOMAINS = 0x40000000  # nurbs_make_compatible(): map the domains of all splines to that of the first one.
NURBS_EQUAL_CHORDS = 0x02000000  # nurbs_curve_divide(): equal distances of consecutive points instead of equal lengths.
NURBS_REVERSED = 0x04000000  # nurbs_snap_boundary(): the two boundaries run against each other.
# nurbs_closest_points() and its neighbours: a point that is not finite gives NaN instead of an error.
NURBS_NAN_POINTS = 0x01000000
NURBS_AS_ORIENTED = 0x01000000  # nurbs_face_create(): the inside is to the left of the loops as they run.
NURBS_CHECK_CROSSINGS = 0x02000000  # nurbs_face_create(): loops that cross themselves or each other are refused.

# --- Form of a knot vector, as reported by nurbs_knot_form()
NURBS_FORM_CLAMPED_START = 0x01  # the first degree + 1 knots are equal
NURBS_FORM_CLAMPED_END = 0x02  # the last degree + 1 knots are equal
NURBS_FORM_PERIODIC = 0x04  # the axis was declared periodic

# --- Bases of a polynomial segment, for nurbs_basis_matrix()
NURBS_BASIS_POWER = 0  # 1, t, t^2, ...
NURBS_BASIS_BERNSTEIN = 1  # the Bezier points over [0, 1]
NURBS_BASIS_HERMITE = 2  # f(0), f'(0), ..., then f(1), f'(1), ...; odd degrees
NURBS_BASIS_BSPLINE = 3  # control points over the knots -degree, ..., degree + 1

# --- Rules for parameters, for nurbs_parametrize()
NURBS_PARAMS_UNIFORM = 0  # equal steps
NURBS_PARAMS_CHORD = 1  # steps in proportion to the chords
NURBS_PARAMS_CENTRIPETAL = 2  # steps in proportion to the square roots of the chords (Lee 1989)
NURBS_PARAMS_POWER = 3  # steps in proportion to a power of the chords
NURBS_PARAMS_FOLEY_NIELSON = 4  # steps in proportion to the chords, longer where the polygon turns

# --- Ends of an interpolating spline, for nurbs_interpolate()
NURBS_ENDS_NOT_A_KNOT = 0  # the parameters next to the end are not knots
NURBS_ENDS_NATURAL = 1  # derivatives of orders (degree + 1) / 2 to degree - 1 vanish; odd degrees
NURBS_ENDS_FREE = 2  # knots averaged from the parameters (nurbs_knots_averaged()); both ends

# --- Special orders of derivatives, for nurbs_curve_interpolate()
NURBS_ORDER_DIRECTION = -1  # the first derivative has the direction of the target, of any length

# --- How smooth a fit is, for nurbs_fit_options
NURBS_SMOOTHING_NONE = 0  # only the data count
NURBS_SMOOTHING_LAMBDA = 1  # the factor of the penalty is given
NURBS_SMOOTHING_GCV = 2  # by generalised cross validation (Craven & Wahba 1979)
NURBS_SMOOTHING_REML = 3  # by restricted maximum likelihood (Wood 2011)
NURBS_SMOOTHING_DISCREPANCY = 4  # as smooth as a given sum of squares allows (Reinsch 1967)

# --- How much outliers count, for nurbs_fit_options
NURBS_ROBUST_NONE = 0  # as much as other data
NURBS_ROBUST_HUBER = 1  # their weight times min(1, 1 / x) (Huber 1964)
NURBS_ROBUST_TUKEY = 2  # their weight times (1 - x^2)^2 for x < 1, else 0 (Beaton & Tukey 1974)

# --- Shapes along an axis, for nurbs_fit_options; they can be added
NURBS_TREND_RISING = 0x01  # the first derivative is >= 0
NURBS_TREND_FALLING = 0x02  # the first derivative is <= 0
NURBS_TREND_CONVEX = 0x04  # the first derivative does not fall
NURBS_TREND_CONCAVE = 0x08  # the first derivative does not rise

# --- Bits of nurbs_fit_report
NURBS_FIT_TARGET_MISSED = 0x01  # the target, or the tolerance, is not reached
NURBS_FIT_NOT_CONVERGED = 0x02  # the last round of a robust fit, or of a shape, still changed it

# --- Bits of nurbs_cloud_report
NURBS_CLOUD_NOT_CONVERGED = 0x01  # the rounds, or the limit of work, ended while the sum was still falling

# --- Rules for tangents, for nurbs_tangents()
NURBS_TANGENTS_CATMULL_ROM = 0  # the slope between the neighbours
NURBS_TANGENTS_BESSEL = 1  # the slope of the parabola through a point and its neighbours
NURBS_TANGENTS_AKIMA = 2  # mean of both slopes, weighted by their steadiness (Akima 1970)
NURBS_TANGENTS_MONOTONE = 3  # each coordinate rises and falls as the data do (Fritsch & Butland 1984)

# --- Ends of an axis
NURBS_START = 0  # the lower end of the domain
NURBS_END = 1  # the upper end of the domain

# --- Status of a point
NURBS_FRAME_LIMIT = 0x01  # tangent of a curve, normal of a surface: a one-sided limit
NURBS_FRAME_NORMAL_LIMIT = 0x02  # normal of a curve in space: a one-sided limit
NURBS_FRAME_RULE = 0x04  # nothing distinguishes a direction: the function's rule chose it
NURBS_FRAME_UNDEFINED = 0x08  # some result does not exist and is NaN

# --- Forms of an arc
NURBS_ARC_QUARTERS = 0  # degree 2, equal pieces of at most a quarter turn
NURBS_ARC_THIRDS = 1  # degree 2, equal pieces of at most a third of a turn
NURBS_ARC_SMOOTH = 2  # One polynomial piece: degree 2 up to a third of a turn, degree 5 beyond; weights are positive.

# --- Kinds of conics
NURBS_CONIC_ELLIPSE = 1  # shape factor below 1
NURBS_CONIC_PARABOLA = 2  # shape factor 1
NURBS_CONIC_HYPERBOLA = 3  # shape factor above 1
NURBS_CONIC_CHORD = 4  # degenerate: shape factor 0, the segment P0 P2
NURBS_CONIC_LEGS = 5  # degenerate: shape factor infinite, the segments P0 P1 and P1 P2
NURBS_CONIC_LINE = 6  # degenerate: P0, P1 and P2 on a line

# --- Flags of constructions
# nurbs_ruled(): rulings of Cartesian points, divided evenly, not those of homogeneous ones.
NURBS_RULED_CARTESIAN = 0x80000000
NURBS_HEMISPHERE = 0x01000000  # nurbs_surface_sphere_patches(): the half towards Z.
NURBS_TWO_SHEETS = 0x02000000  # nurbs_surface_hyperboloid(): the hyperboloid of two sheets.

# --- Twists of nurbs_surface_coons_hermite()
NURBS_TWIST_COMPATIBLE = 0  # both, which must agree to the tolerance
NURBS_TWIST_AVERAGE = 1  # their mean
NURBS_TWIST_GIVEN = 2  # the ones given
NURBS_TWIST_ZERO = 3  # zero (Ferguson's patch)
NURBS_TWIST_BILINEAR = 4  # that of the bilinear patch of the corners
NURBS_TWIST_ADINI = 5  # that of the bilinear Coons surface of the boundaries (Adini's twist)

# --- Shapes
NURBS_SHAPE_NONE = 0  # none of these, to the tolerance
NURBS_SHAPE_POINT = 1  # a single point
NURBS_SHAPE_LINE = 2  # a piece of a straight line
NURBS_SHAPE_CIRCLE = 3  # a circle, or an arc of one
NURBS_SHAPE_ELLIPSE = 4  # an ellipse, or an arc of one
NURBS_SHAPE_PARABOLA = 5  # an arc of a parabola
NURBS_SHAPE_HYPERBOLA = 6  # an arc of one branch of a hyperbola
NURBS_SHAPE_PLANE = 7  # a piece of a plane
NURBS_SHAPE_SPHERE = 8  # a sphere, or a piece of one
NURBS_SHAPE_CYLINDER = 9  # a piece of a circular cylinder
NURBS_SHAPE_CONE = 10  # a piece of one half of a circular cone
NURBS_SHAPE_TORUS = 11  # a torus, or a piece of one
NURBS_SHAPE_REVOLUTION = 12  # a surface of revolution; of models only, as those that follow
NURBS_SHAPE_EXTRUSION = 13  # a curve moved along a vector
NURBS_SHAPE_OFFSET = 14  # at a distance from another surface

# --- Status of a closest point
NURBS_CLOSEST_CERTIFIED = 0x01  # proven to be the nearest, or farthest, point to the tolerance
NURBS_CLOSEST_BOUNDARY = 0x02  # on an end or an edge of the domain, or of range
NURBS_CLOSEST_NOT_UNIQUE = 0x04  # points elsewhere are as near to the tolerance
NURBS_CLOSEST_BUDGET = 0x08  # the budget ended before a proof was found
NURBS_CLOSEST_INVALID = 0x10  # the query point is not finite; results are NaN
NURBS_CLOSEST_COARSE = 0x20  # proven, but rounding the parameters moves the point by more
NURBS_CLOSEST_SINGULAR = 0x40  # of nurbs_closest_adjoint(): the gradient is not determined
NURBS_CLOSEST_LEFT = 0x100  # NURBS_LEFT is meant on axis 0; 0x200 on axis 1, 0x400 on axis 2

# --- Kind of a critical point
NURBS_CRITICAL_MINIMUM = 1  # a local minimum of the distance
NURBS_CRITICAL_MAXIMUM = 2  # a local maximum of the distance
NURBS_CRITICAL_SADDLE = 3  # neither
NURBS_CRITICAL_UNDECIDED = 4  # rounding leaves the kind open

# --- Features of curves
NURBS_FEATURE_INFLECTION = 0x01  # the curvature changes its sign; in space: it vanishes
NURBS_FEATURE_CURVATURE_MAXIMUM = 0x02  # a local maximum of |curvature|
NURBS_FEATURE_CURVATURE_MINIMUM = 0x04  # a local minimum of |curvature|, where it is not 0
NURBS_FEATURE_CUSP = 0x08  # the first derivative vanishes
NURBS_FEATURE_KINK = 0x10  # a knot where the direction of the tangent jumps
NURBS_FEATURE_JUMP = 0x20  # a knot where the curve jumps
NURBS_FEATURE_TORSION = 0x40  # the torsion changes its sign (dimension 3)

# --- Kinds of extrema
NURBS_EXTREMUM_MINIMUM = 0x01  # no value beside it is smaller
NURBS_EXTREMUM_MAXIMUM = 0x02  # no value beside it is larger
NURBS_EXTREMUM_SADDLE = 0x04  # f turns up along some axes, and down along others
NURBS_EXTREMUM_PLATEAU = 0x08  # f is constant in the range
NURBS_EXTREMUM_UNDECIDED = 0x10  # a range in which it is not decided what there is

# --- Convexity of a curve in the plane
NURBS_CONVEXITY_NONE = 0  # turns both ways, or through more than a full turn, or has a cusp
NURBS_CONVEXITY_LEFT = 1  # turns to the left only, by at most a full turn
NURBS_CONVEXITY_RIGHT = 2  # turns to the right only, by at most a full turn
NURBS_CONVEXITY_STRAIGHT = 3  # a straight line that does not turn back, to rounding
NURBS_CONVEXITY_UNDECIDED = 4  # double precision cannot decide

# --- Folds
NURBS_FOLD_NONE = 0  # proven: there is none
NURBS_FOLD_FOUND = 1  # proven: there is one
NURBS_FOLD_UNDECIDED = 2  # neither

# --- Kinds of hits
NURBS_HIT_CROSSING = 1  # passes from one side to the other, or has an end there
NURBS_HIT_TANGENT = 2  # a touch, as far as rounding and the tolerance can tell
NURBS_HIT_CONTACT = 3  # within the tolerance, but proven apart: the nearest place
NURBS_HIT_OVERLAP = 4  # within the tolerance in the whole range, which is a span or more
NURBS_HIT_JUMP = 5  # changes sides where the curve jumps, without meeting anything
NURBS_HIT_UNDECIDED = 6  # a range in which it is not decided what there is

# --- Status of a ray
NURBS_RAY_HIT = 0x01  # the ray meets the surface there, to rounding
NURBS_RAY_CERTIFIED = 0x02  # nothing is nearer; without NURBS_RAY_HIT: it meets nothing
NURBS_RAY_TOUCH = 0x04  # it touches the surface there or just misses it: rounding cannot tell
NURBS_RAY_BACK = 0x08  # it arrives from behind: from the side to which S_u x S_v does not point

# --- Kinds of nodes of a nurbs_meet
NURBS_NODE_BORDER = 1  # the surface ends or jumps there
NURBS_NODE_SEAM = 2  # it closes there on a non-periodic axis: the branch continues beyond
NURBS_NODE_TOUCH = 3  # a part within the tolerance in which branches are not separated
NURBS_NODE_UNDECIDED = 4  # a part in which it is not decided what there is
NURBS_NODE_EDGE = 5  # an edge, a corner or a pole of faces of a model, where another branch continues
NURBS_NODE_FOLD = 6  # the surface folds, seen along the direction of a projection, or feet do: another sheet continues
NURBS_NODE_OVERLAP = 7  # a region in which two surfaces are within the tolerance of each other; no branch ends there

# --- Kinds of contours
NURBS_CONTOUR_SILHOUETTE = 1  # f = N . d: the outline seen along d
NURBS_CONTOUR_PERSPECTIVE = 2  # f = N . (S - d): the outline seen from the point d
NURBS_CONTOUR_ISOPHOTE = 3  # (N . d)^2 = c^2 |N|^2 |d|^2 where N . d has the sign of c: normals at one angle to d
NURBS_CONTOUR_PARABOLIC = 4  # f = K, the Gaussian curvature, up to a positive factor

# --- Kinds of reflection lines
NURBS_REFLECTION_HIGHLIGHT = 1  # f = N . m: the line along the normal meets the line of light
NURBS_REFLECTION_ALONG = 2  # f = (N . N) (v . m) - 2 (N . v) (N . m), v = eye: the mirrored line of sight meets it
NURBS_REFLECTION_FROM = 3  # the same with v = S - eye: seen from the point eye

# --- Kinds of branches
NURBS_BRANCH_CROSSING = 1  # a curve that surfaces, or a surface and a plane, have in common
NURBS_BRANCH_EDGE = 2  # an edge that two faces share
NURBS_BRANCH_CONTACT = 3  # an edge that two faces share, with the same tangent planes somewhere at least
NURBS_BRANCH_TOUCH = 4  # a curve along which surfaces touch: they have the same tangent planes
NURBS_BRANCH_OVERLAP = 5  # a part of the boundary of a region in which surfaces coincide

# --- Kinds of constraints
NURBS_CONSTRAIN_VALUE = 0  # the derivative of the given orders is the target; orders 0: the point
NURBS_CONSTRAIN_DIRECTION = 1  # the derivative is parallel to the target, either way
NURBS_CONSTRAIN_NORMAL = 2  # all first derivatives are perpendicular to the target
NURBS_CONSTRAIN_CURVATURE = 3  # the curvature vector (C'' - (C'' T) T) / |C'|^2 of a curve is the target

# --- What files are read for
NURBS_READ_CURVES = 0x1  # curves: in lists all, also those of edges; in models those that are part of no face or edge
# surfaces: in lists all, also those of faces; in models those that are part of no face (STEP)
NURBS_READ_SURFACES = 0x2
NURBS_READ_FACES = 0x4  # faces of models with their edges and vertices, and other edges; in IGES also surfaces alone

# --- Kinds of handles
NURBS_BYTES_SPLINE = 1  # a spline: nurbs_from_bytes()
NURBS_BYTES_LIST = 2  # a list: nurbs_list_from_bytes()
NURBS_BYTES_STATISTICS = 3  # statistics: nurbs_statistics_from_bytes()
NURBS_BYTES_FACE = 4  # a face: nurbs_face_from_bytes()
NURBS_BYTES_MODEL = 5  # a model: nurbs_model_from_bytes()

# --- Sides of a model
NURBS_SIDE_INSIDE = 1  # inside a solid, for certain
NURBS_SIDE_ON = 0  # no farther from a face than the tolerance
NURBS_SIDE_OUTSIDE = -1  # outside all solids, for certain
NURBS_SIDE_UNDECIDED = 2  # not known

# --- What is inside of closed curves
NURBS_FILL_NON_ZERO = 1  # a winding number other than 0
NURBS_FILL_EVEN_ODD = 2  # an odd winding number
NURBS_FILL_POSITIVE = 3  # a winding number above 0

# --- What is made of two regions
NURBS_REGION_UNION = 1  # what is in a or in b
NURBS_REGION_INTERSECTION = 2  # what is in a and in b
NURBS_REGION_DIFFERENCE = 3  # what is in a and not in b
NURBS_REGION_EITHER = 4  # what is in a or in b and not in both: the symmetric difference

# --- Which side of a surface is kept
NURBS_TRIM_FRONT = 1  # the side to which its normals N = S_u x S_v point
NURBS_TRIM_BACK = -1  # the other side

# --- Flags of meshes
NURBS_MESH_WELDED = 0x01000000  # nurbs_mesh_triangles() and similar functions: corners are points, not vertices.

# --- Formats of files
NURBS_FORMAT_STEP = 1  # STEP: an exchange structure of ISO 10303-21, by AP214
NURBS_FORMAT_IGES = 2  # IGES 5.3 in lines of 80 columns
NURBS_FORMAT_STL = 3  # Triangles: binary STL
NURBS_FORMAT_STL_TEXT = 4  # Triangles: STL as text
NURBS_FORMAT_OBJ = 5  # Triangles: Wavefront OBJ
NURBS_FORMAT_PLY = 6  # Triangles: PLY, binary, little-endian
NURBS_FORMAT_GLB = 7  # Triangles: glTF 2.0 in one binary file
NURBS_FORMAT_VTU = 8  # Triangles: an unstructured grid of VTK in XML, with raw arrays appended


def on_axis(axis: int, flags: int) -> int:
    """The bits `flags` moved to those of `axis`: the macro NURBS_ON_AXIS."""
    return flags << (8 * axis)


def on_all_axes(axes: int, flags: int) -> int:
    """The bits `flags` for the first `axes` axes (1, 2 or 3): the macro NURBS_ON_ALL_AXES."""
    return flags * (0x010101 >> (8 * (3 - axes)))

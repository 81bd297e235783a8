! SPDX-License-Identifier: MIT
!> The constants of nurbs.h, with its names and values.
module nurbs_constants
    use, intrinsic :: iso_c_binding, only: c_int32_t
    implicit none
    public

    ! The macro NURBS_VERSION under another name: Fortran does not tell it from the function nurbs_version.
    integer(c_int32_t), parameter :: NURBS_VERSION_MAJOR = 1, NURBS_VERSION_MINOR = 0, NURBS_VERSION_PATCH = 0
    integer(c_int32_t), parameter :: NURBS_HEADER_VERSION = &
        NURBS_VERSION_MAJOR * 10000 + NURBS_VERSION_MINOR * 100 + NURBS_VERSION_PATCH

    integer(c_int32_t), parameter :: NURBS_MAX_DEGREE = 31
    integer(c_int32_t), parameter :: NURBS_MAX_AXES = 3
    integer(c_int32_t), parameter :: NURBS_MAX_ORDER = 255

    ! Statuses
    integer(c_int32_t), parameter :: NURBS_OK = 0
    integer(c_int32_t), parameter :: NURBS_ERROR_NULL = 1
    integer(c_int32_t), parameter :: NURBS_ERROR_AXES = 2
    integer(c_int32_t), parameter :: NURBS_ERROR_AXIS = 3
    integer(c_int32_t), parameter :: NURBS_ERROR_DEGREE = 4
    integer(c_int32_t), parameter :: NURBS_ERROR_COUNT = 5
    integer(c_int32_t), parameter :: NURBS_ERROR_TOO_FEW_POINTS = 6
    integer(c_int32_t), parameter :: NURBS_ERROR_OVERFLOW = 7
    integer(c_int32_t), parameter :: NURBS_ERROR_SIZE = 8
    integer(c_int32_t), parameter :: NURBS_ERROR_DIMENSION = 9
    integer(c_int32_t), parameter :: NURBS_ERROR_STRIDE = 10
    integer(c_int32_t), parameter :: NURBS_ERROR_OVERLAP = 11
    integer(c_int32_t), parameter :: NURBS_ERROR_FLAGS = 12
    integer(c_int32_t), parameter :: NURBS_ERROR_ORDER = 13
    integer(c_int32_t), parameter :: NURBS_ERROR_KNOT_NOT_FINITE = 14
    integer(c_int32_t), parameter :: NURBS_ERROR_KNOTS_DECREASING = 15
    integer(c_int32_t), parameter :: NURBS_ERROR_END_MULTIPLICITY = 16
    integer(c_int32_t), parameter :: NURBS_ERROR_MULTIPLICITY = 17
    integer(c_int32_t), parameter :: NURBS_ERROR_EMPTY_DOMAIN = 18
    integer(c_int32_t), parameter :: NURBS_ERROR_POINT_NOT_FINITE = 19
    integer(c_int32_t), parameter :: NURBS_ERROR_WEIGHT_NOT_FINITE = 20
    integer(c_int32_t), parameter :: NURBS_ERROR_WEIGHT_NEGATIVE = 21
    integer(c_int32_t), parameter :: NURBS_ERROR_WEIGHTS_VANISH = 22
    integer(c_int32_t), parameter :: NURBS_ERROR_PARAMETER_NOT_FINITE = 23
    integer(c_int32_t), parameter :: NURBS_ERROR_PERIODIC_KNOTS = 24
    integer(c_int32_t), parameter :: NURBS_ERROR_PERIODIC_POINTS = 25
    integer(c_int32_t), parameter :: NURBS_ERROR_TIMES = 26
    integer(c_int32_t), parameter :: NURBS_ERROR_OPTIONS = 27
    integer(c_int32_t), parameter :: NURBS_ERROR_INDEX = 28
    integer(c_int32_t), parameter :: NURBS_ERROR_DIRECTION = 29
    integer(c_int32_t), parameter :: NURBS_ERROR_END_KNOT = 30
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_A_KNOT = 31
    integer(c_int32_t), parameter :: NURBS_ERROR_MATRIX = 32
    integer(c_int32_t), parameter :: NURBS_ERROR_RATIONAL = 33
    integer(c_int32_t), parameter :: NURBS_ERROR_INCOMPATIBLE = 40
    integer(c_int32_t), parameter :: NURBS_ERROR_GAP = 41
    integer(c_int32_t), parameter :: NURBS_ERROR_TOLERANCE = 42
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_PERIODIC = 43
    integer(c_int32_t), parameter :: NURBS_ERROR_END_WEIGHTS = 44
    integer(c_int32_t), parameter :: NURBS_ERROR_FACTOR = 45
    integer(c_int32_t), parameter :: NURBS_ERROR_PERIODIC = 48
    integer(c_int32_t), parameter :: NURBS_ERROR_END = 49
    integer(c_int32_t), parameter :: NURBS_ERROR_BASIS = 50
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_MONOTONE = 51
    integer(c_int32_t), parameter :: NURBS_ERROR_CONTINUITY = 46
    integer(c_int32_t), parameter :: NURBS_ERROR_WEIGHT_SIGN = 47
    integer(c_int32_t), parameter :: NURBS_ERROR_ANGLE = 52
    integer(c_int32_t), parameter :: NURBS_ERROR_LENGTH = 53
    integer(c_int32_t), parameter :: NURBS_ERROR_COLLINEAR = 54
    integer(c_int32_t), parameter :: NURBS_ERROR_CONIC = 55
    integer(c_int32_t), parameter :: NURBS_ERROR_FORM = 56
    integer(c_int32_t), parameter :: NURBS_ERROR_TANGENT = 57
    integer(c_int32_t), parameter :: NURBS_ERROR_TWIST = 58
    integer(c_int32_t), parameter :: NURBS_ERROR_TWIST_RULE = 59
    integer(c_int32_t), parameter :: NURBS_ERROR_INFLUENCE = 60
    integer(c_int32_t), parameter :: NURBS_ERROR_CONTRADICTION = 61
    integer(c_int32_t), parameter :: NURBS_ERROR_CONSTRAINT = 62
    integer(c_int32_t), parameter :: NURBS_ERROR_OFF_POLYGON = 63
    integer(c_int32_t), parameter :: NURBS_ERROR_OUTSIDE_DOMAIN = 100
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_REPRESENTABLE = 200
    integer(c_int32_t), parameter :: NURBS_ERROR_KNOTS_MERGE = 202
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_CONVERGED = 203
    integer(c_int32_t), parameter :: NURBS_ERROR_MEMORY = 300
    integer(c_int32_t), parameter :: NURBS_ERROR_FILE = 301
    integer(c_int32_t), parameter :: NURBS_ERROR_TOO_LARGE = 302
    integer(c_int32_t), parameter :: NURBS_ERROR_FORMAT = 400
    integer(c_int32_t), parameter :: NURBS_ERROR_TRUNCATED = 401
    integer(c_int32_t), parameter :: NURBS_ERROR_SYNTAX = 402
    integer(c_int32_t), parameter :: NURBS_ERROR_UNSUPPORTED = 403
    integer(c_int32_t), parameter :: NURBS_ERROR_INTERNAL = 900

    ! Flags of one axis, to be moved with nurbs_on_axis() or nurbs_on_all_axes()
    integer(c_int32_t), parameter :: NURBS_LEFT = int(z'01', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_CLAMP = int(z'02', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_EXTRAPOLATE = int(z'04', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_WRAP = int(z'08', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_NAN = int(z'10', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_PERIODIC = int(z'01', c_int32_t)

    ! Global flags
    integer(c_int32_t), parameter :: NURBS_ACCUMULATE = int(z'01000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_KEEP_DOMAIN = int(z'02000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_KEEP_GAPS = int(z'04000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_PRODUCT_DOT = int(z'08000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_PRODUCT_CROSS = int(z'10000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_HOMOGENEOUS = int(z'20000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_MAP_DOMAINS = int(z'40000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_RULED_CARTESIAN = int(z'80000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_HEMISPHERE = int(z'01000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_TWO_SHEETS = int(z'02000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_EQUAL_CHORDS = int(z'02000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_REVERSED = int(z'04000000', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_NAN_POINTS = int(z'01000000', c_int32_t)

    ! Bases of a polynomial segment
    integer(c_int32_t), parameter :: NURBS_BASIS_POWER = 0
    integer(c_int32_t), parameter :: NURBS_BASIS_BERNSTEIN = 1
    integer(c_int32_t), parameter :: NURBS_BASIS_HERMITE = 2
    integer(c_int32_t), parameter :: NURBS_BASIS_BSPLINE = 3

    ! Ends of an axis
    integer(c_int32_t), parameter :: NURBS_START = 0
    integer(c_int32_t), parameter :: NURBS_END = 1

    ! Bits of the form of a knot vector
    integer(c_int32_t), parameter :: NURBS_FORM_CLAMPED_START = int(z'01', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FORM_CLAMPED_END = int(z'02', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FORM_PERIODIC = int(z'04', c_int32_t)

    ! Bits of the status of a point of a frame
    integer(c_int32_t), parameter :: NURBS_FRAME_LIMIT = int(z'01', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FRAME_NORMAL_LIMIT = int(z'02', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FRAME_RULE = int(z'04', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FRAME_UNDEFINED = int(z'08', c_int32_t)

    ! Forms of an arc
    integer(c_int32_t), parameter :: NURBS_ARC_QUARTERS = 0
    integer(c_int32_t), parameter :: NURBS_ARC_THIRDS = 1
    integer(c_int32_t), parameter :: NURBS_ARC_SMOOTH = 2

    ! Kinds of conics
    integer(c_int32_t), parameter :: NURBS_CONIC_ELLIPSE = 1
    integer(c_int32_t), parameter :: NURBS_CONIC_PARABOLA = 2
    integer(c_int32_t), parameter :: NURBS_CONIC_HYPERBOLA = 3
    integer(c_int32_t), parameter :: NURBS_CONIC_CHORD = 4
    integer(c_int32_t), parameter :: NURBS_CONIC_LEGS = 5
    integer(c_int32_t), parameter :: NURBS_CONIC_LINE = 6

    ! Twists of a bicubic Coons surface
    integer(c_int32_t), parameter :: NURBS_TWIST_COMPATIBLE = 0
    integer(c_int32_t), parameter :: NURBS_TWIST_AVERAGE = 1
    integer(c_int32_t), parameter :: NURBS_TWIST_GIVEN = 2
    integer(c_int32_t), parameter :: NURBS_TWIST_ZERO = 3
    integer(c_int32_t), parameter :: NURBS_TWIST_BILINEAR = 4
    integer(c_int32_t), parameter :: NURBS_TWIST_ADINI = 5

    ! Shapes that are recognized
    integer(c_int32_t), parameter :: NURBS_SHAPE_NONE = 0
    integer(c_int32_t), parameter :: NURBS_SHAPE_POINT = 1
    integer(c_int32_t), parameter :: NURBS_SHAPE_LINE = 2
    integer(c_int32_t), parameter :: NURBS_SHAPE_CIRCLE = 3
    integer(c_int32_t), parameter :: NURBS_SHAPE_ELLIPSE = 4
    integer(c_int32_t), parameter :: NURBS_SHAPE_PARABOLA = 5
    integer(c_int32_t), parameter :: NURBS_SHAPE_HYPERBOLA = 6
    integer(c_int32_t), parameter :: NURBS_SHAPE_PLANE = 7
    integer(c_int32_t), parameter :: NURBS_SHAPE_SPHERE = 8
    integer(c_int32_t), parameter :: NURBS_SHAPE_CYLINDER = 9
    integer(c_int32_t), parameter :: NURBS_SHAPE_CONE = 10
    integer(c_int32_t), parameter :: NURBS_SHAPE_TORUS = 11

    ! Bits of the status of a closest point
    integer(c_int32_t), parameter :: NURBS_CLOSEST_CERTIFIED = int(z'01', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_CLOSEST_BOUNDARY = int(z'02', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_CLOSEST_NOT_UNIQUE = int(z'04', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_CLOSEST_BUDGET = int(z'08', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_CLOSEST_INVALID = int(z'10', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_CLOSEST_COARSE = int(z'20', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_CLOSEST_LEFT = int(z'100', c_int32_t)

    ! Kinds of critical points
    integer(c_int32_t), parameter :: NURBS_CRITICAL_MINIMUM = 1
    integer(c_int32_t), parameter :: NURBS_CRITICAL_MAXIMUM = 2
    integer(c_int32_t), parameter :: NURBS_CRITICAL_SADDLE = 3
    integer(c_int32_t), parameter :: NURBS_CRITICAL_UNDECIDED = 4

    ! Features of curves
    integer(c_int32_t), parameter :: NURBS_FEATURE_INFLECTION = int(z'01', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FEATURE_CURVATURE_MAXIMUM = int(z'02', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FEATURE_CURVATURE_MINIMUM = int(z'04', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FEATURE_CUSP = int(z'08', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FEATURE_KINK = int(z'10', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FEATURE_JUMP = int(z'20', c_int32_t)
    integer(c_int32_t), parameter :: NURBS_FEATURE_TORSION = int(z'40', c_int32_t)

    ! Convexity of a curve in the plane
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_NONE = 0
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_LEFT = 1
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_RIGHT = 2
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_STRAIGHT = 3
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_UNDECIDED = 4

    ! Folds
    integer(c_int32_t), parameter :: NURBS_FOLD_NONE = 0
    integer(c_int32_t), parameter :: NURBS_FOLD_FOUND = 1
    integer(c_int32_t), parameter :: NURBS_FOLD_UNDECIDED = 2

    ! Kinds of constraints
    integer(c_int32_t), parameter :: NURBS_CONSTRAIN_VALUE = 0
    integer(c_int32_t), parameter :: NURBS_CONSTRAIN_DIRECTION = 1
    integer(c_int32_t), parameter :: NURBS_CONSTRAIN_NORMAL = 2
    integer(c_int32_t), parameter :: NURBS_CONSTRAIN_CURVATURE = 3
end module nurbs_constants

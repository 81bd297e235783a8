! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
!> The constants of nurbs.h, with its names and values. NURBS_VERSION is called NURBS_HEADER_VERSION, because Fortran
!> does not tell it from the function nurbs_version.
module nurbs_constants
    use, intrinsic :: iso_c_binding, only: c_int32_t
    implicit none
    public

    ! --- Version and limits
    ! Changes when programs built with an earlier version may stop working.
    integer(c_int32_t), parameter :: NURBS_VERSION_MAJOR = 1
    ! Changes when functions, constants or options are added.
    integer(c_int32_t), parameter :: NURBS_VERSION_MINOR = 1
    integer(c_int32_t), parameter :: NURBS_VERSION_PATCH = 0  ! Changes when defects are mended.
    ! major * 10000 + minor * 100 + patch, as returned by nurbs_version().
    integer(c_int32_t), parameter :: NURBS_HEADER_VERSION = &
        NURBS_VERSION_MAJOR * 10000 + NURBS_VERSION_MINOR * 100 + NURBS_VERSION_PATCH
    integer(c_int32_t), parameter :: NURBS_MAX_DEGREE = 31  ! Highest degree accepted on any axis.
    integer(c_int32_t), parameter :: NURBS_MAX_AXES = 3  ! Highest number of parametric axes.
    ! Highest order of derivatives that the evaluating functions compute.
    integer(c_int32_t), parameter :: NURBS_MAX_ORDER = 255

    ! --- Statuses
    integer(c_int32_t), parameter :: NURBS_OK = 0  ! success
    integer(c_int32_t), parameter :: NURBS_ERROR_NULL = 1  ! a required pointer is NULL
    ! number of axes not 1 to 3, or not one that the function is for
    integer(c_int32_t), parameter :: NURBS_ERROR_AXES = 2
    integer(c_int32_t), parameter :: NURBS_ERROR_AXIS = 3  ! axis index not in [0, axes)
    integer(c_int32_t), parameter :: NURBS_ERROR_DEGREE = 4  ! degree not in [0, NURBS_MAX_DEGREE]
    ! a count is negative, or zero where something is needed
    integer(c_int32_t), parameter :: NURBS_ERROR_COUNT = 5
    integer(c_int32_t), parameter :: NURBS_ERROR_TOO_FEW_POINTS = 6  ! fewer control points than degree + 1
    ! the sizes asked for do not fit in memory addresses
    integer(c_int32_t), parameter :: NURBS_ERROR_OVERFLOW = 7
    integer(c_int32_t), parameter :: NURBS_ERROR_SIZE = 8  ! a stated array length is not the one required
    ! dimension not in [1, 2^31 - 2], or not one allowed here
    integer(c_int32_t), parameter :: NURBS_ERROR_DIMENSION = 9
    ! negative stride, or neither records nor components lie apart
    integer(c_int32_t), parameter :: NURBS_ERROR_STRIDE = 10
    integer(c_int32_t), parameter :: NURBS_ERROR_OVERLAP = 11  ! an output array overlaps another array
    ! unknown flag bits, or flags that exclude each other
    integer(c_int32_t), parameter :: NURBS_ERROR_FLAGS = 12
    integer(c_int32_t), parameter :: NURBS_ERROR_ORDER = 13  ! derivative order not in [0, NURBS_MAX_ORDER]
    ! a knot is NaN or infinite, or the knots' range overflows
    integer(c_int32_t), parameter :: NURBS_ERROR_KNOT_NOT_FINITE = 14
    ! a knot is smaller than the one before it
    integer(c_int32_t), parameter :: NURBS_ERROR_KNOTS_DECREASING = 15
    ! the first or last knot occurs more than degree + 1 times
    integer(c_int32_t), parameter :: NURBS_ERROR_END_MULTIPLICITY = 16
    ! an interior knot occurs, or would occur, more than degree + 1 times
    integer(c_int32_t), parameter :: NURBS_ERROR_MULTIPLICITY = 17
    ! knots[degree] == knots[count], or an empty interval
    integer(c_int32_t), parameter :: NURBS_ERROR_EMPTY_DOMAIN = 18
    integer(c_int32_t), parameter :: NURBS_ERROR_POINT_NOT_FINITE = 19  ! a coordinate is NaN or infinite
    integer(c_int32_t), parameter :: NURBS_ERROR_WEIGHT_NOT_FINITE = 20  ! a weight is NaN or infinite
    integer(c_int32_t), parameter :: NURBS_ERROR_WEIGHT_NEGATIVE = 21  ! a weight is < 0
    ! all weights that are active at some parameter are 0
    integer(c_int32_t), parameter :: NURBS_ERROR_WEIGHTS_VANISH = 22
    integer(c_int32_t), parameter :: NURBS_ERROR_PARAMETER_NOT_FINITE = 23  ! a parameter is NaN or infinite
    ! knots of an axis flagged periodic do not repeat with the period
    integer(c_int32_t), parameter :: NURBS_ERROR_PERIODIC_KNOTS = 24
    ! points or weights of an axis flagged periodic do not wrap bit for bit
    integer(c_int32_t), parameter :: NURBS_ERROR_PERIODIC_POINTS = 25
    integer(c_int32_t), parameter :: NURBS_ERROR_TIMES = 26  ! a number of repetitions is negative
    ! an options struct has a wrong size or a value out of range
    integer(c_int32_t), parameter :: NURBS_ERROR_OPTIONS = 27
    integer(c_int32_t), parameter :: NURBS_ERROR_INDEX = 28  ! an index is outside its list
    ! a direction is zero, not finite, or parallel to another one
    integer(c_int32_t), parameter :: NURBS_ERROR_DIRECTION = 29
    ! a knot at an end of the domain, where it cannot be removed
    integer(c_int32_t), parameter :: NURBS_ERROR_END_KNOT = 30
    ! a value that has to be a knot of the axis is not one
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_A_KNOT = 31
    ! an entry of a matrix or translation is NaN or infinite
    integer(c_int32_t), parameter :: NURBS_ERROR_MATRIX = 32
    ! the spline is rational, which the function is not for
    integer(c_int32_t), parameter :: NURBS_ERROR_RATIONAL = 33
    ! splines differ in what they have to share
    integer(c_int32_t), parameter :: NURBS_ERROR_INCOMPATIBLE = 40
    ! ends that are to be joined lie farther apart than the tolerance
    integer(c_int32_t), parameter :: NURBS_ERROR_GAP = 41
    ! a tolerance is negative or NaN, or otherwise out of range
    integer(c_int32_t), parameter :: NURBS_ERROR_TOLERANCE = 42
    ! an axis that has to be periodic was not declared so
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_PERIODIC = 43
    ! no one factor makes the weights at the ends of an axis equal
    integer(c_int32_t), parameter :: NURBS_ERROR_END_WEIGHTS = 44
    ! a factor is not finite, or not positive where it has to be
    integer(c_int32_t), parameter :: NURBS_ERROR_FACTOR = 45
    ! a knot is less smooth than the function needs
    integer(c_int32_t), parameter :: NURBS_ERROR_CONTINUITY = 46
    ! a weight of the result would not be positive
    integer(c_int32_t), parameter :: NURBS_ERROR_WEIGHT_SIGN = 47
    ! an axis is periodic, which the function is not for
    integer(c_int32_t), parameter :: NURBS_ERROR_PERIODIC = 48
    integer(c_int32_t), parameter :: NURBS_ERROR_END = 49  ! an end is neither NURBS_START nor NURBS_END
    integer(c_int32_t), parameter :: NURBS_ERROR_BASIS = 50  ! not one of the NURBS_BASIS_ constants
    ! a function neither increases nor decreases strictly
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_MONOTONE = 51
    ! an angle is not finite or above 2^22, or a sweep is 0 or above a turn
    integer(c_int32_t), parameter :: NURBS_ERROR_ANGLE = 52
    ! a radius or another length is not finite or out of range
    integer(c_int32_t), parameter :: NURBS_ERROR_LENGTH = 53
    ! points that must not be on a line are on one
    integer(c_int32_t), parameter :: NURBS_ERROR_COLLINEAR = 54
    ! no conic, or no arc of one in one piece, fulfils the conditions
    integer(c_int32_t), parameter :: NURBS_ERROR_CONIC = 55
    ! not one of the NURBS_ARC_ constants that are allowed here
    integer(c_int32_t), parameter :: NURBS_ERROR_FORM = 56
    ! tangents that have to agree differ by more than the tolerance
    integer(c_int32_t), parameter :: NURBS_ERROR_TANGENT = 57
    ! twists that have to agree differ by more than the tolerance
    integer(c_int32_t), parameter :: NURBS_ERROR_TWIST = 58
    ! not one of the NURBS_TWIST_ constants, or one that does not suit
    integer(c_int32_t), parameter :: NURBS_ERROR_TWIST_RULE = 59
    ! a control point has no influence at the parameter
    integer(c_int32_t), parameter :: NURBS_ERROR_INFLUENCE = 60
    integer(c_int32_t), parameter :: NURBS_ERROR_CONTRADICTION = 61  ! constraints contradict each other
    integer(c_int32_t), parameter :: NURBS_ERROR_CONSTRAINT = 62  ! not one of the NURBS_CONSTRAIN_ constants
    integer(c_int32_t), parameter :: NURBS_ERROR_OFF_POLYGON = 63  ! a point is not on the control polygon
    ! not one of the constants of a rule, or one that does not suit
    integer(c_int32_t), parameter :: NURBS_ERROR_RULE = 64
    ! data lie outside the support of the control point that they have to determine
    integer(c_int32_t), parameter :: NURBS_ERROR_SCHOENBERG_WHITNEY = 65
    integer(c_int32_t), parameter :: NURBS_ERROR_RANK = 66  ! data or conditions do not determine the result
    ! a value or weight is above the scale of the statistics
    integer(c_int32_t), parameter :: NURBS_ERROR_SCALE = 67
    ! loops of a face have no common inside, or enclose nothing
    integer(c_int32_t), parameter :: NURBS_ERROR_ORIENTATION = 68
    integer(c_int32_t), parameter :: NURBS_ERROR_SAME = 69  ! one handle where two different shapes are needed
    ! loops of a face cross themselves or each other
    integer(c_int32_t), parameter :: NURBS_ERROR_CROSSING = 70
    ! a parameter or knot lies outside the domain
    integer(c_int32_t), parameter :: NURBS_ERROR_OUTSIDE_DOMAIN = 100
    ! a value of the result overflows double precision
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_REPRESENTABLE = 200
    ! knots that differ would become equal or change their order
    integer(c_int32_t), parameter :: NURBS_ERROR_KNOTS_MERGE = 202
    integer(c_int32_t), parameter :: NURBS_ERROR_NOT_CONVERGED = 203  ! an iteration did not reach its goal
    integer(c_int32_t), parameter :: NURBS_ERROR_MEMORY = 300  ! an allocation failed
    integer(c_int32_t), parameter :: NURBS_ERROR_FILE = 301  ! a file cannot be opened or read
    ! a file exceeds the size limit of the options
    integer(c_int32_t), parameter :: NURBS_ERROR_TOO_LARGE = 302
    ! the callback of a long call asked for its end
    integer(c_int32_t), parameter :: NURBS_ERROR_CANCELLED = 303
    ! the limit of work of a long call was reached before its end
    integer(c_int32_t), parameter :: NURBS_ERROR_WORK = 304
    integer(c_int32_t), parameter :: NURBS_ERROR_FORMAT = 400  ! not a file of a known format
    ! the file ends, or a section is missing, before its contents are complete
    integer(c_int32_t), parameter :: NURBS_ERROR_TRUNCATED = 401
    integer(c_int32_t), parameter :: NURBS_ERROR_SYNTAX = 402  ! the file breaks the rules of its format
    ! an entity that this version does not read (only in notes)
    integer(c_int32_t), parameter :: NURBS_ERROR_UNSUPPORTED = 403
    ! bytes of a handle are not those that were written
    integer(c_int32_t), parameter :: NURBS_ERROR_CHECKSUM = 404
    ! bytes of a handle have a later version of the form
    integer(c_int32_t), parameter :: NURBS_ERROR_VERSION = 405
    ! entities of a file contain each other (only in notes)
    integer(c_int32_t), parameter :: NURBS_ERROR_CYCLE = 406
    integer(c_int32_t), parameter :: NURBS_ERROR_INTERNAL = 900  ! a defect of the library; please report it

    ! --- Flags by axis
    ! Evaluation: at a knot take the limit from below.
    integer(c_int32_t), parameter :: NURBS_LEFT = int(z'01', c_int32_t)
    ! Evaluation: move a parameter outside the domain (infinite ones too) to the nearer end.
    integer(c_int32_t), parameter :: NURBS_CLAMP = int(z'02', c_int32_t)
    ! Evaluation: outside the domain continue the first or last polynomial piece.
    integer(c_int32_t), parameter :: NURBS_EXTRAPOLATE = int(z'04', c_int32_t)
    ! Evaluation: reduce the parameter by multiples of the domain's length; the start and the end are the same
    ! place, seen from the right unless NURBS_LEFT is set. Allowed on every axis, periodic or not.
    integer(c_int32_t), parameter :: NURBS_WRAP = int(z'08', c_int32_t)
    ! Evaluation: a parameter that cannot be evaluated gives NaN instead of an error. NURBS_CLAMP,
    ! NURBS_EXTRAPOLATE and NURBS_WRAP exclude each other; each may be combined with NURBS_NAN.
    integer(c_int32_t), parameter :: NURBS_NAN = int(z'10', c_int32_t)
    ! Creation: the axis is periodic with period knots[count] - knots[degree]: knots[i + m] = knots[i] +
    ! period to within the rounding of the largest knot, and the last `degree` layers of points and weights
    ! equal the first ones bit for bit, where m = count - degree is the number of distinct layers. Operations
    ! keep the axis periodic.
    integer(c_int32_t), parameter :: NURBS_PERIODIC = int(z'01', c_int32_t)

    ! --- Global flags
    ! nurbs_eval_adjoint() and the other adjoints: add to what the outputs hold instead of overwriting it.
    integer(c_int32_t), parameter :: NURBS_ACCUMULATE = int(z'01000000', c_int32_t)
    ! nurbs_reverse(): map the domain to itself instead of negating the parameter.
    integer(c_int32_t), parameter :: NURBS_KEEP_DOMAIN = int(z'02000000', c_int32_t)
    ! nurbs_join(): ends that do not meet become a jump instead of an error; nurbs_face_create(): segments
    ! close what curves leave open.
    integer(c_int32_t), parameter :: NURBS_KEEP_GAPS = int(z'04000000', c_int32_t)
    ! nurbs_product(): the dot product.
    integer(c_int32_t), parameter :: NURBS_PRODUCT_DOT = int(z'08000000', c_int32_t)
    ! nurbs_product(): the cross product in dimension 3.
    integer(c_int32_t), parameter :: NURBS_PRODUCT_CROSS = int(z'10000000', c_int32_t)
    ! nurbs_create_power(), nurbs_unclamp(): homogeneous records (w x, w y, ..., w).
    integer(c_int32_t), parameter :: NURBS_HOMOGENEOUS = int(z'20000000', c_int32_t)
    ! nurbs_make_compatible(): map the domains of all splines to that of the first one.
    integer(c_int32_t), parameter :: NURBS_MAP_DOMAINS = int(z'40000000', c_int32_t)
    ! nurbs_curve_divide(): equal distances of consecutive points instead of equal lengths.
    integer(c_int32_t), parameter :: NURBS_EQUAL_CHORDS = int(z'02000000', c_int32_t)
    ! nurbs_snap_boundary(): the two boundaries run against each other.
    integer(c_int32_t), parameter :: NURBS_REVERSED = int(z'04000000', c_int32_t)
    ! nurbs_closest_points() and its neighbours: a point that is not finite gives NaN instead of an error.
    integer(c_int32_t), parameter :: NURBS_NAN_POINTS = int(z'01000000', c_int32_t)
    ! nurbs_face_create(): the inside is to the left of the loops as they run.
    integer(c_int32_t), parameter :: NURBS_AS_ORIENTED = int(z'01000000', c_int32_t)
    ! nurbs_face_create(): loops that cross themselves or each other are refused.
    integer(c_int32_t), parameter :: NURBS_CHECK_CROSSINGS = int(z'02000000', c_int32_t)

    ! --- Form of a knot vector, as reported by nurbs_knot_form()
    ! the first degree + 1 knots are equal
    integer(c_int32_t), parameter :: NURBS_FORM_CLAMPED_START = int(z'01', c_int32_t)
    ! the last degree + 1 knots are equal
    integer(c_int32_t), parameter :: NURBS_FORM_CLAMPED_END = int(z'02', c_int32_t)
    ! the axis was declared periodic
    integer(c_int32_t), parameter :: NURBS_FORM_PERIODIC = int(z'04', c_int32_t)

    ! --- Bases of a polynomial segment, for nurbs_basis_matrix()
    integer(c_int32_t), parameter :: NURBS_BASIS_POWER = 0  ! 1, t, t^2, ...
    integer(c_int32_t), parameter :: NURBS_BASIS_BERNSTEIN = 1  ! the Bezier points over [0, 1]
    ! f(0), f'(0), ..., then f(1), f'(1), ...; odd degrees
    integer(c_int32_t), parameter :: NURBS_BASIS_HERMITE = 2
    ! control points over the knots -degree, ..., degree + 1
    integer(c_int32_t), parameter :: NURBS_BASIS_BSPLINE = 3

    ! --- Rules for parameters, for nurbs_parametrize()
    integer(c_int32_t), parameter :: NURBS_PARAMS_UNIFORM = 0  ! equal steps
    integer(c_int32_t), parameter :: NURBS_PARAMS_CHORD = 1  ! steps in proportion to the chords
    ! steps in proportion to the square roots of the chords (Lee 1989)
    integer(c_int32_t), parameter :: NURBS_PARAMS_CENTRIPETAL = 2
    integer(c_int32_t), parameter :: NURBS_PARAMS_POWER = 3  ! steps in proportion to a power of the chords
    ! steps in proportion to the chords, longer where the polygon turns
    integer(c_int32_t), parameter :: NURBS_PARAMS_FOLEY_NIELSON = 4

    ! --- Ends of an interpolating spline, for nurbs_interpolate()
    integer(c_int32_t), parameter :: NURBS_ENDS_NOT_A_KNOT = 0  ! the parameters next to the end are not knots
    ! derivatives of orders (degree + 1) / 2 to degree - 1 vanish; odd degrees
    integer(c_int32_t), parameter :: NURBS_ENDS_NATURAL = 1
    ! knots averaged from the parameters (nurbs_knots_averaged()); both ends
    integer(c_int32_t), parameter :: NURBS_ENDS_FREE = 2

    ! --- Special orders of derivatives, for nurbs_curve_interpolate()
    ! the first derivative has the direction of the target, of any length
    integer(c_int32_t), parameter :: NURBS_ORDER_DIRECTION = -1

    ! --- How smooth a fit is, for nurbs_fit_options
    integer(c_int32_t), parameter :: NURBS_SMOOTHING_NONE = 0  ! only the data count
    integer(c_int32_t), parameter :: NURBS_SMOOTHING_LAMBDA = 1  ! the factor of the penalty is given
    ! by generalised cross validation (Craven & Wahba 1979)
    integer(c_int32_t), parameter :: NURBS_SMOOTHING_GCV = 2
    integer(c_int32_t), parameter :: NURBS_SMOOTHING_REML = 3  ! by restricted maximum likelihood (Wood 2011)
    ! as smooth as a given sum of squares allows (Reinsch 1967)
    integer(c_int32_t), parameter :: NURBS_SMOOTHING_DISCREPANCY = 4

    ! --- How much outliers count, for nurbs_fit_options
    integer(c_int32_t), parameter :: NURBS_ROBUST_NONE = 0  ! as much as other data
    integer(c_int32_t), parameter :: NURBS_ROBUST_HUBER = 1  ! their weight times min(1, 1 / x) (Huber 1964)
    ! their weight times (1 - x^2)^2 for x < 1, else 0 (Beaton & Tukey 1974)
    integer(c_int32_t), parameter :: NURBS_ROBUST_TUKEY = 2

    ! --- Shapes along an axis, for nurbs_fit_options; they can be added
    ! the first derivative is >= 0
    integer(c_int32_t), parameter :: NURBS_TREND_RISING = int(z'01', c_int32_t)
    ! the first derivative is <= 0
    integer(c_int32_t), parameter :: NURBS_TREND_FALLING = int(z'02', c_int32_t)
    ! the first derivative does not fall
    integer(c_int32_t), parameter :: NURBS_TREND_CONVEX = int(z'04', c_int32_t)
    ! the first derivative does not rise
    integer(c_int32_t), parameter :: NURBS_TREND_CONCAVE = int(z'08', c_int32_t)

    ! --- Bits of nurbs_fit_report
    ! the target, or the tolerance, is not reached
    integer(c_int32_t), parameter :: NURBS_FIT_TARGET_MISSED = int(z'01', c_int32_t)
    ! the last round of a robust fit, or of a shape, still changed it
    integer(c_int32_t), parameter :: NURBS_FIT_NOT_CONVERGED = int(z'02', c_int32_t)

    ! --- Bits of nurbs_cloud_report
    ! the rounds, or the limit of work, ended while the sum was still falling
    integer(c_int32_t), parameter :: NURBS_CLOUD_NOT_CONVERGED = int(z'01', c_int32_t)

    ! --- Rules for tangents, for nurbs_tangents()
    integer(c_int32_t), parameter :: NURBS_TANGENTS_CATMULL_ROM = 0  ! the slope between the neighbours
    ! the slope of the parabola through a point and its neighbours
    integer(c_int32_t), parameter :: NURBS_TANGENTS_BESSEL = 1
    ! mean of both slopes, weighted by their steadiness (Akima 1970)
    integer(c_int32_t), parameter :: NURBS_TANGENTS_AKIMA = 2
    ! each coordinate rises and falls as the data do (Fritsch & Butland 1984)
    integer(c_int32_t), parameter :: NURBS_TANGENTS_MONOTONE = 3

    ! --- Ends of an axis
    integer(c_int32_t), parameter :: NURBS_START = 0  ! the lower end of the domain
    integer(c_int32_t), parameter :: NURBS_END = 1  ! the upper end of the domain

    ! --- Status of a point
    ! tangent of a curve, normal of a surface: a one-sided limit
    integer(c_int32_t), parameter :: NURBS_FRAME_LIMIT = int(z'01', c_int32_t)
    ! normal of a curve in space: a one-sided limit
    integer(c_int32_t), parameter :: NURBS_FRAME_NORMAL_LIMIT = int(z'02', c_int32_t)
    ! nothing distinguishes a direction: the function's rule chose it
    integer(c_int32_t), parameter :: NURBS_FRAME_RULE = int(z'04', c_int32_t)
    ! some result does not exist and is NaN
    integer(c_int32_t), parameter :: NURBS_FRAME_UNDEFINED = int(z'08', c_int32_t)

    ! --- Forms of an arc
    ! degree 2, equal pieces of at most a quarter turn
    integer(c_int32_t), parameter :: NURBS_ARC_QUARTERS = 0
    ! degree 2, equal pieces of at most a third of a turn
    integer(c_int32_t), parameter :: NURBS_ARC_THIRDS = 1
    ! One polynomial piece: degree 2 up to a third of a turn, degree 5 beyond; weights are positive.
    integer(c_int32_t), parameter :: NURBS_ARC_SMOOTH = 2

    ! --- Kinds of conics
    integer(c_int32_t), parameter :: NURBS_CONIC_ELLIPSE = 1  ! shape factor below 1
    integer(c_int32_t), parameter :: NURBS_CONIC_PARABOLA = 2  ! shape factor 1
    integer(c_int32_t), parameter :: NURBS_CONIC_HYPERBOLA = 3  ! shape factor above 1
    integer(c_int32_t), parameter :: NURBS_CONIC_CHORD = 4  ! degenerate: shape factor 0, the segment P0 P2
    ! degenerate: shape factor infinite, the segments P0 P1 and P1 P2
    integer(c_int32_t), parameter :: NURBS_CONIC_LEGS = 5
    integer(c_int32_t), parameter :: NURBS_CONIC_LINE = 6  ! degenerate: P0, P1 and P2 on a line

    ! --- Flags of constructions
    ! nurbs_ruled(): rulings of Cartesian points, divided evenly, not those of homogeneous ones.
    integer(c_int32_t), parameter :: NURBS_RULED_CARTESIAN = int(z'80000000', c_int32_t)
    ! nurbs_surface_sphere_patches(): the half towards Z.
    integer(c_int32_t), parameter :: NURBS_HEMISPHERE = int(z'01000000', c_int32_t)
    ! nurbs_surface_hyperboloid(): the hyperboloid of two sheets.
    integer(c_int32_t), parameter :: NURBS_TWO_SHEETS = int(z'02000000', c_int32_t)

    ! --- Twists of nurbs_surface_coons_hermite()
    integer(c_int32_t), parameter :: NURBS_TWIST_COMPATIBLE = 0  ! both, which must agree to the tolerance
    integer(c_int32_t), parameter :: NURBS_TWIST_AVERAGE = 1  ! their mean
    integer(c_int32_t), parameter :: NURBS_TWIST_GIVEN = 2  ! the ones given
    integer(c_int32_t), parameter :: NURBS_TWIST_ZERO = 3  ! zero (Ferguson's patch)
    integer(c_int32_t), parameter :: NURBS_TWIST_BILINEAR = 4  ! that of the bilinear patch of the corners
    ! that of the bilinear Coons surface of the boundaries (Adini's twist)
    integer(c_int32_t), parameter :: NURBS_TWIST_ADINI = 5

    ! --- Shapes
    integer(c_int32_t), parameter :: NURBS_SHAPE_NONE = 0  ! none of these, to the tolerance
    integer(c_int32_t), parameter :: NURBS_SHAPE_POINT = 1  ! a single point
    integer(c_int32_t), parameter :: NURBS_SHAPE_LINE = 2  ! a piece of a straight line
    integer(c_int32_t), parameter :: NURBS_SHAPE_CIRCLE = 3  ! a circle, or an arc of one
    integer(c_int32_t), parameter :: NURBS_SHAPE_ELLIPSE = 4  ! an ellipse, or an arc of one
    integer(c_int32_t), parameter :: NURBS_SHAPE_PARABOLA = 5  ! an arc of a parabola
    integer(c_int32_t), parameter :: NURBS_SHAPE_HYPERBOLA = 6  ! an arc of one branch of a hyperbola
    integer(c_int32_t), parameter :: NURBS_SHAPE_PLANE = 7  ! a piece of a plane
    integer(c_int32_t), parameter :: NURBS_SHAPE_SPHERE = 8  ! a sphere, or a piece of one
    integer(c_int32_t), parameter :: NURBS_SHAPE_CYLINDER = 9  ! a piece of a circular cylinder
    integer(c_int32_t), parameter :: NURBS_SHAPE_CONE = 10  ! a piece of one half of a circular cone
    integer(c_int32_t), parameter :: NURBS_SHAPE_TORUS = 11  ! a torus, or a piece of one
    ! a surface of revolution; of models only, as those that follow
    integer(c_int32_t), parameter :: NURBS_SHAPE_REVOLUTION = 12
    integer(c_int32_t), parameter :: NURBS_SHAPE_EXTRUSION = 13  ! a curve moved along a vector
    integer(c_int32_t), parameter :: NURBS_SHAPE_OFFSET = 14  ! at a distance from another surface

    ! --- Status of a closest point
    ! proven to be the nearest, or farthest, point to the tolerance
    integer(c_int32_t), parameter :: NURBS_CLOSEST_CERTIFIED = int(z'01', c_int32_t)
    ! on an end or an edge of the domain, or of range
    integer(c_int32_t), parameter :: NURBS_CLOSEST_BOUNDARY = int(z'02', c_int32_t)
    ! points elsewhere are as near to the tolerance
    integer(c_int32_t), parameter :: NURBS_CLOSEST_NOT_UNIQUE = int(z'04', c_int32_t)
    ! the budget ended before a proof was found
    integer(c_int32_t), parameter :: NURBS_CLOSEST_BUDGET = int(z'08', c_int32_t)
    ! the query point is not finite; results are NaN
    integer(c_int32_t), parameter :: NURBS_CLOSEST_INVALID = int(z'10', c_int32_t)
    ! proven, but rounding the parameters moves the point by more
    integer(c_int32_t), parameter :: NURBS_CLOSEST_COARSE = int(z'20', c_int32_t)
    ! of nurbs_closest_adjoint(): the gradient is not determined
    integer(c_int32_t), parameter :: NURBS_CLOSEST_SINGULAR = int(z'40', c_int32_t)
    ! NURBS_LEFT is meant on axis 0; 0x200 on axis 1, 0x400 on axis 2
    integer(c_int32_t), parameter :: NURBS_CLOSEST_LEFT = int(z'100', c_int32_t)

    ! --- Kind of a critical point
    integer(c_int32_t), parameter :: NURBS_CRITICAL_MINIMUM = 1  ! a local minimum of the distance
    integer(c_int32_t), parameter :: NURBS_CRITICAL_MAXIMUM = 2  ! a local maximum of the distance
    integer(c_int32_t), parameter :: NURBS_CRITICAL_SADDLE = 3  ! neither
    integer(c_int32_t), parameter :: NURBS_CRITICAL_UNDECIDED = 4  ! rounding leaves the kind open

    ! --- Features of curves
    ! the curvature changes its sign; in space: it vanishes
    integer(c_int32_t), parameter :: NURBS_FEATURE_INFLECTION = int(z'01', c_int32_t)
    ! a local maximum of |curvature|
    integer(c_int32_t), parameter :: NURBS_FEATURE_CURVATURE_MAXIMUM = int(z'02', c_int32_t)
    ! a local minimum of |curvature|, where it is not 0
    integer(c_int32_t), parameter :: NURBS_FEATURE_CURVATURE_MINIMUM = int(z'04', c_int32_t)
    ! the first derivative vanishes
    integer(c_int32_t), parameter :: NURBS_FEATURE_CUSP = int(z'08', c_int32_t)
    ! a knot where the direction of the tangent jumps
    integer(c_int32_t), parameter :: NURBS_FEATURE_KINK = int(z'10', c_int32_t)
    ! a knot where the curve jumps
    integer(c_int32_t), parameter :: NURBS_FEATURE_JUMP = int(z'20', c_int32_t)
    ! the torsion changes its sign (dimension 3)
    integer(c_int32_t), parameter :: NURBS_FEATURE_TORSION = int(z'40', c_int32_t)

    ! --- Kinds of extrema
    ! no value beside it is smaller
    integer(c_int32_t), parameter :: NURBS_EXTREMUM_MINIMUM = int(z'01', c_int32_t)
    ! no value beside it is larger
    integer(c_int32_t), parameter :: NURBS_EXTREMUM_MAXIMUM = int(z'02', c_int32_t)
    ! f turns up along some axes, and down along others
    integer(c_int32_t), parameter :: NURBS_EXTREMUM_SADDLE = int(z'04', c_int32_t)
    ! f is constant in the range
    integer(c_int32_t), parameter :: NURBS_EXTREMUM_PLATEAU = int(z'08', c_int32_t)
    ! a range in which it is not decided what there is
    integer(c_int32_t), parameter :: NURBS_EXTREMUM_UNDECIDED = int(z'10', c_int32_t)

    ! --- Convexity of a curve in the plane
    ! turns both ways, or through more than a full turn, or has a cusp
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_NONE = 0
    ! turns to the left only, by at most a full turn
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_LEFT = 1
    ! turns to the right only, by at most a full turn
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_RIGHT = 2
    ! a straight line that does not turn back, to rounding
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_STRAIGHT = 3
    integer(c_int32_t), parameter :: NURBS_CONVEXITY_UNDECIDED = 4  ! double precision cannot decide

    ! --- Folds
    integer(c_int32_t), parameter :: NURBS_FOLD_NONE = 0  ! proven: there is none
    integer(c_int32_t), parameter :: NURBS_FOLD_FOUND = 1  ! proven: there is one
    integer(c_int32_t), parameter :: NURBS_FOLD_UNDECIDED = 2  ! neither

    ! --- Kinds of hits
    ! passes from one side to the other, or has an end there
    integer(c_int32_t), parameter :: NURBS_HIT_CROSSING = 1
    ! a touch, as far as rounding and the tolerance can tell
    integer(c_int32_t), parameter :: NURBS_HIT_TANGENT = 2
    ! within the tolerance, but proven apart: the nearest place
    integer(c_int32_t), parameter :: NURBS_HIT_CONTACT = 3
    ! within the tolerance in the whole range, which is a span or more
    integer(c_int32_t), parameter :: NURBS_HIT_OVERLAP = 4
    ! changes sides where the curve jumps, without meeting anything
    integer(c_int32_t), parameter :: NURBS_HIT_JUMP = 5
    ! a range in which it is not decided what there is
    integer(c_int32_t), parameter :: NURBS_HIT_UNDECIDED = 6

    ! --- Status of a ray
    ! the ray meets the surface there, to rounding
    integer(c_int32_t), parameter :: NURBS_RAY_HIT = int(z'01', c_int32_t)
    ! nothing is nearer; without NURBS_RAY_HIT: it meets nothing
    integer(c_int32_t), parameter :: NURBS_RAY_CERTIFIED = int(z'02', c_int32_t)
    ! it touches the surface there or just misses it: rounding cannot tell
    integer(c_int32_t), parameter :: NURBS_RAY_TOUCH = int(z'04', c_int32_t)
    ! it arrives from behind: from the side to which S_u x S_v does not point
    integer(c_int32_t), parameter :: NURBS_RAY_BACK = int(z'08', c_int32_t)

    ! --- Kinds of nodes of a nurbs_meet
    integer(c_int32_t), parameter :: NURBS_NODE_BORDER = 1  ! the surface ends or jumps there
    ! it closes there on a non-periodic axis: the branch continues beyond
    integer(c_int32_t), parameter :: NURBS_NODE_SEAM = 2
    ! a part within the tolerance in which branches are not separated
    integer(c_int32_t), parameter :: NURBS_NODE_TOUCH = 3
    ! a part in which it is not decided what there is
    integer(c_int32_t), parameter :: NURBS_NODE_UNDECIDED = 4
    ! an edge, a corner or a pole of faces of a model, where another branch continues
    integer(c_int32_t), parameter :: NURBS_NODE_EDGE = 5
    ! the surface folds, seen along the direction of a projection, or feet do: another sheet continues
    integer(c_int32_t), parameter :: NURBS_NODE_FOLD = 6
    ! a region in which two surfaces are within the tolerance of each other; no branch ends there
    integer(c_int32_t), parameter :: NURBS_NODE_OVERLAP = 7

    ! --- Kinds of contours
    integer(c_int32_t), parameter :: NURBS_CONTOUR_SILHOUETTE = 1  ! f = N . d: the outline seen along d
    ! f = N . (S - d): the outline seen from the point d
    integer(c_int32_t), parameter :: NURBS_CONTOUR_PERSPECTIVE = 2
    ! (N . d)^2 = c^2 |N|^2 |d|^2 where N . d has the sign of c: normals at one angle to d
    integer(c_int32_t), parameter :: NURBS_CONTOUR_ISOPHOTE = 3
    ! f = K, the Gaussian curvature, up to a positive factor
    integer(c_int32_t), parameter :: NURBS_CONTOUR_PARABOLIC = 4

    ! --- Kinds of reflection lines
    ! f = N . m: the line along the normal meets the line of light
    integer(c_int32_t), parameter :: NURBS_REFLECTION_HIGHLIGHT = 1
    ! f = (N . N) (v . m) - 2 (N . v) (N . m), v = eye: the mirrored line of sight meets it
    integer(c_int32_t), parameter :: NURBS_REFLECTION_ALONG = 2
    ! the same with v = S - eye: seen from the point eye
    integer(c_int32_t), parameter :: NURBS_REFLECTION_FROM = 3

    ! --- Kinds of branches
    ! a curve that surfaces, or a surface and a plane, have in common
    integer(c_int32_t), parameter :: NURBS_BRANCH_CROSSING = 1
    integer(c_int32_t), parameter :: NURBS_BRANCH_EDGE = 2  ! an edge that two faces share
    ! an edge that two faces share, with the same tangent planes somewhere at least
    integer(c_int32_t), parameter :: NURBS_BRANCH_CONTACT = 3
    ! a curve along which surfaces touch: they have the same tangent planes
    integer(c_int32_t), parameter :: NURBS_BRANCH_TOUCH = 4
    ! a part of the boundary of a region in which surfaces coincide
    integer(c_int32_t), parameter :: NURBS_BRANCH_OVERLAP = 5

    ! --- Kinds of constraints
    ! the derivative of the given orders is the target; orders 0: the point
    integer(c_int32_t), parameter :: NURBS_CONSTRAIN_VALUE = 0
    ! the derivative is parallel to the target, either way
    integer(c_int32_t), parameter :: NURBS_CONSTRAIN_DIRECTION = 1
    ! all first derivatives are perpendicular to the target
    integer(c_int32_t), parameter :: NURBS_CONSTRAIN_NORMAL = 2
    ! the curvature vector (C'' - (C'' T) T) / |C'|^2 of a curve is the target
    integer(c_int32_t), parameter :: NURBS_CONSTRAIN_CURVATURE = 3

    ! --- What files are read for
    ! curves: in lists all, also those of edges; in models those that are part of no face or edge
    integer(c_int32_t), parameter :: NURBS_READ_CURVES = int(z'1', c_int32_t)
    ! surfaces: in lists all, also those of faces; in models those that are part of no face (STEP)
    integer(c_int32_t), parameter :: NURBS_READ_SURFACES = int(z'2', c_int32_t)
    ! faces of models with their edges and vertices, and other edges; in IGES also surfaces alone
    integer(c_int32_t), parameter :: NURBS_READ_FACES = int(z'4', c_int32_t)

    ! --- Kinds of handles
    integer(c_int32_t), parameter :: NURBS_BYTES_SPLINE = 1  ! a spline: nurbs_from_bytes()
    integer(c_int32_t), parameter :: NURBS_BYTES_LIST = 2  ! a list: nurbs_list_from_bytes()
    integer(c_int32_t), parameter :: NURBS_BYTES_STATISTICS = 3  ! statistics: nurbs_statistics_from_bytes()
    integer(c_int32_t), parameter :: NURBS_BYTES_FACE = 4  ! a face: nurbs_face_from_bytes()
    integer(c_int32_t), parameter :: NURBS_BYTES_MODEL = 5  ! a model: nurbs_model_from_bytes()

    ! --- Sides of a model
    integer(c_int32_t), parameter :: NURBS_SIDE_INSIDE = 1  ! inside a solid, for certain
    integer(c_int32_t), parameter :: NURBS_SIDE_ON = 0  ! no farther from a face than the tolerance
    integer(c_int32_t), parameter :: NURBS_SIDE_OUTSIDE = -1  ! outside all solids, for certain
    integer(c_int32_t), parameter :: NURBS_SIDE_UNDECIDED = 2  ! not known

    ! --- What is inside of closed curves
    integer(c_int32_t), parameter :: NURBS_FILL_NON_ZERO = 1  ! a winding number other than 0
    integer(c_int32_t), parameter :: NURBS_FILL_EVEN_ODD = 2  ! an odd winding number
    integer(c_int32_t), parameter :: NURBS_FILL_POSITIVE = 3  ! a winding number above 0

    ! --- What is made of two regions
    integer(c_int32_t), parameter :: NURBS_REGION_UNION = 1  ! what is in a or in b
    integer(c_int32_t), parameter :: NURBS_REGION_INTERSECTION = 2  ! what is in a and in b
    integer(c_int32_t), parameter :: NURBS_REGION_DIFFERENCE = 3  ! what is in a and not in b
    ! what is in a or in b and not in both: the symmetric difference
    integer(c_int32_t), parameter :: NURBS_REGION_EITHER = 4

    ! --- Which side of a surface is kept
    integer(c_int32_t), parameter :: NURBS_TRIM_FRONT = 1  ! the side to which its normals N = S_u x S_v point
    integer(c_int32_t), parameter :: NURBS_TRIM_BACK = -1  ! the other side

    ! --- Flags of meshes
    ! nurbs_mesh_triangles() and similar functions: corners are points, not vertices.
    integer(c_int32_t), parameter :: NURBS_MESH_WELDED = int(z'01000000', c_int32_t)

    ! --- Formats of files
    ! STEP: an exchange structure of ISO 10303-21, by AP214
    integer(c_int32_t), parameter :: NURBS_FORMAT_STEP = 1
    integer(c_int32_t), parameter :: NURBS_FORMAT_IGES = 2  ! IGES 5.3 in lines of 80 columns
    integer(c_int32_t), parameter :: NURBS_FORMAT_STL = 3  ! Triangles: binary STL
    integer(c_int32_t), parameter :: NURBS_FORMAT_STL_TEXT = 4  ! Triangles: STL as text
    integer(c_int32_t), parameter :: NURBS_FORMAT_OBJ = 5  ! Triangles: Wavefront OBJ
    integer(c_int32_t), parameter :: NURBS_FORMAT_PLY = 6  ! Triangles: PLY, binary, little-endian
    integer(c_int32_t), parameter :: NURBS_FORMAT_GLB = 7  ! Triangles: glTF 2.0 in one binary file
    ! Triangles: an unstructured grid of VTK in XML, with raw arrays appended
    integer(c_int32_t), parameter :: NURBS_FORMAT_VTU = 8
end module nurbs_constants

/* SPDX-License-Identifier: MIT */
/**
 * \file nurbs.h
 * \brief NURBS curves, surfaces and volumes: the C interface of libnurbs, and its manual.
 *
 * Create a spline, evaluate it, destroy it:
 *
 * \code
 * #include <nurbs/nurbs.h>
 * #include <stdio.h>
 *
 * int main(void) { // a quarter of the unit circle: degree 2, 3 weighted control points, 6 knots
 *     const int32_t degree = 2;
 *     const int64_t count = 3;
 *     const double knots[] = {0, 0, 0, 1, 1, 1}, points[3][2] = {{1, 0}, {1, 1}, {0, 1}};
 *     const double weights[] = {1, 0.70710678118654752, 1}, params[] = {0, 0.5, 1};
 *     double result[3][2];
 *     char message[256];
 *     nurbs *arc = NULL;
 *     if (nurbs_create(1, &degree, &count, knots, 6, 2, points[0], 0, 0, weights, 0, 0, &arc) != NURBS_OK ||
 *         nurbs_eval(arc, 3, params, 0, 0, result[0], 0, 0, 0) != NURBS_OK) {
 *         nurbs_last_error(message, sizeof message);
 *         fprintf(stderr, "%s\n", message);
 *     } else {
 *         printf("the middle of the arc is (%g, %g)\n", result[1][0], result[1][1]);
 *     }
 *     nurbs_destroy(arc); // NULL is allowed
 *     return 0;
 * }
 * \endcode
 *
 * A call that fails returns a status other than 0, writes no result, and leaves a message in its thread. No
 * handle ever changes: an operation returns a new one. The arguments 0, 0 after an array of points are
 * strides (packed here), the last 0 stands for flags. Each group of functions below begins with an example of
 * its own, in which `curve` and `surface` are splines in space made before; tests of statuses are left out.
 *
 * # What a handle is
 * A `nurbs` is a spline of 1 (curve), 2 (surface) or 3 (volume) parametric axes in any dimension >= 1:
 *
 *     C(t) = sum_i R_i(t) P_i,   R_i(t) = w_i N_i(t) / sum_j w_j N_j(t),
 *
 * where N_i is a product of B-spline basis functions, one for each axis.
 *
 * Handles are immutable. Every operation reads `const nurbs *` and returns a new handle through its last
 * argument, which is set to NULL on failure. Inputs are copied, getters copy out, nothing is borrowed, and no
 * argument changes its owner. Free every handle once with nurbs_destroy(), from any thread. Any number of
 * threads may use one handle, or one list, at once. nurbs_destroy() and nurbs_list_destroy() must not run
 * while a call uses the same handle; they may run while other calls use its clones, or splines made from it.
 * The library has to stay loaded until the last handle is freed. It has no contexts, no initialisation and no
 * settings, starts no threads, and calls nothing back but the callback of a long call.
 *
 * # Conventions
 * - **Degree** p, not order. Degrees run from 0 to NURBS_MAX_DEGREE.
 * - **Knots** are the full vector t_0 <= t_1 <= ... of count + degree + 1 values, for all axes one after the
 *   other. The domain of an axis is [t_p, t_count]. Clamped, unclamped and periodic vectors are all first
 *   class. A knot occurs at most degree + 1 times. Two knots are equal only if their values are equal: there
 *   is no built-in tolerance. A tolerance that is an argument may be infinite unless its text says otherwise.
 * - **Points** are Cartesian, not multiplied by the weights. The last axis varies fastest: in a surface with
 *   counts (m, n), point (i, j) is record i * n + j. `weights` may be NULL, which makes the spline
 *   polynomial. The values given are the values stored: getters return them bit for bit.
 * - **Weights** are finite and >= 0, and at each parameter of the domain some weight in the support is > 0.
 *   Other weights, and control points at infinity, need nurbs_create_homogeneous().
 * - **Arrays of records** (points, parameters, derivatives) are described by a pointer and two strides
 *   counted in doubles: component c of record i is at `array[i * stride + c * component_stride]`. Both
 *   strides may be 0, which means packed: component_stride 0 is 1, stride 0 is (record length) *
 *   component_stride. A C array of points is (0, 0), a Fortran array x(n, dim) is (1, n). Either the
 *   records lie apart (stride covers a record) or the components do (component_stride covers all records);
 *   anything else is an error. The strides of an array that is NULL are ignored. Outputs must overlap neither
 *   inputs nor each other: arrays that do are refused (NURBS_ERROR_OVERLAP); for outputs of a single value
 *   this is not always checked.
 *   Several arrays of doubles may be columns of one table: their stride is then the length of its rows, their
 *   component_stride 1. Inputs may be the same memory. Where n is 0 the pointers may be NULL.
 * - **A parameter** in a span uses [t_i, t_i+1); the last span is closed. Flags choose the other side, and
 *   what happens outside the domain.
 *
 * # Errors
 * Functions return a nurbs_status. 0 is success; every other value is a failure, including values that this
 * header does not name. The classes are: 1-99 argument, 100-199 domain, 200-299 numeric, 300-399 resource,
 * 400-499 file contents, 900-999 internal. The code alone is enough to act upon. For the last failure in the
 * calling thread, nurbs_last_error() adds the array, the index, the value and what was expected. A failing
 * call writes to none of its outputs except handles, which become NULL, and those of which it is said. No
 * value in an argument makes a call crash; but the library cannot detect an array shorter than its stated length, or a handle that was
 * destroyed. An array, of values or of handles, that would have 2^53 elements or more with its strides is
 * refused before it is touched (NURBS_ERROR_OVERFLOW), since no memory holds it; no shorter one is.
 * Floating-point exceptions are assumed to be masked, as they are unless a program unmasks them; any call may
 * set their flags. Every function that allocates can return NURBS_ERROR_MEMORY, and every function
 * NURBS_ERROR_INTERNAL (a defect of the library); the lists of statuses below do not repeat these two.
 *
 * # Accuracy
 * eps = 2^-52. For a spline with weights >= 0, every coordinate of a point inside the domain is within
 * c * eps * hull of the exact value for the stored data. Here hull (nurbs_hull_size()) is the largest
 * magnitude of a coordinate among the control points that have a positive weight and are active at the
 * parameter, and c is the sum of c(p) over the axes:
 *
 *     degree p    0   1   2   3   4   5   6   7   8   9  10-15  16-23  24-31
 *     c(p)        1   3   4   4   6   6   8   8  12  12    16     24     32
 *
 * This table is tested, not proved: comparison with exact arithmetic, and searches for the worst case, find
 * at most 0.95 of it. There are three methods. Spans of degree 1 to 9 are evaluated as polynomials in a local
 * parameter centred on the span if their active weights (for surfaces and volumes: all weights that are
 * active somewhere) are positive and differ by a factor of at most 4. With these polynomials c is multiplied
 * by that factor, the largest of these weights over the smallest; no other ratio of weights enters. Spans of
 * a few units of rounding, shorter than 2^-100, with knots that reach over more than 2^500 or 2^500 times
 * their length, or (of curves) with a control point of 2^961 or more are none of these. Points of all other
 * spans of curves whose weights are not negative come from the Bezier points of the span, by Horner's rule in
 * (t - a) / (b - t), unless a span is shorter than 2^-900, or a control point is 2^960 or more. Everything
 * else is evaluated by the Cox-de Boor recurrence, for which 7 p + 2 is proved. With signed weights hull is
 * (max|w_i P_i| + |C(t)| max|w_i|) / |w(t)|. At clamped ends (and wherever one basis function is 1 on every
 * axis) the stored control point is returned bit for bit.
 *
 * A derivative of multi-index a (order k = |a| > 0) of a polynomial spline is within 2 (c + 2 k) * eps * H_a,
 * where H_a is the largest control point of the derivative that is active at the parameter, computed in
 * magnitudes: H_0 = |P - O|, and a step along an axis replaces neighbours by (p - k + 1) (H_i + H_i+1) /
 * (t_i+p+1 - t_i+k); in the first step of a curve H_i + H_i+1 is |P_i - P_i+1| + 2^-48 (|P_i| + |P_i+1|). For
 * a rational spline the quotient rule is followed in magnitudes: H_a is replaced by E_a = (H_a[w (P - O)] +
 * sum over 0 < b <= a of binomial(a, b) H_b[w] E_(a-b)) / w(t). Where the weights differ by a factor of more
 * than 4, the largest of the control points H is replaced by the value at the parameter of the spline that
 * has them as control points.
 *
 * So moving a spline does not add to the errors of its derivatives: O is a point with |P - O| at most |P| and
 * at most 9 E, where E is the longest side of the box of the control points with influence (a weight other
 * than 0, and a support in the domain). If that box lies farther than 8 E from 0 in some coordinate, O is
 * its corner nearest to 0, with 0 for the coordinates in which the box is longer than it is far from 0;
 * otherwise O is 0. The points P - O of such a spline are a second copy of its control points, which the
 * handle makes for the first derivatives that need them and keeps.
 *
 * Inserting a knot and raising the degree move each homogeneous control point by at most 2 eps * hull for
 * each time (tested), and by one eps more in all for Cartesian points with weights. Where the knots of a
 * periodic axis repeat only to rounding, they also move it by what that rounding moves. However many knots
 * are inserted at once, only those count for a control point that are new and among the `degree` knots it
 * belongs to: at most `degree` of them. The same holds for refining, splitting, extracting, decomposing and
 * clamping.
 *
 * The bounds assume rounding to nearest and gradual underflow. Neither the bounds nor the proofs hold in a
 * thread that uses other modes, as in programs that g++ before version 13 links with -ffast-math.
 *
 * A control point has no influence if its basis function vanishes on the domain (at an end that is not
 * clamped, and whose knot repeats), or if its weight is 0 and it is not at infinity. Such a control point
 * enters no scale, bound or proof: no answer depends on where it is.
 *
 * All bounds hold barring underflow and overflow: a component too large for double precision comes out as an
 * infinity or NaN, without a status. On one machine, one parameter gives the same bits alone, in a batch of
 * any order and size, on a grid, from any thread, and before or after tables are built. (The instruction set
 * of the machine decides whether multiplications and additions are fused.)
 *
 * # Speed
 * Use batches: the cost of a call is that of evaluating several points. Handles build tables by themselves
 * once enough parameters have been evaluated, about a third of the number of control points. For each span
 * the tables take 4 doubles and degree + 1 times m doubles, and a few more to find spans. Here m is, rounded
 * up to a multiple of 4, the number of components with the weight (curves), or degree + 1 (each axis of
 * surfaces and volumes). Sorted parameters are cheaper than random ones, grids cheaper than the list of their
 * points, and packed outputs cheaper than outputs with strides.
 *
 * # Compatibility
 * A program built with this header runs with every later library of the same major version, and with every
 * earlier one that has the functions, flags, constants and fields it uses.
 * - A **patch** version repairs defects. Results may change within the bounds stated here, and where the
 *   defect had made them wrong; texts of messages may change.
 * - A **minor** version also adds functions, constants, flags, statuses and fields at the ends of structs,
 *   and may accept what was an error: calls that failed may succeed, and files may give more splines and
 *   fewer notes.
 *   The entry of a function names the version that brought it, and its symbol carries that version
 *   (NURBS_1.0).
 * - A **major** version may do anything, has another file name (libnurbs.so.1 is version 1), and can be
 *   installed beside this one.
 *
 * Names, types, values and meanings never change within a major version. Each struct states its size, so that
 * a library knows which fields its caller has. Fields that a caller lacks have their defaults. Fields that a
 * library does not know must be 0, which leaves them at their defaults (otherwise NURBS_ERROR_OPTIONS). A
 * caller has to be ready for statuses that its header does not name, and must not pass bits or constants that
 * its header does not name. A result that is a sum of bits may get further bits: test bits, do not compare
 * sums. A result that is one of several constants may get further values. The value used for a budget of 0
 * may change.
 *
 * # Bindings
 * A program can read the comments below, and a binding needs nothing else. cmake/interface in the sources
 * reads them, and generates declarations for other languages and manual pages from them.
 *
 * - **Types.** Signatures use int32_t, int64_t, uint32_t, double, pointers to these and to float, char
 *   buffers, arrays of texts, bytes (`const void *`) and opaque handles, structs of these, and one callback (nurbs_progress),
 *   nothing else; nurbs_status is an int32_t. Arrays of float are results in single precision; their strides
 *   count floats. Structs are passed by pointers, and have the layout of C. The texts of their fields begin
 *   as those of parameters do, with a shape and `or NULL`. Constants are ints, except that those that end
 *   with u are uint32_t; the two macros with arguments are for a binding to write itself. Answers of yes or
 *   no are 1 or 0. Arrays are aligned as their elements are in C.
 * - **Functions** have a comment with `\brief`, whose first sentence can stand alone, the text that
 *   belongs to it, and, in this order, a `\param` for every parameter, `\return` unless the result is
 *   void, and `\since`, the version that brought the function. Chapters are `\defgroup`, groups of
 *   constants `\name`. A chapter begins with an example between `\code` and `\endcode`.
 * - **Parameters.** After `\param` come the direction, the names, which share one description if there are
 *   several with commas between, the shape, perhaps `or NULL`, and the text. The direction is `[in]`,
 *   `[out]` for what is only written, or `[in,out]`. Pointers without a shape point to one value, one
 *   handle, one struct or a zero-terminated text.
 * - **Shapes** are in brackets, slowest index first: `[n][dim]` is n records of dim components. They are
 *   written in terms of other parameters, and of properties of the spline that is passed: its axes, its
 *   dimension dim, the number N of its control points, and rational, which is 1 with weights and 0 without;
 *   other letters are explained in the text of the function. Three dots between brackets stand for the
 *   brackets of the other axes. An array of records whose layout the caller chooses is followed at once by a
 *   parameter that ends with _stride, and by another with _component_stride if its records have more than one
 *   component; all other arrays are packed.
 * - **NULL.** A pointer may be NULL if `or NULL` follows its shape, or, without a shape, begins its text.
 *   What follows, up to a colon, says what NULL means; an output without such words is simply not wanted. Any
 *   other pointer is required (NURBS_ERROR_NULL), unless its array has the length 0.
 * - **References.** A parameter whose text begins with another function, as in "as for
 *   nurbs_create()", and has no shape of its own, has the shape of the parameter of that name there, and may
 *   be NULL if that one may be.
 * - **Long calls.** nurbs_X_with() takes the parameters of nurbs_X(), and `call`. Where structs replace
 *   parameters, their fields have the names of these parameters. Such a field has the shape of its parameter,
 *   and may be NULL if the parameter may be. A field for which nurbs_X() has no parameter must be 0 or NULL.
 *   Strides that belong to no array are ignored.
 * - **Statuses** are listed after `\return`: _AXES is short for NURBS_ERROR_AXES. "as for" another function,
 *   at the beginning, stands for all statuses that it lists; "without" takes some away, "instead of"
 *   exchanges them. Conditions follow where the name does not say enough. Functions with other results cannot
 *   fail.
 * - **Ownership.** A handle received through a `nurbs **` or `nurbs_list **` belongs to the caller, who
 *   frees it with nurbs_destroy() or nurbs_list_destroy(). A finalizer may do so in a thread of its own, if
 *   it cannot run before the last call that uses the handle returns. All memory that is passed stays the
 *   caller's, and no pointer to it is kept. The text that nurbs_status_name() returns is static. In arrays
 *   of handles none may be NULL, and the same handle may occur several times.
 * - **Lengths that are not known before.** Where a parameter is called `cap`, arrays have that length. 0
 *   asks for the number needed, which comes back in `count`, `entries` or `length`. With a larger cap nothing
 *   is written beyond that number; a smaller one is NURBS_ERROR_SIZE. Texts of at most cap - 1 bytes
 *   are terminated by a zero, and cut if they are longer.
 * - **Texts** are ASCII, with two exceptions: names from files, which are the bytes of the file in whatever
 *   encoding, and in messages of NURBS_ERROR_FILE the path and the system's words on it.
 * - **Threads.** A message belongs to the thread of the operating system whose call failed. Where a runtime
 *   moves tasks between threads (Go), a task has to stay in its thread until it has read the message. Calls
 *   may take long; those whose names end with _with can be ended. A thread that is cancelled ends after the
 *   call, not in it. It is best to release the locks of an interpreter during a call. 128 KB of stack are
 *   enough for every call.
 */
#ifndef NURBS_NURBS_H
#define NURBS_NURBS_H

#include <stdint.h>

/** \brief Marks the exported functions. */
#if defined(__GNUC__)
#define NURBS_API __attribute__((visibility("default")))
#else
#define NURBS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** \name Version and limits
 * @{ */
/** \brief Changes when programs built with an earlier version may stop working. */
#define NURBS_VERSION_MAJOR 1
/** \brief Changes when functions, constants or options are added. */
#define NURBS_VERSION_MINOR 1
/** \brief Changes when defects are mended. */
#define NURBS_VERSION_PATCH 0
/** \brief major * 10000 + minor * 100 + patch, as returned by nurbs_version(). */
#define NURBS_VERSION (NURBS_VERSION_MAJOR * 10000 + NURBS_VERSION_MINOR * 100 + NURBS_VERSION_PATCH)
/** \brief Highest degree accepted on any axis. */
#define NURBS_MAX_DEGREE 31
/** \brief Highest number of parametric axes. */
#define NURBS_MAX_AXES 3
/** \brief Highest order of derivatives that the evaluating functions compute. */
#define NURBS_MAX_ORDER 255
/** @} */

/** \brief A spline: immutable, reference counted, opaque. */
typedef struct nurbs nurbs; /* in C++ a type and no namespace: the functions of nurbs.hpp are in libnurbs:: */

/** \brief Splines in an order: the parts of one, or what a file held, with names, and notes on everything
 * that was not turned into one. */
typedef struct nurbs_list nurbs_list;

/** \brief What a fit needs to know of data: sums that can be added and subtracted. \since 1.1 */
typedef struct nurbs_statistics nurbs_statistics;

/** \brief A trimmed face: immutable, reference counted, opaque. \since 1.1 */
typedef struct nurbs_face nurbs_face;

/** \brief What a file of faces holds: faces, edges and vertices, in parts that are placed; immutable, reference counted,
 * opaque. \since 1.1 */
typedef struct nurbs_model nurbs_model;

/** \brief Where a surface meets planes: curves, and the places where they end; immutable, reference counted, opaque.
 * \since 1.1 */
typedef struct nurbs_meet nurbs_meet;

/** \brief Triangles in place of shapes; immutable, reference counted, opaque. \since 1.1 */
typedef struct nurbs_mesh nurbs_mesh;

/** \brief Result of a call: 0, or one of the NURBS_ERROR_ codes. */
typedef int32_t nurbs_status;

/** \brief The statuses. Values never change their meaning; new ones may be added. */
enum {
    NURBS_OK = 0, /**< success */
    /* argument */
    NURBS_ERROR_NULL = 1,              /**< a required pointer is NULL */
    NURBS_ERROR_AXES = 2,              /**< number of axes not 1 to 3, or not one that the function is for */
    NURBS_ERROR_AXIS = 3,              /**< axis index not in [0, axes) */
    NURBS_ERROR_DEGREE = 4,            /**< degree not in [0, NURBS_MAX_DEGREE] */
    NURBS_ERROR_COUNT = 5,             /**< a count is negative, or zero where something is needed */
    NURBS_ERROR_TOO_FEW_POINTS = 6,    /**< fewer control points than degree + 1 */
    NURBS_ERROR_OVERFLOW = 7,          /**< the sizes asked for do not fit in memory addresses */
    NURBS_ERROR_SIZE = 8,              /**< a stated array length is not the one required */
    NURBS_ERROR_DIMENSION = 9,         /**< dimension not in [1, 2^31 - 2], or not one allowed here */
    NURBS_ERROR_STRIDE = 10,           /**< negative stride, or neither records nor components lie apart */
    NURBS_ERROR_OVERLAP = 11,          /**< an output array overlaps another array */
    NURBS_ERROR_FLAGS = 12,            /**< unknown flag bits, or flags that exclude each other */
    NURBS_ERROR_ORDER = 13,            /**< derivative order not in [0, NURBS_MAX_ORDER] */
    NURBS_ERROR_KNOT_NOT_FINITE = 14,  /**< a knot is NaN or infinite, or the knots' range overflows */
    NURBS_ERROR_KNOTS_DECREASING = 15, /**< a knot is smaller than the one before it */
    NURBS_ERROR_END_MULTIPLICITY = 16, /**< the first or last knot occurs more than degree + 1 times */
    NURBS_ERROR_MULTIPLICITY = 17, /**< an interior knot occurs, or would occur, more than degree + 1 times */
    NURBS_ERROR_EMPTY_DOMAIN = 18, /**< knots[degree] == knots[count], or an empty interval */
    NURBS_ERROR_POINT_NOT_FINITE = 19,     /**< a coordinate is NaN or infinite */
    NURBS_ERROR_WEIGHT_NOT_FINITE = 20,    /**< a weight is NaN or infinite */
    NURBS_ERROR_WEIGHT_NEGATIVE = 21,      /**< a weight is < 0 */
    NURBS_ERROR_WEIGHTS_VANISH = 22,       /**< all weights that are active at some parameter are 0 */
    NURBS_ERROR_PARAMETER_NOT_FINITE = 23, /**< a parameter is NaN or infinite */
    NURBS_ERROR_PERIODIC_KNOTS = 24, /**< knots of an axis flagged periodic do not repeat with the period */
    NURBS_ERROR_PERIODIC_POINTS =
        25,                      /**< points or weights of an axis flagged periodic do not wrap bit for bit */
    NURBS_ERROR_TIMES = 26,      /**< a number of repetitions is negative */
    NURBS_ERROR_OPTIONS = 27,    /**< an options struct has a wrong size or a value out of range */
    NURBS_ERROR_INDEX = 28,      /**< an index is outside its list */
    NURBS_ERROR_DIRECTION = 29,  /**< a direction is zero, not finite, or parallel to another one */
    NURBS_ERROR_END_KNOT = 30,   /**< a knot at an end of the domain, where it cannot be removed */
    NURBS_ERROR_NOT_A_KNOT = 31, /**< a value that has to be a knot of the axis is not one */
    NURBS_ERROR_MATRIX = 32,     /**< an entry of a matrix or translation is NaN or infinite */
    NURBS_ERROR_RATIONAL = 33,   /**< the spline is rational, which the function is not for */
    NURBS_ERROR_INCOMPATIBLE = 40, /**< splines differ in what they have to share */
    NURBS_ERROR_GAP = 41,          /**< ends that are to be joined lie farther apart than the tolerance */
    NURBS_ERROR_TOLERANCE = 42,    /**< a tolerance is negative or NaN, or otherwise out of range */
    NURBS_ERROR_NOT_PERIODIC = 43, /**< an axis that has to be periodic was not declared so */
    NURBS_ERROR_END_WEIGHTS = 44,  /**< no one factor makes the weights at the ends of an axis equal */
    NURBS_ERROR_FACTOR = 45,       /**< a factor is not finite, or not positive where it has to be */
    NURBS_ERROR_CONTINUITY = 46,   /**< a knot is less smooth than the function needs */
    NURBS_ERROR_WEIGHT_SIGN = 47,  /**< a weight of the result would not be positive */
    NURBS_ERROR_PERIODIC = 48,     /**< an axis is periodic, which the function is not for */
    NURBS_ERROR_END = 49,          /**< an end is neither NURBS_START nor NURBS_END */
    NURBS_ERROR_BASIS = 50,        /**< not one of the NURBS_BASIS_ constants */
    NURBS_ERROR_NOT_MONOTONE = 51, /**< a function neither increases nor decreases strictly */
    NURBS_ERROR_ANGLE = 52,      /**< an angle is not finite or above 2^22, or a sweep is 0 or above a turn */
    NURBS_ERROR_LENGTH = 53,     /**< a radius or another length is not finite or out of range */
    NURBS_ERROR_COLLINEAR = 54,  /**< points that must not be on a line are on one */
    NURBS_ERROR_CONIC = 55,      /**< no conic, or no arc of one in one piece, fulfils the conditions */
    NURBS_ERROR_FORM = 56,       /**< not one of the NURBS_ARC_ constants that are allowed here */
    NURBS_ERROR_TANGENT = 57,    /**< tangents that have to agree differ by more than the tolerance */
    NURBS_ERROR_TWIST = 58,      /**< twists that have to agree differ by more than the tolerance */
    NURBS_ERROR_TWIST_RULE = 59, /**< not one of the NURBS_TWIST_ constants, or one that does not suit */
    NURBS_ERROR_INFLUENCE = 60,  /**< a control point has no influence at the parameter */
    NURBS_ERROR_CONTRADICTION = 61, /**< constraints contradict each other */
    NURBS_ERROR_CONSTRAINT = 62,    /**< not one of the NURBS_CONSTRAIN_ constants */
    NURBS_ERROR_OFF_POLYGON = 63,   /**< a point is not on the control polygon */
    NURBS_ERROR_RULE = 64,          /**< not one of the constants of a rule, or one that does not suit */
    NURBS_ERROR_SCHOENBERG_WHITNEY =
        65, /**< data lie outside the support of the control point that they have to determine */
    NURBS_ERROR_RANK = 66,        /**< data or conditions do not determine the result */
    NURBS_ERROR_SCALE = 67,       /**< a value or weight is above the scale of the statistics */
    NURBS_ERROR_ORIENTATION = 68, /**< loops of a face have no common inside, or enclose nothing */
    NURBS_ERROR_SAME = 69,        /**< one handle where two different shapes are needed */
    NURBS_ERROR_CROSSING = 70,    /**< loops of a face cross themselves or each other */
    /* domain */
    NURBS_ERROR_OUTSIDE_DOMAIN = 100, /**< a parameter or knot lies outside the domain */
    /* numeric */
    NURBS_ERROR_NOT_REPRESENTABLE = 200, /**< a value of the result overflows double precision */
    NURBS_ERROR_KNOTS_MERGE = 202,       /**< knots that differ would become equal or change their order */
    NURBS_ERROR_NOT_CONVERGED = 203,     /**< an iteration did not reach its goal */
    /* resource */
    NURBS_ERROR_MEMORY = 300,    /**< an allocation failed */
    NURBS_ERROR_FILE = 301,      /**< a file cannot be opened or read */
    NURBS_ERROR_TOO_LARGE = 302, /**< a file exceeds the size limit of the options */
    NURBS_ERROR_CANCELLED = 303, /**< the callback of a long call asked for its end */
    NURBS_ERROR_WORK = 304,      /**< the limit of work of a long call was reached before its end */
    /* file contents */
    NURBS_ERROR_FORMAT = 400, /**< not a file of a known format */
    NURBS_ERROR_TRUNCATED =
        401,                  /**< the file ends, or a section is missing, before its contents are complete */
    NURBS_ERROR_SYNTAX = 402, /**< the file breaks the rules of its format */
    NURBS_ERROR_UNSUPPORTED = 403, /**< an entity that this version does not read (only in notes) */
    NURBS_ERROR_CHECKSUM = 404,    /**< bytes of a handle are not those that were written */
    NURBS_ERROR_VERSION = 405,     /**< bytes of a handle have a later version of the form */
    NURBS_ERROR_CYCLE = 406,       /**< entities of a file contain each other (only in notes) */
    /* internal */
    NURBS_ERROR_INTERNAL = 900 /**< a defect of the library; please report it */
};

/** \name Flags by axis
 * Each axis has eight bits: bits 0-7 for axis 0, 8-15 for axis 1, 16-23 for axis 2; bits 24-31 are global.
 * Combine the constants below with NURBS_ON_AXIS() or NURBS_ON_ALL_AXES(). A set bit that is not defined, or
 * belongs to an axis that the spline lacks, is NURBS_ERROR_FLAGS.
 * @{ */
/** \brief The bits `flags` moved to those of `axis`. */
#define NURBS_ON_AXIS(axis, flags) ((uint32_t)(flags) << (8 * (axis)))
/** \brief The bits `flags` for the first `axes` axes (1, 2 or 3). */
#define NURBS_ON_ALL_AXES(axes, flags) ((uint32_t)(flags) * (0x010101u >> (8 * (3 - (axes)))))
/** \brief Evaluation: at a knot take the limit from below. */
#define NURBS_LEFT 0x01u
/** \brief Evaluation: move a parameter outside the domain (infinite ones too) to the nearer end. */
#define NURBS_CLAMP 0x02u
/** \brief Evaluation: outside the domain continue the first or last polynomial piece. */
#define NURBS_EXTRAPOLATE 0x04u
/** \brief Evaluation: reduce the parameter by multiples of the domain's length; the start and the end are the
 * same place, seen from the right unless NURBS_LEFT is set. Allowed on every axis, periodic or not. */
#define NURBS_WRAP 0x08u
/** \brief Evaluation: a parameter that cannot be evaluated gives NaN instead of an error. NURBS_CLAMP,
 * NURBS_EXTRAPOLATE and NURBS_WRAP exclude each other; each may be combined with NURBS_NAN. */
#define NURBS_NAN 0x10u
/** \brief Creation: the axis is periodic with period knots[count] - knots[degree]: knots[i + m] = knots[i] +
 * period to within the rounding of the largest knot, and the last `degree` layers of points and weights equal
 * the first ones bit for bit, where m = count - degree is the number of distinct layers. Operations keep the
 * axis periodic. */
#define NURBS_PERIODIC 0x01u
/** @} */

/** \name Global flags
 * One bit may mean different things to different functions; each accepts only the flags that its entry names.
 * @{ */
/** \brief nurbs_eval_adjoint() and the other adjoints: add to what the outputs hold instead of overwriting
 * it. */
#define NURBS_ACCUMULATE 0x01000000u
/** \brief nurbs_reverse(): map the domain to itself instead of negating the parameter. */
#define NURBS_KEEP_DOMAIN 0x02000000u
/** \brief nurbs_join(): ends that do not meet become a jump instead of an error; nurbs_face_create(): segments
 * close what curves leave open. */
#define NURBS_KEEP_GAPS 0x04000000u
/** \brief nurbs_product(): the dot product. */
#define NURBS_PRODUCT_DOT 0x08000000u
/** \brief nurbs_product(): the cross product in dimension 3. */
#define NURBS_PRODUCT_CROSS 0x10000000u
/** \brief nurbs_create_power(), nurbs_unclamp(): homogeneous records (w x, w y, ..., w). */
#define NURBS_HOMOGENEOUS 0x20000000u
/** \brief nurbs_make_compatible(): map the domains of all splines to that of the first one. */
#define NURBS_MAP_DOMAINS 0x40000000u
/** \brief nurbs_curve_divide(): equal distances of consecutive points instead of equal lengths. */
#define NURBS_EQUAL_CHORDS 0x02000000u
/** \brief nurbs_snap_boundary(): the two boundaries run against each other. */
#define NURBS_REVERSED 0x04000000u
/** \brief nurbs_closest_points() and its neighbours: a point that is not finite gives NaN instead of
 * an error. */
#define NURBS_NAN_POINTS 0x01000000u
/** \brief nurbs_face_create(): the inside is to the left of the loops as they run. */
#define NURBS_AS_ORIENTED 0x01000000u
/** \brief nurbs_face_create(): loops that cross themselves or each other are refused. */
#define NURBS_CHECK_CROSSINGS 0x02000000u
/** @} */

/** \name Form of a knot vector, as reported by nurbs_knot_form()
 * @{ */
#define NURBS_FORM_CLAMPED_START 0x01 /**< the first degree + 1 knots are equal */
#define NURBS_FORM_CLAMPED_END 0x02   /**< the last degree + 1 knots are equal */
#define NURBS_FORM_PERIODIC 0x04      /**< the axis was declared periodic */
/** @} */

/** \name Bases of a polynomial segment, for nurbs_basis_matrix()
 * @{ */
#define NURBS_BASIS_POWER 0     /**< 1, t, t^2, ... */
#define NURBS_BASIS_BERNSTEIN 1 /**< the Bezier points over [0, 1] */
#define NURBS_BASIS_HERMITE 2   /**< f(0), f'(0), ..., then f(1), f'(1), ...; odd degrees */
#define NURBS_BASIS_BSPLINE 3   /**< control points over the knots -degree, ..., degree + 1 */
/** @} */

/** \name Rules for parameters, for nurbs_parametrize()
 * @{ */
#define NURBS_PARAMS_UNIFORM 0       /**< equal steps */
#define NURBS_PARAMS_CHORD 1         /**< steps in proportion to the chords */
#define NURBS_PARAMS_CENTRIPETAL 2   /**< steps in proportion to the square roots of the chords (Lee 1989) */
#define NURBS_PARAMS_POWER 3         /**< steps in proportion to a power of the chords */
#define NURBS_PARAMS_FOLEY_NIELSON 4 /**< steps in proportion to the chords, longer where the polygon turns */
/** @} */

/** \name Ends of an interpolating spline, for nurbs_interpolate()
 * @{ */
#define NURBS_ENDS_NOT_A_KNOT 0 /**< the parameters next to the end are not knots */
#define NURBS_ENDS_NATURAL 1 /**< derivatives of orders (degree + 1) / 2 to degree - 1 vanish; odd degrees */
#define NURBS_ENDS_FREE 2    /**< knots averaged from the parameters (nurbs_knots_averaged()); both ends */
/** @} */

/** \name Special orders of derivatives, for nurbs_curve_interpolate()
 * @{ */
#define NURBS_ORDER_DIRECTION (-1) /**< the first derivative has the direction of the target, of any length */
/** @} */

/** \name How smooth a fit is, for nurbs_fit_options
 * @{ */
#define NURBS_SMOOTHING_NONE 0        /**< only the data count */
#define NURBS_SMOOTHING_LAMBDA 1      /**< the factor of the penalty is given */
#define NURBS_SMOOTHING_GCV 2         /**< by generalised cross validation (Craven & Wahba 1979) */
#define NURBS_SMOOTHING_REML 3        /**< by restricted maximum likelihood (Wood 2011) */
#define NURBS_SMOOTHING_DISCREPANCY 4 /**< as smooth as a given sum of squares allows (Reinsch 1967) */
/** @} */

/** \name How much outliers count, for nurbs_fit_options
 * @{ */
#define NURBS_ROBUST_NONE 0  /**< as much as other data */
#define NURBS_ROBUST_HUBER 1 /**< their weight times min(1, 1 / x) (Huber 1964) */
#define NURBS_ROBUST_TUKEY 2 /**< their weight times (1 - x^2)^2 for x < 1, else 0 (Beaton & Tukey 1974) */
/** @} */

/** \name Shapes along an axis, for nurbs_fit_options; they can be added
 * @{ */
#define NURBS_TREND_RISING 0x01  /**< the first derivative is >= 0 */
#define NURBS_TREND_FALLING 0x02 /**< the first derivative is <= 0 */
#define NURBS_TREND_CONVEX 0x04  /**< the first derivative does not fall */
#define NURBS_TREND_CONCAVE 0x08 /**< the first derivative does not rise */
/** @} */

/** \name Bits of nurbs_fit_report
 * @{ */
#define NURBS_FIT_TARGET_MISSED 0x01 /**< the target, or the tolerance, is not reached */
#define NURBS_FIT_NOT_CONVERGED 0x02 /**< the last round of a robust fit, or of a shape, still changed it */
/** @} */

/** \name Bits of nurbs_cloud_report
 * @{ */
#define NURBS_CLOUD_NOT_CONVERGED                                                                            \
    0x01 /**< the rounds, or the limit of work, ended while the sum was still falling */
/** @} */

/** \name Rules for tangents, for nurbs_tangents()
 * @{ */
#define NURBS_TANGENTS_CATMULL_ROM 0 /**< the slope between the neighbours */
#define NURBS_TANGENTS_BESSEL 1      /**< the slope of the parabola through a point and its neighbours */
#define NURBS_TANGENTS_AKIMA 2       /**< mean of both slopes, weighted by their steadiness (Akima 1970) */
#define NURBS_TANGENTS_MONOTONE                                                                              \
    3 /**< each coordinate rises and falls as the data do (Fritsch & Butland 1984) */
/** @} */

/** \name Ends of an axis
 * @{ */
#define NURBS_START 0 /**< the lower end of the domain */
#define NURBS_END 1   /**< the upper end of the domain */
/** @} */

/** \defgroup errors Version and errors
 * \code
 * char message[256];
 * nurbs *finer = NULL;
 * const nurbs_status status = nurbs_insert_knot(curve, 0, 1e9, 1, &finer); // outside the domain
 * if (status != NURBS_OK) {
 *     nurbs_last_error(message, sizeof message);
 *     printf("%s: %s\n", nurbs_status_name(status), message);
 * }
 * \endcode
 * @{ */

/** \brief Version of the library that is running, encoded like NURBS_VERSION.
 * \return the version number.
 * \since 1.0 */
NURBS_API int32_t nurbs_version(void);

/** \brief Name of a status, such as "NURBS_ERROR_NULL".
 * \param[in] status any value.
 * \return a static string, never NULL; "NURBS_ERROR_UNKNOWN" for values without a name.
 * \since 1.0 */
NURBS_API const char *nurbs_status_name(nurbs_status status);

/** \brief Copies the message of the last failed call in the calling thread, such as "params[17] = 1.2 outside
 * [0, 1]". Successful calls leave the message as it was, and so does this one; before any failure it is
 * empty. At most cap - 1 bytes and a terminating zero are written.
 * \param[out] buf [cap] or NULL, which asks for the length only: receives the text.
 * \param[in] cap size of buf in bytes; values < 0 count as 0.
 * \return the length of the whole message, without the terminating zero.
 * \since 1.0 */
NURBS_API int64_t nurbs_last_error(char *buf, int64_t cap);
/** @} */

/** \defgroup call Long calls
 * \code
 * nurbs_call_options call;
 * double length = 0;
 * nurbs_call_options_init(&call, sizeof call);
 * call.work = 1000000000; // a second or two
 * nurbs_curve_length_with(curve, NULL, 1e-12, &length, NULL, &call);
 * \endcode
 * A function that can take long has a second form whose name ends with _with. It has one more argument,
 * `call`, which comes last, or before a new handle. The result is the same, bit for bit. Where there would be
 * more than 12 arguments, structs replace them.
 *
 * **Progress.** The callback runs in the thread of the call, at most every 10 ms, so that a short call may
 * end without one. If it returns anything but 0, the call ends with NURBS_ERROR_CANCELLED and writes nothing.
 * No lock is held while it runs: the callback may call any function with any handle, but it must not destroy
 * what the call was given. Neither an exception nor longjmp() may leave it: keep the exception, return 1, and
 * raise it after the call. (A C++ exception that leaves the callback ends the call as 1 does, and is lost;
 * what longjmp() skips is never freed.) The callback may end its thread by pthread_exit(); a thread that is
 * cancelled in the callback ends after the call.
 *
 * **Work** is counted in multiply-adds, which are estimated. No clock measures it, so the load of the machine
 * changes no result. A processor does some 10^9 multiply-adds in a second or two. What a handle keeps for
 * later calls (tables and trees) is not counted; the first call that needs it builds it, however long that
 * takes. At the limit of work, a function that answers with NURBS_CLOSEST_BUDGET or `complete` returns what
 * is proven so far, and says so, as at the end of its budget; the remaining points of a batch get what is
 * found without a search. Fits to a tolerance, approximations and fits of clouds search with half of the
 * work, and return the best result that they found if the rest is enough to finish it. Any other function
 * returns NURBS_ERROR_WORK and writes nothing.
 *
 * **Without a limit of the caller** the functions that search until a condition holds (distances of two
 * splines and of faces, features of curves and extrema, the fold test, where curves and surfaces meet, sections
 * and levels, projections, divisions by length, meshes, constraints, bends, free-form deformations, fits to a
 * tolerance and of clouds, approximations) have a limit of their own: some 10^9 multiply-adds,
 * about a second, plus 20000 to 1500000 for each control point or datum. There they do what they do at a
 * limit of the caller, but return NURBS_ERROR_NOT_CONVERGED instead of NURBS_ERROR_WORK; fits always have a
 * result. The `work` of the caller, or a budget, replaces this limit.
 * @{ */

/** \brief Called with how much of a call is done: an estimate from 0 to 1 that never decreases. A result
 * other than 0 ends the call. */
typedef int32_t (*nurbs_progress)(double done, void *user);

/** \brief Limit of work and progress callback of a long call; fill with nurbs_call_options_init() first.
 * Fields are only ever appended, and struct_size is at most 4096. */
typedef struct nurbs_call_options {
    int64_t struct_size;     /**< size of this struct as the caller knows it */
    int64_t work;            /**< largest number of multiply-adds; 0: no limit of the caller */
    nurbs_progress progress; /**< or NULL: called now and then */
    void *user;              /**< or NULL: passed to progress */
} nurbs_call_options;

/** \brief Fills an options struct with the defaults: no limit, no callback.
 * \param[out] options the struct.
 * \param[in] struct_size sizeof(nurbs_call_options).
 * \return NURBS_OK, NURBS_ERROR_NULL, _OPTIONS.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_call_options_init(nurbs_call_options *options, int64_t struct_size);
/** @} */

/** \defgroup create Construction
 * \code
 * const int32_t degrees[] = {1, 1}; // a bilinear surface with 2 x 2 control points
 * const int64_t counts[] = {2, 2};
 * const double knots[] = {0, 0, 1, 1, 0, 0, 1, 1};
 * const double points[4][3] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
 * nurbs *made = NULL;
 * nurbs_create(2, degrees, counts, knots, 8, 3, points[0], 0, 0, NULL, 0, 0, &made);
 * nurbs_destroy(made);
 * \endcode
 * @{ */

/** \brief A spline from full knot vectors, Cartesian points and optional weights.
 * With C_k = counts[k] and p_k = degrees[k], the number of points is N = C_0 * ... * C_(axes-1).
 * \param[in] axes number of parametric axes: 1, 2 or 3.
 * \param[in] degrees [axes] degree along each axis.
 * \param[in] counts [axes] number of control points along each axis.
 * \param[in] knots [knot_count] the knot vectors of all axes, one after the other.
 * \param[in] knot_count total number of knots, the sum of (counts[k] + degrees[k] + 1).
 * \param[in] dim dimension of the points.
 * \param[in] points [N][dim] Cartesian control points, last axis fastest.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] weights [N] or NULL for a polynomial spline.
 * \param[in] weight_stride distance between weights, 0 = 1.
 * \param[in] flags NURBS_PERIODIC per axis.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DEGREE, _COUNT, _TOO_FEW_POINTS, _OVERFLOW, _SIZE, _DIMENSION,
 *   _STRIDE, _FLAGS, _KNOT_NOT_FINITE, _KNOTS_DECREASING, _END_MULTIPLICITY, _MULTIPLICITY, _EMPTY_DOMAIN,
 *   _POINT_NOT_FINITE, _WEIGHT_NOT_FINITE, _WEIGHT_NEGATIVE, _WEIGHTS_VANISH, _PERIODIC_KNOTS,
 *   _PERIODIC_POINTS;
 *   _NOT_REPRESENTABLE if a weight times a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_create(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                    const double *knots, int64_t knot_count, int32_t dim,
                                    const double *points, int64_t point_stride,
                                    int64_t point_component_stride, const double *weights,
                                    int64_t weight_stride, uint32_t flags, nurbs **out);

/** \brief A rational spline from homogeneous points (w x, w y, ..., w).
 * Weights may be negative or zero: a record with w = 0 is a control point at infinity in the direction of its
 * other components. Some weight in every span's support must differ from 0. Where w(t) = 0 evaluation yields
 * the infinities and NaNs of the division.
 * \param[in] axes,degrees,counts,knots,knot_count as for nurbs_create().
 * \param[in] dim dimension of the Cartesian points.
 * \param[in] points [N][dim + 1] homogeneous control points, last axis fastest, weight last.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] flags NURBS_PERIODIC per axis.
 * \param[out] out the new handle.
 * \return as for nurbs_create(), without _WEIGHT_NEGATIVE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_create_homogeneous(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                                const double *knots, int64_t knot_count, int32_t dim,
                                                const double *points, int64_t point_stride,
                                                int64_t point_component_stride, uint32_t flags, nurbs **out);

/** \brief A spline from knot vectors without their first and last knot, as openNURBS, Rhino and Maya write
 * them. Each vector has counts[k] + degrees[k] - 1 values; the missing end knots influence nothing inside the
 * domain and are set to the value next to them, or, on a periodic axis, to the one that the period asks for.
 * Degree >= 1.
 * \param[in]
 *   axes,degrees,counts,knots,dim,points,point_stride,point_component_stride,weights,weight_stride,flags as
 *   for nurbs_create(), except that degrees are >= 1.
 * \param[in] knot_count total number of knots, the sum of (counts[k] + degrees[k] - 1).
 * \param[out] out the new handle.
 * \return as for nurbs_create().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_create_short(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                          const double *knots, int64_t knot_count, int32_t dim,
                                          const double *points, int64_t point_stride,
                                          int64_t point_component_stride, const double *weights,
                                          int64_t weight_stride, uint32_t flags, nurbs **out);

/** \brief A spline from distinct knots with multiplicities, as STEP and Open CASCADE write them.
 * On each axis the multiplicities add up to counts[k] + degrees[k] + 1.
 * \param[in] axes,degrees,counts,dim,points,point_stride,point_component_stride,weights,weight_stride,flags
 *   as for nurbs_create().
 * \param[in] distinct_counts [axes] number of distinct knots of each axis.
 * \param[in] distinct_knots [sum of distinct_counts] strictly increasing on each axis, the axes one after the
 *   other.
 * \param[in] multiplicities [sum of distinct_counts] each >= 1.
 * \param[out] out the new handle.
 * \return as for nurbs_create(); _SIZE if multiplicities do not add up, _COUNT for a multiplicity < 1,
 *   _KNOTS_DECREASING for knots that do not increase.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_create_multiplicities(int32_t axes, const int32_t *degrees,
                                                   const int64_t *counts, const int64_t *distinct_counts,
                                                   const double *distinct_knots,
                                                   const int32_t *multiplicities, int32_t dim,
                                                   const double *points, int64_t point_stride,
                                                   int64_t point_component_stride, const double *weights,
                                                   int64_t weight_stride, uint32_t flags, nurbs **out);

/** \brief A spline whose periodic axes are given without what they repeat: each control point once, and the
 * knots of one period. On an axis with flag NURBS_PERIODIC counts[k] = m >= 1 is the number of control
 * points that differ, and the knots are m + 1 values u_0 <= ... <= u_m, u_0 < u_m, where u_m is u_0 a period
 * T = u_m - u_0 later; the domain is [u_0, u_m]. With u_(i + j m) = u_i + j T and P_(i + j m) = P_i for all
 * integers j,
 *
 *     C(t) = sum over all i of P_i N_i(t), where N_i is the B-spline of degree p on u_(i-p), ..., u_(i+1).
 *
 * What is stored is the full form of nurbs_create(), which nurbs_knots_periodic() describes: m + p control
 * points, the last p of which repeat the first, and m + 2 p + 1 knots, with u_0 = t_p. m may be less than p:
 * points then repeat several times. A knot occurs at most p + 1 times in a period, where copies of u_0 and
 * of u_m count as those of one knot, u_m itself left out. Other axes are as for nurbs_create();
 * nurbs_unwrapped_knots() and nurbs_unwrapped_points() give all of it back, bit for bit.
 * \param[in] axes,degrees,dim,point_stride,point_component_stride,weight_stride,flags as for nurbs_create().
 * \param[in] counts [axes] number of control points along each axis, m on periodic ones.
 * \param[in] knots [knot_count] the knots of all axes, one after the other.
 * \param[in] knot_count total number of knots: the sum of counts[k] + 1 for periodic axes, counts[k] +
 *   degrees[k] + 1 for others.
 * \param[in] points [N][dim] Cartesian control points, last axis fastest; N = counts[0] * ... *
 *   counts[axes-1].
 * \param[in] weights [N] or NULL for a polynomial spline.
 * \param[out] out the new handle.
 * \return as for nurbs_create(), without _END_MULTIPLICITY, _PERIODIC_KNOTS, _PERIODIC_POINTS on periodic
 *   axes; _NOT_REPRESENTABLE also if knots beside the period overflow, or too many become equal by rounding.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_create_periodic(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                             const double *knots, int64_t knot_count, int32_t dim,
                                             const double *points, int64_t point_stride,
                                             int64_t point_component_stride, const double *weights,
                                             int64_t weight_stride, uint32_t flags, nurbs **out);

/** \brief A Bezier curve, patch or volume over [0, 1] on every axis: degrees[k] + 1 points along axis k, N in
 * all, no knots.
 * \param[in] axes,dim,points,point_stride,point_component_stride,weights,weight_stride as for nurbs_create().
 * \param[in] degrees [axes] degree along each axis.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DEGREE, _OVERFLOW, _DIMENSION, _STRIDE, _POINT_NOT_FINITE,
 *   _WEIGHT_NOT_FINITE, _WEIGHT_NEGATIVE, _WEIGHTS_VANISH;
 *   _NOT_REPRESENTABLE if a weight times a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_create_bezier(int32_t axes, const int32_t *degrees, int32_t dim,
                                           const double *points, int64_t point_stride,
                                           int64_t point_component_stride, const double *weights,
                                           int64_t weight_stride, nurbs **out);

/** \brief The same degrees, knots, dimension and periodicity with other points; knots and their tables are
 * shared, not copied.
 * \param[in] g a spline.
 * \param[in] points [N][dim] Cartesian control points, last axis fastest, N and dim those of g.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] weights [N] or NULL to keep the weights of g (a polynomial spline stays polynomial).
 * \param[in] weight_stride distance between weights, 0 = 1.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _STRIDE, _POINT_NOT_FINITE, _WEIGHT_NOT_FINITE, _WEIGHT_NEGATIVE,
 *   _WEIGHTS_VANISH, _PERIODIC_POINTS, _OVERFLOW; _NOT_REPRESENTABLE if a weight times a coordinate
 *   overflows; _WEIGHT_NEGATIVE or _WEIGHTS_VANISH also when kept weights of a homogeneous spline do not suit
 *   Cartesian points.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_with_points(const nurbs *g, const double *points, int64_t point_stride,
                                         int64_t point_component_stride, const double *weights,
                                         int64_t weight_stride, nurbs **out);

/** \brief Another handle on the same spline, in constant time.
 * \param[in] g a spline.
 * \param[out] out the new handle, to be destroyed like any other.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_clone(const nurbs *g, nurbs **out);

/** \brief Frees a handle. What was derived from it stays valid.
 * \param[in] g or NULL, which does nothing: a handle.
 * \since 1.0 */
NURBS_API void nurbs_destroy(nurbs *g);
/** @} */

/** \defgroup knots Knot vectors
 * \code
 * const double params[] = {0, 0.1, 0.3, 0.4, 0.8, 0.9, 1}; // of 7 points that a cubic interpolates
 * double knots[11];
 * nurbs_knots_averaged(3, 7, params, 11, knots);
 * \endcode
 * @{ */

/** \brief Uniform unclamped knots: t_i = a + (i - p) h with h = (b - a) / (count - p); domain [a, b].
 * The knots suit a NURBS_PERIODIC axis.
 * \param[in] degree p.
 * \param[in] count number of control points, > p.
 * \param[in] a,b the domain, a < b.
 * \param[in] knot_count count + degree + 1.
 * \param[out] knots [knot_count].
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _COUNT, _TOO_FEW_POINTS, _SIZE, _OVERFLOW, _KNOT_NOT_FINITE,
 *   _EMPTY_DOMAIN; _NOT_REPRESENTABLE if knots overflow or [a, b] has no room for them.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_knots_uniform(int32_t degree, int64_t count, double a, double b,
                                           int64_t knot_count, double *knots);

/** \brief Open uniform (quasi-uniform, clamped) knots: a and b degree + 1 times, the others evenly between.
 * \param[in] degree p.
 * \param[in] count number of control points, > p.
 * \param[in] a,b the domain, a < b.
 * \param[in] knot_count count + degree + 1.
 * \param[out] knots [knot_count].
 * \return as for nurbs_knots_uniform().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_knots_open_uniform(int32_t degree, int64_t count, double a, double b,
                                                int64_t knot_count, double *knots);

/** \brief Piecewise Bezier knots: the ends degree + 1 times, each inner break degree times (degree 0: once).
 * The number of control points is pieces * degree + 1 (degree 0: pieces).
 * \param[in] degree p.
 * \param[in] pieces number of Bezier pieces, >= 1.
 * \param[in] breaks [pieces + 1] or NULL for 0, 1/pieces, ..., 1: strictly increasing.
 * \param[in] knot_count number of control points + degree + 1.
 * \param[out] knots [knot_count].
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _COUNT, _SIZE, _OVERFLOW, _OVERLAP, _KNOT_NOT_FINITE,
 *   _KNOTS_DECREASING.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_knots_bezier(int32_t degree, int64_t pieces, const double *breaks,
                                          int64_t knot_count, double *knots);

/** \brief Clamped knots averaged from parameters, for interpolation: t_(j+p) = (s_j + ... + s_(j+p-1)) / p,
 * j = 1, ..., count - p - 1; the ends are s_0 and s_(count-1). Degree 0: the midpoints. (de Boor 1978; Piegl
 * & Tiller 9.8.)
 * \param[in] degree p.
 * \param[in] count number of parameters and of control points, > p.
 * \param[in] params [count] non-decreasing, first < last.
 * \param[in] knot_count count + degree + 1.
 * \param[out] knots [knot_count].
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _COUNT, _TOO_FEW_POINTS, _SIZE, _OVERFLOW, _OVERLAP,
 *   _PARAMETER_NOT_FINITE, _KNOTS_DECREASING, _EMPTY_DOMAIN, _NOT_REPRESENTABLE; _END_MULTIPLICITY or
 *   _MULTIPLICITY if parameters repeat so often that a knot would.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_knots_averaged(int32_t degree, int64_t count, const double *params,
                                            int64_t knot_count, double *knots);

/** \brief Periodic knots from the breaks of one period: the given knots with their multiplicities, continued
 * with the period on both sides. With m = sum of multiplicities[0 .. n-2] there are m distinct control
 * points, m + degree in all.
 * \param[in] degree p.
 * \param[in] n number of breaks, >= 2; the last break is the first one of the next period.
 * \param[in] breaks [n] strictly increasing.
 * \param[in] multiplicities [n] or NULL for 1: each in [1, degree + 1] (degree 0: 1), the last equal to the
 *   first.
 * \param[in] knot_count m + 2 * degree + 1.
 * \param[out] knots [knot_count].
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _COUNT, _SIZE, _OVERFLOW, _OVERLAP, _KNOT_NOT_FINITE,
 *   _KNOTS_DECREASING, _MULTIPLICITY; _PERIODIC_KNOTS if the first and last multiplicities differ;
 *   _NOT_REPRESENTABLE if knots overflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_knots_periodic(int32_t degree, int64_t n, const double *breaks,
                                            const int32_t *multiplicities, int64_t knot_count, double *knots);
/** @} */

/** \defgroup inspect Inspection
 * \code
 * int32_t degree = 0;
 * int64_t count = 0;
 * double domain[2];
 * nurbs_degree(surface, 1, &degree); // along axis 1
 * nurbs_count(surface, 1, &count);
 * nurbs_domain(surface, 1, domain);
 * \endcode
 * @{ */

/** \brief Number of parametric axes: 1 curve, 2 surface, 3 volume.
 * \param[in] g a spline.
 * \param[out] axes the number.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_axes(const nurbs *g, int32_t *axes);

/** \brief Dimension of the (Cartesian) points.
 * \param[in] g a spline.
 * \param[out] dim the dimension.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_dimension(const nurbs *g, int32_t *dim);

/** \brief Degree along an axis.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[out] degree the degree.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_degree(const nurbs *g, int32_t axis, int32_t *degree);

/** \brief Number of control points along an axis. The axis has count + degree + 1 knots.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[out] count the number.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_count(const nurbs *g, int32_t axis, int64_t *count);

/** \brief Number N of control points of all axes together: the product of the counts.
 * \param[in] g a spline.
 * \param[out] count the number.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_point_count(const nurbs *g, int64_t *count);

/** \brief Whether the spline carries weights, equal ones included.
 * \param[in] g a spline.
 * \param[out] rational 1 rational, 0 polynomial.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_is_rational(const nurbs *g, int32_t *rational);

/** \brief Whether the stored values are homogeneous points: those of nurbs_create_homogeneous(), and of
 * operations on such a spline that keep its weights. nurbs_homogeneous_points() then returns the stored bits,
 * otherwise nurbs_points() and nurbs_weights() do; creating a spline anew from what is stored gives the same
 * spline.
 * \param[in] g a spline.
 * \param[out] homogeneous 1 homogeneous points, 0 Cartesian points with or without weights.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_is_homogeneous(const nurbs *g, int32_t *homogeneous);

/** \brief The full knot vector of an axis.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] knot_count count + degree + 1 of the axis.
 * \param[out] knots [knot_count].
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _SIZE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_knots(const nurbs *g, int32_t axis, int64_t knot_count, double *knots);

/** \brief The knots of an axis without the first and the last one, as nurbs_create_short() takes them and
 * openNURBS, Rhino and Maya keep them. The form with multiplicities is that of nurbs_distinct_knots().
 * \param[in] g a spline.
 * \param[in] axis 0-based axis, of degree >= 1.
 * \param[in] cap length of knots; 0 asks for the number only.
 * \param[out] knots [cap] or NULL: receives the knots.
 * \param[out] count or NULL: their number, count + degree - 1 of the axis.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _DEGREE, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_short_knots(const nurbs *g, int32_t axis, int64_t cap, double *knots,
                                         int64_t *count);

/** \brief The distinct knots of an axis and how often each occurs; those outside the domain are included.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] cap length of the two arrays; 0 asks for the number only.
 * \param[out] knots [cap] or NULL: receives the distinct knots.
 * \param[out] multiplicities [cap] or NULL: receives their multiplicities.
 * \param[out] count the number of distinct knots.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _COUNT; _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_distinct_knots(const nurbs *g, int32_t axis, int64_t cap, double *knots,
                                            int32_t *multiplicities, int64_t *count);

/** \brief Form of the knot vector of an axis: clamped at the start, at the end, declared periodic; 0 is
 * plainly unclamped.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[out] form sum of NURBS_FORM_ bits.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_knot_form(const nurbs *g, int32_t axis, int32_t *form);

/** \brief Domain of an axis: [knots[degree], knots[count]].
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[out] domain [2] lower and upper end.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_domain(const nurbs *g, int32_t axis, double *domain);

/** \brief Greville abscissae of an axis: x_i = (t_(i+1) + ... + t_(i+p)) / p; for degree 0 (t_i + t_(i+1)) /
 * 2.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] count number of control points of the axis.
 * \param[out] abscissae [count].
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _SIZE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_greville(const nurbs *g, int32_t axis, int64_t count, double *abscissae);

/** \brief The Cartesian control points. Those of a spline made by nurbs_create_homogeneous() are divided by
 * their weights; a point at infinity has infinite and NaN coordinates.
 * \param[in] g a spline.
 * \param[in] count number N of control points.
 * \param[out] points [count][dim] last axis fastest.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \return NURBS_OK, NURBS_ERROR_NULL, _SIZE, _STRIDE, _OVERFLOW.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_points(const nurbs *g, int64_t count, double *points, int64_t point_stride,
                                    int64_t point_component_stride);

/** \brief The weights; all 1 for a polynomial spline.
 * \param[in] g a spline.
 * \param[in] count number N of control points.
 * \param[out] weights [count] last axis fastest.
 * \param[in] weight_stride distance between weights, 0 = 1.
 * \return NURBS_OK, NURBS_ERROR_NULL, _SIZE, _STRIDE, _OVERFLOW.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_weights(const nurbs *g, int64_t count, double *weights, int64_t weight_stride);

/** \brief The homogeneous control points (w x, w y, ..., w); w = 1 for a polynomial spline.
 * \param[in] g a spline.
 * \param[in] count number N of control points.
 * \param[out] points [count][dim + 1] last axis fastest.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \return NURBS_OK, NURBS_ERROR_NULL, _SIZE, _STRIDE, _OVERFLOW.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_homogeneous_points(const nurbs *g, int64_t count, double *points,
                                                int64_t point_stride, int64_t point_component_stride);

/** \brief Number of control points along an axis, each counted once: count - degree on a periodic axis, count
 * on any other.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[out] count the number.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_unwrapped_count(const nurbs *g, int32_t axis, int64_t *count);

/** \brief The knots of an axis as nurbs_create_periodic() takes them: those from the start to the end of the
 * domain of a periodic axis, knots[degree] to knots[count], and all knots of any other.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] cap length of knots; 0 asks for the number only.
 * \param[out] knots [cap] or NULL: receives the knots.
 * \param[out] count or NULL: their number, nurbs_unwrapped_count() + 1 on a periodic axis.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_unwrapped_knots(const nurbs *g, int32_t axis, int64_t cap, double *knots,
                                             int64_t *count);

/** \brief Control points and weights, each once, as nurbs_create_periodic() takes them: along periodic axes
 * without the last `degree` ones, which repeat others. Points of a homogeneous spline are divided by their
 * weights.
 * \param[in] g a spline.
 * \param[in] cap length of the two arrays; 0 asks for the number only.
 * \param[out] points [cap][dim] or NULL: receives the Cartesian points, last axis fastest.
 * \param[out] weights [cap] or NULL: receives the weights, all 1 for a polynomial spline.
 * \param[out] count or NULL: number of points, the product of nurbs_unwrapped_count() of all axes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_unwrapped_points(const nurbs *g, int64_t cap, double *points, double *weights,
                                              int64_t *count);

/** \brief Local hull size: the largest |coordinate| among the active control points of positive weight at
 * each parameter, the `hull` of the accuracy contract. With signed weights it is (max|w_i P_i| + |C(t)|
 * max|w_i|) / |w(t)|.
 * \param[in] g a spline.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] sizes [n].
 * \param[in] size_stride distance between sizes, 0 = 1.
 * \param[in] flags evaluation flags per axis.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _FLAGS, _PARAMETER_NOT_FINITE,
 *   _OUTSIDE_DOMAIN.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_hull_size(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                       int64_t param_component_stride, double *sizes, int64_t size_stride,
                                       uint32_t flags);
/** @} */

/** \defgroup basis Bases
 * \code
 * const double knots[] = {0, 0, 0, 0.5, 1, 1, 1}, param = 0.3;
 * int64_t span = 0;
 * double values[3]; // the functions of degree 2 that do not vanish there
 * nurbs_basis(2, 4, knots, 7, 0, 1, &param, 0, &span, values, 0, 0, 0);
 * \endcode
 * @{ */

/** \brief Span of each parameter: the index s with knots[s] <= t < knots[s+1] (the last span is closed),
 * degree <= s < count, never an empty span. The basis functions s - degree, ..., s are the ones that do not
 * vanish there.
 * \param[in] degree,count degree and number of control points.
 * \param[in] knots [knot_count] a full knot vector.
 * \param[in] knot_count number of knots: count + degree + 1.
 * \param[in] n number of parameters.
 * \param[in] params [n].
 * \param[in] param_stride distance between parameters, 0 = 1.
 * \param[out] spans [n].
 * \param[in] flags evaluation flags of one axis; NURBS_NAN gives span -1.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _COUNT, _TOO_FEW_POINTS, _SIZE, _KNOT_NOT_FINITE,
 *   _KNOTS_DECREASING, _END_MULTIPLICITY, _MULTIPLICITY, _EMPTY_DOMAIN, _OVERFLOW, _STRIDE, _OVERLAP, _FLAGS,
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_find_spans(int32_t degree, int64_t count, const double *knots,
                                        int64_t knot_count, int64_t n, const double *params,
                                        int64_t param_stride, int64_t *spans, uint32_t flags);

/** \brief Bernstein polynomials B_(j,p)(t) = binomial(p, j) t^j (1 - t)^(p - j), j = 0, ..., p, and their
 * derivatives. Any finite t is allowed; values are componentwise accurate on [0, 1].
 * \param[in] degree p.
 * \param[in] order highest derivative; those above the degree are 0.
 * \param[in] n number of parameters.
 * \param[in] params [n].
 * \param[in] param_stride distance between parameters, 0 = 1.
 * \param[out] values [n][order + 1][degree + 1]: derivative k of B_(j,p) is component k * (degree + 1) + j.
 * \param[in] value_stride,value_component_stride layout of values, 0 = packed.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _ORDER, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP,
 *   _PARAMETER_NOT_FINITE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_bernstein(int32_t degree, int32_t order, int64_t n, const double *params,
                                       int64_t param_stride, double *values, int64_t value_stride,
                                       int64_t value_component_stride);

/** \brief B-spline basis functions that do not vanish at each parameter, and their derivatives (Cox-de Boor
 * recurrence).
 * \param[in] degree,count degree and number of control points.
 * \param[in] knots [knot_count] a full knot vector.
 * \param[in] knot_count number of knots: count + degree + 1.
 * \param[in] order highest derivative; those above the degree are 0.
 * \param[in] n number of parameters.
 * \param[in] params [n].
 * \param[in] param_stride distance between parameters, 0 = 1.
 * \param[out] spans [n] or NULL: the span s of each parameter; NURBS_NAN gives span -1.
 * \param[out] values [n][order + 1][degree + 1]: derivative k of N_(s - degree + j) is component k * (degree
 *   + 1) + j.
 * \param[in] value_stride,value_component_stride layout of values, 0 = packed.
 * \param[in] flags evaluation flags of one axis.
 * \return as for nurbs_find_spans(), and NURBS_ERROR_ORDER.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_basis(int32_t degree, int64_t count, const double *knots, int64_t knot_count,
                                   int32_t order, int64_t n, const double *params, int64_t param_stride,
                                   int64_t *spans, double *values, int64_t value_stride,
                                   int64_t value_component_stride, uint32_t flags);

/** \brief Rational basis functions R_i(t) = w_i N_i(t) / w(t) of the active control points; N_i for a
 * polynomial spline. There are M = (degree_0 + 1) * ... active points per parameter, last axis fastest; on
 * axis k they start at spans[k] - degree_k.
 * \param[in] g a spline.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] spans [n][axes] or NULL: span on each axis, packed; NURBS_NAN gives span -1 on all of them.
 * \param[out] values [n][M].
 * \param[in] value_stride,value_component_stride layout of values, 0 = packed.
 * \param[in] flags evaluation flags per axis.
 * \return as for nurbs_hull_size().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_rational_basis(const nurbs *g, int64_t n, const double *params,
                                            int64_t param_stride, int64_t param_component_stride,
                                            int64_t *spans, double *values, int64_t value_stride,
                                            int64_t value_component_stride, uint32_t flags);

/** \brief Gradients in space of the rational basis functions of nurbs_rational_basis(): of R_i as a function of the
 * point, J (J^T J)^-1 dR_i/dt with J [dim][axes] the derivatives of the spline. Where there are as many axes as
 * coordinates this is J^-T dR_i/dt; on a curve or a surface in space the gradient runs along it. They sum to 0, and
 * the sum of P_i grad R_i^T is the identity (the projection onto the tangents), so that those of the coordinates
 * are unit vectors: with nurbs_quadrature(), what the element matrices of isogeometric analysis are made of.
 *
 * Errors are those of first derivatives of a spline near its origin, wherever it lies, times the condition of J.
 * \param[in] g a spline of no more axes than coordinates.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] spans [n][axes] or NULL: span on each axis, packed; NURBS_NAN gives span -1 on all of them.
 * \param[out] gradients [n][M][dim], M as of nurbs_rational_basis(). NaN where the derivatives of the spline are
 *   dependent to rounding, as at poles.
 * \param[in] gradient_stride,gradient_component_stride layout of gradients, 0 = packed.
 * \param[in] flags evaluation flags per axis.
 * \return as for nurbs_hull_size(), and NURBS_ERROR_DIMENSION if there are more axes than coordinates.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_basis_gradients(const nurbs *g, int64_t n, const double *params,
                                             int64_t param_stride, int64_t param_component_stride,
                                             int64_t *spans, double *gradients, int64_t gradient_stride,
                                             int64_t gradient_component_stride, uint32_t flags);
/** @} */

/** \defgroup eval Evaluation
 * \code
 * const double params[2][2] = {{0.1, 0.2}, {0.5, 0.5}};
 * double points[2][3];
 * nurbs_eval(surface, 2, params[0], 0, 0, points[0], 0, 0, 0);
 * \endcode
 * @{ */

/** \brief Points at parameters.
 * \param[in] g a spline.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] points [n][dim].
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] flags evaluation flags per axis.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _FLAGS, _PARAMETER_NOT_FINITE,
 *   _OUTSIDE_DOMAIN.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_eval(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                  int64_t param_component_stride, double *points, int64_t point_stride,
                                  int64_t point_component_stride, uint32_t flags);

/** \brief Number of derivative slots S = binomial(order + axes, axes), the partial derivatives of orders 0 to
 * `order`.
 * \param[in] axes 1, 2 or 3.
 * \param[in] order highest order.
 * \param[out] slots S.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _ORDER.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_derivative_slots(int32_t axes, int32_t order, int64_t *slots);

/** \brief Points and all partial derivatives up to an order, by the quotient rule when rational (Piegl &
 * Tiller A4.2, A4.4). Slots are in graded order. Curve: derivative k is slot k. Surface: d^(i+j)/du^i dv^j is
 * slot (i+j)(i+j+1)/2 + j. Volume: d^(i+j+k)/du^i dv^j dw^k is slot s(s+1)(s+2)/6 + r(r+1)/2 + k with s =
 * i+j+k, r = j+k.
 * \param[in] g a spline.
 * \param[in] order highest order; orders above the degree are not special.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] derivs [n][S][dim] with S = binomial(order + axes, axes): coordinate c of slot s is component s
 *   * dim + c.
 * \param[in] deriv_stride,deriv_component_stride layout of derivs, 0 = packed.
 * \param[in] flags evaluation flags per axis.
 * \return as for nurbs_eval(), and NURBS_ERROR_ORDER.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_eval_derivs(const nurbs *g, int32_t order, int64_t n, const double *params,
                                         int64_t param_stride, int64_t param_component_stride, double *derivs,
                                         int64_t deriv_stride, int64_t deriv_component_stride,
                                         uint32_t flags);

/** \brief Points on the grid of all combinations of one parameter from each axis. Where a count is 0 there
 * are no points, but the parameters of the other axes are checked.
 * \param[in] g a spline.
 * \param[in] counts [axes] number of parameters on each axis.
 * \param[in] params [sum of counts] the parameters of axis 0, then of axis 1, then of axis 2, in any order.
 * \param[out] points [counts[0]]...[counts[axes-1]][dim] one record per grid point, last axis fastest.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] flags evaluation flags per axis.
 * \return as for nurbs_eval(); the index in a message counts along params.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_eval_grid(const nurbs *g, const int64_t *counts, const double *params,
                                       double *points, int64_t point_stride, int64_t point_component_stride,
                                       uint32_t flags);

/** \brief Points and partial derivatives on a grid.
 * \param[in] g a spline.
 * \param[in] order highest order.
 * \param[in] counts [axes] number of parameters on each axis.
 * \param[in] params [sum of counts] as for nurbs_eval_grid().
 * \param[out] derivs [counts[0]]...[counts[axes-1]][S][dim] with S = binomial(order + axes, axes) slots
 *   as for nurbs_eval_derivs().
 * \param[in] deriv_stride,deriv_component_stride layout of derivs, 0 = packed.
 * \param[in] flags evaluation flags per axis.
 * \return as for nurbs_eval_derivs().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_eval_grid_derivs(const nurbs *g, int32_t order, const int64_t *counts,
                                              const double *params, double *derivs, int64_t deriv_stride,
                                              int64_t deriv_component_stride, uint32_t flags);

/** \brief Points at parameters in single precision: the results of nurbs_eval(), each rounded once to the
 * nearest float. Coordinates beyond the range of float become infinities.
 * \param[in] g a spline.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] points [n][dim].
 * \param[in] point_stride,point_component_stride layout of points in floats, 0 = packed.
 * \param[in] flags evaluation flags per axis.
 * \return as for nurbs_eval().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_eval_f32(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                                      int64_t param_component_stride, float *points, int64_t point_stride,
                                      int64_t point_component_stride, uint32_t flags);

/** \brief Points on a grid in single precision: the results of nurbs_eval_grid(), each rounded once to the
 * nearest float.
 * \param[in] g a spline.
 * \param[in] counts [axes] number of parameters on each axis.
 * \param[in] params [sum of counts] as for nurbs_eval_grid().
 * \param[out] points [counts[0]]...[counts[axes-1]][dim] one record per grid point, last axis fastest.
 * \param[in] point_stride,point_component_stride layout of points in floats, 0 = packed.
 * \param[in] flags evaluation flags per axis.
 * \return as for nurbs_eval_grid().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_eval_grid_f32(const nurbs *g, const int64_t *counts, const double *params,
                                           float *points, int64_t point_stride,
                                           int64_t point_component_stride, uint32_t flags);

/** \brief The iso-curve of a surface, or iso-surface of a volume, on which the parameter of one axis is
 * fixed. The other axes keep their order, degrees, knots and periodicity.
 * \param[in] g a surface or volume.
 * \param[in] axis the axis that is fixed.
 * \param[in] param its parameter.
 * \param[in] flags evaluation flags of that axis, in the lowest eight bits; NURBS_NAN is not allowed.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _AXIS, _FLAGS, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN;
 *   _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH or _WEIGHT_NEGATIVE if extrapolation leaves the
 *   positive weights, or weights underflow or are all 0 there.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_iso(const nurbs *g, int32_t axis, double param, uint32_t flags, nurbs **out);
/** @} */

/** \defgroup frames Frames and curvature
 * \code
 * const double params[] = {0.5, 0.5};
 * double point[3], normal[3];
 * nurbs_surface_eval_frames(surface, 1, params, 0, 0, point, 0, 0, NULL, 0, 0, NULL, 0, 0, normal, 0, 0,
 *                           NULL, 0);
 * \endcode
 * Points, directions and curvatures computed from derivatives, in one pass. Every output may be NULL, which
 * means not wanted; its strides are then ignored.
 *
 * `status` receives for each point a sum of the NURBS_FRAME_ bits, 0 where nothing is special.
 *
 * A vector counts as zero if its exact value may be zero: if its length is at most the bound of its rounding
 * error. For a derivative of order k that bound is 2 (c + 2 k) eps |E_a|, as in the preamble, but with sums
 * of |P - O| in the first step of a curve too, E_a being taken as a vector. For a product of two it is each
 * factor's length times the other's bound, summed. No other tolerance enters: if points or knots are
 * multiplied by powers of two, no bit of a direction changes, and curvatures are multiplied by a power of
 * two. That holds at every size (since 1.1), even if derivatives or their products leave double precision,
 * unless the result does. One parameter gives the same bits alone, in a batch and on a grid.
 *
 * Limits are taken from the side that the flags name (from above, or from below with NURBS_LEFT), at the ends
 * of the domain from within, outside it from the domain's side. They use derivatives of orders up to 8; a
 * limit that would need higher ones counts as not existing. If a result does not exist, NaN is written and
 * NURBS_FRAME_UNDEFINED is set, also for parameters that give NaN.
 * @{ */

/** \name Status of a point
 * @{ */
#define NURBS_FRAME_LIMIT 0x01        /**< tangent of a curve, normal of a surface: a one-sided limit */
#define NURBS_FRAME_NORMAL_LIMIT 0x02 /**< normal of a curve in space: a one-sided limit */
#define NURBS_FRAME_RULE 0x04         /**< nothing distinguishes a direction: the function's rule chose it */
#define NURBS_FRAME_UNDEFINED 0x08    /**< some result does not exist and is NaN */
/** @} */

/** \brief Points, first derivatives and unit normals of a surface in space.
 * The normal is S_u x S_v / |S_u x S_v|. Where S_u x S_v is zero (poles, collapsed edges, parallel
 * derivatives) it is the limit, if there is one: with S_u x S_v = sum N_ij s^i t^j, where s, t >= 0 run from
 * the point into the domain, the terms of the lowest order i + j that does not vanish must all have one
 * direction, which is the normal. The rounding error of a regular normal is at most about (|S_u| b_v + |S_v|
 * b_u) / |S_u x S_v|, where b_u and b_v bound the errors of the derivatives.
 * \param[in] g a surface of dimension 3.
 * \param[in] n number of parameters.
 * \param[in] params [n][2].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] points [n][3] or NULL.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[out] du [n][3] or NULL: derivative along axis 0.
 * \param[in] du_stride,du_component_stride layout of du, 0 = packed.
 * \param[out] dv [n][3] or NULL: derivative along axis 1.
 * \param[in] dv_stride,dv_component_stride layout of dv, 0 = packed.
 * \param[out] normals [n][3] or NULL: unit normals.
 * \param[in] normal_stride,normal_component_stride layout of normals, 0 = packed.
 * \param[out] status [n] or NULL: NURBS_FRAME_LIMIT or _UNDEFINED where the normal is not regular.
 * \param[in] flags evaluation flags per axis.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _FLAGS,
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_eval_frames(
    const nurbs *g, int64_t n, const double *params, int64_t param_stride, int64_t param_component_stride,
    double *points, int64_t point_stride, int64_t point_component_stride, double *du, int64_t du_stride,
    int64_t du_component_stride, double *dv, int64_t dv_stride, int64_t dv_component_stride, double *normals,
    int64_t normal_stride, int64_t normal_component_stride, int32_t *status, uint32_t flags);

/** \brief The same on the grid of all combinations of a parameter of each axis. The number of grid points is
 * M = counts[0] * counts[1]; one record for each, axis 1 fastest.
 * \param[in] g a surface of dimension 3.
 * \param[in] counts [2] number of parameters on each axis.
 * \param[in] params [sum of counts] as for nurbs_eval_grid().
 * \param[out] points [M][3] or NULL.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[out] du [M][3] or NULL: derivative along axis 0.
 * \param[in] du_stride,du_component_stride layout of du, 0 = packed.
 * \param[out] dv [M][3] or NULL: derivative along axis 1.
 * \param[in] dv_stride,dv_component_stride layout of dv, 0 = packed.
 * \param[out] normals [M][3] or NULL: unit normals.
 * \param[in] normal_stride,normal_component_stride layout of normals, 0 = packed.
 * \param[out] status [M] or NULL: as for nurbs_surface_eval_frames().
 * \param[in] flags evaluation flags per axis.
 * \return as for nurbs_surface_eval_frames(); the index in a message counts along params.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_eval_grid_frames(
    const nurbs *g, const int64_t *counts, const double *params, double *points, int64_t point_stride,
    int64_t point_component_stride, double *du, int64_t du_stride, int64_t du_component_stride, double *dv,
    int64_t dv_stride, int64_t dv_component_stride, double *normals, int64_t normal_stride,
    int64_t normal_component_stride, int32_t *status, uint32_t flags);

/** \brief Principal curvatures and directions of a surface in space, mean and Gaussian curvature.
 * Curvature is positive where the surface bends towards its normal N = S_u x S_v / |S_u x S_v|: a sphere
 * whose normal points outwards has k1 = k2 = -1/r. In an orthonormal basis e1 = S_u / |S_u|, e2 = N x e1 of
 * the tangent plane the shape operator is the symmetric matrix (w11, w12; w12, w22), and
 *
 *     k1, k2 = H +- D,   H = (w11 + w22) / 2,   D = hypot((w11 - w22) / 2, w12),   K = w11 w22 - w12^2.
 *
 * Errors are relative to max(|k1|, |k2|), also near umbilics. The first direction d1 belongs to k1 and has
 * d1 . S_u > 0 (if it is perpendicular to S_u, d1 . S_v > 0); the second is N x d1. Where D may be zero by
 * its rounding bound (umbilics, planes) the rule d1 = e1 is used and NURBS_FRAME_RULE set. Where S_u x S_v is
 * zero the results are undefined, also where a limit exists.
 * \param[in] g a surface of dimension 3.
 * \param[in] n number of parameters.
 * \param[in] params [n][2].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] principal [n][2] or NULL: k1 >= k2.
 * \param[in] principal_stride,principal_component_stride layout of principal, 0 = packed.
 * \param[out] directions [n][2][3] or NULL: unit vectors, coordinate c of direction j is component 3 j + c.
 * \param[in] direction_stride,direction_component_stride layout of directions, 0 = packed.
 * \param[out] mean [n] or NULL: H.
 * \param[in] mean_stride distance between values of mean, 0 = 1.
 * \param[out] gaussian [n] or NULL: K.
 * \param[in] gaussian_stride distance between values of gaussian, 0 = 1.
 * \param[out] status [n] or NULL: NURBS_FRAME_RULE or _UNDEFINED.
 * \param[in] flags evaluation flags per axis.
 * \return as for nurbs_surface_eval_frames().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_eval_curvatures(
    const nurbs *g, int64_t n, const double *params, int64_t param_stride, int64_t param_component_stride,
    double *principal, int64_t principal_stride, int64_t principal_component_stride, double *directions,
    int64_t direction_stride, int64_t direction_component_stride, double *mean, int64_t mean_stride,
    double *gaussian, int64_t gaussian_stride, int32_t *status, uint32_t flags);

/** \brief Frenet frames of a curve in the plane or in space.
 * In space: T = C' / |C'|, B = C' x C'' / |C' x C''|, N = B x T, curvature |C' x C''| / |C'|^3 >= 0, torsion
 * (C' x C'') . C''' / |C' x C''|^2. In the plane: N is T turned by +90 degrees, curvature (C'_x C''_y - C'_y
 * C''_x) / |C'|^3 has a sign.
 *
 * Where C' is zero T is the limit (the direction of the first derivative that is not, with the sign of the
 * side), and curvature and torsion are limits too, infinite at most cusps. In space, where C' x C'' is zero,
 * N is the limit: the part across T of the first derivative that is not parallel to it. On a straight line
 * there is none; then N is the coordinate axis i of the smallest |T_i| (the first of several), made
 * perpendicular to T, the torsion is 0, and NURBS_FRAME_RULE is set.
 * \param[in] g a curve of dimension 2 or 3.
 * \param[in] n number of parameters.
 * \param[in] params [n].
 * \param[in] param_stride distance between parameters, 0 = 1.
 * \param[out] points [n][dim] or NULL.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[out] tangents [n][dim] or NULL: T.
 * \param[in] tangent_stride,tangent_component_stride layout of tangents, 0 = packed.
 * \param[out] normals [n][dim] or NULL: N.
 * \param[in] normal_stride,normal_component_stride layout of normals, 0 = packed.
 * \param[out] binormals [n][3] or NULL, which it must be in the plane: B.
 * \param[in] binormal_stride,binormal_component_stride layout of binormals, 0 = packed.
 * \param[out] curvatures [n] or NULL.
 * \param[in] curvature_stride distance between curvatures, 0 = 1.
 * \param[out] torsions [n] or NULL, which it must be in the plane.
 * \param[in] torsion_stride distance between torsions, 0 = 1.
 * \param[out] status [n] or NULL: sum of NURBS_FRAME_ bits.
 * \param[in] flags evaluation flags of one axis.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _FLAGS,
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN; _DIMENSION if it is not 2 or 3, or is 2 and binormals or torsions
 *   are wanted.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_eval_frames(
    const nurbs *g, int64_t n, const double *params, int64_t param_stride, double *points,
    int64_t point_stride, int64_t point_component_stride, double *tangents, int64_t tangent_stride,
    int64_t tangent_component_stride, double *normals, int64_t normal_stride, int64_t normal_component_stride,
    double *binormals, int64_t binormal_stride, int64_t binormal_component_stride, double *curvatures,
    int64_t curvature_stride, double *torsions, int64_t torsion_stride, int32_t *status, uint32_t flags);

/** \brief Rotation-minimizing frames along a sequence of points of a curve in space, by double reflection
 * (Wang, Juttler, Zheng & Liu 2008): frames that turn about the tangent as little as possible.
 * From one point to the next the frame is reflected so that the first point goes to the second, then so that
 * its tangent goes to the tangent there. The frames at the given parameters differ from the exact ones by
 * O(h^4), h the largest distance of neighbouring parameters on a smooth curve. The result at a point depends
 * on those before it. Between two points that agree to within rounding the tangent is turned the shortest
 * way. On a closed curve the last frame is turned against the first one by atan2(N_last . B_first, N_last .
 * N_first).
 * \param[in] g a curve of dimension 3.
 * \param[in] n number of parameters.
 * \param[in] params [n] in the order of the sequence.
 * \param[in] param_stride distance between parameters, 0 = 1.
 * \param[in] first_normal [3] or NULL for the coordinate axis i of the smallest |T_i| (the first of several):
 *   direction that is made perpendicular to the first tangent and becomes the first normal.
 * \param[out] points [n][3] or NULL.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[out] tangents [n][3] or NULL: unit tangents T, to rounding those of nurbs_curve_eval_frames().
 * \param[in] tangent_stride,tangent_component_stride layout of tangents, 0 = packed.
 * \param[out] normals [n][3] or NULL: N.
 * \param[in] normal_stride,normal_component_stride layout of normals, 0 = packed.
 * \param[out] binormals [n][3] or NULL: B = T x N.
 * \param[in] binormal_stride,binormal_component_stride layout of binormals, 0 = packed.
 * \param[out] status [n] or NULL: NURBS_FRAME_LIMIT where the tangent is a limit; _UNDEFINED where there is
 *   none, and the sequence passes over this point.
 * \param[in] flags evaluation flags of one axis.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _FLAGS,
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN; _DIRECTION if first_normal is not finite, zero, or parallel to
 *   the first tangent to within 8 eps.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_rotation_minimizing_frames(
    const nurbs *g, int64_t n, const double *params, int64_t param_stride, const double *first_normal,
    double *points, int64_t point_stride, int64_t point_component_stride, double *tangents,
    int64_t tangent_stride, int64_t tangent_component_stride, double *normals, int64_t normal_stride,
    int64_t normal_component_stride, double *binormals, int64_t binormal_stride,
    int64_t binormal_component_stride, int32_t *status, uint32_t flags);
/** @} */

/** \defgroup refine Refinement
 * \code
 * nurbs *finer = NULL, *lower = NULL, *upper = NULL;
 * nurbs_insert_knot(curve, 0, 0.3, 1, &finer); // the same shape, one control point more
 * nurbs_split(curve, 0, 0.3, &lower, &upper);
 * nurbs_destroy(finer);
 * nurbs_destroy(lower);
 * nurbs_destroy(upper);
 * \endcode
 * Exact operations: the shape and its parameters stay, and the accuracy is that of inserting knots (see
 * above). Operations along an axis make each new layer of control points from at most degree + 1 old ones, by
 * factors in [0, 1], of homogeneous points when rational. Layers that no knot reaches keep their bits. Costs
 * grow linearly with the number of control points.
 * @{ */

/** \brief Inserts a knot without changing the shape (Boehm 1980).
 * On a periodic axis the copies of the knot one period away are inserted with it, and the end of the domain
 * is its start.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] knot the knot, inside the closed domain.
 * \param[in] times how often; 0 gives the same spline.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _TIMES, _OVERFLOW;
 *   _MULTIPLICITY if the knot would occur more than degree + 1 times; _PERIODIC_KNOTS if its copies on
 *   a periodic axis cannot be told from their neighbours; _NOT_REPRESENTABLE if a point or a knot of the
 *   next period overflows, _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_insert_knot(const nurbs *g, int32_t axis, double knot, int32_t times,
                                         nurbs **out);

/** \brief Inserts a list of knots at once without changing the shape. New control point j is the polar form
 * of the spline at the `degree` knots after new knot j, found by one step of de Boor's algorithm for each of
 * them that is not an old knot (Cohen, Lyche & Riesenfeld 1980; Lyche & Morken 1986). On a periodic axis the
 * copies one period away are inserted too, and the end of the domain is its start.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] count number of knots; 0 gives the same spline.
 * \param[in] knots [count] in any order, inside the closed domain; each entry is inserted once.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _COUNT, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _OVERFLOW;
 *   _MULTIPLICITY if a knot would occur more than degree + 1 times; _PERIODIC_KNOTS, _NOT_REPRESENTABLE,
 *   _WEIGHTS_VANISH as for nurbs_insert_knot().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_refine(const nurbs *g, int32_t axis, int64_t count, const double *knots,
                                    nurbs **out);

/** \brief Divides every non-empty span of the domain into equal parts by knots: a + (b - a) i / parts, 0 < i
 * < parts, in the span [a, b].
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] parts parts of each span, at least 1, which gives the same spline.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _COUNT, _OVERFLOW; _NOT_REPRESENTABLE if a span has too few
 *   doubles for its parts or a point overflows; _PERIODIC_KNOTS, _WEIGHTS_VANISH as for nurbs_insert_knot().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_refine_uniform(const nurbs *g, int32_t axis, int64_t parts, nurbs **out);

/** \brief The matrix A of nurbs_refine() along one axis, as compressed sparse rows (CSR): new layer i is
 * sum_j A[i][j] * old layer j, with homogeneous points when rational. It has one row for each of the m =
 * (count along the axis) + count new layers; entries are > 0, except for a 0 between two of them where
 * one underflows, at most degree + 1 in a row, those of a row add up to 1, each is within 3 n eps of itself,
 * n the number of entries of its row less one, and in rising columns. On a periodic axis rows and columns are
 * those of the stored layers.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] count number of knots.
 * \param[in] knots [count] as for nurbs_refine().
 * \param[in] cap length of values and columns: 0, or at least the number of entries.
 * \param[out] values [cap] or NULL: receives the entries.
 * \param[out] columns [cap] or NULL: receives their columns.
 * \param[out] row_pointers [m + 1] or NULL: receives where each row begins, and the number of entries.
 * \param[out] entries or NULL: number of entries.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _COUNT, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _OVERFLOW,
 *   _MULTIPLICITY, _OVERLAP, _PERIODIC_KNOTS, _NOT_REPRESENTABLE; _SIZE if cap is neither 0 nor enough.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_refinement_matrix(const nurbs *g, int32_t axis, int64_t count,
                                               const double *knots, int64_t cap, double *values,
                                               int64_t *columns, int64_t *row_pointers, int64_t *entries);

/** \brief Splits a spline at a parameter of an axis, for a single Bezier piece by de Casteljau's subdivision.
 * The parts keep their parameters; both are clamped at the new end, where they have the same control points
 * bit for bit unless the spline jumps there (multiplicity degree + 1), and neither is periodic along the
 * axis. The other ends stay as they are, clamped or not.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] param where, inside the open domain.
 * \param[out] lower the part below the parameter.
 * \param[out] upper the part above it.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _AXIS, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN;
 *   _EMPTY_DOMAIN if the parameter is an end of the domain; _NOT_REPRESENTABLE, _WEIGHTS_VANISH as for
 *   nurbs_insert_knot().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_split(const nurbs *g, int32_t axis, double param, nurbs **lower, nurbs **upper);

/** \brief The part of a curve, surface or volume over a box in the domain. It keeps its parameters, is
 * clamped at ends that are new, and left as it is at ends of the domain; an axis of which only a part is
 * taken is not periodic. To extract across the seam of a periodic axis move that first: nurbs_move_seam().
 * \param[in] g a spline.
 * \param[in] lower [axes] where the part begins on each axis.
 * \param[in] upper [axes] where it ends; more than lower on every axis.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN; _EMPTY_DOMAIN if lower is not
 *   less than upper; _NOT_REPRESENTABLE, _WEIGHTS_VANISH as for nurbs_insert_knot().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_extract(const nurbs *g, const double *lower, const double *upper, nurbs **out);

/** \brief Decomposes a spline into its polynomial (rational) pieces, as Bezier splines over their own
 * domains: each has degree + 1 layers along each axis. They come in the order of their parameters, last axis
 * fastest; the number along an axis is that of its non-empty spans, see nurbs_bezier_extraction(), and the
 * names are the indices along the axes, such as "2" or "2,0". Neighbours have common control points bit for
 * bit unless the spline jumps between them. nurbs_join() puts them together again.
 * \param[in] g a spline.
 * \param[out] out the new list.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW; _NOT_REPRESENTABLE, _WEIGHTS_VANISH as for
 *   nurbs_insert_knot().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_decompose(const nurbs *g, nurbs_list **out);

/** \brief The pieces of nurbs_decompose() as arrays, in one call: the same control points and weights, bit for
 * bit, in the same order, without a handle for each. M = (p_0 + 1)(p_1 + 1)... is the number of control points
 * of a piece, which over its domain, with x_k = (t_k - a_k) / (b_k - a_k) and the Bernstein polynomials B of
 * nurbs_bernstein(), is
 *
 *     g(t) = sum_ij.. w_ij.. P_ij.. B_(i,p_0)(x_0) B_(j,p_1)(x_1).. / sum_ij.. w_ij.. B_(i,p_0)(x_0)...
 *
 * The homogeneous control points are those of nurbs_to_homogeneous(g). Costs a sum of at most p + 1 terms for
 * each coordinate of each control point and axis.
 * \param[in] g a spline.
 * \param[in] cap length of the arrays in pieces; 0 asks for the numbers only.
 * \param[out] points [cap][M][dim] or NULL: receives the control points of each piece, as nurbs_points() of it
 *   returns them, last axis fastest, packed.
 * \param[out] weights [cap][M] or NULL: receives their weights; all 1 for a polynomial spline.
 * \param[out] domains [cap][axes][2] or NULL: receives a and b of each axis of each piece, packed.
 * \param[out] piece_counts [axes] or NULL: receives the number of pieces along each axis.
 * \param[out] count number of pieces.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _OVERLAP; _SIZE if cap is neither 0 nor enough;
 *   _NOT_REPRESENTABLE, _WEIGHTS_VANISH as for nurbs_insert_knot().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_bezier_pieces(const nurbs *g, int64_t cap, double *points, double *weights,
                                           double *domains, int64_t *piece_counts, int64_t *count);

/** \brief Splits a spline at all knots inside the domain of an axis where its order of continuity, degree -
 * multiplicity, is less than a given one: 0 at jumps, 1 also at kinks (where it is only continuous), `degree`
 * at every knot. The parts are those of nurbs_split(), in the order of their parameters, named "0", "1" and
 * so on. Without such a knot the list holds the spline itself.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] order the order of continuity that is to be kept, 0 to NURBS_MAX_ORDER.
 * \param[out] out the new list.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _ORDER; _NOT_REPRESENTABLE, _WEIGHTS_VANISH as for
 *   nurbs_insert_knot().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_split_at_knots(const nurbs *g, int32_t axis, int32_t order, nurbs_list **out);

/** \brief Clamps ends of an axis: knots are inserted until the end of the domain occurs degree + 1 times, and
 * what lies outside the domain is dropped. The domain stays. A periodic axis is opened: it becomes a plain
 * one, with flags 0 of the same knots and points.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] flags NURBS_FORM_CLAMPED_START, NURBS_FORM_CLAMPED_END, both or 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _FLAGS; _NOT_REPRESENTABLE, _WEIGHTS_VANISH as for
 *   nurbs_insert_knot().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_clamp_ends(const nurbs *g, int32_t axis, uint32_t flags, nurbs **out);

/** \brief Moves the seam of a periodic axis: the same shape, periodic again, over [param, param + period].
 * The seam becomes a knot if it is not one. Control points keep their bits where no knot went in; knots that
 * move by a period are rounded.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis, periodic.
 * \param[in] param the new seam, inside the closed domain; either end, which is the seam there is, gives the
 *   same spline.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _NOT_PERIODIC, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN;
 *   _PERIODIC_KNOTS if rounding would make distinct knots equal or equal ones distinct; _NOT_REPRESENTABLE,
 *   _WEIGHTS_VANISH as for nurbs_insert_knot().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_move_seam(const nurbs *g, int32_t axis, double param, nurbs **out);

/** \brief Joins splines end to end along an axis. Each part is moved in the parameter to begin where the one
 * before ends (not at all if it does already), clamped at the ends that are to be joined, and its weights are
 * multiplied by one factor that makes its first ones those that precede. The two end layers become one, that
 * of the earlier part, under a knot of multiplicity degree: of the later part nothing else moves, and it by
 * at most `gap`. With NURBS_KEEP_GAPS ends that do not meet so both stay, under a knot of multiplicity degree
 * + 1, and no weight changes there. At degree 0 this is always so, and nothing is measured. Lower degrees are
 * raised to the highest on each axis as by nurbs_elevate(), along the axis after clamping (since 1.1).
 * Dimensions, and along the other axes the knots after that and periodicity, have to be the same; the axis is
 * not periodic in the result. The parts of nurbs_split() and nurbs_decompose() join without a gap.
 * \param[in] count number of splines, at least 1.
 * \param[in] parts [count] the splines in their order.
 * \param[in] axis 0-based axis.
 * \param[in] tolerance largest distance of corresponding control points of two ends that meet, >= 0. The
 *   weights of a curve always agree after scaling; those of two edges or faces must to 4 eps.
 * \param[in] flags NURBS_KEEP_GAPS or 0.
 * \param[out] gap or NULL: largest distance of corresponding control points of two ends, but those of weight 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _AXIS, _TOLERANCE, _FLAGS; _INCOMPATIBLE if numbers
 *   of axes, dimensions or the other axes differ or weights do not agree; _GAP if two ends do not meet;
 *   _KNOTS_MERGE if knots that are moved would round to one; _PERIODIC_KNOTS as for nurbs_elevate();
 *   _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_join(int64_t count, const nurbs *const *parts, int32_t axis, double tolerance,
                                  uint32_t flags, double *gap, nurbs **out);

/** \brief Makes near-equal knots of an axis equal; control points stay. Knots fall into groups that become
 * one knot. With w = tolerance * (length of the domain), knots at most w away from an end of the domain, on
 * either side, become that end (the lower end first); any other group begins with the lowest knot that is in
 * none and holds all that are at most w above it, so that a chain of close knots is cut where it gets longer
 * than w. It takes the value that occurs most often in it, the lowest of several. On a periodic axis copies
 * move alike. Where more than degree + 1 knots become an end of a plain axis, the others go, and as many
 * control points: of a clamped end those next to it, so that it keeps its place, unless the degree is 0.
 *
 * The shape moves by at most `deviation`: with control points P_i, Q_i and weights v_i, w_i of both splines
 * over the union of their knots, the largest |P_i - Q_i| + |1 - w_i / v_i| r_i, r_i the distance from Q_i to
 * the farthest control point that is active together with it; and the rounding of these numbers, none where
 * control points are compared as they are. Where not all weights have one sign, or some are 0, it is what
 * nurbs_deviation() gives as at_most.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] tolerance w as a part of the domain's length, >= 0 and < 1; 0 moves nothing.
 * \param[out] deviation or NULL: proved bound of the distance of any point to where it was, 0 if no knot
 *   moved.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _TOLERANCE; _MULTIPLICITY if knots that become one, other than
 *   an end of a plain axis, would occur more than degree + 1 times; _PERIODIC_KNOTS if rounding keeps copies
 *   from repeating; _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if all weights at a knot are 0.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_snap_knots(const nurbs *g, int32_t axis, double tolerance, double *deviation,
                                        nurbs **out);

/** \brief Brings splines to one degree and one knot vector on every axis, without changing their shapes
 * unless a tolerance allows it, and all to weights if one of them is rational (and to homogeneous points if
 * one was built so). Along each axis: the degree is raised to the highest one; an axis that is periodic in
 * some of the splines only is opened; where knots outside the domain differ, that end is clamped in all; then
 * each spline gets the knots that others have, as often as any has them. An axis on which all agree already
 * is left alone.
 *
 * With a tolerance > 0 near-equal knots of the splines are first moved together as by nurbs_snap_knots(),
 * the knots of all splines taken as one list, so that they do not multiply; the value of a group is the one
 * that occurs most often in all. Splines of which no knot moves stay exact. A domain whose ends are at most
 * tolerance times the length of that of splines[0] away from its ends is mapped to it even without
 * NURBS_MAP_DOMAINS, and the deviation bounds how far points at a parameter move by that, too.
 * \param[in] count number of splines, at least 1.
 * \param[in] splines [count] with the same number of axes, of any dimensions.
 * \param[in] tolerance how far a group of knots may reach, as a part of the domain's length, >= 0 and < 1.
 * \param[in] flags NURBS_MAP_DOMAINS: domains other than that of splines[0] are mapped to it as by
 *   nurbs_reparametrize(); 0: they are refused, unless they are that close.
 * \param[out] deviation or NULL: largest of the splines' bounds, as for nurbs_snap_knots(): 0 if no knot was
 *   moved; on periodic axes, whose outer knots repeat to rounding only, also what that rounding moves.
 * \param[out] out the new list, the splines in their order, named "0", "1" and so on.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _TOLERANCE, _FLAGS; _INCOMPATIBLE if numbers of axes, or
 *   domains without NURBS_MAP_DOMAINS, differ; _MULTIPLICITY as for nurbs_snap_knots(), _KNOTS_MERGE as for
 *   nurbs_reparametrize(), _PERIODIC_KNOTS, _NOT_REPRESENTABLE, _WEIGHTS_VANISH, _OVERFLOW as for
 *   nurbs_refine().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_make_compatible(int64_t count, const nurbs *const *splines, double tolerance,
                                             uint32_t flags, double *deviation, nurbs_list **out);

/** \brief Extends a spline beyond an end of an axis by a length of the parameter. The new part is the Taylor
 * polynomial of an order k of the piece at that end, in homogeneous coordinates if rational: 0 stays where
 * the end is, 1 goes on linearly (C^1), 2 with constant second derivative (C^2), and from the degree on it is
 * the piece itself. The old end becomes a knot of multiplicity degree - k, and k control points that act on
 * the old domain too are moved and get larger, by up to G = (1 + 2 amount / (last span))^k, which they hand
 * on to the rounding of an evaluation there. Where G > 256 that knot has multiplicity degree instead and all
 * control points of g keep their bits. So the old domain stays as it is to 2^8 times the rounding of g,
 * however short its last span is. An end that is not clamped is clamped first. With the new end e and the old
 * one b, the new control points are the polar form of the piece at interior knots, b and e, and values of it
 * at b and e alone continued as a polynomial of degree k in their number.
 * Rounding: homogeneous points of the result are within 16 (degree + 1) eps G times the largest homogeneous
 * coordinate of g and of the result (tested), k at most the degree. At an end that is clamped, weights that
 * are all equal stay so bit for bit (since 1.1).
 * \param[in] g a spline.
 * \param[in] axis 0-based axis, not periodic.
 * \param[in] end NURBS_START or NURBS_END.
 * \param[in] amount by how much the domain grows, > 0.
 * \param[in] order k, 0 to NURBS_MAX_ORDER.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _END, _ORDER, _PERIODIC, _PARAMETER_NOT_FINITE; _EMPTY_DOMAIN if
 *   the domain would not grow; _WEIGHT_NEGATIVE, _WEIGHTS_VANISH if the weights do not stay positive (not
 *   where g was built homogeneous: nurbs_from_homogeneous() of the extended nurbs_to_homogeneous() of g is
 *   the homogeneous result of any g); _NOT_REPRESENTABLE if a value overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_extend(const nurbs *g, int32_t axis, int32_t end, double amount, int32_t order,
                                    nurbs **out);

/** \brief Unclamps ends of an axis: the end of the domain becomes a single knot, and the knots beyond it
 * repeat those of the domain with its length as the period, so that even spans go on evenly. Domain and shape
 * stay. The new control points are the polar form of the end piece at these knots, continued beyond the
 * domain: each homogeneous coordinate is within 4 (degree + 1) eps of the sum of |coefficient * coordinate|,
 * to which clamping the end again brings the shape back. Weights that are all equal stay so bit for bit
 * (since 1.1). Ends that are not clamped, and periodic axes, stay as they are.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] flags NURBS_FORM_CLAMPED_START, NURBS_FORM_CLAMPED_END, both or 0: the ends to be unclamped.
 *   With them NURBS_HOMOGENEOUS (since 1.1): the result of a rational g is as from
 *   nurbs_create_homogeneous(), of the records of nurbs_homogeneous_points(), so that its weights may have
 *   any sign.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _FLAGS; _WEIGHT_NEGATIVE, _WEIGHTS_VANISH if weights beyond the
 *   domain do not stay positive (not where g was built homogeneous, nor with NURBS_HOMOGENEOUS); _KNOTS_MERGE
 *   if knots that differ would be rounded to one beyond the domain; _NOT_REPRESENTABLE if a value overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_unclamp(const nurbs *g, int32_t axis, uint32_t flags, nurbs **out);

/** \brief Makes a closed spline periodic along an axis, over the same domain. The seam gets the highest order
 * of continuity k < degree, and k <= (count - 1) / 2, with which the shape moves by at most the tolerance,
 * under a knot of multiplicity degree - k; at degree 0 the result is always periodic, with order -1. Ends
 * that meet are not enough where weights differ: the homogeneous points have to. Control points whose knots
 * lie on one side of the seam stay bit for bit, those across it are continued from the end that has more of
 * their knots. An axis that repeats already, in knots and bit for bit in points, is only declared periodic.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] tolerance largest deviation allowed, a distance >= 0; the bound includes the rounding of control
 *   points that are moved: 0 is met where none is, such as of a circle that closes bit for bit.
 * \param[out] deviation or NULL: proved bound of the distance of any point to where it was, as for
 *   nurbs_snap_knots().
 * \param[out] order or NULL: the order of continuity that the knots give the seam.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _TOLERANCE; _GAP naming the deviation if the ends do not meet;
 *   _PERIODIC_KNOTS if rounding keeps the knots from repeating; _NOT_REPRESENTABLE if a value overflows,
 *   _WEIGHTS_VANISH if weights become 0. Orders that would take weights below 0 are passed over.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_make_periodic(const nurbs *g, int32_t axis, double tolerance, double *deviation,
                                           int32_t *order, nurbs **out);

/** \brief Whether an axis is periodic in fact: its knots repeat as NURBS_PERIODIC asks, and so do its points
 * and weights, bit for bit. nurbs_make_periodic() declares such an axis periodic without moving anything.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[out] periodic 1 or 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_detect_periodic(const nurbs *g, int32_t axis, int32_t *periodic);
/** @} */

/** \defgroup forms Degree and form
 * \code
 * nurbs *raised = NULL;
 * nurbs_elevate(surface, 0, 1, &raised); // one degree more along axis 0, the same shape
 * nurbs_destroy(raised);
 * \endcode
 * @{ */

/** \brief Raises the degree along an axis without changing the shape (Prautzsch 1984).
 * Degree p becomes p + times, and every knot occurs `times` more often, so that continuity stays what it was;
 * beyond the domain of an unclamped axis the knots that no function on the domain needs any more are left
 * out. The domain stays the same, a periodic axis stays periodic. Control point j of a step is the mean of
 * the old polar form over the p + 1 subsets of p of its p + 1 inner knots; all combinations are convex.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] times by how much; 0 gives the same spline.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _TIMES, _OVERFLOW; _DEGREE if the degree would exceed
 *   NURBS_MAX_DEGREE; _PERIODIC_KNOTS if the copies of knots on a periodic axis are not as often equal as the
 *   knots; _NOT_REPRESENTABLE if a point or a knot of the next period overflows, _WEIGHTS_VANISH if weights
 *   underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_elevate(const nurbs *g, int32_t axis, int32_t times, nurbs **out);

/** \brief Turns an axis round: the result at -t is g at t, exactly. The layers of control points come in the
 * opposite order, the knots too and with the opposite sign (0 becomes -0); reversing twice gives every bit
 * back. At a knot where g jumps each limit stays on its own side of the knot.
 * With NURBS_KEEP_DOMAIN the result at lower + upper - t is g at t: its knots are those of the negated domain
 * taken back to [lower, upper] as by nurbs_reparametrize(), which rounds the knots inside.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] flags 0 or NURBS_KEEP_DOMAIN.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _FLAGS; with NURBS_KEEP_DOMAIN also _KNOTS_MERGE and
 *   _NOT_REPRESENTABLE as for nurbs_reparametrize().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_reverse(const nurbs *g, int32_t axis, uint32_t flags, nurbs **out);

/** \brief Puts the axes in another order: axis k of the result is axis permutation[k] of g. Values are copied
 * bit for bit; {1, 0} exchanges the axes of a surface.
 * \param[in] g a spline.
 * \param[in] permutation [axes] each axis of g once.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL; _AXIS if an entry is not an axis of g or occurs twice.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_transpose(const nurbs *g, const int32_t *permutation, nurbs **out);

/** \brief Moves the domain [a, b] of an axis to [lower, upper] by the affine map
 * t -> lower + (t - a) (upper - lower) / (b - a). Control points and shape stay; derivatives change by powers
 * of the factor. The ends come out exactly, each knot inside the domain within 2 eps *
 * max(|lower|, |upper|, upper - lower). On a periodic axis the knots outside are made copies of those inside.
 * A map that would make two different knots equal is refused.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] lower,upper the new domain, lower < upper.
 * \param[out] out the new handle; with the domain that g has already, the same spline.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _PARAMETER_NOT_FINITE; _EMPTY_DOMAIN unless lower < upper;
 *   _KNOTS_MERGE naming the knots; _NOT_REPRESENTABLE if a knot, or their range, overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_reparametrize(const nurbs *g, int32_t axis, double lower, double upper,
                                           nurbs **out);

/** \brief The same spline with weights: a polynomial one gets weights of 1; any other is returned as it is.
 * \param[in] g a spline.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_make_rational(const nurbs *g, nurbs **out);

/** \brief The homogeneous points (w x, w y, ..., w) of a spline as the points of a polynomial spline of
 * dimension dim + 1; the weights of a polynomial g are 1. These are the points that
 * nurbs_homogeneous_points() returns.
 * \param[in] g a spline.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW; _DIMENSION if dim + 1 exceeds the limit.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_to_homogeneous(const nurbs *g, nurbs **out);

/** \brief The rational spline of dimension dim - 1 whose homogeneous points are the points of a polynomial
 * spline, as of nurbs_create_homogeneous(): the last coordinate becomes the weight. Values are copied bit for
 * bit.
 * \param[in] g a polynomial spline of dimension 2 or more.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL; _RATIONAL if g is rational, _DIMENSION if its dimension is 1,
 *   _WEIGHTS_VANISH if all weights in the support of a span are 0.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_from_homogeneous(const nurbs *g, nurbs **out);

/** \brief Divides all weights by the one of largest magnitude, which becomes 1; if all are equal they are
 * dropped, and the result is polynomial. Points stay bit for bit (homogeneous ones are divided as their
 * weights are), a weight is within eps / 2 of itself.
 * \param[in] g a spline.
 * \param[out] out the new handle; the same spline where there is nothing to do.
 * \return NURBS_OK, NURBS_ERROR_NULL; _NOT_REPRESENTABLE if a coordinate overflows, _WEIGHTS_VANISH if
 *   weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_normalize_weights(const nurbs *g, nurbs **out);

/** \brief Changes the parameter of an axis by a rational linear map of its domain [a, b] to itself, which
 * keeps the shape and changes the weights (Lee & Lucian 1991; Piegl & Tiller 6.4). With rho = ratio^(1/p), t
 * moves to
 *
 *     u = (a rho (b - t) + b (t - a)) / (rho (b - t) + (t - a)),
 *
 * and weight i is multiplied by the product of rho (b - a) / (rho (b - t_k) + t_k - a) over k = i + 1, ...,
 * i + p: the ratio w(b) / w(a) of the weights at the ends of the domain (of the last weight to the first
 * one, where the axis is clamped) is multiplied by `ratio`. Points stay bit for bit, a polynomial spline
 * becomes rational; a weight is within 4 p eps of itself for the knots given (beyond the domain, where the
 * two terms have opposite signs, times the ratio of their magnitudes to their sum), while the new knots are
 * rounded.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis, not periodic, of degree >= 1.
 * \param[in] ratio positive and finite; 1 gives the same spline.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS; _FACTOR if ratio is not positive and finite, _PERIODIC on a
 *   periodic axis, whose knots would not repeat, _DEGREE at degree 0, _KNOTS_MERGE if knots would become one
 *   or lie at or beyond the pole of the map (beyond the domain of an unclamped axis), _NOT_REPRESENTABLE if
 *   a value overflows, _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_reparametrize_moebius(const nurbs *g, int32_t axis, double ratio, nurbs **out);

/** \brief nurbs_reparametrize_moebius() with the ratio w(a) / w(b), so that the weights at both ends of the
 * domain of an axis are the same to (4 p + 8) eps. On surfaces and volumes the ratio must be the same, to 8
 * eps, for all control points across the ends.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis, not periodic.
 * \param[out] out the new handle; the same spline if the weights are equal already.
 * \return as for nurbs_reparametrize_moebius(), without _FACTOR; _END_WEIGHTS if no positive factor makes
 *   them equal.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_equalize_end_weights(const nurbs *g, int32_t axis, nurbs **out);
/** @} */

/** \defgroup calculus Calculus
 * \code
 * nurbs *hodograph = NULL;
 * nurbs_derivative(curve, 0, 1, &hodograph); // C'(t) as a spline
 * nurbs_destroy(hodograph);
 * \endcode
 * Derivatives, integrals, sums and products of splines are splines. Where bounds speak of control points they
 * mean their homogeneous components, before a division by the weight that adds eps / 2. The weights of
 * rational operands count up to one power of two for each (which keeps weights that are all beyond 2^256 or
 * below 2^-256 in range). If the knots of a periodic axis repeat only to rounding, that rounding moves
 * control points as well.
 * @{ */

/** \brief Values of the polar form (blossom) of a polynomial piece (Ramshaw 1989): the symmetric function of
 * p arguments, affine in each of them, that at p equal arguments is the spline. For several axes it takes
 * p_k arguments on axis k; for a rational spline it is that of the homogeneous records (w x, w y, ..., w),
 * whose last component divides the others. Control point i of an axis is its value at the knots t_(i+1),
 * ..., t_(i+p), bit for bit for those active on the piece. Each component is within 4 (p + 1) eps, summed
 * over the axes, of the largest magnitude of it among the active control points while the arguments lie in
 * the closed span. Elsewhere every coefficient alpha and 1 - alpha of de Boor's algorithm counts by its
 * magnitude.
 * \param[in] g a spline.
 * \param[in] params [axes] a parameter in the span of the piece on each axis.
 * \param[in] count number of arguments: the sum of the degrees.
 * \param[in] args [count] finite arguments, p_0 for axis 0, then p_1 for axis 1, and so on.
 * \param[out] values [dim + rational] dim values for a polynomial spline, dim + 1 for a rational one.
 * \param[in] flags evaluation flags for params other than NURBS_NAN: they choose the piece.
 * \return NURBS_OK, NURBS_ERROR_NULL, _SIZE, _FLAGS, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _OVERLAP.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_blossom(const nurbs *g, const double *params, int64_t count, const double *args,
                                     double *values, uint32_t flags);

/** \brief The partial derivative of a spline along an axis, as a spline (hodograph).
 *
 * Polynomial splines: of degree p - order, over the same knots but one at each end for each order; beyond
 * the degree zeros of degree 0 over the same breaks. A knot of multiplicity p + 1, where the spline may
 * jump, keeps one copy for each of the lower degrees + 1: what the jump itself contributes is left out. A
 * periodic axis stays periodic. Each new control point p (P_(i+1) - P_i) / (t_(i+p+1) - t_(i+1)) is within 2
 * eps of itself; order k within 2 k eps of H_k, the same differences with sums of magnitudes (see Accuracy).
 *
 * Rational splines (A, w): N_n / w^(n+1), n = order, by N_0 = A, N_(n+1) = N_n' w - (n + 1) N_n w' (Piegl &
 * Tiller 4.3), of degree (n + 1) p on every axis; its weights are the control points of w^(n+1). A jump
 * keeps its multiplicity of degree + 1. Weights of 0 can bring about control points at infinity; the result
 * then holds homogeneous points. At degree 0 on the axis it is zeros without weights. Control points of N_1
 * and w^2 are within 8 eps (tested), for each order, of p (max |A| max |w|) times 4 over the shortest
 * non-empty t_(i+p) - t_i, and of max |w|^2; step j of a higher order multiplies by 4 j p max |w| over the
 * shortest t_(i+p+1-j) - t_i. The points of A are those of w (P - O), O as in the preamble.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] order 0 to NURBS_MAX_ORDER; 0 gives the same spline.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _ORDER; _DEGREE if (order + 1) p exceeds NURBS_MAX_DEGREE on an
 *   axis of a rational spline; _PERIODIC_KNOTS if the copies of knots on a periodic axis are not as often
 *   equal as the knots; _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if weights underflow,
 *   _OVERFLOW.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_derivative(const nurbs *g, int32_t axis, int32_t order, nurbs **out);

/** \brief The derivative of a spline with respect to a knot, as a spline of the same parameters: C changes by
 * h times the result, to first order, if knot t_k of an axis is moved by h and everything else stays.
 *
 * Polynomial splines (Jupp 1978): of the same degree p, over the knots with t_k once more, with the control
 * points
 *
 *     e_i = -(P_i - P_(i-1)) / (t_(i+p) - t_i),   i = k - p, ..., k,   0 < i < count,
 *
 * and 0 elsewhere, each within 2 eps of itself. What has no influence on the domain is left out: the first
 * layer with the first knot if k <= p, the last layer with the last knot if k >= count. Where t_k occurs p + 1
 * times already, it stays so, and the layer between the two pieces is left out. Rational splines (A, w): (A_k
 * w - A w_k) / w^2 with those derivatives A_k and w_k, of degree 2 p on every axis; its weights are the
 * control points of w^2. At degree 0 on the axis it is zeros, as only the places of jumps move. With D the
 * largest distance of a control point from O (see the preamble) and h the shortest non-empty t_(i+p) - t_i of
 * the axis the result at t is within 8 (c + 16) eps D / h of the derivative, times the square of the largest
 * weight over w(t) (tested).
 *
 * t_k is one knot: where several are equal, the result for the first of them is the derivative for a move
 * down, for the last of them for a move up, and the sum over all of them the derivative of moving them
 * together. The first and the last knot of an axis have no influence. Knots at an end of the domain move the
 * domain with them; the result is what that does to the polynomial pieces at fixed parameters. At the knot
 * itself C has a derivative from either side, and so has the result (NURBS_LEFT). On a periodic axis t_k moves
 * with its copies in all periods; the period stays, and the axis stays periodic. Copies of knots are rounded,
 * which counts as a move of them.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] knot 0-based index of the knot in the full knot vector of the axis.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS; _INDEX if there is no such knot, _DEGREE if 2 p exceeds
 *   NURBS_MAX_DEGREE on an axis of a rational spline; _PERIODIC_KNOTS if the copies of knots on a periodic
 *   axis are not as often equal as the knots; _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if
 *   weights underflow, _OVERFLOW.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_eval_knot_derivative(const nurbs *g, int32_t axis, int64_t knot, nurbs **out);

/** \brief The integral of a polynomial spline along an axis from the lower end a of its domain,
 *
 *     out(t) = integral of g from a to t,
 *
 * of degree p + 1 over the same knots with the first and the last one once more. It is 0 at a (at a clamped
 * start exactly); a periodic axis becomes plain, as an integral over a period need not be 0. With S_i = P_i
 * (t_(i+p+1) - t_i) / (p + 1) its control points are sums of consecutive S_i (de Boor 1978, X), compensated:
 * point j is within 2 eps of the sum of |S_i|, i < j, and if the start is not clamped within 6 (p + 2) eps
 * of those active there or before it more, whatever the number of control points up to 10^7.
 * \param[in] g a polynomial spline.
 * \param[in] axis 0-based axis.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _OVERFLOW; _RATIONAL if g is rational, _DEGREE if p + 1 exceeds
 *   NURBS_MAX_DEGREE, _NOT_REPRESENTABLE if a value overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_antiderivative(const nurbs *g, int32_t axis, nurbs **out);

/** \brief The pointwise product of two splines over the same domain on every axis: component by component,
 * where one of them may have dimension 1 and multiplies all components of the other; or the dot or cross
 * product. Degrees are added on every axis, weights are multiplied; the product of points of weight 0 stands
 * at the origin. A knot that occurs m times in a and n times in b occurs max(q + m, p + n) times (terms of a
 * spline without the knot left out), which is what the continuity asks for, p and q the degrees; an axis is
 * periodic if it is so in both. Control point j is the mean of f[t_I] g[t_J] over all divisions of its p + q
 * knots in p and q, f and g the polar forms (Ramshaw 1989; Morken 1991): all combinations are convex. Each
 * product of two components is within 2 eps for each axis (tested; 4 (p + q + 1) eps is proved) of the
 * largest magnitudes of these components, multiplied; a dot or cross product of n terms within n eps more.
 * \param[in] a,b splines with as many axes and the same domains, bit for bit.
 * \param[in] flags NURBS_PRODUCT_DOT (result of dimension 1) or NURBS_PRODUCT_CROSS (of dimension 3), or 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _FLAGS; _INCOMPATIBLE if axes or domains differ, _DIMENSION if the
 *   dimensions do not suit, _DEGREE if degrees add up to more than NURBS_MAX_DEGREE, _PERIODIC_KNOTS if the
 *   copies of knots on a periodic axis cannot be told apart, _NOT_REPRESENTABLE if a value overflows,
 *   _WEIGHTS_VANISH if weights underflow, _OVERFLOW.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_product(const nurbs *a, const nurbs *b, uint32_t flags, nurbs **out);

/** \brief nurbs_product() with progress reports, cancellation and a limit of work.
 * \param[in] a,b,flags as for nurbs_product().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_product(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_product_with(const nurbs *a, const nurbs *b, uint32_t flags,
                                          const nurbs_call_options *call, nurbs **out);

/** \brief The curve g(f(t)): a curve g over another parameter, or the curve in space that a curve f in the
 * parameter space of a surface or volume g traces on it. Its degree d is q (p_0 + p_1 + ...), q that of f and
 * p_k those of g, and its domain that of f. Knots of f of multiplicity m occur d - q + m times, those at
 * which f crosses one of g d - p_k + m times. It is clamped, even where f is periodic. Where f touches a knot
 * of g the side counts from which it does, where it runs along one the side above. Weights of the result can
 * be 0 or negative though no weight of g is; it then holds homogeneous points.
 *
 * For a curve g, f has to be strictly monotone, which is decided by the signs of the Bernstein coefficients
 * of f'; jumps of f have to lead the same way. All values of f must lie in the domain of g, except on
 * periodic axes of g: there f may run over up to 65536 periods, of which none is more than 2^52 periods from
 * the domain. Both are decided to within the uncertainty
 *
 *     u = 4 (q + 1) eps max |F| + eps max |t| max |f'|
 *
 * of the values of f on a span: F are its active control points, f' counts by its control points. Where f
 * differs by at most u from a knot of g that it crosses it counts as that knot; between two spans of f the
 * smaller u decides, and of u only the first term where the value is a control point of f. So knots of g that
 * are at most u apart can come to one parameter; m above is then the sum of their multiplicities, d + 1 knots
 * at most, and the result leaves out the spans between them: on either side it is g next to them, only
 * whose derivatives count below, and whatever g does between them becomes a jump.
 *
 * A control point is the mean of values of the polar form of g at values of that of f (DeRose, Goldman, Hagen
 * & Mann 1993). Parameters at which f crosses knots of g are rounded; the pieces on both sides share that
 * parameter, and there f counts as the knot itself. So what f adds to the error is what moving its values by
 * u does: control points move by u_0 D_0 + u_1 D_1 + ..., D_k the largest control points of the derivatives
 * of g. Beyond that every component is within 2 eps for each axis (tested; ((q + 6) p_k + 3) eps is proved)
 * of its largest magnitude among the active control points of g. Both bounds hold if polar values of f on
 * each piece stay between those knots of g around them, as on short pieces of f; else every coefficient of de
 * Boor's algorithm counts by its magnitude. Cost: for each polynomial piece of the result the product over
 * the axes of binomial(p_k + q, q) polar values of g, and a copy of the knots of each period that f runs
 * over.
 *
 * f may be rational with positive weights w_i (since 1.1), such as a circle in the domain of a surface. The
 * result then has weights: a polar value of g counts with the product of the weights of its p_0 + p_1 + ...
 * arguments, divided by the power of two in the largest w_i for each of them. In u the first term is 8 (q +
 * 2) eps max |F|, and f' counts by q (w_i + w_(i+1)) / min w times max F - min F over t_(i+q+1) - t_(i+1),
 * all of the span; weights by which the second term exceeds that of equal weights by (max F - min F) / 4, as
 * ratios beyond some 10^14 / q are, are refused. A component of the homogeneous points may be off by (4 q +
 * 6) eps more for each argument; all these bounds are in parts of the product of weights that the point is
 * multiplied by, at a parameter w(t) to the power p_0 + p_1 + ..., and for a point that belongs to several
 * spans of f in parts of the largest on the span of them that it is computed on, the longest.
 * \param[in] g a spline, rational or not.
 * \param[in] f a curve whose dimension is the number of axes of g: polynomial, or with positive weights.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL; _AXES if f is no curve, _RATIONAL if a weight of f is not positive,
 *   _DIMENSION if its dimension does not suit, _DEGREE if the new degree exceeds NURBS_MAX_DEGREE,
 *   _NOT_MONOTONE, _OUTSIDE_DOMAIN if f leaves the domain of g or runs over too many periods, _PERIODIC_KNOTS
 *   if copies of knots of g cannot be told apart, _NOT_REPRESENTABLE if a value or u overflows or u is too
 *   large, _WEIGHTS_VANISH if weights underflow, _OVERFLOW.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_compose(const nurbs *g, const nurbs *f, nurbs **out);

/** \brief nurbs_compose() with progress reports, cancellation and a limit of work.
 * \param[in] g,f as for nurbs_compose().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_compose(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_compose_with(const nurbs *g, const nurbs *f, const nurbs_call_options *call,
                                          nurbs **out);

/** \brief The linear combination alpha a(t) + beta b(t) of two splines over the same domain on every axis.
 * If neither is rational, both are written over common knots, with the higher degree on each axis and every
 * knot as often as the continuity asks for. The same holds for two rational splines whose weights are then
 * equal bit for bit. Any others are added over the product of the denominators, where degrees add up as in
 * nurbs_product(). An axis is periodic if it is so in both. Control points are within 2 eps for each axis
 * (tested; 5 (r + 1) eps, r the new degree, is proved) of max |alpha a| + max |beta b|, over a product
 * (alpha A w_b + beta B w_a) of max |alpha A| max |w_b| + max |beta B| max |w_a|.
 * \param[in] a,b splines of the same dimension with as many axes and the same domains, bit for bit.
 * \param[in] alpha,beta finite factors.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL; _FACTOR if alpha or beta is not finite, _INCOMPATIBLE if axes or
 *   domains differ, _DIMENSION if dimensions do, _DEGREE if degrees add up to more than NURBS_MAX_DEGREE,
 *   _PERIODIC_KNOTS as for nurbs_product(), _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if
 *   weights underflow, _OVERFLOW.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_sum(const nurbs *a, double alpha, const nurbs *b, double beta, nurbs **out);

/** \brief The C^1 piecewise cubic curve through points with given derivatives, as a spline with double knots:
 * its control points are the Bezier points P_i - h_(i-1) T_i / 3 and P_i + h_i T_i / 3 next to each point,
 * and the two ends, each within 2 eps of the sum of its terms. nurbs_eval_derivs() at the parameters gives
 * the data back.
 * \param[in] n number of points, at least 2.
 * \param[in] params [n] strictly increasing.
 * \param[in] dim dimension of the points.
 * \param[in] points [n][dim] P_i.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] tangents [n][dim] T_i, derivatives with respect to the parameter.
 * \param[in] tangent_stride,tangent_component_stride layout of tangents, 0 = packed.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _DIMENSION, _STRIDE, _OVERFLOW, _PARAMETER_NOT_FINITE,
 *   _KNOT_NOT_FINITE; _POINT_NOT_FINITE for a point or derivative, _NOT_REPRESENTABLE if a control point
 *   overflows, _KNOTS_DECREASING for parameters that do not increase.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_create_hermite(int64_t n, const double *params, int32_t dim,
                                            const double *points, int64_t point_stride,
                                            int64_t point_component_stride, const double *tangents,
                                            int64_t tangent_stride, int64_t tangent_component_stride,
                                            nurbs **out);

/** \brief The points and derivatives of a C^1 piecewise cubic at the ends of its non-empty spans, from which
 * nurbs_create_hermite() makes the same curve: clamped, with double knots. A curve of degree p < 3 has them
 * too. The knots alone decide whether it is C^1: none inside the domain may occur more than p - 1 times
 * (nurbs_simplify() takes superfluous ones away). Points are those of nurbs_decompose(), within 2 eps of the
 * largest magnitude M of a control point that is active next to them, ends of a clamped curve exactly;
 * tangents are within 14 p eps M / h of the derivative, h the longer one of the two spans next to the point
 * (both tested).
 * \param[in] g a polynomial curve of degree 0 to 3.
 * \param[in] cap length of the arrays in points; 0 asks for the number only.
 * \param[out] params [cap] or NULL: receives the distinct knots of the domain, rising.
 * \param[out] points [cap][dim] or NULL: receives the points, packed.
 * \param[out] tangents [cap][dim] or NULL: receives the derivatives with respect to the parameter, packed.
 * \param[out] count or NULL: number of points, one more than there are non-empty spans.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERFLOW, _OVERLAP; _SIZE if cap is neither 0 nor
 *   enough, _RATIONAL if g is rational, _DEGREE above 3, _CONTINUITY naming a knot at which g may have a
 *   kink, _NOT_REPRESENTABLE if a tangent overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_to_hermite(const nurbs *g, int64_t cap, double *params, double *points,
                                        double *tangents, int64_t *count);

/** \brief The power basis of every polynomial piece of a spline: on the piece over the span [a, b] of each
 * axis
 *
 *     g(t) = sum_k c_k (t_0 - a_0)^k_0 (t_1 - a_1)^k_1 ...,   0 <= k_i <= p_i,
 *
 * of the homogeneous points (w x, w y, ..., w) if g is rational. They are made from the Bezier points by
 * forward differences on every axis, c_k = binomial(p, k) Delta^k b_0 / h^k with h = b - a, and are within
 *
 *     (sum_i (2 + 2 k_i)) eps M prod_i 2^k_i binomial(p_i, k_i) / h_i^k_i
 *
 * (tested; 4 p_i + 3 instead of 2 is proved) of their exact values, M the largest magnitude of that
 * component in a control point that is active on the piece, and unless they underflow. The power basis is ill
 * conditioned at the far end of a span; the Bezier pieces of nurbs_decompose() are not.
 * \param[in] g a spline, of width W = dim, or dim + 1 if it is rational.
 * \param[in] cap length of coefficients in values: 0 asks for the numbers only, or at least count.
 * \param[out] coefficients [pieces][p_0 + 1]...[W] or NULL: c_k; pieces, the product of piece_counts, stand
 *   in the order of nurbs_decompose(), last axis fastest in pieces and powers. Written, as breaks, if cap is
 *   not 0.
 * \param[out] breaks [sum of (piece_counts[k] + 1)] or NULL: the distinct knots of the domain of every axis,
 *   one axis after the other.
 * \param[out] piece_counts [axes] or NULL: receives the number of pieces along each axis.
 * \param[out] count or NULL: number of values of all coefficients.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _OVERLAP; _SIZE if cap is neither 0 nor enough,
 *   _NOT_REPRESENTABLE if a value overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_to_power(const nurbs *g, int64_t cap, double *coefficients, double *breaks,
                                      int64_t *piece_counts, int64_t *count);

/** \brief A spline from the power basis of its pieces, as nurbs_to_power() gives it. All breaks are knots of
 * multiplicity degree + 1, so that the pieces need not meet, and the Bezier points of every piece are its
 * control points: on one axis b_i = sum_k binomial(i, k) / binomial(p, k) c_k h^k, each within (3 p + 1) / 2
 * eps of the sum of the magnitudes of its terms, on several the sum of that over them. nurbs_simplify()
 * and nurbs_reduce_knots() remove the knots that are not needed where pieces meet smoothly.
 * \param[in] axes 1 to 3.
 * \param[in] degrees [axes] degrees.
 * \param[in] piece_counts [axes] number of pieces along each axis, at least 1.
 * \param[in] breaks [break_count] the ends of the pieces along each axis, piece_counts[k] + 1 strictly
 *   increasing ones, one axis after the other.
 * \param[in] break_count length of breaks: the sum of (piece_counts[k] + 1).
 * \param[in] dim dimension of the points.
 * \param[in] coefficients [pieces][p_0 + 1]...[W] as for nurbs_to_power(); pieces is the product of
 *   piece_counts, and W = dim, or dim + 1 with NURBS_HOMOGENEOUS.
 * \param[in] coefficient_stride,coefficient_component_stride layout of the records of W values, 0 = packed.
 * \param[in] flags NURBS_HOMOGENEOUS: the coefficients are those of (w x, w y, ..., w), and the spline is
 *   rational as from nurbs_create_homogeneous(); or 0: polynomial.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DEGREE, _COUNT, _OVERFLOW, _SIZE, _DIMENSION, _STRIDE, _FLAGS,
 *   _KNOT_NOT_FINITE, _POINT_NOT_FINITE, _WEIGHT_NOT_FINITE, _WEIGHTS_VANISH; _KNOTS_DECREASING for breaks
 *   that do not increase, _NOT_REPRESENTABLE if a control point overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_create_power(int32_t axes, const int32_t *degrees, const int64_t *piece_counts,
                                          const double *breaks, int64_t break_count, int32_t dim,
                                          const double *coefficients, int64_t coefficient_stride,
                                          int64_t coefficient_component_stride, uint32_t flags, nurbs **out);

/** \brief The matrix that takes the coefficients of a polynomial over [0, 1] in one basis to those in
 * another: coefficient i of `to` is sum_j M_ij * coefficient j of `from`. Every entry is a quotient of two
 * integers, rounded once.
 * \param[in] from,to NURBS_BASIS_POWER, NURBS_BASIS_BERNSTEIN, NURBS_BASIS_HERMITE or NURBS_BASIS_BSPLINE.
 * \param[in] degree 0 to 21, odd if a basis is Hermite.
 * \param[in] size (degree + 1)^2.
 * \param[out] matrix [size] M, row by row.
 * \return NURBS_OK, NURBS_ERROR_NULL, _BASIS, _DEGREE, _SIZE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_basis_matrix(int32_t from, int32_t to, int32_t degree, int64_t size,
                                          double *matrix);
/** @} */

/** \defgroup fit Interpolation
 * \code
 * const int32_t degree = 3;
 * const int64_t count = 5;
 * const double points[5][2] = {{0, 0}, {1, 2}, {3, 3}, {5, 1}, {6, 0}};
 * double params[5], residual;
 * nurbs *through = NULL;
 * nurbs_parametrize(1, &count, 2, points[0], 0, 0, NURBS_PARAMS_CENTRIPETAL, 0, 0, params);
 * nurbs_interpolate(1, &degree, &count, params, 2, points[0], 0, 0, NULL, 0, &residual, &through);
 * nurbs_destroy(through);
 * \endcode
 * Splines through given points, on a grid along each of its axes in turn (C. de Boor, "Efficient computer
 * manipulation of tensor products", ACM Trans. Math. Softw. 5 (1979)), in time proportional to the number of
 * points. All coordinates are treated alike, in any dimension. What remains to be chosen are the parameters
 * and the knots.
 * @{ */

/** \brief Parameters of points from the distances between them.
 *
 * Along each axis the parameters run from 0 to 1, with steps in proportion to lengths d_i that the rule
 * derives from the chords c_i = |P_(i+1) - P_i|: 1, c_i, sqrt(c_i), c_i^exponent, or for
 * NURBS_PARAMS_FOLEY_NIELSON
 *
 *     d_i = c_i (1 + 3/2 a_i c_(i-1) / (c_(i-1) + c_i) + 3/2 a_(i+1) c_(i+1) / (c_i + c_(i+1)))
 *
 * where a_i is the angle by which the polygon turns at P_i, but at most a right angle (Foley & Nielson 1989,
 * with Euclidean chords). On a grid, the parameters of an axis are the means of those of its lines; lines of
 * length 0 do not count. Repeated points have equal parameters, which nurbs_interpolate() refuses. If a curve
 * is known already, nurbs_curve_lengths() gives the lengths along it as parameters. Moving, rotating,
 * mirroring or scaling the points changes the parameters only by rounding, and scaling by a power of two does
 * not change them at all.
 * \param[in] axes 1 to 3.
 * \param[in] counts [axes] number of points along each axis, >= 1.
 * \param[in] dim dimension of the points.
 * \param[in] points [counts[0]]...[counts[axes-1]][dim].
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] rule a NURBS_PARAMS_ constant.
 * \param[in] exponent for NURBS_PARAMS_POWER, from 0 to 8; other rules do not read it.
 * \param[in] flags NURBS_PERIODIC for axes along which the last point is the first one again, so that
 *   NURBS_PARAMS_FOLEY_NIELSON sees the angle there.
 * \param[out] params [sum of counts] those of axis 0, then those of axes 1 and 2.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _DIMENSION, _STRIDE, _OVERFLOW, _OVERLAP, _FLAGS,
 *   _POINT_NOT_FINITE; _RULE for another rule, _FACTOR for an exponent that is not allowed, _LENGTH if no
 *   line of an axis has a length.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_parametrize(int32_t axes, const int64_t *counts, int32_t dim,
                                         const double *points, int64_t point_stride,
                                         int64_t point_component_stride, int32_t rule, double exponent,
                                         uint32_t flags, double *params);

/** \brief Parameters that do not depend on the points: where the basis functions are largest.
 *
 * The basis functions are those over the knots of nurbs_knots_open_uniform() from 0 to 1. If
 * nurbs_interpolate_over_knots() uses these knots and parameters, any affine map of the points maps the curve
 * in the same way (Lim 1999).
 * \param[in] degree of the curve.
 * \param[in] count number of points, > degree, at least 2.
 * \param[out] params [count] from 0 to 1; symmetric: params[count - 1 - i] is 1 - params[i], i < count / 2.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _COUNT, _TOO_FEW_POINTS, _OVERFLOW; _NOT_REPRESENTABLE if
 *   there are not so many doubles.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_params_universal(int32_t degree, int64_t count, double *params);

/** \brief The spline of given degrees through points on a grid of parameters.
 *
 * Knots lie at the parameters, or for even degrees in the middle between two of them, with degree + 1 at each
 * end. At an end that is NURBS_ENDS_NOT_A_KNOT, the first degree / 2 of these inner knots are left out. At
 * one that is NURBS_ENDS_NATURAL, none is left out, and the derivatives of orders (degree + 1) / 2 to
 * degree - 1 vanish, as for the interpolating spline of least energy. NURBS_ENDS_FREE at both ends uses
 * averaged knots. A periodic axis has a knot for each parameter but the last, and no ends.
 *
 * A data point at a clamped end is the control point there, bit for bit. Every polynomial spline over these
 * knots with these ends is reproduced up to rounding. At the parameter of a point, the distance of the spline
 * from the point is at most 4 eps times the largest magnitude of a control point (tested).
 * \param[in] axes 1 to 3.
 * \param[in] degrees [axes].
 * \param[in] counts [axes] number of points along each axis: at least 2, and at least degree + 1 unless ends
 *   are natural; on a periodic axis at least 2.
 * \param[in] params [sum of counts] strictly increasing along each axis: those of axis 0, then the others.
 * \param[in] dim dimension of the points.
 * \param[in] points [counts[0]]...[counts[axes-1]][dim]; on a periodic axis the last layer repeats the first
 *   one bit for bit, and its parameter ends the period.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] ends [axes][2] or NULL for NURBS_ENDS_NOT_A_KNOT: NURBS_ENDS_ constants for the start and the
 *   end of each axis, 0 on periodic ones.
 * \param[in] flags NURBS_PERIODIC for axes that are to be periodic.
 * \param[out] residual or NULL: the largest distance of a point from the spline as evaluated at its
 *   parameter.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DEGREE, _COUNT, _DIMENSION, _STRIDE, _OVERFLOW, _FLAGS,
 *   _POINT_NOT_FINITE, _PARAMETER_NOT_FINITE; _TOO_FEW_POINTS, _KNOTS_DECREASING for parameters that do not
 *   increase, naming both, _PERIODIC_POINTS if the last layer of a periodic axis differs from the first,
 *   _RULE for other ends or ends that do not go together, _DEGREE also for natural ends of an even degree,
 *   _PERIODIC_KNOTS, _NOT_REPRESENTABLE if parameters are too near each other or a control point overflows;
 *   _SCHOENBERG_WHITNEY or _RANK where rounding makes the conditions dependent.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_interpolate(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                         const double *params, int32_t dim, const double *points,
                                         int64_t point_stride, int64_t point_component_stride,
                                         const int32_t *ends, uint32_t flags, double *residual, nurbs **out);

/** \brief The spline over given knots through points on a grid of parameters.
 *
 * It has as many control points as there are data. It exists and is unique if parameter i of each axis lies
 * in the support of its control point i, between knots i and i + degree + 1 (Schoenberg & Whitney 1953).
 * \param[in] axes 1 to 3.
 * \param[in] degrees [axes].
 * \param[in] counts [axes] number of points along each axis. An axis has as many control points; a periodic
 *   axis has `degree` more, the last of which repeat the first ones.
 * \param[in] params [sum of counts] in the domain, strictly increasing along each axis.
 * \param[in] knots [knot_count] full knot vectors of all axes, one after the other.
 * \param[in] knot_count sum of (number of control points + degree + 1).
 * \param[in] dim dimension of the points.
 * \param[in] points [counts[0]]...[counts[axes-1]][dim]; on a periodic axis without a last layer that repeats
 *   the first.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] flags NURBS_PERIODIC for periodic axes.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DEGREE, _COUNT, _TOO_FEW_POINTS, _SIZE, _DIMENSION, _STRIDE,
 *   _OVERFLOW, _FLAGS, _POINT_NOT_FINITE, _PARAMETER_NOT_FINITE, _KNOT_NOT_FINITE, _END_MULTIPLICITY,
 *   _MULTIPLICITY, _EMPTY_DOMAIN, _PERIODIC_KNOTS, _OUTSIDE_DOMAIN; _KNOTS_DECREASING for knots, and for
 *   parameters that do not increase; _SCHOENBERG_WHITNEY naming a parameter, its control point and its knots,
 *   _RANK where a periodic axis has no solution, _NOT_REPRESENTABLE if a control point overflows.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_interpolate_over_knots(int32_t axes, const int32_t *degrees,
                                                    const int64_t *counts, const double *params,
                                                    const double *knots, int64_t knot_count, int32_t dim,
                                                    const double *points, int64_t point_stride,
                                                    int64_t point_component_stride, uint32_t flags,
                                                    nurbs **out);

/** \brief The spline through points on a grid with given derivatives at the ends of axes.
 *
 * The values form a grid in which layers of derivatives lie beside the layers of points at the first and last
 * parameters of an axis. Layer i of axis k holds derivatives of order orders[i] along the axis at params[i].
 * Where layers of derivatives of two axes cross, the values are mixed derivatives (de Boor 1962). For
 * example, heights at 3 x 4 places whose slopes at all four borders are known have
 *
 *     counts {5, 6}   params {0, 0, 1, 2, 2,  0, 0, 1, 2, 3, 3}   orders {0, 1, 0, 0, 1,  0, 1, 0, 0, 0, 1}
 *
 * with mixed derivatives in the four corners. A mixed derivative that is NaN is estimated. The estimate is
 * the mean, over its axes, of the derivatives of polynomials of the degree of the axis through the nearest
 * layers, which reproduces polynomials and keeps the order of the error.
 *
 * The knots are those of nurbs_interpolate(), but at an end with m derivatives only the first degree / 2 - m
 * inner knots are left out. Every polynomial spline over these knots with these ends is reproduced up to
 * rounding. For an odd degree, derivatives of orders 1 to degree / 2 give the complete spline (for a cubic:
 * slopes), and derivatives of orders (degree + 1) / 2 to degree - 1 that are 0 give natural ends. For
 * conditions elsewhere than at ends there is nurbs_curve_interpolate().
 * \param[in] axes 1 to 3.
 * \param[in] degrees [axes].
 * \param[in] counts [axes] number of layers along each axis. The number of layers of order 0 is at least that
 *   which nurbs_interpolate() needs, less one for each derivative at an end, and at least 2.
 * \param[in] params [sum of counts] increasing along each axis, and equal only where orders rise.
 * \param[in] orders [sum of counts] or NULL for 0: orders of derivatives. The first one at each parameter
 *   is 0. Others, from 1 to the degree, occur only at the first and last parameter of an axis that is not
 *   periodic, at most degree / 2 of them at each end.
 * \param[in] dim dimension of the values.
 * \param[in] values [counts[0]]...[counts[axes-1]][dim] points and derivatives; mixed ones may be NaN; on a
 *   periodic axis the last layer repeats the first one bit for bit.
 * \param[in] value_stride,value_component_stride layout of values, 0 = packed.
 * \param[in] ends [axes][2] or NULL for NURBS_ENDS_NOT_A_KNOT: as for nurbs_interpolate(); 0 at an end where
 *   derivatives are given, and not NURBS_ENDS_FREE at the other end of such an axis.
 * \param[in] flags NURBS_PERIODIC for axes that are to be periodic.
 * \param[out] out the new handle.
 * \return as for nurbs_interpolate(), and NURBS_ERROR_ORDER for an order that is out of range, does not rise,
 *   or is not at an end, or for too many of them; _POINT_NOT_FINITE except for a mixed derivative that is
 *   NaN.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_interpolate_derivatives(int32_t axes, const int32_t *degrees,
                                                     const int64_t *counts, const double *params,
                                                     const int32_t *orders, int32_t dim, const double *values,
                                                     int64_t value_stride, int64_t value_component_stride,
                                                     const int32_t *ends, uint32_t flags, nurbs **out);

/** \brief The curve with given points and derivatives, of any orders at any parameters.
 *
 * Derivative orders[i] at params[i] is target i. The orders and parameters are arbitrary as long as they
 * determine a curve (Hermite's problem if each parameter has all orders up to its highest one, otherwise
 * Birkhoff's). Clamped ends are given as derivatives at the first and last parameter.
 *
 * With NURBS_ORDER_DIRECTION the first derivative is a positive multiple of the target. Of all lengths of
 * such tangents, those are used for which the integral of |C''|^2 over the pieces of the curve is smallest;
 * nurbs_tangent_lengths() returns them. For a tangent of a given length, use order 1.
 * \param[in] degree of the curve; with directions 2 to 15.
 * \param[in] n number of conditions, and of control points, > degree.
 * \param[in] params [n] not decreasing, in the domain of the knots.
 * \param[in] orders [n] or NULL for 0: orders of derivatives, 0 to degree, or NURBS_ORDER_DIRECTION, which is
 *   of order 1; rising where parameters are equal.
 * \param[in] dim dimension of the targets.
 * \param[in] targets [n][dim] points, derivatives, and directions of any length but 0, whose factors
 *   (nurbs_tangent_lengths()) are representable.
 * \param[in] target_stride,target_component_stride layout of targets, 0 = packed.
 * \param[in] knots [knot_count] or NULL: a full knot vector; NULL for nurbs_knots_averaged() of the
 *   parameters.
 * \param[in] knot_count n + degree + 1, with NURBS_PERIODIC n + 2 degree + 1; 0 for none.
 * \param[in] flags NURBS_PERIODIC for a periodic curve over the given knots, or 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _COUNT, _TOO_FEW_POINTS, _SIZE, _DIMENSION, _STRIDE,
 *   _OVERFLOW, _FLAGS, _POINT_NOT_FINITE, _PARAMETER_NOT_FINITE, _KNOT_NOT_FINITE, _END_MULTIPLICITY,
 *   _MULTIPLICITY, _EMPTY_DOMAIN, _PERIODIC_KNOTS, _OUTSIDE_DOMAIN; _ORDER for an order that is negative,
 *   above the degree, or not above the one before it at the same parameter, or for a direction if the degree
 *   is not from 2 to 15, _KNOTS_DECREASING for knots or parameters that decrease, _SCHOENBERG_WHITNEY, _RANK
 *   if the conditions do not determine the curve, or least energy does not determine the lengths,
 *   _NOT_REPRESENTABLE; _DIRECTION for a direction that is 0, _TANGENT naming a tangent that would point
 *   against its direction, or have no length (at most 2^-40 of the longest one), _NOT_CONVERGED if lengths
 *   are not found to 2^-26.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_interpolate(int32_t degree, int64_t n, const double *params,
                                               const int32_t *orders, int32_t dim, const double *targets,
                                               int64_t target_stride, int64_t target_component_stride,
                                               const double *knots, int64_t knot_count, uint32_t flags,
                                               nurbs **out);

/** \brief The lengths of the tangents of which nurbs_curve_interpolate() is given only the directions.
 *
 * They are factors of the targets of all conditions: with each target multiplied by its factor, and
 * NURBS_ORDER_DIRECTION replaced by 1, the curve is the same, bit for bit. Negative factors, which
 * nurbs_curve_interpolate() refuses, are returned as well: there the energy is smallest with the tangent
 * reversed. Multiplying a direction by a power of two only divides its factor by it. The lengths are the
 * solution of linear equations, found by preconditioned conjugate gradients in a time that grows with n.
 * \param[in] degree as for nurbs_curve_interpolate().
 * \param[in] n as for nurbs_curve_interpolate().
 * \param[in] params [n] as for nurbs_curve_interpolate().
 * \param[in] orders [n] or NULL for 0: as for nurbs_curve_interpolate().
 * \param[in] dim as for nurbs_curve_interpolate().
 * \param[in] targets [n][dim] as for nurbs_curve_interpolate().
 * \param[in] target_stride,target_component_stride layout of targets, 0 = packed.
 * \param[in] knots [knot_count] or NULL: as for nurbs_curve_interpolate().
 * \param[in] knot_count as for nurbs_curve_interpolate().
 * \param[in] flags as for nurbs_curve_interpolate().
 * \param[out] lengths [n] the factor of each direction; 1 for all other conditions.
 * \return as for nurbs_curve_interpolate() without _TANGENT, and NURBS_ERROR_OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_tangent_lengths(int32_t degree, int64_t n, const double *params,
                                             const int32_t *orders, int32_t dim, const double *targets,
                                             int64_t target_stride, int64_t target_component_stride,
                                             const double *knots, int64_t knot_count, uint32_t flags,
                                             double *lengths);

/** \brief Derivatives at the points of a curve, each from a few points near it.
 *
 * From them nurbs_create_hermite() makes a C^1 cubic that changes only near a point that moves. With the
 * slopes d_i = (P_(i+1) - P_i) / h_i of the chords, where h_i is the step of the parameters, the tangent at
 * P_i is
 *
 *     (h_(i-1) d_(i-1) + h_i d_i) / (h_(i-1) + h_i)                     NURBS_TANGENTS_CATMULL_ROM
 *     (h_i d_(i-1) + h_(i-1) d_i) / (h_(i-1) + h_i)                     NURBS_TANGENTS_BESSEL
 *     (|d_(i+1) - d_i| d_(i-1) + |d_(i-1) - d_(i-2)| d_i) / (the sum)   NURBS_TANGENTS_AKIMA
 *
 * If both of Akima's weights are 0, both slopes count equally. NURBS_TANGENTS_MONOTONE works on each
 * coordinate by itself: the tangent is 0 where the two slopes do not have the same sign, otherwise their
 * harmonic mean with the weights 2 h_i + h_(i-1) and h_i + 2 h_(i-1), less 2^-40 of it. The cubics of these
 * points and tangents are monotone between the data in each coordinate, and flat where the data are.
 * (Catmull-Rom splines over centripetal parameters are those of NURBS_TANGENTS_BESSEL.)
 *
 * At the ends of open data, the four rules use, in this order, the slope of the chord, the slope of the
 * parabola, Akima's extrapolation, and the slope of the parabola as far as the curve stays monotone.
 * \param[in] rule a NURBS_TANGENTS_ constant.
 * \param[in] n number of points, at least 2.
 * \param[in] params [n] strictly increasing.
 * \param[in] dim dimension of the points.
 * \param[in] points [n][dim].
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] flags NURBS_PERIODIC if the last point repeats the first one bit for bit, as the tangents then
 *   do; or 0.
 * \param[out] tangents [n][dim].
 * \param[in] tangent_stride,tangent_component_stride layout of tangents, 0 = packed.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _DIMENSION, _STRIDE, _OVERFLOW, _OVERLAP, _FLAGS,
 *   _POINT_NOT_FINITE, _PARAMETER_NOT_FINITE; _RULE for another rule, _KNOTS_DECREASING for parameters that
 *   do not increase, naming both, _PERIODIC_POINTS if the last point differs from the first,
 *   _NOT_REPRESENTABLE if a tangent overflows.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_tangents(int32_t rule, int64_t n, const double *params, int32_t dim,
                                      const double *points, int64_t point_stride,
                                      int64_t point_component_stride, uint32_t flags, double *tangents,
                                      int64_t tangent_stride, int64_t tangent_component_stride);
/** @} */

/** \defgroup fitting Fitting
 * \code
 * const int32_t cubic = 3;
 * const int64_t count = 5;
 * const double knots[9] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
 * double params[200], values[200];
 * for (int i = 0; i < 200; ++i) {
 *     params[i] = i / 199.0;
 *     values[i] = params[i] * params[i];
 * }
 * nurbs_data data;
 * nurbs_data_init(&data, sizeof data);
 * data.n = 200;
 * data.axes = data.dim = 1;
 * data.params = params;
 * data.values = values;
 * nurbs *fitted = NULL;
 * nurbs_fit_points(&data, &cubic, &count, knots, 9, 0, NULL, NULL, &fitted);
 * nurbs_destroy(fitted);
 * \endcode
 * Splines closest to data: s minimises
 *
 *     sum_i w_i |y_i - s(t_i)|^2 + lambda sum_k int (d^m s / dx_k^m)^2 dx
 *
 * over given knots, for values y_i of any dimension at parameters t_i on 1 to 3 axes. Here x_k is the
 * parameter of axis k, scaled so that its domain is from 0 to 1; so lambda does not depend on the unit of
 * parameters.
 *
 * **Statistics.** All that a fit needs to know of the data are sums over the cells between breaks, which a
 * nurbs_statistics holds. Knots (among the breaks), degrees and smoothing are chosen afterwards, without the
 * data. The sums are exact integers. So the statistics of parts of the data can be made on many machines, and
 * added and subtracted in any order; the result is the same, bit for bit, as for all data at once. The only
 * rounding is that of a value to 2^-53 of its scale, of a parameter to 2^-53 of its cell, and of products of
 * basis functions to 2^-62. The equations are then solved with twice the precision, so that the error of a
 * fit is about that of orthogonal methods up to degree 15 or so. A control point that the data do not
 * determine beyond rounding is NURBS_ERROR_RANK.
 *
 * A given lambda is limited to 2^64 times the trace of the matrix of the data, divided by that of the
 * penalty. A larger one would only lose digits of the data. The report has the lambda that was used. At the
 * limit, a curve of up to some 10^4 control points is a polynomial of degree m - 1. For surfaces and volumes
 * whose factorisation takes more than 10^7 multiply-adds, a large lambda may be NURBS_ERROR_RANK.
 *
 * **Robust fits** of points multiply the weights by factors, fit, and adjust the factors, until these change
 * little. The factor of a datum is the NURBS_ROBUST_ function of x = sqrt(w_i) |y_i - s(t_i)| / (width sigma
 * sqrt(dim)). Here sigma is the median of sqrt(w_i) |y_i - s(t_i)|, divided by that of normal errors of
 * standard deviation 1, times sqrt(n / (n - t)) for n data and the trace t of the influence matrix; it is at
 * least 2^-44 of the largest value whose residual is at most the median. The usual widths, 1.345 for Huber's
 * function and 4.685 for Tukey's, cost 5 % of efficiency if there are no outliers. Tukey's function starts
 * from Huber's fit and keeps its sigma. Data with x above 2^30 are left out. Where only outliers determine a
 * control point, the result for Tukey's function is Huber's fit, with NURBS_FIT_NOT_CONVERGED.
 *
 * **Shapes and bounds** are imposed on the control points and on the slopes between them. This is sufficient
 * for the spline, and for degrees from 2 on slightly more than necessary. Of all such splines the fit is the
 * one closest to the data, for the lambda that is best without the shape. On axes that are clamped or
 * periodic, the control points fulfil the inequalities exactly, as doubles, where conditions leave room for
 * that; second differences of convex and concave axes keep a distance of 2^-51 of the control points from 0
 * where rounding would otherwise move them out of the shape. On other axes, which are fitted as clamped ones
 * whose ends are moved afterwards, and with conditions that leave no room, the inequalities hold within
 * rounding. Convexity and the other shapes are those along each axis by itself.
 * @{ */

/** \brief Data: values at parameters, with weights. nurbs_data_init() sets all fields to 0 or NULL. Fields
 * are only ever appended. \since 1.1 */
typedef struct nurbs_data {
    int64_t struct_size;            /**< size of this struct as the caller knows it */
    int64_t n;                      /**< number of data, >= 0 */
    int32_t axes;                   /**< number of parameters, 1 to 3 */
    int32_t dim;                    /**< dimension of the values */
    const double *params;           /**< [n][axes] the parameters */
    int64_t param_stride;           /**< distance between parameters, 0 = packed */
    int64_t param_component_stride; /**< distance between components, 0 = 1 */
    const double *values;           /**< [n][dim] the values */
    int64_t value_stride;           /**< distance between values, 0 = packed */
    int64_t value_component_stride; /**< distance between components, 0 = 1 */
    const double *weights;          /**< [n] or NULL for 1: weights >= 0; 0 leaves the value out */
    int64_t weight_stride;          /**< distance between weights, 0 = 1 */
    uint32_t flags;    /**< evaluation flags for params, without NURBS_EXTRAPOLATE; with NURBS_NAN a
                          parameter that is outside or not finite leaves its value out */
    uint32_t reserved; /**< 0 */
} nurbs_data;

/** \brief Fills a struct with zeros and its size.
 * \param[out] data the struct.
 * \param[in] struct_size sizeof(nurbs_data).
 * \return NURBS_OK, NURBS_ERROR_NULL, _OPTIONS.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_data_init(nurbs_data *data, int64_t struct_size);

/** \brief Statistics of no data, for given degrees, breaks, dimension and scales.
 *
 * Only statistics that agree in all of these can be added. They take 24 bytes for each number that they hold
 * about a cell with data. These are product (2 degree + 1) + dim product (degree + 1) + dim + 1 numbers, with
 * products over the axes.
 * \param[in] axes 1 to 3.
 * \param[in] degrees [axes] highest degrees of the splines that are to be fitted.
 * \param[in] break_counts [axes] number of breaks of each axis, >= 2.
 * \param[in] breaks [break_total] the breaks of all axes, one after the other, increasing along each axis.
 *   The cells of an axis lie between them, and data from the first to the last one. Some 16 breaks for each
 *   knot that is to be chosen leave room for the choice.
 * \param[in] break_total sum of break_counts.
 * \param[in] dim dimension of the values.
 * \param[in] value_scale > 0, at least the largest |coordinate| of a value; rounded up to a power of two.
 * \param[in] weight_scale > 0, at least the largest weight; rounded up to a power of two. A weight below
 *   2^-54 of it counts as 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DEGREE, _COUNT, _SIZE, _DIMENSION, _OVERFLOW,
 *   _KNOT_NOT_FINITE; _KNOTS_DECREASING for breaks that do not increase, _FACTOR for a scale that is not
 *   finite and positive.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_statistics_create(int32_t axes, const int32_t *degrees,
                                               const int64_t *break_counts, const double *breaks,
                                               int64_t break_total, int32_t dim, double value_scale,
                                               double weight_scale, nurbs_statistics **out);

/** \brief Statistics with more data: the sum of given statistics and those of the data.
 *
 * The sum is that of nurbs_statistics_merge(). The cost is that of the data and of all cells that hold any.
 * So for many chunks it is better to add each one to statistics of no data, and then to merge the results.
 * \param[in] statistics a handle.
 * \param[in] data what to add; its axes and dim are those of the statistics.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OPTIONS, _AXES, _COUNT, _DIMENSION, _STRIDE, _OVERFLOW, _FLAGS,
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _POINT_NOT_FINITE, _WEIGHT_NOT_FINITE, _WEIGHT_NEGATIVE, _SCALE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_statistics_add(const nurbs_statistics *statistics, const nurbs_data *data,
                                            nurbs_statistics **out);

/** \brief nurbs_statistics_add() with progress reports, cancellation and a limit of work.
 * \param[in] statistics as for nurbs_statistics_add().
 * \param[in] data as for nurbs_statistics_add().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_statistics_add(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_statistics_add_with(const nurbs_statistics *statistics, const nurbs_data *data,
                                                 const nurbs_call_options *call, nurbs_statistics **out);

/** \brief The sum of statistics, some of which may be subtracted.
 *
 * The sum is exact: it is the same, bit for bit, in any order and for any partition of the same data, and
 * what was added can be subtracted again.
 * \param[in] count number of parts, >= 1.
 * \param[in] parts [count] handles that agree in degrees, breaks, dimension and scales.
 * \param[in] signs [count] or NULL for 1: 1 to add, -1 to subtract a part.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW; _INCOMPATIBLE naming the first part that differs,
 *   _RULE for another sign, _COUNT also where more is subtracted from a cell than was added to it.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_statistics_merge(int64_t count, const nurbs_statistics *const *parts,
                                              const int32_t *signs, nurbs_statistics **out);

/** \brief Another handle on the same statistics, in constant time.
 * \param[in] statistics a handle.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_statistics_clone(const nurbs_statistics *statistics, nurbs_statistics **out);

/** \brief Frees a handle on statistics.
 * \param[in] statistics or NULL, which does nothing: a handle.
 * \since 1.1 */
NURBS_API void nurbs_statistics_destroy(nurbs_statistics *statistics);

/** \brief How much data statistics hold.
 * \param[in] statistics a handle.
 * \param[out] axes or NULL: number of axes.
 * \param[out] dim or NULL: dimension of the values.
 * \param[out] count or NULL: number of data that count.
 * \param[out] cells or NULL: number of cells that hold any of them.
 * \param[out] weight or NULL: sum of the weights.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_statistics_size(const nurbs_statistics *statistics, int32_t *axes, int32_t *dim,
                                             int64_t *count, int64_t *cells, double *weight);

/** \brief Statistics as bytes, to be kept or sent.
 *
 * The bytes are the same on every machine for the same data, whatever the order of the data. A header of 64
 * bytes has a signature, the version of the format, the size, and a checksum that finds every burst of errors
 * of up to 64 bits.
 * \param[in] statistics a handle.
 * \param[in] cap size of bytes: 0, or at least the number of bytes.
 * \param[out] bytes [cap] or NULL: receives the bytes.
 * \param[out] length or NULL: number of bytes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_statistics_to_bytes(const nurbs_statistics *statistics, int64_t cap, void *bytes,
                                                 int64_t *length);

/** \brief Statistics from the bytes of nurbs_statistics_to_bytes().
 * \param[in] bytes [size] the bytes.
 * \param[in] size number of bytes.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT; _FORMAT for bytes that are not a handle, or one of another
 *   kind, _TRUNCATED, _VERSION, _CHECKSUM, _SYNTAX for numbers that no statistics have, _KNOT_NOT_FINITE,
 *   _OVERFLOW.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_statistics_from_bytes(const void *bytes, int64_t size, nurbs_statistics **out);

/** \brief Settings of a fit: smoothing, conditions, robustness and shape. nurbs_fit_options_init() fills in
 * the defaults, which NULL stands for as well. Fields are only ever appended. \since 1.1 */
typedef struct nurbs_fit_options {
    int64_t struct_size;   /**< size of this struct as the caller knows it */
    int32_t smoothing;     /**< a NURBS_SMOOTHING_ constant; default NURBS_SMOOTHING_NONE */
    int32_t penalty_order; /**< m, the order of the derivative that is penalised, >= 1; default 2 */
    double lambda;         /**< the factor of the penalty, for NURBS_SMOOTHING_LAMBDA, >= 0; default 0 */
    double target;         /**< for NURBS_SMOOTHING_DISCREPANCY: largest sum_i w_i |y_i - s(t_i)|^2, >= 0;
                           default 0 */
    int32_t regularize;    /**< 1: of several solutions take that of the smallest penalty; 0: refuse them */
    int32_t reserved;      /**< 0 */
    int64_t conditions;    /**< number of equations that the fit has to fulfil, >= 0; default 0 */
    const double *condition_params;  /**< [conditions][axes] or NULL: parameters, packed */
    const int32_t *condition_orders; /**< [conditions][axes] or NULL for 0: orders of derivatives */
    const double *condition_targets; /**< [conditions][dim] or NULL: points and derivatives, packed */
    int32_t robust; /**< a NURBS_ROBUST_ constant; others than NURBS_ROBUST_NONE, the default, are for fits of
                       points over given knots */
    int32_t reserved2;     /**< 0 */
    double robust_width;   /**< where outliers begin, in standard deviations, >= 0; 0: the usual width */
    const int32_t *shapes; /**< [axes][dim] or NULL: sums of NURBS_TREND_ constants, or 0 */
    const double *lower;   /**< [dim] or NULL: lower bounds of coordinates; -INFINITY for none */
    const double *upper;   /**< [dim] or NULL: upper bounds of coordinates; INFINITY for none */
} nurbs_fit_options;

/** \brief Fills an options struct with the defaults.
 * \param[out] options the struct.
 * \param[in] struct_size sizeof(nurbs_fit_options).
 * \return NURBS_OK, NURBS_ERROR_NULL, _OPTIONS.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_options_init(nurbs_fit_options *options, int64_t struct_size);

/** \brief What is known of a fit. Set struct_size to sizeof(nurbs_fit_report); all other fields are results.
 * Fields are only ever appended. \since 1.1 */
typedef struct nurbs_fit_report {
    int64_t struct_size;   /**< size of this struct as the caller knows it */
    int64_t data_count;    /**< receives the number of data that count */
    double weight;         /**< receives the sum of their weights */
    double squares;        /**< receives sum_i w_i |y_i - s(t_i)|^2 */
    double rms;            /**< receives the square root of squares / weight */
    double lambda;         /**< receives the factor of the penalty that was taken */
    double freedom;        /**< receives the trace of the influence matrix: effective number of parameters */
    double sigma;          /**< receives the standard deviation of a coordinate of weight 1, from residuals;
                            of robust fits from their median */
    double residual;       /**< receives |G x + lambda P x - r| / |r| of the normal equations */
    double largest;        /**< receives the largest |y_i - s(t_i)|; NaN from nurbs_fit() */
    int64_t largest_index; /**< receives the index of that datum; -1 from nurbs_fit() */
    int32_t bits;          /**< receives a sum of NURBS_FIT_ bits */
    int32_t rounds;        /**< receives the number of fits that a robust fit took, else 1 */
    int64_t outliers;      /**< receives the number of data with x > 1 of a robust fit, else 0 */
} nurbs_fit_report;

/** \brief The spline over given knots that is closest to the data of statistics.
 * \param[in] statistics a handle.
 * \param[in] degrees [axes] at most those of the statistics.
 * \param[in] counts [axes] number of control points of each axis, on periodic ones with the copies.
 * \param[in] knots [knot_count] full knot vectors of all axes, one after the other; knots inside a domain are
 *   breaks of the statistics, and its ends are the first and last breaks.
 * \param[in] knot_count sum of (count + degree + 1).
 * \param[in] flags NURBS_PERIODIC per axis.
 * \param[in] options or NULL: smoothing, conditions and shape.
 * \param[in,out] report or NULL: receives what is known of the fit.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _COUNT, _TOO_FEW_POINTS, _SIZE, _OVERFLOW, _FLAGS,
 *   _KNOT_NOT_FINITE, _KNOTS_DECREASING, _END_MULTIPLICITY, _MULTIPLICITY, _EMPTY_DOMAIN, _PERIODIC_KNOTS;
 *   _NOT_A_KNOT for a knot that is not a break, _OUTSIDE_DOMAIN for another domain, or a condition outside
 *   it, _OPTIONS, _RULE for another smoothing, _ORDER for a penalty above all degrees or an order of a
 *   condition that is negative or above the degree, _FACTOR for a lambda or target that is negative or not
 *   finite, _PARAMETER_NOT_FINITE, _POINT_NOT_FINITE for conditions, _CONTRADICTION naming one; _RANK naming
 *   a control point that the data do not determine, _NOT_REPRESENTABLE. For shapes: _RULE for opposite ones,
 *   or one along a periodic axis, _ORDER for a convex axis of degree 0, _MULTIPLICITY for one with a knot of
 *   multiplicity degree + 1 inside, _POINT_NOT_FINITE for a bound that is NaN, _CONTRADICTION for bounds that
 *   cross, or where no spline fulfils conditions and shape. _RULE also for a robust fit, which needs the
 *   data.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit(const nurbs_statistics *statistics, const int32_t *degrees,
                                 const int64_t *counts, const double *knots, int64_t knot_count,
                                 uint32_t flags, const nurbs_fit_options *options, nurbs_fit_report *report,
                                 nurbs **out);

/** \brief nurbs_fit() with progress reports, cancellation and a limit of work.
 * \param[in] statistics as for nurbs_fit().
 * \param[in] degrees as for nurbs_fit().
 * \param[in] counts as for nurbs_fit().
 * \param[in] knots as for nurbs_fit().
 * \param[in] knot_count as for nurbs_fit().
 * \param[in] flags as for nurbs_fit().
 * \param[in] options as for nurbs_fit().
 * \param[in,out] report as for nurbs_fit().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_fit(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_with(const nurbs_statistics *statistics, const int32_t *degrees,
                                      const int64_t *counts, const double *knots, int64_t knot_count,
                                      uint32_t flags, const nurbs_fit_options *options,
                                      nurbs_fit_report *report, const nurbs_call_options *call, nurbs **out);

/** \brief The spline over given knots that is closest to data.
 *
 * It is nurbs_fit() of the statistics of the data, with the knots as breaks and the largest value and weight
 * as scales, in memory that does not depend on the number of data.
 * \param[in] data the data.
 * \param[in] degrees [axes] degrees.
 * \param[in] counts [axes] number of control points of each axis, on periodic ones with the copies.
 * \param[in] knots [knot_count] full knot vectors of all axes, one after the other; data lie in the domain.
 * \param[in] knot_count sum of (count + degree + 1).
 * \param[in] flags NURBS_PERIODIC per axis.
 * \param[in] options or NULL: smoothing, conditions, robustness and shape.
 * \param[in,out] report or NULL: receives what is known of the fit.
 * \param[out] out the new handle.
 * \return as for nurbs_fit(), and NURBS_ERROR_AXES, _DIMENSION, _STRIDE, _PARAMETER_NOT_FINITE,
 *   _OUTSIDE_DOMAIN, _POINT_NOT_FINITE, _WEIGHT_NOT_FINITE, _WEIGHT_NEGATIVE, _FACTOR for a width that is
 *   negative or not finite; without _NOT_A_KNOT, and _RULE only for another smoothing, robust rule or shape.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_points(const nurbs_data *data, const int32_t *degrees, const int64_t *counts,
                                        const double *knots, int64_t knot_count, uint32_t flags,
                                        const nurbs_fit_options *options, nurbs_fit_report *report,
                                        nurbs **out);

/** \brief nurbs_fit_points() with progress reports, cancellation and a limit of work.
 * \param[in] data as for nurbs_fit_points().
 * \param[in] degrees as for nurbs_fit_points().
 * \param[in] counts as for nurbs_fit_points().
 * \param[in] knots as for nurbs_fit_points().
 * \param[in] knot_count as for nurbs_fit_points().
 * \param[in] flags as for nurbs_fit_points().
 * \param[in] options as for nurbs_fit_points().
 * \param[in,out] report as for nurbs_fit_points().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_fit_points(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_points_with(const nurbs_data *data, const int32_t *degrees,
                                             const int64_t *counts, const double *knots, int64_t knot_count,
                                             uint32_t flags, const nurbs_fit_options *options,
                                             nurbs_fit_report *report, const nurbs_call_options *call,
                                             nurbs **out);

/** \brief Pointwise standard errors of a fit.
 *
 * The standard error is sigma sqrt(b(t) (G + lambda P)^-1 b(t)), with the basis functions b, the matrix G of
 * the data and the matrix P of the penalty: how far each coordinate of the fit may be off if the coordinates
 * of data of weight w have the standard deviation sigma / sqrt(w). Without a penalty it is the error of least
 * squares. With one it is Bayesian, and 1.96 of it on both sides cover the true function at 95 % of all
 * places (Wahba 1983). Conditions, shapes and factors of robust fits are disregarded.
 * \param[in] statistics statistics of the data that were fitted.
 * \param[in] g the fit, or any spline over its knots: only the knots count.
 * \param[in] penalty_order order of the derivative that was penalised, >= 1; not read for a lambda of 0.
 * \param[in] lambda factor of the penalty, >= 0, as in the report of the fit.
 * \param[in] sigma standard deviation, >= 0, as in the report of the fit.
 * \param[in] n number of parameters, >= 0.
 * \param[in] params [n][axes] the parameters.
 * \param[in] param_stride distance between parameters, 0 = packed.
 * \param[in] param_component_stride distance between components, 0 = 1.
 * \param[in] flags evaluation flags, without NURBS_EXTRAPOLATE.
 * \param[out] errors [n] receives the standard errors.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES for a spline with another number of axes, _COUNT, _STRIDE,
 *   _OVERFLOW, _FLAGS, _OVERLAP, _DEGREE, _NOT_A_KNOT, _OUTSIDE_DOMAIN, _PARAMETER_NOT_FINITE, _ORDER,
 *   _FACTOR, _RANK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_errors(const nurbs_statistics *statistics, const nurbs *g,
                                        int32_t penalty_order, double lambda, double sigma, int64_t n,
                                        const double *params, int64_t param_stride,
                                        int64_t param_component_stride, uint32_t flags, double *errors);

/** \brief nurbs_fit_errors() with progress reports, cancellation and a limit of work.
 * \param[in] statistics as for nurbs_fit_errors().
 * \param[in] g as for nurbs_fit_errors().
 * \param[in] penalty_order as for nurbs_fit_errors().
 * \param[in] lambda as for nurbs_fit_errors().
 * \param[in] sigma as for nurbs_fit_errors().
 * \param[in] n as for nurbs_fit_errors().
 * \param[in] params as for nurbs_fit_errors().
 * \param[in] param_stride as for nurbs_fit_errors().
 * \param[in] param_component_stride as for nurbs_fit_errors().
 * \param[in] flags as for nurbs_fit_errors().
 * \param[out] errors as for nurbs_fit_errors().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_fit_errors(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_errors_with(const nurbs_statistics *statistics, const nurbs *g,
                                             int32_t penalty_order, double lambda, double sigma, int64_t n,
                                             const double *params, int64_t param_stride,
                                             int64_t param_component_stride, uint32_t flags, double *errors,
                                             const nurbs_call_options *call);

/** \brief What NURBS_SMOOTHING_GCV and NURBS_SMOOTHING_REML compare, for each of some factors of the penalty.
 *
 * With n data, N control points, M of them that no penalty determines, R = sum_i w_i |y_i - s(t_i)|^2 and the
 * trace t of the influence matrix, GCV is n R / (n - t)^2, and REML is (n - M) log(R + lambda P) + log
 * det(G + lambda P) - (N - M) log lambda, where P is the penalty, or its matrix, and G the matrix of the
 * data. Where rounding makes t uncertain, GCV is infinite. With N >= n, where it ends in 0 / 0, it is also
 * infinite where n - t is not above 2^-10 n. NURBS_SMOOTHING_GCV passes over such factors.
 * \param[in] statistics a handle.
 * \param[in] g a spline of which only the knots count; they have to be as for nurbs_fit().
 * \param[in] penalty_order order of the derivative that is penalised, >= 1.
 * \param[in] n number of factors, >= 0.
 * \param[in] lambdas [n] factors, > 0.
 * \param[out] values [n][4] receives R, t, GCV and REML for each factor.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERFLOW, _OVERLAP, _DEGREE, _NOT_A_KNOT,
 *   _OUTSIDE_DOMAIN, _ORDER, _FACTOR, _RANK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_criteria(const nurbs_statistics *statistics, const nurbs *g,
                                          int32_t penalty_order, int64_t n, const double *lambdas,
                                          double *values);

/** \brief nurbs_fit_criteria() with progress reports, cancellation and a limit of work.
 * \param[in] statistics as for nurbs_fit_criteria().
 * \param[in] g as for nurbs_fit_criteria().
 * \param[in] penalty_order as for nurbs_fit_criteria().
 * \param[in] n as for nurbs_fit_criteria().
 * \param[in] lambdas as for nurbs_fit_criteria().
 * \param[out] values as for nurbs_fit_criteria().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_fit_criteria(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_criteria_with(const nurbs_statistics *statistics, const nurbs *g,
                                               int32_t penalty_order, int64_t n, const double *lambdas,
                                               double *values, const nurbs_call_options *call);

/** \brief A spline with few control points from which no datum is farther than a tolerance.
 *
 * Knots are placed where a first fit over even knots shows that they are needed, and as often at one place as
 * a kink or a jump of the data requires. Their number is found with some of the data, and checked with all.
 * With several axes, each has as many as it needs beside the others. Where the data leave control points
 * undetermined, the fit with the smallest penalty is taken. Where the limit of work ends the search, a
 * tolerance may be met with more control points than it needs, or missed.
 * \param[in] data the data.
 * \param[in] degrees [axes] degrees.
 * \param[in] domain [axes][2] or NULL: start and end of each axis; NULL for the range of the parameters.
 * \param[in] tolerance >= 0, the largest distance |y_i - s(t_i)| that is allowed.
 * \param[in] max_count largest number of control points, with the copies of periodic axes; 0: as many as
 *   data. The search ends earlier where knots would be nearly as close to each other as data: at a third of
 *   the data above 2000 of them (20000 with several axes), and at 8100 with several axes.
 * \param[in] flags NURBS_PERIODIC per axis.
 * \param[in] options or NULL: smoothing, conditions and shape; regularize is not read.
 * \param[in,out] report or NULL: receives what is known of the fit; its bits have NURBS_FIT_TARGET_MISSED if
 *   the result is only the closest one that was found.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OPTIONS, _AXES, _COUNT, _DIMENSION, _STRIDE, _OVERFLOW, _FLAGS,
 *   _DEGREE, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _POINT_NOT_FINITE, _WEIGHT_NOT_FINITE, _WEIGHT_NEGATIVE,
 *   _RULE, also for a robust fit, _ORDER, _FACTOR, _CONTRADICTION, _NOT_REPRESENTABLE; _TOLERANCE for one
 *   that is negative or NaN, _EMPTY_DOMAIN for a domain without length, _COUNT also for no data,
 *   _TOO_FEW_POINTS for a max_count below the product of degree + 1.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_tolerance(const nurbs_data *data, const int32_t *degrees,
                                           const double *domain, double tolerance, int64_t max_count,
                                           uint32_t flags, const nurbs_fit_options *options,
                                           nurbs_fit_report *report, nurbs **out);

/** \brief nurbs_fit_tolerance() with progress reports, cancellation and a limit of work.
 * \param[in] data as for nurbs_fit_tolerance().
 * \param[in] degrees as for nurbs_fit_tolerance().
 * \param[in] domain as for nurbs_fit_tolerance().
 * \param[in] tolerance as for nurbs_fit_tolerance().
 * \param[in] max_count as for nurbs_fit_tolerance().
 * \param[in] flags as for nurbs_fit_tolerance().
 * \param[in] options as for nurbs_fit_tolerance().
 * \param[in,out] report as for nurbs_fit_tolerance().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_fit_tolerance(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_tolerance_with(const nurbs_data *data, const int32_t *degrees,
                                                const double *domain, double tolerance, int64_t max_count,
                                                uint32_t flags, const nurbs_fit_options *options,
                                                nurbs_fit_report *report, const nurbs_call_options *call,
                                                nurbs **out);

/** \brief A polynomial spline with few control points, proven to be within a tolerance of another spline.
 *
 * The distance is that at equal parameters, at all of them. So a rational spline can be replaced by a
 * polynomial one, a high degree by a low one, or many knots by few. Samples of g are fitted as by
 * nurbs_fit_tolerance(), and the result is compared with g as by nurbs_deviation(). The corners of a fit are
 * those of g, bit for bit. Jumps and kinks stay where they are if max_count and the limit of work have room
 * for them, and periodic axes stay periodic. A polynomial g of no higher degrees is returned itself, with its
 * degrees raised, where nothing simpler is found. Where the limit of work ends the search, a tolerance may be
 * met with more control points than it needs, or missed.
 * \param[in] g a spline.
 * \param[in] degrees [axes] or NULL: degrees of the result; NULL for those of g.
 * \param[in] tolerance >= 0, the largest distance that is allowed; 0 is met only by a polynomial g of no
 *   higher degrees.
 * \param[in] max_count largest number of control points; 0: no limit but that of the samples.
 * \param[out] bound or NULL: an upper bound of the distance, above the tolerance if the result is only the
 *   closest one that was found.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DEGREE, _TOLERANCE, _COUNT; _TOO_FEW_POINTS for a max_count below the
 *   product of degree + 1, _OVERFLOW, _NOT_REPRESENTABLE; _NOT_CONVERGED where even the simplest fit takes
 *   more work than its limit.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_approximate(const nurbs *g, const int32_t *degrees, double tolerance,
                                         int64_t max_count, double *bound, nurbs **out);

/** \brief nurbs_approximate() with progress reports, cancellation and a limit of work.
 * \param[in] g as for nurbs_approximate().
 * \param[in] degrees as for nurbs_approximate().
 * \param[in] tolerance as for nurbs_approximate().
 * \param[in] max_count as for nurbs_approximate().
 * \param[out] bound as for nurbs_approximate().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_approximate(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_approximate_with(const nurbs *g, const int32_t *degrees, double tolerance,
                                              int64_t max_count, double *bound,
                                              const nurbs_call_options *call, nurbs **out);

/** \brief A spline from which nurbs_fit_cloud() can begin, found from points without parameters.
 *
 * It is linear along each axis, in one of the principal directions of the points, axis 0 in the first one; it
 * goes through their mean, and as far as they reach. A periodic curve is an ellipse in the plane of the first
 * two directions, with the variances of the points, as far as the knots allow. A surface that is periodic
 * along one axis is an elliptic cylinder, around that of the first three directions from which the distances
 * of the points vary least. No start is found for surfaces that are closed along both axes, and none that is
 * good for clouds far from a plane or a cylinder, as a spiral is far from a line: for these the caller has to
 * supply one. Points that span fewer dimensions than there are axes give a start that is collapsed. The order
 * of the points does not matter.
 * \param[in] axes 1 to 3, less than dim.
 * \param[in] degrees [axes] degrees.
 * \param[in] counts [axes] number of control points of each axis, on periodic ones with the copies.
 * \param[in] knots [knot_count] full knot vectors of all axes, one after the other.
 * \param[in] knot_count sum of (count + degree + 1).
 * \param[in] n number of points, at least 1.
 * \param[in] dim dimension of the points.
 * \param[in] points [n][dim] the points.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] flags NURBS_PERIODIC for one axis of a curve or surface, or 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DEGREE, _COUNT, _TOO_FEW_POINTS, _SIZE, _DIMENSION, _STRIDE,
 *   _OVERFLOW, _FLAGS, _POINT_NOT_FINITE, _KNOT_NOT_FINITE, _KNOTS_DECREASING, _END_MULTIPLICITY,
 *   _MULTIPLICITY, _EMPTY_DOMAIN, _PERIODIC_KNOTS; _DIMENSION also for a dim that is not above axes, _FLAGS
 *   also for periodic axes for which no start is found, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_cloud_start(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                         const double *knots, int64_t knot_count, int64_t n, int32_t dim,
                                         const double *points, int64_t point_stride,
                                         int64_t point_component_stride, uint32_t flags, nurbs **out);

/** \brief Settings of nurbs_fit_cloud(). nurbs_cloud_options_init() fills in the defaults, which NULL stands
 * for as well. Fields are only ever appended. \since 1.1 */
typedef struct nurbs_cloud_options {
    int64_t struct_size;   /**< size of this struct as the caller knows it */
    int32_t penalty_order; /**< m, the order of the derivative that is penalised, >= 1; default 2 */
    int32_t rounds;        /**< most searches for the nearest points of all points, >= 1; default 100 */
    double lambda;         /**< the factor of the penalty; below 0: found; default -1 */
    double first_lambda;   /**< the factor at the start, which falls to lambda; below 0: found; default -1 */
    double tolerance;      /**< the smallest relative decrease of the sum worth a step, >= 0; default 1e-3 */
} nurbs_cloud_options;

/** \brief Fills an options struct with the defaults.
 * \param[out] options the struct.
 * \param[in] struct_size sizeof(nurbs_cloud_options).
 * \return NURBS_OK, NURBS_ERROR_NULL, _OPTIONS.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_cloud_options_init(nurbs_cloud_options *options, int64_t struct_size);

/** \brief What is known of a fit by nurbs_fit_cloud(). Set struct_size to sizeof(nurbs_cloud_report); all
 * other fields are results. Fields are only ever appended. \since 1.1 */
typedef struct nurbs_cloud_report {
    int64_t struct_size;   /**< size of this struct as the caller knows it */
    int64_t data_count;    /**< receives the number of points that count: those of a weight above 0 */
    double weight;         /**< receives the sum of their weights */
    double squares;        /**< receives sum_i w_i d_i^2, d_i the distance of point i from the result */
    double rms;            /**< receives the square root of squares / weight */
    double largest;        /**< receives the largest d_i */
    int64_t largest_index; /**< receives the index of that point */
    double lambda;         /**< receives the last factor of the penalty */
    double noise;          /**< receives a bound of the error of a d_i, if its nearest point is certified */
    int64_t boundary;      /**< receives the number of points whose nearest point is on an end or an edge */
    int64_t uncertified;   /**< receives the number of points whose nearest point is not proven */
    int32_t rounds;        /**< receives the number of searches for the nearest points of all points */
    int32_t bits;          /**< receives a sum of NURBS_CLOUD_ bits */
} nurbs_cloud_report;

/** \brief The spline, over the knots of a start, that is closest to points without parameters.
 *
 * It is a minimum, reached from the start, of
 *
 *     sum_i w_i min_t |x_i - s(t)|^2 + lambda sum_k int (d^m s / dx_k^m)^2 dx
 *
 * where x_k is the parameter of axis k, scaled so that its domain is from 0 to 1. An m above the highest
 * degree counts as the highest degree.
 *
 * **Rounds.** Each round finds the nearest point of s for each x_i, its foot, as nurbs_closest_points() does,
 * with a proof if a few pieces are enough for one. Then the squared distance to the moving spline is modelled
 * as (r - m)^T W (r - m), where r leads from the foot to the point, and m, here, is the movement of the foot.
 * W is 1 in directions normal to s. In a principal direction of curvature it is K / (1 + K) on the outer
 * side, where K is |r| over the radius of curvature, and 0 on the inner side. It is 1 where the foot stays,
 * at ends, edges and kinks. This model lies between the distances to the tangent and to the foot (Wang,
 * Pottmann & Liu 2006). The step that makes the sum of the models least is taken if the true sum falls,
 * otherwise a shorter one (Levenberg 1944, Marquardt 1963); so the sum never rises.
 *
 * **The penalty.** Between rounds lambda falls, at most by a factor of 8, from first_lambda to lambda. If
 * these are to be found, and the start has no shape of its own, as a line or a plane, lambda begins where it
 * allows almost no shape. It goes on to the quotient of two variances, that of the distances and that of what
 * is penalised: sum_i w_i d_i^2 N / n over the penalty, where N is the number of control points times the
 * number of dimensions across the spline, and n the number of points (Wood & Fasiolo 2017). So lambda
 * vanishes with the distances, and points on a spline over these knots are met to rounding from a start that
 * is near it. From a start that is not near it, parameters may have to slide far along a shape that is almost
 * right, which takes more rounds than there are. Where lambda is so large that bends are less than 2^-26 of
 * what they are without it, it acts as the lambda at which that begins: polynomials of degree m - 1 are left,
 * and smaller bends would only lose digits.
 *
 * **The result** is the same, bit for bit, for any order of the points, and it scales with the points and the
 * start, to rounding (by powers of two bit for bit). Ends are free: those of a curve come to the outermost
 * points, but nothing draws back what reaches beyond them. Periodic axes stay periodic. Control points that
 * no point is near, as with fewer points than control points, go where smoothing and damping leave them. The
 * minimum is a local one: feet do not jump from one part of s to another that lies behind it. Points whose
 * distance from 0 is large compared with their extent are fitted about their middle, without loss: only the
 * control points of the result, and its distances, are rounded as coordinates of that size are.
 *
 * **Distances** are those of the stored result as it is evaluated. None is below the true one by more than
 * noise. Where uncertified is 0, none is above it by more either, so that largest and rms are proven to
 * within noise. The search for proofs goes on as long as the nearest points of a shape with tangents need. On
 * a shape that has collapsed to a curve or a point, whole lines of parameters are equally near, and points
 * may stay uncertified.
 * \param[in] g the start, polynomial, of a dimension above its number of axes; for example from
 *   nurbs_cloud_start().
 * \param[in] n number of points, at least 1 of a weight above 0.
 * \param[in] points [n][dim] the points.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] weights [n] or NULL for 1: weights >= 0; a weight of 0 leaves the point out, whatever its
 *   coordinates are.
 * \param[in] weight_stride distance between weights, 0 = 1.
 * \param[in] options or NULL: settings.
 * \param[in,out] report or NULL: receives what is known of the fit; its bits have NURBS_CLOUD_NOT_CONVERGED
 *   if steps were still lowering the sum by more than the tolerance when the rounds, or the limit of work,
 *   ended.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _STRIDE, _OVERFLOW, _POINT_NOT_FINITE, _WEIGHT_NOT_FINITE,
 *   _WEIGHT_NEGATIVE; _RATIONAL if g is rational, _DIMENSION if its dimension is not above its number of
 *   axes, _OPTIONS, _ORDER for a penalty_order below 1, _COUNT also for rounds below 1, _FACTOR for a lambda
 *   or first_lambda that is not finite, _TOLERANCE, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_cloud(const nurbs *g, int64_t n, const double *points, int64_t point_stride,
                                       int64_t point_component_stride, const double *weights,
                                       int64_t weight_stride, const nurbs_cloud_options *options,
                                       nurbs_cloud_report *report, nurbs **out);

/** \brief nurbs_fit_cloud() with progress reports, cancellation and a limit of work.
 * \param[in] g as for nurbs_fit_cloud().
 * \param[in] n as for nurbs_fit_cloud().
 * \param[in] points as for nurbs_fit_cloud().
 * \param[in] point_stride,point_component_stride as for nurbs_fit_cloud().
 * \param[in] weights as for nurbs_fit_cloud().
 * \param[in] weight_stride as for nurbs_fit_cloud().
 * \param[in] options as for nurbs_fit_cloud().
 * \param[in,out] report as for nurbs_fit_cloud().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_fit_cloud(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fit_cloud_with(const nurbs *g, int64_t n, const double *points,
                                            int64_t point_stride, int64_t point_component_stride,
                                            const double *weights, int64_t weight_stride,
                                            const nurbs_cloud_options *options, nurbs_cloud_report *report,
                                            const nurbs_call_options *call, nurbs **out);
/** @} */

/** \defgroup continuity Continuity
 * \code
 * int64_t count = 0; // of the knots inside the domain
 * nurbs_continuity(curve, 0, 1e-6, 1e-6, 1e-6, 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL, &count);
 * \endcode
 * The parametric order k of a place says that the derivatives of orders 0 to k are the same on both sides: -1
 * is a jump, 0 a kink. It is at most the degree. It holds within tolerances: points may differ by
 * position_tolerance, the derivatives of order 1 and more by derivative_tolerance times the length of the
 * longer one, and all of them by the rounding that their computation may have. So tolerances of 0 ask for as
 * much as double precision can decide.
 *
 * The geometric order is 0 if the points agree in this way. It is 1 if in addition the angle between the
 * tangents is at most angle_tolerance. It is 2 if their curvature vectors (C'' - (C'' T) T) / |C'|^2 also
 * differ by at most derivative_tolerance times the longer one, or times 1 / l, where l is the length |C'| h
 * of the longer one of the two spans [t, t + h]: along l a gap d turns the tangent by d l, so that no
 * rounding breaks a straight line. Where the first derivative vanishes the tangent is the limit, given by the
 * first derivative that does not, and the geometric order is at most 1. Where all vanish it is at most 0, and
 * the angle is NaN.
 * @{ */

/** \brief Continuity at the knots of an axis: one row for each distinct knot inside the domain, and one more,
 * named by the upper end of the domain, for the seam of an axis that is periodic or whose ends meet within
 * position_tolerance. Of a surface or a volume the row is the worst of samples: degree + 1 places in each
 * span of every other axis; a surface in space has the angles between its normals, and geometric orders to 1,
 * other surfaces and volumes have neither angles (NaN) nor geometric orders above 0, and only curves have
 * curvatures.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] position_tolerance,derivative_tolerance,angle_tolerance >= 0, angles in radians; infinite ones
 *   admit everything.
 * \param[in] cap length of the outputs: 0, or at least the number of rows.
 * \param[out] knots [cap] or NULL: where.
 * \param[out] knot_orders [cap] or NULL: the order that the knots guarantee, degree - multiplicity; -1 for
 *   the seam of an axis that is not periodic.
 * \param[out] orders [cap] or NULL: the parametric order that holds.
 * \param[out] geometric_orders [cap] or NULL: the geometric order that holds.
 * \param[out] position_gaps [cap] or NULL: distance of the points.
 * \param[out] angles [cap] or NULL: angle in radians, NaN where there is none.
 * \param[out] curvature_gaps [cap] or NULL: length of the difference of the curvature vectors, NaN where
 *   there is none.
 * \param[out] count or NULL: number of rows.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _TOLERANCE, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor
 *   enough; _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if all weights along a knot are 0.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_continuity(const nurbs *g, int32_t axis, double position_tolerance,
                                        double derivative_tolerance, double angle_tolerance, int64_t cap,
                                        double *knots, int32_t *knot_orders, int32_t *orders,
                                        int32_t *geometric_orders, double *position_gaps, double *angles,
                                        double *curvature_gaps, int64_t *count);

/** \brief Continuity of two curves at one end of each, on the way along a to its end and from the end of b
 * along b: a parameter that runs the other way changes its sign. The parameters are compared as they are; a
 * part of a curve at another speed meets with C^0 and G^2.
 * \param[in] a the curve that comes first.
 * \param[in] end_a where it is left, NURBS_END or NURBS_START.
 * \param[in] b the curve that follows, of the same dimension.
 * \param[in] end_b where it begins, NURBS_START or NURBS_END.
 * \param[in] position_tolerance,derivative_tolerance,angle_tolerance as for nurbs_continuity().
 * \param[out] order or NULL: the parametric order that holds, at most the higher of the two degrees.
 * \param[out] geometric or NULL: the geometric order that holds.
 * \param[out] position_gap or NULL: distance of the points.
 * \param[out] angle or NULL: angle between the tangents in radians, NaN where there is none.
 * \param[out] curvature_gap or NULL: length of the difference of the curvature vectors, NaN where there is
 *   none.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _END, _TOLERANCE; _INCOMPATIBLE if the dimensions differ.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_continuity_between(const nurbs *a, int32_t end_a, const nurbs *b, int32_t end_b,
                                                double position_tolerance, double derivative_tolerance,
                                                double angle_tolerance, int32_t *order, int32_t *geometric,
                                                double *position_gap, double *angle, double *curvature_gap);
/** @} */

/** \defgroup reduce Reduction
 * \code
 * double bound = 0; // no point moves by more
 * nurbs *fewer = NULL;
 * nurbs_reduce_knots(curve, 0, 1e-3, &bound, &fewer);
 * nurbs_destroy(fewer);
 * \endcode
 * Operations that move the shape. Each returns a proven bound of the distance to the given spline, in the
 * space of the points (Cartesian, also when rational). The bound holds at every parameter and includes the
 * rounding of its own computation, some 30 (degree + 1) eps times the size of the model. A tolerance below
 * that changes nothing. Distances are taken at equal parameters. Bounds come from Bernstein pieces of the
 * difference, whose numerators and denominators enclose it. The worst piece is subdivided until the largest
 * distance is known to a factor of 5/4.
 * @{ */

/** \brief Encloses the largest distance sup |f(t) - g(t)| of two splines over their domain, both limits at
 * jumps included. Degrees, knots and weights may differ, and either may be periodic or rational; axes,
 * dimension and domains have to agree. at_least <= sup <= at_most, both proven; at_most <= 5/4 at_least
 * apart from rounding, unless that takes more than 600 subdivisions. Weights may be 0; where the weights do
 * not let a denominator be shown to have no zero, at_most is infinite.
 * \param[in] f,g two splines.
 * \param[out] at_least or NULL: a distance that is reached.
 * \param[out] at_most or NULL: one that is not exceeded.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW; _INCOMPATIBLE if axes, dimensions or domains differ,
 *   _NOT_REPRESENTABLE if a coefficient overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_deviation(const nurbs *f, const nurbs *g, double *at_least, double *at_most);

/** \brief Removes copies of a knot as long as the shape moves by at most a tolerance (Tiller 1992). Only the
 * degree - multiplicity layers around the knot change; the residual of their equations is spread evenly, and
 * they are solved from the side on which every division is by 1/2 at least, homogeneous points when rational.
 * Of a knot of multiplicity degree + 1, at which the spline may jump, both sides become their mean. On a
 * periodic axis the copies a period away go too; the last copy of a knot at the seam stays, and so does a
 * knot of an axis with no more than degree - multiplicity + 1 distinct layers. A copy whose removal would
 * give a weight that is negative beyond rounding, or all weights 0, stays. Unless weights differ much, what
 * nurbs_insert_knot() put in goes again, and points return, within (20 * 2^p + 80 * sum over axes of p_k + 1)
 * eps * hull (tested).
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] knot the knot, inside the domain; on a periodic axis its ends too if they occur twice.
 * \param[in] times how often at most.
 * \param[in] tolerance largest distance from g, >= 0, may be infinite.
 * \param[out] removed or NULL: how often.
 * \param[out] bound or NULL: proven bound of the distance from g, at most the tolerance; 0 if nothing was
 *   removed.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _TIMES, _TOLERANCE,
 *   _OVERFLOW; _NOT_A_KNOT if there is no such knot, _END_KNOT if it is an end of the domain;
 *   _PERIODIC_KNOTS as for nurbs_elevate(); _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if
 *   weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_remove_knot(const nurbs *g, int32_t axis, double knot, int32_t times,
                                         double tolerance, int32_t *removed, double *bound, nurbs **out);

/** \brief Removes as many knots inside the domain as a tolerance allows (Lyche & Morken 1988; Piegl & Tiller
 * A9.8): always the one whose removal moves the shape least, with the moves added up span by span. The result
 * is certified against g, the moves it measures take the place of the sums, and the removal goes on until
 * nothing more goes. Ends of the domain stay knots, clamped ends keep their points bit for bit, and so do the
 * derivatives there within the tolerance only. The knots chosen do not change when points and tolerance are
 * multiplied by a power of two.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis, or -1 for every one, in their order, with an even share of the tolerance.
 * \param[in] tolerance largest distance from g, >= 0, may be infinite.
 * \param[out] bound or NULL: proven bound of the distance from g, at most the tolerance; 0 if nothing was
 *   removed.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _TOLERANCE, _OVERFLOW; _PERIODIC_KNOTS as for nurbs_elevate();
 *   _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_reduce_knots(const nurbs *g, int32_t axis, double tolerance, double *bound,
                                          nurbs **out);

/** \brief nurbs_reduce_knots() with progress reports, cancellation and a limit of work.
 * \param[in] g,axis,tolerance as for nurbs_reduce_knots().
 * \param[out] bound as for nurbs_reduce_knots().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_reduce_knots(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_reduce_knots_with(const nurbs *g, int32_t axis, double tolerance, double *bound,
                                               const nurbs_call_options *call, nurbs **out);

/** \brief Lowers the degree along an axis. The result has the same distinct knots, each `times` less often
 * but at least once, and its control points raised back to the degree of g are the closest to those of g:
 * least squares of coefficients (Lutterkort, Peters & Reif 1999), homogeneous points when rational, by a
 * banded QR factorisation. The ends of the shape are kept bit for bit, unless the degree becomes 0. Unclamped
 * ends are clamped first, a periodic axis stays periodic. Weights that are 0 to rounding become 0, their
 * control points the origin; one that has to lie at infinity makes the result homogeneous. What
 * nurbs_elevate() made comes back to within 2^p * 8 eps * hull, p the degree of the result (tested).
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] times by how much; 0 gives the same spline.
 * \param[out] bound or NULL: proven bound of the distance from g.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _TIMES, _OVERFLOW; _DEGREE if times exceeds the degree,
 *   _WEIGHT_SIGN if g has weights >= 0 and the result would not; _PERIODIC_KNOTS as for nurbs_elevate();
 *   _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_reduce_degree(const nurbs *g, int32_t axis, int32_t times, double *bound,
                                           nurbs **out);

/** \brief nurbs_reduce_degree() with progress reports, cancellation and a limit of work.
 * \param[in] g,axis,times as for nurbs_reduce_degree().
 * \param[out] bound as for nurbs_reduce_degree().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_reduce_degree(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_reduce_degree_with(const nurbs *g, int32_t axis, int32_t times, double *bound,
                                                const nurbs_call_options *call, nurbs **out);

/** \brief The simplest spline within a tolerance: weights are dropped if they may be, the degree of each axis
 * is lowered by nurbs_reduce_degree() as long as that stays within and leaves no more control points (but not
 * below 1, where steps would begin), and knots are removed by nurbs_reduce_knots(). The ends stay.
 * \param[in] g a spline.
 * \param[in] tolerance largest distance from g, >= 0, may be infinite.
 * \param[out] bound or NULL: proven bound of the distance from g, at most the tolerance; 0 if nothing
 *   changed.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _TOLERANCE, _OVERFLOW; _PERIODIC_KNOTS as for nurbs_elevate();
 *   _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_simplify(const nurbs *g, double tolerance, double *bound, nurbs **out);

/** \brief nurbs_simplify() with progress reports, cancellation and a limit of work.
 * \param[in] g,tolerance as for nurbs_simplify().
 * \param[out] bound as for nurbs_simplify().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_simplify(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_simplify_with(const nurbs *g, double tolerance, double *bound,
                                           const nurbs_call_options *call, nurbs **out);
/** @} */

/** \defgroup transform Transformations
 * \code
 * const double quarter_turn[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1}, shift[3] = {0, 0, 2};
 * nurbs *turned = NULL;
 * nurbs_transform(surface, 3, quarter_turn, shift, &turned);
 * nurbs_destroy(turned);
 * \endcode
 * @{ */

/** \brief Applies the affine map x -> A x + b to the control points, and with them to the shape:
 *
 *     y_i = A_i0 x_0 + ... + A_i(dim-1) x_(dim-1) + b_i,   0 <= i < out_dim.
 *
 * out_dim may differ from the dimension of g, which drops, adds or mixes coordinates. Knots and weights stay
 * bit for bit. Each coordinate of a control point is within (dim + 1) eps / 2 * (sum_j |A_ij x_j| + |b_i|) of
 * its exact value; rows of zeros and one entry 1 copy it. Control points that were built homogeneous are
 * mapped as A (w x) + w b.
 * \param[in] g a spline.
 * \param[in] out_dim dimension of the result.
 * \param[in] matrix [out_dim][dim] A, row by row.
 * \param[in] translation [out_dim] or NULL for 0: b.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _OVERFLOW; _MATRIX if an entry is not finite,
 *   _NOT_REPRESENTABLE if a coordinate, or its product with the weight, overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_transform(const nurbs *g, int32_t out_dim, const double *matrix,
                                       const double *translation, nurbs **out);

/** \brief Applies a projective map to the homogeneous control points h = (w x, w y, ..., w):
 *
 *     h'_i = M_i0 h_0 + ... + M_i(dim) h_dim,   0 <= i <= out_dim,
 *
 * which maps the shape by the quotients of the components by the last one. Knots stay bit for bit, weights
 * change, a polynomial spline becomes rational. A component is within (dim + 2) eps / 2 * sum_j |M_ij h_j| of
 * its exact value. If all new weights are positive, or all negative (then every sign is changed), the control
 * points are stored as Cartesian ones with weights, one division more; otherwise, and if g was built from
 * homogeneous points, as homogeneous ones: where the image passes through infinity evaluation yields the
 * infinities and NaNs of the division.
 * \param[in] g a spline.
 * \param[in] out_dim dimension of the result.
 * \param[in] matrix [out_dim + 1][dim + 1] M, row by row.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _OVERFLOW; _MATRIX if an entry is not finite,
 *   _WEIGHTS_VANISH if all new weights in the support of a span are 0, _NOT_REPRESENTABLE if a value
 *   overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_transform_projective(const nurbs *g, int32_t out_dim, const double *matrix,
                                                  nurbs **out);

/** \brief The mirror image in the plane (in 2D the line, in general the hyperplane) through a point:
 * x -> x - 2 n (n . (x - point)) / (n . n). An affine map, applied as by nurbs_transform(): its entries are
 * exact to a few eps, so that coordinates are within 8 (dim + 2) eps of the size of x and point, and exact
 * where the normal is along an axis and its component of x and twice that of point add up exactly.
 * \param[in] g a spline.
 * \param[in] point [dim] a point of the plane.
 * \param[in] normal [dim] of any length but 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _POINT_NOT_FINITE; _DIRECTION if the normal is 0 or not finite,
 *   _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_mirror(const nurbs *g, const double *point, const double *normal, nurbs **out);

/** \brief Projects a spline to the plane (line, hyperplane) through a point, along a direction:
 * x -> x - d (n . (x - point)) / (n . d). The dimension stays; rounding as for nurbs_mirror(), times
 * (|n| |d| / |n . d|)^2 where the direction is oblique.
 * \param[in] g a spline.
 * \param[in] point [dim] a point of the plane.
 * \param[in] normal [dim] of any length but 0.
 * \param[in] direction [dim] or NULL for the normal: d, of any length but 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _POINT_NOT_FINITE; _DIRECTION if the normal or the direction is 0 or
 *   not finite, or the direction parallel to the plane to rounding; _NOT_REPRESENTABLE if a coordinate
 *   overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_project_to_plane(const nurbs *g, const double *point, const double *normal,
                                              const double *direction, nurbs **out);

/** \brief Projects a spline from an eye to the plane (line, hyperplane) through a point, in perspective:
 * x -> eye + (x - eye) (n . (point - eye)) / (n . (x - eye)). A projective map, applied as by
 * nurbs_transform_projective(): the result is rational, its weights are multiplied by n . (x - eye), with n
 * brought near length 1 by a power of 2. Where control points lie on both sides of the eye weights have both
 * signs.
 * \param[in] g a spline.
 * \param[in] eye [dim] from where.
 * \param[in] point [dim] a point of the plane.
 * \param[in] normal [dim] of any length but 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _POINT_NOT_FINITE; _DIRECTION if the normal is 0 or not finite, or the
 *   eye lies in the plane to rounding; _WEIGHTS_VANISH, _NOT_REPRESENTABLE as for
 *   nurbs_transform_projective().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_project_from(const nurbs *g, const double *eye, const double *point,
                                          const double *normal, nurbs **out);
/** @} */

/** \defgroup curves Lines, conics and helices
 * \code
 * nurbs *circle = NULL;
 * nurbs_curve_circle(2, NULL, NULL, NULL, 1.0, NURBS_ARC_QUARTERS, &circle); // the unit circle of the plane
 * nurbs_destroy(circle);
 * \endcode
 * Curves that are defined by a few numbers. All are clamped and run over [0, 1] unless their text says
 * otherwise; a spline with all weights equal is polynomial.
 *
 * A **placement** is an origin, an axis and a direction x. In dimension 3 the unit vectors Z = axis /
 * |axis|, X = the part of x that is perpendicular to the axis, over its length, and Y = Z x X are the frame
 * of the shape; axis NULL is (0, 0, 1), and x NULL the coordinate direction of the smallest component of
 * the axis (the first of equal ones) for x, but (1, 0, 0) with axis NULL. In dimension 2 axis must be NULL,
 * Y is X turned a quarter to the left, and x NULL is (1, 0). An origin that is NULL is 0. For other
 * dimensions see nurbs_transform(), which is exact for all of these shapes.
 *
 * **Angles** are in radians, counted from X towards Y. They are in proportion to the parameter where pieces
 * join, and nearly so, not exactly, between (see nurbs_curve_params_at_lengths() for points at even lengths).
 * A sweep is not 0 and at most a full turn either way; one that is a multiple of 15 degrees to within 4 units
 * of rounding is taken for that multiple, and so are starts. Cosines and sines that are 0, 1/2 or 1 are exact
 * then, and full turns end where they begin, bit for bit. No angle may be above 2^22.
 *
 * Distances of evaluated points to the true shape stay within 4 eps * size (tested), size being the largest
 * coordinate among the control points. For curves by points and tangents the true shape is the one that the
 * numbers given determine, however near to degenerate they are: they are solved in twice the precision. In
 * dimensions above 2 the plane of the points is rounded, which counts as rounding of their coordinates.
 * @{ */

/** \name Forms of an arc
 * @{ */
#define NURBS_ARC_QUARTERS 0 /**< degree 2, equal pieces of at most a quarter turn */
#define NURBS_ARC_THIRDS 1   /**< degree 2, equal pieces of at most a third of a turn */
/** \brief One polynomial piece: degree 2 up to a third of a turn, degree 5 beyond; weights are positive. */
#define NURBS_ARC_SMOOTH 2
/** @} */

/** \name Kinds of conics
 * @{ */
#define NURBS_CONIC_ELLIPSE 1   /**< shape factor below 1 */
#define NURBS_CONIC_PARABOLA 2  /**< shape factor 1 */
#define NURBS_CONIC_HYPERBOLA 3 /**< shape factor above 1 */
#define NURBS_CONIC_CHORD 4     /**< degenerate: shape factor 0, the segment P0 P2 */
#define NURBS_CONIC_LEGS 5      /**< degenerate: shape factor infinite, the segments P0 P1 and P1 P2 */
#define NURBS_CONIC_LINE 6      /**< degenerate: P0, P1 and P2 on a line */
/** @} */

/** \brief The segment (1 - t) a + t b, of degree 1.
 * \param[in] dim dimension, at least 1.
 * \param[in] a,b [dim] its ends.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_line(int32_t dim, const double *a, const double *b, nurbs **out);

/** \brief The polyline through n points, of degree 1, with one knot for each point.
 * \param[in] n number of points, at least 2.
 * \param[in] dim dimension, at least 1.
 * \param[in] points [n][dim] its corners in order; for a closed one the last is the first.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] params [n] or NULL for 0, 1, ..., n - 1: the parameters of the points, increasing.
 * \param[in] param_stride distance between parameters, 0 = 1.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _TOO_FEW_POINTS, _DIMENSION, _STRIDE, _POINT_NOT_FINITE,
 *   _PARAMETER_NOT_FINITE; _KNOTS_DECREASING if a parameter is not above the one before it,
 *   _KNOT_NOT_FINITE if their range overflows, _OVERFLOW.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_polyline(int64_t n, int32_t dim, const double *points,
                                            int64_t point_stride, int64_t point_component_stride,
                                            const double *params, int64_t param_stride, nurbs **out);

/** \brief A closed regular polygon, of degree 1, counterclockwise about the axis. Its corners are at the
 * angles 2 pi i / sides; the parameter is i / sides there.
 * \param[in] dim 2 or 3.
 * \param[in] center,axis,x [dim] or NULL: placement.
 * \param[in] radius distance of the corners from the centre, > 0.
 * \param[in] sides number of sides, at least 3.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _DIRECTION, _POINT_NOT_FINITE, _COUNT, _OVERFLOW; _LENGTH
 *   if the radius is not finite or not positive, _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_polygon(int32_t dim, const double *center, const double *axis,
                                           const double *x, double radius, int64_t sides, nurbs **out);

/** \brief A closed rectangle with sides along X and Y whose corners are rounded by quarter circles, of
 * degree 2, counterclockwise about the axis, beginning at the start of its lower side. Sides that the
 * corners leave no length are left out; with corner_radius 0 the rectangle has degree 1. Knots are spaced
 * evenly.
 * \param[in] dim 2 or 3.
 * \param[in] center,axis,x [dim] or NULL: placement; the centre is that of the rectangle.
 * \param[in] width,height lengths of the sides along X and Y, > 0.
 * \param[in] corner_radius 0 to half of the smaller side.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _DIRECTION, _POINT_NOT_FINITE; _LENGTH if width, height
 *   or corner_radius is not finite or out of range, _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_rounded_rectangle(int32_t dim, const double *center, const double *axis,
                                                     const double *x, double width, double height,
                                                     double corner_radius, nurbs **out);

/** \brief The full circle, from the direction X counterclockwise about the axis: nurbs_curve_arc() over a
 * full turn. With NURBS_ARC_QUARTERS it has 9 control points, with NURBS_ARC_THIRDS 7, with
 * NURBS_ARC_SMOOTH 6.
 * \param[in] dim 2 or 3.
 * \param[in] center,axis,x [dim] or NULL: placement.
 * \param[in] radius > 0.
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _DIRECTION, _POINT_NOT_FINITE, _FORM; _LENGTH if the
 *   radius is not finite or not positive, _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_circle(int32_t dim, const double *center, const double *axis,
                                          const double *x, double radius, int32_t form, nurbs **out);

/** \brief A circular arc: center + radius (X cos a + Y sin a), a from start to start + sweep. A piece of
 * angle d has the weights 1, cos(d / 2), 1 and its middle control point where its end tangents meet.
 * \param[in] dim 2 or 3.
 * \param[in] center,axis,x [dim] or NULL: placement.
 * \param[in] radius > 0.
 * \param[in] start,sweep angles; a negative sweep runs clockwise.
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _DIRECTION, _POINT_NOT_FINITE, _FORM; _LENGTH if the
 *   radius is not finite or not positive, _ANGLE if start or sweep is not finite or above 2^22, or sweep is
 *   0 or more than a full turn; _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_arc(int32_t dim, const double *center, const double *axis, const double *x,
                                       double radius, double start, double sweep, int32_t form, nurbs **out);

/** \brief The circular arc from a through b to c. Its ends are a and c bit for bit.
 * \param[in] dim dimension, at least 2.
 * \param[in] a,b,c [dim] three points that are not on a line.
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE, _FORM; _COLLINEAR if the points are on
 *   a line to within rounding, or two are equal; _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_arc_through(int32_t dim, const double *a, const double *b, const double *c,
                                               int32_t form, nurbs **out);

/** \brief The circular arc that leaves a in the direction of a tangent and ends at b. Its ends are a and b
 * bit for bit.
 * \param[in] dim dimension, at least 2.
 * \param[in] a [dim] start.
 * \param[in] tangent [dim] direction at a, of any length.
 * \param[in] b [dim] end.
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE, _FORM; _DIRECTION if the tangent is
 *   zero or not finite, _COLLINEAR if a and b are equal or b lies on the tangent to within rounding,
 *   _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_arc_tangent(int32_t dim, const double *a, const double *tangent,
                                               const double *b, int32_t form, nurbs **out);

/** \brief An elliptic arc: center + radius_x X cos a + radius_y Y sin a, a from start to start + sweep; a is
 * the eccentric angle, not that of the point seen from the centre.
 * \param[in] dim 2 or 3.
 * \param[in] center,axis,x [dim] or NULL: placement.
 * \param[in] radius_x,radius_y semi-axes, > 0, in any order.
 * \param[in] start,sweep angles, as for nurbs_curve_arc().
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle.
 * \return as for nurbs_curve_arc().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_ellipse(int32_t dim, const double *center, const double *axis,
                                           const double *x, double radius_x, double radius_y, double start,
                                           double sweep, int32_t form, nurbs **out);

/** \brief A parabolic arc, polynomial of degree 2 over [start, end]: vertex + t^2 / (4 focal_length) X + t
 * Y, so that the parameter is the coordinate along Y.
 * \param[in] dim 2 or 3.
 * \param[in] vertex,axis,x [dim] or NULL: placement; X points to the focus.
 * \param[in] focal_length distance from the vertex to the focus, > 0.
 * \param[in] start,end the domain, start < end.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _DIRECTION, _POINT_NOT_FINITE, _PARAMETER_NOT_FINITE,
 *   _EMPTY_DOMAIN; _LENGTH if the focal length is not finite or not positive, _NOT_REPRESENTABLE if a
 *   coordinate, _KNOT_NOT_FINITE if end - start overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_parabola(int32_t dim, const double *vertex, const double *axis,
                                            const double *x, double focal_length, double start, double end,
                                            nurbs **out);

/** \brief An arc of the branch of a hyperbola that opens to X: center + radius_x X cosh u + radius_y Y sinh
 * u, u from start to end. A piece that spans d in u has the weights 1, cosh(d / 2), 1; pieces of degree 2
 * are of equal length in u, at most 2.
 * \param[in] dim 2 or 3.
 * \param[in] center,axis,x [dim] or NULL: placement.
 * \param[in] radius_x,radius_y semi-axes, > 0; the asymptotes are Y = +-(radius_y / radius_x) X.
 * \param[in] start,end values of u, start < end.
 * \param[out] out the new handle.
 * \return as for nurbs_curve_parabola(), but _NOT_REPRESENTABLE also if end - start overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_hyperbola(int32_t dim, const double *center, const double *axis,
                                             const double *x, double radius_x, double radius_y, double start,
                                             double end, nurbs **out);

/** \brief The conic with a control triangle and a shape factor C_sf = w1^2 / (w0 w2): degree 2, the weights
 * 1, sqrt(C_sf), 1. It is an arc of an ellipse where C_sf < 1, of a parabola (polynomial) where C_sf = 1,
 * of a hyperbola where C_sf > 1. C_sf = 0 gives the chord p0 p2, an infinite one the legs p0 p1 p2, both of
 * degree 1. For a shoulder point at the part rho of the way from the middle of the chord to p1, C_sf is
 * (rho / (1 - rho))^2.
 * \param[in] dim dimension, at least 1.
 * \param[in] p0,p1,p2 [dim] the triangle; p0 and p2 are the ends, bit for bit.
 * \param[in] shape_factor C_sf >= 0, possibly infinite.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE; _FACTOR if C_sf is negative or NaN,
 *   _NOT_REPRESENTABLE if a weight times a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_conic_triangle(int32_t dim, const double *p0, const double *p1,
                                                  const double *p2, double shape_factor, nurbs **out);

/** \brief The conic arc that leaves a in one direction and arrives at b in another one, and whose shoulder
 * point is at the part rho of the way from the middle of the chord to the point where the tangents meet: an
 * ellipse where rho < 1/2, a parabola where rho = 1/2, a hyperbola where rho > 1/2.
 * \param[in] dim dimension, at least 2.
 * \param[in] a [dim] start.
 * \param[in] tangent_a [dim] direction at a.
 * \param[in] b [dim] end.
 * \param[in] tangent_b [dim] direction of the arc at b.
 * \param[in] rho 0 <= rho < 1.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE; _DIRECTION if a tangent is zero or not
 *   finite, _FACTOR if rho is out of range; _CONIC if the tangents are parallel, do not meet in one point
 *   to within rounding, or meet before a or beyond b; _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_conic_shoulder(int32_t dim, const double *a, const double *tangent_a,
                                                  const double *b, const double *tangent_b, double rho,
                                                  nurbs **out);

/** \brief The conic arc from a to b with given tangent lines at both ends that passes through a third point;
 * degree 2, in pieces of which none turns by more than the form allows in the affine picture in which it is
 * a circle. The lines may be parallel (half an ellipse), and the arc may be more than half an ellipse.
 * Piegl & Tiller, The NURBS Book, 7.5.
 * \param[in] dim dimension, at least 2.
 * \param[in] a [dim] start.
 * \param[in] tangent_a [dim] a direction of the tangent line at a, either way.
 * \param[in] b [dim] end.
 * \param[in] tangent_b [dim] a direction of the tangent line at b, either way.
 * \param[in] point [dim] a point of the arc between a and b.
 * \param[in] form NURBS_ARC_QUARTERS or NURBS_ARC_THIRDS.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE, _FORM; _DIRECTION if a tangent is zero
 *   or not finite, _COLLINEAR if a, b and the point are on a line to within rounding; _CONIC if the
 *   tangents and the point are not in one plane to within rounding, or no arc in one piece passes through
 *   the point; _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_conic_point(int32_t dim, const double *a, const double *tangent_a,
                                               const double *b, const double *tangent_b, const double *point,
                                               int32_t form, nurbs **out);

/** \brief The conic arc through five points, from the first to the last in this order; tangents at its ends
 * by Pascal's theorem, pieces as for nurbs_curve_conic_point().
 * \param[in] dim dimension, at least 2.
 * \param[in] points [5][dim] no three on a line.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] form NURBS_ARC_QUARTERS or NURBS_ARC_THIRDS.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _OVERFLOW, _STRIDE, _POINT_NOT_FINITE, _FORM; _COLLINEAR if
 *   three points are on a line to within rounding; _CONIC if they are not in one plane to within rounding,
 *   or not on one arc in this order; _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_conic_through(int32_t dim, const double *points, int64_t point_stride,
                                                 int64_t point_component_stride, int32_t form, nurbs **out);

/** \brief Kind and axes of the conic A x^2 + B x y + C y^2 + D x + E y + F = 0, from its principal axes. An
 * ellipse has its centre and semi-axes sizes[0] >= sizes[1], x along the longer one; a hyperbola its
 * centre, x towards a vertex, semi-axes sizes[0] along x and sizes[1] across; for both x[0] > 0 or x = (0,
 * 1). A parabola has its vertex, x towards the focus, and the focal length sizes[0], sizes[1] = 0. The kind
 * is that of the sign of B^2 - 4 A C, computed exactly; an equation of lines or a point is one whose
 * determinant is 0 to within 100 eps^2 of its terms. The equation of the axes is the one given to 16 eps of
 * the terms of each coefficient (tested).
 * \param[in] coefficients [6] A, B, C, D, E, F.
 * \param[out] type NURBS_CONIC_ELLIPSE, _PARABOLA or _HYPERBOLA.
 * \param[out] origin [2] centre or vertex.
 * \param[out] x [2] unit direction.
 * \param[out] sizes [2] semi-axes or focal length.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP; _FACTOR if a coefficient is not finite; _CONIC if the
 *   equation describes no curve of these kinds: no points, one point, or lines; _NOT_REPRESENTABLE if a
 *   value overflows or a size underflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_conic_axes(const double *coefficients, int32_t *type, double *origin, double *x,
                                        double *sizes);

/** \brief An arc of the conic with an implicit equation, as described by nurbs_conic_axes(): of an ellipse
 * as nurbs_curve_ellipse() with start and sweep = end - start, of a parabola and a hyperbola (the branch
 * towards x) as nurbs_curve_parabola() and nurbs_curve_hyperbola() from start to end.
 * \param[in] coefficients [6] A, B, C, D, E, F.
 * \param[in] start,end range of the parameter of that curve.
 * \param[in] form one of the NURBS_ARC_ constants; used for ellipses.
 * \param[out] out the new handle, of dimension 2.
 * \return NURBS_OK, NURBS_ERROR_NULL, _FACTOR, _CONIC, _NOT_REPRESENTABLE as for nurbs_conic_axes(); for
 *   ellipses _ANGLE, _FORM, for the others _PARAMETER_NOT_FINITE, _EMPTY_DOMAIN, _KNOT_NOT_FINITE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_conic_implicit(const double *coefficients, double start, double end,
                                                  int32_t form, nurbs **out);

/** \brief An arc of the conic with a focus, a directrix and an eccentricity e: the points whose distance
 * from the focus is e times that from the directrix, at angles about the focus from start to start + sweep,
 * counted from the foot of the perpendicular to the directrix; r(a) = e d / (1 + e cos a) where d = |foot -
 * focus|. The parameter is that of the rational quadratic pieces.
 * \param[in] dim 2 or 3.
 * \param[in] focus [dim] the focus.
 * \param[in] axis [dim] or NULL for (0, 0, 1), and in dimension 2 for what is needed: normal of the plane in
 *   dimension 3; its part across foot - focus counts.
 * \param[in] foot [dim] the point of the directrix that is nearest to the focus; the directrix is
 *   perpendicular to the line from the focus to it.
 * \param[in] eccentricity e > 0.
 * \param[in] start,sweep angles; on the way 1 + e cos a must stay positive.
 * \param[in] form NURBS_ARC_QUARTERS or NURBS_ARC_THIRDS.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE, _DIRECTION (foot = focus, or an axis
 *   that is parallel to foot - focus to within rounding), _FORM, _ANGLE, _NOT_REPRESENTABLE; _FACTOR if e
 *   is not finite or not positive; _CONIC if the angles reach infinity.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_conic_focus(int32_t dim, const double *focus, const double *axis,
                                               const double *foot, double eccentricity, double start,
                                               double sweep, int32_t form, nurbs **out);

/** \brief Shape factor C_sf = w1^2 / (w0 w2) and kind of a conic segment: a curve of degree 2 with one
 * polynomial piece. The weights are those of its Bezier form. The kind is decided exactly for the stored
 * weights, unless the piece is unclamped: then for its Bezier weights as computed. A middle control point
 * at infinity (of weight 0) makes half an ellipse, not a chord.
 * \param[in] g a curve of degree 2 with 3 control points.
 * \param[out] factor C_sf; infinite if it overflows.
 * \param[out] type one of the NURBS_CONIC_ constants but NURBS_CONIC_LEGS; NURBS_CONIC_LINE if the control
 *   points are on a line to within 4 eps of the largest coordinate, which comes before all others.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP; _AXES if g is no curve, _DEGREE if its degree is not 2,
 *   _COUNT if it has several pieces, _WEIGHT_SIGN if an end weight is not positive.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_shape_factor(const nurbs *g, double *factor, int32_t *type);

/** \brief A circular helix or Archimedean spiral to a tolerance. With turns n the curve is, for a from start
 * to start + 2 pi n,
 *
 *     origin + r(a) (X cos a + Y sin a) + pitch (a - start) / (2 pi) Z,
 *     r(a) = radius + growth (a - start) / (2 pi),
 *
 * growth != 0 making it a conical helix, and in dimension 2, where pitch is 0, a spiral. Pieces are equal,
 * at most a quarter turn each, of degree 6 (8 where growth is not 0), and join with their tangents and
 * curvatures. Every point is at an angle exactly as on an arc, so that a helix lies on its cylinder and a
 * conical one on its cone; only how far along it the point stands is approximated: the error for pieces of
 * angle d is at most 0.2176 tan(d / 4)^7 times the way gone by radius and pitch for each radian. The domain
 * is [0, turns]; joints of pieces are points of the true curve.
 * \param[in] dim 2 or 3.
 * \param[in] origin,axis,x [dim] or NULL: placement.
 * \param[in] radius at the start, >= 0, and > 0 where growth is 0.
 * \param[in] growth change of the radius in a turn; the radius at the end must be >= 0, too.
 * \param[in] pitch rise along the axis in a turn; 0 in dimension 2.
 * \param[in] start angle at which the curve begins.
 * \param[in] turns number of turns, > 0.
 * \param[in] tolerance largest distance between the curve and the true one at the same angle, > 0 and
 *   finite.
 * \param[out] error or NULL: a proven bound of that distance, rounding left out.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _DIRECTION, _POINT_NOT_FINITE, _ANGLE, _TOLERANCE,
 *   _LENGTH if a length is not finite or a radius is out of range, _FACTOR if the turns are,
 *   _NOT_REPRESENTABLE if a coordinate overflows; _OVERFLOW also if the tolerance asks for 2^40 pieces.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_helix(int32_t dim, const double *origin, const double *axis,
                                         const double *x, double radius, double growth, double pitch,
                                         double start, double turns, double tolerance, double *error,
                                         nurbs **out);
/** @} */

/** \defgroup shapes Surfaces and volumes from curves
 * \code
 * const double up[] = {0, 0, 1};
 * nurbs *wall = NULL;
 * nurbs_extrude(curve, up, &wall);
 * nurbs_destroy(wall);
 * \endcode
 * Exact constructions. Domains of given splines are kept, new axes run over [0, 1]. Placements, angles and
 * forms of arcs are those of the curves. Shapes of revolution have the angle as axis 0, and a normal S_u x
 * S_v that points outwards where the sweep is positive.
 *
 * With size the largest coordinate among the control points, evaluated points lie within 4 eps * size of the
 * true sphere, cylinder, cone or torus, and within 5 eps * size of the other quadrics (tested). A shape made
 * of splines has the weights and Cartesian control points of its formula. Each product and sum of the formula
 * is rounded once; revolved shapes are rounded once in all; ruled shapes are also moved by what makes their
 * splines compatible.
 * @{ */

/** \name Flags of constructions
 * @{ */
/** \brief nurbs_ruled(): rulings of Cartesian points, divided evenly, not those of homogeneous ones. */
#define NURBS_RULED_CARTESIAN 0x80000000u
/** \brief nurbs_surface_sphere_patches(): the half towards Z. */
#define NURBS_HEMISPHERE 0x01000000u
/** \brief nurbs_surface_hyperboloid(): the hyperboloid of two sheets. */
#define NURBS_TWO_SHEETS 0x02000000u
/** @} */

/** \brief Moves a curve or surface along a vector: (u, v) -> g(u) + v vector, the new axis last, of degree 1
 * over [0, 1]. A plane curve moves in its plane: nurbs_transform() with a matrix of 3 x 2 lifts it into
 * space.
 * \param[in] g a spline of 1 or 2 axes.
 * \param[in] vector [dim] the way, not 0.
 * \param[out] out the new handle, with one axis more.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW; _AXES if g is a volume, _DIRECTION if the vector is zero
 *   or not finite, _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_extrude(const nurbs *g, const double *vector, nurbs **out);

/** \brief Turns a curve or surface in space about an axis, the angle as a new axis 0 over [0, 1]. At the
 * angle 0 it is g itself, bit for bit where it has Cartesian points. A control point at the distance r from
 * the axis goes along the control points of an arc of radius r; weights are multiplied (Piegl & Tiller
 * 8.5).
 * \param[in] g a spline of 1 or 2 axes and dimension 3.
 * \param[in] point [3] or NULL for the origin: a point of the axis.
 * \param[in] axis [3] or NULL for (0, 0, 1): its direction.
 * \param[in] sweep angle, right-handed about the axis.
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle, with one axis more.
 * \return NURBS_OK, NURBS_ERROR_NULL, _POINT_NOT_FINITE, _FORM, _ANGLE, _OVERFLOW; _AXES if g is a volume,
 *   _DIMENSION if its dimension is not 3, _DIRECTION if the axis is zero or not finite, _NOT_REPRESENTABLE
 *   if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_revolve(const nurbs *g, const double *point, const double *axis, double sweep,
                                     int32_t form, nurbs **out);

/** \brief The surface of straight lines between curves, or the volume between surfaces, with a new last axis
 * v over [0, 1]. Both are brought to one degree and one knot vector as by nurbs_make_compatible() with
 * tolerance 0, the domain of b being mapped to that of a. By default homogeneous points are divided, the
 * usual NURBS ruling (degree 1 in v, rulings divided unevenly where the weights differ); with
 * NURBS_RULED_CARTESIAN the point is (1 - v) a(u) + v b(u), over the product of the denominators where the
 * weights differ.
 * \param[in] a,b splines of 1 or 2 axes, as many in both, and of the same dimension.
 * \param[in] flags NURBS_RULED_CARTESIAN, or 0.
 * \param[out] out the new handle, with one axis more; a at v = 0, b at v = 1.
 * \return NURBS_OK, NURBS_ERROR_NULL, _FLAGS, _OVERFLOW; _AXES if a is a volume, _INCOMPATIBLE if the
 *   numbers of axes differ, _DIMENSION if the dimensions do, _DEGREE if degrees add up to more than
 *   NURBS_MAX_DEGREE, _KNOTS_MERGE as for nurbs_reparametrize(), _PERIODIC_KNOTS, _NOT_REPRESENTABLE,
 *   _WEIGHTS_VANISH.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_ruled(const nurbs *a, const nurbs *b, uint32_t flags, nurbs **out);

/** \brief The translational sweep alpha a(u) + beta b(v), the axes of b after those of a. The weights are
 * products, so that the sum is one of Cartesian points.
 * \param[in] a,b splines of the same dimension with at most NURBS_MAX_AXES axes together.
 * \param[in] alpha,beta finite factors.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW; _AXES if there are too many axes, _DIMENSION if the
 *   dimensions differ, _FACTOR if alpha or beta is not finite, _NOT_REPRESENTABLE if a value overflows,
 *   _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_tensor_sum(const nurbs *a, double alpha, const nurbs *b, double beta,
                                        nurbs **out);

/** \brief The product a(u) b(v), component by component, the axes of b after those of a; one of them may
 * have dimension 1 and multiplies all components of the other.
 * \param[in] a,b splines with at most NURBS_MAX_AXES axes together.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW; _AXES if there are too many axes, _DIMENSION if the
 *   dimensions do not suit, _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_tensor_product(const nurbs *a, const nurbs *b, nurbs **out);

/** \brief A swung surface: (u, v) -> (scale r(v) x(u), scale r(v) y(u), z(v)) for the trajectory (x, y) and
 * the profile (r, z). A circle about the origin as trajectory gives the surface of revolution (Woodward
 * 1987; Piegl & Tiller 10.3).
 * \param[in] trajectory a curve of dimension 2, axis 0 of the result.
 * \param[in] profile a curve of dimension 2, axis 1 of the result.
 * \param[in] scale finite, not 0.
 * \param[out] out the new handle, of dimension 3.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW; _AXES if one is no curve, _DIMENSION if its dimension is
 *   not 2, _FACTOR if the scale is not finite or is 0, _NOT_REPRESENTABLE if a value overflows,
 *   _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_swung(const nurbs *trajectory, const nurbs *profile, double scale,
                                           nurbs **out);

/** \brief The parallelogram origin + s u + t v, of degree 1 on both axes.
 * \param[in] dim dimension, at least 2.
 * \param[in] origin [dim] or NULL for 0: a corner.
 * \param[in] u,v [dim] two sides.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE; _DIRECTION if a side is zero, not
 *   finite, or parallel to the other one to within rounding; _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_plane(int32_t dim, const double *origin, const double *u,
                                           const double *v, nurbs **out);

/** \brief The bilinear patch over four corners, of degree 1 on both axes.
 * \param[in] dim dimension, at least 1.
 * \param[in] corners [4][dim] the points at (0, 0), (0, 1), (1, 0) and (1, 1).
 * \param[in] corner_stride,corner_component_stride layout of corners, 0 = packed.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _OVERFLOW, _STRIDE, _POINT_NOT_FINITE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_bilinear(int32_t dim, const double *corners, int64_t corner_stride,
                                              int64_t corner_component_stride, nurbs **out);

/** \brief The trilinear volume over eight corners, of degree 1 on all axes.
 * \param[in] dim dimension, at least 1.
 * \param[in] corners [8][dim] the points at (0, 0, 0), (0, 0, 1), (0, 1, 0), ..., (1, 1, 1).
 * \param[in] corner_stride,corner_component_stride layout of corners, 0 = packed.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _OVERFLOW, _STRIDE, _POINT_NOT_FINITE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_volume_trilinear(int32_t dim, const double *corners, int64_t corner_stride,
                                              int64_t corner_component_stride, nurbs **out);

/** \brief The whole sphere by longitude (axis 0) and latitude (axis 1, from the pole -Z to the pole Z); its
 * poles are collapsed edges, its seam closes bit for bit.
 * \param[in] center,axis,x [3] or NULL: placement.
 * \param[in] radius > 0.
 * \param[in] form one of the NURBS_ARC_ constants, for both axes.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIRECTION, _POINT_NOT_FINITE, _FORM; _LENGTH if the radius is not
 *   finite or not positive, _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_sphere(const double *center, const double *axis, const double *x,
                                            double radius, int32_t form, nurbs **out);

/** \brief A patch of a sphere between two meridians and two circles of latitude.
 * \param[in] center,axis,x [3] or NULL: placement.
 * \param[in] radius > 0.
 * \param[in] start,sweep longitudes, as for nurbs_curve_arc().
 * \param[in] south,north latitudes, -pi/2 <= south < north <= pi/2; a hemisphere is 0, pi/2.
 * \param[in] form one of the NURBS_ARC_ constants, for both axes.
 * \param[out] out the new handle.
 * \return as for nurbs_surface_sphere(), and NURBS_ERROR_ANGLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_spherical_patch(const double *center, const double *axis,
                                                     const double *x, double radius, double start,
                                                     double sweep, double south, double north, int32_t form,
                                                     nurbs **out);

/** \brief The sphere without poles: six patches of degree 4 x 4 over the faces of a cube, each bounded by
 * arcs of great circles, without a singular point (after Cobb 1988). Neighbours share their edge curves bit
 * for bit, up to direction. The names in the list are "+X", "+Y", "-X", "-Y", "+Z", "-Z". With
 * NURBS_HEMISPHERE the half towards Z: "+Z" whole, and the upper halves of "+X", "+Y", "-X", "-Y".
 * \param[in] center,axis,x [3] or NULL: placement.
 * \param[in] radius > 0.
 * \param[in] flags NURBS_HEMISPHERE, or 0.
 * \param[out] out the new list.
 * \return as for nurbs_surface_sphere(), _FLAGS instead of _FORM.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_sphere_patches(const double *center, const double *axis, const double *x,
                                                    double radius, uint32_t flags, nurbs_list **out);

/** \brief The whole ellipsoid with semi-axes along X, Y and Z, parametrized as nurbs_surface_sphere().
 * \param[in] center,axis,x [3] or NULL: placement.
 * \param[in] radius_x,radius_y,radius_z semi-axes, > 0.
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle.
 * \return as for nurbs_surface_sphere().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_ellipsoid(const double *center, const double *axis, const double *x,
                                               double radius_x, double radius_y, double radius_z,
                                               int32_t form, nurbs **out);

/** \brief A circular cylinder: origin + radius (X cos a + Y sin a) + v height Z. Axis 0 is the angle, axis
 * 1, of degree 1, the height.
 * \param[in] origin,axis,x [3] or NULL: placement; the origin is the centre of the base.
 * \param[in] radius,height > 0.
 * \param[in] start,sweep angles, as for nurbs_curve_arc().
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIRECTION, _POINT_NOT_FINITE, _FORM, _ANGLE; _LENGTH if a length is
 *   not finite or out of range, _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_cylinder(const double *origin, const double *axis, const double *x,
                                              double radius, double height, double start, double sweep,
                                              int32_t form, nurbs **out);

/** \brief A circular cone or its frustum, parametrized as nurbs_surface_cylinder(), with a radius that
 * changes from base_radius at the origin to top_radius at origin + height Z.
 * \param[in] origin,axis,x [3] or NULL: placement; the origin is the centre of the base.
 * \param[in] base_radius,top_radius >= 0, not equal; where one is 0 the apex is a collapsed edge.
 * \param[in] height > 0.
 * \param[in] start,sweep angles, as for nurbs_curve_arc().
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle.
 * \return as for nurbs_surface_cylinder().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_cone(const double *origin, const double *axis, const double *x,
                                          double base_radius, double top_radius, double height, double start,
                                          double sweep, int32_t form, nurbs **out);

/** \brief A torus: (R + r cos b) (X cos a + Y sin a) + r sin b Z about the centre. Axis 0 is the angle a
 * about the axis, axis 1 the angle b about the tube, counted from the outer equator upwards. Where r > R it
 * cuts itself.
 * \param[in] center,axis,x [3] or NULL: placement.
 * \param[in] major_radius,minor_radius R, r > 0.
 * \param[in] start,sweep angles a.
 * \param[in] tube_start,tube_sweep angles b.
 * \param[in] form one of the NURBS_ARC_ constants, for both axes.
 * \param[out] out the new handle.
 * \return as for nurbs_surface_cylinder().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_torus(const double *center, const double *axis, const double *x,
                                           double major_radius, double minor_radius, double start,
                                           double sweep, double tube_start, double tube_sweep, int32_t form,
                                           nurbs **out);

/** \brief A bowl of the elliptic paraboloid Z = height ((X / radius_x)^2 + (Y / radius_y)^2), from the
 * vertex, a collapsed edge, at v = 0 to the rim at v = 1, Z = height v^2. Axis 0 is the angle.
 * \param[in] vertex,axis,x [3] or NULL: placement.
 * \param[in] radius_x,radius_y semi-axes of the rim, > 0.
 * \param[in] height > 0.
 * \param[in] start,sweep angles, as for nurbs_curve_ellipse().
 * \param[in] form one of the NURBS_ARC_ constants.
 * \param[out] out the new handle.
 * \return as for nurbs_surface_cylinder().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_paraboloid(const double *vertex, const double *axis, const double *x,
                                                double radius_x, double radius_y, double height, double start,
                                                double sweep, int32_t form, nurbs **out);

/** \brief A saddle of the hyperbolic paraboloid Z = height ((X / radius_x)^2 - (Y / radius_y)^2) over the
 * rectangle |X| <= radius_x, |Y| <= radius_y: polynomial, of degree 2 on both axes, X along axis 0 and Y
 * along axis 1.
 * \param[in] center,axis,x [3] or NULL: placement.
 * \param[in] radius_x,radius_y,height > 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIRECTION, _POINT_NOT_FINITE; _LENGTH if a length is not finite or
 *   not positive, _NOT_REPRESENTABLE if a coordinate overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_saddle(const double *center, const double *axis, const double *x,
                                            double radius_x, double radius_y, double height, nurbs **out);

/** \brief A band of the hyperboloid (X / radius_x)^2 + (Y / radius_y)^2 - (Z / radius_z)^2 = 1 between two
 * planes Z = bottom and Z = top; or with NURBS_TWO_SHEETS of the sheets (Z / radius_z)^2 - (X / radius_x)^2
 * - (Y / radius_y)^2 = 1, both planes being on one sheet: radius_z <= bottom or top <= -radius_z. Axis 0 is
 * the angle.
 * \param[in] center,axis,x [3] or NULL: placement.
 * \param[in] radius_x,radius_y,radius_z > 0.
 * \param[in] bottom,top heights, bottom < top.
 * \param[in] start,sweep angles, as for nurbs_curve_ellipse().
 * \param[in] form one of the NURBS_ARC_ constants, for the angle.
 * \param[in] flags NURBS_TWO_SHEETS, or 0.
 * \param[out] out the new handle.
 * \return as for nurbs_surface_cylinder(), and NURBS_ERROR_FLAGS.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_hyperboloid(const double *center, const double *axis, const double *x,
                                                 double radius_x, double radius_y, double radius_z,
                                                 double bottom, double top, double start, double sweep,
                                                 int32_t form, uint32_t flags, nurbs **out);
/** @} */

/** \defgroup coons Surfaces and volumes from their boundaries
 * \code
 * nurbs *edges[4] = {NULL, NULL, NULL, NULL}, *patch = NULL;
 * nurbs_list *list = NULL;
 * nurbs_boundaries(surface, &list);
 * for (int64_t i = 0; i < 4; ++i) {
 *     nurbs_list_get(list, i, &edges[i]);
 * }
 * nurbs_surface_coons((const nurbs *const *)edges, 1e-9, &patch);
 * for (int i = 0; i < 4; ++i) {
 *     nurbs_destroy(edges[i]);
 * }
 * nurbs_destroy(patch);
 * nurbs_list_destroy(list);
 * \endcode
 * A boundary of a spline is what is left when one axis stands at one end of its domain. The boundaries of a
 * surface (4 curves) and of a volume (6 surfaces) are counted by axis, then by end:
 *
 *     index   0           1           2           3           4           5
 *     fixed   axis 0      axis 0      axis 1      axis 1      axis 2      axis 2
 *             start       end         start       end         start       end
 *
 * Each runs over the other axes in their order: of a surface S(u, v), 0 and 1 are curves in v, 2 and 3 in
 * u. Where boundaries are given, dim is their dimension.
 *
 * A Coons surface takes the domain of axis 0 from boundary 2 and that of axis 1 from boundary 0; a Coons
 * volume those of its axes 1 and 2 from boundary 0, and that of axis 0 from boundary 2. Domains of the
 * others are mapped to them. The result is clamped: unclamped boundaries are clamped, periodic ones opened.
 *
 * Corners, and whatever else is given twice, agree if they are at most `tolerance` apart; 0 asks for
 * equality of every bit, which ends of unclamped boundaries, and edges of faces with different knots, only
 * reach by chance. Where they differ by less, the means are used: a surface misses its boundaries by half
 * of what positions differ, and an eighth of the domain's length times what tangents do; a volume misses
 * its faces by at most three times the gap.
 *
 * Barring that, every boundary of a surface is met to 2 eps of its hull everywhere, half an eps more where
 * means were used, and one more for each denominator with which it is multiplied (tested by exact
 * comparison of the curves, weights within a factor of 25); corners bit for bit. Where a domain is mapped
 * to another one, its knots are rounded, which moves that boundary by its speed times the rounding. Cross
 * tangents are met to the rounding of the two layers of control points that they are differences of.
 *
 * Rational boundaries are blended in Cartesian space. The result is the sum over the product of the
 * denominators that are not equal bit for bit after both are brought to common knots and divided by their
 * first weight: degrees up to 2 p + 1 for surfaces from curves of degree p, 4 p + 3 with cross tangents. It
 * is polynomial where the weights of every boundary are equal. Weights of the faces of a volume are taken
 * apart into a factor for each axis where they are such products, to 8 eps, which gives degrees up to 4 p +
 * 1; where one face has others, the denominators of edges are factors too, up to 8 p + 1 in all, and edges
 * follow the first of their faces instead of the mean; the time then grows with the cube of the number of
 * knots of all those factors (seconds for six rational cubic faces of 7 x 7 points).
 * @{ */

/** \name Twists of nurbs_surface_coons_hermite()
 * The twist of a corner is S_uv there. Cross tangents determine it twice: as the derivatives along their
 * boundaries of both that meet there.
 * @{ */
#define NURBS_TWIST_COMPATIBLE 0 /**< both, which must agree to the tolerance */
#define NURBS_TWIST_AVERAGE 1    /**< their mean */
#define NURBS_TWIST_GIVEN 2      /**< the ones given */
#define NURBS_TWIST_ZERO 3       /**< zero (Ferguson's patch) */
#define NURBS_TWIST_BILINEAR 4   /**< that of the bilinear patch of the corners */
#define NURBS_TWIST_ADINI 5      /**< that of the bilinear Coons surface of the boundaries (Adini's twist) */
/** @} */

/** \brief The boundaries of a surface or volume, in the order above, each bit for bit what nurbs_iso()
 * gives; named "0-", "0+", "1-", "1+", and so on.
 * \param[in] g a surface or volume.
 * \param[out] out the new list, of 4 or 6.
 * \return NURBS_OK, NURBS_ERROR_NULL, _NOT_REPRESENTABLE; _AXES if g is a curve, _WEIGHTS_VANISH if all
 *   weights of a boundary are 0.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_boundaries(const nurbs *g, nurbs_list **out);

/** \brief The bilinearly blended Coons surface of four curves (Coons 1967): with u and v mapped to [0, 1],
 *
 *     S(u, v) = (1 - u) c0(v) + u c1(v) + (1 - v) c2(u) + v c3(u)
 *               - the bilinear patch of the four corners.
 *
 * \param[in] boundaries [4] curves of the same dimension, in the order above.
 * \param[in] tolerance largest gap at a corner, >= 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _TOLERANCE, _OVERFLOW; _AXES if one is no curve, _DIMENSION if
 *   dimensions differ, _GAP if a corner has a larger gap (the message names corner and gap; all gaps:
 *   nurbs_coons_gaps()), _DEGREE if a degree would exceed NURBS_MAX_DEGREE, _KNOTS_MERGE as for
 *   nurbs_reparametrize(), _NOT_REPRESENTABLE, _WEIGHTS_VANISH also if a corner lies at infinity.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_coons(const nurbs *const *boundaries, double tolerance, nurbs **out);

/** \brief The bicubically blended Coons surface of four curves and the derivatives across them:
 *
 *     S(u, v) = - [-1 F0(u) F1(u) G0(u) G1(u)] M [-1 F0(v) F1(v) G0(v) G1(v)]^T,
 *
 * where M is the boundary information matrix
 *
 *     | 0      S(u,0)   S(u,1)   S_v(u,0)   S_v(u,1)  |
 *     | S(0,v) S(0,0)   S(0,1)   S_v(0,0)   S_v(0,1)  |
 *     | S(1,v) S(1,0)   S(1,1)   S_v(1,0)   S_v(1,1)  |
 *     | S_u(0,v) S_u(0,0) S_u(0,1) S_uv(0,0) S_uv(0,1) |
 *     | S_u(1,v) S_u(1,0) S_u(1,1) S_uv(1,0) S_uv(1,1) |
 *
 * and F0, F1, G0, G1 are the cubic Hermite functions (Coons 1967), those of derivatives times the length of
 * the domain. Without cross tangents the surface is Hermite's bicubic blend of the corners' tangents along
 * the boundaries: S_u(0,v) = F0(v) S_u(0,0) + F1(v) S_u(0,1) + G0(v) S_uv(0,0) + G1(v) S_uv(0,1), and so
 * on.
 *
 * Boundaries are met everywhere; cross tangents are too, where the twists agree with them. Where they do
 * not, G0 and G1 times the differences are added to the cross tangents, so that the twists of the surface
 * are the ones used; M holds what results. Two surfaces that share a boundary, its cross tangents and the
 * twists at its ends join with one tangent plane along it.
 * \param[in] boundaries [4] curves of the same dimension, in the order above.
 * \param[in] cross [4] or NULL: curves of the same dimension: the derivative of the surface by the fixed axis
 *   along each boundary (0: S_u(u0, v), 2: S_v(u, v0)). Their domains are mapped to those of the boundaries
 *   without changing their values.
 * \param[in] twist one of the NURBS_TWIST_ constants; without cross not NURBS_TWIST_COMPATIBLE or _AVERAGE.
 * \param[in] twists [4][dim] or NULL, which it must be except for NURBS_TWIST_GIVEN: S_uv at (u0, v0), (u0,
 *   v1), (u1, v0), (u1, v1).
 * \param[in] tolerance largest gap at a corner, between tangents of boundaries and cross tangents there,
 *   and for NURBS_TWIST_COMPATIBLE between twists, >= 0.
 * \param[out] bound or NULL: largest difference between the twists used and those of the cross tangents, 0
 *   without cross.
 * \param[out] out the new handle.
 * \return as for nurbs_surface_coons(), and NURBS_ERROR_OVERLAP, _TWIST_RULE if twist is none of the
 *   constants or does not suit, or twists are given to another one, _POINT_NOT_FINITE if a twist is not
 *   finite, _TANGENT if a cross tangent differs from the tangent of the boundary at a corner by more than the
 *   tolerance, _TWIST if twists do; the message names the corner and the difference.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_coons_hermite(const nurbs *const *boundaries, const nurbs *const *cross,
                                                   int32_t twist, const double *twists, double tolerance,
                                                   double *bound, nurbs **out);

/** \brief What does not meet at the corners of a surface to be: corners in the order (u0, v0), (u0, v1),
 * (u1, v0), (u1, v1). All differences are lengths of vectors.
 * \param[in] boundaries [4] curves of the same dimension, in the order above.
 * \param[in] cross [4] or NULL: as for nurbs_surface_coons_hermite().
 * \param[out] positions [4] distances between the ends of the two boundaries.
 * \param[out] tangents [4][2] or NULL: differences between the derivative of a boundary and the cross tangent
 *   that belongs to the other one, first S_u, then S_v; 0 without cross.
 * \param[out] twists [4] or NULL: differences between the derivatives of the two cross tangents; 0 without
 *   cross.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _KNOTS_MERGE; _AXES if one is no curve, _DIMENSION if
 *   dimensions differ, _WEIGHTS_VANISH if a corner lies at infinity, _NOT_REPRESENTABLE if a difference
 *   overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_coons_gaps(const nurbs *const *boundaries, const nurbs *const *cross,
                                        double *positions, double *tangents, double *twists);

/** \brief The volume that blends six faces linearly (Gordon & Hall 1973): the sum of the blends of opposite
 * faces, less those of the twelve edges, plus that of the eight corners. Gaps along edges are proven
 * bounds, at most a quarter above the largest distance, apart from rounding.
 * \param[in] faces [6] surfaces of the same dimension, in the order above.
 * \param[in] tolerance largest gap along an edge, >= 0.
 * \param[out] out the new handle.
 * \return as for nurbs_surface_coons(), _AXES if a face is no surface; _GAP also names the edge.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_volume_coons(const nurbs *const *faces, double tolerance, nurbs **out);
/** @} */

/** \defgroup recognize Recognition
 * \code
 * int32_t shape = NURBS_SHAPE_NONE;
 * double placement[9], sizes[3], deviation = 0;
 * nurbs_recognize(surface, 1e-6, &shape, placement, sizes, &deviation); // such as NURBS_SHAPE_SPHERE
 * \endcode
 * @{ */

/** \name Shapes
 * @{ */
#define NURBS_SHAPE_NONE 0        /**< none of these, to the tolerance */
#define NURBS_SHAPE_POINT 1       /**< a single point */
#define NURBS_SHAPE_LINE 2        /**< a piece of a straight line */
#define NURBS_SHAPE_CIRCLE 3      /**< a circle, or an arc of one */
#define NURBS_SHAPE_ELLIPSE 4     /**< an ellipse, or an arc of one */
#define NURBS_SHAPE_PARABOLA 5    /**< an arc of a parabola */
#define NURBS_SHAPE_HYPERBOLA 6   /**< an arc of one branch of a hyperbola */
#define NURBS_SHAPE_PLANE 7       /**< a piece of a plane */
#define NURBS_SHAPE_SPHERE 8      /**< a sphere, or a piece of one */
#define NURBS_SHAPE_CYLINDER 9    /**< a piece of a circular cylinder */
#define NURBS_SHAPE_CONE 10       /**< a piece of one half of a circular cone */
#define NURBS_SHAPE_TORUS 11      /**< a torus, or a piece of one */
#define NURBS_SHAPE_REVOLUTION 12 /**< a surface of revolution; of models only, as those that follow */
#define NURBS_SHAPE_EXTRUSION 13  /**< a curve moved along a vector */
#define NURBS_SHAPE_OFFSET 14     /**< at a distance from another surface */
/** @} */

/** \brief Whether a curve is a line or a conic, or a surface a plane, sphere, cylinder, cone or torus.
 *
 * The result for a curve is the first of point, line, circle, parabola, ellipse and hyperbola, and for a
 * surface the first of point, line (both since 1.1), plane, sphere, cylinder, cone and torus, from which no
 * point of g is farther than the tolerance. So a surface that has shrunk to a point or a line is not a plane:
 * nothing would determine its normal. (Parabolas come before ellipses, because ellipses come as near to a
 * parabola as one likes.)
 *
 * A shape is fitted to points of g. Then the distance of all of g from it is bounded by the Bernstein
 * coefficients of the equation of the shape along g, so that the result is proven, rounding included. It
 * makes no difference whether the shape is closed or partial, nor how it is parametrized. If no shape is
 * found, g may still be within the tolerance of one, by a small margin: the fit makes distances small in the
 * mean, and the bound is within a factor of about 5/4, in the worst cases seen 3/2.
 *
 * The numbers are a placement and up to three sizes, of which none of these shapes needs the third. Unused
 * ones are 0:
 *
 *     shape       origin        axis              x                  sizes
 *     POINT       the point
 *     LINE        start         direction
 *     CIRCLE      centre        normal            to the start       radius
 *     ELLIPSE     centre        normal            major axis         semi-axes
 *     PARABOLA    vertex        normal            to the focus       focal length
 *     HYPERBOLA   centre        normal            to the vertex      semi-axes along x and across
 *     PLANE       a point       normal            along axis 0
 *     SPHERE      centre                                             radius
 *     CYLINDER    on the axis   axis              to the start       radius
 *     CONE        apex          axis, into g      to the start       half the opening angle
 *     TORUS       centre        axis              to the start       major and minor radius
 *
 * The start is the point of g at the lower end of the domain; for the origin of a line or a cylinder it is
 * the foot of that point on the axis. Where the start lies on the axis, x points to another point of g. A
 * circle or ellipse runs counterclockwise about its normal, and a parabola or hyperbola in the direction Y =
 * normal x X, so that the numbers are those with which nurbs_curve_circle() and the functions beside it make
 * the curve. In dimension 2, third coordinates are 0 and normals are (0, 0, 1) or (0, 0, -1). The normal of a
 * plane is on the side of S_u x S_v. The axis of a cylinder points from the start into g, and the largest
 * component of that of a torus is positive. A hyperbola is one branch and a cone one half. A torus with r > R
 * is its outer part.
 *
 * On exact shapes of degree 2, the bound is some 1e-14 of the largest distance of a Bezier point of g from
 * the origin of the shape, and a little more where coordinates are large compared with g. It grows in
 * proportion to the sum of the degrees, and up to fiftyfold for tori that nearly reach their axis and for
 * long hyperbolas (measured). With tolerances below that, nothing is found. Control points of small weight
 * far beyond a shape cost digits in proportion. Control points at infinity are allowed. Where the weights of
 * g cannot be shown to have one sign, the result is NURBS_SHAPE_NONE. The time is that of up to 60
 * subdivisions of each Bezier piece, each in proportion to the square of the number of its control points;
 * for most shapes one or two are enough.
 * \param[in] g a curve or surface of dimension 2 or 3.
 * \param[in] tolerance largest distance from the shape, > 0.
 * \param[out] shape one of the NURBS_SHAPE_ constants.
 * \param[out] placement [9] or NULL: origin, axis and x, three each.
 * \param[out] sizes [3] or NULL: see above.
 * \param[out] deviation or NULL: a proven bound of the distance of points of g from the shape with these
 *   numbers, at most the tolerance; 0 for NURBS_SHAPE_NONE.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _TOLERANCE, _OVERLAP; _NOT_REPRESENTABLE if a
 *   value overflows on the way.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_recognize(const nurbs *g, double tolerance, int32_t *shape, double *placement,
                                       double *sizes, double *deviation);

/** \brief nurbs_recognize() with progress reports, cancellation and a limit of work.
 * \param[in] g,tolerance as for nurbs_recognize().
 * \param[out] shape,placement,sizes,deviation as for nurbs_recognize().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_recognize(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_recognize_with(const nurbs *g, double tolerance, int32_t *shape,
                                            double *placement, double *sizes, double *deviation,
                                            const nurbs_call_options *call);
/** @} */

/** \defgroup closest Distances and closest points
 * \code
 * const double point[] = {1, 2, 3};
 * double params[2], foot[3], distance = 0;
 * int32_t status = 0; // NURBS_CLOSEST_CERTIFIED: proven
 * nurbs_closest_points(surface, 1, point, 0, 0, NULL, 0, 0, params, 0, 0, foot, 0, 0, &distance, 0,
 *                      &status, 0);
 * \endcode
 * All distances are Euclidean, in the Cartesian space of the points. The first query of a handle builds a
 * tree of its Bezier pieces with bounds, which the handle keeps. Use batches.
 *
 * A result is certified if it is proven that no point of g is nearer (for farthest points: farther) by more
 * than the tolerance and rounding. The latter is at most (64 n + 2 dim) eps (sqrt(dim) s + |x|), where n is
 * the sum of degree + 1 over the axes, s the largest coordinate of g, and x the query point. The proof uses
 * polynomials: with the homogeneous form A / w of a piece, |A - x w|^2 - r^2 w^2 >= 0 says that the piece is
 * not nearer than r, and it holds if all Bernstein coefficients are >= 0. Curves are divided at the minima of
 * the distance; around minima on surfaces and volumes, the polynomial is shown to be convex. Pieces that this
 * does not decide are halved, at most `budget` of them for a point. At the end of the budget, the best point
 * found is returned with NURBS_CLOSEST_BUDGET instead of NURBS_CLOSEST_CERTIFIED. Pieces of more than 256
 * control points count more than once. Of pieces with more than 1024, as in volumes of high degrees, only
 * hulls are examined, which is seldom enough for a proof. If parameters are so large, or spans so short, that
 * the point at the rounded parameter is worse than what was proven, or if its distance overflows,
 * NURBS_CLOSEST_COARSE replaces NURBS_CLOSEST_CERTIFIED. Weights have to be > 0. Splines with other weights
 * are searched in the same way, and are certified if their Bezier pieces have positive weights nevertheless.
 *
 * At a jump, both limits belong to g. A foot may be the limit that nurbs_eval() gives with NURBS_LEFT, which
 * NURBS_CLOSEST_LEFT reports. A seam, a pole or a collapsed edge has several parameters for one point; any of
 * them is returned. Ends and edges of the domain belong to it. Status bits refer to points: two parameters of
 * one point do not make it NURBS_CLOSEST_NOT_UNIQUE.
 * @{ */

/** \name Status of a closest point
 * @{ */
#define NURBS_CLOSEST_CERTIFIED 0x01  /**< proven to be the nearest, or farthest, point to the tolerance */
#define NURBS_CLOSEST_BOUNDARY 0x02   /**< on an end or an edge of the domain, or of range */
#define NURBS_CLOSEST_NOT_UNIQUE 0x04 /**< points elsewhere are as near to the tolerance */
#define NURBS_CLOSEST_BUDGET 0x08     /**< the budget ended before a proof was found */
#define NURBS_CLOSEST_INVALID 0x10    /**< the query point is not finite; results are NaN */
#define NURBS_CLOSEST_COARSE 0x20     /**< proven, but rounding the parameters moves the point by more */
#define NURBS_CLOSEST_SINGULAR 0x40   /**< of nurbs_closest_adjoint(): the gradient is not determined */
#define NURBS_CLOSEST_LEFT 0x100      /**< NURBS_LEFT is meant on axis 0; 0x200 on axis 1, 0x400 on axis 2 */
/** @} */

/** \name Kind of a critical point
 * @{ */
#define NURBS_CRITICAL_MINIMUM 1   /**< a local minimum of the distance */
#define NURBS_CRITICAL_MAXIMUM 2   /**< a local maximum of the distance */
#define NURBS_CRITICAL_SADDLE 3    /**< neither */
#define NURBS_CRITICAL_UNDECIDED 4 /**< rounding leaves the kind open */
/** @} */

/** \brief The points of a spline that are nearest to given points.
 *
 * Results are parameters, points and distances, and a status for each. For a volume this is inversion: a
 * point inside has the distance 0 to rounding. Points that are equally near, to within the tolerance, are
 * reported by NURBS_CLOSEST_NOT_UNIQUE and found by nurbs_closest_all().
 * \param[in] g a spline.
 * \param[in] n number of query points.
 * \param[in] points [n][dim] the query points.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] range [axes][2] or NULL for all of it: the part of the domain that is searched.
 * \param[in] tolerance how much nearer another point may be, >= 0.
 * \param[in] budget largest number of pieces examined for a point; 0 for 16 times the number of Bezier pieces
 *   of g, but at least 20000 and at most 2000000 (20000 before 1.1).
 * \param[out] params [n][axes] or NULL: the parameters.
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] feet [n][dim] or NULL: the nearest points, as nurbs_eval() gives them.
 * \param[in] foot_stride,foot_component_stride layout of feet, 0 = packed.
 * \param[out] distances [n] or NULL: the distances.
 * \param[in] distance_stride distance between values of distances, 0 = 1.
 * \param[out] status [n] or NULL: sum of NURBS_CLOSEST_ bits.
 * \param[in] flags NURBS_NAN_POINTS: a query point that is not finite gives NaN and NURBS_CLOSEST_INVALID
 *   instead of an error; or 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _FLAGS, _TOLERANCE,
 *   _POINT_NOT_FINITE; _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN or _EMPTY_DOMAIN if range is not an interval of
 *   the domain, _NOT_REPRESENTABLE if a point of a homogeneous spline overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_closest_points(const nurbs *g, int64_t n, const double *points,
                                            int64_t point_stride, int64_t point_component_stride,
                                            const double *range, double tolerance, int64_t budget,
                                            double *params, int64_t param_stride,
                                            int64_t param_component_stride, double *feet, int64_t foot_stride,
                                            int64_t foot_component_stride, double *distances,
                                            int64_t distance_stride, int32_t *status, uint32_t flags);

/** \brief Inputs of the batch functions for closest points in their form as long calls. Set struct_size to
 * sizeof(nurbs_closest_query), and what is not wanted to 0: fields that are 0 or NULL have their defaults.
 * Fields that a function does not use must be 0 or NULL (NURBS_ERROR_OPTIONS). Fields are only ever appended,
 * and struct_size is at most 4096. */
typedef struct nurbs_closest_query {
    int64_t struct_size;            /**< size of this struct as the caller knows it */
    int64_t n;                      /**< number of points */
    const double *points;           /**< [n][dim] the points */
    int64_t point_stride;           /**< distance between points, 0 = packed */
    int64_t point_component_stride; /**< distance between components, 0 = 1 */
    const double *guesses;          /**< [n][axes] or NULL: where nurbs_closest_local_with() begins */
    int64_t guess_stride;           /**< distance between guesses, 0 = packed */
    int64_t guess_component_stride; /**< distance between components, 0 = 1 */
    const double *range;            /**< [axes][2] or NULL for all of it: the part of the domain */
    double tolerance;               /**< >= 0 */
    int64_t budget;    /**< most pieces examined for each point, 0 as for nurbs_closest_points() */
    uint32_t flags;    /**< NURBS_NAN_POINTS or 0 */
    uint32_t reserved; /**< 0 */
} nurbs_closest_query;

/** \brief Outputs of the batch functions for closest points in their form as long calls: arrays of the
 * caller, NULL for what is not wanted. Set struct_size to sizeof(nurbs_closest_answer). Arrays that a
 * function does not fill must be NULL (NURBS_ERROR_OPTIONS). Fields are only ever appended, and struct_size
 * is at most 4096. */
typedef struct nurbs_closest_answer {
    int64_t struct_size;            /**< size of this struct as the caller knows it */
    double *params;                 /**< [n][axes] or NULL: the parameters */
    int64_t param_stride;           /**< distance between parameters, 0 = packed */
    int64_t param_component_stride; /**< distance between components, 0 = 1 */
    double *feet;                   /**< [n][dim] or NULL: the points of the spline */
    int64_t foot_stride;            /**< distance between feet, 0 = packed */
    int64_t foot_component_stride;  /**< distance between components, 0 = 1 */
    double *distances;       /**< [n] or NULL: the distances, of nurbs_curve_signed_distances_with() signed */
    int64_t distance_stride; /**< distance between distances, 0 = 1 */
    int32_t *status;         /**< [n] or NULL: sums of NURBS_CLOSEST_ bits */
} nurbs_closest_answer;

/** \brief nurbs_closest_points() with progress reports, cancellation and a limit of work.
 * \param[in] g as for nurbs_closest_points().
 * \param[in] query the points, and all other inputs except guesses.
 * \param[in] answer the arrays to fill.
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_closest_points(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_closest_points_with(const nurbs *g, const nurbs_closest_query *query,
                                                 const nurbs_closest_answer *answer,
                                                 const nurbs_call_options *call);

/** \brief The points of a spline that are farthest from given points.
 *
 * Everything else is as for nurbs_closest_points().
 * \param[in] g a spline.
 * \param[in] n number of query points.
 * \param[in] points [n][dim] the query points.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] range [axes][2] or NULL for all of it: the part of the domain that is searched.
 * \param[in] tolerance how much farther another point may be, >= 0.
 * \param[in] budget largest number of pieces examined for a point; 0 for 16 times the number of Bezier pieces
 *   of g, but at least 20000 and at most 2000000 (20000 before 1.1).
 * \param[out] params [n][axes] or NULL: the parameters.
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] feet [n][dim] or NULL: the farthest points.
 * \param[in] foot_stride,foot_component_stride layout of feet, 0 = packed.
 * \param[out] distances [n] or NULL: the distances.
 * \param[in] distance_stride distance between values of distances, 0 = 1.
 * \param[out] status [n] or NULL: sum of NURBS_CLOSEST_ bits.
 * \param[in] flags NURBS_NAN_POINTS, or 0.
 * \return as for nurbs_closest_points().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_farthest_points(
    const nurbs *g, int64_t n, const double *points, int64_t point_stride, int64_t point_component_stride,
    const double *range, double tolerance, int64_t budget, double *params, int64_t param_stride,
    int64_t param_component_stride, double *feet, int64_t foot_stride, int64_t foot_component_stride,
    double *distances, int64_t distance_stride, int32_t *status, uint32_t flags);

/** \brief nurbs_farthest_points() with progress reports, cancellation and a limit of work.
 * \param[in] g as for nurbs_farthest_points().
 * \param[in] query the points, and all other inputs except guesses.
 * \param[in] answer the arrays to fill.
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_farthest_points(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_farthest_points_with(const nurbs *g, const nurbs_closest_query *query,
                                                  const nurbs_closest_answer *answer,
                                                  const nurbs_call_options *call);

/** \brief Local minima of the distance from given points, each reached by a descent from a guess.
 *
 * The descent is Newton's method with a trust region, constrained to the box of the domain, and continues
 * across knots. The result is never certified.
 * \param[in] g a spline.
 * \param[in] n number of query points.
 * \param[in] points [n][dim] the query points.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] guesses [n][axes] parameters in the domain.
 * \param[in] guess_stride,guess_component_stride layout of guesses, 0 = packed.
 * \param[out] params [n][axes] or NULL: the parameters.
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] feet [n][dim] or NULL: the points of the spline.
 * \param[in] foot_stride,foot_component_stride layout of feet, 0 = packed.
 * \param[out] distances [n] or NULL: the distances.
 * \param[in] distance_stride distance between values of distances, 0 = 1.
 * \param[out] status [n] or NULL: NURBS_CLOSEST_BOUNDARY, NURBS_CLOSEST_BUDGET where 100 steps did not
 *   converge, NURBS_CLOSEST_INVALID.
 * \param[in] flags NURBS_NAN_POINTS, or 0.
 * \return as for nurbs_closest_points(); _PARAMETER_NOT_FINITE or _OUTSIDE_DOMAIN naming a guess.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_closest_local(const nurbs *g, int64_t n, const double *points,
                                           int64_t point_stride, int64_t point_component_stride,
                                           const double *guesses, int64_t guess_stride,
                                           int64_t guess_component_stride, double *params,
                                           int64_t param_stride, int64_t param_component_stride, double *feet,
                                           int64_t foot_stride, int64_t foot_component_stride,
                                           double *distances, int64_t distance_stride, int32_t *status,
                                           uint32_t flags);

/** \brief nurbs_closest_local() with progress reports, cancellation and a limit of work.
 * \param[in] g as for nurbs_closest_local().
 * \param[in] query the points, guesses and flags.
 * \param[in] answer the arrays to fill.
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_closest_local(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_closest_local_with(const nurbs *g, const nurbs_closest_query *query,
                                                const nurbs_closest_answer *answer,
                                                const nurbs_call_options *call);

/** \brief All local minima of the distance from a point that are within a tolerance of the smallest.
 *
 * Where they are not isolated (on an arc around its centre), every piece of g that has some gives at least
 * one, and the status has NURBS_CLOSEST_NOT_UNIQUE without NURBS_CLOSEST_CERTIFIED. At a jump, a point may be
 * the limit from below.
 * \param[in] g a spline.
 * \param[in] point [dim] the query point.
 * \param[in] range [axes][2] or NULL for all of it: the part of the domain that is searched.
 * \param[in] tolerance how much farther than the nearest point a minimum may be, >= 0.
 * \param[in] budget largest number of pieces examined, 0 for 20000.
 * \param[in] cap length of the outputs: 0, or at least the number of points.
 * \param[out] params [cap][axes] or NULL: the parameters, in rising order.
 * \param[out] distances [cap] or NULL: the distances.
 * \param[out] count or NULL: number of points.
 * \param[out] status or NULL: sum of NURBS_CLOSEST_ bits: certified if no other point is as near.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _OVERLAP, _TOLERANCE, _POINT_NOT_FINITE; _SIZE if
 *   cap is neither 0 nor enough; _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN or _EMPTY_DOMAIN if range is not an
 *   interval of the domain, _NOT_REPRESENTABLE if a point of a homogeneous spline overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_closest_all(const nurbs *g, const double *point, const double *range,
                                         double tolerance, int64_t budget, int64_t cap, double *params,
                                         double *distances, int64_t *count, int32_t *status);

/** \brief nurbs_closest_all() with progress reports, cancellation and a limit of work.
 * \param[in] g,point,range,tolerance,budget,cap as for nurbs_closest_all().
 * \param[out] params,distances,count,status as for nurbs_closest_all().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_closest_all(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_closest_all_with(const nurbs *g, const double *point, const double *range,
                                              double tolerance, int64_t budget, int64_t cap, double *params,
                                              double *distances, int64_t *count, int32_t *status,
                                              const nurbs_call_options *call);

/** \brief All critical points of the distance from a point.
 *
 * On a curve C, these are the points where x - C is perpendicular to the tangent, and the ends and kinks
 * where the distance has a minimum or maximum. On surfaces and volumes they are the critical points inside,
 * those on edges that are critical along the edges, and the corners with a minimum or maximum. Minima on
 * creases at knots are not among them; nurbs_closest_all() finds these. A pole is one point, together with
 * everything that the tolerance does not distinguish from it; its kind is that of samples around it. At a
 * jump, a point may be the limit from below.
 * \param[in] g a spline.
 * \param[in] point [dim] the query point x.
 * \param[in] range [axes][2] or NULL for all of it: the part of the domain that is searched.
 * \param[in] tolerance >= 0: points of g that are no farther apart are not distinguished; of a curve, those
 *   that follow each other along it, also across the seam of a closed one. A place where a curve crosses
 *   itself is a point for each of its parameters.
 * \param[in] budget largest number of pieces examined, 0 for 20000.
 * \param[in] cap length of the outputs: 0, or at least the number of points.
 * \param[out] params [cap][axes] or NULL: the parameters, in rising order.
 * \param[out] distances [cap] or NULL: the distances.
 * \param[out] kinds [cap] or NULL: NURBS_CRITICAL_ constants.
 * \param[out] count or NULL: number of points.
 * \param[out] status or NULL: NURBS_CLOSEST_CERTIFIED if there are no others, NURBS_CLOSEST_NOT_UNIQUE if
 *   they are not isolated, NURBS_CLOSEST_BUDGET.
 * \return as for nurbs_closest_all().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_critical_points(const nurbs *g, const double *point, const double *range,
                                             double tolerance, int64_t budget, int64_t cap, double *params,
                                             double *distances, int32_t *kinds, int64_t *count,
                                             int32_t *status);

/** \brief nurbs_critical_points() with progress reports, cancellation and a limit of work.
 * \param[in] g,point,range,tolerance,budget,cap as for nurbs_critical_points().
 * \param[out] params,distances,kinds,count,status as for nurbs_critical_points().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_critical_points(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_critical_points_with(const nurbs *g, const double *point, const double *range,
                                                  double tolerance, int64_t budget, int64_t cap,
                                                  double *params, double *distances, int32_t *kinds,
                                                  int64_t *count, int32_t *status,
                                                  const nurbs_call_options *call);

/** \brief Signed distances of points in the plane from a curve: positive to the left of its direction.
 *
 * So they are positive inside a closed curve that runs counterclockwise without crossing itself. At a kink,
 * the corner determines the side; beyond the end of an open curve, the tangent at the end does. A distance of
 * 0 has no sign.
 * \param[in] g a curve of dimension 2.
 * \param[in] n number of query points.
 * \param[in] points [n][2] the query points.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] tolerance how much nearer another point may be, >= 0.
 * \param[in] budget largest number of pieces examined for a point; 0 for 16 times the number of Bezier pieces
 *   of g, but at least 20000 and at most 2000000 (20000 before 1.1).
 * \param[out] distances [n] the distances with their sign.
 * \param[in] distance_stride distance between values of distances, 0 = 1.
 * \param[out] params [n] or NULL: the parameters of the nearest points.
 * \param[in] param_stride distance between values of params, 0 = 1.
 * \param[out] status [n] or NULL: as for nurbs_closest_points().
 * \param[in] flags NURBS_NAN_POINTS, or 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _FLAGS,
 *   _TOLERANCE, _POINT_NOT_FINITE; _NOT_REPRESENTABLE if a point of a homogeneous spline overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_signed_distances(const nurbs *g, int64_t n, const double *points,
                                                    int64_t point_stride, int64_t point_component_stride,
                                                    double tolerance, int64_t budget, double *distances,
                                                    int64_t distance_stride, double *params,
                                                    int64_t param_stride, int32_t *status, uint32_t flags);

/** \brief nurbs_curve_signed_distances() with progress reports, cancellation and a limit of work.
 * \param[in] g as for nurbs_curve_signed_distances().
 * \param[in] query the points, and all other inputs except guesses and range.
 * \param[in] answer the arrays to fill.
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_signed_distances(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_signed_distances_with(const nurbs *g, const nurbs_closest_query *query,
                                                         const nurbs_closest_answer *answer,
                                                         const nurbs_call_options *call);

/** \brief Proven bounds of the smallest distance between two splines, of any number of axes each.
 *
 * at_least <= distance of the nearest points <= at_most, and at_most is the distance of the two points
 * returned. The bounds differ by at most the tolerance and rounding unless the budget ends. Pairs of pieces
 * are bounded from below by boxes, and by planes, spheres and cylinders that separate them, which is exact
 * for parallel and concentric shapes. Other continua of nearest points take about 1 / sqrt(tolerance) pairs.
 * At a jump, a point may be the limit from below.
 * \param[in] a,b two splines of the same dimension.
 * \param[in] tolerance largest difference of the bounds that is wanted, >= 0.
 * \param[in] budget largest number of pairs of pieces examined, 0 for 200000 within the limit of work.
 * \param[out] at_least,at_most or NULL: the bounds.
 * \param[out] params_a [axes of a] or NULL: the parameters of the point of a.
 * \param[out] params_b [axes of b] or NULL: the parameters of the point of b.
 * \param[out] status or NULL: NURBS_CLOSEST_CERTIFIED, NURBS_CLOSEST_BUDGET.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP, _TOLERANCE; _INCOMPATIBLE if the dimensions differ,
 *   _NOT_REPRESENTABLE if a distance overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_distance(const nurbs *a, const nurbs *b, double tolerance, int64_t budget,
                                      double *at_least, double *at_most, double *params_a, double *params_b,
                                      int32_t *status);

/** \brief nurbs_distance() with progress reports, cancellation and a limit of work.
 * \param[in] a,b,tolerance,budget as for nurbs_distance().
 * \param[out] at_least,at_most,params_a,params_b,status as for nurbs_distance().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_distance(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_distance_with(const nurbs *a, const nurbs *b, double tolerance, int64_t budget,
                                           double *at_least, double *at_most, double *params_a,
                                           double *params_b, int32_t *status, const nurbs_call_options *call);

/** \brief Proven bounds of the Hausdorff distances of two splines as sets of points.
 *
 * Parameters do not matter. The distance from a to b is that of the point of a that is farthest from b; the
 * distance from b to a is the other way round. The larger of the two is the symmetric distance.
 * at_least[i] <= distance <= at_most[i], both proven. The bounds differ by at most the tolerance and rounding
 * unless the budget ends; at_most may then be infinite. Upper bounds come from the farthest control point
 * from one point, and from matching a piece of one spline with a part of a piece of the other by their
 * nearest corners, so that splines that are near each other everywhere are measured quickly.
 *
 * Splines with the same numbers have the distances 0. If one spline is the same set as the other, or a part
 * of it, this is found at once, with a bound of rounding, where its parameters are those of the other after a
 * linear map of each axis: whatever the degrees and knots are, and the order, directions and domains of the
 * axes. The weights have to be positive for that. A few nearest points, with at most 500 pieces each, which
 * the budget does not count, decide whether this is possible.
 * \param[in] a,b two splines of the same dimension.
 * \param[in] tolerance largest difference of the bounds that is wanted, >= 0.
 * \param[in] budget largest number of pieces examined in each direction, those for nearest points included; 0
 *   for 2000000 within the limit of work.
 * \param[out] at_least [2] or NULL: from a to b, from b to a.
 * \param[out] at_most [2] or NULL: the same, from above.
 * \param[out] params_a [axes of a] or NULL: the parameters of a point of a that is at_least[0] away from b.
 * \param[out] params_b [axes of b] or NULL: the parameters of a point of b that is at_least[1] away from a.
 * \param[out] status or NULL: NURBS_CLOSEST_CERTIFIED, NURBS_CLOSEST_BUDGET.
 * \return as for nurbs_distance().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_hausdorff_distance(const nurbs *a, const nurbs *b, double tolerance,
                                                int64_t budget, double *at_least, double *at_most,
                                                double *params_a, double *params_b, int32_t *status);

/** \brief nurbs_hausdorff_distance() with progress reports, cancellation and a limit of work.
 * \param[in] a,b,tolerance,budget as for nurbs_hausdorff_distance().
 * \param[out] at_least,at_most,params_a,params_b,status as for nurbs_hausdorff_distance().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_hausdorff_distance(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_hausdorff_distance_with(const nurbs *a, const nurbs *b, double tolerance,
                                                     int64_t budget, double *at_least, double *at_most,
                                                     double *params_a, double *params_b, int32_t *status,
                                                     const nurbs_call_options *call);
/** @} */

/** \defgroup measure Lengths, areas and moments
 * \code
 * double length = 0, error = 0;
 * nurbs_curve_length(curve, NULL, 1e-12, &length, &error);
 * \endcode
 * Integrals over splines, by nested Gauss rules (Patterson 1968) of 15 to 63 nodes on each span between
 * knots, never across a knot. A span is halved if the Legendre coefficients of the integrand do not fall fast
 * enough, if weights differ by a factor of more than 64, or, for lengths and areas, if the spline turns so
 * sharply that a feature may be narrower than the distance of the nodes. Cusps, poles and other places where
 * the speed vanishes are found by the halving; they cost more time, not accuracy. Where the weights vanish,
 * an integral may be infinite: NURBS_ERROR_NOT_CONVERGED.
 *
 * **Tolerances.** `relative_tolerance` is that of the result (of a centroid and of moments: relative to the
 * size of the shape). 0, and any tolerance below rounding, asks for the best that double precision and a
 * limit of work give: rounding, or otherwise about nine, six or three digits, as along a fold inside a
 * surface, where |S_u x S_v| has a kink. If a tolerance above rounding is not reached, that is
 * NURBS_ERROR_NOT_CONVERGED. For functions without `error`, which could show what was reached
 * (nurbs_curve_lengths() and those that share its table), the same holds for 0. `error` receives an estimate
 * of the absolute error, rounding included; it follows from how the coefficients fall, and is not a proof.
 *
 * **Inertia** is the tensor about the centroid, the integral of |y|^2 E - y y^T with y = x - centroid and the
 * unit matrix E, for the density 1. It is symmetric, with rows one after the other. If the content is
 * negative, the inertia has that sign.
 * @{ */

/** \brief The length of a curve or of a part of it.
 * \param[in] g a curve.
 * \param[in] range [2] or NULL for all of it: the part of the domain.
 * \param[in] relative_tolerance >= 0.
 * \param[out] length the integral of |C'(t)|.
 * \param[out] error or NULL: estimate of the error.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _OVERLAP, _TOLERANCE; _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN or
 *   _EMPTY_DOMAIN if range is not an interval of the domain; _NOT_CONVERGED naming the error reached,
 *   _NOT_REPRESENTABLE if the length overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_length(const nurbs *g, const double *range, double relative_tolerance,
                                          double *length, double *error);

/** \brief nurbs_curve_length() with progress reports, cancellation and a limit of work.
 * \param[in] g,range,relative_tolerance as for nurbs_curve_length().
 * \param[out] length,error as for nurbs_curve_length().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_length(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_length_with(const nurbs *g, const double *range, double relative_tolerance,
                                               double *length, double *error, const nurbs_call_options *call);

/** \brief Lengths from the start of the domain to given parameters.
 *
 * The first call of a handle makes a table, which takes as long as several lengths.
 * nurbs_curve_params_at_lengths() and nurbs_curve_divide() share it, so that they map the length at the end
 * of the domain to the end, unless the curve stands still there. nurbs_curve_length() adds in another order,
 * and its results may differ by rounding.
 * \param[in] g a curve.
 * \param[in] n number of parameters.
 * \param[in] params [n] in the domain.
 * \param[in] param_stride distance between parameters, 0 = 1.
 * \param[in] relative_tolerance >= 0, of the whole length.
 * \param[out] lengths [n] the lengths.
 * \param[in] length_stride distance between lengths, 0 = 1.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _TOLERANCE,
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _NOT_CONVERGED, _NOT_REPRESENTABLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_lengths(const nurbs *g, int64_t n, const double *params,
                                           int64_t param_stride, double relative_tolerance, double *lengths,
                                           int64_t length_stride);

/** \brief nurbs_curve_lengths() with progress reports, cancellation and a limit of work.
 * \param[in] g,n,params,param_stride,relative_tolerance as for nurbs_curve_lengths().
 * \param[out] lengths as for nurbs_curve_lengths().
 * \param[in] length_stride as for nurbs_curve_lengths().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_lengths(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_lengths_with(const nurbs *g, int64_t n, const double *params,
                                                int64_t param_stride, double relative_tolerance,
                                                double *lengths, int64_t length_stride,
                                                const nurbs_call_options *call);

/** \brief Parameters at given lengths from the start of the domain.
 *
 * Where the curve stands still, the first parameter is returned. The method is Newton's, with the speed as
 * derivative, inside a bracket.
 * \param[in] g a curve.
 * \param[in] n number of lengths.
 * \param[in] lengths [n] from 0 to the length of the curve, which the tolerance and rounding may exceed.
 * \param[in] length_stride distance between lengths, 0 = 1.
 * \param[in] relative_tolerance >= 0, of the whole length.
 * \param[out] params [n] the parameters.
 * \param[in] param_stride distance between parameters, 0 = 1.
 * \param[in] flags NURBS_CLAMP: a length outside, also an infinite one, gives the nearer end instead of an
 *   error; or 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _FLAGS, _TOLERANCE;
 *   _LENGTH if a length is NaN, or outside without NURBS_CLAMP; _NOT_CONVERGED, _NOT_REPRESENTABLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_params_at_lengths(const nurbs *g, int64_t n, const double *lengths,
                                                     int64_t length_stride, double relative_tolerance,
                                                     double *params, int64_t param_stride, uint32_t flags);

/** \brief nurbs_curve_params_at_lengths() with progress reports, cancellation and a limit of work.
 * \param[in] g,n,lengths,length_stride,relative_tolerance as for nurbs_curve_params_at_lengths().
 * \param[out] params as for nurbs_curve_params_at_lengths().
 * \param[in] param_stride,flags as for nurbs_curve_params_at_lengths().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_params_at_lengths(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_params_at_lengths_with(const nurbs *g, int64_t n, const double *lengths,
                                                          int64_t length_stride, double relative_tolerance,
                                                          double *params, int64_t param_stride,
                                                          uint32_t flags, const nurbs_call_options *call);

/** \brief Divides a curve into parts of equal length, or so that consecutive points have equal distances.
 *
 * For equal distances, each point is the first one at its distance from the one before, where there is such a
 * division. Otherwise chains of points are followed while their distance rises and falls. On curves that wind
 * about themselves this finds most divisions into few parts; into ten or more parts the path may be too long:
 * NURBS_ERROR_NOT_CONVERGED.
 * \param[in] g a curve.
 * \param[in] range [2] or NULL for all of it: the part of the domain.
 * \param[in] parts number of parts, > 0.
 * \param[in] relative_tolerance >= 0, of a part.
 * \param[in] flags NURBS_EQUAL_CHORDS: equal distances instead of equal lengths; or 0.
 * \param[out] params [parts + 1] rising; the first and last ones are the ends of range.
 * \param[out] size or NULL: the length or the chord of a part.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERFLOW, _OVERLAP, _FLAGS, _TOLERANCE;
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN or _EMPTY_DOMAIN if range is not an interval of the domain;
 *   _LENGTH if the curve has none, _NOT_CONVERGED (for chords also where no division is found),
 *   _NOT_REPRESENTABLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_divide(const nurbs *g, const double *range, int64_t parts,
                                          double relative_tolerance, uint32_t flags, double *params,
                                          double *size);

/** \brief nurbs_curve_divide() with progress reports, cancellation and a limit of work.
 * \param[in] g,range,parts,relative_tolerance,flags as for nurbs_curve_divide().
 * \param[out] params,size as for nurbs_curve_divide().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_divide(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_divide_with(const nurbs *g, const double *range, int64_t parts,
                                               double relative_tolerance, uint32_t flags, double *params,
                                               double *size, const nurbs_call_options *call);

/** \brief The area of a surface or of a part of it, in any dimension.
 * \param[in] g a surface.
 * \param[in] range [2][2] or NULL for all of it: the part of the domain.
 * \param[in] relative_tolerance >= 0.
 * \param[out] area the integral of |S_u x S_v|; in dimensions other than 3 of sqrt(|S_u|^2 |S_v|^2 - (S_u .
 *   S_v)^2).
 * \param[out] error or NULL: estimate of the error.
 * \return as for nurbs_curve_length(), _AXES if g is not a surface.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_surface_area(const nurbs *g, const double *range, double relative_tolerance,
                                          double *area, double *error);

/** \brief nurbs_surface_area() with progress reports, cancellation and a limit of work.
 * \param[in] g,range,relative_tolerance as for nurbs_surface_area().
 * \param[out] area,error as for nurbs_surface_area().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_surface_area(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_area_with(const nurbs *g, const double *range, double relative_tolerance,
                                               double *area, double *error, const nurbs_call_options *call);

/** \brief Content, centroid and inertia of a curve as a wire, a surface as a sheet, or a volume as a body.
 *
 * The content of a volume is the integral of |det J|, where J are its derivatives.
 * \param[in] g a spline; a volume of dimension 3.
 * \param[in] relative_tolerance >= 0.
 * \param[out] content the length, area or volume.
 * \param[out] centroid [dim] or NULL.
 * \param[out] inertia [dim][dim] or NULL: about the centroid. It overflows long before the content does, and
 *   NULL leaves it out.
 * \param[out] error or NULL: estimate of the error of content.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _TOLERANCE; _DIMENSION if g is a volume of another dimension,
 *   _LENGTH if the content is 0 and centroid or inertia are wanted, _NOT_CONVERGED, _NOT_REPRESENTABLE naming
 *   which of these overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_moments(const nurbs *g, double relative_tolerance, double *content,
                                     double *centroid, double *inertia, double *error);

/** \brief nurbs_moments() with progress reports, cancellation and a limit of work.
 * \param[in] g,relative_tolerance as for nurbs_moments().
 * \param[out] content,centroid,inertia,error as for nurbs_moments().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_moments(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_moments_with(const nurbs *g, double relative_tolerance, double *content,
                                          double *centroid, double *inertia, double *error,
                                          const nurbs_call_options *call);

/** \brief Area, centroid and inertia of the region of the plane that closed chains of curves enclose.
 *
 * By Green's theorem the area is 1/2 integral of x dy - y dx. What a counterclockwise chain encloses counts
 * positive, so that holes run clockwise. The curves may come in any order, but each runs in the direction of
 * its chain. A jump inside a curve is an end and a start; a periodic curve has no other ends.
 * \param[in] count number of curves, > 0.
 * \param[in] curves [count] curves of dimension 2.
 * \param[in] tolerance largest gap between an end and the start that follows it, another one for each end,
 *   >= 0.
 * \param[in] relative_tolerance >= 0.
 * \param[out] area the area, with its sign.
 * \param[out] centroid [2] or NULL.
 * \param[out] inertia [2][2] or NULL: as for nurbs_moments().
 * \param[out] error or NULL: estimate of the error of area, gaps not included.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _AXES, _DIMENSION, _OVERLAP, _TOLERANCE; _GAP
 *   naming a curve whose end has no start within the tolerance, and the gap, or none that is not that of
 *   another end; _LENGTH if the area is 0 and centroid or inertia are wanted, _NOT_CONVERGED,
 *   _NOT_REPRESENTABLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_enclosed_area(int64_t count, const nurbs *const *curves, double tolerance,
                                           double relative_tolerance, double *area, double *centroid,
                                           double *inertia, double *error);

/** \brief nurbs_enclosed_area() with progress reports, cancellation and a limit of work.
 * \param[in] count,curves,tolerance,relative_tolerance as for nurbs_enclosed_area().
 * \param[out] area,centroid,inertia,error as for nurbs_enclosed_area().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_enclosed_area(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_enclosed_area_with(int64_t count, const nurbs *const *curves, double tolerance,
                                                double relative_tolerance, double *area, double *centroid,
                                                double *inertia, double *error,
                                                const nurbs_call_options *call);

/** \brief Volume, centroid and inertia of the body that surfaces enclose.
 *
 * By the divergence theorem the volume is 1/3 integral of S . (S_u x S_v). The normals S_u x S_v point
 * outwards (if all of them point inwards, the volume is negative). The vector area, the integral of S_u x
 * S_v, shows whether the surfaces close: it is zero for closed shells.
 * \param[in] count number of surfaces, > 0.
 * \param[in] surfaces [count] surfaces of dimension 3.
 * \param[in] relative_tolerance >= 0.
 * \param[out] volume the volume, with its sign.
 * \param[out] centroid [3] or NULL.
 * \param[out] inertia [3][3] or NULL: as for nurbs_moments().
 * \param[out] openness or NULL: length of the vector area.
 * \param[out] error or NULL: estimate of the error of volume, gaps not included.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _AXES, _DIMENSION, _OVERLAP, _TOLERANCE; _LENGTH
 *   if the volume is 0 and centroid or inertia are wanted, _NOT_CONVERGED, _NOT_REPRESENTABLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_enclosed_volume(int64_t count, const nurbs *const *surfaces,
                                             double relative_tolerance, double *volume, double *centroid,
                                             double *inertia, double *openness, double *error);

/** \brief nurbs_enclosed_volume() with progress reports, cancellation and a limit of work.
 * \param[in] count,surfaces,relative_tolerance as for nurbs_enclosed_volume().
 * \param[out] volume,centroid,inertia,openness,error as for nurbs_enclosed_volume().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_enclosed_volume(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_enclosed_volume_with(int64_t count, const nurbs *const *surfaces,
                                                  double relative_tolerance, double *volume, double *centroid,
                                                  double *inertia, double *openness, double *error,
                                                  const nurbs_call_options *call);

/** \brief Points and weights for integrals of any function over a spline.
 *
 * They are tensor products of Gauss-Legendre rules on all spans that are not empty, exact along each axis for
 * polynomials of degree 2 nodes - 1 on each span. The points come span by span, the last axis fastest; the
 * nodes^axes points of a span come with the last axis fastest, too. All points lie inside their spans, which
 * nurbs_rational_basis() and nurbs_basis_gradients() return. The sum of measures[i] f(point i) approximates
 * the integral of f over the shape, and the sum of weights[i] f(params[i]) that over the domain:
 *
 *     measures[i] = weights[i] sqrt(det J^T J),  J the derivatives of g at params[i].
 * \param[in] g a spline.
 * \param[in] nodes number of nodes along each axis of a span, 1 to 64; 0: on each axis one more than its
 *   degree.
 * \param[in] cap length of the arrays in points; 0 asks for the number only.
 * \param[out] params [cap][axes] or NULL: receives the parameters, packed.
 * \param[out] weights [cap] or NULL: receives the weights of the parameters, which add up to the size of the
 *   domain.
 * \param[out] measures [cap] or NULL: receives the weights of lengths, areas or volumes; 0 where g has more
 *   axes than coordinates.
 * \param[out] count or NULL: receives the number of points.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW, _OVERLAP; _COUNT for nodes or cap out of range, _SIZE if cap
 *   is neither 0 nor enough, _NOT_REPRESENTABLE if weights or measures overflow.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_quadrature(const nurbs *g, int32_t nodes, int64_t cap, double *params,
                                        double *weights, double *measures, int64_t *count);
/** @} */

/** \defgroup bounds Boxes and cones
 * \code
 * double lower[3], upper[3], gap = 0;
 * nurbs_box(surface, NULL, 1e-3, lower, upper, &gap); // each face at most 1e-3 from the surface
 * \endcode
 * Proven bounds that contain a spline. They come from Bernstein coefficients; pieces are halved where a
 * tighter bound is wanted, and bounds are rounded outwards. On every Bezier piece the weights have to be > 0
 * after some halvings. If they never are, boxes are infinite and cones may be the whole space. Where a search
 * has a limit of 20000 halvings, the limit is lower for pieces of more than 3000 coefficients, so that memory
 * does not run out. A derivative that is zero to its rounding at an end of a piece counts as zero there, and
 * its direction is the limit.
 * @{ */

/** \brief An axis-aligned box that contains a spline, and all points that evaluation gives of it.
 *
 * Evaluated points of homogeneous splines are an exception, because their rounding has no such bound.
 * \param[in] g a spline.
 * \param[in] range [axes][2] or NULL for all of it: the part of the domain.
 * \param[in] tolerance how far a face may be from the nearest point of g, >= 0; infinite: the box of the
 *   Bezier points.
 * \param[out] lower [dim] the lower corner.
 * \param[out] upper [dim] the upper corner.
 * \param[out] gap or NULL: a proven bound of the largest distance of a face from the spline; at most the
 *   tolerance, apart from rounding, unless 20000 halvings do not reach it.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _TOLERANCE; _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN or
 *   _EMPTY_DOMAIN if range is not an interval of the domain, _NOT_REPRESENTABLE if a point of a homogeneous
 *   spline overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_box(const nurbs *g, const double *range, double tolerance, double *lower,
                                 double *upper, double *gap);

/** \brief A box with axes of its own that contains a spline.
 *
 * It is { center + sum_k x_k axes[k], |x_k| <= half[k] }. Its axes are the principal axes of the control
 * points, longest first, or the coordinate axes where the box along these has no larger content.
 * \param[in] g a spline.
 * \param[in] tolerance how far a face may be from the nearest point of g, >= 0, may be infinite.
 * \param[out] center [dim] the middle of the box.
 * \param[out] axes [dim][dim] orthonormal to rounding, right-handed in dimension 3.
 * \param[out] half [dim] half the lengths of the sides.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _TOLERANCE; _DIMENSION if it exceeds 16,
 *   _NOT_REPRESENTABLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_oriented_box(const nurbs *g, double tolerance, double *center, double *axes,
                                          double *half);

/** \brief A cone that contains the directions of all derivatives along an axis.
 *
 * So it contains those on both sides of kinks. Zero vectors have no direction. Boundaries of Bezier pieces
 * where derivatives vanish to rounding are divided out.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] range [axes][2] or NULL for all of it: the part of the domain.
 * \param[in] tolerance in radians, >= 0, may be infinite: halving ends when the angle between some derivative
 *   and the direction is within this of the angle of the cone, or after 2000 halvings.
 * \param[out] direction [dim] unit vector, the axis of the cone: the middle of the coefficients.
 * \param[out] angle half the opening angle, in radians; pi if no smaller one is found, and direction is then
 *   a unit vector without meaning.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _OVERLAP, _TOLERANCE, _NOT_REPRESENTABLE; _PARAMETER_NOT_FINITE,
 *   _OUTSIDE_DOMAIN or _EMPTY_DOMAIN if range is not an interval of the domain.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_tangent_cone(const nurbs *g, int32_t axis, const double *range, double tolerance,
                                          double *direction, double *angle);

/** \brief A cone that contains the directions of all normals S_u x S_v of a surface in space.
 * \param[in] g a surface of dimension 3.
 * \param[in] range [2][2] or NULL for all of it: the part of the domain.
 * \param[in] tolerance as for nurbs_tangent_cone().
 * \param[out] direction [3] unit vector, the axis of the cone.
 * \param[out] angle half the opening angle, in radians; pi if no smaller one is found.
 * \return as for nurbs_tangent_cone(), and NURBS_ERROR_AXES, _DIMENSION.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_normal_cone(const nurbs *g, const double *range, double tolerance,
                                         double *direction, double *angle);

/** \brief The point of a spline that is farthest in a direction: the largest value of direction . C(t).
 * \param[in] g a spline.
 * \param[in] direction [dim], not zero.
 * \param[in] range [axes][2] or NULL for all of it: the part of the domain.
 * \param[in] tolerance how much farther another point may be, as a length, >= 0.
 * \param[out] params [axes] or NULL: the parameters of the point. Where g jumps, or ends in the range, the
 *   limit from inside the range may be meant.
 * \param[out] value or NULL: direction . C there.
 * \param[out] bound or NULL: a proven upper bound of the value at all points; at most value + tolerance
 *   |direction|, apart from rounding, unless 20000 halvings do not reach it.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _TOLERANCE, _DIRECTION; _NOT_REPRESENTABLE if the value
 *   overflows, or no weight can be shown to be positive; _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN or
 *   _EMPTY_DOMAIN if range is not an interval of the domain.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_extreme_point(const nurbs *g, const double *direction, const double *range,
                                           double tolerance, double *params, double *value, double *bound);
/** @} */

/** \defgroup analysis Features of a shape
 * \code
 * int64_t count = 0;
 * int32_t complete = 0; // 1: proven that there are no others
 * nurbs_curve_features(curve, NURBS_FEATURE_CUSP, 0, NULL, NULL, NULL, &count, &complete);
 * \endcode
 * Places where something happens on a curve or surface. Features are the zeros of polynomials, and the signs
 * of the Bernstein coefficients of these say how many there are. `complete` receives 1 if it is proven that
 * no feature was missed and each was found once. It receives 0 if zeros lie so close together, or are so
 * flat, that double precision cannot decide, as for extrema along an arc of a circle, whose curvature is
 * constant, and for inflections along a straight line, unless its degree is 1. Polynomials that vanish to
 * rounding at a knot count as 0 there: zeros within rounding of a knot are at the knot. Vectors, such as C'
 * at a cusp, count as 0 if all components vanish to rounding at the zero of one of them.
 * @{ */

/** \name Features of curves
 * Any sum of them may be asked for.
 * @{ */
#define NURBS_FEATURE_INFLECTION 0x01        /**< the curvature changes its sign; in space: it vanishes */
#define NURBS_FEATURE_CURVATURE_MAXIMUM 0x02 /**< a local maximum of |curvature| */
#define NURBS_FEATURE_CURVATURE_MINIMUM 0x04 /**< a local minimum of |curvature|, where it is not 0 */
#define NURBS_FEATURE_CUSP 0x08              /**< the first derivative vanishes */
#define NURBS_FEATURE_KINK 0x10              /**< a knot where the direction of the tangent jumps */
#define NURBS_FEATURE_JUMP 0x20              /**< a knot where the curve jumps */
#define NURBS_FEATURE_TORSION 0x40           /**< the torsion changes its sign (dimension 3) */
/** @} */

/** \name Kinds of extrema
 * Bits: an extremum that is not isolated is also a plateau.
 * @{ */
#define NURBS_EXTREMUM_MINIMUM 0x01   /**< no value beside it is smaller */
#define NURBS_EXTREMUM_MAXIMUM 0x02   /**< no value beside it is larger */
#define NURBS_EXTREMUM_SADDLE 0x04    /**< f turns up along some axes, and down along others */
#define NURBS_EXTREMUM_PLATEAU 0x08   /**< f is constant in the range */
#define NURBS_EXTREMUM_UNDECIDED 0x10 /**< a range in which it is not decided what there is */
/** @} */

/** \name Convexity of a curve in the plane
 * @{ */
#define NURBS_CONVEXITY_NONE 0      /**< turns both ways, or through more than a full turn, or has a cusp */
#define NURBS_CONVEXITY_LEFT 1      /**< turns to the left only, by at most a full turn */
#define NURBS_CONVEXITY_RIGHT 2     /**< turns to the right only, by at most a full turn */
#define NURBS_CONVEXITY_STRAIGHT 3  /**< a straight line that does not turn back, to rounding */
#define NURBS_CONVEXITY_UNDECIDED 4 /**< double precision cannot decide */
/** @} */

/** \name Folds
 * @{ */
#define NURBS_FOLD_NONE 0      /**< proven: there is none */
#define NURBS_FOLD_FOUND 1     /**< proven: there is one */
#define NURBS_FOLD_UNDECIDED 2 /**< neither */
/** @} */

/** \brief Inflections, extrema of curvature, cusps, kinks, jumps and changes of torsion along a curve.
 *
 * The ends of the domain have no features except cusps, even where a curve that is not periodic closes
 * (nurbs_make_periodic()). The seam of a periodic curve has all features, at the lower end of the domain. A
 * curvature that jumps at a knot rises or falls there, so that the knot can be a maximum or a minimum. Where
 * |curvature| stays at a maximum or minimum, the middle of that stretch is returned.
 * \param[in] g a curve of dimension 2 or 3.
 * \param[in] kinds sum of NURBS_FEATURE_ constants.
 * \param[in] cap length of the outputs: 0, or at least the number of features.
 * \param[out] params [cap] or NULL: the parameters, rising.
 * \param[out] found [cap] or NULL: one NURBS_FEATURE_ constant for each.
 * \param[out] values [cap] or NULL: the curvature there (signed in the plane; infinite at most cusps), the
 *   turning angle of a kink (in the plane positive to the left), the width of a jump.
 * \param[out] count or NULL: number of features.
 * \param[out] complete or NULL: 1 if it is proven that there are no others, else 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _FLAGS, _COUNT, _OVERLAP; _DIMENSION also if changes of
 *   torsion are asked for in the plane; _SIZE if cap is neither 0 nor enough; _NOT_REPRESENTABLE if a
 *   coefficient overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_features(const nurbs *g, uint32_t kinds, int64_t cap, double *params,
                                            int32_t *found, double *values, int64_t *count,
                                            int32_t *complete);

/** \brief nurbs_curve_features() with progress reports, cancellation and a limit of work.
 * \param[in] g,kinds,cap as for nurbs_curve_features().
 * \param[out] params,found,values,count,complete as for nurbs_curve_features().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_features(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_features_with(const nurbs *g, uint32_t kinds, int64_t cap, double *params,
                                                 int32_t *found, double *values, int64_t *count,
                                                 int32_t *complete, const nurbs_call_options *call);

/** \brief Local extrema and saddles of a scalar spline f of 1 to 3 axes.
 *
 * (For its global minimum and maximum, with a proven bound, use nurbs_extreme_point() with a direction of -1
 * and 1.)
 *
 * **Extrema.** Seen along one axis, f turns down at a place if it rises before and falls after it, and turns
 * up if it falls before and rises after it. At an end of the domain, f turns down if it falls from there
 * inwards, and up if it rises. Knots where f has a kink are included. Where f jumps, it counts as rising or
 * falling from one limit to the other, and each of the two limits is a place. A minimum turns up along all
 * axes, a maximum down along all axes, and a saddle up along some and down along others. On a side or an edge
 * of the domain, or where f has a kink along some axes, the other axes are replaced by those principal
 * directions of f there in which its derivative vanishes. A saddle on a side is one of the sub- or superlevel
 * sets of f: there is none where f rises into the domain from one side and falls from another. So on a
 * surface that is periodic along both axes, the number of minima less that of saddles plus that of maxima
 * is 0. On a curve, a saddle is where the derivative is 0, from one side at least, and f goes on in the
 * direction in which it came.
 *
 * **Proofs.** Along one axis, the signs of Bernstein coefficients prove what there is, as in nurbs_roots().
 * In a range that rounding cannot resolve there is an extremum of the kind that is returned, and there may be
 * more. Along more axes, each extremum is proven to be the only one in its range (a contraction, by the
 * Krawczyk operator), and the signs of second derivatives determine its kind. What is degenerate to rounding,
 * such as a ridge of constant height, is undecided. So is what has a weight that cannot be shown to be
 * positive, and, along more axes, a jump whose height changes its sign.
 *
 * **Plateaus.** Where control points that are not homogeneous show without rounding that f is constant, on
 * spans or on sides where it ends or has a kink, that is a plateau, its borders included. On a curve it is
 * also a minimum, maximum or saddle, by what f does before and after it. On a side or an edge of a surface or
 * volume it is also a minimum or maximum if f is proven to turn up or down along all axes on which the
 * plateau has no extent, and it is left out where f goes on across it. An f that is constant on all of its
 * domain is a plateau and nothing else.
 * \param[in] g a spline of dimension 1.
 * \param[in] kinds sum of NURBS_EXTREMUM_ constants: extrema of at least one of these kinds are returned.
 * \param[in] cap length of the outputs: 0, or at least the number of extrema.
 * \param[out] params [cap][axes] or NULL: where, in rising order of the first axis, then the second; the
 *   middle of a plateau or of an undecided range. An extremum at the seam of a periodic axis is at its lower
 *   end.
 * \param[out] values [cap] or NULL: f there; at a jump, the limit that is meant.
 * \param[out] found [cap] or NULL: a sum of NURBS_EXTREMUM_ constants for each.
 * \param[out] boxes [cap][axes][2] or NULL: ranges of parameters that contain the extremum, or all of a
 *   plateau. On periodic axes they may begin in the period before or end in the next one.
 * \param[out] count or NULL: number of extrema.
 * \param[out] complete or NULL: 1 if nothing is undecided and there is nothing outside the ranges, kinds that
 *   are not asked for included; else 0. At the limit of work, what was not examined is undecided.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _FLAGS, _COUNT, _OVERLAP, _NOT_REPRESENTABLE; _SIZE if cap
 *   is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_extrema(const nurbs *g, uint32_t kinds, int64_t cap, double *params,
                                     double *values, int32_t *found, double *boxes, int64_t *count,
                                     int32_t *complete);

/** \brief nurbs_extrema() with progress reports, cancellation and a limit of work.
 * \param[in] g,kinds,cap as for nurbs_extrema().
 * \param[out] params,values,found,boxes,count,complete as for nurbs_extrema().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_extrema(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_extrema_with(const nurbs *g, uint32_t kinds, int64_t cap, double *params,
                                          double *values, int32_t *found, double *boxes, int64_t *count,
                                          int32_t *complete, const nurbs_call_options *call);

/** \brief The pieces of a curve on which it runs one way along a direction.
 *
 * On each piece direction . C(t) rises, falls or, to rounding, is constant on whole Bezier pieces. A jump
 * begins a piece.
 * \param[in] g a curve.
 * \param[in] direction [dim], not zero.
 * \param[in] cap length of the outputs: 0, or at least the number of pieces.
 * \param[out] starts [cap] or NULL: the lower ends of the pieces, rising.
 * \param[out] signs [cap] or NULL: 1 where direction . C(t) rises, -1 where it falls, or 0.
 * \param[out] count or NULL: number of pieces.
 * \param[out] complete or NULL: 1 if rounding hides no change of direction, else 0.
 * \return as for nurbs_curve_features(), and NURBS_ERROR_DIRECTION.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_monotone_pieces(const nurbs *g, const double *direction, int64_t cap,
                                                   double *starts, int32_t *signs, int64_t *count,
                                                   int32_t *complete);

/** \brief Whether a curve in the plane is convex: whether it turns one way only, and by at most a full turn.
 *
 * Kinks are included. The answer is to rounding: where double precision cannot decide whether the curve
 * turns, pieces count as straight, and places as not turning. A curve that jumps is not convex.
 * \param[in] g a curve of dimension 2.
 * \param[out] convexity one of the NURBS_CONVEXITY_ constants.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _NOT_REPRESENTABLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_curve_convexity(const nurbs *g, int32_t *convexity);

/** \brief How far a spline is from a straight line: a line near the best one, and a proven bound.
 * \param[in] g a spline.
 * \param[out] origin [dim] or NULL: a point of the line.
 * \param[out] direction [dim] or NULL: unit vector, from the start of a curve towards its end where they
 *   differ.
 * \param[out] bound no point of g is farther from the line than this.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _NOT_REPRESENTABLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_straightness(const nurbs *g, double *origin, double *direction, double *bound);

/** \brief How far a spline in space is from a plane: a plane near the best one, and a proven bound.
 * \param[in] g a spline of dimension 3.
 * \param[out] origin [3] or NULL: a point of the plane.
 * \param[out] normal [3] or NULL: unit vector, its largest component positive.
 * \param[out] bound no point of g is farther from the plane than this.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _OVERLAP, _NOT_REPRESENTABLE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_planarity(const nurbs *g, double *origin, double *normal, double *bound);

/** \brief Which axes of a spline close and which of its boundaries collapse, with proven bounds.
 *
 * Boundaries are counted by axis, then by end.
 * \param[in] g a spline.
 * \param[in] tolerance the largest distance that counts as zero, >= 0.
 * \param[out] closed [axes] or NULL: 1 where the two boundaries of an axis are nowhere farther apart than the
 *   tolerance, at equal parameters, else 0.
 * \param[out] gaps [axes] or NULL: the two boundaries of the axis are nowhere farther apart than this, at
 *   equal parameters. 0 on a periodic axis, whose boundaries are one by definition, however its knots are
 *   rounded. Elsewhere the rounding of boundaries that are not clamped is in the gaps, and in the sizes.
 * \param[out] collapsed [2 * axes] or NULL: 1 where a boundary lies within the tolerance of one point (the
 *   pole), else 0; of a curve always 1.
 * \param[out] sizes [2 * axes] or NULL: the boundary lies within this distance of a point.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _TOLERANCE, _NOT_REPRESENTABLE; _WEIGHTS_VANISH as for
 *   nurbs_boundaries().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_boundary_contacts(const nurbs *g, double tolerance, int32_t *closed,
                                               double *gaps, int32_t *collapsed, double *sizes);

/** \brief Places where a curve or surface is singular: C' = 0, or S_u x S_v = 0.
 *
 * The latter says that the two first derivatives are parallel, or that one of them vanishes. Singular lines,
 * such as collapsed edges, are represented by one point on each piece that they cross.
 * \param[in] g a curve or a surface.
 * \param[in] tolerance > 0: the size in the parameters, relative to the domain, to which places are resolved.
 * \param[in] cap length of the outputs: 0, or at least the number of places.
 * \param[out] params [cap][axes] or NULL: where.
 * \param[out] boxes [cap][axes][2] or NULL: intervals of the parameters in which the singular set around the
 *   place lies.
 * \param[out] count or NULL: number of places.
 * \param[out] complete or NULL: 1 if it is proven that g is regular everywhere outside the boxes, except for
 *   boundaries of Bezier pieces that vanish to rounding, which are places with boxes of no width; else 0.
 *   Boxes are larger than the tolerance where 20000 halvings do not reach it.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _TOLERANCE, _COUNT, _OVERFLOW, _OVERLAP, _NOT_REPRESENTABLE;
 *   _SIZE if cap is neither 0 nor enough.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_singular_points(const nurbs *g, double tolerance, int64_t cap, double *params,
                                             double *boxes, int64_t *count, int32_t *complete);

/** \brief Whether a surface or volume folds over: whether the sign of J changes.
 *
 * For a surface in the plane or a volume in space, J is the determinant of the first derivatives; for a
 * surface in space, J is (S_u x S_v) . reference. Where J is 0 only on collapsed boundaries, there is no
 * fold. The result is undecided if 20000 halvings do not decide it, if J comes to 0 inside without a change
 * of sign, and for volumes whose degrees are together so high that J has more coefficients than can be formed
 * in seconds.
 * \param[in] g a surface of dimension 2 or 3, or a volume of dimension 3.
 * \param[in] reference [3] or NULL for the vector area, the integral of S_u x S_v: for a surface in space,
 *   the direction that normals are compared with; for others it must be NULL.
 * \param[out] result one of the NURBS_FOLD_ constants.
 * \param[out] positive [axes] or NULL: parameters with J > 0, NaN if none are known.
 * \param[out] negative [axes] or NULL: parameters with J < 0, NaN if none are known.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _OVERLAP, _NOT_REPRESENTABLE; _DIRECTION if
 *   reference is zero, not finite or not NULL where it has to be, or the vector area vanishes, as that of a
 *   closed surface does.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_fold_test(const nurbs *g, const double *reference, int32_t *result,
                                       double *positive, double *negative);

/** \brief nurbs_fold_test() with progress reports, cancellation and a limit of work.
 * \param[in] g,reference as for nurbs_fold_test().
 * \param[out] result,positive,negative as for nurbs_fold_test().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_fold_test(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fold_test_with(const nurbs *g, const double *reference, int32_t *result,
                                            double *positive, double *negative,
                                            const nurbs_call_options *call);

/** \brief nurbs_fold_test() of each polynomial piece by itself.
 *
 * The pieces are in the order of nurbs_bezier_pieces() and nurbs_bezier_cells(), and all have one reference.
 * \param[in] g,reference as for nurbs_fold_test().
 * \param[in] cap length of the outputs: 0, or at least the number of pieces.
 * \param[out] folds [cap] or NULL: a NURBS_FOLD_ constant for each piece; undecided if 2000 halvings do not
 *   decide it.
 * \param[out] signs [cap] or NULL: if there is no fold, 1 or -1: the sign that J is proven to have wherever
 *   in the piece it is not 0; else 0, also where J is 0 everywhere.
 * \param[out] count or NULL: number of pieces.
 * \return as for nurbs_fold_test(), and NURBS_ERROR_COUNT, _OVERFLOW; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fold_pieces(const nurbs *g, const double *reference, int64_t cap, int32_t *folds,
                                         int32_t *signs, int64_t *count);

/** \brief nurbs_fold_pieces() with progress reports, cancellation and a limit of work.
 * \param[in] g,reference,cap as for nurbs_fold_pieces().
 * \param[out] folds,signs,count as for nurbs_fold_pieces().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_fold_pieces(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fold_pieces_with(const nurbs *g, const double *reference, int64_t cap,
                                              int32_t *folds, int32_t *signs, int64_t *count,
                                              const nurbs_call_options *call);
/** @} */

/** \defgroup intersections Where shapes meet
 * \code
 * const double plane[] = {0, 0, 1, -0.5}; // z = 0.5
 * double params[8];
 * int64_t count = 0;
 * int32_t complete = 0; // 1: proven that there are no others
 * nurbs_curve_level(curve, 1, plane, 1e-9, 8, params, NULL, NULL, &count, &complete);
 *
 * const double eye[] = {0, 0, 10}, down[] = {0, 0, -1};
 * double uv[2], distance;
 * int32_t status = 0; // NURBS_RAY_HIT | NURBS_RAY_CERTIFIED: proven to be the first
 * nurbs_surface_rays(surface, 1, eye, 0, 0, down, 0, 0, uv, &distance, &status);
 *
 * const double up[] = {0, 0, 1}, heights[] = {0.25, 0.5, 0.75};
 * nurbs_meet *meet = NULL;
 * int64_t branches = 0;
 * nurbs_surface_sections(surface, up, 3, heights, 1e-6, &meet); // curves to within 1e-6
 * nurbs_meet_counts(meet, &branches, NULL, &complete);
 * for (int64_t i = 0; i < branches; ++i) {
 *     nurbs *space = NULL, *on_surface = NULL;
 *     nurbs_meet_branch(meet, i, &space, &on_surface);
 *     nurbs_destroy(space);
 *     nurbs_destroy(on_surface);
 * }
 * nurbs_meet_destroy(meet);
 * \endcode
 * Every answer says what is proven. Each hit has a kind and a range of parameters, and it is proven that
 * there is no solution outside the ranges; `complete` is 1 if no hit is undecided. With a tolerance of 0 only
 * what double precision proves is decided: a touch to rounding is undecided, unless the control points show
 * without any rounding that the shapes touch.
 *
 * A nurbs_meet holds the curves of an intersection, a section, a contour or a projection. Its branches are
 * these curves, its nodes the places where branches end and the parts in which something is not resolved, and
 * a way is a chain of branches, each of which continues the one before.
 * @{ */

/** \name Kinds of hits
 * @{ */
#define NURBS_HIT_CROSSING 1  /**< passes from one side to the other, or has an end there */
#define NURBS_HIT_TANGENT 2   /**< a touch, as far as rounding and the tolerance can tell */
#define NURBS_HIT_CONTACT 3   /**< within the tolerance, but proven apart: the nearest place */
#define NURBS_HIT_OVERLAP 4   /**< within the tolerance in the whole range, which is a span or more */
#define NURBS_HIT_JUMP 5      /**< changes sides where the curve jumps, without meeting anything */
#define NURBS_HIT_UNDECIDED 6 /**< a range in which it is not decided what there is */
/** @} */

/** \brief Roots of a scalar curve: where f(t) = value.
 *
 * The signs of Bernstein coefficients prove how many roots there are (Descartes' rule of signs), so that none
 * is lost or reported twice, not even at knots and ends. Where |f - value| <= tolerance on a whole knot span
 * or more, that range is one hit, an overlap, unless it contains exactly one root.
 * \param[in] g a curve of dimension 1, the function f.
 * \param[in] value the value that f has to take, finite.
 * \param[in] tolerance largest |f - value| that counts as zero, >= 0.
 * \param[in] cap length of the outputs: 0, or at least the number of hits.
 * \param[out] params [cap] or NULL: the parameters, in rising order; for an overlap or an undecided range,
 *   its middle. A root at the seam of a periodic curve is reported at the lower end of the domain.
 * \param[out] kinds [cap] or NULL: one of the NURBS_HIT_ constants for each hit.
 * \param[out] ranges [cap][2] or NULL: ranges of parameters: for a crossing or a tangent the range that
 *   contains the root, for a contact or an overlap the range in which |f - value| <= tolerance. On periodic
 *   curves a range may end in the next period. Where the curve jumps, the limit from either side may be
 *   meant.
 * \param[out] count or NULL: number of hits.
 * \param[out] complete or NULL: 1 if no hit is undecided, else 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _TOLERANCE, _COUNT, _OVERFLOW, _OVERLAP,
 *   _NOT_REPRESENTABLE; _POINT_NOT_FINITE if value is not finite, _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_roots(const nurbs *g, double value, double tolerance, int64_t cap,
                                   double *params, int32_t *kinds, double *ranges, int64_t *count,
                                   int32_t *complete);

/** \brief nurbs_roots() with progress reports, cancellation and a limit of work.
 * \param[in] g,value,tolerance,cap as for nurbs_roots().
 * \param[out] params,kinds,ranges,count,complete as for nurbs_roots().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_roots(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_roots_with(const nurbs *g, double value, double tolerance, int64_t cap,
                                        double *params, int32_t *kinds, double *ranges, int64_t *count,
                                        int32_t *complete, const nurbs_call_options *call);

/** \brief Where a curve meets a line, plane, conic, sphere, quadric or other set f(x) = 0 of a polynomial f.
 *
 * The coefficients of f are those of the products x_i x_j ... of `degree` factors with i <= j <= ..., in
 * lexicographic order, where x_dim stands for 1:
 *
 *     a x + b y + c of a line in the plane, a x + b y + c z + d of a plane,
 *     a x x + b x y + c x + d y y + e y + f of a conic,
 *     a x x + b x y + c x z + d x + e y y + f y z + g y + h z z + i z + j of a quadric.
 * \param[in] g a curve.
 * \param[in] degree the degree of f, 1 to 8.
 * \param[in] coefficients [M], M = (dim + degree)! / (dim! degree!), of which at least one before the last is
 *   not 0.
 * \param[in] tolerance largest |f| that counts as zero, >= 0. It is a distance if degree is 1 and (a, b, c)
 *   is a unit vector, and nearly one for a sphere written as (|x - m|^2 - r^2) / (2 r).
 * \param[in] cap length of the outputs: 0, or at least the number of hits.
 * \param[out] params,kinds,ranges,count,complete as for nurbs_roots(), of f along the curve.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _TOLERANCE, _COUNT, _OVERFLOW, _OVERLAP, _NOT_REPRESENTABLE;
 *   _DEGREE also if a degree above 1 takes more than 10000 coefficients, _POINT_NOT_FINITE if one is not
 *   finite, _DIRECTION if all but the last are 0, _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_level(const nurbs *g, int32_t degree, const double *coefficients,
                                         double tolerance, int64_t cap, double *params, int32_t *kinds,
                                         double *ranges, int64_t *count, int32_t *complete);

/** \brief nurbs_curve_level() with progress reports, cancellation and a limit of work.
 * \param[in] g,degree,coefficients,tolerance,cap as for nurbs_curve_level().
 * \param[out] params,kinds,ranges,count,complete as for nurbs_curve_level().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_level(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_level_with(const nurbs *g, int32_t degree, const double *coefficients,
                                              double tolerance, int64_t cap, double *params, int32_t *kinds,
                                              double *ranges, int64_t *count, int32_t *complete,
                                              const nurbs_call_options *call);

/** \brief Where two curves meet: all places at which they come as near as the tolerance.
 *
 * Parts of the curves that cross are proven to meet exactly once (a contraction, by the Krawczyk operator).
 * Parts within the tolerance of each other that are connected form one overlap if they contain a whole span
 * of one of the curves, or begin and end where one of the curves has a knot or an end. All other parts within
 * the tolerance are resolved without the tolerance, into
 * - crossings. In the plane there is also a crossing where a changes its side of b in a range that rounding
 *   cannot resolve; it may stand for any odd number of crossings.
 * - tangents.
 * - a contact, if they contain nothing else.
 *
 * In space and in higher dimensions no two curves are proven to meet: what meets to rounding is a crossing.
 * With a tolerance of 0 it is undecided, as are ends on the other curve, and overlaps, unless both curves
 * have the same control point there. Nothing is met in the gap between the two limits of a curve that jumps.
 * A curve that closes without being periodic has two ends, and a hit at each.
 * \param[in] a,b curves of the same dimension, 2 or more. They must not be the same curve or clones of it:
 *   for that there is nurbs_curve_self_intersections().
 * \param[in] tolerance the largest distance that counts as zero, >= 0.
 * \param[in] cap length of the outputs: 0, or at least the number of hits.
 * \param[out] params_a,params_b [cap] or NULL: parameters on both curves, rising on a: for an overlap its
 *   middle, otherwise the nearest places found.
 * \param[out] kinds [cap] or NULL: one of the NURBS_HIT_ constants for each hit.
 * \param[out] ranges_a [cap][2] or NULL: ranges of parameters of a: for a crossing or a tangent the range
 *   that contains it, for a contact the range that is near. The range of an overlap ends where the first of
 *   the two curves ends, or where they part, to within the tolerance along the curves. On periodic curves a
 *   range may end in the next period.
 * \param[out] ranges_b [cap][2] or NULL: the same for b; falling where an overlap runs against b.
 * \param[out] count or NULL: number of hits.
 * \param[out] complete or NULL: 1 if there is nothing within the tolerance besides the hits and none of them
 *   is undecided, else 0. At the limit of work, what was not examined is undecided.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _SAME, _DIMENSION, _INCOMPATIBLE, _TOLERANCE, _COUNT, _OVERFLOW,
 *   _OVERLAP, _NOT_REPRESENTABLE; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_intersections(const nurbs *a, const nurbs *b, double tolerance,
                                                 int64_t cap, double *params_a, double *params_b,
                                                 int32_t *kinds, double *ranges_a, double *ranges_b,
                                                 int64_t *count, int32_t *complete);

/** \brief nurbs_curve_intersections() with progress reports, cancellation and a limit of work.
 * \param[in] a,b,tolerance,cap as for nurbs_curve_intersections().
 * \param[out] params_a,params_b,kinds,ranges_a,ranges_b,count,complete as for nurbs_curve_intersections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_intersections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_intersections_with(const nurbs *a, const nurbs *b, double tolerance,
                                                      int64_t cap, double *params_a, double *params_b,
                                                      int32_t *kinds, double *ranges_a, double *ranges_b,
                                                      int64_t *count, int32_t *complete,
                                                      const nurbs_call_options *call);

/** \brief Where a curve meets itself, at pairs of parameters a < b.
 *
 * Hits are those of nurbs_curve_intersections() between parts of the curve. A part is proven to be simple if
 * the component of its derivative along some vector is nowhere 0. A pair of places does not count if all of
 * the curve between them stays near them, to about the tolerance, nor do the two ends of a curve that closes.
 * At a cusp, and where a curve turns back, double precision cannot exclude a loop of zero size: with a
 * tolerance of 0 such places are undecided. nurbs_singular_points() finds them.
 * \param[in] g a curve of dimension 2 or more.
 * \param[in] tolerance the largest distance that counts as zero, >= 0.
 * \param[in] cap length of the outputs: 0, or at least the number of hits.
 * \param[out] params_a,params_b [cap] or NULL: both parameters, params_a < params_b, in the order of
 *   params_a.
 * \param[out] kinds,ranges_a,ranges_b,count,complete as for nurbs_curve_intersections(). If count is 0 and
 *   complete is 1, the curve is proven to be simple.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _TOLERANCE, _COUNT, _OVERFLOW, _OVERLAP,
 *   _NOT_REPRESENTABLE; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_self_intersections(const nurbs *g, double tolerance, int64_t cap,
                                                      double *params_a, double *params_b, int32_t *kinds,
                                                      double *ranges_a, double *ranges_b, int64_t *count,
                                                      int32_t *complete);

/** \brief nurbs_curve_self_intersections() with progress reports, cancellation and a limit of work.
 * \param[in] g,tolerance,cap as for nurbs_curve_self_intersections().
 * \param[out] params_a,params_b,kinds,ranges_a,ranges_b,count,complete as for
 *   nurbs_curve_self_intersections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_self_intersections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_self_intersections_with(const nurbs *g, double tolerance, int64_t cap,
                                                           double *params_a, double *params_b, int32_t *kinds,
                                                           double *ranges_a, double *ranges_b, int64_t *count,
                                                           int32_t *complete, const nurbs_call_options *call);

/** \brief Where a curve meets a surface: all places at which they come as near as the tolerance.
 *
 * Parts that pass through each other are proven to meet exactly once (a contraction, by the Krawczyk
 * operator). Parts within the tolerance of each other that are connected form one overlap if the curve is
 * that near along a whole span of its own, or from a knot or an end of either shape to the next. All other
 * parts within the tolerance are resolved without the tolerance, into
 * - crossings. There is also a crossing where the curve changes its side of the surface in a range that
 *   rounding cannot resolve; it may stand for any odd number of crossings.
 * - tangents.
 * - a contact, if they contain nothing else.
 *
 * An end of the curve on the surface, and a meeting on the border of the surface, is a crossing, to rounding.
 * With a tolerance of 0 it is undecided, as are tangents and overlaps, unless both shapes have the same
 * control point there. A surface continues across opposite borders that are one curve, and across a border
 * that is one point if the other borders close around it: what lies there is one hit. Overlaps where S_u and
 * S_v are parallel, or nearly so, are undecided. Nothing is met in the gap between the two limits where the
 * curve or the surface jumps. A curve that closes without being periodic has two ends, and a hit at each.
 * \param[in] curve a curve of dimension 3.
 * \param[in] surface a surface of dimension 3.
 * \param[in] tolerance the largest distance that counts as zero, >= 0.
 * \param[in] cap length of the outputs: 0, or at least the number of hits.
 * \param[out] params_curve [cap] or NULL: parameters of the curve, rising: for an overlap about its middle,
 *   otherwise the nearest place found.
 * \param[out] params_surface [cap][2] or NULL: parameters of the surface.
 * \param[out] kinds [cap] or NULL: one of the NURBS_HIT_ constants for each hit.
 * \param[out] ranges_curve [cap][2] or NULL: ranges of parameters of the curve: for a crossing or a tangent
 *   the range that contains it, for a contact the range that is near. The range of an overlap ends where the
 *   first of the two shapes ends, or where they part, to within the tolerance. On periodic curves a range may
 *   end in the next period.
 * \param[out] ranges_surface [cap][2][2] or NULL: the same for the surface, lower and upper end along each
 *   axis. Where the surface is periodic or closes, a range may end in the next period.
 * \param[out] count or NULL: number of hits.
 * \param[out] complete or NULL: 1 if there is nothing within the tolerance besides the hits and none of them
 *   is undecided, else 0. At the limit of work, what was not examined is undecided.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _INCOMPATIBLE, _TOLERANCE, _COUNT, _OVERFLOW,
 *   _OVERLAP, _NOT_REPRESENTABLE; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_surface_intersections(const nurbs *curve, const nurbs *surface,
                                                         double tolerance, int64_t cap, double *params_curve,
                                                         double *params_surface, int32_t *kinds,
                                                         double *ranges_curve, double *ranges_surface,
                                                         int64_t *count, int32_t *complete);

/** \brief nurbs_curve_surface_intersections() with progress reports, cancellation and a limit of work.
 * \param[in] curve,surface,tolerance,cap as for nurbs_curve_surface_intersections().
 * \param[out] params_curve,params_surface,kinds,ranges_curve,ranges_surface as for
 *   nurbs_curve_surface_intersections().
 * \param[out] count,complete as for nurbs_curve_surface_intersections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_curve_surface_intersections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_curve_surface_intersections_with(
    const nurbs *curve, const nurbs *surface, double tolerance, int64_t cap, double *params_curve,
    double *params_surface, int32_t *kinds, double *ranges_curve, double *ranges_surface, int64_t *count,
    int32_t *complete, const nurbs_call_options *call);

/** \brief The points that three surfaces have in common: all of them, proven to be all.
 *
 * Let F = (A(u, v) - B(s, t), A(u, v) - C(p, q)), and let M be the inverse of its derivative. Triples of
 * parts of Bezier pieces are halved until their boxes have no common part, or a row of M F is nowhere 0, or
 * the largest row sum of |I - M F'| is below 1. In the last case they contain at most one common point, which
 * the Krawczyk operator locates. So a point at which the three tangent planes have no common direction is
 * proven to be one, to rounding where it lies on a border or on a knot at which a surface has a kink.
 *
 * NURBS_HIT_UNDECIDED marks a part in which it is left open what there is: the tangent planes have a common
 * direction, or nearly have one, as where the three surfaces share a curve or a region, which is reported in
 * parts that are connected on a; or a derivative vanishes, as at poles; or the limit of work came first.
 * Costs: about 10 microseconds for each triple of pieces that come together, and more where they run along
 * each other.
 * \param[in] a,b,c surfaces of dimension 3.
 * \param[in] tolerance the size in space, >= 0, of parts that need not be resolved further; 0: what double
 *   precision resolves.
 * \param[in] cap length of the outputs: 0, or at least the number of points.
 * \param[out] params [cap][6] or NULL: both parameters of a, then of b, then of c, in the order of those of
 *   a; for an undecided part, its middle.
 * \param[out] points [cap][3] or NULL: the points, as evaluated on a.
 * \param[out] kinds [cap] or NULL: NURBS_HIT_CROSSING or NURBS_HIT_UNDECIDED for each.
 * \param[out] ranges [cap][6][2] or NULL: lower and upper end of each of these parameters. There are no
 *   common points outside the ranges, and those of a crossing contain exactly one. What lies on a seam is
 *   reported on one side of it. The ranges of a part on both sides of a seam run beyond the upper end of the
 *   domain.
 * \param[out] count or NULL: number of points.
 * \param[out] complete or NULL: 1 if none is undecided, else 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _TOLERANCE, _COUNT, _OVERFLOW, _OVERLAP,
 *   _NOT_REPRESENTABLE; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surfaces_common_points(const nurbs *a, const nurbs *b, const nurbs *c,
                                                    double tolerance, int64_t cap, double *params,
                                                    double *points, int32_t *kinds, double *ranges,
                                                    int64_t *count, int32_t *complete);

/** \brief nurbs_surfaces_common_points() with progress reports, cancellation and a limit of work.
 * \param[in] a,b,c,tolerance,cap as for nurbs_surfaces_common_points().
 * \param[out] params,points,kinds,ranges,count,complete as for nurbs_surfaces_common_points().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_surfaces_common_points(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surfaces_common_points_with(const nurbs *a, const nurbs *b, const nurbs *c,
                                                         double tolerance, int64_t cap, double *params,
                                                         double *points, int32_t *kinds, double *ranges,
                                                         int64_t *count, int32_t *complete,
                                                         const nurbs_call_options *call);

/** \name Status of a ray
 * @{ */
#define NURBS_RAY_HIT 0x01       /**< the ray meets the surface there, to rounding */
#define NURBS_RAY_CERTIFIED 0x02 /**< nothing is nearer; without NURBS_RAY_HIT: it meets nothing */
#define NURBS_RAY_TOUCH 0x04     /**< it touches the surface there or just misses it: rounding cannot tell */
#define NURBS_RAY_BACK 0x08 /**< it arrives from behind: from the side to which S_u x S_v does not point */
/** @} */

/** \brief The first hits of rays x = origin + t direction, t >= 0, with a surface.
 *
 * A part of a Bezier piece is settled when a contraction (the Krawczyk operator, for two planes through the
 * ray) proves that it meets the ray exactly once or never; other parts are halved. The proofs include
 * rounding: a certified answer holds for a ray that passes within some units of rounding of the given one,
 * relative to the size of the surface and the distance of the origin. So a ray through the common edge of two
 * pieces, or along the edge of the surface, hits. At a jump the limit from either side may be meant. The
 * first call builds a tree of boxes, which is kept.
 * \param[in] g a surface of dimension 3.
 * \param[in] n number of rays.
 * \param[in] origins [n][3] the origins of the rays.
 * \param[in] origin_stride,origin_component_stride layout of origins, 0 = packed.
 * \param[in] directions [n][3] their directions, of any length but 0.
 * \param[in] direction_stride,direction_component_stride layout of directions, 0 = packed.
 * \param[out] params [n][2] or NULL: parameters of the surface; NaN where there is neither a hit nor a touch.
 * \param[out] distances [n] or NULL: t, in units of the length of the direction; NaN where params are.
 * \param[out] status [n] or NULL: sums of NURBS_RAY_ bits. A touch is reported if it comes before all hits;
 *   it may be a near miss. Without NURBS_RAY_CERTIFIED it was left open after some thousand boxes whether
 *   anything is nearer.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP;
 *   _POINT_NOT_FINITE if an origin is not finite, _DIRECTION if a direction is not finite or 0.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_rays(const nurbs *g, int64_t n, const double *origins,
                                          int64_t origin_stride, int64_t origin_component_stride,
                                          const double *directions, int64_t direction_stride,
                                          int64_t direction_component_stride, double *params,
                                          double *distances, int32_t *status);

/** \brief nurbs_surface_rays() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work, rays that were not examined have no status bits.
 * \param[in] g,n,origins,origin_stride,origin_component_stride,directions as for nurbs_surface_rays().
 * \param[in] direction_stride,direction_component_stride as for nurbs_surface_rays().
 * \param[out] params,distances,status as for nurbs_surface_rays().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_surface_rays(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_rays_with(const nurbs *g, int64_t n, const double *origins,
                                               int64_t origin_stride, int64_t origin_component_stride,
                                               const double *directions, int64_t direction_stride,
                                               int64_t direction_component_stride, double *params,
                                               double *distances, int32_t *status,
                                               const nurbs_call_options *call);

/** \brief All places where a ray meets a surface, in the order of rising t.
 *
 * They are found as nurbs_surface_rays() finds the first one.
 * \param[in] g a surface of dimension 3.
 * \param[in] origin [3] the origin of the ray.
 * \param[in] direction [3] its direction, of any length but 0.
 * \param[in] range [2] or NULL for {0, INFINITY}: lower and upper end of the t that count, infinite ones
 *   allowed.
 * \param[in] cap length of the outputs: 0, or at least the number of places.
 * \param[out] params [cap][2] or NULL: parameters of the surface.
 * \param[out] distances [cap] or NULL: t, in units of the length of the direction.
 * \param[out] kinds [cap] or NULL: NURBS_RAY_HIT, to which NURBS_RAY_BACK may be added, or NURBS_RAY_TOUCH.
 * \param[out] count or NULL: number of places.
 * \param[out] complete or NULL: 1 if there are no others and none of them is a touch, else 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _COUNT, _OVERFLOW, _OVERLAP, _POINT_NOT_FINITE,
 *   _DIRECTION as for nurbs_surface_rays(); _EMPTY_DOMAIN if range[0] > range[1] or one is NaN, _SIZE if cap
 *   is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_ray_hits(const nurbs *g, const double *origin, const double *direction,
                                              const double *range, int64_t cap, double *params,
                                              double *distances, int32_t *kinds, int64_t *count,
                                              int32_t *complete);
/** \name Kinds of nodes of a nurbs_meet
 * @{ */
#define NURBS_NODE_BORDER 1    /**< the surface ends or jumps there */
#define NURBS_NODE_SEAM 2      /**< it closes there on a non-periodic axis: the branch continues beyond */
#define NURBS_NODE_TOUCH 3     /**< a part within the tolerance in which branches are not separated */
#define NURBS_NODE_UNDECIDED 4 /**< a part in which it is not decided what there is */
#define NURBS_NODE_EDGE                                                                                      \
    5 /**< an edge, a corner or a pole of faces of a model, where another branch continues */
#define NURBS_NODE_FOLD                                                                                      \
    6 /**< the surface folds, seen along the direction of a projection, or feet do: another sheet continues */
#define NURBS_NODE_OVERLAP                                                                                   \
    7 /**< a region in which two surfaces are within the tolerance of each other; no branch ends there */
/** @} */

/** \brief Where planes normal . x = offset cut a surface: all curves, proven to be all.
 *
 * Bezier pieces are halved until normal . S is strictly monotone in one parameter, so that the section is a
 * graph over the other one, in which neither a loop nor an end can hide; the curves of neighbouring parts end
 * in the same places. Every branch has normal . S > offset on its left in the parameter domain. In space it
 * runs along normal x N with N = S_u x S_v: around a body whose N points outwards it runs counterclockwise,
 * as seen from the tip of the normal. Branches close, or end in nodes: at borders of the surface, at seams,
 * and in
 * - TOUCH: all of the part is within the tolerance of the plane, or of what rounding makes of it, and the
 *   section in it is not resolved. It is a peak, a pit, a saddle or a pole at the offset, a place where a
 *   border, a corner or a crease touches the plane, or a piece that lies in the plane. A loop that fits into
 *   the tolerance may be one, too, and a small branch may begin and end in one.
 * - UNDECIDED: the limit of work came first, or the surface is too nearly singular for double precision.
 *
 * Outside these nodes the branches are all there is, to within their deviations. Where f = normal . S -
 * offset is 0 to rounding along a border or a crease, it counts as positive: a border that lies in the plane
 * is a branch where f < 0 or f > 0 beside it; a crease that lies in the plane is a TOUCH if f > 0 on both
 * sides, and two branches, there and back, if f < 0 on both sides. Costs: a few microseconds for each piece
 * that is cut, and for each piece of a curve.
 * \param[in] g a surface of dimension 3.
 * \param[in] normal [3] the normal of the planes, of any length but 0.
 * \param[in] n number of planes.
 * \param[in] offsets [n] in any order; the signed distance of a plane from 0 is offset / |normal|.
 * \param[in] tolerance > 0: the largest distance of the curves from the section.
 * \param[out] out the new meet; its branches are in the order of the planes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _COUNT, _OVERFLOW, _TOLERANCE, _NOT_REPRESENTABLE;
 *   _DIRECTION if the normal is not finite or 0, _POINT_NOT_FINITE if an offset is not finite.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_sections(const nurbs *g, const double *normal, int64_t n,
                                              const double *offsets, double tolerance, nurbs_meet **out);

/** \brief nurbs_surface_sections() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work, what was not examined is undecided, and curves keep the deviation that they have.
 * \param[in] g,normal,n,offsets,tolerance as for nurbs_surface_sections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_surface_sections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_sections_with(const nurbs *g, const double *normal, int64_t n,
                                                   const double *offsets, double tolerance,
                                                   const nurbs_call_options *call, nurbs_meet **out);

/** \name Kinds of contours
 * For a surface S with N = S_u x S_v, a vector d and a number c: the curves where f = 0. Where N is 0, at
 * poles and singular points, f is 0 for that reason alone: sides that collapse are left out, other such
 * places are nodes.
 * @{ */
#define NURBS_CONTOUR_SILHOUETTE 1  /**< f = N . d: the outline seen along d */
#define NURBS_CONTOUR_PERSPECTIVE 2 /**< f = N . (S - d): the outline seen from the point d */
#define NURBS_CONTOUR_ISOPHOTE                                                                               \
    3 /**< (N . d)^2 = c^2 |N|^2 |d|^2 where N . d has the sign of c: normals at one angle to d */
#define NURBS_CONTOUR_PARABOLIC 4 /**< f = K, the Gaussian curvature, up to a positive factor */
/** @} */

/** \brief Silhouettes, isophotes and parabolic curves of a surface: all of them, proven to be all.
 *
 * They are returned as curves in space and in the parameter domain. For each kind f is a polynomial on each
 * Bezier piece, whose zeros are traced as by nurbs_surface_sections(), with f > 0 on the left of branches. As
 * f is no distance, zeros are separated as far as double precision allows: a saddle or a peak of f at 0 is a
 * node TOUCH, and so is all of a surface on which f vanishes, such as a cylinder seen along its axis. A
 * crease at which f jumps from one sign to the other is no zero and is not reported; branches end there.
 * Costs: some ten microseconds for each piece, a hundred for parabolic curves.
 * \param[in] g a surface of dimension 3.
 * \param[in] kind one of the NURBS_CONTOUR_ constants.
 * \param[in] d [3] or NULL: the direction, of any length but 0, or the point; not used for parabolic curves.
 * \param[in] n number of cosines for isophotes; 0 for the other kinds, which have one level, 0.
 * \param[in] cosines [n] or NULL: cosines of the angle between N and d, in [-1, 1], in any order.
 * \param[in] tolerance > 0: the largest distance of the curves in space from the contour.
 * \param[out] out the new meet; its branches are in the order of the cosines.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _OVERFLOW, _TOLERANCE, _NOT_REPRESENTABLE; _RULE if
 *   kind is none of the constants, _DEGREE if f has a degree above 2 NURBS_MAX_DEGREE (for parabolic curves:
 *   if the surface has one above 10, or above 8 with weights), _COUNT if n < 0, or > 0 for a kind without
 *   cosines, _DIRECTION if d is needed and is not finite or is a direction of length 0, _FACTOR if a cosine
 *   is not in [-1, 1].
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_contours(const nurbs *g, int32_t kind, const double *d, int64_t n,
                                              const double *cosines, double tolerance, nurbs_meet **out);

/** \brief nurbs_surface_contours() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_surface_sections_with().
 * \param[in] g,kind,d,n,cosines,tolerance as for nurbs_surface_contours().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_surface_contours(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_contours_with(const nurbs *g, int32_t kind, const double *d, int64_t n,
                                                   const double *cosines, double tolerance,
                                                   const nurbs_call_options *call, nurbs_meet **out);

/** \name Kinds of reflection lines
 * For a surface S with N = S_u x S_v and a line of light through a along l: the curves where f = 0, with
 * m = (S - a) x l.
 * @{ */
#define NURBS_REFLECTION_HIGHLIGHT 1 /**< f = N . m: the line along the normal meets the line of light */
#define NURBS_REFLECTION_ALONG                                                                               \
    2 /**< f = (N . N) (v . m) - 2 (N . v) (N . m), v = eye: the mirrored line of sight meets it */
#define NURBS_REFLECTION_FROM 3 /**< the same with v = S - eye: seen from the point eye */
/** @} */

/** \brief Reflection lines and highlight lines of a surface, which show how fair it is.
 *
 * They are the lines of light that the surface mirrors: all of them, proven to be all, found as
 * nurbs_surface_contours() finds contours. Seen along a direction or from a point they are reflection lines
 * (R. Klass, CAD 12 (1980)). Where the normals themselves meet the line of light they are highlight lines
 * (K.-P. Beier & Y. Chen, CAD 26 (1994)), which are the circular silhouettes around that line: there a
 * rotation about the line moves the surface along itself. Lines of light extend in both directions, and so do
 * mirrored lines of sight. Where the surface is only tangent continuous the curves have kinks, and where it
 * is only continuous they are broken. All of a surface of revolution about the line is one of its highlight
 * lines, a node TOUCH. Costs: some ten microseconds for each piece for highlight lines, a hundred for the
 * others.
 * \param[in] g a surface of dimension 3.
 * \param[in] kind one of the NURBS_REFLECTION_ constants.
 * \param[in] eye [3] or NULL: the direction, of any length but 0, or the point; not used for highlight lines.
 * \param[in] direction [3]: l, of any length but 0.
 * \param[in] n number of lines of light.
 * \param[in] points [n][3]: a of each line.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] tolerance > 0: the largest distance of the curves in space from the reflection line.
 * \param[out] out the new meet; its branches are in the order of the lines.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _COUNT, _OVERFLOW, _STRIDE, _TOLERANCE,
 *   _NOT_REPRESENTABLE; _RULE if kind is none of the constants, _DEGREE if f has a degree above 2
 *   NURBS_MAX_DEGREE, _DIRECTION if the direction, or the eye where it is needed, is not finite, or is a
 *   direction of length 0, _POINT_NOT_FINITE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_reflections(const nurbs *g, int32_t kind, const double *eye,
                                                 const double *direction, int64_t n, const double *points,
                                                 int64_t point_stride, int64_t point_component_stride,
                                                 double tolerance, nurbs_meet **out);

/** \brief nurbs_surface_reflections() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_surface_sections_with().
 * \param[in] g,kind,eye,direction,n,points as for nurbs_surface_reflections().
 * \param[in] point_stride,point_component_stride,tolerance as for nurbs_surface_reflections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_surface_reflections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_reflections_with(const nurbs *g, int32_t kind, const double *eye,
                                                      const double *direction, int64_t n,
                                                      const double *points, int64_t point_stride,
                                                      int64_t point_component_stride, double tolerance,
                                                      const nurbs_call_options *call, nurbs_meet **out);

/** \brief Where an implicit polynomial f of space vanishes on a surface.
 *
 * So it finds where the surface meets a plane, a sphere, any quadric or algebraic surface: all curves, proven
 * to be all. f(S(u, v)) is a polynomial on each Bezier piece, whose zeros are traced as by
 * nurbs_surface_contours(), with f > 0 on the left of branches.
 * \param[in] g a surface of dimension 3.
 * \param[in] degree the degree of f, 1 to 8; times the degrees of the surface it is at most 2
 *   NURBS_MAX_DEGREE.
 * \param[in] coefficients [M], M = (dim + degree)! / (dim! degree!), dim = 3, in the order of
 *   nurbs_curve_level().
 * \param[in] tolerance > 0: the largest distance of the curves in space from the set f = 0 on the surface.
 * \param[out] out the new meet; all of it has level 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _DEGREE, _TOLERANCE, _NOT_REPRESENTABLE;
 *   _POINT_NOT_FINITE if a coefficient is not finite, _DIRECTION if all but the last are 0.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_level(const nurbs *g, int32_t degree, const double *coefficients,
                                           double tolerance, nurbs_meet **out);

/** \brief nurbs_surface_level() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_surface_sections_with().
 * \param[in] g,degree,coefficients,tolerance as for nurbs_surface_level().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_surface_level(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_level_with(const nurbs *g, int32_t degree, const double *coefficients,
                                                double tolerance, const nurbs_call_options *call,
                                                nurbs_meet **out);

/** \brief Level curves of a scalar spline over a surface, such as a temperature, a pressure or a thickness.
 *
 * These are the curves on which the scalar has given values: all of them, proven to be all. They are traced
 * as by nurbs_surface_contours(), with scalar > value on the left of branches.
 * \param[in] g a surface of dimension 3.
 * \param[in] scalar a spline of dimension 1 with the same domain, periodic on the same axes; its degrees and
 *   knots may differ.
 * \param[in] n number of values.
 * \param[in] values [n] in any order.
 * \param[in] tolerance > 0: the largest distance of the curves in space from the level.
 * \param[out] out the new meet; its branches are in the order of the values.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _COUNT, _OVERFLOW, _TOLERANCE, _NOT_REPRESENTABLE;
 *   _INCOMPATIBLE if domains or periodic axes differ, _POINT_NOT_FINITE if a value is not finite.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_level_curves(const nurbs *g, const nurbs *scalar, int64_t n,
                                                  const double *values, double tolerance, nurbs_meet **out);

/** \brief nurbs_surface_level_curves() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_surface_sections_with().
 * \param[in] g,scalar,n,values,tolerance as for nurbs_surface_level_curves().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_surface_level_curves(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_level_curves_with(const nurbs *g, const nurbs *scalar, int64_t n,
                                                       const double *values, double tolerance,
                                                       const nurbs_call_options *call, nurbs_meet **out);

/** \brief Where two surfaces meet in curves: all of them, proven to be all.
 *
 * Let F = A(u, v) - B(s, t), and let M be the inverse of its derivative without one column k. Pairs of parts
 * of Bezier pieces are halved until the matrix of bounds of |I - M F'| over both parts has a spectral radius
 * below 1. Where surfaces run along each other at a small angle, the unknowns are the parameters of one of
 * them, and how far those of the other one are off a linear function of these: then what both bend alike
 * cancels. The common points in such parts are a graph over parameter k, inside which there can be neither a
 * loop nor an end, and the ends of the graph on the sides of the box are those of its neighbours. So a loop
 * of any size is found as long as double precision tells the two surfaces apart in it.
 *
 * Every branch except those of kind NURBS_BRANCH_TOUCH, which run either way, runs along N_b x N_a with
 * N = S_u x S_v: in the parameter domain of a, the side of b to which its normals point is on the left.
 * Branches close, or end in nodes
 * - BORDER: one of the surfaces ends or jumps there.
 * - SEAM: one of them closes there on an axis that is not periodic: the branch continues beyond.
 * - TOUCH: all that the surfaces have in the ranges of the node lies between two planes no farther apart than
 *   the tolerance, or in a box no larger, and is no larger than about 1/32 of the surfaces; branches are not
 *   separated in it. There the surfaces touch in a point, and no branch ends; or branches cross in a point at
 *   which the tangent planes coincide, and four ends are there; or there is a loop, or a connection between
 *   branches, that double precision does not tell from these; or there is a pole.
 * - UNDECIDED: a pair of parts in which it is left open what there is. The surfaces touch, or nearly touch,
 *   in regions that are no overlaps, or along curves across which the second derivative of their distance is
 *   not of one sign all along; or a derivative vanishes; or the limit of work came first. Connected parts are
 *   one node. A pair of Bezier pieces that takes more than its share of the work, of all pairs that meet, is
 *   left open there; others are not affected.
 *
 * Branches of kind NURBS_BRANCH_TOUCH (nurbs_meet_kinds()) are curves along which the surfaces touch. In the
 * parts around such a curve, the second derivative across it of the height of one surface over the other is
 * proven to have one sign, so that at each place along the curve the height has exactly one least (or
 * largest) value. This value is 0 to rounding in as many places as it takes to bound it by the tolerance
 * between them. What the surfaces have in common there is no farther from the curve than
 * sqrt(2 tolerance / that derivative), and branches that double precision does not tell from the curve are
 * not separated from it. The deviation is that from both surfaces.
 *
 * A region in which both surfaces coincide to within the tolerance is an overlap: parts of one plane, one
 * cylinder or one spline, whatever their knots, degrees and parametrizations. Each overlap has a level of its
 * own, 1, 2, ..., and on it
 * - one node OVERLAP: its params are a place inside on a, its second ones (nurbs_meet_nodes_second()) the
 *   place beside it on b, and its ranges the boxes of the region in both domains.
 * - its boundary, in branches of kind NURBS_BRANCH_OVERLAP: the parts of borders of a that run on b, and the
 *   parts of borders of b that run on a; what is both is reported once. They form closed loops, one around
 *   the region and one around each hole. In the domain of a the region is on their left; in the domain of b
 *   it is on their left where the normals agree, and on their right where they are opposite. Each branch ends
 *   in the node BORDER in which the next one begins or, where a surface closes on an axis that is not
 *   periodic or the next one leaves a pole at another parameter, in a node SEAM. Sides along which a surface
 *   closes, and poles, bound nothing: all of a closed surface has no boundary.
 *
 * Of regions it is proven that each place of a in them is no farther than the tolerance from b, or that each
 * place of b in them is no farther than that from a; it is tried first from the surface of the lower degrees.
 * All places at which borders lie within the tolerance of the other surface are known
 * (nurbs_curve_surface_intersections()), so that the region extends until one of the surfaces ends. It is
 * divided into parts on each of which the map to the other surface is a polynomial in the parameters,
 * corrected by a contraction as above, and the distance is bounded by samples of a polynomial of known
 * degree. Nothing else is reported of what the surfaces have in common in a region, nor whether more of the
 * other surface touches it there. If these proofs fail, as where the surfaces part by more than the tolerance
 * inside their borders, or if it is left open what a border does, there is no region but a node UNDECIDED.
 * Surfaces that share only an edge have no region, and surfaces that double precision tells apart by less
 * than the tolerance have nothing in common.
 *
 * A caller should treat a kind that it does not know as UNDECIDED: later versions may say more about how
 * surfaces touch.
 *
 * Outside these nodes the branches are all there is, to within their deviations. Branches along borders of
 * pieces are reported once, and curves in the domains stay inside these. Only curves are reported: where just
 * corners or borders touch, to rounding, there may be a short branch or none. Costs: about 10 microseconds
 * for each pair of pieces that meet, and for each piece of a curve; about a millisecond for each place in
 * which the surfaces touch. Where the surfaces coincide in a region, the number of pairs of parts within the
 * tolerance ends the search in it, after some ten milliseconds; the proofs take up to a millisecond for each
 * piece. If call.work gives no limit there is one of about a second, and more for many control points.
 * \param[in] a,b surfaces of dimension 3.
 * \param[in] tolerance > 0: the largest distance of the curves from the common points.
 * \param[out] out the new meet; all of it except overlaps has level 0. nurbs_meet_branch() returns curves in
 *   the domain of a, nurbs_meet_branch_second() those in the domain of b.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _TOLERANCE, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_intersections(const nurbs *a, const nurbs *b, double tolerance,
                                                   nurbs_meet **out);

/** \brief nurbs_surface_intersections() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_surface_sections_with().
 * \param[in] a,b,tolerance as for nurbs_surface_intersections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_surface_intersections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_intersections_with(const nurbs *a, const nurbs *b, double tolerance,
                                                        const nurbs_call_options *call, nurbs_meet **out);

/** \brief Where a surface meets itself: all curves of double points, or the proof that there are none.
 *
 * Parts of the surface are compared as by nurbs_surface_intersections(), except for parts side by side, which
 * share a side or a corner. For two places x, y of a rectangle of the domain, S(x) - S(y) = P (x - y)_0 +
 * Q (x - y)_1, where P and Q are the means of S_u and S_v along the segment between them. If, as seen in some
 * plane, no direction in the cone of all S_u of the rectangle is equal or opposite to one in the cone of all
 * S_v, then P and Q are linearly independent, and S(x) and S(y) are proven to be different points. The
 * rectangle may contain knots, and edges that are less than folded flat. Around a side that is one point, as
 * at a pole, polar coordinates take the place of those of the plane, and S_uv that of the derivative that
 * vanishes there. Rectangles for which this does not hold are halved until it does, or until they have
 * nothing in common.
 *
 * Places that are one, to rounding, because the surface closes along an axis, or because they are on a side
 * that is one point, are not reported. Where sides meet otherwise, as those of a Moebius strip do, the
 * surface meets itself.
 *
 * Branches and nodes are those of nurbs_surface_intersections() with the surface as both a and b, except that
 * - each is reported once, with its two places in either order. A branch along which the two places exchange
 *   their order, so that its curve in the domain closes only after that in space has gone round twice, is
 *   reported as such, twice as long.
 * - TOUCH: also a part, between two such planes and in a box of size 16 sqrt(tolerance * size of the
 *   surface), in which both places of a branch become one, such as the pinch point of a Whitney umbrella; or
 *   all of which is one point, such as the point at which a revolved profile passes through its axis.
 * - UNDECIDED: also where the surface turns back along a curve (a cuspidal edge, or an edge that is folded
 *   flat), parts that have no area, and regions in which the surface lies on itself, since there are no
 *   branches OVERLAP.
 *
 * If complete is 1 and there are no branches and no nodes, the surface is proven to be simple: it has no
 * self-intersections. Costs: some microseconds for each piece where that is so, and elsewhere twice what
 * nurbs_surface_intersections() costs. For a face, take what lies in it of the meet of its surface:
 * nurbs_meet_trim() and nurbs_meet_trim_second().
 * \param[in] g a surface of dimension 3.
 * \param[in] tolerance > 0: the largest distance of the curves from the common points.
 * \param[out] out the new meet of two surfaces, both of which are g; all of it has level 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _TOLERANCE, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_self_intersections(const nurbs *g, double tolerance, nurbs_meet **out);

/** \brief nurbs_surface_self_intersections() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_surface_sections_with().
 * \param[in] g,tolerance as for nurbs_surface_self_intersections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_surface_self_intersections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_self_intersections_with(const nurbs *g, double tolerance,
                                                             const nurbs_call_options *call,
                                                             nurbs_meet **out);

/** \brief Where two faces meet: in curves, in regions, and in the edges that they share.
 *
 * The answer is what their surfaces have in common (nurbs_surface_intersections()) inside the loops of both
 * faces, cut as by nurbs_meet_trim() and nurbs_meet_trim_second(), and the edges that the faces share: those
 * that have one key (nurbs_face_edge()) and lie in one place. So neighbours in a model meet in their edges.
 * Each shared edge is a branch EDGE, or CONTACT if at one of 33 places along it the sine of the angle between
 * the tangent planes is at most 1/256 (nurbs_meet_kinds()). An EDGE runs along N_b x N_a, as curves in which
 * surfaces cross do, a CONTACT along the loop of a. Its curve in space is the edge itself, with its degree
 * and weights. Its curves in the domains run over the same parameters; on axes that close they may run beyond
 * the domain, as curves of loops may. Its deviation is a proven bound of how far all three curves are apart.
 * It ends in nodes BORDER or, if it closes, in two nodes SEAM.
 *
 * What the surfaces have in common near a shared edge is that edge, and is not reported again. Near means
 * within 2 (d_a + d_b + tolerance) / s, where d_a and d_b are how far the faces are off the edge
 * (nurbs_face_deviation()), and s is the least of these sines, but no less than 1/256; the division by s does
 * not enlarge this distance beyond 1/16 of the size of the edge. A curve that begins within this distance of
 * the edge, and is no longer than it, is left out, too. Any other curve that leaves the edge begins in a node
 * EDGE. For this the surfaces are continued beyond the ends of their domains, where borders do cross. Faces
 * that are smooth at a shared edge generally have a node UNDECIDED there, as surfaces that touch have.
 *
 * Where the two surfaces coincide in a region (nurbs_surface_intersections()), the part of it inside the
 * loops of both faces is reported, and nothing if there is no such part. Each connected piece has a level of
 * its own, 1, 2, ..., with a node OVERLAP and a boundary of branches OVERLAP, parts of curves of either face,
 * as regions of surfaces have. To find it, the part of b in the region is cut out in the domain of b, its
 * border is carried over to the domain of a along the region, and what a has inside that border is cut out
 * there, as nurbs_region_combine() does. In this, places no farther apart than the largest of the tolerance
 * and the tolerances of the faces are one, so that sides of both faces that run along each other leave no
 * slivers; in a domain, this distance is the same share of the width of the domain as it is of the size of
 * the surface. Where such sides run along each other with the faces on opposite sides, there is no region but
 * a branch EDGE, which runs with the loop of a and ends in nodes BORDER; where faces touch only in a corner,
 * nothing is reported. The deviations of these branches bound how far both surfaces over the curves in the
 * domains are from the curve in space; they are INFINITY where that is not proven. Where rounding would have
 * to decide any of this, or the limit of work comes first, a node UNDECIDED is left.
 *
 * If it is left open what faces without shared edges have in common, they are intersected once more on
 * surfaces continued beyond the ends of their domains, for patches of one surface side by side; if that is
 * complete, it is the answer. For faces with shared edges, regions are looked for only where the surfaces, of
 * at most 64 pieces each, lie on each other beside an edge CONTACT. Neighbours that are parts of one plane or
 * one cylinder thus have nothing in common but that edge.
 * \param[in] a,b faces in space.
 * \param[in] tolerance > 0: the largest distance of the curves from the common points.
 * \param[out] out the new meet, on the surfaces of a and of b; all of it except overlaps has level 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _TOLERANCE, _NOT_REPRESENTABLE, _NOT_CONVERGED.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_intersections(const nurbs_face *a, const nurbs_face *b, double tolerance,
                                                nurbs_meet **out);

/** \brief nurbs_face_intersections() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_surface_sections_with().
 * \param[in] a,b,tolerance as for nurbs_face_intersections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_face_intersections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_intersections_with(const nurbs_face *a, const nurbs_face *b,
                                                     double tolerance, const nurbs_call_options *call,
                                                     nurbs_meet **out);

/** \brief A curve projected onto a surface, along a direction d or along the normals of the surface.
 *
 * The answer is all curves of projected points, proven to be all. With d, they are the common curves of the
 * surface and of the ruled surface (t, h) -> C(t) + h d / |d| of the lines through the points of C. The
 * control points of the ruled surface are those of C moved along d, each rounded once; h covers all values
 * that lead into the box of the surface. The curves are found as by nurbs_surface_intersections(), on both
 * sides of C and on all sheets of the surface.
 *
 * Without d, they are the curves of all orthogonal feet, near ones and far ones: of all (t, u, v) with
 * (S(u, v) - C(t)) . S_u = 0 and (S(u, v) - C(t)) . S_v = 0, so that S = C + h n, with n the unit vector
 * along S_u x S_v. Where C is on the surface, h is 0. A local minimum of the distance at a border, a crease
 * or a pole is no such foot; nurbs_closest_points() finds those.
 *
 * Along each branch t rises. nurbs_meet_branch_second() returns the curve of (t, h): its first coordinate at
 * the ends is the range of t that is projected, and its second coordinate is the signed distance from C,
 * along d or n. Branches close, or end in nodes
 * - BORDER: the curve, or the surface, ends or jumps there, or feet come to a crease of the surface, at which
 *   the tangent planes of both sides differ.
 * - SEAM: one of them closes there on an axis that is not periodic: the branch continues beyond.
 * - FOLD: t turns there, since d is in the tangent plane of the surface, or since C(t) is a centre of
 *   curvature of the surface at the foot. Another branch continues on the sheet of the surface behind the
 *   fold; both end there, or both begin there. A turn of t counts only if the curve moves by more than 4
 *   deviations of the branch, measured across d if there is one.
 * - TOUCH, for feet: branches cross or end in a part that is no larger than the tolerance, on the surface and
 *   on the curve.
 * - UNDECIDED: it is left open what there is. The surface touches the lines along a curve, or contains one of
 *   them; or feet fill a region, as for a curve along the axis of a cylinder or through the centre of a
 *   sphere; or branches of feet meet, at a pole or in a plane of symmetry, in a part that rounding makes
 *   larger than the tolerance; or a derivative vanishes; or the limit of work came first.
 *
 * Outside these nodes the branches are all there is, to within their deviations. Where the curve runs along
 * d, or along the normal, a branch stays at one point and its knots are next to each other. Along a side at
 * which S_u or S_v vanishes, feet are those of the tangent plane there. If an axis of the surface has degree
 * 0, everything is left open.
 * \param[in] g a surface of dimension 3. Without a direction its degrees are at most 31, or 20 if it has
 *   weights.
 * \param[in] curve a curve of dimension 3.
 * \param[in] direction [3] or NULL for the normals: d, of any length but 0; what is projected against it has
 *   h < 0.
 * \param[in] tolerance > 0: the largest distance of the curves from the projection.
 * \param[out] out the new meet; all of it has level 0. nurbs_meet_branch() returns curves in space and in the
 *   domain of g. Deviations bound the distance of each of these from the common curves, or from the feet, and
 *   how far C(t) and h are from theirs. So at equal parameters the surface is within two deviations of
 *   C(t) + h d / |d|; without d, |h| is within three deviations of the distance between S(u, v) and C(t).
 *   Nothing bounds h where n flips, as it may where S_u x S_v is 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _DIRECTION, _TOLERANCE; _DEGREE, along the normals;
 *   _NOT_REPRESENTABLE if lines to the box of the surface overflow, or weights cannot be shown to be
 *   positive.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_project_curve(const nurbs *g, const nurbs *curve,
                                                   const double *direction, double tolerance,
                                                   nurbs_meet **out);

/** \brief nurbs_surface_project_curve() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_surface_sections_with().
 * \param[in] g,curve as for nurbs_surface_project_curve().
 * \param[in] direction [3] or NULL: as for nurbs_surface_project_curve().
 * \param[in] tolerance as for nurbs_surface_project_curve().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_surface_project_curve(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_surface_project_curve_with(const nurbs *g, const nurbs *curve,
                                                        const double *direction, double tolerance,
                                                        const nurbs_call_options *call, nurbs_meet **out);

/** \brief A curve projected onto a face, along a direction or along the normals of its surface.
 *
 * The answer is what lies inside the loops of the face of nurbs_surface_project_curve() on its surface,
 * trimmed as by nurbs_meet_trim(). Branches that leave the face end in nodes BORDER.
 * \param[in] face a face.
 * \param[in] curve as for nurbs_surface_project_curve().
 * \param[in] direction [3] or NULL: as for nurbs_surface_project_curve().
 * \param[in] tolerance as for nurbs_surface_project_curve().
 * \param[out] out the new meet.
 * \return as for nurbs_surface_project_curve().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_project_curve(const nurbs_face *face, const nurbs *curve,
                                                const double *direction, double tolerance, nurbs_meet **out);

/** \brief nurbs_face_project_curve() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_surface_sections_with().
 * \param[in] face,curve as for nurbs_face_project_curve().
 * \param[in] direction [3] or NULL: as for nurbs_face_project_curve().
 * \param[in] tolerance as for nurbs_face_project_curve().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_face_project_curve(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_project_curve_with(const nurbs_face *face, const nurbs *curve,
                                                     const double *direction, double tolerance,
                                                     const nurbs_call_options *call, nurbs_meet **out);

/** \brief Another handle on the same meet, in constant time.
 * \param[in] meet a meet.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_clone(const nurbs_meet *meet, nurbs_meet **out);

/** \brief Frees a handle on a meet. Curves taken from it stay valid.
 * \param[in] meet or NULL, which does nothing: a meet.
 * \since 1.1 */
NURBS_API void nurbs_meet_destroy(nurbs_meet *meet);

/** \brief The numbers of branches and nodes of a meet, and whether it is complete.
 * \param[in] meet a meet.
 * \param[out] branches or NULL: number of branches.
 * \param[out] nodes or NULL: number of nodes.
 * \param[out] complete or NULL: 1 if it is proven that there is nothing else, with no node undecided; else 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_counts(const nurbs_meet *meet, int64_t *branches, int64_t *nodes,
                                         int32_t *complete);

/** \brief What the branches of a meet belong to, and where they end.
 * \param[in] meet a meet.
 * \param[in] cap length of the outputs: 0, or at least the number of branches.
 * \param[out] levels [cap] or NULL: index of the plane, cosine, line of light or value, 0-based, and 0 where
 *   there are none of these; for overlaps the number of the region, from 1.
 * \param[out] end_nodes [cap][2] or NULL: the nodes at which each branch begins and ends, 0-based; -1: it
 *   closes.
 * \param[out] loops [cap] or NULL: the closed way of which the branch is a part, or all, 0-based; -1: none.
 *   The branches of one way follow each other in its direction, from one seam to the next.
 * \param[out] deviations [cap] or NULL: a proven bound of the distance from the exact section, in space, of
 *   the curve in space and of the image of the curve in the parameter domain; of two surfaces, of both
 *   images. It is larger than the tolerance only where rounding or the limit of work prevents a better one;
 *   INFINITY: nothing is proven.
 * \param[out] count or NULL: number of branches.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_branches(const nurbs_meet *meet, int64_t cap, int64_t *levels,
                                           int64_t *end_nodes, int64_t *loops, double *deviations,
                                           int64_t *count);

/** \name Kinds of branches
 * @{ */
#define NURBS_BRANCH_CROSSING 1 /**< a curve that surfaces, or a surface and a plane, have in common */
#define NURBS_BRANCH_EDGE 2     /**< an edge that two faces share */
#define NURBS_BRANCH_CONTACT                                                                                 \
    3 /**< an edge that two faces share, with the same tangent planes somewhere at least */
#define NURBS_BRANCH_TOUCH 4   /**< a curve along which surfaces touch: they have the same tangent planes */
#define NURBS_BRANCH_OVERLAP 5 /**< a part of the boundary of a region in which surfaces coincide */
/** @} */

/** \brief What kind each branch of a meet is.
 * \param[in] meet a meet.
 * \param[in] cap length of the output: 0, or at least the number of branches.
 * \param[out] kinds [cap] or NULL: one of the NURBS_BRANCH_ constants for each: EDGE and CONTACT only in
 *   meets of faces and models, TOUCH in all meets of two surfaces, trimmed or not, OVERLAP in meets of
 *   surfaces, faces or models.
 * \param[out] count or NULL: number of branches.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_kinds(const nurbs_meet *meet, int64_t cap, int32_t *kinds, int64_t *count);

/** \brief A branch of a meet, as curves in space and in the parameter domain.
 *
 * The curves are cubic and have common knots; their parameter is about the length in space. Branches of edges
 * that faces share have the degree and the parameters of these edges.
 * \param[in] meet a meet.
 * \param[in] index 0-based.
 * \param[out] space the curve in space.
 * \param[out] on_surface the curve in the parameter domain, of dimension 2, with normal . S > offset on its
 *   left. Its control points are in the domain; on a periodic axis it may run into neighbouring periods.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_branch(const nurbs_meet *meet, int64_t index, nurbs **space,
                                         nurbs **on_surface);

/** \brief The curve of a branch on the second of two surfaces; in a projection, the curve of (t, h).
 * \param[in] meet a meet of two surfaces, faces or models, or of a projection.
 * \param[in] index 0-based.
 * \param[out] on_second the curve in the parameter domain of the second surface, with the knots of the curves
 *   of nurbs_meet_branch(). Its control points are in the domain; on a periodic axis it may run into
 *   neighbouring periods.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX; _INCOMPATIBLE if the meet is of one surface.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_branch_second(const nurbs_meet *meet, int64_t index, nurbs **on_second);

/** \brief The nodes of a meet: where branches end, and where something is not resolved.
 * \param[in] meet a meet.
 * \param[in] cap length of the outputs: 0, or at least the number of nodes.
 * \param[out] levels [cap] or NULL: the level, as for branches in nurbs_meet_branches().
 * \param[out] kinds [cap] or NULL: one of the NURBS_NODE_ constants for each.
 * \param[out] params [cap][2] or NULL: parameters of the surface; for a part, its middle.
 * \param[out] ranges [cap][2][2] or NULL: lower and upper end of the part along each axis. Where the surface
 *   closes, the range of a part on both sides of the seam runs beyond the upper end of the domain.
 * \param[out] count or NULL: number of nodes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_nodes(const nurbs_meet *meet, int64_t cap, int64_t *levels, int32_t *kinds,
                                        double *params, double *ranges, int64_t *count);

/** \brief Where the nodes of a meet are on the second of two surfaces; in a projection, their (t, h).
 * \param[in] meet a meet of two surfaces, faces or models, or of a projection.
 * \param[in] cap length of the outputs: 0, or at least the number of nodes.
 * \param[out] params [cap][2] or NULL: parameters of the second surface, in its domain; for a part, its
 *   middle.
 * \param[out] ranges [cap][2][2] or NULL: lower and upper end of the part along each axis.
 * \param[out] count or NULL: number of nodes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough, _INCOMPATIBLE
 *   if the meet is of one surface.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_nodes_second(const nurbs_meet *meet, int64_t cap, double *params,
                                               double *ranges, int64_t *count);

/** \brief The ways of a meet: chains of branches, each of which continues the one before.
 *
 * Each branch belongs to one way, and the branches of a way follow each other in its direction.
 * \param[in] meet a meet.
 * \param[in] cap length of the outputs: 0, or at least the number of ways.
 * \param[out] levels [cap] or NULL: the level, as for branches in nurbs_meet_branches(), rising.
 * \param[out] firsts [cap] or NULL: the first branch, 0-based.
 * \param[out] sizes [cap] or NULL: the number of branches, at least 1.
 * \param[out] closes [cap] or NULL: 1 if the last branch continues in the first one, or a single branch
 *   closes; else 0, as where a node TOUCH hides how the way continues, even if the meet is complete.
 * \param[out] gaps [cap] or NULL: the largest distance in space between ends that continue in each other
 *   (nurbs_meet_joints()).
 * \param[out] count or NULL: number of ways.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_ways(const nurbs_meet *meet, int64_t cap, int64_t *levels, int64_t *firsts,
                                       int64_t *sizes, int32_t *closes, double *gaps, int64_t *count);

/** \brief The faces on which the branches of a meet of a model lie; -1 in other meets.
 *
 * Meets of models are those of nurbs_model_sections() and nurbs_model_intersections(), where the faces are
 * those of the first model.
 * \param[in] meet a meet.
 * \param[in] cap length of the outputs: 0, or at least the number of branches.
 * \param[out] own_faces [cap] or NULL: the face of the model, 0-based.
 * \param[out] own_instances [cap] or NULL: the instance of its part, 0-based (nurbs_model_instances()).
 * \param[out] count or NULL: number of branches.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_faces(const nurbs_meet *meet, int64_t cap, int64_t *own_faces,
                                        int64_t *own_instances, int64_t *count);

/** \brief The faces of the second model of nurbs_model_intersections() on which branches lie; else -1.
 * \param[in] meet a meet.
 * \param[in] cap length of the outputs: 0, or at least the number of branches.
 * \param[out] own_faces [cap] or NULL: the face of the second model, 0-based.
 * \param[out] own_instances [cap] or NULL: the instance of its part, 0-based (nurbs_model_instances()).
 * \param[out] count or NULL: number of branches.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_faces_second(const nurbs_meet *meet, int64_t cap, int64_t *own_faces,
                                               int64_t *own_instances, int64_t *count);

/** \brief How branches continue at the nodes of a meet, and on which faces of a model these nodes are.
 * \param[in] meet a meet.
 * \param[in] cap length of the outputs: 0, or at least the number of nodes.
 * \param[out] next_nodes [cap] or NULL: the node of the branch that continues here, or that came here,
 *   0-based; -1: none.
 * \param[out] gaps [cap] or NULL: how far apart in space the ends of both branches are; 0 in a meet of one
 *   surface.
 * \param[out] own_faces [cap] or NULL: the face of the model, 0-based; -1 if the meet is not of a model.
 * \param[out] own_instances [cap] or NULL: the instance of its part, 0-based; -1 if the meet is not of a
 *   model.
 * \param[out] count or NULL: number of nodes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_joints(const nurbs_meet *meet, int64_t cap, int64_t *next_nodes,
                                         double *gaps, int64_t *own_faces, int64_t *own_instances,
                                         int64_t *count);

/** \brief The faces of the second model of nurbs_model_intersections() on which nodes are; else -1.
 * \param[in] meet a meet.
 * \param[in] cap length of the outputs: 0, or at least the number of nodes.
 * \param[out] own_faces [cap] or NULL: the face of the second model, 0-based.
 * \param[out] own_instances [cap] or NULL: the instance of its part, 0-based (nurbs_model_instances()).
 * \param[out] count or NULL: number of nodes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_joints_second(const nurbs_meet *meet, int64_t cap, int64_t *own_faces,
                                                int64_t *own_instances, int64_t *count);

/** \brief The part of a meet that lies in a face.
 *
 * Of the branches the parts inside the loops are kept, which end on the loops in nodes BORDER, and of the
 * nodes those of these parts. So sections, contours and levels of a face are those of its surface, trimmed.
 * Of a meet of two surfaces, what lies in a face of the first one is kept; nurbs_meet_trim_second() keeps
 * what lies in a face of the second one.
 *
 * Where curves cross loops is decided by nurbs_curve_intersections() in the parameter domain, and which parts
 * are inside by the sides of their middles (nurbs_face_classify()). What runs along a loop, to 1e-9 of the
 * domain, is inside. Where crossings are undecided there is a node UNDECIDED. A closed branch that is cut is
 * also cut where it begins, in two nodes SEAM. Of an overlap that reaches into the face a node UNDECIDED is
 * left, and none of its boundary. A node TOUCH stays if its middle is in the face, a node UNDECIDED unless
 * all of its part is outside. Deviations stay.
 * \param[in] meet a meet of the surface of the face, or of one with the same parameters; of two surfaces, it
 *   is the first.
 * \param[in] face a face.
 * \param[out] out the new meet.
 * \return NURBS_OK, NURBS_ERROR_NULL, _NOT_REPRESENTABLE; _INCOMPATIBLE for meets of models, whose faces are
 *   trimmed, unless they are empty.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_trim(const nurbs_meet *meet, const nurbs_face *face, nurbs_meet **out);

/** \brief nurbs_meet_trim() with progress reports, cancellation and a limit of work.
 * \param[in] meet,face as for nurbs_meet_trim().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_meet_trim(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_trim_with(const nurbs_meet *meet, const nurbs_face *face,
                                            const nurbs_call_options *call, nurbs_meet **out);

/** \brief The part of a meet of two surfaces that lies in a face of the second one.
 *
 * It is trimmed as by nurbs_meet_trim(): curves in the domain of the second surface are cut where they cross
 * the loops, and all curves of a branch with them. The two trims may be made in either order.
 * \param[in] meet a meet of two surfaces, the second of which is that of the face, or one with the same
 *   parameters.
 * \param[in] face a face.
 * \param[out] out the new meet.
 * \return NURBS_OK, NURBS_ERROR_NULL, _NOT_REPRESENTABLE; _INCOMPATIBLE if the meet is of one surface or of
 *   one model, or, unless it is empty, of two models.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_trim_second(const nurbs_meet *meet, const nurbs_face *face,
                                              nurbs_meet **out);

/** \brief nurbs_meet_trim_second() with progress reports, cancellation and a limit of work.
 * \param[in] meet,face as for nurbs_meet_trim_second().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_meet_trim_second(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_meet_trim_second_with(const nurbs_meet *meet, const nurbs_face *face,
                                                   const nurbs_call_options *call, nurbs_meet **out);
/** @} */

/** \defgroup edit Weights and control points
 * \code
 * const double params[] = {0.5}, up[] = {0, 0, 1};
 * double moved = 0; // how far control point 1 goes to lift the point at 0.5 by 0.1
 * nurbs *lifted = NULL;
 * nurbs_pull_point(curve, 1, params, up, 0.1, &moved, &lifted);
 * nurbs_destroy(lifted);
 * \endcode
 * Changes of one or a few control points or weights that bring a point of the shape to where it is wanted;
 * Piegl & Tiller, "The NURBS Book", chapter 11. R_i(t) is the rational basis function of control point i, a
 * flat index, last axis fastest. Where R_i(t) is 0 the control point cannot move that point:
 * NURBS_ERROR_INFLUENCE, and the message names the control points that can. On a periodic axis the copies of
 * a layer change with it, and R_i is the sum of the copies' functions. A control point at infinity has no
 * weight that could change: its R_i is 0.
 *
 * A point that is moved by weights ends within (3 sum p + n + 8) eps of its place, times the distance from
 * the centre to the farthest of the n active control points. A point that is moved by its control point ends
 * within the same multiple of the distance and R_i |P_i*|. Tests find at most 0.05 of that.
 * @{ */

/** \brief Changes a weight so that the point at a parameter moves by a distance towards the control point,
 * or away from it if the distance is negative:
 *
 *     w_i* = w_i (1 + d / (R_i(t) (|P_i S| - d))),   S = C(t).
 *
 * The point stays on the line through P_i and B, its place at weight 0: -|S B| < d < |P_i S|.
 * \param[in] g a spline.
 * \param[in] index control point.
 * \param[in] params [axes] parameter.
 * \param[in] distance d.
 * \param[out] weight or NULL: the new weight.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _INFLUENCE; _LENGTH
 *   if the distance is not finite or d >= |P_i S|, _WEIGHT_SIGN if d <= -|S B|, so that the weight would
 *   not be positive; _NOT_REPRESENTABLE if the weight, or its product with the point, overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_pull_weight(const nurbs *g, int64_t index, const double *params, double distance,
                                         double *weight, nurbs **out);

/** \brief Multiplies several weights by one factor so that the point at a parameter moves by a distance
 * towards (or away from) their common centre Q = sum R_i P_i / sum R_i: the formula of nurbs_pull_weight()
 * with Q and sum R_i. Two neighbours pull a curve to the leg between them.
 * \param[in] g a spline.
 * \param[in] count number of control points, > 0.
 * \param[in] indices [count] control points, all different.
 * \param[in] params [axes] parameter.
 * \param[in] distance d.
 * \param[out] factor or NULL: by which the weights were multiplied.
 * \param[out] out the new handle.
 * \return as for nurbs_pull_weight(), and NURBS_ERROR_COUNT, _OVERFLOW; _INDEX also if an index occurs twice.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_pull_weights(const nurbs *g, int64_t count, const int64_t *indices,
                                          const double *params, double distance, double *factor, nurbs **out);

/** \brief Sets weights; control points stay, and a polynomial spline becomes rational unless count is 0. In a
 * homogeneous spline a control point of weight 0 has no place any more.
 * \param[in] g a spline.
 * \param[in] count number of weights.
 * \param[in] indices [count] control points, all different.
 * \param[in] weights [count] >= 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _INDEX, _WEIGHT_NOT_FINITE, _WEIGHT_NEGATIVE,
 *   _WEIGHTS_VANISH, _OVERFLOW, _NOT_REPRESENTABLE; _POINT_NOT_FINITE if g has a control point at infinity.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_set_weights(const nurbs *g, int64_t count, const int64_t *indices,
                                         const double *weights, nurbs **out);

/** \brief The points at a parameter for the weights 0, 1 and the present one of a control point. They lie on
 * a line with P_i, which is the point at an infinite weight.
 * \param[in] g a spline.
 * \param[in] index control point.
 * \param[in] params [axes] parameter.
 * \param[out] at_zero [dim] or NULL: the point m at weight 0; NaN if no other weight acts there.
 * \param[out] at_one [dim] or NULL: the point n at weight 1.
 * \param[out] at_weight [dim] or NULL: the point p at the present weight.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _OVERLAP,
 *   _NOT_REPRESENTABLE; _POINT_NOT_FINITE if the control point is at infinity.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_weight_points(const nurbs *g, int64_t index, const double *params,
                                           double *at_zero, double *at_one, double *at_weight);

/** \brief The weight as the cross ratio of four points on a line: w = (P n / n m) / (P p / p m), signed
 * lengths, where m, n, p are the points of nurbs_weight_points(). The points are projected onto the line
 * through P and m.
 * \param[in] dim dimension.
 * \param[in] control_point [dim] P.
 * \param[in] at_zero,at_one,at_weight [dim] m, n, p.
 * \param[out] weight w; infinite if p = P.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _OVERLAP, _POINT_NOT_FINITE; _COLLINEAR if P = m or n is
 *   one of them, so that there is no ratio.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_weight_cross_ratio(int32_t dim, const double *control_point,
                                                const double *at_zero, const double *at_one,
                                                const double *at_weight, double *weight);

/** \brief Sets the weight of a control point so that the point at a parameter becomes a given one, on the
 * line through P_i and the point at weight 0, by the cross ratio.
 * \param[in] g a spline.
 * \param[in] index control point.
 * \param[in] params [axes] parameter.
 * \param[in] target [dim] between P_i and the point at weight 0.
 * \param[in] tolerance largest distance of target from the line, >= 0.
 * \param[out] weight or NULL: the new weight.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _INFLUENCE (also if no
 *   weight moves the point), _TOLERANCE, _POINT_NOT_FINITE; _GAP naming the distance if target is not on the
 *   line, _WEIGHT_SIGN if it is not between the two points, _NOT_REPRESENTABLE if the weight overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_weight_through(const nurbs *g, int64_t index, const double *params,
                                            const double *target, double tolerance, double *weight,
                                            nurbs **out);

/** \brief Moves a control point so that the point at a parameter moves by a distance along a direction:
 *
 *     P_i* = P_i + alpha V,   alpha = d / (|V| R_i(t)).
 *
 * \param[in] g a spline.
 * \param[in] index control point.
 * \param[in] params [axes] parameter.
 * \param[in] direction [dim] V, not zero.
 * \param[in] distance d.
 * \param[out] moved or NULL: how far the control point moved, with the sign of d.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _INFLUENCE,
 *   _DIRECTION; _LENGTH if the distance is not finite, _NOT_REPRESENTABLE if the point overflows.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_pull_point(const nurbs *g, int64_t index, const double *params,
                                        const double *direction, double distance, double *moved, nurbs **out);

/** \brief The control point with the largest |R_i(t)|, the first of several.
 * \param[in] g a spline.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[out] indices [n] or NULL: control points.
 * \param[out] influences [n] or NULL: R_i(t).
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _PARAMETER_NOT_FINITE,
 *   _OUTSIDE_DOMAIN.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_most_influential(const nurbs *g, int64_t n, const double *params,
                                              int64_t param_stride, int64_t param_component_stride,
                                              int64_t *indices, double *influences);

/** \brief Inverse knot insertion: inserts the knot that makes a point of a leg of the control polygon a
 * control point. The leg from P_i to its neighbour P_j along the axis, the point Q = P_i + ratio (P_j -
 * P_i):
 *
 *     s = w_i |Q - P_i| / (w_i |Q - P_i| + w_j |P_j - Q|),   knot = t_(i+1) + s (t_(i+p+1) - t_(i+1)),
 *
 * where i also counts along the axis and p is the degree. In a surface or volume Q is the point of this
 * leg, all rows along the axis get the knot. The knot may lie outside the domain at an unclamped end: then
 * the outermost knot there and its layer, on which no point depends, go, so that the domain stays. On a
 * periodic axis the knot is that of the period of the domain. Where both weights are 0, s is the ratio.
 * \param[in] g a spline of degree >= 1 along the axis.
 * \param[in] axis 0-based axis.
 * \param[in] index control point P_i, not the last one along the axis.
 * \param[in] ratio from 0 to 1.
 * \param[out] knot or NULL: the knot.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _INDEX, _OVERFLOW, _PERIODIC_KNOTS, _NOT_REPRESENTABLE; _DEGREE
 *   if it is 0, _FACTOR if ratio is not in [0, 1], _MULTIPLICITY if the knot occurs degree + 1 times
 *   already, _WEIGHT_SIGN if the weights of the ends have not one sign, or just one is 0, so that no knot
 *   makes a point between them one, _POINT_NOT_FINITE if one of them is at infinity, _PERIODIC if a periodic
 *   axis has fewer different layers than its degree.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_insert_on_leg(const nurbs *g, int32_t axis, int64_t index, double ratio,
                                           double *knot, nurbs **out);

/** \brief Inverse knot insertion at a point of the control polygon: the leg along the axis that is nearest
 * to the point is taken, and the knot inserted as by nurbs_insert_on_leg().
 * \param[in] g a spline of degree >= 1 along the axis.
 * \param[in] axis 0-based axis.
 * \param[in] point [dim].
 * \param[in] tolerance largest distance of the point from the leg, >= 0.
 * \param[out] index or NULL: control point where the leg starts.
 * \param[out] ratio or NULL: where on the leg.
 * \param[out] knot or NULL: the knot.
 * \param[out] out the new handle.
 * \return as for nurbs_insert_on_leg(), and NURBS_ERROR_TOLERANCE, _POINT_NOT_FINITE; _OFF_POLYGON naming the
 *   distance if the point is farther from every leg.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_insert_at_point(const nurbs *g, int32_t axis, const double *point,
                                             double tolerance, int64_t *index, double *ratio, double *knot,
                                             nurbs **out);
/** @} */

/** \defgroup constrain Constraints
 * \code
 * const double params[] = {0.5}, target[] = {1, 2, 3}; // where the point at 0.5 has to be
 * nurbs *through = NULL;
 * nurbs_constrain(curve, 1, NULL, NULL, params, target, NULL, NULL, NULL, 0, NULL, NULL, NULL, NULL,
 *                 &through);
 * nurbs_destroy(through);
 * \endcode
 * @{ */

/** \name Kinds of constraints
 * @{ */
#define NURBS_CONSTRAIN_VALUE 0 /**< the derivative of the given orders is the target; orders 0: the point */
#define NURBS_CONSTRAIN_DIRECTION 1 /**< the derivative is parallel to the target, either way */
#define NURBS_CONSTRAIN_NORMAL 2    /**< all first derivatives are perpendicular to the target */
#define NURBS_CONSTRAIN_CURVATURE                                                                            \
    3 /**< the curvature vector (C'' - (C'' T) T) / |C'|^2 of a curve is the target */
/** @} */

/** \brief The smallest change of control points, and if wanted of weights, that makes a shape meet
 * constraints:
 *
 *     minimise sum_i costs[i] |e_i|^2 + sum_i weight_costs[i] (w_i* / w_i - 1)^2,   P_i* = P_i + e_i,
 *
 * subject to count constraints at parameters. With the weights fixed and no CURVATURE the constraints are
 * linear and solved by Lagrange multipliers, by an orthogonal factorisation; one point of one control point
 * gives e = (T - S) / R_i, over a range e_i = R_i / (sum R_j^2) (T - S). Otherwise by sequential quadratic
 * programming, to a local minimum with an optimality of at most 1e-6. Equations that follow from others count
 * once (rank). On a periodic axis the copies of a layer are one control point, with the costs of the first
 * one. Only control points that act on a constraint change. Cost: linear in the number of constraints on a
 * curve; on surfaces and volumes each meets others with control points in the same layers.
 * \param[in] g a spline.
 * \param[in] count number of constraints, > 0.
 * \param[in] kinds [count] or NULL for all VALUE: NURBS_CONSTRAIN_ constants.
 * \param[in] orders [count][axes] or NULL for all 0, DIRECTION of a curve 1: orders of the derivatives
 *   (VALUE, DIRECTION), else 0. Those of a constraint add up to NURBS_MAX_ORDER at most.
 * \param[in] params [count][axes] parameters; a knot belongs to the span above it.
 * \param[in] targets [count][dim].
 * \param[in] keep [axes][2] or NULL for none: highest order of derivatives that stay at the start and end of
 *   every axis, -1 for none. All control points on which they depend stay.
 * \param[in] costs [N] or NULL for all 1: > 0, infinite for control points that stay.
 * \param[in] weight_costs [N] or NULL, with which all stay: > 0, infinite for weights that stay.
 * \param[in] tolerance largest residual, >= 0: as a length for points, for derivatives as what control points
 *   that are off by it can make of them; 0 means 64 eps times the size of the terms.
 * \param[out] residuals [count] or NULL: how far each constraint is missed, the length of the difference; of
 *   the part of the derivative across the direction; of the parts of the derivatives along the normal.
 * \param[out] rank or NULL: number of independent equations; a point has one for each coordinate.
 * \param[out] moved or NULL: largest distance by which a control point moved.
 * \param[out] optimality or NULL: length of the gradient of the Lagrangian relative to its terms.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _OVERLAP, _CONSTRAINT, _ORDER,
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN, _POINT_NOT_FINITE, _TOLERANCE; _FACTOR if a cost is not
 *   positive, _DIRECTION if a target that has to be a direction is zero, _DIMENSION or _AXES if a kind does
 *   not suit, _INFLUENCE if no control point that may move acts on a constraint, _CONTRADICTION naming the
 *   constraint with the largest residual and that, _WEIGHT_SIGN if a weight would not be positive,
 *   _NOT_CONVERGED, _NOT_REPRESENTABLE, _WEIGHTS_VANISH; _POINT_NOT_FINITE also if g has a control point at
 *   infinity.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_constrain(const nurbs *g, int64_t count, const int32_t *kinds,
                                       const int32_t *orders, const double *params, const double *targets,
                                       const int32_t *keep, const double *costs, const double *weight_costs,
                                       double tolerance, double *residuals, int64_t *rank, double *moved,
                                       double *optimality, nurbs **out);

/** \brief The constraints of nurbs_constrain() as one argument. Set struct_size to
 * sizeof(nurbs_constraints), and what is not wanted to 0. Fields are only ever appended, and struct_size is
 * at most 4096. */
typedef struct nurbs_constraints {
    int64_t struct_size;        /**< size of this struct as the caller knows it */
    int64_t count;              /**< number of constraints, > 0 */
    const int32_t *kinds;       /**< [count] or NULL: as for nurbs_constrain(), like all fields that follow */
    const int32_t *orders;      /**< [count][axes] or NULL: orders of derivatives */
    const double *params;       /**< [count][axes] parameters */
    const double *targets;      /**< [count][dim] targets */
    const int32_t *keep;        /**< [axes][2] or NULL: derivatives that stay at the ends */
    const double *costs;        /**< [N] or NULL: of moving control points */
    const double *weight_costs; /**< [N] or NULL: of changing weights */
    double tolerance;           /**< largest residual, >= 0 */
} nurbs_constraints;

/** \brief What nurbs_constrain() tells about its solution. Set struct_size to sizeof(nurbs_constraint_report),
 * and residuals. Fields are only ever appended, and struct_size is at most 4096. */
typedef struct nurbs_constraint_report {
    int64_t struct_size; /**< size of this struct as the caller knows it */
    double *residuals;   /**< [count] or NULL: an array of the caller, which receives the residuals */
    int64_t rank;        /**< receives the number of independent equations */
    double moved;        /**< receives the largest distance by which a control point moved */
    double optimality;   /**< receives the relative length of the gradient */
} nurbs_constraint_report;

/** \brief nurbs_constrain() with progress reports, cancellation and a limit of work.
 * \param[in] g as for nurbs_constrain().
 * \param[in] constraints what is to hold.
 * \param[in,out] report or NULL: where the answers go.
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_constrain(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_constrain_with(const nurbs *g, const nurbs_constraints *constraints,
                                            nurbs_constraint_report *report, const nurbs_call_options *call,
                                            nurbs **out);
/** @} */

/** \defgroup deform Deformations
 * \code
 * const double range[2][2] = {{0.25, 0.75}, {0.25, 0.75}}, up[] = {0, 0, 1};
 * nurbs *bump = NULL;
 * nurbs_warp(surface, range[0], up, 0.1, 1, &bump); // raised by 0.1 in the middle of the region
 * nurbs_destroy(bump);
 * \endcode
 * Changes of a whole shape or of a region of it. `range` is a box of parameters. Its ends become knots, so
 * that the shape outside stays the same, and control points whose basis functions reach outside stay.
 * @{ */

/** \brief Raises a region along a direction: adds distance * b(t) * direction / |direction|, where b is 1 in
 * the middle of the range, 0 at its ends with the first `order` derivatives, and rises and falls once along
 * each axis: a product of B-splines of degree order + 1 over even knots, added exactly. Degrees become at
 * least order + 1; with weights they rise by as much.
 * \param[in] g a spline.
 * \param[in] range [axes][2] or NULL for the whole domain: the region.
 * \param[in] direction [dim], not zero.
 * \param[in] distance signed.
 * \param[in] order derivatives that stay at the ends of the region, 0 to 7.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIRECTION, _ORDER, _OVERFLOW, _PERIODIC_KNOTS; _PARAMETER_NOT_FINITE,
 *   _OUTSIDE_DOMAIN or _EMPTY_DOMAIN if range is no interval of the domain, _KNOTS_MERGE if it has too few
 *   doubles; _LENGTH if the distance is not finite, _DEGREE if a degree would exceed NURBS_MAX_DEGREE,
 *   _NOT_REPRESENTABLE if a value overflows, _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_warp(const nurbs *g, const double *range, const double *direction,
                                  double distance, int32_t order, nurbs **out);

/** \brief Flattens a region to a plane (in the plane: to a line): control points of the region are projected
 * onto it along a direction; those inside it only, so that the shape joins what is outside as smoothly as
 * the degree allows. Along an axis of which the region is a part, each of 3 (degree + 1) equal parts of it
 * gets a knot if it has none, so that the middle third becomes flat.
 * \param[in] g a spline.
 * \param[in] range [axes][2] or NULL for the whole domain: the region.
 * \param[in] point [dim] a point of the plane.
 * \param[in] normal [dim] its normal.
 * \param[in] direction [dim] or NULL for the normal: direction of projection.
 * \param[out] moved or NULL: largest distance by which a control point moved, which bounds that of the shape
 *   if all weights are >= 0; infinite if a control point at infinity moved.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW, _POINT_NOT_FINITE, _PERIODIC_KNOTS; _DIRECTION if the
 *   normal or the direction is zero or not finite, or they are perpendicular; _PARAMETER_NOT_FINITE,
 *   _OUTSIDE_DOMAIN or _EMPTY_DOMAIN if range is no interval of the domain; _NOT_REPRESENTABLE if a value
 *   overflows, _WEIGHTS_VANISH if weights underflow.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_flatten(const nurbs *g, const double *range, const double *point,
                                     const double *normal, const double *direction, double *moved,
                                     nurbs **out);

/** \brief Bends a shape about an axis (Barr 1984). With unit vectors e along and n across (away from the
 * centre), at x = origin + a e + b n + rest, the bend of curvature k maps
 *
 *     a -> (1/k + b) sin(k a),   b -> (1/k + b) cos(k a) - 1/k
 *
 * for a between lower and upper, and goes on straight outside; the rest stays. The exact image is no spline;
 * g is refined, degrees 1 and 2 raised to 3 if that takes less, until the difference at equal parameters is
 * at most the tolerance: proven where all weights are positive unless that takes many more points; at most
 * 2^18.
 * \param[in] g a spline of dimension >= 2.
 * \param[in] origin [dim].
 * \param[in] along [dim] e, made a unit vector.
 * \param[in] across [dim] n, made perpendicular to e and a unit vector.
 * \param[in] curvature k, signed; 0 changes nothing.
 * \param[in] lower,upper the bent part, lower < upper, infinite ones allowed.
 * \param[in] tolerance > 0.
 * \param[out] deviation or NULL: largest distance from the exact image, a bound if proven is 1, else of
 *   samples.
 * \param[out] proven or NULL: 1 or 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE, _DIRECTION, _OVERFLOW, _TOLERANCE;
 *   _FACTOR if k is not finite, _EMPTY_DOMAIN unless lower < upper, _NOT_CONVERGED if the tolerance is not
 *   reached, _NOT_REPRESENTABLE; _PERIODIC_KNOTS, _WEIGHTS_VANISH as for nurbs_elevate().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_bend(const nurbs *g, const double *origin, const double *along,
                                  const double *across, double curvature, double lower, double upper,
                                  double tolerance, double *deviation, int32_t *proven, nurbs **out);

/** \brief nurbs_bend() with progress reports, cancellation and a limit of work.
 * \param[in] g,origin,along,across,curvature,lower,upper,tolerance as for nurbs_bend().
 * \param[out] deviation,proven as for nurbs_bend().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_bend(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_bend_with(const nurbs *g, const double *origin, const double *along,
                                       const double *across, double curvature, double lower, double upper,
                                       double tolerance, double *deviation, int32_t *proven,
                                       const nurbs_call_options *call, nurbs **out);

/** \brief Free-form deformation (Sederberg & Parry 1986): maps a shape by a volume, C -> V(A C), where A
 * maps the box from lower to upper to the domain of V. The exact image of a curve has a high degree
 * (nurbs_compose()); here g is refined as by nurbs_bend() until the difference is at most the tolerance. That
 * is proven for polynomial curves whose exact image has a degree of at most NURBS_MAX_DEGREE, m > 1; g is
 * seen to be inside the box there, elsewhere at samples.
 * \param[in] g a spline of dimension m, the number of axes of volume.
 * \param[in] volume V, with m axes and of dimension m.
 * \param[in] lower,upper [m] the box, lower < upper; g has to be inside.
 * \param[in] tolerance > 0.
 * \param[out] deviation or NULL: largest distance from the exact image, a bound if proven is 1, else of
 *   samples.
 * \param[out] proven or NULL: 1 or 0.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _POINT_NOT_FINITE, _OVERFLOW, _TOLERANCE; _EMPTY_DOMAIN
 *   unless lower < upper, _OUTSIDE_DOMAIN if g leaves the box, _NOT_CONVERGED if the tolerance is not
 *   reached, _NOT_REPRESENTABLE; _PERIODIC_KNOTS, _WEIGHTS_VANISH as for nurbs_elevate().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_free_form_deform(const nurbs *g, const nurbs *volume, const double *lower,
                                              const double *upper, double tolerance, double *deviation,
                                              int32_t *proven, nurbs **out);

/** \brief nurbs_free_form_deform() with progress reports, cancellation and a limit of work.
 * \param[in] g,volume,lower,upper,tolerance as for nurbs_free_form_deform().
 * \param[out] deviation,proven as for nurbs_free_form_deform().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_free_form_deform(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_free_form_deform_with(const nurbs *g, const nurbs *volume, const double *lower,
                                                   const double *upper, double tolerance, double *deviation,
                                                   int32_t *proven, const nurbs_call_options *call,
                                                   nurbs **out);

/** \brief Fairs a shape: among the splines with the same knots and weights that are at most a tolerance away,
 * and of them those that move control points least for their energy, the one with the least energy, the
 * integral of the squared derivatives of an order, summed over the axes (of homogeneous coordinates about the
 * centre when rational). The bound is that of nurbs_deviation().
 * \param[in] g a spline.
 * \param[in] order of the derivatives: 1 (membrane), 2 (thin plate) or 3.
 * \param[in] keep [axes][2] or NULL for 0 on all axes that are not periodic, so that boundaries stay: highest
 *   order of derivatives that stay at the start and end of every axis, -1 for none. All control points on
 *   which they depend stay.
 * \param[in] tolerance largest distance from g, >= 0.
 * \param[out] energies [2] or NULL: before and after; give NULL where they would overflow, which is
 *   _NOT_REPRESENTABLE otherwise.
 * \param[out] bound or NULL: proven bound of the distance from g, at most the tolerance.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _ORDER, _TOLERANCE, _OVERLAP, _OVERFLOW, _NOT_REPRESENTABLE,
 *   _WEIGHTS_VANISH; _DEGREE if no axis has a degree of at least order.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_fair(const nurbs *g, int32_t order, const int32_t *keep, double tolerance,
                                  double *energies, double *bound, nurbs **out);

/** \brief nurbs_fair() with progress reports, cancellation and a limit of work.
 * \param[in] g,order,keep,tolerance as for nurbs_fair().
 * \param[out] energies,bound as for nurbs_fair().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new handle.
 * \return as for nurbs_fair(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_fair_with(const nurbs *g, int32_t order, const int32_t *keep, double tolerance,
                                       double *energies, double *bound, const nurbs_call_options *call,
                                       nurbs **out);

/** \brief Moves a boundary of a spline onto one of another: a curve's end onto an end, a surface's edge onto
 * an edge. Layers of control points at the boundary change, after both were made compatible along it; with
 * order 1 the second layer is moved too, so that tangents (of a surface: tangent planes) agree all along, g
 * going on from other: derivatives across are those of other times one factor, which leaves their mean size
 * as it was. Weights of the boundary become those of other, times a power of two that leaves their size.
 * \param[in] g a curve or surface.
 * \param[in] axis,end the boundary of g: axis, and NURBS_START or NURBS_END.
 * \param[in] other a spline with as many axes, of the same dimension.
 * \param[in] other_axis,other_end its boundary.
 * \param[in] order 0 (positions) or 1 (tangents too).
 * \param[in] flags NURBS_REVERSED: the boundaries of surfaces run against each other; or 0.
 * \param[out] bound or NULL: proven bound of the distance from g.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _END, _ORDER, _OVERFLOW, _KNOTS_MERGE, _NOT_REPRESENTABLE,
 *   _WEIGHTS_VANISH; _AXES if g is a volume or other has not as many axes, _FLAGS, also for NURBS_REVERSED
 *   with curves, _INCOMPATIBLE if the dimensions differ, _PERIODIC if an axis across a boundary is periodic,
 *   _DEGREE if one across has degree 0 and order is 1, _TANGENT if a tangent that is needed vanishes,
 *   _WEIGHT_SIGN if a weight of the second layer would not be positive.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_snap_boundary(const nurbs *g, int32_t axis, int32_t end, const nurbs *other,
                                           int32_t other_axis, int32_t other_end, int32_t order,
                                           uint32_t flags, double *bound, nurbs **out);
/** @} */

/** \defgroup linear Derivatives with respect to data
 * \code
 * const int32_t degree = 2;
 * const int64_t count = 4;
 * const double knots[] = {0, 0, 0, 0.5, 1, 1, 1}, params[] = {0, 0.5, 1};
 * double values[9];
 * int64_t columns[9], rows[4]; // the matrix N_j(t_i), 3 x 4, compressed
 * nurbs_collocation(1, &degree, &count, knots, 7, NULL, 3, params, 0, 0, 9, values, columns, rows, NULL, 0);
 * \endcode
 * A point is linear in the control points, and so is every derivative of it: C = A P. This group has the
 * matrix A, products with its transpose, and the operators that turn spans into Bezier pieces. On a periodic
 * axis all of them refer to the stored N control points, including the last `degree` layers along the axis,
 * as if these were not copies. With m = count - degree distinct layers, add the columns and gradients of
 * layer l + m to those of layer l, l < degree, to refer to the m distinct ones.
 * @{ */

/** \brief Collocation matrix of B-spline basis functions, or of one of their partial derivatives, as
 * compressed sparse rows (CSR), the arrays that SciPy and Eigen take. Row i is parameter i, column j is
 * control point j, last axis fastest, of N = counts[0] * ... * counts[axes-1]; the entry is
 *
 *     d^|a| / dt^a  N_j(t_i),   a = orders.
 *
 * Every row has the M = (degrees[0] + 1) * ... functions of the spans of its parameter, in rising columns,
 * zeros included; row_pointers[i] is i * M. A parameter that gives NaN (NURBS_NAN) has the M columns of the
 * first span of the knot vectors and the value NaN. Each array may be NULL if it is not wanted; with cap 0
 * values and columns are not written, which asks for their length. Values are those of nurbs_basis(),
 * multiplied over the axes: within 3 p eps of itself for each axis of degree p inside the domain at order 0,
 * otherwise as the preamble says of a derivative.
 * \param[in] axes,degrees,counts,knots,knot_count as for nurbs_create().
 * \param[in] orders [axes] or NULL for 0: order of the derivative along each axis, with a sum of at most
 *   NURBS_MAX_ORDER.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[in] cap length of values and columns: 0, or at least n * M.
 * \param[out] values [cap] or NULL: receives the n * M entries.
 * \param[out] columns [cap] or NULL: receives their columns.
 * \param[out] row_pointers [n + 1] or NULL: receives 0, M, ..., n * M.
 * \param[out] entries or NULL: n * M.
 * \param[in] flags evaluation flags per axis.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DEGREE, _COUNT, _TOO_FEW_POINTS, _OVERFLOW, _SIZE, _ORDER,
 *   _STRIDE, _OVERLAP, _FLAGS, _KNOT_NOT_FINITE, _KNOTS_DECREASING, _END_MULTIPLICITY, _MULTIPLICITY,
 *   _EMPTY_DOMAIN, _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_collocation(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                         const double *knots, int64_t knot_count, const int32_t *orders,
                                         int64_t n, const double *params, int64_t param_stride,
                                         int64_t param_component_stride, int64_t cap, double *values,
                                         int64_t *columns, int64_t *row_pointers, int64_t *entries,
                                         uint32_t flags);

/** \brief Collocation matrix of the rational basis functions R_j = w_j N_j / w(t) of a spline, or of one of
 * their partial derivatives; of N_j for a polynomial spline. Otherwise as nurbs_collocation().
 * By the quotient rule: with q = 1 / w(t), whose derivatives are q^(0) = 1 / w and
 *
 *     q^(a) = -(sum over 0 < b <= a of binomial(a, b) w^(b) q^(a-b)) / w,
 *     R_j^(a) = w_j * sum over b <= a of binomial(a, b) N_j^(b) q^(a-b).
 *
 * The values of order 0 are those of nurbs_rational_basis(), bit for bit.
 * \param[in] g a spline.
 * \param[in] orders [axes] or NULL for 0: order of the derivative along each axis, with a sum of at most
 *   NURBS_MAX_ORDER.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[in] cap length of values and columns: 0, or at least n * M.
 * \param[out] values [cap] or NULL: receives the n * M entries.
 * \param[out] columns [cap] or NULL: receives their columns.
 * \param[out] row_pointers [n + 1] or NULL: receives 0, M, ..., n * M.
 * \param[out] entries or NULL: n * M.
 * \param[in] flags evaluation flags per axis.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _SIZE, _ORDER, _STRIDE, _OVERLAP, _FLAGS,
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_rational_collocation(const nurbs *g, const int32_t *orders, int64_t n,
                                                  const double *params, int64_t param_stride,
                                                  int64_t param_component_stride, int64_t cap, double *values,
                                                  int64_t *columns, int64_t *row_pointers, int64_t *entries,
                                                  uint32_t flags);

/** \brief Bezier extraction operators of the non-empty spans of an axis (Borden, Scott, Evans & Hughes 2011).
 * On span e with the domain [a, b] and x = (t - a) / (b - a)
 *
 *     N_(f+j)(t) = sum_k C[j][k] B_(k,p)(x),   j = 0, ..., p,
 *
 * with f = firsts[e] and the Bernstein polynomials B of nurbs_bernstein(); the Bezier points of the piece are
 * Q_k = sum_j C[j][k] P_(f+j), with homogeneous points when rational. Entries are >= 0, those of a column
 * k add up to 1 and each is within 3 p eps of itself.
 * \param[in] g a spline.
 * \param[in] axis 0-based axis, of degree p.
 * \param[in] cap length of the arrays in spans; 0 asks for the number only.
 * \param[out] operators [cap][p + 1][p + 1] or NULL: receives C[j][k] of each span, packed.
 * \param[out] firsts [cap] or NULL: receives the index of the first control point of each span.
 * \param[out] domains [cap][2] or NULL: receives a and b of each span, packed.
 * \param[out] count number of non-empty spans in the domain.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXIS, _COUNT, _OVERFLOW, _OVERLAP; _SIZE if cap is neither 0 nor
 *   enough.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_bezier_extraction(const nurbs *g, int32_t axis, int64_t cap, double *operators,
                                               int64_t *firsts, double *domains, int64_t *count);

/** \brief Gradients of a function L of points and derivatives with respect to the control points, the weights
 * and the parameters: the transpose of nurbs_eval_derivs(), or of nurbs_eval() with order 0. Given the
 * cotangents G[k][s] = dL / dC^(s)(t_k) of every slot s,
 *
 *     grad_points[i]  = dL/dP_i = sum_k sum_s R_i^(s)(t_k) G[k][s],
 *     grad_weights[i] = dL/dw_i = sum_k sum_s < G[k][s], (N_i (P_i - C) / w)^(s)(t_k) >,
 *     grad_params[k][a] = dL/dt_k,a = sum_s < G[k][s], C^(s + e_a)(t_k) >,
 *
 * where < , > is the scalar product and e_a the order 1 along axis a. Points are Cartesian; those of a
 * homogeneous spline are its records divided by their weights, and a point at infinity has no finite weight
 * gradient. The weights of a polynomial spline are 1. For a parameter moved to an end by NURBS_CLAMP,
 * grad_params is 0. A parameter that gives NaN (NURBS_NAN) adds nothing to grad_points and grad_weights; its
 * grad_params are NaN. Cotangents may have any value and follow the rules of IEEE arithmetic.
 *
 * Contributions are added one after the other in the order of the parameters, so that the same arguments give
 * the same bits in every call and thread. With NURBS_ACCUMULATE they are added to what the outputs hold, and
 * a batch that is cut into consecutive calls gives the bits of a single one; without it the outputs are
 * overwritten, all N points of them. grad_points[i] is within
 *
 *     eps * sum_k sum_s (2 (c + 2 |s|) + n) |G[k][s]| E_s[R_i]
 *
 * of the exact sum, where E_s[R_i] is the magnitude of the derivative of R_i in the preamble (tested).
 * grad_weights[i] is within 1 / w_i times twice as much, with n + dim for n, and the magnitudes of the
 * products R_i P_i and R_i C instead of E_s[R_i]. grad_params are products with the results of
 * nurbs_eval_derivs(): bit for bit if order > 0, added up in the order of the slots and, in each, of the
 * coordinates; to rounding at order 0, where they are made from the sums of the other gradients. There
 * grad_params[k][a] is within
 *
 *     eps * (2 (c + 2) + dim) * sum over the coordinates of |G[k][0]| E_(e_a)[C]
 *
 * of the exact product, as the product with the results of nurbs_eval_derivs() is, so that the two differ by at
 * most twice that (tested).
 * \param[in] g a spline.
 * \param[in] order highest order of derivatives in L; less than NURBS_MAX_ORDER if grad_params is wanted.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[in] cotangents [n][S][dim] with S = binomial(order + axes, axes) slots as for nurbs_eval_derivs():
 *   coordinate c of slot s is component s * dim + c.
 * \param[in] cotangent_stride,cotangent_component_stride layout of cotangents, 0 = packed.
 * \param[in,out] grad_points [N][dim] or NULL: last axis fastest.
 * \param[in] grad_point_stride,grad_point_component_stride layout of grad_points, 0 = packed.
 * \param[in,out] grad_weights [N] or NULL.
 * \param[in] grad_weight_stride distance between weight gradients, 0 = 1.
 * \param[in,out] grad_params [n][axes] or NULL.
 * \param[in] grad_param_stride,grad_param_component_stride layout of grad_params, 0 = packed.
 * \param[in] flags evaluation flags per axis, and NURBS_ACCUMULATE.
 * \return as for nurbs_eval_derivs().
 * \since 1.0 */
NURBS_API nurbs_status nurbs_eval_adjoint(const nurbs *g, int32_t order, int64_t n, const double *params,
                                          int64_t param_stride, int64_t param_component_stride,
                                          const double *cotangents, int64_t cotangent_stride,
                                          int64_t cotangent_component_stride, double *grad_points,
                                          int64_t grad_point_stride, int64_t grad_point_component_stride,
                                          double *grad_weights, int64_t grad_weight_stride,
                                          double *grad_params, int64_t grad_param_stride,
                                          int64_t grad_param_component_stride, uint32_t flags);

/** \brief Gradients of a function L of points and derivatives with respect to the knots of an axis. Given the
 * cotangents G[k][s] = dL / dC^(s)(t_k) of every slot s,
 *
 *     grad_knots[j] = sum_k sum_s < G[k][s], (dC / dtau_j)^(s)(t_k) >
 *
 * for every knot tau_j of the full vector, with the derivatives of nurbs_eval_knot_derivative(). Each knot
 * counts alone. Where knots are equal their gradients are those of moving the first one down and the last one
 * up; add them up for moving all of them together. On a periodic axis with m = count - degree distinct
 * layers, add up those of the knots j, j + m, ... that move together. The first and the last knot, and all
 * knots at degree 0, have gradients 0. The cost grows with the 2 p knots of an axis that matter at a
 * parameter.
 *
 * A parameter at a knot belongs to the span that evaluation takes (NURBS_LEFT), whose polynomial piece is
 * continued when the knot moves. A parameter moved by NURBS_CLAMP or NURBS_WRAP stays where it was moved to,
 * whatever happens to the ends of the domain. One that gives NaN (NURBS_NAN) adds nothing. Contributions are
 * added in the order of the parameters; with NURBS_ACCUMULATE to what grad_knots holds. At order 0 each
 * contribution is within (16 p + 8) eps |G| D / h, with D and h of nurbs_eval_knot_derivative(), times the
 * square of the largest weight over w(t_k) (tested).
 * \param[in] g a spline.
 * \param[in] axis 0-based axis.
 * \param[in] order highest order of derivatives in L.
 * \param[in] n number of parameters.
 * \param[in] params [n][axes].
 * \param[in] param_stride,param_component_stride layout of params, 0 = packed.
 * \param[in] cotangents [n][S][dim] with S = binomial(order + axes, axes) slots as for nurbs_eval_derivs().
 * \param[in] cotangent_stride,cotangent_component_stride layout of cotangents, 0 = packed.
 * \param[in,out] grad_knots [K] with K = count + degree + 1 knots of the axis.
 * \param[in] flags evaluation flags per axis, and NURBS_ACCUMULATE.
 * \return as for nurbs_eval_derivs(), and NURBS_ERROR_AXIS.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_eval_adjoint_knots(const nurbs *g, int32_t axis, int32_t order, int64_t n,
                                                const double *params, int64_t param_stride,
                                                int64_t param_component_stride, const double *cotangents,
                                                int64_t cotangent_stride, int64_t cotangent_component_stride,
                                                double *grad_knots, uint32_t flags);

/** \brief Gradients of a function L of closest points, or of any places where the distance to a point is
 * critical, with respect to control points, weights and the query points, by the implicit function theorem.
 * The foot u of a point x, with r = C(u) - x, satisfies < r, C_a > = 0 on every axis a where it is free. With
 * H_ab = < C_a, C_b > + < r, C_ab >, and the cotangents g_u, g_f and g_d of parameters, feet and distances,
 *
 *     H lambda = -(g_u + < g_f, C_a >)_a,   v = g_d r / |r| + sum_a lambda_a C_a,
 *     dL/dx = -v,   dL/dC(u) = g_f + v,   dL/dC_a(u) = lambda_a r,
 *
 * and the last two go through nurbs_eval_adjoint(): one small system for each point, and no search. An axis is
 * not free where the foot lies at an end of the domain and the axis is not periodic, nor if its degree is 0,
 * nor at a knot of multiplicity >= degree where < r, C_a > is not 0 (to 2^-30 |r| |C_a|), a kink that holds
 * it: lambda_a is 0 there. At the edge of a `range` inside the domain the foot counts as free, which it is
 * not; leave such feet out. The params are taken as they are: those of a foot that was not found exactly give
 * the gradient of Newton's step from there. Derivatives at a knot are those of the side that NURBS_LEFT
 * chooses. No squares of lengths are made: coordinates may have any size at which the results are numbers.
 *
 * Where something is not determined the status has NURBS_CLOSEST_SINGULAR. There are two cases. H may be
 * singular to rounding (an eigenvalue below 256 eps after every axis is scaled by the square root of |C_a|^2
 * + |r| |C_aa|), as at a centre of curvature: the foot adds nothing, and its grad_queries are 0. Or g_d is
 * not 0, and |r| is not longer than what rounding may add to it, eps times the sum over the axes of sqrt(dim)
 * (7 p + 2) hull (nurbs_hull_size()) and |u_a| |C_a|: the point lies on the spline, as far as doubles tell,
 * and r / |r| is any direction. Then g_d counts as 0, the shortest subgradient of the distance, and all else
 * is as the formulas say. With NURBS_NAN_POINTS a query point or foot that is not finite, as those of
 * nurbs_closest_points() are for such points, or a foot outside the domain has NURBS_CLOSEST_INVALID and adds
 * nothing, and its grad_queries are NaN.
 * \param[in] g a spline.
 * \param[in] n number of points.
 * \param[in] points [n][dim] the query points, packed.
 * \param[in] params [n][axes] parameters of their feet, packed.
 * \param[in] param_cotangents [n][axes] or NULL for 0, packed.
 * \param[in] foot_cotangents [n][dim] or NULL for 0, packed.
 * \param[in] distance_cotangents [n] or NULL for 0.
 * \param[out] grad_points [N][dim] or NULL: packed, last axis fastest.
 * \param[out] grad_weights [N] or NULL.
 * \param[out] grad_queries [n][dim] or NULL: packed.
 * \param[out] status [n] or NULL: 0, or a sum of NURBS_CLOSEST_BOUNDARY (not free on an axis), _SINGULAR,
 *   _INVALID.
 * \param[in] flags NURBS_LEFT per axis, and NURBS_NAN_POINTS.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _OVERLAP, _FLAGS, _POINT_NOT_FINITE,
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_closest_adjoint(const nurbs *g, int64_t n, const double *points,
                                             const double *params, const double *param_cotangents,
                                             const double *foot_cotangents, const double *distance_cotangents,
                                             double *grad_points, double *grad_weights, double *grad_queries,
                                             int32_t *status, uint32_t flags);

/** \brief Gradients of the length of a curve, or of a part of it, with respect to control points and weights:
 * with the unit tangent T and the rational functions R_i,
 *
 *     grad_points[i]  = cotangent * integral of R_i'(t) T(t) dt,
 *     grad_weights[i] = cotangent * integral of < T, (N_i (P_i - C) / w)'(t) > dt,
 *
 * by nested rules of 15 and 31 nodes on each span, never across a knot; a span is halved as long as they
 * differ by more than the tolerance allows, and where tangents at neighbouring nodes are more than 41 degrees
 * apart. Where the curve stands still T counts as 0. Errors are relative to
 * the longest gradient of a control point, for weights to length / w_i. 0, and a tolerance below 64 eps, asks
 * for the best within 1e-3. Points are Cartesian, all N stored ones; the weights of a polynomial curve are 1.
 * \param[in] g a curve.
 * \param[in] range [2] or NULL for all of it: the part of the domain.
 * \param[in] relative_tolerance >= 0.
 * \param[in] cotangent dL / dlength, 1 for the gradients of the length itself.
 * \param[in,out] grad_points [N][dim] or NULL.
 * \param[in] grad_point_stride,grad_point_component_stride layout of grad_points, 0 = packed.
 * \param[in,out] grad_weights [N] or NULL.
 * \param[in] grad_weight_stride distance between weight gradients, 0 = 1.
 * \param[out] error or NULL: estimate of the relative error of the integrals, rounding included.
 * \param[in] flags NURBS_ACCUMULATE or 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _STRIDE, _OVERFLOW, _OVERLAP, _FLAGS, _TOLERANCE;
 *   _PARAMETER_NOT_FINITE, _OUTSIDE_DOMAIN or _EMPTY_DOMAIN if range is no interval of the domain;
 *   _NOT_CONVERGED naming the error reached, _NOT_REPRESENTABLE if a gradient that is wanted overflows.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_length_adjoint(const nurbs *g, const double *range, double relative_tolerance,
                                            double cotangent, double *grad_points, int64_t grad_point_stride,
                                            int64_t grad_point_component_stride, double *grad_weights,
                                            int64_t grad_weight_stride, double *error, uint32_t flags);
/** @} */

/** \defgroup face Trimmed faces
 * \code
 * nurbs *circle = NULL;
 * nurbs_face *face = NULL;
 * const double center[] = {0.5, 0.5}; // in the domain of the surface
 * const int64_t size = 1;             // one loop of one closed curve
 * double gap = 0, area = 0, error = 0;
 * nurbs_curve_circle(2, center, NULL, NULL, 0.25, NURBS_ARC_QUARTERS, &circle);
 * nurbs_face_create(surface, 1, &size, (const nurbs *const *)&circle, NULL, NULL, 1e-6, 0, &gap, &face);
 * nurbs_face_area(face, 1e-9, &area, &error);
 * nurbs_face_destroy(face);
 * nurbs_destroy(circle);
 * \endcode
 * A face is the part of a surface that loops of curves in its domain bound. The curves of a loop follow one
 * another: each begins where the one before it ends, and the first where the last one ends. Inside is what
 * lies to the left of the loops, in a plane with u to the right and v upwards: outer loops run
 * counterclockwise, holes clockwise.
 *
 * **Surfaces that close.** An axis is closed if its two boundaries are nowhere farther apart than the
 * tolerance of the face (nurbs_boundary_contacts()); periodic axes are closed. Loops lie in the plane that
 * copies of the domain cover. On a closed axis a curve may run over an end of the domain into the next copy.
 * Each curve is taken in the copy in which it begins nearest to the end of the one before it, and a loop may
 * end in another copy of the place where it began, having run around the axis. One such loop bounds a cap of
 * a sphere, two bound a band of a cylinder; what lies to their left is inside. A boundary no larger than the
 * tolerance is a pole. If one curve ends at a pole and the next begins at it, the two are joined along the
 * pole, with the inside to the left.
 *
 * **Edges** are the curves in space that belong to the curves of the loops. Either may be missing. A missing
 * curve of the domain is made under its edge, and a missing edge over its curve. Both then have equal
 * parameters (opposite ones if the edge runs against the curve), and nurbs_face_deviation() returns how far
 * apart they are.
 *
 * Results are exact for the stored curves, and for the segments that join ends which do not meet. Faces are
 * immutable and reference counted, as splines are, and any number of threads may use one at once.
 * @{ */

/** \brief A face made of a surface and loops of curves.
 *
 * Outer loops and holes are recognised, whatever their order and direction, by which loops lie inside which.
 * Loops that do not run around a closed axis are turned so that those inside an even number of others enclose
 * what is inside. Where loops run around a closed axis, these say what is inside before the others do. With
 * NURBS_AS_ORIENTED no loop is turned. A loop that is turned has its curves in the opposite order and each of
 * them reversed, t -> -t.
 *
 * **Crossings.** With NURBS_CHECK_CROSSINGS, loops that cross themselves or each other are refused, in all
 * copies of a closed domain. To the left of a loop is the inside, to its right the outside. Where curves
 * cross, there are places to the left, or to the right, of one curve more than that. So all hits of the
 * curves are found, as by nurbs_curve_intersections() with a tolerance of 0, and samples beside the parts of
 * the loops between them show whether there are such places. The samples are taken at the tolerance and at
 * twice the tolerance from the curve: what is thinner is not a crossing. Loops may touch each other and
 * themselves, in points and where curves end. Curves that run along each other are refused, except those of
 * one loop that go there and back, as along a seam, and those of two loops that run around a closed axis in
 * opposite directions. Loops that lie inside each other in a way that no face allows are refused with
 * NURBS_ERROR_ORIENTATION. Segments that close gaps larger than the tolerance are checked like curves.
 *
 * Costs: each curve that is made takes a nearest point for each place that it goes through; the rest is
 * linear in the number of spans. The check takes n log n for n curves, and the search for hits of those whose
 * boxes meet.
 * \param[in] surface a surface.
 * \param[in] loops number of loops; 0: the whole surface, bounded by those of its boundaries that neither
 *   meet nor are poles, from the lower left corner on.
 * \param[in] sizes [loops] or NULL when loops is 0: number of curves of each loop, at least 1.
 * \param[in] curves [size] or NULL for none, size being the sum of the sizes: curves of dimension 2 in the
 *   domain of the surface, with positive weights, in the direction of their loops, loop by loop; NULL for a
 *   curve that is missing, where there is an edge.
 * \param[in] edges [size] or NULL for none: curves of the dimension of the surface; NULL for an edge that is
 *   missing, where there is a curve.
 * \param[in] keys [size] or NULL for zeros: numbers of edges, the same in all faces that share an edge,
 *   negative if the edge runs against the direction of the loop. 0: an edge without number, which runs with
 *   the loop.
 * \param[in] tolerance the largest distance in space that counts as zero, >= 0: of ends that are to meet, of
 *   edges from the surface, of curves beyond the domain.
 * \param[in] flags sum of NURBS_AS_ORIENTED, NURBS_CHECK_CROSSINGS and NURBS_KEEP_GAPS, by which gaps larger
 *   than the tolerance are closed by segments, too; or 0.
 * \param[out] gaps [loops] or NULL: for each loop, the largest distance in space of two ends that are to
 *   meet. They are written with NURBS_ERROR_GAP, too, where curves do not meet.
 * \param[out] out the new face.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERFLOW, _DIMENSION, _TOLERANCE, _FLAGS, _OVERLAP;
 *   _GAP naming the loop if curves do not meet, or the edge that is off the surface; _OUTSIDE_DOMAIN naming a
 *   curve that leaves the domain on an axis that is not closed; _WEIGHT_SIGN; _ORIENTATION naming a loop that
 *   encloses nothing, or has its left side where another one has its right side; _NOT_CONVERGED for an edge
 *   under which no curve is found; with NURBS_CHECK_CROSSINGS _CROSSING naming two curves with their loops
 *   and the parameters where they cross, and _NOT_CONVERGED naming two of which it is undecided whether they
 *   do, because of rounding or at the limit of work.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_create(const nurbs *surface, int64_t loops, const int64_t *sizes,
                                         const nurbs *const *curves, const nurbs *const *edges,
                                         const int64_t *keys, double tolerance, uint32_t flags, double *gaps,
                                         nurbs_face **out);

/** \brief nurbs_face_create() with progress reports, cancellation and a limit of work.
 * \param[in] surface,loops,sizes,curves,edges,keys,tolerance,flags as for nurbs_face_create().
 * \param[out] gaps as for nurbs_face_create().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new face.
 * \return as for nurbs_face_create(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_create_with(const nurbs *surface, int64_t loops, const int64_t *sizes,
                                              const nurbs *const *curves, const nurbs *const *edges,
                                              const int64_t *keys, double tolerance, uint32_t flags,
                                              double *gaps, const nurbs_call_options *call, nurbs_face **out);

/** \brief Another handle on the same face, in constant time.
 * \param[in] face a face.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_clone(const nurbs_face *face, nurbs_face **out);

/** \brief Frees a handle on a face.
 * \param[in] face or NULL, which does nothing: a face.
 * \since 1.1 */
NURBS_API void nurbs_face_destroy(nurbs_face *face);

/** \brief The surface of a face.
 * \param[in] face a face.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_surface(const nurbs_face *face, nurbs **out);

/** \brief The number of curves of each loop.
 * \param[in] face a face.
 * \param[in] cap length of sizes, 0 to ask for the number of loops.
 * \param[out] sizes [cap] or NULL when cap is 0.
 * \param[out] count or NULL: the number of loops.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _SIZE, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_loops(const nurbs_face *face, int64_t cap, int64_t *sizes, int64_t *count);

/** \brief A curve of a loop in the domain of the surface, running with the inside to its left.
 * \param[in] face a face.
 * \param[in] loop 0-based.
 * \param[in] index 0-based, in the loop.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_curve(const nurbs_face *face, int64_t loop, int64_t index, nurbs **out);

/** \brief The edge in space that belongs to a curve of a loop.
 *
 * It is the edge that was given, in its own direction, or one that is made. The latter is the surface
 * composed with the curve (nurbs_compose()) where the degree of this is at most NURBS_MAX_DEGREE and the
 * curve stays in the domain; on a plane parallelogram of degree 1 it is the curve with its control points
 * moved there, of its own degree. Elsewhere it is a curve through as many places as the tolerance of the face
 * takes.
 * \param[in] face a face.
 * \param[in] loop 0-based.
 * \param[in] index 0-based, in the loop.
 * \param[out] key or NULL: its number, negative if it runs against the loop; 0 if it has none and runs with
 *   the loop.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _NOT_CONVERGED, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_edge(const nurbs_face *face, int64_t loop, int64_t index, int64_t *key,
                                       nurbs **out);

/** \brief How far a curve of a loop, mapped by the surface, and its edge are apart.
 *
 * The distance is that at equal parameters if this is within the tolerance of the face, otherwise that from
 * each to the nearest point of the other. The largest of these distances is the true tolerance of a face.
 * \param[in] face a face.
 * \param[in] loop 0-based.
 * \param[in] index 0-based, in the loop.
 * \param[out] distance the distance.
 * \param[out] proven or NULL: 1 if the distance is a proven bound; 0 if it is the largest one seen, because
 *   the composed curve would have a degree above NURBS_MAX_DEGREE, or the search ended at its limit.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _OVERLAP, _NOT_CONVERGED, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_deviation(const nurbs_face *face, int64_t loop, int64_t index,
                                            double *distance, int32_t *proven);

/** \brief The tolerance that a face was created with.
 * \param[in] face a face.
 * \param[out] tolerance the tolerance.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_tolerance(const nurbs_face *face, double *tolerance);

/** \brief On which side of the boundary of a face places of the domain lie.
 *
 * Curves are cut into pieces on which both parameters run one way. The direction of each piece in the column
 * above a place says from which side the piece is passed, so that the answer is exact for the stored curves.
 * It is 0 where rounding would have to decide, which happens only within some units of rounding of a curve.
 * On closed axes, parameters outside the domain are wrapped; on other axes, such places are outside, or on the
 * boundary if they are within the tolerance of it.
 * \param[in] face a face.
 * \param[in] n number of parameters.
 * \param[in] params [n][2] finite.
 * \param[in] param_stride distance between parameters, 0 = packed.
 * \param[in] param_component_stride distance between their components, 0 = 1.
 * \param[in] tolerance the distance in space from the boundary within which a place counts as on it, >= 0,
 *   measured by the first derivatives of the surface at the place.
 * \param[out] sides [n] 1 inside, 0 on the boundary, -1 outside.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _TOLERANCE,
 *   _PARAMETER_NOT_FINITE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_classify(const nurbs_face *face, int64_t n, const double *params,
                                           int64_t param_stride, int64_t param_component_stride,
                                           double tolerance, int32_t *sides);

/** \brief nurbs_face_classify() with progress reports, cancellation and a limit of work.
 * \param[in] face,n,params,param_stride,param_component_stride,tolerance as for nurbs_face_classify().
 * \param[out] sides as for nurbs_face_classify().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_face_classify(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_classify_with(const nurbs_face *face, int64_t n, const double *params,
                                                int64_t param_stride, int64_t param_component_stride,
                                                double tolerance, int32_t *sides,
                                                const nurbs_call_options *call);

/** \brief The first hits of rays x = origin + t direction, t >= 0, with a face.
 *
 * They are hits of its surface, as by nurbs_surface_rays(), that lie inside its loops for certain. A hit so
 * near to a curve of a loop that rounding would have to decide is a touch. What lies outside for certain is
 * passed over, so that NURBS_RAY_CERTIFIED without a hit or a touch proves that the ray meets no point of the
 * face. The face ends where its curves are, not where they are within its tolerance: nurbs_model_rays()
 * allows for that.
 * \param[in] face a face of a surface of dimension 3.
 * \param[in] n number of rays.
 * \param[in] origins [n][3] the origins of the rays.
 * \param[in] origin_stride,origin_component_stride layout of origins, 0 = packed.
 * \param[in] directions [n][3] their directions, of any length but 0.
 * \param[in] direction_stride,direction_component_stride layout of directions, 0 = packed.
 * \param[out] params [n][2] or NULL: parameters of the surface; NaN where there is neither a hit nor a touch.
 * \param[out] distances [n] or NULL: t, in units of the length of the direction; NaN where params are.
 * \param[out] status [n] or NULL: sums of NURBS_RAY_ bits, as for nurbs_surface_rays().
 * \return NURBS_OK, NURBS_ERROR_NULL, _DIMENSION, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP; _POINT_NOT_FINITE if
 *   an origin is not finite, _DIRECTION if a direction is not finite or 0.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_rays(const nurbs_face *face, int64_t n, const double *origins,
                                       int64_t origin_stride, int64_t origin_component_stride,
                                       const double *directions, int64_t direction_stride,
                                       int64_t direction_component_stride, double *params, double *distances,
                                       int32_t *status);

/** \brief nurbs_face_rays() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work, rays that were not examined have no status bits.
 * \param[in] face,n,origins,origin_stride,origin_component_stride,directions as for nurbs_face_rays().
 * \param[in] direction_stride,direction_component_stride as for nurbs_face_rays().
 * \param[out] params,distances,status as for nurbs_face_rays().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_face_rays(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_rays_with(const nurbs_face *face, int64_t n, const double *origins,
                                            int64_t origin_stride, int64_t origin_component_stride,
                                            const double *directions, int64_t direction_stride,
                                            int64_t direction_component_stride, double *params,
                                            double *distances, int32_t *status,
                                            const nurbs_call_options *call);

/** \brief The points of a face that are nearest to given points.
 *
 * If the nearest point of the surface lies inside the face, it is the result. Otherwise the result is the
 * nearest point of the boundary, or the nearest of those local minima of the distance from the surface that
 * lie inside and are nearer than that. Where rounding would have to say whether a point is inside, it counts
 * as inside.
 * \param[in] face a face.
 * \param[in] n number of points.
 * \param[in] points [n][dim], finite.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] tolerance how much nearer another point may be, >= 0.
 * \param[out] params [n][2] or NULL: parameters of the surface.
 * \param[out] feet [n][dim] or NULL: the nearest points, as nurbs_eval() gives them.
 * \param[out] distances [n] or NULL: the distances.
 * \param[out] status [n] or NULL: NURBS_CLOSEST_ bits; NURBS_CLOSEST_BOUNDARY: on the boundary of the face.
 *   Without NURBS_CLOSEST_CERTIFIED a nearer point is not excluded: where the default budget of
 *   nurbs_closest_points() or the limit of work ends, where minima are not isolated, and where a curve of the
 *   boundary, composed with the surface, would have a degree above NURBS_MAX_DEGREE. Then NURBS_CLOSEST_BUDGET
 *   is set. Whether other points are as near is not reported.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _TOLERANCE, _POINT_NOT_FINITE,
 *   _NOT_CONVERGED, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_closest_points(const nurbs_face *face, int64_t n, const double *points,
                                                 int64_t point_stride, int64_t point_component_stride,
                                                 double tolerance, double *params, double *feet,
                                                 double *distances, int32_t *status);

/** \brief nurbs_face_closest_points() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work, points are not certified.
 * \param[in] face,n,points,point_stride,point_component_stride as for nurbs_face_closest_points().
 * \param[in] tolerance as for nurbs_face_closest_points().
 * \param[out] params,feet,distances,status as for nurbs_face_closest_points().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_face_closest_points(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_closest_points_with(const nurbs_face *face, int64_t n, const double *points,
                                                      int64_t point_stride, int64_t point_component_stride,
                                                      double tolerance, double *params, double *feet,
                                                      double *distances, int32_t *status,
                                                      const nurbs_call_options *call);

/** \brief Proven bounds of the smallest distance between two faces.
 *
 * As for splines (nurbs_distance()), at_least <= distance of the nearest points <= at_most, and at_most is
 * the distance of the two points returned. The bounds differ by at most the tolerance and rounding unless the
 * limit of work ends the search. Nearest points are searched for on the curves of both boundaries, on the
 * curves of one face and inside the other, and inside both. Inside, pairs of pieces are left out of which one
 * lies outside its face, or along which the distance falls towards other pieces. Places so near to a curve
 * that rounding would have to say whether they are inside count as inside. Where both surfaces go on beyond
 * edges that lie side by side, as in one plane, with a gap between them, the search takes a number of pieces
 * in proportion to the length of the edges over the gap.
 * \param[in] a,b two faces of surfaces of the same dimension.
 * \param[in] tolerance largest difference of the bounds that is wanted, >= 0.
 * \param[out] at_least,at_most or NULL: the bounds. Where a curve of a boundary, composed with the surface,
 *   would have a degree above NURBS_MAX_DEGREE, at_least comes only from ever smaller pieces, of which the
 *   limit of work allows few.
 * \param[out] params_a,params_b [2] or NULL: parameters of the surface of a, and of the surface of b.
 * \param[out] status or NULL: NURBS_CLOSEST_CERTIFIED, NURBS_CLOSEST_BUDGET.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _TOLERANCE; _INCOMPATIBLE if the dimensions differ,
 *   _NOT_REPRESENTABLE if a distance overflows.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_distance(const nurbs_face *a, const nurbs_face *b, double tolerance,
                                           double *at_least, double *at_most, double *params_a,
                                           double *params_b, int32_t *status);

/** \brief nurbs_face_distance() with progress reports, cancellation and a limit of work.
 * \param[in] a,b,tolerance as for nurbs_face_distance().
 * \param[out] at_least,at_most,params_a,params_b,status as for nurbs_face_distance().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_face_distance(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_distance_with(const nurbs_face *a, const nurbs_face *b, double tolerance,
                                                double *at_least, double *at_most, double *params_a,
                                                double *params_b, int32_t *status,
                                                const nurbs_call_options *call);

/** \brief Proven bounds of the Hausdorff distances of two faces.
 *
 * As for splines (nurbs_hausdorff_distance()), the distance from a to b is that of the point of a that is
 * farthest from b; the distance from b to a is the other way round. The larger of the two is the symmetric
 * distance. at_least[i] <= distance <= at_most[i], both proven. The bounds differ by at most the tolerance
 * and rounding unless the limit of work ends the search; at_most may then be infinite. Where a face ends
 * beside the other one, bounds fall only with the size of the pieces, whose number is in proportion to 1 /
 * tolerance. For a face and a copy of it, both distances are 0.
 * \param[in] a,b two faces of surfaces of the same dimension.
 * \param[in] tolerance largest difference of the bounds that is wanted, >= 0.
 * \param[out] at_least [2] or NULL: from a to b, from b to a.
 * \param[out] at_most [2] or NULL: the same, from above.
 * \param[out] params_a [2] or NULL: parameters of a place of a that is at_least[0] away from b.
 * \param[out] params_b [2] or NULL: parameters of a place of b that is at_least[1] away from a.
 * \param[out] status or NULL: NURBS_CLOSEST_CERTIFIED, NURBS_CLOSEST_BUDGET.
 * \return as for nurbs_face_distance().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_hausdorff_distance(const nurbs_face *a, const nurbs_face *b,
                                                     double tolerance, double *at_least, double *at_most,
                                                     double *params_a, double *params_b, int32_t *status);

/** \brief nurbs_face_hausdorff_distance() with progress reports, cancellation and a limit of work.
 * \param[in] a,b,tolerance as for nurbs_face_hausdorff_distance().
 * \param[out] at_least,at_most,params_a,params_b,status as for nurbs_face_hausdorff_distance().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_face_hausdorff_distance(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_hausdorff_distance_with(const nurbs_face *a, const nurbs_face *b,
                                                          double tolerance, double *at_least, double *at_most,
                                                          double *params_a, double *params_b, int32_t *status,
                                                          const nurbs_call_options *call);

/** \brief The area of a face.
 *
 * It is the sum of integrals over rectangles and curved trapezoids of the domain (Gunderman, Weiss, Evans
 * 2021), each within one span of the surface.
 * \param[in] face a face.
 * \param[in] relative_tolerance >= 0; 0 asks for the best that double precision and a limit of work give.
 * \param[out] area the area.
 * \param[out] error or NULL: estimate of the error.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _TOLERANCE, _NOT_CONVERGED naming the error reached,
 *   _ORIENTATION if loops cross or coincide, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_area(const nurbs_face *face, double relative_tolerance, double *area,
                                       double *error);

/** \brief nurbs_face_area() with progress reports, cancellation and a limit of work.
 * \param[in] face,relative_tolerance as for nurbs_face_area().
 * \param[out] area,error as for nurbs_face_area().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_face_area(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_area_with(const nurbs_face *face, double relative_tolerance, double *area,
                                            double *error, const nurbs_call_options *call);

/** \brief Area, centroid and inertia of a face, as nurbs_moments() computes them for a whole surface.
 *
 * In the shapes below, dim is the dimension of the surface.
 * \param[in] face a face.
 * \param[in] relative_tolerance as for nurbs_face_area().
 * \param[out] content the area.
 * \param[out] centroid [dim] or NULL.
 * \param[out] inertia [dim][dim] or NULL: about the centroid.
 * \param[out] error or NULL: estimate of the error of content.
 * \return as for nurbs_face_area(), and NURBS_ERROR_LENGTH if the area is 0 and centroid or inertia are
 *   wanted.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_moments(const nurbs_face *face, double relative_tolerance, double *content,
                                          double *centroid, double *inertia, double *error);

/** \brief nurbs_face_moments() with progress reports, cancellation and a limit of work.
 * \param[in] face,relative_tolerance as for nurbs_face_moments().
 * \param[out] content,centroid,inertia,error as for nurbs_face_moments().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_face_moments(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_moments_with(const nurbs_face *face, double relative_tolerance,
                                               double *content, double *centroid, double *inertia,
                                               double *error, const nurbs_call_options *call);

/** \brief Points and weights for integrals of any function over a face.
 *
 * They are like those of nurbs_quadrature() for a whole surface: Gauss rules on the cells of which the face
 * consists. Each cell lies between two lines across the first axis, and between two curves, or knots, that
 * stay in one span of the surface. All points are in the face, to rounding, and no weight is negative. Beside
 * curved loops the rule follows the loops through u = 3 x^2 - 2 x^3. It converges fast for bounds that are
 * vertical at an end, like those of circles, and slower for those that are nearly vertical inside; it is
 * exact for neither. More nodes, and nurbs_face_area(), show how good it is. Between straight bounds it is
 * exact for polynomials in the parameters of total degree 2 nodes - 2.
 * \param[in] face a face.
 * \param[in] nodes number of nodes along each axis of a cell, 1 to 64; 0: one more than the larger degree of
 *   the surface.
 * \param[in] cap length of the arrays in points; 0 asks for the number only.
 * \param[out] params [cap][2] or NULL: receives the parameters, packed.
 * \param[out] weights [cap] or NULL: receives the weights of the parameters, which add up to the size of the
 *   face in its domain.
 * \param[out] measures [cap] or NULL: receives the weights of areas.
 * \param[out] count or NULL: receives the number of points.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERFLOW, _OVERLAP; _COUNT for nodes or cap out of range, _SIZE if cap
 *   is neither 0 nor enough, _ORIENTATION if loops cross or coincide, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_quadrature(const nurbs_face *face, int32_t nodes, int64_t cap,
                                             double *params, double *weights, double *measures,
                                             int64_t *count);

/** \brief nurbs_face_quadrature() with progress reports, cancellation and a limit of work.
 * \param[in] face,nodes,cap as for nurbs_face_quadrature().
 * \param[out] params,weights,measures,count as for nurbs_face_quadrature().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_face_quadrature(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_quadrature_with(const nurbs_face *face, int32_t nodes, int64_t cap,
                                                  double *params, double *weights, double *measures,
                                                  int64_t *count, const nurbs_call_options *call);

/** \brief An axis-aligned box that contains a face.
 *
 * In the shapes below, dim is the dimension of the surface. Edges that are composed with the surface are
 * bounded as splines are; inside, parts of the surface on which a coordinate may be extreme are halved.
 * \param[in] face a face.
 * \param[in] tolerance how far a side may be from the nearest point of the face, >= 0.
 * \param[out] lower [dim] the lower corner.
 * \param[out] upper [dim] the upper corner.
 * \param[out] gap or NULL: a proven bound of the largest distance of a side from the face; at most the
 *   tolerance, apart from rounding, unless 20000 halvings do not reach it.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP, _TOLERANCE, _NOT_CONVERGED, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_box(const nurbs_face *face, double tolerance, double *lower, double *upper,
                                      double *gap);

/** \brief nurbs_face_box() with progress reports, cancellation and a limit of work.
 * \param[in] face,tolerance as for nurbs_face_box().
 * \param[out] lower,upper,gap as for nurbs_face_box().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_face_box(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_box_with(const nurbs_face *face, double tolerance, double *lower,
                                           double *upper, double *gap, const nurbs_call_options *call);
/** @} */

/** \defgroup read Reading files
 * \code
 * nurbs_list *list = NULL;
 * nurbs *first = NULL;
 * if (nurbs_read_file("part.igs", NULL, &list) == NURBS_OK && nurbs_list_get(list, 0, &first) == NURBS_OK) {
 *     nurbs_destroy(first);
 * }
 * nurbs_list_destroy(list);
 * \endcode
 * @{ */

/** \name What files are read for
 * Bits of `kinds` in nurbs_read_options. \since 1.1
 * @{ */
/** \brief curves: in lists all, also those of edges; in models those that are part of no face or edge */
#define NURBS_READ_CURVES 0x1u
/** \brief surfaces: in lists all, also those of faces; in models those that are part of no face (STEP) */
#define NURBS_READ_SURFACES 0x2u
/** \brief faces of models with their edges and vertices, and other edges; in IGES also surfaces alone */
#define NURBS_READ_FACES 0x4u
/** @} */

/** \brief Settings for nurbs_read(); fill with nurbs_read_options_init() first. Fields are only ever
 * appended, and struct_size is at most 4096. A file whose own unit is not known cannot be converted to
 * another: NURBS_ERROR_OPTIONS. */
typedef struct nurbs_read_options {
    int64_t struct_size; /**< size of this struct as the caller knows it */
    double unit;         /**< wanted unit in metres (0.001: millimetres); 0 keeps the file's own */
    int64_t max_bytes;   /**< largest file accepted; 0 means the default, 2^30 */
    double tolerance;    /**< the distance, in the unit of the result, that counts as zero: the tolerance of
                              faces, and how near to what the file states is what has to be made; 0 for the
                              uncertainty or resolution that the file states. \since 1.1 */
    uint32_t kinds; /**< sum of NURBS_READ_ constants, 0 for all of them; others are left out without a note.
                            \since 1.1 */
    uint32_t reserved; /**< 0 */
} nurbs_read_options;

/** \brief Fills an options struct with the defaults.
 * \param[out] options the struct.
 * \param[in] struct_size sizeof(nurbs_read_options).
 * \return NURBS_OK, NURBS_ERROR_NULL, _OPTIONS.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_read_options_init(nurbs_read_options *options, int64_t struct_size);

/** \brief Reads the curves and surfaces of an IGES or a STEP file.
 *
 * The first line of the file says which of the two it is. However the entities of a file name each other,
 * memory stays below 64 times the size of the file and 1 MB more.
 *
 * **IGES 5.x** (fixed-length ASCII form): entities 126 (rational B-spline curve) and 128 (rational B-spline
 * surface) become splines, in the order of the directory. Transformation matrices (124), parameter ranges (as
 * far as they lie inside the knots), delimiters, unit and model scale are respected. Curves used in the
 * parameter plane of a surface have dimension 2 and are not scaled to `unit`; everything else has
 * dimension 3. An entity whose weights are all equal becomes a polynomial spline, whatever its flags say. An
 * axis becomes periodic if the entity says so and its knots and points wrap, or are closed bit for bit: a
 * clamped axis with equal first and last layers becomes a wrapped one, with the same knots and points in its
 * domain, and the seam as a knot of multiplicity `degree`. Every other entity that did not become part of a
 * spline, and every 126 or 128 that is not a valid spline, is listed in the notes.
 *
 * Since 1.1, the following entities become splines, too, exactly but for rounding. They come after those
 * above, in the same order: circular and conic arcs (100, 104), composite curves (102), polygons (106, forms
 * 11, 12, 13 and 63), lines (110), parametric spline curves and surfaces (112, 114), ruled surfaces (118),
 * surfaces of revolution (120), tabulated cylinders (122), spheres (196), tori (198), and planes with a
 * boundary (108), cut to the boundary and 1/64 of its size more.
 *
 * - The entities of which composite curves and these surfaces consist are not listed again, except 126
 *   and 128.
 * - The ends of domains are the parameters of IGES, with angles in radians. For hyperbolas and parabolas they
 *   are those of ISO 10303-42 (negated where the curve runs against these), and for a tabulated cylinder
 *   those of its directrix. The first parameter of a surface of revolution is the angle, the second that
 *   along the generatrix.
 * - The curves of a composite curve are joined where they are no farther apart than the resolution that the
 *   file states (1e-6 of the size where it states none). Otherwise there is a note, and the curves are
 *   listed. Pieces of 112 and 114 are joined where they are no farther apart than that resolution or 1e-9 of
 *   the size, and keep other gaps.
 * - A matrix counts as a combination of rotation, reflection and one scale if it is that to 1e-9. With
 *   others, arcs become the splines of their images, and spheres, tori and surfaces of revolution become
 *   notes.
 * - Rulings join points of equal parameters of the two splines. Where the file asks for others (of equal arc
 *   length, or equal angles of an arc and parameters of something else), there is a note with
 *   NURBS_ERROR_UNSUPPORTED beside the spline.
 * - Offset surfaces (140) and offset curves (130), at one distance along V x T, are treated as those of STEP;
 *   the curves are those between TT1 and TT2 if one of these is not 0.
 * - Unbounded surfaces and lines, offset curves at a distance that changes, and trimmed faces are listed in
 *   the notes.
 *
 * **STEP** (ISO 10303-21: AP203, AP214, AP242; since 1.1): the list has the surface of each face, the curve
 * of each edge from its start to its end, and the curves and surfaces of which nothing else is made, each of
 * the three in the order of instance numbers. Lines, conics, polylines, trimmed and composite curves, planes,
 * cylinders, cones, spheres, tori, surfaces of revolution and of linear extrusion, trimmed surfaces, and
 * Bezier and B-spline curves and surfaces in all their forms become splines exactly, but for rounding. The
 * ends of their domains are the parameters of ISO 10303-42, with angles in radians. Unbounded surfaces are
 * cut to the boundary of their face and 1/64 of its size more. Replicas are images of what they repeat, at
 * equal parameters. Lengths are in the unit of the first context that states one; what belongs to other
 * contexts is converted, and lengths in contexts that state none count as in that unit, with a note. Parts
 * stay where they are modelled: their placements in assemblies, curves in parameter planes, and the trimming
 * of faces are not read. Whatever else shapes contain is listed in the notes.
 *
 * **Offsets in STEP.** An offset surface is a known surface where the surface that it is offset from is one.
 * Other offset surfaces are approximated, within a quarter of the uncertainty or as near as the size of the
 * file allows. A note with the reason NURBS_ERROR_TOLERANCE gives the distance that is proven, and the
 * uncertainty if the distance is above it. Those without a normal at some place are not read. An offset of an
 * offset surface goes along the normal S_u x S_v of the latter. Beyond one of the two centres of curvature,
 * this normal lies on the other side of the surface; where that changes on the surface, the offset is not
 * read.
 *
 * The same holds for offset curves, C + d V x T / |V x T| with the unit tangent T and the reference direction
 * V, and to the left of curves of the plane. The offsets of lines, and of circles around V, are again lines
 * and circles. Others need a tangent that is not along V. A note reports those that run against their basis
 * behind a cusp, where the radius of curvature of the basis is the distance. What is offset from another
 * approximation is not read.
 * \param[in] bytes [size] the contents of the file.
 * \param[in] size number of bytes.
 * \param[in] options or NULL for the defaults: settings.
 * \param[out] out the new list.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OPTIONS, _TOO_LARGE, _FORMAT, _TRUNCATED, _SYNTAX.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_read(const void *bytes, int64_t size, const nurbs_read_options *options,
                                  nurbs_list **out);

/** \brief nurbs_read() with progress reports, cancellation and a limit of work.
 * \param[in] bytes,size,options as for nurbs_read().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new list.
 * \return as for nurbs_read(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_read_with(const void *bytes, int64_t size, const nurbs_read_options *options,
                                       const nurbs_call_options *call, nurbs_list **out);

/** \brief Reads a file by its path; see nurbs_read().
 * \param[in] path file name, zero-terminated, in the system's encoding.
 * \param[in] options or NULL for the defaults: settings.
 * \param[out] out the new list.
 * \return as for nurbs_read(), and NURBS_ERROR_FILE.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_read_file(const char *path, const nurbs_read_options *options, nurbs_list **out);

/** \brief nurbs_read_file() with progress reports, cancellation and a limit of work.
 * \param[in] path,options as for nurbs_read_file().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new list.
 * \return as for nurbs_read_file(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_read_file_with(const char *path, const nurbs_read_options *options,
                                            const nurbs_call_options *call, nurbs_list **out);

/** \brief A list of given splines.
 * \param[in] count number of splines, >= 0.
 * \param[in] splines [count] handles, which stay the caller's.
 * \param[in] names [count] or NULL for "0", "1", ...: their names, zero-terminated, in any encoding.
 * \param[in] metres metres per unit of length, 0 if that is not known.
 * \param[out] out the new list.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW; _FACTOR if metres is negative or not finite.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_list_create(int64_t count, const nurbs *const *splines, const char *const *names,
                                         double metres, nurbs_list **out);

/** \brief Number of splines in a list.
 * \param[in] list a list.
 * \param[out] count the number.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_list_count(const nurbs_list *list, int64_t *count);

/** \brief A new handle on spline `index`, which outlives the list.
 * \param[in] list a list.
 * \param[in] index 0-based.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_list_get(const nurbs_list *list, int64_t index, nurbs **out);

/** \brief The name of spline `index`.
 *
 * In lists from files it is that of the file (IGES: name property, else label and subscript; STEP: name of
 * the face, edge, curve or surface, in UTF-8). Where the file has none, it is "type#line" such as "126#17",
 * in STEP the instance such as "#17". In other lists it is the name that the description of the function that
 * made the list states. At most cap - 1 bytes and a terminating zero are written.
 * \param[in] list a list.
 * \param[in] index 0-based.
 * \param[out] buf [cap] or NULL when cap is 0: receives the text.
 * \param[in] cap size of buf in bytes.
 * \param[out] length or NULL: length of the whole name without the terminating zero.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _COUNT.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_list_name(const nurbs_list *list, int64_t index, char *buf, int64_t cap,
                                       int64_t *length);

/** \brief Number of notes: entities of the file that did not become a spline, or only approximately.
 * \param[in] list a list.
 * \param[out] count the number.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_list_note_count(const nurbs_list *list, int64_t *count);

/** \brief A note: which entity, where, and why it did not become a spline.
 * \param[in] list a list.
 * \param[in] index 0-based.
 * \param[out] entity_type or NULL: type number of the entity in the file's format, 0 if that has none.
 * \param[out] line or NULL: sequence number of the entity in the directory section; of STEP, the number of
 *   the instance.
 * \param[out] reason or NULL: NURBS_ERROR_UNSUPPORTED for an entity that is not read, otherwise what is wrong
 *   with it.
 * \param[out] buf [cap] or NULL when cap is 0: receives the text.
 * \param[in] cap size of buf in bytes.
 * \param[out] length or NULL: length of the whole text without the terminating zero.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _COUNT.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_list_note(const nurbs_list *list, int64_t index, int32_t *entity_type,
                                       int64_t *line, nurbs_status *reason, char *buf, int64_t cap,
                                       int64_t *length);

/** \brief The unit of length of the splines in a list.
 * \param[in] list a list.
 * \param[out] metres metres per unit, model scale included; 0 if the file names a unit that is not known, and
 *   in lists that are neither from files nor from nurbs_list_create(). An IGES file without any unit is in
 *   inches, as the standard has it; for a STEP file without one, 0.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.0 */
NURBS_API nurbs_status nurbs_list_unit(const nurbs_list *list, double *metres);

/** \brief Frees a list.
 *
 * Handles taken from it stay valid.
 * \param[in] list or NULL, which does nothing: a list.
 * \since 1.0 */
NURBS_API void nurbs_list_destroy(nurbs_list *list);
/** @} */

/** \defgroup bytes Handles as bytes
 * \code
 * int64_t length = 0;
 * unsigned char bytes[1024]; // cap = 0 asks how many are needed
 * nurbs *again = NULL;
 * nurbs_to_bytes(surface, sizeof bytes, bytes, &length);
 * nurbs_from_bytes(bytes, length, &again); // the same spline, bit for bit, on any machine
 * nurbs_destroy(again);
 * \endcode
 * Splines, lists, faces, models and statistics (nurbs_statistics_to_bytes()) as bytes, to be kept, sent or
 * shared. The same values have the same bytes on every machine, so that a hash of the bytes is a hash of the
 * contents. Bytes are read with one copy, and checked as creation checks its arguments. Any change of up to
 * 64 consecutive bits is found, and any truncation. The page "The form of bytes" of the manual has the layout
 * with examples: NumPy's view of control points in place, and a spline that is cut out of a list.
 *
 * **The form.** All numbers have their lowest byte first; doubles are those of IEEE 754. Each part begins at
 * a multiple of 64 bytes, with zeros before it, so that programs that know the layout can look at numbers in
 * place.
 *
 *     byte  bytes
 *     0     8      89 4e 55 52 0d 0a 1a 0a (hexadecimal), which show what text mode does to files
 *     8     2, 2   version of the form: major, minor
 *     12    4      kind: one of the NURBS_BYTES_ constants
 *     16    8      number of all bytes
 *     24    8      CRC-64 of bytes 0-23 and all from 32 on: that of ECMA-182, bits reflected, as in xz
 *     32    8 * 4  integers of the kind, 0 where there are none
 *     64           the body
 *
 * **A spline.** Integers: axes, dim, form (0 polynomial, 1 points and weights, 2 homogeneous points).
 *
 *     64    16     for each axis: number of control points C (8), degree p (4), 1 if periodic, else 0 (4)
 *     112   8      where the points begin
 *     120   8      where the weights begin, 0 if there are none
 *     128          the knots of all axes, C + p + 1 doubles for each
 *                  the points, [N][dim] doubles, or [N][dim + 1] homogeneous ones, last axis fastest
 *                  the weights, [N] doubles
 *
 * **A list.** Its integers have 8 bytes.
 *
 *     64    4 * 8  numbers of places n, of different splines m, of notes k, and of bytes of text
 *     96    8      metres per unit, a double, 0 if not known
 *     128          n integers: which of the m splines is at each place
 *                  3 k integers: type, line and reason of each note
 *                  n + k integers: where each text ends, counted from the beginning of the texts
 *                  the texts: the names, then the words of the notes
 *                  m integers: where each spline begins, counted from the beginning of the list
 *                  the splines, each with a header of its own, so that it can be cut out and read alone
 *
 * **Statistics.** Integers: axes, dim, and the exponents of the scales of values and of weights, which are
 * powers of two.
 *
 *     64           numbers of cells with data c, and of sums of a cell s (8 each)
 *                  for each axis: its degree (8), the number of its breaks (8)
 *                  the breaks of all axes, doubles
 *                  c integers: the cells, rising; c integers: how many data are in each
 *                  c s sums of 24 bytes, integers in two's complement
 *
 * **Faces and models** hold the splines of which they consist as lists do, each once; that page has their
 * layouts.
 *
 * **Versions.** A library reads all minor versions of its own major version and of earlier ones. Later minor
 * versions only add parts after all parts that are known.
 * @{ */

/** \name Kinds of handles
 * Results of nurbs_bytes_kind(). \since 1.1
 * @{ */
/** \brief a spline: nurbs_from_bytes() */
#define NURBS_BYTES_SPLINE 1
/** \brief a list: nurbs_list_from_bytes() */
#define NURBS_BYTES_LIST 2
/** \brief statistics: nurbs_statistics_from_bytes() */
#define NURBS_BYTES_STATISTICS 3
/** \brief a face: nurbs_face_from_bytes() */
#define NURBS_BYTES_FACE 4
/** \brief a model: nurbs_model_from_bytes() */
#define NURBS_BYTES_MODEL 5
/** @} */

/** \brief A spline as bytes.
 *
 * They are 64 bytes and 16 for each axis, 8 for each knot, coordinate and weight, and what brings each part
 * to a multiple of 64.
 * \param[in] g a spline.
 * \param[in] cap size of bytes: 0, or at least the number of bytes.
 * \param[out] bytes [cap] or NULL: receives the bytes.
 * \param[out] length or NULL: number of bytes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_to_bytes(const nurbs *g, int64_t cap, void *bytes, int64_t *length);

/** \brief The spline of the bytes of nurbs_to_bytes().
 *
 * It has the same stored values, bit for bit, and the same periodic axes.
 * \param[in] bytes [size] the bytes.
 * \param[in] size number of bytes.
 * \param[out] out the new handle.
 * \return as for nurbs_create(), and NURBS_ERROR_FORMAT for bytes that are not a handle, or one of another
 *   kind, _TRUNCATED, _VERSION, _CHECKSUM, _SYNTAX.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_from_bytes(const void *bytes, int64_t size, nurbs **out);

/** \brief A list as bytes, with names, notes and unit.
 *
 * Splines whose bytes are the same are stored once.
 * \param[in] list a list.
 * \param[in] cap size of bytes: 0, or at least the number of bytes.
 * \param[out] bytes [cap] or NULL: receives the bytes.
 * \param[out] length or NULL: number of bytes.
 * \return as for nurbs_to_bytes(); for a list whose parts are made when they are taken, also what
 *   nurbs_list_get() returns for them.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_list_to_bytes(const nurbs_list *list, int64_t cap, void *bytes, int64_t *length);

/** \brief The list of the bytes of nurbs_list_to_bytes().
 * \param[in] bytes [size] the bytes.
 * \param[in] size number of bytes.
 * \param[out] out the new list.
 * \return as for nurbs_from_bytes(), and NURBS_ERROR_FACTOR for a unit that is negative or not finite.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_list_from_bytes(const void *bytes, int64_t size, nurbs_list **out);

/** \brief A face as bytes.
 *
 * They hold its surface, loops, edges, keys, tolerance, and what was proven of curves that were made.
 * \param[in] face a face.
 * \param[in] cap size of bytes: 0, or at least the number of bytes.
 * \param[out] bytes [cap] or NULL: receives the bytes.
 * \param[out] length or NULL: number of bytes.
 * \return as for nurbs_to_bytes().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_to_bytes(const nurbs_face *face, int64_t cap, void *bytes, int64_t *length);

/** \brief The face of the bytes of nurbs_face_to_bytes().
 *
 * It gives the same results, bit for bit, on the same machine. It is made of its loops as it was the first
 * time: they are checked, and distances that were proven are proven again.
 * \param[in] bytes [size] the bytes.
 * \param[in] size number of bytes.
 * \param[out] out the new face.
 * \return as for nurbs_from_bytes() and nurbs_face_create().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_from_bytes(const void *bytes, int64_t size, nurbs_face **out);

/** \brief A model as bytes, with everything that it holds.
 *
 * That is faces, edges, vertices, parts and their uses, names, colours, solids, layers, kinds of curves and
 * surfaces, and the splines, notes and unit of nurbs_model_splines(). Splines whose bytes are the same are
 * stored once, so that faces of one surface share it again.
 * \param[in] model a model.
 * \param[in] cap size of bytes: 0, or at least the number of bytes.
 * \param[out] bytes [cap] or NULL: receives the bytes.
 * \param[out] length or NULL: number of bytes.
 * \return as for nurbs_to_bytes().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_to_bytes(const nurbs_model *model, int64_t cap, void *bytes,
                                            int64_t *length);

/** \brief The model of the bytes of nurbs_model_to_bytes().
 *
 * Its faces are made as nurbs_face_from_bytes() makes them.
 * \param[in] bytes [size] the bytes.
 * \param[in] size number of bytes.
 * \param[out] out the new model.
 * \return as for nurbs_face_from_bytes(), and NURBS_ERROR_FACTOR for a unit that is negative or not finite;
 *   _DIRECTION, _LENGTH, _ANGLE, _EMPTY_DOMAIN for the numbers of a known curve or surface that belong to
 *   none.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_from_bytes(const void *bytes, int64_t size, nurbs_model **out);

/** \brief The kind of handle that bytes hold, and the version of their form.
 *
 * These are read from the first 64 bytes, and nothing else is examined: the bytes may be of a later version,
 * or damaged.
 * \param[in] bytes [size] the bytes, or the first ones.
 * \param[in] size number of bytes, >= 64.
 * \param[out] kind or NULL: one of the NURBS_BYTES_ constants, or another number for a kind of a later
 *   library.
 * \param[out] major or NULL: major version of the form.
 * \param[out] minor or NULL: minor version.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _FORMAT, _TRUNCATED, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_bytes_kind(const void *bytes, int64_t size, int32_t *kind, int32_t *major,
                                        int32_t *minor);
/** @} */

/** \defgroup model Models
 * \code
 * nurbs_model *model = NULL;
 * int64_t faces = 0;
 * if (nurbs_read_model_file("part.step", NULL, &model) == NURBS_OK) {
 *     nurbs_model_counts(model, NULL, NULL, &faces, NULL, NULL);
 *     for (int64_t i = 0; i < faces; ++i) {
 *         nurbs_face *face = NULL;
 *         double area = 0;
 *         nurbs_model_face(model, i, NULL, NULL, NULL, NULL, &face);
 *         nurbs_face_area(face, 1e-6, &area, NULL);
 *         nurbs_face_destroy(face);
 *     }
 * }
 * nurbs_model_destroy(model);
 * \endcode
 * A model holds faces with the edges that they share, the vertices at which edges meet, and the parts to
 * which faces and edges belong. A part has coordinates of its own. A use places a part in the whole or in
 * another part, as often as a file says; no geometry is copied. An instance of a part is one chain of uses
 * from the whole to it (nurbs_model_instances()). A model made of faces alone has one part and one use of it.
 *
 * In models from files the key of an edge in nurbs_face_edge() is its index in the model + 1.
 * nurbs_model_splines() returns the curves and surfaces of a file that are part of no face or edge, with the
 * notes on what was not read. Models are immutable and reference counted, as splines are, and any number of
 * threads may use one at once.
 * @{ */

/** \brief Reads the faces, edges and vertices of a STEP or an IGES file.
 *
 * The first line of the file says which of the two it is. Planes, cylinders, cones, spheres, tori, surfaces
 * of revolution and of extrusion become splines exactly, and keep their kind. Offset surfaces become what
 * nurbs_read() makes of them; those that it approximates have the kind NURBS_SHAPE_OFFSET. Unbounded surfaces
 * are cut to the boundary of their face. A face has the tolerance that the file states, 1e-7 if it states
 * none, or one larger by powers of ten where its edges need that, which a note reports. What is wrong with a
 * face or an edge becomes a note and does not affect the others. However the entities name each other, memory
 * stays below 64 times the size of the file and 1 MB more, and parts are not multiplied; a use that would put
 * a part into itself is left out, and its note has the reason NURBS_ERROR_CYCLE.
 *
 * STEP (ISO 10303-21; AP203, AP214, AP242): the curve of an edge in space takes precedence. Curves in the
 * domain of a spline surface are taken from the file where they lie under their edges; all others are made
 * (nurbs_face_create()). The stated tolerance is the uncertainty of the context. Faces of oriented shells in
 * solids (BREP_WITH_VOIDS) are turned as those shells say, and keep their solid; layers are those of
 * PRESENTATION_LAYER_ASSIGNMENTs.
 *
 * IGES 5.x (fixed-length ASCII form): faces are trimmed surfaces (entity 144), bounded surfaces (143), faces
 * (510) of shells (514) and solids (186), and surfaces that are part of nothing else: these over their whole
 * domain, a plane (108) within its curve. Where a boundary (142, 141) has curves both in space and in the
 * domain, those that the file prefers take precedence, without a preference those in space; the others are
 * used where they belong to them. If a face cannot be made that way, the other curves take precedence, and
 * loops that are open are closed by segments in the domain; a note reports either. Loops are turned as by
 * nurbs_face_create(). Faces share the edges and vertices of lists (504, 502); other edges belong to one face
 * only, and meet each other in vertices of their own. The stated tolerance is the resolution of the file. The
 * first part holds what no subfigure (308) lists, directly or in groups (402). Subfigures are parts, which
 * their instances (408) place with translation, scale and matrix (124). A solid with instances (430), an
 * entity in several subfigures, and a face, shell or solid with a matrix are parts of their own. The colour
 * of a face (314 or one of the eight that have numbers) is its own, or that of its shell or solid. So is its
 * level, a number or a list of them (406 form 1), which is a layer. Curves that are part of nothing else are
 * in nurbs_model_splines().
 * \param[in] bytes [size] the contents of the file.
 * \param[in] size number of bytes.
 * \param[in] options or NULL for the defaults: settings.
 * \param[out] out the new model.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OPTIONS, _TOO_LARGE, _FORMAT, _TRUNCATED, _SYNTAX.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_read_model(const void *bytes, int64_t size, const nurbs_read_options *options,
                                        nurbs_model **out);

/** \brief nurbs_read_model() with progress reports, cancellation and a limit of work.
 * \param[in] bytes,size,options as for nurbs_read_model().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new model.
 * \return as for nurbs_read_model(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_read_model_with(const void *bytes, int64_t size,
                                             const nurbs_read_options *options,
                                             const nurbs_call_options *call, nurbs_model **out);

/** \brief Reads a model from a file by its path; see nurbs_read_model().
 * \param[in] path file name, zero-terminated, in the system's encoding.
 * \param[in] options or NULL for the defaults: settings.
 * \param[out] out the new model.
 * \return as for nurbs_read_model(), and NURBS_ERROR_FILE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_read_model_file(const char *path, const nurbs_read_options *options,
                                             nurbs_model **out);

/** \brief nurbs_read_model_file() with progress reports, cancellation and a limit of work.
 * \param[in] path,options as for nurbs_read_model_file().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new model.
 * \return as for nurbs_read_model_file(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_read_model_file_with(const char *path, const nurbs_read_options *options,
                                                  const nurbs_call_options *call, nurbs_model **out);

/** \brief A model made of faces, with one part and one use of it.
 *
 * Faces with a common key share an edge, that of the first of them, if their edges are no farther from each
 * other than the sum of the tolerances of both faces. Otherwise each has an edge of its own, which a note of
 * nurbs_model_splines() reports. So faces of several models, whose keys may be equal by chance, can be put
 * together. Edges are numbered in the order in which they occur; curves of loops without a key get edges of
 * their own. Vertices are the ends of edges; ends that are equal bit for bit are one vertex.
 * \param[in] count number of faces.
 * \param[in] faces [count] faces of surfaces of dimension 3.
 * \param[in] metres metres per unit of length, >= 0; 0 leaves it open.
 * \param[out] out the new model.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _DIMENSION, _FACTOR, _NOT_CONVERGED,
 *   _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_create(int64_t count, const nurbs_face *const *faces, double metres,
                                          nurbs_model **out);

/** \brief A model sewn from patches without topology: boundaries that coincide become common edges.
 *
 * The model has one part and one use of it. Pieces of boundaries that lie along each other are common edges,
 * so that nurbs_mesh_model() makes a mesh without gaps. A whole surface is sewn as the face without loops
 * that nurbs_face_create() makes of it.
 *
 * **When two pieces are one edge.** The boundary of a face is what its surface makes of the curves of its
 * loops; edges in space that it was given are disregarded. Ends of these curves that are no farther from each
 * other than the tolerance are one vertex. Where a vertex is within the tolerance of a curve that does not
 * end there, the curve is cut if a common edge begins or ends there, as where two sides meet a longer one.
 * Pieces between the same vertices are one edge if each is proven to lie within the tolerance of the other,
 * and so are their ends. Distances are measured at equal parameters, else at those of nearest points, else as
 * the two-sided Hausdorff distance. If the distance of two curves is below the tolerance by less than a
 * thousandth of it, this may stay undecided; then they are not one edge. What a surface makes of a curve can
 * be proven only where nurbs_face_edge() composes it; where it is a curve through places, the largest error
 * seen between these counts instead, and nurbs_model_edge_gaps() tells that the gap is not proven. There is
 * no limit to the number of faces at an edge. Where not all pieces are within the tolerance of each other,
 * the one that most others are near gathers these others, and of several such pieces the one whose middle has
 * the least coordinates, so that the order of the faces does not change any count.
 *
 * **Nothing is moved.** The curve of an edge is one of the pieces: that of the first face, where there are
 * two. How far the others are from it is in nurbs_face_deviation(), and in nurbs_model_edge_gaps(), together
 * with the number of uses, which tells free edges from common ones. Curves of edges are clamped; those along
 * a parameter have the degree of the surface along it.
 *
 * **Surfaces that close.** For a face that is the whole of its surface, boundaries are judged at the
 * tolerance of sewing: those that meet are no edges (a seam), and those no larger than the tolerance are
 * poles, unless the whole surface is so thin that two of its sides would meet all along. In other faces two
 * curves of one loop may be one edge. Pieces of curves within the tolerance of a point are left out of loops,
 * unless these consist of nothing else, and their ends become one vertex. A closed curve has a vertex where
 * it begins.
 *
 * Faces keep their order and their surfaces, and their names are their numbers. The tolerance of a face
 * becomes as large as the distances of its curves from the edges, as a thousandth of the tolerance, and as
 * the face needs to close up as it does. Faces that are connected by edges with two uses are seen from the
 * side of the first one of them: those that are oriented against it have `against` in nurbs_model_face().
 * nurbs_model_volume() computes what closed ones enclose.
 *
 * Costs: some nearest points and one comparison of curves for each edge; for n sides that end at the same two
 * vertices n^2 comparisons.
 * \param[in] count number of faces, at least 1.
 * \param[in] faces [count] faces of surfaces of dimension 3, no two of them the same in surface and curves.
 * \param[in] tolerance the largest distance in space that counts as zero, > 0 and finite.
 * \param[in] metres metres per unit of length, >= 0; 0 leaves it open.
 * \param[out] out the new model.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _DIMENSION, _TOLERANCE, _FACTOR, _NOT_CONVERGED,
 *   _NOT_REPRESENTABLE; _SAME naming two faces that are the same; _ORIENTATION, _GAP or _OUTSIDE_DOMAIN
 *   naming a face of which nothing is left at the tolerance.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_sew(int64_t count, const nurbs_face *const *faces, double tolerance,
                                       double metres, nurbs_model **out);

/** \brief nurbs_model_sew() with progress reports, cancellation and a limit of work.
 * \param[in] count,faces,tolerance,metres as for nurbs_model_sew().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new model.
 * \return as for nurbs_model_sew(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_sew_with(int64_t count, const nurbs_face *const *faces, double tolerance,
                                            double metres, const nurbs_call_options *call, nurbs_model **out);

/** \brief Another handle on the same model, in constant time.
 * \param[in] model a model.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_clone(const nurbs_model *model, nurbs_model **out);

/** \brief Frees a handle on a model. Handles taken from it stay valid.
 * \param[in] model or NULL, which does nothing: a model.
 * \since 1.1 */
NURBS_API void nurbs_model_destroy(nurbs_model *model);

/** \brief The numbers of parts, uses, faces, edges and vertices of a model.
 * \param[in] model a model.
 * \param[out] parts or NULL: number of parts.
 * \param[out] uses or NULL: number of uses of parts.
 * \param[out] faces or NULL: number of faces.
 * \param[out] edges or NULL: number of edges.
 * \param[out] vertices or NULL: number of vertices.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_counts(const nurbs_model *model, int64_t *parts, int64_t *uses,
                                          int64_t *faces, int64_t *edges, int64_t *vertices);

/** \brief A face of a model, with its part, kind, orientation and colour.
 * \param[in] model a model.
 * \param[in] index 0-based.
 * \param[out] part or NULL: the part that it belongs to.
 * \param[out] shape or NULL: the kind of its surface, one of the NURBS_SHAPE_ constants; NURBS_SHAPE_NONE for
 *   a spline.
 * \param[out] against or NULL: 1 if the outer normal is opposite to the normal S_u x S_v of the surface, else
 *   0.
 * \param[out] colour [3] or NULL: red, green and blue from 0 to 1, NaN where the file gives none.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_face(const nurbs_model *model, int64_t index, int64_t *part,
                                        int32_t *shape, int32_t *against, double *colour, nurbs_face **out);

/** \brief The name of a face.
 *
 * It is from the file (STEP: name of the face; IGES: name property, else label and subscript), else the
 * number of its entity, such as "#18" in STEP and "144#17" in IGES. In other models it is the index of the
 * face.
 * \param[in] model a model.
 * \param[in] index 0-based.
 * \param[out] buf [cap] or NULL when cap is 0: receives the text.
 * \param[in] cap size of buf in bytes.
 * \param[out] length or NULL: length of the whole name without the terminating zero.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _COUNT.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_face_name(const nurbs_model *model, int64_t index, char *buf, int64_t cap,
                                             int64_t *length);

/** \brief The solid that a face bounds.
 *
 * Outer normals of its faces (nurbs_model_face()) point out of the material, also those of the faces of its
 * voids, so that the integral of x . n / 3 over all of them is its volume.
 * \param[in] model a model.
 * \param[in] index 0-based, of the face.
 * \param[out] solid or NULL: the number of the solid, from 0 in the order of the first faces; -1 if the file
 *   has the face in none, and in models made of faces.
 * \param[out] in_void or NULL: 1 if the face belongs to a void of the solid, else 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_face_solid(const nurbs_model *model, int64_t index, int64_t *solid,
                                              int32_t *in_void);

/** \brief The layers that a face is in.
 *
 * In STEP these are the layers of the face itself and of each shell, solid or representation that it is a
 * part of; in IGES those of the face, else of its shell or solid.
 * \param[in] model a model.
 * \param[in] index 0-based, of the face.
 * \param[in] cap length of layers, 0 to ask for it.
 * \param[out] layers [cap] or NULL when cap is 0: indices of layers for nurbs_model_layer(), rising.
 * \param[out] count or NULL: the number of layers.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _COUNT, _SIZE, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_face_layers(const nurbs_model *model, int64_t index, int64_t cap,
                                               int64_t *layers, int64_t *count);

/** \brief An edge of a model, with its part, end vertices and kind.
 * \param[in] model a model.
 * \param[in] index 0-based.
 * \param[out] part or NULL: the part that it belongs to.
 * \param[out] end_vertices [2] or NULL: the vertices where its curve begins and ends; -1 for none.
 * \param[out] shape or NULL: the kind of its curve, one of the NURBS_SHAPE_ constants; NURBS_SHAPE_NONE for a
 *   spline.
 * \param[out] out the new handle on its curve.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_edge(const nurbs_model *model, int64_t index, int64_t *part,
                                        int64_t *end_vertices, int32_t *shape, nurbs **out);

/** \brief Where faces use an edge: once at a free boundary, twice inside a shell.
 * \param[in] model a model.
 * \param[in] index 0-based, of the edge.
 * \param[in] cap number of rows of places, 0 to ask for it.
 * \param[out] places [cap][3] or NULL when cap is 0: face, loop, and place in the loop.
 * \param[out] count or NULL: the number of uses.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _COUNT, _SIZE, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_edge_uses(const nurbs_model *model, int64_t index, int64_t cap,
                                             int64_t *places, int64_t *count);

/** \brief How well faces meet at the edges of a model: the number of uses and the largest gap of each edge.
 *
 * An edge with one use is where a face ends. The gap is the largest distance of the edge from the curves of
 * faces, as their surfaces map them, as nurbs_face_deviation() finds it.
 * \param[in] model a model.
 * \param[in] cap length of the arrays, 0 to ask for the number of edges.
 * \param[out] uses [cap] or NULL: number of uses of each edge.
 * \param[out] gaps [cap] or NULL: distances; 0 for an edge that no face uses.
 * \param[out] bounded [cap] or NULL: 1 if the distance is a proven bound, 0 if it is the largest one seen.
 * \param[out] count or NULL: the number of edges.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _SIZE, _OVERLAP, _NOT_CONVERGED, _NOT_REPRESENTABLE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_edge_gaps(const nurbs_model *model, int64_t cap, int64_t *uses,
                                             double *gaps, int32_t *bounded, int64_t *count);

/** \brief The point of a vertex, in the coordinates of its part.
 * \param[in] model a model.
 * \param[in] index 0-based.
 * \param[out] point [3].
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_vertex(const nurbs_model *model, int64_t index, double *point);

/** \brief The name of a part.
 * \param[in] model a model.
 * \param[in] index 0-based.
 * \param[out] buf [cap] or NULL when cap is 0: receives the text.
 * \param[in] cap size of buf in bytes.
 * \param[out] length or NULL: length of the whole name without the terminating zero.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _COUNT.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_part(const nurbs_model *model, int64_t index, char *buf, int64_t cap,
                                        int64_t *length);

/** \brief A use of a part: where it is placed.
 * \param[in] model a model.
 * \param[in] index 0-based.
 * \param[out] parent or NULL: the part in which it is placed; -1: the whole.
 * \param[out] part or NULL: the part that is placed.
 * \param[out] placement [3][4] or NULL: a point x of the part is at M x + t, rows of (M | t).
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_use(const nurbs_model *model, int64_t index, int64_t *parent,
                                       int64_t *part, double *placement);

/** \brief Where the parts of a model stand in the whole: each chain of uses from the whole to a part.
 *
 * The order is depth first: each instance comes before those in it, and those in one instance are in the
 * order of their uses.
 * \param[in] model a model.
 * \param[in] cap length of the outputs: 0, or at least the number of instances.
 * \param[out] parents [cap] or NULL: the instance in which it stands; -1: the whole.
 * \param[out] last_uses [cap] or NULL: the last use of the chain.
 * \param[out] own_parts [cap] or NULL: the part of that use.
 * \param[out] placements [cap][12] or NULL: a point x of the part is at M x + t in the whole, the three rows
 *   of (M | t).
 * \param[out] count or NULL: the number of instances.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _SIZE, _OVERLAP; _TOO_LARGE if there are more than 2^20.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_instances(const nurbs_model *model, int64_t cap, int64_t *parents,
                                             int64_t *last_uses, int64_t *own_parts, double *placements,
                                             int64_t *count);

/** \brief The first hits of rays x = origin + t direction, t >= 0, with the faces of a model.
 *
 * Faces of all parts count where they stand in the whole (nurbs_model_instances()). Hits are those of
 * nurbs_face_rays(); its rounding, and that of placements, is in the proofs. A ray that passes an edge within
 * twice the largest tolerance among its face and the faces that share edges with that face touches the face
 * there, unless a hit follows within four times that distance: so no ray slips through between two neighbours
 * and is reported as certified. The first call builds a tree of the boxes of all faces, which is kept.
 * \param[in] model a model.
 * \param[in] n number of rays.
 * \param[in] origins [n][3] the origins of the rays.
 * \param[in] directions [n][3] their directions, of any length but 0.
 * \param[out] params [n][2] or NULL: parameters of the surface; NaN where there is neither a hit nor a touch.
 * \param[out] distances [n] or NULL: t, in units of the length of the direction; NaN where params are.
 * \param[out] status [n] or NULL: sums of NURBS_RAY_ bits; NURBS_RAY_BACK: from the side to which the outer
 *   normal of the face (nurbs_model_face()) does not point.
 * \param[out] places [n][2] or NULL: the face, and the instance of its part; -1 where params are NaN.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _OVERLAP; _POINT_NOT_FINITE if an origin is not
 *   finite, _DIRECTION if a direction is not finite or 0, _MATRIX if a part is placed so that rounding hides
 *   one of its dimensions, _NOT_REPRESENTABLE if a curve in space that bounds a face overflows, _TOO_LARGE as
 *   for nurbs_model_instances().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_rays(const nurbs_model *model, int64_t n, const double *origins,
                                        const double *directions, double *params, double *distances,
                                        int32_t *status, int64_t *places);

/** \brief nurbs_model_rays() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work, rays that were not examined have no status bits.
 * \param[in] model,n,origins,directions as for nurbs_model_rays().
 * \param[out] params,distances,status,places as for nurbs_model_rays().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_model_rays(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_rays_with(const nurbs_model *model, int64_t n, const double *origins,
                                             const double *directions, double *params, double *distances,
                                             int32_t *status, int64_t *places,
                                             const nurbs_call_options *call);

/** \brief All places where a ray meets the faces of a model, in the order of rising t.
 *
 * They are found as nurbs_model_rays() finds the first one. A place on an edge is one of each of its faces.
 * \param[in] model a model.
 * \param[in] origin [3] the origin of the ray.
 * \param[in] direction [3] its direction, of any length but 0.
 * \param[in] range [2] or NULL for {0, INFINITY}: lower and upper end of the t that count, infinite ones
 *   allowed.
 * \param[in] cap length of the outputs: 0, or at least the number of places.
 * \param[out] params [cap][2] or NULL: parameters of the surface.
 * \param[out] distances [cap] or NULL: t, in units of the length of the direction.
 * \param[out] kinds [cap] or NULL: NURBS_RAY_HIT, to which NURBS_RAY_BACK may be added, or NURBS_RAY_TOUCH.
 * \param[out] places [cap][2] or NULL: the face, and the instance of its part.
 * \param[out] count or NULL: number of places.
 * \param[out] complete or NULL: 1 if there are no others and none of them is a touch, else 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _OVERLAP, _POINT_NOT_FINITE, _DIRECTION, _MATRIX,
 *   _NOT_REPRESENTABLE, _TOO_LARGE as for nurbs_model_rays(); _EMPTY_DOMAIN if range[0] > range[1] or one is
 *   NaN, _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_ray_hits(const nurbs_model *model, const double *origin,
                                            const double *direction, const double *range, int64_t cap,
                                            double *params, double *distances, int32_t *kinds,
                                            int64_t *places, int64_t *count, int32_t *complete);

/** \brief nurbs_model_ray_hits() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work the answer is not complete.
 * \param[in] model,origin,direction,range,cap as for nurbs_model_ray_hits().
 * \param[out] params,distances,kinds,places,count,complete as for nurbs_model_ray_hits().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_model_ray_hits(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_ray_hits_with(const nurbs_model *model, const double *origin,
                                                 const double *direction, const double *range, int64_t cap,
                                                 double *params, double *distances, int32_t *kinds,
                                                 int64_t *places, int64_t *count, int32_t *complete,
                                                 const nurbs_call_options *call);

/** \name Sides of a model
 * @{ */
#define NURBS_SIDE_INSIDE 1     /**< inside a solid, for certain */
#define NURBS_SIDE_ON 0         /**< no farther from a face than the tolerance */
#define NURBS_SIDE_OUTSIDE (-1) /**< outside all solids, for certain */
#define NURBS_SIDE_UNDECIDED 2  /**< not known */
/** @} */

/** \brief Whether points are inside the solids of a closed model.
 *
 * A ray from a point inside a solid leaves it once more than it enters it. Up to 16 directions are tried, one
 * after the other, until the hits on all faces are proven, none of them is near an edge, where faces may
 * leave a gap as wide as their tolerances and nurbs_face_deviation() say, and none is at the point itself.
 * Where nurbs_face_deviation() proves nothing, the gap is taken to be as wide as boxes around small parts of
 * the curves allow, mostly about a hundredth of the size of the face: points nearer to an edge are undecided.
 * Solids are those that the file states, in each instance of their part, with their voids; the faces of an
 * instance that bound none of them are taken to bound one together. A point in several of them is inside.
 * \param[in] model a model.
 * \param[in] n number of points.
 * \param[in] points [n][3], finite.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] tolerance the distance from a face up to which a point is on it, >= 0. With 0 no point is on a
 *   face, and points that lie on one to rounding are undecided. Points as near as the tolerance to a surface
 *   are undecided, too, if their distance from the face (nurbs_face_closest_points()) is not certified.
 * \param[out] sides [n] NURBS_SIDE_ constants.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _TOLERANCE, _POINT_NOT_FINITE,
 *   _MATRIX, _NOT_REPRESENTABLE, _TOO_LARGE as for nurbs_model_rays(), _NOT_CONVERGED as for
 *   nurbs_face_deviation(); _GAP if the model is not closed: an edge is used an odd number of times by the
 *   faces of a solid, a face ends without an edge or has a gap in a loop, or its surface has an interior knot
 *   of a multiplicity above its degree.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_classify(const nurbs_model *model, int64_t n, const double *points,
                                            int64_t point_stride, int64_t point_component_stride,
                                            double tolerance, int32_t *sides);

/** \brief nurbs_model_classify() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work, points that were not examined are undecided.
 * \param[in] model,n,points,point_stride,point_component_stride,tolerance as for nurbs_model_classify().
 * \param[out] sides as for nurbs_model_classify().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_model_classify(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_classify_with(const nurbs_model *model, int64_t n, const double *points,
                                                 int64_t point_stride, int64_t point_component_stride,
                                                 double tolerance, int32_t *sides,
                                                 const nurbs_call_options *call);

/** \brief The points of a model that are nearest to given points.
 *
 * Faces of all parts count where they stand in the whole (nurbs_model_instances()). Each face is searched as
 * by nurbs_face_closest_points(), the nearest boxes first, so that few faces are searched. A face whose
 * placement changes ratios of distances is searched in the whole.
 * \param[in] model a model.
 * \param[in] n number of points.
 * \param[in] points [n][3], finite, in the whole.
 * \param[in] point_stride,point_component_stride layout of points, 0 = packed.
 * \param[in] tolerance how much nearer another point may be, >= 0.
 * \param[out] params [n][2] or NULL: parameters of the surface; NaN if the model has no faces.
 * \param[out] feet [n][3] or NULL: the nearest points, in the whole; NaN if there are no faces.
 * \param[out] distances [n] or NULL: distances in the whole; infinite if there are no faces.
 * \param[out] status [n] or NULL: NURBS_CLOSEST_ bits, as of nurbs_face_closest_points().
 * \param[out] places [n][2] or NULL: the face, and the instance of its part; -1 if there are no faces.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _STRIDE, _OVERLAP, _TOLERANCE, _POINT_NOT_FINITE,
 *   _NOT_CONVERGED; _MATRIX, _NOT_REPRESENTABLE, _TOO_LARGE as for nurbs_model_rays().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_closest_points(const nurbs_model *model, int64_t n, const double *points,
                                                  int64_t point_stride, int64_t point_component_stride,
                                                  double tolerance, double *params, double *feet,
                                                  double *distances, int32_t *status, int64_t *places);

/** \brief nurbs_model_closest_points() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work, points are not certified.
 * \param[in] model,n,points,point_stride,point_component_stride,tolerance as for
 *   nurbs_model_closest_points().
 * \param[out] params,feet,distances,status,places as for nurbs_model_closest_points().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_model_closest_points(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_closest_points_with(const nurbs_model *model, int64_t n,
                                                       const double *points, int64_t point_stride,
                                                       int64_t point_component_stride, double tolerance,
                                                       double *params, double *feet, double *distances,
                                                       int32_t *status, int64_t *places,
                                                       const nurbs_call_options *call);

/** \brief Where planes cut the faces of a model, with the curves joined to ways over shared edges.
 *
 * The planes may have any directions; faces are cut where they stand in the whole (nurbs_model_instances()).
 * On each face branches and nodes are those of nurbs_surface_sections(), trimmed as by nurbs_meet_trim();
 * curves in space are in the whole. A branch has the outer normals of its face (nurbs_model_face()) on its
 * right, as seen from the tip of the normal of its plane: around material it runs counterclockwise, and
 * around a hole in it clockwise, so that the signed areas enclosed add up to that of the section. Faces that
 * bound no solid are oriented like the first one of those that are connected by edges. In the parameter
 * domain normal . S > offset is on the left of branches, as nurbs_meet_branch() says, or on their right where
 * branches are turned for the orientation above.
 *
 * Where a branch ends on an edge that two faces of one solid share, or two faces that bound none, the next
 * branch is found by the order of the ends along the edge and by its direction; at a corner of faces, or at a
 * pole, it is found if exactly one branch ends there and one begins. Both ends are nodes EDGE with their
 * distance (nurbs_meet_joints()). This distance is no more than twice what the tolerances of the faces and
 * the given one allow, divided by the sine of the angle, of at least 1/256, between edge and plane. An end on
 * a shared edge without a next branch is a node UNDECIDED, which leaves its way open. So do nodes TOUCH,
 * where a face is tangent to the plane and more than two branches meet, or where branches end before a pole
 * that the plane goes through, and nodes BORDER, where no other face continues: at edges of one use, or of
 * more than two. Nothing is joined merely because it is near. A shared edge that lies in a plane is a branch
 * of those of its faces that are below the plane beside it, as if the plane stood a little lower; what passes
 * through a corner within the tolerance is left out. A face that lies in the plane is a node TOUCH.
 *
 * Costs: those of nurbs_surface_sections() for faces whose boxes a plane cuts; parallel planes with equal
 * normals share preparations.
 * \param[in] model a model.
 * \param[in] n number of planes normal . x = offset.
 * \param[in] normals [n][3] the normals of the planes, of any length but 0.
 * \param[in] offsets [n] the offsets; the signed distance of a plane from 0 is offset / |normal|.
 * \param[in] tolerance > 0: the largest distance of the curves from the section, in the whole. Where
 *   placements move parts, it holds for planes that the rounding of these motions may have moved, too.
 * \param[out] out the new meet; its levels are the planes, and nurbs_meet_faces() returns the faces of
 *   branches.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _TOLERANCE, _NOT_REPRESENTABLE; _DIRECTION if a
 *   normal is not finite or 0, _POINT_NOT_FINITE if an offset is not finite, _MATRIX if a placement cannot be
 *   inverted, _TOO_LARGE if there are too many instances.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_sections(const nurbs_model *model, int64_t n, const double *normals,
                                            const double *offsets, double tolerance, nurbs_meet **out);

/** \brief nurbs_model_sections() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work, what was not examined is undecided.
 * \param[in] model,n,normals,offsets,tolerance as for nurbs_model_sections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_model_sections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_sections_with(const nurbs_model *model, int64_t n, const double *normals,
                                                 const double *offsets, double tolerance,
                                                 const nurbs_call_options *call, nurbs_meet **out);

/** \brief Where the faces of two models meet, with the curves joined to ways over shared edges.
 *
 * These are the curves of a union, a difference or an intersection. Faces meet where they stand in the whole
 * (nurbs_model_instances()). On each pair of faces whose boxes have common points, found in a tree of boxes,
 * branches and nodes are those of nurbs_face_intersections() for faces that share no edge. Regions in which
 * faces coincide have levels of their own throughout, from 1; their branches run around them as in the domain
 * of the face of a, and edges run with its loops. A curve in which a face meets a neighbour of a face that it
 * has such a region with is left out where it runs along the border of the region from end to end: models
 * that stand on each other have only the region in common. Curves in space are in the whole. Branches run
 * along n_b x n_a with the outer normals n of the faces (nurbs_model_face()): on a face of a, seen from
 * outside, the material of b is on their right, and on one of b, that of a is on their left. Faces that bound
 * no solid are oriented like the first one of those that are connected by edges.
 *
 * Where a branch ends on an edge that two faces of one solid share, or two faces that bound none, the next
 * branch is on the other face with the same face of the other model or, where edges of both models cross,
 * with the other face of that edge. Both ends are nodes EDGE with their distance (nurbs_meet_joints()). This
 * distance is no more than twice what the tolerances of the faces and the given one allow, divided by the
 * sine of the angle, of at least 1/256, between edge and surface. An end on a shared edge without a next
 * branch is a node UNDECIDED; at edges of one use, or of more than two, it is a node BORDER. Nothing is
 * joined merely because it is near. A curve that runs along borders of both faces from end to end, and at
 * one end at least continues in nothing, is an edge that both models have: a branch EDGE for each pair of the
 * faces beside it, which ends in a node BORDER where it continues in nothing.
 *
 * Costs: those of nurbs_surface_intersections() for pairs of faces that come near, each restricted to a
 * little more than the face.
 * \param[in] a,b models; both may be the same.
 * \param[in] tolerance > 0: the largest distance of the curves from the common points, in the whole.
 * \param[out] out the new meet; all of it except overlaps has level 0. nurbs_meet_faces() and
 *   nurbs_meet_joints() return the faces of a, nurbs_meet_faces_second() and nurbs_meet_joints_second() those
 *   of b.
 * \return NURBS_OK, NURBS_ERROR_NULL, _TOLERANCE, _NOT_REPRESENTABLE; _MATRIX if a placement cannot be
 *   inverted, _TOO_LARGE if there are too many instances.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_intersections(const nurbs_model *a, const nurbs_model *b, double tolerance,
                                                 nurbs_meet **out);

/** \brief nurbs_model_intersections() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work, what was not examined is undecided.
 * \param[in] a,b,tolerance as for nurbs_model_intersections().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new meet.
 * \return as for nurbs_model_intersections(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_intersections_with(const nurbs_model *a, const nurbs_model *b,
                                                      double tolerance, const nurbs_call_options *call,
                                                      nurbs_meet **out);

/** \brief The area of all faces of a model where they stand in the whole (nurbs_model_instances()).
 * \param[in] model a model.
 * \param[in] relative_tolerance as for nurbs_face_area(), of the faces of each part together.
 * \param[out] area the area; 0 if there are no faces.
 * \param[out] error or NULL: estimate of the error.
 * \return as for nurbs_face_area(), and NURBS_ERROR_MATRIX, _TOO_LARGE as for nurbs_model_rays().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_area(const nurbs_model *model, double relative_tolerance, double *area,
                                        double *error);

/** \brief nurbs_model_area() with progress reports, cancellation and a limit of work.
 * \param[in] model,relative_tolerance as for nurbs_model_area().
 * \param[out] area,error as for nurbs_model_area().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_model_area(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_area_with(const nurbs_model *model, double relative_tolerance,
                                             double *area, double *error, const nurbs_call_options *call);

/** \brief Volume, centroid and inertia of the solids of a closed model.
 *
 * They are those of the solids where these stand in the whole (nurbs_model_instances()), by the divergence
 * theorem over their trimmed faces, as nurbs_enclosed_volume() computes them for whole surfaces. Solids are
 * those that the file states, with voids subtracted, as the outer normals of their faces say
 * (nurbs_model_face()). The faces of a part that bound none of them are taken to bound one together, and
 * those of them that are connected by edges are oriented like the first of them: shells of a hollow body have
 * to begin with faces whose normals all point out of the material, or all into it. A solid that is turned
 * inside out, or mirrored by its placement, has the volume that it encloses, too; solids that overlap count
 * each.
 *
 * Gaps that faces leave within their tolerances, or beyond (nurbs_face_deviation()), are neither in the
 * volume nor in the error. The vector area of a solid, the integral of its outer normal, is 0 if its faces
 * fit together: it shows such gaps, and outer normals that point inwards.
 * \param[in] model a model.
 * \param[in] relative_tolerance as for nurbs_face_area(), of each solid.
 * \param[out] volume >= 0.
 * \param[out] centroid [3] or NULL.
 * \param[out] inertia [3][3] or NULL: about the centroid, as for nurbs_moments().
 * \param[out] openness or NULL: sum of the lengths of the vector areas of all solids.
 * \param[out] error or NULL: estimate of the error of volume.
 * \return as for nurbs_face_area(); NURBS_ERROR_GAP if the model is not closed, as for
 *   nurbs_model_classify(), _LENGTH if the volume is 0 and centroid or inertia are wanted, _TOO_LARGE if
 *   there are too many instances.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_volume(const nurbs_model *model, double relative_tolerance, double *volume,
                                          double *centroid, double *inertia, double *openness, double *error);

/** \brief nurbs_model_volume() with progress reports, cancellation and a limit of work.
 * \param[in] model,relative_tolerance as for nurbs_model_volume().
 * \param[out] volume,centroid,inertia,openness,error as for nurbs_model_volume().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_model_volume(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_volume_with(const nurbs_model *model, double relative_tolerance,
                                               double *volume, double *centroid, double *inertia,
                                               double *openness, double *error,
                                               const nurbs_call_options *call);

/** \brief The curves and surfaces of a file that are part of no face or edge, as a list.
 *
 * The list also has the unit of length of the file and the notes on all that was not read.
 * \param[in] model a model.
 * \param[out] out the new list.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_splines(const nurbs_model *model, nurbs_list **out);

/** \brief The layers that one of the splines of nurbs_model_splines() is in.
 * \param[in] model a model.
 * \param[in] index 0-based, of the spline.
 * \param[in] cap length of layers, 0 to ask for it.
 * \param[out] layers [cap] or NULL when cap is 0: indices of layers for nurbs_model_layer(), rising.
 * \param[out] count or NULL: the number of layers.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _COUNT, _SIZE, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_spline_layers(const nurbs_model *model, int64_t index, int64_t cap,
                                                 int64_t *layers, int64_t *count);

/** \brief The number of layers that faces and splines of a model are in.
 * \param[in] model a model.
 * \param[out] count number of layers.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_layer_count(const nurbs_model *model, int64_t *count);

/** \brief The name of a layer.
 *
 * In STEP it is that of a PRESENTATION_LAYER_ASSIGNMENT; those of equal names are one layer. In IGES it is
 * the number of a level, such as "3", or what a property (406 form 3) says that the level is for.
 * \param[in] model a model.
 * \param[in] index 0-based.
 * \param[out] buf [cap] or NULL when cap is 0: receives the text.
 * \param[in] cap size of buf in bytes.
 * \param[out] length or NULL: length of the whole name without the terminating zero.
 * \return NURBS_OK, NURBS_ERROR_NULL, _INDEX, _COUNT.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_layer(const nurbs_model *model, int64_t index, char *buf, int64_t cap,
                                         int64_t *length);
/** @} */

/** \defgroup regions Regions, and parts of faces
 * \code
 * nurbs *outline = NULL, *hole = NULL;
 * nurbs_model *plate = NULL, *disk = NULL, *rest = NULL;
 * nurbs_face *a = NULL, *b = NULL;
 * nurbs_curve_circle(2, NULL, NULL, NULL, 2.0, NURBS_ARC_QUARTERS, &outline);
 * nurbs_curve_circle(2, NULL, NULL, NULL, 1.0, NURBS_ARC_QUARTERS, &hole);
 * const nurbs *curves[] = {outline, hole};
 * nurbs_region_create(2, curves, NURBS_FILL_EVEN_ODD, 0, &plate);     // one face with a hole
 * nurbs_region_create(1, &curves[1], NURBS_FILL_EVEN_ODD, 0, &disk);
 * nurbs_model_face(plate, 0, NULL, NULL, NULL, NULL, &a);
 * nurbs_model_face(disk, 0, NULL, NULL, NULL, NULL, &b);
 * nurbs_region_combine(NURBS_REGION_UNION, 1, (const nurbs_face *const *)&a, 1, (const nurbs_face *const *)&b, 0, &rest);
 * nurbs_face_destroy(a);
 * nurbs_face_destroy(b);
 * nurbs_model_destroy(plate);
 * nurbs_model_destroy(disk);
 * nurbs_model_destroy(rest); // one face, with outline around it
 * nurbs_destroy(outline);
 * nurbs_destroy(hole);
 * \endcode
 * Curves of the plane, or of the domain of a surface, are cut wherever they meet
 * (nurbs_curve_intersections()): they become edges between nodes, and no other curve comes to an edge between
 * its two nodes. Edges that run along each other are one. How often loops go around the places beside an edge
 * is counted along a column of the domain, exactly for the stored curves, as by nurbs_face_classify(). The
 * results are bounded by exact parts of the curves that were given, and by whole ones where nothing meets
 * them.
 *
 * **What is near.** Places that are no farther from each other than the tolerance are one node. Curves that
 * run along each other within it, from a knot or an end of one of them to another, are one edge, that of the
 * first of them. A curve that ends as near as that beside another one, or beside a border, ends on it.
 * Rounding makes 2^-37 of the size of the domain, about 7e-12, count as near in any case, and as much of the
 * largest parameter. At places farther from the curves than a few times that and the tolerance, the result is
 * right. Where that cannot be decided, the call fails with NURBS_ERROR_NOT_CONVERGED and names the place.
 *
 * **Surfaces that close.** Along axes whose ends are one curve in space, faces and curves lie in the plane
 * that copies of the domain cover: curves may cross seams, wind around as often as they like, and begin in
 * any copy. Poles are points, however long they are in the domain: curves come to them and leave them in any
 * direction, the parts on both sides of such a curve are apart there, and no part has an edge along a pole.
 * Before parts are returned, it is checked that they cover as much of the domain as they should; if not, the
 * call fails with NURBS_ERROR_NOT_CONVERGED.
 *
 * A region is a model of faces of one surface; the empty region has none. Each face is in one piece, with one
 * loop around it and one around each hole. No loop passes a place twice, but loops may touch each other in
 * nodes.
 * @{ */

/** \name What is inside of closed curves
 * By the winding number at a place: how often they go around it, counterclockwise less clockwise.
 * @{ */
#define NURBS_FILL_NON_ZERO 1 /**< a winding number other than 0 */
#define NURBS_FILL_EVEN_ODD 2 /**< an odd winding number */
#define NURBS_FILL_POSITIVE 3 /**< a winding number above 0 */
/** @} */

/** \name What is made of two regions
 * @{ */
#define NURBS_REGION_UNION 1        /**< what is in a or in b */
#define NURBS_REGION_INTERSECTION 2 /**< what is in a and in b */
#define NURBS_REGION_DIFFERENCE 3   /**< what is in a and not in b */
#define NURBS_REGION_EITHER 4       /**< what is in a or in b and not in both: the symmetric difference */
/** @} */

/** \brief The region of the plane that closed curves enclose, however they cross, touch or lie in each other.
 *
 * Such curves are outlines of fonts, or paths of cutters. The faces of the region are in the plane z = 0 over
 * a square around all curves, with (u, v) = (x, y).
 *
 * Costs: n log n for n curves, those of the pairs that come near each other, and a column of the plane for
 * each edge.
 * \param[in] count number of curves; 0: the empty region.
 * \param[in] curves [count] curves of dimension 2 with positive weights, one after the other: each begins
 *   where the one before it ends, or begins a new loop if that one came back to where its loop began.
 * \param[in] rule one of the NURBS_FILL_ constants.
 * \param[in] tolerance the largest distance that counts as zero, >= 0.
 * \param[out] out the new model, its unit left open.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERFLOW, _DIMENSION, _TOLERANCE, _WEIGHT_SIGN;
 *   _NOT_REPRESENTABLE also for curves that extend over less than 2^-480 or more than 2^480, whose areas
 *   cannot be computed; _RULE for another rule, _GAP naming a curve that jumps, or does not begin where the
 *   one before it ends, or a loop that does not close, _NOT_CONVERGED where rounding would have to decide.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_region_create(int64_t count, const nurbs *const *curves, int32_t rule,
                                           double tolerance, nurbs_model **out);

/** \brief nurbs_region_create() with progress reports, cancellation and a limit of work.
 * \param[in] count,curves,rule,tolerance as for nurbs_region_create().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new model.
 * \return as for nurbs_region_create(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_region_create_with(int64_t count, const nurbs *const *curves, int32_t rule,
                                                double tolerance, const nurbs_call_options *call,
                                                nurbs_model **out);

/** \brief The union, intersection, difference or symmetric difference of two regions.
 *
 * The faces of each region may overlap: together they are what at least one of them covers. So the union of
 * any number of faces is that of all of them with the empty region. Borders, or parts of borders, that both
 * regions have in common count once, with what lies on their two sides.
 *
 * All faces are of one surface, or of planes that nurbs_region_create() made, over whatever squares. The
 * faces of the result are of the same surface, or of such a plane. Their edges in space are made anew, and
 * their tolerances are at least those of all faces, the one given, and the largest gap of their own loops.
 * \param[in] rule one of the NURBS_REGION_ constants.
 * \param[in] count_a number of faces of a.
 * \param[in] a [count_a] faces of surfaces of dimension 3.
 * \param[in] count_b number of faces of b.
 * \param[in] b [count_b] such faces.
 * \param[in] tolerance the largest distance that counts as zero, >= 0. It counts as no less than the
 *   tolerance of faces in such planes, and than the largest gap between the curves of loops of other faces.
 * \param[out] out the new model, its unit left open.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _DIMENSION, _TOLERANCE, _NOT_REPRESENTABLE; _RULE
 *   for another rule, _INCOMPATIBLE naming a face of another surface, _GAP naming a face whose loops have
 *   larger gaps than its tolerance, _NOT_CONVERGED where rounding would have to decide.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_region_combine(int32_t rule, int64_t count_a, const nurbs_face *const *a,
                                            int64_t count_b, const nurbs_face *const *b, double tolerance,
                                            nurbs_model **out);

/** \brief nurbs_region_combine() with progress reports, cancellation and a limit of work.
 * \param[in] rule,count_a,a,count_b,b,tolerance as for nurbs_region_combine().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new model.
 * \return as for nurbs_region_combine(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_region_combine_with(int32_t rule, int64_t count_a, const nurbs_face *const *a,
                                                 int64_t count_b, const nurbs_face *const *b,
                                                 double tolerance, const nurbs_call_options *call,
                                                 nurbs_model **out);

/** \brief The parts into which curves in the domain of its surface divide a face.
 *
 * The curves are cuts, or the curves where the face meets other shapes. With no curves, the parts are the
 * pieces that the face consists of.
 *
 * Curves may cross the border and each other, run along them, and close. What lies outside the face has no
 * effect, nor has what ends inside it without dividing anything, as far as the same part is on both sides.
 *
 * The parts on both sides of a curve have a common edge in space with a common key, and the ends of this edge
 * are nodes, bit for bit: the result is closed along all of its cuts without being sewn. Curves of loops that
 * are not cut keep the edges in space and keys that they were given; an edge without a key gets one if parts
 * on both sides have it, as along a seam. Edges of others are made (nurbs_face_edge()). New keys are above
 * those of the face.
 * \param[in] face a face of a surface of dimension 3.
 * \param[in] count number of curves.
 * \param[in] curves [count] curves of dimension 2 in the domain of the surface, or in the plane that covers
 *   it, with positive weights.
 * \param[in] tolerance the largest distance in space that counts as zero, >= 0, as far as parameters move
 *   points evenly over the surface. It counts as no less than the largest gap between the curves of the loops
 *   of the face. The tolerance of a part, which says how far its edges may be off it, is at least this one,
 *   that of the face, and the largest gap of its own loops.
 * \param[out] out the new model of the parts, its unit left open.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERFLOW, _DIMENSION, _TOLERANCE, _WEIGHT_SIGN,
 *   _NOT_REPRESENTABLE; _GAP naming a curve that jumps, or if loops have larger gaps than the tolerance of
 *   the face, _NOT_CONVERGED where rounding would have to decide, or if the face is no larger than the
 *   tolerance.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_split(const nurbs_face *face, int64_t count, const nurbs *const *curves,
                                        double tolerance, nurbs_model **out);

/** \brief nurbs_face_split() with progress reports, cancellation and a limit of work.
 * \param[in] face,count,curves,tolerance as for nurbs_face_split().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new model.
 * \return as for nurbs_face_split(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_split_with(const nurbs_face *face, int64_t count,
                                             const nurbs *const *curves, double tolerance,
                                             const nurbs_call_options *call, nurbs_model **out);

/** \name Which side of a surface is kept
 * @{ */
#define NURBS_TRIM_FRONT 1   /**< the side to which its normals N = S_u x S_v point */
#define NURBS_TRIM_BACK (-1) /**< the other side */
/** @} */

/** \brief The parts of a face that lie on one side of a surface.
 *
 * The curves of nurbs_surface_intersections() divide the face into parts, as by nurbs_face_split(), and those
 * on the other side are left out; none is left if the whole face is there. What is kept for both sides
 * together makes up the face.
 *
 * Beside a curve of intersection its direction decides which side a part is on: what lies to its left in the
 * domain of the face is in front. A part that the surface does not come to is in front if P - Q points as N
 * does, to within 8 degrees, where P is a place in the part and Q is the nearest point of the surface
 * (nurbs_closest_points()); Q has to be certified, farther from P than 4 tolerances, and not on the border of
 * the surface, where there is no side. If none of some places in the part tells a side, the call fails. A
 * surface has to divide the face from border to border; one that ends inside the face is refused. Where both
 * only touch, in points or along curves, nothing is divided.
 *
 * Curves that end in a node TOUCH, or in one UNDECIDED no larger than 16 tolerances, are continued by
 * segments in the domain, no farther from the surface than the tolerance at nine places evenly along each: to
 * the pole that is there, else to the middle of the node, or from one curve to the other if there are two. So
 * a face is cut through its poles and those of the surface, and along curves that cross themselves, as where
 * two pipes of one size meet. If it is otherwise undecided how both meet in the face, or if this does not
 * tell where curves continue, the call fails.
 * \param[in] face a face of a surface of dimension 3.
 * \param[in] surface a surface of dimension 3, all of which counts; its own border trims nothing.
 * \param[in] side one of the NURBS_TRIM_ constants.
 * \param[in] tolerance > 0: the largest distance of the new borders from the surface, and what counts as
 *   zero, as for nurbs_face_split().
 * \param[out] out the new model of the parts that are kept, its unit left open.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _TOLERANCE, _NOT_REPRESENTABLE; _RULE for another
 *   side, _INCOMPATIBLE if the surface ends inside the face, or a part lies on both of its sides or beyond
 *   its border, _GAP if loops of the face have larger gaps than its tolerance, _NOT_CONVERGED where it is
 *   undecided how both meet, or rounding would have to decide.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_trim(const nurbs_face *face, const nurbs *surface, int32_t side,
                                       double tolerance, nurbs_model **out);

/** \brief nurbs_face_trim() with progress reports, cancellation and a limit of work.
 * \param[in] face,surface,side,tolerance as for nurbs_face_trim().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new model.
 * \return as for nurbs_face_trim(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_face_trim_with(const nurbs_face *face, const nurbs *surface, int32_t side,
                                            double tolerance, const nurbs_call_options *call,
                                            nurbs_model **out);
/** @} */

/** \defgroup mesh Meshes
 * \code
 * nurbs_mesh_options options;
 * nurbs_mesh *mesh = NULL;
 * int64_t points = 0, triangles = 0;
 * int32_t reached = 0; // 1: proven that nothing is farther than 0.01
 * nurbs_mesh_options_init(&options, sizeof options);
 * options.chord = 0.01;
 * nurbs_mesh_surface(surface, &options, &mesh);
 * nurbs_mesh_bound(mesh, NULL, NULL, &reached);
 * nurbs_mesh_counts(mesh, &points, NULL, &triangles, NULL, NULL, NULL);
 * if (points <= 4096 && triangles <= 8192) {
 *     double xyz[4096][3];
 *     int64_t corners[8192][3];
 *     nurbs_mesh_points(mesh, points, xyz[0], NULL);
 *     nurbs_mesh_triangles(mesh, NURBS_MESH_WELDED, triangles, corners[0], NULL);
 * }
 * nurbs_mesh_destroy(mesh);
 * \endcode
 * Approximations of shapes by segments, triangles and hexahedra, within a distance that is proven.
 * Parameters that divide a curve into parts of equal length are those of nurbs_curve_divide().
 * @{ */

/** \brief A polyline that approximates a curve within a proven distance.
 *
 * The Hausdorff distance of each segment from the part of the curve that it replaces, both ways, is at most
 * `chord`. It is proven by the Bernstein coefficients of the part, since the curve is no farther from the
 * segment than they are (convex hull property), and, where that is smaller, by the second derivatives across
 * the segment, which is exact in the limit of short segments. Rounding is included in the bound.
 *
 * Vertices are at the ends of the domain; where the curve jumps, twice, at the limits from the left and the
 * right; at knots where its direction changes by more than rounding; and in between as few as greedy steps
 * need: for smooth curves a few hundredths more than the least number for the tolerance, for rough ones up to
 * a tenth more. A curve that closes has three segments or more; the last vertex of a periodic one is its
 * first, bit for bit. Other points are those of nurbs_eval(). Powers of two in the unit of length change
 * nothing but sizes.
 *
 * An angle cannot be kept where the curve turns back at a cusp, or where its derivative vanishes, and nothing
 * can be proven where weights pass through 0. There segments become as short as 1e-6 of the size of the
 * curve, or end at neighbouring parameters. A chord below what rounding allows is not reached either. If no
 * limit of work is given there is one of about a second, and more for many control points.
 *
 * Costs: about 0.5 us for each segment of a cubic, and as much for each span.
 * \param[in] g a curve.
 * \param[in] chord > 0: the largest distance; infinite for no limit, if there is another one.
 * \param[in] angle the largest angle between any two tangents of the part of a segment, in radians, at most
 *   pi; 0 for no limit.
 * \param[in] longest the largest length of a segment; 0 for no limit.
 * \param[in] cap length of the arrays: 0, or at least the number of vertices.
 * \param[out] params [cap] or NULL: parameters of the vertices, rising.
 * \param[out] points [cap][dim] or NULL: the vertices.
 * \param[out] bound or NULL: no distance is larger; infinite where none could be proven.
 * \param[out] reached or NULL: 1 if it is proven that all segments keep to the limits, else 0. At the limit
 *   of work it is 0, and the rest of the curve is one segment from each place that has a vertex to the next
 *   one.
 * \param[out] count or NULL: number of vertices.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _COUNT, _OVERLAP; _TOLERANCE if chord is not > 0, or infinite
 *   without another limit, _ANGLE if angle is not from 0 to pi, _LENGTH if longest is not finite or < 0,
 *   _SIZE if cap is neither 0 nor enough; _NOT_REPRESENTABLE if control points of pieces overflow.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_curve(const nurbs *g, double chord, double angle, double longest,
                                        int64_t cap, double *params, double *points, double *bound,
                                        int32_t *reached, int64_t *count);

/** \brief nurbs_mesh_curve() with progress reports, cancellation and a limit of work.
 * \param[in] g,chord,angle,longest,cap as for nurbs_mesh_curve().
 * \param[out] params,points,bound,reached,count as for nurbs_mesh_curve().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_mesh_curve(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_curve_with(const nurbs *g, double chord, double angle, double longest,
                                             int64_t cap, double *params, double *points, double *bound,
                                             int32_t *reached, int64_t *count,
                                             const nurbs_call_options *call);

/** \brief How near a mesh has to be to its shape; fill with nurbs_mesh_options_init() first. NULL stands for
 * the defaults as well. Fields are only ever appended, and struct_size is at most 4096. All limits that are
 * given hold. The extent is the longest side of the box of all control points of all surfaces. \since 1.1 */
typedef struct nurbs_mesh_options {
    int64_t struct_size;   /**< size of this struct as the caller knows it */
    double chord;          /**< largest distance between shape and mesh, both ways, > 0; default INFINITY */
    double relative_chord; /**< the same as a share of the extent, >= 0; 0: no limit; default 1e-3 */
    double longest;        /**< largest length of sides of triangles, >= 0; 0: no limit; default 0 */
    double angle;          /**< of triangles' corner normals, radians, 0 to pi; 0, pi: no limit; default 0 */
    double minimum_angle;  /**< smallest of triangles inside, radians, 0 to pi / 6; 0: no limit; default 0 */
} nurbs_mesh_options;

/** \brief Fills an options struct with the defaults.
 * \param[out] options the struct.
 * \param[in] struct_size sizeof(nurbs_mesh_options).
 * \return NURBS_OK, NURBS_ERROR_NULL, _OPTIONS.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_options_init(nurbs_mesh_options *options, int64_t struct_size);

/** \name Flags of meshes
 * @{ */
/** \brief nurbs_mesh_triangles() and similar functions: corners are points, not vertices. */
#define NURBS_MESH_WELDED 0x01000000u
/** @} */

/** \brief A triangle mesh of a whole surface, within proven distances.
 *
 * A mesh has **points** in space, and **vertices**: each vertex is at a point, and has parameters and a
 * normal of one face. A point has several vertices where faces meet, along seams, at poles, and along lines
 * where the surface may have a crease: knots of full multiplicity. The corners of triangles are vertices, of
 * which normals and parameters can be interpolated, or, welded, points: then two triangles at an edge of the
 * shape have a side in common, and no other triangle has that side. No triangle has the index of a point
 * twice.
 *
 * **Both distances are proven**: no point of the shape is farther from the mesh than `from_shape`, and no
 * point of the triangles is farther from the shape than `from_mesh`. Where the surface is far from its
 * triangle sideways, but over the triangles beside it, it is not far from the mesh. The bounds come from
 * second derivatives, which are bounded over a whole cell of the domain, and from the control points of what
 * these leave; they include what rounding may have done to points and bounds. For small tolerances they are
 * about the least possible; they are infinite where nothing can be proven, as where weights pass through 0.
 *
 * The domain is halved into cells until the two triangles over each keep to the limits, along the axis that
 * needs it more. Cells end where the surface may have a crease or a jump. Vertices are at corners of cells,
 * and cells of different sizes meet without a gap. All points lie on the surface: they are those of
 * nurbs_eval(), bit for bit, at the parameters of one of their vertices, and up to rounding at those of the
 * others; where the surface jumps, from the side of the triangles. Across a jump there is nothing, and
 * neither is there between the steps of an axis of degree 0. A side of the domain that is one point is one
 * point of the mesh (a pole), and opposite sides with equal points (a closed or periodic axis) have the same
 * points of the mesh. Equal means exactly equal here, and equal to the tolerance of the face in
 * nurbs_mesh_face().
 *
 * **The angle** between the normals of the surface at any two corners of a triangle (those of
 * nurbs_mesh_vertices(), from the side of the triangle) is at most `angle`, and so it is at the ends of each
 * side for the triangles on both sides of it, where the surface has no crease. Corners without a normal do
 * not count. In addition, the domain is halved until, by a bound of the second derivatives over a whole cell,
 * the normal turns by no more in it. This is an estimate, not a proof; it finds waves between the corners,
 * and without it nothing counts as reached. No angle below 1e-7 is reached, and none at singular places,
 * where the normal jumps inside a polynomial piece: triangles there become as short as 1e-5 of the size of
 * the surface. In the plane there is no angle to keep.
 *
 * **Small angles** of the triangles themselves, as they are in space: with `minimum_angle`, vertices are
 * added inside and sides are flipped until no triangle has a smaller angle (Delaunay refinement: Chew 1993,
 * Ruppert 1995, Shewchuk 2002). What is given stays: points at the border do not move, and sides at the
 * border are not divided, since they belong to edges. So a triangle does not count if one of its corners is
 * at the border or at a pole, or if the border or sides at a pole come into its circumcircle, at whose centre
 * its new vertex would be; nor do triangles between two sides of the border that meet at a smaller angle. All
 * others have no smaller angle where the mesh is `reached`, and those that do not count are improved where
 * possible. Seams and lines at which there may be a crease are divided, but not crossed. Distances are proven
 * for the final triangles, and come first: if the work is not enough for angles, the distances are those of
 * the mesh without this limit. There are about as many triangles as if squares took the place of long and
 * thin triangles, and few more. The refinement ends at a multiple of that number, which is not enough where
 * lengths of the surface change a lot within a triangle, as where it is crumpled: a smaller `chord` helps.
 * Quads are the cells that are left.
 *
 * Triangles are counterclockwise about the normal S_u x S_v. Powers of two in the unit of length change
 * nothing but sizes, and the same shape has the same mesh on every machine of one kind. If no limit of work
 * is given there is one of about two million triangles of surfaces, fewer where many of them are between
 * edges, and more for many control points.
 *
 * Costs: about two microseconds and 250 bytes for each triangle.
 * \param[in] g a surface of dimension 2 or 3.
 * \param[in] options or NULL for the defaults: limits.
 * \param[out] out the new mesh, of one face and no edges.
 * \return NURBS_OK, NURBS_ERROR_NULL, _AXES, _DIMENSION, _OPTIONS; _TOLERANCE if chord is not > 0, if
 *   relative_chord is not finite or < 0, or if there is no limit at all, _LENGTH if longest is not finite or
 *   < 0, _ANGLE if angle is not from 0 to pi, or minimum_angle not from 0 to pi / 6, _OVERFLOW if there are
 *   2^31 vertices or more.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_surface(const nurbs *g, const nurbs_mesh_options *options,
                                          nurbs_mesh **out);

/** \brief nurbs_mesh_surface() with progress reports, cancellation and a limit of work.
 *
 * What would exceed the limit of work is meshed for larger distances, equally all over. The distances of the
 * mesh are those proven of it, and `reached` is 0.
 * \param[in] g,options as for nurbs_mesh_surface().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new mesh.
 * \return as for nurbs_mesh_surface(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_surface_with(const nurbs *g, const nurbs_mesh_options *options,
                                               const nurbs_call_options *call, nurbs_mesh **out);

/** \brief A triangle mesh of a trimmed face, within proven distances.
 *
 * Inside the face it has the cells of nurbs_mesh_surface(), and between these and the border a constrained
 * Delaunay triangulation. The border consists of polylines of the edges of the face (nurbs_mesh_curve()).
 * Their points lie on the edge, and their sides join places of the curve in the domain; `angle` limits the
 * angle of their tangents as well as that of normals. How far these places are from the edge, which is at
 * most the tolerance of the face, is included in the bounds.
 * \param[in] face a face of a surface of dimension 2 or 3.
 * \param[in] options or NULL for the defaults: limits.
 * \param[out] out the new mesh, of one face. Its edges are those of the model that nurbs_model_create() makes
 *   of this face alone, followed by those that belong to the face only.
 * \return as for nurbs_mesh_surface(); _NOT_REPRESENTABLE if a curve in space that bounds the face overflows.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_face(const nurbs_face *face, const nurbs_mesh_options *options,
                                       nurbs_mesh **out);

/** \brief nurbs_mesh_face() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_mesh_surface_with().
 * \param[in] face,options as for nurbs_mesh_face().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new mesh.
 * \return as for nurbs_mesh_face(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_face_with(const nurbs_face *face, const nurbs_mesh_options *options,
                                            const nurbs_call_options *call, nurbs_mesh **out);

/** \brief A triangle mesh of all faces of a model, within proven distances.
 *
 * Faces are meshed as by nurbs_mesh_face(). Each edge is one polyline, and all faces at it have its points:
 * the mesh of a solid is closed. Faces keep their order, and are in the coordinates of their parts, once for
 * each part and not for each of its uses: nurbs_model_instances() says where they stand in the whole.
 * Triangles are counterclockwise about the normal of the surface even where that points into a solid, which
 * `against` of nurbs_model_face() tells.
 * \param[in] model a model.
 * \param[in] options or NULL for the defaults: limits.
 * \param[out] out the new mesh: faces and edges in the order of the model, followed by edges that belong to
 *   one face only.
 * \return as for nurbs_mesh_face().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_model(const nurbs_model *model, const nurbs_mesh_options *options,
                                        nurbs_mesh **out);

/** \brief nurbs_mesh_model() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_mesh_surface_with().
 * \param[in] model,options as for nurbs_mesh_model().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new mesh.
 * \return as for nurbs_mesh_model(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_model_with(const nurbs_model *model, const nurbs_mesh_options *options,
                                             const nurbs_call_options *call, nurbs_mesh **out);

/** \brief Meshes of a whole surface for several distances, as levels of detail for drawing.
 *
 * Each mesh is the one that nurbs_mesh_surface() makes with `chord` = chords[i] and `relative_chord` = 0, bit
 * for bit, unless it comes to a limit of work. Points of one mesh need not be points of another one. One mesh
 * may stand for two equal distances. On failure all handles are NULL; only with NURBS_ERROR_COUNT nothing is
 * written.
 *
 * Most of the time goes into the proof of every triangle, which no other mesh has, so that several meshes
 * take about as long as separate calls. Halving the distance doubles the number of triangles: four such
 * meshes take twice as long as the finest one.
 * \param[in] g a surface of dimension 2 or 3.
 * \param[in] count number of distances, 0 to 4096.
 * \param[in] chords [count], in any order: the largest distances, each > 0; infinite for no limit, if there
 *   is another one.
 * \param[in] options or NULL for the defaults: all other limits. `chord` and `relative_chord` are ignored.
 * \param[out] out [count]: the new meshes, in the order of chords.
 * \return as for nurbs_mesh_surface(), and NURBS_ERROR_COUNT if count is < 0 or > 4096.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_surface_levels(const nurbs *g, int64_t count, const double *chords,
                                                 const nurbs_mesh_options *options, nurbs_mesh **out);

/** \brief nurbs_mesh_surface_levels() with progress reports, cancellation and a limit of work.
 *
 * A limit of work is one for all meshes together; the coarsest one is made first.
 * \param[in] g,count,chords,options as for nurbs_mesh_surface_levels().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out [count]: the new meshes, in the order of chords.
 * \return as for nurbs_mesh_surface_levels(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_surface_levels_with(const nurbs *g, int64_t count, const double *chords,
                                                      const nurbs_mesh_options *options,
                                                      const nurbs_call_options *call, nurbs_mesh **out);

/** \brief Meshes of a trimmed face for several distances, as nurbs_mesh_surface_levels().
 *
 * Each mesh is one of nurbs_mesh_face().
 * \param[in] face a face of a surface of dimension 2 or 3.
 * \param[in] count,chords,options as for nurbs_mesh_surface_levels().
 * \param[out] out [count]: the new meshes, in the order of chords.
 * \return as for nurbs_mesh_face(), and NURBS_ERROR_COUNT if count is < 0 or > 4096.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_face_levels(const nurbs_face *face, int64_t count, const double *chords,
                                              const nurbs_mesh_options *options, nurbs_mesh **out);

/** \brief nurbs_mesh_face_levels() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_mesh_surface_levels_with().
 * \param[in] face,count,chords,options as for nurbs_mesh_face_levels().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out [count]: the new meshes, in the order of chords.
 * \return as for nurbs_mesh_face_levels(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_face_levels_with(const nurbs_face *face, int64_t count,
                                                   const double *chords, const nurbs_mesh_options *options,
                                                   const nurbs_call_options *call, nurbs_mesh **out);

/** \brief Meshes of all faces of a model for several distances, as nurbs_mesh_surface_levels().
 *
 * Each mesh is one of nurbs_mesh_model(), and that of a solid is closed.
 * \param[in] model a model.
 * \param[in] count,chords,options as for nurbs_mesh_surface_levels().
 * \param[out] out [count]: the new meshes, in the order of chords.
 * \return as for nurbs_mesh_model(), and NURBS_ERROR_COUNT if count is < 0 or > 4096.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_model_levels(const nurbs_model *model, int64_t count, const double *chords,
                                               const nurbs_mesh_options *options, nurbs_mesh **out);

/** \brief nurbs_mesh_model_levels() with progress reports, cancellation and a limit of work.
 *
 * The limit of work is as for nurbs_mesh_surface_levels_with().
 * \param[in] model,count,chords,options as for nurbs_mesh_model_levels().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out [count]: the new meshes, in the order of chords.
 * \return as for nurbs_mesh_model_levels(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_model_levels_with(const nurbs_model *model, int64_t count,
                                                    const double *chords, const nurbs_mesh_options *options,
                                                    const nurbs_call_options *call, nurbs_mesh **out);

/** \brief A mesh of hexahedra of a volume in space, on a grid of lines along its axes.
 *
 * Each hexahedron is the trilinear map between its eight corners. **Distances are proven**: no point of the
 * volume is farther from the point of its hexahedron at the same parameters than `from_shape` of
 * nurbs_mesh_bound(), and so no point of a hexahedron is farther from the volume (`from_mesh` is the same).
 * With h_k the lengths of a hexahedron in the parameters,
 *
 *     |V - trilinear| <= sum_k h_k^2 / 8 max |d^2 V / dt_k^2|,
 *
 * where the maxima are bounded by the control points of each part of a piece; these bounds are about the
 * least possible for small tolerances, and rounding is included. The distance is infinite where weights may
 * pass through 0.
 *
 * Lines are at all knots, and between them evenly spaced in the parameter, on each axis by itself: about as
 * many as make the number of hexahedra least. Points lie on the volume: they are those of nurbs_eval() at
 * their parameters, bit for bit, and neighbours share theirs, so that each side inside belongs to two
 * hexahedra. Where the volume jumps at a knot, each side has points of its own, the limits from there. A
 * periodic axis is closed, and so is one whose two ends have the same control points and weights bit for bit:
 * the last points are the first. Where a side of the volume collapses along an axis, so that its control
 * points are the same bit for bit and their weights in proportion, its points are the same, too: hexahedra
 * there have a corner several times. Control points that are equal only up to rounding do not make points
 * one.
 *
 * nurbs_mesh_points() returns the points, nurbs_mesh_hexahedra() the rest; there are no vertices and no
 * triangles, and one face, which is the whole.
 *
 * Costs: about a microsecond for each hexahedron, and some 10 us for each piece.
 * \param[in] g a volume of dimension 3 whose degrees are at least 1 (nurbs_elevate() raises others).
 * \param[in] options or NULL for the defaults: limits, of which `longest` is that of sides of hexahedra;
 *   `angle` and `minimum_angle` have to be 0.
 * \param[in] limit the most hexahedra, 0 for 2^20. If more were needed, lines are farther apart than asked
 *   for, and `reached` of nurbs_mesh_bound() is 0; but there is at least one hexahedron for each polynomial
 *   piece.
 * \param[out] out the new mesh.
 * \return as for nurbs_mesh_surface(), with _DEGREE for an axis of degree 0, _COUNT if limit is < 0, _ANGLE
 *   if angle or minimum_angle is not 0; _NOT_REPRESENTABLE if the control points of a side overflow.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_volume(const nurbs *g, const nurbs_mesh_options *options, int64_t limit,
                                         nurbs_mesh **out);

/** \brief nurbs_mesh_volume() with progress reports, cancellation and a limit of work.
 *
 * At the limit of work it returns NURBS_ERROR_WORK, unless only the folds of nurbs_mesh_hexahedra() are left,
 * which then stay undecided.
 * \param[in] g,options,limit as for nurbs_mesh_volume().
 * \param[in] call or NULL: limit of work and progress callback.
 * \param[out] out the new mesh.
 * \return as for nurbs_mesh_volume(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_volume_with(const nurbs *g, const nurbs_mesh_options *options,
                                              int64_t limit, const nurbs_call_options *call,
                                              nurbs_mesh **out);

/** \brief Another handle on the same mesh, in constant time.
 * \param[in] mesh a mesh.
 * \param[out] out the new handle.
 * \return NURBS_OK, NURBS_ERROR_NULL.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_clone(const nurbs_mesh *mesh, nurbs_mesh **out);

/** \brief Frees a handle on a mesh.
 * \param[in] mesh or NULL, which does nothing: a mesh.
 * \since 1.1 */
NURBS_API void nurbs_mesh_destroy(nurbs_mesh *mesh);

/** \brief The numbers of points, vertices, triangles, faces and edges of a mesh.
 * \param[in] mesh a mesh.
 * \param[out] points or NULL: number of points.
 * \param[out] vertices or NULL: number of vertices.
 * \param[out] triangles or NULL: number of triangles.
 * \param[out] faces or NULL: number of faces.
 * \param[out] edges or NULL: number of polylines of edges.
 * \param[out] edge_points or NULL: number of vertices of all these polylines together.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_counts(const nurbs_mesh *mesh, int64_t *points, int64_t *vertices,
                                         int64_t *triangles, int64_t *faces, int64_t *edges,
                                         int64_t *edge_points);

/** \brief How far a mesh and its shape are from each other: the largest distances of all faces.
 * \param[in] mesh a mesh.
 * \param[out] from_shape or NULL: no point of the shape is farther from the mesh; INFINITY: nothing is
 *   proven.
 * \param[out] from_mesh or NULL: no point of the mesh is farther from the shape; INFINITY: nothing is proven.
 * \param[out] reached or NULL: 1 if all that was asked for is proven of all faces and edges; else 0.
 * \return NURBS_OK, NURBS_ERROR_NULL, _OVERLAP.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_bound(const nurbs_mesh *mesh, double *from_shape, double *from_mesh,
                                        int32_t *reached);

/** \brief The points of a mesh.
 * \param[in] mesh a mesh.
 * \param[in] cap length of points: 0, or at least the number of points.
 * \param[out] points [cap][3] or NULL: in space; of a surface in the plane z is 0.
 * \param[out] count or NULL: number of points.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_points(const nurbs_mesh *mesh, int64_t cap, double *points, int64_t *count);

/** \brief nurbs_mesh_points() in single precision.
 *
 * Each number is rounded once to the nearest float. Coordinates beyond the range of float become infinities.
 * \param[in] mesh,cap as for nurbs_mesh_points().
 * \param[out] points [cap][3] or NULL: in space.
 * \param[out] count or NULL: number of points.
 * \return as for nurbs_mesh_points().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_points_f32(const nurbs_mesh *mesh, int64_t cap, float *points,
                                             int64_t *count);

/** \brief The vertices of a mesh, face by face.
 * \param[in] mesh a mesh.
 * \param[in] cap length of the outputs: 0, or at least the number of vertices.
 * \param[out] own_points [cap] or NULL: the point at which each vertex is, 0-based.
 * \param[out] params [cap][2] or NULL: parameters of the surface of the face.
 * \param[out] normals [cap][3] or NULL: S_u x S_v, of length 1, from the side of the triangles; NaN where
 *   there is none, as at the tip of a cone.
 * \param[out] count or NULL: number of vertices.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_vertices(const nurbs_mesh *mesh, int64_t cap, int64_t *own_points,
                                           double *params, double *normals, int64_t *count);

/** \brief The vertices of a mesh in single precision, with their points instead of indices, as for drawing.
 *
 * Each number is rounded once to the nearest float.
 * \param[in] mesh,cap as for nurbs_mesh_vertices().
 * \param[out] points [cap][3] or NULL: in space; what is beyond the range of float becomes infinite.
 * \param[out] params [cap][2] or NULL: parameters of the surface of the face.
 * \param[out] normals [cap][3] or NULL: as of nurbs_mesh_vertices().
 * \param[out] count or NULL: number of vertices.
 * \return as for nurbs_mesh_vertices().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_vertices_f32(const nurbs_mesh *mesh, int64_t cap, float *points,
                                               float *params, float *normals, int64_t *count);

/** \brief The triangles of a mesh, face by face.
 * \param[in] mesh a mesh.
 * \param[in] flags NURBS_MESH_WELDED or 0.
 * \param[in] cap length of corners: 0, or at least the number of triangles.
 * \param[out] corners [cap][3] or NULL: vertices, or with NURBS_MESH_WELDED points, 0-based, counterclockwise
 *   about the normal.
 * \param[out] count or NULL: number of triangles.
 * \return NURBS_OK, NURBS_ERROR_NULL, _FLAGS, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_triangles(const nurbs_mesh *mesh, uint32_t flags, int64_t cap,
                                            int64_t *corners, int64_t *count);

/** \brief nurbs_mesh_triangles() with indices of 32 bits.
 * \param[in] mesh,flags,cap as for nurbs_mesh_triangles().
 * \param[out] corners [cap][3] or NULL: as of nurbs_mesh_triangles().
 * \param[out] count or NULL: number of triangles.
 * \return as for nurbs_mesh_triangles().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_triangles_i32(const nurbs_mesh *mesh, uint32_t flags, int64_t cap,
                                                int32_t *corners, int64_t *count);

/** \brief The quads of a mesh: cells of the domain that are divided into exactly two triangles.
 *
 * Such a cell has no vertex of another cell on its sides. The two triangles of a quad are 0, 1, 2 and 0, 2, 3
 * of its corners (each may begin with any of its three), as programs divide quads, and for these the
 * distances of nurbs_mesh_bound() are proven: not for a bilinear patch, nor for the other diagonal. They
 * follow each other in nurbs_mesh_triangles(). All other triangles, between cells of different sizes, at
 * poles and along the border of a trimmed face, stay triangles in a mesh of both.
 * \param[in] mesh a mesh.
 * \param[in] flags NURBS_MESH_WELDED or 0.
 * \param[in] cap length of the outputs: 0, or at least the number of quads.
 * \param[out] corners [cap][4] or NULL: vertices, or with NURBS_MESH_WELDED points, 0-based, counterclockwise
 *   about the normal.
 * \param[out] own_triangles [cap] or NULL: the first triangle of each quad, rising, 0-based; the next one is
 *   the second.
 * \param[out] count or NULL: number of quads.
 * \return NURBS_OK, NURBS_ERROR_NULL, _FLAGS, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_quads(const nurbs_mesh *mesh, uint32_t flags, int64_t cap, int64_t *corners,
                                        int64_t *own_triangles, int64_t *count);

/** \brief Which vertices and triangles of a mesh belong to which face, and how near these are.
 * \param[in] mesh a mesh.
 * \param[in] cap length of the outputs: 0, or at least the number of faces.
 * \param[out] first_vertices [cap] or NULL: the first vertex, 0-based.
 * \param[out] vertex_counts [cap] or NULL: the number of vertices.
 * \param[out] first_triangles [cap] or NULL: the first triangle, 0-based.
 * \param[out] triangle_counts [cap] or NULL: the number of triangles.
 * \param[out] from_shape [cap] or NULL: no point of the face is farther from its triangles; INFINITY: nothing
 *   is proven.
 * \param[out] from_mesh [cap] or NULL: no point of its triangles is farther from the face; INFINITY: nothing
 *   is proven.
 * \param[out] reaches [cap] or NULL: 1 if all that was asked for is proven; else 0.
 * \param[out] count or NULL: number of faces.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_faces(const nurbs_mesh *mesh, int64_t cap, int64_t *first_vertices,
                                        int64_t *vertex_counts, int64_t *first_triangles,
                                        int64_t *triangle_counts, double *from_shape, double *from_mesh,
                                        int32_t *reaches, int64_t *count);

/** \brief The polylines that stand for edges in a mesh.
 * \param[in] mesh a mesh.
 * \param[in] cap length of the outputs: 0, or at least the number of polylines.
 * \param[out] own_edges [cap] or NULL: the edge of the model, 0-based; -1: one that belongs to one face only.
 * \param[out] firsts [cap] or NULL: its first vertex in nurbs_mesh_edge_points(), 0-based.
 * \param[out] sizes [cap] or NULL: the number of its vertices.
 * \param[out] bounds [cap] or NULL: no point of the edge is farther from the polyline, and none of the
 *   polyline from the edge; INFINITY: nothing is proven.
 * \param[out] reaches [cap] or NULL: 1 if all that was asked for is proven; else 0.
 * \param[out] count or NULL: number of polylines.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_edges(const nurbs_mesh *mesh, int64_t cap, int64_t *own_edges,
                                        int64_t *firsts, int64_t *sizes, double *bounds, int32_t *reaches,
                                        int64_t *count);

/** \brief The vertices of the polylines for edges in a mesh, each from the start of its edge to the end.
 * \param[in] mesh a mesh.
 * \param[in] cap length of own_points: 0, or at least their number.
 * \param[out] own_points [cap] or NULL: points of the mesh, 0-based.
 * \param[out] count or NULL: number of vertices of all polylines.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_edge_points(const nurbs_mesh *mesh, int64_t cap, int64_t *own_points,
                                              int64_t *count);

/** \brief The hexahedra of a mesh of nurbs_mesh_volume(), last axis fastest.
 *
 * Corners are in the order of VTK_HEXAHEDRON (cell type 12), with the first axis of the volume as the first
 * one there. By the lower (0) and upper (1) ends of a hexahedron along the axes they are at 000, 100, 110,
 * 010, 001, 101, 111, 011. Where the Jacobian of the volume is positive, that is the order of a hexahedron
 * that is not turned inside out.
 * \param[in] mesh a mesh.
 * \param[in] cap length of the outputs: 0, or at least the number of hexahedra.
 * \param[out] corners [cap][8] or NULL: points of the mesh, 0-based.
 * \param[out] domains [cap][3][2] or NULL: lower and upper end of each hexahedron along each axis of the
 *   volume.
 * \param[out] folds [cap] or NULL: a NURBS_FOLD_ constant: whether the volume folds over this part of its
 *   domain; undecided is what 64 halvings do not decide.
 * \param[out] signs [cap] or NULL: if there is no fold, 1 or -1, the sign that the Jacobian of the volume is
 *   proven to have wherever in this part it is not 0; else 0.
 * \param[out] count or NULL: number of hexahedra.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP; _SIZE if cap is neither 0 nor enough.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_hexahedra(const nurbs_mesh *mesh, int64_t cap, int64_t *corners,
                                            double *domains, int32_t *folds, int32_t *signs, int64_t *count);

/** \brief A spline as Bezier cells, exactly: its polynomial (rational) pieces, which share control points.
 *
 * Cells are the pieces of nurbs_bezier_pieces(), in their order, with their degrees and domains. They name
 * their control points by indices into nurbs_bezier_cell_points().
 *
 * Each cell has its M = (p_0 + 1)(p_1 + 1)... control points in the order of VTK_BEZIER_CURVE, _QUADRILATERAL
 * and _HEXAHEDRON, that of VTK 9 (files of version 2.1 and later), with the axes of g as the axes there: the
 * corners, then the inner points of edges, of sides, and of the cell, each in the order of its parameters,
 * first axis fastest.
 *
 *     corners: as of nurbs_mesh_hexahedra(), the first 2 or 4 of these in cells of fewer axes
 *     edges:   along the axes 0, 1, 0, 1 from corner 0 to 1, 1 to 2, 3 to 2, 0 to 3; the same from 4 to 5,
 *              5 to 6, 7 to 6, 4 to 7; along axis 2 from 0 to 4, 1 to 5, 2 to 6, 3 to 7
 *     sides:   the lower and the upper end of axis 0, of axis 1, of axis 2
 *
 * VTK takes degrees from an array HigherOrderDegrees of cells, unless all degrees of a cell are the same, and
 * weights from an array RationalWeights of points.
 *
 * Control points that neighbours have in common are one, unless g jumps between them. A periodic axis is
 * closed, and so is one whose ends have the same control points and weights bit for bit: the last ones are
 * the first. Sides that collapse keep all of their control points, since weights differ there.
 * \param[in] g a spline whose degrees are at least 1 (nurbs_elevate() raises others).
 * \param[in] cap length of own_points: 0, or at least the number of cells.
 * \param[out] own_points [cap][M] or NULL: control points of each cell, 0-based.
 * \param[out] kind or NULL: the type of such cells in VTK: 75 for a curve, 77 for a surface, 79 for a volume.
 * \param[out] points or NULL: number of control points.
 * \param[out] count or NULL: number of cells.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERFLOW, _OVERLAP; _DEGREE for an axis of degree 0, _SIZE if
 *   cap is neither 0 nor enough; _NOT_REPRESENTABLE, _WEIGHTS_VANISH as for nurbs_insert_knot().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_bezier_cells(const nurbs *g, int64_t cap, int64_t *own_points, int32_t *kind,
                                          int64_t *points, int64_t *count);

/** \brief The control points of nurbs_bezier_cells(), last axis fastest.
 *
 * They are those of nurbs_bezier_pieces(), bit for bit, each once; those of a seam are as the first cell has
 * them.
 * \param[in] g a spline whose degrees are at least 1.
 * \param[in] cap length of the arrays: 0, or at least the number of control points.
 * \param[out] points [cap][dim] or NULL: the control points, packed.
 * \param[out] weights [cap] or NULL: their weights; all 1 for a polynomial spline.
 * \param[out] count or NULL: number of control points.
 * \return as for nurbs_bezier_cells().
 * \since 1.1 */
NURBS_API nurbs_status nurbs_bezier_cell_points(const nurbs *g, int64_t cap, double *points, double *weights,
                                                int64_t *count);
/** @} */

/** \defgroup write Writing files
 * \code
 * nurbs_model *model = NULL;
 * nurbs_write_options options;
 * nurbs_write_options_init(&options, sizeof options);
 * options.unit = 0.0254; // inches, whatever the model has
 * if (nurbs_read_model_file("part.step", NULL, &model) == NURBS_OK) {
 *     nurbs_model_write_file(model, "inches.step", NURBS_FORMAT_STEP, &options);
 * }
 * nurbs_model_destroy(model);
 * \endcode
 * Writes models, lists of splines and meshes as files for other programs. The same model gives the same
 * bytes on every machine, except for the last digits of arcs (100, 104) in IGES, which come from its sine and
 * cosine: files contain no time, no path and no user.
 *
 * **STEP** (ISO 10303-21, AP214). Faces become advanced faces with the edges and vertices that they share, in
 * solids where every edge is used exactly once in each direction, else in shells; voids of a solid that was
 * read stay its own. Edges that no face uses become wires. Splines of a model or a list become geometric
 * sets; curves of dimension 2 have a set of their own, in parameters that have no unit. Surfaces and edges
 * that were elementary in a file are elementary again, all others become B-splines. Parts become products,
 * and their uses assemblies; a use that is a mirror image or a scaling becomes a mapped item. If parts stand
 * in the whole other than each once and unmoved, the whole becomes one more product. Numbers have all digits
 * that they need, so that nurbs_read_model() and nurbs_read() return knots, points and weights bit for bit,
 * and names, colours, layers, kinds, parts, uses, edges and vertices. This does not hold for
 * - lengths in another unit than that of the model;
 * - the mark of a periodic axis, whose knots and points stay (nurbs_detect_periodic());
 * - homogeneous points, which are divided by their weights, and weights that are all equal, which are left
 *   out;
 * - curves in the domains of other surfaces than splines, and those of faces with larger tolerances than the
 *   file that are not under their edges at equal parameters to the tolerance of the file: readers make them
 *   anew;
 * - parametrizations of curves in domains, which become those of their edges;
 * - blanks around names of faces and splines, control characters, which become '?', and empty names, which
 *   become "#" and the number of their entity;
 * - gaps of loops that were kept (NURBS_KEEP_GAPS): the segments that close them become edges.
 *
 * **IGES** (5.3, fixed-length form). Faces (510) with loops (508) share the edges and vertices of one list
 * each (504, 502), in solids (186) with their voids where every edge is used exactly once in each direction,
 * else in open shells (514). Edges that no face uses stand in the list only, which other programs may not
 * show. Splines of a model or a list are entities 126 and 128, in their order, curves of dimension 2 in
 * parameters that have no unit; surfaces of a model come back as faces over their whole domains. Layers are
 * levels: the number of a level is the name of the layer if that is a number above those before, else the
 * next number, which a property (406 form 3) names, if there is a name. Parts become subfigures (308), and
 * their uses instances (408) with matrices (124), of form 1 for mirror images. A first part that stands in
 * the whole once and unmoved is what no subfigure has, and its name is that of the product. A unit that has
 * no number in IGES is written as one that has, with another model space scale. Surfaces and edges that were
 * elementary in a file are so again: planes, cylinders, cones, spheres and tori with a reference direction
 * (190 to 198), surfaces of revolution and tabulated cylinders (120, 122), arcs and ellipses (100, 104),
 * where reading them gives the same splines bit for bit, with all curves in the domains. To know this, what
 * is written is read once before. All others are B-splines (126, 128), with their parameter curves. So
 * nurbs_read_model() and nurbs_read() return what they return of STEP files, and the mark of a periodic axis,
 * too. This does not hold for
 * - lengths in another unit than that of the model, and placements that are rotated and scaled, up to
 *   rounding;
 * - homogeneous points, and weights that are all equal, as for STEP;
 * - the parameters of straight edges (110) that were others than 0 to 1, and of curves that lie under them;
 * - curves in domains that are not under their edges at equal parameters, or that leave the domain by more
 *   than the tolerance of the file: readers make them anew;
 * - tolerances of faces: readers find the least power of ten times that of the file that is enough;
 * - blanks around names and control characters, as for STEP, and empty names, which become type and number:
 *   "510#37";
 * - colours whose percentages have no digits of their own, which become adjacent ones;
 * - faces of NURBS_KEEP_GAPS, as for STEP.
 *
 * Knots inside a domain of a multiplicity above `degree`, knots that are not clamped, and weights of 0 are
 * written as they are. This library reads them; STEP and IGES have no such knots and weights, and some
 * readers of IGES want clamped knots.
 * @{ */

/** \name Formats of files
 * Formats of shapes are for nurbs_model_write() and nurbs_list_write(), those of triangles for
 * nurbs_mesh_write().
 * \since 1.1
 * @{ */
/** \brief STEP: an exchange structure of ISO 10303-21, by AP214 */
#define NURBS_FORMAT_STEP 1
/** \brief IGES 5.3 in lines of 80 columns */
#define NURBS_FORMAT_IGES 2
/** \brief Triangles: binary STL */
#define NURBS_FORMAT_STL 3
/** \brief Triangles: STL as text */
#define NURBS_FORMAT_STL_TEXT 4
/** \brief Triangles: Wavefront OBJ */
#define NURBS_FORMAT_OBJ 5
/** \brief Triangles: PLY, binary, little-endian */
#define NURBS_FORMAT_PLY 6
/** \brief Triangles: glTF 2.0 in one binary file */
#define NURBS_FORMAT_GLB 7
/** \brief Triangles: an unstructured grid of VTK in XML, with raw arrays appended */
#define NURBS_FORMAT_VTU 8
/** @} */

/** \brief Settings for nurbs_model_write() and similar functions; fill with nurbs_write_options_init() first.
 * Fields are only ever appended, and struct_size is at most 4096. Without a tolerance each part of a STEP
 * file gets the least one of its faces that is not 0, since readers enlarge it where edges need that, but no
 * less than 10^-4 of the largest one, and 1e-7 metres if it has none. IGES has one for the whole file, the
 * least of all faces, but no less than 10^-4 of those that are above 1 % of the size of their surfaces:
 * readers find the others. */
typedef struct nurbs_write_options {
    int64_t struct_size; /**< size of this struct as the caller knows it */
    double unit;         /**< unit of the file in metres; 0: that of the model, millimetres if it has none */
    double tolerance;    /**< distance that counts as none, in units of the file; 0: that of the faces */
} nurbs_write_options;

/** \brief Fills an options struct with the defaults.
 * \param[out] options the struct.
 * \param[in] struct_size sizeof(nurbs_write_options).
 * \return NURBS_OK, NURBS_ERROR_NULL, _OPTIONS.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_write_options_init(nurbs_write_options *options, int64_t struct_size);

/** \brief The contents of a file that holds a model.
 *
 * Asking for the number of bytes takes as long as writing them.
 * \param[in] model a model.
 * \param[in] format NURBS_FORMAT_STEP or NURBS_FORMAT_IGES.
 * \param[in] options or NULL for the defaults: settings.
 * \param[in] cap size of bytes: 0, or at least the number of bytes.
 * \param[out] bytes [cap] or NULL: receives the bytes.
 * \param[out] length or NULL: number of bytes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, _OVERLAP, _OPTIONS, _FORMAT for any other format; _SIZE if cap
 *   is neither 0 nor enough. For what the format cannot hold, naming the index: _DIMENSION for splines that
 *   are not in space, except curves of dimension 2, _AXES for volumes, _DEGREE for degree 0, _WEIGHT_SIGN for
 *   homogeneous points whose weights are not positive, _MATRIX for placements that are no similarities.
 *   _NOT_REPRESENTABLE; _TOO_LARGE for an IGES file of more lines than its seven digits can count.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_write(const nurbs_model *model, int32_t format,
                                         const nurbs_write_options *options, int64_t cap, void *bytes,
                                         int64_t *length);

/** \brief nurbs_model_write() with progress reports, cancellation and a limit of work.
 * \param[in] model,format,options,cap as for nurbs_model_write().
 * \param[out] bytes,length as for nurbs_model_write().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_model_write(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_write_with(const nurbs_model *model, int32_t format,
                                              const nurbs_write_options *options, int64_t cap, void *bytes,
                                              int64_t *length, const nurbs_call_options *call);

/** \brief Writes a model to a file.
 *
 * The bytes go to a new file in the same folder, which takes the name once they are on the disk: no other
 * program sees half a file, and a file that had the name is as it was if anything fails. A symbolic link
 * stays, and the file that it leads to is replaced or made; devices and pipes are written to.
 * \param[in] model a model.
 * \param[in] path file name, zero-terminated, in the system's encoding.
 * \param[in] format NURBS_FORMAT_STEP or NURBS_FORMAT_IGES.
 * \param[in] options or NULL for the defaults: settings.
 * \return as for nurbs_model_write() without _COUNT, _OVERLAP, _SIZE, and NURBS_ERROR_FILE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_write_file(const nurbs_model *model, const char *path, int32_t format,
                                              const nurbs_write_options *options);

/** \brief nurbs_model_write_file() with progress reports, cancellation and a limit of work.
 * \param[in] model,path,format,options as for nurbs_model_write_file().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_model_write_file(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_model_write_file_with(const nurbs_model *model, const char *path, int32_t format,
                                                   const nurbs_write_options *options,
                                                   const nurbs_call_options *call);

/** \brief The contents of a file that holds the curves and surfaces of a list.
 *
 * They are written with their names, as nurbs_model_write() writes those that belong to no face.
 * \param[in] list a list.
 * \param[in] format NURBS_FORMAT_STEP or NURBS_FORMAT_IGES.
 * \param[in] options or NULL for the defaults: settings.
 * \param[in] cap size of bytes: 0, or at least the number of bytes.
 * \param[out] bytes [cap] or NULL: receives the bytes.
 * \param[out] length or NULL: number of bytes.
 * \return as for nurbs_model_write() without _MATRIX; for a list whose parts are made when they are taken,
 *   also what nurbs_list_get() returns for them.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_list_write(const nurbs_list *list, int32_t format,
                                        const nurbs_write_options *options, int64_t cap, void *bytes,
                                        int64_t *length);

/** \brief nurbs_list_write() with progress reports, cancellation and a limit of work.
 * \param[in] list,format,options,cap as for nurbs_list_write().
 * \param[out] bytes,length as for nurbs_list_write().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_list_write(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_list_write_with(const nurbs_list *list, int32_t format,
                                             const nurbs_write_options *options, int64_t cap, void *bytes,
                                             int64_t *length, const nurbs_call_options *call);

/** \brief Writes the curves and surfaces of a list to a file, as nurbs_model_write_file() does.
 * \param[in] list a list.
 * \param[in] path file name, zero-terminated, in the system's encoding.
 * \param[in] format NURBS_FORMAT_STEP or NURBS_FORMAT_IGES.
 * \param[in] options or NULL for the defaults: settings.
 * \return as for nurbs_list_write() without _COUNT, _OVERLAP, _SIZE, and NURBS_ERROR_FILE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_list_write_file(const nurbs_list *list, const char *path, int32_t format,
                                             const nurbs_write_options *options);

/** \brief nurbs_list_write_file() with progress reports, cancellation and a limit of work.
 * \param[in] list,path,format,options as for nurbs_list_write_file().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_list_write_file(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_list_write_file_with(const nurbs_list *list, const char *path, int32_t format,
                                                  const nurbs_write_options *options,
                                                  const nurbs_call_options *call);

/** \brief The contents of a file that holds a mesh: its triangles, with what the model says about them.
 *
 * Asking for the number of bytes takes as long as writing them. The bytes are the same on every machine for
 * the same mesh.
 *
 * Parts stand where they are in the whole, once for each of their instances (nurbs_model_instances()).
 * Triangles are counterclockwise as they are **seen from outside**, and normals point to that side. For faces
 * of solids the outside is where nurbs_model_face() says (`against`); where a part has faces of no solid,
 * each shell is oriented like its first face, as in nurbs_model_volume(). If the triangles of a solid, or of
 * all such faces of a part, close up and enclose a negative volume, they are turned, also those of a single
 * surface. A vertex without a normal, such as a pole, gets that of the triangles around it.
 *
 * - **STL**, binary or text: the triangles, in single precision, with their normals. Triangles of which two
 *   corners are one point in single precision are left out: what was closed stays closed. Names and colours
 *   are lost.
 * - **OBJ**: for each instance of a part an object with its name, with the points that its faces share (as
 *   NURBS_MESH_WELDED gives them), and normals for each face; for each face a group with its name. Blanks,
 *   '#', backslashes and what is no text become '_'. Colours are names of materials, "colour_ff8000", which
 *   are not defined.
 * - **PLY**: vertices of faces with their points in double precision, normals, the number of their face
 *   (`face_number`, 0-based), and red, green and blue if any face has a colour.
 * - **GLB**: a node for each use of a part, in the order of nurbs_model_instances(), with names and
 *   placements, below one that turns the z axis upwards, as CAD has it, into the y axis upwards of glTF, and
 *   the unit into metres; a mesh for each part, with a primitive for each colour of its faces. The `extras`
 *   of a primitive tell which triangles stand for which face, and the name of that. Points are in single
 *   precision.
 * - **VTU**: vertices with points and parameters (`params`) in double precision and normals (`normals`);
 *   triangles with the numbers of their face and of its part (`face`, `part`, 0-based), and `colour` if any
 *   face has one.
 *
 * The bytes are written as they are made, without another copy: if memory runs out on the way
 * (NURBS_ERROR_MEMORY), some may have been written.
 * \param[in] mesh a mesh.
 * \param[in] format NURBS_FORMAT_STL, _STL_TEXT, _OBJ, _PLY, _GLB or _VTU.
 * \param[in] options or NULL for the defaults: settings. The tolerance is not used.
 * \param[in] cap size of bytes: 0, or at least the number of bytes.
 * \param[out] bytes [cap] or NULL: receives the bytes.
 * \param[out] length or NULL: number of bytes.
 * \return NURBS_OK, NURBS_ERROR_NULL, _COUNT, also for a mesh that has no triangles, _OVERLAP, _OPTIONS,
 *   _FORMAT for any other format; _SIZE if cap is neither 0 nor enough; _MATRIX for placements without an
 *   inverse, and in GLB for those that are no similarities; _NOT_REPRESENTABLE for coordinates that overflow
 *   in the precision of the file, in GLB also for placements, and in STL if no triangle is left; _TOO_LARGE
 *   where a file would have more than its format can count: 2^32 bytes of GLB, 2^31 vertices of PLY, 2^32
 *   triangles of STL, or a million instances.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_write(const nurbs_mesh *mesh, int32_t format,
                                        const nurbs_write_options *options, int64_t cap, void *bytes,
                                        int64_t *length);

/** \brief nurbs_mesh_write() with progress reports, cancellation and a limit of work.
 * \param[in] mesh,format,options,cap as for nurbs_mesh_write().
 * \param[out] bytes,length as for nurbs_mesh_write().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_mesh_write(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_write_with(const nurbs_mesh *mesh, int32_t format,
                                             const nurbs_write_options *options, int64_t cap, void *bytes,
                                             int64_t *length, const nurbs_call_options *call);

/** \brief Writes a mesh to a file, as nurbs_model_write_file() does.
 *
 * It is written block by block: at no time is all of the file in memory.
 * \param[in] mesh a mesh.
 * \param[in] path file name, zero-terminated, in the system's encoding.
 * \param[in] format NURBS_FORMAT_STL, _STL_TEXT, _OBJ, _PLY, _GLB or _VTU.
 * \param[in] options or NULL for the defaults: settings. The tolerance is not used.
 * \return as for nurbs_mesh_write() without _OVERLAP, _SIZE, and NURBS_ERROR_FILE.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_write_file(const nurbs_mesh *mesh, const char *path, int32_t format,
                                             const nurbs_write_options *options);

/** \brief nurbs_mesh_write_file() with progress reports, cancellation and a limit of work.
 * \param[in] mesh,path,format,options as for nurbs_mesh_write_file().
 * \param[in] call or NULL: limit of work and progress callback.
 * \return as for nurbs_mesh_write_file(), and NURBS_ERROR_OPTIONS, _CANCELLED, _WORK.
 * \since 1.1 */
NURBS_API nurbs_status nurbs_mesh_write_file_with(const nurbs_mesh *mesh, const char *path, int32_t format,
                                                  const nurbs_write_options *options,
                                                  const nurbs_call_options *call);
/** @} */

#ifdef __cplusplus
}
#endif

#endif /* NURBS_NURBS_H */

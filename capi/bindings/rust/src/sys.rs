// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
//! The C interface as it stands: the names, arguments and constants of `nurbs.h`, which is the manual.

#![allow(non_camel_case_types)]

use std::os::raw::{c_char, c_void};

/// A spline: immutable, reference counted, opaque. Never made or moved on this side.
#[repr(C)]
pub struct nurbs {
    _private: [u8; 0],
}

/// Splines in an order: the parts of one, or what a file held, with names, and notes on everything that was
/// not turned into one. Never made or moved on this side.
#[repr(C)]
pub struct nurbs_list {
    _private: [u8; 0],
}

/// What a fit needs to know of data: sums that can be added and subtracted. \since 1.1 Never made or moved on
/// this side.
#[repr(C)]
pub struct nurbs_statistics {
    _private: [u8; 0],
}

/// A trimmed face: immutable, reference counted, opaque. \since 1.1 Never made or moved on this side.
#[repr(C)]
pub struct nurbs_face {
    _private: [u8; 0],
}

/// What a file of faces holds: faces, edges and vertices, in parts that are placed; immutable, reference
/// counted, opaque. \since 1.1 Never made or moved on this side.
#[repr(C)]
pub struct nurbs_model {
    _private: [u8; 0],
}

/// Where a surface meets planes: curves, and the places where they end; immutable, reference counted, opaque.
/// Never made or moved on this side.
#[repr(C)]
pub struct nurbs_meet {
    _private: [u8; 0],
}

/// Triangles in place of shapes; immutable, reference counted, opaque. \since 1.1 Never made or moved on this
/// side.
#[repr(C)]
pub struct nurbs_mesh {
    _private: [u8; 0],
}

/// Result of a call: 0, or one of the NURBS_ERROR_ codes.
pub type nurbs_status = i32;

/// Called with how much of a call is done: an estimate from 0 to 1 that never decreases. A result other than
/// 0 ends the call.
pub type nurbs_progress = Option<unsafe extern "C" fn(done: f64, user: *mut c_void) -> i32>;

/// Limit of work and progress callback of a long call; fill with nurbs_call_options_init() first. Fields are
/// only ever appended, and struct_size is at most 4096.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_call_options {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// largest number of multiply-adds; 0: no limit of the caller
    pub work: i64,
    /// or NULL: called now and then
    pub progress: nurbs_progress,
    /// or NULL: passed to progress
    pub user: *mut c_void,
}

/// Data: values at parameters, with weights. nurbs_data_init() sets all fields to 0 or NULL. Fields are only
/// ever appended. \since 1.1
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_data {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// number of data, \>= 0
    pub n: i64,
    /// number of parameters, 1 to 3
    pub axes: i32,
    /// dimension of the values
    pub dim: i32,
    /// \[n\]\[axes\] the parameters
    pub params: *const f64,
    /// distance between parameters, 0 = packed
    pub param_stride: i64,
    /// distance between components, 0 = 1
    pub param_component_stride: i64,
    /// \[n\]\[dim\] the values
    pub values: *const f64,
    /// distance between values, 0 = packed
    pub value_stride: i64,
    /// distance between components, 0 = 1
    pub value_component_stride: i64,
    /// \[n\] or NULL for 1: weights \>= 0; 0 leaves the value out
    pub weights: *const f64,
    /// distance between weights, 0 = 1
    pub weight_stride: i64,
    /// evaluation flags for params, without NURBS_EXTRAPOLATE; with NURBS_NAN a parameter that is outside or
    /// not finite leaves its value out
    pub flags: u32,
    /// 0
    pub reserved: u32,
}

/// Settings of a fit: smoothing, conditions, robustness and shape. nurbs_fit_options_init() fills in the
/// defaults, which NULL stands for as well. Fields are only ever appended. \since 1.1
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_fit_options {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// a NURBS_SMOOTHING_ constant; default NURBS_SMOOTHING_NONE
    pub smoothing: i32,
    /// m, the order of the derivative that is penalised, \>= 1; default 2
    pub penalty_order: i32,
    /// the factor of the penalty, for NURBS_SMOOTHING_LAMBDA, \>= 0; default 0
    pub lambda: f64,
    /// for NURBS_SMOOTHING_DISCREPANCY: largest sum_i w_i |y_i - s(t_i)|^2, \>= 0; default 0
    pub target: f64,
    /// 1: of several solutions take that of the smallest penalty; 0: refuse them
    pub regularize: i32,
    /// 0
    pub reserved: i32,
    /// number of equations that the fit has to fulfil, \>= 0; default 0
    pub conditions: i64,
    /// \[conditions\]\[axes\] or NULL: parameters, packed
    pub condition_params: *const f64,
    /// \[conditions\]\[axes\] or NULL for 0: orders of derivatives
    pub condition_orders: *const i32,
    /// \[conditions\]\[dim\] or NULL: points and derivatives, packed
    pub condition_targets: *const f64,
    /// a NURBS_ROBUST_ constant; others than NURBS_ROBUST_NONE, the default, are for fits of points over
    /// given knots
    pub robust: i32,
    /// 0
    pub reserved2: i32,
    /// where outliers begin, in standard deviations, \>= 0; 0: the usual width
    pub robust_width: f64,
    /// \[axes\]\[dim\] or NULL: sums of NURBS_TREND_ constants, or 0
    pub shapes: *const i32,
    /// \[dim\] or NULL: lower bounds of coordinates; -INFINITY for none
    pub lower: *const f64,
    /// \[dim\] or NULL: upper bounds of coordinates; INFINITY for none
    pub upper: *const f64,
}

/// What is known of a fit. Set struct_size to sizeof(nurbs_fit_report); all other fields are results. Fields
/// are only ever appended. \since 1.1
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_fit_report {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// receives the number of data that count
    pub data_count: i64,
    /// receives the sum of their weights
    pub weight: f64,
    /// receives sum_i w_i |y_i - s(t_i)|^2
    pub squares: f64,
    /// receives the square root of squares / weight
    pub rms: f64,
    /// receives the factor of the penalty that was taken
    pub lambda: f64,
    /// receives the trace of the influence matrix: effective number of parameters
    pub freedom: f64,
    /// receives the standard deviation of a coordinate of weight 1, from residuals; of robust fits from their
    /// median
    pub sigma: f64,
    /// receives |G x + lambda P x - r| / |r| of the normal equations
    pub residual: f64,
    /// receives the largest |y_i - s(t_i)|; NaN from nurbs_fit()
    pub largest: f64,
    /// receives the index of that datum; -1 from nurbs_fit()
    pub largest_index: i64,
    /// receives a sum of NURBS_FIT_ bits
    pub bits: i32,
    /// receives the number of fits that a robust fit took, else 1
    pub rounds: i32,
    /// receives the number of data with x \> 1 of a robust fit, else 0
    pub outliers: i64,
}

/// Settings of nurbs_fit_cloud(). nurbs_cloud_options_init() fills in the defaults, which NULL stands for as
/// well. Fields are only ever appended. \since 1.1
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_cloud_options {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// m, the order of the derivative that is penalised, \>= 1; default 2
    pub penalty_order: i32,
    /// most searches for the nearest points of all points, \>= 1; default 100
    pub rounds: i32,
    /// the factor of the penalty; below 0: found; default -1
    pub lambda: f64,
    /// the factor at the start, which falls to lambda; below 0: found; default -1
    pub first_lambda: f64,
    /// the smallest relative decrease of the sum worth a step, \>= 0; default 1e-3
    pub tolerance: f64,
}

/// What is known of a fit by nurbs_fit_cloud(). Set struct_size to sizeof(nurbs_cloud_report); all other
/// fields are results. Fields are only ever appended. \since 1.1
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_cloud_report {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// receives the number of points that count: those of a weight above 0
    pub data_count: i64,
    /// receives the sum of their weights
    pub weight: f64,
    /// receives sum_i w_i d_i^2, d_i the distance of point i from the result
    pub squares: f64,
    /// receives the square root of squares / weight
    pub rms: f64,
    /// receives the largest d_i
    pub largest: f64,
    /// receives the index of that point
    pub largest_index: i64,
    /// receives the last factor of the penalty
    pub lambda: f64,
    /// receives a bound of the error of a d_i, if its nearest point is certified
    pub noise: f64,
    /// receives the number of points whose nearest point is on an end or an edge
    pub boundary: i64,
    /// receives the number of points whose nearest point is not proven
    pub uncertified: i64,
    /// receives the number of searches for the nearest points of all points
    pub rounds: i32,
    /// receives a sum of NURBS_CLOUD_ bits
    pub bits: i32,
}

/// Inputs of the batch functions for closest points in their form as long calls. Set struct_size to
/// sizeof(nurbs_closest_query), and what is not wanted to 0: fields that are 0 or NULL have their defaults.
/// Fields that a function does not use must be 0 or NULL (NURBS_ERROR_OPTIONS). Fields are only ever
/// appended, and struct_size is at most 4096.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_closest_query {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// number of points
    pub n: i64,
    /// \[n\]\[dim\] the points
    pub points: *const f64,
    /// distance between points, 0 = packed
    pub point_stride: i64,
    /// distance between components, 0 = 1
    pub point_component_stride: i64,
    /// \[n\]\[axes\] or NULL: where nurbs_closest_local_with() begins
    pub guesses: *const f64,
    /// distance between guesses, 0 = packed
    pub guess_stride: i64,
    /// distance between components, 0 = 1
    pub guess_component_stride: i64,
    /// \[axes\]\[2\] or NULL for all of it: the part of the domain
    pub range: *const f64,
    /// \>= 0
    pub tolerance: f64,
    /// most pieces examined for each point, 0 as for nurbs_closest_points()
    pub budget: i64,
    /// NURBS_NAN_POINTS or 0
    pub flags: u32,
    /// 0
    pub reserved: u32,
}

/// Outputs of the batch functions for closest points in their form as long calls: arrays of the caller, NULL
/// for what is not wanted. Set struct_size to sizeof(nurbs_closest_answer). Arrays that a function does not
/// fill must be NULL (NURBS_ERROR_OPTIONS). Fields are only ever appended, and struct_size is at most 4096.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_closest_answer {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// \[n\]\[axes\] or NULL: the parameters
    pub params: *mut f64,
    /// distance between parameters, 0 = packed
    pub param_stride: i64,
    /// distance between components, 0 = 1
    pub param_component_stride: i64,
    /// \[n\]\[dim\] or NULL: the points of the spline
    pub feet: *mut f64,
    /// distance between feet, 0 = packed
    pub foot_stride: i64,
    /// distance between components, 0 = 1
    pub foot_component_stride: i64,
    /// \[n\] or NULL: the distances, of nurbs_curve_signed_distances_with() signed
    pub distances: *mut f64,
    /// distance between distances, 0 = 1
    pub distance_stride: i64,
    /// \[n\] or NULL: sums of NURBS_CLOSEST_ bits
    pub status: *mut i32,
}

/// The constraints of nurbs_constrain() as one argument. Set struct_size to sizeof(nurbs_constraints), and
/// what is not wanted to 0. Fields are only ever appended, and struct_size is at most 4096.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_constraints {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// number of constraints, \> 0
    pub count: i64,
    /// \[count\] or NULL: as for nurbs_constrain(), like all fields that follow
    pub kinds: *const i32,
    /// \[count\]\[axes\] or NULL: orders of derivatives
    pub orders: *const i32,
    /// \[count\]\[axes\] parameters
    pub params: *const f64,
    /// \[count\]\[dim\] targets
    pub targets: *const f64,
    /// \[axes\]\[2\] or NULL: derivatives that stay at the ends
    pub keep: *const i32,
    /// \[N\] or NULL: of moving control points
    pub costs: *const f64,
    /// \[N\] or NULL: of changing weights
    pub weight_costs: *const f64,
    /// largest residual, \>= 0
    pub tolerance: f64,
}

/// What nurbs_constrain() tells about its solution. Set struct_size to sizeof(nurbs_constraint_report), and
/// residuals. Fields are only ever appended, and struct_size is at most 4096.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_constraint_report {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// \[count\] or NULL: an array of the caller, which receives the residuals
    pub residuals: *mut f64,
    /// receives the number of independent equations
    pub rank: i64,
    /// receives the largest distance by which a control point moved
    pub moved: f64,
    /// receives the relative length of the gradient
    pub optimality: f64,
}

/// Settings for nurbs_read(); fill with nurbs_read_options_init() first. Fields are only ever appended, and
/// struct_size is at most 4096. A file whose own unit is not known cannot be converted to another:
/// NURBS_ERROR_OPTIONS.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_read_options {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// wanted unit in metres (0.001: millimetres); 0 keeps the file's own
    pub unit: f64,
    /// largest file accepted; 0 means the default, 2^30
    pub max_bytes: i64,
    /// the distance, in the unit of the result, that counts as zero: the tolerance of faces, and how near to
    /// what the file states is what has to be made; 0 for the uncertainty or resolution that the file states.
    /// \since 1.1
    pub tolerance: f64,
    /// sum of NURBS_READ_ constants, 0 for all of them; others are left out without a note. \since 1.1
    pub kinds: u32,
    /// 0
    pub reserved: u32,
}

/// How near a mesh has to be to its shape; fill with nurbs_mesh_options_init() first. NULL stands for the
/// defaults as well. Fields are only ever appended, and struct_size is at most 4096. All limits that are
/// given hold. The extent is the longest side of the box of all control points of all surfaces. \since 1.1
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_mesh_options {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// largest distance between shape and mesh, both ways, \> 0; default INFINITY
    pub chord: f64,
    /// the same as a share of the extent, \>= 0; 0: no limit; default 1e-3
    pub relative_chord: f64,
    /// largest length of sides of triangles, \>= 0; 0: no limit; default 0
    pub longest: f64,
    /// of triangles' corner normals, radians, 0 to pi; 0, pi: no limit; default 0
    pub angle: f64,
    /// smallest of triangles inside, radians, 0 to pi / 6; 0: no limit; default 0
    pub minimum_angle: f64,
}

/// Settings for nurbs_model_write() and similar functions; fill with nurbs_write_options_init() first. Fields
/// are only ever appended, and struct_size is at most 4096. Without a tolerance each part of a STEP file gets
/// the least one of its faces that is not 0, since readers enlarge it where edges need that, but no less than
/// 10^-4 of the largest one, and 1e-7 metres if it has none. IGES has one for the whole file, the least of
/// all faces, but no less than 10^-4 of those that are above 1 % of the size of their surfaces: readers find
/// the others.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_write_options {
    /// size of this struct as the caller knows it
    pub struct_size: i64,
    /// unit of the file in metres; 0: that of the model, millimetres if it has none
    pub unit: f64,
    /// distance that counts as none, in units of the file; 0: that of the faces
    pub tolerance: f64,
}

// --- Version and limits
/// Changes when programs built with an earlier version may stop working.
pub const NURBS_VERSION_MAJOR: i32 = 1;
/// Changes when functions, constants or options are added.
pub const NURBS_VERSION_MINOR: i32 = 1;
/// Changes when defects are mended.
pub const NURBS_VERSION_PATCH: i32 = 0;
/// major \* 10000 + minor \* 100 + patch, as returned by nurbs_version().
pub const NURBS_VERSION: i32 = NURBS_VERSION_MAJOR * 10000 + NURBS_VERSION_MINOR * 100 + NURBS_VERSION_PATCH;
/// Highest degree accepted on any axis.
pub const NURBS_MAX_DEGREE: i32 = 31;
/// Highest number of parametric axes.
pub const NURBS_MAX_AXES: i32 = 3;
/// Highest order of derivatives that the evaluating functions compute.
pub const NURBS_MAX_ORDER: i32 = 255;

// --- Statuses
/// success
pub const NURBS_OK: nurbs_status = 0;
/// a required pointer is NULL
pub const NURBS_ERROR_NULL: nurbs_status = 1;
/// number of axes not 1 to 3, or not one that the function is for
pub const NURBS_ERROR_AXES: nurbs_status = 2;
/// axis index not in \[0, axes)
pub const NURBS_ERROR_AXIS: nurbs_status = 3;
/// degree not in \[0, NURBS_MAX_DEGREE\]
pub const NURBS_ERROR_DEGREE: nurbs_status = 4;
/// a count is negative, or zero where something is needed
pub const NURBS_ERROR_COUNT: nurbs_status = 5;
/// fewer control points than degree + 1
pub const NURBS_ERROR_TOO_FEW_POINTS: nurbs_status = 6;
/// the sizes asked for do not fit in memory addresses
pub const NURBS_ERROR_OVERFLOW: nurbs_status = 7;
/// a stated array length is not the one required
pub const NURBS_ERROR_SIZE: nurbs_status = 8;
/// dimension not in \[1, 2^31 - 2\], or not one allowed here
pub const NURBS_ERROR_DIMENSION: nurbs_status = 9;
/// negative stride, or neither records nor components lie apart
pub const NURBS_ERROR_STRIDE: nurbs_status = 10;
/// an output array overlaps another array
pub const NURBS_ERROR_OVERLAP: nurbs_status = 11;
/// unknown flag bits, or flags that exclude each other
pub const NURBS_ERROR_FLAGS: nurbs_status = 12;
/// derivative order not in \[0, NURBS_MAX_ORDER\]
pub const NURBS_ERROR_ORDER: nurbs_status = 13;
/// a knot is NaN or infinite, or the knots' range overflows
pub const NURBS_ERROR_KNOT_NOT_FINITE: nurbs_status = 14;
/// a knot is smaller than the one before it
pub const NURBS_ERROR_KNOTS_DECREASING: nurbs_status = 15;
/// the first or last knot occurs more than degree + 1 times
pub const NURBS_ERROR_END_MULTIPLICITY: nurbs_status = 16;
/// an interior knot occurs, or would occur, more than degree + 1 times
pub const NURBS_ERROR_MULTIPLICITY: nurbs_status = 17;
/// knots\[degree\] == knots\[count\], or an empty interval
pub const NURBS_ERROR_EMPTY_DOMAIN: nurbs_status = 18;
/// a coordinate is NaN or infinite
pub const NURBS_ERROR_POINT_NOT_FINITE: nurbs_status = 19;
/// a weight is NaN or infinite
pub const NURBS_ERROR_WEIGHT_NOT_FINITE: nurbs_status = 20;
/// a weight is \< 0
pub const NURBS_ERROR_WEIGHT_NEGATIVE: nurbs_status = 21;
/// all weights that are active at some parameter are 0
pub const NURBS_ERROR_WEIGHTS_VANISH: nurbs_status = 22;
/// a parameter is NaN or infinite
pub const NURBS_ERROR_PARAMETER_NOT_FINITE: nurbs_status = 23;
/// knots of an axis flagged periodic do not repeat with the period
pub const NURBS_ERROR_PERIODIC_KNOTS: nurbs_status = 24;
/// points or weights of an axis flagged periodic do not wrap bit for bit
pub const NURBS_ERROR_PERIODIC_POINTS: nurbs_status = 25;
/// a number of repetitions is negative
pub const NURBS_ERROR_TIMES: nurbs_status = 26;
/// an options struct has a wrong size or a value out of range
pub const NURBS_ERROR_OPTIONS: nurbs_status = 27;
/// an index is outside its list
pub const NURBS_ERROR_INDEX: nurbs_status = 28;
/// a direction is zero, not finite, or parallel to another one
pub const NURBS_ERROR_DIRECTION: nurbs_status = 29;
/// a knot at an end of the domain, where it cannot be removed
pub const NURBS_ERROR_END_KNOT: nurbs_status = 30;
/// a value that has to be a knot of the axis is not one
pub const NURBS_ERROR_NOT_A_KNOT: nurbs_status = 31;
/// an entry of a matrix or translation is NaN or infinite
pub const NURBS_ERROR_MATRIX: nurbs_status = 32;
/// the spline is rational, which the function is not for
pub const NURBS_ERROR_RATIONAL: nurbs_status = 33;
/// splines differ in what they have to share
pub const NURBS_ERROR_INCOMPATIBLE: nurbs_status = 40;
/// ends that are to be joined lie farther apart than the tolerance
pub const NURBS_ERROR_GAP: nurbs_status = 41;
/// a tolerance is negative or NaN, or otherwise out of range
pub const NURBS_ERROR_TOLERANCE: nurbs_status = 42;
/// an axis that has to be periodic was not declared so
pub const NURBS_ERROR_NOT_PERIODIC: nurbs_status = 43;
/// no one factor makes the weights at the ends of an axis equal
pub const NURBS_ERROR_END_WEIGHTS: nurbs_status = 44;
/// a factor is not finite, or not positive where it has to be
pub const NURBS_ERROR_FACTOR: nurbs_status = 45;
/// a knot is less smooth than the function needs
pub const NURBS_ERROR_CONTINUITY: nurbs_status = 46;
/// a weight of the result would not be positive
pub const NURBS_ERROR_WEIGHT_SIGN: nurbs_status = 47;
/// an axis is periodic, which the function is not for
pub const NURBS_ERROR_PERIODIC: nurbs_status = 48;
/// an end is neither NURBS_START nor NURBS_END
pub const NURBS_ERROR_END: nurbs_status = 49;
/// not one of the NURBS_BASIS_ constants
pub const NURBS_ERROR_BASIS: nurbs_status = 50;
/// a function neither increases nor decreases strictly
pub const NURBS_ERROR_NOT_MONOTONE: nurbs_status = 51;
/// an angle is not finite or above 2^22, or a sweep is 0 or above a turn
pub const NURBS_ERROR_ANGLE: nurbs_status = 52;
/// a radius or another length is not finite or out of range
pub const NURBS_ERROR_LENGTH: nurbs_status = 53;
/// points that must not be on a line are on one
pub const NURBS_ERROR_COLLINEAR: nurbs_status = 54;
/// no conic, or no arc of one in one piece, fulfils the conditions
pub const NURBS_ERROR_CONIC: nurbs_status = 55;
/// not one of the NURBS_ARC_ constants that are allowed here
pub const NURBS_ERROR_FORM: nurbs_status = 56;
/// tangents that have to agree differ by more than the tolerance
pub const NURBS_ERROR_TANGENT: nurbs_status = 57;
/// twists that have to agree differ by more than the tolerance
pub const NURBS_ERROR_TWIST: nurbs_status = 58;
/// not one of the NURBS_TWIST_ constants, or one that does not suit
pub const NURBS_ERROR_TWIST_RULE: nurbs_status = 59;
/// a control point has no influence at the parameter
pub const NURBS_ERROR_INFLUENCE: nurbs_status = 60;
/// constraints contradict each other
pub const NURBS_ERROR_CONTRADICTION: nurbs_status = 61;
/// not one of the NURBS_CONSTRAIN_ constants
pub const NURBS_ERROR_CONSTRAINT: nurbs_status = 62;
/// a point is not on the control polygon
pub const NURBS_ERROR_OFF_POLYGON: nurbs_status = 63;
/// not one of the constants of a rule, or one that does not suit
pub const NURBS_ERROR_RULE: nurbs_status = 64;
/// data lie outside the support of the control point that they have to determine
pub const NURBS_ERROR_SCHOENBERG_WHITNEY: nurbs_status = 65;
/// data or conditions do not determine the result
pub const NURBS_ERROR_RANK: nurbs_status = 66;
/// a value or weight is above the scale of the statistics
pub const NURBS_ERROR_SCALE: nurbs_status = 67;
/// loops of a face have no common inside, or enclose nothing
pub const NURBS_ERROR_ORIENTATION: nurbs_status = 68;
/// one handle where two different shapes are needed
pub const NURBS_ERROR_SAME: nurbs_status = 69;
/// loops of a face cross themselves or each other
pub const NURBS_ERROR_CROSSING: nurbs_status = 70;
/// a parameter or knot lies outside the domain
pub const NURBS_ERROR_OUTSIDE_DOMAIN: nurbs_status = 100;
/// a value of the result overflows double precision
pub const NURBS_ERROR_NOT_REPRESENTABLE: nurbs_status = 200;
/// knots that differ would become equal or change their order
pub const NURBS_ERROR_KNOTS_MERGE: nurbs_status = 202;
/// an iteration did not reach its goal
pub const NURBS_ERROR_NOT_CONVERGED: nurbs_status = 203;
/// an allocation failed
pub const NURBS_ERROR_MEMORY: nurbs_status = 300;
/// a file cannot be opened or read
pub const NURBS_ERROR_FILE: nurbs_status = 301;
/// a file exceeds the size limit of the options
pub const NURBS_ERROR_TOO_LARGE: nurbs_status = 302;
/// the callback of a long call asked for its end
pub const NURBS_ERROR_CANCELLED: nurbs_status = 303;
/// the limit of work of a long call was reached before its end
pub const NURBS_ERROR_WORK: nurbs_status = 304;
/// not a file of a known format
pub const NURBS_ERROR_FORMAT: nurbs_status = 400;
/// the file ends, or a section is missing, before its contents are complete
pub const NURBS_ERROR_TRUNCATED: nurbs_status = 401;
/// the file breaks the rules of its format
pub const NURBS_ERROR_SYNTAX: nurbs_status = 402;
/// an entity that this version does not read (only in notes)
pub const NURBS_ERROR_UNSUPPORTED: nurbs_status = 403;
/// bytes of a handle are not those that were written
pub const NURBS_ERROR_CHECKSUM: nurbs_status = 404;
/// bytes of a handle have a later version of the form
pub const NURBS_ERROR_VERSION: nurbs_status = 405;
/// entities of a file contain each other (only in notes)
pub const NURBS_ERROR_CYCLE: nurbs_status = 406;
/// a defect of the library; please report it
pub const NURBS_ERROR_INTERNAL: nurbs_status = 900;

// --- Flags by axis
/// Evaluation: at a knot take the limit from below.
pub const NURBS_LEFT: u32 = 0x01;
/// Evaluation: move a parameter outside the domain (infinite ones too) to the nearer end.
pub const NURBS_CLAMP: u32 = 0x02;
/// Evaluation: outside the domain continue the first or last polynomial piece.
pub const NURBS_EXTRAPOLATE: u32 = 0x04;
/// Evaluation: reduce the parameter by multiples of the domain's length; the start and the end are the same
/// place, seen from the right unless NURBS_LEFT is set. Allowed on every axis, periodic or not.
pub const NURBS_WRAP: u32 = 0x08;
/// Evaluation: a parameter that cannot be evaluated gives NaN instead of an error. NURBS_CLAMP,
/// NURBS_EXTRAPOLATE and NURBS_WRAP exclude each other; each may be combined with NURBS_NAN.
pub const NURBS_NAN: u32 = 0x10;
/// Creation: the axis is periodic with period knots\[count\] - knots\[degree\]: knots\[i + m\] = knots\[i\] +
/// period to within the rounding of the largest knot, and the last `degree` layers of points and weights
/// equal the first ones bit for bit, where m = count - degree is the number of distinct layers. Operations
/// keep the axis periodic.
pub const NURBS_PERIODIC: u32 = 0x01;

// --- Global flags
/// nurbs_eval_adjoint() and the other adjoints: add to what the outputs hold instead of overwriting it.
pub const NURBS_ACCUMULATE: u32 = 0x01000000;
/// nurbs_reverse(): map the domain to itself instead of negating the parameter.
pub const NURBS_KEEP_DOMAIN: u32 = 0x02000000;
/// nurbs_join(): ends that do not meet become a jump instead of an error; nurbs_face_create(): segments close
/// what curves leave open.
pub const NURBS_KEEP_GAPS: u32 = 0x04000000;
/// nurbs_product(): the dot product.
pub const NURBS_PRODUCT_DOT: u32 = 0x08000000;
/// nurbs_product(): the cross product in dimension 3.
pub const NURBS_PRODUCT_CROSS: u32 = 0x10000000;
/// nurbs_create_power(), nurbs_unclamp(): homogeneous records (w x, w y, ..., w).
pub const NURBS_HOMOGENEOUS: u32 = 0x20000000;
/// nurbs_make_compatible(): map the domains of all splines to that of the first one.
pub const NURBS_MAP_DOMAINS: u32 = 0x40000000;
/// nurbs_curve_divide(): equal distances of consecutive points instead of equal lengths.
pub const NURBS_EQUAL_CHORDS: u32 = 0x02000000;
/// nurbs_snap_boundary(): the two boundaries run against each other.
pub const NURBS_REVERSED: u32 = 0x04000000;
/// nurbs_closest_points() and its neighbours: a point that is not finite gives NaN instead of an error.
pub const NURBS_NAN_POINTS: u32 = 0x01000000;
/// nurbs_face_create(): the inside is to the left of the loops as they run.
pub const NURBS_AS_ORIENTED: u32 = 0x01000000;
/// nurbs_face_create(): loops that cross themselves or each other are refused.
pub const NURBS_CHECK_CROSSINGS: u32 = 0x02000000;

// --- Form of a knot vector, as reported by nurbs_knot_form()
/// the first degree + 1 knots are equal
pub const NURBS_FORM_CLAMPED_START: i32 = 0x01;
/// the last degree + 1 knots are equal
pub const NURBS_FORM_CLAMPED_END: i32 = 0x02;
/// the axis was declared periodic
pub const NURBS_FORM_PERIODIC: i32 = 0x04;

// --- Bases of a polynomial segment, for nurbs_basis_matrix()
/// 1, t, t^2, ...
pub const NURBS_BASIS_POWER: i32 = 0;
/// the Bezier points over \[0, 1\]
pub const NURBS_BASIS_BERNSTEIN: i32 = 1;
/// f(0), f'(0), ..., then f(1), f'(1), ...; odd degrees
pub const NURBS_BASIS_HERMITE: i32 = 2;
/// control points over the knots -degree, ..., degree + 1
pub const NURBS_BASIS_BSPLINE: i32 = 3;

// --- Rules for parameters, for nurbs_parametrize()
/// equal steps
pub const NURBS_PARAMS_UNIFORM: i32 = 0;
/// steps in proportion to the chords
pub const NURBS_PARAMS_CHORD: i32 = 1;
/// steps in proportion to the square roots of the chords (Lee 1989)
pub const NURBS_PARAMS_CENTRIPETAL: i32 = 2;
/// steps in proportion to a power of the chords
pub const NURBS_PARAMS_POWER: i32 = 3;
/// steps in proportion to the chords, longer where the polygon turns
pub const NURBS_PARAMS_FOLEY_NIELSON: i32 = 4;

// --- Ends of an interpolating spline, for nurbs_interpolate()
/// the parameters next to the end are not knots
pub const NURBS_ENDS_NOT_A_KNOT: i32 = 0;
/// derivatives of orders (degree + 1) / 2 to degree - 1 vanish; odd degrees
pub const NURBS_ENDS_NATURAL: i32 = 1;
/// knots averaged from the parameters (nurbs_knots_averaged()); both ends
pub const NURBS_ENDS_FREE: i32 = 2;

// --- Special orders of derivatives, for nurbs_curve_interpolate()
/// the first derivative has the direction of the target, of any length
pub const NURBS_ORDER_DIRECTION: i32 = -1;

// --- How smooth a fit is, for nurbs_fit_options
/// only the data count
pub const NURBS_SMOOTHING_NONE: i32 = 0;
/// the factor of the penalty is given
pub const NURBS_SMOOTHING_LAMBDA: i32 = 1;
/// by generalised cross validation (Craven & Wahba 1979)
pub const NURBS_SMOOTHING_GCV: i32 = 2;
/// by restricted maximum likelihood (Wood 2011)
pub const NURBS_SMOOTHING_REML: i32 = 3;
/// as smooth as a given sum of squares allows (Reinsch 1967)
pub const NURBS_SMOOTHING_DISCREPANCY: i32 = 4;

// --- How much outliers count, for nurbs_fit_options
/// as much as other data
pub const NURBS_ROBUST_NONE: i32 = 0;
/// their weight times min(1, 1 / x) (Huber 1964)
pub const NURBS_ROBUST_HUBER: i32 = 1;
/// their weight times (1 - x^2)^2 for x \< 1, else 0 (Beaton & Tukey 1974)
pub const NURBS_ROBUST_TUKEY: i32 = 2;

// --- Shapes along an axis, for nurbs_fit_options; they can be added
/// the first derivative is \>= 0
pub const NURBS_TREND_RISING: i32 = 0x01;
/// the first derivative is \<= 0
pub const NURBS_TREND_FALLING: i32 = 0x02;
/// the first derivative does not fall
pub const NURBS_TREND_CONVEX: i32 = 0x04;
/// the first derivative does not rise
pub const NURBS_TREND_CONCAVE: i32 = 0x08;

// --- Bits of nurbs_fit_report
/// the target, or the tolerance, is not reached
pub const NURBS_FIT_TARGET_MISSED: i32 = 0x01;
/// the last round of a robust fit, or of a shape, still changed it
pub const NURBS_FIT_NOT_CONVERGED: i32 = 0x02;

// --- Bits of nurbs_cloud_report
/// the rounds, or the limit of work, ended while the sum was still falling
pub const NURBS_CLOUD_NOT_CONVERGED: i32 = 0x01;

// --- Rules for tangents, for nurbs_tangents()
/// the slope between the neighbours
pub const NURBS_TANGENTS_CATMULL_ROM: i32 = 0;
/// the slope of the parabola through a point and its neighbours
pub const NURBS_TANGENTS_BESSEL: i32 = 1;
/// mean of both slopes, weighted by their steadiness (Akima 1970)
pub const NURBS_TANGENTS_AKIMA: i32 = 2;
/// each coordinate rises and falls as the data do (Fritsch & Butland 1984)
pub const NURBS_TANGENTS_MONOTONE: i32 = 3;

// --- Ends of an axis
/// the lower end of the domain
pub const NURBS_START: i32 = 0;
/// the upper end of the domain
pub const NURBS_END: i32 = 1;

// --- Status of a point
/// tangent of a curve, normal of a surface: a one-sided limit
pub const NURBS_FRAME_LIMIT: i32 = 0x01;
/// normal of a curve in space: a one-sided limit
pub const NURBS_FRAME_NORMAL_LIMIT: i32 = 0x02;
/// nothing distinguishes a direction: the function's rule chose it
pub const NURBS_FRAME_RULE: i32 = 0x04;
/// some result does not exist and is NaN
pub const NURBS_FRAME_UNDEFINED: i32 = 0x08;

// --- Forms of an arc
/// degree 2, equal pieces of at most a quarter turn
pub const NURBS_ARC_QUARTERS: i32 = 0;
/// degree 2, equal pieces of at most a third of a turn
pub const NURBS_ARC_THIRDS: i32 = 1;
/// One polynomial piece: degree 2 up to a third of a turn, degree 5 beyond; weights are positive.
pub const NURBS_ARC_SMOOTH: i32 = 2;

// --- Kinds of conics
/// shape factor below 1
pub const NURBS_CONIC_ELLIPSE: i32 = 1;
/// shape factor 1
pub const NURBS_CONIC_PARABOLA: i32 = 2;
/// shape factor above 1
pub const NURBS_CONIC_HYPERBOLA: i32 = 3;
/// degenerate: shape factor 0, the segment P0 P2
pub const NURBS_CONIC_CHORD: i32 = 4;
/// degenerate: shape factor infinite, the segments P0 P1 and P1 P2
pub const NURBS_CONIC_LEGS: i32 = 5;
/// degenerate: P0, P1 and P2 on a line
pub const NURBS_CONIC_LINE: i32 = 6;

// --- Flags of constructions
/// nurbs_ruled(): rulings of Cartesian points, divided evenly, not those of homogeneous ones.
pub const NURBS_RULED_CARTESIAN: u32 = 0x80000000;
/// nurbs_surface_sphere_patches(): the half towards Z.
pub const NURBS_HEMISPHERE: u32 = 0x01000000;
/// nurbs_surface_hyperboloid(): the hyperboloid of two sheets.
pub const NURBS_TWO_SHEETS: u32 = 0x02000000;

// --- Twists of nurbs_surface_coons_hermite()
/// both, which must agree to the tolerance
pub const NURBS_TWIST_COMPATIBLE: i32 = 0;
/// their mean
pub const NURBS_TWIST_AVERAGE: i32 = 1;
/// the ones given
pub const NURBS_TWIST_GIVEN: i32 = 2;
/// zero (Ferguson's patch)
pub const NURBS_TWIST_ZERO: i32 = 3;
/// that of the bilinear patch of the corners
pub const NURBS_TWIST_BILINEAR: i32 = 4;
/// that of the bilinear Coons surface of the boundaries (Adini's twist)
pub const NURBS_TWIST_ADINI: i32 = 5;

// --- Shapes
/// none of these, to the tolerance
pub const NURBS_SHAPE_NONE: i32 = 0;
/// a single point
pub const NURBS_SHAPE_POINT: i32 = 1;
/// a piece of a straight line
pub const NURBS_SHAPE_LINE: i32 = 2;
/// a circle, or an arc of one
pub const NURBS_SHAPE_CIRCLE: i32 = 3;
/// an ellipse, or an arc of one
pub const NURBS_SHAPE_ELLIPSE: i32 = 4;
/// an arc of a parabola
pub const NURBS_SHAPE_PARABOLA: i32 = 5;
/// an arc of one branch of a hyperbola
pub const NURBS_SHAPE_HYPERBOLA: i32 = 6;
/// a piece of a plane
pub const NURBS_SHAPE_PLANE: i32 = 7;
/// a sphere, or a piece of one
pub const NURBS_SHAPE_SPHERE: i32 = 8;
/// a piece of a circular cylinder
pub const NURBS_SHAPE_CYLINDER: i32 = 9;
/// a piece of one half of a circular cone
pub const NURBS_SHAPE_CONE: i32 = 10;
/// a torus, or a piece of one
pub const NURBS_SHAPE_TORUS: i32 = 11;
/// a surface of revolution; of models only, as those that follow
pub const NURBS_SHAPE_REVOLUTION: i32 = 12;
/// a curve moved along a vector
pub const NURBS_SHAPE_EXTRUSION: i32 = 13;
/// at a distance from another surface
pub const NURBS_SHAPE_OFFSET: i32 = 14;

// --- Status of a closest point
/// proven to be the nearest, or farthest, point to the tolerance
pub const NURBS_CLOSEST_CERTIFIED: i32 = 0x01;
/// on an end or an edge of the domain, or of range
pub const NURBS_CLOSEST_BOUNDARY: i32 = 0x02;
/// points elsewhere are as near to the tolerance
pub const NURBS_CLOSEST_NOT_UNIQUE: i32 = 0x04;
/// the budget ended before a proof was found
pub const NURBS_CLOSEST_BUDGET: i32 = 0x08;
/// the query point is not finite; results are NaN
pub const NURBS_CLOSEST_INVALID: i32 = 0x10;
/// proven, but rounding the parameters moves the point by more
pub const NURBS_CLOSEST_COARSE: i32 = 0x20;
/// of nurbs_closest_adjoint(): the gradient is not determined
pub const NURBS_CLOSEST_SINGULAR: i32 = 0x40;
/// NURBS_LEFT is meant on axis 0; 0x200 on axis 1, 0x400 on axis 2
pub const NURBS_CLOSEST_LEFT: i32 = 0x100;

// --- Kind of a critical point
/// a local minimum of the distance
pub const NURBS_CRITICAL_MINIMUM: i32 = 1;
/// a local maximum of the distance
pub const NURBS_CRITICAL_MAXIMUM: i32 = 2;
/// neither
pub const NURBS_CRITICAL_SADDLE: i32 = 3;
/// rounding leaves the kind open
pub const NURBS_CRITICAL_UNDECIDED: i32 = 4;

// --- Features of curves
/// the curvature changes its sign; in space: it vanishes
pub const NURBS_FEATURE_INFLECTION: u32 = 0x01;
/// a local maximum of |curvature|
pub const NURBS_FEATURE_CURVATURE_MAXIMUM: u32 = 0x02;
/// a local minimum of |curvature|, where it is not 0
pub const NURBS_FEATURE_CURVATURE_MINIMUM: u32 = 0x04;
/// the first derivative vanishes
pub const NURBS_FEATURE_CUSP: u32 = 0x08;
/// a knot where the direction of the tangent jumps
pub const NURBS_FEATURE_KINK: u32 = 0x10;
/// a knot where the curve jumps
pub const NURBS_FEATURE_JUMP: u32 = 0x20;
/// the torsion changes its sign (dimension 3)
pub const NURBS_FEATURE_TORSION: u32 = 0x40;

// --- Kinds of extrema
/// no value beside it is smaller
pub const NURBS_EXTREMUM_MINIMUM: u32 = 0x01;
/// no value beside it is larger
pub const NURBS_EXTREMUM_MAXIMUM: u32 = 0x02;
/// f turns up along some axes, and down along others
pub const NURBS_EXTREMUM_SADDLE: u32 = 0x04;
/// f is constant in the range
pub const NURBS_EXTREMUM_PLATEAU: u32 = 0x08;
/// a range in which it is not decided what there is
pub const NURBS_EXTREMUM_UNDECIDED: u32 = 0x10;

// --- Convexity of a curve in the plane
/// turns both ways, or through more than a full turn, or has a cusp
pub const NURBS_CONVEXITY_NONE: i32 = 0;
/// turns to the left only, by at most a full turn
pub const NURBS_CONVEXITY_LEFT: i32 = 1;
/// turns to the right only, by at most a full turn
pub const NURBS_CONVEXITY_RIGHT: i32 = 2;
/// a straight line that does not turn back, to rounding
pub const NURBS_CONVEXITY_STRAIGHT: i32 = 3;
/// double precision cannot decide
pub const NURBS_CONVEXITY_UNDECIDED: i32 = 4;

// --- Folds
/// proven: there is none
pub const NURBS_FOLD_NONE: i32 = 0;
/// proven: there is one
pub const NURBS_FOLD_FOUND: i32 = 1;
/// neither
pub const NURBS_FOLD_UNDECIDED: i32 = 2;

// --- Kinds of hits
/// passes from one side to the other, or has an end there
pub const NURBS_HIT_CROSSING: i32 = 1;
/// a touch, as far as rounding and the tolerance can tell
pub const NURBS_HIT_TANGENT: i32 = 2;
/// within the tolerance, but proven apart: the nearest place
pub const NURBS_HIT_CONTACT: i32 = 3;
/// within the tolerance in the whole range, which is a span or more
pub const NURBS_HIT_OVERLAP: i32 = 4;
/// changes sides where the curve jumps, without meeting anything
pub const NURBS_HIT_JUMP: i32 = 5;
/// a range in which it is not decided what there is
pub const NURBS_HIT_UNDECIDED: i32 = 6;

// --- Status of a ray
/// the ray meets the surface there, to rounding
pub const NURBS_RAY_HIT: i32 = 0x01;
/// nothing is nearer; without NURBS_RAY_HIT: it meets nothing
pub const NURBS_RAY_CERTIFIED: i32 = 0x02;
/// it touches the surface there or just misses it: rounding cannot tell
pub const NURBS_RAY_TOUCH: i32 = 0x04;
/// it arrives from behind: from the side to which S_u x S_v does not point
pub const NURBS_RAY_BACK: i32 = 0x08;

// --- Kinds of nodes of a nurbs_meet
/// the surface ends or jumps there
pub const NURBS_NODE_BORDER: i32 = 1;
/// it closes there on a non-periodic axis: the branch continues beyond
pub const NURBS_NODE_SEAM: i32 = 2;
/// a part within the tolerance in which branches are not separated
pub const NURBS_NODE_TOUCH: i32 = 3;
/// a part in which it is not decided what there is
pub const NURBS_NODE_UNDECIDED: i32 = 4;
/// an edge, a corner or a pole of faces of a model, where another branch continues
pub const NURBS_NODE_EDGE: i32 = 5;
/// the surface folds, seen along the direction of a projection, or feet do: another sheet continues
pub const NURBS_NODE_FOLD: i32 = 6;
/// a region in which two surfaces are within the tolerance of each other; no branch ends there
pub const NURBS_NODE_OVERLAP: i32 = 7;

// --- Kinds of contours
/// f = N . d: the outline seen along d
pub const NURBS_CONTOUR_SILHOUETTE: i32 = 1;
/// f = N . (S - d): the outline seen from the point d
pub const NURBS_CONTOUR_PERSPECTIVE: i32 = 2;
/// (N . d)^2 = c^2 |N|^2 |d|^2 where N . d has the sign of c: normals at one angle to d
pub const NURBS_CONTOUR_ISOPHOTE: i32 = 3;
/// f = K, the Gaussian curvature, up to a positive factor
pub const NURBS_CONTOUR_PARABOLIC: i32 = 4;

// --- Kinds of reflection lines
/// f = N . m: the line along the normal meets the line of light
pub const NURBS_REFLECTION_HIGHLIGHT: i32 = 1;
/// f = (N . N) (v . m) - 2 (N . v) (N . m), v = eye: the mirrored line of sight meets it
pub const NURBS_REFLECTION_ALONG: i32 = 2;
/// the same with v = S - eye: seen from the point eye
pub const NURBS_REFLECTION_FROM: i32 = 3;

// --- Kinds of branches
/// a curve that surfaces, or a surface and a plane, have in common
pub const NURBS_BRANCH_CROSSING: i32 = 1;
/// an edge that two faces share
pub const NURBS_BRANCH_EDGE: i32 = 2;
/// an edge that two faces share, with the same tangent planes somewhere at least
pub const NURBS_BRANCH_CONTACT: i32 = 3;
/// a curve along which surfaces touch: they have the same tangent planes
pub const NURBS_BRANCH_TOUCH: i32 = 4;
/// a part of the boundary of a region in which surfaces coincide
pub const NURBS_BRANCH_OVERLAP: i32 = 5;

// --- Kinds of constraints
/// the derivative of the given orders is the target; orders 0: the point
pub const NURBS_CONSTRAIN_VALUE: i32 = 0;
/// the derivative is parallel to the target, either way
pub const NURBS_CONSTRAIN_DIRECTION: i32 = 1;
/// all first derivatives are perpendicular to the target
pub const NURBS_CONSTRAIN_NORMAL: i32 = 2;
/// the curvature vector (C'' - (C'' T) T) / |C'|^2 of a curve is the target
pub const NURBS_CONSTRAIN_CURVATURE: i32 = 3;

// --- What files are read for
/// curves: in lists all, also those of edges; in models those that are part of no face or edge
pub const NURBS_READ_CURVES: u32 = 0x1;
/// surfaces: in lists all, also those of faces; in models those that are part of no face (STEP)
pub const NURBS_READ_SURFACES: u32 = 0x2;
/// faces of models with their edges and vertices, and other edges; in IGES also surfaces alone
pub const NURBS_READ_FACES: u32 = 0x4;

// --- Kinds of handles
/// a spline: nurbs_from_bytes()
pub const NURBS_BYTES_SPLINE: i32 = 1;
/// a list: nurbs_list_from_bytes()
pub const NURBS_BYTES_LIST: i32 = 2;
/// statistics: nurbs_statistics_from_bytes()
pub const NURBS_BYTES_STATISTICS: i32 = 3;
/// a face: nurbs_face_from_bytes()
pub const NURBS_BYTES_FACE: i32 = 4;
/// a model: nurbs_model_from_bytes()
pub const NURBS_BYTES_MODEL: i32 = 5;

// --- Sides of a model
/// inside a solid, for certain
pub const NURBS_SIDE_INSIDE: i32 = 1;
/// no farther from a face than the tolerance
pub const NURBS_SIDE_ON: i32 = 0;
/// outside all solids, for certain
pub const NURBS_SIDE_OUTSIDE: i32 = -1;
/// not known
pub const NURBS_SIDE_UNDECIDED: i32 = 2;

// --- What is inside of closed curves
/// a winding number other than 0
pub const NURBS_FILL_NON_ZERO: i32 = 1;
/// an odd winding number
pub const NURBS_FILL_EVEN_ODD: i32 = 2;
/// a winding number above 0
pub const NURBS_FILL_POSITIVE: i32 = 3;

// --- What is made of two regions
/// what is in a or in b
pub const NURBS_REGION_UNION: i32 = 1;
/// what is in a and in b
pub const NURBS_REGION_INTERSECTION: i32 = 2;
/// what is in a and not in b
pub const NURBS_REGION_DIFFERENCE: i32 = 3;
/// what is in a or in b and not in both: the symmetric difference
pub const NURBS_REGION_EITHER: i32 = 4;

// --- Which side of a surface is kept
/// the side to which its normals N = S_u x S_v point
pub const NURBS_TRIM_FRONT: i32 = 1;
/// the other side
pub const NURBS_TRIM_BACK: i32 = -1;

// --- Flags of meshes
/// nurbs_mesh_triangles() and similar functions: corners are points, not vertices.
pub const NURBS_MESH_WELDED: u32 = 0x01000000;

// --- Formats of files
/// STEP: an exchange structure of ISO 10303-21, by AP214
pub const NURBS_FORMAT_STEP: i32 = 1;
/// IGES 5.3 in lines of 80 columns
pub const NURBS_FORMAT_IGES: i32 = 2;
/// Triangles: binary STL
pub const NURBS_FORMAT_STL: i32 = 3;
/// Triangles: STL as text
pub const NURBS_FORMAT_STL_TEXT: i32 = 4;
/// Triangles: Wavefront OBJ
pub const NURBS_FORMAT_OBJ: i32 = 5;
/// Triangles: PLY, binary, little-endian
pub const NURBS_FORMAT_PLY: i32 = 6;
/// Triangles: glTF 2.0 in one binary file
pub const NURBS_FORMAT_GLB: i32 = 7;
/// Triangles: an unstructured grid of VTK in XML, with raw arrays appended
pub const NURBS_FORMAT_VTU: i32 = 8;

#[link(name = "nurbs")]
extern "C" {
    // --- Version and errors
    /// Version of the library that is running, encoded like NURBS_VERSION.
    pub fn nurbs_version() -> i32;
    /// Name of a status, such as "NURBS_ERROR_NULL".
    pub fn nurbs_status_name(status: nurbs_status) -> *const c_char;
    /// Copies the message of the last failed call in the calling thread, such as "params\[17\] = 1.2 outside
    /// \[0, 1\]".
    ///
    /// May be null: `buf`.
    pub fn nurbs_last_error(buf: *mut c_char, cap: i64) -> i64;
    // --- Long calls
    /// Fills an options struct with the defaults: no limit, no callback.
    pub fn nurbs_call_options_init(options: *mut nurbs_call_options, struct_size: i64) -> nurbs_status;
    // --- Construction
    /// A spline from full knot vectors, Cartesian points and optional weights.
    ///
    /// May be null: `weights`.
    pub fn nurbs_create(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        weights: *const f64,
        weight_stride: i64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A rational spline from homogeneous points (w x, w y, ..., w).
    pub fn nurbs_create_homogeneous(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A spline from knot vectors without their first and last knot, as openNURBS, Rhino and Maya write them.
    ///
    /// May be null: `weights`.
    pub fn nurbs_create_short(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        weights: *const f64,
        weight_stride: i64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A spline from distinct knots with multiplicities, as STEP and Open CASCADE write them.
    ///
    /// May be null: `weights`.
    pub fn nurbs_create_multiplicities(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        distinct_counts: *const i64,
        distinct_knots: *const f64,
        multiplicities: *const i32,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        weights: *const f64,
        weight_stride: i64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A spline whose periodic axes are given without what they repeat: each control point once, and the
    /// knots of one period.
    ///
    /// May be null: `weights`.
    pub fn nurbs_create_periodic(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        weights: *const f64,
        weight_stride: i64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A Bezier curve, patch or volume over \[0, 1\] on every axis: degrees\[k\] + 1 points along axis k, N
    /// in all, no knots.
    ///
    /// May be null: `weights`.
    pub fn nurbs_create_bezier(
        axes: i32,
        degrees: *const i32,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        weights: *const f64,
        weight_stride: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The same degrees, knots, dimension and periodicity with other points; knots and their tables are
    /// shared, not copied.
    ///
    /// May be null: `weights`.
    pub fn nurbs_with_points(
        g: *const nurbs,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        weights: *const f64,
        weight_stride: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Another handle on the same spline, in constant time.
    pub fn nurbs_clone(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    /// Frees a handle.
    ///
    /// May be null: `g`.
    pub fn nurbs_destroy(g: *mut nurbs);
    // --- Knot vectors
    /// Uniform unclamped knots: t_i = a + (i - p) h with h = (b - a) / (count - p); domain \[a, b\].
    pub fn nurbs_knots_uniform(
        degree: i32,
        count: i64,
        a: f64,
        b: f64,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    /// Open uniform (quasi-uniform, clamped) knots: a and b degree + 1 times, the others evenly between.
    pub fn nurbs_knots_open_uniform(
        degree: i32,
        count: i64,
        a: f64,
        b: f64,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    /// Piecewise Bezier knots: the ends degree + 1 times, each inner break degree times (degree 0: once).
    ///
    /// May be null: `breaks`.
    pub fn nurbs_knots_bezier(
        degree: i32,
        pieces: i64,
        breaks: *const f64,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    /// Clamped knots averaged from parameters, for interpolation: t_(j+p) = (s_j + ... + s_(j+p-1)) / p, j =
    /// 1, ..., count - p - 1; the ends are s_0 and s_(count-1).
    pub fn nurbs_knots_averaged(
        degree: i32,
        count: i64,
        params: *const f64,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    /// Periodic knots from the breaks of one period: the given knots with their multiplicities, continued
    /// with the period on both sides.
    ///
    /// May be null: `multiplicities`.
    pub fn nurbs_knots_periodic(
        degree: i32,
        n: i64,
        breaks: *const f64,
        multiplicities: *const i32,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    // --- Inspection
    /// Number of parametric axes: 1 curve, 2 surface, 3 volume.
    pub fn nurbs_axes(g: *const nurbs, axes: *mut i32) -> nurbs_status;
    /// Dimension of the (Cartesian) points.
    pub fn nurbs_dimension(g: *const nurbs, dim: *mut i32) -> nurbs_status;
    /// Degree along an axis.
    pub fn nurbs_degree(g: *const nurbs, axis: i32, degree: *mut i32) -> nurbs_status;
    /// Number of control points along an axis.
    pub fn nurbs_count(g: *const nurbs, axis: i32, count: *mut i64) -> nurbs_status;
    /// Number N of control points of all axes together: the product of the counts.
    pub fn nurbs_point_count(g: *const nurbs, count: *mut i64) -> nurbs_status;
    /// Whether the spline carries weights, equal ones included.
    pub fn nurbs_is_rational(g: *const nurbs, rational: *mut i32) -> nurbs_status;
    /// Whether the stored values are homogeneous points: those of nurbs_create_homogeneous(), and of
    /// operations on such a spline that keep its weights.
    pub fn nurbs_is_homogeneous(g: *const nurbs, homogeneous: *mut i32) -> nurbs_status;
    /// The full knot vector of an axis.
    pub fn nurbs_knots(g: *const nurbs, axis: i32, knot_count: i64, knots: *mut f64) -> nurbs_status;
    /// The knots of an axis without the first and the last one, as nurbs_create_short() takes them and
    /// openNURBS, Rhino and Maya keep them.
    ///
    /// May be null: `knots`, `count`.
    pub fn nurbs_short_knots(
        g: *const nurbs,
        axis: i32,
        cap: i64,
        knots: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The distinct knots of an axis and how often each occurs; those outside the domain are included.
    ///
    /// May be null: `knots`, `multiplicities`.
    pub fn nurbs_distinct_knots(
        g: *const nurbs,
        axis: i32,
        cap: i64,
        knots: *mut f64,
        multiplicities: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    /// Form of the knot vector of an axis: clamped at the start, at the end, declared periodic; 0 is plainly
    /// unclamped.
    pub fn nurbs_knot_form(g: *const nurbs, axis: i32, form: *mut i32) -> nurbs_status;
    /// Domain of an axis: \[knots\[degree\], knots\[count\]\].
    pub fn nurbs_domain(g: *const nurbs, axis: i32, domain: *mut f64) -> nurbs_status;
    /// Greville abscissae of an axis: x_i = (t_(i+1) + ... + t_(i+p)) / p; for degree 0 (t_i + t_(i+1)) / 2.
    pub fn nurbs_greville(g: *const nurbs, axis: i32, count: i64, abscissae: *mut f64) -> nurbs_status;
    /// The Cartesian control points.
    pub fn nurbs_points(
        g: *const nurbs,
        count: i64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
    ) -> nurbs_status;
    /// The weights; all 1 for a polynomial spline.
    pub fn nurbs_weights(g: *const nurbs, count: i64, weights: *mut f64, weight_stride: i64) -> nurbs_status;
    /// The homogeneous control points (w x, w y, ..., w); w = 1 for a polynomial spline.
    pub fn nurbs_homogeneous_points(
        g: *const nurbs,
        count: i64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
    ) -> nurbs_status;
    /// Number of control points along an axis, each counted once: count - degree on a periodic axis, count on
    /// any other.
    pub fn nurbs_unwrapped_count(g: *const nurbs, axis: i32, count: *mut i64) -> nurbs_status;
    /// The knots of an axis as nurbs_create_periodic() takes them: those from the start to the end of the
    /// domain of a periodic axis, knots\[degree\] to knots\[count\], and all knots of any other.
    ///
    /// May be null: `knots`, `count`.
    pub fn nurbs_unwrapped_knots(
        g: *const nurbs,
        axis: i32,
        cap: i64,
        knots: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// Control points and weights, each once, as nurbs_create_periodic() takes them: along periodic axes
    /// without the last `degree` ones, which repeat others.
    ///
    /// May be null: `points`, `weights`, `count`.
    pub fn nurbs_unwrapped_points(
        g: *const nurbs,
        cap: i64,
        points: *mut f64,
        weights: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// Local hull size: the largest |coordinate| among the active control points of positive weight at each
    /// parameter, the `hull` of the accuracy contract.
    pub fn nurbs_hull_size(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        sizes: *mut f64,
        size_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    // --- Bases
    /// Span of each parameter: the index s with knots\[s\] \<= t \< knots\[s+1\] (the last span is closed),
    /// degree \<= s \< count, never an empty span.
    pub fn nurbs_find_spans(
        degree: i32,
        count: i64,
        knots: *const f64,
        knot_count: i64,
        n: i64,
        params: *const f64,
        param_stride: i64,
        spans: *mut i64,
        flags: u32,
    ) -> nurbs_status;
    /// Bernstein polynomials B_(j,p)(t) = binomial(p, j) t^j (1 - t)^(p - j), j = 0, ..., p, and their
    /// derivatives.
    pub fn nurbs_bernstein(
        degree: i32,
        order: i32,
        n: i64,
        params: *const f64,
        param_stride: i64,
        values: *mut f64,
        value_stride: i64,
        value_component_stride: i64,
    ) -> nurbs_status;
    /// B-spline basis functions that do not vanish at each parameter, and their derivatives (Cox-de Boor
    /// recurrence).
    ///
    /// May be null: `spans`.
    pub fn nurbs_basis(
        degree: i32,
        count: i64,
        knots: *const f64,
        knot_count: i64,
        order: i32,
        n: i64,
        params: *const f64,
        param_stride: i64,
        spans: *mut i64,
        values: *mut f64,
        value_stride: i64,
        value_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// Rational basis functions R_i(t) = w_i N_i(t) / w(t) of the active control points; N_i for a polynomial
    /// spline.
    ///
    /// May be null: `spans`.
    pub fn nurbs_rational_basis(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        spans: *mut i64,
        values: *mut f64,
        value_stride: i64,
        value_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// Gradients in space of the rational basis functions of nurbs_rational_basis(): of R_i as a function of
    /// the point, J (J^T J)^-1 dR_i/dt with J \[dim\]\[axes\] the derivatives of the spline.
    ///
    /// May be null: `spans`.
    pub fn nurbs_basis_gradients(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        spans: *mut i64,
        gradients: *mut f64,
        gradient_stride: i64,
        gradient_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    // --- Evaluation
    /// Points at parameters.
    pub fn nurbs_eval(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// Number of derivative slots S = binomial(order + axes, axes), the partial derivatives of orders 0 to
    /// `order`.
    pub fn nurbs_derivative_slots(axes: i32, order: i32, slots: *mut i64) -> nurbs_status;
    /// Points and all partial derivatives up to an order, by the quotient rule when rational (Piegl & Tiller
    /// A4.2, A4.4).
    pub fn nurbs_eval_derivs(
        g: *const nurbs,
        order: i32,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        derivs: *mut f64,
        deriv_stride: i64,
        deriv_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// Points on the grid of all combinations of one parameter from each axis.
    pub fn nurbs_eval_grid(
        g: *const nurbs,
        counts: *const i64,
        params: *const f64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// Points and partial derivatives on a grid.
    pub fn nurbs_eval_grid_derivs(
        g: *const nurbs,
        order: i32,
        counts: *const i64,
        params: *const f64,
        derivs: *mut f64,
        deriv_stride: i64,
        deriv_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// Points at parameters in single precision: the results of nurbs_eval(), each rounded once to the
    /// nearest float.
    pub fn nurbs_eval_f32(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        points: *mut f32,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// Points on a grid in single precision: the results of nurbs_eval_grid(), each rounded once to the
    /// nearest float.
    pub fn nurbs_eval_grid_f32(
        g: *const nurbs,
        counts: *const i64,
        params: *const f64,
        points: *mut f32,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// The iso-curve of a surface, or iso-surface of a volume, on which the parameter of one axis is fixed.
    pub fn nurbs_iso(
        g: *const nurbs,
        axis: i32,
        param: f64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Frames and curvature
    /// Points, first derivatives and unit normals of a surface in space.
    ///
    /// May be null: `points`, `du`, `dv`, `normals`, `status`.
    pub fn nurbs_surface_eval_frames(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
        du: *mut f64,
        du_stride: i64,
        du_component_stride: i64,
        dv: *mut f64,
        dv_stride: i64,
        dv_component_stride: i64,
        normals: *mut f64,
        normal_stride: i64,
        normal_component_stride: i64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    /// The same on the grid of all combinations of a parameter of each axis.
    ///
    /// May be null: `points`, `du`, `dv`, `normals`, `status`.
    pub fn nurbs_surface_eval_grid_frames(
        g: *const nurbs,
        counts: *const i64,
        params: *const f64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
        du: *mut f64,
        du_stride: i64,
        du_component_stride: i64,
        dv: *mut f64,
        dv_stride: i64,
        dv_component_stride: i64,
        normals: *mut f64,
        normal_stride: i64,
        normal_component_stride: i64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    /// Principal curvatures and directions of a surface in space, mean and Gaussian curvature.
    ///
    /// May be null: `principal`, `directions`, `mean`, `gaussian`, `status`.
    pub fn nurbs_surface_eval_curvatures(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        principal: *mut f64,
        principal_stride: i64,
        principal_component_stride: i64,
        directions: *mut f64,
        direction_stride: i64,
        direction_component_stride: i64,
        mean: *mut f64,
        mean_stride: i64,
        gaussian: *mut f64,
        gaussian_stride: i64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    /// Frenet frames of a curve in the plane or in space.
    ///
    /// May be null: `points`, `tangents`, `normals`, `binormals`, `curvatures`, `torsions`, `status`.
    pub fn nurbs_curve_eval_frames(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
        tangents: *mut f64,
        tangent_stride: i64,
        tangent_component_stride: i64,
        normals: *mut f64,
        normal_stride: i64,
        normal_component_stride: i64,
        binormals: *mut f64,
        binormal_stride: i64,
        binormal_component_stride: i64,
        curvatures: *mut f64,
        curvature_stride: i64,
        torsions: *mut f64,
        torsion_stride: i64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    /// Rotation-minimizing frames along a sequence of points of a curve in space, by double reflection (Wang,
    /// Juttler, Zheng & Liu 2008): frames that turn about the tangent as little as possible.
    ///
    /// May be null: `first_normal`, `points`, `tangents`, `normals`, `binormals`, `status`.
    pub fn nurbs_curve_rotation_minimizing_frames(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        first_normal: *const f64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
        tangents: *mut f64,
        tangent_stride: i64,
        tangent_component_stride: i64,
        normals: *mut f64,
        normal_stride: i64,
        normal_component_stride: i64,
        binormals: *mut f64,
        binormal_stride: i64,
        binormal_component_stride: i64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    // --- Refinement
    /// Inserts a knot without changing the shape (Boehm 1980).
    pub fn nurbs_insert_knot(
        g: *const nurbs,
        axis: i32,
        knot: f64,
        times: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Inserts a list of knots at once without changing the shape.
    pub fn nurbs_refine(
        g: *const nurbs,
        axis: i32,
        count: i64,
        knots: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Divides every non-empty span of the domain into equal parts by knots: a + (b - a) i / parts, 0 \< i \<
    /// parts, in the span \[a, b\].
    pub fn nurbs_refine_uniform(g: *const nurbs, axis: i32, parts: i64, out: *mut *mut nurbs)
        -> nurbs_status;
    /// The matrix A of nurbs_refine() along one axis, as compressed sparse rows (CSR): new layer i is sum_j
    /// A\[i\]\[j\] \* old layer j, with homogeneous points when rational.
    ///
    /// May be null: `values`, `columns`, `row_pointers`, `entries`.
    pub fn nurbs_refinement_matrix(
        g: *const nurbs,
        axis: i32,
        count: i64,
        knots: *const f64,
        cap: i64,
        values: *mut f64,
        columns: *mut i64,
        row_pointers: *mut i64,
        entries: *mut i64,
    ) -> nurbs_status;
    /// Splits a spline at a parameter of an axis, for a single Bezier piece by de Casteljau's subdivision.
    pub fn nurbs_split(
        g: *const nurbs,
        axis: i32,
        param: f64,
        lower: *mut *mut nurbs,
        upper: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The part of a curve, surface or volume over a box in the domain.
    pub fn nurbs_extract(
        g: *const nurbs,
        lower: *const f64,
        upper: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Decomposes a spline into its polynomial (rational) pieces, as Bezier splines over their own domains:
    /// each has degree + 1 layers along each axis.
    pub fn nurbs_decompose(g: *const nurbs, out: *mut *mut nurbs_list) -> nurbs_status;
    /// The pieces of nurbs_decompose() as arrays, in one call: the same control points and weights, bit for
    /// bit, in the same order, without a handle for each.
    ///
    /// May be null: `points`, `weights`, `domains`, `piece_counts`.
    pub fn nurbs_bezier_pieces(
        g: *const nurbs,
        cap: i64,
        points: *mut f64,
        weights: *mut f64,
        domains: *mut f64,
        piece_counts: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// Splits a spline at all knots inside the domain of an axis where its order of continuity, degree -
    /// multiplicity, is less than a given one: 0 at jumps, 1 also at kinks (where it is only continuous),
    /// `degree` at every knot.
    pub fn nurbs_split_at_knots(
        g: *const nurbs,
        axis: i32,
        order: i32,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    /// Clamps ends of an axis: knots are inserted until the end of the domain occurs degree + 1 times, and
    /// what lies outside the domain is dropped.
    pub fn nurbs_clamp_ends(g: *const nurbs, axis: i32, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    /// Moves the seam of a periodic axis: the same shape, periodic again, over \[param, param + period\].
    pub fn nurbs_move_seam(g: *const nurbs, axis: i32, param: f64, out: *mut *mut nurbs) -> nurbs_status;
    /// Joins splines end to end along an axis.
    ///
    /// May be null: `gap`.
    pub fn nurbs_join(
        count: i64,
        parts: *const *const nurbs,
        axis: i32,
        tolerance: f64,
        flags: u32,
        gap: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Makes near-equal knots of an axis equal; control points stay.
    ///
    /// May be null: `deviation`.
    pub fn nurbs_snap_knots(
        g: *const nurbs,
        axis: i32,
        tolerance: f64,
        deviation: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Brings splines to one degree and one knot vector on every axis, without changing their shapes unless a
    /// tolerance allows it, and all to weights if one of them is rational (and to homogeneous points if one
    /// was built so).
    ///
    /// May be null: `deviation`.
    pub fn nurbs_make_compatible(
        count: i64,
        splines: *const *const nurbs,
        tolerance: f64,
        flags: u32,
        deviation: *mut f64,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    /// Extends a spline beyond an end of an axis by a length of the parameter.
    pub fn nurbs_extend(
        g: *const nurbs,
        axis: i32,
        end: i32,
        amount: f64,
        order: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Unclamps ends of an axis: the end of the domain becomes a single knot, and the knots beyond it repeat
    /// those of the domain with its length as the period, so that even spans go on evenly.
    pub fn nurbs_unclamp(g: *const nurbs, axis: i32, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    /// Makes a closed spline periodic along an axis, over the same domain.
    ///
    /// May be null: `deviation`, `order`.
    pub fn nurbs_make_periodic(
        g: *const nurbs,
        axis: i32,
        tolerance: f64,
        deviation: *mut f64,
        order: *mut i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Whether an axis is periodic in fact: its knots repeat as NURBS_PERIODIC asks, and so do its points and
    /// weights, bit for bit.
    pub fn nurbs_detect_periodic(g: *const nurbs, axis: i32, periodic: *mut i32) -> nurbs_status;
    // --- Degree and form
    /// Raises the degree along an axis without changing the shape (Prautzsch 1984).
    pub fn nurbs_elevate(g: *const nurbs, axis: i32, times: i32, out: *mut *mut nurbs) -> nurbs_status;
    /// Turns an axis round: the result at -t is g at t, exactly.
    pub fn nurbs_reverse(g: *const nurbs, axis: i32, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    /// Puts the axes in another order: axis k of the result is axis permutation\[k\] of g.
    pub fn nurbs_transpose(g: *const nurbs, permutation: *const i32, out: *mut *mut nurbs) -> nurbs_status;
    /// Moves the domain \[a, b\] of an axis to \[lower, upper\] by the affine map t -\> lower + (t - a)
    /// (upper - lower) / (b - a).
    pub fn nurbs_reparametrize(
        g: *const nurbs,
        axis: i32,
        lower: f64,
        upper: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The same spline with weights: a polynomial one gets weights of 1; any other is returned as it is.
    pub fn nurbs_make_rational(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    /// The homogeneous points (w x, w y, ..., w) of a spline as the points of a polynomial spline of
    /// dimension dim + 1; the weights of a polynomial g are 1.
    pub fn nurbs_to_homogeneous(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    /// The rational spline of dimension dim - 1 whose homogeneous points are the points of a polynomial
    /// spline, as of nurbs_create_homogeneous(): the last coordinate becomes the weight.
    pub fn nurbs_from_homogeneous(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    /// Divides all weights by the one of largest magnitude, which becomes 1; if all are equal they are
    /// dropped, and the result is polynomial.
    pub fn nurbs_normalize_weights(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    /// Changes the parameter of an axis by a rational linear map of its domain \[a, b\] to itself, which
    /// keeps the shape and changes the weights (Lee & Lucian 1991; Piegl & Tiller 6.4).
    pub fn nurbs_reparametrize_moebius(
        g: *const nurbs,
        axis: i32,
        ratio: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_reparametrize_moebius() with the ratio w(a) / w(b), so that the weights at both ends of the
    /// domain of an axis are the same to (4 p + 8) eps.
    pub fn nurbs_equalize_end_weights(g: *const nurbs, axis: i32, out: *mut *mut nurbs) -> nurbs_status;
    // --- Calculus
    /// Values of the polar form (blossom) of a polynomial piece (Ramshaw 1989): the symmetric function of p
    /// arguments, affine in each of them, that at p equal arguments is the spline.
    pub fn nurbs_blossom(
        g: *const nurbs,
        params: *const f64,
        count: i64,
        args: *const f64,
        values: *mut f64,
        flags: u32,
    ) -> nurbs_status;
    /// The partial derivative of a spline along an axis, as a spline (hodograph).
    pub fn nurbs_derivative(g: *const nurbs, axis: i32, order: i32, out: *mut *mut nurbs) -> nurbs_status;
    /// The derivative of a spline with respect to a knot, as a spline of the same parameters: C changes by h
    /// times the result, to first order, if knot t_k of an axis is moved by h and everything else stays.
    pub fn nurbs_eval_knot_derivative(
        g: *const nurbs,
        axis: i32,
        knot: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The integral of a polynomial spline along an axis from the lower end a of its domain.
    pub fn nurbs_antiderivative(g: *const nurbs, axis: i32, out: *mut *mut nurbs) -> nurbs_status;
    /// The pointwise product of two splines over the same domain on every axis: component by component, where
    /// one of them may have dimension 1 and multiplies all components of the other; or the dot or cross
    /// product.
    pub fn nurbs_product(a: *const nurbs, b: *const nurbs, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    /// nurbs_product() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_product_with(
        a: *const nurbs,
        b: *const nurbs,
        flags: u32,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The curve g(f(t)): a curve g over another parameter, or the curve in space that a curve f in the
    /// parameter space of a surface or volume g traces on it.
    pub fn nurbs_compose(g: *const nurbs, f: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    /// nurbs_compose() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_compose_with(
        g: *const nurbs,
        f: *const nurbs,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The linear combination alpha a(t) + beta b(t) of two splines over the same domain on every axis.
    pub fn nurbs_sum(
        a: *const nurbs,
        alpha: f64,
        b: *const nurbs,
        beta: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The C^1 piecewise cubic curve through points with given derivatives, as a spline with double knots:
    /// its control points are the Bezier points P_i - h_(i-1) T_i / 3 and P_i + h_i T_i / 3 next to each
    /// point, and the two ends, each within 2 eps of the sum of its terms.
    pub fn nurbs_create_hermite(
        n: i64,
        params: *const f64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tangents: *const f64,
        tangent_stride: i64,
        tangent_component_stride: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The points and derivatives of a C^1 piecewise cubic at the ends of its non-empty spans, from which
    /// nurbs_create_hermite() makes the same curve: clamped, with double knots.
    ///
    /// May be null: `params`, `points`, `tangents`, `count`.
    pub fn nurbs_to_hermite(
        g: *const nurbs,
        cap: i64,
        params: *mut f64,
        points: *mut f64,
        tangents: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The power basis of every polynomial piece of a spline: on the piece over the span \[a, b\] of each
    /// axis.
    ///
    /// May be null: `coefficients`, `breaks`, `piece_counts`, `count`.
    pub fn nurbs_to_power(
        g: *const nurbs,
        cap: i64,
        coefficients: *mut f64,
        breaks: *mut f64,
        piece_counts: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// A spline from the power basis of its pieces, as nurbs_to_power() gives it.
    pub fn nurbs_create_power(
        axes: i32,
        degrees: *const i32,
        piece_counts: *const i64,
        breaks: *const f64,
        break_count: i64,
        dim: i32,
        coefficients: *const f64,
        coefficient_stride: i64,
        coefficient_component_stride: i64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The matrix that takes the coefficients of a polynomial over \[0, 1\] in one basis to those in another:
    /// coefficient i of `to` is sum_j M_ij \* coefficient j of `from`.
    pub fn nurbs_basis_matrix(from: i32, to: i32, degree: i32, size: i64, matrix: *mut f64) -> nurbs_status;
    // --- Interpolation
    /// Parameters of points from the distances between them.
    pub fn nurbs_parametrize(
        axes: i32,
        counts: *const i64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        rule: i32,
        exponent: f64,
        flags: u32,
        params: *mut f64,
    ) -> nurbs_status;
    /// Parameters that do not depend on the points: where the basis functions are largest.
    pub fn nurbs_params_universal(degree: i32, count: i64, params: *mut f64) -> nurbs_status;
    /// The spline of given degrees through points on a grid of parameters.
    ///
    /// May be null: `ends`, `residual`.
    pub fn nurbs_interpolate(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        params: *const f64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        ends: *const i32,
        flags: u32,
        residual: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The spline over given knots through points on a grid of parameters.
    pub fn nurbs_interpolate_over_knots(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        params: *const f64,
        knots: *const f64,
        knot_count: i64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The spline through points on a grid with given derivatives at the ends of axes.
    ///
    /// May be null: `orders`, `ends`.
    pub fn nurbs_interpolate_derivatives(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        params: *const f64,
        orders: *const i32,
        dim: i32,
        values: *const f64,
        value_stride: i64,
        value_component_stride: i64,
        ends: *const i32,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The curve with given points and derivatives, of any orders at any parameters.
    ///
    /// May be null: `orders`, `knots`.
    pub fn nurbs_curve_interpolate(
        degree: i32,
        n: i64,
        params: *const f64,
        orders: *const i32,
        dim: i32,
        targets: *const f64,
        target_stride: i64,
        target_component_stride: i64,
        knots: *const f64,
        knot_count: i64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The lengths of the tangents of which nurbs_curve_interpolate() is given only the directions.
    ///
    /// May be null: `orders`, `knots`.
    pub fn nurbs_tangent_lengths(
        degree: i32,
        n: i64,
        params: *const f64,
        orders: *const i32,
        dim: i32,
        targets: *const f64,
        target_stride: i64,
        target_component_stride: i64,
        knots: *const f64,
        knot_count: i64,
        flags: u32,
        lengths: *mut f64,
    ) -> nurbs_status;
    /// Derivatives at the points of a curve, each from a few points near it.
    pub fn nurbs_tangents(
        rule: i32,
        n: i64,
        params: *const f64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
        tangents: *mut f64,
        tangent_stride: i64,
        tangent_component_stride: i64,
    ) -> nurbs_status;
    // --- Fitting
    /// Fills a struct with zeros and its size.
    pub fn nurbs_data_init(data: *mut nurbs_data, struct_size: i64) -> nurbs_status;
    /// Statistics of no data, for given degrees, breaks, dimension and scales.
    pub fn nurbs_statistics_create(
        axes: i32,
        degrees: *const i32,
        break_counts: *const i64,
        breaks: *const f64,
        break_total: i64,
        dim: i32,
        value_scale: f64,
        weight_scale: f64,
        out: *mut *mut nurbs_statistics,
    ) -> nurbs_status;
    /// Statistics with more data: the sum of given statistics and those of the data.
    pub fn nurbs_statistics_add(
        statistics: *const nurbs_statistics,
        data: *const nurbs_data,
        out: *mut *mut nurbs_statistics,
    ) -> nurbs_status;
    /// nurbs_statistics_add() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_statistics_add_with(
        statistics: *const nurbs_statistics,
        data: *const nurbs_data,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_statistics,
    ) -> nurbs_status;
    /// The sum of statistics, some of which may be subtracted.
    ///
    /// May be null: `signs`.
    pub fn nurbs_statistics_merge(
        count: i64,
        parts: *const *const nurbs_statistics,
        signs: *const i32,
        out: *mut *mut nurbs_statistics,
    ) -> nurbs_status;
    /// Another handle on the same statistics, in constant time.
    pub fn nurbs_statistics_clone(
        statistics: *const nurbs_statistics,
        out: *mut *mut nurbs_statistics,
    ) -> nurbs_status;
    /// Frees a handle on statistics.
    ///
    /// May be null: `statistics`.
    pub fn nurbs_statistics_destroy(statistics: *mut nurbs_statistics);
    /// How much data statistics hold.
    ///
    /// May be null: `axes`, `dim`, `count`, `cells`, `weight`.
    pub fn nurbs_statistics_size(
        statistics: *const nurbs_statistics,
        axes: *mut i32,
        dim: *mut i32,
        count: *mut i64,
        cells: *mut i64,
        weight: *mut f64,
    ) -> nurbs_status;
    /// Statistics as bytes, to be kept or sent.
    ///
    /// May be null: `bytes`, `length`.
    pub fn nurbs_statistics_to_bytes(
        statistics: *const nurbs_statistics,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
    ) -> nurbs_status;
    /// Statistics from the bytes of nurbs_statistics_to_bytes().
    pub fn nurbs_statistics_from_bytes(
        bytes: *const c_void,
        size: i64,
        out: *mut *mut nurbs_statistics,
    ) -> nurbs_status;
    /// Fills an options struct with the defaults.
    pub fn nurbs_fit_options_init(options: *mut nurbs_fit_options, struct_size: i64) -> nurbs_status;
    /// The spline over given knots that is closest to the data of statistics.
    ///
    /// May be null: `options`, `report`.
    pub fn nurbs_fit(
        statistics: *const nurbs_statistics,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        flags: u32,
        options: *const nurbs_fit_options,
        report: *mut nurbs_fit_report,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_fit() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `report`, `call`.
    pub fn nurbs_fit_with(
        statistics: *const nurbs_statistics,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        flags: u32,
        options: *const nurbs_fit_options,
        report: *mut nurbs_fit_report,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The spline over given knots that is closest to data.
    ///
    /// May be null: `options`, `report`.
    pub fn nurbs_fit_points(
        data: *const nurbs_data,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        flags: u32,
        options: *const nurbs_fit_options,
        report: *mut nurbs_fit_report,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_fit_points() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `report`, `call`.
    pub fn nurbs_fit_points_with(
        data: *const nurbs_data,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        flags: u32,
        options: *const nurbs_fit_options,
        report: *mut nurbs_fit_report,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Pointwise standard errors of a fit.
    pub fn nurbs_fit_errors(
        statistics: *const nurbs_statistics,
        g: *const nurbs,
        penalty_order: i32,
        lambda: f64,
        sigma: f64,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        flags: u32,
        errors: *mut f64,
    ) -> nurbs_status;
    /// nurbs_fit_errors() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_fit_errors_with(
        statistics: *const nurbs_statistics,
        g: *const nurbs,
        penalty_order: i32,
        lambda: f64,
        sigma: f64,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        flags: u32,
        errors: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// What NURBS_SMOOTHING_GCV and NURBS_SMOOTHING_REML compare, for each of some factors of the penalty.
    pub fn nurbs_fit_criteria(
        statistics: *const nurbs_statistics,
        g: *const nurbs,
        penalty_order: i32,
        n: i64,
        lambdas: *const f64,
        values: *mut f64,
    ) -> nurbs_status;
    /// nurbs_fit_criteria() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_fit_criteria_with(
        statistics: *const nurbs_statistics,
        g: *const nurbs,
        penalty_order: i32,
        n: i64,
        lambdas: *const f64,
        values: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// A spline with few control points from which no datum is farther than a tolerance.
    ///
    /// May be null: `domain`, `options`, `report`.
    pub fn nurbs_fit_tolerance(
        data: *const nurbs_data,
        degrees: *const i32,
        domain: *const f64,
        tolerance: f64,
        max_count: i64,
        flags: u32,
        options: *const nurbs_fit_options,
        report: *mut nurbs_fit_report,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_fit_tolerance() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `domain`, `options`, `report`, `call`.
    pub fn nurbs_fit_tolerance_with(
        data: *const nurbs_data,
        degrees: *const i32,
        domain: *const f64,
        tolerance: f64,
        max_count: i64,
        flags: u32,
        options: *const nurbs_fit_options,
        report: *mut nurbs_fit_report,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A polynomial spline with few control points, proven to be within a tolerance of another spline.
    ///
    /// May be null: `degrees`, `bound`.
    pub fn nurbs_approximate(
        g: *const nurbs,
        degrees: *const i32,
        tolerance: f64,
        max_count: i64,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_approximate() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `degrees`, `bound`, `call`.
    pub fn nurbs_approximate_with(
        g: *const nurbs,
        degrees: *const i32,
        tolerance: f64,
        max_count: i64,
        bound: *mut f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A spline from which nurbs_fit_cloud() can begin, found from points without parameters.
    pub fn nurbs_cloud_start(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        n: i64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Fills an options struct with the defaults.
    pub fn nurbs_cloud_options_init(options: *mut nurbs_cloud_options, struct_size: i64) -> nurbs_status;
    /// The spline, over the knots of a start, that is closest to points without parameters.
    ///
    /// May be null: `weights`, `options`, `report`.
    pub fn nurbs_fit_cloud(
        g: *const nurbs,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        weights: *const f64,
        weight_stride: i64,
        options: *const nurbs_cloud_options,
        report: *mut nurbs_cloud_report,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_fit_cloud() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `weights`, `options`, `report`, `call`.
    pub fn nurbs_fit_cloud_with(
        g: *const nurbs,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        weights: *const f64,
        weight_stride: i64,
        options: *const nurbs_cloud_options,
        report: *mut nurbs_cloud_report,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Continuity
    /// Continuity at the knots of an axis: one row for each distinct knot inside the domain, and one more,
    /// named by the upper end of the domain, for the seam of an axis that is periodic or whose ends meet
    /// within position_tolerance.
    ///
    /// May be null: `knots`, `knot_orders`, `orders`, `geometric_orders`, `position_gaps`, `angles`,
    /// `curvature_gaps`, `count`.
    pub fn nurbs_continuity(
        g: *const nurbs,
        axis: i32,
        position_tolerance: f64,
        derivative_tolerance: f64,
        angle_tolerance: f64,
        cap: i64,
        knots: *mut f64,
        knot_orders: *mut i32,
        orders: *mut i32,
        geometric_orders: *mut i32,
        position_gaps: *mut f64,
        angles: *mut f64,
        curvature_gaps: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// Continuity of two curves at one end of each, on the way along a to its end and from the end of b along
    /// b: a parameter that runs the other way changes its sign.
    ///
    /// May be null: `order`, `geometric`, `position_gap`, `angle`, `curvature_gap`.
    pub fn nurbs_continuity_between(
        a: *const nurbs,
        end_a: i32,
        b: *const nurbs,
        end_b: i32,
        position_tolerance: f64,
        derivative_tolerance: f64,
        angle_tolerance: f64,
        order: *mut i32,
        geometric: *mut i32,
        position_gap: *mut f64,
        angle: *mut f64,
        curvature_gap: *mut f64,
    ) -> nurbs_status;
    // --- Reduction
    /// Encloses the largest distance sup |f(t) - g(t)| of two splines over their domain, both limits at jumps
    /// included.
    ///
    /// May be null: `at_least`, `at_most`.
    pub fn nurbs_deviation(
        f: *const nurbs,
        g: *const nurbs,
        at_least: *mut f64,
        at_most: *mut f64,
    ) -> nurbs_status;
    /// Removes copies of a knot as long as the shape moves by at most a tolerance (Tiller 1992).
    ///
    /// May be null: `removed`, `bound`.
    pub fn nurbs_remove_knot(
        g: *const nurbs,
        axis: i32,
        knot: f64,
        times: i32,
        tolerance: f64,
        removed: *mut i32,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Removes as many knots inside the domain as a tolerance allows (Lyche & Morken 1988; Piegl & Tiller
    /// A9.8): always the one whose removal moves the shape least, with the moves added up span by span.
    ///
    /// May be null: `bound`.
    pub fn nurbs_reduce_knots(
        g: *const nurbs,
        axis: i32,
        tolerance: f64,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_reduce_knots() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `bound`, `call`.
    pub fn nurbs_reduce_knots_with(
        g: *const nurbs,
        axis: i32,
        tolerance: f64,
        bound: *mut f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Lowers the degree along an axis.
    ///
    /// May be null: `bound`.
    pub fn nurbs_reduce_degree(
        g: *const nurbs,
        axis: i32,
        times: i32,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_reduce_degree() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `bound`, `call`.
    pub fn nurbs_reduce_degree_with(
        g: *const nurbs,
        axis: i32,
        times: i32,
        bound: *mut f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The simplest spline within a tolerance: weights are dropped if they may be, the degree of each axis is
    /// lowered by nurbs_reduce_degree() as long as that stays within and leaves no more control points (but
    /// not below 1, where steps would begin), and knots are removed by nurbs_reduce_knots().
    ///
    /// May be null: `bound`.
    pub fn nurbs_simplify(
        g: *const nurbs,
        tolerance: f64,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_simplify() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `bound`, `call`.
    pub fn nurbs_simplify_with(
        g: *const nurbs,
        tolerance: f64,
        bound: *mut f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Transformations
    /// Applies the affine map x -\> A x + b to the control points, and with them to the shape.
    ///
    /// May be null: `translation`.
    pub fn nurbs_transform(
        g: *const nurbs,
        out_dim: i32,
        matrix: *const f64,
        translation: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Applies a projective map to the homogeneous control points h = (w x, w y, ..., w).
    pub fn nurbs_transform_projective(
        g: *const nurbs,
        out_dim: i32,
        matrix: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The mirror image in the plane (in 2D the line, in general the hyperplane) through a point: x -\> x - 2
    /// n (n . (x - point)) / (n . n).
    pub fn nurbs_mirror(
        g: *const nurbs,
        point: *const f64,
        normal: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Projects a spline to the plane (line, hyperplane) through a point, along a direction: x -\> x - d (n .
    /// (x - point)) / (n . d).
    ///
    /// May be null: `direction`.
    pub fn nurbs_project_to_plane(
        g: *const nurbs,
        point: *const f64,
        normal: *const f64,
        direction: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Projects a spline from an eye to the plane (line, hyperplane) through a point, in perspective: x -\>
    /// eye + (x - eye) (n . (point - eye)) / (n . (x - eye)).
    pub fn nurbs_project_from(
        g: *const nurbs,
        eye: *const f64,
        point: *const f64,
        normal: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Lines, conics and helices
    /// The segment (1 - t) a + t b, of degree 1.
    pub fn nurbs_curve_line(dim: i32, a: *const f64, b: *const f64, out: *mut *mut nurbs) -> nurbs_status;
    /// The polyline through n points, of degree 1, with one knot for each point.
    ///
    /// May be null: `params`.
    pub fn nurbs_curve_polyline(
        n: i64,
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        params: *const f64,
        param_stride: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A closed regular polygon, of degree 1, counterclockwise about the axis.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_curve_polygon(
        dim: i32,
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        sides: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A closed rectangle with sides along X and Y whose corners are rounded by quarter circles, of degree 2,
    /// counterclockwise about the axis, beginning at the start of its lower side.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_curve_rounded_rectangle(
        dim: i32,
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        width: f64,
        height: f64,
        corner_radius: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The full circle, from the direction X counterclockwise about the axis: nurbs_curve_arc() over a full
    /// turn.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_curve_circle(
        dim: i32,
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A circular arc: center + radius (X cos a + Y sin a), a from start to start + sweep.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_curve_arc(
        dim: i32,
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        start: f64,
        sweep: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The circular arc from a through b to c.
    pub fn nurbs_curve_arc_through(
        dim: i32,
        a: *const f64,
        b: *const f64,
        c: *const f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The circular arc that leaves a in the direction of a tangent and ends at b.
    pub fn nurbs_curve_arc_tangent(
        dim: i32,
        a: *const f64,
        tangent: *const f64,
        b: *const f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// An elliptic arc: center + radius_x X cos a + radius_y Y sin a, a from start to start + sweep; a is the
    /// eccentric angle, not that of the point seen from the centre.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_curve_ellipse(
        dim: i32,
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius_x: f64,
        radius_y: f64,
        start: f64,
        sweep: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A parabolic arc, polynomial of degree 2 over \[start, end\]: vertex + t^2 / (4 focal_length) X + t Y,
    /// so that the parameter is the coordinate along Y.
    ///
    /// May be null: `vertex`, `axis`, `x`.
    pub fn nurbs_curve_parabola(
        dim: i32,
        vertex: *const f64,
        axis: *const f64,
        x: *const f64,
        focal_length: f64,
        start: f64,
        end: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// An arc of the branch of a hyperbola that opens to X: center + radius_x X cosh u + radius_y Y sinh u, u
    /// from start to end.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_curve_hyperbola(
        dim: i32,
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius_x: f64,
        radius_y: f64,
        start: f64,
        end: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The conic with a control triangle and a shape factor C_sf = w1^2 / (w0 w2): degree 2, the weights 1,
    /// sqrt(C_sf), 1.
    pub fn nurbs_curve_conic_triangle(
        dim: i32,
        p0: *const f64,
        p1: *const f64,
        p2: *const f64,
        shape_factor: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The conic arc that leaves a in one direction and arrives at b in another one, and whose shoulder point
    /// is at the part rho of the way from the middle of the chord to the point where the tangents meet: an
    /// ellipse where rho \< 1/2, a parabola where rho = 1/2, a hyperbola where rho \> 1/2.
    pub fn nurbs_curve_conic_shoulder(
        dim: i32,
        a: *const f64,
        tangent_a: *const f64,
        b: *const f64,
        tangent_b: *const f64,
        rho: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The conic arc from a to b with given tangent lines at both ends that passes through a third point;
    /// degree 2, in pieces of which none turns by more than the form allows in the affine picture in which it
    /// is a circle.
    pub fn nurbs_curve_conic_point(
        dim: i32,
        a: *const f64,
        tangent_a: *const f64,
        b: *const f64,
        tangent_b: *const f64,
        point: *const f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The conic arc through five points, from the first to the last in this order; tangents at its ends by
    /// Pascal's theorem, pieces as for nurbs_curve_conic_point().
    pub fn nurbs_curve_conic_through(
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Kind and axes of the conic A x^2 + B x y + C y^2 + D x + E y + F = 0, from its principal axes.
    pub fn nurbs_conic_axes(
        coefficients: *const f64,
        r#type: *mut i32,
        origin: *mut f64,
        x: *mut f64,
        sizes: *mut f64,
    ) -> nurbs_status;
    /// An arc of the conic with an implicit equation, as described by nurbs_conic_axes(): of an ellipse as
    /// nurbs_curve_ellipse() with start and sweep = end - start, of a parabola and a hyperbola (the branch
    /// towards x) as nurbs_curve_parabola() and nurbs_curve_hyperbola() from start to end.
    pub fn nurbs_curve_conic_implicit(
        coefficients: *const f64,
        start: f64,
        end: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// An arc of the conic with a focus, a directrix and an eccentricity e: the points whose distance from
    /// the focus is e times that from the directrix, at angles about the focus from start to start + sweep,
    /// counted from the foot of the perpendicular to the directrix; r(a) = e d / (1 + e cos a) where d =
    /// |foot - focus|.
    ///
    /// May be null: `axis`.
    pub fn nurbs_curve_conic_focus(
        dim: i32,
        focus: *const f64,
        axis: *const f64,
        foot: *const f64,
        eccentricity: f64,
        start: f64,
        sweep: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Shape factor C_sf = w1^2 / (w0 w2) and kind of a conic segment: a curve of degree 2 with one
    /// polynomial piece.
    pub fn nurbs_curve_shape_factor(g: *const nurbs, factor: *mut f64, r#type: *mut i32) -> nurbs_status;
    /// A circular helix or Archimedean spiral to a tolerance.
    ///
    /// May be null: `origin`, `axis`, `x`, `error`.
    pub fn nurbs_curve_helix(
        dim: i32,
        origin: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        growth: f64,
        pitch: f64,
        start: f64,
        turns: f64,
        tolerance: f64,
        error: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Surfaces and volumes from curves
    /// Moves a curve or surface along a vector: (u, v) -\> g(u) + v vector, the new axis last, of degree 1
    /// over \[0, 1\].
    pub fn nurbs_extrude(g: *const nurbs, vector: *const f64, out: *mut *mut nurbs) -> nurbs_status;
    /// Turns a curve or surface in space about an axis, the angle as a new axis 0 over \[0, 1\].
    ///
    /// May be null: `point`, `axis`.
    pub fn nurbs_revolve(
        g: *const nurbs,
        point: *const f64,
        axis: *const f64,
        sweep: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The surface of straight lines between curves, or the volume between surfaces, with a new last axis v
    /// over \[0, 1\].
    pub fn nurbs_ruled(a: *const nurbs, b: *const nurbs, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    /// The translational sweep alpha a(u) + beta b(v), the axes of b after those of a.
    pub fn nurbs_tensor_sum(
        a: *const nurbs,
        alpha: f64,
        b: *const nurbs,
        beta: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The product a(u) b(v), component by component, the axes of b after those of a; one of them may have
    /// dimension 1 and multiplies all components of the other.
    pub fn nurbs_tensor_product(a: *const nurbs, b: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    /// A swung surface: (u, v) -\> (scale r(v) x(u), scale r(v) y(u), z(v)) for the trajectory (x, y) and the
    /// profile (r, z).
    pub fn nurbs_surface_swung(
        trajectory: *const nurbs,
        profile: *const nurbs,
        scale: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The parallelogram origin + s u + t v, of degree 1 on both axes.
    ///
    /// May be null: `origin`.
    pub fn nurbs_surface_plane(
        dim: i32,
        origin: *const f64,
        u: *const f64,
        v: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The bilinear patch over four corners, of degree 1 on both axes.
    pub fn nurbs_surface_bilinear(
        dim: i32,
        corners: *const f64,
        corner_stride: i64,
        corner_component_stride: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The trilinear volume over eight corners, of degree 1 on all axes.
    pub fn nurbs_volume_trilinear(
        dim: i32,
        corners: *const f64,
        corner_stride: i64,
        corner_component_stride: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The whole sphere by longitude (axis 0) and latitude (axis 1, from the pole -Z to the pole Z); its
    /// poles are collapsed edges, its seam closes bit for bit.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_surface_sphere(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A patch of a sphere between two meridians and two circles of latitude.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_surface_spherical_patch(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        start: f64,
        sweep: f64,
        south: f64,
        north: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The sphere without poles: six patches of degree 4 x 4 over the faces of a cube, each bounded by arcs
    /// of great circles, without a singular point (after Cobb 1988).
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_surface_sphere_patches(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        flags: u32,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    /// The whole ellipsoid with semi-axes along X, Y and Z, parametrized as nurbs_surface_sphere().
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_surface_ellipsoid(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius_x: f64,
        radius_y: f64,
        radius_z: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A circular cylinder: origin + radius (X cos a + Y sin a) + v height Z.
    ///
    /// May be null: `origin`, `axis`, `x`.
    pub fn nurbs_surface_cylinder(
        origin: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        height: f64,
        start: f64,
        sweep: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A circular cone or its frustum, parametrized as nurbs_surface_cylinder(), with a radius that changes
    /// from base_radius at the origin to top_radius at origin + height Z.
    ///
    /// May be null: `origin`, `axis`, `x`.
    pub fn nurbs_surface_cone(
        origin: *const f64,
        axis: *const f64,
        x: *const f64,
        base_radius: f64,
        top_radius: f64,
        height: f64,
        start: f64,
        sweep: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A torus: (R + r cos b) (X cos a + Y sin a) + r sin b Z about the centre.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_surface_torus(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        major_radius: f64,
        minor_radius: f64,
        start: f64,
        sweep: f64,
        tube_start: f64,
        tube_sweep: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A bowl of the elliptic paraboloid Z = height ((X / radius_x)^2 + (Y / radius_y)^2), from the vertex, a
    /// collapsed edge, at v = 0 to the rim at v = 1, Z = height v^2.
    ///
    /// May be null: `vertex`, `axis`, `x`.
    pub fn nurbs_surface_paraboloid(
        vertex: *const f64,
        axis: *const f64,
        x: *const f64,
        radius_x: f64,
        radius_y: f64,
        height: f64,
        start: f64,
        sweep: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A saddle of the hyperbolic paraboloid Z = height ((X / radius_x)^2 - (Y / radius_y)^2) over the
    /// rectangle |X| \<= radius_x, |Y| \<= radius_y: polynomial, of degree 2 on both axes, X along axis 0 and
    /// Y along axis 1.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_surface_saddle(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius_x: f64,
        radius_y: f64,
        height: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// A band of the hyperboloid (X / radius_x)^2 + (Y / radius_y)^2 - (Z / radius_z)^2 = 1 between two
    /// planes Z = bottom and Z = top; or with NURBS_TWO_SHEETS of the sheets (Z / radius_z)^2 - (X /
    /// radius_x)^2 - (Y / radius_y)^2 = 1, both planes being on one sheet: radius_z \<= bottom or top \<=
    /// -radius_z.
    ///
    /// May be null: `center`, `axis`, `x`.
    pub fn nurbs_surface_hyperboloid(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius_x: f64,
        radius_y: f64,
        radius_z: f64,
        bottom: f64,
        top: f64,
        start: f64,
        sweep: f64,
        form: i32,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Surfaces and volumes from their boundaries
    /// The boundaries of a surface or volume, in the order above, each bit for bit what nurbs_iso() gives;
    /// named "0-", "0+", "1-", "1+", and so on.
    pub fn nurbs_boundaries(g: *const nurbs, out: *mut *mut nurbs_list) -> nurbs_status;
    /// The bilinearly blended Coons surface of four curves (Coons 1967): with u and v mapped to \[0, 1\].
    pub fn nurbs_surface_coons(
        boundaries: *const *const nurbs,
        tolerance: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The bicubically blended Coons surface of four curves and the derivatives across them.
    ///
    /// May be null: `cross`, `twists`, `bound`.
    pub fn nurbs_surface_coons_hermite(
        boundaries: *const *const nurbs,
        cross: *const *const nurbs,
        twist: i32,
        twists: *const f64,
        tolerance: f64,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// What does not meet at the corners of a surface to be: corners in the order (u0, v0), (u0, v1), (u1,
    /// v0), (u1, v1).
    ///
    /// May be null: `cross`, `tangents`, `twists`.
    pub fn nurbs_coons_gaps(
        boundaries: *const *const nurbs,
        cross: *const *const nurbs,
        positions: *mut f64,
        tangents: *mut f64,
        twists: *mut f64,
    ) -> nurbs_status;
    /// The volume that blends six faces linearly (Gordon & Hall 1973): the sum of the blends of opposite
    /// faces, less those of the twelve edges, plus that of the eight corners.
    pub fn nurbs_volume_coons(
        faces: *const *const nurbs,
        tolerance: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Recognition
    /// Whether a curve is a line or a conic, or a surface a plane, sphere, cylinder, cone or torus.
    ///
    /// May be null: `placement`, `sizes`, `deviation`.
    pub fn nurbs_recognize(
        g: *const nurbs,
        tolerance: f64,
        shape: *mut i32,
        placement: *mut f64,
        sizes: *mut f64,
        deviation: *mut f64,
    ) -> nurbs_status;
    /// nurbs_recognize() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `placement`, `sizes`, `deviation`, `call`.
    pub fn nurbs_recognize_with(
        g: *const nurbs,
        tolerance: f64,
        shape: *mut i32,
        placement: *mut f64,
        sizes: *mut f64,
        deviation: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    // --- Distances and closest points
    /// The points of a spline that are nearest to given points.
    ///
    /// May be null: `range`, `params`, `feet`, `distances`, `status`.
    pub fn nurbs_closest_points(
        g: *const nurbs,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        range: *const f64,
        tolerance: f64,
        budget: i64,
        params: *mut f64,
        param_stride: i64,
        param_component_stride: i64,
        feet: *mut f64,
        foot_stride: i64,
        foot_component_stride: i64,
        distances: *mut f64,
        distance_stride: i64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    /// nurbs_closest_points() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_closest_points_with(
        g: *const nurbs,
        query: *const nurbs_closest_query,
        answer: *const nurbs_closest_answer,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The points of a spline that are farthest from given points.
    ///
    /// May be null: `range`, `params`, `feet`, `distances`, `status`.
    pub fn nurbs_farthest_points(
        g: *const nurbs,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        range: *const f64,
        tolerance: f64,
        budget: i64,
        params: *mut f64,
        param_stride: i64,
        param_component_stride: i64,
        feet: *mut f64,
        foot_stride: i64,
        foot_component_stride: i64,
        distances: *mut f64,
        distance_stride: i64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    /// nurbs_farthest_points() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_farthest_points_with(
        g: *const nurbs,
        query: *const nurbs_closest_query,
        answer: *const nurbs_closest_answer,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Local minima of the distance from given points, each reached by a descent from a guess.
    ///
    /// May be null: `params`, `feet`, `distances`, `status`.
    pub fn nurbs_closest_local(
        g: *const nurbs,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        guesses: *const f64,
        guess_stride: i64,
        guess_component_stride: i64,
        params: *mut f64,
        param_stride: i64,
        param_component_stride: i64,
        feet: *mut f64,
        foot_stride: i64,
        foot_component_stride: i64,
        distances: *mut f64,
        distance_stride: i64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    /// nurbs_closest_local() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_closest_local_with(
        g: *const nurbs,
        query: *const nurbs_closest_query,
        answer: *const nurbs_closest_answer,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// All local minima of the distance from a point that are within a tolerance of the smallest.
    ///
    /// May be null: `range`, `params`, `distances`, `count`, `status`.
    pub fn nurbs_closest_all(
        g: *const nurbs,
        point: *const f64,
        range: *const f64,
        tolerance: f64,
        budget: i64,
        cap: i64,
        params: *mut f64,
        distances: *mut f64,
        count: *mut i64,
        status: *mut i32,
    ) -> nurbs_status;
    /// nurbs_closest_all() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `range`, `params`, `distances`, `count`, `status`, `call`.
    pub fn nurbs_closest_all_with(
        g: *const nurbs,
        point: *const f64,
        range: *const f64,
        tolerance: f64,
        budget: i64,
        cap: i64,
        params: *mut f64,
        distances: *mut f64,
        count: *mut i64,
        status: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// All critical points of the distance from a point.
    ///
    /// May be null: `range`, `params`, `distances`, `kinds`, `count`, `status`.
    pub fn nurbs_critical_points(
        g: *const nurbs,
        point: *const f64,
        range: *const f64,
        tolerance: f64,
        budget: i64,
        cap: i64,
        params: *mut f64,
        distances: *mut f64,
        kinds: *mut i32,
        count: *mut i64,
        status: *mut i32,
    ) -> nurbs_status;
    /// nurbs_critical_points() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `range`, `params`, `distances`, `kinds`, `count`, `status`, `call`.
    pub fn nurbs_critical_points_with(
        g: *const nurbs,
        point: *const f64,
        range: *const f64,
        tolerance: f64,
        budget: i64,
        cap: i64,
        params: *mut f64,
        distances: *mut f64,
        kinds: *mut i32,
        count: *mut i64,
        status: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Signed distances of points in the plane from a curve: positive to the left of its direction.
    ///
    /// May be null: `params`, `status`.
    pub fn nurbs_curve_signed_distances(
        g: *const nurbs,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tolerance: f64,
        budget: i64,
        distances: *mut f64,
        distance_stride: i64,
        params: *mut f64,
        param_stride: i64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    /// nurbs_curve_signed_distances() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_curve_signed_distances_with(
        g: *const nurbs,
        query: *const nurbs_closest_query,
        answer: *const nurbs_closest_answer,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Proven bounds of the smallest distance between two splines, of any number of axes each.
    ///
    /// May be null: `at_least`, `at_most`, `params_a`, `params_b`, `status`.
    pub fn nurbs_distance(
        a: *const nurbs,
        b: *const nurbs,
        tolerance: f64,
        budget: i64,
        at_least: *mut f64,
        at_most: *mut f64,
        params_a: *mut f64,
        params_b: *mut f64,
        status: *mut i32,
    ) -> nurbs_status;
    /// nurbs_distance() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `at_least`, `at_most`, `params_a`, `params_b`, `status`, `call`.
    pub fn nurbs_distance_with(
        a: *const nurbs,
        b: *const nurbs,
        tolerance: f64,
        budget: i64,
        at_least: *mut f64,
        at_most: *mut f64,
        params_a: *mut f64,
        params_b: *mut f64,
        status: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Proven bounds of the Hausdorff distances of two splines as sets of points.
    ///
    /// May be null: `at_least`, `at_most`, `params_a`, `params_b`, `status`.
    pub fn nurbs_hausdorff_distance(
        a: *const nurbs,
        b: *const nurbs,
        tolerance: f64,
        budget: i64,
        at_least: *mut f64,
        at_most: *mut f64,
        params_a: *mut f64,
        params_b: *mut f64,
        status: *mut i32,
    ) -> nurbs_status;
    /// nurbs_hausdorff_distance() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `at_least`, `at_most`, `params_a`, `params_b`, `status`, `call`.
    pub fn nurbs_hausdorff_distance_with(
        a: *const nurbs,
        b: *const nurbs,
        tolerance: f64,
        budget: i64,
        at_least: *mut f64,
        at_most: *mut f64,
        params_a: *mut f64,
        params_b: *mut f64,
        status: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    // --- Lengths, areas and moments
    /// The length of a curve or of a part of it.
    ///
    /// May be null: `range`, `error`.
    pub fn nurbs_curve_length(
        g: *const nurbs,
        range: *const f64,
        relative_tolerance: f64,
        length: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    /// nurbs_curve_length() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `range`, `error`, `call`.
    pub fn nurbs_curve_length_with(
        g: *const nurbs,
        range: *const f64,
        relative_tolerance: f64,
        length: *mut f64,
        error: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Lengths from the start of the domain to given parameters.
    pub fn nurbs_curve_lengths(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        relative_tolerance: f64,
        lengths: *mut f64,
        length_stride: i64,
    ) -> nurbs_status;
    /// nurbs_curve_lengths() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_curve_lengths_with(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        relative_tolerance: f64,
        lengths: *mut f64,
        length_stride: i64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Parameters at given lengths from the start of the domain.
    pub fn nurbs_curve_params_at_lengths(
        g: *const nurbs,
        n: i64,
        lengths: *const f64,
        length_stride: i64,
        relative_tolerance: f64,
        params: *mut f64,
        param_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// nurbs_curve_params_at_lengths() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_curve_params_at_lengths_with(
        g: *const nurbs,
        n: i64,
        lengths: *const f64,
        length_stride: i64,
        relative_tolerance: f64,
        params: *mut f64,
        param_stride: i64,
        flags: u32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Divides a curve into parts of equal length, or so that consecutive points have equal distances.
    ///
    /// May be null: `range`, `size`.
    pub fn nurbs_curve_divide(
        g: *const nurbs,
        range: *const f64,
        parts: i64,
        relative_tolerance: f64,
        flags: u32,
        params: *mut f64,
        size: *mut f64,
    ) -> nurbs_status;
    /// nurbs_curve_divide() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `range`, `size`, `call`.
    pub fn nurbs_curve_divide_with(
        g: *const nurbs,
        range: *const f64,
        parts: i64,
        relative_tolerance: f64,
        flags: u32,
        params: *mut f64,
        size: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The area of a surface or of a part of it, in any dimension.
    ///
    /// May be null: `range`, `error`.
    pub fn nurbs_surface_area(
        g: *const nurbs,
        range: *const f64,
        relative_tolerance: f64,
        area: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    /// nurbs_surface_area() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `range`, `error`, `call`.
    pub fn nurbs_surface_area_with(
        g: *const nurbs,
        range: *const f64,
        relative_tolerance: f64,
        area: *mut f64,
        error: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Content, centroid and inertia of a curve as a wire, a surface as a sheet, or a volume as a body.
    ///
    /// May be null: `centroid`, `inertia`, `error`.
    pub fn nurbs_moments(
        g: *const nurbs,
        relative_tolerance: f64,
        content: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    /// nurbs_moments() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `centroid`, `inertia`, `error`, `call`.
    pub fn nurbs_moments_with(
        g: *const nurbs,
        relative_tolerance: f64,
        content: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        error: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Area, centroid and inertia of the region of the plane that closed chains of curves enclose.
    ///
    /// May be null: `centroid`, `inertia`, `error`.
    pub fn nurbs_enclosed_area(
        count: i64,
        curves: *const *const nurbs,
        tolerance: f64,
        relative_tolerance: f64,
        area: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    /// nurbs_enclosed_area() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `centroid`, `inertia`, `error`, `call`.
    pub fn nurbs_enclosed_area_with(
        count: i64,
        curves: *const *const nurbs,
        tolerance: f64,
        relative_tolerance: f64,
        area: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        error: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Volume, centroid and inertia of the body that surfaces enclose.
    ///
    /// May be null: `centroid`, `inertia`, `openness`, `error`.
    pub fn nurbs_enclosed_volume(
        count: i64,
        surfaces: *const *const nurbs,
        relative_tolerance: f64,
        volume: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        openness: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    /// nurbs_enclosed_volume() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `centroid`, `inertia`, `openness`, `error`, `call`.
    pub fn nurbs_enclosed_volume_with(
        count: i64,
        surfaces: *const *const nurbs,
        relative_tolerance: f64,
        volume: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        openness: *mut f64,
        error: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Points and weights for integrals of any function over a spline.
    ///
    /// May be null: `params`, `weights`, `measures`, `count`.
    pub fn nurbs_quadrature(
        g: *const nurbs,
        nodes: i32,
        cap: i64,
        params: *mut f64,
        weights: *mut f64,
        measures: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    // --- Boxes and cones
    /// An axis-aligned box that contains a spline, and all points that evaluation gives of it.
    ///
    /// May be null: `range`, `gap`.
    pub fn nurbs_box(
        g: *const nurbs,
        range: *const f64,
        tolerance: f64,
        lower: *mut f64,
        upper: *mut f64,
        gap: *mut f64,
    ) -> nurbs_status;
    /// A box with axes of its own that contains a spline.
    pub fn nurbs_oriented_box(
        g: *const nurbs,
        tolerance: f64,
        center: *mut f64,
        axes: *mut f64,
        half: *mut f64,
    ) -> nurbs_status;
    /// A cone that contains the directions of all derivatives along an axis.
    ///
    /// May be null: `range`.
    pub fn nurbs_tangent_cone(
        g: *const nurbs,
        axis: i32,
        range: *const f64,
        tolerance: f64,
        direction: *mut f64,
        angle: *mut f64,
    ) -> nurbs_status;
    /// A cone that contains the directions of all normals S_u x S_v of a surface in space.
    ///
    /// May be null: `range`.
    pub fn nurbs_normal_cone(
        g: *const nurbs,
        range: *const f64,
        tolerance: f64,
        direction: *mut f64,
        angle: *mut f64,
    ) -> nurbs_status;
    /// The point of a spline that is farthest in a direction: the largest value of direction . C(t).
    ///
    /// May be null: `range`, `params`, `value`, `bound`.
    pub fn nurbs_extreme_point(
        g: *const nurbs,
        direction: *const f64,
        range: *const f64,
        tolerance: f64,
        params: *mut f64,
        value: *mut f64,
        bound: *mut f64,
    ) -> nurbs_status;
    // --- Features of a shape
    /// Inflections, extrema of curvature, cusps, kinks, jumps and changes of torsion along a curve.
    ///
    /// May be null: `params`, `found`, `values`, `count`, `complete`.
    pub fn nurbs_curve_features(
        g: *const nurbs,
        kinds: u32,
        cap: i64,
        params: *mut f64,
        found: *mut i32,
        values: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// nurbs_curve_features() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `found`, `values`, `count`, `complete`, `call`.
    pub fn nurbs_curve_features_with(
        g: *const nurbs,
        kinds: u32,
        cap: i64,
        params: *mut f64,
        found: *mut i32,
        values: *mut f64,
        count: *mut i64,
        complete: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Local extrema and saddles of a scalar spline f of 1 to 3 axes.
    ///
    /// May be null: `params`, `values`, `found`, `boxes`, `count`, `complete`.
    pub fn nurbs_extrema(
        g: *const nurbs,
        kinds: u32,
        cap: i64,
        params: *mut f64,
        values: *mut f64,
        found: *mut i32,
        boxes: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// nurbs_extrema() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `values`, `found`, `boxes`, `count`, `complete`, `call`.
    pub fn nurbs_extrema_with(
        g: *const nurbs,
        kinds: u32,
        cap: i64,
        params: *mut f64,
        values: *mut f64,
        found: *mut i32,
        boxes: *mut f64,
        count: *mut i64,
        complete: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The pieces of a curve on which it runs one way along a direction.
    ///
    /// May be null: `starts`, `signs`, `count`, `complete`.
    pub fn nurbs_curve_monotone_pieces(
        g: *const nurbs,
        direction: *const f64,
        cap: i64,
        starts: *mut f64,
        signs: *mut i32,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// Whether a curve in the plane is convex: whether it turns one way only, and by at most a full turn.
    pub fn nurbs_curve_convexity(g: *const nurbs, convexity: *mut i32) -> nurbs_status;
    /// How far a spline is from a straight line: a line near the best one, and a proven bound.
    ///
    /// May be null: `origin`, `direction`.
    pub fn nurbs_straightness(
        g: *const nurbs,
        origin: *mut f64,
        direction: *mut f64,
        bound: *mut f64,
    ) -> nurbs_status;
    /// How far a spline in space is from a plane: a plane near the best one, and a proven bound.
    ///
    /// May be null: `origin`, `normal`.
    pub fn nurbs_planarity(
        g: *const nurbs,
        origin: *mut f64,
        normal: *mut f64,
        bound: *mut f64,
    ) -> nurbs_status;
    /// Which axes of a spline close and which of its boundaries collapse, with proven bounds.
    ///
    /// May be null: `closed`, `gaps`, `collapsed`, `sizes`.
    pub fn nurbs_boundary_contacts(
        g: *const nurbs,
        tolerance: f64,
        closed: *mut i32,
        gaps: *mut f64,
        collapsed: *mut i32,
        sizes: *mut f64,
    ) -> nurbs_status;
    /// Places where a curve or surface is singular: C' = 0, or S_u x S_v = 0.
    ///
    /// May be null: `params`, `boxes`, `count`, `complete`.
    pub fn nurbs_singular_points(
        g: *const nurbs,
        tolerance: f64,
        cap: i64,
        params: *mut f64,
        boxes: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// Whether a surface or volume folds over: whether the sign of J changes.
    ///
    /// May be null: `reference`, `positive`, `negative`.
    pub fn nurbs_fold_test(
        g: *const nurbs,
        reference: *const f64,
        result: *mut i32,
        positive: *mut f64,
        negative: *mut f64,
    ) -> nurbs_status;
    /// nurbs_fold_test() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `reference`, `positive`, `negative`, `call`.
    pub fn nurbs_fold_test_with(
        g: *const nurbs,
        reference: *const f64,
        result: *mut i32,
        positive: *mut f64,
        negative: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// nurbs_fold_test() of each polynomial piece by itself.
    ///
    /// May be null: `reference`, `folds`, `signs`, `count`.
    pub fn nurbs_fold_pieces(
        g: *const nurbs,
        reference: *const f64,
        cap: i64,
        folds: *mut i32,
        signs: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    /// nurbs_fold_pieces() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `reference`, `folds`, `signs`, `count`, `call`.
    pub fn nurbs_fold_pieces_with(
        g: *const nurbs,
        reference: *const f64,
        cap: i64,
        folds: *mut i32,
        signs: *mut i32,
        count: *mut i64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    // --- Where shapes meet
    /// Roots of a scalar curve: where f(t) = value.
    ///
    /// May be null: `params`, `kinds`, `ranges`, `count`, `complete`.
    pub fn nurbs_roots(
        g: *const nurbs,
        value: f64,
        tolerance: f64,
        cap: i64,
        params: *mut f64,
        kinds: *mut i32,
        ranges: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// nurbs_roots() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `kinds`, `ranges`, `count`, `complete`, `call`.
    pub fn nurbs_roots_with(
        g: *const nurbs,
        value: f64,
        tolerance: f64,
        cap: i64,
        params: *mut f64,
        kinds: *mut i32,
        ranges: *mut f64,
        count: *mut i64,
        complete: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Where a curve meets a line, plane, conic, sphere, quadric or other set f(x) = 0 of a polynomial f.
    ///
    /// May be null: `params`, `kinds`, `ranges`, `count`, `complete`.
    pub fn nurbs_curve_level(
        g: *const nurbs,
        degree: i32,
        coefficients: *const f64,
        tolerance: f64,
        cap: i64,
        params: *mut f64,
        kinds: *mut i32,
        ranges: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// nurbs_curve_level() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `kinds`, `ranges`, `count`, `complete`, `call`.
    pub fn nurbs_curve_level_with(
        g: *const nurbs,
        degree: i32,
        coefficients: *const f64,
        tolerance: f64,
        cap: i64,
        params: *mut f64,
        kinds: *mut i32,
        ranges: *mut f64,
        count: *mut i64,
        complete: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Where two curves meet: all places at which they come as near as the tolerance.
    ///
    /// May be null: `params_a`, `params_b`, `kinds`, `ranges_a`, `ranges_b`, `count`, `complete`.
    pub fn nurbs_curve_intersections(
        a: *const nurbs,
        b: *const nurbs,
        tolerance: f64,
        cap: i64,
        params_a: *mut f64,
        params_b: *mut f64,
        kinds: *mut i32,
        ranges_a: *mut f64,
        ranges_b: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// nurbs_curve_intersections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params_a`, `params_b`, `kinds`, `ranges_a`, `ranges_b`, `count`, `complete`, `call`.
    pub fn nurbs_curve_intersections_with(
        a: *const nurbs,
        b: *const nurbs,
        tolerance: f64,
        cap: i64,
        params_a: *mut f64,
        params_b: *mut f64,
        kinds: *mut i32,
        ranges_a: *mut f64,
        ranges_b: *mut f64,
        count: *mut i64,
        complete: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Where a curve meets itself, at pairs of parameters a \< b.
    ///
    /// May be null: `params_a`, `params_b`, `kinds`, `ranges_a`, `ranges_b`, `count`, `complete`.
    pub fn nurbs_curve_self_intersections(
        g: *const nurbs,
        tolerance: f64,
        cap: i64,
        params_a: *mut f64,
        params_b: *mut f64,
        kinds: *mut i32,
        ranges_a: *mut f64,
        ranges_b: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// nurbs_curve_self_intersections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params_a`, `params_b`, `kinds`, `ranges_a`, `ranges_b`, `count`, `complete`, `call`.
    pub fn nurbs_curve_self_intersections_with(
        g: *const nurbs,
        tolerance: f64,
        cap: i64,
        params_a: *mut f64,
        params_b: *mut f64,
        kinds: *mut i32,
        ranges_a: *mut f64,
        ranges_b: *mut f64,
        count: *mut i64,
        complete: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Where a curve meets a surface: all places at which they come as near as the tolerance.
    ///
    /// May be null: `params_curve`, `params_surface`, `kinds`, `ranges_curve`, `ranges_surface`, `count`,
    /// `complete`.
    pub fn nurbs_curve_surface_intersections(
        curve: *const nurbs,
        surface: *const nurbs,
        tolerance: f64,
        cap: i64,
        params_curve: *mut f64,
        params_surface: *mut f64,
        kinds: *mut i32,
        ranges_curve: *mut f64,
        ranges_surface: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// nurbs_curve_surface_intersections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params_curve`, `params_surface`, `kinds`, `ranges_curve`, `ranges_surface`, `count`,
    /// `complete`, `call`.
    pub fn nurbs_curve_surface_intersections_with(
        curve: *const nurbs,
        surface: *const nurbs,
        tolerance: f64,
        cap: i64,
        params_curve: *mut f64,
        params_surface: *mut f64,
        kinds: *mut i32,
        ranges_curve: *mut f64,
        ranges_surface: *mut f64,
        count: *mut i64,
        complete: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The points that three surfaces have in common: all of them, proven to be all.
    ///
    /// May be null: `params`, `points`, `kinds`, `ranges`, `count`, `complete`.
    pub fn nurbs_surfaces_common_points(
        a: *const nurbs,
        b: *const nurbs,
        c: *const nurbs,
        tolerance: f64,
        cap: i64,
        params: *mut f64,
        points: *mut f64,
        kinds: *mut i32,
        ranges: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// nurbs_surfaces_common_points() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `points`, `kinds`, `ranges`, `count`, `complete`, `call`.
    pub fn nurbs_surfaces_common_points_with(
        a: *const nurbs,
        b: *const nurbs,
        c: *const nurbs,
        tolerance: f64,
        cap: i64,
        params: *mut f64,
        points: *mut f64,
        kinds: *mut i32,
        ranges: *mut f64,
        count: *mut i64,
        complete: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The first hits of rays x = origin + t direction, t \>= 0, with a surface.
    ///
    /// May be null: `params`, `distances`, `status`.
    pub fn nurbs_surface_rays(
        g: *const nurbs,
        n: i64,
        origins: *const f64,
        origin_stride: i64,
        origin_component_stride: i64,
        directions: *const f64,
        direction_stride: i64,
        direction_component_stride: i64,
        params: *mut f64,
        distances: *mut f64,
        status: *mut i32,
    ) -> nurbs_status;
    /// nurbs_surface_rays() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `distances`, `status`, `call`.
    pub fn nurbs_surface_rays_with(
        g: *const nurbs,
        n: i64,
        origins: *const f64,
        origin_stride: i64,
        origin_component_stride: i64,
        directions: *const f64,
        direction_stride: i64,
        direction_component_stride: i64,
        params: *mut f64,
        distances: *mut f64,
        status: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// All places where a ray meets a surface, in the order of rising t.
    ///
    /// May be null: `range`, `params`, `distances`, `kinds`, `count`, `complete`.
    pub fn nurbs_surface_ray_hits(
        g: *const nurbs,
        origin: *const f64,
        direction: *const f64,
        range: *const f64,
        cap: i64,
        params: *mut f64,
        distances: *mut f64,
        kinds: *mut i32,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// Where planes normal . x = offset cut a surface: all curves, proven to be all.
    pub fn nurbs_surface_sections(
        g: *const nurbs,
        normal: *const f64,
        n: i64,
        offsets: *const f64,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_surface_sections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_surface_sections_with(
        g: *const nurbs,
        normal: *const f64,
        n: i64,
        offsets: *const f64,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// Silhouettes, isophotes and parabolic curves of a surface: all of them, proven to be all.
    ///
    /// May be null: `d`, `cosines`.
    pub fn nurbs_surface_contours(
        g: *const nurbs,
        kind: i32,
        d: *const f64,
        n: i64,
        cosines: *const f64,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_surface_contours() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `d`, `cosines`, `call`.
    pub fn nurbs_surface_contours_with(
        g: *const nurbs,
        kind: i32,
        d: *const f64,
        n: i64,
        cosines: *const f64,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// Reflection lines and highlight lines of a surface, which show how fair it is.
    ///
    /// May be null: `eye`.
    pub fn nurbs_surface_reflections(
        g: *const nurbs,
        kind: i32,
        eye: *const f64,
        direction: *const f64,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_surface_reflections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `eye`, `call`.
    pub fn nurbs_surface_reflections_with(
        g: *const nurbs,
        kind: i32,
        eye: *const f64,
        direction: *const f64,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// Where an implicit polynomial f of space vanishes on a surface.
    pub fn nurbs_surface_level(
        g: *const nurbs,
        degree: i32,
        coefficients: *const f64,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_surface_level() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_surface_level_with(
        g: *const nurbs,
        degree: i32,
        coefficients: *const f64,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// Level curves of a scalar spline over a surface, such as a temperature, a pressure or a thickness.
    pub fn nurbs_surface_level_curves(
        g: *const nurbs,
        scalar: *const nurbs,
        n: i64,
        values: *const f64,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_surface_level_curves() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_surface_level_curves_with(
        g: *const nurbs,
        scalar: *const nurbs,
        n: i64,
        values: *const f64,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// Where two surfaces meet in curves: all of them, proven to be all.
    pub fn nurbs_surface_intersections(
        a: *const nurbs,
        b: *const nurbs,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_surface_intersections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_surface_intersections_with(
        a: *const nurbs,
        b: *const nurbs,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// Where a surface meets itself: all curves of double points, or the proof that there are none.
    pub fn nurbs_surface_self_intersections(
        g: *const nurbs,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_surface_self_intersections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_surface_self_intersections_with(
        g: *const nurbs,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// Where two faces meet: in curves, in regions, and in the edges that they share.
    pub fn nurbs_face_intersections(
        a: *const nurbs_face,
        b: *const nurbs_face,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_face_intersections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_face_intersections_with(
        a: *const nurbs_face,
        b: *const nurbs_face,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// A curve projected onto a surface, along a direction d or along the normals of the surface.
    ///
    /// May be null: `direction`.
    pub fn nurbs_surface_project_curve(
        g: *const nurbs,
        curve: *const nurbs,
        direction: *const f64,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_surface_project_curve() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `direction`, `call`.
    pub fn nurbs_surface_project_curve_with(
        g: *const nurbs,
        curve: *const nurbs,
        direction: *const f64,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// A curve projected onto a face, along a direction or along the normals of its surface.
    ///
    /// May be null: `direction`.
    pub fn nurbs_face_project_curve(
        face: *const nurbs_face,
        curve: *const nurbs,
        direction: *const f64,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_face_project_curve() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `direction`, `call`.
    pub fn nurbs_face_project_curve_with(
        face: *const nurbs_face,
        curve: *const nurbs,
        direction: *const f64,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// Another handle on the same meet, in constant time.
    pub fn nurbs_meet_clone(meet: *const nurbs_meet, out: *mut *mut nurbs_meet) -> nurbs_status;
    /// Frees a handle on a meet.
    ///
    /// May be null: `meet`.
    pub fn nurbs_meet_destroy(meet: *mut nurbs_meet);
    /// The numbers of branches and nodes of a meet, and whether it is complete.
    ///
    /// May be null: `branches`, `nodes`, `complete`.
    pub fn nurbs_meet_counts(
        meet: *const nurbs_meet,
        branches: *mut i64,
        nodes: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// What the branches of a meet belong to, and where they end.
    ///
    /// May be null: `levels`, `end_nodes`, `loops`, `deviations`, `count`.
    pub fn nurbs_meet_branches(
        meet: *const nurbs_meet,
        cap: i64,
        levels: *mut i64,
        end_nodes: *mut i64,
        loops: *mut i64,
        deviations: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// What kind each branch of a meet is.
    ///
    /// May be null: `kinds`, `count`.
    pub fn nurbs_meet_kinds(
        meet: *const nurbs_meet,
        cap: i64,
        kinds: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    /// A branch of a meet, as curves in space and in the parameter domain.
    pub fn nurbs_meet_branch(
        meet: *const nurbs_meet,
        index: i64,
        space: *mut *mut nurbs,
        on_surface: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The curve of a branch on the second of two surfaces; in a projection, the curve of (t, h).
    pub fn nurbs_meet_branch_second(
        meet: *const nurbs_meet,
        index: i64,
        on_second: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The nodes of a meet: where branches end, and where something is not resolved.
    ///
    /// May be null: `levels`, `kinds`, `params`, `ranges`, `count`.
    pub fn nurbs_meet_nodes(
        meet: *const nurbs_meet,
        cap: i64,
        levels: *mut i64,
        kinds: *mut i32,
        params: *mut f64,
        ranges: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// Where the nodes of a meet are on the second of two surfaces; in a projection, their (t, h).
    ///
    /// May be null: `params`, `ranges`, `count`.
    pub fn nurbs_meet_nodes_second(
        meet: *const nurbs_meet,
        cap: i64,
        params: *mut f64,
        ranges: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The ways of a meet: chains of branches, each of which continues the one before.
    ///
    /// May be null: `levels`, `firsts`, `sizes`, `closes`, `gaps`, `count`.
    pub fn nurbs_meet_ways(
        meet: *const nurbs_meet,
        cap: i64,
        levels: *mut i64,
        firsts: *mut i64,
        sizes: *mut i64,
        closes: *mut i32,
        gaps: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The faces on which the branches of a meet of a model lie; -1 in other meets.
    ///
    /// May be null: `own_faces`, `own_instances`, `count`.
    pub fn nurbs_meet_faces(
        meet: *const nurbs_meet,
        cap: i64,
        own_faces: *mut i64,
        own_instances: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The faces of the second model of nurbs_model_intersections() on which branches lie; else -1.
    ///
    /// May be null: `own_faces`, `own_instances`, `count`.
    pub fn nurbs_meet_faces_second(
        meet: *const nurbs_meet,
        cap: i64,
        own_faces: *mut i64,
        own_instances: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// How branches continue at the nodes of a meet, and on which faces of a model these nodes are.
    ///
    /// May be null: `next_nodes`, `gaps`, `own_faces`, `own_instances`, `count`.
    pub fn nurbs_meet_joints(
        meet: *const nurbs_meet,
        cap: i64,
        next_nodes: *mut i64,
        gaps: *mut f64,
        own_faces: *mut i64,
        own_instances: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The faces of the second model of nurbs_model_intersections() on which nodes are; else -1.
    ///
    /// May be null: `own_faces`, `own_instances`, `count`.
    pub fn nurbs_meet_joints_second(
        meet: *const nurbs_meet,
        cap: i64,
        own_faces: *mut i64,
        own_instances: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The part of a meet that lies in a face.
    pub fn nurbs_meet_trim(
        meet: *const nurbs_meet,
        face: *const nurbs_face,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_meet_trim() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_meet_trim_with(
        meet: *const nurbs_meet,
        face: *const nurbs_face,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// The part of a meet of two surfaces that lies in a face of the second one.
    pub fn nurbs_meet_trim_second(
        meet: *const nurbs_meet,
        face: *const nurbs_face,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_meet_trim_second() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_meet_trim_second_with(
        meet: *const nurbs_meet,
        face: *const nurbs_face,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    // --- Weights and control points
    /// Changes a weight so that the point at a parameter moves by a distance towards the control point, or
    /// away from it if the distance is negative.
    ///
    /// May be null: `weight`.
    pub fn nurbs_pull_weight(
        g: *const nurbs,
        index: i64,
        params: *const f64,
        distance: f64,
        weight: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Multiplies several weights by one factor so that the point at a parameter moves by a distance towards
    /// (or away from) their common centre Q = sum R_i P_i / sum R_i: the formula of nurbs_pull_weight() with
    /// Q and sum R_i.
    ///
    /// May be null: `factor`.
    pub fn nurbs_pull_weights(
        g: *const nurbs,
        count: i64,
        indices: *const i64,
        params: *const f64,
        distance: f64,
        factor: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Sets weights; control points stay, and a polynomial spline becomes rational unless count is 0.
    pub fn nurbs_set_weights(
        g: *const nurbs,
        count: i64,
        indices: *const i64,
        weights: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The points at a parameter for the weights 0, 1 and the present one of a control point.
    ///
    /// May be null: `at_zero`, `at_one`, `at_weight`.
    pub fn nurbs_weight_points(
        g: *const nurbs,
        index: i64,
        params: *const f64,
        at_zero: *mut f64,
        at_one: *mut f64,
        at_weight: *mut f64,
    ) -> nurbs_status;
    /// The weight as the cross ratio of four points on a line: w = (P n / n m) / (P p / p m), signed lengths,
    /// where m, n, p are the points of nurbs_weight_points().
    pub fn nurbs_weight_cross_ratio(
        dim: i32,
        control_point: *const f64,
        at_zero: *const f64,
        at_one: *const f64,
        at_weight: *const f64,
        weight: *mut f64,
    ) -> nurbs_status;
    /// Sets the weight of a control point so that the point at a parameter becomes a given one, on the line
    /// through P_i and the point at weight 0, by the cross ratio.
    ///
    /// May be null: `weight`.
    pub fn nurbs_weight_through(
        g: *const nurbs,
        index: i64,
        params: *const f64,
        target: *const f64,
        tolerance: f64,
        weight: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Moves a control point so that the point at a parameter moves by a distance along a direction.
    ///
    /// May be null: `moved`.
    pub fn nurbs_pull_point(
        g: *const nurbs,
        index: i64,
        params: *const f64,
        direction: *const f64,
        distance: f64,
        moved: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The control point with the largest |R_i(t)|, the first of several.
    ///
    /// May be null: `indices`, `influences`.
    pub fn nurbs_most_influential(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        indices: *mut i64,
        influences: *mut f64,
    ) -> nurbs_status;
    /// Inverse knot insertion: inserts the knot that makes a point of a leg of the control polygon a control
    /// point.
    ///
    /// May be null: `knot`.
    pub fn nurbs_insert_on_leg(
        g: *const nurbs,
        axis: i32,
        index: i64,
        ratio: f64,
        knot: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Inverse knot insertion at a point of the control polygon: the leg along the axis that is nearest to
    /// the point is taken, and the knot inserted as by nurbs_insert_on_leg().
    ///
    /// May be null: `index`, `ratio`, `knot`.
    pub fn nurbs_insert_at_point(
        g: *const nurbs,
        axis: i32,
        point: *const f64,
        tolerance: f64,
        index: *mut i64,
        ratio: *mut f64,
        knot: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Constraints
    /// The smallest change of control points, and if wanted of weights, that makes a shape meet constraints.
    ///
    /// May be null: `kinds`, `orders`, `keep`, `costs`, `weight_costs`, `residuals`, `rank`, `moved`,
    /// `optimality`.
    pub fn nurbs_constrain(
        g: *const nurbs,
        count: i64,
        kinds: *const i32,
        orders: *const i32,
        params: *const f64,
        targets: *const f64,
        keep: *const i32,
        costs: *const f64,
        weight_costs: *const f64,
        tolerance: f64,
        residuals: *mut f64,
        rank: *mut i64,
        moved: *mut f64,
        optimality: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_constrain() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `report`, `call`.
    pub fn nurbs_constrain_with(
        g: *const nurbs,
        constraints: *const nurbs_constraints,
        report: *mut nurbs_constraint_report,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Deformations
    /// Raises a region along a direction: adds distance \* b(t) \* direction / |direction|, where b is 1 in
    /// the middle of the range, 0 at its ends with the first `order` derivatives, and rises and falls once
    /// along each axis: a product of B-splines of degree order + 1 over even knots, added exactly.
    ///
    /// May be null: `range`.
    pub fn nurbs_warp(
        g: *const nurbs,
        range: *const f64,
        direction: *const f64,
        distance: f64,
        order: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Flattens a region to a plane (in the plane: to a line): control points of the region are projected
    /// onto it along a direction; those inside it only, so that the shape joins what is outside as smoothly
    /// as the degree allows.
    ///
    /// May be null: `range`, `direction`, `moved`.
    pub fn nurbs_flatten(
        g: *const nurbs,
        range: *const f64,
        point: *const f64,
        normal: *const f64,
        direction: *const f64,
        moved: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Bends a shape about an axis (Barr 1984).
    ///
    /// May be null: `deviation`, `proven`.
    pub fn nurbs_bend(
        g: *const nurbs,
        origin: *const f64,
        along: *const f64,
        across: *const f64,
        curvature: f64,
        lower: f64,
        upper: f64,
        tolerance: f64,
        deviation: *mut f64,
        proven: *mut i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_bend() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `deviation`, `proven`, `call`.
    pub fn nurbs_bend_with(
        g: *const nurbs,
        origin: *const f64,
        along: *const f64,
        across: *const f64,
        curvature: f64,
        lower: f64,
        upper: f64,
        tolerance: f64,
        deviation: *mut f64,
        proven: *mut i32,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Free-form deformation (Sederberg & Parry 1986): maps a shape by a volume, C -\> V(A C), where A maps
    /// the box from lower to upper to the domain of V.
    ///
    /// May be null: `deviation`, `proven`.
    pub fn nurbs_free_form_deform(
        g: *const nurbs,
        volume: *const nurbs,
        lower: *const f64,
        upper: *const f64,
        tolerance: f64,
        deviation: *mut f64,
        proven: *mut i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_free_form_deform() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `deviation`, `proven`, `call`.
    pub fn nurbs_free_form_deform_with(
        g: *const nurbs,
        volume: *const nurbs,
        lower: *const f64,
        upper: *const f64,
        tolerance: f64,
        deviation: *mut f64,
        proven: *mut i32,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Fairs a shape: among the splines with the same knots and weights that are at most a tolerance away,
    /// and of them those that move control points least for their energy, the one with the least energy, the
    /// integral of the squared derivatives of an order, summed over the axes (of homogeneous coordinates
    /// about the centre when rational).
    ///
    /// May be null: `keep`, `energies`, `bound`.
    pub fn nurbs_fair(
        g: *const nurbs,
        order: i32,
        keep: *const i32,
        tolerance: f64,
        energies: *mut f64,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// nurbs_fair() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `keep`, `energies`, `bound`, `call`.
    pub fn nurbs_fair_with(
        g: *const nurbs,
        order: i32,
        keep: *const i32,
        tolerance: f64,
        energies: *mut f64,
        bound: *mut f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Moves a boundary of a spline onto one of another: a curve's end onto an end, a surface's edge onto an
    /// edge.
    ///
    /// May be null: `bound`.
    pub fn nurbs_snap_boundary(
        g: *const nurbs,
        axis: i32,
        end: i32,
        other: *const nurbs,
        other_axis: i32,
        other_end: i32,
        order: i32,
        flags: u32,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    // --- Derivatives with respect to data
    /// Collocation matrix of B-spline basis functions, or of one of their partial derivatives, as compressed
    /// sparse rows (CSR), the arrays that SciPy and Eigen take.
    ///
    /// May be null: `orders`, `values`, `columns`, `row_pointers`, `entries`.
    pub fn nurbs_collocation(
        axes: i32,
        degrees: *const i32,
        counts: *const i64,
        knots: *const f64,
        knot_count: i64,
        orders: *const i32,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        cap: i64,
        values: *mut f64,
        columns: *mut i64,
        row_pointers: *mut i64,
        entries: *mut i64,
        flags: u32,
    ) -> nurbs_status;
    /// Collocation matrix of the rational basis functions R_j = w_j N_j / w(t) of a spline, or of one of
    /// their partial derivatives; of N_j for a polynomial spline.
    ///
    /// May be null: `orders`, `values`, `columns`, `row_pointers`, `entries`.
    pub fn nurbs_rational_collocation(
        g: *const nurbs,
        orders: *const i32,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        cap: i64,
        values: *mut f64,
        columns: *mut i64,
        row_pointers: *mut i64,
        entries: *mut i64,
        flags: u32,
    ) -> nurbs_status;
    /// Bezier extraction operators of the non-empty spans of an axis (Borden, Scott, Evans & Hughes 2011).
    ///
    /// May be null: `operators`, `firsts`, `domains`.
    pub fn nurbs_bezier_extraction(
        g: *const nurbs,
        axis: i32,
        cap: i64,
        operators: *mut f64,
        firsts: *mut i64,
        domains: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// Gradients of a function L of points and derivatives with respect to the control points, the weights
    /// and the parameters: the transpose of nurbs_eval_derivs(), or of nurbs_eval() with order 0.
    ///
    /// May be null: `grad_points`, `grad_weights`, `grad_params`.
    pub fn nurbs_eval_adjoint(
        g: *const nurbs,
        order: i32,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        cotangents: *const f64,
        cotangent_stride: i64,
        cotangent_component_stride: i64,
        grad_points: *mut f64,
        grad_point_stride: i64,
        grad_point_component_stride: i64,
        grad_weights: *mut f64,
        grad_weight_stride: i64,
        grad_params: *mut f64,
        grad_param_stride: i64,
        grad_param_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    /// Gradients of a function L of points and derivatives with respect to the knots of an axis.
    pub fn nurbs_eval_adjoint_knots(
        g: *const nurbs,
        axis: i32,
        order: i32,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        cotangents: *const f64,
        cotangent_stride: i64,
        cotangent_component_stride: i64,
        grad_knots: *mut f64,
        flags: u32,
    ) -> nurbs_status;
    /// Gradients of a function L of closest points, or of any places where the distance to a point is
    /// critical, with respect to control points, weights and the query points, by the implicit function
    /// theorem.
    ///
    /// May be null: `param_cotangents`, `foot_cotangents`, `distance_cotangents`, `grad_points`,
    /// `grad_weights`, `grad_queries`, `status`.
    pub fn nurbs_closest_adjoint(
        g: *const nurbs,
        n: i64,
        points: *const f64,
        params: *const f64,
        param_cotangents: *const f64,
        foot_cotangents: *const f64,
        distance_cotangents: *const f64,
        grad_points: *mut f64,
        grad_weights: *mut f64,
        grad_queries: *mut f64,
        status: *mut i32,
        flags: u32,
    ) -> nurbs_status;
    /// Gradients of the length of a curve, or of a part of it, with respect to control points and weights:
    /// with the unit tangent T and the rational functions R_i.
    ///
    /// May be null: `range`, `grad_points`, `grad_weights`, `error`.
    pub fn nurbs_length_adjoint(
        g: *const nurbs,
        range: *const f64,
        relative_tolerance: f64,
        cotangent: f64,
        grad_points: *mut f64,
        grad_point_stride: i64,
        grad_point_component_stride: i64,
        grad_weights: *mut f64,
        grad_weight_stride: i64,
        error: *mut f64,
        flags: u32,
    ) -> nurbs_status;
    // --- Trimmed faces
    /// A face made of a surface and loops of curves.
    ///
    /// May be null: `sizes`, `curves`, `edges`, `keys`, `gaps`.
    pub fn nurbs_face_create(
        surface: *const nurbs,
        loops: i64,
        sizes: *const i64,
        curves: *const *const nurbs,
        edges: *const *const nurbs,
        keys: *const i64,
        tolerance: f64,
        flags: u32,
        gaps: *mut f64,
        out: *mut *mut nurbs_face,
    ) -> nurbs_status;
    /// nurbs_face_create() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `sizes`, `curves`, `edges`, `keys`, `gaps`, `call`.
    pub fn nurbs_face_create_with(
        surface: *const nurbs,
        loops: i64,
        sizes: *const i64,
        curves: *const *const nurbs,
        edges: *const *const nurbs,
        keys: *const i64,
        tolerance: f64,
        flags: u32,
        gaps: *mut f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_face,
    ) -> nurbs_status;
    /// Another handle on the same face, in constant time.
    pub fn nurbs_face_clone(face: *const nurbs_face, out: *mut *mut nurbs_face) -> nurbs_status;
    /// Frees a handle on a face.
    ///
    /// May be null: `face`.
    pub fn nurbs_face_destroy(face: *mut nurbs_face);
    /// The surface of a face.
    pub fn nurbs_face_surface(face: *const nurbs_face, out: *mut *mut nurbs) -> nurbs_status;
    /// The number of curves of each loop.
    ///
    /// May be null: `sizes`, `count`.
    pub fn nurbs_face_loops(
        face: *const nurbs_face,
        cap: i64,
        sizes: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// A curve of a loop in the domain of the surface, running with the inside to its left.
    pub fn nurbs_face_curve(
        face: *const nurbs_face,
        r#loop: i64,
        index: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// The edge in space that belongs to a curve of a loop.
    ///
    /// May be null: `key`.
    pub fn nurbs_face_edge(
        face: *const nurbs_face,
        r#loop: i64,
        index: i64,
        key: *mut i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// How far a curve of a loop, mapped by the surface, and its edge are apart.
    ///
    /// May be null: `proven`.
    pub fn nurbs_face_deviation(
        face: *const nurbs_face,
        r#loop: i64,
        index: i64,
        distance: *mut f64,
        proven: *mut i32,
    ) -> nurbs_status;
    /// The tolerance that a face was created with.
    pub fn nurbs_face_tolerance(face: *const nurbs_face, tolerance: *mut f64) -> nurbs_status;
    /// On which side of the boundary of a face places of the domain lie.
    pub fn nurbs_face_classify(
        face: *const nurbs_face,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        tolerance: f64,
        sides: *mut i32,
    ) -> nurbs_status;
    /// nurbs_face_classify() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_face_classify_with(
        face: *const nurbs_face,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        tolerance: f64,
        sides: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The first hits of rays x = origin + t direction, t \>= 0, with a face.
    ///
    /// May be null: `params`, `distances`, `status`.
    pub fn nurbs_face_rays(
        face: *const nurbs_face,
        n: i64,
        origins: *const f64,
        origin_stride: i64,
        origin_component_stride: i64,
        directions: *const f64,
        direction_stride: i64,
        direction_component_stride: i64,
        params: *mut f64,
        distances: *mut f64,
        status: *mut i32,
    ) -> nurbs_status;
    /// nurbs_face_rays() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `distances`, `status`, `call`.
    pub fn nurbs_face_rays_with(
        face: *const nurbs_face,
        n: i64,
        origins: *const f64,
        origin_stride: i64,
        origin_component_stride: i64,
        directions: *const f64,
        direction_stride: i64,
        direction_component_stride: i64,
        params: *mut f64,
        distances: *mut f64,
        status: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The points of a face that are nearest to given points.
    ///
    /// May be null: `params`, `feet`, `distances`, `status`.
    pub fn nurbs_face_closest_points(
        face: *const nurbs_face,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tolerance: f64,
        params: *mut f64,
        feet: *mut f64,
        distances: *mut f64,
        status: *mut i32,
    ) -> nurbs_status;
    /// nurbs_face_closest_points() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `feet`, `distances`, `status`, `call`.
    pub fn nurbs_face_closest_points_with(
        face: *const nurbs_face,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tolerance: f64,
        params: *mut f64,
        feet: *mut f64,
        distances: *mut f64,
        status: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Proven bounds of the smallest distance between two faces.
    ///
    /// May be null: `at_least`, `at_most`, `params_a`, `params_b`, `status`.
    pub fn nurbs_face_distance(
        a: *const nurbs_face,
        b: *const nurbs_face,
        tolerance: f64,
        at_least: *mut f64,
        at_most: *mut f64,
        params_a: *mut f64,
        params_b: *mut f64,
        status: *mut i32,
    ) -> nurbs_status;
    /// nurbs_face_distance() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `at_least`, `at_most`, `params_a`, `params_b`, `status`, `call`.
    pub fn nurbs_face_distance_with(
        a: *const nurbs_face,
        b: *const nurbs_face,
        tolerance: f64,
        at_least: *mut f64,
        at_most: *mut f64,
        params_a: *mut f64,
        params_b: *mut f64,
        status: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Proven bounds of the Hausdorff distances of two faces.
    ///
    /// May be null: `at_least`, `at_most`, `params_a`, `params_b`, `status`.
    pub fn nurbs_face_hausdorff_distance(
        a: *const nurbs_face,
        b: *const nurbs_face,
        tolerance: f64,
        at_least: *mut f64,
        at_most: *mut f64,
        params_a: *mut f64,
        params_b: *mut f64,
        status: *mut i32,
    ) -> nurbs_status;
    /// nurbs_face_hausdorff_distance() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `at_least`, `at_most`, `params_a`, `params_b`, `status`, `call`.
    pub fn nurbs_face_hausdorff_distance_with(
        a: *const nurbs_face,
        b: *const nurbs_face,
        tolerance: f64,
        at_least: *mut f64,
        at_most: *mut f64,
        params_a: *mut f64,
        params_b: *mut f64,
        status: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The area of a face.
    ///
    /// May be null: `error`.
    pub fn nurbs_face_area(
        face: *const nurbs_face,
        relative_tolerance: f64,
        area: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    /// nurbs_face_area() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `error`, `call`.
    pub fn nurbs_face_area_with(
        face: *const nurbs_face,
        relative_tolerance: f64,
        area: *mut f64,
        error: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Area, centroid and inertia of a face, as nurbs_moments() computes them for a whole surface.
    ///
    /// May be null: `centroid`, `inertia`, `error`.
    pub fn nurbs_face_moments(
        face: *const nurbs_face,
        relative_tolerance: f64,
        content: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    /// nurbs_face_moments() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `centroid`, `inertia`, `error`, `call`.
    pub fn nurbs_face_moments_with(
        face: *const nurbs_face,
        relative_tolerance: f64,
        content: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        error: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Points and weights for integrals of any function over a face.
    ///
    /// May be null: `params`, `weights`, `measures`, `count`.
    pub fn nurbs_face_quadrature(
        face: *const nurbs_face,
        nodes: i32,
        cap: i64,
        params: *mut f64,
        weights: *mut f64,
        measures: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// nurbs_face_quadrature() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `weights`, `measures`, `count`, `call`.
    pub fn nurbs_face_quadrature_with(
        face: *const nurbs_face,
        nodes: i32,
        cap: i64,
        params: *mut f64,
        weights: *mut f64,
        measures: *mut f64,
        count: *mut i64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// An axis-aligned box that contains a face.
    ///
    /// May be null: `gap`.
    pub fn nurbs_face_box(
        face: *const nurbs_face,
        tolerance: f64,
        lower: *mut f64,
        upper: *mut f64,
        gap: *mut f64,
    ) -> nurbs_status;
    /// nurbs_face_box() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `gap`, `call`.
    pub fn nurbs_face_box_with(
        face: *const nurbs_face,
        tolerance: f64,
        lower: *mut f64,
        upper: *mut f64,
        gap: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    // --- Reading files
    /// Fills an options struct with the defaults.
    pub fn nurbs_read_options_init(options: *mut nurbs_read_options, struct_size: i64) -> nurbs_status;
    /// Reads the curves and surfaces of an IGES or a STEP file.
    ///
    /// May be null: `options`.
    pub fn nurbs_read(
        bytes: *const c_void,
        size: i64,
        options: *const nurbs_read_options,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    /// nurbs_read() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_read_with(
        bytes: *const c_void,
        size: i64,
        options: *const nurbs_read_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    /// Reads a file by its path; see nurbs_read().
    ///
    /// May be null: `options`.
    pub fn nurbs_read_file(
        path: *const c_char,
        options: *const nurbs_read_options,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    /// nurbs_read_file() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_read_file_with(
        path: *const c_char,
        options: *const nurbs_read_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    /// A list of given splines.
    ///
    /// May be null: `names`.
    pub fn nurbs_list_create(
        count: i64,
        splines: *const *const nurbs,
        names: *const *const c_char,
        metres: f64,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    /// Number of splines in a list.
    pub fn nurbs_list_count(list: *const nurbs_list, count: *mut i64) -> nurbs_status;
    /// A new handle on spline `index`, which outlives the list.
    pub fn nurbs_list_get(list: *const nurbs_list, index: i64, out: *mut *mut nurbs) -> nurbs_status;
    /// The name of spline `index`.
    ///
    /// May be null: `buf`, `length`.
    pub fn nurbs_list_name(
        list: *const nurbs_list,
        index: i64,
        buf: *mut c_char,
        cap: i64,
        length: *mut i64,
    ) -> nurbs_status;
    /// Number of notes: entities of the file that did not become a spline, or only approximately.
    pub fn nurbs_list_note_count(list: *const nurbs_list, count: *mut i64) -> nurbs_status;
    /// A note: which entity, where, and why it did not become a spline.
    ///
    /// May be null: `entity_type`, `line`, `reason`, `buf`, `length`.
    pub fn nurbs_list_note(
        list: *const nurbs_list,
        index: i64,
        entity_type: *mut i32,
        line: *mut i64,
        reason: *mut nurbs_status,
        buf: *mut c_char,
        cap: i64,
        length: *mut i64,
    ) -> nurbs_status;
    /// The unit of length of the splines in a list.
    pub fn nurbs_list_unit(list: *const nurbs_list, metres: *mut f64) -> nurbs_status;
    /// Frees a list.
    ///
    /// May be null: `list`.
    pub fn nurbs_list_destroy(list: *mut nurbs_list);
    // --- Handles as bytes
    /// A spline as bytes.
    ///
    /// May be null: `bytes`, `length`.
    pub fn nurbs_to_bytes(g: *const nurbs, cap: i64, bytes: *mut c_void, length: *mut i64) -> nurbs_status;
    /// The spline of the bytes of nurbs_to_bytes().
    pub fn nurbs_from_bytes(bytes: *const c_void, size: i64, out: *mut *mut nurbs) -> nurbs_status;
    /// A list as bytes, with names, notes and unit.
    ///
    /// May be null: `bytes`, `length`.
    pub fn nurbs_list_to_bytes(
        list: *const nurbs_list,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
    ) -> nurbs_status;
    /// The list of the bytes of nurbs_list_to_bytes().
    pub fn nurbs_list_from_bytes(bytes: *const c_void, size: i64, out: *mut *mut nurbs_list) -> nurbs_status;
    /// A face as bytes.
    ///
    /// May be null: `bytes`, `length`.
    pub fn nurbs_face_to_bytes(
        face: *const nurbs_face,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
    ) -> nurbs_status;
    /// The face of the bytes of nurbs_face_to_bytes().
    pub fn nurbs_face_from_bytes(bytes: *const c_void, size: i64, out: *mut *mut nurbs_face) -> nurbs_status;
    /// A model as bytes, with everything that it holds.
    ///
    /// May be null: `bytes`, `length`.
    pub fn nurbs_model_to_bytes(
        model: *const nurbs_model,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
    ) -> nurbs_status;
    /// The model of the bytes of nurbs_model_to_bytes().
    pub fn nurbs_model_from_bytes(
        bytes: *const c_void,
        size: i64,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// The kind of handle that bytes hold, and the version of their form.
    ///
    /// May be null: `kind`, `major`, `minor`.
    pub fn nurbs_bytes_kind(
        bytes: *const c_void,
        size: i64,
        kind: *mut i32,
        major: *mut i32,
        minor: *mut i32,
    ) -> nurbs_status;
    // --- Models
    /// Reads the faces, edges and vertices of a STEP or an IGES file.
    ///
    /// May be null: `options`.
    pub fn nurbs_read_model(
        bytes: *const c_void,
        size: i64,
        options: *const nurbs_read_options,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// nurbs_read_model() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_read_model_with(
        bytes: *const c_void,
        size: i64,
        options: *const nurbs_read_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// Reads a model from a file by its path; see nurbs_read_model().
    ///
    /// May be null: `options`.
    pub fn nurbs_read_model_file(
        path: *const c_char,
        options: *const nurbs_read_options,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// nurbs_read_model_file() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_read_model_file_with(
        path: *const c_char,
        options: *const nurbs_read_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// A model made of faces, with one part and one use of it.
    pub fn nurbs_model_create(
        count: i64,
        faces: *const *const nurbs_face,
        metres: f64,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// A model sewn from patches without topology: boundaries that coincide become common edges.
    pub fn nurbs_model_sew(
        count: i64,
        faces: *const *const nurbs_face,
        tolerance: f64,
        metres: f64,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// nurbs_model_sew() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_model_sew_with(
        count: i64,
        faces: *const *const nurbs_face,
        tolerance: f64,
        metres: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// Another handle on the same model, in constant time.
    pub fn nurbs_model_clone(model: *const nurbs_model, out: *mut *mut nurbs_model) -> nurbs_status;
    /// Frees a handle on a model.
    ///
    /// May be null: `model`.
    pub fn nurbs_model_destroy(model: *mut nurbs_model);
    /// The numbers of parts, uses, faces, edges and vertices of a model.
    ///
    /// May be null: `parts`, `uses`, `faces`, `edges`, `vertices`.
    pub fn nurbs_model_counts(
        model: *const nurbs_model,
        parts: *mut i64,
        uses: *mut i64,
        faces: *mut i64,
        edges: *mut i64,
        vertices: *mut i64,
    ) -> nurbs_status;
    /// A face of a model, with its part, kind, orientation and colour.
    ///
    /// May be null: `part`, `shape`, `against`, `colour`.
    pub fn nurbs_model_face(
        model: *const nurbs_model,
        index: i64,
        part: *mut i64,
        shape: *mut i32,
        against: *mut i32,
        colour: *mut f64,
        out: *mut *mut nurbs_face,
    ) -> nurbs_status;
    /// The name of a face.
    ///
    /// May be null: `buf`, `length`.
    pub fn nurbs_model_face_name(
        model: *const nurbs_model,
        index: i64,
        buf: *mut c_char,
        cap: i64,
        length: *mut i64,
    ) -> nurbs_status;
    /// The solid that a face bounds.
    ///
    /// May be null: `solid`, `in_void`.
    pub fn nurbs_model_face_solid(
        model: *const nurbs_model,
        index: i64,
        solid: *mut i64,
        in_void: *mut i32,
    ) -> nurbs_status;
    /// The layers that a face is in.
    ///
    /// May be null: `layers`, `count`.
    pub fn nurbs_model_face_layers(
        model: *const nurbs_model,
        index: i64,
        cap: i64,
        layers: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// An edge of a model, with its part, end vertices and kind.
    ///
    /// May be null: `part`, `end_vertices`, `shape`.
    pub fn nurbs_model_edge(
        model: *const nurbs_model,
        index: i64,
        part: *mut i64,
        end_vertices: *mut i64,
        shape: *mut i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    /// Where faces use an edge: once at a free boundary, twice inside a shell.
    ///
    /// May be null: `places`, `count`.
    pub fn nurbs_model_edge_uses(
        model: *const nurbs_model,
        index: i64,
        cap: i64,
        places: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// How well faces meet at the edges of a model: the number of uses and the largest gap of each edge.
    ///
    /// May be null: `uses`, `gaps`, `bounded`, `count`.
    pub fn nurbs_model_edge_gaps(
        model: *const nurbs_model,
        cap: i64,
        uses: *mut i64,
        gaps: *mut f64,
        bounded: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    /// The point of a vertex, in the coordinates of its part.
    pub fn nurbs_model_vertex(model: *const nurbs_model, index: i64, point: *mut f64) -> nurbs_status;
    /// The name of a part.
    ///
    /// May be null: `buf`, `length`.
    pub fn nurbs_model_part(
        model: *const nurbs_model,
        index: i64,
        buf: *mut c_char,
        cap: i64,
        length: *mut i64,
    ) -> nurbs_status;
    /// A use of a part: where it is placed.
    ///
    /// May be null: `parent`, `part`, `placement`.
    pub fn nurbs_model_use(
        model: *const nurbs_model,
        index: i64,
        parent: *mut i64,
        part: *mut i64,
        placement: *mut f64,
    ) -> nurbs_status;
    /// Where the parts of a model stand in the whole: each chain of uses from the whole to a part.
    ///
    /// May be null: `parents`, `last_uses`, `own_parts`, `placements`, `count`.
    pub fn nurbs_model_instances(
        model: *const nurbs_model,
        cap: i64,
        parents: *mut i64,
        last_uses: *mut i64,
        own_parts: *mut i64,
        placements: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The first hits of rays x = origin + t direction, t \>= 0, with the faces of a model.
    ///
    /// May be null: `params`, `distances`, `status`, `places`.
    pub fn nurbs_model_rays(
        model: *const nurbs_model,
        n: i64,
        origins: *const f64,
        directions: *const f64,
        params: *mut f64,
        distances: *mut f64,
        status: *mut i32,
        places: *mut i64,
    ) -> nurbs_status;
    /// nurbs_model_rays() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `distances`, `status`, `places`, `call`.
    pub fn nurbs_model_rays_with(
        model: *const nurbs_model,
        n: i64,
        origins: *const f64,
        directions: *const f64,
        params: *mut f64,
        distances: *mut f64,
        status: *mut i32,
        places: *mut i64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// All places where a ray meets the faces of a model, in the order of rising t.
    ///
    /// May be null: `range`, `params`, `distances`, `kinds`, `places`, `count`, `complete`.
    pub fn nurbs_model_ray_hits(
        model: *const nurbs_model,
        origin: *const f64,
        direction: *const f64,
        range: *const f64,
        cap: i64,
        params: *mut f64,
        distances: *mut f64,
        kinds: *mut i32,
        places: *mut i64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    /// nurbs_model_ray_hits() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `range`, `params`, `distances`, `kinds`, `places`, `count`, `complete`, `call`.
    pub fn nurbs_model_ray_hits_with(
        model: *const nurbs_model,
        origin: *const f64,
        direction: *const f64,
        range: *const f64,
        cap: i64,
        params: *mut f64,
        distances: *mut f64,
        kinds: *mut i32,
        places: *mut i64,
        count: *mut i64,
        complete: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Whether points are inside the solids of a closed model.
    pub fn nurbs_model_classify(
        model: *const nurbs_model,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tolerance: f64,
        sides: *mut i32,
    ) -> nurbs_status;
    /// nurbs_model_classify() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_model_classify_with(
        model: *const nurbs_model,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tolerance: f64,
        sides: *mut i32,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The points of a model that are nearest to given points.
    ///
    /// May be null: `params`, `feet`, `distances`, `status`, `places`.
    pub fn nurbs_model_closest_points(
        model: *const nurbs_model,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tolerance: f64,
        params: *mut f64,
        feet: *mut f64,
        distances: *mut f64,
        status: *mut i32,
        places: *mut i64,
    ) -> nurbs_status;
    /// nurbs_model_closest_points() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `feet`, `distances`, `status`, `places`, `call`.
    pub fn nurbs_model_closest_points_with(
        model: *const nurbs_model,
        n: i64,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        tolerance: f64,
        params: *mut f64,
        feet: *mut f64,
        distances: *mut f64,
        status: *mut i32,
        places: *mut i64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Where planes cut the faces of a model, with the curves joined to ways over shared edges.
    pub fn nurbs_model_sections(
        model: *const nurbs_model,
        n: i64,
        normals: *const f64,
        offsets: *const f64,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_model_sections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_model_sections_with(
        model: *const nurbs_model,
        n: i64,
        normals: *const f64,
        offsets: *const f64,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// Where the faces of two models meet, with the curves joined to ways over shared edges.
    pub fn nurbs_model_intersections(
        a: *const nurbs_model,
        b: *const nurbs_model,
        tolerance: f64,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// nurbs_model_intersections() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_model_intersections_with(
        a: *const nurbs_model,
        b: *const nurbs_model,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_meet,
    ) -> nurbs_status;
    /// The area of all faces of a model where they stand in the whole (nurbs_model_instances()).
    ///
    /// May be null: `error`.
    pub fn nurbs_model_area(
        model: *const nurbs_model,
        relative_tolerance: f64,
        area: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    /// nurbs_model_area() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `error`, `call`.
    pub fn nurbs_model_area_with(
        model: *const nurbs_model,
        relative_tolerance: f64,
        area: *mut f64,
        error: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Volume, centroid and inertia of the solids of a closed model.
    ///
    /// May be null: `centroid`, `inertia`, `openness`, `error`.
    pub fn nurbs_model_volume(
        model: *const nurbs_model,
        relative_tolerance: f64,
        volume: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        openness: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    /// nurbs_model_volume() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `centroid`, `inertia`, `openness`, `error`, `call`.
    pub fn nurbs_model_volume_with(
        model: *const nurbs_model,
        relative_tolerance: f64,
        volume: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        openness: *mut f64,
        error: *mut f64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The curves and surfaces of a file that are part of no face or edge, as a list.
    pub fn nurbs_model_splines(model: *const nurbs_model, out: *mut *mut nurbs_list) -> nurbs_status;
    /// The layers that one of the splines of nurbs_model_splines() is in.
    ///
    /// May be null: `layers`, `count`.
    pub fn nurbs_model_spline_layers(
        model: *const nurbs_model,
        index: i64,
        cap: i64,
        layers: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The number of layers that faces and splines of a model are in.
    pub fn nurbs_model_layer_count(model: *const nurbs_model, count: *mut i64) -> nurbs_status;
    /// The name of a layer.
    ///
    /// May be null: `buf`, `length`.
    pub fn nurbs_model_layer(
        model: *const nurbs_model,
        index: i64,
        buf: *mut c_char,
        cap: i64,
        length: *mut i64,
    ) -> nurbs_status;
    // --- Regions, and parts of faces
    /// The region of the plane that closed curves enclose, however they cross, touch or lie in each other.
    pub fn nurbs_region_create(
        count: i64,
        curves: *const *const nurbs,
        rule: i32,
        tolerance: f64,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// nurbs_region_create() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_region_create_with(
        count: i64,
        curves: *const *const nurbs,
        rule: i32,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// The union, intersection, difference or symmetric difference of two regions.
    pub fn nurbs_region_combine(
        rule: i32,
        count_a: i64,
        a: *const *const nurbs_face,
        count_b: i64,
        b: *const *const nurbs_face,
        tolerance: f64,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// nurbs_region_combine() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_region_combine_with(
        rule: i32,
        count_a: i64,
        a: *const *const nurbs_face,
        count_b: i64,
        b: *const *const nurbs_face,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// The parts into which curves in the domain of its surface divide a face.
    pub fn nurbs_face_split(
        face: *const nurbs_face,
        count: i64,
        curves: *const *const nurbs,
        tolerance: f64,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// nurbs_face_split() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_face_split_with(
        face: *const nurbs_face,
        count: i64,
        curves: *const *const nurbs,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// The parts of a face that lie on one side of a surface.
    pub fn nurbs_face_trim(
        face: *const nurbs_face,
        surface: *const nurbs,
        side: i32,
        tolerance: f64,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    /// nurbs_face_trim() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `call`.
    pub fn nurbs_face_trim_with(
        face: *const nurbs_face,
        surface: *const nurbs,
        side: i32,
        tolerance: f64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_model,
    ) -> nurbs_status;
    // --- Meshes
    /// A polyline that approximates a curve within a proven distance.
    ///
    /// May be null: `params`, `points`, `bound`, `reached`, `count`.
    pub fn nurbs_mesh_curve(
        g: *const nurbs,
        chord: f64,
        angle: f64,
        longest: f64,
        cap: i64,
        params: *mut f64,
        points: *mut f64,
        bound: *mut f64,
        reached: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    /// nurbs_mesh_curve() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `params`, `points`, `bound`, `reached`, `count`, `call`.
    pub fn nurbs_mesh_curve_with(
        g: *const nurbs,
        chord: f64,
        angle: f64,
        longest: f64,
        cap: i64,
        params: *mut f64,
        points: *mut f64,
        bound: *mut f64,
        reached: *mut i32,
        count: *mut i64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Fills an options struct with the defaults.
    pub fn nurbs_mesh_options_init(options: *mut nurbs_mesh_options, struct_size: i64) -> nurbs_status;
    /// A triangle mesh of a whole surface, within proven distances.
    ///
    /// May be null: `options`.
    pub fn nurbs_mesh_surface(
        g: *const nurbs,
        options: *const nurbs_mesh_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// nurbs_mesh_surface() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_mesh_surface_with(
        g: *const nurbs,
        options: *const nurbs_mesh_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// A triangle mesh of a trimmed face, within proven distances.
    ///
    /// May be null: `options`.
    pub fn nurbs_mesh_face(
        face: *const nurbs_face,
        options: *const nurbs_mesh_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// nurbs_mesh_face() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_mesh_face_with(
        face: *const nurbs_face,
        options: *const nurbs_mesh_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// A triangle mesh of all faces of a model, within proven distances.
    ///
    /// May be null: `options`.
    pub fn nurbs_mesh_model(
        model: *const nurbs_model,
        options: *const nurbs_mesh_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// nurbs_mesh_model() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_mesh_model_with(
        model: *const nurbs_model,
        options: *const nurbs_mesh_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// Meshes of a whole surface for several distances, as levels of detail for drawing.
    ///
    /// May be null: `options`.
    pub fn nurbs_mesh_surface_levels(
        g: *const nurbs,
        count: i64,
        chords: *const f64,
        options: *const nurbs_mesh_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// nurbs_mesh_surface_levels() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_mesh_surface_levels_with(
        g: *const nurbs,
        count: i64,
        chords: *const f64,
        options: *const nurbs_mesh_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// Meshes of a trimmed face for several distances, as nurbs_mesh_surface_levels().
    ///
    /// May be null: `options`.
    pub fn nurbs_mesh_face_levels(
        face: *const nurbs_face,
        count: i64,
        chords: *const f64,
        options: *const nurbs_mesh_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// nurbs_mesh_face_levels() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_mesh_face_levels_with(
        face: *const nurbs_face,
        count: i64,
        chords: *const f64,
        options: *const nurbs_mesh_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// Meshes of all faces of a model for several distances, as nurbs_mesh_surface_levels().
    ///
    /// May be null: `options`.
    pub fn nurbs_mesh_model_levels(
        model: *const nurbs_model,
        count: i64,
        chords: *const f64,
        options: *const nurbs_mesh_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// nurbs_mesh_model_levels() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_mesh_model_levels_with(
        model: *const nurbs_model,
        count: i64,
        chords: *const f64,
        options: *const nurbs_mesh_options,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// A mesh of hexahedra of a volume in space, on a grid of lines along its axes.
    ///
    /// May be null: `options`.
    pub fn nurbs_mesh_volume(
        g: *const nurbs,
        options: *const nurbs_mesh_options,
        limit: i64,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// nurbs_mesh_volume() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_mesh_volume_with(
        g: *const nurbs,
        options: *const nurbs_mesh_options,
        limit: i64,
        call: *const nurbs_call_options,
        out: *mut *mut nurbs_mesh,
    ) -> nurbs_status;
    /// Another handle on the same mesh, in constant time.
    pub fn nurbs_mesh_clone(mesh: *const nurbs_mesh, out: *mut *mut nurbs_mesh) -> nurbs_status;
    /// Frees a handle on a mesh.
    ///
    /// May be null: `mesh`.
    pub fn nurbs_mesh_destroy(mesh: *mut nurbs_mesh);
    /// The numbers of points, vertices, triangles, faces and edges of a mesh.
    ///
    /// May be null: `points`, `vertices`, `triangles`, `faces`, `edges`, `edge_points`.
    pub fn nurbs_mesh_counts(
        mesh: *const nurbs_mesh,
        points: *mut i64,
        vertices: *mut i64,
        triangles: *mut i64,
        faces: *mut i64,
        edges: *mut i64,
        edge_points: *mut i64,
    ) -> nurbs_status;
    /// How far a mesh and its shape are from each other: the largest distances of all faces.
    ///
    /// May be null: `from_shape`, `from_mesh`, `reached`.
    pub fn nurbs_mesh_bound(
        mesh: *const nurbs_mesh,
        from_shape: *mut f64,
        from_mesh: *mut f64,
        reached: *mut i32,
    ) -> nurbs_status;
    /// The points of a mesh.
    ///
    /// May be null: `points`, `count`.
    pub fn nurbs_mesh_points(
        mesh: *const nurbs_mesh,
        cap: i64,
        points: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// nurbs_mesh_points() in single precision.
    ///
    /// May be null: `points`, `count`.
    pub fn nurbs_mesh_points_f32(
        mesh: *const nurbs_mesh,
        cap: i64,
        points: *mut f32,
        count: *mut i64,
    ) -> nurbs_status;
    /// The vertices of a mesh, face by face.
    ///
    /// May be null: `own_points`, `params`, `normals`, `count`.
    pub fn nurbs_mesh_vertices(
        mesh: *const nurbs_mesh,
        cap: i64,
        own_points: *mut i64,
        params: *mut f64,
        normals: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The vertices of a mesh in single precision, with their points instead of indices, as for drawing.
    ///
    /// May be null: `points`, `params`, `normals`, `count`.
    pub fn nurbs_mesh_vertices_f32(
        mesh: *const nurbs_mesh,
        cap: i64,
        points: *mut f32,
        params: *mut f32,
        normals: *mut f32,
        count: *mut i64,
    ) -> nurbs_status;
    /// The triangles of a mesh, face by face.
    ///
    /// May be null: `corners`, `count`.
    pub fn nurbs_mesh_triangles(
        mesh: *const nurbs_mesh,
        flags: u32,
        cap: i64,
        corners: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// nurbs_mesh_triangles() with indices of 32 bits.
    ///
    /// May be null: `corners`, `count`.
    pub fn nurbs_mesh_triangles_i32(
        mesh: *const nurbs_mesh,
        flags: u32,
        cap: i64,
        corners: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    /// The quads of a mesh: cells of the domain that are divided into exactly two triangles.
    ///
    /// May be null: `corners`, `own_triangles`, `count`.
    pub fn nurbs_mesh_quads(
        mesh: *const nurbs_mesh,
        flags: u32,
        cap: i64,
        corners: *mut i64,
        own_triangles: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// Which vertices and triangles of a mesh belong to which face, and how near these are.
    ///
    /// May be null: `first_vertices`, `vertex_counts`, `first_triangles`, `triangle_counts`, `from_shape`,
    /// `from_mesh`, `reaches`, `count`.
    pub fn nurbs_mesh_faces(
        mesh: *const nurbs_mesh,
        cap: i64,
        first_vertices: *mut i64,
        vertex_counts: *mut i64,
        first_triangles: *mut i64,
        triangle_counts: *mut i64,
        from_shape: *mut f64,
        from_mesh: *mut f64,
        reaches: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    /// The polylines that stand for edges in a mesh.
    ///
    /// May be null: `own_edges`, `firsts`, `sizes`, `bounds`, `reaches`, `count`.
    pub fn nurbs_mesh_edges(
        mesh: *const nurbs_mesh,
        cap: i64,
        own_edges: *mut i64,
        firsts: *mut i64,
        sizes: *mut i64,
        bounds: *mut f64,
        reaches: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    /// The vertices of the polylines for edges in a mesh, each from the start of its edge to the end.
    ///
    /// May be null: `own_points`, `count`.
    pub fn nurbs_mesh_edge_points(
        mesh: *const nurbs_mesh,
        cap: i64,
        own_points: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The hexahedra of a mesh of nurbs_mesh_volume(), last axis fastest.
    ///
    /// May be null: `corners`, `domains`, `folds`, `signs`, `count`.
    pub fn nurbs_mesh_hexahedra(
        mesh: *const nurbs_mesh,
        cap: i64,
        corners: *mut i64,
        domains: *mut f64,
        folds: *mut i32,
        signs: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    /// A spline as Bezier cells, exactly: its polynomial (rational) pieces, which share control points.
    ///
    /// May be null: `own_points`, `kind`, `points`, `count`.
    pub fn nurbs_bezier_cells(
        g: *const nurbs,
        cap: i64,
        own_points: *mut i64,
        kind: *mut i32,
        points: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
    /// The control points of nurbs_bezier_cells(), last axis fastest.
    ///
    /// May be null: `points`, `weights`, `count`.
    pub fn nurbs_bezier_cell_points(
        g: *const nurbs,
        cap: i64,
        points: *mut f64,
        weights: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    // --- Writing files
    /// Fills an options struct with the defaults.
    pub fn nurbs_write_options_init(options: *mut nurbs_write_options, struct_size: i64) -> nurbs_status;
    /// The contents of a file that holds a model.
    ///
    /// May be null: `options`, `bytes`, `length`.
    pub fn nurbs_model_write(
        model: *const nurbs_model,
        format: i32,
        options: *const nurbs_write_options,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
    ) -> nurbs_status;
    /// nurbs_model_write() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `bytes`, `length`, `call`.
    pub fn nurbs_model_write_with(
        model: *const nurbs_model,
        format: i32,
        options: *const nurbs_write_options,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Writes a model to a file.
    ///
    /// May be null: `options`.
    pub fn nurbs_model_write_file(
        model: *const nurbs_model,
        path: *const c_char,
        format: i32,
        options: *const nurbs_write_options,
    ) -> nurbs_status;
    /// nurbs_model_write_file() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_model_write_file_with(
        model: *const nurbs_model,
        path: *const c_char,
        format: i32,
        options: *const nurbs_write_options,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The contents of a file that holds the curves and surfaces of a list.
    ///
    /// May be null: `options`, `bytes`, `length`.
    pub fn nurbs_list_write(
        list: *const nurbs_list,
        format: i32,
        options: *const nurbs_write_options,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
    ) -> nurbs_status;
    /// nurbs_list_write() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `bytes`, `length`, `call`.
    pub fn nurbs_list_write_with(
        list: *const nurbs_list,
        format: i32,
        options: *const nurbs_write_options,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Writes the curves and surfaces of a list to a file, as nurbs_model_write_file() does.
    ///
    /// May be null: `options`.
    pub fn nurbs_list_write_file(
        list: *const nurbs_list,
        path: *const c_char,
        format: i32,
        options: *const nurbs_write_options,
    ) -> nurbs_status;
    /// nurbs_list_write_file() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_list_write_file_with(
        list: *const nurbs_list,
        path: *const c_char,
        format: i32,
        options: *const nurbs_write_options,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// The contents of a file that holds a mesh: its triangles, with what the model says about them.
    ///
    /// May be null: `options`, `bytes`, `length`.
    pub fn nurbs_mesh_write(
        mesh: *const nurbs_mesh,
        format: i32,
        options: *const nurbs_write_options,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
    ) -> nurbs_status;
    /// nurbs_mesh_write() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `bytes`, `length`, `call`.
    pub fn nurbs_mesh_write_with(
        mesh: *const nurbs_mesh,
        format: i32,
        options: *const nurbs_write_options,
        cap: i64,
        bytes: *mut c_void,
        length: *mut i64,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
    /// Writes a mesh to a file, as nurbs_model_write_file() does.
    ///
    /// May be null: `options`.
    pub fn nurbs_mesh_write_file(
        mesh: *const nurbs_mesh,
        path: *const c_char,
        format: i32,
        options: *const nurbs_write_options,
    ) -> nurbs_status;
    /// nurbs_mesh_write_file() with progress reports, cancellation and a limit of work.
    ///
    /// May be null: `options`, `call`.
    pub fn nurbs_mesh_write_file_with(
        mesh: *const nurbs_mesh,
        path: *const c_char,
        format: i32,
        options: *const nurbs_write_options,
        call: *const nurbs_call_options,
    ) -> nurbs_status;
}

// SPDX-License-Identifier: MIT
//! The C interface as it stands: the names, arguments and constants of `nurbs.h`, which is the manual.

#![allow(non_camel_case_types)]

use std::os::raw::{c_char, c_void};

/// A spline. Never made or moved on this side.
#[repr(C)]
pub struct nurbs {
    _private: [u8; 0],
}

/// What a file held. Never made or moved on this side.
#[repr(C)]
pub struct nurbs_list {
    _private: [u8; 0],
}

pub type nurbs_status = i32;

/// Settings for reading, filled by `nurbs_read_options_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct nurbs_read_options {
    pub struct_size: i64,
    pub unit: f64,
    pub max_bytes: i64,
}

pub const NURBS_VERSION_MAJOR: i32 = 1;
pub const NURBS_VERSION_MINOR: i32 = 0;
pub const NURBS_VERSION_PATCH: i32 = 0;
pub const NURBS_VERSION: i32 = NURBS_VERSION_MAJOR * 10000 + NURBS_VERSION_MINOR * 100 + NURBS_VERSION_PATCH;
pub const NURBS_MAX_DEGREE: i32 = 31;
pub const NURBS_MAX_AXES: i32 = 3;
pub const NURBS_MAX_ORDER: i32 = 255;

// Statuses
pub const NURBS_OK: nurbs_status = 0;
pub const NURBS_ERROR_NULL: nurbs_status = 1;
pub const NURBS_ERROR_AXES: nurbs_status = 2;
pub const NURBS_ERROR_AXIS: nurbs_status = 3;
pub const NURBS_ERROR_DEGREE: nurbs_status = 4;
pub const NURBS_ERROR_COUNT: nurbs_status = 5;
pub const NURBS_ERROR_TOO_FEW_POINTS: nurbs_status = 6;
pub const NURBS_ERROR_OVERFLOW: nurbs_status = 7;
pub const NURBS_ERROR_SIZE: nurbs_status = 8;
pub const NURBS_ERROR_DIMENSION: nurbs_status = 9;
pub const NURBS_ERROR_STRIDE: nurbs_status = 10;
pub const NURBS_ERROR_OVERLAP: nurbs_status = 11;
pub const NURBS_ERROR_FLAGS: nurbs_status = 12;
pub const NURBS_ERROR_ORDER: nurbs_status = 13;
pub const NURBS_ERROR_KNOT_NOT_FINITE: nurbs_status = 14;
pub const NURBS_ERROR_KNOTS_DECREASING: nurbs_status = 15;
pub const NURBS_ERROR_END_MULTIPLICITY: nurbs_status = 16;
pub const NURBS_ERROR_MULTIPLICITY: nurbs_status = 17;
pub const NURBS_ERROR_EMPTY_DOMAIN: nurbs_status = 18;
pub const NURBS_ERROR_POINT_NOT_FINITE: nurbs_status = 19;
pub const NURBS_ERROR_WEIGHT_NOT_FINITE: nurbs_status = 20;
pub const NURBS_ERROR_WEIGHT_NEGATIVE: nurbs_status = 21;
pub const NURBS_ERROR_WEIGHTS_VANISH: nurbs_status = 22;
pub const NURBS_ERROR_PARAMETER_NOT_FINITE: nurbs_status = 23;
pub const NURBS_ERROR_PERIODIC_KNOTS: nurbs_status = 24;
pub const NURBS_ERROR_PERIODIC_POINTS: nurbs_status = 25;
pub const NURBS_ERROR_TIMES: nurbs_status = 26;
pub const NURBS_ERROR_OPTIONS: nurbs_status = 27;
pub const NURBS_ERROR_INDEX: nurbs_status = 28;
pub const NURBS_ERROR_DIRECTION: nurbs_status = 29;
pub const NURBS_ERROR_END_KNOT: nurbs_status = 30;
pub const NURBS_ERROR_NOT_A_KNOT: nurbs_status = 31;
pub const NURBS_ERROR_MATRIX: nurbs_status = 32;
pub const NURBS_ERROR_RATIONAL: nurbs_status = 33;
pub const NURBS_ERROR_INCOMPATIBLE: nurbs_status = 40;
pub const NURBS_ERROR_GAP: nurbs_status = 41;
pub const NURBS_ERROR_TOLERANCE: nurbs_status = 42;
pub const NURBS_ERROR_NOT_PERIODIC: nurbs_status = 43;
pub const NURBS_ERROR_END_WEIGHTS: nurbs_status = 44;
pub const NURBS_ERROR_FACTOR: nurbs_status = 45;
pub const NURBS_ERROR_PERIODIC: nurbs_status = 48;
pub const NURBS_ERROR_END: nurbs_status = 49;
pub const NURBS_ERROR_BASIS: nurbs_status = 50;
pub const NURBS_ERROR_NOT_MONOTONE: nurbs_status = 51;
pub const NURBS_ERROR_CONTINUITY: nurbs_status = 46;
pub const NURBS_ERROR_WEIGHT_SIGN: nurbs_status = 47;
pub const NURBS_ERROR_ANGLE: nurbs_status = 52;
pub const NURBS_ERROR_LENGTH: nurbs_status = 53;
pub const NURBS_ERROR_COLLINEAR: nurbs_status = 54;
pub const NURBS_ERROR_CONIC: nurbs_status = 55;
pub const NURBS_ERROR_FORM: nurbs_status = 56;
pub const NURBS_ERROR_TANGENT: nurbs_status = 57;
pub const NURBS_ERROR_TWIST: nurbs_status = 58;
pub const NURBS_ERROR_TWIST_RULE: nurbs_status = 59;
pub const NURBS_ERROR_INFLUENCE: nurbs_status = 60;
pub const NURBS_ERROR_CONTRADICTION: nurbs_status = 61;
pub const NURBS_ERROR_CONSTRAINT: nurbs_status = 62;
pub const NURBS_ERROR_OFF_POLYGON: nurbs_status = 63;
pub const NURBS_ERROR_OUTSIDE_DOMAIN: nurbs_status = 100;
pub const NURBS_ERROR_NOT_REPRESENTABLE: nurbs_status = 200;
pub const NURBS_ERROR_KNOTS_MERGE: nurbs_status = 202;
pub const NURBS_ERROR_NOT_CONVERGED: nurbs_status = 203;
pub const NURBS_ERROR_MEMORY: nurbs_status = 300;
pub const NURBS_ERROR_FILE: nurbs_status = 301;
pub const NURBS_ERROR_TOO_LARGE: nurbs_status = 302;
pub const NURBS_ERROR_FORMAT: nurbs_status = 400;
pub const NURBS_ERROR_TRUNCATED: nurbs_status = 401;
pub const NURBS_ERROR_SYNTAX: nurbs_status = 402;
pub const NURBS_ERROR_UNSUPPORTED: nurbs_status = 403;
pub const NURBS_ERROR_INTERNAL: nurbs_status = 900;

// Flags of one axis, to be moved with on_axis() or on_all_axes()
pub const NURBS_LEFT: u32 = 0x01;
pub const NURBS_CLAMP: u32 = 0x02;
pub const NURBS_EXTRAPOLATE: u32 = 0x04;
pub const NURBS_WRAP: u32 = 0x08;
pub const NURBS_NAN: u32 = 0x10;
pub const NURBS_PERIODIC: u32 = 0x01;

// Global flags
pub const NURBS_ACCUMULATE: u32 = 0x01000000;
pub const NURBS_KEEP_DOMAIN: u32 = 0x02000000;
pub const NURBS_KEEP_GAPS: u32 = 0x04000000;
pub const NURBS_PRODUCT_DOT: u32 = 0x08000000;
pub const NURBS_PRODUCT_CROSS: u32 = 0x10000000;
pub const NURBS_HOMOGENEOUS: u32 = 0x20000000;
pub const NURBS_MAP_DOMAINS: u32 = 0x40000000;
pub const NURBS_RULED_CARTESIAN: u32 = 0x80000000;
pub const NURBS_HEMISPHERE: u32 = 0x01000000;
pub const NURBS_TWO_SHEETS: u32 = 0x02000000;
pub const NURBS_EQUAL_CHORDS: u32 = 0x02000000;
pub const NURBS_REVERSED: u32 = 0x04000000;
pub const NURBS_NAN_POINTS: u32 = 0x01000000;
pub const NURBS_BASIS_POWER: i32 = 0;
pub const NURBS_BASIS_BERNSTEIN: i32 = 1;
pub const NURBS_BASIS_HERMITE: i32 = 2;
pub const NURBS_BASIS_BSPLINE: i32 = 3;
pub const NURBS_START: i32 = 0;
pub const NURBS_END: i32 = 1;

// Bits of the form of a knot vector
pub const NURBS_FORM_CLAMPED_START: i32 = 0x01;
pub const NURBS_FORM_CLAMPED_END: i32 = 0x02;
pub const NURBS_FORM_PERIODIC: i32 = 0x04;

// Bits of the status of a point of a frame
pub const NURBS_FRAME_LIMIT: i32 = 0x01;
pub const NURBS_FRAME_NORMAL_LIMIT: i32 = 0x02;
pub const NURBS_FRAME_RULE: i32 = 0x04;
pub const NURBS_FRAME_UNDEFINED: i32 = 0x08;

// Forms of an arc
pub const NURBS_ARC_QUARTERS: i32 = 0;
pub const NURBS_ARC_THIRDS: i32 = 1;
pub const NURBS_ARC_SMOOTH: i32 = 2;

// Kinds of conics
pub const NURBS_CONIC_ELLIPSE: i32 = 1;
pub const NURBS_CONIC_PARABOLA: i32 = 2;
pub const NURBS_CONIC_HYPERBOLA: i32 = 3;
pub const NURBS_CONIC_CHORD: i32 = 4;
pub const NURBS_CONIC_LEGS: i32 = 5;
pub const NURBS_CONIC_LINE: i32 = 6;

// Twists of a bicubic Coons surface
pub const NURBS_TWIST_COMPATIBLE: i32 = 0;
pub const NURBS_TWIST_AVERAGE: i32 = 1;
pub const NURBS_TWIST_GIVEN: i32 = 2;
pub const NURBS_TWIST_ZERO: i32 = 3;
pub const NURBS_TWIST_BILINEAR: i32 = 4;
pub const NURBS_TWIST_ADINI: i32 = 5;

// Shapes that are recognized
pub const NURBS_SHAPE_NONE: i32 = 0;
pub const NURBS_SHAPE_POINT: i32 = 1;
pub const NURBS_SHAPE_LINE: i32 = 2;
pub const NURBS_SHAPE_CIRCLE: i32 = 3;
pub const NURBS_SHAPE_ELLIPSE: i32 = 4;
pub const NURBS_SHAPE_PARABOLA: i32 = 5;
pub const NURBS_SHAPE_HYPERBOLA: i32 = 6;
pub const NURBS_SHAPE_PLANE: i32 = 7;
pub const NURBS_SHAPE_SPHERE: i32 = 8;
pub const NURBS_SHAPE_CYLINDER: i32 = 9;
pub const NURBS_SHAPE_CONE: i32 = 10;
pub const NURBS_SHAPE_TORUS: i32 = 11;

// Bits of the status of a closest point
pub const NURBS_CLOSEST_CERTIFIED: i32 = 0x01;
pub const NURBS_CLOSEST_BOUNDARY: i32 = 0x02;
pub const NURBS_CLOSEST_NOT_UNIQUE: i32 = 0x04;
pub const NURBS_CLOSEST_BUDGET: i32 = 0x08;
pub const NURBS_CLOSEST_INVALID: i32 = 0x10;
pub const NURBS_CLOSEST_COARSE: i32 = 0x20;
pub const NURBS_CLOSEST_LEFT: i32 = 0x100;

// Kinds of critical points
pub const NURBS_CRITICAL_MINIMUM: i32 = 1;
pub const NURBS_CRITICAL_MAXIMUM: i32 = 2;
pub const NURBS_CRITICAL_SADDLE: i32 = 3;
pub const NURBS_CRITICAL_UNDECIDED: i32 = 4;

// Features of curves
pub const NURBS_FEATURE_INFLECTION: u32 = 0x01;
pub const NURBS_FEATURE_CURVATURE_MAXIMUM: u32 = 0x02;
pub const NURBS_FEATURE_CURVATURE_MINIMUM: u32 = 0x04;
pub const NURBS_FEATURE_CUSP: u32 = 0x08;
pub const NURBS_FEATURE_KINK: u32 = 0x10;
pub const NURBS_FEATURE_JUMP: u32 = 0x20;
pub const NURBS_FEATURE_TORSION: u32 = 0x40;

// Convexity of a curve in the plane
pub const NURBS_CONVEXITY_NONE: i32 = 0;
pub const NURBS_CONVEXITY_LEFT: i32 = 1;
pub const NURBS_CONVEXITY_RIGHT: i32 = 2;
pub const NURBS_CONVEXITY_STRAIGHT: i32 = 3;
pub const NURBS_CONVEXITY_UNDECIDED: i32 = 4;

// Folds
pub const NURBS_FOLD_NONE: i32 = 0;
pub const NURBS_FOLD_FOUND: i32 = 1;
pub const NURBS_FOLD_UNDECIDED: i32 = 2;

// Kinds of constraints
pub const NURBS_CONSTRAIN_VALUE: i32 = 0;
pub const NURBS_CONSTRAIN_DIRECTION: i32 = 1;
pub const NURBS_CONSTRAIN_NORMAL: i32 = 2;
pub const NURBS_CONSTRAIN_CURVATURE: i32 = 3;

#[link(name = "nurbs")]
extern "C" {
    pub fn nurbs_version() -> i32;
    pub fn nurbs_status_name(status: nurbs_status) -> *const c_char;
    pub fn nurbs_last_error(buf: *mut c_char, cap: i64) -> i64;
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
    pub fn nurbs_with_points(
        g: *const nurbs,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        weights: *const f64,
        weight_stride: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_clone(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_destroy(g: *mut nurbs);
    pub fn nurbs_knots_uniform(
        degree: i32,
        count: i64,
        a: f64,
        b: f64,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_knots_open_uniform(
        degree: i32,
        count: i64,
        a: f64,
        b: f64,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_knots_bezier(
        degree: i32,
        pieces: i64,
        breaks: *const f64,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_knots_averaged(
        degree: i32,
        count: i64,
        params: *const f64,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_knots_periodic(
        degree: i32,
        n: i64,
        breaks: *const f64,
        multiplicities: *const i32,
        knot_count: i64,
        knots: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_axes(g: *const nurbs, axes: *mut i32) -> nurbs_status;
    pub fn nurbs_dimension(g: *const nurbs, dim: *mut i32) -> nurbs_status;
    pub fn nurbs_degree(g: *const nurbs, axis: i32, degree: *mut i32) -> nurbs_status;
    pub fn nurbs_count(g: *const nurbs, axis: i32, count: *mut i64) -> nurbs_status;
    pub fn nurbs_point_count(g: *const nurbs, count: *mut i64) -> nurbs_status;
    pub fn nurbs_is_rational(g: *const nurbs, rational: *mut i32) -> nurbs_status;
    pub fn nurbs_knots(g: *const nurbs, axis: i32, knot_count: i64, knots: *mut f64) -> nurbs_status;
    pub fn nurbs_distinct_knots(
        g: *const nurbs,
        axis: i32,
        cap: i64,
        knots: *mut f64,
        multiplicities: *mut i32,
        count: *mut i64,
    ) -> nurbs_status;
    pub fn nurbs_knot_form(g: *const nurbs, axis: i32, form: *mut i32) -> nurbs_status;
    pub fn nurbs_domain(g: *const nurbs, axis: i32, domain: *mut f64) -> nurbs_status;
    pub fn nurbs_greville(g: *const nurbs, axis: i32, count: i64, abscissae: *mut f64) -> nurbs_status;
    pub fn nurbs_points(
        g: *const nurbs,
        count: i64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
    ) -> nurbs_status;
    pub fn nurbs_weights(g: *const nurbs, count: i64, weights: *mut f64, weight_stride: i64) -> nurbs_status;
    pub fn nurbs_homogeneous_points(
        g: *const nurbs,
        count: i64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
    ) -> nurbs_status;
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
    pub fn nurbs_derivative_slots(axes: i32, order: i32, slots: *mut i64) -> nurbs_status;
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
    pub fn nurbs_eval_grid(
        g: *const nurbs,
        counts: *const i64,
        params: *const f64,
        points: *mut f64,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
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
    pub fn nurbs_eval_grid_f32(
        g: *const nurbs,
        counts: *const i64,
        params: *const f64,
        points: *mut f32,
        point_stride: i64,
        point_component_stride: i64,
        flags: u32,
    ) -> nurbs_status;
    pub fn nurbs_iso(
        g: *const nurbs,
        axis: i32,
        param: f64,
        flags: u32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_insert_knot(
        g: *const nurbs,
        axis: i32,
        knot: f64,
        times: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_elevate(g: *const nurbs, axis: i32, times: i32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_reverse(g: *const nurbs, axis: i32, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_transpose(g: *const nurbs, permutation: *const i32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_reparametrize(
        g: *const nurbs,
        axis: i32,
        lower: f64,
        upper: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_make_rational(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_to_homogeneous(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_from_homogeneous(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_normalize_weights(g: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_reparametrize_moebius(
        g: *const nurbs,
        axis: i32,
        ratio: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_equalize_end_weights(g: *const nurbs, axis: i32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_blossom(
        g: *const nurbs,
        params: *const f64,
        count: i64,
        args: *const f64,
        values: *mut f64,
        flags: u32,
    ) -> nurbs_status;
    pub fn nurbs_derivative(g: *const nurbs, axis: i32, order: i32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_antiderivative(g: *const nurbs, axis: i32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_product(a: *const nurbs, b: *const nurbs, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_compose(g: *const nurbs, f: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_sum(
        a: *const nurbs,
        alpha: f64,
        b: *const nurbs,
        beta: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_transform(
        g: *const nurbs,
        out_dim: i32,
        matrix: *const f64,
        translation: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_transform_projective(
        g: *const nurbs,
        out_dim: i32,
        matrix: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_refine(
        g: *const nurbs,
        axis: i32,
        count: i64,
        knots: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_refine_uniform(g: *const nurbs, axis: i32, parts: i64, out: *mut *mut nurbs)
        -> nurbs_status;
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
    pub fn nurbs_split(
        g: *const nurbs,
        axis: i32,
        param: f64,
        lower: *mut *mut nurbs,
        upper: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_extract(
        g: *const nurbs,
        lower: *const f64,
        upper: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_decompose(g: *const nurbs, out: *mut *mut nurbs_list) -> nurbs_status;
    pub fn nurbs_split_at_knots(
        g: *const nurbs,
        axis: i32,
        order: i32,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    pub fn nurbs_clamp_ends(g: *const nurbs, axis: i32, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_move_seam(g: *const nurbs, axis: i32, param: f64, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_snap_knots(
        g: *const nurbs,
        axis: i32,
        tolerance: f64,
        deviation: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_make_compatible(
        count: i64,
        splines: *const *const nurbs,
        tolerance: f64,
        flags: u32,
        deviation: *mut f64,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
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
    pub fn nurbs_to_hermite(
        g: *const nurbs,
        cap: i64,
        params: *mut f64,
        points: *mut f64,
        tangents: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
    pub fn nurbs_to_power(
        g: *const nurbs,
        cap: i64,
        coefficients: *mut f64,
        breaks: *mut f64,
        piece_counts: *mut i64,
        count: *mut i64,
    ) -> nurbs_status;
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
    pub fn nurbs_basis_matrix(from: i32, to: i32, degree: i32, size: i64, matrix: *mut f64) -> nurbs_status;
    pub fn nurbs_mirror(
        g: *const nurbs,
        point: *const f64,
        normal: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_project_to_plane(
        g: *const nurbs,
        point: *const f64,
        normal: *const f64,
        direction: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_project_from(
        g: *const nurbs,
        eye: *const f64,
        point: *const f64,
        normal: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_extend(
        g: *const nurbs,
        axis: i32,
        end: i32,
        amount: f64,
        order: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_unclamp(g: *const nurbs, axis: i32, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_make_periodic(
        g: *const nurbs,
        axis: i32,
        tolerance: f64,
        deviation: *mut f64,
        order: *mut i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_detect_periodic(g: *const nurbs, axis: i32, periodic: *mut i32) -> nurbs_status;
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
    pub fn nurbs_join(
        count: i64,
        parts: *const *const nurbs,
        axis: i32,
        tolerance: f64,
        flags: u32,
        gap: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_deviation(
        f: *const nurbs,
        g: *const nurbs,
        at_least: *mut f64,
        at_most: *mut f64,
    ) -> nurbs_status;
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
    pub fn nurbs_reduce_knots(
        g: *const nurbs,
        axis: i32,
        tolerance: f64,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_reduce_degree(
        g: *const nurbs,
        axis: i32,
        times: i32,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_simplify(g: *const nurbs, tolerance: f64, bound: *mut f64, out: *mut *mut nurbs)
        -> nurbs_status;
    pub fn nurbs_curve_line(dim: i32, a: *const f64, b: *const f64, out: *mut *mut nurbs) -> nurbs_status;
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
    pub fn nurbs_curve_polygon(
        dim: i32,
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        sides: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_curve_circle(
        dim: i32,
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_curve_arc_through(
        dim: i32,
        a: *const f64,
        b: *const f64,
        c: *const f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_curve_arc_tangent(
        dim: i32,
        a: *const f64,
        tangent: *const f64,
        b: *const f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_curve_conic_triangle(
        dim: i32,
        p0: *const f64,
        p1: *const f64,
        p2: *const f64,
        shape_factor: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_curve_conic_shoulder(
        dim: i32,
        a: *const f64,
        tangent_a: *const f64,
        b: *const f64,
        tangent_b: *const f64,
        rho: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_curve_conic_through(
        dim: i32,
        points: *const f64,
        point_stride: i64,
        point_component_stride: i64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_conic_axes(
        coefficients: *const f64,
        r#type: *mut i32,
        origin: *mut f64,
        x: *mut f64,
        sizes: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_curve_conic_implicit(
        coefficients: *const f64,
        start: f64,
        end: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_curve_shape_factor(g: *const nurbs, factor: *mut f64, r#type: *mut i32) -> nurbs_status;
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
    pub fn nurbs_extrude(g: *const nurbs, vector: *const f64, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_revolve(
        g: *const nurbs,
        point: *const f64,
        axis: *const f64,
        sweep: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_ruled(a: *const nurbs, b: *const nurbs, flags: u32, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_tensor_sum(
        a: *const nurbs,
        alpha: f64,
        b: *const nurbs,
        beta: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_tensor_product(a: *const nurbs, b: *const nurbs, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_surface_swung(
        trajectory: *const nurbs,
        profile: *const nurbs,
        scale: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_surface_plane(
        dim: i32,
        origin: *const f64,
        u: *const f64,
        v: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_surface_bilinear(
        dim: i32,
        corners: *const f64,
        corner_stride: i64,
        corner_component_stride: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_volume_trilinear(
        dim: i32,
        corners: *const f64,
        corner_stride: i64,
        corner_component_stride: i64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_surface_sphere(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        form: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_surface_sphere_patches(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius: f64,
        flags: u32,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
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
    pub fn nurbs_surface_saddle(
        center: *const f64,
        axis: *const f64,
        x: *const f64,
        radius_x: f64,
        radius_y: f64,
        height: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_boundaries(g: *const nurbs, out: *mut *mut nurbs_list) -> nurbs_status;
    pub fn nurbs_surface_coons(
        boundaries: *const *const nurbs,
        tolerance: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_surface_coons_hermite(
        boundaries: *const *const nurbs,
        cross: *const *const nurbs,
        twist: i32,
        twists: *const f64,
        tolerance: f64,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_coons_gaps(
        boundaries: *const *const nurbs,
        cross: *const *const nurbs,
        positions: *mut f64,
        tangents: *mut f64,
        twists: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_volume_coons(
        faces: *const *const nurbs,
        tolerance: f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_recognize(
        g: *const nurbs,
        tolerance: f64,
        shape: *mut i32,
        placement: *mut f64,
        sizes: *mut f64,
        deviation: *mut f64,
    ) -> nurbs_status;
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
    pub fn nurbs_curve_length(
        g: *const nurbs,
        range: *const f64,
        relative_tolerance: f64,
        length: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_curve_lengths(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        relative_tolerance: f64,
        lengths: *mut f64,
        length_stride: i64,
    ) -> nurbs_status;
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
    pub fn nurbs_curve_divide(
        g: *const nurbs,
        range: *const f64,
        parts: i64,
        relative_tolerance: f64,
        flags: u32,
        params: *mut f64,
        size: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_surface_area(
        g: *const nurbs,
        range: *const f64,
        relative_tolerance: f64,
        area: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_moments(
        g: *const nurbs,
        relative_tolerance: f64,
        content: *mut f64,
        centroid: *mut f64,
        inertia: *mut f64,
        error: *mut f64,
    ) -> nurbs_status;
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
    pub fn nurbs_box(
        g: *const nurbs,
        range: *const f64,
        tolerance: f64,
        lower: *mut f64,
        upper: *mut f64,
        gap: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_oriented_box(
        g: *const nurbs,
        tolerance: f64,
        center: *mut f64,
        axes: *mut f64,
        half: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_tangent_cone(
        g: *const nurbs,
        axis: i32,
        range: *const f64,
        tolerance: f64,
        direction: *mut f64,
        angle: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_normal_cone(
        g: *const nurbs,
        range: *const f64,
        tolerance: f64,
        direction: *mut f64,
        angle: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_extreme_point(
        g: *const nurbs,
        direction: *const f64,
        range: *const f64,
        tolerance: f64,
        params: *mut f64,
        value: *mut f64,
        bound: *mut f64,
    ) -> nurbs_status;
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
    pub fn nurbs_curve_monotone_pieces(
        g: *const nurbs,
        direction: *const f64,
        cap: i64,
        starts: *mut f64,
        signs: *mut i32,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    pub fn nurbs_curve_convexity(g: *const nurbs, convexity: *mut i32) -> nurbs_status;
    pub fn nurbs_straightness(
        g: *const nurbs,
        origin: *mut f64,
        direction: *mut f64,
        bound: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_planarity(
        g: *const nurbs,
        origin: *mut f64,
        normal: *mut f64,
        bound: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_boundary_contacts(
        g: *const nurbs,
        tolerance: f64,
        closed: *mut i32,
        gaps: *mut f64,
        collapsed: *mut i32,
        sizes: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_singular_points(
        g: *const nurbs,
        tolerance: f64,
        cap: i64,
        params: *mut f64,
        boxes: *mut f64,
        count: *mut i64,
        complete: *mut i32,
    ) -> nurbs_status;
    pub fn nurbs_fold_test(
        g: *const nurbs,
        reference: *const f64,
        result: *mut i32,
        positive: *mut f64,
        negative: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_pull_weight(
        g: *const nurbs,
        index: i64,
        params: *const f64,
        distance: f64,
        weight: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_pull_weights(
        g: *const nurbs,
        count: i64,
        indices: *const i64,
        params: *const f64,
        distance: f64,
        factor: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_set_weights(
        g: *const nurbs,
        count: i64,
        indices: *const i64,
        weights: *const f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_weight_points(
        g: *const nurbs,
        index: i64,
        params: *const f64,
        at_zero: *mut f64,
        at_one: *mut f64,
        at_weight: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_weight_cross_ratio(
        dim: i32,
        control_point: *const f64,
        at_zero: *const f64,
        at_one: *const f64,
        at_weight: *const f64,
        weight: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_weight_through(
        g: *const nurbs,
        index: i64,
        params: *const f64,
        target: *const f64,
        tolerance: f64,
        weight: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_pull_point(
        g: *const nurbs,
        index: i64,
        params: *const f64,
        direction: *const f64,
        distance: f64,
        moved: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_most_influential(
        g: *const nurbs,
        n: i64,
        params: *const f64,
        param_stride: i64,
        param_component_stride: i64,
        indices: *mut i64,
        influences: *mut f64,
    ) -> nurbs_status;
    pub fn nurbs_insert_on_leg(
        g: *const nurbs,
        axis: i32,
        index: i64,
        ratio: f64,
        knot: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_warp(
        g: *const nurbs,
        range: *const f64,
        direction: *const f64,
        distance: f64,
        order: i32,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
    pub fn nurbs_flatten(
        g: *const nurbs,
        range: *const f64,
        point: *const f64,
        normal: *const f64,
        direction: *const f64,
        moved: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_fair(
        g: *const nurbs,
        order: i32,
        keep: *const i32,
        tolerance: f64,
        energies: *mut f64,
        bound: *mut f64,
        out: *mut *mut nurbs,
    ) -> nurbs_status;
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
    pub fn nurbs_bezier_extraction(
        g: *const nurbs,
        axis: i32,
        cap: i64,
        operators: *mut f64,
        firsts: *mut i64,
        domains: *mut f64,
        count: *mut i64,
    ) -> nurbs_status;
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
    pub fn nurbs_read_options_init(options: *mut nurbs_read_options, struct_size: i64) -> nurbs_status;
    pub fn nurbs_read(
        bytes: *const c_void,
        size: i64,
        options: *const nurbs_read_options,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    pub fn nurbs_read_file(
        path: *const c_char,
        options: *const nurbs_read_options,
        out: *mut *mut nurbs_list,
    ) -> nurbs_status;
    pub fn nurbs_list_count(list: *const nurbs_list, count: *mut i64) -> nurbs_status;
    pub fn nurbs_list_get(list: *const nurbs_list, index: i64, out: *mut *mut nurbs) -> nurbs_status;
    pub fn nurbs_list_name(
        list: *const nurbs_list,
        index: i64,
        buf: *mut c_char,
        cap: i64,
        length: *mut i64,
    ) -> nurbs_status;
    pub fn nurbs_list_note_count(list: *const nurbs_list, count: *mut i64) -> nurbs_status;
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
    pub fn nurbs_list_unit(list: *const nurbs_list, metres: *mut f64) -> nurbs_status;
    pub fn nurbs_list_destroy(list: *mut nurbs_list);
}

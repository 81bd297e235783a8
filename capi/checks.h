// SPDX-License-Identifier: MIT
// Checks of the arguments of C functions. They throw, so they are only for use inside guard().
#pragma once

#include "base/records.h"
#include "handle.h"

#include <cstdint>
#include <initializer_list>
#include <span>

namespace nrb::capi {

[[noreturn]] void fail_null(const char *name);
[[noreturn]] void fail_length(int64_t n, const char *name);

// Throws NURBS_ERROR_NULL naming the argument. Checks that even the shortest calls make are inline, but the
// code for their messages is not.
inline void require(const void *pointer, const char *name) {
    if (pointer == nullptr) {
        fail_null(name);
    }
}
// require() for the address of a new handle. Also sets *out to NULL, so that it is NULL if anything fails
// later.
template <class Handle>
void require_out(Handle **out) {
    require(out, "out");
    *out = nullptr;
}
inline const Spline &spline_of(const ::nurbs *g) {
    require(g, "g");
    return *g->spline;
}
inline const face::Face &face_of(const ::nurbs_face *face) {
    require(face, "face");
    return *face->face;
}
inline const model::Model &model_of(const ::nurbs_model *model) {
    require(model, "model");
    return *model->model;
}

// The spline of one of several handles; `name` is the name of the argument.
inline const Spline &named(const ::nurbs *g, const char *name) {
    require(g, name);
    return *g->spline;
}
const Spline &curve_of(const ::nurbs *g);
const Spline &surface_of(const ::nurbs *g);

void check_axis(const Spline &spline, int32_t axis);
void check_order(int32_t order);
// Throws NURBS_ERROR_FACTOR unless the factor is finite.
void check_factor(double factor, const char *name);
// Throws NURBS_ERROR_POINT_NOT_FINITE unless all coordinates are finite.
void check_points(const char *name, const ConstRecords &points);
// Throws NURBS_ERROR_DIRECTION if a vector in space is zero or not finite. index: its index in an array; < 0:
// it is the only one.
void check_direction(const char *name, const double *x, int64_t index = -1);
// The n values of an array. Throws NURBS_ERROR_COUNT, _OVERFLOW or _NULL for the array, and
// NURBS_ERROR_POINT_NOT_FINITE unless all values are finite.
std::span<const double> checked_values(int64_t n, const double *values, const char *name);
// Throws NURBS_ERROR_PARAMETER_NOT_FINITE or _OUTSIDE_DOMAIN unless t is finite and in the closed domain of
// the axis.
void check_place(double t, Interval domain, const char *name, int axis);
// The ends of an axis that NURBS_FORM_CLAMPED_START and NURBS_FORM_CLAMPED_END select. Throws
// NURBS_ERROR_FLAGS for flags other than these and `others`, which the message calls `name`.
refine::AxisEnds decode_ends(uint32_t flags, uint32_t others = 0, const char *name = "");
// Whether an end is the upper one; throws NURBS_ERROR_END for a value that is not an end.
bool upper_end(int32_t end, const char *name);
// n >= 0, else NURBS_ERROR_COUNT.
inline void check_length(int64_t n, const char *name) {
    if (n < 0) {
        fail_length(n, name);
    }
}
// n >= least, else NURBS_ERROR_COUNT.
void check_at_least(int64_t n, int64_t least, const char *name);
// The largest number of pieces that a search may examine: `usual` if the budget is 0. Throws
// NURBS_ERROR_COUNT if it is negative.
int64_t checked_budget(int64_t budget, int64_t usual);
// Checks the highest orders of derivatives that stay at the two ends of each axis, [axes][2], -1 for none.
// NULL is allowed. Throws NURBS_ERROR_ORDER.
void check_keep(const Spline &spline, const int32_t *keep);
// n == expected, else NURBS_ERROR_SIZE; NURBS_ERROR_OVERFLOW if no array can have that length.
void check_size(int64_t n, int64_t expected, const char *name);

// A view of `count` records of `width` values. Strides of 0 (packed) are replaced by the true ones, and all
// strides are checked. The pointer may be NULL if count is 0.
ConstRecords input(const char *name, const double *data, int64_t count, int64_t width, int64_t stride,
                   int64_t component_stride);
Records output(const char *name, double *data, int64_t count, int64_t width, int64_t stride,
               int64_t component_stride);
FloatRecords output(const char *name, float *data, int64_t count, int64_t width, int64_t stride,
                    int64_t component_stride);
// A strided list of single values.
inline ConstRecords input(const char *name, const double *data, int64_t count, int64_t stride) {
    return input(name, data, count, 1, stride, 0);
}

// An output as a read-only view, for the check that other outputs do not overlap it.
inline ConstRecords read_only(Records out) noexcept {
    return {out.data, out.count, out.width, out.stride, out.component_stride};
}

// Throws NURBS_ERROR_OVERLAP if the ranges of bytes that the two arrays reach over overlap. Records of
// doubles may interleave, as columns of one table: with equal strides, and components side by side.
void check_overlap(const char *out_name, const Records &out, const char *in_name, const ConstRecords &in);
void check_overlap(const char *out_name, const FloatRecords &out, const char *in_name,
                   const ConstRecords &in);
void check_overlap(const char *out_name, const void *out, int64_t out_bytes, const char *in_name,
                   const void *in, int64_t in_bytes);

// An array of any type as a range of bytes, which is empty if the pointer is NULL.
struct Memory {
    const char *name;
    const void *data;
    int64_t bytes;
};
template <class T>
Memory memory(const char *name, const T *data, int64_t n) noexcept {
    return {name, data, data == nullptr ? 0 : n * static_cast<int64_t>(sizeof(T))};
}
inline bool apart(const Memory &a, const Memory &b) noexcept {
    const auto from_a = reinterpret_cast<uintptr_t>(a.data), from_b = reinterpret_cast<uintptr_t>(b.data);
    return a.bytes == 0 || b.bytes == 0 || from_a + static_cast<uintptr_t>(a.bytes) <= from_b ||
           from_b + static_cast<uintptr_t>(b.bytes) <= from_a;
}
// Whether the strides are those of records whose `width` values lie side by side.
inline bool in_a_row(int64_t width, int64_t stride, int64_t component_stride) noexcept {
    return (stride == 0 || stride >= width) && (component_stride == 0 || component_stride == 1);
}
// Throws NURBS_ERROR_OVERLAP if an output overlaps another output or an input.
void check_apart(std::initializer_list<Memory> outputs, std::initializer_list<Memory> inputs);

// The faces of an array of handles. Throws NURBS_ERROR_NULL, _COUNT, _OVERFLOW, and _DIMENSION unless all
// their surfaces have dimension 3.
std::vector<face::FacePtr> faces_in_space(int64_t count, const ::nurbs_face *const *faces,
                                          const char *count_name, const char *name);

} // namespace nrb::capi

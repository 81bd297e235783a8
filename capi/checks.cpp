// SPDX-License-Identifier: MIT
#include "checks.h"

#include "base/checked.h"
#include "spline/kind.h"

#include <cmath>

namespace nrb::capi {

void fail_null(const char *name) {
    fail(Status::null, "%s is NULL", name);
}

void fail_length(int64_t n, const char *name) {
    fail(Status::count, "%s = %lld, expected >= 0", name, static_cast<long long>(n));
}

const Spline &curve_of(const ::nurbs *g) {
    const Spline &spline = spline_of(g);
    check_kind(spline, 1);
    return spline;
}

const Spline &surface_of(const ::nurbs *g) {
    const Spline &spline = spline_of(g);
    check_kind(spline, 2);
    return spline;
}

void check_axis(const Spline &spline, int32_t axis) {
    if (axis < 0 || axis >= spline.axes()) {
        fail(Status::axis, "axis = %d, expected 0 to %d", axis, spline.axes() - 1);
    }
}

void check_order(int32_t order) {
    if (order < 0 || order > NURBS_MAX_ORDER) {
        fail(Status::order, "order = %d, expected 0 to %d", order, NURBS_MAX_ORDER);
    }
}

void check_factor(double factor, const char *name) {
    if (!std::isfinite(factor)) {
        fail(Status::factor, "%s = %s is not finite", name, Number(factor).text);
    }
}

void check_points(const char *name, const ConstRecords &points) {
    for (int64_t i = 0; i < points.count; ++i) {
        for (int64_t c = 0; c < points.width; ++c) {
            if (!std::isfinite(points(i, c))) {
                fail(Status::point_not_finite, "%s[%lld][%lld] = %s, expected a number", name,
                     static_cast<long long>(i), static_cast<long long>(c), Number(points(i, c)).text);
            }
        }
    }
}

void check_place(double t, Interval domain, const char *name, int axis) {
    if (!std::isfinite(t)) {
        fail(Status::parameter_not_finite, "%s = %s on axis %d is not finite", name, Number(t).text, axis);
    }
    if (t < domain.lower || t > domain.upper) {
        fail(Status::outside_domain, "%s = %s outside [%s, %s], the domain of axis %d", name, Number(t).text,
             Number(domain.lower).text, Number(domain.upper).text, axis);
    }
}

refine::AxisEnds decode_ends(uint32_t flags, uint32_t others, const char *name) {
    constexpr uint32_t start = NURBS_FORM_CLAMPED_START, end = NURBS_FORM_CLAMPED_END;
    if ((flags & ~(start | end | others)) != 0) {
        fail(Status::flags,
             "flags = 0x%x, expected NURBS_FORM_CLAMPED_START, NURBS_FORM_CLAMPED_END, both or 0%s%s", flags,
             others == 0 ? "" : ", and ", name);
    }
    return {(flags & start) != 0, (flags & end) != 0};
}

bool upper_end(int32_t end, const char *name) {
    if (end != NURBS_START && end != NURBS_END) {
        fail(Status::end, "%s = %d, expected NURBS_START or NURBS_END", name, end);
    }
    return end == NURBS_END;
}

void check_at_least(int64_t n, int64_t least, const char *name) {
    if (n < least) {
        fail(Status::count, "%s = %lld, expected at least %lld", name, static_cast<long long>(n),
             static_cast<long long>(least));
    }
}

int64_t checked_budget(int64_t budget, int64_t usual) {
    check_length(budget, "budget");
    return budget == 0 ? usual : budget;
}

void check_keep(const Spline &spline, const int32_t *keep) {
    for (int i = 0; keep != nullptr && i < 2 * spline.axes(); ++i) {
        if (keep[i] < -1 || keep[i] > NURBS_MAX_ORDER) {
            fail(Status::order, "keep[%d][%d] = %d, expected -1 to %d", i / 2, i % 2, keep[i],
                 NURBS_MAX_ORDER);
        }
    }
}

void check_size(int64_t n, int64_t expected, const char *name) {
    if (n != expected) {
        fail(Status::size, "%s = %lld, expected %lld", name, static_cast<long long>(n),
             static_cast<long long>(expected));
    }
    checked_array(n, name);
}

namespace {

[[noreturn]] void fail_stride(const char *name, const char *which, int64_t stride, const char *expected) {
    fail(Status::stride, "%s: %s = %lld, expected %s", name, which, static_cast<long long>(stride), expected);
}

// Throws NURBS_ERROR_STRIDE unless the layout is one of two in which no two elements share a place: records
// lie apart (the stride covers a record), or components lie apart (the component stride covers that component
// of all records).
void check_separation(const char *name, int64_t count, int64_t width, int64_t stride,
                      int64_t component_stride) {
    if (count <= 1 || (component_stride == 1 && width <= stride)) { // the usual layout
        return;
    }
    const bool records_apart = stride > 0 && (width - 1) <= (stride - 1) / component_stride;
    const bool components_apart =
        stride > 0 && (width == 1 || (count - 1) <= (component_stride - 1) / stride);
    if (!records_apart && !components_apart) {
        fail(Status::stride, "%s: strides (%lld, %lld) let %lld records of %lld values overlap", name,
             static_cast<long long>(stride), static_cast<long long>(component_stride),
             static_cast<long long>(count), static_cast<long long>(width));
    }
}

template <class T>
RecordView<T> view(const char *name, T *data, int64_t count, int64_t width, int64_t stride,
                   int64_t component_stride) {
    if (count > 0) {
        require(data, name);
    }
    if (stride < 0) {
        fail_stride(name, "stride", stride, ">= 0");
    }
    if (component_stride < 0) {
        fail_stride(name, "component stride", component_stride, ">= 0");
    }
    component_stride = component_stride == 0 ? 1 : component_stride;
    if (stride == 0) { // packed; the stride of a single record does not matter
        stride = count > 1 ? checked_product(width, component_stride, name) : width;
    }
    check_separation(name, count, width, stride, component_stride);
    if (count > 0) {
        checked_sum(checked_product(count - 1, stride, name),
                    checked_product(width - 1, component_stride, name) + 1, name);
    }
    return {data, count, width, stride, component_stride};
}

bool interleaved(const Records &out, const ConstRecords &in) noexcept {
    if (out.stride != in.stride || out.component_stride != 1 || in.component_stride != 1) {
        return false;
    }
    const auto bytes = reinterpret_cast<intptr_t>(out.data) - reinterpret_cast<intptr_t>(in.data);
    constexpr auto size = static_cast<intptr_t>(sizeof(double));
    if (bytes % size != 0) {
        return false;
    }
    const int64_t shift = ((bytes / size) % in.stride + in.stride) % in.stride;
    return shift >= in.width && shift + out.width <= in.stride;
}

template <class T>
int64_t bytes_of(const RecordView<T> &view) noexcept {
    return view.extent() * static_cast<int64_t>(sizeof(T));
}

} // namespace

ConstRecords input(const char *name, const double *data, int64_t count, int64_t width, int64_t stride,
                   int64_t component_stride) {
    return view(name, data, count, width, stride, component_stride);
}

Records output(const char *name, double *data, int64_t count, int64_t width, int64_t stride,
               int64_t component_stride) {
    return view(name, data, count, width, stride, component_stride);
}

FloatRecords output(const char *name, float *data, int64_t count, int64_t width, int64_t stride,
                    int64_t component_stride) {
    return view(name, data, count, width, stride, component_stride);
}

void check_overlap(const char *out_name, const void *out, int64_t out_bytes, const char *in_name,
                   const void *in, int64_t in_bytes) {
    if (!apart({out_name, out, out_bytes}, {in_name, in, in_bytes})) {
        fail(Status::overlap, "output %s overlaps %s", out_name, in_name);
    }
}

void check_overlap(const char *out_name, const Records &out, const char *in_name, const ConstRecords &in) {
    if (out.count > 0 && in.count > 0 && !interleaved(out, in)) {
        check_overlap(out_name, out.data, bytes_of(out), in_name, in.data, bytes_of(in));
    }
}

void check_overlap(const char *out_name, const FloatRecords &out, const char *in_name,
                   const ConstRecords &in) {
    if (out.count > 0 && in.count > 0) {
        check_overlap(out_name, out.data, bytes_of(out), in_name, in.data, bytes_of(in));
    }
}

void check_apart(std::initializer_list<Memory> outputs, std::initializer_list<Memory> inputs) {
    for (const Memory *out = outputs.begin(); out != outputs.end(); ++out) {
        for (const Memory &in : inputs) {
            check_overlap(out->name, out->data, out->bytes, in.name, in.data, in.bytes);
        }
        for (const Memory *other = outputs.begin(); other != out; ++other) {
            check_overlap(out->name, out->data, out->bytes, other->name, other->data, other->bytes);
        }
    }
}

void check_direction(const char *name, const double *x, int64_t index) {
    char row[32] = "";
    if (index >= 0) {
        std::snprintf(row, sizeof row, "[%lld]", static_cast<long long>(index));
    }
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(x[c])) {
            fail(Status::direction, "%s%s[%d] = %s, expected a number", name, row, c, Number(x[c]).text);
        }
    }
    if (x[0] == 0 && x[1] == 0 && x[2] == 0) {
        fail(Status::direction, "%s%s is 0, expected a direction", name, row);
    }
}

std::span<const double> checked_values(int64_t n, const double *values, const char *name) {
    check_length(n, "n");
    checked_array(n, name);
    if (n > 0) {
        require(values, name);
    }
    for (int64_t i = 0; i < n; ++i) {
        if (!std::isfinite(values[i])) {
            fail(Status::point_not_finite, "%s[%lld] = %s, expected a finite value", name,
                 static_cast<long long>(i), Number(values[i]).text);
        }
    }
    return {values, static_cast<size_t>(n)};
}

std::vector<face::FacePtr> faces_in_space(int64_t count, const ::nurbs_face *const *faces,
                                          const char *count_name, const char *name) {
    check_length(count, count_name);
    checked_array(count, name);
    if (count > 0) {
        require(faces, name);
    }
    std::vector<face::FacePtr> given;
    for (int64_t i = 0; i < count; ++i) {
        if (faces[i] == nullptr) {
            fail(Status::null, "%s[%lld] is NULL", name, static_cast<long long>(i));
        }
        const int dim = faces[i]->face->surface()->dim();
        if (dim != 3) {
            fail(Status::dimension, "%s[%lld] has dimension %d, expected 3", name, static_cast<long long>(i),
                 dim);
        }
        given.push_back(faces[i]->face);
    }
    return given;
}

} // namespace nrb::capi

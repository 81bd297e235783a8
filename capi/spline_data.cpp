// SPDX-License-Identifier: MIT
#include "spline_data.h"

#include "base/checked.h"

#include <limits>

namespace nrb::capi {

bool decode_periodic(uint32_t flags, int32_t axes, int k) {
    const uint32_t known = NURBS_ON_ALL_AXES(axes, NURBS_PERIODIC);
    if ((flags & ~known) != 0) {
        fail(Status::flags, "flags = 0x%x: unknown bits 0x%x for %d axes", flags, flags & ~known, axes);
    }
    return (flags & NURBS_ON_AXIS(k, NURBS_PERIODIC)) != 0;
}

namespace {

bool one_after_the_other(const ConstRecords &view) noexcept {
    return view.component_stride == 1 && (view.stride == view.width || view.count == 1);
}

} // namespace

std::vector<double> packed(ConstRecords view) {
    const auto size = static_cast<size_t>(checked_product(view.count, view.width, "points"));
    std::vector<double> values;
    values.reserve(size + Spline::padding); // so that a spline appends its padding without reallocation
    if (one_after_the_other(view)) {
        values.assign(view.data, view.data + size);
        return values;
    }
    values.resize(size);
    auto next = values.begin();
    for (int64_t i = 0; i < view.count; ++i) {
        for (int64_t c = 0; c < view.width; ++c) {
            *next++ = view(i, c);
        }
    }
    return values;
}

std::span<const double> packed(ConstRecords view, std::vector<double> &room) {
    if (one_after_the_other(view)) {
        return {view.data, static_cast<size_t>(checked_product(view.count, view.width, "points"))};
    }
    return room = packed(view);
}

AxesData::AxesData(int32_t axes, const int32_t *degrees, const int64_t *counts, uint32_t flags)
    : size_(axes) {
    check_axes(axes);
    require(degrees, "degrees");
    require(counts, "counts");
    for (int k = 0; k < axes; ++k) {
        check_degree(degrees[k], k);
        check_count(degrees[k], counts[k], k);
        axes_[static_cast<size_t>(k)] = {degrees[k], counts[k], decode_periodic(flags, axes, k)};
    }
}

AxesData::AxesData(int32_t axes, const int32_t *degrees) : size_(axes) {
    check_axes(axes);
    require(degrees, "degrees");
    for (int k = 0; k < axes; ++k) {
        check_degree(degrees[k], k);
        axes_[static_cast<size_t>(k)] = {degrees[k], degrees[k] + 1, false};
    }
}

int64_t AxesData::point_count() const {
    int64_t count = 1;
    for (int k = 0; k < size_; ++k) {
        count = checked_product(count, (*this)[k].count, "points");
    }
    return count;
}

// Does not check that an array can have this length: check_size() does so, after comparing it with the
// caller's length.
int64_t AxesData::knot_total(int extra) const {
    constexpr int64_t most = std::numeric_limits<int64_t>::max() / 8; // a sum of three cannot overflow
    int64_t total = 0;
    for (int k = 0; k < size_; ++k) {
        const AxisData &axis = (*this)[k];
        if (axis.count > most) {
            fail(Status::overflow, "knots: %lld + %d values exceed the address space",
                 static_cast<long long>(axis.count), axis.degree + extra);
        }
        total += axis.count + axis.degree + extra;
    }
    return total;
}

Spline::Axes AxesData::with_knots(const double *knots, int64_t knot_count) const {
    check_size(knot_count, knot_total(1), "knot_count");
    static_cast<void>(point_count()); // refuses numbers of points before that many knots are read
    require(knots, "knots");
    return make(
        [knots](const AxisData &axis, int, int64_t offset) {
            const double *first = knots + offset;
            return std::pair(std::vector<double>(first, first + axis.count + axis.degree + 1), offset);
        },
        1);
}

SplinePtr PointsData::make(Spline::Axes axes, int64_t count, std::vector<double> kept) const {
    check_dimension(dim);
    const ConstRecords point_view = input("points", points, count, dim, stride, component_stride);
    if (weights != nullptr) {
        kept = packed(input("weights", weights, count, weight_stride));
    }
    const Form form = kept.empty() ? Form::polynomial : Form::rational;
    return make_spline(std::move(axes), dim, form, packed(point_view), std::move(kept));
}

SplinePtr PointsData::make_homogeneous(Spline::Axes axes, int64_t count) const {
    check_dimension(dim);
    const int64_t width = int64_t{dim} + 1;
    const ConstRecords view = input("points", points, count, width, stride, component_stride);
    return make_spline(std::move(axes), dim, Form::homogeneous, packed(view));
}

} // namespace nrb::capi

// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "build/surfaces/points_in_rotation.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "build/surfaces/points_in_rotation.h"
#include "numeric/double_double-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace nrb::build {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using namespace numeric::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 8>;
using Register = hn::Vec<Lanes>;
using Number = DoubleDoubleLanes<Register>;

HWY_INLINE Number loaded(const double *parts, int64_t stride, int64_t which) {
    const Lanes d;
    return {hn::LoadU(d, parts + 2 * which * stride), hn::LoadU(d, parts + (2 * which + 1) * stride)};
}

// Compensated sums, as in numeric/sum.h.
void rotated_values(const double *parts, int64_t stride, int64_t size, double at_x, double at_y,
                    double *out) {
    const Lanes d;
    const auto lanes = static_cast<int64_t>(hn::Lanes(d));
    const Register x = hn::Set(d, at_x), y = hn::Set(d, at_y);
    HWY_ALIGN double last[8];
    for (int64_t i = 0; i < size; i += lanes) {
        const Number foot = loaded(parts + i, stride, 0), along = loaded(parts + i, stride, 1),
                     across = loaded(parts + i, stride, 2);
        const Number p = exact_product(x, along.high), q = exact_product(y, across.high);
        const Number turned = exact_sum(p.high, q.high), all = exact_sum(turned.high, foot.high);
        const Register rests = hn::Add(hn::MulAdd(x, along.low, p.low), hn::MulAdd(y, across.low, q.low));
        const Register value =
            hn::Add(all.high, hn::Add(hn::Add(turned.low, all.low), hn::Add(rests, foot.low)));
        if (i + lanes <= size) {
            hn::StoreU(value, d, out + i);
        } else {
            hn::Store(value, d, last);
            std::copy_n(last, size - i, out + i);
        }
    }
}

// The constructor is written out because one that the compiler adds would not be compiled for the instruction
// set.
struct Point {
    Register high[3];
    Register low[3];

    HWY_INLINE Point() {}

    HWY_INLINE void set(int c, const Number &value) {
        high[c] = value.high;
        low[c] = value.low;
    }
};

HWY_INLINE void store(const Point &point, const Register *weight, double *high, double *low) {
    const Lanes d;
    if (weight == nullptr) {
        hn::StoreInterleaved3(point.high[0], point.high[1], point.high[2], d, high);
        hn::StoreInterleaved3(point.low[0], point.low[1], point.low[2], d, low);
    } else {
        hn::StoreInterleaved4(point.high[0], point.high[1], point.high[2], *weight, d, high);
        hn::StoreInterleaved4(point.low[0], point.low[1], point.low[2], hn::Zero(d), d, low);
    }
}

HWY_INLINE Number broadcast(const DoubleDouble &x) {
    const Lanes d;
    return {hn::Set(d, x.high), hn::Set(d, x.low)};
}

// Foot, d and e of every record, of width 3 or 4. Reads and writes whole vectors of records.
void radii(const double *points, int64_t records, int width, const AxisLine &axis, double *const *out) {
    const Lanes d;
    const Register zero = hn::Zero(d);
    const Number z[3] = {broadcast(axis.along[0]), broadcast(axis.along[1]), broadcast(axis.along[2])};
    const Register origin[3] = {hn::Set(d, axis.origin[0]), hn::Set(d, axis.origin[1]),
                                hn::Set(d, axis.origin[2])};
    for (int64_t i = 0; i < records; i += static_cast<int64_t>(hn::Lanes(d))) {
        Register p[3], weight = hn::Set(d, 1.0);
        if (width == 3) {
            hn::LoadInterleaved3(d, points + i * width, p[0], p[1], p[2]);
        } else {
            hn::LoadInterleaved4(d, points + i * width, p[0], p[1], p[2], weight);
        }
        const Number seen[3] = {Number{p[0], zero} - exact_product(weight, origin[0]),
                                Number{p[1], zero} - exact_product(weight, origin[1]),
                                Number{p[2], zero} - exact_product(weight, origin[2])};
        const Number part = seen[0] * z[0] + seen[1] * z[1] + seen[2] * z[2];
        Point foot, along, across;
        for (int c = 0; c < 3; ++c) {
            const int next = (c + 1) % 3, other = (c + 2) % 3;
            const Number radius = seen[c] - part * z[c];
            foot.set(c, Number{p[c], zero} - radius);
            along.set(c, radius);
            across.set(c, z[next] * seen[other] - z[other] * seen[next]);
        }
        const bool plain = width == 3;
        store(foot, plain ? nullptr : &weight, out[0] + i * width, out[1] + i * width);
        store(along, plain ? nullptr : &zero, out[2] + i * width, out[3] + i * width);
        store(across, plain ? nullptr : &zero, out[4] + i * width, out[5] + i * width);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::build
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::build {

NURBS_FORMS(rotated_values);
NURBS_FORMS(radii);

namespace {

constexpr int64_t lanes = 8; // largest number of lanes of a vector

int64_t whole_vectors(int64_t n) noexcept {
    return (n + lanes - 1) / lanes * lanes;
}

} // namespace

PointsInRotation::PointsInRotation(int64_t coordinates)
    : size_(coordinates), stride_(whole_vectors(coordinates)), data_(static_cast<size_t>(parts * stride_)) {}

PointsInRotation::PointsInRotation(const Spline &spline, const AxisLine &axis)
    : size_(std::ssize(spline.points())),
      stride_(whole_vectors(spline.point_count()) * spline.stored_width()),
      data_(static_cast<size_t>(parts * stride_)) {
    std::vector<double> points(static_cast<size_t>(stride_));
    std::ranges::copy(spline.points(), points.begin());
    NURBS_BEST(radii)
    (points.data(), spline.point_count(), spline.stored_width(), axis, arrays().data());
}

std::array<double *, PointsInRotation::parts> PointsInRotation::arrays() noexcept {
    std::array<double *, parts> result{};
    for (int64_t k = 0; k < parts; ++k) {
        result[static_cast<size_t>(k)] = data_.data() + k * stride_;
    }
    return result;
}

void PointsInRotation::set(int64_t coordinate, const DoubleDouble &foot, const DoubleDouble &d,
                           const DoubleDouble &e) noexcept {
    const double values[] = {foot.high, foot.low, d.high, d.low, e.high, e.low};
    for (int64_t k = 0; k < parts; ++k) {
        data_[static_cast<size_t>(k * stride_ + coordinate)] = values[k];
    }
}

void PointsInRotation::values(double x, double y, double *out) const noexcept {
    NURBS_BEST(rotated_values)(data_.data(), stride_, size_, x, y, out);
}

} // namespace nrb::build
#endif

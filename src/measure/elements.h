// SPDX-License-Identifier: MIT
// The polynomial pieces of a spline, prepared for integration: each is relative to an origin of its own, so
// that the rounding of derivatives depends neither on the position of the model nor on its size.
#pragma once

#include "pieces/frame.h"
#include "spline/part.h"

#include <vector>

namespace nrb::measure {

// The frame of all control points, with a unit whose inverse is representable, so that lengths can be
// multiplied by it. Over `axes` axes, the scaled content is 2^-(exponent * axes) times the true one.
pieces::Frame integral_frame(std::span<const Spline *const> splines);
inline pieces::Frame integral_frame(const Spline &spline) {
    const Spline *one = &spline;
    return integral_frame({&one, 1});
}

// One piece of the integration domain: the Bernstein coefficients of w (x - origin) * scale, component by
// component (the coordinates and, if rational, the weight), last axis fastest.
struct Element {
    std::vector<double> net;    // [width][coefficients]
    std::vector<double> origin; // (origin - centre) * scale
    double spread = 0;          // largest |x - origin| * scale of a control point
    double weight_scale = 1;    // a power of two by which the weights are multiplied
    std::vector<double> work;
};

// The elements of a spline over a part of its domain. Cost: degree^3 / 2 for each span of every axis; then
// axes + 1 contractions with their matrices for each element loaded. Precondition: every interval of the part
// is inside the domain and not empty.
class Elements {
public:
    Elements(const Spline &spline, const pieces::Frame &frame, const Part &part);

    [[nodiscard]] int64_t size() const noexcept;
    [[nodiscard]] int axes() const noexcept { return spline_.axes(); }
    [[nodiscard]] int dim() const noexcept { return spline_.dim(); }
    [[nodiscard]] int width() const noexcept { return spline_.width(); }
    [[nodiscard]] bool rational() const noexcept { return spline_.rational(); }
    [[nodiscard]] int degree(int k) const noexcept { return spline_.axis(k).degree(); }
    [[nodiscard]] int64_t coefficients() const noexcept { return coefficients_; }
    // The interval of an axis that an element covers; elements are numbered with the last axis fastest.
    [[nodiscard]] Interval interval(int64_t element, int axis) const noexcept;
    void load(int64_t element, Element &out) const;

private:
    struct AxisElements {
        std::vector<double> matrices; // one [degree + 1][degree + 1] per element of the axis
        std::vector<int64_t> firsts;
        std::vector<Interval> intervals;
    };
    [[nodiscard]] std::array<size_t, max_axes> places(int64_t element) const noexcept;
    static void add_span(AxisElements &elements, const KnotVector &axis, int64_t span, Interval range);
    void gather(const std::array<int64_t, max_axes> &first, Element &out) const;
    void add_point(int64_t index, int64_t at, Element &out) const;
    [[nodiscard]] int64_t origin_point(const std::array<int64_t, max_axes> &first) const noexcept;
    template <class Visit>
    void for_each_active(const std::array<int64_t, max_axes> &first, Visit &&visit) const;

    const Spline &spline_;
    const pieces::Frame &frame_;
    double scale_;
    std::array<AxisElements, max_axes> axes_;
    int64_t coefficients_ = 1;
};

// out[o][k][i] = sum over j < terms of in[o][j][i] matrix[j][k], for k < count. The rows of the matrix are
// `stride` apart.
void contract(const double *in, int64_t outer, int terms, int64_t inner, const double *matrix, int stride,
              int count, double *out) noexcept;

} // namespace nrb::measure

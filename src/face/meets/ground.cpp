// SPDX-License-Identifier: MIT
#include "face/meets/ground.h"

#include "base/error.h"
#include "eval/evaluate.h"
#include "face/face_box.h"
#include "refine/parts/continuation.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <array>

namespace nrb::face {

namespace {

// A surface is continued by at most this share of the span at its end: so little beyond it, the polynomial of
// the span is hardly larger.
constexpr double most_of_span = 1.0 / 8;
// A span that is cut keeps at least this share of its length.
constexpr double least_of_span = 1.0 / 8;

double last_span(const KnotVector &axis, bool upper) {
    const std::span<const double> breaks = axis.spans().breaks();
    const size_t n = breaks.size();
    return upper ? breaks[n - 1] - breaks[n - 2] : breaks[1] - breaks[0];
}

SplinePtr continued(const SplinePtr &surface, int axis, bool upper, double amount) {
    const double most = most_of_span * last_span(surface->axis(axis), upper);
    try {
        return refine::extend(surface, axis, upper, std::min(amount, most), surface->axis(axis).degree());
    } catch (const Error &) { // weights would not stay positive, or the new end is not representable
        return surface;
    }
}

// Where to cut an axis. The cut is farther out if it would leave a sliver of a span, beyond which its
// polynomial says nothing.
double cut_at(const KnotVector &axis, double at, bool upper) {
    const std::span<const double> breaks = axis.spans().breaks();
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, at);
    const double low = *(above - 1), high = *above, least = least_of_span * (high - low);
    return upper ? std::max(at, low + least) : std::min(at, high - least);
}

} // namespace

SplinePtr ground_of(const Face &face, bool beyond, double margin) {
    const std::array<Interval, 2> rectangle = smallest_rectangle(face);
    SplinePtr surface = face.surface();
    for (const int k : {0, 1}) {
        if (face.covering().closed(k)) {
            continue;
        }
        const auto &[lower, upper] = rectangle[static_cast<size_t>(k)];
        const Interval domain = surface->axis(k).domain();
        const double around = margin * (upper - lower);
        const double from = cut_at(surface->axis(k), std::max(lower - around, domain.lower), false),
                     to = cut_at(surface->axis(k), std::min(upper + around, domain.upper), true);
        if ((from > domain.lower || to < domain.upper) && from < to) {
            surface = refine::restrict_axis(surface, k, from, to);
        }
        if (beyond && lower - around < domain.lower && !face.covering().collapsed(k, 0)) {
            surface = continued(surface, k, false, around);
        }
        if (beyond && upper + around > domain.upper && !face.covering().collapsed(k, 1)) {
            surface = continued(surface, k, true, around);
        }
    }
    return surface;
}

Vector3 surface_normal(const Spline &surface, const Point2 &at) {
    std::array<double, 9> jet{}; // the point and both derivatives
    eval::evaluate_points(surface, {}, 1, {at.data(), 1, 2, 2, 1}, {jet.data(), 1, 9, 9, 1});
    const Vector3 u{jet[3], jet[4], jet[5]}, v{jet[6], jet[7], jet[8]};
    return cross(times_power(u, -size_exponent(u)), times_power(v, -size_exponent(v)));
}

} // namespace nrb::face

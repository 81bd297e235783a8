// SPDX-License-Identifier: MIT
#include "io/iges/write/write_spline.h"

#include "io/iges/types.h"
#include "io/written/spline_facts.h"

namespace nrb::io::iges {
namespace {

// The first index varies fastest in a file, the last one in this library.
template <class Visit>
void for_each_point(const Spline &spline, const Visit &visit) {
    const int64_t m = spline.count(0), n = spline.axes() == 2 ? spline.count(1) : 1;
    for (int64_t j = 0; j < n; ++j) {
        for (int64_t i = 0; i < m; ++i) {
            visit(i * n + j);
        }
    }
}

template <class Visit>
void for_each_axis(const Spline &spline, const Visit &visit) {
    for (int k = 0; k < spline.axes(); ++k) {
        visit(k);
    }
}

// Highest indices, degrees, and the properties.
void put_properties(FileText &text, const Spline &spline) {
    const auto flag = [](bool value) { return value ? 1 : 0; };
    for_each_axis(spline, [&](int k) { text.put(spline.count(k) - 1); });
    for_each_axis(spline, [&](int k) { text.put(spline.axis(k).degree()); });
    if (spline.axes() == 1) {
        text.put(flag(spline.dim() == 2)); // whether it is known to be planar
    }
    for_each_axis(spline, [&](int k) { text.put(flag(closed(spline, k))); });
    text.put(flag(!has_weights(spline)));
    for_each_axis(spline, [&](int k) { text.put(flag(spline.axis(k).periodic())); });
}

void put_points(FileText &text, const Spline &spline, double length) {
    for_each_point(spline, [&](int64_t i) {
        for (int c = 0; c < 3; ++c) {
            text.put(c < spline.dim() ? length * spline.coordinate(i, c) : 0.0);
        }
    });
}

} // namespace

int64_t begin_spline(FileText &text, const Spline &spline, std::string_view status, double length,
                     int64_t level) {
    const bool curve = spline.axes() == 1, weights = has_weights(spline);
    const int64_t number =
        text.begin({curve ? spline_curve_type : spline_surface_type, 0, status, 0, 0, level});
    put_properties(text, spline);
    for_each_axis(spline, [&](int k) { text.put_all(spline.axis(k).knots()); });
    for_each_point(spline, [&](int64_t i) { text.put(weights ? spline.weight(i) : 1.0); });
    put_points(text, spline, length);
    for_each_axis(spline, [&](int k) {
        const Interval domain = spline.axis(k).domain();
        text.put(domain.lower, domain.upper);
    });
    if (curve) {
        text.put(0.0, 0.0, spline.dim() == 2 ? 1.0 : 0.0); // the normal of the plane
    }
    return number;
}

} // namespace nrb::io::iges

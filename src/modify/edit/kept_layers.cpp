// SPDX-License-Identifier: MIT
#include "modify/edit/kept_layers.h"

#include "basis/bspline.h"
#include "modify/edit/net_editor.h"
#include "spline/axis_view.h"

#include <algorithm>

namespace nrb::modify {

namespace {

// For each layer of an axis, whether it acts on derivatives up to an order at an end of the domain.
std::vector<char> acting_layers(const KnotVector &axis, bool upper, int order) {
    std::vector<char> acting(static_cast<size_t>(axis.count()), 0);
    if (order < 0) {
        return acting;
    }
    const int p = axis.degree(), highest = std::min(order, p);
    const double end = upper ? axis.domain().upper : axis.domain().lower;
    const int64_t span = axis.find_span(end, upper);
    std::vector<double> values(static_cast<size_t>((highest + 1) * (p + 1)));
    basis_derivs(axis.knots().data(), p, span, end, highest, values.data());
    for (size_t i = 0; i < values.size(); ++i) {
        if (values[i] != 0) {
            acting[static_cast<size_t>(span - p) + i % (static_cast<size_t>(p) + 1)] = 1;
        }
    }
    return acting;
}

} // namespace

std::vector<char> kept_points(const Spline &spline, const int32_t *keep) {
    std::vector<char> stays(static_cast<size_t>(spline.point_count()), 0);
    for (int k = 0; k < spline.axes() && keep != nullptr; ++k) {
        const AxisView view = axis_view(spline, k, 1);
        for (int end = 0; end < 2; ++end) {
            const std::vector<char> acting = acting_layers(spline.axis(k), end == 1, keep[2 * k + end]);
            for (int64_t i = 0; i < spline.point_count(); ++i) {
                if (acting[static_cast<size_t>(i / view.inner % view.count)] != 0) {
                    stays[static_cast<size_t>(original_of(spline, i))] = 1;
                }
            }
        }
    }
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        stays[static_cast<size_t>(i)] = stays[static_cast<size_t>(original_of(spline, i))];
    }
    return stays;
}

} // namespace nrb::modify

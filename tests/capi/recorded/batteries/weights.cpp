/* SPDX-License-Identifier: MIT */
// Single weights and control points.
#include "recorded/batteries/batteries.h"

namespace recorded {

namespace {

void one_weight(const Subject &s, int64_t index, const std::vector<double> &place) {
    for (const double distance : {0.01, -0.01, 10.0}) {
        nurbs_pull_weight(s.g, index, place.data(), distance * s.size, unread, unread);
        nurbs_pull_point(s.g, index, place.data(), s.direction(1).data(), distance * s.size, unread, unread);
    }
    std::vector<double> zero(static_cast<size_t>(s.dim)), one(zero), now(zero);
    if (nurbs_weight_points(s.g, index, place.data(), zero.data(), one.data(), now.data()) != NURBS_OK) {
        return;
    }
    nurbs_weight_through(s.g, index, place.data(), one.data(), s.size, unread, unread);
    nurbs_weight_through(s.g, index, place.data(), s.center.data(), s.size, unread, unread);
    nurbs_weight_cross_ratio(s.dim, s.control.data() + index * s.dim, zero.data(), one.data(), now.data(),
                             unread);
}

void several_weights(const Subject &s, const std::vector<double> &place) {
    const int64_t some[] = {0, s.points / 2, s.points - 1};
    const double weights[] = {0.5, 2, 1.25};
    for (const int64_t count : {1, 2, 3}) {
        nurbs_pull_weights(s.g, count, some, place.data(), 0.01 * s.size, unread, unread);
        nurbs_set_weights(s.g, count, some, weights, unread);
    }
}

} // namespace

// Of the control point with the largest influence, and of others.
void call_weights(const Subject &s) {
    for (const double fraction : {0.0, 0.3, 0.8}) {
        const std::vector<double> place = s.middle(fraction);
        int64_t strongest = 0;
        if (nurbs_most_influential(s.g, 1, place.data(), 0, 0, &strongest, unread) == NURBS_OK) {
            one_weight(s, strongest, place);
        }
        one_weight(s, s.points / 2, place);
        several_weights(s, place);
    }
}

} // namespace recorded

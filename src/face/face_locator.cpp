// SPDX-License-Identifier: MIT
#include "face/face_locator.h"

#include "base/numbers.h"
#include "bounds/box.h"
#include "closest/closest.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

bool certified(const closest::Foot &foot) noexcept {
    return (foot.status & closest::closest_certified) != 0;
}

closest::Foot nearest_of(const Spline &spline, const double *point, double tolerance) {
    return closest::locator_of(spline).nearest(
        {point, nullptr, tolerance, closest::usual_budget(spline), false, true});
}

} // namespace

int FaceLocator::side(const closest::Foot &foot) const noexcept {
    return face_.trims().side({foot.params[0], foot.params[1]});
}

void FaceLocator::find_edges() {
    if (known_) {
        return;
    }
    for (BoundaryCurve &curve : boundary_curves(face_)) {
        if (curve.space == nullptr) {
            composed_ = false;
            curve.space = edge_over(face_.surface(), face_.covering(), curve.plane, face_.tolerance()).curve;
        }
        const bounds::Box box = bounds::bounding_box(*curve.space, whole_domain(*curve.space), infinity);
        edges_.push_back({std::move(curve), box.lower, box.upper});
    }
    known_ = true;
}

double FaceLocator::distance_of(const Edge &edge, const double *point) const noexcept {
    return norm_of(face_.surface()->dim(), [&](int c) {
        const auto at = static_cast<size_t>(c);
        return std::max({edge.lower[at] - point[c], point[c] - edge.upper[at], 0.0});
    });
}

// The nearest box first, so that most of the others need no search.
FaceLocator::Found FaceLocator::on_edges(const double *point, double tolerance) {
    std::vector<std::pair<double, size_t>> order;
    for (size_t i = 0; i < edges_.size(); ++i) {
        order.emplace_back(distance_of(edges_[i], point), i);
    }
    std::sort(order.begin(), order.end());
    Found best{{}, composed_};
    best.foot.distance = infinity;
    for (const auto &[from, i] : order) {
        if (from > best.foot.distance) {
            break;
        }
        const closest::Foot foot = nearest_of(*edges_[i].curve.space, point, tolerance);
        best.certified = best.certified && certified(foot);
        if (foot.distance < best.foot.distance) {
            Point2 place{};
            eval::curve_point(*edges_[i].curve.plane, foot.params[0], (foot.left & 1U) != 0, place.data());
            place = face_.covering().in_domain(place);
            best.foot = {{place[0], place[1]}, foot.distance, 0, foot.noise, 0, foot.examined};
        }
    }
    return best;
}

closest::Foot FaceLocator::nearest(const double *point, double tolerance) {
    const closest::Foot least = nearest_of(*face_.surface(), point, tolerance);
    if (const int side = this->side(least); side >= 0) {
        closest::Foot foot = least;
        foot.status &= ~closest::closest_boundary;
        foot.status |= side == 0 ? closest::closest_boundary : 0;
        return foot;
    }
    return nearest_inside(point, tolerance, least);
}

// The nearest point is on the boundary, or it is a local minimum of the surface that is nearer. Minima for which rounding would
// have to say whether they are inside are as near as the boundary.
closest::Foot FaceLocator::nearest_inside(const double *point, double tolerance, const closest::Foot &least) {
    find_edges();
    const Found edge = on_edges(point, tolerance);
    closest::Foot best = edge.foot;
    best.status = closest::closest_boundary;
    const double beyond = edge.foot.distance - least.distance;
    bool sure = edge.certified && certified(least);
    if (beyond > tolerance && std::isfinite(beyond)) {
        const Spline &surface = *face_.surface();
        const closest::CriticalSet minima = closest::locator_of(surface).minima(
            {point, nullptr, beyond, closest::usual_budget(surface), false, false});
        sure = sure && (minima.status & closest::closest_certified) != 0;
        for (const closest::CriticalPoint &minimum : minima.points) {
            if (minimum.foot.distance < best.distance && side(minimum.foot) > 0) {
                best = minimum.foot;
                best.status = 0;
            }
        }
    }
    best.status |= sure && std::isfinite(best.distance) ? closest::closest_certified : 0;
    return best;
}

} // namespace nrb::face

// SPDX-License-Identifier: MIT
#include "face/near/face_locator.h"

#include "base/numbers.h"
#include "closest/closest.h"
#include "eval/evaluate.h"
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

// Where the surface jumps along the boundary, the limit from below is no point of the face.
int FaceLocator::side(const closest::Foot &foot) const noexcept {
    const int side = face_.trims().side({foot.params[0], foot.params[1]});
    return side == 0 && foot.left != 0 ? -1 : side;
}

// The point at which the boundary begins. Precondition: edges_ are known.
closest::Foot FaceLocator::any_foot(const double *point) const {
    const Spline &surface = *face_.surface();
    const Point2 place = place_of(face_, *edges_);
    const int dim = surface.dim();
    std::vector<double> x(static_cast<size_t>(dim));
    eval::evaluate_points(surface, {}, 0, {place.data(), 1, 2, 2, 1}, {x.data(), 1, dim, dim, 1});
    closest::Foot foot;
    foot.params = {place[0], place[1]};
    foot.distance = distance(x.data(), point, dim);
    return foot;
}

// Edges with near boxes come first, so that most of the others need no search.
FaceLocator::Found FaceLocator::on_edges(const double *point, double tolerance) {
    if (!edges_) {
        edges_ = space_edges(face_);
    }
    std::vector<std::pair<double, size_t>> order;
    for (size_t i = 0; i < edges_->all.size(); ++i) {
        order.emplace_back(edges_->all[i].distance(point, point), i);
    }
    std::sort(order.begin(), order.end());
    Found best{{}, edges_->exact};
    best.foot.distance = infinity;
    for (const auto &[from, i] : order) {
        if (from > best.foot.distance) {
            break;
        }
        const BoundaryCurve &curve = edges_->all[i].curve;
        const closest::Foot foot = nearest_of(*curve.space, point, tolerance);
        best.certified = best.certified && certified(foot);
        if (foot.distance < best.foot.distance) {
            const Point2 place = place_on(face_, curve, foot.params[0], (foot.left & 1U) != 0);
            best.foot = {{place[0], place[1]}, foot.distance, 0, foot.noise, 0, foot.examined};
        }
    }
    if (!std::isfinite(best.foot.distance)) {
        best = {any_foot(point), false};
    }
    return best;
}

closest::BoundedFoot FaceLocator::nearest(const double *point, double tolerance, double far) {
    const auto bound = [tolerance](const closest::Foot &foot) {
        return certified(foot) ? std::max(0.0, foot.distance - tolerance - foot.noise) : 0;
    };
    const closest::Foot least = nearest_of(*face_.surface(), point, tolerance);
    const double at_least = bound(least);
    if (at_least > far) {
        return {least, at_least};
    }
    if (const int side = this->side(least); side >= 0) {
        closest::Foot foot = least;
        foot.status &= ~closest::closest_boundary;
        foot.status |= side == 0 ? closest::closest_boundary : 0;
        return {foot, at_least};
    }
    const closest::Foot foot = nearest_inside(point, tolerance, least);
    return {foot, std::max(at_least, bound(foot))};
}

// The nearest point is on the boundary, or it is a local minimum of the surface that is inside and nearer. A
// minimum that is inside or outside only by rounding is on the boundary, and so no nearer than that.
closest::Foot FaceLocator::nearest_inside(const double *point, double tolerance, const closest::Foot &least) {
    const Found edge = on_edges(point, tolerance);
    closest::Foot best = edge.foot;
    best.status = closest::closest_boundary;
    const double beyond = edge.foot.distance - least.distance;
    bool sure = edge.certified && certified(least);
    if (beyond > tolerance && std::isfinite(beyond)) {
        const Spline &surface = *face_.surface();
        const closest::CriticalSet minima = closest::locator_of(surface).minima(
            {point, nullptr, beyond, closest::usual_budget(surface), false, false, true});
        sure = sure && (minima.status & closest::closest_certified) != 0;
        for (const closest::CriticalPoint &minimum : minima.points) {
            if (minimum.foot.distance < best.distance && side(minimum.foot) > 0) {
                best = minimum.foot;
                best.status = 0;
            }
        }
    }
    best.status |=
        sure && std::isfinite(best.distance) ? closest::closest_certified : closest::closest_budget;
    return best;
}

} // namespace nrb::face

// SPDX-License-Identifier: MIT
#include "face/kept/kept_side.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "closest/closest.h"
#include "eval/evaluate.h"
#include "face/arrange/split.h"
#include "face/kept/bridges.h"
#include "face/places_inside.h"
#include "intersect/surfaces/surface_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace nrb::face {

namespace {

using Vector = std::array<double, 3>;

void check_decided(const Face &face, const intersect::Meet &meet, const Bridges &bridges) {
    for (size_t i = 0; i < meet.nodes.size(); ++i) {
        const intersect::MeetNode &node = meet.nodes[i];
        const auto &[u, v] = node.range;
        if (node.kind == intersect::NodeKind::undecided && !bridges.nodes[i] &&
            !is_outside(face, {u.lower, v.lower}, {u.upper, v.upper})) {
            if (meet.limited) {
                end_for_work();
            }
            fail(Status::not_converged, "it is undecided how the surface meets the face at (%s, %s)",
                 Number(node.at[0]).text, Number(node.at[1]).text);
        }
    }
}

// Branches that cross each other end at touch nodes. known: by nodes, whether nothing is left open there.
void check_told_apart(const intersect::Meet &meet, const std::vector<bool> &known) {
    for (const intersect::MeetBranch &branch : meet.branches) {
        for (const int64_t end : branch.nodes) {
            if (end >= 0 && !known[static_cast<size_t>(end)] &&
                meet.nodes[static_cast<size_t>(end)].kind == intersect::NodeKind::touch) {
                const Point2 &at = meet.nodes[static_cast<size_t>(end)].at;
                fail(Status::not_converged,
                     "curves in which the surface meets the face are not told apart at (%s, %s)",
                     Number(at[0]).text, Number(at[1]).text);
            }
        }
    }
}

// How far the curves of the branches may be from the intersection.
double near_of(const intersect::Meet &meet, double tolerance) {
    double near = tolerance;
    for (const intersect::MeetBranch &branch : meet.branches) {
        if (branch.kind == intersect::BranchKind::touch) {
            continue;
        }
        if (!std::isfinite(branch.deviation)) {
            fail(Status::not_converged, "a curve in which the surface meets the face is not proven");
        }
        near = std::max(near, branch.deviation);
    }
    return near;
}

// On which side of a surface points lie.
class SidesOfSurface {
public:
    SidesOfSurface(const Spline &surface, double tolerance)
        : surface_(surface), covering_(surface, tolerance), tolerance_(tolerance) {}

    // 1 in front, -1 at the back; 0 if the nearest point does not decide.
    [[nodiscard]] int of(const std::vector<double> &point) const {
        const closest::Foot foot = closest::locator_of(surface_).nearest(
            {point.data(), nullptr, tolerance_, closest::usual_budget(surface_), false, true});
        const bool certified = (foot.status & closest::closest_certified) != 0;
        if (!certified || !(foot.distance > 4 * tolerance_) || is_end({foot.params[0], foot.params[1]})) {
            return 0;
        }
        return side_at({foot.params[0], foot.params[1]}, point);
    }

private:
    [[nodiscard]] bool is_end(const Point2 &x) const {
        for (const int k : {0, 1}) {
            const auto [lower, upper] = covering_.domain(k);
            const double at = x[static_cast<size_t>(k)], room = 0x1p-30 * (upper - lower);
            if (!covering_.closed(k) && (at - lower <= room || upper - at <= room)) {
                return true;
            }
        }
        return false;
    }
    // The side of a point whose direction from the surface point at x makes an angle with a cosine above 0.99
    // with the normal or its opposite; else 0.
    [[nodiscard]] int side_at(const Point2 &x, const std::vector<double> &point) const {
        constexpr double upright = 0.99;
        std::array<double, 9> jet{};
        eval::evaluate_points(surface_, {}, 1, {x.data(), 1, 2, 2, 1}, {jet.data(), 1, 9, 9, 1});
        const Vector a{jet[3], jet[4], jet[5]}, b{jet[6], jet[7], jet[8]};
        const Vector normal{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        const Vector off{point[0] - jet[0], point[1] - jet[1], point[2] - jet[2]};
        const double height = off[0] * normal[0] + off[1] * normal[1] + off[2] * normal[2];
        const double most = std::hypot(off[0], off[1], off[2]) * std::hypot(normal[0], normal[1], normal[2]);
        return height > upright * most ? 1 : height < -upright * most ? -1 : 0;
    }

    const Spline &surface_;
    Covering covering_;
    double tolerance_;
};

int side_of(const Face &part, const SidesOfSurface &sides) {
    for (const Point2 &place : places_inside(part)) {
        if (const int side = sides.of(point_at(*part.surface(), place)); side != 0) {
            return side;
        }
    }
    fail(Status::incompatible,
         "the surface does not tell on which side of it a part of the face lies that it does not "
         "cross: it ends before, or is as near to it as the tolerance");
}

} // namespace

std::vector<FacePtr> kept_side(const Face &face, const SplinePtr &surface, SurfaceSide side,
                               double tolerance) {
    const intersect::Meet meet = intersect::surface_intersections(*face.surface(), *surface, tolerance);
    const Bridges bridged = bridges(face, *surface, meet, tolerance);
    check_decided(face, meet, bridged);
    const SplitFace split = split_with_sides(face, bridged.curves, near_of(meet, tolerance));
    if (split.loose) {
        check_told_apart(meet, bridged.nodes);
        fail(Status::incompatible, "the surface ends inside of the face at (%s, %s)",
             Number((*split.loose)[0]).text, Number((*split.loose)[1]).text);
    }
    const SidesOfSurface sides(*surface, tolerance);
    std::vector<FacePtr> kept;
    for (const SplitPart &part : split.parts) {
        if (part.left && part.right) {
            check_told_apart(meet, std::vector<bool>(meet.nodes.size(), false));
            fail(Status::incompatible, "a part of the face lies on both sides of the surface");
        }
        const int own = part.left ? 1 : part.right ? -1 : side_of(*part.face, sides);
        if (own == static_cast<int>(side)) {
            kept.push_back(part.face);
        }
    }
    return kept;
}

} // namespace nrb::face

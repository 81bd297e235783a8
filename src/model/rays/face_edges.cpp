// SPDX-License-Identifier: MIT
#include "model/rays/face_edges.h"

#include "bounds/box.h"
#include "eval/curve_point.h"
#include "face/boundary.h"
#include "intersect/rays/near_curve.h"
#include "model/rays/face_place.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {

namespace {

constexpr double largest_part = 1.0 / 64; // relative to the size of the face
constexpr int most_halvings = 8;

} // namespace

FaceEdges::FaceEdges(const face::Face &face, const std::vector<double> &rooms) {
    size_ = face_box(face).size();
    std::vector<face::BoundaryCurve> curves = face::boundary_curves(face);
    std::ranges::move(face::seam_curves(face), std::back_inserter(curves));
    for (face::BoundaryCurve &curve : curves) {
        const size_t loop = curve.loop >= 0 ? static_cast<size_t>(curve.loop) : rooms.size() - 1;
        add(face, std::move(curve.plane), std::move(curve.space), rooms[loop]);
    }
    tree_ = intersect::BoxTree(boxes_);
    boxes_ = {};
}

void FaceEdges::add(const face::Face &face, SplinePtr plane, SplinePtr space, double room) {
    if (space == nullptr) {
        add_boxes(face, *plane, room);
        return;
    }
    const intersect::Box3 box = box3_of(bounds::bounding_box(*space, whole_domain(*space), infinity));
    add_item({std::move(plane), std::move(space), room}, box);
}

// Covers a curve that has no exact image in space by boxes of the surface that are small compared with the
// face. Precondition: both coordinates of the curve are monotone, so that the rectangle between two of its
// places contains the part between them.
void FaceEdges::add_boxes(const face::Face &face, const Spline &plane, double room) {
    struct Part {
        Interval params;
        int halvings;
    };
    const auto at = [&](double t) {
        face::Point2 x{};
        eval::curve_point(plane, t, false, x.data());
        return x;
    };
    std::vector<Part> parts{{plane.axis(0).domain(), 0}};
    while (!parts.empty()) {
        const Part part = parts.back();
        parts.pop_back();
        const double middle = parameter_in(part.params, 0.5);
        const intersect::Box3 box = box_between(face, at(part.params.lower), at(part.params.upper));
        if (part.halvings < most_halvings && box.size() > std::max(4 * room, largest_part * size_)) {
            parts.push_back({{part.params.lower, middle}, part.halvings + 1});
            parts.push_back({{middle, part.params.upper}, part.halvings + 1});
            continue;
        }
        add_item({nullptr, nullptr, room, at(middle)}, box);
    }
}

void FaceEdges::add_item(Item item, intersect::Box3 box) {
    box.grow(item.room);
    boxes_.push_back(box);
    items_.push_back(std::move(item));
}

void FaceEdges::passages(const intersect::RayQuery &query, std::vector<EdgePassage> &out) const {
    tree_.walk(
        query, [&] { return query.range.upper; },
        [&](int32_t i, Interval where) {
            const Item &item = items_[static_cast<size_t>(i)];
            if (item.space == nullptr) {
                out.push_back({where, item.middle, item.room});
                return;
            }
            const intersect::CurvePassage passage = intersect::passage_near(*item.space, query, item.room);
            if (passage.there()) {
                face::Point2 at{};
                eval::curve_point(*item.plane, passage.param, false, at.data());
                out.push_back({passage.ts, at, item.room});
            }
        });
}

} // namespace nrb::model

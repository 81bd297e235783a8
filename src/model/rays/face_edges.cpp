// SPDX-License-Identifier: MIT
#include "model/rays/face_edges.h"

#include "bounds/box.h"
#include "eval/curve_point.h"
#include "face/boundary.h"
#include "intersect/rays/near_curve.h"
#include "model/rays/face_place.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {

namespace {

constexpr int parts_of_a_piece = 8;

} // namespace

FaceEdges::FaceEdges(const face::Face &face, const std::vector<double> &rooms) {
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

// Precondition: both parameters of the curve run one way.
void FaceEdges::add_boxes(const face::Face &face, const Spline &plane, double room) {
    const Interval domain = plane.axis(0).domain();
    face::Point2 from{}, to{};
    eval::curve_point(plane, domain.lower, false, from.data());
    for (int i = 1; i <= parts_of_a_piece; ++i, from = to) {
        eval::curve_point(plane, parameter_in(domain, static_cast<double>(i) / parts_of_a_piece), true,
                          to.data());
        Item item{nullptr, nullptr, room, {from[0] / 2 + to[0] / 2, from[1] / 2 + to[1] / 2}};
        item.middle = face.covering().in_domain(item.middle);
        add_item(std::move(item), box_between(face, from, to));
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
        [&](int32_t i) {
            const Item &item = items_[static_cast<size_t>(i)];
            if (item.space == nullptr) {
                out.push_back({query.range, item.middle});
                return;
            }
            const intersect::CurvePassage passage = intersect::passage_near(*item.space, query, item.room);
            if (passage.there()) {
                face::Point2 at{};
                eval::curve_point(*item.plane, passage.param, false, at.data());
                out.push_back({passage.ts, at});
            }
        });
}

} // namespace nrb::model

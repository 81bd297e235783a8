// SPDX-License-Identifier: MIT
#include "model/sewing/side_cuts.h"

#include "base/watch.h"
#include "closest/closest.h"
#include "refine/parts/cut.h"

#include <algorithm>

namespace nrb::model {

namespace {

void add_near(const Side &side, const Corners::Middle &vertex, double tolerance, std::vector<SideCut> &cuts) {
    const double x[] = {vertex.point.x, vertex.point.y, vertex.point.z};
    const closest::Foot foot =
        closest::locator_of(*side.image)
            .nearest({x, nullptr, tolerance / 64, closest::usual_budget(*side.image), false, true});
    if (foot.distance <= tolerance) {
        cuts.push_back({foot.params[0], vertex.vertex});
    }
}

bool is_small(const Side &side, double from, double to, double tolerance) {
    return !(from < to) || is_collapsed(*refine::cut_axis(side.image, 0, from, to, {true, true}), tolerance);
}

// Leaves out cuts after which, up to the next cut or the end of the side, no more than a collapsed piece
// would remain, and merges the vertices at the ends of such a piece.
std::vector<SideCut> kept_cuts(const Side &side, size_t number, std::vector<SideCut> &&found,
                               Corners &corners, double tolerance) {
    const Interval domain = side.image->axis(0).domain();
    std::ranges::sort(found, {}, &SideCut::param);
    std::vector<SideCut> result;
    SideCut before{domain.lower, corners.at(number, false)};
    for (const SideCut &cut : found) {
        if (is_small(side, before.param, cut.param, tolerance)) {
            corners.join(before.vertex, cut.vertex);
        } else {
            result.push_back(cut);
            before = cut;
        }
    }
    if (!result.empty() && is_small(side, before.param, domain.upper, tolerance)) {
        corners.join(before.vertex, corners.at(number, true));
        result.pop_back();
    }
    return result;
}

} // namespace

std::vector<std::vector<SideCut>> cuts_of(const std::vector<Side> &sides, Corners &corners,
                                          double tolerance) {
    std::vector<intersect::Box3> boxes;
    boxes.reserve(sides.size());
    for (const Side &side : sides) {
        boxes.push_back(side.box);
    }
    const intersect::BoxTree tree(boxes);
    std::vector<std::vector<SideCut>> found(sides.size()), result;
    for (const Corners::Middle &vertex : corners.middles()) {
        tree.walk_near(vertex.point, tolerance, [&](int32_t number) {
            const auto i = static_cast<size_t>(number);
            if (corners.at(i, false) != vertex.vertex && corners.at(i, true) != vertex.vertex) {
                add_near(sides[i], vertex, tolerance, found[i]);
            }
            count_work(64);
        });
    }
    for (size_t i = 0; i < sides.size(); ++i) {
        result.push_back(kept_cuts(sides[i], i, std::move(found[i]), corners, tolerance));
    }
    return result;
}

} // namespace nrb::model

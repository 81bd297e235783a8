// SPDX-License-Identifier: MIT
#include "model/sections/face_sections.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "intersect/levels/sections.h"
#include "model/rays/face_place.h"
#include "model/rays/scene.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::model {

namespace {

using intersect::MeetBranch;
using intersect::MeetNode;

// The range of normal . x over a box, enlarged by more than rounding.
Interval range_over(const intersect::Box3 &box, const Vector3 &normal) noexcept {
    const std::array<double, 3> n{normal.x, normal.y, normal.z};
    double middle = 0, half = 0, size = 0;
    for (size_t c = 0; c < 3; ++c) {
        middle += n[c] * (box.lower[c] / 2 + box.upper[c] / 2);
        half += std::abs(n[c]) * (box.upper[c] / 2 - box.lower[c] / 2);
        size += std::abs(n[c]) * std::max(std::abs(box.lower[c]), std::abs(box.upper[c]));
    }
    const double room = half * 0x1p-20 + 64 * eps * size;
    return {middle - half - room, middle + half + room};
}

Vector3 end_of(const Spline &curve, bool upper) {
    std::array<double, 3> x{};
    eval::end_point(curve, upper, x.data());
    return {x[0], x[1], x[2]};
}

} // namespace

FaceCutter::FaceCutter(const Model &model, const SharedBorders &borders, double tolerance)
    : model_(model), borders_(borders), tolerance_(tolerance), tolerances_(widest_tolerances(model)) {
    for (const ModelFace &face : model.faces) {
        boxes_.push_back(face_box(*face.face));
        count_work(64 * face.face->surface()->point_count());
    }
}

void FaceCutter::add(int64_t face, int64_t instance, const Placement &placement, const ParallelPlanes &planes,
                     FaceSections &out) {
    const auto number = static_cast<size_t>(face);
    const intersect::Box3 &box = boxes_[number];
    const Placement::Plane origin = placement.moved(Placement::Plane{planes.normal, 0});
    const Interval range = range_over(box, origin.normal);
    const double least = length(origin.normal) * tolerance_ / placement.growth_to_whole();
    const auto first = std::ranges::lower_bound(planes.offsets, range.lower - origin.offset - least),
               last = std::ranges::upper_bound(planes.offsets, range.upper - origin.offset + least);
    if (!(first < last)) {
        return;
    }
    std::vector<double> offsets;
    const auto from = first - planes.offsets.begin();
    for (auto offset = first; offset != last; ++offset) {
        offsets.push_back(placement.moved(Placement::Plane{planes.normal, *offset}).offset);
    }
    const face::Face &own = *model_.faces[number].face;
    const intersect::Meet meet =
        intersect::plane_sections(*own.surface(), {origin.normal.x, origin.normal.y, origin.normal.z},
                                  offsets, tolerance_ / placement.growth_to_whole());
    const auto levels = planes.levels.begin() + from;
    add_meet(face::trimmed_with_places(own, meet),
             {face,
              instance,
              placement,
              {levels, levels + std::ssize(offsets)},
              (model_.faces[number].against != borders_.is_turned(face)) != placement.mirrors()},
             out);
}

void FaceCutter::add_meet(const face::BorderedMeet &found, const Cut &cut, FaceSections &out) {
    nodes_.assign(found.meet.nodes.size(), -1);
    for (size_t i = 0; i < found.meet.branches.size(); ++i) {
        if (!is_above_shared_edge(found.courses[i], cut.face)) {
            add_branch(found, i, cut, out);
        }
    }
    for (size_t i = 0; i < nodes_.size(); ++i) {
        const MeetNode &node = found.meet.nodes[i];
        const bool stays =
            node.kind == intersect::NodeKind::touch || node.kind == intersect::NodeKind::undecided;
        nodes_[i] = nodes_[i] < 0 && stays ? add_node(node, cut, out) : nodes_[i];
        if (nodes_[i] >= 0 && node.next >= 0) {
            out.meet.nodes[static_cast<size_t>(nodes_[i])].next = nodes_[static_cast<size_t>(node.next)];
        }
    }
}

int64_t FaceCutter::add_node(const MeetNode &node, const Cut &cut, FaceSections &out) {
    MeetNode own = node;
    own.level = cut.levels[static_cast<size_t>(node.level)];
    own.next = -1;
    own.face = cut.face;
    own.instance = cut.instance;
    out.meet.nodes.push_back(own);
    return std::ssize(out.meet.nodes) - 1;
}

void FaceCutter::add_branch(const face::BorderedMeet &found, size_t i, const Cut &cut, FaceSections &out) {
    const auto face = static_cast<size_t>(cut.face);
    const double growth = cut.placement.growth_to_whole(), size = boxes_[face].magnitude();
    MeetBranch branch = found.meet.branches[i];
    branch.level = cut.levels[static_cast<size_t>(branch.level)];
    branch.space = cut.placement.in_whole(branch.space);
    branch.deviation = growth * branch.deviation + cut.placement.rounding(size);
    branch.loop = -1;
    branch.face = cut.face;
    branch.instance = cut.instance;
    if (cut.reversed) {
        branch.space = refine::reverse(*branch.space, 0, false);
        branch.on = refine::reverse(*branch.on, 0, false);
        std::swap(branch.nodes[0], branch.nodes[1]);
    }
    for (const bool begins : {true, false}) {
        int64_t &node = branch.nodes[begins ? 0 : 1];
        if (node < 0) {
            continue;
        }
        const auto own = static_cast<size_t>(node);
        nodes_[own] = nodes_[own] < 0 ? add_node(found.meet.nodes[own], cut, out) : nodes_[own];
        node = nodes_[own];
        SectionEnd end{
            std::ssize(out.meet.branches),
            begins,
            {},
            end_of(*branch.space, !begins),
            2 * (growth * tolerances_[face] + std::min(branch.deviation, tolerance_) + tolerance_) +
                0x1p-44 * growth * size};
        for (const face::BorderPlace &place : found.places[i][begins != cut.reversed ? 0 : 1]) {
            end.places.push_back({borders_.number(cut.face, place.loop, place.index), place.param});
        }
        out.ends.push_back(std::move(end));
    }
    out.meet.branches.push_back(std::move(branch));
}

bool FaceCutter::is_above_shared_edge(const face::Course &course, int64_t face) const {
    return course.direction == face::Direction::with_loop &&
           borders_.coedge(borders_.number(face, course.loop, course.index)).pair >= 0;
}

} // namespace nrb::model

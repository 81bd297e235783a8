// SPDX-License-Identifier: MIT
#include "face/meets/shared_parts.h"

#include "base/error.h"
#include "face/arrange/face_loops.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nrb::face {

namespace {

constexpr int32_t owner_face = 0, owner_regions = 1;

bool is_in_both(const PassedSums &values) {
    int in_face = 0, in_regions = 0;
    for (const PassedSum &sum : values) {
        (sum.loop == owner_face ? in_face : in_regions) = sum.value;
    }
    if (in_regions > 1) {
        fail(Status::not_converged, "regions that two surfaces share lie on each other");
    }
    return in_face > 0 && in_regions > 0;
}

} // namespace

FacePtr SharedParts::face_of(const SharedGrounds &grounds, size_t k, const SharedLoops &loops) {
    FaceParts parts{grounds.surface(k), {}, grounds.near(), true, true};
    for (const SharedLoop &loop : loops) {
        Loop &own = parts.loops.emplace_back();
        for (const SharedCurve &curve : loop) {
            own.push_back({curve.on[k], curve.space});
        }
    }
    return std::make_shared<const Face>(std::move(parts), nullptr);
}

// The loops of regions come first: where a curve of the face runs along one of them, the curve of the region
// is used, which is known on both surfaces.
SharedParts::SharedParts(const SharedGrounds &grounds, size_t k, const Face &face,
                         std::vector<SharedLoops> regions)
    : grounds_(grounds), k_(k), regions_(std::move(regions)) {
    if (face.has_gaps()) {
        fail(Status::gap, "the face has gaps larger than its tolerance");
    }
    std::vector<FacePtr> faces;
    for (size_t region = 0; region < regions_.size(); ++region) {
        faces.push_back(face_of(grounds, k, regions_[region]));
        add(*faces.back(), owner_regions, region);
    }
    add(face, owner_face, 0);
    arrangement_.emplace(grounds.covering(k), loops_, grounds.near());
    AtCorner corner(*arrangement_);
    for (const FacePtr &region : faces) {
        corner.add(*region, owner_regions);
    }
    corner.add(face, owner_face);
    inside_.emplace(*arrangement_, corner.sums(), is_in_both);
}

void SharedParts::add(const Face &face, int32_t owner, size_t region) {
    std::ranges::move(loops_of(face, owner), std::back_inserter(loops_));
    const size_t first = sources_.size();
    sources_.resize(loops_.size());
    for (size_t i = 0; owner == owner_regions && i < regions_[region].size(); ++i) {
        sources_[first + i] = Source{region, i};
    }
}

std::vector<SharedLoops> SharedParts::parts() const {
    std::vector<SharedLoops> result;
    std::vector<FacePtr> faces;
    for (const PartLoops &part : inside_->list()) {
        SharedLoops &own = result.emplace_back();
        for (const EdgeLoop &loop : part) {
            if (SharedLoop made = loop_of(loop); !made.empty()) {
                own.push_back(std::move(made));
            }
        }
        faces.push_back(face_of(grounds_, k_, own));
    }
    inside_->check(faces);
    return result;
}

SharedLoop SharedParts::loop_of(const EdgeLoop &loop) const {
    SharedLoop made;
    for (const Run &run : runs_of(*arrangement_, loop, RunRule::longest)) {
        add(run, made);
    }
    grounds_.join(made);
    return made;
}

void SharedParts::add(const Run &run, SharedLoop &loop) const {
    const auto &cuts = arrangement_->cuts().edges();
    const Arrangement::Origin &origin = arrangement_->origin(cuts[run.first]);
    if (const auto &source = sources_[origin.loop]) {
        const CutEdge &lower = cuts[run.back ? run.last : run.first],
                      &upper = cuts[run.back ? run.first : run.last];
        loop.push_back(part_of(regions_[source->region][source->loop][origin.index],
                               {lower.range.lower, upper.range.upper}, run.back));
    } else {
        std::ranges::move(grounds_.over(k_, curve_of(*arrangement_, run)), std::back_inserter(loop));
    }
}

std::vector<SharedCurve> SharedParts::edges() const {
    const auto owner_of = [&](const Arrangement::Member &member) {
        return arrangement_->loop(arrangement_->cuts().edges()[member.cut]).owner;
    };
    const auto has = [&](const Arrangement::Edge &edge, int32_t owner) {
        return std::ranges::any_of(edge.members, [&](const auto &own) { return owner_of(own) == owner; });
    };
    // Edges against the direction of their cuts come last and in descending order, so that runs continue.
    std::vector<DirectedEdge> along = inside_->outer_edges([&](const Arrangement::Edge &edge) {
        return has(edge, owner_face) && has(edge, owner_regions) && !edge.in_a_point;
    });
    for (DirectedEdge &edge : along) {
        const auto &members = arrangement_->edges()[edge.edge].members;
        edge.back = std::ranges::find(members, owner_face, owner_of)->against;
    }
    const auto against =
        std::stable_partition(along.begin(), along.end(), [](DirectedEdge edge) { return !edge.back; });
    std::reverse(against, along.end());
    std::vector<SharedCurve> result;
    for (const Run &run :
         along.empty() ? std::vector<Run>() : runs_of(*arrangement_, along, RunRule::longest)) {
        add(run, result);
    }
    return result;
}

} // namespace nrb::face

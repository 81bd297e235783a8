// SPDX-License-Identifier: MIT
#include "face/meets/face_regions.h"

#include "base/error.h"
#include "face/meets/region_branches.h"
#include "face/meets/shared_parts.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nrb::face {

namespace {

using intersect::Meet;
using intersect::MeetBranch;
using intersect::MeetNode;

SharedLoops loops_of(const Meet &meet, int64_t level) {
    SharedLoops loops;
    int64_t last = -1;
    for (const MeetBranch &branch : meet.branches) {
        if (branch.kind == intersect::BranchKind::overlap && branch.level == level) {
            if (loops.empty() || branch.loop != last) {
                loops.emplace_back();
            }
            last = branch.loop;
            loops.back().push_back({branch.space, {branch.on, branch.on_second}, branch.deviation});
        }
    }
    return loops;
}

SharedLoops turned(const SharedLoops &loops) {
    SharedLoops result;
    std::ranges::transform(loops, std::back_inserter(result),
                           [](const SharedLoop &loop) { return turned(loop); });
    return result;
}

// Whether an error means that two faces leave something open, rather than a fault of the caller.
bool leaves_open(Status status) noexcept {
    return status == Status::not_converged || status == Status::gap || status == Status::orientation ||
           status == Status::outside_domain || status == Status::crossing || status == Status::weight_sign;
}

} // namespace

FaceRegions::FaceRegions(const Face &a, const Face &b, const std::array<SplinePtr, 2> &grounds,
                         double tolerance)
    : a_(a), b_(b), grounds_(grounds, {a.tolerance(), b.tolerance()}, tolerance) {}

std::optional<Meet> FaceRegions::within(const Meet &surfaces, const MeetNode &region) {
    try {
        return cut_out(loops_of(surfaces, region.level), grounds_.is_alike(region.at, region.at_second));
    } catch (const Error &error) {
        if (!leaves_open(error.status())) {
            throw;
        }
    }
    return std::nullopt;
}

// alike: whether loops with the region to their left in one domain also have it to their left in the other
// one.
Meet FaceRegions::cut_out(const SharedLoops &loops, bool alike) {
    const auto seen_from_other = [alike](const SharedLoops &own) { return alike ? own : turned(own); };
    std::vector<SharedLoops> parts;
    for (const SharedLoops &part : SharedParts(grounds_, 1, b_, {seen_from_other(loops)}).parts()) {
        parts.push_back(seen_from_other(part));
    }
    Meet found;
    found.of_two = true;
    if (parts.empty()) {
        return found;
    }
    const SharedParts shared(grounds_, 0, a_, parts);
    RegionBranches branches(grounds_, found);
    int64_t level = found_;
    for (const SharedLoops &part : shared.parts()) {
        branches.add_region(part, ++level);
    }
    for (const SharedCurve &edge : shared.edges()) {
        branches.add_edge(edge);
    }
    found_ = level;
    return found;
}

} // namespace nrb::face

// SPDX-License-Identifier: MIT
#include "model/rays/closed.h"

#include "base/error.h"
#include "face/open_ends.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace nrb::model {

namespace {

// Checks that each solid uses the edge an even number of times, and so do all faces together that bound none.
void check_edge(const Model &model, size_t index) {
    const Edge &edge = model.edges[index];
    std::map<int64_t, int> uses;
    for (const EdgeUse &use : edge.uses) {
        ++uses[model.faces[static_cast<size_t>(use.face)].solid];
    }
    for (const auto &[solid, count] : uses) {
        if (count % 2 != 0) {
            fail(Status::gap, "edge %zu is used %d times%s, expected twice: the faces are not closed", index,
                 count, solid < 0 ? "" : " by faces of a solid");
        }
    }
}

bool is_pole(const face::Covering &covering, const face::EndPart &part) noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const int axis = static_cast<int>(k);
        const Interval domain = covering.domain(axis);
        if (part.from[k] == part.to[k]) {
            return (part.from[k] == domain.lower && covering.collapsed(axis, 0)) ||
                   (part.from[k] == domain.upper && covering.collapsed(axis, 1));
        }
    }
    return false;
}

// Whether an open end of the domain runs along the loops, by samples. Loops may leave the domain by up to the
// tolerance; the face then ends at the end of the domain, near the loop.
bool is_near_loops(const face::Face &face, const face::EndPart &part) {
    constexpr int samples = 17;
    std::vector<double> places;
    for (int i = 0; i < samples; ++i) {
        const double share = static_cast<double>(i) / (samples - 1);
        for (size_t k = 0; k < 2; ++k) {
            places.push_back(part.from[k] * (1 - share) + part.to[k] * share);
        }
    }
    std::array<int32_t, samples> sides{};
    face::classify(face, {places.data(), samples, 2, 2, 1}, 2 * face.tolerance(), sides.data());
    return std::ranges::all_of(sides, [](int32_t side) { return side == 0; });
}

bool jumps(const Spline &surface) {
    for (int k = 0; k < 2; ++k) {
        const KnotVector &axis = surface.axis(k);
        const Interval domain = axis.domain();
        for (const KnotGroup &group : distinct_knots(axis.knots())) {
            if (domain.lower < group.knot && group.knot < domain.upper &&
                group.multiplicity > axis.degree()) {
                return true;
            }
        }
    }
    return false;
}

void check_face(const face::Face &face, size_t index) {
    const std::vector<face::EndPart> ends = face::open_ends(face);
    if (std::ranges::any_of(ends, [&](const face::EndPart &part) {
            return !is_pole(face.covering(), part) && !is_near_loops(face, part);
        })) {
        fail(Status::gap, "face %zu ends where no edge bounds it", index);
    }
    if (face.has_gaps()) {
        fail(Status::gap, "face %zu has a loop with a gap", index);
    }
    if (jumps(*face.surface())) {
        fail(Status::gap, "the surface of face %zu may jump, at a knot of more than its degree", index);
    }
}

} // namespace

void check_closed(const Model &model) {
    for (size_t i = 0; i < model.edges.size(); ++i) {
        check_edge(model, i);
    }
    for (size_t i = 0; i < model.faces.size(); ++i) {
        check_face(*model.faces[i].face, i);
    }
}

} // namespace nrb::model

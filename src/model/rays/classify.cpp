// SPDX-License-Identifier: MIT
#include "model/rays/classify.h"

#include "base/error.h"
#include "base/watch.h"
#include "basis/knot_vector.h"
#include "closest/closest.h"
#include "face/open_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace nrb::model {

namespace {

constexpr int most_directions = 16;

// Spread over the sphere, in no plane with its axes: a spiral of golden angles.
Vector3 direction_of(int i) noexcept {
    constexpr double golden = 2.399963229728653;
    const double z = 0.96837 - 1.93713 * ((5 * i) % most_directions) / (most_directions - 1),
                 angle = 0.71 + golden * i, radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

// Whether each solid of a part, and all faces of it that bound none, use an edge an even number of times.
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

// Where loops leave the domain by no more than a tolerance, the face ends with that, near to them.
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

Classifier::Classifier(const Model &model, double tolerance)
    : model_(model), scene_(closed_scene_of(model)), caster_(model, scene_), tolerance_(tolerance),
      groups_(static_cast<size_t>(scene_.groups())) {}

Side Classifier::side(const Vector3 &x) {
    if (const Side near = nearness(x); near != side_outside) {
        return near;
    }
    std::ranges::fill(groups_, Group{});
    for (int i = 0; i < most_directions; ++i) {
        if (const Side found = side_along(x, direction_of(i)); found != side_undecided) {
            return found;
        }
    }
    return side_undecided;
}

// On a face, or for certain on none: outside.
Side Classifier::nearness(const Vector3 &x) const {
    Side found = side_outside;
    if (tolerance_ > 0) {
        scene_.tree().walk_near(x, tolerance_, [&](int32_t i) {
            const Side own = found == side_on ? side_on : nearness(x, scene_.face(i));
            found = own == side_on || found == side_outside ? own : found;
        });
    }
    return found;
}

Side Classifier::nearness(const Vector3 &x, const PlacedFace &placed) const {
    const face::Face &face = *model_.faces[static_cast<size_t>(placed.face)].face;
    const Placement &placement = scene_.placement(placed);
    const Vector3 local = placement.moved(x);
    const double error = placement.error(x), at[] = {local.x, local.y, local.z};
    const double far = placement.growth_to_part() * tolerance_ + error,
                 near = tolerance_ / placement.growth_to_whole() - error;
    const closest::Foot foot =
        closest::locator_of(*face.surface())
            .nearest({at, nullptr, tolerance_ / 1024, closest::usual_budget(*face.surface()), false, true});
    if ((foot.status & closest::closest_certified) != 0 &&
        foot.distance - tolerance_ / 1024 - foot.noise > far) {
        return side_outside;
    }
    const bool on =
        foot.distance + foot.noise <= near && face.trims().side({foot.params[0], foot.params[1]}) >= 0;
    return on ? side_on : side_undecided;
}

// Of the groups that the ray meets, those that it has left as often as it has entered them are settled.
Side Classifier::side_along(const Vector3 &x, const Vector3 &direction) {
    met_.clear();
    const intersect::RayQuery query{x, direction};
    scene_.tree().walk(
        query, [] { return infinity; }, [&](int32_t i, Interval) { pass(i, query); });
    bool sure = true;
    for (const int64_t i : met_) {
        Group &group = groups_[static_cast<size_t>(i)];
        if (group.sure && group.passed % 2 != 0) {
            return side_inside;
        }
        sure = sure && group.sure;
        group = {0, true, group.sure};
    }
    return sure ? side_outside : side_undecided;
}

// What is met where the ray begins, or on a border of two pieces, may count twice or not at all.
void Classifier::pass(int32_t placed, const intersect::RayQuery &query) {
    const int64_t number = scene_.face(placed).group;
    Group &group = groups_[static_cast<size_t>(number)];
    if (group.settled) {
        return;
    }
    if (std::ranges::find(met_, number) == met_.end()) {
        met_.push_back(number);
    }
    meets_.clear();
    bool sure = group.sure && !work_ended() && caster_.all_of(placed, query, meets_);
    for (const PlacedMeet &meet : meets_) {
        sure = sure && meet.answer.inside && meet.answer.t > 128 * meet.room;
    }
    group.passed += static_cast<int>(meets_.size());
    group.sure = sure;
}

} // namespace nrb::model

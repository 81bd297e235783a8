// SPDX-License-Identifier: MIT
#include "model/rays/classify.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {

namespace {

constexpr int most_directions = 16;

// Directions on a golden-angle spiral, which spreads them over the sphere. None lies in a coordinate plane.
Vector3 direction_of(int i) noexcept {
    constexpr double golden = 2.399963229728653;
    const double z = 0.96837 - 1.93713 * ((5 * i) % most_directions) / (most_directions - 1),
                 angle = 0.71 + golden * i, radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

} // namespace

Classifier::Classifier(const Model &model, double tolerance)
    : model_(model), scene_(closed_scene_of(model)), caster_(model, scene_), tolerance_(tolerance),
      locators_(model.faces.size()), groups_(static_cast<size_t>(scene_.groups())) {}

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

// side_on: on a face; side_outside: certainly on none; side_undecided otherwise.
Side Classifier::nearness(const Vector3 &x) {
    Side found = side_outside;
    if (tolerance_ > 0) {
        scene_.tree().walk_near(x, tolerance_, [&](int32_t i) {
            const Side own = found == side_on ? side_on : nearness(x, scene_.face(i));
            found = own == side_on || found == side_outside ? own : found;
        });
    }
    return found;
}

Side Classifier::nearness(const Vector3 &x, const PlacedFace &placed) {
    const Placement &placement = scene_.placement(placed);
    const Vector3 local = placement.moved(x);
    const double error = placement.error(x), at[] = {local.x, local.y, local.z};
    const double far = placement.growth_to_part() * tolerance_ + error,
                 near = tolerance_ / placement.growth_to_whole() - error,
                 precision = tolerance_ / (1024 * placement.growth_to_whole());
    const closest::Foot foot = locator(placed.face).nearest(at, precision, far).foot;
    const bool certified = (foot.status & closest::closest_certified) != 0;
    return certified && foot.distance - precision - foot.noise > far ? side_outside
           : foot.distance + foot.noise <= near                      ? side_on
                                                                     : side_undecided;
}

face::FaceLocator &Classifier::locator(int64_t face) {
    auto &own = locators_[static_cast<size_t>(face)];
    if (own == nullptr) {
        own = std::make_unique<face::FaceLocator>(*model_.faces[static_cast<size_t>(face)].face);
    }
    return *own;
}

// Decides by the parity of the crossings of each group of faces that the ray meets, where these are certain.
// An odd number puts the point inside. A group with an even number is settled, and is left out in further
// directions.
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

// Crossings at the origin of the ray, or on the border between two Bezier pieces, may be counted twice or not
// at all: the direction then proves nothing for the group.
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

// SPDX-License-Identifier: MIT
#include "model/rays/model_caster.h"

#include "base/watch.h"
#include "face/face_rays.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace nrb::model {

namespace {

// In the range of the ray, finite where that is possible.
intersect::RayAnswer touch_of(const EdgePassage &passage, const face::Face &face, Interval range) {
    const Interval ts{std::max(passage.ts.lower, range.lower), std::min(passage.ts.upper, range.upper)};
    const double middle = ts.lower / 2 + ts.upper / 2;
    const double t = std::isfinite(middle) ? middle : std::isfinite(ts.lower) ? ts.lower : ts.upper;
    return {face.covering().in_domain(passage.params), t, intersect::ray_touch, ts, false};
}

} // namespace

ModelCaster::ModelCaster(const Model &model, const Scene &scene)
    : model_(model), scene_(scene), casters_(model.faces.size()) {}

intersect::RayCaster &ModelCaster::caster(int64_t face) {
    auto &own = casters_[static_cast<size_t>(face)];
    if (own == nullptr) {
        const face::Face &made = *model_.faces[static_cast<size_t>(face)].face;
        own = std::make_unique<intersect::RayCaster>(*made.surface(), face::trim_filter(made));
    }
    return *own;
}

const std::vector<EdgePassage> &ModelCaster::passages(const intersect::RayQuery &query, int64_t face) {
    passages_.clear();
    scene_.edges(model_, face).passages(query, passages_);
    return passages_;
}

ModelAnswer ModelCaster::first(const intersect::RayQuery &query) {
    intersect::FirstMeets meets;
    int32_t hit = -1, touch = -1;
    const auto add_touch = [&](intersect::RayAnswer answer, int32_t placed) {
        const double from = std::min(answer.ts.lower, meets.touch_from());
        if (!meets.touch || answer.t < meets.touch->t) {
            meets.touch = answer;
            touch = placed;
        }
        meets.touch->ts.lower = from;
    };
    const auto limit = [&] { return meets.hit ? meets.hit->t : query.range.upper; };
    const int64_t visits = scene_.tree().walk(query, limit, [&](int32_t i) {
        if (work_ended()) {
            meets.complete = false;
            return;
        }
        const PlacedFace &placed = scene_.face(i);
        intersect::RayQuery local = scene_.placement(placed).moved(query);
        local.range.upper = limit();
        for (const EdgePassage &passage : passages(local, placed.face)) {
            add_touch(touch_of(passage, *model_.faces[static_cast<size_t>(placed.face)].face, local.range),
                      i);
        }
        const intersect::FirstMeets own = caster(placed.face).first(local);
        if (own.hit && !(meets.hit && meets.hit->t <= own.hit->t)) {
            meets.hit = own.hit;
            hit = i;
        }
        if (own.touch) {
            add_touch(*own.touch, i);
        }
        meets.room = std::max(meets.room, own.room);
        meets.complete = meets.complete && own.complete;
    });
    count_work(30 * visits);
    const intersect::RayAnswer answer = meets.answer();
    const bool hits = (answer.status & intersect::ray_hit) != 0,
               touches = (answer.status & intersect::ray_touch) != 0;
    return hits || touches ? this->answer({answer, hits ? hit : touch, meets.room}) : ModelAnswer{answer};
}

bool ModelCaster::all(const intersect::RayQuery &query, std::vector<PlacedMeet> &out) {
    const size_t before = out.size();
    bool sure = true;
    const int64_t visits = scene_.tree().walk(
        query, [&] { return query.range.upper; },
        [&](int32_t i) { sure = !work_ended() && all_of(i, query, out) && sure; });
    count_work(30 * visits);
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(before), out.end(),
              [](const PlacedMeet &a, const PlacedMeet &b) {
                  return std::tie(a.answer.t, a.placed) < std::tie(b.answer.t, b.placed);
              });
    return sure;
}

// Touches of the surface near an edge are those of the edge.
bool ModelCaster::all_of(int32_t placed, const intersect::RayQuery &given, std::vector<PlacedMeet> &out) {
    const int64_t face = scene_.face(placed).face;
    const intersect::RayQuery query = scene_.placement(scene_.face(placed)).moved(given);
    double room = 0;
    answers_.clear();
    bool sure = caster(face).all(query, answers_, &room);
    const std::vector<EdgePassage> &near = passages(query, face);
    for (const EdgePassage &passage : near) {
        out.push_back(
            {touch_of(passage, *model_.faces[static_cast<size_t>(face)].face, query.range), placed, room});
    }
    for (const intersect::RayAnswer &answer : answers_) {
        const bool known = std::ranges::any_of(near, [&](const EdgePassage &passage) {
            return passage.ts.lower - room <= answer.t && answer.t <= passage.ts.upper + room;
        });
        if ((answer.status & intersect::ray_touch) == 0 || !known) {
            out.push_back({answer, placed, room});
        }
    }
    return sure && near.empty();
}

// The side is that of the outer normal, which is the same in all places.
ModelAnswer ModelCaster::answer(const PlacedMeet &meet) const {
    const PlacedFace &placed = scene_.face(meet.placed);
    ModelAnswer result{meet.answer, placed.face, placed.instance};
    const bool hit = (meet.answer.status & intersect::ray_hit) != 0;
    if (hit && model_.faces[static_cast<size_t>(placed.face)].against) {
        result.answer.status ^= intersect::ray_back;
    }
    return result;
}

} // namespace nrb::model

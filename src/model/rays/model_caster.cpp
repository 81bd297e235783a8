// SPDX-License-Identifier: MIT
#include "model/rays/model_caster.h"

#include "base/watch.h"
#include "face/face_rays.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace nrb::model {

namespace {

// The touch that a passage near an edge stands for: clipped to the range of the ray, at a finite t where
// possible.
intersect::RayAnswer touch_of(const EdgePassage &passage, const face::Face &face, Interval range) {
    const Interval ts{std::max(passage.ts.lower, range.lower), std::min(passage.ts.upper, range.upper)};
    const double middle = ts.lower / 2 + ts.upper / 2;
    const double t = std::isfinite(middle) ? middle : std::isfinite(ts.lower) ? ts.lower : ts.upper;
    return {face.covering().in_domain(passage.params), t, intersect::ray_touch, ts, false};
}

// The ray with a direction whose largest coordinate is about 1, so that products with it neither overflow nor
// underflow. Its t is that of the query times a power of two.
class ScaledRay {
public:
    explicit ScaledRay(const intersect::RayQuery &query) noexcept
        : exponent_(size_exponent(query.direction)), query_(query) {
        query_.direction = times_power(query.direction, -exponent_);
        query_.range = {std::ldexp(query.range.lower, exponent_), std::ldexp(query.range.upper, exponent_)};
    }
    [[nodiscard]] const intersect::RayQuery &query() const noexcept { return query_; }
    // A t that overflows certifies nothing.
    void unscale(intersect::RayAnswer &answer) const noexcept {
        answer.t = std::ldexp(answer.t, -exponent_);
        answer.ts = {std::ldexp(answer.ts.lower, -exponent_), std::ldexp(answer.ts.upper, -exponent_)};
        answer.status &= std::isinf(answer.t) ? ~intersect::ray_certified : ~0;
    }

private:
    int exponent_;
    intersect::RayQuery query_;
};

} // namespace

ModelCaster::ModelCaster(const Model &model, const Scene &scene)
    : model_(model), scene_(scene), casters_(model.faces.size()) {}

intersect::RayCaster &ModelCaster::caster(int64_t face) {
    auto &own = casters_[static_cast<size_t>(face)];
    if (own == nullptr) {
        const face::Face &made = this->face(face);
        own = std::make_unique<intersect::RayCaster>(*made.surface(), face::trim_filter(made));
    }
    return *own;
}

const std::vector<EdgePassage> &ModelCaster::passages(const intersect::RayQuery &query, int64_t face) {
    passages_.clear();
    scene_.edges(model_, face).passages(query, passages_);
    return passages_;
}

// Collects what a ray meets on its way to the first hit.
class ModelCaster::First {
public:
    First(const intersect::RayQuery &query, ModelCaster &caster)
        : query_(query), speed_(length(query.direction)), caster_(caster) {}

    [[nodiscard]] double limit() const noexcept { return meets_.hit ? meets_.hit->t : query_.range.upper; }

    void look_at(int32_t i) {
        if (work_ended()) {
            meets_.complete = false;
            return;
        }
        const PlacedFace &placed = caster_.scene_.face(i);
        const Placement &placement = caster_.scene_.placement(placed);
        intersect::RayQuery local = placement.moved(query_);
        local.range.upper = limit();
        for (const EdgePassage &passage : caster_.passages(local, placed.face)) {
            const auto answer = touch_of(passage, caster_.face(placed.face), local.range);
            edges_.push_back({{answer, i, 0}, placement.growth_to_whole() * passage.room / speed_});
        }
        add(caster_.caster(placed.face).first(local), i);
    }
    // An edge passage does not count if a hit follows within a few rooms: the hit is that of the face or of
    // its neighbour at the edge.
    [[nodiscard]] ModelAnswer answer() {
        for (const Edge &edge : edges_) {
            const double from = edge.meet.answer.ts.lower;
            if (!meets_.hit || from + most_rooms * edge.room < meets_.hit->t) {
                add_touch(edge.meet.answer, edge.meet.placed);
            }
        }
        const intersect::RayAnswer answer = meets_.answer();
        const bool hits = (answer.status & intersect::ray_hit) != 0,
                   touches = (answer.status & intersect::ray_touch) != 0;
        return hits || touches ? caster_.answer({answer, hits ? hit_ : touch_, meets_.room})
                               : ModelAnswer{answer};
    }

private:
    static constexpr double most_rooms = 4;
    struct Edge {
        PlacedMeet meet;
        double room; // converted to t
    };

    void add(const intersect::FirstMeets &own, int32_t placed) {
        if (own.hit && !(meets_.hit && meets_.hit->t <= own.hit->t)) {
            meets_.hit = own.hit;
            hit_ = placed;
        }
        if (own.touch) {
            add_touch(*own.touch, placed);
        }
        meets_.room = std::max(meets_.room, own.room);
        meets_.complete = meets_.complete && own.complete;
    }
    void add_touch(const intersect::RayAnswer &answer, int32_t placed) {
        const double from = std::min(answer.ts.lower, meets_.touch_from());
        if (!meets_.touch || answer.t < meets_.touch->t) {
            meets_.touch = answer;
            touch_ = placed;
        }
        meets_.touch->ts.lower = from;
    }

    const intersect::RayQuery &query_;
    double speed_;
    ModelCaster &caster_;
    intersect::FirstMeets meets_;
    int32_t hit_ = -1, touch_ = -1;
    std::vector<Edge> edges_;
};

ModelAnswer ModelCaster::first(const intersect::RayQuery &query) {
    const ScaledRay ray(query);
    ModelAnswer found = first_of(ray.query());
    ray.unscale(found.answer);
    return found;
}

ModelAnswer ModelCaster::first_of(const intersect::RayQuery &query) {
    First meets(query, *this);
    const int64_t visits = scene_.tree().walk(
        query, [&] { return meets.limit(); }, [&](int32_t i, Interval) { meets.look_at(i); });
    count_work(30 * visits);
    return meets.answer();
}

bool ModelCaster::all(const intersect::RayQuery &query, std::vector<PlacedMeet> &out) {
    const ScaledRay ray(query);
    const auto limit = [&] { return ray.query().range.upper; };
    bool sure = true;
    const int64_t visits = scene_.tree().walk(ray.query(), limit, [&](int32_t i, Interval) {
        sure = !work_ended() && all_of(i, ray.query(), out) && sure;
    });
    count_work(30 * visits);
    for (PlacedMeet &meet : out) {
        ray.unscale(meet.answer);
        sure = sure && std::isfinite(meet.answer.t);
    }
    std::ranges::sort(out, [](const PlacedMeet &a, const PlacedMeet &b) {
        return std::tie(a.answer.t, a.placed) < std::tie(b.answer.t, b.placed);
    });
    return sure;
}

// Touches of the surface within an edge passage are left out, since the passage itself is a touch.
bool ModelCaster::all_of(int32_t placed, const intersect::RayQuery &given, std::vector<PlacedMeet> &out) {
    const int64_t face = scene_.face(placed).face;
    const intersect::RayQuery query = scene_.placement(scene_.face(placed)).moved(given);
    double room = 0;
    answers_.clear();
    bool sure = caster(face).all(query, answers_, &room);
    const std::vector<EdgePassage> &near = passages(query, face);
    for (const EdgePassage &passage : near) {
        out.push_back({touch_of(passage, this->face(face), query.range), placed, room});
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

// ray_back is made to refer to the outer normal instead of that of the surface. No placement changes on which
// side of a surface a ray arrives.
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

// SPDX-License-Identifier: MIT
#include "intersect/rays/rays.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/rays/ray_solver.h"
#include "intersect/rays/ray_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace nrb::intersect {

RayAnswer FirstMeets::answer() const noexcept {
    const auto nothing = [](bool certified) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        return RayAnswer{{none, none}, none, certified ? ray_certified : 0};
    };
    if (!hit && !touch) {
        return nothing(complete);
    }
    const bool before = touches_before();
    RayAnswer answer = hit && !(before && touch->t < hit->t) ? *hit : *touch;
    if (std::isnan(answer.t)) { // too far away to be located
        return nothing(false);
    }
    answer.status |= complete && !before && std::isfinite(answer.t) ? ray_certified : 0;
    return answer;
}

// Works in the frame of the pieces.
class RayCaster::Cast {
public:
    Cast(const Spline &surface, PlaceFilter filter)
        : tree_(ray_tree_of(surface)), grid_(tree_.grid()), solver_(grid_), filter_(std::move(filter)) {}

    FirstMeets first(const RayQuery &query) {
        set(query);
        std::optional<RayMeet> hit, touch;
        double touch_from = infinity;
        const auto limit = [&] { return hit ? hit->t : range_.upper; };
        FirstMeets meets;
        meets.complete = walk(limit, [&](RayMeet meet) {
            if (!counts(meet)) {
                return;
            }
            std::optional<RayMeet> &found = meet.proven ? hit : touch;
            touch_from = meet.proven ? touch_from : std::min(touch_from, meet.ts.lower);
            if (!found || meet.t < found->t) {
                found = meet;
            }
        });
        if (hit) {
            meets.hit = answer_of(*hit);
        }
        if (touch) {
            touch->ts.lower = touch_from;
            meets.touch = answer_of(*touch);
        }
        meets.room = solver_.room() / placed_.factor;
        return meets;
    }

    bool all(const RayQuery &query, std::vector<RayAnswer> &out, double *room) {
        set(query);
        meets_.clear();
        const auto limit = [&] { return range_.upper; };
        const bool complete = walk(limit, [&](RayMeet meet) {
            if (counts(meet)) {
                meets_.push_back(meet);
            }
        });
        std::ranges::sort(meets_, {}, [](const RayMeet &meet) {
            return std::tuple(meet.ts.lower, meet.piece, meet.place);
        });
        merge();
        bool sure = complete;
        for (const RayMeet &meet : meets_) {
            const RayAnswer answer = answer_of(meet);
            sure = sure && meet.proven && std::isfinite(answer.t);
            if (!std::isnan(answer.t)) {
                out.push_back(answer);
            }
        }
        if (room != nullptr) {
            *room = solver_.room() / placed_.factor;
        }
        return sure;
    }

private:
    void set(const RayQuery &query) {
        placed_ = PlacedRay(grid_, query);
        range_ = {placed_.in_frame(query.range.lower), placed_.in_frame(query.range.upper)};
        solver_.set_ray(placed_);
    }
    // Whether the filter accepts a hit. If it cannot decide, the hit becomes a touch.
    bool counts(RayMeet &meet) const {
        const int side = filter_ ? filter_(box_of(meet)) : 1;
        meet.proven = meet.proven && side > 0;
        return side >= 0;
    }

    // Visits the nearer child first. Returns whether all pieces were searched that may hold an intersection
    // up to the limit.
    template <class Limit, class Found>
    bool walk(Limit &&limit, Found &&found) {
        stack_.clear();
        push(0);
        bool complete = true;
        int64_t visits = 0;
        while (!stack_.empty()) {
            const Visit visit = stack_.back();
            stack_.pop_back();
            ++visits;
            if (visit.from > limit() + solver_.room()) {
                continue;
            }
            if (tree_.is_piece(visit.node)) {
                complete = solver_.solve(tree_.piece(visit.node), range_.lower, limit, found) && complete;
                continue;
            }
            const size_t before = stack_.size();
            push(tree_.right(visit.node));
            push(visit.node + 1);
            if (stack_.size() == before + 2 && stack_[before + 1].from > stack_[before].from) {
                std::swap(stack_[before], stack_[before + 1]);
            }
        }
        count_work(20 * visits);
        return complete;
    }
    void push(int32_t node) {
        const Interval inside = tree_.meets(node, placed_.ray, solver_.room());
        if (inside.lower <= inside.upper && inside.upper >= range_.lower && inside.lower <= range_.upper) {
            stack_.push_back({node, std::max(inside.lower, range_.lower)});
        }
    }

    // Merges hits that two pieces have on their common edge, and the boxes of one touch.
    void merge() {
        std::vector<RayMeet> kept;
        for (const RayMeet &meet : meets_) {
            const auto same = std::find_if(kept.rbegin(), kept.rend(),
                                           [&](const RayMeet &other) { return is_one(other, meet); });
            if (same == kept.rend()) {
                kept.push_back(meet);
                continue;
            }
            const double upper = std::max(same->ts.upper, meet.ts.upper);
            if (meet.proven && !same->proven) {
                *same = meet;
            }
            same->ts.upper = upper;
        }
        meets_ = std::move(kept);
    }
    [[nodiscard]] bool is_one(const RayMeet &x, const RayMeet &y) const {
        const double near = 64 * solver_.room() / std::max(std::abs(y.sine), 1e-3);
        if ((x.inside && y.inside) || y.ts.lower > x.ts.upper + near) {
            return false;
        }
        if (!x.proven && !y.proven) {
            return true;
        }
        const bool one_side = !x.proven || !y.proven || (x.sine > 0) == (y.sine > 0);
        return one_side && are_neighbours(places_of(x), places_of(y));
    }
    // A hit is at its parameters; a touch may be anywhere in its box, so that it is no hit beside it unless
    // all of the box is there.
    [[nodiscard]] std::array<Interval, 2> places_of(const RayMeet &meet) const {
        const auto [u, v] = params_of(meet);
        return meet.proven ? std::array{Interval{u, u}, Interval{v, v}} : box_of(meet);
    }
    // Whether boxes are in one place, or at opposite ends of an axis, where the surface may close.
    [[nodiscard]] bool are_neighbours(const std::array<Interval, 2> &x,
                                      const std::array<Interval, 2> &y) const {
        const double share = std::min(1e-6 + 256 * solver_.room(), 0.25);
        for (size_t k = 0; k < 2; ++k) {
            const auto axis = static_cast<int>(k);
            const double length = grid_.break_at(axis, grid_.count(axis)) - grid_.break_at(axis, 0),
                         both = std::max(x[k].upper, y[k].upper) - std::min(x[k].lower, y[k].lower),
                         between = std::max(x[k].lower, y[k].lower) - std::min(x[k].upper, y[k].upper);
            if (both > share * length && between < (1 - share) * length) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] std::array<double, 2> params_of(const RayMeet &meet) const {
        std::array<double, 2> params{};
        const auto part = grid_.part(meet.piece);
        for (size_t k = 0; k < 2; ++k) {
            params[k] = part[k].lower; // for axes of degree 0
        }
        for (int k = 0; k < grid_.shape().axes; ++k) {
            const auto on = static_cast<size_t>(grid_.spline_axis(k));
            const double s = meet.place[static_cast<size_t>(k)];
            params[on] =
                std::clamp(part[on].lower * (1 - s) + part[on].upper * s, part[on].lower, part[on].upper);
        }
        return params;
    }
    // The box of parameters, rounded outwards, but within the piece.
    [[nodiscard]] std::array<Interval, 2> box_of(const RayMeet &meet) const {
        std::array<Interval, 2> box{};
        const auto part = grid_.part(meet.piece);
        std::copy_n(part.begin(), 2, box.begin()); // for axes of degree 0
        for (int k = 0; k < grid_.shape().axes; ++k) {
            const Interval own = part[static_cast<size_t>(grid_.spline_axis(k))],
                           around = meet.around[static_cast<size_t>(k)];
            const double room = 4 * eps * std::max(std::abs(own.lower), std::abs(own.upper));
            const auto at = [&](double s) { return own.lower * (1 - s) + own.upper * s; };
            box[static_cast<size_t>(grid_.spline_axis(k))] = {std::max(at(around.lower) - room, own.lower),
                                                              std::min(at(around.upper) + room, own.upper)};
        }
        return box;
    }
    [[nodiscard]] RayAnswer answer_of(const RayMeet &meet) const {
        return {params_of(meet),
                placed_.of_query(meet.t),
                meet.proven ? ray_hit | (meet.sine > 0 ? ray_back : 0) : ray_touch,
                {placed_.of_query(meet.ts.lower), placed_.of_query(meet.ts.upper)},
                meet.inside};
    }

    struct Visit {
        int32_t node;
        double from;
    };

    const RayTree &tree_;
    const pieces::PieceGrid &grid_;
    RaySolver solver_;
    PlaceFilter filter_;
    PlacedRay placed_;
    Interval range_{};
    std::vector<Visit> stack_;
    std::vector<RayMeet> meets_;
};

RayCaster::RayCaster(const Spline &surface, PlaceFilter filter)
    : cast_(std::make_unique<Cast>(surface, std::move(filter))) {}
RayCaster::~RayCaster() = default;

FirstMeets RayCaster::first(const RayQuery &query) {
    return cast_->first(query);
}

bool RayCaster::all(const RayQuery &query, std::vector<RayAnswer> &out, double *room) {
    return cast_->all(query, out, room);
}

} // namespace nrb::intersect

// SPDX-License-Identifier: MIT
#include "intersect/rays/rays.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/rays/ray_solver.h"
#include "numeric/power_of_two.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace nrb::intersect {

// One ray after the other, in the frame of the pieces.
class RayCaster::Cast {
public:
    Cast(const Spline &surface, const RayBatch &rays)
        : tree_(ray_tree_of(surface)), grid_(tree_.grid()), solver_(grid_), rays_(rays) {}

    RayAnswer nearest(int64_t i) {
        set(i);
        std::optional<RayMeet> hit, touch;
        double first_touch = infinity; // where one may begin
        const auto limit = [&] { return hit ? hit->t : range_.upper; };
        const bool complete = walk(limit, [&](const RayMeet &meet) {
            std::optional<RayMeet> &found = meet.proven ? hit : touch;
            if (!found || meet.t < found->t) {
                found = meet;
            }
            first_touch = meet.proven ? first_touch : std::min(first_touch, meet.ts.lower);
        });
        const bool before = first_touch < (hit ? hit->t - 64 * solver_.room() : infinity);
        if (!hit && !touch) {
            constexpr double none = std::numeric_limits<double>::quiet_NaN();
            return {{none, none}, none, complete ? ray_certified : 0};
        }
        RayAnswer answer = answer_of(hit && !(before && touch->t < hit->t) ? *hit : *touch);
        answer.status |= complete && !before && std::isfinite(answer.t) ? ray_certified : 0;
        return answer;
    }

    bool all(int64_t i, std::vector<RayAnswer> &out) {
        set(i);
        meets_.clear();
        const auto limit = [&] { return range_.upper; };
        const bool complete = walk(limit, [&](const RayMeet &meet) { meets_.push_back(meet); });
        std::ranges::sort(meets_, {}, [](const RayMeet &meet) {
            return std::tuple(meet.ts.lower, meet.piece, meet.place);
        });
        merge();
        bool sure = complete;
        for (const RayMeet &meet : meets_) {
            out.push_back(answer_of(meet));
            sure = sure && meet.proven;
        }
        return sure && std::ranges::all_of(out, [](const RayAnswer &one) { return std::isfinite(one.t); });
    }

private:
    // Directions are made unit vectors, and the origin is moved along the ray to where it is nearest to the centre: what
    // that rounds moves the ray. t of the frame is (t of the caller) factor_ - start_.
    void set(int64_t i) {
        const auto row = [i](const ConstRecords &rows) {
            return Vector3{rows(i, 0), rows(i, 1), rows(i, 2)};
        };
        const Vector3 origin = row(rays_.origins), direction = row(rays_.directions);
        factor_ =
            times_power_of_two(grid_.scaled(length(scaled_to_one(direction))), size_exponent(direction));
        std::array<double, 4> placed{};
        const double given[] = {origin.x, origin.y, origin.z};
        grid_.place(given, placed.data());
        const Vector3 from{placed[0], placed[1], placed[2]};
        ray_.direction = unit(scaled_to_one(direction));
        start_ = -dot(from, ray_.direction);
        ray_.origin = from + start_ * ray_.direction;
        ray_.start = {ray_.origin.x, ray_.origin.y, ray_.origin.z};
        ray_.inverse = {1 / ray_.direction.x, 1 / ray_.direction.y, 1 / ray_.direction.z};
        range_ = {in_frame(rays_.range.lower), in_frame(rays_.range.upper)};
        solver_.set_ray(ray_, 4 * eps * std::abs(start_));
    }
    [[nodiscard]] double in_frame(double t) const noexcept {
        return std::isinf(t) ? t : t * factor_ - start_;
    }

    // The nearer child first. Returns whether all was looked at that may hold a meet up to the limit.
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
        const Interval inside = tree_.meets(node, ray_, solver_.room());
        if (inside.lower <= inside.upper && inside.upper >= range_.lower && inside.lower <= range_.upper) {
            stack_.push_back({node, std::max(inside.lower, range_.lower)});
        }
    }

    // What two pieces have on their common edge, and boxes of one touch.
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
        if (!x.proven || !y.proven) {
            return true;
        }
        return (x.sine > 0) == (y.sine > 0) && are_neighbours(params_of(x), params_of(y));
    }
    // The same, or at both ends of an axis, where the surface may close.
    [[nodiscard]] bool are_neighbours(const std::array<double, 2> &x, const std::array<double, 2> &y) const {
        const double share = std::min(1e-6 + 256 * solver_.room(), 0.25);
        for (size_t k = 0; k < 2; ++k) {
            const auto axis = static_cast<int>(k);
            const double length = grid_.break_at(axis, grid_.count(axis)) - grid_.break_at(axis, 0),
                         apart = std::abs(x[k] - y[k]);
            if (apart > share * length && apart < (1 - share) * length) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] std::array<double, 2> params_of(const RayMeet &meet) const {
        std::array<double, 2> params{};
        const auto part = grid_.part(meet.piece);
        for (size_t k = 0; k < 2; ++k) {
            params[k] = part[k].lower; // of an axis of degree 0
        }
        for (int k = 0; k < grid_.shape().axes; ++k) {
            const auto on = static_cast<size_t>(grid_.spline_axis(k));
            const double s = meet.place[static_cast<size_t>(k)];
            params[on] =
                std::clamp(part[on].lower * (1 - s) + part[on].upper * s, part[on].lower, part[on].upper);
        }
        return params;
    }
    [[nodiscard]] RayAnswer answer_of(const RayMeet &meet) const {
        return {params_of(meet), (meet.t + start_) / factor_,
                meet.proven ? ray_hit | (meet.sine > 0 ? ray_back : 0) : ray_touch};
    }

    struct Visit {
        int32_t node;
        double from;
    };

    const RayTree &tree_;
    const pieces::PieceGrid &grid_;
    RaySolver solver_;
    RayBatch rays_;
    Ray ray_;
    Interval range_{};
    double factor_ = 1, start_ = 0;
    std::vector<Visit> stack_;
    std::vector<RayMeet> meets_;
};

RayCaster::RayCaster(const Spline &surface, const RayBatch &rays)
    : cast_(std::make_unique<Cast>(surface, rays)) {}
RayCaster::~RayCaster() = default;

RayAnswer RayCaster::nearest(int64_t ray) {
    return cast_->nearest(ray);
}

bool RayCaster::all(int64_t ray, std::vector<RayAnswer> &out) {
    return cast_->all(ray, out);
}

} // namespace nrb::intersect

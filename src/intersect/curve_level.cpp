// SPDX-License-Identifier: MIT
#include "intersect/curve_level.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/level_signs.h"

#include <algorithm>
#include <utility>

namespace nrb::intersect {

namespace {

// Turns the zeros, jumps and near ranges of a function into hits.
class LevelHits {
public:
    LevelHits(const CurveFunction &f, double tolerance)
        : f_(f), tolerance_(tolerance), signs_(level_signs(f, tolerance)) {}

    CurveHits run() {
        go_around();
        for (const Interval &range : signs_.near) {
            add_near(range);
        }
        add_until(infinity);
        for (const Interval &range : signs_.unknown) {
            hits_.list.push_back({range.lower / 2 + range.upper / 2, range, HitKind::undecided});
        }
        std::ranges::sort(hits_.list, {},
                          [](const CurveHit &hit) { return std::pair(hit.at, hit.range.lower); });
        return std::move(hits_);
    }

private:
    // If the last near range extends into the next period, the zeros and jumps at the start of the domain
    // that lie in it are moved up by a period, after all others.
    void go_around() {
        if (signs_.near.empty() || !(signs_.near.back().upper > f_.domain().upper)) {
            return;
        }
        const double period = f_.period(), end = signs_.near.back().upper - period;
        std::vector<ZeroRange> &zeros = signs_.zeros;
        const auto zero =
            std::ranges::find_if(zeros, [end](const ZeroRange &x) { return x.range.lower > end; });
        std::for_each(zeros.begin(), zero, [period](ZeroRange &x) {
            x.range = {x.range.lower + period, x.range.upper + period};
        });
        std::rotate(zeros.begin(), zero, zeros.end());
        std::vector<SignJump> &jumps = signs_.jumps;
        const auto jump = std::ranges::upper_bound(jumps, end, {}, &SignJump::at);
        std::for_each(jumps.begin(), jump, [period](SignJump &x) { x.at += period; });
        std::rotate(jumps.begin(), jump, jumps.end());
    }

    // Adds the zeros and jumps before a parameter; they belong to no near range.
    void add_until(double parameter) {
        for (; next_zero_ < signs_.zeros.size() && signs_.zeros[next_zero_].range.upper < parameter;
             ++next_zero_) {
            add(signs_.zeros[next_zero_]);
        }
        for (; next_jump_ < signs_.jumps.size() && signs_.jumps[next_jump_].at < parameter; ++next_jump_) {
            add_jump(signs_.jumps[next_jump_].at);
        }
    }

    // A near range around a single zero or jump yields that alone; any other one that holds a span is an
    // overlap.
    void add_near(Interval range) {
        add_until(range.lower);
        const size_t first_zero = next_zero_, first_jump = next_jump_;
        while (next_zero_ < signs_.zeros.size() && signs_.zeros[next_zero_].range.lower <= range.upper) {
            ++next_zero_;
        }
        while (next_jump_ < signs_.jumps.size() && signs_.jumps[next_jump_].at <= range.upper) {
            ++next_jump_;
        }
        const size_t zeros = next_zero_ - first_zero, jumps = next_jump_ - first_jump;
        const bool single = zeros + jumps == 1 && !(zeros == 1 && signs_.zeros[first_zero].whole);
        if (holds_span(range) && !single) {
            hits_.list.push_back({inside(range.lower / 2 + range.upper / 2), range, HitKind::overlap});
            return;
        }
        for (size_t i = first_zero; i < next_zero_; ++i) {
            add(signs_.zeros[i]);
        }
        for (size_t i = first_jump; i < next_jump_; ++i) {
            add_jump(signs_.jumps[i].at);
        }
        if (zeros + jumps == 0) {
            hits_.list.push_back({place_of_least(f_, range), range, HitKind::contact});
        }
    }
    void add(const ZeroRange &zero) {
        const double middle = inside(zero.range.lower / 2 + zero.range.upper / 2);
        const double at = zero.inside ? place_of_least(f_, zero.range) : zero.whole ? middle : zero.at;
        const bool beyond = f_.periodic() && zero.range.lower >= f_.domain().upper;
        const double shift = beyond ? f_.period() : 0;
        hits_.list.push_back({at, {zero.range.lower - shift, zero.range.upper - shift}, kind_of(zero)});
    }
    void add_jump(double given) {
        const double at = f_.periodic() && given >= f_.domain().upper ? given - f_.period() : given;
        hits_.list.push_back({at, {at, at}, HitKind::jump});
    }

    [[nodiscard]] HitKind kind_of(const ZeroRange &zero) const noexcept {
        const bool ends = zero.before == 0 || zero.after == 0;
        const bool changes = !ends && zero.before != zero.after;
        const bool sure = zero.exact || tolerance_ > 0;
        if (zero.whole) {
            return sure ? HitKind::overlap : HitKind::undecided;
        }
        if (zero.simple || changes) {
            return HitKind::crossing;
        }
        if (!sure) {
            return HitKind::undecided;
        }
        return ends && zero.order == 1 ? HitKind::crossing : HitKind::tangent;
    }

    [[nodiscard]] bool holds_span(Interval range) const noexcept {
        return holds_span(range, 0) || (f_.periodic() && holds_span(range, f_.period()));
    }
    // In the range moved back by `shift`, 0 or one period.
    [[nodiscard]] bool holds_span(Interval range, double shift) const noexcept {
        int64_t e = f_.first_to(range.lower - shift);
        e += e < f_.count() && f_.part(e).lower < range.lower - shift ? 1 : 0;
        return e < f_.count() && f_.part(e).upper <= range.upper - shift;
    }
    [[nodiscard]] double inside(double at) const noexcept {
        return at > f_.domain().upper ? at - f_.period() : at;
    }

    const CurveFunction &f_;
    double tolerance_;
    LevelSigns signs_;
    size_t next_zero_ = 0, next_jump_ = 0;
    CurveHits hits_;
};

} // namespace

CurveHits curve_level(const Spline &curve, const ImplicitForm &form, double tolerance) {
    const UsualLimit usual(usual_work(curve.point_count()));
    const LimitedSearch limited;
    return LevelHits(*function_along(curve, form), tolerance).run();
}

} // namespace nrb::intersect

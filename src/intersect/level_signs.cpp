// SPDX-License-Identifier: MIT
#include "intersect/level_signs.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// The nearest places tried on both sides of a zero at which the sign is certain. The zero is known to be the
// only one between from and to.
Interval certain_ends(const RoundedPolynomial &f, double zero, double from, double to) {
    constexpr double factor = 16;
    double reach = 2 * eps;
    while (reach < to - from) {
        const double a = std::max(zero - reach, from), b = std::min(zero + reach, to);
        const int below = value_at(f, last_axis, a).sign(0), above = value_at(f, last_axis, b).sign(0);
        if (below != 0 && above == -below) {
            return {a, b};
        }
        reach *= factor;
    }
    return {from, to};
}

bool vanishes_exactly(const RoundedPolynomial &f) noexcept {
    const auto zero = [](double x) { return x == 0; };
    return std::ranges::all_of(f.values, zero) && std::ranges::all_of(f.errors, zero);
}

// Goes through the pieces in order and joins what is known of their signs.
class SignsAlong {
public:
    SignsAlong(const CurveFunction &f, double tolerance) : f_(f), tolerance_(tolerance) {}

    LevelSigns run() {
        Steps steps(f_.count());
        for (int64_t e = 0; e < f_.count(); ++e, steps.next()) {
            piece_ = e;
            if (const int sign = f_.far(e, tolerance_); sign != 0) {
                add_sign(f_.part(e).lower, sign);
                far_.push_back(f_.part(e));
            } else {
                add_piece();
            }
        }
        result_.first = first_sign_;
        result_.last = zero_is_last_ ? 0 : sign_;
        close_seam();
        add_near();
        return std::move(result_);
    }

private:
    void add_piece() {
        const FunctionPiece f = f_.piece(piece_);
        if (!f.known || work_ended()) {
            result_.unknown.push_back(f_.part(piece_));
            far_.push_back(f_.part(piece_));
            sign_ = 0;
            zero_is_last_ = false;
            return;
        }
        add_signs(f.value);
        if (tolerance_ == 0) {
            return;
        }
        add_far(f.value - scaled(f.weight, tolerance_), 1);
        add_far(f.value + scaled(f.weight, tolerance_), -1);
    }

    [[nodiscard]] Interval range(double from, double to) const noexcept {
        return {f_.parameter(piece_, from), f_.parameter(piece_, to)};
    }
    // The same, widened by what the rounding of parameters may have cut off, except at the ends of the piece.
    [[nodiscard]] Interval wide_range(double from, double to) const noexcept {
        const Interval part = f_.part(piece_), inside = range(from, to);
        const double off = 2 * eps * std::max(std::abs(part.lower), std::abs(part.upper));
        return {from == 0 ? part.lower : std::max(inside.lower - off, part.lower),
                to == 1 ? part.upper : std::min(inside.upper + off, part.upper)};
    }

    void add_signs(const RoundedPolynomial &value) {
        const SignRuns signs = sign_runs(value);
        if (signs.nothing) {
            ZeroRange zero{range(0, 1), f_.parameter(piece_, 0.5)};
            zero.whole = true;
            zero.exact = vanishes_exactly(value);
            return add_zero(zero);
        }
        add_end(value, 0, signs.zeros_at_start, signs.doubtful);
        for (size_t i = 0; i < signs.runs.size(); ++i) {
            const SignRun &run = signs.runs[i];
            if (run.sign != 0) {
                add_sign(range(run.from, run.to).lower, run.sign);
            } else if (run.simple) {
                const Interval ends =
                    certain_ends(value, run.from, signs.runs[i - 1].from, signs.runs[i + 1].to);
                ZeroRange zero{wide_range(ends.lower, ends.upper), f_.parameter(piece_, run.from)};
                zero.simple = true;
                add_zero(zero);
            } else {
                ZeroRange zero{wide_range(run.from, run.to), f_.parameter(piece_, std::max(run.zero, 0.0))};
                zero.inside = run.zero < 0;
                add_zero(zero);
            }
        }
        add_end(value, 1, signs.zeros_at_end, signs.doubtful);
    }

    // Adds a zero at an end of the piece. It stands for all zeros that rounding cannot distinguish from one
    // there.
    void add_end(const RoundedPolynomial &value, int end, int order, bool doubtful) {
        if (order == 0) {
            return;
        }
        const size_t i = end == 0 ? 0 : value.values.size() - 1;
        ZeroRange zero{range(end, end), f_.parameter(piece_, end)};
        zero.exact = value.values[i] == 0 && value.errors[i] == 0;
        zero.order = order;
        if (!zero.exact) {
            const double reach = doubtful ? 0x1p-8 : std::exp2(-32.0 / order);
            zero.range = end == 0 ? wide_range(0, reach) : wide_range(1 - reach, 1);
        }
        add_zero(zero);
    }

    void add_sign(double from, int sign) {
        if (zero_is_last_) {
            result_.zeros.back().after = sign;
        } else if (sign_ == -sign) {
            result_.jumps.push_back({from, sign_});
        }
        if (first_sign_ == 0 && result_.zeros.empty() && result_.unknown.empty()) {
            first_sign_ = sign;
        }
        sign_ = sign;
        zero_is_last_ = false;
    }
    // Zeros that touch are merged.
    void add_zero(ZeroRange zero) {
        if (!zero_is_last_) {
            zero.before = sign_;
            result_.zeros.push_back(zero);
            zero_is_last_ = true;
            return;
        }
        ZeroRange &last = result_.zeros.back();
        last.range = {std::min(last.range.lower, zero.range.lower),
                      std::max(last.range.upper, zero.range.upper)};
        last.simple = last.inside = false;
        last.exact = last.whole == zero.whole ? last.exact && zero.exact : last.exact || zero.exact;
        last.whole = last.whole || zero.whole;
        last.order = std::max(last.order, zero.order);
    }

    void add_far(const RoundedPolynomial &beyond, int sign) {
        for (const SignRun &run : sign_runs(beyond).runs) {
            if (run.sign == sign) {
                far_.push_back(range(run.from, run.to));
            }
        }
    }

    // Joins both ends of a periodic curve: what is known before one holds after the other.
    void close_seam() {
        if (!f_.periodic()) {
            return;
        }
        const double start = f_.domain().lower, period = f_.period();
        std::vector<ZeroRange> &zeros = result_.zeros;
        const bool at_start = !zeros.empty() && first_sign_ == 0 && zeros.front().range.lower == start;
        if (at_start && zero_is_last_ && zeros.size() > 1) {
            ZeroRange first = zeros.front();
            first.range = {first.range.lower + period, first.range.upper + period};
            add_zero(first);
            zeros.back().at = start;
            zeros.back().after = first.after;
            zeros.erase(zeros.begin());
        } else if (at_start && !zero_is_last_) {
            zeros.front().before = sign_;
        } else if (!at_start && zero_is_last_) {
            zeros.back().after = first_sign_;
        } else if (!at_start && sign_ == -first_sign_ && sign_ != 0) {
            result_.jumps.insert(result_.jumps.begin(), {start, sign_});
        }
    }

    // The gaps between the far ranges are the near ones.
    void add_near() {
        if (tolerance_ == 0) {
            return;
        }
        std::ranges::sort(far_, {}, &Interval::lower);
        const auto [start, end] = f_.domain();
        double known = start;
        std::vector<Interval> &near = result_.near;
        for (const Interval &far : far_) {
            if (far.lower > known) {
                near.push_back({known, far.lower});
            }
            known = std::max(known, far.upper);
        }
        if (end > known) {
            near.push_back({known, end});
        }
        if (f_.periodic() && near.size() > 1 && near.front().lower == start && near.back().upper == end) {
            near.back().upper = near.front().upper + (end - start);
            near.erase(near.begin());
        }
    }

    const CurveFunction &f_;
    double tolerance_;
    int64_t piece_ = 0;
    int sign_ = 0, first_sign_ = 0; // the last certain one, and the one at the start
    bool zero_is_last_ = false;
    std::vector<Interval> far_;
    LevelSigns result_;
};

// Calls visit(e, from, to) for the part of each piece e that lies in a range, given by local parameters.
template <class Visit>
void for_each_part(const CurveFunction &f, Interval range, const Visit &visit) {
    for (const double shift : {0.0, f.period()}) {
        const double lower = range.lower - shift, upper = range.upper - shift;
        for (int64_t e = f.first_to(lower); e < f.count() && f.part(e).lower <= upper; ++e) {
            const Interval part = f.part(e);
            const double length = part.upper - part.lower;
            visit(e, std::max(lower - part.lower, 0.0) / length,
                  std::min(upper - part.lower, length) / length);
        }
        if (!f.periodic()) {
            return;
        }
    }
}

} // namespace

LevelSigns level_signs(const CurveFunction &f, double tolerance) {
    return SignsAlong(f, tolerance).run();
}

double place_of_least(const CurveFunction &f, Interval range) {
    double least = infinity, at = range.lower;
    for_each_part(f, range, [&](int64_t e, double from, double to) {
        const FunctionPiece piece = f.piece(e);
        std::vector<double> places{from, to};
        const RoundedPolynomial slope = derivative(piece.value, last_axis) * piece.weight -
                                        piece.value * derivative(piece.weight, last_axis);
        for (const SignRun &run : sign_runs(slope).runs) {
            if (run.sign == 0 && run.from >= from && run.to <= to) {
                places.push_back(run.from / 2 + run.to / 2);
            }
        }
        for (const double place : places) {
            const double value = std::abs(value_at(piece.value, last_axis, place).values[0] /
                                          value_at(piece.weight, last_axis, place).values[0]);
            if (value < least) {
                least = value;
                at = f.parameter(e, place);
            }
        }
    });
    return at;
}

} // namespace nrb::intersect

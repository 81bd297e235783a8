// SPDX-License-Identifier: MIT
#include "bernstein/sign_runs.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::inline bernstein {

namespace {

constexpr int axis = 2;             // of the three axes, the one along which curves lie
constexpr double least = 0x1p-48;   // parts shorter than this are not subdivided
constexpr int most_halvings = 4096; // per polynomial, where rounding leaves many parts undecided

// Candidates for the place of subdivision: the first one that is not near a zero is taken.
constexpr double split_places[] = {0.5, 0.4375, 0.5625, 0.375, 0.625, 0.25, 0.75, 0.125, 0.875};

// Number of sign changes of the coefficients: the least that is certain, and the most over all choices for
// coefficients without a certain sign, where the latter may be overestimated by up to 2.
struct Variations {
    int least = 0;
    int most = 0;
};

Variations variations(const RoundedPolynomial &f) noexcept {
    Variations count;
    int last = 0;    // the last certain sign
    int unknown = 0; // number of coefficients since then
    for (size_t i = 0; i < f.values.size(); ++i) {
        const int sign = f.sign(i);
        if (sign == 0) {
            ++unknown;
            continue;
        }
        const bool change = last != 0 && sign != last;
        count.least += change ? 1 : 0;
        // Unknown signs between + and + can add two changes; between + and - they add none, except in pairs.
        count.most += (change ? 1 : 0) + (unknown > (change ? 1 : 0) ? 2 : 0);
        last = sign;
        unknown = 0;
    }
    count.most += unknown;
    return count;
}

double value_at(std::vector<double> b, double x) noexcept {
    evaluate(static_cast<int>(b.size()) - 1, 1, x, b.data());
    return b[0];
}

// The zero of a polynomial whose values at 0 and 1 have different signs: the method of A. Bjoerck and N.
// Anderson (regula falsi, BIT 13 (1973)), safeguarded by bisection.
double bracketed_zero(const std::vector<double> &b) {
    double low = 0, high = 1, f_low = b.front(), f_high = b.back();
    int side = 0;
    for (int step = 0; step < 100 && high - low > eps; ++step) {
        double x = (low * f_high - high * f_low) / (f_high - f_low);
        if (!(x > low && x < high) || step % 4 == 3) {
            x = low / 2 + high / 2;
        }
        const double f = value_at(b, x);
        if (f == 0) {
            return x;
        }
        const bool lower = (f > 0) == (f_low > 0);
        const double ratio = 1 - f / (lower ? f_low : f_high), factor = ratio > 0 ? ratio : 0.5;
        if (lower) {
            f_high *= side == 1 ? factor : 1;
            low = x;
            f_low = f;
        } else {
            f_low *= side == -1 ? factor : 1;
            high = x;
            f_high = f;
        }
        side = lower ? 1 : -1;
    }
    return std::abs(f_low) < std::abs(f_high) ? low : high;
}

// Appends a run; consecutive runs of the same kind are merged.
void append(std::vector<SignRun> &runs, SignRun run) {
    const bool hidden = run.sign == 0 && !run.simple;
    if (!runs.empty() && runs.back().sign == run.sign && runs.back().simple == run.simple &&
        (run.sign != 0 || hidden)) {
        runs.back().to = run.to;
        return;
    }
    runs.push_back(run);
}

class Isolation {
public:
    explicit Isolation(std::vector<SignRun> &runs) : runs_(runs) {}

    // Precondition: the values at both ends have certain signs.
    void run(const RoundedPolynomial &f, double from, double to) {
        const Variations changes = variations(f);
        if (changes.most == 0) {
            return append(runs_, {from, to, f.sign(0)});
        }
        const bool monotone =
            f.sign(0) != f.sign(f.values.size() - 1) && certain_sign(derivative(f, axis)) != 0;
        if ((changes.least == 1 && changes.most == 1) || monotone) {
            const double zero = from + (to - from) * bracketed_zero(f.values);
            append(runs_, {from, zero, f.sign(0)});
            append(runs_, {zero, zero, 0, true});
            return append(runs_, {zero, to, f.sign(f.values.size() - 1)});
        }
        halve(f, from, to);
    }

private:
    // Subdivides at a place where the sign is certain.
    void halve(const RoundedPolynomial &f, double from, double to) {
        for (const double place : split_places) {
            if (to - from < least || halvings_ > most_halvings || work_ended()) {
                break;
            }
            ++halvings_;
            RoundedPolynomial upper = f;
            const RoundedPolynomial lower = split(upper, axis, place);
            if (upper.sign(0) != 0) {
                const double middle = from + (to - from) * place;
                run(lower, from, middle);
                return run(upper, middle, to);
            }
        }
        const bool changes = f.sign(0) != f.sign(f.values.size() - 1);
        append(runs_, {from, to, 0, false, changes ? from + (to - from) * bracketed_zero(f.values) : -1});
    }

    std::vector<SignRun> &runs_;
    int halvings_ = 0;
};

// Subdivides until every part has no zero, or one.
class VectorIsolation {
public:
    void run(RoundedPolynomial v) {
        const int start = divide_end(v, axis, false);
        if (start < 0) {
            return note({0, 1, false});
        }
        if (start > 0) {
            note({0, 0, true});
        }
        const int end = divide_end(v, axis, true);
        part(v, 0, 1);
        if (end > 0) {
            note({1, 1, true});
        }
    }
    [[nodiscard]] std::vector<ZeroPlace> take() { return std::move(places_); }

private:
    // Overlapping and adjacent places are merged.
    void note(ZeroPlace place) {
        if (!places_.empty() && place.from <= places_.back().to) {
            ZeroPlace &last = places_.back();
            const bool same = place.from == place.to && last.from == last.to;
            last.to = std::max(last.to, place.to);
            last.certain = same && last.certain && place.certain;
            return;
        }
        places_.push_back(place);
    }

    // False if a component, or the projection onto the sum of the vectors at both ends, certainly has no
    // zero.
    static bool may_vanish(const RoundedPolynomial &v) {
        RoundedPolynomial along;
        const auto n = static_cast<size_t>(v.shape.width);
        for (size_t c = 0; c < n; ++c) {
            const RoundedPolynomial one = component(v, static_cast<int>(c));
            if (certain_sign(one) != 0) {
                return false;
            }
            const double factor = v.values[c] + v.values[v.values.size() - n + c];
            along = c == 0 ? scaled(one, factor) : sum(along, factor, one);
        }
        return certain_sign(along) == 0;
    }

    void part(const RoundedPolynomial &v, double from, double to) {
        if (!may_vanish(v)) {
            return;
        }
        for (int c = 0; c < v.shape.width; ++c) {
            const RoundedPolynomial one = component(v, c);
            const Variations changes = variations(one);
            const bool ends = one.sign(0) * one.sign(one.values.size() - 1) < 0;
            if (ends &&
                ((changes.least == 1 && changes.most == 1) || certain_sign(derivative(one, axis)) != 0)) {
                const double zero = bracketed_zero(one.values);
                if (vanish_at(v, c, zero)) {
                    const double place = from + (to - from) * zero;
                    note({place, place, true});
                }
                return;
            }
        }
        halve(v, from, to);
    }

    // Subdivides at a place where not all components vanish up to rounding.
    void halve(const RoundedPolynomial &v, double from, double to) {
        for (const double place : split_places) {
            if (to - from < least || ++halvings_ > most_halvings || work_ended()) {
                break;
            }
            RoundedPolynomial upper = v;
            const RoundedPolynomial lower = split(upper, axis, place);
            if (!vanishes(end_value(upper, axis, false))) {
                const double middle = from + (to - from) * place;
                part(lower, from, middle);
                return part(upper, middle, to);
            }
        }
        note({from, to, false});
    }

    // Whether all components vanish up to rounding at the zero of one of them, which rounding moves by its
    // error over its derivative.
    static bool vanish_at(const RoundedPolynomial &v, int pivot, double zero) {
        const RoundedPolynomial values = value_at(v, axis, zero),
                                slopes = value_at(derivative(v, axis), axis, zero);
        const auto at = static_cast<size_t>(pivot);
        const double slope = std::abs(slopes.values[at]) - slopes.error(at);
        if (!(slope > 0)) {
            return true;
        }
        const double moved = 2 * (std::abs(values.values[at]) + values.error(at)) / slope + 4 * eps;
        for (size_t c = 0; c < static_cast<size_t>(v.shape.width); ++c) {
            const double reach = moved * (std::abs(slopes.values[c]) + slopes.error(c));
            if (!(std::abs(values.values[c]) <= values.error(c) + reach)) {
                return false;
            }
        }
        return true;
    }

    std::vector<ZeroPlace> places_;
    int halvings_ = 0;
};

// With f = x^m q, the zeros of f + e are where x^m q = -e.
bool doubtful_end(const RoundedPolynomial &f, double q, int times, bool upper) noexcept {
    double error = 0;
    for (size_t i = 0; i < static_cast<size_t>(times); ++i) {
        error = std::max(error, f.error(upper ? f.values.size() - 1 - i : i));
    }
    return !(error <= 0x1p-32 * std::abs(q));
}

} // namespace

SignRuns sign_runs(RoundedPolynomial f) {
    SignRuns result;
    const RoundedPolynomial whole = f;
    result.zeros_at_start = divide_end(f, axis, false);
    if (result.zeros_at_start < 0) {
        return {{{0, 1, 0}}, 0, 0, true, false};
    }
    result.zeros_at_end = divide_end(f, axis, true);
    result.doubtful = doubtful_end(whole, f.values.front(), result.zeros_at_start, false) ||
                      doubtful_end(whole, f.values.back(), result.zeros_at_end, true);
    Isolation(result.runs).run(f, 0, 1);
    return result;
}

std::vector<ZeroPlace> zero_places(RoundedPolynomial v) {
    VectorIsolation isolation;
    isolation.run(std::move(v));
    return isolation.take();
}

} // namespace nrb::inline bernstein

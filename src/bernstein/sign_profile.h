// SPDX-License-Identifier: MIT
// Finds where a function of one variable changes its sign, from Bernstein coefficients known to a given
// uncertainty. Fast, and blind to anything below that uncertainty. sign_runs.h proves more, at the price of
// running error bounds.
#pragma once

#include "bernstein/de_casteljau.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace nrb::inline bernstein {

// Bernstein coefficients, each known to `uncertainty`, or, if `weighted`, to `uncertainty` times its weight.
template <size_t kSize>
struct UncertainNet {
    int degree = 0;
    double uncertainty = 0;
    bool weighted = false;
    std::array<double, kSize> values{};
    std::array<double, kSize> weights{};

    // 0 if the coefficient is no farther from 0 than its uncertainty.
    [[nodiscard]] int sign(int j) const noexcept {
        const auto at = static_cast<size_t>(j);
        const double x = values[at], known = weighted ? uncertainty * weights[at] : uncertainty;
        return std::fabs(x) <= known ? 0 : x > 0 ? 1 : -1;
    }
    // Halves the net: returns the lower half; this becomes the upper half.
    [[nodiscard]] UncertainNet take_lower_half() noexcept {
        UncertainNet lower = *this;
        subdivide(degree, 1, 0.5, values.data(), lower.values.data());
        if (weighted) {
            subdivide(degree, 1, 0.5, weights.data(), lower.weights.data());
        }
        return lower;
    }
};

// The signs that occur inside an interval.
struct SignProfile {
    bool below = false;
    bool above = false;
    std::vector<double> crossings; // parameters at which the sign changes, in increasing order
};

// Subdivides until the coefficients of each part have at most one sign change (Lane & Riesenfeld, "Bounds on
// a polynomial", BIT 21 (1981)), then refines the crossing by the secant method on `value`, the function
// itself, down to neighbouring doubles. Where the function touches 0 without crossing it, only its side is
// reported. Cost: degree^2 for each subdivision, of which there are at most some 50 degree, and some 10
// evaluations for a crossing, at most twice as many as it has bits.
template <size_t kSize, class Value>
class SignWalk {
public:
    explicit SignWalk(Value value) : value_(std::move(value)) {}

    // `net` is the net over [lower, upper].
    SignProfile walk(UncertainNet<kSize> net, double lower, double upper) && {
        visit(net, lower, upper);
        return std::move(profile_);
    }

private:
    // Visits the parts in the order of their parameters.
    void visit(UncertainNet<kSize> &net, double lower, double upper) {
        int first = 0, last = 0, changes = 0;
        for (int j = 0; j <= net.degree; ++j) {
            const int own = net.sign(j);
            changes += own * last < 0 ? 1 : 0;
            last = own != 0 ? own : last;
            first = first != 0 ? first : own;
        }
        const double middle = lower + (upper - lower) / 2;
        if (changes > 1 && lower < middle && middle < upper) {
            UncertainNet<kSize> left = net.take_lower_half();
            visit(left, lower, middle);
            visit(net, middle, upper);
        } else if (first != 0) {
            add(first, last, lower, upper);
        }
    }

    // Adds a part that begins with the sign `first` and ends with the sign `last`.
    void add(int first, int last, double lower, double upper) {
        if (before_ * first < 0) {
            profile_.crossings.push_back(lower);
        }
        if (first != last) {
            profile_.crossings.push_back(root(lower, upper, last));
        }
        before_ = last;
        profile_.below = profile_.below || first < 0 || last < 0;
        profile_.above = profile_.above || first > 0 || last > 0;
    }

    // The secant method with bracketing. Each secant step is pushed towards the middle, past the zero, so
    // that both ends close in; a step that did not halve the interval is followed by a bisection.
    [[nodiscard]] double root(double lower, double upper, int last) const {
        const double whole = upper - lower;
        double at_lower = value_(lower), at_upper = value_(upper), before = HUGE_VAL;
        for (;;) {
            const double length = upper - lower, middle = lower + length / 2;
            if (middle == lower || middle == upper) {
                return middle;
            }
            // Near an end of a part, the values may be too small to have the signs expected there.
            const bool differ = std::min(at_lower, at_upper) < 0 && std::max(at_lower, at_upper) > 0;
            const double secant = lower + length * (at_lower / (at_lower - at_upper));
            const double t = length > before / 2 || !differ
                                 ? middle
                                 : pushed(secant, {lower, middle, upper}, length / whole);
            const double value = value_(t);
            if (value == 0) {
                return t;
            }
            const bool above = (value > 0) == (last > 0);
            (above ? upper : lower) = t;
            (above ? at_upper : at_lower) = value;
            before = length;
        }
    }

    struct Bracket {
        double lower, middle, upper;
    };

    // Moves t towards the middle by a tenth of the interval times its share of the whole, except in the first
    // step, where the zero of a straight line is hit exactly. Stays strictly inside; returns the middle if t
    // is NaN.
    [[nodiscard]] static double pushed(double t, const Bracket &in, double share) noexcept {
        const double push = share < 1 ? share * (in.upper - in.lower) / 10 : 0;
        if (!(std::fabs(t - in.middle) > push)) {
            return in.middle;
        }
        return std::clamp(t + std::copysign(push, in.middle - t), std::nextafter(in.lower, in.upper),
                          std::nextafter(in.upper, in.lower));
    }

    Value value_;
    int before_ = 0; // the last sign met
    SignProfile profile_;
};

template <size_t kSize, class Value>
SignProfile signs_between(double lower, double upper, const UncertainNet<kSize> &net, Value value) {
    return SignWalk<kSize, Value>(std::move(value)).walk(net, lower, upper);
}

} // namespace nrb::inline bernstein

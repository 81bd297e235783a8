// SPDX-License-Identifier: MIT
// Where a function of one variable changes its sign, as told by Bernstein coefficients that are known to a
// stated uncertainty: quick, and blind to less than that. sign_runs.h proves more, at the price of running
// error bounds.
#pragma once

#include "bernstein/de_casteljau.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace nrb::inline bernstein {

// Coefficients of which each is known to the uncertainty, or with weights to that times its own.
template <size_t kSize>
struct UncertainNet {
    int degree = 0;
    double uncertainty = 0;
    bool weighted = false;
    std::array<double, kSize> values{};
    std::array<double, kSize> weights{};

    // 0: no farther from 0 than is known.
    [[nodiscard]] int sign(int j) const noexcept {
        const auto at = static_cast<size_t>(j);
        const double x = values[at], known = weighted ? uncertainty * weights[at] : uncertainty;
        return std::fabs(x) <= known ? 0 : x > 0 ? 1 : -1;
    }
    // This becomes the upper half.
    [[nodiscard]] UncertainNet take_lower_half() noexcept {
        UncertainNet lower = *this;
        subdivide(degree, 1, 0.5, values.data(), lower.values.data());
        if (weighted) {
            subdivide(degree, 1, 0.5, weights.data(), lower.weights.data());
        }
        return lower;
    }
};

// What is known of the signs inside an interval.
struct SignProfile {
    bool below = false;
    bool above = false;
    std::vector<double> crossings; // parameters at which the sign changes, rising
};

// By halving until coefficients change their sign at most once on each part (Lane & Riesenfeld, "Bounds on a
// polynomial", BIT 21 (1981)), then secants of `value`, the function itself, to neighbouring doubles. Of places
// where it touches 0 without crossing it nothing is reported but the side. Cost: degree^2 for each halving, at
// most some 50 degree of them, and some 10 evaluations for a crossing, at most twice as many as it has bits.
template <size_t kSize, class Value>
class SignWalk {
public:
    explicit SignWalk(Value value) : value_(std::move(value)) {}

    // The net is that over [lower, upper].
    SignProfile walk(UncertainNet<kSize> net, double lower, double upper) && {
        visit(net, lower, upper);
        return std::move(profile_);
    }

private:
    // Parts in the order of their parameters.
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

    // A part that begins with one sign and ends with another one, or the same.
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

    // Secants, which a step towards the middle takes past the zero, so that both ends close in; a step that did not halve
    // the interval is followed by one that does.
    [[nodiscard]] double root(double lower, double upper, int last) const {
        const double whole = upper - lower;
        double at_lower = value_(lower), at_upper = value_(upper), before = HUGE_VAL;
        for (;;) {
            const double length = upper - lower, middle = lower + length / 2;
            if (middle == lower || middle == upper) {
                return middle;
            }
            // Values at the ends of a part may be known too little to have their signs.
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

    // Inside, nearer to the middle by a tenth of the share of the interval, but not at first, when a straight line is met
    // exactly; the middle where t is no number.
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

// SPDX-License-Identifier: MIT
#include "intersect/pairs/matched_distance.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "numeric/binomial.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// The factor f for which u(r) = f r / (1 - r + f r) is `image` at r.
double factor_of(double r, double image) noexcept {
    constexpr double most = 16;
    const double factor = image * (1 - r) / ((1 - image) * r);
    return std::isfinite(factor) ? std::clamp(factor, 1 / most, most) : 1;
}

double share(Interval part, double at) noexcept {
    return (at - part.lower) / (part.upper - part.lower);
}

} // namespace

// If the places descend, the coefficients are reversed.
void MatchedDistance::set_part(const pieces::BezierPiece &piece, Interval places, Part &part) {
    const int p = piece.degree(0), dim = piece.dim();
    const auto size = static_cast<size_t>(p) + 1, width = static_cast<size_t>(dim);
    part.points.resize(size * width);
    part.weights.resize(size);
    component_.resize(size);
    for (int c = dim; c >= 0; --c) {
        for (size_t i = 0; i < size; ++i) {
            component_[i] = piece.record(static_cast<int64_t>(i))[c];
        }
        restrict_to(p, std::min(places.lower, places.upper), std::max(places.lower, places.upper),
                    component_.data());
        if (places.lower > places.upper) {
            std::ranges::reverse(component_);
        }
        for (size_t i = 0; i < size; ++i) {
            if (c == dim) {
                part.weights[i] = component_[i];
            } else {
                part.points[i * width + static_cast<size_t>(c)] = component_[i] / part.weights[i];
            }
        }
    }
    for (size_t i = 0; i < size; ++i) {
        part.weights[i] *= binomial(p, static_cast<int>(i));
    }
}

// Each of the 2 p means moves a point by at most 3 / 2 eps of its distance from the centre. Sums of products
// of positive weights are as exact as their factors.
void MatchedDistance::set(const pieces::BezierPiece &a, const pieces::BezierPiece &b,
                          const Beside::Match &match) {
    const int p = a.degree(0), q = b.degree(0);
    dim_ = a.dim();
    const auto width = static_cast<size_t>(dim_);
    count_work(2 * (p + 1) * (q + 1) * (dim_ + 1));
    set_part(a, match.ends.a, a_);
    set_part(b, match.ends.b, b_);
    const double factor = factor_of(share(match.ends.a, match.middle_a), share(match.ends.b, match.middle_b));
    double power = 1;
    for (double &weight : b_.weights) {
        weight *= power;
        power *= factor;
    }
    offsets_.assign(static_cast<size_t>(p + q + 1) * width, 0.0);
    largest_ = 0;
    for (int k = 0; k <= p + q; ++k) {
        double *difference = offsets_.data() + static_cast<size_t>(k) * width;
        double whole = 0;
        for (int i = std::max(0, k - q); i <= std::min(p, k); ++i) {
            const auto on_a = static_cast<size_t>(i), on_b = static_cast<size_t>(k - i);
            const double weight = a_.weights[on_a] * b_.weights[on_b];
            whole += weight;
            for (size_t c = 0; c < width; ++c) {
                difference[c] += weight * (a_.points[on_a * width + c] - b_.points[on_b * width + c]);
            }
        }
        for (size_t c = 0; c < width; ++c) {
            difference[c] /= whole;
        }
        largest_ = std::max(largest_, norm(difference, dim_));
    }
    largest_ = std::isfinite(largest_) ? largest_ : infinity;
    rounding_ =
        ((6 * p + 8) * a.reach() + (6 * q + 8) * b.reach() + 4 * (p + q + dim_ + 4) * largest_) * eps +
        a.moved() + b.moved();
}

// Of two graphs with slopes of at most m, a point D above the other graph is D / sqrt(1 + m^2) away from it,
// also if the other graph ends within less than that.
bool MatchedDistance::separates(const Beside &beside, double near) const noexcept {
    const double *d = beside.vector();
    const Interval slopes = beside.slopes_of_b(), others = beside.slopes_of_a();
    const double steepest = std::max(
        {std::abs(slopes.lower), std::abs(slopes.upper), std::abs(others.lower), std::abs(others.upper)});
    const double room = 1.0001 * std::hypot(1, steepest) * near + (1 + steepest) * rounding_;
    bool above = largest_ < infinity, below = above;
    for (size_t k = 0; k < offsets_.size(); k += 2) {
        const double e = d[0] * offsets_[k] + d[1] * offsets_[k + 1],
                     h = d[0] * offsets_[k + 1] - d[1] * offsets_[k];
        const double first = h - slopes.lower * e, second = h - slopes.upper * e;
        above = above && std::min(first, second) > room;
        below = below && std::max(first, second) < -room;
    }
    return above || below;
}

} // namespace nrb::intersect

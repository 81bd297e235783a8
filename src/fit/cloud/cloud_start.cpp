// SPDX-License-Identifier: MIT
#include "fit/cloud/cloud_start.h"

#include "base/error.h"
#include "base/watch.h"
#include "fit/least_squares/stencil_matrix.h"
#include "numeric/norm.h"
#include "numeric/solvers/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::fit {

namespace {

// A principal direction, and the spread of the points along it.
struct Direction {
    std::vector<double> unit;
    Interval range;  // of the points, from their mean
    double variance; // of the points along it
};

std::vector<double> mean_of(const Cloud &cloud) {
    std::vector<double> mean(static_cast<size_t>(cloud.dim));
    for (size_t c = 0; c < mean.size(); ++c) {
        DoubleDouble sum;
        for (int64_t i = 0; i < cloud.size(); ++i) {
            sum = sum + DoubleDouble(cloud.point(i)[c]);
        }
        mean[c] = sum.high / static_cast<double>(cloud.size());
    }
    return mean;
}

// The sign of an eigenvector is arbitrary: makes its component of largest magnitude positive.
void orient(std::vector<double> &unit) noexcept {
    const double largest = *std::ranges::max_element(unit, {}, [](double x) { return std::abs(x); });
    for (double &x : unit) {
        x = largest < 0 ? -x : x;
    }
}

class Spread {
public:
    explicit Spread(const Cloud &cloud) : cloud_(cloud), mean_(mean_of(cloud)) {
        const std::vector<double> rows = principal_axes(cloud.points, cloud.dim);
        for (int k = 0; k < std::min(cloud.dim, 3); ++k) {
            directions_.push_back(
                {{rows.begin() + k * cloud.dim, rows.begin() + (k + 1) * cloud.dim}, {}, 0});
            orient(directions_.back().unit);
            measure(directions_.back());
        }
        count_work(cloud.size() * cloud.dim * (cloud.dim + 16));
    }

    [[nodiscard]] const std::vector<double> &mean() const noexcept { return mean_; }
    [[nodiscard]] const Direction &operator[](size_t k) const noexcept { return directions_[k]; }
    [[nodiscard]] size_t size() const noexcept { return directions_.size(); }

    // How much the points vary about an elliptic cylinder around direction k: up to their number, the
    // variance of the left side of its equation x^2 / var_x + y^2 / var_y = 2, whose mean is 2 for every
    // direction.
    [[nodiscard]] double variation_around(size_t k) const noexcept {
        const Direction &a = directions_[(k + 1) % 3], &b = directions_[(k + 2) % 3];
        if (!(a.variance > 0 && b.variance > 0)) {
            return HUGE_VAL;
        }
        double sum = 0;
        for (int64_t i = 0; i < cloud_.size(); ++i) {
            const double x = along(a, i), y = along(b, i);
            const double miss = x * x / a.variance + y * y / b.variance - 2;
            sum += miss * miss;
        }
        return sum;
    }

private:
    [[nodiscard]] double along(const Direction &direction, int64_t i) const noexcept {
        double sum = 0;
        for (size_t c = 0; c < mean_.size(); ++c) {
            sum += (cloud_.point(i)[c] - mean_[c]) * direction.unit[c];
        }
        return sum;
    }
    void measure(Direction &direction) const noexcept {
        direction.range = {HUGE_VAL, -HUGE_VAL};
        for (int64_t i = 0; i < cloud_.size(); ++i) {
            const double x = along(direction, i);
            direction.range = {std::min(direction.range.lower, x), std::max(direction.range.upper, x)};
            direction.variance += x * x / static_cast<double>(cloud_.size());
        }
    }

    const Cloud &cloud_;
    std::vector<double> mean_;
    std::vector<Direction> directions_;
};

// The offset from the mean that an axis of the spline contributes at a fraction of its domain.
struct Part {
    std::vector<const Direction *> along; // one, or the two of an ellipse

    void add(double place, std::vector<double> &point) const noexcept {
        if (along.size() == 1) {
            const auto [lower, upper] = along[0]->range;
            add(*along[0], std::lerp(lower, upper, place), point);
            return;
        }
        const double angle = 2 * std::numbers::pi * place;
        add(*along[0], std::sqrt(2 * along[0]->variance) * std::cos(angle), point);
        add(*along[1], std::sqrt(2 * along[1]->variance) * std::sin(angle), point);
    }

private:
    static void add(const Direction &direction, double length, std::vector<double> &point) noexcept {
        for (size_t c = 0; c < point.size(); ++c) {
            point[c] += length * direction.unit[c];
        }
    }
};

std::vector<Part> parts_for(const Spread &spread, const Spline::Axes &axes) {
    const auto closed =
        std::ranges::count_if(axes, [](const KnotVectorPtr &axis) { return axis->periodic(); });
    if (closed > 1 || (closed == 1 && axes.size() > 2)) {
        fail(Status::flags,
             "flags: no start is found for %lld periodic axes of %lld, expected one of at most 2",
             static_cast<long long>(closed), static_cast<long long>(axes.size()));
    }
    size_t straight = 0; // the direction of the axis of a cylinder
    if (closed == 1 && axes.size() == 2) {
        for (size_t k = 1; k < 3; ++k) {
            straight = spread.variation_around(k) < spread.variation_around(straight) ? k : straight;
        }
    }
    std::vector<Part> parts;
    for (size_t k = 0; k < axes.size(); ++k) {
        if (!axes[k]->periodic()) {
            parts.push_back({{&spread[closed == 1 ? straight : k]}});
        } else if (axes.size() == 1) {
            parts.push_back({{&spread[0], &spread[1]}});
        } else {
            parts.push_back({{&spread[straight == 0 ? 1 : 0], &spread[straight == 2 ? 1 : 2]}});
        }
    }
    return parts;
}

double place_of(const KnotVector &axis, int64_t layer) noexcept {
    const Interval domain = axis.domain();
    const int64_t own = axis.periodic() ? layer % axis.distinct_layers() : layer; // copies agree bit for bit
    return (greville(axis, own) - domain.lower) / (domain.upper - domain.lower);
}

} // namespace

SplinePtr cloud_start(const Cloud &cloud, const Spline::Axes &axes) {
    const Spread spread(cloud);
    const std::vector<Part> parts = parts_for(spread, axes);
    Index counts{1, 1, 1};
    for (size_t k = 0; k < axes.size(); ++k) {
        counts[k] = axes[k]->count();
    }
    std::vector<double> points;
    for_each_index({}, counts, [&](const Index &layer) {
        std::vector<double> point = spread.mean();
        for (size_t k = 0; k < axes.size(); ++k) {
            parts[k].add(place_of(*axes[k], layer[k]), point);
        }
        for (size_t c = 0; c < point.size(); ++c) {
            points.push_back(cloud.given(point[c], c));
        }
    });
    count_work(16 * static_cast<int64_t>(points.size()));
    return make_result(axes, cloud.dim, Form::polynomial, std::move(points));
}

} // namespace nrb::fit

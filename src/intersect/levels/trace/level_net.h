// SPDX-License-Identifier: MIT
// Bernstein coefficients of a function of two variables whose zeros are looked for.
#pragma once

#include "spline/spline.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace nrb::intersect {

// To within what coefficients are known: relative to their weights, and of any weight.
struct Noise {
    double relative = 0, absolute = 0;
    [[nodiscard]] double of(double weight) const noexcept { return relative * std::abs(weight) + absolute; }
};

// f = values / weights over a box; without weights these are 1. The sign of f counts as known where |values| > noise
// of the weights; a value that is nearer to 0 counts as above.
struct LevelNet {
    std::array<int, 2> degrees{};
    Noise noise;
    double least_weight = 0;             // weights above this are known to be positive
    std::vector<double> values, weights; // [degrees[0] + 1][degrees[1] + 1]

    [[nodiscard]] size_t rows() const noexcept { return static_cast<size_t>(degrees[0]) + 1; }
    [[nodiscard]] size_t columns() const noexcept { return static_cast<size_t>(degrees[1]) + 1; }
    [[nodiscard]] double weight(size_t i) const noexcept { return weights.empty() ? 1 : weights[i]; }

    // Whether all coefficients are farther from 0 than some times the noise, on one side: 1 or -1; else 0.
    [[nodiscard]] int side(double times) const noexcept;
    [[nodiscard]] bool is_near(double distance) const noexcept;
    [[nodiscard]] bool has_positive_weights() const noexcept;
    [[nodiscard]] double largest_weight() const noexcept;

    // How the values change along an axis: the sign of all differences of neighbours beyond the noise, or 0, and the
    // smallest and largest magnitude of them.
    struct Slope {
        int sign = 0;
        double least = 0, most = 0;
    };
    [[nodiscard]] Slope slope(size_t axis) const noexcept;

    // This becomes the upper half along an axis.
    LevelNet take_lower_half(size_t axis);
    // The coefficients on a side: end 0 or 1 of an axis.
    struct Edge {
        std::vector<double> values, weights;
        Noise noise;
        [[nodiscard]] double known(size_t i) const noexcept {
            return noise.of(weights.empty() ? 1 : weights[i]);
        }
        [[nodiscard]] bool is_known(size_t i) const noexcept { return std::abs(values[i]) > known(i); }
        [[nodiscard]] bool is_hidden() const noexcept; // no sign is known
        [[nodiscard]] double largest_known() const noexcept;
        [[nodiscard]] double value(double place) const;
        // This becomes the upper half.
        Edge take_lower_half();
    };
    [[nodiscard]] Edge edge(size_t axis, int end) const;
    [[nodiscard]] bool is_above(size_t row, size_t column) const noexcept {
        const size_t i = row * columns() + column;
        return values[i] >= -noise.of(weight(i));
    }

    struct Point {
        double value;
        std::array<double, 2> slope;
    };
    [[nodiscard]] Point at(const std::array<double, 2> &place) const noexcept;
    [[nodiscard]] double value(const std::array<double, 2> &place) const noexcept;
};

// Coefficients [degrees[0] + 1][degrees[1] + 1][width] over a part of [0, 1]^2.
void restrict_to(const std::array<int, 2> &degrees, int64_t width, const std::array<Interval, 2> &box,
                 std::vector<double> &values);

} // namespace nrb::intersect

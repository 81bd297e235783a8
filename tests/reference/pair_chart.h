// F(x) = A(x0, x1) - B(x2, x3) over a cell, |x| <= 1, and its margin: what its first derivatives prove.
#pragma once

#include "reference/patch_tree.h"

#include <algorithm>
#include <cmath>

namespace reference {

inline double dot(const Vector &x, const Vector &y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
inline Vector cross(const Vector &x, const Vector &y) {
    return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

struct PairSystem {
    Vector middle{}; // F(0), to `noise`
    std::array<Vector, 4> slope{}, radius{};
    double noise;

    PairSystem(const Patch &a, const Patch &b, double error) : noise(error) {
        for (size_t c = 0; c < 3; ++c) {
            middle[c] = a.middle[c] - b.middle[c];
        }
        for (size_t k = 0; k < 4; ++k) {
            slope[k] = k < 2 ? a.slope[k] : b.slope[k - 2];
            radius[k] = k < 2 ? a.slope_radius[k] : b.slope_radius[k - 2];
            for (double &x : slope[k]) {
                x = k < 2 ? x : -x;
            }
        }
    }

    [[nodiscard]] static std::array<size_t, 3> without(size_t k) {
        return {k == 0 ? 1U : 0U, k <= 1 ? 2U : 1U, k <= 2 ? 3U : 2U};
    }
    [[nodiscard]] double determinant(size_t k) const {
        const auto [i, j, l] = without(k);
        return dot(slope[i], cross(slope[j], slope[l]));
    }
    // The parameter that curves run along.
    [[nodiscard]] size_t longest() const {
        size_t best = 0;
        for (size_t k = 1; k < 4; ++k) {
            best = std::abs(determinant(k)) > std::abs(determinant(best)) ? k : best;
        }
        return best;
    }
};

// With M an inverse of F'(0) without column k, to rounding: bounds hold for any M.
class PairChart {
public:
    PairChart(const PairSystem &system, size_t k) : columns_(PairSystem::without(k)) {
        const auto [i, j, l] = columns_;
        const double determinant = system.determinant(k);
        const std::array<Vector, 3> rows{cross(system.slope[j], system.slope[l]),
                                         cross(system.slope[l], system.slope[i]),
                                         cross(system.slope[i], system.slope[j])};
        for (size_t r = 0; r < 3; ++r) {
            for (size_t c = 0; c < 3; ++c) {
                inverse_[r][c] = rows[r][c] / determinant;
                regular_ = regular_ && std::isfinite(inverse_[r][c]);
            }
        }
        if (regular_) {
            set_bounds(system);
        }
    }

    [[nodiscard]] bool regular() const { return regular_; }
    // The largest row sum of |I - M F'|, over the margin.
    [[nodiscard]] double contraction() const { return contraction_; }
    // An error of M F.
    [[nodiscard]] double noise() const { return noise_; }
    [[nodiscard]] Vector step(const Vector &f) const {
        return {dot(inverse_[0], f), dot(inverse_[1], f), dot(inverse_[2], f)};
    }
    [[nodiscard]] double size_of_step(const Vector &f) const {
        const Vector by = step(f);
        return std::max({std::abs(by[0]), std::abs(by[1]), std::abs(by[2])});
    }
    void move(const Vector &step, std::array<double, 4> &x) const {
        for (size_t r = 0; r < 3; ++r) {
            x[columns_[r]] -= step[r];
        }
    }
    // Whether F has no zero in the cell with x[axis] = at; axis 4: anywhere in it.
    [[nodiscard]] bool excludes(size_t axis, double at) const {
        for (size_t r = 0; r < 3; ++r) {
            double value = offset_[r], reach = noise_;
            for (size_t k = 0; k < 4; ++k) {
                value += k == axis ? at * product_[r][k] : 0;
                reach += radius_[r][k] + (k == axis ? 0 : std::abs(product_[r][k]));
            }
            if (std::abs(value) > rounded_up * reach) {
                return true;
            }
        }
        return false;
    }

private:
    static constexpr double rounded_up = 1 + 1e-12, rounding = 1e-14;

    void set_bounds(const PairSystem &system) {
        offset_ = step(system.middle);
        for (size_t r = 0; r < 3; ++r) {
            const Vector size{std::abs(inverse_[r][0]), std::abs(inverse_[r][1]), std::abs(inverse_[r][2])};
            noise_ = std::max(noise_, rounded_up * (size[0] + size[1] + size[2]) * system.noise);
            double sum = 0;
            for (size_t k = 0; k < 4; ++k) {
                const Vector slope{std::abs(system.slope[k][0]), std::abs(system.slope[k][1]),
                                   std::abs(system.slope[k][2])};
                product_[r][k] = dot(inverse_[r], system.slope[k]);
                radius_[r][k] = rounded_up * (dot(size, system.radius[k]) + rounding * dot(size, slope));
            }
            for (size_t s = 0; s < 3; ++s) {
                sum += std::abs(product_[r][columns_[s]] - (s == r ? 1 : 0)) + radius_[r][columns_[s]];
            }
            contraction_ = std::max(contraction_, rounded_up * sum);
        }
    }

    std::array<size_t, 3> columns_;
    std::array<Vector, 3> inverse_{};
    bool regular_ = true;
    Vector offset_{};
    std::array<std::array<double, 4>, 3> product_{}, radius_{};
    double contraction_ = 0, noise_ = 0;
};

} // namespace reference

// SPDX-License-Identifier: MIT
// Local minima and maxima of a squared distance in a box of parameters: Newton's method with the gradient
// projected to the box, damped by the Levenberg-Marquardt rule where the second derivatives are not positive
// definite or a step does not descend.
#pragma once

#include "base/numbers.h"
#include "numeric/solvers/small_cholesky.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::pieces {

// |S|^2 of a vector S of up to N parameters, and its derivatives: the Hessian of |S|^2 / 2 is the sum of
// metric and curvature.
template <size_t N>
struct SquareJet {
    using Vector = std::array<double, N>;
    double square = 0;                 // |S|^2
    Vector gradient{};                 // S . S_k
    std::array<Vector, N> metric{};    // S_k . S_l
    std::array<Vector, N> curvature{}; // S . S_kl
};

template <size_t N>
struct ParameterBox {
    std::array<double, N> lower{};
    std::array<double, N> upper = ones();

    static constexpr std::array<double, N> ones() noexcept {
        std::array<double, N> result{};
        result.fill(1);
        return result;
    }
};

struct Descent {
    double distance; // |S|
    bool converged;
};

// `jet` makes the SquareJet at an array of parameters.
template <size_t N, class Jet>
class DampedDescent {
public:
    using Vector = std::array<double, N>;

    // Minimises sign |S|, sign = 1 or -1; a distance of at most `floor` counts as 0.
    DampedDescent(int n, const ParameterBox<N> &box, double sign, double floor, const Jet &jet) noexcept
        : n_(static_cast<size_t>(n)), box_(box), sign_(sign), floor_(floor), jet_(jet) {}

    // Starts from `at`, which becomes the minimum, and makes at most `steps` steps.
    Descent run(Vector &at, int steps) {
        now_ = jet_(at);
        for (int i = 0; i < steps; ++i) {
            if (at_floor() || !set_free(at) || !set_move() || !set_next(at) || !descend(at)) {
                return {distance(), true};
            }
        }
        return {distance(), false};
    }

private:
    [[nodiscard]] double distance() const noexcept { return std::sqrt(std::max(now_.square, 0.0)); }
    [[nodiscard]] bool at_floor() const noexcept { return sign_ > 0 && !(now_.square > floor_ * floor_); }

    // Finds the axes along which descent does not leave the box; false if there are none.
    bool set_free(const Vector &at) noexcept {
        free_count_ = 0;
        for (size_t k = 0; k < n_; ++k) {
            const double down = -sign_ * now_.gradient[k];
            if (!((at[k] <= box_.lower[k] && down <= 0) || (at[k] >= box_.upper[k] && down >= 0))) {
                free_[free_count_++] = k;
            }
        }
        return free_count_ > 0;
    }

    bool set_move() noexcept {
        while (!solve()) {
            if (!damp(4)) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] bool damp(double factor) noexcept {
        damping_ = std::max(factor * damping_, 1e-3);
        return !(damping_ > 1e12);
    }

    // Computes the step on the free axes; false if the damped Hessian is not positive definite.
    bool solve() noexcept {
        double trace = 0;
        for (size_t k = 0; k < n_; ++k) {
            trace += now_.metric[k][k];
        }
        std::array<Vector, N> matrix;
        Vector x;
        for (size_t i = 0; i < free_count_; ++i) {
            const size_t k = free_[i];
            for (size_t j = 0; j <= i; ++j) {
                matrix[i][j] = sign_ * (now_.metric[k][free_[j]] + now_.curvature[k][free_[j]]);
            }
            matrix[i][i] += damping_ * (now_.metric[k][k] + 1e-6 * trace);
            x[i] = -sign_ * now_.gradient[k];
        }
        SmallCholesky<N> factor;
        if (!factor.factorise(matrix, static_cast<int>(free_count_), 8 * eps)) {
            return false;
        }
        factor.solve(x);
        move_ = {};
        for (size_t i = 0; i < free_count_; ++i) {
            move_[free_[i]] = x[i];
        }
        return true;
    }

    // Clamps the step to the box; false if it does not move.
    bool set_next(const Vector &at) noexcept {
        next_ = at;
        decrease_ = 0;
        bool moves = false;
        for (size_t k = 0; k < n_; ++k) {
            next_[k] = std::clamp(at[k] + move_[k], box_.lower[k], box_.upper[k]);
            decrease_ -= sign_ * now_.gradient[k] * (next_[k] - at[k]);
            moves = moves || next_[k] != at[k];
        }
        return moves;
    }

    // Where the expected decrease of |S|^2 is below rounding, the step is the last one and is taken even
    // without a measurable gain: by then Newton's method has squared the error.
    bool descend(Vector &at) {
        const SquareJet<N> then = jet_(next_);
        const double gain = sign_ * (now_.square - then.square);
        const bool last = std::abs(decrease_) <= 16 * eps * now_.square;
        const bool taken = last ? gain > 0 || std::abs(gain) <= 64 * eps * now_.square
                                : gain > 0 && std::isfinite(then.square);
        if (!taken) {
            return !last && damp(8);
        }
        at = next_;
        now_ = then;
        if (gain > 0.5 * decrease_) {
            damping_ = damping_ < 1e-2 ? 0 : damping_ / 8;
        }
        return !last;
    }

    size_t n_;
    const ParameterBox<N> &box_;
    double sign_, floor_;
    const Jet &jet_;
    SquareJet<N> now_;
    double damping_ = 0;
    std::array<size_t, N> free_{};
    size_t free_count_ = 0;
    Vector move_{}, next_{};
    double decrease_ = 0; // expected decrease of |S|^2 / 2
};

} // namespace nrb::pieces

// SPDX-License-Identifier: MIT
// Bounds the error of linear interpolation over a triangle by second derivatives. The l_i are barycentric
// coordinates.
#pragma once

#include "base/numbers.h"
#include "mesh/proof/four.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::mesh {

using Values = std::array<double, 3>;

// The maximum of l_0 l_1 q[2] + l_1 l_2 q[0] + l_2 l_0 q[1] over l_i >= 0 with sum 1. If the q[k] are the
// squared sides of an acute triangle, it is the squared circumradius, taken at the circumcentre; otherwise it
// is taken at the midpoint of a side, or it is 0.
inline double most_of_pairs(const Values &q) noexcept {
    const double a = q[0], b = q[1], c = q[2];
    const double side = std::max({a, b, c, 0.0}) / 4;
    const bool inside = a > 0 && b > 0 && c > 0 && a < b + c && b < a + c && c < a + b;
    return inside ? std::max(side, a * b * c / (2 * (a * b + b * c + c * a) - (a * a + b * b + c * c)) *
                                       (1 + 64 * eps))
                  : side;
}

// Bounds on what N / w is divided by, for a weight w that is at least `least` on the triangle, and at least the
// linear interpolant of some values w_i at its corners. With v_i = sqrt(w_i), m_i = l_i v_i / sum l v, and
// sum m = 1,
//
//     l_i l_j / w <= l_i l_j / sum l v^2 = m_i m_j / (v_i v_j sum (m / v) sum (m v)) <= m_i m_j / (v_i v_j),
//
// since the product of the sums is at least 1 (Cauchy-Schwarz). So sums of terms l_i l_j q[k], divided by w,
// are no greater than those of terms l_i l_j q[k] / sqrt(w_i w_j).
struct InverseWeights {
    Values pairs; // 1 / sqrt(w_i w_j) for the ends of side k
    double most;  // 1 / least
};

// The error of the linear interpolant of a function N over a triangle. The Hessian H of N is given as an
// affine function within a radius. Side k is opposite corner k. Let m_k be the mean of the second derivatives
// of N along side k at its two ends, and d_k a twelfth of their difference. Without the radius,
//
//     interpolant - N = 1/2 sum l_i l_j m_k + sum l_i l_j (l_i - l_j) d_k + l_0 l_1 l_2 g,
//
// where the sums run over the sides k with their ends i and j (Taylor's formula with the integral remainder),
// and g = 0 if H is constant. The sum of the |l_i l_j (l_i - l_j)| is at most 0.118 on the triangle and
// 0.0963 on a side.
class Bend {
public:
    // q[m][k]: the second derivative along side k at corner m. rest[k]: the radius of the second derivative
    // along side k; rest[3]: along any segment in the triangle. beside: if N is the sum of a function with the
    // Hessian q and another one, a bound on |interpolant - function| for the latter.
    Bend(const std::array<Four, 3> &q, const Four &rest, double beside) noexcept
        : rest_(rest), beside_(beside), largest_(greatest(abs(q[0]), greatest(abs(q[1]), abs(q[2]))) + rest),
          least_(greatest(q[0] * -1, greatest(q[1] * -1, q[2] * -1)) + rest),
          most_(greatest(q[0], greatest(q[1], q[2])) + rest) {
        const Four from(q[1][0], q[2][1], q[0][2], 0), to(q[2][0], q[0][1], q[1][2], 0), both = from + to;
        means_ = both * 0.5;
        differences_ = abs(to - from) * (1.0 / 12);
        product_ = std::abs(both.sum() / 12 - (q[0][0] + q[1][1] + q[2][2]) / 6);
        all_ = 0.118 * std::max({differences_[0], differences_[1], differences_[2]}) + product_ / 27 +
               std::min(rest[3] / 8, beside);
    }

    // An upper bound on N - interpolant.
    [[nodiscard]] double above() const noexcept {
        return most_of_pairs({-means_[0], -means_[1], -means_[2]}) / 2 + all_;
    }
    // An upper bound on N / w if N is at most 0 at the ends of side k and at most -below at corner k. All terms
    // but those of side k add up to at most l_k times `lifts`, so that -l_k below outweighs them if
    // lifts <= below. For the radii r = rest_: along the segment from corner k through the point to side k,
    // the second derivative has a radius of at most max(r_i, r_j) + r_k l_i l_j / (1 - l_k)^2. Altogether the
    // radii contribute at most r_k l_i l_j (1 + l_k) / (1 - l_k) / 2 + max(r_i, r_j) l_k / 2; the first term
    // is at most r_k / 8, since l_i l_j <= (1 - l_k)^2 / 4. Or else `beside` is all that they contribute.
    [[nodiscard]] double above(size_t k, double below, const InverseWeights &inverse) const noexcept {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const double lifts = std::max({-means_[i], -means_[j], 0.0}) / 2 + rest_of_lifts(k);
        const double on_side =
            std::max(-means_[k], 0.0) / 8 * inverse.pairs[k] + 0.0963 * differences_[k] * inverse.most;
        const auto outweighs = [below](double all) { return all * (1 + 16 * eps) <= below; };
        double result = above() * inverse.most;
        if (outweighs(lifts)) {
            result = std::min(result, on_side + beside_ * inverse.most);
        }
        if (outweighs(lifts + std::max(rest_[i], rest_[j]) / 2)) {
            result = std::min(result, on_side + rest_[k] / 8 * inverse.most);
        }
        return result;
    }
    // Upper bounds on |N - interpolant|, on the triangle; and divided by w, on the triangle, on side k, and where
    // l_k is at most `share`.
    [[nodiscard]] double both() const noexcept {
        return std::max(most_of_pairs({means_[0], means_[1], means_[2]}) / 2 + all_, above());
    }
    [[nodiscard]] double both(const InverseWeights &inverse) const noexcept {
        const Values &w = inverse.pairs;
        const double x = means_[0] * w[0], y = means_[1] * w[1], z = means_[2] * w[2];
        return std::max(most_of_pairs({x, y, z}), most_of_pairs({-x, -y, -z})) / 2 + all_ * inverse.most;
    }
    [[nodiscard]] double on_side(size_t k, const InverseWeights &inverse) const noexcept {
        return std::abs(means_[k]) / 8 * inverse.pairs[k] +
               (std::min(rest_[k] / 8, beside_) + 0.0963 * differences_[k]) * inverse.most;
    }
    [[nodiscard]] double near_side(size_t k, double share, const InverseWeights &inverse) const noexcept {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const double lifts = std::max(std::abs(means_[i]), std::abs(means_[j])) / 2 + rest_of_lifts(k);
        return std::abs(means_[k]) / 8 * inverse.pairs[k] +
               (0.0963 * differences_[k] + share * lifts +
                std::min(beside_, rest_[k] / 8 + share * std::max(rest_[i], rest_[j]) / 2)) *
                   inverse.most;
    }

    // An upper bound on the magnitude of the second derivative along side k, anywhere in the triangle.
    [[nodiscard]] double largest(size_t k) const noexcept { return largest_[k]; }
    // The same by sign, and at least 0: of -N'' and of N''. N exceeds its interpolant by at most
    // 1/2 sum l_i l_j falling(k), and lies below it by at most 1/2 sum l_i l_j rising(k). S. Waldron: The
    // error in linear interpolation at the vertices of a simplex, SIAM J. Numer. Anal. 35, 1998.
    [[nodiscard]] double falling(size_t k) const noexcept { return std::max(least_[k], 0.0); }
    [[nodiscard]] double rising(size_t k) const noexcept { return std::max(most_[k], 0.0); }

private:
    // What does not depend on signs in the sum of all terms but those of side k, relative to l_k.
    [[nodiscard]] double rest_of_lifts(size_t k) const noexcept {
        return std::max(differences_[(k + 1) % 3], differences_[(k + 2) % 3]) + product_ / 4;
    }

    Four rest_;
    double beside_;
    Four largest_, least_, most_, means_, differences_; // by side
    double product_, all_;
};

} // namespace nrb::mesh

// SPDX-License-Identifier: MIT
#include "closest/patch/critical/face_part.h"

#include "numeric/solvers/small_systems.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

namespace {

constexpr int most_newton_steps = 40;

enum class Step { on, converged, lost };

// One Newton step. Iterates may leave the part by up to its length.
Step newton_step(const PatchFace &face, const FacePart &part, const PatchJet &jet, AxisValues &at) {
    const int n = face.shape.axes;
    AxisMatrix hessian{};
    AxisVector gradient{};
    for (int k = 0; k < n; ++k) {
        const size_t i = face.shape_axis(k);
        gradient[static_cast<size_t>(k)] = jet.gradient[i];
        for (int l = 0; l < n; ++l) {
            const size_t j = face.shape_axis(l);
            hessian[static_cast<size_t>(k)][static_cast<size_t>(l)] = jet.metric[i][j] + jet.curvature[i][j];
        }
    }
    const AxisVector move = shortest_solution(n, hessian, gradient);
    bool converged = true;
    for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
        double &t = at[face.shape_axis(static_cast<int>(i))];
        converged = converged && std::abs(move[i]) <= 1e-9 * part.length[i];
        t = std::clamp(t - move[i], part.lower[i] - part.length[i], part.lower[i] + 2 * part.length[i]);
        if (!std::isfinite(t)) {
            return Step::lost;
        }
    }
    return converged ? Step::converged : Step::on;
}

// Moves a place that is outside by no more than rounding into the part; false if it is farther outside.
bool move_inside(const PatchFace &face, const FacePart &part, AxisValues &at) noexcept {
    for (int k = 0; k < face.shape.axes; ++k) {
        const auto i = static_cast<size_t>(k);
        const double over = 1e-7 * part.length[i], upper = part.lower[i] + part.length[i];
        double &t = at[face.shape_axis(k)];
        if (t < part.lower[i] - over || t > upper + over) {
            return false;
        }
        t = std::clamp(t, part.lower[i], upper);
    }
    return true;
}

} // namespace

AxisValues FacePart::middle(const PatchFace &face) const noexcept {
    AxisValues at{};
    for (size_t i = 0; i < static_cast<size_t>(face.shape.axes); ++i) {
        at[i] = lower[i] + length[i] / 2;
    }
    return face.in_piece(at);
}

int FacePart::longest_axis(const PatchFace &face) const noexcept {
    return static_cast<int>(std::max_element(length.begin(), length.begin() + face.shape.axes) -
                            length.begin());
}

std::optional<NewtonResult> newton(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                                   const FacePart &part) {
    NewtonResult result{part.middle(face), false};
    for (int i = 0; i < most_newton_steps && !result.converged; ++i) {
        const Step step = newton_step(face, part, query.descent().jet(whole.values, result.at), result.at);
        if (step == Step::lost) {
            return std::nullopt;
        }
        result.converged = step == Step::converged;
    }
    if (!move_inside(face, part, result.at)) {
        return std::nullopt;
    }
    return result;
}

} // namespace nrb::closest

// SPDX-License-Identifier: MIT
// A Krawczyk test for uniqueness: systems of N equations in N unknowns with at most one solution, whatever
// they come from, such as two curves, or a ray and a surface.
#pragma once

#include "base/numbers.h"
#include "basis/knot_vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nrb::intersect {

template <size_t N>
using Place = std::array<double, N>; // local parameters in [0, 1]^N
template <size_t N>
using Box = std::array<Interval, N>;

template <size_t N>
double largest(const Place<N> &x) noexcept {
    double most = 0;
    for (const double value : x) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

// For F over [0, 1]^N and a matrix M, rho is the largest row sum of |M F' - I| over the whole box, and norm
// is the norm of M by which |F| <= near implies |M F| <= norm near. If rho < 1, then for all z and z0, in the
// maximum norm,
//     |z - z0| (1 - rho) <= |M (F(z) - F(z0))|
// (R. Krawczyk 1969). So F has at most one zero, and all places where F is small lie close together.
struct Contraction {
    double rho = infinity;
    double norm = 0;

    [[nodiscard]] bool proven() const noexcept { return rho < 0.9; }

    // A bound on the distance from z0 to any place with |F| <= near. step: M F(z0).
    template <size_t N>
    [[nodiscard]] double radius(const Place<N> &step, double near) const noexcept {
        return 1.001 * (largest(step) + norm * near) / (1 - rho);
    }
    // A box that holds all such places, also those beyond [0, 1]^N. A place within the radius r of z0 is
    // within rho r + norm near of z0 - step.
    template <size_t N>
    [[nodiscard]] Box<N> solutions(const Place<N> &z0, const Place<N> &step, double near) const noexcept {
        const double r = radius(step, near);
        Box<N> found{};
        for (size_t k = 0; k < N; ++k) {
            const double centre = z0[k] - step[k];
            const double rest = 1.001 * (rho * r + norm * near) + 8 * eps * (1 + std::abs(step[k]));
            found[k] = {std::max(z0[k] - r, centre - rest), std::min(z0[k] + r, centre + rest)};
        }
        return found;
    }
};

// An approximate zero by Newton's method from the middle of the box. Where |M F| has not halved since the
// last step, the simplified step M F is taken instead. The iteration ends at rounding, where |M F| hardly
// falls any more, or where clamping to [0, 1]^N, widened by `room` on all sides, leaves no step. fixed(z):
// M F(z). newton(): the Newton step at the place of the last call of fixed(). That last call is for the place
// returned, so what fixed() keeps belongs to it.
template <size_t N, class Fixed, class Newton>
Place<N> approached(Fixed &&fixed, Newton &&newton, double room = 0) {
    constexpr int most_steps = 40;
    Place<N> z{};
    z.fill(0.5);
    double last = infinity;
    for (int i = 0;; ++i) {
        const Place<N> slow = fixed(z);
        const double size = largest(slow);
        if (size <= 2 * eps || i == most_steps || !(size < 0.95 * last)) {
            return z;
        }
        const Place<N> step = size < 0.5 * last ? newton() : slow;
        Place<N> next = z;
        for (size_t k = 0; k < N; ++k) {
            next[k] = std::clamp(z[k] - step[k], -room, 1 + room);
        }
        if (next == z) {
            return z;
        }
        last = size;
        z = next;
    }
}

template <size_t N>
bool strictly_inside(const Box<N> &box) noexcept {
    return std::all_of(box.begin(), box.end(), [](Interval x) { return x.lower > 0 && x.upper < 1; });
}
// Whether a box and [0, 1]^N are disjoint.
template <size_t N>
bool outside(const Box<N> &box) noexcept {
    return std::any_of(box.begin(), box.end(),
                       [](Interval x) { return !(std::max(x.lower, 0.0) <= std::min(x.upper, 1.0)); });
}

} // namespace nrb::intersect

// SPDX-License-Identifier: MIT
// Knot refinement as rows of coefficients, by the Oslo algorithm: E. Cohen, T. Lyche, R. Riesenfeld,
// "Discrete B-splines and subdivision techniques" (1980); T. Lyche, K. Morken, "Making the Oslo algorithm
// more efficient" (1986).
#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace nrb::refine {

// New control point j over the knots `fine` is the polar form of the spline over `coarse` at the arguments
// fine[j + 1], ..., fine[j + p]. Arguments that are old knots need no arithmetic. The others lie between the
// old knots next to these, so each of them is one step of de Boor's algorithm with factors in [0, 1]. The
// coefficients of a row depend neither on how other rows are computed nor on their number.
class Refinement {
public:
    // The data of a row: one step of de Boor's algorithm for each argument that is not an old knot, over the
    // old knots around the arguments that are; see append_argument(). The coefficients belong to old layers
    // first, ..., first + steps.
    struct Blossom {
        int64_t first;
        int steps;
        const double *left;
        const double *right;
        const double *arguments;
    };

    // Both vectors must outlive this. Preconditions: both are sorted; `fine` contains every knot of `coarse`
    // at least as often, and at most degree + 1 times; the knots that it contains more often lie in
    // [coarse[p], coarse[count]].
    Refinement(int degree, std::span<const double> coarse, std::span<const double> fine);

    [[nodiscard]] int width() const noexcept { return degree_ + 1; }
    [[nodiscard]] int64_t rows() const noexcept { return std::ssize(fine_) - degree_ - 1; }
    // Whether new layer j equals the layer before it: all arguments of both are the same knot, and the spline
    // does not jump there.
    [[nodiscard]] bool repeats(int64_t j) const noexcept {
        const auto i = static_cast<size_t>(j), after = i + static_cast<size_t>(degree_);
        return fine_[i] == fine_[after] && old_last_[i + 1] == old_last_[i] &&
               old_first_[after] == old_first_[after + 1];
    }
    // The data of new layer j. With n arguments that are not old knots it has n + 1 coefficients, each with a
    // relative error of at most 3 n eps; with n = 0 it is an old layer. If only some of the arguments are
    // new, they are copied to `room`, which holds up to `degree` of them.
    Blossom blossom(int64_t j, double *room) const noexcept {
        const double *arguments = fine_.data() + j + 1;
        const int64_t shared = old_last_[static_cast<size_t>(j + 1)];
        const int64_t shared_end = old_first_[static_cast<size_t>(j + degree_ + 1)];
        const double *left = coarse_.data() + shared;
        const double *right = coarse_.data() + shared_end;
        const auto steps = static_cast<int>(degree_ - (shared_end - shared));
        if (steps == degree_) { // most rows of fine refinements
            return {shared - 1 - steps, steps, left, right, arguments};
        }
        const double *old = left;
        for (int d = 0; d < steps; ++arguments) {
            if (old != right && *old == *arguments) {
                ++old;
            } else {
                room[d++] = *arguments;
            }
        }
        return {shared - 1 - steps, steps, left, right, room};
    }

    // How many consecutive new layers from j on, up to end - 1, have no old knot among their arguments and
    // have all of these between the same two old knots. Precondition: this is true of layer j.
    int64_t alike(int64_t j, int64_t end) const noexcept {
        const size_t reach = static_cast<size_t>(degree_) + 1;
        auto after = static_cast<size_t>(j) + reach;
        const int64_t old = old_first_[after];
        while (after < static_cast<size_t>(end) + reach && old_first_[after] == old) {
            ++after;
        }
        return static_cast<int64_t>(after - reach) - j;
    }

private:
    int degree_;
    std::span<const double> coarse_;
    std::span<const double> fine_;
    // The number of old knots among the first i fine knots, if old knots precede (old_first_) or follow
    // (old_last_) the new knots equal to them.
    std::unique_ptr<int64_t[]> old_first_;
    std::unique_ptr<int64_t[]> old_last_;
};

} // namespace nrb::refine

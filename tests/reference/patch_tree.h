// Bezier pieces of a surface and the cells that they are divided into, for proofs apart from the library: no code of it is used.
#pragma once

#include "support/spline_data.h"

#include <array>
#include <deque>
#include <vector>

namespace reference {

using Vector = std::array<double, 3>;

// A cell of a piece. Its local coordinates x run over [-1, 1]; bounds hold over the cell with a margin, |x| <= 1 + margin, in
// which the piece goes on as a rational function.
struct Patch {
    static constexpr double margin = 0.125;

    std::array<double, 2> lower{}, upper{}; // in units of pieces: piece i is [i, i + 1]
    int depth = 0;
    bool bounded = false; // weights are positive in the margin, too; else there are no bounds
    Vector middle{};      // at x = 0
    Vector least{}, most{};
    std::array<Vector, 2> slope{}, slope_radius{}; // of the derivatives by x
    std::vector<double> net;                       // homogeneous Bernstein coefficients over the margin
    std::array<int32_t, 4> children{-1, -1, -1, -1};
};

// All cells that were asked for, each made once. Double precision; noise() bounds the error of every coordinate: a step of de
// Casteljau's algorithm adds 3/2 eps of the largest coefficient, and there are 4 p of them in each of 26 divisions of degree p, besides
// those of the spans, and of a margin in which coefficients grow by (1 + margin)^(2 p) at most.
class PatchTree {
public:
    static constexpr int most_depth = 26, most_degree = 9;

    // Points are relative to `origin`. Precondition: degrees in [1, most_degree], weights > 0.
    PatchTree(const support::SplineData &data, const Vector &origin);

    [[nodiscard]] const std::vector<int32_t> &roots() const { return roots_; }
    [[nodiscard]] const Patch &operator[](int32_t patch) const {
        return patches_[static_cast<size_t>(patch)];
    }
    // Child `which` of 4: bit k is set for the upper part on axis k. Precondition: depth < most_depth.
    int32_t child(int32_t patch, int which);
    // The point at local coordinates in the margin.
    [[nodiscard]] Vector point(int32_t patch, const std::array<double, 2> &x) const;
    [[nodiscard]] double noise() const { return noise_; }

    [[nodiscard]] double pieces(int axis) const {
        return static_cast<double>(breaks_[static_cast<size_t>(axis)].size()) - 1;
    }
    // Whether both ends of an axis are one curve, to rounding.
    [[nodiscard]] bool closes(int axis) const { return closes_[static_cast<size_t>(axis)]; }
    // The parameter of a place in units of pieces.
    [[nodiscard]] double param(int axis, double place) const;

private:
    void add_pieces(const std::vector<double> &points, const support::SplineData &data);
    void find_closed_axes();
    void set_bounds(Patch &patch) const;
    [[nodiscard]] std::vector<double> part(const std::vector<double> &net, int axis, double from,
                                           double to) const;

    std::array<int, 2> degrees_{};
    std::array<std::vector<double>, 2> breaks_;
    std::array<bool, 2> closes_{};
    std::deque<Patch> patches_;
    std::vector<int32_t> roots_;
    double noise_ = 0;
};

} // namespace reference

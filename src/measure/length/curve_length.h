// SPDX-License-Identifier: MIT
// Lengths of curves.
#pragma once

#include "measure/elements.h"
#include "measure/length/speed_kernel.h"

#include <vector>

namespace nrb::measure {

struct Integral {
    double value;
    double error;     // estimate, rounding included
    bool good = true; // whether the error is what was asked for
};

// |C'| on the pieces of a curve as |N| / w^2, N = A' w - A w' = p (A_1 w_0 - A_0 w_1) of degree 2 p - 2,
// where A_0, A_1 are the means of the first and the last p coefficients of A (Floater, "Derivatives of
// rational Bezier curves", CAGD 9 (1992)): no difference is left to take where the curve is slow.
class SpeedPieces {
public:
    // Precondition: a curve.
    SpeedPieces(const Spline &curve, Interval range);

    [[nodiscard]] int64_t size() const noexcept { return std::ssize(intervals_); }
    [[nodiscard]] const SpeedForm &form() const noexcept { return form_; }
    [[nodiscard]] const double *net(int64_t piece) const noexcept {
        return nets_.data() + piece * form_.size();
    }
    [[nodiscard]] Interval interval(int64_t piece) const noexcept {
        return intervals_[static_cast<size_t>(piece)];
    }
    // Rounding of the length of all pieces, at most.
    [[nodiscard]] double rounding() const noexcept { return rounding_; }
    // What a length is multiplied by to be one of the model: 2^exponent.
    [[nodiscard]] int exponent() const noexcept { return exponent_; }

private:
    void add_piece(const Element &element, int degree);

    SpeedForm form_;
    std::vector<double> basis_;
    std::vector<double> weight_basis_;
    std::vector<double> nets_;
    std::vector<Interval> intervals_;
    double rounding_ = 0;
    int exponent_ = 0;
};

// A part of a piece on which one rule is enough.
struct LengthLeaf {
    int64_t piece;
    double lower, upper; // of the piece, in [0, 1]
    int level;           // of the rule
    double length;
};

// The length of all pieces. `leaves`, if not null, become all parts in their order, and `nets` what belongs
// to them as in SpeedPieces. The error is above what was asked only if the budget is spent; a tolerance below
// rounding asks for the best that the budget allows.
Integral integrate(const SpeedPieces &pieces, double relative_tolerance,
                   std::vector<LengthLeaf> *leaves = nullptr, std::vector<double> *nets = nullptr);

// The integral of the speed of one net by the rule of a level >= 2.
double rule_length(const SpeedForm &form, const double *net, int level) noexcept;

// Throws Status::not_converged, not_representable.
Integral curve_length(const Spline &curve, Interval range, double relative_tolerance);

// The results of an integral, scaled by 2^exponent.
Integral scaled_result(Integral integral, int exponent, double relative_tolerance, const char *what);

} // namespace nrb::measure

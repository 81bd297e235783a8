// SPDX-License-Identifier: MIT
// Lengths of curves by adaptive quadrature of the speed.
#pragma once

#include "measure/elements.h"
#include "measure/length/speed_kernel.h"

#include <vector>

namespace nrb::measure {

struct Integral {
    double value;
    double error;     // estimate, with rounding
    bool good = true; // whether the error is as small as requested
};

// The speed |C'| on the pieces of a curve as |N| / w^2. The numerator N = A' w - A w' = p (A_1 w_0 - A_0 w_1)
// has degree 2 p - 2, where A_0 and A_1 are the two points before the last step of de Casteljau's algorithm,
// that is the weighted means of the first and of the last p coefficients, and w_0, w_1 their weights
// (Floater, "Derivatives of rational Bezier curves", CAGD 9 (1992)). Its coefficients are computed once, so
// that no cancellation is left where the curve is slow.
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
    // A generous estimate of the rounding of the length of all pieces.
    [[nodiscard]] double rounding() const noexcept { return rounding_; }
    // Lengths here times 2^exponent are lengths of the model.
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

// A part of a piece on which one quadrature rule is accurate enough.
struct LengthLeaf {
    int64_t piece;
    double lower, upper; // in [0, 1] of the piece
    int level;           // of the rule
    double length;
};

// The length of all pieces. If `leaves` is not null, it receives all leaves in their order, and `nets` their
// nets, laid out as in SpeedPieces. The error exceeds the requested one only if the budget is spent. A
// tolerance below rounding requests the best that the budget allows.
Integral integrate(const SpeedPieces &pieces, double relative_tolerance,
                   std::vector<LengthLeaf> *leaves = nullptr, std::vector<double> *nets = nullptr);

// The integral of the speed of one net by the rule of a level >= 2.
double rule_length(const SpeedForm &form, const double *net, int level) noexcept;

// Throws Status::not_converged, not_representable.
Integral curve_length(const Spline &curve, Interval range, double relative_tolerance);

// An integral scaled by 2^exponent. Throws Status::not_converged, not_representable.
Integral scaled_result(Integral integral, int exponent, double relative_tolerance, const char *what);

} // namespace nrb::measure

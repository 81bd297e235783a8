// SPDX-License-Identifier: MIT
// Arc length as a function of the parameter, and its inverse.
#pragma once

#include "base/records.h"
#include "measure/length/curve_length.h"

#include <memory>

namespace nrb::measure {

// The leaves of a curve, on each of which one rule gives the length to double precision. Kept with the
// spline, because making the table takes as long as computing several lengths.
class LengthTable {
public:
    explicit LengthTable(const Spline &curve);
    static const LengthTable &of(const Spline &curve);

    // All lengths here are those of the model divided by 2^exponent().
    [[nodiscard]] double total() const noexcept { return starts_.back(); }
    [[nodiscard]] double error() const noexcept { return error_; }
    [[nodiscard]] int exponent() const noexcept { return pieces_.exponent(); }
    // The doubles of working memory that the functions below need.
    [[nodiscard]] size_t work_size() const noexcept;
    // The multiply-adds of a rule on a part of a leaf.
    [[nodiscard]] int64_t work_of_a_place() const noexcept;
    // The length from the start of the domain to t. Precondition: t is in the domain. Cost: one rule.
    [[nodiscard]] double length_at(double t, double *work) const noexcept;
    // The first parameter with a given length in [0, total()], by Newton's method inside a bracket with the
    // speed as derivative. Cost: about three rules.
    [[nodiscard]] double param_at(double length, double *work) const noexcept;

    // Throws Status::not_converged unless lengths are accurate to this tolerance, relative to `part` or the
    // total, whichever is smaller; and not_representable.
    void check(double relative_tolerance, double part) const;

private:
    [[nodiscard]] const double *net(size_t leaf) const noexcept {
        return nets_.data() + leaf * static_cast<size_t>(pieces_.form().size());
    }
    [[nodiscard]] double part_length(size_t leaf, double lower, double upper, double *work) const noexcept;
    [[nodiscard]] double from_start(size_t leaf, double x, double *work) const noexcept;
    [[nodiscard]] double speed(size_t leaf, double x, double *work) const noexcept;
    [[nodiscard]] double guess(size_t leaf, double part) const noexcept;
    [[nodiscard]] double step_length(size_t leaf, double from, double to, double speed_from, double speed_to,
                                     double *work) const noexcept;
    // Precondition: 0 < part < the length of the leaf.
    [[nodiscard]] double solve(size_t leaf, double part, double *work) const noexcept;

    SpeedPieces pieces_;
    std::vector<LengthLeaf> leaves_;
    std::vector<double> nets_;
    std::vector<double> starts_; // length up to each leaf, then the total
    std::vector<double> params_; // parameter at which each leaf begins
    std::vector<std::array<double, 2>> end_speeds_;
    double error_ = 0;
};

// Lengths from the start of the domain to parameters. Precondition: the parameters are in the domain.
void curve_lengths(const Spline &curve, const ConstRecords &params, double relative_tolerance,
                   const Records &out);

// Parameters at given lengths. Throws Status::length for a length that is NaN or, unless `clamp`, outside
// [0, total].
void curve_params_at_lengths(const Spline &curve, const ConstRecords &lengths, double relative_tolerance,
                             bool clamp, const Records &out);

} // namespace nrb::measure

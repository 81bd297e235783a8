// SPDX-License-Identifier: MIT
// All Bernstein pieces of a spline in one net, over breaks that may be more than its own.
#pragma once

#include "bernstein/products.h"
#include "spline/spline.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::pieces {

// Homogeneous points about a centre in Cartesian space, as they enter a net.
struct CentredRecords {
    int width = 0; // coordinates, and the weight unless all splines compared are polynomial
    bool weighted = false;
    bool positive = true;       // all weights >= 0, and none 0 with a point at infinity
    std::vector<double> values; // (w (x - c), ..., w)
    std::vector<double> sizes;  // what a record is accurate to 2 eps of, by its weight: |x - c| if positive
};

// All of what follows is of control points that have influence.
// The middle of their box; the origin for points that have no Cartesian place.
std::vector<double> centre_of(const Spline &given);
// The power of two above their largest weight: divided by it, none is more than 1, and no product with a point overflows.
int weight_exponent(const Spline &given);

// (w (x - c), w) with the weights divided by 2^exponent.
CentredRecords centred_records(const Spline &given, const std::vector<double> &centre, bool weighted,
                               int exponent);

// Of the axes that the spline has; 0 for the others.
std::array<int, max_axes> degrees_of(const Spline &spline) noexcept;

// Coefficients of the pieces between consecutive breaks, raised to given degrees. With exact coefficients A*,
// w* of a piece and H its size(): |w - w*| <= error() w, |A - A*| <= error() H w if the weights are positive;
// otherwise the same with the largest weight instead of w and the largest record instead of H w.
class BernsteinNet {
public:
    using Breaks = std::array<std::vector<double>, max_axes>;

    // Breaks of the axes of the spline, rising, in its domain, all its knots between the first and the last
    // among them. Those of axes that are not there are empty. Cost: linear in the number of pieces.
    BernsteinNet(const Spline &spline, const CentredRecords &records, const Breaks &breaks,
                 std::span<const int> degrees);

    [[nodiscard]] const BernsteinShape &shape() const noexcept { return shape_; } // with the weight
    [[nodiscard]] int64_t pieces() const noexcept { return counts_[0] * counts_[1] * counts_[2]; }
    // Coordinates and, if there is one, the weight of all coefficients of a piece.
    void copy(int64_t piece, double *coordinates, double *weights) const noexcept;
    // Largest size of the records that are active on a piece.
    [[nodiscard]] double size(int64_t piece) const noexcept { return sizes_[static_cast<size_t>(piece)]; }
    [[nodiscard]] double error() const noexcept { return error_; }
    [[nodiscard]] bool weighted() const noexcept { return weighted_; }
    [[nodiscard]] bool positive() const noexcept { return positive_; }
    [[nodiscard]] double largest_record() const noexcept { return largest_record_; }
    [[nodiscard]] double largest_weight() const noexcept { return largest_weight_; }

private:
    BernsteinShape shape_;
    std::array<int64_t, max_axes> counts_{1, 1, 1}; // pieces along each axis
    SplinePtr net_;                                 // count * (degree + 1) layers along each axis
    std::vector<double> sizes_;
    double error_ = 0;
    bool weighted_ = false;
    bool positive_ = true;
    double largest_record_ = 0;
    double largest_weight_ = 1;
};

} // namespace nrb::pieces

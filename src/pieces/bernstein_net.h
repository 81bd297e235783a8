// SPDX-License-Identifier: MIT
// All Bernstein pieces of a spline in one net, over its own breaks or a superset of them.
#pragma once

#include "bernstein/products.h"
#include "spline/spline.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::pieces {

// Homogeneous control points about a centre in Cartesian space, as they enter a net.
struct CentredRecords {
    int width = 0; // coordinates, plus the weight unless all splines compared are polynomial
    bool weighted = false;
    bool positive = true;       // all weights >= 0, and > 0 if homogeneous
    std::vector<double> values; // (w (x - c), ..., w)
    std::vector<double> sizes;  // records are accurate to 2 eps of this times the weight; |x - c| if positive
};

// The functions below consider only the control points that have influence.
//
// The middle of their bounding box; the origin for homogeneous control points.
std::vector<double> centre_of(const Spline &given);
// The exponent of the power of two above their largest weight: divided by it, no weight exceeds 1, and no
// product with a point overflows.
int weight_exponent(const Spline &given);

// (w (x - c), w) with the weights divided by 2^exponent.
CentredRecords centred_records(const Spline &given, const std::vector<double> &centre, bool weighted,
                               int exponent);

// The degrees of the axes of the spline; 0 for the others.
std::array<int, max_axes> degrees_of(const Spline &spline) noexcept;

// The coefficients of the pieces between consecutive breaks, elevated to given degrees. Let A*, w* be the
// exact coefficients of a piece, and H its size(). If the weights are positive, |w - w*| <= error() w and
// |A - A*| <= error() H w. Otherwise the same bounds hold with the largest weight instead of w, and the
// largest record instead of H w.
class BernsteinNet {
public:
    using Breaks = std::array<std::vector<double>, max_axes>;

    // breaks: for each axis of the spline increasing parameters in its domain, including all knots between
    // the first and the last of them; empty for axes that the spline does not have. Cost: linear in the
    // number of pieces.
    BernsteinNet(const Spline &spline, const CentredRecords &records, const Breaks &breaks,
                 std::span<const int> degrees);

    [[nodiscard]] const BernsteinShape &shape() const noexcept { return shape_; } // including the weight
    [[nodiscard]] int64_t pieces() const noexcept { return counts_[0] * counts_[1] * counts_[2]; }
    // Copies the coordinates and, if weighted, the weights of all coefficients of a piece.
    void copy(int64_t piece, double *coordinates, double *weights) const noexcept;
    // The largest size of the records that are active on a piece.
    [[nodiscard]] double size(int64_t piece) const noexcept { return sizes_[static_cast<size_t>(piece)]; }
    [[nodiscard]] double error() const noexcept { return error_; }
    [[nodiscard]] bool weighted() const noexcept { return weighted_; }
    [[nodiscard]] bool positive() const noexcept { return positive_; }
    [[nodiscard]] double largest_record() const noexcept { return largest_record_; }
    [[nodiscard]] double largest_weight() const noexcept { return largest_weight_; }

private:
    BernsteinShape shape_;
    std::array<int64_t, max_axes> counts_{1, 1, 1}; // number of pieces along each axis
    SplinePtr net_;                                 // count * (degree + 1) layers along each axis
    std::vector<double> sizes_;
    double error_ = 0;
    bool weighted_ = false;
    bool positive_ = true;
    double largest_record_ = 0;
    double largest_weight_ = 1;
};

} // namespace nrb::pieces

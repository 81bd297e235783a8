// SPDX-License-Identifier: MIT
// Bernstein forms along a piece of the polynomials in implicit equations, over powers of the weight.
#pragma once

#include "recognize/shape_pieces.h"

#include <vector>

namespace nrb::recognize {

// Bounds on the values of a polynomial over a power of the weight; they include `error`, the part due to
// rounding.
struct FormRange {
    double least;
    double most;
    double error;
};

struct TorusForms {
    FormRange sum;            // G = x^2 + y^2 + z^2 + R^2 - r^2
    FormRange squared_radius; // S = x^2 + y^2
    FormRange product;        // G^2 - 4 R^2 S
};

// Coefficients are stored multiplied by their binomials, so that products are convolutions; in quotients of
// coefficients, the binomials of the product cancel. The rounding error of a product a b is at most
// product_error() times the sum of the magnitudes of its terms, which is at most w^2 times the largest
// |a| / w times the largest |b| / w. Cost: for a piece with n coefficients, n^2 operations per product, and
// n^2 2^(2 axes) for the torus.
class ShapeForms {
public:
    // Precondition: the piece is sound().
    explicit ShapeForms(const pieces::BezierPiece &piece);

    [[nodiscard]] FormRange quadratic(const Quadric &quadric) const;
    // The squared length of half the gradient.
    [[nodiscard]] FormRange squared_gradient(const Quadric &quadric) const;
    [[nodiscard]] TorusForms torus(double major, double minor) const;

private:
    using Values = std::vector<double>;

    // The terms of a^2 + factor b w^2, with a bound on the rounding error.
    struct Fourth {
        const Values &a;
        const Values &b;
        double factor;
        double error;
    };
    [[nodiscard]] Fourth fourth(const Values &a, double a_error, const Values &b, double b_error,
                                double factor) const;
    [[nodiscard]] FormRange product(const Fourth &form) const;
    [[nodiscard]] Values numerators(const Quadric &quadric) const;
    void add_product(Values &sum, double factor, const Values &a, const Values &b) const;
    [[nodiscard]] double largest(const Quadric &squares, double linear) const noexcept;
    [[nodiscard]] FormRange range(const Values &numerators, double error) const noexcept;

    const pieces::BezierPiece &piece_;
    BernsteinShape single_; // for a coordinate
    BernsteinShape double_; // for a product of coordinates
    Values x_, y_, z_, w_;
    Values squares_; // w^2
    double product_error_;
};

} // namespace nrb::recognize

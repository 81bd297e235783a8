// SPDX-License-Identifier: MIT
// Polynomials of the coordinates along a piece, over powers of its weight.
#pragma once

#include "recognize/shape_pieces.h"

#include <vector>

namespace nrb::recognize {

// Between what bounds the values of a polynomial over a power of the weight lie; `error` is what rounding has
// in them.
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

// Bernstein coefficients times their binomials, so that products are convolutions; in quotients of
// coefficients the binomials of the product fall out. Of a term a b of two factors rounding takes at most
// product_error() times the sum of the magnitudes of its products, which is at most the largest |a| / w times
// the largest |b| / w, times w^2. Cost: for a piece of n coefficients n^2 operations a product, n^2 2^(2
// axes) for the torus.
class ShapeForms {
public:
    // Precondition: the piece is sound.
    explicit ShapeForms(const pieces::BezierPiece &piece);

    [[nodiscard]] FormRange quadratic(const Quadric &quadric) const;
    // Of half the gradient.
    [[nodiscard]] FormRange squared_gradient(const Quadric &quadric) const;
    [[nodiscard]] TorusForms torus(double major, double minor) const;

private:
    using Values = std::vector<double>;

    // a^2 + factor b w^2, and what rounding it would have.
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
    BernsteinShape single_; // of the coordinates
    BernsteinShape double_; // of their products
    Values x_, y_, z_, w_;
    Values squares_; // w^2
    double product_error_;
};

} // namespace nrb::recognize

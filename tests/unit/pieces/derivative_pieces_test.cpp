// SPDX-License-Identifier: MIT
// Numerators of derivatives on Bernstein pieces against the derivatives themselves, in exact arithmetic.
#include "pieces/derivative_pieces.h"
#include "property/exact_points.h"
#include "support/cases.h"

#include <gtest/gtest.h>

namespace derivative_pieces_test {

namespace {

using namespace support;
using nrb::RoundedPolynomial;

nrb::SplinePtr spline_of(const SplineData &data) {
    nrb::Spline::Axes axes;
    for (size_t k = 0; k < data.knots.size(); ++k) {
        axes.push_back(
            nrb::make_knot_vector(data.degrees[k], data.knots[k], data.periodic(static_cast<int>(k))));
    }
    return nrb::make_spline(axes, data.dim, data.rational() ? nrb::Form::rational : nrb::Form::polynomial,
                            data.points, data.weights);
}

// Value and error of component c in the middle of a piece.
struct Middle {
    double value;
    double error;
};
Middle middle_of(RoundedPolynomial f, int c) {
    for (int axis = 0; axis < nrb::max_axes; ++axis) {
        split(f, axis);
        f = end_value(f, axis, false);
    }
    return {f.values[static_cast<size_t>(c)], f.error(static_cast<size_t>(c))};
}

using Vector = std::vector<Rational>;

Vector cross(const Vector &a, const Vector &b) {
    if (a.size() == 2) {
        return {a[0] * b[1] - a[1] * b[0]};
    }
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Vector &a, const Vector &b) {
    Rational sum = 0;
    for (size_t c = 0; c < a.size(); ++c) {
        sum += a[c] * b[c];
    }
    return sum;
}

// The derivatives in the middle of a piece, with respect to its places and in its unit of length.
class Middles {
public:
    Middles(const SplineData &data, const nrb::pieces::HomogeneousPiece &piece) : piece_(piece) {
        std::vector<double> at;
        for (int k = 0; k < data.axes(); ++k) {
            at.push_back(piece.parameter(k, 0.5));
        }
        derivatives_ = reference::exact_derivatives(data, 3, at.data());
        exact_ = true; // the middle is not rounded
        for (int k = 0; k < data.axes(); ++k) {
            const nrb::Interval range = piece.part[static_cast<size_t>(k)];
            exact_ =
                exact_ && 2 * exact(at[static_cast<size_t>(k)]) == exact(range.lower) + exact(range.upper);
        }
    }
    [[nodiscard]] bool usable() const { return exact_; }

    [[nodiscard]] Vector at(const MultiIndex &index) const {
        Rational factor = piece_.exponent >= 0 ? Rational(1) / (reference::Integer(1) << piece_.exponent)
                                               : Rational(reference::Integer(1) << -piece_.exponent);
        for (size_t k = 0; k < index.size(); ++k) {
            for (int i = 0; i < index[k]; ++i) {
                factor *= exact(piece_.part[k].upper) - exact(piece_.part[k].lower);
            }
        }
        Vector result;
        for (const auto &x : derivatives_[static_cast<size_t>(slot_of(index))]) {
            result.push_back(factor * Rational(x.numerator, x.denominator));
        }
        return result;
    }

    // numerator = w^power * expected, each to its rounding.
    void check(const RoundedPolynomial &numerator, const Vector &expected, int power,
               const std::string &text) {
        const Middle w = middle_of(piece_.weight, 0);
        for (size_t c = 0; c < expected.size(); ++c) {
            const Middle found = middle_of(numerator, static_cast<int>(c));
            Rational value = expected[c];
            for (int i = 0; i < power; ++i) {
                value *= exact(w.value);
            }
            const long double off = std::fabs(as_long_double(Rational(exact(found.value) - value)));
            const long double slack = std::fabs(as_long_double(value)) * 1.1L * power * w.error / w.value;
            EXPECT_LE(off, found.error + slack) << text;
            worst = std::max(worst, off == 0 ? 0 : off / (found.error + slack));
        }
    }
    static inline long double worst = 0;

private:
    const nrb::pieces::HomogeneousPiece &piece_;
    std::vector<std::vector<reference::Fraction>> derivatives_;
    bool exact_ = false;
};

SplineData random_of(Random &random, int axes, int dim) {
    Recipe recipe = random_recipe(random, axes, axes == 1 ? 6 : 3);
    recipe.dim = dim;
    for (AxisRecipe &axis : recipe.axes) {
        axis.spacing = Spacing::integers; // middles of pieces are numbers then
        axis.spans = axes == 1 ? 4 : 1;
    }
    return random_spline(random, recipe);
}

} // namespace

TEST(DerivativePieces, of_curves) {
    for_each_case(9100, 120, [](Random &random, uint64_t seed) {
        const SplineData data = random_of(random, 1, random.whole(2, 3));
        const nrb::SplinePtr spline = spline_of(data);
        const nrb::pieces::PieceMaker maker(*spline, nrb::whole_domain(*spline));
        for (int64_t e = 0; e < maker.count(); ++e) {
            const nrb::pieces::HomogeneousPiece piece = maker.piece(e);
            Middles middle(data, piece);
            if (!middle.usable()) {
                continue;
            }
            const Vector d = middle.at({1}), dd = middle.at({2}), ddd = middle.at({3});
            middle.check(nrb::pieces::tangent_numerator(piece, 0), d, 2, where(seed, data));
            middle.check(nrb::pieces::bend_numerator(piece), cross(d, dd), 3, where(seed, data));
            if (data.dim == 3) {
                middle.check(nrb::pieces::twist_numerator(piece), {dot(cross(d, dd), ddd)}, 4,
                             where(seed, data));
            }
        }
    });
    EXPECT_GT(Middles::worst, 1e-3L); // the bounds are not idle
}

TEST(DerivativePieces, of_surfaces_and_volumes) {
    for_each_case(9200, 60, [](Random &random, uint64_t seed) {
        const int axes = random.whole(2, 3), dim = axes == 3 ? 3 : random.whole(2, 3);
        const SplineData data = random_of(random, axes, dim);
        const nrb::SplinePtr spline = spline_of(data);
        const nrb::pieces::PieceMaker maker(*spline, nrb::whole_domain(*spline));
        const nrb::pieces::HomogeneousPiece piece =
            maker.piece(random.whole(0, static_cast<int>(maker.count()) - 1));
        Middles middle(data, piece);
        if (!middle.usable()) {
            return;
        }
        if (axes == 2) {
            const Vector u = middle.at({1, 0}), v = middle.at({0, 1});
            middle.check(nrb::pieces::normal_numerator(piece), cross(u, v), 3, where(seed, data));
            middle.check(nrb::pieces::tangent_numerator(piece, 1), v, 2, where(seed, data));
        } else {
            const Vector u = middle.at({1, 0, 0}), v = middle.at({0, 1, 0}), w = middle.at({0, 0, 1});
            middle.check(nrb::pieces::volume_numerator(piece), {dot(cross(u, v), w)}, 4, where(seed, data));
        }
    });
}

} // namespace derivative_pieces_test

// SPDX-License-Identifier: MIT
#include "analysis/steady_sign.h"

#include "support/generators.h"

#include <gtest/gtest.h>

namespace steady_sign_test {

using namespace nrb;

namespace {

// One piece of degree 2 on two or three axes: the identity, with points moved by up to `noise`.
SplinePtr patch(support::Random &random, int axes, int dim, double noise, bool rational, bool mirrored) {
    const auto knots = make_knot_vector(2, {0, 0, 0, 1, 1, 1});
    std::vector<double> points, weights;
    for (int i = 0; i < (axes == 3 ? 27 : 9); ++i) {
        int rest = i;
        std::array<double, 3> place{};
        for (int k = axes - 1; k >= 0; --k, rest /= 3) {
            place[static_cast<size_t>(k)] = 0.5 * (rest % 3);
        }
        place[0] = mirrored ? -place[0] : place[0];
        for (int c = 0; c < dim; ++c) {
            points.push_back(place[static_cast<size_t>(c)] + random.between(-noise, noise));
        }
        weights.push_back(random.between(1, 1 + noise));
    }
    return make_spline(Spline::Axes(static_cast<size_t>(axes), knots), dim,
                       rational ? Form::rational : Form::polynomial, std::move(points),
                       rational ? std::move(weights) : std::vector<double>());
}

int sign_of(const Spline &spline, const std::array<double, 3> &direction) {
    return analysis::steady_sign(pieces::PieceMaker(spline, whole_domain(spline)).piece(0), spline.axes(),
                                 direction);
}

// Of the Bernstein coefficients of the determinant itself.
int certain(const Spline &spline, const std::array<double, 3> &direction) {
    const pieces::HomogeneousPiece piece = pieces::PieceMaker(spline, whole_domain(spline)).piece(0);
    RoundedPolynomial f =
        spline.axes() == 3 ? pieces::volume_numerator(piece) : pieces::normal_numerator(piece);
    if (f.shape.width == 3) {
        RoundedPolynomial along = scaled(component(f, 0), direction[0]);
        along = sum(along, direction[1], component(f, 1));
        f = sum(along, direction[2], component(f, 2));
    }
    return certain_sign(f);
}

} // namespace

TEST(SteadySign, has_the_sign_of_the_determinant_or_tells_nothing) {
    support::Random random(1);
    const std::array<double, 3> up{0, 0, 1};
    int told = 0, silent = 0;
    for (int i = 0; i < 600; ++i) {
        const int axes = random.whole(2, 3), dim = axes == 3 ? 3 : random.whole(2, 3);
        const bool mirrored = random.chance(50);
        const SplinePtr spline =
            patch(random, axes, dim, random.magnitude(1e-3, 1), random.chance(50), mirrored);
        const int sign = sign_of(*spline, up);
        if (sign != 0) {
            ++told;
            const int exact = certain(*spline, up);
            EXPECT_TRUE(exact == sign || exact == 0); // coefficients may have both signs where J has one
            EXPECT_EQ(sign, mirrored ? -1 : 1);
        } else {
            ++silent;
        }
    }
    EXPECT_GT(told, 100);
    EXPECT_GT(silent, 100);
}

TEST(SteadySign, tells_nothing_of_shapes_that_fold_or_collapse) {
    const auto knots = make_knot_vector(1, {0, 0, 1, 1});
    const Spline::Axes axes(2, knots);
    const SplinePtr folded = make_spline(axes, 2, Form::polynomial, {0, 0, 0, 1, 1, 1, 1, 0});
    const SplinePtr collapsed = make_spline(axes, 2, Form::polynomial, {0, 0, 0, 0, 1, 0, 1, 1});
    const SplinePtr line = make_spline(axes, 2, Form::polynomial, {0, 0, 1, 1, 2, 2, 3, 3});
    for (const SplinePtr &spline : {folded, collapsed, line}) {
        EXPECT_EQ(sign_of(*spline, {}), 0);
    }
}

} // namespace steady_sign_test

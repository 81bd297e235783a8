// Derivatives, integrals, sums, products and compositions of curves of small whole numbers, which come out
// exactly.
#include "refine/algebra/antiderivative.h"
#include "refine/algebra/derivative.h"
#include "refine/algebra/product.h"
#include "refine/algebra/sum.h"
#include "refine/compose/compose.h"
#include "refine/forms/power.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace calculus_test {

using namespace nrb;
using namespace shapes;

namespace {

using Values = std::vector<double>;

TEST(Derivative, of_an_integral_is_the_curve) {
    const SplinePtr g = curve(2, {0, 0, 0, 1, 3, 3, 3}, 1, {2, 4, 8, 16});
    const SplinePtr whole = refine::antiderivative(*refine::polynomial_derivative(g, 0, 1), 0);
    EXPECT_EQ(vector_of(whole->points()), (Values{0, 2, 6, 14}));
    EXPECT_EQ(vector_of(whole->axis(0).knots()), vector_of(g->axis(0).knots()));
}

TEST(Derivative, drops_the_layer_of_a_jump) {
    const SplinePtr jump = curve(1, {0, 0, 1, 1, 2, 2}, 1, {0, 1, 5, 7});
    EXPECT_EQ(vector_of(nrb::refine::polynomial_derivative(jump, 0, 1)->points()), (Values{1, 2}));
}

TEST(Product, of_lines_is_a_parabola) {
    const SplinePtr made =
        refine::product(*bezier(1, {0, 1}), *bezier(1, {0, 1}), refine::ProductKind::components);
    EXPECT_EQ(vector_of(made->points()), (Values{0, 0, 1}));
}

TEST(Product, takes_a_scalar_times_all_components) {
    const SplinePtr made =
        refine::product(*bezier(2, {1, 2, 3, 4}), *bezier(1, {2, 2}), refine::ProductKind::components);
    EXPECT_EQ(vector_of(made->points()), (Values{2, 4, 4, 6, 6, 8}));
}

TEST(Sum, raises_the_lower_degree) {
    const SplinePtr made = refine::sum(bezier(1, {0, 2}), 1, bezier(1, {0, 0, 1}), -1);
    EXPECT_EQ(vector_of(made->points()), (Values{0, 1, 1}));
}

TEST(Power, basis_there_and_back) {
    const SplinePtr g = curve(2, {0, 0, 0, 2, 4, 4, 4}, 1, {1, 3, 5, 13});
    refine::PowerForm form = refine::to_power(g);
    EXPECT_EQ(form.coefficients, (Values{1, 2, -0.25, 4, 1, 1.75}));
    const SplinePtr back = refine::from_power(std::move(form), false);
    EXPECT_EQ(vector_of(back->points()), (Values{1, 3, 4, 4, 5, 13}));
}

TEST(Compose, of_powers_multiplies_them) {
    const SplinePtr square = bezier(1, {0, 0, 1});
    const SplinePtr fourth = refine::compose(square, square);
    EXPECT_EQ(vector_of(fourth->points()), (Values{0, 0, 0, 0, 1}));
}

TEST(Compose, deals_knots_out_over_several_spans) {
    const SplinePtr g = curve(2, {0, 0, 0, 1, 2, 3, 3, 3}, 1, {0, 1, 2, 4, 8});
    const SplinePtr made = refine::compose(g, bezier(1, {3, 0})); // backwards and three times as fast
    EXPECT_EQ(vector_of(made->points()), (Values{8, 4, 2, 1, 0}));
}

TEST(Compose, meets_a_corner_of_knot_lines_once) {
    const auto axis = make_knot_vector(1, {0, 0, 1, 2, 2});
    const SplinePtr tent = make_spline({axis, axis}, 1, Form::polynomial, {0, 0, 0, 0, 4, 0, 0, 0, 0});
    const SplinePtr made = refine::compose(tent, bezier(2, {0, 0, 2, 2}));
    EXPECT_EQ(vector_of(made->axis(0).knots()), (Values{0, 0, 0, 0.5, 0.5, 1, 1, 1}));
    EXPECT_EQ(vector_of(made->points()), (Values{0, 0, 4, 0, 0}));
}

} // namespace

} // namespace calculus_test

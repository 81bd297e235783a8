// Affine maps commute with evaluation; maps that are exact in binary do so bit for bit. Nothing depends on
// the scale of the model, of the parameters or of the weights.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cmath>
#include <gtest/gtest.h>

namespace affine_test {

using namespace support;
using reference::eps;

namespace {

std::vector<double> times(std::vector<double> values, double factor) {
    for (double &x : values) {
        x *= factor;
    }
    return values;
}

SplineData random_data(Random &random) {
    const int axes = random.whole(1, 3);
    return random_spline(random, random_recipe(random, axes, axes == 1 ? 12 : 4));
}

TEST(Affine, powers_of_two_on_the_points) {
    for_each_case(100000, 800, [](Random &random, uint64_t seed) {
        const auto data = random_data(random);
        const auto params = away_from_underflow(random_params(random, data, 10));
        SplineData image = data;
        const double factor = std::ldexp(random.chance(50) ? 1 : -1, random.whole(-20, 20));
        image.points = times(data.points, factor);
        const auto g = create(data);
        const auto h = create(image);
        // -0 and 0 are one value here: a sum of cancelling terms is +0 for either sign of its terms.
        ASSERT_EQ(eval(h.get(), params), times(eval(g.get(), params), factor)) << where(seed, data);
        ASSERT_EQ(eval_derivs(h.get(), 2, params), times(eval_derivs(g.get(), 2, params), factor))
            << where(seed, data);
        ASSERT_EQ(hull_sizes(h.get(), params), times(hull_sizes(g.get(), params), std::fabs(factor)))
            << where(seed, data);
    });
}

TEST(Affine, powers_of_two_on_the_knots) {
    for_each_case(101000, 800, [](Random &random, uint64_t seed) {
        const auto data = random_data(random);
        const auto params = away_from_underflow(random_params(random, data, 10));
        SplineData image = data;
        const int power = random.whole(-30, 30);
        for (auto &knots : image.knots) {
            knots = times(knots, std::ldexp(1, power));
        }
        const auto g = create(data);
        const auto h = create(image);
        const auto moved = times(params, std::ldexp(1, power));
        ASSERT_TRUE(same_bits(eval(h.get(), moved), eval(g.get(), params))) << where(seed, data);
        const int order = 3;
        const auto before = eval_derivs(g.get(), order, params);
        const auto after = eval_derivs(h.get(), order, moved);
        const auto indices = graded_indices(data.axes(), order);
        const auto dim = static_cast<size_t>(data.dim);
        for (size_t i = 0; i < before.size(); ++i) {
            int k = 0;
            for (const int part : indices[i / dim % indices.size()]) {
                k += part;
            }
            ASSERT_EQ(after[i], std::ldexp(before[i], -power * k)) << where(seed, data) << "power " << power;
        }
    });
}

TEST(Affine, powers_of_two_on_all_weights) {
    for_each_case(102000, 800, [](Random &random, uint64_t seed) {
        const auto data = random_data(random);
        if (!data.rational()) {
            return;
        }
        const auto params = away_from_underflow(random_params(random, data, 10));
        SplineData image = data;
        image.weights = times(data.weights, std::ldexp(1, random.whole(-30, 30)));
        ASSERT_TRUE(same_bits(eval(create(image).get(), params), eval(create(data).get(), params)))
            << where(seed, data);
        ASSERT_TRUE(same_bits(eval_derivs(create(image).get(), 3, params),
                              eval_derivs(create(data).get(), 3, params)))
            << where(seed, data);
    });
}

// Any factor: both sides keep their promise, and the image's points are rounded once.
TEST(Affine, a_model_in_other_units) {
    for_each_case(103000, 800, [](Random &random, uint64_t seed) {
        const auto data = random_data(random);
        const auto params = away_from_underflow(random_params(random, data, 10));
        const double factor = random.chance(50) ? 1e-6 : 1e6;
        SplineData image = data;
        image.points = times(data.points, factor);
        const auto g = create(data);
        const auto before = eval(g.get(), params);
        const auto after = eval(create(image).get(), params);
        const auto hulls = hull_sizes(g.get(), params);
        const long double bound = (2 * reference::c_of(data) + 1) * eps;
        for (size_t i = 0; i < before.size(); ++i) {
            const long double difference = after[i] - static_cast<long double>(before[i]) * factor;
            ASSERT_LE(std::fabs(difference), bound * factor * hulls[i / static_cast<size_t>(data.dim)])
                << where(seed, data);
        }
    });
}

// A general affine map of space, applied to the control points and to the points of the spline.
TEST(Affine, maps_of_space_commute_with_evaluation) {
    for_each_case(104000, 800, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        recipe.dim = 3;
        const auto data = random_spline(random, recipe);
        const auto params = random_params(random, data, 8);
        double matrix[3][3];
        double shift[3];
        for (int r = 0; r < 3; ++r) {
            shift[r] = random.between(-1, 1);
            for (double &entry : matrix[r]) {
                entry = random.between(-1, 1);
            }
        }
        const auto image_of = [&](const std::vector<double> &points) {
            std::vector<double> images;
            for (size_t i = 0; i < points.size(); i += 3) {
                for (int r = 0; r < 3; ++r) {
                    const double *x = &points[i];
                    images.push_back(matrix[r][0] * x[0] + matrix[r][1] * x[1] + matrix[r][2] * x[2] +
                                     shift[r]);
                }
            }
            return images;
        };
        SplineData image = data;
        image.points = image_of(data.points);
        const auto g = create(data);
        const auto before = image_of(eval(g.get(), params));
        const auto after = eval(create(image).get(), params);
        const auto hulls = hull_sizes(g.get(), params);
        for (size_t i = 0; i < before.size(); ++i) {
            // |image| <= 3 hull + 1; the map itself rounds seven times on either side.
            const long double size = 3 * static_cast<long double>(hulls[i / 3]) + 1;
            ASSERT_LE(std::fabs(static_cast<long double>(before[i]) - after[i]),
                      (2 * reference::c_of(data) + 7) * eps * size)
                << where(seed, data);
        }
    });
}

} // namespace

} // namespace affine_test

// Affine and projective maps: every control point against its exact image, and maps that commute with
// evaluation.
#include "reference/magnitudes.h"
#include "reference/number.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace transform_test {

using namespace support;
using reference::eps;
using reference::exact;
using reference::Rational;

namespace {

std::vector<double> random_matrix(Random &random, int rows, int columns) {
    std::vector<double> matrix(static_cast<size_t>(rows * columns));
    for (double &entry : matrix) {
        entry = random.chance(20) ? 0 : random.between(-1, 1) * random.magnitude(1e-3, 1e3);
    }
    return matrix;
}

// Row `row` times x, exactly and in magnitudes.
struct Image {
    Rational value = 0;
    long double magnitude = 0;

    void add(const Rational &factor, const Rational &x) {
        value += factor * x;
        const Rational size = abs(Rational(factor * x));
        magnitude += reference::quotient(numerator(size), denominator(size));
    }
};

TEST(Transform, affine_images_are_exact_to_rounding) {
    WorstErrors worst("affine images by dimension, unit eps * magnitude");
    for_each_case(116000, 300, [&](Random &random, uint64_t seed) {
        auto recipe = random_recipe(random, random.whole(1, 3), 3);
        recipe.dim = random.whole(1, 4);
        const auto data = random_spline(random, recipe);
        const int out_dim = random.whole(1, 4);
        const auto matrix = random_matrix(random, out_dim, data.dim);
        const auto translation = random_matrix(random, out_dim, 1);
        const bool moved = random.chance(70);
        nurbs *out = nullptr;
        require_ok(nurbs_transform(create(data).get(), out_dim, matrix.data(),
                                   moved ? translation.data() : nullptr, &out));
        const Handle image(out);
        const auto got = read_back(image.get());
        ASSERT_EQ(got.dim, out_dim) << where(seed, data);
        ASSERT_EQ(got.flags, data.flags) << where(seed, data);
        ASSERT_TRUE(same_bits(got.all_knots(), data.all_knots())) << where(seed, data);
        ASSERT_TRUE(same_bits(got.weights, data.weights)) << where(seed, data);
        for (int64_t i = 0; i < data.point_count(); ++i) {
            for (int c = 0; c < out_dim; ++c) {
                Image want;
                for (int j = 0; j < data.dim; ++j) {
                    want.add(exact(matrix[static_cast<size_t>(c * data.dim + j)]),
                             exact(data.coordinate(i, j)));
                }
                if (moved) {
                    want.add(exact(translation[static_cast<size_t>(c)]), 1);
                }
                const long double unit = eps * want.magnitude;
                const long double error =
                    reference::error_ratio(got.coordinate(i, c), reference::fraction(want.value), unit);
                worst.add(data.dim, error / ((data.dim + 1) / 2.0L), error);
                ASSERT_LE(error, (data.dim + 1) / 2.0L) << where(seed, data);
            }
        }
    });
}

// Homogeneous control points are mapped as A (w x) + w b and keep their weights, of either sign.
TEST(Transform, homogeneous_points_keep_their_weights) {
    for_each_case(119000, 300, [](Random &random, uint64_t seed) {
        auto recipe = random_recipe(random, random.whole(1, 2), 3);
        recipe.dim = 3;
        recipe.weights = Weights::none;
        const auto data = random_spline(random, recipe);
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_from_homogeneous(create(data).get(), &out);
        const Handle g(out);
        if (status == NURBS_ERROR_WEIGHTS_VANISH) {
            return; // zeros in a row
        }
        require_ok(status);
        const std::vector<double> matrix = {0, 2, 4, 0};
        const std::vector<double> translation = {1, -8};
        require_ok(nurbs_transform(g.get(), 2, matrix.data(), translation.data(), &out));
        const Handle image(out);
        const auto got = homogeneous_points(image.get());
        for (size_t i = 0; i < got.size(); i += 3) {
            const double x = data.points[i];
            const double y = data.points[i + 1];
            const double w = data.points[i + 2];
            ASSERT_EQ(got[i], 2 * y + w) << where(seed, data);
            ASSERT_EQ(got[i + 1], 4 * x - 8 * w) << where(seed, data);
            ASSERT_TRUE(same_bits(got[i + 2], w)) << where(seed, data);
        }
    });
}

// Components of h' against the exact ones: one rounding for each product w x and each term, and with all
// weights of one sign a division and a product more, where nurbs_homogeneous_points() multiplies again.
TEST(Transform, projective_images_are_exact_to_rounding) {
    WorstErrors worst("projective images by dimension, unit eps * magnitude");
    for_each_case(117000, 300, [&](Random &random, uint64_t seed) {
        auto recipe = random_recipe(random, random.whole(1, 3), 3);
        recipe.dim = random.whole(1, 4);
        const auto data = random_spline(random, recipe);
        const int out_dim = random.whole(1, 4);
        const auto matrix = random_matrix(random, out_dim + 1, data.dim + 1);
        nurbs *out = nullptr;
        const nurbs_status status =
            nurbs_transform_projective(create(data).get(), out_dim, matrix.data(), &out);
        const Handle image(out);
        if (status == NURBS_ERROR_WEIGHTS_VANISH) {
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        const auto got = homogeneous_points(image.get());
        const auto width = static_cast<size_t>(out_dim) + 1;
        double sign = 0; // of all records, where the library has turned them round
        for (int64_t i = 0; i < data.point_count(); ++i) {
            for (size_t c = width; c-- > 0;) {
                Image want;
                for (int j = 0; j <= data.dim; ++j) {
                    const Rational x = j < data.dim ? exact(data.coordinate(i, j)) : Rational(1);
                    want.add(exact(matrix[c * static_cast<size_t>(data.dim + 1) + static_cast<size_t>(j)]),
                             exact(data.weight(i)) * x);
                }
                const double value = got[static_cast<size_t>(i) * width + c];
                if (sign == 0 && c + 1 == width && want.value != 0) {
                    sign = (want.value < 0) == (value < 0) ? 1 : -1;
                }
                const long double error = reference::error_ratio(
                    sign == -1 ? -value : value, reference::fraction(want.value), eps * want.magnitude);
                worst.add(data.dim, error / ((data.dim + 4) / 2.0L), error);
                ASSERT_LE(error, (data.dim + 4) / 2.0L) << where(seed, data) << " point " << i;
            }
        }
    });
}

// A map that rounds nothing: only the two evaluations err.
TEST(Transform, commutes_with_evaluation) {
    for_each_case(118000, 300, [](Random &random, uint64_t seed) {
        auto recipe = random_recipe(random, random.whole(1, 3), 3);
        recipe.dim = 3;
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        // (x, y, z) -> (y / 2, x / 2, 2 z) with a weight of 2.
        const std::vector<double> swap = {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 2};
        nurbs *out = nullptr;
        require_ok(nurbs_transform_projective(g.get(), 3, swap.data(), &out));
        const Handle image(out);
        const auto params = random_params(random, data, 6);
        const auto before = eval(g.get(), params);
        const auto after = eval(image.get(), params);
        const auto hulls = hull_sizes(g.get(), params);
        const long double bound = (data.rational() ? 8 : 2) * reference::c_of(data) * eps + 2 * eps;
        for (size_t i = 0; i < hulls.size(); ++i) {
            for (size_t c = 0; c < 3; ++c) {
                const long double want = c == 2 ? 2.0L * before[3 * i + 2] : before[3 * i + 1 - c] / 2.0L;
                ASSERT_LE(std::fabs(want - after[3 * i + c]), 2 * bound * hulls[i]) << where(seed, data);
            }
        }
    });
}

} // namespace

} // namespace transform_test

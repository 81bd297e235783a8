// Bernstein polynomials: accuracy, sums, symmetry, and where each is largest.
#include "reference/exact_basis.h"
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cfloat>
#include <cmath>
#include <gtest/gtest.h>

namespace bernstein_test {

using namespace support;
using reference::eps;

namespace {

std::vector<double> bernstein(int degree, int order, const std::vector<double> &params) {
    std::vector<double> values(params.size() * static_cast<size_t>((order + 1) * (degree + 1)));
    require_ok(nurbs_bernstein(degree, order, static_cast<int64_t>(params.size()), params.data(), 0,
                               values.data(), 0, 0));
    return values;
}

std::vector<double> bezier_knots(int degree) {
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0);
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, 1);
    return knots;
}

std::vector<double> unit_params(Random &random) {
    std::vector<double> params = {0, 1, 0.5, 0x1p-60, std::nextafter(1.0, 0.0), 1e-9, 1 - 1e-9};
    for (int i = 0; i < 8; ++i) {
        params.push_back(random.unit());
    }
    return params;
}

// Rounded 1 - t, p factors, a binomial: at most p + 1 eps relative whichever way the product is formed.
TEST(Bernstein, values_are_accurate_each_by_itself) {
    WorstErrors worst("Bernstein polynomials by degree, unit eps * B");
    Random random(50000);
    for (int degree = 0; degree <= NURBS_MAX_DEGREE; ++degree) {
        const auto params = unit_params(random);
        const auto values = bernstein(degree, 0, params);
        auto value = values.begin();
        for (const double t : params) {
            const auto want = reference::exact_basis(bezier_knots(degree), degree, t, 0);
            long double sum = -1;
            for (const auto &numerator : want.numerators[0]) {
                ASSERT_GE(*value, 0);
                const long double size = reference::quotient(numerator, want.denominator);
                const long double error =
                    reference::error_ratio(*value, {numerator, want.denominator}, eps * size + DBL_MIN * eps);
                worst.add(degree, error / (degree + 1), error);
                ASSERT_LE(error, degree + 1) << "degree " << degree << " at " << hex(t);
                sum += *value++;
            }
            ASSERT_LE(std::fabs(sum), reference::c_of(degree) * eps)
                << "degree " << degree << " at " << hex(t);
        }
    }
}

// All derivatives of sum B_j = 1 vanish; the bound is that of a curve with all control points 1.
TEST(Bernstein, derivatives_are_accurate_and_sum_to_zero) {
    Random random(51000);
    for (int degree = 0; degree <= 12; ++degree) {
        const int order = 4;
        const auto params = unit_params(random);
        const auto values = bernstein(degree, order, params);
        auto value = values.begin();
        for (const double t : params) {
            const auto want = reference::exact_basis(bezier_knots(degree), degree, t, order);
            for (int k = 0; k <= order; ++k) {
                long double size =
                    k > degree ? 0 : 1; // 2^k p! / (p - k)!: the magnitudes of all functions together
                for (int i = 0; i < std::min(k, degree); ++i) {
                    size *= 2 * (degree - i);
                }
                const long double bound = 2 * (reference::c_of(degree) + 2 * k) * eps * size;
                long double sum = k == 0 ? -1 : 0;
                for (const auto &numerator : want.numerators[static_cast<size_t>(k)]) {
                    ASSERT_LE(reference::error_ratio(*value, {numerator, want.denominator}, bound + DBL_MIN),
                              1)
                        << "degree " << degree << " derivative " << k << " at " << hex(t);
                    sum += *value++;
                }
                ASSERT_LE(std::fabs(sum), bound)
                    << "degree " << degree << " derivative " << k << " at " << hex(t);
            }
        }
    }
}

TEST(Bernstein, function_k_of_degree_n_is_largest_at_k_over_n) {
    for (int n = 1; n <= NURBS_MAX_DEGREE; ++n) {
        for (int k = 0; k <= n; ++k) {
            std::vector<double> params = {static_cast<double>(k) / n};
            for (int i = 0; i <= 400; ++i) {
                params.push_back(i / 400.0);
            }
            const auto values = bernstein(n, 0, params);
            const auto width = static_cast<size_t>(n) + 1;
            const auto column = static_cast<size_t>(k);
            // Two values with a relative error of n + 1 eps each.
            const double limit = values[column] * (1 + 2 * (n + 1) * DBL_EPSILON);
            for (size_t i = 1; i < params.size(); ++i) {
                ASSERT_LE(values[i * width + column], limit) << n << " " << k << " at " << params[i];
                if (std::fabs(params[i] - params[0]) > 0.01) {
                    ASSERT_LT(values[i * width + column], values[column])
                        << n << " " << k << " at " << params[i];
                }
            }
        }
    }
}

// Outside [0, 1] the polynomials go on; sizes are those of the terms.
TEST(Bernstein, any_finite_parameter) {
    for (int degree = 0; degree <= 8; ++degree) {
        for (const double t : {-3.0, -0.25, 1.5, 7.0}) {
            const auto values = bernstein(degree, 1, {t});
            const auto want = reference::exact_basis(bezier_knots(degree), degree, t, 1);
            for (size_t j = 0; j <= static_cast<size_t>(degree); ++j) {
                // Small dyadic numbers: every operation is exact.
                ASSERT_EQ(values[j], reference::nearest({want.numerators[0][j], want.denominator}));
                ASSERT_EQ(values[static_cast<size_t>(degree) + 1 + j],
                          reference::nearest({want.numerators[1][j], want.denominator}));
            }
        }
    }
}

} // namespace

} // namespace bernstein_test

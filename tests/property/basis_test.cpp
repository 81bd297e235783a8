// B-spline and rational basis functions: spans, componentwise accuracy, signs, sums.
#include "reference/exact_basis.h"
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cfloat>
#include <gtest/gtest.h>

namespace basis_test {

using namespace support;
using reference::eps;

namespace {

struct Basis {
    std::vector<int64_t> spans;
    std::vector<double> values; // [n][order + 1][degree + 1]
};

Basis library_basis(const std::vector<double> &knots, int degree, int order,
                    const std::vector<double> &params, uint32_t flags = 0) {
    Basis basis;
    basis.spans.resize(params.size());
    basis.values.resize(params.size() * static_cast<size_t>((order + 1) * (degree + 1)));
    const auto knot_count = static_cast<int64_t>(knots.size());
    require_ok(nurbs_basis(degree, knot_count - degree - 1, knots.data(), knot_count, order,
                           static_cast<int64_t>(params.size()), params.data(), 0, basis.spans.data(),
                           basis.values.data(), 0, 0, flags));
    return basis;
}

std::vector<double> axis_params(Random &random, const std::vector<double> &knots, int degree, int n) {
    std::vector<double> params;
    for (int i = 0; i < n; ++i) {
        params.push_back(random_param(random, knots, degree));
    }
    return params;
}

std::string place(uint64_t seed, const std::vector<double> &knots, int degree, double t) {
    return "\nseed " + std::to_string(seed) + " degree " + std::to_string(degree) + " knots " + hex(knots) +
           " at " + hex(t);
}

int some_degree(Random &random) {
    return random.chance(10) ? random.whole(16, 31) : random.whole(0, 15);
}

TEST(Basis, spans_contain_their_parameters) {
    for_each_case(40000, 1500, [](Random &random, uint64_t seed) {
        const int degree = some_degree(random);
        const auto knots = random_knots(random, random_axis(random, degree));
        const auto params = axis_params(random, knots, degree, 30);
        const auto knot_count = static_cast<int64_t>(knots.size());
        for (const bool left : {false, true}) {
            std::vector<int64_t> spans(params.size());
            require_ok(nurbs_find_spans(degree, knot_count - degree - 1, knots.data(), knot_count,
                                        static_cast<int64_t>(params.size()), params.data(), 0, spans.data(),
                                        left ? NURBS_LEFT : 0U));
            const auto basis = library_basis(knots, degree, 0, params, left ? NURBS_LEFT : 0U);
            for (size_t i = 0; i < params.size(); ++i) {
                const int64_t want = reference::exact_span(knots, degree, params[i], left);
                ASSERT_EQ(spans[i], want) << place(seed, knots, degree, params[i]) << " left " << left;
                ASSERT_EQ(basis.spans[i], want) << place(seed, knots, degree, params[i]) << " left " << left;
            }
        }
    });
}

// Each level of the recurrence rounds five times (two differences, a quotient, a product, a sum), all terms
// being positive: every function keeps a relative error of 5 p / 2 eps, to first order. Below the normal
// range the error is absolute.
TEST(Basis, every_function_is_accurate_by_itself) {
    WorstErrors worst("basis functions by degree, unit eps * N");
    for_each_case(41000, 1500, [&](Random &random, uint64_t seed) {
        const int degree = some_degree(random);
        const auto knots = random_knots(random, random_axis(random, degree));
        const auto params = axis_params(random, knots, degree, 8);
        const auto basis = library_basis(knots, degree, 0, params);
        auto value = basis.values.begin();
        for (const double t : params) {
            const auto want = reference::exact_basis(knots, degree, t, 0);
            const long double bound = (2.5L * degree + 0.1L) * eps;
            long double sum = -1;
            for (const auto &numerator : want.numerators[0]) {
                ASSERT_GE(*value, 0) << place(seed, knots, degree, t);
                const long double size = reference::quotient(numerator, want.denominator);
                const long double error =
                    reference::error_ratio(*value, {numerator, want.denominator}, eps * size + DBL_MIN * eps);
                worst.add(degree, error / (bound / eps), error);
                ASSERT_LE(error * (eps * size + DBL_MIN * eps), bound * size + (degree + 1) * DBL_MIN * eps)
                    << place(seed, knots, degree, t) << " error " << static_cast<double>(error) << " eps";
                sum += *value++;
            }
            ASSERT_LE(std::fabs(sum), reference::c_of(degree) * eps) << place(seed, knots, degree, t);
        }
    });
}

// The curve whose control points are the unit vectors: its coordinates are the basis functions, and its
// bounds theirs.
SplineData unit_vectors(const std::vector<double> &knots, int degree) {
    const auto count = static_cast<int64_t>(knots.size()) - degree - 1;
    SplineData data = {{degree}, {count}, {knots}, static_cast<int32_t>(count), {}, {}, 0};
    data.points.assign(static_cast<size_t>(count * count), 0);
    for (int64_t i = 0; i < count; ++i) {
        data.points[static_cast<size_t>(i * count + i)] = 1;
    }
    return data;
}

TEST(Basis, derivatives_are_accurate_and_cancel) {
    for_each_case(42000, 800, [](Random &random, uint64_t seed) {
        const int degree = random.whole(0, 12);
        const auto knots = random_knots(random, random_axis(random, degree));
        const auto params = away_from_underflow(axis_params(random, knots, degree, 3));
        const int order = 4;
        const auto basis = library_basis(knots, degree, order, params);
        const auto data = unit_vectors(knots, degree);
        auto value = basis.values.begin();
        for (size_t i = 0; i < params.size(); ++i) {
            const auto want = reference::exact_derivatives(data, order, &params[i]);
            const auto sizes = reference::magnitudes(data, order, &params[i]);
            for (int k = 0; k <= order; ++k) {
                const auto slot = static_cast<size_t>(k);
                const long double factor = 2 * (reference::c_of(degree) + 2 * k) * eps;
                long double sum = k == 0 ? -1 : 0;
                long double size = 0;
                for (int j = 0; j <= degree; ++j) {
                    const auto c = static_cast<size_t>(basis.spans[i] - degree + j);
                    ASSERT_LE(reference::error_ratio(*value, want[slot][c],
                                                     factor * sizes[slot][c] + (degree + 1) * DBL_MIN * eps),
                              1)
                        << place(seed, knots, degree, params[i]) << " derivative " << k << " of function "
                        << j << " is " << hex(*value) << " in place of "
                        << hex(reference::nearest(want[slot][c]));
                    size += sizes[slot][c];
                    sum += *value++;
                }
                ASSERT_LE(std::fabs(sum), factor * size) << place(seed, knots, degree, params[i]);
            }
        }
    });
}

// R_i is the curve whose points are the unit vectors, rational: bound c * eps with hull 1; the sum has all M
// errors.
TEST(Basis, rational_functions_are_accurate_and_sum_to_one) {
    for_each_case(43000, 800, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 2), 5);
        recipe.dim = 1;
        auto data = random_spline(random, recipe);
        const auto g = create(data);
        const auto params = random_params(random, data, 4);
        const auto values = rational_basis(g.get(), params);
        const long double c = reference::c_of(data);
        auto value = values.begin();
        for (size_t i = 0; i < params.size(); i += data.degrees.size()) {
            const auto active = reference::active_points(data, reference::first_active(data, &params[i]));
            long double sum = 0;
            for (const int64_t one : active) {
                SplineData indicator = data;
                indicator.points.assign(data.points.size(), 0);
                indicator.points[static_cast<size_t>(one)] = 1;
                const auto want = reference::exact_point(indicator, &params[i])[0];
                ASSERT_GE(*value, 0) << where(seed, data);
                ASSERT_LE(reference::error_ratio(*value, want, c * eps), 1)
                    << where(seed, data) << "point " << one << " at " << hex(params[i]);
                sum += *value++;
            }
            // Errors of the functions are relative: numerator and denominator c each, the division half a
            // unit.
            ASSERT_LE(std::fabs(sum - 1), (2 * c + 1) * eps) << where(seed, data);
        }
    });
}

} // namespace

} // namespace basis_test

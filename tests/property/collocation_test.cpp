// Collocation matrices: the exact basis functions and their derivatives, in the rows and columns they belong
// to, and the matrix times the points.
#include "reference/exact_basis.h"
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cfloat>
#include <gtest/gtest.h>
#include <numeric>

namespace collocation_test {

using namespace support;
using reference::eps;

namespace {

struct Matrix {
    std::vector<double> values;
    std::vector<int64_t> columns;
    std::vector<int64_t> row_pointers;
};

int64_t rows_of(const SplineData &data, const std::vector<double> &params) {
    return static_cast<int64_t>(params.size()) / data.axes();
}

template <class Call>
Matrix filled(int64_t n, Call &&call) {
    int64_t entries = -1;
    require_ok(call(0, nullptr, nullptr, nullptr, &entries));
    const auto size = static_cast<size_t>(entries);
    Matrix m{std::vector<double>(size), std::vector<int64_t>(size),
             std::vector<int64_t>(static_cast<size_t>(n) + 1)};
    require_ok(call(entries, m.values.data(), m.columns.data(), m.row_pointers.data(), nullptr));
    return m;
}

Matrix basis_matrix(const SplineData &data, const std::vector<int32_t> &orders,
                    const std::vector<double> &params, uint32_t flags = 0) {
    const auto knots = data.all_knots();
    const int64_t n = rows_of(data, params);
    return filled(n, [&](int64_t cap, double *values, int64_t *columns, int64_t *rows, int64_t *entries) {
        return nurbs_collocation(data.axes(), data.degrees.data(), data.counts.data(), knots.data(),
                                 static_cast<int64_t>(knots.size()), orders.data(), n, params.data(), 0, 0,
                                 cap, values, columns, rows, entries, flags);
    });
}

Matrix rational_matrix(const SplineData &data, const std::vector<int32_t> &orders,
                       const std::vector<double> &params, uint32_t flags = 0) {
    const auto g = create(data);
    const int64_t n = rows_of(data, params);
    return filled(n, [&](int64_t cap, double *values, int64_t *columns, int64_t *rows, int64_t *entries) {
        return nurbs_rational_collocation(g.get(), orders.data(), n, params.data(), 0, 0, cap, values,
                                          columns, rows, entries, flags);
    });
}

std::vector<int32_t> random_orders(Random &random, int axes, int highest) {
    std::vector<int32_t> orders;
    for (int k = 0; k < axes; ++k) {
        orders.push_back(random.chance(40) ? 0 : random.whole(0, highest));
    }
    return orders;
}

Recipe small_recipe(Random &random, int max_degree) {
    const int axes = random.whole(1, 3);
    Recipe recipe = random_recipe(random, axes, axes == 3 ? std::min(max_degree, 3) : max_degree);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = std::min(axis.spans, axes == 3 ? 2 : 4);
    }
    return recipe;
}

void check_structure(const Matrix &m, const SplineData &data, const std::vector<double> &params,
                     const std::string &what) {
    const auto axes = data.degrees.size();
    const auto n = static_cast<size_t>(rows_of(data, params));
    for (size_t i = 0; i < n; ++i) {
        const double *param = params.data() + i * axes;
        const auto active = reference::active_points(data, reference::first_active(data, param));
        ASSERT_EQ(m.row_pointers[i], static_cast<int64_t>(i * active.size())) << what;
        const auto row = m.columns.begin() + m.row_pointers[i];
        ASSERT_TRUE(std::equal(active.begin(), active.end(), row)) << what << " row " << i;
    }
    ASSERT_EQ(m.row_pointers[n], static_cast<int64_t>(m.values.size())) << what;
}

// The curve whose points are the unit vectors: its coordinates are the basis functions of an axis.
SplineData unit_vectors(const SplineData &data, size_t axis) {
    const int64_t count = data.counts[axis];
    SplineData unit = {
        {data.degrees[axis]}, {count}, {data.knots[axis]}, static_cast<int32_t>(count), {}, {}, 0};
    unit.points.assign(static_cast<size_t>(count * count), 0);
    for (int64_t i = 0; i < count; ++i) {
        unit.points[static_cast<size_t>(i * count + i)] = 1;
    }
    return unit;
}

// Derivatives of the functions of one axis at one parameter, and their magnitudes by the preamble.
struct AxisValues {
    std::vector<reference::Fraction> exact;
    std::vector<long double> sizes;
};

AxisValues axis_values(const SplineData &data, size_t axis, int order, double t) {
    const SplineData unit = unit_vectors(data, axis);
    return {reference::exact_derivatives(unit, order, &t).back(),
            reference::magnitudes(unit, order, &t).back()};
}

// The factor of eps in the bound: relative at order 0, of a derivative otherwise.
long double factor(const SplineData &data, const std::vector<int32_t> &orders) {
    long double sum = 1;
    for (size_t k = 0; k < orders.size(); ++k) {
        const long double c = reference::c_of(data.degrees[k]);
        sum += orders[k] == 0 ? 3.0L * data.degrees[k] : 2 * (c + 2 * orders[k]);
    }
    return sum;
}

TEST(Collocation, rows_hold_the_exact_basis_functions) {
    WorstErrors worst("collocation by total order, unit eps * H");
    for_each_case(92000000, 2000, [&](Random &random, uint64_t seed) {
        const auto data = random_spline(random, small_recipe(random, 5));
        const auto orders = random_orders(random, data.axes(), 3);
        const auto params = away_from_underflow(random_params(random, data, 3));
        const Matrix m = basis_matrix(data, orders, params);
        check_structure(m, data, params, where(seed, data));
        const int total = std::accumulate(orders.begin(), orders.end(), 0);
        for (size_t i = 0; i + 1 < m.row_pointers.size(); ++i) {
            std::vector<AxisValues> axes;
            for (size_t k = 0; k < orders.size(); ++k) {
                axes.push_back(axis_values(data, k, orders[k], params[i * orders.size() + k]));
            }
            for (int64_t e = m.row_pointers[i]; e < m.row_pointers[i + 1]; ++e) {
                reference::Fraction want{1, 1};
                long double size = 1;
                int64_t rest = m.columns[static_cast<size_t>(e)];
                for (size_t k = orders.size(); k-- > 0; rest /= data.counts[k]) {
                    const auto at = static_cast<size_t>(rest % data.counts[k]);
                    want.numerator *= axes[k].exact[at].numerator;
                    want.denominator *= axes[k].exact[at].denominator;
                    size *= axes[k].sizes[at];
                }
                const double value = m.values[static_cast<size_t>(e)];
                const long double error = reference::error_ratio(value, want, eps * size + DBL_MIN);
                worst.add(total, error / factor(data, orders), error);
                ASSERT_LE(error, factor(data, orders))
                    << where(seed, data) << " row " << i << " is " << hex(value);
            }
        }
    });
}

// R_j is the spline with the point 1 at j and 0 elsewhere.
TEST(Collocation, rows_hold_the_exact_rational_functions) {
    WorstErrors worst("rational collocation by total order, unit eps * E");
    for_each_case(93000000, 1200, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 2), 4);
        recipe.dim = 1;
        recipe.weights = random.chance(50) ? Weights::moderate : Weights::extreme;
        const auto data = random_spline(random, recipe);
        const auto orders = random_orders(random, data.axes(), 2);
        const auto params = away_from_underflow(random_params(random, data, 2));
        const Matrix m = rational_matrix(data, orders, params);
        check_structure(m, data, params, where(seed, data));
        const int total = std::accumulate(orders.begin(), orders.end(), 0);
        const auto slot = static_cast<size_t>(slot_of({orders.begin(), orders.end()}));
        const long double bound = 2 * (reference::c_of(data) + 2 * total);
        for (size_t i = 0; i + 1 < m.row_pointers.size(); ++i) {
            const double *param = params.data() + i * orders.size();
            for (auto e = static_cast<size_t>(m.row_pointers[i]);
                 e < static_cast<size_t>(m.row_pointers[i + 1]); ++e) {
                SplineData one = data;
                one.points.assign(data.points.size(), 0);
                one.points[static_cast<size_t>(m.columns[e])] = 1;
                const auto want = reference::exact_derivatives(one, total, param)[slot][0];
                const long double size = reference::magnitudes(one, total, param)[slot][0];
                const long double error = reference::error_ratio(m.values[e], want, eps * size + DBL_MIN);
                worst.add(total, error / bound, error);
                ASSERT_LE(error, bound) << where(seed, data) << " at " << hex({param, param + data.axes()})
                                        << " is " << hex(m.values[e]);
            }
        }
    });
}

// Both sides are within their bounds of the exact value, and the sum of M products adds M roundings.
TEST(Collocation, matrix_times_points_is_evaluation) {
    for_each_case(94000000, 2000, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, small_recipe(random, 5));
        const auto orders = random_orders(random, data.axes(), 2);
        const auto params = away_from_underflow(random_params(random, data, 5));
        const Matrix m = rational_matrix(data, orders, params);
        const int total = std::accumulate(orders.begin(), orders.end(), 0);
        const auto derivs = eval_derivs(create(data).get(), total, params);
        const auto slot = static_cast<size_t>(slot_of({orders.begin(), orders.end()}));
        const auto dim = static_cast<size_t>(data.dim);
        const auto n = static_cast<size_t>(rows_of(data, params));
        for (size_t i = 0; i < n; ++i) {
            const auto size = reference::magnitudes(data, total, params.data() + i * orders.size(),
                                                    reference::Terms::stored)[slot];
            for (size_t c = 0; c < dim; ++c) {
                long double sum = 0;
                for (auto e = static_cast<size_t>(m.row_pointers[i]);
                     e < static_cast<size_t>(m.row_pointers[i + 1]); ++e) {
                    sum += static_cast<long double>(m.values[e]) *
                           data.coordinate(m.columns[e], static_cast<int>(c));
                }
                const long double got = derivs[i * derivs.size() / n + slot * dim + c];
                const long double bound = 4 * (reference::c_of(data) + 2 * total + 1) * eps * size[c];
                ASSERT_LE(std::fabs(sum - got), bound + DBL_MIN) << where(seed, data) << " row " << i;
            }
        }
    });
}

TEST(Collocation, order_zero_has_the_bits_of_the_bases) {
    for_each_case(95000000, 300, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, small_recipe(random, 5));
        const auto params = random_params(random, data, 6);
        const std::vector<int32_t> zero(data.degrees.size(), 0);
        const Matrix m = rational_matrix(data, zero, params);
        ASSERT_TRUE(same_bits(m.values, rational_basis(create(data).get(), params))) << where(seed, data);
        if (!data.rational()) {
            ASSERT_TRUE(same_bits(basis_matrix(data, zero, params).values, m.values)) << where(seed, data);
        }
        SplineData plain = data;
        plain.weights.clear();
        const auto orders = random_orders(random, data.axes(), 3);
        ASSERT_TRUE(same_bits(basis_matrix(data, orders, params, 0).values,
                              rational_matrix(plain, orders, params, 0).values))
            << where(seed, data);
    });
}

} // namespace

} // namespace collocation_test

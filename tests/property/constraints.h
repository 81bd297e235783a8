// Sets of constraints, and exact derivatives.
#pragma once

#include "property/influences.h"
#include "reference/float50.h"

namespace support::constraints {

using Real = reference::Float50;
using Row = std::vector<Real>;

inline Real real(const Rational &x) {
    return Real(numerator(x)) / Real(denominator(x));
}

// x of a square system, by elimination with row pivots.
inline std::vector<Row> solved(std::vector<Row> a, std::vector<Row> b) {
    const size_t n = a.size();
    for (size_t k = 0; k < n; ++k) {
        size_t best = k;
        for (size_t i = k + 1; i < n; ++i) {
            best = abs(a[i][k]) > abs(a[best][k]) ? i : best;
        }
        std::swap(a[k], a[best]);
        std::swap(b[k], b[best]);
        for (size_t i = k + 1; i < n; ++i) {
            const Real factor = a[i][k] / a[k][k];
            for (size_t j = k; factor != 0 && j < n; ++j) {
                a[i][j] -= factor * a[k][j];
            }
            for (size_t j = 0; factor != 0 && j < b[i].size(); ++j) {
                b[i][j] -= factor * b[k][j];
            }
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t c = 0; c < b[k].size(); ++c) {
            for (size_t j = k + 1; j < n; ++j) {
                b[k][c] -= a[k][j] * b[j][c];
            }
            b[k][c] /= a[k][k];
        }
    }
    return b;
}

// Arguments of a call, by constraints.
struct Set {
    std::vector<int32_t> kinds;
    std::vector<int32_t> orders;
    std::vector<double> params;
    std::vector<double> targets;
    std::vector<int32_t> keep;
    std::vector<double> costs;
    std::vector<double> weight_costs;
    double tolerance = 0;

    [[nodiscard]] int64_t count() const { return std::ssize(kinds); }
};

struct Result {
    nurbs_status status = NURBS_OK;
    Handle g;
    std::vector<double> residuals;
    int64_t rank = -1;
    double moved = -1;
    double optimality = -1;
};

inline Result constrain(const nurbs *g, const Set &set) {
    Result result;
    result.residuals.resize(set.kinds.size());
    nurbs *out = nullptr;
    const auto given = [](const auto &values) { return values.empty() ? nullptr : values.data(); };
    result.status = nurbs_constrain(g, set.count(), set.kinds.data(), given(set.orders), set.params.data(),
                                    set.targets.data(), given(set.keep), given(set.costs),
                                    given(set.weight_costs), set.tolerance, result.residuals.data(),
                                    &result.rank, &result.moved, &result.optimality, &out);
    result.g.reset(out);
    return result;
}

// Enough control points for the constraints, of moderate weights.
inline SplineData roomy(Random &random, int axes, int points, bool periodic) {
    Recipe recipe;
    recipe.dim = random.whole(1, 3);
    recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
    for (int k = 0; k < axes; ++k) {
        AxisRecipe axis = random_axis(random, random.whole(1, axes == 1 ? 5 : 3));
        axis.form = periodic && k == 0  ? KnotForm::periodic
                    : random.chance(70) ? KnotForm::clamped
                                        : KnotForm::unclamped;
        axis.spacing = Spacing::integers;
        axis.placement = Placement::origin;
        axis.spans = axes == 1 ? 2 * points : 8;
        recipe.axes.push_back(axis);
    }
    return random_spline(random, recipe);
}

// Points spread over the domain so that neighbours share few control points.
inline Set value_set(Random &random, const SplineData &data, int count) {
    Set set;
    for (int i = 0; i < count; ++i) {
        set.kinds.push_back(NURBS_CONSTRAIN_VALUE);
        for (int k = 0; k < data.axes(); ++k) {
            const double part = data.axes() == 1 ? (i + random.between(0.3, 0.7)) / count : random.unit();
            set.params.push_back(data.lower(k) + part * (data.upper(k) - data.lower(k)));
        }
        for (int c = 0; c < data.dim; ++c) {
            set.targets.push_back(random.between(-1, 1) * extent(data));
        }
    }
    return set;
}

inline std::vector<double> param_of(const Set &set, const SplineData &data, int64_t i) {
    const auto at = set.params.begin() + i * data.axes();
    return {at, at + data.axes()};
}

inline Point target_of(const Set &set, const SplineData &data, int64_t i) {
    Point target;
    for (int c = 0; c < data.dim; ++c) {
        target.push_back(exact(set.targets[static_cast<size_t>(i * data.dim + c)]));
    }
    return target;
}

// R_i at a parameter, over the first copies.
inline Row exact_row(const SplineData &data, const std::vector<double> &param) {
    const auto all = exact_influences(data, param);
    const Rational total = total_weight(all);
    Row row(static_cast<size_t>(data.point_count()));
    for (const auto &[point, influence] : all) {
        row[static_cast<size_t>(point)] = real(Rational(influence.weight / total));
    }
    return row;
}

inline void expect_met(const SplineData &data, const Set &set, const Result &result, double bound,
                       const std::string &place) {
    const SplineData after = read_back(result.g.get());
    for (int64_t i = 0; i < set.count(); ++i) {
        const Point missed = minus(point_at(after, param_of(set, data, i)), target_of(set, data, i));
        ASSERT_LE(length(missed), bound * std::max(extent(data), extent(after)))
            << place << " constraint " << i;
    }
}

inline Point derivative_at(const SplineData &data, const std::vector<double> &param,
                           const std::vector<int> &index) {
    int order = 0;
    for (const int k : index) {
        order += k;
    }
    const auto derivatives = reference::exact_derivatives(data, order, param.data());
    Point point;
    for (const reference::Fraction &x : derivatives[static_cast<size_t>(slot_of(index))]) {
        point.emplace_back(x.numerator, x.denominator);
    }
    return point;
}

inline Rational dot(const Point &a, const Point &b) {
    Rational sum = 0;
    for (size_t c = 0; c < a.size(); ++c) {
        sum += a[c] * b[c];
    }
    return sum;
}

} // namespace support::constraints

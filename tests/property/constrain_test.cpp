// Constraints: they hold, and the change is the smallest one, that of the Kuhn-Tucker equations solved in
// high precision.
#include "property/influences.h"
#include "reference/float50.h"

using namespace support;

namespace {

using Real = reference::Float50;
using Row = std::vector<Real>;

Real real(const Rational &x) {
    return Real(numerator(x)) / Real(denominator(x));
}

// x of a square system, by elimination with row pivots.
std::vector<Row> solved(std::vector<Row> a, std::vector<Row> b) {
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

// The e that makes sum costs |e|^2 least with A e = r: by the multipliers, costs e = A^T lambda, A costs^-1
// A^T lambda = r.
std::vector<Row> least_change(const std::vector<Row> &rows, const std::vector<Row> &right, const Row &costs) {
    std::vector<Row> gram(rows.size(), Row(rows.size()));
    for (size_t i = 0; i < rows.size(); ++i) {
        for (size_t j = 0; j <= i; ++j) {
            for (size_t k = 0; k < costs.size(); ++k) {
                if (rows[i][k] != 0 && rows[j][k] != 0) {
                    gram[i][j] += rows[i][k] * rows[j][k] / costs[k];
                }
            }
            gram[j][i] = gram[i][j];
        }
    }
    const std::vector<Row> multipliers = solved(gram, right);
    std::vector<Row> change(costs.size(), Row(right[0].size()));
    for (size_t i = 0; i < rows.size(); ++i) {
        for (size_t k = 0; k < costs.size(); ++k) {
            for (size_t c = 0; rows[i][k] != 0 && c < right[i].size(); ++c) {
                change[k][c] += rows[i][k] * multipliers[i][c] / costs[k];
            }
        }
    }
    return change;
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

Result constrain(const nurbs *g, const Set &set) {
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

double uniform_cost(Random &random) {
    return random.chance(20) ? HUGE_VAL : random.magnitude(0.1, 10);
}

// Enough control points for the constraints, of moderate weights.
SplineData roomy(Random &random, int axes, int points, bool periodic) {
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
Set value_set(Random &random, const SplineData &data, int count) {
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

std::vector<double> param_of(const Set &set, const SplineData &data, int64_t i) {
    const auto at = set.params.begin() + i * data.axes();
    return {at, at + data.axes()};
}

Point target_of(const Set &set, const SplineData &data, int64_t i) {
    Point target;
    for (int c = 0; c < data.dim; ++c) {
        target.push_back(exact(set.targets[static_cast<size_t>(i * data.dim + c)]));
    }
    return target;
}

// R_i at a parameter, over the first copies.
Row exact_row(const SplineData &data, const std::vector<double> &param) {
    const auto all = exact_influences(data, param);
    const Rational total = total_weight(all);
    Row row(static_cast<size_t>(data.point_count()));
    for (const auto &[point, influence] : all) {
        row[static_cast<size_t>(point)] = real(Rational(influence.weight / total));
    }
    return row;
}

void expect_least_change(const SplineData &data, const Set &set, const Result &result,
                         const std::string &place) {
    std::vector<Row> rows, right;
    for (int64_t i = 0; i < set.count(); ++i) {
        const std::vector<double> param = param_of(set, data, i);
        rows.push_back(exact_row(data, param));
        right.emplace_back();
        for (const Rational &x : minus(target_of(set, data, i), point_at(data, param))) {
            right.back().push_back(real(x));
        }
    }
    Row costs;
    for (int64_t i = 0; i < data.point_count(); ++i) {
        costs.emplace_back(set.costs.empty() ? 1.0 : std::min(set.costs[static_cast<size_t>(i)], 1e300));
    }
    const std::vector<Row> want = least_change(rows, right, costs);
    const SplineData after = read_back(result.g.get());
    Real error = 0, size = 0;
    for (int64_t i = 0; i < data.point_count(); ++i) {
        for (int c = 0; c < data.dim && original_of(data, i) == i; ++c) {
            const Real move = real(Rational(exact(after.coordinate(i, c)) - exact(data.coordinate(i, c))));
            const Real off = move - want[static_cast<size_t>(i)][static_cast<size_t>(c)];
            error += off * off;
            size += want[static_cast<size_t>(i)][static_cast<size_t>(c)] *
                    want[static_cast<size_t>(i)][static_cast<size_t>(c)];
        }
    }
    ASSERT_LE(sqrt(error), 1e-11 * sqrt(size) + 1e-13 * extent(data)) << place;
}

void expect_met(const SplineData &data, const Set &set, const Result &result, double bound,
                const std::string &place) {
    const SplineData after = read_back(result.g.get());
    for (int64_t i = 0; i < set.count(); ++i) {
        const Point missed = minus(point_at(after, param_of(set, data, i)), target_of(set, data, i));
        ASSERT_LE(length(missed), bound * std::max(extent(data), extent(after)))
            << place << " constraint " << i;
    }
}

// Whether there was a solution.
bool solve_values(Random &random, uint64_t seed, int count, bool periodic) {
    const int axes = count == 200 || random.chance(60) ? 1 : 2;
    const SplineData data = roomy(random, axes, count, periodic);
    Set set = value_set(random, data, axes == 1 ? count : std::min(count, 5));
    if (random.chance(count == 200 ? 0 : 40)) {
        for (int64_t i = 0; i < data.point_count(); ++i) {
            set.costs.push_back(uniform_cost(random));
        }
        for (int64_t i = 0; i < data.point_count(); ++i) { // those of copies do not count
            set.costs[static_cast<size_t>(i)] = set.costs[static_cast<size_t>(original_of(data, i))];
        }
    }
    const std::string place = where(seed, data) + hex(set.params);
    const Result result = constrain(create(data).get(), set);
    if (result.status == NURBS_ERROR_INFLUENCE || result.status == NURBS_ERROR_CONTRADICTION) {
        EXPECT_TRUE(!set.costs.empty() || axes == 2 || periodic) << last_error() << place;
        return false; // control points that stay left too few
    }
    EXPECT_EQ(result.status, NURBS_OK) << last_error() << place;
    if (!result.g) {
        return false;
    }
    EXPECT_EQ(result.rank, set.count() * data.dim) << place;
    EXPECT_LE(result.optimality, 1e-12) << place;
    expect_met(data, set, result, 1e-12, place);
    if (result.moved < 1e3 * extent(data)) { // else the equations are close to dependent
        expect_least_change(data, set, result, place);
    }
    return true;
}

void solve_all(uint64_t base, int cases, int count) {
    int solved_cases = 0;
    for_each_case(base, cases, [&](Random &random, uint64_t seed) {
        solved_cases += solve_values(random, seed, count, count < 200 && random.chance(20)) ? 1 : 0;
    });
    ASSERT_GE(solved_cases, support::of_whole_run(cases / 2));
}

TEST(Constrain, one_value_holds_with_the_least_change) {
    solve_all(1410000, 200, 1);
}

TEST(Constrain, ten_values_hold_with_the_least_change) {
    solve_all(1420000, 100, 10);
}

TEST(Constrain, two_hundred_values_hold_with_the_least_change) {
    solve_all(1430000, 4, 200);
}

// One constraint: e = (T - S) / R of one control point, R_i / sum R_j^2 (T - S) over a range.
TEST(Constrain, one_value_has_its_closed_form) {
    for_each_case(1440000, 200, [](Random &random, uint64_t seed) {
        const SplineData data = roomy(random, 1, 8, false);
        Set set = value_set(random, data, 1);
        const Row row = exact_row(data, set.params);
        const int64_t first = random.whole(0, static_cast<int>(data.point_count()) - 1),
                      many = random.whole(1, 4);
        set.costs.assign(static_cast<size_t>(data.point_count()), HUGE_VAL);
        Real squares = 0;
        for (int64_t i = first; i < std::min(first + many, data.point_count()); ++i) {
            set.costs[static_cast<size_t>(i)] = 3;
            squares += row[static_cast<size_t>(i)] * row[static_cast<size_t>(i)];
        }
        const Result result = constrain(create(data).get(), set);
        if (squares == 0) {
            ASSERT_EQ(result.status, NURBS_ERROR_INFLUENCE) << where(seed, data);
            return;
        }
        if (squares < 1e-12) {
            return; // the control points go out of sight
        }
        ASSERT_EQ(result.status, NURBS_OK) << last_error() << where(seed, data);
        const SplineData after = read_back(result.g.get());
        const Point gap = minus(target_of(set, data, 0), point_at(data, set.params));
        for (int64_t i = 0; i < data.point_count(); ++i) {
            const auto at = static_cast<size_t>(i);
            for (size_t c = 0; c < gap.size(); ++c) {
                const Real want =
                    std::isinf(set.costs[at]) ? Real(0) : Real(row[at] / squares * real(gap[c]));
                const Real got = real(Rational(exact(after.coordinate(i, static_cast<int>(c))) -
                                               exact(data.coordinate(i, static_cast<int>(c)))));
                ASSERT_LE(abs(got - want), 256 * 0x1p-52 * (abs(want) + extent(after))) << where(seed, data);
            }
        }
    });
}

Point derivative_at(const SplineData &data, const std::vector<double> &param, const std::vector<int> &index) {
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

Rational dot(const Point &a, const Point &b) {
    Rational sum = 0;
    for (size_t c = 0; c < a.size(); ++c) {
        sum += a[c] * b[c];
    }
    return sum;
}

// A point, its tangent, a normal and a derivative, all at once; conditions of all linear kinds.
TEST(Constrain, derivatives_directions_and_normals_hold) {
    for_each_case(1450000, 200, [](Random &random, uint64_t seed) {
        SplineData data = roomy(random, 1, 20, false);
        if (data.dim < 2 || data.degrees[0] < 2) {
            return;
        }
        Set set = value_set(random, data, 4);
        set.kinds = {NURBS_CONSTRAIN_VALUE, NURBS_CONSTRAIN_DIRECTION, NURBS_CONSTRAIN_NORMAL,
                     NURBS_CONSTRAIN_VALUE};
        set.orders = {0, 1, 0, 1};
        set.params[1] = set.params[0]; // the tangent at the point that is given
        const std::string place = where(seed, data) + hex(set.params);
        const Result result = constrain(create(data).get(), set);
        ASSERT_EQ(result.status, NURBS_OK) << last_error() << place;
        ASSERT_EQ(result.rank, 2 * data.dim + data.dim - 1 + 1) << place;
        ASSERT_LE(result.optimality, 1e-12) << place;
        const SplineData after = read_back(result.g.get());
        const auto at = [&](int64_t i) { return param_of(set, data, i); };
        const auto target = [&](int64_t i) { return target_of(set, data, i); };
        const long double size = extent(after);
        ASSERT_LE(length(minus(point_at(after, at(0)), target(0))), 1e-12L * size) << place;
        const Point tangent = derivative_at(after, at(1), {1}), u = target(1);
        const Rational along = dot(tangent, u) / dot(u, u);
        Point across = tangent;
        for (size_t c = 0; c < u.size(); ++c) {
            across[c] -= along * u[c];
        }
        const long double speed = 8.0L * data.degrees[0] * size * (data.rational() ? 16 : 1);
        ASSERT_LE(length(across), 1e-12L * speed) << place;
        const Point n = target(2), v = derivative_at(after, at(2), {1});
        ASSERT_LE(std::fabs(as_long_double(dot(n, v))), 1e-12L * speed * length(n)) << place;
        ASSERT_LE(length(minus(derivative_at(after, at(3), {1}), target(3))), 1e-12L * speed) << place;
    });
}

TEST(Constrain, contradictions_are_named) {
    for_each_case(1460000, 100, [](Random &random, uint64_t seed) {
        const SplineData data = roomy(random, 1, 10, false);
        Set set = value_set(random, data, 3);
        set.params[2] = set.params[1];
        const Result result = constrain(create(data).get(), set);
        ASSERT_EQ(result.status, NURBS_ERROR_CONTRADICTION) << where(seed, data);
        const std::string text = last_error();
        ASSERT_TRUE(text.find("constraint 1 is missed") != std::string::npos ||
                    text.find("constraint 2 is missed") != std::string::npos)
            << text;
        std::copy_n(set.targets.begin() + data.dim, data.dim, set.targets.begin() + int64_t{2} * data.dim);
        const Result same = constrain(create(data).get(), set);
        ASSERT_EQ(same.status, NURBS_OK) << last_error() << where(seed, data);
        ASSERT_EQ(same.rank, 2 * data.dim);
    });
}

TEST(Constrain, ends_stay) {
    for_each_case(1470000, 150, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        const SplineData data = roomy(random, axes, 20, false);
        Set set = value_set(random, data, 1);
        for (int k = 0; k < axes; ++k) {
            set.params[static_cast<size_t>(k)] = (data.lower(k) + data.upper(k)) / 2;
            set.keep.push_back(random.whole(-1, 1));
            set.keep.push_back(random.whole(-1, 1));
        }
        const Result result = constrain(create(data).get(), set);
        if (result.status == NURBS_ERROR_INFLUENCE) {
            return;
        }
        ASSERT_EQ(result.status, NURBS_OK) << last_error() << where(seed, data);
        const SplineData after = read_back(result.g.get());
        for (int k = 0; k < axes; ++k) {
            for (int end = 0; end < 2; ++end) {
                std::vector<double> param = random_params(random, data, 1);
                param[static_cast<size_t>(k)] = end == 0 ? data.lower(k) : data.upper(k);
                for (int order = 0; order <= set.keep[static_cast<size_t>(2 * k + end)]; ++order) {
                    std::vector<int> index(static_cast<size_t>(axes), 0);
                    index[static_cast<size_t>(k)] = order;
                    reference::Sides left{};
                    left[static_cast<size_t>(k)] = end == 1;
                    const auto slot = static_cast<size_t>(slot_of(index));
                    const auto a = reference::exact_derivatives(data, order, param.data(), left)[slot];
                    const auto b = reference::exact_derivatives(after, order, param.data(), left)[slot];
                    for (size_t c = 0; c < a.size(); ++c) {
                        ASSERT_EQ(Rational(a[c].numerator, a[c].denominator),
                                  Rational(b[c].numerator, b[c].denominator))
                            << where(seed, data);
                    }
                }
            }
        }
    });
}

// With costs of weights: c e = R lambda and v r = (w / w*) R (P* - S) . lambda at every control point.
TEST(Constrain, weights_and_points_share_the_change) {
    int solved_cases = 0;
    for_each_case(1480000, 100, [&](Random &random, uint64_t seed) {
        SplineData data = roomy(random, 1, 6, false);
        Set set = value_set(random, data, 1);
        for (int c = 0; c < data.dim; ++c) { // not far away
            const double now =
                static_cast<double>(as_long_double(point_at(data, set.params)[static_cast<size_t>(c)]));
            set.targets[static_cast<size_t>(c)] = now + random.between(-0.1, 0.1) * extent(data);
        }
        for (int64_t i = 0; i < data.point_count(); ++i) {
            set.costs.push_back(random.magnitude(0.5, 2));
            set.weight_costs.push_back(random.magnitude(0.5, 2) * extent(data) * extent(data));
        }
        const Result result = constrain(create(data).get(), set);
        ASSERT_EQ(result.status, NURBS_OK) << last_error() << where(seed, data);
        ++solved_cases;
        ASSERT_LE(result.optimality, 1e-8);
        const SplineData after = read_back(result.g.get());
        expect_met(data, set, result, 1e-12, where(seed, data));
        const Row row = exact_row(after, set.params);
        const Point s = point_at(after, set.params);
        const auto most = static_cast<size_t>(std::max_element(row.begin(), row.end()) - row.begin());
        std::vector<Real> multipliers;
        Real size = 0;
        for (size_t c = 0; c < s.size(); ++c) {
            const Real move =
                real(Rational(exact(after.coordinate(static_cast<int64_t>(most), static_cast<int>(c))) -
                              exact(data.coordinate(static_cast<int64_t>(most), static_cast<int>(c)))));
            multipliers.emplace_back(set.costs[most] * move / row[most]);
            size += abs(multipliers.back());
        }
        for (size_t i = 0; i < row.size(); ++i) {
            const auto at = static_cast<int64_t>(i);
            Real slope = 0;
            for (size_t c = 0; c < s.size(); ++c) {
                const Rational p = exact(after.coordinate(at, static_cast<int>(c)));
                const Real move = real(Rational(p - exact(data.coordinate(at, static_cast<int>(c)))));
                ASSERT_LE(abs(set.costs[i] * move - row[i] * multipliers[c]), 1e-7 * size)
                    << where(seed, data);
                slope += real(Rational(p - s[c])) * multipliers[c];
            }
            const Real ratio = Real(data.weight(at)) / Real(after.weight(at)), change = 1 / ratio - 1;
            ASSERT_LE(abs(set.weight_costs[i] * change - ratio * row[i] * slope), 1e-7 * size * extent(after))
                << where(seed, data);
        }
    });
    ASSERT_GT(solved_cases, support::of_whole_run(50));
}

// A curvature that is turned about and points along the tangent, too: the tangent has to follow, which no
// linear equation of the start contradicts.
TEST(Constrain, curvature_turns_the_tangent) {
    int asked = 0, solved_cases = 0;
    for_each_case(1495000, 200, [&](Random &random, uint64_t seed) {
        SplineData data = roomy(random, 1, 8, false);
        if (data.dim < 2 || data.degrees[0] < 3) {
            return;
        }
        Set set = value_set(random, data, 1);
        const Point a = derivative_at(data, set.params, {1}), b = derivative_at(data, set.params, {2});
        const Rational s = dot(a, a), along = dot(a, b) / s;
        const long double speed = std::sqrt(as_long_double(s));
        long double size = 0;
        for (size_t c = 0; c < a.size(); ++c) {
            size = std::hypot(size, as_long_double(Rational((b[c] - along * a[c]) / s)));
        }
        set.kinds = {NURBS_CONSTRAIN_CURVATURE};
        for (size_t c = 0; c < a.size(); ++c) {
            const long double now = as_long_double(Rational((b[c] - along * a[c]) / s)),
                              tangent = as_long_double(a[c]) / speed;
            set.targets[c] = static_cast<double>(-0.8L * now + 0.6L * size * tangent);
        }
        set.tolerance = 1e-12 * extent(data);
        const Result result = constrain(create(data).get(), set);
        ++asked;
        ASSERT_NE(result.status, NURBS_ERROR_CONTRADICTION) << last_error() << where(seed, data);
        if (result.status == NURBS_OK) { // quadratic convergence ends in rounding
            ++solved_cases;
            ASSERT_LE(result.optimality, 1e-10) << where(seed, data);
        }
    });
    ASSERT_GT(asked, support::of_whole_run(50));
    ASSERT_GE(solved_cases, asked * 9 / 10);
}

TEST(Constrain, curvature_holds) {
    int solved_cases = 0;
    for_each_case(1490000, 100, [&](Random &random, uint64_t seed) {
        SplineData data = roomy(random, 1, 8, false);
        if (data.dim < 2 || data.degrees[0] < 3) {
            return;
        }
        Set set = value_set(random, data, 1);
        const Point a = derivative_at(data, set.params, {1}), b = derivative_at(data, set.params, {2});
        const Rational s = dot(a, a), along = dot(a, b) / s;
        set.kinds = {NURBS_CONSTRAIN_CURVATURE};
        for (size_t c = 0; c < a.size(); ++c) { // a tenth more, and a little turned
            const long double now = as_long_double(Rational((b[c] - along * a[c]) / s));
            set.targets[c] = static_cast<double>(now) * 1.1;
        }
        set.tolerance = 1e-12 * extent(data);
        const Result result = constrain(create(data).get(), set);
        ASSERT_EQ(result.status, NURBS_OK) << last_error() << where(seed, data) << hex(set.params);
        ++solved_cases;
        const SplineData after = read_back(result.g.get());
        const Point v = derivative_at(after, set.params, {1}), w = derivative_at(after, set.params, {2});
        const Rational speed = dot(v, v), part = dot(v, w) / speed;
        long double error = 0, size = 0;
        for (size_t c = 0; c < v.size(); ++c) {
            error =
                std::hypot(error, as_long_double(Rational((w[c] - part * v[c]) / speed)) - set.targets[c]);
            size = std::hypot(size, set.targets[c]);
        }
        const long double scale = 64 * extent(after) / as_long_double(speed) * 25;
        ASSERT_LE(error, 1e-11L * (scale + size)) << where(seed, data) << hex(set.params);
        ASSERT_LE(result.optimality, 1e-6);
    });
    ASSERT_GT(solved_cases, support::of_whole_run(20));
}

// Two tangents that are met best by a curve that stands still: no curvature is there to speak of.
TEST(Constrain, curvature_is_not_excused_where_a_curve_stands_still) {
    SplineData data{{2}, {3}, {{0, 0, 0, 1, 1, 1}}, 3, {}, {}, 0};
    data.points = {-1.8376059568347545, -0.10085291889391751,  -0.451433451785003,
                   0.9554205398634676,  -0.5926897721889577,   0.6363290124369492,
                   0.10302281320692915, -0.015383823070245281, 0.3289223511034654};
    data.weights = {0.6785729134191877, 0.896163172482727, 0.811530343576127};
    Set set;
    set.kinds = {NURBS_CONSTRAIN_DIRECTION, NURBS_CONSTRAIN_DIRECTION, NURBS_CONSTRAIN_CURVATURE};
    set.orders = {1, 1, 0};
    set.params = {0.19611651602279367, 0.33696457422914194, 0.8855591330656541};
    set.targets = {1.258328890065498,    1.0494273555513152,     0.5219965109522967,
                   -0.7290619402999594,  1.780501479726986,      0.09194590632669447,
                   -0.01628886083708101, -0.0019632373722657695, 0.04178587475995931};
    const Result result = constrain(create(data).get(), set);
    EXPECT_TRUE(result.status != NURBS_OK || result.residuals[2] <= 1e-6 * 0.045);
}

} // namespace

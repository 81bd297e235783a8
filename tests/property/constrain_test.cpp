// Constraints: they hold, and the change is the smallest one, that of the Kuhn-Tucker equations solved in
// high precision.
#include "property/constraints.h"

namespace constrain_test {

using namespace support;
using namespace support::constraints;

namespace {

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

double uniform_cost(Random &random) {
    return random.chance(20) ? HUGE_VAL : random.magnitude(0.1, 10);
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

// A homogeneous spline changes as the rational one does that it equals, to the rounding of its points P = (w
// P) / w.
TEST(Constrain, homogeneous_splines_change_like_rational_ones) {
    int met = 0;
    for_each_case(1496000, 60, [&](Random &random, uint64_t seed) {
        const SplineData data = roomy(random, random.whole(1, 2), 4, random.chance(20));
        Set set = value_set(random, data, 2);
        if (random.chance(50)) {
            set.weight_costs.assign(static_cast<size_t>(data.point_count()), 1);
        }
        const Handle g = create(data), records = homogeneous_form(g.get());
        const Result want = constrain(g.get(), set), got = constrain(records.get(), set);
        const std::string place = where(seed, data) + hex(set.params);
        ASSERT_EQ(got.status, want.status) << last_error() << place;
        if (got.status != NURBS_OK) {
            return;
        }
        ++met;
        int32_t homogeneous = 0;
        require_ok(nurbs_is_homogeneous(got.g.get(), &homogeneous));
        ASSERT_EQ(homogeneous, 1) << place;
        ASSERT_EQ(got.rank, want.rank) << place;
        const std::vector<double> params = random_params(random, data, 20);
        const std::vector<double> a = eval(want.g.get(), params), b = eval(got.g.get(), params);
        for (size_t i = 0; i < a.size(); ++i) {
            ASSERT_NEAR(a[i], b[i], 1e-9 * (extent(data) + want.moved)) << place;
        }
    });
    ASSERT_GT(met, support::of_whole_run(40));
}

} // namespace

} // namespace constrain_test

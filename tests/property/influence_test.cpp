// Control points without influence: those whose basis function vanishes on the domain, as at an unclamped end
// whose knot repeats, and those of weight 0. Whatever they are, every answer is the same.
#include "property/query_answers.h"

#include <gtest/gtest.h>

namespace influence_test {

using namespace support;

namespace {

SplineData curve(int degree, std::vector<double> knots, int dim, std::vector<double> points,
                 std::vector<double> weights = {}) {
    SplineData data;
    data.degrees = {degree};
    data.counts = {static_cast<int64_t>(knots.size()) - degree - 1};
    data.knots = {std::move(knots)};
    data.dim = dim;
    data.points = std::move(points);
    data.weights = std::move(weights);
    return data;
}

// Whether a control point has no influence on axis k, by the support of its function.
bool vanishes(const SplineData &data, int k, int64_t layer) {
    const auto at = static_cast<size_t>(k), i = static_cast<size_t>(layer);
    return data.knots[at][i + static_cast<size_t>(data.degrees[at]) + 1] <= data.lower(k) ||
           data.knots[at][i] >= data.upper(k);
}

bool outside(const SplineData &data, int64_t i) {
    bool result = false;
    for (int k = data.axes(); k-- > 0; i /= data.counts[static_cast<size_t>(k)]) {
        result = result || vanishes(data, k, i % data.counts[static_cast<size_t>(k)]);
    }
    return result;
}

// With every point that has no influence at a place of about that size, and the weights of those outside.
SplineData with_inert(SplineData data, Random random, double size) {
    for (int64_t i = 0; i < data.point_count(); ++i) {
        const bool no_function = outside(data, i);
        if (!no_function && data.weight(i) != 0) {
            continue;
        }
        for (int c = 0; c < data.dim; ++c) {
            data.points[static_cast<size_t>(i * data.dim + c)] = random.between(-1, 1) * size;
        }
        if (no_function && data.rational()) {
            data.weights[static_cast<size_t>(i)] = random.magnitude(1e-6, 1e6);
        }
    }
    return data;
}

// Zeros may differ in sign: a weight of 0 times a coordinate keeps it.
bool same(double a, double b) {
    return a == b || same_bits(a, b);
}

void expect_same(const SplineData &data, const SplineData &other, bool homogeneous, uint64_t seed) {
    const Answers answers(data, homogeneous), others(other, homogeneous);
    ASSERT_EQ(answers.list().size(), others.list().size());
    for (size_t i = 0; i < answers.list().size(); ++i) {
        const auto &[name, a] = answers.list()[i];
        const auto &b = others.list()[i].second;
        ASSERT_EQ(a.size(), b.size()) << name;
        for (size_t k = 0; k < a.size(); ++k) {
            EXPECT_TRUE(same(a[k], b[k]))
                << name << "[" << k << "]: " << a[k] << ", " << b[k] << where(seed, other);
        }
    }
}

// Over [0, 1], clamped, or with a point at each end that no parameter sees.
std::vector<double> knots_of(int degree, bool clamped) {
    std::vector<double> head;
    for (int i = degree; i > 0; --i) {
        head.push_back(clamped ? 0 : -i);
    }
    head.push_back(0);
    if (!clamped) {
        head.push_back(0);
    }
    std::vector<double> knots = head;
    knots.insert(knots.end(), {0.4, 0.7});
    std::for_each(head.rbegin(), head.rend(), [&](double t) { knots.push_back(1 - t); });
    return knots;
}

// Control point i of a surface or volume moved near its place in a grid.
void unfold(SplineData &data, int64_t i) {
    int64_t rest = i;
    for (int k = data.axes(); k-- > 0; rest /= data.counts[static_cast<size_t>(k)]) {
        double &x = data.points[static_cast<size_t>(i * data.dim + k)];
        x = 0.1 * x + 0.5 * static_cast<double>(rest % data.counts[static_cast<size_t>(k)]);
    }
}

SplineData random_net(Random &random, const std::vector<std::pair<int, bool>> &axes, int dim, bool rational,
                      bool some_zero) {
    SplineData data;
    data.dim = dim;
    for (const auto &[degree, clamped] : axes) {
        data.degrees.push_back(degree);
        data.knots.push_back(knots_of(degree, clamped));
        data.counts.push_back(static_cast<int64_t>(data.knots.back().size()) - degree - 1);
    }
    for (int64_t i = 0; i < data.point_count(); ++i) {
        for (int c = 0; c < dim; ++c) {
            data.points.push_back(random.between(-1, 1));
        }
        if (axes.size() > 1) { // no folds, which are dear to integrate over
            unfold(data, i);
        }
        if (rational) {
            data.weights.push_back(random.magnitude(0.4, 2.5));
        }
    }
    if (some_zero) {
        data.weights[static_cast<size_t>(data.point_count() / 2)] = 0;
    }
    return data;
}

void check_law(uint64_t base, const std::vector<std::pair<int, bool>> &axes, int dim) {
    for_each_case(base, axes.size() == 1 ? 3 : 1, [&](Random &random, uint64_t seed) {
        for (const int kind : {0, 1, 2, 3}) { // polynomial, rational, with a weight of 0, homogeneous
            if (kind == 2 && axes.size() == 1 && axes[0].first == 1) {
                continue; // the weight would vanish there
            }
            const double model = random.chance(50) ? 1 : 1e-30;
            const SplineData data = scaled(random_net(random, axes, dim, kind > 0, kind == 2), model);
            const SplineData near = with_inert(data, random, model);
            for (const double size : {1e10, 1e300}) {
                expect_same(near, with_inert(data, random, size), kind == 3, seed);
            }
        }
    });
}

TEST(Influence, law_of_lines) {
    check_law(91000, {{1, false}}, 2);
}
TEST(Influence, law_of_plane_curves) {
    check_law(91010, {{2, false}}, 2);
}
TEST(Influence, law_of_space_curves) {
    check_law(91020, {{3, false}}, 3);
}
TEST(Influence, law_of_clamped_curves) {
    check_law(91030, {{3, true}}, 3);
}
TEST(Influence, law_of_surfaces) {
    check_law(91040, {{2, false}, {1, true}}, 3);
}
TEST(Influence, law_of_plane_surfaces) {
    check_law(91050, {{1, false}, {2, false}}, 2);
}
TEST(Influence, law_of_volumes) {
    check_law(91060, {{1, true}, {1, false}, {2, false}}, 3);
}

// The segment from (0, 0) to (1, 0) over the domain [0, 1], and a point of no influence at each end.
SplineData seen_segment(double size) {
    return curve(1, {-1, 0, 0, 1, 1, 2}, 2, {size, size, 0, 0, 1, 0, -size, -size});
}
// The same between points of weight 1, with one of weight 0 that lies anywhere.
SplineData weightless_middle(double size) {
    return curve(2, {0, 0, 0, 1, 1, 1}, 2, {0, 0, size, 0, 1, 0}, {1, 0, 1});
}

void check_segment(const SplineData &data) {
    const Handle g = create(data);
    double length = -1, lower[2], upper[2], gap = -1;
    require_ok(nurbs_curve_length(g.get(), nullptr, 0, &length, nullptr));
    EXPECT_NEAR(length, 1, 1e-14);
    require_ok(nurbs_box(g.get(), nullptr, 0, lower, upper, &gap));
    EXPECT_LE(gap, 1e-13);
    EXPECT_NEAR(lower[0], 0, 1e-13);
    EXPECT_NEAR(upper[0], 1, 1e-13);
    EXPECT_NEAR(upper[1] - lower[1], 0, 1e-13);
    const double asked[] = {0.25, 1};
    double foot[2], distance = -1;
    int32_t status = -1;
    require_ok(nurbs_closest_points(g.get(), 1, asked, 0, 0, nullptr, 1e-12, 0, nullptr, 0, 0, foot, 0, 0,
                                    &distance, 0, &status, 0));
    EXPECT_NEAR(foot[0], 0.25, 1e-12);
    EXPECT_NEAR(distance, 1, 1e-14);
    EXPECT_EQ(status, NURBS_CLOSEST_CERTIFIED);
    const Handle above = create(curve(1, {0, 0, 1, 1}, 2, {0, 1, 1, 1}));
    double at_least = -1, at_most = -1;
    require_ok(nurbs_distance(g.get(), above.get(), 1e-9, 0, &at_least, &at_most, nullptr, nullptr, &status));
    EXPECT_LE(at_least, 1);
    EXPECT_GE(at_most, 1);
    EXPECT_LE(at_most - at_least, 1e-9 + 1e-13);
    EXPECT_EQ(status, NURBS_CLOSEST_CERTIFIED);
}

TEST(Influence, points_that_no_parameter_sees) {
    for (const double size : {1.0, 1e10, 1e100, 1e200, 1e300}) {
        check_segment(seen_segment(size));
    }
}

TEST(Influence, points_of_weight_0) {
    for (const double size : {0.5, 1e10, 1e100, 1e200, 1e300}) {
        check_segment(weightless_middle(size));
    }
}

// Their stored values stay.
TEST(Influence, is_not_needed_to_be_kept) {
    for (const SplineData &data : {seen_segment(1e200), weightless_middle(1e200)}) {
        const SplineData back = read_back(create(data).get());
        EXPECT_TRUE(same_bits(back.points, data.points));
        EXPECT_TRUE(same_bits(back.weights, data.weights));
    }
}

// The derivatives of higher degrees are sums of differences from a point of the curve.
TEST(Influence, points_of_weight_0_far_from_large_ones) {
    std::vector<double> knots(22, 0.0), points(11, -1.4e308), weights(11, 1.0);
    std::fill(knots.begin() + 11, knots.end(), 1.0);
    std::fill(points.begin(), points.begin() + 5, -1.5e308);
    weights[5] = 0;
    std::vector<double> slopes;
    for (const double x : {0.0, 1.7e308}) {
        points[5] = x;
        slopes.push_back(eval_derivs(create(curve(10, knots, 1, points, weights)).get(), 1, {0.3}).back());
    }
    ASSERT_TRUE(std::isfinite(slopes[0]));
    ASSERT_EQ(slopes[0], slopes[1]);
}

// A weight that nobody sees scales no other one out of double precision.
TEST(Influence, weights_that_no_parameter_sees) {
    for (const double weight : {1e-300, 1.0, 1e300}) {
        SplineData data = seen_segment(1e-3);
        data.points[2] = 1e-200;
        data.weights = {weight, 1e-10, 3e-10, weight};
        const std::vector<double> found = eval(create(data).get(), {0, 0.5});
        EXPECT_EQ(found[0], 1e-200) << weight;
        EXPECT_NEAR(found[2], 0.75, 1e-15) << weight;
    }
}

} // namespace

} // namespace influence_test

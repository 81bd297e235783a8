// Constraints that are not linear: costs of weights, curvature.
#include "property/constraints.h"

namespace constrain_curvature_test {

using namespace support;
using namespace support::constraints;

namespace {

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

// C' and the curvature (C'' - (C' . C'' / |C'|^2) C') / |C'|^2 of a curve.
struct Bend {
    Rational square; // |C'|^2
    std::vector<long double> tangent, curvature;
};

Bend bend_at(const SplineData &data, const std::vector<double> &param) {
    const Point a = derivative_at(data, param, {1}), b = derivative_at(data, param, {2});
    Bend bend{dot(a, a), {}, {}};
    const Rational along = dot(a, b) / bend.square;
    const long double speed = std::sqrt(as_long_double(bend.square));
    for (size_t c = 0; c < a.size(); ++c) {
        bend.tangent.push_back(as_long_double(a[c]) / speed);
        bend.curvature.push_back(as_long_double(Rational((b[c] - along * a[c]) / bend.square)));
    }
    return bend;
}

long double norm(const std::vector<long double> &x) {
    long double size = 0;
    for (const long double part : x) {
        size = std::hypot(size, part);
    }
    return size;
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
        const Bend now = bend_at(data, set.params);
        const long double size = norm(now.curvature);
        set.kinds = {NURBS_CONSTRAIN_CURVATURE};
        for (size_t c = 0; c < now.curvature.size(); ++c) {
            set.targets[c] = static_cast<double>(-0.8L * now.curvature[c] + 0.6L * size * now.tangent[c]);
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

// A tenth more curvature at a parameter.
Set bent_more(Random &random, const SplineData &data) {
    Set set = value_set(random, data, 1);
    const Bend now = bend_at(data, set.params);
    set.kinds = {NURBS_CONSTRAIN_CURVATURE};
    for (size_t c = 0; c < now.curvature.size(); ++c) {
        set.targets[c] = static_cast<double>(now.curvature[c]) * 1.1;
    }
    return set;
}

TEST(Constrain, curvature_holds) {
    int solved_cases = 0;
    for_each_case(1490000, 100, [&](Random &random, uint64_t seed) {
        SplineData data = roomy(random, 1, 8, false);
        if (data.dim < 2 || data.degrees[0] < 3) {
            return;
        }
        Set set = bent_more(random, data);
        set.tolerance = 1e-12 * extent(data);
        const Result result = constrain(create(data).get(), set);
        ASSERT_EQ(result.status, NURBS_OK) << last_error() << where(seed, data) << hex(set.params);
        ++solved_cases;
        const SplineData after = read_back(result.g.get());
        Bend got = bend_at(after, set.params);
        const long double size = norm(got.curvature);
        for (size_t c = 0; c < got.curvature.size(); ++c) {
            got.curvature[c] -= set.targets[c];
        }
        const long double scale = 64 * extent(after) / as_long_double(got.square) * 25;
        ASSERT_LE(norm(got.curvature), 1e-11L * (scale + size)) << where(seed, data) << hex(set.params);
        ASSERT_LE(result.optimality, 1e-6);
    });
    ASSERT_GT(solved_cases, support::of_whole_run(20));
}

// Points that the condition does not see may be of any size.
TEST(Constrain, curvature_beside_huge_points) {
    int solved_cases = 0;
    for_each_case(1499000, 60, [&](Random &random, uint64_t seed) {
        SplineData data = roomy(random, 1, 8, false);
        if (data.dim < 2 || data.degrees[0] < 3 || data.rational()) {
            return;
        }
        Set set = bent_more(random, data);
        set.tolerance = 1e-9 * extent(data);
        const Result base = constrain(create(data).get(), set);
        const auto &knots = data.knots[0];
        const int64_t span = std::upper_bound(knots.begin(), knots.end(), set.params[0]) - knots.begin() - 1;
        const double small = random.chance(50) ? 1 : 1e-30, large = random.chance(50) ? 1e150 : 1e-290;
        std::vector<size_t> unseen;
        for (int64_t i = 0; i < data.counts[0]; ++i) {
            const bool seen = i >= span - data.degrees[0] - 1 && i <= span + 1;
            for (int c = 0; c < data.dim; ++c) {
                const auto at = static_cast<size_t>(i * data.dim + c);
                data.points[at] *= seen ? small : large;
                if (!seen) {
                    unseen.push_back(at);
                }
            }
        }
        for (double &target : set.targets) {
            target /= small;
        }
        set.tolerance *= small;
        const Result found = constrain(create(data).get(), set);
        ASSERT_EQ(found.status, base.status) << last_error() << where(seed, data);
        for (const size_t at : unseen) {
            ASSERT_TRUE(found.status != NURBS_OK || read_back(found.g.get()).points[at] == data.points[at])
                << where(seed, data);
        }
        solved_cases += base.status == NURBS_OK;
    });
    ASSERT_GT(solved_cases, support::of_whole_run(10));
}

// A model and knots multiplied by powers of two give what the model gives.
TEST(Constrain, curvature_has_no_size) {
    int solved_cases = 0;
    for_each_case(1498000, 60, [&](Random &random, uint64_t seed) {
        const SplineData data = roomy(random, 1, 8, false);
        if (data.dim < 2 || data.degrees[0] < 3) {
            return;
        }
        Set set = bent_more(random, data);
        set.tolerance = 1e-12 * extent(data);
        const Result base = constrain(create(data).get(), set);
        const int points = random.whole(-800, 800), knots = random.chance(50) ? 0 : random.whole(-200, 200);
        const double size = std::ldexp(1, points);
        Set other = set;
        other.tolerance *= size;
        other.params[0] = std::ldexp(set.params[0], knots);
        for (double &target : other.targets) {
            target /= size;
        }
        const Result found = constrain(create(scaled(data, size, std::ldexp(1, knots))).get(), other);
        ASSERT_EQ(found.status, base.status) << last_error() << where(seed, data);
        if (base.status != NURBS_OK) {
            return;
        }
        ++solved_cases;
        ASSERT_TRUE(same_bits(read_back(found.g.get()).points, scaled(read_back(base.g.get()), size).points))
            << where(seed, data) << points << " " << knots;
        ASSERT_EQ(found.moved, base.moved * size);
        ASSERT_EQ(found.residuals[0], std::ldexp(base.residuals[0], -points)) << where(seed, data);
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

} // namespace constrain_curvature_test

// Bends against the exact image, which is no spline, and against the bound that they state.
#include "property/deform_cases.h"

namespace bend_test {

using namespace support;
using namespace support::deform;

namespace {

struct BendCase {
    std::vector<double> origin, along, across;
    double curvature, lower, upper;
};

std::vector<long double> bent(const BendCase &rule, const Point &point) {
    const size_t dim = point.size();
    std::vector<long double> e(rule.along.begin(), rule.along.end()),
        n(rule.across.begin(), rule.across.end());
    const auto dot = [dim](const auto &a, const auto &b) {
        long double sum = 0;
        for (size_t c = 0; c < dim; ++c) {
            sum += a[c] * b[c];
        }
        return sum;
    };
    const auto unit = [&](std::vector<long double> &x) {
        const long double size = std::sqrt(dot(x, x));
        for (long double &value : x) {
            value /= size;
        }
    };
    unit(e);
    const long double part = dot(e, n);
    for (size_t c = 0; c < dim; ++c) {
        n[c] -= part * e[c];
    }
    unit(n);
    std::vector<long double> x;
    for (size_t c = 0; c < dim; ++c) {
        x.push_back(as_long_double(Rational(point[c] - exact(rule.origin[c]))));
    }
    const long double k = rule.curvature, a = dot(x, e), b = dot(x, n),
                      u = std::clamp<long double>(a, rule.lower, rule.upper), far = a - u;
    const long double to_a = (1 / k + b) * std::sin(k * u) + far * std::cos(k * u),
                      to_b = (1 / k + b) * std::cos(k * u) - 1 / k - far * std::sin(k * u);
    std::vector<long double> image;
    for (size_t c = 0; c < dim; ++c) {
        image.push_back(rule.origin[c] + x[c] + (to_a - a) * e[c] + (to_b - b) * n[c]);
    }
    return image;
}

long double gap_between(const Point &point, const std::vector<long double> &image) {
    long double sum = 0;
    for (size_t c = 0; c < point.size(); ++c) {
        sum = std::hypot(sum, as_long_double(point[c]) - image[c]);
    }
    return sum;
}

// Bends a spline in 60 ways; how many of the bounds are proven.
int bends_within_the_tolerance(uint64_t base, bool wild_weights) {
    int proofs = 0;
    for_each_case(base, 60, [&](Random &random, uint64_t seed) {
        const int axes = wild_weights || random.chance(70) ? 1 : 2;
        Recipe recipe = calm_recipe(random, axes, 4, random.whole(2, 3));
        recipe.axes[0].form = wild_weights ? KnotForm::clamped : recipe.axes[0].form;
        SplineData data = random_spline(random, recipe);
        if (wild_weights) {
            data.weights.resize(static_cast<size_t>(data.point_count()));
            std::generate(data.weights.begin(), data.weights.end(),
                          [&] { return random.magnitude(1e-2, 1e2); });
        }
        const double size = extent(data);
        BendCase rule{{},
                      direction_of(random, data.dim),
                      direction_of(random, data.dim),
                      random.between(0.2, 2) / size,
                      -HUGE_VAL,
                      HUGE_VAL};
        rule.across[0] -= 4; // not along it
        rule.origin.assign(static_cast<size_t>(data.dim), 0.1 * size);
        if (axes == 1 && random.chance(50)) {
            rule.lower = -0.3 * size;
            rule.upper = 0.4 * size;
        }
        const double tolerance = size * (axes == 1 ? random.magnitude(1e-9, 1e-3) : 1e-3);
        const Handle g = create(data);
        double deviation = -1;
        int32_t proven = -1;
        const Handle h = made([&](nurbs **out) {
            return nurbs_bend(g.get(), rule.origin.data(), rule.along.data(), rule.across.data(),
                              rule.curvature, rule.lower, rule.upper, tolerance, &deviation, &proven, out);
        });
        proofs += proven;
        ASSERT_LE(deviation, tolerance);
        const SplineData after = read_back(h.get());
        for (int n = 0; n < 20; ++n) {
            const std::vector<double> param = random_params(random, after, 1);
            const long double gap = gap_between(point_at(after, param), bent(rule, point_at(data, param)));
            ASSERT_LE(gap, (proven == 1 ? deviation : tolerance) + 64 * eps * size)
                << where(seed, data) << hex(param);
        }
    });
    std::printf("%d bounds proven\n", proofs);
    return proofs;
}

TEST(Bend, is_within_the_tolerance_of_the_exact_image) {
    EXPECT_GE(bends_within_the_tolerance(1540000, false), support::of_whole_run(55));
}

// Bounds that are far above the deviations, of weights from 1e-2 to 1e2, give way to samples.
TEST(Bend, is_within_the_tolerance_for_wild_weights) {
    EXPECT_LT(bends_within_the_tolerance(1545000, true), 60);
}

// A polyline at integers, its corners on the line through origin and (1, 1 / 4) if it is straight.
SplineData polyline(int corners, bool straight, KnotForm form) {
    SplineData data;
    data.dim = 2;
    data.degrees = {1};
    const bool periodic = form == KnotForm::periodic;
    std::vector<double> knots;
    for (int i = 0; i < corners + 2; ++i) {
        knots.push_back(form == KnotForm::clamped ? std::clamp(i, 1, corners) : i);
        if (i < corners) {
            const double x = i % (periodic ? corners - 1 : corners);
            data.points.insert(data.points.end(),
                               {x / corners, straight ? 0.25 * x / corners : 0.1 * ((i * 7) % 3)});
        }
    }
    data.points[data.points.size() - 1] = periodic ? data.points[1] : data.points.back();
    data.counts = {corners};
    data.knots = {knots};
    data.flags = periodic ? NURBS_PERIODIC : 0;
    return data;
}

SplineData bent_by_one(const SplineData &data, double tolerance, int32_t &proven, int places = 200) {
    const double origin[] = {0.1, 0}, along[] = {1, 0}, across[] = {0, 1};
    double deviation = -1;
    nurbs *out = nullptr;
    const nurbs_status status = nurbs_bend(create(data).get(), origin, along, across, 3, -HUGE_VAL, HUGE_VAL,
                                           tolerance, &deviation, &proven, &out);
    EXPECT_EQ(status, NURBS_OK) << last_error();
    const Handle h(out);
    const SplineData after = read_back(h.get());
    EXPECT_LE(deviation, tolerance);
    const BendCase rule{{0.1, 0}, {1, 0}, {0, 1}, 3, -HUGE_VAL, HUGE_VAL};
    for (int i = 0; i <= places; ++i) {
        const double t = data.lower(0) + (data.upper(0) - data.lower(0)) * i / places;
        EXPECT_LE(gap_between(point_at(after, {t}), bent(rule, point_at(data, {t}))), deviation);
    }
    return after;
}

// Of 1e-9^(-1 / 4) = 178 cubic pieces to each unit of length times curvature; of degree 1 it takes 10^4.
TEST(Bend, polylines_become_cubic) {
    for (const KnotForm form : {KnotForm::clamped, KnotForm::unclamped, KnotForm::periodic}) {
        int32_t proven = -1;
        const SplineData line = bent_by_one(polyline(5, form != KnotForm::periodic, form), 1e-9, proven);
        EXPECT_EQ(proven, 1);
        EXPECT_EQ(line.degrees[0], 3);
        EXPECT_LE(line.point_count(), 600);
        EXPECT_EQ(line.periodic(0), form == KnotForm::periodic);
    }
}

// Corners are knots of multiplicity degree, where values are met; all others are smooth.
TEST(Bend, corners_stay_corners) {
    int32_t proven = -1;
    const SplineData before = polyline(6, false, KnotForm::clamped),
                     after = bent_by_one(before, 1e-7, proven);
    const std::vector<double> &knots = after.knots[0];
    ASSERT_EQ(after.degrees[0], 3);
    for (size_t i = 4; i + 4 < knots.size(); ++i) {
        const auto copies = std::count(knots.begin(), knots.end(), knots[i]);
        const bool corner = std::floor(knots[i]) == knots[i];
        ASSERT_EQ(copies, corner ? 3 : 1) << knots[i];
        const BendCase rule{{0.1, 0}, {1, 0}, {0, 1}, 3, -HUGE_VAL, HUGE_VAL};
        const long double gap =
            gap_between(point_at(after, {knots[i]}), bent(rule, point_at(before, {knots[i]})));
        ASSERT_TRUE(!corner || gap <= 16 * eps) << static_cast<double>(gap);
    }
}

TEST(Bend, degrees_stay_where_they_suffice) {
    int32_t proven = -1;
    const SplineData loose = bent_by_one(polyline(40, false, KnotForm::clamped), 0.05, proven);
    ASSERT_EQ(loose.degrees[0], 1);
    ASSERT_EQ(loose.point_count(), 40);
}

// On even knots, where a control point of a high degree is ill-conditioned from one span.
TEST(Bend, high_degrees_are_met) {
    for (const int degree : {9, 17, 31}) {
        for (const KnotForm form : {KnotForm::clamped, KnotForm::unclamped, KnotForm::periodic}) {
            for (const int spans : {1, 2, 20}) {
                Random random(static_cast<uint64_t>(1545000 + degree * 100 + spans));
                Recipe recipe;
                recipe.dim = 2;
                recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
                AxisRecipe axis = random_axis(random, degree);
                axis.form = form;
                axis.spacing = Spacing::integers;
                axis.placement = Placement::origin;
                axis.spans = spans;
                recipe.axes = {axis};
                SplineData data = random_spline(random, recipe);
                const double size = extent(data);
                std::transform(data.points.begin(), data.points.end(), data.points.begin(),
                               [size](double x) { return 0.1 * x / size; });
                int32_t proven = -1;
                const SplineData after = bent_by_one(data, 1e-10, proven, 30);
                ASSERT_LE(after.point_count(), 256) << where(static_cast<uint64_t>(degree), data);
            }
        }
    }
}

} // namespace

} // namespace bend_test

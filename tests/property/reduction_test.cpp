// Fewer knots and lower degrees: bounds hold, tolerances hold, what was refined and elevated comes back.
#include "property/dense_samples.h"

namespace reduction_test {

using namespace support;

namespace {

struct Made {
    Handle spline;
    double bound = -1;
};

Made reduce_knots(const nurbs *g, int axis, double tolerance) {
    nurbs *out = nullptr;
    Made made;
    require_ok(nurbs_reduce_knots(g, axis, tolerance, &made.bound, &out));
    made.spline.reset(out);
    return made;
}

Made reduce_degree(const nurbs *g, int axis, int times, nurbs_status &status) {
    nurbs *out = nullptr;
    Made made;
    status = nurbs_reduce_degree(g, axis, times, &made.bound, &out);
    made.spline.reset(out);
    return made;
}

Made simplify(const nurbs *g, double tolerance) {
    nurbs *out = nullptr;
    Made made;
    require_ok(nurbs_simplify(g, tolerance, &made.bound, &out));
    made.spline.reset(out);
    return made;
}

SplineData random_case(Random &random, int surfaces) {
    const int axes = random.chance(surfaces) ? 2 : 1;
    Recipe recipe = random_recipe(random, axes, axes == 1 ? 6 : 3);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = axes == 1 ? random.whole(1, 12) : axis.spans;
    }
    return random_spline(random, recipe);
}

int64_t knot_total(const SplineData &data) {
    int64_t total = 0;
    for (const auto &knots : data.knots) {
        total += std::ssize(knots);
    }
    return total;
}

TEST(Reduction, the_bound_of_data_reduction_is_one) {
    std::vector<long double> ratios;
    int64_t removed = 0;
    for_each_case(310000, 2500, [&](Random &random, uint64_t seed) {
        const auto data = random_case(random, 8);
        const auto g = create(data);
        const int axis = random.whole(-1, data.axes() - 1);
        const double tolerance = extent(data) * random.magnitude(1e-4, 10);
        const Made result = reduce_knots(g.get(), axis, tolerance);
        ASSERT_LE(result.bound, tolerance) << where(seed, data);
        const auto fewer = read_back(result.spline.get());
        removed += knot_total(data) - knot_total(fewer);
        const long double found = dense_deviation(data, fewer, 8);
        ASSERT_LE(found, result.bound) << where(seed, data) << " tolerance " << hex(tolerance);
        if (found > 1e-8 * extent(data)) {
            ratios.push_back(result.bound / found);
        }
    });
    EXPECT_LE(median(ratios, "bound / sampled deviation, data reduction"), 1.5L);
    std::printf("%lld knots removed\n", static_cast<long long>(removed));
}

// A smooth arc with many knots too many, in any form of knots: most of them go at once, and what goes later is
// measured against what is left.
TEST(Reduction, of_many_knots_few_remain) {
    for_each_case(315000, 60, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 6);
        recipe.axes[0].spans = random.whole(1, 4);
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        nurbs *out = nullptr;
        const int64_t parts = random.chance(5) ? 20000 : 100;
        if (nurbs_refine_uniform(g.get(), 0, parts, &out) != NURBS_OK) {
            return; // too few doubles between the knots
        }
        const Handle many(out);
        const double tolerance = extent(data) * random.magnitude(1e-6, 1e-3);
        const Made one = reduce_knots(g.get(), 0, tolerance), result = reduce_knots(many.get(), 0, tolerance);
        ASSERT_LE(result.bound, tolerance) << where(seed, data);
        const auto fewer = read_back(result.spline.get());
        ASSERT_LE(knot_total(fewer), knot_total(read_back(one.spline.get())) + 6) << where(seed, data);
        ASSERT_LE(dense_deviation(data, fewer, 8), result.bound) << where(seed, data);
    });
}

TEST(Reduction, the_bound_of_degree_reduction_is_one) {
    std::vector<long double> ratios;
    for_each_case(320000, 2500, [&](Random &random, uint64_t seed) {
        const auto data = random_case(random, 8);
        const auto g = create(data);
        const int axis = random.whole(0, data.axes() - 1);
        const int degree = data.degrees[static_cast<size_t>(axis)];
        nurbs_status status = NURBS_OK;
        const Made result =
            reduce_degree(g.get(), axis, random.whole(std::min(1, degree), std::min(3, degree)), status);
        if (status == NURBS_ERROR_WEIGHT_SIGN) {
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        const long double found = dense_deviation(data, read_back(result.spline.get()), 8);
        ASSERT_LE(found, result.bound) << where(seed, data);
        if (found > 1e-8 * extent(data)) {
            ratios.push_back(result.bound / found);
        }
    });
    EXPECT_LE(median(ratios, "bound / sampled deviation, degree reduction"), 1.5L);
}

TEST(Reduction, elevated_splines_come_back) {
    WorstErrors worst("elevate -> reduce, in eps * hull");
    for_each_case(330000, 1500, [&](Random &random, uint64_t seed) {
        const auto data = random_case(random, 10);
        const int axis = random.whole(0, data.axes() - 1);
        const int times = random.whole(1, 3);
        const auto g = create(data);
        Handle high;
        try {
            high = elevate(g.get(), axis, times);
        } catch (const std::runtime_error &) {
            return;
        }
        nurbs_status status = NURBS_OK;
        const Made back = reduce_degree(high.get(), axis, times, status);
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        if (std::count(data.weights.begin(), data.weights.end(), 0.0) > 0) {
            return; // weights come back to within rounding, points of those that are small do not
        }
        const auto got = read_back(back.spline.get());
        const auto want = homogeneous(g.get()), found = homogeneous(back.spline.get());
        const auto k = static_cast<size_t>(axis);
        if (data.knots[k] != got.knots[k]) {
            return;
        }
        double hull = 0;
        long double error = 0;
        for (size_t i = 0; i < want.points.size(); ++i) {
            hull = std::max(hull, std::fabs(want.points[i]));
            error = std::max(error, std::fabs(static_cast<long double>(want.points[i]) - found.points[i]));
        }
        worst.add(data.degrees[k], error / (eps * hull * 8 * std::pow(2.0L, data.degrees[k])),
                  error / (eps * hull));
    });
}

// Weights over eight orders of magnitude, and some of 0: what was inserted goes again, in one list or one by
// one.
TEST(Reduction, inserted_knots_go_whatever_the_weights) {
    int64_t inserted = 0, by_list = 0, one_by_one = 0;
    for_each_case(365000, 400, [&](Random &random, uint64_t seed) {
        Recipe recipe = open_recipe(random, 1, 4);
        recipe.weights = Weights::ones;
        SplineData data = random_spline(random, recipe);
        for (double &w : data.weights) {
            w = random.chance(10) ? 0 : random.magnitude(1e-4, 1e4);
        }
        Handle g;
        if (try_create(data, g) != NURBS_OK) {
            return; // no weight somewhere
        }
        Handle fine = insert(g.get(), 0, data.lower(0), 0);
        std::vector<double> knots;
        for (int i = 0; i < 3; ++i) {
            const double t = data.lower(0) + (data.upper(0) - data.lower(0)) * random.unit();
            if (std::count(data.knots[0].begin(), data.knots[0].end(), t) == 0 && t > data.lower(0)) {
                fine = insert(fine.get(), 0, t, 1);
                knots.push_back(t);
            }
        }
        const double tolerance = 1e-9 * extent(data);
        const Made fewer = reduce_knots(fine.get(), 0, tolerance);
        ASSERT_LE(dense_deviation(data, read_back(fewer.spline.get()), 8), tolerance) << where(seed, data);
        inserted += std::ssize(knots);
        by_list += std::max<int64_t>(0, knot_total(read_back(fewer.spline.get())) - knot_total(data));
        for (const double t : knots) {
            nurbs *out = nullptr;
            require_ok(nurbs_remove_knot(fine.get(), 0, t, 1, tolerance, nullptr, nullptr, &out));
            fine.reset(out);
        }
        one_by_one += knot_total(read_back(fine.get())) - knot_total(data);
    });
    std::printf("%lld inserted, %lld and %lld left\n", static_cast<long long>(inserted),
                static_cast<long long>(by_list), static_cast<long long>(one_by_one));
    ASSERT_LE(by_list * 100, inserted);
    ASSERT_LE(one_by_one * 100, inserted);
}

TEST(Reduction, simplified_splines_keep_the_tolerance) {
    for_each_case(340000, 300, [&](Random &random, uint64_t seed) {
        const auto data = random_case(random, 10);
        const auto g = create(data);
        const double tolerance = extent(data) * random.magnitude(1e-6, 1);
        const Made result = simplify(g.get(), tolerance);
        ASSERT_LE(result.bound, tolerance) << where(seed, data);
        const long double found = dense_deviation(data, read_back(result.spline.get()), 8);
        ASSERT_LE(found, result.bound) << where(seed, data);
    });
}

TEST(Reduction, the_choice_of_knots_is_free_of_scale) {
    for_each_case(350000, 400, [](Random &random, uint64_t seed) {
        const auto data = random_case(random, 10);
        const double tolerance = extent(data) * random.magnitude(1e-3, 10);
        const double scale = std::ldexp(1.0, random.whole(-40, 40));
        const Made one = reduce_knots(create(data).get(), -1, tolerance);
        const Made other = reduce_knots(create(scaled(data, scale)).get(), -1, tolerance * scale);
        const auto a = read_back(one.spline.get());
        const auto b = read_back(other.spline.get());
        ASSERT_TRUE(same_bits(a.all_knots(), b.all_knots())) << where(seed, data) << hex(scale);
        ASSERT_EQ(one.bound * scale, other.bound) << where(seed, data) << hex(scale);
        ASSERT_EQ(scaled(a, scale).points, b.points) << where(seed, data) << hex(scale);
    });
}

// Points of any weights, some of them at infinity or negative.
TEST(Reduction, bounds_of_homogeneous_splines_are_bounds) {
    int finite = 0;
    for_each_case(360000, 600, [&](Random &random, uint64_t seed) {
        auto data = random_case(random, 0);
        data.weights.assign(static_cast<size_t>(data.point_count()), 1.0);
        std::vector<double> records;
        const int64_t distinct = data.counts[0] - (data.periodic(0) ? data.degrees[0] : 0);
        for (int64_t i = 0; i < data.point_count(); ++i) {
            const auto at = static_cast<size_t>(i);
            data.weights[at] = i >= distinct ? data.weights[at - static_cast<size_t>(distinct)]
                                             : random.between(random.chance(10) ? -0.2 : 0.3, 1);
            for (int c = 0; c < data.dim; ++c) {
                records.push_back(data.weights[at] * data.coordinate(i, c));
            }
            records.push_back(data.weights[at]);
        }
        nurbs *made = nullptr;
        require_ok(nurbs_create_homogeneous(1, data.degrees.data(), data.counts.data(), data.knots[0].data(),
                                            std::ssize(data.knots[0]), data.dim, records.data(), 0, 0,
                                            data.flags, &made));
        const Handle g(made);
        const Made result = reduce_knots(made, 0, extent(data));
        auto f = homogeneous(made), h = homogeneous(result.spline.get());
        long double found = 0;
        for (const SampledPlace &place : dense_places(f, h, 0, 8)) {
            const reference::Sides left{place.left, false, false};
            const auto a = long_point(f, &place.t, left), b = long_point(h, &place.t, left);
            long double square = 0;
            for (size_t c = 0; c + 1 < a.size(); ++c) {
                square += std::pow(a[c] / a.back() - b[c] / b.back(), 2.0L);
            }
            found = std::max(found, std::sqrt(square));
        }
        ASSERT_LE(found, result.bound + 1e-12L * extent(data)) << where(seed, data);
        finite += result.bound > 0 ? 1 : 0;
    });
    std::printf("%d splines were reduced\n", finite);
}

// What was inserted goes before anything that carries shape, whatever the tolerance allows.
TEST(Reduction, inserted_knots_go_first) {
    Random random(315000);
    for (const auto &[p, clamped, rational] : {std::tuple(1, true, false),
                                               {3, true, false},
                                               {5, true, false},
                                               {7, true, false},
                                               {3, false, false},
                                               {5, false, true},
                                               {3, true, true},
                                               {7, true, true}}) {
        SplineData data;
        data.degrees = {p};
        data.dim = 3;
        data.counts = {p + 9};
        data.knots.emplace_back();
        for (int i = -p; i <= 9 + p; ++i) {
            data.knots[0].push_back(clamped ? std::clamp(i, 0, 9) : i);
        }
        for (int i = 0; i < p + 9 && rational; ++i) {
            data.weights.push_back(random.between(0.5, 2));
        }
        for (int i = 0; i < 3 * (p + 9); ++i) {
            data.points.push_back(random.between(-1, 1));
        }
        std::vector<double> inserted;
        for (int i = 0; i < 300; ++i) {
            inserted.push_back(0.03 * (i + 0.5));
        }
        nurbs *fine = nullptr;
        require_ok(nurbs_refine(create(data).get(), 0, std::ssize(inserted), inserted.data(), &fine));
        const Handle refined(fine);
        for (const double tolerance : {1e-10, 1e-7, 1e-5, 1e-3}) {
            const Made made = reduce_knots(refined.get(), 0, tolerance);
            EXPECT_EQ(read_back(made.spline.get()).counts[0], p + 9)
                << p << clamped << rational << ' ' << tolerance;
            EXPECT_LE(made.bound, 1e-11) << p << clamped << rational << ' ' << tolerance;
        }
    }
}

} // namespace

} // namespace reduction_test

// Every constructor makes the same spline as nurbs_create() with the knots written out.
#include "support/cases.h"
#include "support/handle.h"

#include <gtest/gtest.h>

namespace constructors_test {

using namespace support;

namespace {

const double *weights_of(const SplineData &data) {
    return data.rational() ? data.weights.data() : nullptr;
}

// Everything that can be read from a spline, and its points at some parameters, bit for bit.
void expect_same(const SplineData &want, const nurbs *g, Random &random, uint64_t seed) {
    const auto got = read_back(g);
    ASSERT_EQ(got.degrees, want.degrees) << where(seed, want);
    ASSERT_EQ(got.counts, want.counts) << where(seed, want);
    ASSERT_EQ(got.flags, want.flags) << where(seed, want);
    ASSERT_TRUE(same_bits(got.all_knots(), want.all_knots())) << where(seed, want) << describe(got);
    ASSERT_TRUE(same_bits(got.points, want.points)) << where(seed, want) << describe(got);
    ASSERT_TRUE(same_bits(got.weights, want.weights)) << where(seed, want) << describe(got);
    const auto params = random_params(random, want, 10);
    ASSERT_TRUE(same_bits(eval(g, params), eval(create(want).get(), params))) << where(seed, want);
}

TEST(Constructors, create_gives_back_what_it_was_given) {
    for_each_case(70000, 200, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 4));
        expect_same(data, create(data).get(), random, seed);
    });
}

// The end knots of the full vector, as nurbs_create_short() promises to set them.
void set_end_knots(SplineData &data) {
    for (int axis = 0; axis < data.axes(); ++axis) {
        auto &t = data.knots[static_cast<size_t>(axis)];
        const auto count = static_cast<size_t>(data.counts[static_cast<size_t>(axis)]);
        const size_t last = t.size() - 1;
        const size_t distinct = count - static_cast<size_t>(data.degrees[static_cast<size_t>(axis)]);
        const double period = data.upper(axis) - data.lower(axis);
        t[0] = data.periodic(axis) ? t[distinct] - period : t[1];
        t[last] = data.periodic(axis) ? t[last - distinct] + period : t[last - 1];
    }
}

nurbs_status create_short(const SplineData &data, Handle &out) {
    std::vector<double> knots;
    for (const auto &axis : data.knots) {
        knots.insert(knots.end(), axis.begin() + 1, axis.end() - 1);
    }
    nurbs *g = nullptr;
    const nurbs_status status =
        nurbs_create_short(data.axes(), data.degrees.data(), data.counts.data(), knots.data(),
                           static_cast<int64_t>(knots.size()), data.dim, data.points.data(), 0, 0,
                           weights_of(data), 0, data.flags, &g);
    out.reset(g);
    return status;
}

Recipe exact_recipe(Random &random) {
    Recipe recipe = random_recipe(random, random.whole(1, 3), 3);
    for (AxisRecipe &axis : recipe.axes) {
        axis.degree = std::max(axis.degree, 1);
        axis.spacing = Spacing::few_bits; // knots one period away are then exact
        axis.placement = Placement::origin;
    }
    return recipe;
}

bool creatable(const SplineData &data) {
    Handle g;
    return try_create(data, g) == NURBS_OK;
}

TEST(Constructors, short_knots) {
    int cases = 0;
    int compared = 0;
    for_each_case(71000, 300, [&](Random &random, uint64_t seed) {
        ++cases;
        auto data = random_spline(random, exact_recipe(random));
        set_end_knots(data);
        if (!creatable(data)) {
            return; // doubling an end knot of full multiplicity makes it one too many
        }
        Handle g;
        ASSERT_EQ(create_short(data, g), NURBS_OK) << where(seed, data) << last_error();
        expect_same(data, g.get(), random, seed);
        ++compared;
    });
    EXPECT_GT(3 * compared, cases) << "most cases fell away";
}

// What the missing knots are does not matter inside the domain.
TEST(Constructors, end_knots_influence_nothing) {
    int cases = 0;
    int compared = 0;
    for_each_case(72000, 300, [&](Random &random, uint64_t seed) {
        ++cases;
        Recipe recipe = random_recipe(random, random.whole(1, 2), 5);
        for (AxisRecipe &axis : recipe.axes) {
            axis.degree = std::max(axis.degree, 1);
            axis.form = random.chance(50) ? KnotForm::unclamped : KnotForm::half_clamped;
        }
        const auto data = random_spline(random, recipe);
        Handle g;
        if (create_short(data, g) != NURBS_OK) {
            return;
        }
        const auto params = random_params(random, data, 20);
        ASSERT_TRUE(same_bits(eval(g.get(), params), eval(create(data).get(), params))) << where(seed, data);
        ++compared;
    });
    EXPECT_GT(3 * compared, cases) << "most cases fell away";
}

TEST(Constructors, knots_with_multiplicities) {
    for_each_case(73000, 300, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 4));
        std::vector<int64_t> counts;
        std::vector<double> distinct;
        std::vector<int32_t> multiplicities;
        for (const auto &axis : data.knots) {
            const size_t before = distinct.size();
            for (size_t i = 0; i < axis.size(); ++i) {
                if (i > 0 && axis[i] == axis[i - 1]) {
                    ++multiplicities.back();
                } else {
                    distinct.push_back(axis[i]);
                    multiplicities.push_back(1);
                }
            }
            counts.push_back(static_cast<int64_t>(distinct.size() - before));
        }
        nurbs *g = nullptr;
        require_ok(nurbs_create_multiplicities(
            data.axes(), data.degrees.data(), data.counts.data(), counts.data(), distinct.data(),
            multiplicities.data(), data.dim, data.points.data(), 0, 0, weights_of(data), 0, data.flags, &g));
        const Handle handle(g);
        expect_same(data, g, random, seed);
        int64_t number = 0;
        std::vector<double> knots(static_cast<size_t>(counts[0]));
        std::vector<int32_t> times(static_cast<size_t>(counts[0]));
        require_ok(nurbs_distinct_knots(g, 0, counts[0], knots.data(), times.data(), &number));
        ASSERT_EQ(number, counts[0]) << where(seed, data);
        ASSERT_TRUE(std::equal(knots.begin(), knots.end(), distinct.begin())) << where(seed, data);
        ASSERT_TRUE(std::equal(times.begin(), times.end(), multiplicities.begin())) << where(seed, data);
    });
}

TEST(Constructors, bezier) {
    for_each_case(74000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        for (AxisRecipe &axis : recipe.axes) {
            axis.form = KnotForm::clamped;
            axis.spans = 1;
        }
        auto data = random_spline(random, recipe);
        for (size_t k = 0; k < data.knots.size(); ++k) {
            const auto half = data.knots[k].begin() + data.degrees[k] + 1;
            std::fill(data.knots[k].begin(), half, 0.0);
            std::fill(half, data.knots[k].end(), 1.0);
        }
        nurbs *g = nullptr;
        require_ok(nurbs_create_bezier(data.axes(), data.degrees.data(), data.dim, data.points.data(), 0, 0,
                                       weights_of(data), 0, &g));
        const Handle handle(g);
        expect_same(data, g, random, seed);
    });
}

// Weights that are powers of two: homogeneous and Cartesian points then say the same without rounding.
TEST(Constructors, homogeneous) {
    for_each_case(75000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        recipe.weights = Weights::extreme;
        recipe.short_numbers = true;
        const auto data = random_spline(random, recipe);
        const auto plain = create(data);
        const auto records = homogeneous_points(plain.get());
        const auto knots = data.all_knots();
        nurbs *g = nullptr;
        require_ok(nurbs_create_homogeneous(data.axes(), data.degrees.data(), data.counts.data(),
                                            knots.data(), static_cast<int64_t>(knots.size()), data.dim,
                                            records.data(), 0, 0, data.flags, &g));
        const Handle handle(g);
        expect_same(data, g, random, seed);
        ASSERT_TRUE(same_bits(homogeneous_points(g), records)) << where(seed, data);
    });
}

TEST(Constructors, strided_points_and_weights) {
    for_each_case(76000, 100, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 2, 4);
        recipe.weights = Weights::moderate;
        const auto data = random_spline(random, recipe);
        const int64_t n = data.point_count();
        std::vector<double> columns(static_cast<size_t>(n * data.dim)); // Fortran x(n, dim)
        std::vector<double> weights(static_cast<size_t>(3 * n));
        for (int64_t i = 0; i < n; ++i) {
            weights[static_cast<size_t>(3 * i)] = data.weight(i);
            for (int c = 0; c < data.dim; ++c) {
                columns[static_cast<size_t>(c * n + i)] = data.coordinate(i, c);
            }
        }
        const auto knots = data.all_knots();
        nurbs *g = nullptr;
        require_ok(nurbs_create(2, data.degrees.data(), data.counts.data(), knots.data(),
                                static_cast<int64_t>(knots.size()), data.dim, columns.data(), 1, n,
                                weights.data(), 3, data.flags, &g));
        const Handle handle(g);
        expect_same(data, g, random, seed);
        nurbs *clone = nullptr;
        require_ok(nurbs_clone(g, &clone));
        const Handle second(clone);
        expect_same(data, clone, random, seed);
        nurbs *moved = nullptr;
        require_ok(nurbs_with_points(g, data.points.data(), 0, 0, nullptr, 0, &moved));
        const Handle third(moved);
        expect_same(data, moved, random, seed);
    });
}

} // namespace

} // namespace constructors_test

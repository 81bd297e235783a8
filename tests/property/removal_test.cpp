// Knots removed: the bound returned holds, the tolerance holds, what was inserted comes back.
#include "property/dense_samples.h"

namespace removal_test {

using namespace support;

namespace {

struct Removed {
    Handle spline;
    int32_t times = 0;
    double bound = -1;
};

Removed remove_knot(const nurbs *g, int axis, double knot, int times, double tolerance) {
    nurbs *out = nullptr;
    Removed result;
    require_ok(nurbs_remove_knot(g, axis, knot, times, tolerance, &result.times, &result.bound, &out));
    result.spline.reset(out);
    return result;
}

SplineData random_case(Random &random, int surfaces) {
    const int axes = random.chance(surfaces) ? 2 : 1;
    Recipe recipe = random_recipe(random, axes, axes == 1 ? 6 : 3);
    recipe.weights = std::min(recipe.weights, Weights::extreme);
    return random_spline(random, recipe);
}

// A knot inside the domain, NaN if there is none.
double inner_knot(Random &random, const SplineData &data, int axis) {
    std::vector<double> knots = data.knots[static_cast<size_t>(axis)];
    std::erase_if(knots, [&](double t) { return t <= data.lower(axis) || t >= data.upper(axis); });
    return knots.empty() ? std::nan("") : knots[random.bits() % knots.size()];
}

TEST(Removal, the_bound_is_one) {
    std::vector<long double> ratios;
    for_each_case(300000, 6000, [&](Random &random, uint64_t seed) {
        const auto data = random_case(random, 10);
        const int axis = random.whole(0, data.axes() - 1);
        const double knot = inner_knot(random, data, axis);
        if (std::isnan(knot)) {
            return;
        }
        const auto g = create(data);
        const Removed result = remove_knot(g.get(), axis, knot, random.whole(1, 3), INFINITY);
        const long double found = dense_deviation(data, read_back(result.spline.get()), 12);
        ASSERT_LE(found, result.bound) << where(seed, data) << " without " << hex(knot);
        if (found > 1e-8 * extent(data)) {
            ratios.push_back(result.bound / found);
        }
    });
    EXPECT_LE(median(ratios, "bound / sampled deviation, removal"), 1.5L);
}

long double largest_move(const nurbs *before, const nurbs *after) {
    const auto want = homogeneous(before).points, found = homogeneous(after).points;
    long double move = want.size() == found.size() ? 0 : INFINITY;
    for (size_t i = 0; i < std::min(want.size(), found.size()); ++i) {
        move = std::max(move, std::fabs(static_cast<long double>(want[i]) - found[i]));
    }
    return move;
}

double homogeneous_extent(const nurbs *g) {
    return extent(homogeneous(g));
}

// Weights that differ much let small ones be lost beside large ones, so that these cases have none of them.
TEST(Removal, inserted_knots_come_back) {
    WorstErrors worst("insert -> remove, in eps * hull");
    for_each_case(301000, 1500, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(15) ? 2 : 1;
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 9 : 3);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const auto data = random_spline(random, recipe);
        const int axis = random.whole(0, axes - 1);
        const auto k = static_cast<size_t>(axis);
        const double knot = random_new_knot(random, data, axis);
        const auto present = std::count(data.knots[k].begin(), data.knots[k].end(), knot);
        if (knot <= data.lower(axis) || knot >= data.upper(axis) || present + 1 > data.degrees[k]) {
            return;
        }
        const int times = random.whole(1, data.degrees[k] - static_cast<int>(present));
        const auto g = create(data);
        Handle more;
        try {
            more = insert(g.get(), axis, knot, times);
        } catch (const std::runtime_error &) {
            return; // copies of the knot beside the seam
        }
        const double hull = std::max(extent(data), homogeneous_extent(g.get()));
        double steps = 20 * std::pow(2.0, data.degrees[k]);
        for (const int32_t p : data.degrees) {
            steps += 80 * (p + 1);
        }
        const double tolerance = static_cast<double>(steps * eps) * hull;
        const Removed back = remove_knot(more.get(), axis, knot, times, tolerance);
        if (!data.periodic(axis) || data.counts[k] > 2 * data.degrees[k] + 1) {
            ASSERT_EQ(back.times, times) << where(seed, data) << hex(knot);
            const long double moved = largest_move(g.get(), back.spline.get());
            ASSERT_LE(moved, tolerance) << where(seed, data) << hex(knot);
            worst.add(data.degrees[k], moved / tolerance, moved / (eps * hull));
        }
    });
}

TEST(Removal, tolerances_hold) {
    for_each_case(302000, 1500, [](Random &random, uint64_t seed) {
        const auto data = random_case(random, 5);
        const int axis = random.whole(0, data.axes() - 1);
        const double knot = inner_knot(random, data, axis);
        if (std::isnan(knot)) {
            return;
        }
        const auto g = create(data);
        const double tolerance = random.chance(20) ? 0 : extent(data) * random.magnitude(1e-9, 2);
        const Removed result = remove_knot(g.get(), axis, knot, random.whole(1, 4), tolerance);
        ASSERT_TRUE(result.bound <= tolerance) << where(seed, data) << hex(knot);
        ASSERT_TRUE(result.times > 0 || result.bound == 0) << where(seed, data) << hex(knot);
        ASSERT_LE(dense_deviation(data, read_back(result.spline.get()), 6), tolerance) << where(seed, data);
    });
}

} // namespace

} // namespace removal_test

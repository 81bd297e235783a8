// Knots removed: the bound returned holds, the tolerance holds, what was inserted comes back.
#include "property/dense_samples.h"

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

double extent(const SplineData &data) {
    double size = 0;
    for (const double x : data.points) {
        size = std::max(size, std::fabs(x));
    }
    return size;
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

} // namespace

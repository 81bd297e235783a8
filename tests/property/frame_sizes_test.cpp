// Frames and curvature of models and knots of every size: powers of two change no bit of a direction and
// scale curvatures exactly.
#include "property/surface_normals.h"

namespace frame_sizes_test {

using namespace support;
using reference::eps;
using surface_normals::Exact;

namespace {

using Values = std::vector<double>;

// Powers of two by which points and knots are multiplied so that no bit is lost, nor a product with a weight.
struct Sizes {
    int points, knots;
};

bool exact(const Values &values, int exponent) {
    return std::all_of(values.begin(), values.end(), [exponent](double x) {
        const double y = std::ldexp(x, exponent);
        return std::isfinite(0x1p21 * y) && std::ldexp(y, -exponent) == x;
    });
}

Sizes random_sizes(Random &random, const SplineData &data, const Values &params) {
    Sizes sizes{};
    do {
        sizes = {random.whole(-1000, 1000), random.chance(30) ? 0 : random.whole(-400, 400)};
    } while (!exact(data.points, sizes.points) || !exact(data.all_knots(), sizes.knots) ||
             !exact(params, sizes.knots));
    return sizes;
}

Values times_power(Values values, int exponent) {
    for (double &x : values) {
        x = std::ldexp(x, exponent);
    }
    return values;
}

SplineData resized(const SplineData &data, Sizes sizes) {
    return scaled(data, std::ldexp(1, sizes.points), std::ldexp(1, sizes.knots));
}

// Values that are those times the power of two, but where that leaves double precision.
void expect_scaled(const Values &found, const Values &base, int exponent, const std::string &where) {
    ASSERT_EQ(found.size(), base.size());
    for (size_t i = 0; i < base.size(); ++i) {
        ASSERT_PRED2([](double a, double b) { return same_bits(a, b); }, found[i],
                     std::ldexp(base[i], exponent))
            << "value " << i << " of " << base[i] << where;
    }
}

Recipe recipe_of(Random &random, int axes, int dim) {
    Recipe recipe = random_recipe(random, axes, axes == 1 ? 9 : 5);
    recipe.dim = dim;
    recipe.short_numbers = random.chance(60);
    return recipe;
}

TEST(FrameSizes, of_curves) {
    int large = 0;
    for_each_case(2710000, 1500, [&](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, recipe_of(random, 1, random.whole(2, 3)));
        const Values params = away_from_underflow(random_params(random, data, random.chance(50) ? 1 : 20));
        const Sizes sizes = random_sizes(random, data, params);
        const uint32_t flags = random.chance(30) ? NURBS_LEFT : 0;
        const CurveFrames base = curve_frames(create(data).get(), params, flags);
        const CurveFrames found =
            curve_frames(create(resized(data, sizes)).get(), times_power(params, sizes.knots), flags);
        const std::string place = where(seed, data) + " points 2^" + std::to_string(sizes.points) +
                                  " knots 2^" + std::to_string(sizes.knots);
        ASSERT_EQ(found.status, base.status) << place;
        expect_scaled(found.tangents, base.tangents, 0, place);
        expect_scaled(found.normals, base.normals, 0, place);
        expect_scaled(found.binormals, base.binormals, 0, place);
        expect_scaled(found.curvatures, base.curvatures, -sizes.points, place);
        expect_scaled(found.torsions, base.torsions, -sizes.points, place);
        large += std::abs(sizes.points) > 500 ? 1 : 0;
    });
    EXPECT_GE(large, of_whole_run(500));
}

TEST(FrameSizes, of_surfaces) {
    for_each_case(2720000, 500, [&](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, recipe_of(random, 2, 3));
        const Values params = away_from_underflow(random_params(random, data, random.chance(50) ? 1 : 20));
        const Sizes sizes = random_sizes(random, data, params);
        const Handle g = create(data), h = create(resized(data, sizes));
        const Values moved = times_power(params, sizes.knots);
        const std::string place = where(seed, data) + " points 2^" + std::to_string(sizes.points) +
                                  " knots 2^" + std::to_string(sizes.knots);
        const SurfaceFrames base = surface_frames(g.get(), params), found = surface_frames(h.get(), moved);
        ASSERT_EQ(found.status, base.status) << place;
        expect_scaled(found.normals, base.normals, 0, place);
        const Curvatures curved = surface_curvatures(g.get(), params),
                         bent = surface_curvatures(h.get(), moved);
        ASSERT_EQ(bent.status, curved.status) << place;
        expect_scaled(bent.directions, curved.directions, 0, place);
        expect_scaled(bent.principal, curved.principal, -sizes.points, place);
        expect_scaled(bent.mean, curved.mean, -sizes.points, place);
        expect_scaled(bent.gaussian, curved.gaussian, -2 * sizes.points, place);
    });
}

// Points and derivatives are those of evaluation, and a grid has what its points have singly.
TEST(FrameSizes, of_grids) {
    for_each_case(2730000, 100, [&](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, recipe_of(random, 2, 3));
        const Sizes sizes = random_sizes(random, data, data.all_knots());
        const SplineData large = resized(data, sizes);
        const Handle h = create(large);
        std::vector<Values> axes(2);
        Values list;
        for (size_t k = 0; k < 2; ++k) {
            const auto at = static_cast<size_t>(large.degrees[k]);
            axes[k] = {large.knots[k][at],
                       large.lower(static_cast<int>(k)) / 2 + large.upper(static_cast<int>(k)) / 2};
        }
        for (const double u : axes[0]) {
            list.insert(list.end(), {u, axes[1][0], u, axes[1][1]});
        }
        const SurfaceFrames grid = surface_grid_frames(h.get(), axes), single = surface_frames(h.get(), list);
        ASSERT_EQ(grid.status, single.status) << where(seed, data);
        for (const auto part :
             {&SurfaceFrames::points, &SurfaceFrames::du, &SurfaceFrames::dv, &SurfaceFrames::normals}) {
            ASSERT_TRUE(same_bits(grid.*part, single.*part)) << where(seed, data);
        }
        ASSERT_TRUE(same_bits(single.points, eval(h.get(), list))) << where(seed, data);
    });
}

TEST(FrameSizes, of_rotation_minimizing_frames) {
    for_each_case(2740000, 500, [&](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, recipe_of(random, 1, 3));
        Values params = away_from_underflow(random_params(random, data, 30));
        std::sort(params.begin(), params.end());
        const Sizes sizes = random_sizes(random, data, params);
        const CurveFrames base = minimal_frames(create(data).get(), params);
        const CurveFrames found =
            minimal_frames(create(resized(data, sizes)).get(), times_power(params, sizes.knots));
        const std::string place = where(seed, data) + " points 2^" + std::to_string(sizes.points);
        ASSERT_EQ(found.status, base.status) << place;
        expect_scaled(found.tangents, base.tangents, 0, place);
        expect_scaled(found.normals, base.normals, 0, place);
        expect_scaled(found.binormals, base.binormals, 0, place);
    });
}

// What has no influence on a span has none on its frames, however large or small it is; neither has a change
// of size along the curve.
TEST(FrameSizes, of_a_part_of_a_curve) {
    for_each_case(2750000, 300, [&](Random &random, uint64_t seed) {
        const int degree = random.whole(1, 5), spans = degree + 3;
        SplineData data{{degree}, {degree + spans}, {{}}, 3, {}, {}, 0};
        for (int i = 0; i < spans + 2 * degree + 1; ++i) {
            data.knots[0].push_back(std::clamp(i - degree, 0, spans));
        }
        for (int64_t i = 0; i < 3 * data.counts[0]; ++i) {
            data.points.push_back(random.whole(-64, 64) / 8.0);
        }
        SplineData other = data;
        const int first = random.whole(-1000, 1000), last = random.whole(-1000, 1000);
        for (size_t i = 0; i < data.points.size(); ++i) {
            const bool near = i < 3 * static_cast<size_t>(degree + 1);
            other.points[i] = std::ldexp(data.points[i], near ? first : last);
        }
        const CurveFrames base = curve_frames(create(data).get(), {0.25, 0.5, 0.9375});
        const CurveFrames found = curve_frames(create(other).get(), {0.25, 0.5, 0.9375});
        ASSERT_EQ(found.status, base.status) << where(seed, other);
        expect_scaled(found.tangents, base.tangents, 0, where(seed, other));
        expect_scaled(found.binormals, base.binormals, 0, where(seed, other));
        expect_scaled(found.curvatures, base.curvatures, -first, where(seed, other));
    });
}

// An arch of known curvature, up to the largest and down to the smallest numbers.
TEST(FrameSizes, of_a_parabola) {
    for (int k = -1074; k <= 1022; ++k) {
        const double unit = std::ldexp(1, k);
        const SplineData data{{2}, {3}, {{0, 0, 0, 1, 1, 1}}, 2, {0, 0, unit, unit, 2 * unit, 0}, {}, 0};
        const CurveFrames found = curve_frames(create(data).get(), {0.5});
        ASSERT_EQ(found.status[0], 0) << k;
        ASSERT_EQ(found.tangents, (Values{1, 0})) << k;
        ASSERT_EQ(found.curvatures[0], -std::ldexp(1, -k)) << k;
    }
}

// A clamped axis with a span much shorter than those beside it.
std::vector<double> uneven_knots(int degree, double gap) {
    std::vector<double> knots(static_cast<size_t>(degree) + 1, -1);
    knots.insert(knots.end(), {0, gap});
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, 1);
    return knots;
}

SplineData uneven_spline(Random &random, int axes, int dim, double gap) {
    SplineData data;
    data.dim = dim;
    for (int k = 0; k < axes; ++k) {
        const int degree = random.whole(2, axes == 1 ? 6 : 4);
        data.degrees.push_back(degree);
        data.counts.push_back(degree + 3);
        data.knots.push_back(uneven_knots(degree, gap));
    }
    for (int64_t i = 0; i < data.point_count() * dim; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    return data;
}

// There derivatives of one order are far larger than those of another, and their products leave double
// precision; long double has room for them.
TEST(FrameSizes, of_a_short_span_between_long_ones) {
    for_each_case(2760000, 400, [&](Random &random, uint64_t seed) {
        const int dim = random.whole(2, 3);
        const double gap = std::ldexp(1, -random.whole(20, 600)), t = random.whole(1, 7) / 8.0 * gap;
        const SplineData data = uneven_spline(random, 1, dim, gap);
        const auto exact = reference::exact_derivatives(data, 2, &t);
        const auto sizes = reference::magnitudes(data, 2, &t);
        const auto vector = [&](const std::vector<reference::Fraction> &x) {
            const auto at = [&](size_t c) {
                return c < x.size() ? surface_normals::approximate(surface_normals::rational(x[c])) : 0.0L;
            };
            return Vector{at(0), at(1), at(2)};
        };
        const Vector first = vector(exact[1]), second = vector(exact[2]);
        long double size_1 = 0, size_2 = 0;
        for (size_t c = 0; c < static_cast<size_t>(dim); ++c) {
            size_1 = std::hypot(size_1, sizes[1][c]);
            size_2 = std::hypot(size_2, sizes[2][c]);
        }
        const long double speed = norm(first), curvature = norm(cross(first, second)) / speed / speed / speed;
        const long double bound = 64 * eps * (size_2 + norm(second) * size_1 / speed) / speed / speed;
        const CurveFrames found = curve_frames(create(data).get(), {t});
        ASSERT_EQ(found.status[0], 0) << where(seed, data);
        ASSERT_LE(std::fabs(std::fabs(found.curvatures[0]) - curvature), bound) << where(seed, data);
    });
}

TEST(FrameSizes, of_surfaces_with_short_spans) {
    for_each_case(2770000, 200, [&](Random &random, uint64_t seed) {
        const double gap = std::ldexp(1, -random.whole(20, 600));
        const SplineData data = uneven_spline(random, 2, 3, gap);
        const Values param{random.whole(1, 7) / 8.0 * gap, random.whole(1, 7) / 8.0 * gap};
        const Exact exact = surface_normals::exact_at(data, param.data());
        const SurfaceFrames found = surface_frames(create(data).get(), param);
        const Vector want = surface_normals::direction(exact.product);
        ASSERT_EQ(found.status[0], 0) << where(seed, data);
        ASSERT_LE(norm(minus(vector_at(found.normals, 0), want)),
                  4 * exact.noise() / norm(surface_normals::approximate(exact.product)) + 8 * eps)
            << where(seed, data);
    });
}

} // namespace

} // namespace frame_sizes_test

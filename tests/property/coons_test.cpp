// Bilinearly blended surfaces: boundaries and the defining formula against exact values.
#include "property/coons_cases.h"

namespace coons_test {

using namespace support;

namespace {

// How far boundary `i` of a surface is from a curve of the same domain, everywhere.
long double boundary_error(const SplineData &surface, size_t i, const SplineData &curve) {
    const int axis = i < 2 ? 0 : 1;
    const std::vector<double> breaks =
        reference::united(reference::breaks_of(surface, 1 - axis), reference::breaks_of(curve, 0));
    long double largest = 0;
    for (size_t s = 0; s + 1 < breaks.size(); ++s) {
        largest = std::max(largest, reference::largest_difference(
                                        reference::edge(surface, axis, i % 2 == 1, breaks[s], breaks[s + 1]),
                                        reference::piece(curve, breaks[s], breaks[s + 1])));
    }
    return largest;
}

void expect_boundaries(uint64_t base, int cases, int max_degree, bool rational, bool clamped,
                       long double allowed) {
    WorstErrors worst("boundaries of Coons surfaces, in eps * hull");
    for_each_case(base, cases, [&](Random &random, uint64_t seed) {
        const Boundaries given = random_boundaries(random, max_degree, rational, clamped);
        Handle made;
        require_ok(coons(handles_of(given.curves), clamped ? 0 : 1e-12, made));
        const SplineData surface = read_back(made.get());
        for (size_t i = 0; i < 4; ++i) {
            const SplineData &curve = given.curves[i];
            const long double unit = eps * extent(curve);
            const long double error = boundary_error(surface, i, curve) - given.gap / 2;
            worst.add(curve.degrees[0], error / (allowed * unit), error / unit);
            ASSERT_LE(error, allowed * unit) << "boundary " << i << where(seed, curve);
        }
    });
}

double largest_extent(const std::vector<SplineData> &curves) {
    double largest = 0;
    for (const SplineData &curve : curves) {
        largest = std::max(largest, extent(curve));
    }
    return largest;
}

SplineData coons_of(const std::vector<SplineData> &curves, double tolerance = 0) {
    Handle made;
    require_ok(coons(handles_of(curves), tolerance, made));
    return read_back(made.get());
}

std::vector<Handle> boundaries_of(const nurbs *g) {
    nurbs_list *list = nullptr;
    require_ok(nurbs_boundaries(g, &list));
    int64_t count = 0;
    require_ok(nurbs_list_count(list, &count));
    std::vector<Handle> handles;
    for (int64_t i = 0; i < count; ++i) {
        nurbs *one = nullptr;
        require_ok(nurbs_list_get(list, i, &one));
        handles.emplace_back(one);
    }
    nurbs_list_destroy(list);
    return handles;
}

// A quarter of the unit circle in the plane of two coordinates, raised to a height, with weights multiplied.
SplineData quarter(size_t x, size_t y, double turn, double scale) {
    SplineData arc;
    arc.degrees = {2};
    arc.counts = {3};
    arc.knots = {{0, 0, 0, 8, 8, 8}};
    arc.dim = 3;
    arc.points.assign(9, turn);
    const double corner[][2] = {{1, 0}, {1, 1}, {0, 1}};
    for (size_t i = 0; i < 3; ++i) {
        arc.points[3 * i + x] = corner[i][0];
        arc.points[3 * i + y] = corner[i][1];
    }
    arc.weights = {scale, scale * 0.70710678118654757, scale};
    return arc;
}

SplineData segment(const SplineData &from, bool from_end, const SplineData &to, bool to_end) {
    SplineData line;
    line.degrees = {1};
    line.counts = {2};
    line.knots = {{0, 0, 8, 8}};
    line.dim = 3;
    for (const Corner &point : {end_of(from, from_end), end_of(to, to_end)}) {
        line.points.insert(line.points.end(), point.begin(), point.end());
    }
    return line;
}

} // namespace

TEST(Coons, polynomial_boundaries_are_met_everywhere) {
    expect_boundaries(410000, 45, 9, false, true, 2);
}
TEST(Coons, rational_boundaries_are_met_everywhere) {
    expect_boundaries(411000, 40, 5, true, true, 3);
}
TEST(Coons, unclamped_boundaries_are_met_everywhere) {
    expect_boundaries(412000, 30, 5, true, false, 4);
}

// Every control point is a sum of four products of factors that are within 2 eps, of magnitudes that add up
// to three hulls; where denominators multiply, within 4.
TEST(Coons, agrees_with_the_matrix_form) {
    WorstErrors worst("Coons surfaces, in eps * hull");
    for_each_case(413000, 200, [&](Random &random, uint64_t seed) {
        const bool rational = random.chance(50);
        const Boundaries given = random_boundaries(random, rational ? 4 : 7, rational, random.chance(50));
        std::vector<SplineData> curves = given.curves;
        const reference::BoundaryBlend formula(curves);
        curves[1] = mapped(curves[1], 3);
        curves[3] = mapped(curves[3], -1);
        const SplineData surface = coons_of(curves, 1e-12);
        ASSERT_EQ(surface.lower(0), 0.0);
        ASSERT_EQ(surface.upper(1), 8.0);
        const double unit = static_cast<double>(eps) * largest_extent(curves),
                     error = formula_error(surface, formula, random);
        worst.add(surface.degrees[0], error / (20 * unit), error / unit);
        ASSERT_LE(error, 20 * unit) << where(seed, surface);
    });
}

TEST(Coons, reproduces_what_it_blended) {
    for_each_case(414000, 60, [&](Random &random, uint64_t seed) {
        const Boundaries given = random_boundaries(random, 6, false, true);
        Handle made, again;
        require_ok(coons(handles_of(given.curves), 0, made));
        require_ok(coons(boundaries_of(made.get()), 0, again));
        const SplineData first = read_back(made.get()), second = read_back(again.get());
        for (int i = 0; i < 5; ++i) {
            const std::vector<double> at{random.whole(0, 64) / 8.0, random.whole(0, 64) / 8.0};
            ASSERT_LE(difference(reference::exact_value(first, at), reference::exact_value(second, at)),
                      20 * static_cast<double>(eps) * extent(first))
                << where(seed, first);
        }
    });
}

TEST(Coons, gaps_are_split_evenly) {
    for_each_case(415000, 15, [&](Random &random, uint64_t seed) {
        Boundaries given = random_boundaries(random, 4, random.chance(50), true);
        for (SplineData &curve : given.curves) {
            for (size_t c = 0; c < 3; ++c) {
                curve.points[c] += random.between(-1, 1) * 1e-3;
            }
        }
        const double gap = largest_gap(handles_of(given.curves));
        Handle none;
        ASSERT_EQ(coons(handles_of(given.curves), gap * 0.999, none), NURBS_ERROR_GAP);
        const SplineData surface = coons_of(given.curves, gap);
        for (size_t i = 0; i < 4; ++i) {
            const long double error = boundary_error(surface, i, given.curves[i]);
            ASSERT_LE(error, gap / 2 + 3 * static_cast<double>(eps) * extent(given.curves[i]))
                << where(seed, surface);
        }
        ASSERT_LE(formula_error(surface, reference::BoundaryBlend(given.curves), random),
                  20 * static_cast<double>(eps) * largest_extent(given.curves));
    });
}

TEST(Coons, equal_denominators_are_shared_once) {
    const SplineData low = quarter(0, 1, 0, 1), high = quarter(0, 1, 1, 4);
    std::vector<SplineData> curves = {segment(low, false, high, false), segment(low, true, high, true), low,
                                      high};
    SplineData surface = coons_of(curves); // a quarter of a cylinder
    EXPECT_EQ(surface.degrees[0], 3);
    EXPECT_EQ(surface.degrees[1], 1);
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_LE(boundary_error(surface, i, curves[i]), 2 * eps);
    }
    curves[3].weights[1] *= 1.5;
    surface = coons_of(curves);
    EXPECT_EQ(surface.degrees[0], 5);
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_LE(boundary_error(surface, i, curves[i]), 3 * eps);
    }
    curves[2].weights.assign(3, 7.0);
    curves[3].weights.assign(3, 0.3);
    surface = coons_of(curves);
    EXPECT_FALSE(surface.rational());
    EXPECT_EQ(surface.degrees[0], 2);
}

TEST(Coons, blends_homogeneous_curves) {
    const SplineData low = quarter(0, 1, 0, 1), high = quarter(0, 1, 1, 1);
    std::vector<SplineData> curves = {segment(low, false, high, false), segment(low, true, high, true), low,
                                      high};
    std::vector<Handle> handles = handles_of(curves);
    for (const size_t i : {2U, 3U}) {
        nurbs *polynomial = nullptr, *projective = nullptr;
        require_ok(nurbs_to_homogeneous(handles[i].get(), &polynomial));
        require_ok(nurbs_from_homogeneous(polynomial, &projective));
        nurbs_destroy(polynomial);
        handles[i].reset(projective);
    }
    Handle made;
    require_ok(coons(handles, 1e-15, made));
    for (const double u : {0.0, 1.0, 3.5, 8.0}) {
        const std::vector<double> point = eval(made.get(), {u, 2}), same = eval(handles[2].get(), {u});
        EXPECT_NEAR(point[0], same[0], 8 * static_cast<double>(eps));
        EXPECT_NEAR(point[1], same[1], 8 * static_cast<double>(eps));
        EXPECT_NEAR(point[2], 0.25, 8 * static_cast<double>(eps));
    }
}

TEST(Coons, closed_boundaries_make_a_tube) {
    SplineData loop;
    loop.degrees = {2};
    loop.counts = {6};
    loop.knots = {{-4, -2, 0, 2, 4, 6, 8, 10, 12}};
    loop.dim = 3;
    loop.points = {1, 1, 0, -1, 1, 0, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    loop.flags = NURBS_PERIODIC;
    SplineData top = loop;
    for (size_t i = 2; i < top.points.size(); i += 3) {
        top.points[i] = 2;
    }
    const SplineData side = segment(loop, false, top, false);
    const SplineData surface = coons_of({side, side, loop, top});
    EXPECT_EQ(surface.flags, 0U);
    EXPECT_EQ(surface.counts[0], 6); // clamped over the knots 0, 2, 4, 6, 8
    const std::vector<double> point = eval(create(surface).get(), {8, 4}),
                              start = eval(create(surface).get(), {0, 4});
    EXPECT_EQ(point, start);
    EXPECT_EQ(point[2], 1.0);
}

TEST(Coons, takes_boundaries_of_degree_zero) {
    SplineData apex;
    apex.degrees = {0};
    apex.counts = {2};
    apex.knots = {{0, 4, 8}}; // the same point twice: a collapsed edge
    apex.dim = 3;
    apex.points = {0, 0, 0, 0, 0, 0};
    SplineData low = quarter(0, 1, 0, 1), high = quarter(0, 2, 0, 1);
    for (SplineData *curve : {&low, &high}) { // from the origin
        for (size_t i = 0; i < 9; i += 3) {
            curve->points[i] -= 1;
        }
    }
    const SplineData surface = coons_of({apex, segment(low, true, high, true), low, high});
    EXPECT_EQ(surface.degrees[1], 1);
    EXPECT_LE(boundary_error(surface, 0, apex), 0);
    EXPECT_LE(boundary_error(surface, 2, low), 2 * eps);
    EXPECT_LE(boundary_error(surface, 3, high), 2 * eps);
}

TEST(Coons, is_free_of_scale) {
    for_each_case(416000, 20, [&](Random &random, uint64_t seed) {
        const Boundaries given = random_boundaries(random, 4, random.chance(50), true);
        const SplineData surface = coons_of(given.curves);
        std::vector<SplineData> small;
        for (const SplineData &curve : given.curves) {
            small.push_back(scaled(curve, 0x1p-40, 0x1p-60));
        }
        const SplineData other = scaled(coons_of(small), 0x1p40);
        ASSERT_TRUE(same_bits(surface.points, other.points)) << where(seed, surface);
        ASSERT_TRUE(same_bits(surface.weights, other.weights));
    });
}

} // namespace coons_test

// Recognition: it finds what a shape is in all its forms, what it proves holds, and what is no such shape is
// not taken for one.
#include "property/dense_samples.h"
#include "property/exact_polynomials.h"
#include "property/made_shapes.h"
#include "property/shape_distance.h"

namespace recognize_test {

using namespace support;

namespace {

constexpr int32_t kinds[] = {
    NURBS_SHAPE_LINE,  NURBS_SHAPE_CIRCLE, NURBS_SHAPE_ELLIPSE,  NURBS_SHAPE_PARABOLA, NURBS_SHAPE_HYPERBOLA,
    NURBS_SHAPE_PLANE, NURBS_SHAPE_SPHERE, NURBS_SHAPE_CYLINDER, NURBS_SHAPE_CONE,     NURBS_SHAPE_TORUS};

FoundShape recognize(const nurbs *g, double tolerance) {
    FoundShape found;
    require_ok(nurbs_recognize(g, tolerance, &found.kind, found.placement, found.sizes, &found.deviation));
    return found;
}

// The largest distance over `per_span` places in every span, less what sampling may be off by.
long double sampled_deviation(const SplineData &data, const FoundShape &shape, int per_span) {
    std::vector<std::vector<SampledPlace>> places;
    for (int k = 0; k < 2; ++k) {
        places.push_back(k < data.axes() ? dense_places(data, data, k, per_span)
                                         : std::vector<SampledPlace>{{0, false}});
    }
    long double largest = 0;
    for (const SampledPlace &u : places[0]) {
        for (const SampledPlace &v : places[1]) {
            const double param[] = {u.t, v.t};
            const auto p = long_point(data, param, {u.left, v.left, false});
            largest = std::max(largest, shape_distance(shape, p));
        }
    }
    return std::max(0.0L, largest - sampling_error(data));
}
int places_for(const SplineData &data) {
    return data.axes() == 1 ? 10 : 5;
}

struct Case {
    int32_t kind = 0;
    int dim = 3;
    MadeShape shape;
    double size = 1;
    Handle spline;
};

Case random_case(Random &random, double scale, double offset) {
    Case made;
    made.kind = kinds[random.bits() % std::size(kinds)];
    made.dim = made.kind < NURBS_SHAPE_PLANE ? random.whole(2, 3) : 3;
    made.shape = made_shape(random, made.kind, made.dim);
    made.size = made.shape.size * scale;
    move(made.shape.data, random_motion(random, made.dim, scale, offset));
    made.spline = disguised(random, create(made.shape.data), made.shape.data.axes());
    return made;
}

// Kinds in the order in which they are tried.
int rank(int32_t kind) {
    return kind == NURBS_SHAPE_PARABOLA ? 2 * NURBS_SHAPE_ELLIPSE - 1 : 2 * kind;
}

// A tolerance finds the shape or, if it is coarse, one that is simpler; the proof holds in either case.
TEST(Recognition, finds_every_shape_in_every_form) {
    std::vector<long double> proven;
    size_t periodic = 0;
    for_each_case(551000, 1000, [&](Random &random, uint64_t seed) {
        const double scale = random.magnitude(1e-6, 1e6), relative = random.magnitude(1e-12, 1e-2);
        const double offset = relative < 1e-10 ? 1 : random.chance(50) ? 3 : 1000;
        Case made = random_case(random, scale, offset);
        if (random.chance(30)) {
            made.spline = periodic_where_closed(std::move(made.spline), made.shape.data.axes());
        }
        const FoundShape found = recognize(made.spline.get(), relative * made.size);
        if (relative < 1e-6) {
            ASSERT_EQ(found.kind, made.kind) << "seed " << seed << " tolerance " << relative;
        }
        ASSERT_NE(found.kind, NURBS_SHAPE_NONE) << "seed " << seed << " tolerance " << relative;
        ASSERT_LE(rank(found.kind), rank(made.kind)) << "seed " << seed;
        ASSERT_LE(found.deviation, relative * made.size) << "seed " << seed;
        const SplineData data = read_back(made.spline.get());
        periodic += data.flags != 0 ? 1 : 0;
        ASSERT_LE(sampled_deviation(data, found, places_for(data)), found.deviation) << "seed " << seed;
        if (found.kind != made.kind) {
            return;
        }
        proven.push_back(found.deviation / (made.size * offset));
        for (size_t i = 0; i < 2; ++i) {
            const double unit = made.kind == NURBS_SHAPE_CONE ? 1 : scale;
            ASSERT_NEAR(found.sizes[i] / unit, made.shape.sizes[i], 1e-12 * std::max(4.0, offset))
                << "seed " << seed << " kind " << made.kind;
        }
    });
    std::printf("%zu periodic\n", periodic);
    EXPECT_GE(100 * periodic, proven.size());
    for (long double &x : proven) {
        x /= reference::eps;
    }
    median(std::move(proven), "proven deviation of exact shapes, in eps of their sizes");
}

// Shapes whose control points were moved a little each, by a distance of 1.74 at most: at 2 they are still
// found.
TEST(Recognition, proves_a_distance_that_holds_and_is_tight) {
    std::vector<long double> ratios;
    int none = 0;
    for_each_case(552000, 600, [&](Random &random, uint64_t seed) {
        const Case made = random_case(random, random.magnitude(1e-3, 1e3), 2);
        SplineData data = read_back(made.spline.get());
        const double moved = made.size * random.magnitude(1e-11, 1e-2);
        for (double &x : data.points) {
            x += moved * random.between(-1, 1);
        }
        const FoundShape found = recognize(create(data).get(), 2 * moved);
        if (found.kind == NURBS_SHAPE_NONE) {
            ++none;
            return;
        }
        const long double sampled = sampled_deviation(data, found, places_for(data));
        ASSERT_LE(found.deviation, 2 * moved) << "seed " << seed;
        ASSERT_LE(sampled, found.deviation) << "seed " << seed;
        if (sampled > 1e-13 * made.size) {
            ratios.push_back(found.deviation / sampled);
        }
    });
    std::printf("%d not found\n", none);
    EXPECT_LE(40 * static_cast<size_t>(none), ratios.size());
    EXPECT_LE(median(std::move(ratios), "proven over sampled deviation"), 1.25L);
}

Polynomial scaled(Polynomial values, const Rational &factor, const Rational &unit) {
    const Rational whole = factor * unit; // unit clears the denominators of all factors
    EXPECT_EQ(denominator(whole), 1);
    for (Integer &x : values) {
        x *= numerator(whole);
    }
    return values;
}

// Whether |A - o w|^2 - inner^2 w^2 >= 0 and outer^2 w^2 - |A - o w|^2 >= 0 on a piece; for a line A - o w is
// replaced by its part across the axis, times the square of the axis.
bool between(const std::vector<Polynomial> &piece, const FoundShape &shape, const Rational &inner,
             const Rational &outer) {
    const size_t dim = piece.size() - 1;
    const Polynomial &w = piece.back();
    std::vector<Rational> origin, axis;
    Rational square = shape.kind == NURBS_SHAPE_LINE ? 0 : 1;
    for (size_t c = 0; c < dim; ++c) {
        origin.push_back(reference::exact(shape.placement[c]));
        axis.push_back(shape.kind == NURBS_SHAPE_LINE ? reference::exact(shape.placement[3 + c]) : 0);
        square += axis.back() * axis.back();
    }
    Integer unit = lcm(denominator(inner), denominator(outer)) * denominator(square);
    for (size_t c = 0; c < dim; ++c) {
        unit = lcm(unit, lcm(denominator(origin[c]), denominator(axis[c])));
    }
    const Rational one = unit;
    std::vector<Polynomial> from; // times unit
    Polynomial along(w.size());
    for (size_t c = 0; c < dim; ++c) {
        from.push_back(scaled(piece[c], 1, one));
        add(from.back(), scaled(w, origin[c], one), -1);
        add(along, scaled(from.back(), axis[c], one), 1); // times unit^2
    }
    Polynomial distance(2 * w.size() - 1); // times unit^6
    for (size_t c = 0; c < dim; ++c) {
        Polynomial across = scaled(scaled(from[c], square, one), 1, one);
        add(across, scaled(along, axis[c], one), -1);
        add(distance, product(across, across), 1);
    }
    const Polynomial weight = scaled(scaled(scaled(product(w, w), square, one), square, one), 1, one * one);
    Polynomial above = scaled(scaled(weight, outer, one), outer, one), below = distance;
    add(above, distance, -1);
    add(below, scaled(scaled(weight, inner, one), inner, one), -1);
    return nonnegative(above) && (inner <= 0 || nonnegative(below));
}

// The same without rounding and without samples, of lines and of circles in the plane.
TEST(Recognition, proves_distances_that_hold_in_exact_arithmetic) {
    int compared = 0, cases = 0;
    for_each_case(556000, 300, [&](Random &random, uint64_t seed) {
        ++cases;
        const bool line = random.chance(40);
        const int dim = line ? random.whole(2, 3) : 2;
        MadeShape made = made_shape(random, line ? NURBS_SHAPE_LINE : NURBS_SHAPE_CIRCLE, dim);
        move(made.data, random_motion(random, dim, 1, 2));
        SplineData data = read_back(disguised(random, create(made.data), 1).get());
        const double moved = random.chance(50) ? 0 : random.magnitude(1e-15, 1e-2);
        for (double &x : data.points) {
            x += moved * random.between(-1, 1);
        }
        const FoundShape found = recognize(create(data).get(), 8 * moved + 1e-12);
        if (found.kind != made.kind) {
            return;
        }
        const Rational radius = reference::exact(found.sizes[0]), bound = reference::exact(found.deviation);
        for (size_t i = 0; i + 1 < data.knots[0].size(); ++i) {
            const double from = data.knots[0][i], to = data.knots[0][i + 1];
            if (from < to && from >= data.lower(0) && to <= data.upper(0)) {
                ASSERT_TRUE(between(piece(data, from, to), found, radius - bound, radius + bound))
                    << "seed " << seed << " bound " << found.deviation;
            }
        }
        ++compared;
    });
    EXPECT_GE(10 * compared, 8 * cases);
}

// One inner control point moved so far that the curve or surface is ten tolerances away from the shape.
TEST(Recognition, does_not_take_one_shape_for_another) {
    int none = 0, simpler = 0;
    for_each_case(553000, 200, [&](Random &random, uint64_t seed) {
        const Case made = random_case(random, random.magnitude(1e-3, 1e3), 2);
        nurbs *fine = nullptr;
        require_ok(nurbs_elevate(made.spline.get(), 0, 1, &fine));
        Handle g(fine);
        const int parts = made.shape.data.axes() == 1 ? 6 : 3; // more freedom than another conic can follow
        for (int32_t axis = 0; axis < made.shape.data.axes(); ++axis) {
            require_ok(nurbs_refine_uniform(g.get(), axis, parts, &fine));
            g.reset(fine);
        }
        SplineData data = read_back(g.get());
        const FoundShape exact = recognize(g.get(), 1e-10 * made.size);
        ASSERT_EQ(exact.kind, made.kind) << "seed " << seed;
        int64_t place = 0; // inside on every axis
        for (size_t k = 0; k < data.counts.size(); ++k) {
            place = place * data.counts[k] + data.counts[k] / 2;
        }
        const double moved = made.size * random.magnitude(1e-8, 1e-2);
        for (int c = 0; c < data.dim; ++c) {
            data.points[static_cast<size_t>(place * data.dim + c)] += moved * random.between(-1, 1);
        }
        const long double away = sampled_deviation(data, exact, places_for(data));
        if (away < 1e-9 * made.size) {
            return; // moved along the shape
        }
        const FoundShape found = recognize(create(data).get(), static_cast<double>(away) / 10);
        (found.kind == NURBS_SHAPE_NONE ? none : simpler) += 1;
        EXPECT_EQ(found.kind, NURBS_SHAPE_NONE) << "seed " << seed << " kind " << made.kind << " dim "
                                                << made.dim << " away " << away / made.size;
    });
    std::printf("%d refused, %d taken for another shape\n", none, simpler);
    EXPECT_GE(none, 20 * simpler + 1);
}

// Arcs of one degree: the tolerance tells how well the numbers are known.
TEST(Recognition, copes_with_short_arcs) {
    for_each_case(554000, 200, [&](Random &random, uint64_t seed) {
        const int dim = random.whole(2, 3);
        const double a = random.between(0.5, 2), start = random.between(-3, 3),
                     degree = std::acos(-1.0) / 180;
        SplineData data = in_space(ellipse_arc(0, 0, a, a, start, degree), dim);
        move(data, random_motion(random, dim, 1, 1));
        const auto g = disguised(random, create(data), 1);
        const double size = a * degree / 2;
        const FoundShape found = recognize(g.get(), 1e-10 * size);
        ASSERT_EQ(found.kind, NURBS_SHAPE_CIRCLE) << "seed " << seed;
        ASSERT_NEAR(found.sizes[0], a, 1e-10 * a) << "seed " << seed;
        const SplineData back = read_back(g.get());
        ASSERT_LE(sampled_deviation(back, found, 24), found.deviation) << "seed " << seed;
    });
}

// Conics stay conics, and planes planes, whatever the affine map.
TEST(Recognition, of_conics_and_planes_survives_affine_maps) {
    for_each_case(555000, 300, [&](Random &random, uint64_t seed) {
        const int32_t kind = kinds[random.whole(1, 5)];
        const int dim = kind == NURBS_SHAPE_PLANE ? 3 : random.whole(2, 3);
        MadeShape made = made_shape(random, kind, dim);
        Motion map = random_motion(random, dim, 1, 2);
        for (double &m : map.matrix) {
            m += 0.3 * random.between(-1, 1);
        }
        move(made.data, map);
        const auto g = disguised(random, create(made.data), made.data.axes());
        const FoundShape found = recognize(g.get(), 1e-11 * made.size);
        ASSERT_EQ(found.kind, kind == NURBS_SHAPE_CIRCLE ? NURBS_SHAPE_ELLIPSE : kind) << "seed " << seed;
        const SplineData data = read_back(g.get());
        ASSERT_LE(sampled_deviation(data, found, places_for(data)), found.deviation) << "seed " << seed;
    });
}

// The control points of a plane moved into a line or a point, about `away` from the origin.
SplineData shrunk_plane(Random &random, bool line, double away) {
    SplineData data = made_shape(random, NURBS_SHAPE_PLANE, 3).data;
    const double place[] = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)},
                 along[] = {random.between(-1, 1), random.between(0.5, 1), random.between(-1, 1)};
    for (size_t i = 0; i < data.points.size(); i += 3) {
        const double at = line ? data.points[i] + data.points[i + 1] : 0;
        for (size_t c = 0; c < 3; ++c) {
            data.points[i + c] = away * place[c] + at * along[c];
        }
    }
    return data;
}

// Off the line or point by up to a part of the tolerance.
TEST(Recognition, of_a_surface_that_is_shrunk_to_a_line_or_point) {
    for_each_case(557000, 300, [&](Random &random, uint64_t seed) {
        const double scale = std::ldexp(random.between(1, 2), random.whole(-900, 900));
        const bool line = random.chance(50);
        const double relative = random.magnitude(1e-11, 1e-3), off = random.chance(50) ? 0 : relative / 4;
        SplineData data = shrunk_plane(random, line, 1);
        for (double &x : data.points) {
            x = scale * (x + off * random.between(-1, 1));
        }
        const Handle g = disguised(random, create(data), 2);
        const FoundShape found = recognize(g.get(), scale * relative);
        ASSERT_EQ(found.kind, line ? NURBS_SHAPE_LINE : NURBS_SHAPE_POINT) << "seed " << seed;
        ASSERT_LE(found.deviation, scale * relative) << "seed " << seed;
        ASSERT_LE(sampled_deviation(read_back(g.get()), found, 5), found.deviation) << "seed " << seed;
        for (size_t c = line ? 6 : 3; c < 9; ++c) {
            ASSERT_EQ(found.placement[c], 0) << "seed " << seed;
        }
    });
}

// At tolerances of the size of rounding a proof may fail, but then there is no plane of any normal either.
TEST(Recognition, of_what_is_shrunk_is_no_plane_at_any_tolerance) {
    for_each_case(558000, 300, [&](Random &random, uint64_t seed) {
        const bool line = random.chance(50);
        const SplineData data = shrunk_plane(random, line, 1e3);
        const FoundShape found = recognize(create(data).get(), random.magnitude(1e-18, 1e-8));
        ASSERT_TRUE(found.kind == NURBS_SHAPE_NONE ||
                    found.kind == (line ? NURBS_SHAPE_LINE : NURBS_SHAPE_POINT))
            << "seed " << seed << " " << found.kind;
    });
}

// Where the tolerance is 0 to the size, as a point of exact coordinates has it, whatever they are.
TEST(Recognition, of_points_of_every_size) {
    for (const double x : {0.0, 0x1p-1074, 0x1.8p-1000, 0.75, 0x1.8p1023}) {
        for (const int axes : {1, 2}) {
            SplineData data;
            data.dim = 3;
            for (int k = 0; k < axes; ++k) {
                data.degrees.push_back(2);
                data.counts.push_back(3);
                data.knots.push_back({0, 0, 0, 1, 1, 1});
            }
            for (int i = 0; i < (axes == 1 ? 3 : 9); ++i) {
                data.points.insert(data.points.end(), {x, -x, x / 2});
            }
            const FoundShape found = recognize(create(data).get(), std::max(0x1p-1074, x * 0x1p-40));
            EXPECT_EQ(found.kind, NURBS_SHAPE_POINT) << x;
            EXPECT_NEAR(found.placement[0], x, x * 0x1p-40);
        }
    }
}

} // namespace

} // namespace recognize_test

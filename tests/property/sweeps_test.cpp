// Extruded, revolved, tensor and swung shapes against their defining formulas, without rounding.
#include "exact_points.h"
#include "surface_integrals.h"

#include <array>
#include <map>
#include <numbers>
#include <string>

namespace sweeps_test {

using namespace support;

namespace {

// Degrees 0 to 9 of curves, to 3 of surfaces; clamped, unclamped and periodic; with weights of any kind or
// none.
SplineData random_shape(Random &random, int axes, int dim) {
    Recipe recipe;
    for (int k = 0; k < axes; ++k) {
        recipe.axes.push_back(random_axis(random, random.whole(0, axes == 1 ? 9 : 3)));
        recipe.axes.back().spans = random.whole(1, 4);
    }
    constexpr std::array weights = {Weights::none, Weights::moderate, Weights::moderate, Weights::extreme,
                                    Weights::some_zero};
    recipe.weights = weights[static_cast<size_t>(random.whole(0, 4))];
    recipe.dim = dim;
    return random_spline(random, recipe);
}

// Weights that are rounded, by eps / 2 of themselves, move a point by at most eps times this.
double hull(const SplineData &data, const std::vector<double> &params) {
    return reference::exact_hull(data, params.data());
}

// One rounding of each control point: eps / 2 of the largest.
TEST(Sweeps, extruded_shapes_are_moved_copies) {
    WorstRatios worst("extruded");
    for_each_case(712000, 150, [&](Random &random, uint64_t seed) {
        const auto data = random_shape(random, random.whole(1, 2), random.whole(1, 4));
        std::vector<double> vector(static_cast<size_t>(data.dim));
        std::generate(vector.begin(), vector.end(), [&] { return random.between(-1, 1) * extent(data); });
        nurbs *out = nullptr;
        require_ok(nurbs_extrude(create(data).get(), vector.data(), &out));
        const Handle made(out);
        const auto got = read_back(made.get());
        ASSERT_EQ(got.flags, data.flags) << where(seed, data);
        for (int64_t i = 0; i < data.point_count() * data.dim; ++i) { // v = 0 bit for bit
            const int64_t at = i / data.dim * 2 * data.dim + i % data.dim;
            ASSERT_TRUE(same_bits(got.points[static_cast<size_t>(at)], data.points[static_cast<size_t>(i)]));
        }
        const auto params = random_params(random, data, 1);
        const double v = random.unit();
        Point want = point_at(data, params);
        for (size_t c = 0; c < want.size(); ++c) {
            want[c] += exact(v) * exact(vector[c]);
        }
        const auto all = joined(params, {v});
        const long double error = ratio(point_at(got, all), want, 0.5L * eps * hull(got, all));
        worst.add(error);
        ASSERT_LE(error, 1) << where(seed, data);
    });
}

// An axis whose length is a whole number, so that unit vectors along it are rational.
struct Axis {
    std::vector<double> along;
    double length;
};
Axis random_axis_of_revolution(Random &random) {
    const int m = random.whole(-9, 9), n = random.whole(-9, 9), p = random.whole(-9, 9),
              q = random.whole(1, 9);
    const double scale = std::ldexp(1.0, random.whole(-30, 30));
    const int along[] = {m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)};
    return {{scale * along[0], scale * along[1], scale * along[2]}, scale * (m * m + n * n + p * p + q * q)};
}

Handle revolve(const nurbs *g, const double *point, const double *axis, double sweep, int32_t form) {
    nurbs *out = nullptr;
    require_ok(nurbs_revolve(g, point, axis, sweep, form, &out));
    return Handle(out);
}

// The arc (x, y, 0) that the library turns with: what becomes of the point (1, 0, 0) about the third axis.
SplineData arc_of(double sweep, int32_t form) {
    const SplineData still{{0}, {1}, {{0, 1}}, 3, {1, 0, 0}, {}, 0};
    return read_back(revolve(create(still).get(), nullptr, nullptr, sweep, form).get());
}

Rational dot(const Point &a, const Point &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// foot + x d + y (Z x d).
Point turned(const Point &p, const Point &origin, const Point &along, const Rational &length,
             const Point &arc) {
    Point seen(3), result(3);
    for (size_t c = 0; c < 3; ++c) {
        seen[c] = p[c] - origin[c];
    }
    const Rational part = dot(seen, along) / (length * length);
    for (size_t c = 0; c < 3; ++c) {
        const size_t i = (c + 1) % 3, j = (c + 2) % 3;
        const Rational foot = origin[c] + part * along[c], d = seen[c] - part * along[c];
        result[c] = foot + arc[0] * d + arc[1] * (along[i] * seen[j] - along[j] * seen[i]) / length;
    }
    return result;
}

double random_sweep(Random &random) {
    return random.chance(40) ? random.whole(1, 24) * std::numbers::pi / 12
                             : (random.chance(50) ? 1 : -1) * 2 * std::numbers::pi * (1 - random.unit());
}

// One rounding of each control point, and one of each weight: 1.5 eps of the largest.
TEST(Sweeps, revolved_shapes_follow_the_arc) {
    WorstRatios worst("revolved");
    for_each_case(713000, 150, [&](Random &random, uint64_t seed) {
        const auto data = random_shape(random, random.whole(1, 2), 3);
        const Axis axis = random_axis_of_revolution(random);
        std::vector<double> origin(3, 0);
        if (random.chance(60)) {
            std::generate(origin.begin(), origin.end(), [&] { return random.between(-1, 1) * extent(data); });
        }
        const double sweep = random_sweep(random);
        const int32_t form = random.whole(0, 2);
        const Handle made = revolve(create(data).get(), origin.data(), axis.along.data(), sweep, form);
        const auto got = read_back(made.get()), arc = arc_of(sweep, form);
        ASSERT_EQ(got.flags, data.flags << 8) << where(seed, data);
        const std::vector<double> first(got.points.begin(),
                                        got.points.begin() + static_cast<std::ptrdiff_t>(data.points.size()));
        ASSERT_TRUE(same_bits(first, data.points)) << where(seed, data);
        if (sweep == 2 * std::numbers::pi) {
            const std::vector<double> last(got.points.end() - static_cast<std::ptrdiff_t>(data.points.size()),
                                           got.points.end());
            ASSERT_TRUE(same_bits(last, data.points)) << where(seed, data);
        }
        const auto params = random_params(random, data, 1);
        const double u = random.unit();
        Point center, along;
        for (size_t c = 0; c < 3; ++c) {
            center.push_back(exact(origin[c]));
            along.push_back(exact(axis.along[c]));
        }
        const Point want =
            turned(point_at(data, params), center, along, exact(axis.length), point_at(arc, {u, 0}));
        const auto all = joined({u}, params);
        const long double error = ratio(point_at(got, all), want, 1.5L * eps * hull(got, all));
        worst.add(error);
        ASSERT_LE(error, 1) << where(seed, data) << "\nsweep " << hex(sweep) << " form " << form;
    });
}

// Two products and their sum, 1.5 eps / 2 each of its part, 1 eps in all, and the weights.
TEST(Sweeps, tensor_sums) {
    WorstRatios worst("tensor sums");
    for_each_case(714000, 150, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2), dim = random.whole(1, 4);
        const auto a = random_shape(random, axes, dim),
                   b = random_shape(random, axes == 1 ? random.whole(1, 2) : 1, dim);
        const double alpha = random.between(-2, 2), beta = random.between(-2, 2);
        nurbs *out = nullptr;
        require_ok(nurbs_tensor_sum(create(a).get(), alpha, create(b).get(), beta, &out));
        const auto got = read_back(Handle(out).get());
        ASSERT_EQ(got.flags, a.flags | b.flags << (8 * axes)) << where(seed, a);
        const auto u = random_params(random, a, 1), v = random_params(random, b, 1);
        const Point x = point_at(a, u), y = point_at(b, v);
        Point want(x.size());
        for (size_t c = 0; c < want.size(); ++c) {
            want[c] = exact(alpha) * x[c] + exact(beta) * y[c];
        }
        const long double size = std::fabs(alpha) * hull(a, u) + std::fabs(beta) * hull(b, v);
        const long double error = ratio(point_at(got, joined(u, v)), want, 2 * eps * size);
        worst.add(error);
        ASSERT_LE(error, 1) << where(seed, a) << describe(b);
    });
}

// One product, and the weights.
TEST(Sweeps, tensor_products) {
    WorstRatios worst("tensor products");
    for_each_case(715000, 150, [&](Random &random, uint64_t seed) {
        const int dim = random.whole(1, 4), which = random.whole(0, 2);
        const auto a = random_shape(random, 1, which == 0 ? 1 : dim),
                   b = random_shape(random, random.whole(1, 2), which == 1 ? 1 : dim);
        nurbs *out = nullptr;
        require_ok(nurbs_tensor_product(create(a).get(), create(b).get(), &out));
        const auto got = read_back(Handle(out).get());
        ASSERT_EQ(got.dim, dim) << where(seed, a);
        ASSERT_EQ(got.flags, a.flags | b.flags << 8) << where(seed, a);
        const auto u = random_params(random, a, 1), v = random_params(random, b, 1);
        const Point x = point_at(a, u), y = point_at(b, v);
        Point want(static_cast<size_t>(dim));
        for (size_t c = 0; c < want.size(); ++c) {
            want[c] = x[which == 0 ? 0 : c] * y[which == 1 ? 0 : c];
        }
        const long double error =
            ratio(point_at(got, joined(u, v)), want, 1.5L * eps * hull(a, u) * hull(b, v));
        worst.add(error);
        ASSERT_LE(error, 1) << where(seed, a) << describe(b);
    });
}

// Two products, and the weights; the height is that of the profile.
TEST(Sweeps, swung_surfaces) {
    WorstRatios worst("swung");
    for_each_case(716000, 100, [&](Random &random, uint64_t seed) {
        const auto trajectory = random_shape(random, 1, 2), profile = random_shape(random, 1, 2);
        const double scale = random.between(0.1, 3) * (random.chance(50) ? 1 : -1);
        nurbs *out = nullptr;
        require_ok(nurbs_surface_swung(create(trajectory).get(), create(profile).get(), scale, &out));
        const auto got = read_back(Handle(out).get());
        const auto u = random_params(random, trajectory, 1), v = random_params(random, profile, 1);
        const Point x = point_at(trajectory, u), r = point_at(profile, v);
        const Point plane = {exact(scale) * r[0] * x[0], exact(scale) * r[0] * x[1]};
        const Point all = point_at(got, joined(u, v)), across = {all[0], all[1]}, up = {all[2]};
        const long double size = std::fabs(scale) * hull(profile, v) * hull(trajectory, u);
        const long double error =
            std::max(ratio(across, plane, 2 * eps * size), ratio(up, {r[1]}, eps * hull(profile, v)));
        worst.add(error);
        ASSERT_LE(error, 1) << where(seed, trajectory) << describe(profile);
    });
}

// Half circles with a control point at infinity, homogeneous (1, 0, 0, 1), (0, 0, 1, 0), (-1, 0, 0, 1) in the
// plane y = 0.
Handle half_circle_to_infinity(double radius) {
    const int32_t degree = 2;
    const int64_t count = 3;
    const double knots[] = {0, 0, 0, 1, 1, 1};
    const double records[] = {0, 0, -radius, 1, radius, 0, 0, 0, 0, 0, radius, 1};
    nurbs *g = nullptr;
    require_ok(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 3, records, 0, 0, 0, &g));
    return Handle(g);
}

void expect_points(const Handle &g, const std::function<long double(const double *)> &distance) {
    std::vector<double> params;
    Random random(720000);
    for (int i = 0; i < 400; ++i) {
        params.push_back(random.unit());
    }
    const auto points = eval(g.get(), params);
    for (size_t i = 0; i < points.size(); i += 3) {
        EXPECT_LE(std::fabs(distance(points.data() + i)), 8 * eps);
    }
}

TEST(Sweeps, control_points_at_infinity) {
    const Handle half = half_circle_to_infinity(1);
    const auto sphere = [](const double *p) { return std::hypot(p[0], p[1], p[2]) - 1.0L; };
    for (int32_t form = 0; form < 3; ++form) {
        expect_points(revolve(half.get(), nullptr, nullptr, 2 * std::numbers::pi, form), sphere);
    }
    nurbs *out = nullptr;
    const double up[] = {0, 2, 0};
    require_ok(nurbs_extrude(half.get(), up, &out));
    const auto cylinder = [](const double *p) { return std::hypot(p[0], p[2]) - 1.0L; };
    expect_points(Handle(out), cylinder);
    const Handle line = create({{1}, {2}, {{0, 0, 1, 1}}, 3, {0, 0, 0, 0, 2, 0}, {}, 0});
    require_ok(nurbs_tensor_sum(half.get(), 1, line.get(), 0.5, &out));
    expect_points(Handle(out), cylinder);
    const Handle big = half_circle_to_infinity(2);
    require_ok(nurbs_ruled(half.get(), big.get(), NURBS_RULED_CARTESIAN, &out));
    expect_points(Handle(out), [](const double *p) { return p[1]; });
}

// The integral of the Jacobian over [0, 1]^3.
long double volume(const nurbs *g) {
    const Quadrature rule = gauss(1);
    const auto values = eval_grid_derivs(g, 1, {rule.nodes, rule.nodes, rule.nodes});
    const size_t n = rule.nodes.size();
    long double sum = 0;
    for (size_t i = 0; i < n * n * n; ++i) {
        const Vector u = vector_at(values, i, 12, 3), v = vector_at(values, i, 12, 6),
                     w = vector_at(values, i, 12, 9);
        sum += rule.weights[i / (n * n)] * rule.weights[i / n % n] * rule.weights[i % n] *
               support::dot(u, cross(v, w));
    }
    return sum;
}

// A third of a pipe of radii 1 and 2, and a wedge between two squares.
TEST(Sweeps, volumes_of_solids) {
    const std::vector<double> line = {0, 0, 1, 1};
    const Handle square =
        create({{1, 1}, {2, 2}, {line, line}, 3, {1, 0, 0, 1, 0, 1, 2, 0, 0, 2, 0, 1}, {}, 0});
    const double pi = std::numbers::pi;
    const Handle pipe = revolve(square.get(), nullptr, nullptr, 2 * pi / 3, NURBS_ARC_THIRDS);
    EXPECT_NEAR(static_cast<double>(std::fabs(volume(pipe.get()))), pi, 1e-13);
    nurbs *out = nullptr;
    const double up[] = {1, 3, 0};
    require_ok(nurbs_extrude(square.get(), up, &out));
    EXPECT_NEAR(static_cast<double>(std::fabs(volume(Handle(out).get()))), 3, 1e-14);
    const Handle small =
        create({{1, 1}, {2, 2}, {line, line}, 3, {1, 6, 0, 1, 6, 0, 2, 6, 0, 2, 6, 0}, {}, 0});
    require_ok(nurbs_ruled(square.get(), small.get(), 0, &out));
    EXPECT_NEAR(static_cast<double>(std::fabs(volume(Handle(out).get()))), 3, 1e-14);
}

// Pappus: 2 pi times the distance of the centre of gravity times the length.
TEST(Sweeps, areas_of_revolution) {
    const Handle segment = create({{1}, {2}, {{0, 0, 1, 1}}, 3, {1, 0, 0, 4, 0, 4}, {}, 0});
    const double pi = std::numbers::pi;
    for (int32_t form = 0; form < 3; ++form) {
        const Handle cone = revolve(segment.get(), nullptr, nullptr, 2 * pi, form);
        EXPECT_NEAR(static_cast<double>(area(cone.get())) / (25 * pi), 1, 1e-14);
    }
}

} // namespace

} // namespace sweeps_test

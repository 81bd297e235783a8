// Lengths, areas and moments: closed forms, quadrature in fifty digits, and the laws of integrals.
#include "length_oracle.h"
#include "support/cases.h"
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

using namespace support;

namespace {

constexpr double eps = 0x1p-52;
constexpr double pi = std::numbers::pi;
const double origin[] = {0, 0, 0}, up[] = {0, 0, 1}, right[] = {1, 0, 0};

struct Measured {
    double value = 0;
    double error = 0;
};

Measured length(const nurbs *g, double tolerance = 0, const std::vector<double> &range = {}) {
    Measured m;
    require_ok(nurbs_curve_length(g, range.empty() ? nullptr : range.data(), tolerance, &m.value, &m.error));
    return m;
}

Measured area(const nurbs *g, double tolerance = 0, const std::vector<double> &range = {}) {
    Measured m;
    require_ok(nurbs_surface_area(g, range.empty() ? nullptr : range.data(), tolerance, &m.value, &m.error));
    return m;
}

struct Body {
    double content = 0, error = 0, openness = 0;
    std::vector<double> centroid, inertia;
};

Body moments(const nurbs *g, int dim, double tolerance = 1e-12) {
    Body b;
    b.centroid.resize(static_cast<size_t>(dim));
    b.inertia.resize(static_cast<size_t>(dim * dim));
    require_ok(nurbs_moments(g, tolerance, &b.content, b.centroid.data(), b.inertia.data(), &b.error));
    return b;
}

Body enclosed_volume(const std::vector<const nurbs *> &surfaces, double tolerance = 1e-12) {
    Body b;
    b.centroid.resize(3);
    b.inertia.resize(9);
    require_ok(nurbs_enclosed_volume(static_cast<int64_t>(surfaces.size()), surfaces.data(), tolerance,
                                     &b.content, b.centroid.data(), b.inertia.data(), &b.openness, &b.error));
    return b;
}

Body enclosed_area(const std::vector<const nurbs *> &curves, double tolerance = 1e-12) {
    Body b;
    b.centroid.resize(2);
    b.inertia.resize(4);
    require_ok(nurbs_enclosed_area(static_cast<int64_t>(curves.size()), curves.data(), 1e-9, tolerance,
                                   &b.content, b.centroid.data(), b.inertia.data(), &b.error));
    return b;
}

std::vector<double> lengths_at(const nurbs *g, const std::vector<double> &params) {
    std::vector<double> out(params.size());
    require_ok(
        nurbs_curve_lengths(g, static_cast<int64_t>(params.size()), params.data(), 0, 1e-12, out.data(), 0));
    return out;
}

std::vector<double> params_at(const nurbs *g, const std::vector<double> &lengths, uint32_t flags = 0) {
    std::vector<double> out(lengths.size());
    require_ok(nurbs_curve_params_at_lengths(g, static_cast<int64_t>(lengths.size()), lengths.data(), 0,
                                             1e-12, out.data(), 0, flags));
    return out;
}

Handle made(const std::function<nurbs_status(nurbs **)> &call) {
    nurbs *g = nullptr;
    require_ok(call(&g));
    return Handle(g);
}

Handle ellipse(double a, double b, int32_t form = 0) {
    return made([&](nurbs **out) {
        return nurbs_curve_ellipse(2, origin, nullptr, right, a, b, 0, 2 * pi, form, out);
    });
}
Handle ellipsoid(double a, double b, double c, int32_t form = 0) {
    return made([&](nurbs **out) { return nurbs_surface_ellipsoid(origin, up, right, a, b, c, form, out); });
}
Handle torus(double major, double minor, int32_t form = 0) {
    return made([&](nurbs **out) {
        return nurbs_surface_torus(origin, up, right, major, minor, 0, 2 * pi, 0, 2 * pi, form, out);
    });
}

SplineData bezier(int dim, const std::vector<double> &points, const std::vector<double> &weights = {}) {
    SplineData data;
    const auto n = static_cast<int>(points.size()) / dim;
    data.degrees = {n - 1};
    data.counts = {n};
    data.knots = {std::vector<double>(static_cast<size_t>(n), 0.0)};
    data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(n), 1.0);
    data.dim = dim;
    data.points = points;
    data.weights = weights;
    return data;
}

// A curve that wanders, of spans of which none is much longer than another.
SplineData tangle(Random &random, int degree, int count, int dim, bool rational) {
    SplineData data;
    data.degrees = {degree};
    data.counts = {count};
    data.knots = {std::vector<double>(static_cast<size_t>(degree) + 1, 0.0)};
    for (int i = degree + 1; i < count; ++i) {
        data.knots[0].push_back(data.knots[0].back() + random.between(0.3, 2));
    }
    data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(degree) + 1, data.knots[0].back() + 1);
    data.dim = dim;
    for (int i = 0; i < count * dim; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    for (int i = 0; rational && i < count; ++i) {
        data.weights.push_back(random.magnitude(0.3, 3));
    }
    return data;
}

double extent_of(const SplineData &data) {
    double most = 0;
    for (const double x : data.points) {
        most = std::max(most, std::fabs(x));
    }
    return most;
}

} // namespace

// One in 1e13, and in fact a few units of rounding.
TEST(Measure, CirclesAndEllipsesHaveTheirLengthsAndAreas) {
    for (const int32_t form : {NURBS_ARC_QUARTERS, NURBS_ARC_THIRDS, NURBS_ARC_SMOOTH}) {
        for (const double r : {1.0, 1e-6, 3e6, 1e-150, 1e120}) {
            const Handle circle = ellipse(r, r, form);
            const Measured m = length(circle.get());
            EXPECT_NEAR(m.value / (2 * pi * r), 1, 16 * eps) << form << ' ' << r;
            EXPECT_LE(std::fabs(m.value - 2 * pi * r), m.error);
            EXPECT_LE(m.error, 1e-13 * m.value);
            if (r < 1e100 && r > 1e-50) {
                const Body disc = enclosed_area({circle.get()});
                EXPECT_NEAR(disc.content / (pi * r * r), 1, 16 * eps);
                EXPECT_NEAR(disc.inertia[0] / (pi / 4 * r * r * r * r), 1, 32 * eps);
                EXPECT_NEAR(disc.inertia[3] / (pi / 4 * r * r * r * r), 1, 32 * eps);
            }
        }
        for (const double ratio : {0.9, 0.5, 0.1, 1e-3}) {
            const double k = std::sqrt((1 - ratio) * (1 + ratio));
            EXPECT_NEAR(length(ellipse(1, ratio, form).get()).value / (4 * std::comp_ellint_2(k)), 1, 1e-13)
                << form << ' ' << ratio;
            EXPECT_NEAR(enclosed_area({ellipse(1, ratio, form).get()}).content / (pi * ratio), 1, 1e-13);
        }
    }
}

TEST(Measure, SpheresAndToriHaveTheirAreasAndVolumes) {
    for (const int32_t form : {NURBS_ARC_QUARTERS, NURBS_ARC_THIRDS, NURBS_ARC_SMOOTH}) {
        for (const double r : {1.0, 2e-6, 5e6}) {
            const Handle sphere = ellipsoid(r, r, r, form), ring = torus(3 * r, r, form);
            EXPECT_NEAR(area(sphere.get()).value / (4 * pi * r * r), 1, 1e-13);
            EXPECT_NEAR(area(ring.get()).value / (12 * pi * pi * r * r), 1, 1e-13);
            const Body ball = enclosed_volume({sphere.get()}), solid = enclosed_volume({ring.get()});
            EXPECT_NEAR(ball.content / (4 * pi / 3 * r * r * r), 1, 1e-13);
            EXPECT_NEAR(solid.content / (6 * pi * pi * r * r * r), 1, 1e-13);
            EXPECT_LE(ball.openness, 1e-13 * r * r);
            EXPECT_LE(solid.openness, 1e-12 * r * r);
            for (size_t i = 0; i < 9; ++i) {
                const double unit = i % 4 == 0 ? 1 : 0;
                EXPECT_NEAR(ball.inertia[i] / (0.4 * ball.content * r * r), unit, 1e-13);
            }
            // 5/8 m r^2 + m R^2 / 2 across the axis, m R^2 + 3/4 m r^2 about it
            EXPECT_NEAR(solid.inertia[0] / (solid.content * r * r), 0.625 + 4.5, 1e-12);
            EXPECT_NEAR(solid.inertia[8] / (solid.content * r * r), 9.75, 1e-12);
            const Body shell = moments(sphere.get(), 3);
            EXPECT_NEAR(shell.inertia[4] / (2.0 / 3 * shell.content * r * r), 1, 1e-12);
        }
        for (const double c : {2.0, 100.0}) { // a prolate spheroid along either axis of the parameters
            const double e = std::sqrt(1 - 1 / (c * c)), exact = 2 * pi * (1 + c / e * std::asin(e));
            for (const double tolerance : {1e-6, 1e-10}) {
                for (const Handle &g : {ellipsoid(1, 1, c, form), ellipsoid(c, 1, 1, form)}) {
                    const Measured m = area(g.get(), tolerance);
                    EXPECT_LE(std::fabs(m.value - exact), m.error) << form << ' ' << c;
                    EXPECT_LE(m.error, 4 * tolerance * exact);
                }
            }
        }
    }
}

// (t^2, t^3) on [a, b] has the length of ((4 + 9 t^2)^(3/2) - 8) / 27 at both ends; with the cusp anywhere.
TEST(Measure, ACuspKeepsItsTolerance) {
    for (const double start : {-1.0, -0.37, -1e-3, 0.0, 1e-9}) {
        const double b = 0.8113, a = start;
        // blossoms of t^2 and t^3 over [a, b]
        const SplineData data = bezier(2, {a * a, a * a * a, (a * a + 2 * a * b) / 3, a * a * b,
                                           (b * b + 2 * a * b) / 3, a * b * b, b * b, b * b * b});
        const auto part = [](double t) { return (std::pow(4 + 9 * t * t, 1.5L) - 8) / 27; };
        const long double exact = part(b) + (a < 0 ? part(a) : -part(a));
        for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
            const Measured m = length(create(data).get(), tolerance);
            EXPECT_LE(std::fabs(static_cast<double>(m.value - exact)), std::max(m.error, 4 * eps)) << start;
            EXPECT_LE(m.error, 2 * tolerance * m.value) << start;
        }
    }
}

TEST(Measure, ANearCuspKeepsItsTolerance) {
    for (const double gap : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-13}) {
        const SplineData data = bezier(2, {0, 0, 1.1, 1, -0.1 + gap, 1, 0.9, 0});
        const Measured m = length(create(data).get(), 1e-12);
        const Long exact = exact_length(data, 0, 1, 1e-20);
        EXPECT_LE(static_cast<double>(abs(exact - m.value)), m.error) << gap;
        EXPECT_LE(m.error, 2e-12 * m.value) << gap;
    }
}

TEST(Measure, LengthsAgreeWithFiftyDigits) {
    Random random(5521);
    for (int i = 0; i < 32; ++i) {
        const int degree = random.whole(1, i < 28 ? 5 : 12);
        const SplineData data =
            tangle(random, degree, degree + random.whole(1, 5), random.whole(2, 4), random.chance(60));
        for (const double tolerance : {1e-6, 1e-12, 0.0}) {
            const Measured m = length(create(data).get(), tolerance);
            const double off = static_cast<double>(abs(exact_length(data, -1, 1e9, 1e-18) - m.value));
            EXPECT_LE(off, m.error) << describe(data);
            EXPECT_LE(m.error, 1.5 * tolerance * m.value + 100 * (degree + 1) * eps * extent_of(data) * 8)
                << describe(data);
        }
    }
}

// T_n goes up and down n times between -1 and 1; its Bernstein coefficients are quotients of binomials.
TEST(Measure, ChebyshevPolynomialsVaryByTwiceTheirDegree) {
    for (int n = 1; n <= 12; ++n) {
        std::vector<double> points;
        for (int j = 0; j <= n; ++j) {
            const double c =
                static_cast<double>(binomial(2 * n, 2 * j)) / static_cast<double>(binomial(n, j));
            points.push_back((n - j) % 2 == 0 ? c : -c);
        }
        const Handle g = create(bezier(1, points));
        for (const double tolerance : {1e-5, 1e-12}) {
            const Measured m = length(g.get(), tolerance);
            EXPECT_LE(std::fabs(m.value - 2 * n), m.error) << n;
            EXPECT_LE(m.error,
                      std::max(2 * tolerance, 64 * n * eps * *std::ranges::max_element(points)) * m.value);
        }
    }
}

TEST(Measure, PartsAddUpAndFormsAgree) {
    Random random(5522);
    int curves = 0;
    for (int i = 0; i < 150; ++i) {
        const SplineData data = random_spline(random, random_recipe(random, 1, 6));
        Handle g;
        if (try_create(data, g) != NURBS_OK) {
            continue;
        }
        const Measured whole = length(g.get(), 1e-9);
        const double t = random_param(random, data.knots[0], data.degrees[0]);
        const double lower = data.lower(0), upper = data.upper(0);
        ++curves;
        // elevation moves points
        const double allowed =
            4 * whole.error + 64 * eps * extent_of(data) * static_cast<double>(data.counts[0]);
        if (t > lower && t < upper) {
            const double sum =
                length(g.get(), 1e-9, {lower, t}).value + length(g.get(), 1e-9, {t, upper}).value;
            EXPECT_NEAR(sum, whole.value, allowed + 1e-9 * sum) << describe(data);
        }
        if (!data.periodic(0)) { // whose knots may repeat to rounding only
            EXPECT_NEAR(length(elevate(g.get(), 0, 1).get(), 1e-9).value, whole.value, allowed)
                << describe(data);
        }
        const Handle back = made([&](nurbs **out) { return nurbs_reverse(g.get(), 0, 0, out); });
        EXPECT_NEAR(length(back.get(), 1e-9).value, whole.value, allowed) << describe(data);
        EXPECT_NEAR(lengths_at(g.get(), {lower, upper})[1], whole.value, allowed) << describe(data);
    }
    EXPECT_GT(curves, 100);
}

// Powers of two change nothing but the exponents.
TEST(Measure, LengthsScaleWithTheModelAndNotWithTheKnots) {
    Random random(5523);
    for (int i = 0; i < 20; ++i) {
        SplineData data = tangle(random, random.whole(1, 6), 12, 3, random.chance(50));
        const double before = length(create(data).get(), 1e-12).value;
        for (const int power : {-300, -20, 20, 300}) {
            SplineData scaled = data;
            for (double &x : scaled.points) {
                x = std::ldexp(x, power);
            }
            for (double &t : scaled.knots[0]) {
                t = std::ldexp(t, -power / 10);
            }
            EXPECT_EQ(length(create(scaled).get(), 1e-12).value, std::ldexp(before, power));
        }
    }
}

TEST(Measure, LengthsAndParametersAreInverse) {
    Random random(5524);
    for (int i = 0; i < 20; ++i) {
        const SplineData data = tangle(random, random.whole(1, 6), random.whole(7, 14), 3, random.chance(50));
        const Handle g = create(data);
        // The sum of the same table: that of the length alone may round otherwise, as it does on arm64.
        const double total = lengths_at(g.get(), {data.upper(0)})[0];
        std::vector<double> lengths = {0, total};
        for (int k = 0; k < 40; ++k) {
            lengths.push_back(random.unit() * total);
        }
        lengths.push_back(length(g.get()).value);
        EXPECT_NEAR(lengths.back(), total, 16 * eps * total);
        const std::vector<double> params = params_at(g.get(), lengths), again = lengths_at(g.get(), params);
        EXPECT_EQ(params[0], data.lower(0));
        EXPECT_EQ(params[1], data.upper(0));
        for (size_t k = 0; k < lengths.size(); ++k) {
            EXPECT_NEAR(again[k], lengths[k], 16 * eps * total) << describe(data);
        }
        for (size_t k = 2; k < 4; ++k) {
            const double exact = static_cast<double>(exact_length(data, -1, params[k], 1e-18));
            EXPECT_NEAR(exact, lengths[k], 32 * eps * total);
        }
    }
}

// t^3 on [-1, 1] stands still at 0, and a curve with a jump loses nothing there.
TEST(Measure, TheFirstParameterWhereACurveStandsStill) {
    const Handle cubic = create(bezier(1, {-1, 1, -1, 1}));
    EXPECT_NEAR(params_at(cubic.get(), {1.0})[0], 0.5, 1e-5);
    SplineData jump;
    jump.degrees = {1};
    jump.counts = {6};
    jump.knots = {{0, 0, 1, 1, 2, 2, 3, 3}};
    jump.dim = 1;
    jump.points = {0, 1, 5, 5, 8, 9};
    EXPECT_EQ(params_at(create(jump).get(), {0.5, 1, 1.5, 2}), (std::vector<double>{0.5, 1, 2.5, 3}));
    EXPECT_EQ(length(create(jump).get()).value, 2);
}

TEST(Measure, EqualLengthsAndEqualChords) {
    Random random(5525);
    for (int i = 0; i < 12; ++i) {
        const SplineData data = tangle(random, 3, 9, 2, random.chance(50));
        const Handle g = create(data);
        const int64_t parts = random.whole(1, 20);
        std::vector<double> params(static_cast<size_t>(parts) + 1);
        double size = 0;
        require_ok(nurbs_curve_divide(g.get(), nullptr, parts, 1e-12, 0, params.data(), &size));
        const std::vector<double> at = lengths_at(g.get(), params);
        for (size_t k = 1; k < at.size(); ++k) {
            EXPECT_NEAR(at[k] - at[k - 1], size, 64 * eps * at.back());
        }
        const nurbs_status status =
            nurbs_curve_divide(g.get(), nullptr, parts, 1e-9, NURBS_EQUAL_CHORDS, params.data(), &size);
        if (status == NURBS_ERROR_NOT_CONVERGED) {
            continue; // a curve that crosses itself may have no such chord
        }
        require_ok(status);
        EXPECT_EQ(params.front(), data.lower(0));
        EXPECT_EQ(params.back(), data.upper(0));
        const std::vector<double> points = eval(g.get(), params);
        for (size_t k = 1; k < params.size(); ++k) {
            EXPECT_GT(params[k], params[k - 1]);
            const double chord =
                std::hypot(points[2 * k] - points[2 * k - 2], points[2 * k + 1] - points[2 * k - 1]);
            EXPECT_NEAR(chord, size, 2e-9 * size + 64 * eps) << describe(data);
        }
    }
    std::vector<double> params(7);
    double chord = 0;
    const Handle circle = ellipse(2, 2);
    require_ok(
        nurbs_curve_divide(circle.get(), nullptr, 6, 1e-12, NURBS_EQUAL_CHORDS, params.data(), &chord));
    EXPECT_NEAR(chord, 2, 1e-11); // a regular hexagon
}

// Where walks by the first point at a distance jump over the end, chains are followed through folds: of these
// curves walks divide about half.
TEST(Measure, TanglesDivideIntoAFewEqualChords) {
    Random random(5529);
    int found = 0;
    for (int i = 0; i < 40; ++i) {
        const int dim = 2 + i % 2;
        const SplineData data = tangle(random, 3, 20, dim, random.chance(50));
        const Handle g = create(data);
        const int64_t parts = 2 + i % 4;
        std::vector<double> params(static_cast<size_t>(parts) + 1);
        double size = 0;
        const nurbs_status status =
            nurbs_curve_divide(g.get(), nullptr, parts, 1e-9, NURBS_EQUAL_CHORDS, params.data(), &size);
        if (status == NURBS_ERROR_NOT_CONVERGED) {
            continue;
        }
        require_ok(status);
        ++found;
        EXPECT_EQ(params.front(), data.lower(0));
        EXPECT_EQ(params.back(), data.upper(0));
        const std::vector<double> points = eval(g.get(), params);
        const auto stride = static_cast<size_t>(dim);
        for (size_t k = 1; k < params.size(); ++k) {
            EXPECT_GT(params[k], params[k - 1]);
            double square = 0;
            for (size_t c = 0; c < stride; ++c) {
                square += std::pow(points[k * stride + c] - points[(k - 1) * stride + c], 2);
            }
            EXPECT_NEAR(std::sqrt(square), size, 2e-9 * size) << describe(data);
        }
    }
    EXPECT_GE(found, 38);
}

// The six faces of a trilinear volume enclose what the volume holds, and both are polynomials of degree 5.
TEST(Measure, FacesEncloseWhatAVolumeHolds) {
    Random random(5526);
    for (int i = 0; i < 10; ++i) {
        SplineData data;
        data.degrees = {1, 1, 1};
        data.counts = {2, 2, 2};
        data.knots = {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}};
        data.dim = 3;
        for (int at = 0; at < 8; ++at) {
            for (const int c : {at / 4, at / 2 % 2, at % 2}) {
                data.points.push_back(c + random.between(-0.2, 0.2));
            }
        }
        const Handle g = create(data);
        nurbs_list *list = nullptr;
        require_ok(nurbs_boundaries(g.get(), &list));
        std::vector<Handle> faces;
        std::vector<const nurbs *> all;
        for (int64_t f = 0; f < 6; ++f) {
            nurbs *face = nullptr;
            require_ok(nurbs_list_get(list, f, &face));
            faces.emplace_back(face);
            if (f == 0 || f == 3 || f == 4) { // their normals point inwards
                nurbs *turned = nullptr;
                require_ok(nurbs_reverse(face, 0, 0, &turned));
                faces.emplace_back(turned);
            }
            all.push_back(faces.back().get());
        }
        nurbs_list_destroy(list);
        const Body inside = moments(g.get(), 3), outside = enclosed_volume(all);
        EXPECT_NEAR(outside.content, inside.content, 64 * eps);
        EXPECT_LE(outside.openness, 64 * eps);
        for (size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(outside.centroid[k], inside.centroid[k], 64 * eps);
        }
        for (size_t k = 0; k < 9; ++k) {
            EXPECT_NEAR(outside.inertia[k], inside.inertia[k], 64 * eps);
        }
    }
}

// Pappus: the area of a surface of revolution is the length of its profile times the way of its centroid.
TEST(Measure, WiresAndSheetsObeyPappus) {
    Random random(5527);
    for (int i = 0; i < 10; ++i) {
        SplineData data = tangle(random, 3, 6, 3, random.chance(50));
        for (size_t k = 0; k < data.points.size(); k += 3) {
            data.points[k] += 2;
            data.points[k + 1] = 0;
        }
        const Handle profile = create(data);
        const Handle surface = made([&](nurbs **out) {
            return nurbs_revolve(profile.get(), origin, up, 2 * pi, NURBS_ARC_QUARTERS, out);
        });
        const Body wire = moments(profile.get(), 3);
        EXPECT_NEAR(wire.content, length(profile.get()).value, 1e-12 * wire.content);
        EXPECT_NEAR(area(surface.get(), 1e-10).value, 2 * pi * wire.centroid[0] * wire.content, 1e-9);
    }
}

// A bilinear patch of the plane whose determinant is 1 + 0.7 u - 1.5 v: its magnitude has a kink along a line
// that no halving meets. What cannot be reached is refused, but 0 asks for what can.
TEST(Measure, AFoldIsMeasuredAsWellAsTheWorkLimitAllows) {
    const double exact = 0.6 + 0.25 / 6.3;
    for (const bool space : {false, true}) {
        SplineData data;
        data.degrees = {1, 1};
        data.counts = {2, 2};
        data.knots = {{0, 0, 1, 1}, {0, 0, 1, 1}};
        data.dim = space ? 3 : 2;
        for (const auto &[x, y] : {std::pair{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}, {-0.5, 1.7}}) {
            data.points.insert(data.points.end(), {x, y});
            data.points.resize(data.points.size() + (space ? 1 : 0));
        }
        const Handle g = create(data);
        const Measured best = area(g.get());
        EXPECT_LE(std::fabs(best.value - exact), best.error);
        EXPECT_LE(best.error, 1e-8);
        const Body sheet = moments(g.get(), data.dim, 0);
        EXPECT_LE(std::fabs(sheet.content - exact), sheet.error);
        EXPECT_LE(sheet.error, 1e-5);
        double value = -1, error = -1;
        EXPECT_EQ(nurbs_surface_area(g.get(), nullptr, 1e-14, &value, &error), NURBS_ERROR_NOT_CONVERGED);
        EXPECT_EQ(value, -1);
        EXPECT_EQ(error, -1);
    }
}

TEST(Measure, PartsOfSurfacesAddUp) {
    Random random(5528);
    int surfaces = 0;
    for (int i = 0; i < 40; ++i) {
        Recipe recipe = random_recipe(random, 2, 3);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        Handle g;
        Measured whole;
        if (try_create(data, g) != NURBS_OK || data.dim < 2 ||
            nurbs_surface_area(g.get(), nullptr, 1e-5, &whole.value, &whole.error) != NURBS_OK) {
            continue;
        }
        ++surfaces;
        const double u = (data.lower(0) + data.upper(0)) / 2, v = (data.lower(1) + data.upper(1)) / 2;
        double sum = 0;
        for (const bool high : {false, true}) {
            for (const bool far : {false, true}) {
                sum += area(g.get(), 1e-5,
                            {high ? u : data.lower(0), high ? data.upper(0) : u, far ? v : data.lower(1),
                             far ? data.upper(1) : v})
                           .value;
            }
        }
        EXPECT_NEAR(sum, whole.value, 3e-5 * whole.value + 1e-13 * extent_of(data) * extent_of(data))
            << describe(data);
    }
    EXPECT_GT(surfaces, 15);
}

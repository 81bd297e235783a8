// Conics by points, tangents, foci and shoulders: the equations that their points fulfil.
#include "property/made_curves.h"

namespace conic_conditions_test {

using namespace support;
using namespace support::curves;

namespace {

// Points of the circle of radius 65 with integer coordinates.
const std::vector<std::array<double, 2>> circle65 = {
    {65, 0}, {63, 16},  {60, 25},  {56, 33},  {52, 39},  {39, 52},  {33, 56},  {25, 60},  {16, 63},
    {0, 65}, {-16, 63}, {-25, 60}, {-33, 56}, {-39, 52}, {-52, 39}, {-56, 33}, {-60, 25}, {-63, 16}};

// An affine map with small integers, so that all its images of integer points are exact.
struct IntegerMap {
    std::array<double, 4> m{};
    std::array<double, 2> shift{};

    explicit IntegerMap(Random &random) {
        do {
            for (double &x : m) {
                x = random.whole(-9, 9);
            }
        } while (std::fabs(m[0] * m[3] - m[1] * m[2]) < 20);
        shift = {static_cast<double>(random.whole(-99, 99)), static_cast<double>(random.whole(-99, 99))};
    }
    [[nodiscard]] std::array<double, 2> operator()(std::array<double, 2> p) const {
        return {m[0] * p[0] + m[1] * p[1] + shift[0], m[2] * p[0] + m[3] * p[1] + shift[1]};
    }
    [[nodiscard]] std::array<double, 2> direction(std::array<double, 2> p) const {
        return {m[0] * p[0] + m[1] * p[1], m[2] * p[0] + m[3] * p[1]};
    }
    // How much longer, at most, a coordinate of a vector gets on the way back.
    [[nodiscard]] double stretch_back() const {
        const double det = std::fabs(m[0] * m[3] - m[1] * m[2]);
        return std::max(std::fabs(m[3]) + std::fabs(m[1]), std::fabs(m[0]) + std::fabs(m[2])) / det;
    }
    [[nodiscard]] std::array<long double, 2> back(double x, double y) const {
        const long double det = static_cast<long double>(m[0]) * m[3] - static_cast<long double>(m[1]) * m[2];
        const long double p = x - static_cast<long double>(shift[0]),
                          q = y - static_cast<long double>(shift[1]);
        return {(m[3] * p - m[1] * q) / det, (m[0] * q - m[2] * p) / det};
    }
};

// Five points of a conic that is known without rounding, as an image of one of these in rational points.
struct KnownConic {
    std::array<std::array<double, 2>, 5> points{};
    std::array<double, 2> first_tangent{}, last_tangent{};
    std::function<long double(long double, long double)> equation;
    double slope = 0; // of the equation: the sum of its two derivatives, at most
};

KnownConic known_circle(Random &random) {
    KnownConic conic;
    const int step = random.whole(2, 4), first = random.whole(0, 17 - 4 * step);
    for (size_t i = 0; i < 5; ++i) {
        conic.points[i] = circle65[static_cast<size_t>(first) + i * static_cast<size_t>(step)];
    }
    conic.first_tangent = {-conic.points[0][1], conic.points[0][0]};
    conic.last_tangent = {-conic.points[4][1], conic.points[4][0]};
    conic.equation = [](long double x, long double y) { return (x * x + y * y) / 4225 - 1; };
    conic.slope = 2 * std::sqrt(2.0) / 65;
    return conic;
}

KnownConic known_parabola(Random &random) {
    KnownConic conic;
    const int step = random.whole(2, 4), first = random.whole(-10, 0);
    for (size_t i = 0; i < 5; ++i) {
        const double t = first + static_cast<int>(i) * step;
        conic.points[i] = {t * t, 8 * t};
    }
    conic.first_tangent = {conic.points[0][1] / 4, 8};
    conic.last_tangent = {conic.points[4][1] / 4, 8};
    conic.equation = [](long double x, long double y) { return (x - y * y / 64) / 64; };
    conic.slope = (1 + 128.0 / 32) / 64; // |y| <= 128
    return conic;
}

KnownConic known_hyperbola(Random &random) { // x y = 64
    KnownConic conic;
    const std::array<double, 7> powers = {1, 2, 4, 8, 16, 32, 64};
    const auto first = static_cast<size_t>(random.whole(0, 2));
    for (size_t i = 0; i < 5; ++i) {
        conic.points[i] = {powers[first + i], 64 / powers[first + i]};
    }
    conic.first_tangent = {conic.points[0][0], -conic.points[0][1]};
    conic.last_tangent = {conic.points[4][0], -conic.points[4][1]};
    conic.equation = [](long double x, long double y) { return x * y / 64 - 1; };
    conic.slope = 65.0 / 64; // x + y <= 65
    return conic;
}

// To 4 double_eps of the size, as the map back and the gradient of the equation carry it.
void expect_on(const nurbs *g, const KnownConic &conic, const IntegerMap &map, uint64_t seed) {
    const double bound = 4 * double_eps * size_of(g) * map.stretch_back() * conic.slope;
    Random random(seed);
    const Vec points = eval(g, random_params(random, 200));
    for (size_t i = 0; i < points.size(); i += 2) {
        const auto p = map.back(points[i], points[i + 1]);
        ASSERT_LE(std::fabs(conic.equation(p[0], p[1])), bound) << "seed " << seed;
    }
}

TEST(Curves, conics_by_conditions_are_those_of_exact_points) {
    for_each_case(40400, 900, [](Random &random, uint64_t seed) {
        const KnownConic conic = seed % 3 == 0   ? known_circle(random)
                                 : seed % 3 == 1 ? known_parabola(random)
                                                 : known_hyperbola(random);
        const IntegerMap map(random);
        Vec points;
        for (const auto &p : conic.points) {
            const auto q = map(p);
            points.insert(points.end(), q.begin(), q.end());
        }
        const int form = static_cast<int>(seed % 2);
        const Handle five =
            made([&](nurbs **out) { return nurbs_curve_conic_through(2, points.data(), 0, 0, form, out); });
        expect_on(five.get(), conic, map, seed);
        const auto s = map.direction(conic.first_tangent), t = map.direction(conic.last_tangent);
        const Handle one = made([&](nurbs **out) {
            return nurbs_curve_conic_point(2, points.data(), s.data(), points.data() + 8, t.data(),
                                           points.data() + 4, form, out);
        });
        expect_on(one.get(), conic, map, seed);
        for (const nurbs *g : {five.get(), one.get()}) {
            ASSERT_TRUE(same_bits(eval(g, {0}), {points[0], points[1]}));
            ASSERT_TRUE(same_bits(eval(g, {1}), {points[8], points[9]}));
        }
    });
}

TEST(Curves, focal_conics_keep_the_ratio_of_distances) {
    double worst = 0;
    for_each_case(40500, 300, [&](Random &random, uint64_t seed) {
        const double e = random.magnitude(0.05, 4), d = random.magnitude(0.1, 10);
        const double reach = e < 1 ? 2 * pi : 2 * std::acos(-1 / e) - 0.2;
        const double sweep = seed % 3 == 0 ? reach : random.between(0.1, 1) * reach;
        const double start = e < 1 ? random.between(-6, 6) : -reach / 2;
        const double angle = random.between(0, 6);
        const Vec focus = random_vector(random, 2, 3), unit = {std::cos(angle), std::sin(angle)};
        const Vec foot = {focus[0] + d * unit[0], focus[1] + d * unit[1]};
        const Handle g = made([&](nurbs **out) {
            return nurbs_curve_conic_focus(2, focus.data(), nullptr, foot.data(), e, start, sweep,
                                           static_cast<int>(seed % 2), out);
        });
        const Vec points = eval(g.get(), random_params(random, 300));
        const double size = size_of(g.get());
        for (size_t i = 0; i < points.size(); i += 2) {
            const long double x = points[i] - static_cast<long double>(focus[0]),
                              y = points[i + 1] - static_cast<long double>(focus[1]);
            const long double off = std::sqrt(x * x + y * y) - e * (d - x * unit[0] - y * unit[1]);
            // The foot is rounded: its distance and direction by double_eps of the focus' size over d.
            const double bound = 16 * double_eps * (1 + e) * size * (1 + largest(focus) / d);
            ASSERT_LE(std::fabs(off), bound) << "seed " << seed;
            worst = std::max(worst, static_cast<double>(std::fabs(off)) / bound);
        }
    });
    std::printf("focal conics: at most %.2f of the bound\n", worst);
}

// Largest |x^2 + y^2 - R^2| / (2 R^2) in double_eps, without rounding.
double off_integer_circle(const nurbs *g, double radius) {
    using reference::exact;
    Random random(40700);
    const Vec points = eval(g, random_params(random, 120));
    const reference::Rational square = exact(radius) * exact(radius);
    double worst = 0;
    for (size_t i = 0; i < points.size(); i += 2) {
        const reference::Rational x = exact(points[i]), y = exact(points[i + 1]);
        const reference::Rational off = (x * x + y * y - square) / (2 * square);
        worst = std::max(worst, std::fabs(static_cast<double>(off)) / double_eps);
    }
    return worst;
}

// Arcs from (R, 0) through (-R, 0) to (m^2 - 1, -2 m), R = m^2 + 1: all but 2 / m of a full turn, from data
// without rounding.
TEST(Curves, nearly_full_turns_are_as_accurate_as_their_data) {
    double worst = 0;
    for (const double m : {2.0, 3.0, 10.0, 100.0, 1e4, 1e6, 3e7}) {
        const double radius = m * m + 1;
        const Vec a = {radius, 0}, b = {-radius, 0}, c = {m * m - 1, -2 * m}, s = {0, 1},
                  t = {2 * m, m * m - 1};
        for (int form = 0; form < 3; ++form) {
            const Handle through = made([&](nurbs **out) {
                return nurbs_curve_arc_through(2, a.data(), b.data(), c.data(), form, out);
            });
            const Handle tangent = made([&](nurbs **out) {
                return nurbs_curve_arc_tangent(2, a.data(), s.data(), c.data(), form, out);
            });
            const Handle conic = made([&](nurbs **out) {
                return nurbs_curve_conic_point(2, a.data(), s.data(), c.data(), t.data(), b.data(), form % 2,
                                               out);
            });
            for (const nurbs *g : {through.get(), tangent.get(), conic.get()}) {
                const double off = off_integer_circle(g, radius);
                ASSERT_LE(off, 4) << "m " << m << " form " << form;
                worst = std::max(worst, off);
            }
        }
    }
    std::printf("nearly full turns: %.2f double_eps\n", worst);
}

// From (0, 0) along x to (1, 1) along y through (1 - h, h): with barycentric coordinates 1 - x, x - y, y it
// is (x - y)^2 = 4 w^2 (1 - x) y, 4 w^2 = (1 - 2 h)^2 / h^2, as sharp as h is small.
TEST(Curves, sharp_hyperbolas_are_accurate) {
    const Vec a = {0, 0}, b = {1, 1}, s = {1, 0}, t = {0, 1};
    for (int k = 3; k <= 30; ++k) {
        const double h = std::ldexp(1.0, -k);
        const Vec point = {1 - h, h};
        const Handle g = made([&](nurbs **out) {
            return nurbs_curve_conic_point(2, a.data(), s.data(), b.data(), t.data(), point.data(), k % 2,
                                           out);
        });
        Random random(40800);
        const Vec points = eval(g.get(), random_params(random, 200));
        const long double four = (1 - 2.0L * h) * (1 - 2.0L * h) / h / h;
        for (size_t i = 0; i < points.size(); i += 2) {
            const long double x = points[i], y = points[i + 1];
            const long double f = (x - y) * (x - y) - four * (1 - x) * y;
            const long double gradient = std::hypot(2 * (x - y) + four * y, -2 * (x - y) - four * (1 - x));
            // Near the vertex the curve turns within h: there the first order says less than all.
            ASSERT_LE(std::fabs(f), 16 * double_eps * gradient + 64 * double_eps * double_eps * four)
                << "h 2^-" << k;
        }
    }
}

TEST(Curves, shoulders_stand_where_rho_says_at_small_angles_too) {
    for_each_case(40900, 400, [&](Random &random, uint64_t seed) {
        const int dim = 2 + static_cast<int>(seed % 3);
        const double angle = random.magnitude(1e-8, 1), rho = random.between(0.05, 0.95);
        // Exact: the corner is a + u, and b = corner + v, for short numbers u and v.
        Vec a, u, v;
        for (int c = 0; c < dim; ++c) {
            a.push_back(random.whole(-64, 64));
            u.push_back(random.whole(1, 64));
            v.push_back(u.back() + random.whole(-64, 64) * std::ldexp(1.0, std::ilogb(angle) - 6));
        }
        Vec b = a;
        for (size_t c = 0; c < b.size(); ++c) {
            b[c] += u[c] + v[c];
        }
        nurbs *made_curve = nullptr;
        const nurbs_status status =
            nurbs_curve_conic_shoulder(dim, a.data(), u.data(), b.data(), v.data(), rho, &made_curve);
        const Handle g(made_curve);
        if (status == NURBS_ERROR_CONIC) {
            ASSERT_NE(last_error().find("parallel"), std::string::npos) << last_error(); // u = v happens
            return;
        }
        require_ok(status);
        const Vec corner = read_back(g.get()).points;
        for (size_t c = 0; c < static_cast<size_t>(dim); ++c) {
            ASSERT_NEAR(corner[static_cast<size_t>(dim) + c], a[c] + u[c], 4 * double_eps * 256)
                << "seed " << seed;
        }
    });
}

TEST(Curves, focal_conics_near_their_asymptotes_and_beyond) {
    for (const double e : {1.0, 1.5, 7.0}) {
        const Vec focus = {0, 0}, foot = {1, 0};
        const double limit = std::acos(-1 / e);
        for (const double gap : {1e-1, 1e-3, 1e-5}) {
            const Handle g = made([&](nurbs **out) {
                return nurbs_curve_conic_focus(2, focus.data(), nullptr, foot.data(), e, gap - limit,
                                               2 * (limit - gap), 0, out);
            });
            Random random(41000);
            const Vec points = eval(g.get(), random_params(random, 100));
            const double size = size_of(g.get());
            for (size_t i = 0; i < points.size(); i += 2) {
                const long double x = points[i], y = points[i + 1];
                ASSERT_LE(std::fabs(std::hypot(x, y) - e * (1 - x)), 8 * (1 + e) * double_eps * size)
                    << e << " " << gap;
            }
        }
        for (const double half : {0.01, 0.5, 1.0, 2.0, 3.1}) {
            for (const double sign : {-1.0, 1.0}) {
                nurbs *out = nullptr;
                ASSERT_EQ(nurbs_curve_conic_focus(2, focus.data(), nullptr, foot.data(), e, pi - sign * half,
                                                  sign * 2 * half, 0, &out),
                          NURBS_ERROR_CONIC)
                    << e << " " << half;
            }
        }
    }
}

} // namespace

} // namespace conic_conditions_test

// Angles whose multiples of 15 degrees are exact, and the arcs of the unit circle and hyperbola made of them.
#include "build/conics/arc.h"

#include "base/error.h"
#include "reference/number.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace arc_test {

using nrb::build::Angle;
using nrb::build::Arc;
using nrb::build::Direction;

namespace {

constexpr double eps = 0x1p-52;
constexpr double pi = std::numbers::pi;

void expect_direction(const Angle &angle, double cosine, double sine) {
    const Direction d = angle.direction();
    EXPECT_EQ(d.cos, cosine) << angle.radians();
    EXPECT_EQ(d.sin, sine) << angle.radians();
}

TEST(Angle, multiples_of_a_quarter_turn_are_exact) {
    constexpr std::array<double, 5> wave = {1, 0, -1, 0, 1};
    for (int k = -400; k <= 400; ++k) {
        const auto i = static_cast<size_t>(((k % 4) + 4) % 4);
        expect_direction(Angle::from_radians(k * (pi / 2)), wave[i], wave[(i + 3) % 4]);
        EXPECT_EQ(std::signbit(Angle::quarters(k).direction().sin), wave[(i + 3) % 4] < 0);
    }
}

TEST(Angle, a_degree_count_converted_in_any_way_is_that_multiple) {
    for (int k = -72; k <= 72; ++k) {
        const Direction d = Angle::from_radians(15.0 * k * pi / 180).direction();
        const Direction e = Angle::from_radians(15.0 * k * (pi / 180)).direction();
        EXPECT_EQ(d.cos, e.cos);
        EXPECT_EQ(d.sin, e.sin);
        if (k % 4 == 0 && k % 6 != 0) {
            EXPECT_EQ(std::fabs(d.cos), 0.5);
        }
    }
}

TEST(Angle, directions_are_accurate_to_eps) {
    std::mt19937_64 random(401);
    std::uniform_real_distribution<double> uniform(-7, 7);
    for (int i = 0; i < 100000; ++i) {
        const double t = uniform(random);
        const Direction d = Angle::from_radians(t).direction();
        ASSERT_LE(std::fabs(d.cos - std::cos(static_cast<long double>(t))), eps);
        ASSERT_LE(std::fabs(d.sin - std::sin(static_cast<long double>(t))), eps);
    }
}

TEST(Angle, parts_add_up_to_the_whole) {
    std::mt19937_64 random(402);
    std::uniform_real_distribution<double> uniform(-6.2, 6.2);
    for (int i = 0; i < 10000; ++i) {
        const double start = uniform(random), sweep = uniform(random);
        const int n = 1 + i % 16, k = i % (n + 1);
        const Direction d = Angle::from_radians(start).plus(Angle::from_radians(sweep), k, n).direction();
        const long double angle = static_cast<long double>(start) + static_cast<long double>(sweep) * k / n;
        ASSERT_LE(std::fabs(d.cos - std::cos(angle)), 2 * eps);
        ASSERT_LE(std::fabs(d.sin - std::sin(angle)), 2 * eps);
    }
}

nrb::Status refused(double start, double sweep) {
    try {
        (void)nrb::build::make_turn(start, sweep);
    } catch (const nrb::Error &error) {
        return error.status();
    }
    return nrb::Status::ok;
}

TEST(Turn, takes_a_full_turn_and_no_more) {
    EXPECT_EQ(refused(1, 2 * pi), nrb::Status::ok);
    EXPECT_EQ(refused(1, -2 * pi), nrb::Status::ok);
    EXPECT_EQ(refused(1, std::nextafter(2 * pi, 7)), nrb::Status::ok); // rounding
    EXPECT_EQ(refused(1, 2 * pi + 1e-14), nrb::Status::angle);
    EXPECT_EQ(refused(1, 0), nrb::Status::angle);
    EXPECT_EQ(refused(1, NAN), nrb::Status::angle);
    EXPECT_EQ(refused(INFINITY, 1), nrb::Status::angle);
    EXPECT_EQ(refused(0x1p23, 1), nrb::Status::angle);
}

using reference::exact;
using reference::Rational;

struct Homogeneous {
    Rational x;
    Rational y;
    Rational w;
};

// A piece of the arc at a parameter, by de Casteljau's algorithm without rounding.
Homogeneous point_of(const Arc &arc, size_t piece, const Rational &t) {
    const auto degree = static_cast<size_t>(arc.axis->degree());
    std::vector<Homogeneous> p;
    for (size_t i = 0; i <= degree; ++i) {
        const nrb::build::ArcPoint &q = arc.points[piece * degree + i];
        const Rational w = exact(q.weight);
        p.push_back({exact(q.x) * w, exact(q.y) * w, w});
    }
    for (size_t level = degree; level > 0; --level) {
        for (size_t i = 0; i < level; ++i) {
            p[i] = {p[i].x * (1 - t) + p[i + 1].x * t, p[i].y * (1 - t) + p[i + 1].y * t,
                    p[i].w * (1 - t) + p[i + 1].w * t};
        }
    }
    return p[0];
}

// Largest |x^2 + sign y^2 - 1| over the parts of all pieces, in eps and relative to size^2.
double off_conic(const Arc &arc, int sign) {
    double worst = 0;
    const size_t pieces = (arc.points.size() - 1) / static_cast<size_t>(arc.axis->degree());
    for (size_t piece = 0; piece < pieces; ++piece) {
        for (int k = 0; k <= 8; ++k) {
            const Homogeneous p = point_of(arc, piece, Rational(k) / 8);
            const Rational y2 = p.y * p.y * sign, size = p.x * p.x + p.y * p.y;
            const Rational off = (p.x * p.x + y2 - p.w * p.w) / (size > p.w * p.w ? size : p.w * p.w);
            worst = std::max(worst, std::fabs(static_cast<double>(off)) / eps);
        }
    }
    return worst;
}

TEST(Arc, every_form_is_on_the_circle) {
    std::mt19937_64 random(403);
    std::uniform_real_distribution<double> uniform(-2 * pi, 2 * pi);
    double worst = 0;
    for (int i = 0; i < 600; ++i) {
        const double sweep = i % 20 == 0 ? 2 * pi : uniform(random);
        const double start = i % 3 == 0 ? 0 : uniform(random);
        const Arc arc = nrb::build::unit_arc(nrb::build::make_turn(start, sweep), i % 3);
        const double off = off_conic(arc, 1);
        ASSERT_LE(off, 5) << "start " << start << " sweep " << sweep; // twice the distance from the circle
        worst = std::max(worst, off);
        for (const nrb::build::ArcPoint &p : arc.points) {
            ASSERT_GT(p.weight, 0);
        }
    }
    std::printf("arcs: largest |x^2 + y^2 - 1| %.2f eps\n", worst);
}

TEST(Arc, forms_have_their_degrees_and_pieces) {
    const auto points = [](double sweep, int form) {
        return nrb::build::unit_arc(nrb::build::make_turn(0.3, sweep), form).points.size();
    };
    EXPECT_EQ(points(pi / 2, nrb::build::arc_quarters), 3U);
    EXPECT_EQ(points(-pi / 2 * 1.001, nrb::build::arc_quarters), 5U);
    EXPECT_EQ(points(2 * pi, nrb::build::arc_quarters), 9U);
    EXPECT_EQ(points(2 * pi / 3, nrb::build::arc_thirds), 3U);
    EXPECT_EQ(points(2 * pi, nrb::build::arc_thirds), 7U);
    EXPECT_EQ(points(2 * pi / 3, nrb::build::arc_smooth), 3U);
    EXPECT_EQ(points(2.2, nrb::build::arc_smooth), 6U);
    EXPECT_EQ(points(2 * pi, nrb::build::arc_smooth), 6U);
}

TEST(Arc, hyperbolas_are_on_theirs) {
    double worst = 0;
    for (const double start : {-6.0, -1.0, 0.0, 3.0}) {
        for (const double length : {0.01, 1.9, 2.0, 7.5}) {
            const double off = off_conic(nrb::build::unit_hyperbola(start, start + length), -1);
            ASSERT_LE(off, 8) << start << " " << length;
            worst = std::max(worst, off);
        }
    }
    std::printf("hyperbolas: largest |x^2 - y^2 - 1| / (x^2 + y^2) %.2f eps\n", worst);
}

} // namespace

} // namespace arc_test

// The kind of a conic segment against the discriminant of its equation, and the axes of a conic against its
// equation, in exact arithmetic.
#include "reference/number.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cmath>
#include <gtest/gtest.h>

namespace conic_kind_test {

using namespace support;
using reference::exact;
using reference::Rational;

namespace {

struct Triangle {
    double points[6];
    double weights[3];
};

// tau, the barycentric coordinates of (x, y), are (a x + b y + c) / D each; on the conic w0 w2 tau1^2 = 4
// w1^2 tau0 tau2. B^2 - 4 A C of that equation, without the factor 1 / D^4.
Rational discriminant(const Triangle &triangle) {
    Rational a[3], b[3];
    for (int i = 0; i < 3; ++i) {
        const double *p = triangle.points + 2 * ((i + 1) % 3), *q = triangle.points + 2 * ((i + 2) % 3);
        a[i] = exact(p[1]) - exact(q[1]);
        b[i] = exact(q[0]) - exact(p[0]);
    }
    const Rational ends = exact(triangle.weights[0]) * exact(triangle.weights[2]);
    const Rational middle = 4 * exact(triangle.weights[1]) * exact(triangle.weights[1]);
    const Rational xx = ends * a[1] * a[1] - middle * a[0] * a[2];
    const Rational xy = 2 * ends * a[1] * b[1] - middle * (a[0] * b[2] + a[2] * b[0]);
    const Rational yy = ends * b[1] * b[1] - middle * b[0] * b[2];
    return xy * xy - 4 * xx * yy;
}

// A third of them parabolas, exactly or almost.
Triangle random_triangle(Random &random) {
    Triangle triangle{};
    const double scale = random.magnitude(1e-9, 1e9);
    for (double &x : triangle.points) {
        x = scale * random.between(-1, 1);
    }
    for (double &w : triangle.weights) {
        w = random.magnitude(1e-6, 1e6);
    }
    if (random.chance(40)) { // w0 = m^2 s, w1 = m n s, w2 = n^2 s, all exact
        const double m = random.whole(1, 1 << 20), n = random.whole(1, 1 << 20);
        const double s = std::ldexp(1.0, random.whole(-40, 40));
        triangle.weights[0] = m * m * s;
        triangle.weights[1] = m * n * s;
        triangle.weights[2] = n * n * s;
        const int near = random.whole(-3, 3);
        double &w = triangle.weights[random.whole(0, 2)];
        for (int i = 0; i < std::abs(near); ++i) {
            w = std::nextafter(w, near < 0 ? 0 : INFINITY);
        }
    }
    return triangle;
}

Handle segment(const Triangle &triangle) {
    const int32_t degree = 2;
    nurbs *out = nullptr;
    require_ok(nurbs_create_bezier(1, &degree, 2, triangle.points, 0, 0, triangle.weights, 0, &out));
    return Handle(out);
}

TEST(ConicKind, of_segments_is_that_of_the_discriminant) {
    int parabolas = 0;
    Random random(550100);
    for (int i = 0; i < support::scaled(100000); ++i) {
        const Triangle triangle = random_triangle(random);
        double factor = 0;
        int32_t type = 0;
        require_ok(nurbs_curve_shape_factor(segment(triangle).get(), &factor, &type));
        const Rational sign = discriminant(triangle);
        const int32_t want = sign < 0    ? NURBS_CONIC_ELLIPSE
                             : sign == 0 ? NURBS_CONIC_PARABOLA
                                         : NURBS_CONIC_HYPERBOLA;
        ASSERT_EQ(type, want) << "case " << i;
        const auto &w = triangle.weights;
        const Rational square = exact(w[1]) * exact(w[1]), ends = exact(w[0]) * exact(w[2]);
        ASSERT_LE(abs(exact(factor) * ends - square), square * exact(2 * 0x1p-52)) << "case " << i;
        parabolas += sign == 0 ? 1 : 0;
    }
    EXPECT_GE(parabolas, support::of_whole_run(4000));
}

// The canonical equation of the axes, turned and moved back, in long double.
struct Rebuilt {
    long double q[6];
    long double size[6]; // sums of magnitudes
};
Rebuilt rebuilt(int32_t type, const double *origin, const double *x, const double *sizes) {
    const long double a = sizes[0], b = sizes[1];
    const bool parabola = type == NURBS_CONIC_PARABOLA;
    const long double k = parabola ? 0 : (type == NURBS_CONIC_ELLIPSE ? 1 : -1);
    const long double u = parabola ? 0 : b * b, v = parabola ? 1 : k * a * a; // u X^2 + v Y^2 + 2 l X - c = 0
    const long double l = parabola ? -2 * a : 0, c = parabola ? 0 : a * a * b * b;
    const long double s = x[0], t = x[1], ox = origin[0], oy = origin[1];
    Rebuilt r{};
    const auto set = [&r](int i, std::initializer_list<long double> terms) {
        for (const long double term : terms) {
            r.q[i] += term;
            r.size[i] += std::fabs(term);
        }
    };
    const long double xx = u * s * s + v * t * t, xy = 2 * (u - v) * s * t, yy = u * t * t + v * s * s;
    const long double xx_size = u * s * s + std::fabs(v) * t * t, yy_size = u * t * t + std::fabs(v) * s * s;
    set(0, {u * s * s, v * t * t});
    set(1, {2 * u * s * t, -2 * v * s * t});
    set(2, {u * t * t, v * s * s});
    set(3, {-2 * xx * ox, -xy * oy, 2 * l * s});
    set(4, {-2 * yy * oy, -xy * ox, 2 * l * t});
    set(5, {xx * ox * ox, xy * ox * oy, yy * oy * oy, -2 * l * (s * ox + t * oy), -c});
    r.size[3] += 2 * xx_size * std::fabs(ox);
    r.size[4] += 2 * yy_size * std::fabs(oy);
    r.size[5] += xx_size * ox * ox + yy_size * oy * oy;
    return r;
}

// An equation with the given axes, rounded, has axes whose own equation is the first one to rounding.
TEST(ConicAxes, give_back_the_equation) {
    long double worst = 0;
    for_each_case(550200, 20000, [&](Random &random, uint64_t seed) {
        const auto type = static_cast<int32_t>(random.whole(1, 3));
        const double scale = random.magnitude(1e-9, 1e9), turn = random.between(-4, 4);
        const double origin[] = {scale * random.between(-2, 2), scale * random.between(-2, 2)};
        const double x[] = {std::cos(turn), std::sin(turn)};
        double sizes[] = {scale * random.between(0.5, 2), scale * random.between(0.5, 2)};
        if (type == NURBS_CONIC_PARABOLA) { // exactly: directions along the axes or a Pythagorean triple
            sizes[1] = 0;
        }
        Rebuilt made = rebuilt(type, origin, x, sizes);
        double q[6];
        for (int i = 0; i < 6; ++i) {
            q[i] = static_cast<double>(made.q[i]);
        }
        if (type == NURBS_CONIC_PARABOLA) {
            const double m = random.whole(1, 1000), n = random.whole(-1000, 1000);
            q[0] = m * m;
            q[1] = 2 * m * n;
            q[2] = n * n;
        }
        int32_t found = 0;
        double centre[2], direction[2], lengths[2];
        const nurbs_status status = nurbs_conic_axes(q, &found, centre, direction, lengths);
        require_ok(status);
        ASSERT_EQ(found, type) << "seed " << seed;
        ASSERT_LE(std::fabs(std::hypot(direction[0], direction[1]) - 1), 2 * 0x1p-52);
        const Rebuilt back = rebuilt(found, centre, direction, lengths);
        int pivot = 0; // the equations agree up to a factor
        for (int i = 1; i < 3; ++i) {
            pivot = std::fabs(q[i]) > std::fabs(q[pivot]) ? i : pivot;
        }
        const long double factor = q[pivot] / back.q[pivot];
        for (int i = 0; i < 6; ++i) {
            const long double bound = std::fabs(factor) * back.size[i] * 0x1p-52L;
            const long double error = std::fabs(back.q[i] * factor - q[i]);
            ASSERT_LE(error, 16 * bound) << "seed " << seed << " coefficient " << i;
            worst = std::max(worst, error / bound);
        }
    });
    std::printf("worst coefficient: %.2Lf eps of its terms\n", worst);
}

} // namespace

} // namespace conic_kind_test

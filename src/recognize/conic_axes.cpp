// SPDX-License-Identifier: MIT
#include "recognize/conic_axes.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/numbers.h"
#include "numeric/exact_products.h"
#include "numeric/sum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::recognize {

namespace {

struct Equation {
    double a, b, c, d, e, f;

    Equation operator-() const noexcept { return {-a, -b, -c, -d, -e, -f}; }
};

int exponent_of(double x) noexcept {
    return x == 0 ? -100000 : std::ilogb(x);
}

// Powers of two by which the coordinates of an equation are divided.
struct Units {
    int x = 0, y = 0;
};

// The equation in coordinates divided by 2^exponent, multiplied by a power of two. The largest coefficient of
// degree 2 and the largest of the others (if any) then have magnitudes near 1.
struct Scaled {
    Equation equation;
    int exponent = 0;
    // The same with another unit for the coordinate whose square has by far the smaller coefficient, which
    // would vanish, or lose digits, in products. Such a unit only multiplies the determinant and 4 a c - b^2.
    Equation stretched;
    Units stretch;

    explicit Scaled(const double *q) noexcept {
        const int quadratic = std::max({exponent_of(q[0]), exponent_of(q[1]), exponent_of(q[2])});
        const int linear = std::max(exponent_of(q[3]), exponent_of(q[4]));
        const int step = std::max(linear - quadratic, (exponent_of(q[5]) - quadratic) / 2);
        exponent = std::abs(step) > 5000 ? 0 : step;
        const auto scaled = [&](double x, int times, int power) {
            return std::ldexp(x, -quadratic - times * exponent + power);
        };
        const auto in_units = [&](Units by) {
            return Equation{scaled(q[0], 0, 2 * by.x), scaled(q[1], 0, by.x + by.y),
                            scaled(q[2], 0, 2 * by.y), scaled(q[3], 1, by.x),
                            scaled(q[4], 1, by.y),     scaled(q[5], 2, 0)};
        };
        equation = in_units({});
        const int mixed = exponent_of(q[1]) - quadratic;
        const auto missing = [&](double square, double first) {
            return stretch_for(exponent_of(square) - quadratic, mixed,
                               exponent_of(first) - quadratic - exponent);
        };
        stretch = {missing(q[0], q[3]), missing(q[2], q[4])};
        stretched = in_units(stretch);
    }

    // The power that brings the coefficient of a square near 1, and those of the other terms with the same
    // coordinate to sizes whose products do not overflow. 0 if there is no such square, or it is not small.
    static int stretch_for(int square, int mixed, int first) noexcept {
        constexpr int small = -500, large = 300, absent = -5000;
        return square > small || square < absent
                   ? 0
                   : std::max(std::min({-square / 2, -mixed, large - first}), 0);
    }
};

// A sum of products of three numbers, computed as if in twice the precision, and the sum of their magnitudes.
struct TripleProducts {
    CompensatedSum sum;
    double magnitudes = 0;

    void add(double a, double b, double c) noexcept {
        const double ab = a * b, low = std::fma(a, b, -ab), abc = ab * c;
        sum.add(abc);
        sum.add(std::fma(ab, c, -abc));
        sum.add(low * c);
        magnitudes += std::abs(abc);
    }
    // The sum has 15 terms, each with an error of at most eps^2 times its product.
    [[nodiscard]] bool vanishes() const noexcept {
        return !(std::abs(sum.value()) > 100 * eps * eps * magnitudes);
    }
};

// 4 det Q, where Q is the symmetric 3 x 3 matrix of the equation; 0 for lines and points.
TripleProducts determinant(const Equation &q) noexcept {
    TripleProducts sum;
    sum.add(4 * q.a, q.c, q.f);
    sum.add(q.b, q.d, q.e);
    sum.add(-q.a, q.e, q.e);
    sum.add(-q.c, q.d, q.d);
    sum.add(-q.f, q.b, q.b);
    return sum;
}

// The eigenvalue of largest magnitude of the quadratic part, with its direction. Precondition: a + c >= 0.
struct Principal {
    double value;
    double x, y;

    explicit Principal(const Equation &q) noexcept {
        const double difference = q.a - q.c, root = std::hypot(difference, q.b);
        value = (q.a + q.c + root) / 2;
        x = 1;
        y = 0;
        if (root > 0) { // cosine and sine of half the angle of (difference, b), without cancellation
            const double large = std::sqrt((1 + std::abs(difference) / root) / 2);
            const double small = q.b / (2 * root * large);
            x = difference >= 0 ? large : std::abs(small);
            y = difference >= 0 ? small : std::copysign(large, small);
        }
    }
};

// For ellipses and hyperbolas: the quadratic part is value X^2 + other Y^2, with X along the principal
// direction. q: the equation in stretched units. at_centre: its value at the centre.
void central_axes(const Equation &q, Units stretch, const Principal &principal, double four_ac,
                  double at_centre, ConicAxes &axes) noexcept {
    axes.origin[0] = std::ldexp(difference_of_products(q.b, q.e, 2 * q.c, q.d) / four_ac, stretch.x);
    axes.origin[1] = std::ldexp(difference_of_products(q.b, q.d, 2 * q.a, q.e) / four_ac, stretch.y);
    const double other = four_ac / 4 / principal.value; // only the unit of Y can be stretched
    const double along = std::sqrt(std::abs(at_centre / principal.value));
    const double across = std::ldexp(std::sqrt(std::abs(at_centre / other)), stretch.x + stretch.y);
    // Whether the longer axis, or the one with the vertices, is Y.
    const bool turned = four_ac > 0 ? along < across : at_centre > 0;
    axes.sizes[0] = turned ? across : along;
    axes.sizes[1] = turned ? along : across;
    const double x = turned ? -principal.y : principal.x, y = turned ? principal.x : principal.y;
    const double sign = x < 0 || (x == 0 && y < 0) ? -1 : 1;
    axes.x[0] = sign * x + 0.0; // no -0
    axes.x[1] = sign * y + 0.0;
}

// For parabolas: the equation is value X^2 + across X + along Y + f, with Y along the axis of the parabola.
void parabola_axes(const Equation &q, ConicAxes &axes) noexcept {
    const bool first = q.a >= q.c; // the larger row of the matrix, which has rank 1, gives the direction of X
    const double value = q.a + q.c;
    const double norm = first ? std::hypot(q.a, q.b / 2) : std::hypot(q.b / 2, q.c);
    const double x = (first ? q.a : q.b / 2) / norm, y = (first ? q.b / 2 : q.c) / norm;
    const double across = q.d * x + q.e * y;
    const double along = first ? difference_of_products(q.a, q.e, q.b / 2, q.d) / norm
                               : difference_of_products(q.b / 2, q.e, q.c, q.d) / norm;
    const double at_x = -across / (2 * value);
    const double at_y = (across * across / (4 * value) - q.f) / along;
    axes.origin[0] = at_x * x - at_y * y;
    axes.origin[1] = at_x * y + at_y * x;
    axes.x[0] = along < 0 ? -y : y;
    axes.x[1] = along < 0 ? x : -x;
    axes.sizes[0] = std::abs(along) / (4 * value);
    axes.sizes[1] = 0;
}

// The exact sign of 4 a c - b^2.
int discriminant_sign(const double *q) noexcept {
    return std::abs(q[0]) < 1 ? compare_products(4 * q[0], q[2], q[1], q[1])
                              : compare_products(q[0], q[2], q[1] / 2, q[1] / 2);
}

} // namespace

bool find_conic_axes(const double *coefficients, ConicAxes &axes) noexcept {
    if (!all_finite({coefficients, 6})) {
        return false;
    }
    const Scaled scaled(coefficients);
    Equation q = scaled.equation, stretched = scaled.stretched;
    if (q.a + q.c < 0) {
        q = -q;
        stretched = -stretched;
    }
    const int sign = discriminant_sign(coefficients);
    const TripleProducts determined = determinant(stretched);
    const double determinant = determined.sum.value();
    if (determined.vanishes() || (sign > 0 && determinant > 0)) {
        return false;
    }
    if (sign == 0) {
        parabola_axes(q, axes);
    } else {
        const double four_ac = difference_of_products(4 * stretched.a, stretched.c, stretched.b, stretched.b);
        central_axes(stretched, scaled.stretch, Principal(q), four_ac, determinant / four_ac, axes);
    }
    axes.type = sign > 0 ? conic_ellipse : sign == 0 ? conic_parabola : conic_hyperbola;
    for (double *x : {&axes.origin[0], &axes.origin[1], &axes.sizes[0], &axes.sizes[1]}) {
        *x = std::ldexp(*x, scaled.exponent) + 0.0; // no -0
    }
    return true;
}

ConicAxes conic_axes(const double *coefficients) {
    for (int i = 0; i < 6; ++i) {
        if (!std::isfinite(coefficients[i])) {
            fail(Status::factor, "coefficients[%d] = %s is not finite", i, Number(coefficients[i]).text);
        }
    }
    ConicAxes axes{};
    if (!find_conic_axes(coefficients, axes)) {
        const double discriminant =
            difference_of_products(coefficients[1], coefficients[1], 4 * coefficients[0], coefficients[2]);
        fail(Status::conic, "coefficients describe no ellipse, parabola or hyperbola: B^2 - 4 A C = %s",
             Number(discriminant).text);
    }
    for (const double x :
         {axes.origin[0], axes.origin[1], axes.x[0], axes.x[1], axes.sizes[0], axes.sizes[1]}) {
        if (!std::isfinite(x)) {
            fail(Status::not_representable, "a value of the axes of the conic overflows");
        }
    }
    if (!(axes.sizes[0] > 0) || (axes.type != conic_parabola && !(axes.sizes[1] > 0))) {
        fail(Status::not_representable, "sizes = %s, %s: a size of the conic underflows",
             Number(axes.sizes[0]).text, Number(axes.sizes[1]).text);
    }
    return axes;
}

} // namespace nrb::recognize

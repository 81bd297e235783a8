// Laws of the geometry: variation diminishing, convex hull, end curvature, three tangents, linear precision.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace shape_laws_test {

using namespace support;
using reference::eps;

namespace {

using Vector = std::array<long double, 3>;

Vector at(const std::vector<double> &values, size_t record) {
    return {values[3 * record], values[3 * record + 1], values[3 * record + 2]};
}

Vector minus(const Vector &a, const Vector &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

long double length(const Vector &a) {
    return std::hypot(a[0], a[1], a[2]);
}

// Sign changes of a sequence in which values of size <= noise do not count.
int sign_changes(const std::vector<double> &values, double noise) {
    int changes = 0;
    int sign = 0;
    for (const double x : values) {
        if (std::fabs(x) <= noise) {
            continue;
        }
        const int now = x > 0 ? 1 : -1;
        changes += sign != 0 && now != sign ? 1 : 0;
        sign = now;
    }
    return changes;
}

// A plane meets a curve no more often than its control polygon. With the plane x = 0: the signs of a scalar
// curve.
TEST(ShapeLaws, variation_diminishing) {
    for_each_case(120000, 1000, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 12);
        recipe.dim = 1;
        recipe.axes[0].spans = random.whole(1, 12);
        if (recipe.axes[0].form == KnotForm::periodic) {
            recipe.axes[0].form = KnotForm::unclamped;
        }
        const auto data = random_spline(random, recipe);
        auto params = random_params(random, data, 300);
        std::sort(params.begin(), params.end());
        const auto g = create(data);
        double hull = 0;
        for (const double x : data.points) {
            hull = std::max(hull, std::fabs(x));
        }
        const auto noise = static_cast<double>(reference::c_of(data) * eps * hull);
        ASSERT_LE(sign_changes(eval(g.get(), params), noise), sign_changes(data.points, 0))
            << where(seed, data);
    });
}

// Every coordinate lies between the smallest and the largest of the active control points of positive weight.
TEST(ShapeLaws, convex_hull) {
    for_each_case(121000, 200, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 4));
        const auto g = create(data);
        const auto params = random_params(random, data, 10);
        const auto points = eval(g.get(), params);
        const auto axes = data.degrees.size();
        for (size_t i = 0; i < params.size() / axes; ++i) {
            const double *param = &params[i * axes];
            const double slack =
                static_cast<double>(reference::c_of(data) * eps * reference::exact_hull(data, param));
            for (int c = 0; c < data.dim; ++c) {
                double low = HUGE_VAL;
                double high = -HUGE_VAL;
                for (const int64_t p : reference::active_points(data, reference::first_active(data, param))) {
                    if (data.weight(p) > 0) {
                        low = std::min(low, data.coordinate(p, c));
                        high = std::max(high, data.coordinate(p, c));
                    }
                }
                const double x = points[i * static_cast<size_t>(data.dim) + static_cast<size_t>(c)];
                ASSERT_TRUE(low - slack <= x && x <= high + slack) << where(seed, data);
            }
        }
    });
}

Handle bezier(int degree, const std::vector<double> &points) {
    nurbs *g = nullptr;
    require_ok(nurbs_create_bezier(1, &degree, 3, points.data(), 0, 0, nullptr, 0, &g));
    return Handle(g);
}

std::vector<double> small_points(Random &random, int n) {
    std::vector<double> points;
    for (int i = 0; i < 3 * n; ++i) {
        points.push_back(random.whole(-8, 8));
    }
    return points;
}

// Curvature at the start of a Bezier curve of degree n: (n - 1) / n |a x b| / |a|^3, a and b the first two
// legs. (Farin 1988)
TEST(ShapeLaws, end_curvature_of_bezier_curves) {
    for_each_case(122000, 300, [](Random &random, uint64_t seed) {
        const int n = random.whole(2, 15);
        const auto points = small_points(random, n + 1);
        const Vector a = minus(at(points, 1), at(points, 0));
        const Vector b = minus(at(points, 2), at(points, 1));
        if (length(a) == 0) {
            return;
        }
        const auto derivs = eval_derivs(bezier(n, points).get(), 2, {0});
        const Vector first = at(derivs, 1);
        const Vector second = at(derivs, 2);
        const long double got = length(cross(first, second)) / std::pow(length(first), 3.0L);
        const long double want = (n - 1.0L) / n * length(cross(a, b)) / std::pow(length(a), 3.0L);
        // Relative errors of C' and C'' by the contract, carried through the formula.
        const long double second_size = 4.0L * n * (n - 1) * 8;
        const long double first_size = 2.0L * n * 8;
        const long double relative = 2 * (reference::c_of(n) + 4) * eps;
        const long double first_length = n * length(a);
        const long double bound = relative * (second_size + 4 * first_size * second_size / first_length) * 3 /
                                  (first_length * first_length);
        ASSERT_LE(std::fabs(got - want), bound) << "seed " << seed << " degree " << n << " " << hex(points);
        ASSERT_LE(bound, 1e-8 * (1 + want)) << "the bound says nothing";
    });
}

// Where the tangent at s meets the tangent at t, as a fraction of the way from C(r) ... : of a parabola, the
// point on the tangent at parameter q that also lies on the tangent at r.
Vector meeting_point(const std::vector<double> &derivs, size_t q, size_t r) {
    const Vector from = at(derivs, 3 * q);
    const Vector direction = at(derivs, 3 * q + 1);
    const Vector other = at(derivs, 3 * r + 1);
    const Vector normal = cross(direction, other);
    const Vector moment = cross(minus(at(derivs, 3 * r), from), other);
    const long double size = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    const long double step = (moment[0] * normal[0] + moment[1] * normal[1] + moment[2] * normal[2]) / size;
    return {from[0] + step * direction[0], from[1] + step * direction[1], from[2] + step * direction[2]};
}

// Three tangents of a parabola at t0 < t1 < t2 cut each other in the ratio (t1 - t0) : (t2 - t1). (Farin
// 1988, section 4.1)
TEST(ShapeLaws, three_tangents_of_a_parabola) {
    for_each_case(123000, 200, [](Random &random, uint64_t seed) {
        const auto points = small_points(random, 3);
        const Vector legs = cross(minus(at(points, 1), at(points, 0)), minus(at(points, 2), at(points, 1)));
        if (length(legs) < 1) {
            return;
        }
        const double t0 = random.between(0, 0.3);
        const double t1 = random.between(0.35, 0.65);
        const double t2 = random.between(0.7, 1);
        const auto derivs = eval_derivs(bezier(2, points).get(), 2, {t0, t1, t2});
        const long double ratio = (static_cast<long double>(t1) - t0) / (static_cast<long double>(t2) - t1);
        const Vector apex = meeting_point(derivs, 0, 2);
        const Vector low = meeting_point(derivs, 0, 1);
        const Vector high = meeting_point(derivs, 2, 1);
        const Vector touch = at(derivs, 3);
        const std::pair<Vector, Vector> cuts[] = {
            {minus(low, at(derivs, 0)), minus(apex, low)},   // on the first tangent
            {minus(touch, low), minus(high, touch)},         // on the middle one
            {minus(high, apex), minus(at(derivs, 6), high)}, // on the last one
        };
        for (const auto &[before, after] : cuts) {
            for (size_t c = 0; c < 3; ++c) {
                // Coordinates up to 8, tangents at least 0.05 apart in direction times their lengths.
                ASSERT_NEAR(static_cast<double>(before[c]), static_cast<double>(ratio * after[c]), 1e-9)
                    << "seed " << seed << " " << hex(points);
            }
        }
    });
}

// Control points on a line at the Greville abscissae give that line, uniformly traversed: derivative
// constant, second one zero.
TEST(ShapeLaws, linear_precision_of_derivatives) {
    for_each_case(124000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe;
        recipe.axes = {
            {random.whole(1, 9), KnotForm::clamped, Spacing::full, Placement::origin, random.whole(1, 6)}};
        recipe.dim = 1;
        auto data = random_spline(random, recipe);
        for (const auto &t = data.knots[0]; const double knot : t) {
            if (knot > t.front() && knot < t.back() &&
                std::count(t.begin(), t.end(), knot) > data.degrees[0]) {
                return; // broken in two: the derivative formula does not reach across
            }
        }
        require_ok(nurbs_greville(create(data).get(), 0, data.counts[0], data.points.data()));
        const auto g = create(data);
        for (const double t : random_params(random, data, 10)) {
            const auto derivs = eval_derivs(g.get(), 2, {t});
            const auto sizes = reference::magnitudes(data, 2, &t, reference::Terms::stored);
            // The abscissae are rounded (p + 1) / 2 times, which the magnitudes of the differences count as
            // well.
            const long double c = reference::c_of(data) + data.degrees[0] + 1;
            ASSERT_LE(std::fabs(derivs[1] - 1), 2 * (c + 2) * eps * sizes[1][0]) << where(seed, data);
            ASSERT_LE(std::fabs(derivs[2]), 2 * (c + 4) * eps * sizes[2][0]) << where(seed, data);
        }
    });
}

} // namespace

} // namespace shape_laws_test

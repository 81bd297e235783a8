// Boxes, cones and extreme points contain the shapes that they belong to, and touch them.
#include "exact_points.h"
#include "made_shapes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace boxes_test {

using namespace support;

namespace {

using Vec = std::vector<double>;
constexpr double pi = std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Box {
    Vec lower, upper;
    double gap = -1;
};

Box box_of(const nurbs *g, int dim, double tolerance, const double *range = nullptr) {
    Box box{Vec(static_cast<size_t>(dim)), Vec(static_cast<size_t>(dim)), -1};
    require_ok(nurbs_box(g, range, tolerance, box.lower.data(), box.upper.data(), &box.gap));
    return box;
}

double size_of(const SplineData &data) {
    double largest = 0;
    for (const double x : data.points) {
        largest = std::max(largest, std::fabs(x));
    }
    return largest;
}

SplineData any_shape(Random &random) {
    if (random.chance(50)) {
        SplineData data = made_shape(random, random.whole(NURBS_SHAPE_LINE, NURBS_SHAPE_TORUS), 3).data;
        move(data, random_motion(random, 3, random.magnitude(1e-6, 1e6), 3));
        return data;
    }
    return random_spline(random, random_recipe(random, random.whole(1, 3), 4));
}

// Weights by which rounding is not magnified.
bool even_weights(const SplineData &data) {
    const auto [least, most] = std::minmax_element(data.weights.begin(), data.weights.end());
    return data.weights.empty() || *most <= 100 * *least;
}

// A part of the domain, or all of it.
Vec any_range(Random &random, const SplineData &data) {
    Vec range;
    for (int k = 0; k < data.axes(); ++k) {
        double a = data.lower(k), b = data.upper(k);
        if (random.chance(50)) {
            const double s = a + (b - a) * random.unit(), t = a + (b - a) * random.unit();
            if (s != t) {
                a = std::max(a, std::min(s, t));
                b = std::min(b, std::max(s, t));
            }
        }
        range.insert(range.end(), {a, b});
    }
    return range;
}

Vec param_in(Random &random, const Vec &range) {
    Vec param;
    for (size_t k = 0; k < range.size(); k += 2) {
        const int kind = random.whole(0, 5);
        const double t = range[k] + (range[k + 1] - range[k]) * random.unit();
        param.push_back(kind == 0   ? range[k]
                        : kind == 1 ? range[k + 1]
                                    : std::clamp(t, range[k], range[k + 1]));
    }
    return param;
}

} // namespace

// The stored shape, without rounding, is inside, and so are evaluated points at many more places.
TEST(Boxes, contain_exact_points) {
    for_each_case(6100, 400, [](Random &random, uint64_t seed) {
        const SplineData data = any_shape(random);
        const Handle g = create(data);
        const Vec range = any_range(random, data);
        const double tolerance = random.chance(20) ? infinite : random.magnitude(1e-9, 1) * size_of(data);
        const Box box = box_of(g.get(), data.dim, tolerance, range.data());
        Vec direction(static_cast<size_t>(data.dim));
        std::generate(direction.begin(), direction.end(), [&] { return random.between(-1, 1); });
        double bound = 0;
        require_ok(nurbs_extreme_point(g.get(), direction.data(), range.data(), tolerance, nullptr, nullptr,
                                       &bound));
        for (int i = 0; i < 20; ++i) {
            const Vec param = param_in(random, range);
            reference::Sides left{};
            for (size_t k = 0; k < param.size(); ++k) { // at a jump at its end the limit from inside
                left[k] = param[k] == range[2 * k + 1];
            }
            const auto point = reference::exact_point(data, param.data(), left);
            Rational along = 0;
            for (size_t c = 0; c < point.size(); ++c) {
                const Rational x(point[c].numerator, point[c].denominator);
                ASSERT_TRUE(exact(box.lower[c]) <= x && x <= exact(box.upper[c])) << where(seed, data);
                along += exact(direction[c]) * x;
            }
            ASSERT_TRUE(std::isinf(bound) || along <= exact(bound)) << where(seed, data);
        }
    });
}

TEST(Boxes, contain_many_points) {
    for_each_case(6200, 25, [](Random &random, uint64_t seed) {
        const SplineData data = any_shape(random);
        const Handle g = create(data);
        const Box box = box_of(g.get(), data.dim, 1e-6 * size_of(data));
        constexpr int n = 40000;
        Vec params;
        for (int i = 0; i < n; ++i) {
            for (int k = 0; k < data.axes(); ++k) {
                const double t = data.lower(k) + (data.upper(k) - data.lower(k)) * random.unit();
                params.push_back(std::clamp(t, data.lower(k), data.upper(k)));
            }
        }
        const Vec points = eval(g.get(), params);
        for (size_t i = 0; i < points.size(); ++i) {
            const size_t c = i % static_cast<size_t>(data.dim);
            ASSERT_TRUE(points[i] >= box.lower[c] && points[i] <= box.upper[c])
                << points[i] << " " << box.lower[c] << " " << box.upper[c] << where(seed, data);
        }
    });
}

// The gap that is claimed is one: each face has a point of the shape so near, which extreme points tell.
TEST(Boxes, touch_within_the_tolerance) {
    WorstRatios worst("gap over tolerance and 1e-12 of the size");
    for_each_case(6300, 200, [&](Random &random, uint64_t seed) {
        SplineData data = any_shape(random);
        const Handle g = create(data);
        const double size = size_of(data), tolerance = random.magnitude(1e-7, 1e-2) * size;
        const Box box = box_of(g.get(), data.dim, tolerance);
        const bool even = even_weights(data);
        for (int c = 0; c < data.dim; ++c) {
            for (const double sign : {-1.0, 1.0}) {
                Vec direction(static_cast<size_t>(data.dim)), param(static_cast<size_t>(data.axes()));
                direction[static_cast<size_t>(c)] = sign;
                double value = 0, bound = 0;
                require_ok(nurbs_extreme_point(g.get(), direction.data(), nullptr, tolerance, param.data(),
                                               &value, &bound));
                const double face =
                    sign > 0 ? box.upper[static_cast<size_t>(c)] : -box.lower[static_cast<size_t>(c)];
                EXPECT_LE(value, bound);
                EXPECT_LE(face - value, box.gap + tolerance + 1e-12 * size) << where(seed, data);
                if (even) {
                    worst.add(box.gap / (tolerance + 1e-12L * size));
                    EXPECT_LE(bound - value, tolerance + 1e-12 * size) << where(seed, data);
                }
            }
        }
    });
}

TEST(Boxes, of_an_ellipse) {
    const double x[] = {3, 4}, a = 5, b = 2;
    const double direction[] = {0.6, 0.8};
    nurbs *out = nullptr;
    require_ok(nurbs_curve_ellipse(2, nullptr, nullptr, x, a, b, 0.3, 2 * pi, NURBS_ARC_QUARTERS, &out));
    const Handle g(out);
    const double half[] = {std::hypot(a * 0.6, b * 0.8), std::hypot(a * 0.8, b * 0.6)};
    const Box box = box_of(g.get(), 2, 1e-13);
    for (size_t c = 0; c < 2; ++c) {
        EXPECT_NEAR(box.upper[c], half[c], 2e-13);
        EXPECT_NEAR(box.lower[c], -half[c], 2e-13);
    }
    Vec center(2), axes(4), sides(2);
    require_ok(nurbs_oriented_box(g.get(), 1e-12, center.data(), axes.data(), sides.data()));
    EXPECT_NEAR(std::fabs(axes[0] * direction[0] + axes[1] * direction[1]), 1, 1e-2);
    EXPECT_LT(sides[0] * sides[1], half[0] * half[1]);
}

TEST(Boxes, oriented_ones_contain_exact_points) {
    for_each_case(6400, 200, [](Random &random, uint64_t seed) {
        const SplineData data = any_shape(random);
        const Handle g = create(data);
        const auto dim = static_cast<size_t>(data.dim);
        Vec center(dim), axes(dim * dim), half(dim);
        require_ok(
            nurbs_oriented_box(g.get(), 1e-3 * size_of(data), center.data(), axes.data(), half.data()));
        for (int i = 0; i < 10; ++i) {
            const Point p = point_at(data, random_params(random, data, 1));
            for (size_t r = 0; r < dim; ++r) { // the rows are orthonormal to 1e-14
                Rational along = 0;
                for (size_t c = 0; c < dim; ++c) {
                    along += exact(axes[r * dim + c]) * (p[c] - exact(center[c]));
                }
                EXPECT_LE(std::fabs(as_long_double(along)), half[r] + 1e-14L * size_of(data))
                    << where(seed, data);
            }
        }
    });
}

TEST(Cones, contain_derivatives) {
    for_each_case(6500, 200, [](Random &random, uint64_t seed) {
        SplineData data = any_shape(random);
        const Handle g = create(data);
        const auto dim = static_cast<size_t>(data.dim);
        const int axis = random.whole(0, data.axes() - 1);
        Vec range;
        for (int k = 0; k < data.axes(); ++k) {
            const double a = data.lower(k), b = data.upper(k);
            range.insert(range.end(), {a + 0.3 * (b - a), a + random.between(0.31, 0.6) * (b - a)});
        }
        Vec direction(dim);
        double angle = -1;
        require_ok(nurbs_tangent_cone(g.get(), axis, range.data(), 0.05, direction.data(), &angle));
        double length = 0;
        for (const double x : direction) {
            length += x * x;
        }
        EXPECT_NEAR(length, 1, 1e-14);
        for (int i = 0; i < 10; ++i) {
            const auto derivs = reference::exact_derivatives(data, 1, param_in(random, range).data());
            const auto &d = derivs[static_cast<size_t>(axis) + 1];
            long double square = 0, apart = 0, across = 0;
            std::vector<long double> x;
            for (size_t c = 0; c < dim; ++c) {
                x.push_back(reference::quotient(d[c].numerator, d[c].denominator));
                square += x.back() * x.back();
            }
            for (size_t c = 0; c < dim && square > 0; ++c) {
                const long double unit = x[c] / std::sqrt(square);
                apart += (unit - direction[c]) * (unit - direction[c]);
                across += (unit + direction[c]) * (unit + direction[c]);
            }
            if (square > 0) {
                const long double turned = 2 * std::atan2(std::sqrt(apart), std::sqrt(across));
                EXPECT_LE(turned, angle + 4e-16) << where(seed, data);
            }
        }
    });
}

// A torus: its normals over a part are those of the angles.
TEST(Cones, of_normals_of_a_torus) {
    nurbs *out = nullptr;
    require_ok(
        nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0, 2 * pi, 0, 2 * pi, NURBS_ARC_QUARTERS, &out));
    const Handle g(out);
    double domains[4];
    require_ok(nurbs_domain(g.get(), 0, domains));
    require_ok(nurbs_domain(g.get(), 1, domains + 2));
    for_each_case(6600, 50, [&](Random &random, uint64_t) {
        double range[4];
        for (size_t k = 0; k < 4; k += 2) {
            const double length = domains[k + 1] - domains[k];
            range[k] = domains[k] + length * random.between(0, 0.8);
            range[k + 1] = range[k] + length * random.between(0.01, 0.12);
        }
        Vec direction(3);
        double angle = 0;
        require_ok(nurbs_normal_cone(g.get(), range, 1e-3, direction.data(), &angle));
        EXPECT_LT(angle, 1.2);
        Vec params;
        for (int i = 0; i < 100; ++i) {
            const Vec p = param_in(random, {range, range + 4});
            params.insert(params.end(), p.begin(), p.end());
        }
        Vec normals(300);
        require_ok(nurbs_surface_eval_frames(g.get(), 100, params.data(), 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                             nullptr, 0, 0, normals.data(), 0, 0, nullptr, 0));
        double widest = 0;
        for (size_t i = 0; i < 300; i += 3) {
            const double cosine =
                normals[i] * direction[0] + normals[i + 1] * direction[1] + normals[i + 2] * direction[2];
            widest = std::max(widest, std::acos(std::clamp(cosine, -1.0, 1.0)));
        }
        EXPECT_LE(widest, angle + 1e-7);
        EXPECT_GE(widest, angle - 0.05); // corners are among the places
    });
}

// The poles of a sphere are divided out.
TEST(Cones, of_a_hemisphere) {
    nurbs *out = nullptr;
    require_ok(nurbs_surface_spherical_patch(nullptr, nullptr, nullptr, 1, 0, 2 * pi, 0.5, pi / 2,
                                             NURBS_ARC_QUARTERS, &out));
    const Handle g(out);
    Vec direction(3);
    double angle = 0;
    require_ok(nurbs_normal_cone(g.get(), nullptr, 1e-4, direction.data(), &angle));
    EXPECT_NEAR(std::fabs(direction[2]), 1, 1e-3);
    EXPECT_NEAR(angle, pi / 2 - 0.5, 0.05);
}

} // namespace boxes_test

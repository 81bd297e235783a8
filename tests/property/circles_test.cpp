// Circular arcs and lengths of curves that constructors make: equations, ends, closed forms.
#include "property/made_curves.h"

namespace circles_test {

using namespace support;
using namespace support::curves;

namespace {

// A circular arc anywhere; over full turns every other time.
struct AnyArc {
    int dim;
    Vec center, axis, x;
    double radius, start, sweep;

    AnyArc(Random &random, int i) : dim(2 + i % 2) {
        center = random_vector(random, dim, i % 5 == 0 ? 0 : 10);
        axis = random_vector(random, 3, 1);
        x = random_vector(random, dim, 1);
        radius = random.magnitude(0.01, 100);
        start = random.between(-7, 7);
        sweep = i % 2 == 0 ? 2 * pi : random.between(0.01, 6.28) * (random.chance(50) ? 1 : -1);
    }
    [[nodiscard]] Handle curve(int form) const {
        return made([&](nurbs **out) {
            return nurbs_curve_arc(dim, center.data(), dim == 3 ? axis.data() : nullptr, x.data(), radius,
                                   start, sweep, form, out);
        });
    }
};

TEST(Curves, circles_keep_their_equation_to_4_eps_size_over_a_million_points) {
    std::array<long double, 3> worst{};
    for_each_case(40100, 300, [&](Random &random, uint64_t seed) {
        const AnyArc arc(random, static_cast<int>(seed % 20));
        const int form = static_cast<int>(seed % 3);
        const Handle g = arc.curve(form);
        const Vec points = eval(g.get(), random_params(random, 3500));
        const auto dim = static_cast<size_t>(arc.dim);
        const double size = size_of(g.get());
        for (size_t i = 0; i < points.size(); i += dim) {
            std::vector<long double> offset;
            for (size_t c = 0; c < dim; ++c) {
                offset.push_back(static_cast<long double>(points[i + c]) - arc.center[c]);
            }
            const long double off = std::fabs(length(offset) - arc.radius) / size / double_eps;
            ASSERT_LE(off, 4) << "seed " << seed << " form " << form;
            worst[static_cast<size_t>(form)] = std::max(worst[static_cast<size_t>(form)], off);
        }
    });
    std::printf("arcs: largest distance from the circle %.2Lf, %.2Lf, %.2Lf double_eps size\n", worst[0],
                worst[1], worst[2]);
}

TEST(Curves, full_turns_close_bit_for_bit) {
    for_each_case(40200, 60, [](Random &random, uint64_t seed) {
        AnyArc arc(random, static_cast<int>(seed % 20));
        arc.sweep = seed % 2 == 0 ? 2 * pi : -2 * pi;
        const Handle g = arc.curve(static_cast<int>(seed % 3));
        ASSERT_TRUE(same_bits(eval(g.get(), {0}), eval(g.get(), {1})));
    });
}

TEST(Curves, arcs_by_points_and_tangents_have_their_ends_bit_for_bit) {
    for_each_case(40300, 200, [](Random &random, uint64_t seed) {
        const int dim = 2 + static_cast<int>(seed % 4), form = static_cast<int>(seed % 3);
        const Vec a = random_vector(random, dim, 5), b = random_vector(random, dim, 5),
                  c = random_vector(random, dim, 5);
        const Handle through = made([&](nurbs **out) {
            return nurbs_curve_arc_through(dim, a.data(), b.data(), c.data(), form, out);
        });
        const Handle tangent = made([&](nurbs **out) {
            return nurbs_curve_arc_tangent(dim, a.data(), b.data(), c.data(), form, out);
        });
        for (const nurbs *g : {through.get(), tangent.get()}) {
            ASSERT_TRUE(same_bits(eval(g, {0}), a));
            ASSERT_TRUE(same_bits(eval(g, {1}), c));
        }
        const Vec derivs = eval_derivs(tangent.get(), 1, {0});
        long double along = 0;
        std::vector<long double> d, t;
        for (size_t i = 0; i < static_cast<size_t>(dim); ++i) {
            d.push_back(derivs[static_cast<size_t>(dim) + i]);
            t.push_back(b[i]);
            along += d[i] * t[i];
        }
        ASSERT_GT(along / length(d) / length(t), 1 - 1e-13L);
    });
}

// Length by Gauss-Legendre quadrature with 5 points on each of `parts` parts of [0, 1].
double length_of(const nurbs *g, int dim, int parts) {
    constexpr std::array<double, 5> nodes = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                             0.9061798459386640};
    constexpr std::array<double, 5> weights = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                               0.4786286704993665, 0.2369268850561891};
    Vec params;
    for (int i = 0; i < parts; ++i) {
        for (const double node : nodes) {
            params.push_back((i + (node + 1) / 2) / parts);
        }
    }
    const Vec derivs = eval_derivs(g, 1, params);
    const auto width = static_cast<size_t>(dim);
    double sum = 0;
    for (size_t i = 0; i < params.size(); ++i) {
        std::vector<long double> d(derivs.begin() + static_cast<std::ptrdiff_t>((2 * i + 1) * width),
                                   derivs.begin() + static_cast<std::ptrdiff_t>((2 * i + 2) * width));
        sum += weights[i % 5] / 2 / parts * static_cast<double>(length(d));
    }
    return sum;
}

TEST(Curves, lengths_are_exact) {
    for (int form = 0; form < 3; ++form) {
        const Handle circle = made(
            [&](nurbs **out) { return nurbs_curve_circle(3, nullptr, nullptr, nullptr, 2.5, form, out); });
        EXPECT_NEAR(length_of(circle.get(), 3, 240), 5 * pi, 1e-13 * 5 * pi);
        const Handle arc = made(
            [&](nurbs **out) { return nurbs_curve_arc(2, nullptr, nullptr, nullptr, 3, 1, -2, form, out); });
        EXPECT_NEAR(length_of(arc.get(), 2, 240), 6, 1e-13 * 6);
    }
    // x = t^2 / 4, y = t: the length from 0 to 1 is sqrt(5) / 4 + asinh(1 / 2).
    const Handle parabola =
        made([](nurbs **out) { return nurbs_curve_parabola(2, nullptr, nullptr, nullptr, 1, 0, 1, out); });
    EXPECT_NEAR(length_of(parabola.get(), 2, 60), std::sqrt(5.0) / 4 + std::asinh(0.5), 1e-13);
    const Handle box = made([](nurbs **out) {
        return nurbs_curve_rounded_rectangle(2, nullptr, nullptr, nullptr, 6, 4, 1, out);
    });
    EXPECT_NEAR(length_of(box.get(), 2, 240), 12 + 2 * pi, 1e-12);
}

TEST(Curves, nothing_but_the_size_depends_on_the_scale) {
    for_each_case(40600, 60, [](Random &random, uint64_t seed) {
        const Vec a = random_vector(random, 3, 1), b = random_vector(random, 3, 1),
                  c = random_vector(random, 3, 1);
        const double scale = std::ldexp(1.0, random.whole(-300, 300));
        Vec sa = a, sb = b, sc = c;
        for (Vec *v : {&sa, &sb, &sc}) {
            for (double &x : *v) {
                x *= scale;
            }
        }
        const int form = static_cast<int>(seed % 3);
        const SplineData one =
            read_back(made([&](nurbs **out) {
                          return nurbs_curve_arc_through(3, a.data(), b.data(), c.data(), form, out);
                      }).get());
        const SplineData other =
            read_back(made([&](nurbs **out) {
                          return nurbs_curve_arc_through(3, sa.data(), sb.data(), sc.data(), form, out);
                      }).get());
        ASSERT_TRUE(same_bits(scaled(one, scale).points, other.points));
        ASSERT_TRUE(same_bits(one.weights, other.weights));
    });
}

} // namespace

} // namespace circles_test

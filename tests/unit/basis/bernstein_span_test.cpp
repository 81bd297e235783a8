// The values of Bernstein spans against rational numbers, on every instruction set.
#include "unit/targets.h"

#include "basis/bernstein_span.h"
#include "basis/knot_vector.h"
#include "numeric/binomial.h"
#include "reference/definition.h"
#include "reference/exact_basis.h"
#include "support/cases.h"

#include <cmath>

namespace bernstein_span_test {

using namespace support;
using nrb::BernsteinSpan;
using nrb::PowerSpan;
using reference::exact;
using reference::Rational;

namespace {

using Spans = targets::Targets;
constexpr int lanes = 4;

// Three coordinates and a weight, to be multiplied by weights far apart.
struct Window {
    std::vector<double> weights, points;

    Window(Random &random, int degree) {
        for (int j = 0; j <= degree; ++j) {
            weights.push_back(random.chance(10) ? 0 : random.magnitude(1e-12, 1e12));
            for (int c = 0; c < lanes; ++c) {
                points.push_back(c == 3 ? 1 : random.between(-1, 1));
            }
        }
    }
    [[nodiscard]] std::vector<std::vector<Rational>> exact_points() const {
        std::vector<std::vector<Rational>> all;
        for (size_t j = 0; j < weights.size(); ++j) {
            all.emplace_back();
            for (size_t c = 0; c < lanes; ++c) {
                all.back().push_back(exact(weights[j]) * exact(points[j * lanes + c]));
            }
        }
        return all;
    }
};

std::vector<double> made(const nrb::KnotVector &axis, int64_t span, const Window &window) {
    std::vector<double> out(static_cast<size_t>(BernsteinSpan::head_size + lanes * (axis.degree() + 1)));
    nrb::make_bernstein_span(axis.knots().data(), axis.degree(), span, window.weights.data(),
                             window.points.data(), lanes, out.data());
    return out;
}

nrb::KnotVectorPtr random_axis_of(Random &random, int degree) {
    AxisRecipe recipe = random_axis(random, degree);
    recipe.spans = 4;
    return nrb::make_knot_vector(degree, random_knots(random, recipe));
}

// Weights do not cancel, and so are the nearest numbers but for rare ties; coordinates may, of which the terms
// are known to some 2^-98.
void compare(const nrb::KnotVector &axis, int64_t span, Random &random) {
    const int p = axis.degree();
    const Window window(random, p);
    const std::vector<double> span_made = made(axis, span, window);
    EXPECT_TRUE(std::isnan(span_made[PowerSpan::lower]));
    EXPECT_EQ(span_made[BernsteinSpan::a], axis[span]);
    EXPECT_EQ(span_made[BernsteinSpan::b], axis[span + 1]);
    const std::vector<double> knots(axis.knots().begin(), axis.knots().end());
    for (int i = 0; i <= p; i += p > 9 && i > 0 && i + 1 < p ? p / 2 : 1) {
        std::vector<Rational> arguments(static_cast<size_t>(p), exact(axis[span]));
        std::fill_n(arguments.begin(), i, exact(axis[span + 1]));
        const auto want = reference::blossom_at(knots, p, span, window.exact_points(), arguments);
        const double factor = nrb::binomial(p, i);
        for (size_t c = 0; c < lanes; ++c) {
            const Rational value = want[c] * exact(factor);
            const Rational size = want[3] * exact(factor); // of the terms
            const double got = span_made[static_cast<size_t>(BernsteinSpan::head_size + i * lanes) + c];
            const Rational error = abs(Rational(exact(got) - value));
            EXPECT_LE(error, abs(value) * exact(0x1p-53) * exact(1 + 0x1p-40) + size * exact(0x1p-92))
                << "degree " << p << ", point " << i << ", component " << c;
        }
    }
}

TEST_P(Spans, are_exact_but_for_one_rounding) {
    for (const int degree : {1, 2, 3, 5, 9, 10, 16, 31}) {
        for_each_case(99000 + 100 * static_cast<uint64_t>(degree), degree > 9 ? 1 : 5,
                      [&](Random &random, uint64_t) {
                          const auto axis = random_axis_of(random, degree);
                          const std::span<const int64_t> spans = axis->spans().indices();
                          for (size_t e = 0; e < std::min<size_t>(spans.size(), degree > 9 ? 1 : 3); ++e) {
                              compare(*axis, spans[e], random);
                          }
                      });
    }
}

// Knots that are multiple at both ends: the points are the Bezier points themselves.
TEST_P(Spans, of_bezier_curves_are_their_points_times_binomials) {
    for (int degree = 1; degree <= nrb::max_degree; ++degree) {
        std::vector<double> knots(static_cast<size_t>(degree) + 1, -3.0);
        knots.resize(2 * knots.size(), 0.1);
        Random random(static_cast<uint64_t>(degree));
        Window window(random, degree);
        window.weights.assign(window.weights.size(), 1.0);
        const auto axis = nrb::make_knot_vector(degree, knots);
        const std::vector<double> span = made(*axis, degree, window);
        for (int i = 0; i <= degree; ++i) {
            for (int c = 0; c < lanes; ++c) {
                EXPECT_EQ(span[static_cast<size_t>(BernsteinSpan::head_size + i * lanes + c)],
                          window.points[static_cast<size_t>(i * lanes + c)] * nrb::binomial(degree, i));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryTarget, Spans, targets::every_target(), targets::target_name);

} // namespace

} // namespace bernstein_span_test

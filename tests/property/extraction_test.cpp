// Bezier extraction: N = C B at exact rationals, the law of the sums, and every entry relative to itself.
#include "reference/definition.h"
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cfloat>
#include <gtest/gtest.h>

namespace extraction_test {

using namespace support;
using reference::eps;
using reference::exact;
using reference::Rational;

namespace {

struct Extraction {
    std::vector<double> operators;
    std::vector<int64_t> firsts;
    std::vector<double> domains;
};

Extraction extract(const nurbs *g, int axis, int degree) {
    int64_t spans = 0;
    require_ok(nurbs_bezier_extraction(g, axis, 0, nullptr, nullptr, nullptr, &spans));
    Extraction result;
    result.operators.resize(static_cast<size_t>(spans * (degree + 1) * (degree + 1)));
    result.firsts.resize(static_cast<size_t>(spans));
    result.domains.resize(static_cast<size_t>(2 * spans));
    require_ok(nurbs_bezier_extraction(g, axis, spans, result.operators.data(), result.firsts.data(),
                                       result.domains.data(), &spans));
    return result;
}

// The exact operator of a span: de Boor's algorithm on the unit vectors, at p - k times the start and k times
// the end of the span. C[j][k] is at j * (p + 1) + k.
std::vector<Rational> exact_operator(const std::vector<double> &knots, int degree, int64_t span) {
    const auto p = static_cast<size_t>(degree);
    const auto s = static_cast<size_t>(span);
    std::vector<Rational> result((p + 1) * (p + 1));
    for (size_t k = 0; k <= p; ++k) {
        for (size_t j = 0; j <= p; ++j) {
            std::vector<Rational> d(p + 1, 0);
            d[j] = 1;
            for (size_t r = 1; r <= p; ++r) {
                const Rational t = exact(r <= k ? knots[s + 1] : knots[s]);
                for (size_t i = p; i >= r; --i) {
                    const Rational low = exact(knots[s - p + i]);
                    const Rational high = exact(knots[s + 1 + i - r]);
                    d[i] = ((t - low) * d[i] + (high - t) * d[i - 1]) / (high - low);
                }
            }
            result[j * (p + 1) + k] = d[p];
        }
    }
    return result;
}

// N_(s-p+j)(t) = sum of C[j][k] B_k(x) at a rational place inside the span, by the definitions.
void check_definition(const std::vector<double> &knots, int degree, int64_t span,
                      const std::vector<Rational> &matrix, const std::string &what) {
    const auto p = static_cast<size_t>(degree);
    const Rational a = exact(knots[static_cast<size_t>(span)]);
    const Rational b = exact(knots[static_cast<size_t>(span) + 1]);
    for (const Rational &x : {Rational(1, 3), Rational(5, 7)}) {
        const Rational t = a + x * (b - a);
        for (size_t j = 0; j <= p; ++j) {
            Rational sum = 0;
            for (size_t k = 0; k <= p; ++k) {
                Rational term = matrix[j * (p + 1) + k] * binomial(degree, static_cast<int>(k));
                for (size_t m = 0; m < p; ++m) {
                    term *= m < k ? x : 1 - x;
                }
                sum += term;
            }
            const int64_t i = span - degree + static_cast<int64_t>(j);
            ASSERT_EQ(sum, reference::defined_basis(knots, span, i, degree, t)) << what << " function " << j;
        }
    }
}

void check_entries(const double *actual, const std::vector<Rational> &wanted, int degree, WorstErrors &worst,
                   const std::string &what) {
    const auto width = static_cast<size_t>(degree) + 1;
    for (size_t k = 0; k < width; ++k) {
        Rational exact_sum = 0;
        long double sum = 0;
        for (size_t j = 0; j < width; ++j) {
            const double value = actual[j * width + k];
            const Rational &want = wanted[j * width + k];
            ASSERT_GE(value, 0) << what;
            ASSERT_EQ(value == 0, want == 0) << what << " C[" << j << "][" << k << "]";
            const auto size = static_cast<long double>(want);
            const long double error = reference::error_ratio(value, reference::fraction(want), eps * size);
            if (size > DBL_MIN) {
                worst.add(degree, error / (3.0L * std::max(degree, 1)), error);
                ASSERT_LE(error, 3 * degree) << what << " C[" << j << "][" << k << "]";
            }
            exact_sum += want;
            sum += value;
        }
        ASSERT_EQ(exact_sum, 1) << what;
        ASSERT_LE(std::fabs(sum - 1), (degree + 1) * eps) << what;
    }
}

TEST(Extraction, operators_are_accurate_entry_by_entry) {
    WorstErrors worst("Bezier extraction by degree, unit eps * C");
    for_each_case(90000000, 400, [&](Random &random, uint64_t seed) {
        const int degree = random.chance(10) ? random.whole(8, 12) : random.whole(0, 6);
        Recipe recipe = random_recipe(random, 1, degree);
        recipe.axes[0].degree = degree;
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const Extraction got = extract(g.get(), 0, degree);
        const auto size = static_cast<size_t>((degree + 1) * (degree + 1));
        size_t e = 0;
        for (int64_t span = degree; span < data.counts[0]; ++span) {
            const double a = data.knots[0][static_cast<size_t>(span)];
            const double b = data.knots[0][static_cast<size_t>(span) + 1];
            if (a == b) {
                continue;
            }
            ASSERT_LT(e, got.firsts.size()) << where(seed, data);
            ASSERT_EQ(got.firsts[e], span - degree) << where(seed, data);
            ASSERT_TRUE(got.domains[2 * e] == a && got.domains[2 * e + 1] == b) << where(seed, data);
            const auto want = exact_operator(data.knots[0], degree, span);
            if (degree <= 4) {
                check_definition(data.knots[0], degree, span, want, where(seed, data));
            }
            check_entries(got.operators.data() + e * size, want, degree, worst,
                          where(seed, data) + " span " + std::to_string(span));
            ++e;
        }
        ASSERT_EQ(e, got.firsts.size()) << where(seed, data);
    });
}

// Only the knots of the axis matter.
TEST(Extraction, axes_of_surfaces_and_volumes) {
    for_each_case(91000000, 200, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(2, 3), 4));
        const auto g = create(data);
        for (int k = 0; k < data.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            SplineData curve = {{data.degrees[at]}, {data.counts[at]}, {data.knots[at]}, 1, {}, {}, 0};
            curve.points.assign(static_cast<size_t>(data.counts[at]), 1);
            const Extraction a = extract(g.get(), k, data.degrees[at]);
            const Extraction b = extract(create(curve).get(), 0, data.degrees[at]);
            ASSERT_TRUE(same_bits(a.operators, b.operators) && same_bits(a.domains, b.domains) &&
                        a.firsts == b.firsts)
                << where(seed, data);
        }
    });
}

} // namespace

} // namespace extraction_test

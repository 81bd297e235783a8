// The coefficients of power spans against rational numbers, on every instruction set.
#include "unit/targets.h"

#include "basis/knot_vector.h"
#include "basis/power_spans.h"
#include "reference/exact_basis.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cmath>

namespace power_spans_test {

using namespace support;
using nrb::PowerSpan;
using reference::exact;
using reference::Rational;

namespace {

using Pieces = targets::Targets;

// Power spans and rests of some spans of one knot vector, made in one call.
struct Together {
    std::vector<std::vector<double>> power_spans;
    std::vector<std::vector<double>> rests;

    Together(const nrb::KnotVector &axis, const std::vector<int64_t> &spans, bool with_rests = true) {
        const auto size = static_cast<size_t>(PowerSpan::size(axis.degree(), axis.degree() + 1));
        power_spans.assign(spans.size(), std::vector<double>(size, std::nan("")));
        rests.assign(spans.size(), std::vector<double>(size, 0.0));
        std::vector<double *> piece_records;
        std::vector<double *> rest_records;
        for (size_t i = 0; i < spans.size(); ++i) {
            piece_records.push_back(power_spans[i].data());
            rest_records.push_back(rests[i].data());
        }
        nrb::basis_power_spans(axis.knots().data(), axis.degree(), spans.data(),
                               static_cast<int>(spans.size()), piece_records.data(),
                               with_rests ? rest_records.data() : nullptr);
    }
};

size_t place(int degree, int k, int j) {
    return static_cast<size_t>(PowerSpan::head_size + k * PowerSpan::lanes(degree + 1) + j);
}

// Powers of the local parameter in place of derivatives: D^k / (k! scale^k).
class ExactPiece {
public:
    ExactPiece(const nrb::KnotVector &axis, const std::vector<double> &power_span)
        : basis_(reference::exact_basis({axis.knots().begin(), axis.knots().end()}, axis.degree(),
                                        power_span[PowerSpan::middle], axis.degree(),
                                        power_span[PowerSpan::middle] == power_span[PowerSpan::upper])),
          scale_(exact(power_span[PowerSpan::scale])) {}

    [[nodiscard]] int64_t span() const { return basis_.span; }
    [[nodiscard]] Rational operator()(int k, int j) const {
        Rational value(basis_.numerators[static_cast<size_t>(k)][static_cast<size_t>(j)], basis_.denominator);
        for (int i = 1; i <= k; ++i) {
            value /= scale_ * i;
        }
        return value;
    }

private:
    reference::ExactBasis basis_;
    Rational scale_;
};

// What the roundings of double-doubles are relative to: the largest magnitude among the terms that are added
// up to the coefficients of power k, from the functions of degree p - k and the difference formula without
// its signs.
std::vector<double> magnitudes(const nrb::KnotVector &axis, int64_t span,
                               const std::vector<double> &power_span, int k) {
    const int p = axis.degree();
    std::vector<double> values = {1};
    double factor = 1;
    for (int r = 1; r <= p; ++r) {
        std::vector<double> upper(values.size() + 1);
        for (int j = 0; j < r; ++j) {
            const double first = axis[span - r + 1 + j];
            const double last = axis[span + 1 + j];
            const double part = values[static_cast<size_t>(j)] / (last - first);
            const double middle = power_span[PowerSpan::middle];
            const bool differs = r > p - k;
            upper[static_cast<size_t>(j)] +=
                part * (differs ? 1 / power_span[PowerSpan::scale] : last - middle);
            upper[static_cast<size_t>(j) + 1] +=
                part * (differs ? 1 / power_span[PowerSpan::scale] : middle - first);
        }
        values = std::move(upper);
        factor *= r > p - k ? static_cast<double>(r) / (r - p + k) : 1;
    }
    for (double &value : values) {
        value *= factor;
    }
    return values;
}

// A power span's coefficients, tallied: how many that did not come from cancellation are not the exact ones
// rounded, and the errors of all with their rests.
struct Tally {
    int64_t count = 0;
    int64_t other = 0;
    double worst_rest = 0; // in units of 2^-104 times the magnitudes

    void add(const nrb::KnotVector &axis, int64_t span, const std::vector<double> &power_span,
             const std::vector<double> &rest) {
        const int p = axis.degree();
        const ExactPiece want(axis, power_span);
        ASSERT_EQ(want.span(), span);
        for (int k = 0; k <= p; ++k) {
            const auto sizes = magnitudes(axis, span, power_span, k);
            for (int j = 0; j <= p; ++j) {
                add(power_span[place(p, k, j)], rest[place(p, k, j)], want(k, j),
                    sizes[static_cast<size_t>(j)]);
            }
        }
    }

private:
    void add(double value, double rest, const Rational &want, double size) {
        ++count;
        const bool cancelled = std::fabs(value) < size * 0x1p-20;
        other += cancelled || value == reference::nearest(reference::fraction(want)) ? 0 : 1;
        const auto error = reference::fraction(abs(Rational(exact(value) + exact(rest) - want)));
        const long double distance = reference::quotient(error.numerator, error.denominator);
        worst_rest = std::max(worst_rest, static_cast<double>(std::ldexp(distance / size, 104)));
        EXPECT_EQ(value, value + rest);
    }
};

nrb::KnotVectorPtr random_axis_of(Random &random, int degree) {
    AxisRecipe recipe = random_axis(random, degree);
    recipe.spans = 6;
    return nrb::make_knot_vector(degree, random_knots(random, recipe));
}

std::vector<int64_t> spans_with_pieces(const nrb::KnotVector &axis) {
    std::vector<int64_t> spans;
    for (const int64_t span : axis.spans().indices()) {
        if (axis.has_power_span(span)) {
            spans.push_back(span);
        }
    }
    return spans;
}

TEST_P(Pieces, have_heads_that_map_their_span_to_unit_size) {
    for_each_case(96000, 200, [](Random &random, uint64_t) {
        const auto axis = random_axis_of(random, random.whole(1, nrb::max_power_span_degree));
        for (const int64_t span : spans_with_pieces(*axis)) {
            const auto power_span = Together(*axis, {span}).power_spans[0];
            const double scale = power_span[PowerSpan::scale];
            EXPECT_EQ(power_span[PowerSpan::lower], (*axis)[span]);
            EXPECT_EQ(power_span[PowerSpan::upper], (*axis)[span + 1]);
            const double behind = power_span[PowerSpan::middle] - power_span[PowerSpan::lower];
            const double ahead = power_span[PowerSpan::upper] - power_span[PowerSpan::middle];
            EXPECT_LE(std::fabs(behind - ahead), 0.05 * (behind + ahead));
            int exponent = 0;
            EXPECT_EQ(std::frexp(scale, &exponent), 0.5);
            EXPECT_LE(std::max(behind, ahead) * scale, 1);
            EXPECT_GE(std::max(behind, ahead) * scale, 0.5);
        }
    });
}

// Rounding a number of twice the precision misses the nearest double only close to a tie. Coefficients whose
// terms cancel are known to twice the precision of the terms, no more: zeros come out as some 1e-32 of them.
TEST_P(Pieces, are_the_exact_ones_rounded) {
    for (int degree = 1; degree <= nrb::max_power_span_degree; ++degree) {
        Tally tally;
        for_each_case(97000 + 100 * static_cast<uint64_t>(degree), 8, [&](Random &random, uint64_t) {
            const auto axis = random_axis_of(random, degree);
            for (const int64_t span : spans_with_pieces(*axis)) {
                const Together one(*axis, {span});
                tally.add(*axis, span, one.power_spans[0], one.rests[0]);
            }
        });
        std::printf("degree %d: %lld of %lld coefficients not the nearest, with rests within %.2f * 2^-104\n",
                    degree, static_cast<long long>(tally.other), static_cast<long long>(tally.count),
                    tally.worst_rest);
        EXPECT_LE(tally.other, tally.count / 1000);
        EXPECT_LE(tally.worst_rest, 16 * degree);
    }
}

TEST_P(Pieces, have_the_same_bits_whatever_is_made_together) {
    for_each_case(98000, 300, [](Random &random, uint64_t) {
        const auto axis = random_axis_of(random, random.whole(1, nrb::max_power_span_degree));
        const auto spans = spans_with_pieces(*axis);
        if (spans.empty()) {
            return;
        }
        std::vector<std::vector<double>> alone;
        for (const int64_t span : spans) {
            alone.push_back(Together(*axis, {span}).power_spans[0]);
            ASSERT_TRUE(same_bits(Together(*axis, {span}, false).power_spans[0], alone.back()));
        }
        const nrb::PowerSpans table = nrb::basis_power_spans(*axis);
        for (int count = 1; count <= nrb::power_spans_together(); ++count) {
            std::vector<int64_t> chosen;
            std::vector<size_t> numbers;
            for (int i = 0; i < count; ++i) {
                numbers.push_back(random.bits() % spans.size());
                chosen.push_back(spans[numbers.back()]);
            }
            const Together together(*axis, chosen);
            for (size_t i = 0; i < chosen.size(); ++i) {
                ASSERT_TRUE(same_bits(together.power_spans[i], alone[numbers[i]])) << count << " together";
                const auto &indices = axis->spans().indices();
                const auto number = std::find(indices.begin(), indices.end(), chosen[i]) - indices.begin();
                const std::vector<double> stored(table[number], table[number] + table.size());
                ASSERT_TRUE(same_bits(stored, alone[numbers[i]])) << "in the table";
            }
        }
    });
}

// The powers of a curve: sums of products of three, rounded once, and each component on its own.
TEST_P(Pieces, of_curves_are_the_exact_sums_rounded) {
    long double worst = 0; // beyond half a unit, in units of 2^-104 times the sum of magnitudes
    for_each_case(99000, 40, [&](Random &random, uint64_t) {
        const int degree = random.whole(1, nrb::max_power_span_degree);
        const auto axis = random_axis_of(random, degree);
        const auto spans = spans_with_pieces(*axis);
        if (spans.empty()) {
            return;
        }
        const Together one(*axis, {spans.front()});
        const int lanes = random.chance(50) ? 4 : 8;
        const bool constant = random.chance(30); // all powers but one cancel
        const auto functions = static_cast<size_t>(degree) + 1;
        std::vector<double> weights;
        std::vector<double> points;
        for (size_t j = 0; j < functions; ++j) {
            weights.push_back(constant ? 0.3 : random.between(1, 4));
            for (int c = 0; c < lanes; ++c) {
                points.push_back(constant ? 0.1 : random.between(-1, 1) * random.magnitude(1e-3, 1e3));
            }
        }
        std::vector<double> powers(functions * static_cast<size_t>(lanes));
        nrb::combine_power_spans(one.power_spans[0].data(), one.rests[0].data(), degree, weights.data(),
                                 points.data(), lanes, powers.data());
        for (size_t i = 0; i < powers.size(); ++i) {
            const auto k = static_cast<int>(i) / lanes;
            Rational sum = 0;
            Rational size = 0;
            for (size_t j = 0; j < functions; ++j) {
                const size_t at = place(degree, k, static_cast<int>(j));
                const Rational term =
                    (exact(one.power_spans[0][at]) + exact(one.rests[0][at])) * exact(weights[j]) *
                    exact(points[j * static_cast<size_t>(lanes) + i % static_cast<size_t>(lanes)]);
                sum += term;
                size += abs(term);
            }
            const Rational half = powers[i] == 0 ? 0 : exact(std::ldexp(1.0, std::ilogb(powers[i]) - 53));
            const auto beyond = reference::fraction(Rational((abs(exact(powers[i]) - sum) - half) / size));
            worst =
                std::max(worst, std::ldexp(reference::quotient(beyond.numerator, beyond.denominator), 104));
        }
    });
    std::printf("beyond half a unit by at most %.2Lf * 2^-104 of the terms\n", worst);
    EXPECT_LE(worst, 8);
}

INSTANTIATE_TEST_SUITE_P(All, Pieces, targets::every_target(), targets::target_name);

} // namespace

} // namespace power_spans_test

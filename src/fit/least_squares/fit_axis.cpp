// SPDX-License-Identifier: MIT
#include "fit/least_squares/fit_axis.h"

#include "base/error.h"
#include "numeric/binomial.h"
#include "refine/knots/extraction.h"

#include <algorithm>

namespace nrb::fit {

namespace {

// Degree elevation: from Bernstein coefficients of degree n - 1 to those of degree n.
void elevate(int n, DoubleDouble *coefficients) noexcept {
    coefficients[n] = coefficients[n - 1];
    for (int k = n - 1; k > 0; --k) {
        const DoubleDouble part = DoubleDouble(k) / DoubleDouble(n);
        coefficients[k] = part * coefficients[k - 1] + (DoubleDouble(1) - part) * coefficients[k];
    }
}

// A place in a span: its distances from both ends, relative to the length of the span.
struct Place {
    DoubleDouble after, ahead;
};
Place place_of(double t, double lower, double upper) noexcept {
    const DoubleDouble length = DoubleDouble::sum(upper, -lower);
    return {DoubleDouble::sum(t, -lower) / length, DoubleDouble::sum(upper, -t) / length};
}

} // namespace

FitAxis::FitAxis(KnotVectorPtr knots, KnotVectorPtr breaks, int data_degree, int axis)
    : knots_(std::move(knots)), breaks_(std::move(breaks)), data_degree_(data_degree),
      product_factors_(precise_product_factors(data_degree)) {
    const Interval own = knots_->domain(), given = breaks_->domain();
    if (degree() > data_degree) {
        fail(Status::degree, "degrees[%d] = %d, expected at most %d, the degree of the statistics", axis,
             degree(), data_degree);
    }
    if (own.lower != given.lower || own.upper != given.upper) {
        fail(Status::outside_domain, "axis %d: the domain is [%s, %s], that of the statistics [%s, %s]", axis,
             Number(own.lower).text, Number(own.upper).text, Number(given.lower).text,
             Number(given.upper).text);
    }
    const auto indices = knots_->spans().indices();
    spans_.assign(indices.begin(), indices.end());
    int64_t cell = 0;
    for (int64_t s = 0; s < spans(); ++s) {
        const int64_t index = knot_index(s);
        const double end = (*knots_)[index + 1];
        for (; cell < breaks_->count() && (*breaks_)[cell] < end; ++cell) {
            span_of_.push_back(s);
        }
        if ((*breaks_)[cell] != end) {
            fail(Status::not_a_knot, "axis %d: knot %lld, %s, is not a break of the statistics", axis,
                 static_cast<long long>(index + 1), Number(end).text);
        }
    }
}

std::vector<DoubleDouble> FitAxis::function_table(int64_t span) const {
    const int q = degree(), p = data_degree_;
    const auto own = static_cast<size_t>(q + 1), width = static_cast<size_t>(p + 1);
    std::vector<DoubleDouble> matrix(own * own), functions(own * width);
    refine::bezier_extraction(knots_->knots().data(), q, knot_index(span), matrix.data());
    for (size_t i = 0; i < own; ++i) {
        DoubleDouble *const row = functions.data() + i * width;
        std::copy_n(matrix.data() + i * own, own, row);
        for (int n = q + 1; n <= p; ++n) {
            elevate(n, row);
        }
    }
    return functions;
}

SpanTables FitAxis::tables(int64_t span) const {
    const auto own = static_cast<size_t>(degree() + 1), width = static_cast<size_t>(data_degree_ + 1);
    SpanTables made{function_table(span), std::vector<DoubleDouble>(own * (own + 1) / 2 * (2 * width - 1))};
    DoubleDouble *pair = made.pairs.data();
    for (size_t i = 0; i < own; ++i) {
        for (size_t j = i; j < own; ++j, pair += 2 * width - 1) {
            for (size_t l = 0; l < width; ++l) {
                for (size_t m = 0; m < width; ++m) {
                    pair[l + m] =
                        pair[l + m] + product_factors_[l * width + m] *
                                          (made.functions[i * width + l] * made.functions[j * width + m]);
                }
            }
        }
    }
    return made;
}

std::vector<DoubleDouble> FitAxis::pair_sums(const std::vector<DoubleDouble> &functions,
                                             const std::vector<DoubleDouble> &sums) const {
    const auto own = static_cast<size_t>(degree() + 1), width = static_cast<size_t>(data_degree_ + 1);
    std::vector<DoubleDouble> products(width * width), half(own * width), result;
    result.reserve(own * (own + 1) / 2);
    for (size_t l = 0; l < width; ++l) {
        for (size_t m = 0; m < width; ++m) {
            products[l * width + m] = product_factors_[l * width + m] * sums[l + m];
        }
    }
    for (size_t i = 0; i < own; ++i) {
        for (size_t l = 0; l < width; ++l) {
            for (size_t m = 0; m < width; ++m) {
                half[i * width + m] =
                    half[i * width + m] + functions[i * width + l] * products[l * width + m];
            }
        }
    }
    for (size_t i = 0; i < own; ++i) {
        for (size_t j = i; j < own; ++j) {
            DoubleDouble sum;
            for (size_t m = 0; m < width; ++m) {
                sum = sum + half[i * width + m] * functions[j * width + m];
            }
            result.push_back(sum);
        }
    }
    return result;
}

// The transpose of the subdivision that bernstein::restrict_to() applies to coefficients.
void FitAxis::widen(int64_t cell, int degree, int64_t inner, DoubleDouble *sums) const noexcept {
    const int64_t index = knot_index(span_of(cell));
    const double start = (*knots_)[index], end = (*knots_)[index + 1];
    const double lower = (*breaks_)[cell], upper = (*breaks_)[cell + 1];
    const auto spread = [&](int64_t from, int64_t to, const DoubleDouble &kept, const DoubleDouble &given) {
        for (int64_t c = 0; c < inner; ++c) {
            DoubleDouble &source = sums[from * inner + c], &target = sums[to * inner + c];
            target = target + given * source;
            source = kept * source;
        }
    };
    if (lower > start) { // from [lower, upper] to [start, upper]
        const auto [after, ahead] = place_of(lower, start, upper);
        for (int r = degree; r > 0; --r) {
            for (int i = degree - r; i >= 0; --i) {
                spread(i, i + 1, ahead, after);
            }
        }
    }
    if (upper < end) { // from [start, upper] to [start, end]
        const auto [after, ahead] = place_of(upper, start, end);
        for (int r = degree; r > 0; --r) {
            for (int i = r; i <= degree; ++i) {
                spread(i, i - 1, after, ahead);
            }
        }
    }
}

} // namespace nrb::fit

#include "reference/exact_spline.h"

#include "reference/exact_basis.h"

#include <algorithm>
#include <cmath>

namespace reference {

using support::MultiIndex;
using support::SplineData;

namespace {

using Record = std::vector<Integer>; // numerators of (w x, w y, ..., w), or of (x, y, ...) when polynomial

struct Scale {
    int points;  // coordinates are multiples of 2^points
    int weights; // weights are multiples of 2^weights
};

Record control_record(const SplineData &data, int64_t i, Scale scale) {
    Record record;
    const Integer weight = data.rational() ? scaled(data.weight(i), scale.weights) : Integer(1);
    for (int c = 0; c < data.dim; ++c) {
        record.push_back(weight * scaled(data.coordinate(i, c), scale.points));
    }
    if (data.rational()) {
        record.push_back(weight);
    }
    return record;
}

std::vector<ExactBasis> bases_at(const SplineData &data, int order, const double *param, Sides left) {
    std::vector<ExactBasis> bases;
    for (int k = 0; k < data.axes(); ++k) {
        const auto axis = static_cast<size_t>(k);
        bases.push_back(exact_basis(data.knots[axis], data.degrees[axis], param[k], order, left[axis]));
    }
    return bases;
}

// Sum over the active points of axes k, k+1, ...; `start` is the number of the active point of the earlier
// axes.
Record contract(const SplineData &data, const std::vector<ExactBasis> &bases,
                const std::vector<Record> &active, const MultiIndex &a, size_t k, size_t start) {
    if (k == bases.size()) {
        return active[start];
    }
    const auto &values = bases[k].numerators[static_cast<size_t>(a[k])];
    Record sum;
    for (size_t j = 0; j < values.size(); ++j) {
        const Record inner = contract(data, bases, active, a, k + 1, start * values.size() + j);
        sum.resize(inner.size());
        for (size_t c = 0; c < inner.size() && values[j] != 0; ++c) {
            sum[c] += values[j] * inner[c];
        }
    }
    return sum;
}

Integer power(const Integer &base, int exponent) {
    return pow(base, static_cast<unsigned>(exponent));
}

// The quotient rule with w^(|a|+1) as the common denominator of a derivative of order |a|:
// V_a = A_a w^|a| - sum over 0 < b <= a of binomial(a, b) W_b V_(a-b) w^(|b|-1).
std::vector<Record> divide_by_weight(const std::vector<MultiIndex> &indices,
                                     const std::vector<Record> &sums) {
    const Integer &w = sums[0].back();
    std::vector<Record> quotients;
    for (size_t slot = 0; slot < indices.size(); ++slot) {
        int order = 0;
        for (const int part : indices[slot]) {
            order += part;
        }
        Record value(sums[slot].begin(), sums[slot].end() - 1);
        for (Integer &x : value) {
            x *= power(w, order);
        }
        for (const auto &term : support::leibniz_terms(indices[slot])) {
            int steps = -1;
            for (const int part : term.b) {
                steps += part;
            }
            const Integer factor =
                term.factor * sums[static_cast<size_t>(support::slot_of(term.b))].back() * power(w, steps);
            const Record &rest = quotients[static_cast<size_t>(support::slot_of(term.rest))];
            for (size_t c = 0; c < value.size(); ++c) {
                value[c] -= factor * rest[c];
            }
        }
        quotients.push_back(std::move(value));
    }
    return quotients;
}

std::vector<Fraction> fractions(const Record &numerators, Integer denominator, int exponent) {
    const bool negative = denominator < 0;
    denominator = abs(denominator) << -exponent;
    std::vector<Fraction> values;
    for (const Integer &x : numerators) {
        values.push_back({negative ? Integer(-x) : x, denominator});
    }
    return values;
}

} // namespace

std::vector<int64_t> first_active(const SplineData &data, const double *param, Sides left) {
    std::vector<int64_t> first;
    for (int k = 0; k < data.axes(); ++k) {
        const auto axis = static_cast<size_t>(k);
        first.push_back(exact_span(data.knots[axis], data.degrees[axis], param[k], left[axis]) -
                        data.degrees[axis]);
    }
    return first;
}

std::vector<int64_t> active_points(const SplineData &data, const std::vector<int64_t> &first) {
    std::vector<int64_t> places = {0};
    for (size_t k = 0; k < first.size(); ++k) {
        std::vector<int64_t> longer;
        for (const int64_t place : places) {
            for (int64_t j = 0; j <= data.degrees[k]; ++j) {
                longer.push_back(place * data.counts[k] + first[k] + j);
            }
        }
        places = std::move(longer);
    }
    return places;
}

std::vector<std::vector<Fraction>> exact_derivatives(const SplineData &data, int order, const double *param,
                                                     Sides left) {
    const auto bases = bases_at(data, order, param, left);
    const Scale scale = {common_exponent(data.points), common_exponent(data.weights)};
    std::vector<Record> active;
    for (const int64_t i : active_points(data, first_active(data, param, left))) {
        active.push_back(control_record(data, i, scale));
    }
    const auto indices = support::graded_indices(data.axes(), order);
    std::vector<Record> sums;
    for (const MultiIndex &a : indices) {
        sums.push_back(contract(data, bases, active, a, 0, 0));
    }
    std::vector<std::vector<Fraction>> out;
    if (!data.rational()) {
        Integer denominator = 1;
        for (const ExactBasis &basis : bases) {
            denominator *= basis.denominator;
        }
        for (const Record &sum : sums) {
            out.push_back(fractions(sum, denominator, scale.points));
        }
        return out;
    }
    const auto quotients = divide_by_weight(indices, sums);
    for (size_t slot = 0; slot < indices.size(); ++slot) {
        int steps = 1;
        for (const int part : indices[slot]) {
            steps += part;
        }
        out.push_back(fractions(quotients[slot], power(sums[0].back(), steps), scale.points));
    }
    return out;
}

std::vector<Fraction> exact_point(const SplineData &data, const double *param, Sides left) {
    return exact_derivatives(data, 0, param, left)[0];
}

double exact_hull(const SplineData &data, const double *param, Sides left) {
    double hull = 0;
    for (const int64_t i : active_points(data, first_active(data, param, left))) {
        for (int c = 0; c < data.dim && data.weight(i) > 0; ++c) {
            hull = std::max(hull, std::fabs(data.coordinate(i, c)));
        }
    }
    return hull;
}

namespace {

// Whether some weight and basis function are both positive at one corner of a cell of spans.
bool positive_at(const SplineData &data, const double *param, Sides left) {
    const auto bases = bases_at(data, 0, param, left);
    std::vector<bool> product = {true};
    for (const ExactBasis &basis : bases) {
        std::vector<bool> longer;
        for (const bool head : product) {
            for (const Integer &value : basis.numerators[0]) {
                longer.push_back(head && value > 0);
            }
        }
        product = std::move(longer);
    }
    const auto active = active_points(data, first_active(data, param, left));
    for (size_t j = 0; j < active.size(); ++j) {
        if (product[j] && data.weight(active[j]) > 0) {
            return true;
        }
    }
    return false;
}

bool corners_suit(const SplineData &data, std::vector<double> &param, Sides left, int k) {
    if (k == data.axes()) {
        return positive_at(data, param.data(), left);
    }
    const auto axis = static_cast<size_t>(k);
    const auto &knots = data.knots[axis];
    for (auto s = static_cast<size_t>(data.degrees[axis]); s < static_cast<size_t>(data.counts[axis]); ++s) {
        for (const bool end : {false, true}) {
            param[axis] = knots[end ? s + 1 : s];
            left[axis] = end;
            if (knots[s] < knots[s + 1] && !corners_suit(data, param, left, k + 1)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

bool weights_suit(const SplineData &data) {
    std::vector<double> param(3);
    return corners_suit(data, param, {}, 0);
}

} // namespace reference

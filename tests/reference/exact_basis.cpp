#include "reference/exact_basis.h"

#include <algorithm>

namespace reference {

int64_t exact_span(const std::vector<double> &knots, int degree, double t, bool left) {
    const auto count = static_cast<int64_t>(knots.size()) - degree - 1;
    int64_t found = -1;
    for (int64_t s = degree; s < count; ++s) {
        const double lower = knots[static_cast<size_t>(s)];
        const bool reached = left ? lower < t : lower <= t;
        if (lower < knots[static_cast<size_t>(s + 1)] && (reached || found < 0)) {
            found = s;
        }
    }
    return found;
}

namespace {

// Steps from degree r - 1 to r of the functions that live on one span.
struct Level {
    int degree;
    std::vector<Integer> rise;  // t - t_i for the r functions of the lower degree
    std::vector<Integer> fall;  // t_i+r - t
    std::vector<Integer> share; // common / (t_i+r - t_i)
    Integer common;
};

using Values = std::vector<Integer>;

Level make_level(const std::vector<Integer> &local, const Integer &t, int degree, int r) {
    Level level{r, {}, {}, {}, 1};
    std::vector<Integer> lengths;
    for (int j = 0; j < r; ++j) {
        // Function j of degree r - 1 on the span is number span - r + 1 + j; local[0] is the knot span -
        // degree.
        const auto first = static_cast<size_t>(degree - r + 1 + j);
        const auto last = first + static_cast<size_t>(r);
        level.rise.push_back(t - local[first]);
        level.fall.push_back(local[last] - t);
        lengths.push_back(local[last] - local[first]);
        level.common = lcm(level.common, lengths.back());
    }
    for (const Integer &length : lengths) {
        level.share.push_back(level.common / length);
    }
    return level;
}

// Lower function j spreads to the functions j (with its falling factor) and j + 1 (with its rising one) of
// the next degree.
Values raise(const Level &level, const Values &lower) {
    Values upper(lower.size() + 1);
    for (size_t j = 0; j < lower.size(); ++j) {
        const Integer part = lower[j] * level.share[j];
        upper[j] += part * level.fall[j];
        upper[j + 1] += part * level.rise[j];
    }
    return upper;
}

Values raise_derivative(const Level &level, const Values &lower) {
    Values upper(lower.size() + 1);
    for (size_t j = 0; j < lower.size(); ++j) {
        const Integer part = lower[j] * level.share[j] * level.degree;
        upper[j] -= part;
        upper[j + 1] += part;
    }
    return upper;
}

} // namespace

ExactBasis exact_basis(const std::vector<double> &knots, int degree, double t, int order, bool left) {
    ExactBasis basis;
    basis.span = exact_span(knots, degree, t, left);
    const auto first = knots.begin() + (basis.span - degree);
    const std::vector<double> active(first, first + 2 * degree + 2);
    const int exponent = std::min(common_exponent(active), std::min(lowest_bit(t), 0));
    std::vector<Integer> local;
    for (const double knot : active) {
        local.push_back(scaled(knot, exponent));
    }
    std::vector<Level> levels;
    basis.denominator = 1;
    for (int r = 1; r <= degree; ++r) {
        levels.push_back(make_level(local, scaled(t, exponent), degree, r));
        basis.denominator *= levels.back().common;
    }
    basis.numerators.assign(static_cast<size_t>(order) + 1, Values(static_cast<size_t>(degree) + 1));
    for (int k = 0; k <= std::min(order, degree); ++k) {
        Values values = {1};
        for (const Level &level : levels) {
            values = level.degree <= degree - k ? raise(level, values) : raise_derivative(level, values);
        }
        for (Integer &value : values) {
            value <<= -exponent * k; // the knots were multiplied by 2^-exponent
        }
        basis.numerators[static_cast<size_t>(k)] = std::move(values);
    }
    return basis;
}

} // namespace reference

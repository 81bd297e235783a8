#include "reference/magnitudes.h"

#include "reference/exact_basis.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reference {

using support::MultiIndex;
using support::SplineData;

long double c_of(int degree) {
    static constexpr int to_nine[] = {1, 3, 4, 4, 6, 6, 8, 8, 12, 12};
    if (degree <= 9) {
        return to_nine[degree];
    }
    return degree <= 15 ? 16 : degree <= 23 ? 24 : 32;
}

long double c_of(const SplineData &data) {
    long double sum = 0;
    for (const int degree : data.degrees) {
        sum += c_of(degree);
    }
    return sum;
}

namespace {

using LongRecord = std::vector<long double>;

// One axis at one parameter, with its knots counted from the first active function: knot(i) is t_(span -
// degree + i).
struct Axis {
    const double *knots;
    int degree;
    long double t;

    [[nodiscard]] long double knot(int i) const { return knots[i]; }
};

// Magnitudes on the span of the functions of a lower degree: the recurrence of Cox and de Boor with every
// factor made positive. Inside the domain all factors are, and these are the functions themselves.
LongRecord basis_values(const Axis &axis, int degree) {
    LongRecord values = {1};
    for (int r = 1; r <= degree; ++r) {
        LongRecord upper(values.size() + 1);
        for (int j = 0; j < r; ++j) {
            const int first = axis.degree - r + 1 + j;
            const long double part =
                values[static_cast<size_t>(j)] / (axis.knot(first + r) - axis.knot(first));
            upper[static_cast<size_t>(j)] += part * std::fabs(axis.knot(first + r) - axis.t);
            upper[static_cast<size_t>(j) + 1] += part * std::fabs(axis.t - axis.knot(first));
        }
        values = std::move(upper);
    }
    return values;
}

// How the points of the last step become one: by the largest, or by the value at t.
enum class Last { largest, value };

LongRecord magnitude(LongRecord record) {
    for (long double &x : record) {
        x = std::fabs(x);
    }
    return record;
}

// What stands for the sum of the magnitudes of neighbours in the first step of a polynomial curve.
std::vector<LongRecord> differences(const std::vector<LongRecord> &points) {
    std::vector<LongRecord> steps;
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        LongRecord step = points[i + 1];
        for (size_t c = 0; c < step.size(); ++c) {
            const long double sum = std::fabs(points[i][c]) + std::fabs(step[c]);
            step[c] = std::fabs(step[c] - points[i][c]) + 0x1p-48L * sum;
        }
        steps.push_back(std::move(step));
    }
    return steps;
}

// H_a along one axis: k steps on magnitudes, then the last. `first`: the first step by differences.
LongRecord contract(const Axis &axis, int order, Last last, bool first, std::vector<LongRecord> points) {
    const size_t width = points[0].size();
    if (order > axis.degree) {
        return LongRecord(width, 0);
    }
    const std::vector<LongRecord> steps = first ? differences(points) : std::vector<LongRecord>();
    std::transform(points.begin(), points.end(), points.begin(), magnitude);
    for (int k = 1; k <= order; ++k) {
        for (size_t i = 0; i + 1 < points.size(); ++i) {
            const auto number = static_cast<int>(i);
            const long double length = axis.knot(number + axis.degree + 1) - axis.knot(number + k);
            for (size_t c = 0; c < width; ++c) {
                const long double step = first && k == 1 ? steps[i][c] : points[i][c] + points[i + 1][c];
                points[i][c] = (axis.degree - k + 1) * step / length;
            }
        }
        points.pop_back();
    }
    const LongRecord values = basis_values(axis, axis.degree - order);
    // Inside the domain the values add up to 1; outside they say how far rounding is magnified.
    const long double total = std::accumulate(values.begin(), values.end(), 0.0L);
    LongRecord sum(width);
    for (size_t i = 0; i < points.size(); ++i) {
        for (size_t c = 0; c < width; ++c) {
            sum[c] = last == Last::value ? sum[c] + values[i] * points[i][c]
                                         : std::max(sum[c], total * points[i][c]);
        }
    }
    return sum;
}

// Contracts the last axis of `points` first; the order does not matter for a sum of positive terms.
LongRecord contract_all(const std::vector<Axis> &axes, const MultiIndex &a, Last last, bool first,
                        std::vector<LongRecord> points) {
    for (size_t k = axes.size(); k-- > 0;) {
        const auto width = static_cast<size_t>(axes[k].degree) + 1;
        std::vector<LongRecord> fewer;
        for (size_t i = 0; i < points.size(); i += width) {
            const auto from = points.begin() + static_cast<std::ptrdiff_t>(i);
            fewer.push_back(
                contract(axes[k], a[k], last, first, {from, from + static_cast<std::ptrdiff_t>(width)}));
        }
        points = std::move(fewer);
    }
    return points[0];
}

// E_a = (H_a[wP] + sum over 0 < b <= a of binomial(a, b) H_b[w] E_(a-b)) / w(t).
std::vector<LongRecord> divide_by_weight(const std::vector<MultiIndex> &indices,
                                         const std::vector<LongRecord> &h, long double weight) {
    std::vector<LongRecord> e;
    for (size_t slot = 0; slot < indices.size(); ++slot) {
        LongRecord sum(h[slot].begin(), h[slot].end() - 1);
        for (const auto &term : support::leibniz_terms(indices[slot])) {
            const long double factor = static_cast<long double>(term.factor) *
                                       h[static_cast<size_t>(support::slot_of(term.b))].back();
            const LongRecord &rest = e[static_cast<size_t>(support::slot_of(term.rest))];
            for (size_t c = 0; c < sum.size(); ++c) {
                sum[c] += factor * rest[c];
            }
        }
        for (long double &x : sum) {
            x /= weight;
        }
        e.push_back(std::move(sum));
    }
    return e;
}

// Whether the weights, the last components, differ by a factor of more than 4.
bool uneven(const std::vector<LongRecord> &points) {
    const auto [smallest, largest] =
        std::minmax_element(points.begin(), points.end(),
                            [](const LongRecord &a, const LongRecord &b) { return a.back() < b.back(); });
    return !(smallest->back() > 0 && largest->back() <= 4 * smallest->back());
}

// Whether the function of a control point is not 0 on the whole domain.
bool has_support(const SplineData &data, int64_t point) {
    bool inside = true;
    for (size_t k = data.degrees.size(); k-- > 0;) {
        const auto i = static_cast<size_t>(point % data.counts[k]);
        point /= data.counts[k];
        const auto &knots = data.knots[k];
        const auto axis = static_cast<int>(k);
        const auto end = i + static_cast<size_t>(data.degrees[k]) + 1;
        inside = inside && std::max(knots[i], data.lower(axis)) < std::min(knots[end], data.upper(axis));
    }
    return inside;
}

} // namespace

long double weight_factor(const SplineData &data, const double *param, Sides left) {
    std::vector<double> weights = data.weights;
    if (data.rational() && data.axes() == 1) {
        weights.clear();
        for (const int64_t i : active_points(data, first_active(data, param, left))) {
            weights.push_back(data.weight(i));
        }
    }
    const bool centred = std::any_of(data.degrees.begin(), data.degrees.end(),
                                     [](int degree) { return degree >= 1 && degree <= 9; });
    if (!centred || weights.empty()) {
        return 1;
    }
    const auto [smallest, largest] = std::minmax_element(weights.begin(), weights.end());
    const bool even = *smallest > 0 && *largest <= 4 * *smallest;
    return even ? static_cast<long double>(*largest) / *smallest : 1;
}

namespace {

// `first_step`: by differences.
std::vector<std::vector<long double>> magnitudes_from(const std::vector<double> &origin, bool first_step,
                                                      const SplineData &data, int order, const double *param,
                                                      Sides left) {
    const auto first = first_active(data, param, left);
    std::vector<Axis> axes;
    for (size_t k = 0; k < first.size(); ++k) {
        axes.push_back({data.knots[k].data() + first[k], data.degrees[k], param[k]});
    }
    const auto seen_from = [&](const std::vector<double> &from) {
        std::vector<LongRecord> points;
        for (const int64_t i : active_points(data, first)) {
            LongRecord record;
            for (int c = 0; c < data.dim; ++c) {
                record.push_back(
                    static_cast<long double>(data.weight(i)) *
                    (static_cast<long double>(data.coordinate(i, c)) - from[static_cast<size_t>(c)]));
            }
            if (data.rational()) {
                record.push_back(data.weight(i));
            }
            points.push_back(std::move(record));
        }
        return points;
    };
    const std::vector<LongRecord> stored = seen_from(std::vector<double>(static_cast<size_t>(data.dim)));
    const std::vector<LongRecord> points = seen_from(origin);
    const Last last = data.rational() && uneven(points) ? Last::value : Last::largest;
    const auto indices = support::graded_indices(data.axes(), order);
    std::vector<LongRecord> h;
    for (const MultiIndex &a : indices) {
        h.push_back(contract_all(axes, a, last, first_step, points));
    }
    if (data.rational()) {
        h = divide_by_weight(indices, h, contract_all(axes, indices[0], Last::value, false, points).back());
    }
    h[0] = contract_all(axes, indices[0], last, false, stored);
    if (data.rational()) {
        const long double weight = contract_all(axes, indices[0], Last::value, false, stored).back();
        h[0].pop_back();
        for (long double &x : h[0]) {
            x /= weight;
        }
    }
    return h;
}

} // namespace

std::vector<std::vector<long double>> magnitudes(const SplineData &data, int order, const double *param,
                                                 Sides left) {
    const bool differences = !data.rational() && data.axes() == 1;
    return differences ? magnitudes_from(std::vector<double>(static_cast<size_t>(data.dim)), true, data,
                                         order, param, left)
                       : magnitudes(data, order, param, Terms::seen_from_o, left);
}

std::vector<std::vector<long double>> magnitudes(const SplineData &data, int order, const double *param,
                                                 Terms terms, Sides left) {
    const std::vector<double> zero(static_cast<size_t>(data.dim));
    return magnitudes_from(terms == Terms::stored ? zero : origin_of(data), false, data, order, param, left);
}

std::vector<double> origin_of(const SplineData &data) {
    const auto dim = static_cast<size_t>(data.dim);
    std::vector<double> lower(dim, INFINITY);
    std::vector<double> upper(dim, -INFINITY);
    for (int64_t i = 0; i < data.point_count(); ++i) {
        for (size_t c = 0; c < dim && data.weight(i) != 0 && has_support(data, i); ++c) {
            lower[c] = std::min(lower[c], data.coordinate(i, static_cast<int>(c)));
            upper[c] = std::max(upper[c], data.coordinate(i, static_cast<int>(c)));
        }
    }
    std::vector<double> corner(dim);
    double size = 0;
    double distance = 0;
    for (size_t c = 0; c < dim; ++c) {
        corner[c] = lower[c] > 0 ? lower[c] : std::min(upper[c], 0.0);
        size = std::max(size, upper[c] - lower[c]);
        distance = std::max(distance, std::fabs(corner[c]));
    }
    for (size_t c = 0; c < dim; ++c) {
        const bool near = distance <= 8 * size || std::fabs(corner[c]) < upper[c] - lower[c];
        corner[c] = near ? 0 : corner[c];
    }
    return corner;
}

} // namespace reference

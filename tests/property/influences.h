// R_i(t) without rounding, copies on periodic axes taken together.
#pragma once

#include "exact_points.h"
#include "reference/exact_basis.h"

#include <map>

namespace support {

// The first copy of a control point.
inline int64_t original_of(const SplineData &data, int64_t point) {
    int64_t original = 0, scale = 1;
    for (int k = data.axes(); k-- > 0;) {
        const auto at = static_cast<size_t>(k);
        const int64_t count = data.counts[at], distinct = data.periodic(k) ? count - data.degrees[at] : count;
        original += point % count % distinct * scale;
        point /= count;
        scale *= count;
    }
    return original;
}

struct Influence {
    Rational function = 0; // sum of N_i over the copies
    Rational weight = 0;   // the same of N_i w_i
};

// By first copies; the points that are active, whatever their functions.
inline std::map<int64_t, Influence> exact_influences(const SplineData &data,
                                                     const std::vector<double> &param) {
    std::vector<reference::ExactBasis> bases;
    for (int k = 0; k < data.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        bases.push_back(reference::exact_basis(data.knots[at], data.degrees[at], param[at], 0));
    }
    const std::vector<int64_t> active =
        reference::active_points(data, reference::first_active(data, param.data()));
    std::map<int64_t, Influence> all;
    for (size_t i = 0; i < active.size(); ++i) {
        Rational value = 1;
        size_t rest = i;
        for (int k = data.axes(); k-- > 0;) {
            const auto at = static_cast<size_t>(k), size = static_cast<size_t>(data.degrees[at]) + 1;
            value *= Rational(bases[at].numerators[0][rest % size], bases[at].denominator);
            rest /= size;
        }
        Influence &sums = all[original_of(data, active[i])];
        sums.function += value;
        sums.weight += value * exact(data.weight(active[i]));
    }
    return all;
}

inline Rational total_weight(const std::map<int64_t, Influence> &all) {
    Rational sum = 0;
    for (const auto &[point, influence] : all) {
        sum += influence.weight;
    }
    return sum;
}

inline Point place_of(const SplineData &data, int64_t i) {
    Point place;
    for (int c = 0; c < data.dim; ++c) {
        place.push_back(exact(data.coordinate(i, c)));
    }
    return place;
}

inline Point minus(const Point &a, const Point &b) {
    Point result;
    for (size_t c = 0; c < a.size(); ++c) {
        result.emplace_back(a[c] - b[c]);
    }
    return result;
}

inline long double length(const Point &a) {
    Rational sum = 0;
    for (const Rational &x : a) {
        sum += x * x;
    }
    return std::sqrt(as_long_double(sum));
}

// The largest distance of an active control point from a place.
inline long double spread(const SplineData &data, const std::map<int64_t, Influence> &all,
                          const Point &from) {
    long double largest = 0;
    for (const auto &[point, influence] : all) {
        largest = std::max(largest, length(minus(place_of(data, point), from)));
    }
    return largest;
}

// Roundings of a sum over the active points whose basis functions are within 3 p eps of themselves on each
// axis.
inline long double sum_roundings(const SplineData &data) {
    long double functions = 0, points = 1;
    for (const int32_t p : data.degrees) {
        functions += 3 * p;
        points *= p + 1;
    }
    return functions + points + 8;
}

} // namespace support

// Exact derivatives of splines by their data: de Boor's algorithm in numbers a + b e with e^2 = 0 and rational a
// and b, on the piece of the span that holds the parameter.
#pragma once

#include "reference/exact_spline.h"

#include <functional>

namespace dual_numbers {

using reference::exact;
using reference::Rational;

struct Dual {
    Rational value = 0;
    Rational slope = 0;

    friend Dual operator+(const Dual &a, const Dual &b) { return {a.value + b.value, a.slope + b.slope}; }
    friend Dual operator-(const Dual &a, const Dual &b) { return {a.value - b.value, a.slope - b.slope}; }
    friend Dual operator*(const Dual &a, const Dual &b) {
        return {a.value * b.value, a.slope * b.value + a.value * b.slope};
    }
    friend Dual operator/(const Dual &a, const Dual &b) {
        const Rational quotient = a.value / b.value;
        return {quotient, (a.slope - quotient * b.slope) / b.value};
    }
};

// The rows of one axis at t: rows[r * inner + i], r = 0, ..., p, become row 0. knots: those of the layers from
// the first active one on.
inline void de_boor(const std::vector<Dual> &knots, size_t degree, const Dual &t, std::vector<Dual> &rows) {
    const size_t inner = rows.size() / (degree + 1);
    for (size_t r = 1; r <= degree; ++r) {
        for (size_t j = degree; j >= r; --j) {
            const Dual alpha = (t - knots[j]) / (knots[j + degree - r + 1] - knots[j]);
            const Dual rest = Dual{1, 0} - alpha;
            for (size_t i = 0; i < inner; ++i) {
                rows[j * inner + i] = rest * rows[(j - 1) * inner + i] + alpha * rows[j * inner + i];
            }
        }
    }
    rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(degree * inner));
}

// Whether a knot of an axis moves, by its index.
using Moves = std::function<bool(int axis, size_t knot)>;

// C(t) and its derivative, when the knots move that `moves` names.
inline std::vector<Dual> point(const support::SplineData &data, const double *param, const Moves &moves) {
    const std::vector<int64_t> first = reference::first_active(data, param);
    std::vector<Dual> net;
    for (const int64_t i : reference::active_points(data, first)) {
        const Rational weight = exact(data.weight(i));
        for (int c = 0; c < data.dim; ++c) {
            net.push_back({weight * exact(data.coordinate(i, c)), 0});
        }
        net.push_back({weight, 0});
    }
    for (int k = 0; k < data.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const auto degree = static_cast<size_t>(data.degrees[at]);
        std::vector<Dual> knots;
        for (size_t j = 0; j < 2 * degree + 2; ++j) {
            const size_t index = static_cast<size_t>(first[at]) + j;
            knots.push_back({exact(data.knots[at][index]), moves(k, index) ? 1 : 0});
        }
        de_boor(knots, degree, {exact(param[k]), 0}, net);
    }
    const Dual weight = net.back();
    net.pop_back();
    for (Dual &x : net) {
        x = x / weight;
    }
    return net;
}

} // namespace dual_numbers

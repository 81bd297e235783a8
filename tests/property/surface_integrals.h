// Areas and volumes by quadrature, for shapes whose own are known.
#pragma once

#include "support/frames.h"
#include "support/handle.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace support {

struct Quadrature {
    std::vector<double> nodes;
    std::vector<long double> weights;
};

// Gauss and Legendre's with 20 nodes on each of `parts` equal parts of [0, 1].
inline Quadrature gauss(int parts) {
    constexpr int n = 20;
    Quadrature rule;
    for (int part = 0; part < parts; ++part) {
        for (int i = 0; i < n; ++i) {
            long double x = std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (n + 0.5L)), slope = 0;
            for (int step = 0; step < 8; ++step) { // Newton's, on the Legendre polynomial
                long double p = x, before = 1;
                for (int k = 2; k <= n; ++k) {
                    const long double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                    before = p;
                    p = next;
                }
                slope = n * (x * p - before) / (x * x - 1);
                x -= p / slope;
            }
            rule.nodes.push_back(static_cast<double>((part + (1 - x) / 2) / parts));
            rule.weights.push_back(1 / ((1 - x * x) * slope * slope) / parts);
        }
    }
    return rule;
}

// The integral over [0, 1]^2 of what a function makes of the point, S_u and S_v.
inline long double
integral(const nurbs *g, int parts,
         const std::function<long double(const Vector &point, const Vector &du, const Vector &dv)> &f) {
    const Quadrature rule = gauss(parts);
    const auto values = eval_grid_derivs(g, 1, {rule.nodes, rule.nodes});
    long double sum = 0;
    for (size_t i = 0; i < rule.nodes.size(); ++i) {
        for (size_t j = 0; j < rule.nodes.size(); ++j) {
            const size_t record = i * rule.nodes.size() + j;
            sum += rule.weights[i] * rule.weights[j] *
                   f(vector_at(values, record, 9), vector_at(values, record, 9, 3),
                     vector_at(values, record, 9, 6));
        }
    }
    return sum;
}

inline long double area(const nurbs *g, int parts = 12) {
    return integral(g, parts,
                    [](const Vector &, const Vector &du, const Vector &dv) { return norm(cross(du, dv)); });
}

// Of the cone over the surface from a point: the volume inside closed ones, positive where S_u x S_v points
// outwards.
inline long double volume_below(const nurbs *g, const Vector &from = {}, int parts = 12) {
    return integral(g, parts, [&](const Vector &point, const Vector &du, const Vector &dv) {
        return dot(minus(point, from), cross(du, dv)) / 3;
    });
}

} // namespace support

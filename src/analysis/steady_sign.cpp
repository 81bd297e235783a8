// SPDX-License-Identifier: MIT
#include "analysis/steady_sign.h"

#include "base/numbers.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nrb::analysis {

namespace {

using Rows = std::array<Vector3, 3>;

// Vector i of an array of vectors with 2 or 3 components.
Vector3 vector_at(const std::vector<double> &values, size_t i, size_t width) noexcept {
    const double *x = values.data() + i * width;
    return {x[0], x[1], width > 2 ? x[2] : 0};
}

// The derivative along one axis, or its numerator.
struct Column {
    RoundedPolynomial vectors;

    [[nodiscard]] size_t size() const noexcept { return static_cast<size_t>(vectors.shape.coefficients()); }
    [[nodiscard]] Vector3 at(size_t i) const noexcept {
        return vector_at(vectors.values, i, static_cast<size_t>(vectors.shape.width));
    }
    [[nodiscard]] Vector3 error(size_t i) const noexcept {
        return vector_at(vectors.errors, i, static_cast<size_t>(vectors.shape.width));
    }
    [[nodiscard]] Vector3 mean() const noexcept {
        Vector3 sum;
        for (size_t i = 0; i < size(); ++i) {
            sum = sum + 1 / static_cast<double>(size()) * at(i);
        }
        return sum;
    }
};

Vector3 magnitudes(const Vector3 &a) noexcept {
    return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}

// Computes the rows of the inverse of the matrix with these columns. Returns the sign of its determinant, or
// 0 if that is not certain.
int invert(const Rows &columns, Rows &rows) noexcept {
    constexpr double least = 1e-10; // relative to the product of the largest components of the columns
    rows = {cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])};
    const double det = dot(columns[0], rows[0]);
    if (!(std::abs(det) > least * largest(columns[0]) * largest(columns[1]) * largest(columns[2])) ||
        !std::isfinite(1 / det)) {
        return 0;
    }
    for (Vector3 &row : rows) {
        row = 1 / det * row;
    }
    return det > 0 ? 1 : -1;
}

// The largest distance, in the sum of magnitudes, of B times a coefficient from unit vector k, rounding
// included.
double farthest(const Column &column, size_t k, const Rows &rows) noexcept {
    constexpr double rounding = 8 * eps;
    double most = 0;
    for (size_t i = 0; i < column.size(); ++i) {
        const Vector3 x = column.at(i), slack = 1.01 * column.error(i) + rounding * magnitudes(x);
        double sum = 0;
        for (size_t r = 0; r < 3; ++r) {
            sum += std::abs(dot(rows[r], x) - (r == k ? 1 : 0)) + dot(magnitudes(rows[r]), slack);
        }
        most = std::max(most, sum);
    }
    return most;
}

} // namespace

int steady_sign(const pieces::HomogeneousPiece &piece, int axes, const std::array<double, 3> &direction) {
    const bool polynomial = piece.weight.shape.coefficients() == 1;
    std::vector<Column> columns;
    Rows means, rows;
    means[2] = {direction[0], direction[1], direction[2]};
    for (int k = 0; k < axes; ++k) {
        columns.push_back(
            {polynomial ? derivative(piece.points, piece.axis(k)) : tangent_numerator(piece, k)});
        means[static_cast<size_t>(k)] = columns.back().mean();
    }
    if (piece.points.shape.width == 2) {
        means[2] = {0, 0, 1};
    }
    const int sign = invert(means, rows);
    for (size_t k = 0; k < columns.size() && sign != 0; ++k) {
        if (!(farthest(columns[k], k, rows) < 1 - 1e-6)) {
            return 0;
        }
    }
    return sign;
}

} // namespace nrb::analysis

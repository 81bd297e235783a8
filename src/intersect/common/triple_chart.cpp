// SPDX-License-Identifier: MIT
#include "intersect/common/triple_chart.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr double most_rho = 0.75;
// The rounding of local parameters must be smaller than this, or a chart could not distinguish places.
constexpr double least_digits = 0x1p-5;

double largest_of(double lower, double upper) noexcept {
    return std::max(std::abs(lower), std::abs(upper));
}

void set_column(Matrix<6> &matrix, size_t k, const Vector3 &of_b, const Vector3 &of_c) noexcept {
    const std::array<double, 6> column{of_b.x, of_b.y, of_b.z, of_c.x, of_c.y, of_c.z};
    for (size_t i = 0; i < 6; ++i) {
        matrix[i][k] = column[i];
    }
}

// F' from the partial derivatives of the three surfaces.
Matrix<6> derivative_of(const std::array<std::array<Vector3, 2>, 3> &slopes) noexcept {
    Matrix<6> matrix{};
    for (size_t k = 0; k < 2; ++k) {
        set_column(matrix, k, slopes[0][k], slopes[0][k]);
        set_column(matrix, 2 + k, -1 * slopes[1][k], {});
        set_column(matrix, 4 + k, {}, -1 * slopes[2][k]);
    }
    return matrix;
}

// Points and partial derivatives of the three surfaces at places in their parts.
struct TripleValue {
    std::array<Vector3, 3> points{};
    std::array<std::array<Vector3, 2>, 3> slopes{};

    TripleValue(const TripleParts &parts, const TriplePlace &z) noexcept {
        for (size_t s = 0; s < 3; ++s) {
            const CrossPiece::Point point = parts[s]->piece().evaluate(parts[s]->in_piece(z.data() + 2 * s));
            points[s] = point.at;
            slopes[s] = {parts[s]->length(0) * point.slope[0], parts[s]->length(1) * point.slope[1]};
        }
    }
};

TriplePlace product(const Matrix<6> &matrix, const Vector3 &b, const Vector3 &c) noexcept {
    TriplePlace result{};
    for (size_t i = 0; i < 6; ++i) {
        const auto &row = matrix[i];
        result[i] = row[0] * b.x + row[1] * b.y + row[2] * b.z + row[3] * c.x + row[4] * c.y + row[5] * c.z;
    }
    return result;
}

} // namespace

TripleChart::Verdict TripleChart::set(const TripleParts &parts) {
    parts_ = parts;
    contraction_ = {};
    bends_ = {};
    const auto error = [&](size_t s) { return parts[s]->amplified() * parts[s]->piece().error; };
    near_ = 1.01 * (error(0) + std::max(error(1), error(2)));
    count_work(1000);
    std::array<std::array<Vector3, 2>, 3> slopes;
    for (size_t s = 0; s < 3; ++s) {
        slopes[s] = {parts[s]->slope(0), parts[s]->slope(1)};
    }
    Matrix<6> inverse{};
    if (!invert<6>(derivative_of(slopes), inverse)) {
        return Verdict::flat;
    }
    double norm = 0;
    for (size_t i = 0; i < 6; ++i) {
        const auto &row = inverse[i];
        rows_[i] = {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}};
        norm = std::max(norm, 1.0001 * (length(rows_[i].b) + length(rows_[i].c)));
    }
    if (!std::isfinite(norm)) {
        return Verdict::flat;
    }
    double rho = 0;
    for (size_t i = 0; i < 6; ++i) {
        double row = 0;
        if (!set_row(i, row)) {
            return Verdict::apart;
        }
        rho = std::max(rho, row);
    }
    if (!(rho <= most_rho) || !(norm * near_ < least_digits)) {
        return Verdict::bent;
    }
    contraction_ = {rho, norm};
    return Verdict::chart;
}

// Adds up row i of |I - M F'|; false: row i of M F is nowhere 0.
bool TripleChart::set_row(size_t i, double &sum) {
    const auto &[b, c] = rows_[i];
    const std::array<Vector3, 3> factors{b + c, -1 * b, -1 * c};
    const Vector3 from_b = parts_[0]->centre() - parts_[1]->centre(),
                  from_c = parts_[0]->centre() - parts_[2]->centre();
    const double sizes = length(b) * length(from_b) + length(c) * length(from_c);
    double lower = dot(b, from_b) + dot(c, from_c), upper = lower, room = 16 * eps * sizes;
    sum = 64 * eps;
    for (size_t s = 0; s < 3; ++s) {
        count_work(400);
        const CrossExtents extents = parts_[s]->along(factors[s]);
        lower += extents.points.lower;
        upper += extents.points.upper;
        room += length(factors[s]) * parts_[s]->wide_error() +
                16 * eps * largest_of(extents.points.lower, extents.points.upper);
        double off = 0;
        for (size_t k = 0; k < 2; ++k) {
            const double wanted = i == 2 * s + k ? 1 : 0;
            off += 1.0001 * largest_of(extents.slopes[k].lower - wanted, extents.slopes[k].upper - wanted);
        }
        bends_[s] = std::max(bends_[s], off);
        sum += off;
    }
    return lower <= room && upper >= -room;
}

TripleChart::Found TripleChart::solution() const {
    Vector3 from_b, from_c;
    Matrix<6> inverse{};
    bool inverted = false;
    const auto fixed = [&](const TriplePlace &z) {
        count_work(1500);
        const TripleValue value(parts_, z);
        from_b = value.points[0] - value.points[1];
        from_c = value.points[0] - value.points[2];
        inverted = invert<6>(derivative_of(value.slopes), inverse);
        TriplePlace step{};
        for (size_t i = 0; i < 6; ++i) {
            step[i] = dot(rows_[i].b, from_b) + dot(rows_[i].c, from_c);
        }
        return step;
    };
    TriplePlace step{};
    const auto newton = [&] { return inverted ? product(inverse, from_b, from_c) : step; };
    Found found;
    found.at = approached<6>([&](const TriplePlace &z) { return step = fixed(z); }, newton, widening);
    found.range = contraction_.solutions(found.at, step, near_);
    return found;
}

size_t TripleChart::most_bent() const noexcept {
    return static_cast<size_t>(std::ranges::max_element(bends_) - bends_.begin());
}

} // namespace nrb::intersect

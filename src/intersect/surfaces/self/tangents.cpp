// SPDX-License-Identifier: MIT
#include "intersect/surfaces/self/tangents.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/binomial.h"
#include "pieces/tree/patch_kernel.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr size_t record_size = 4; // x w, y w, z w, w

// Subdivides homogeneous control points along an axis to a part of it. inner: number of values in a layer.
void take_part(int degree, const Interval &places, size_t outer, size_t inner, std::vector<double> &records) {
    if (places.lower == 0 && places.upper == 1) {
        return;
    }
    const auto n = static_cast<size_t>(degree) + 1;
    std::vector<double> matrix(n * n), part(records.size());
    pieces::part_matrix(degree, places.lower, places.upper, matrix.data());
    for (size_t o = 0; o < outer; ++o) {
        for (size_t i = 0; i < n; ++i) {
            double *to = part.data() + (o * n + i) * inner;
            for (size_t j = 0; j < n; ++j) {
                const double *from = records.data() + (o * n + j) * inner;
                for (size_t c = 0; c < inner; ++c) {
                    to[c] += matrix[i * n + j] * from[c];
                }
            }
        }
    }
    records = std::move(part);
}

} // namespace

Tangents::Tangents(const CrossPiece &piece, const std::array<Interval, 2> &places)
    : degrees_(piece.degrees), binomials_{binomials(degrees_[0]), binomials(degrees_[1])} {
    const auto count = static_cast<size_t>(piece.piece.coefficients());
    std::vector<double> records(piece.piece.record(0), piece.piece.record(0) + count * record_size);
    const size_t row = static_cast<size_t>(degrees_[1]) + 1;
    take_part(degrees_[0], places[0], 1, row * record_size, records);
    take_part(degrees_[1], places[1], count / row, record_size, records);
    for (size_t i = 0; i < records.size(); i += record_size) {
        const double w = records[i + 3], inverse = 1 / w;
        points_.push_back({records[i] * inverse, records[i + 1] * inverse, records[i + 2] * inverse});
        weights_.push_back(w);
        rational_ = rational_ || w != weights_.front();
    }
    error_ = piece.error + 4 * (degrees_[0] + degrees_[1] + 2) * eps * piece.piece.reach();
    count_work(static_cast<int64_t>(count) * (4 * (degrees_[0] + degrees_[1]) + 16));
}

void Tangents::add_rays(size_t axis, std::optional<size_t> without, std::vector<TangentRay> &rays) const {
    const auto p = static_cast<size_t>(degrees_[axis]), q = static_cast<size_t>(degrees_[1 - axis]);
    const size_t last = rational_ ? 2 * q : q;
    const size_t from = without == 0 ? 1 : 0, to = without == 1 ? last - 1 : last;
    if (!rational_) {
        add_legs(axis, from, to, rays);
        return;
    }
    for (size_t power = 0; power + 1 < 2 * p; ++power) {
        for (size_t layers = from; layers <= to; ++layers) {
            rays.push_back(sum_of_chords(axis, power, layers));
        }
    }
    count_work(static_cast<int64_t>(3 * p * (p + 1) * (q + 1) * (q + 1)));
}

void Tangents::add_legs(size_t axis, size_t first, size_t last, std::vector<TangentRay> &rays) const {
    for (size_t i = 0; i < static_cast<size_t>(degrees_[axis]); ++i) {
        for (size_t j = first; j <= last; ++j) {
            rays.push_back({points_[place(axis, i + 1, j)] - points_[place(axis, i, j)], 2 * error_});
        }
    }
}

// The ray of the terms with i + j - 1 = power and with indices of layers along the other axis whose sum is
// `layers`: the mean of their chords, weighted by the factors.
TangentRay Tangents::sum_of_chords(size_t axis, size_t power, size_t layers) const noexcept {
    const auto p = static_cast<size_t>(degrees_[axis]), q = static_cast<size_t>(degrees_[1 - axis]);
    Vector3 sum;
    double factors = 0;
    for (size_t j = power / 2 + 1; j <= std::min(p, power + 1); ++j) {
        const size_t i = power + 1 - j;
        const double of_axis = static_cast<double>(j - i) * binomials_[axis][i] * binomials_[axis][j];
        for (size_t l = layers > q ? layers - q : 0; l <= std::min(q, layers); ++l) {
            const size_t m = layers - l, a = place(axis, i, l), b = place(axis, j, m);
            const double factor =
                of_axis * binomials_[1 - axis][l] * binomials_[1 - axis][m] * weights_[a] * weights_[b];
            sum = sum + factor * (points_[b] - points_[a]);
            factors += factor;
        }
    }
    return {(1 / factors) * sum, 2 * error_};
}

void Tangents::add_rays_from(const Vector3 &point, size_t axis, std::optional<size_t> without,
                             std::vector<TangentRay> &rays) const {
    const auto p = static_cast<size_t>(degrees_[axis]), q = static_cast<size_t>(degrees_[1 - axis]);
    for (size_t i = without == 0 ? 1 : 0; i <= (without == 1 ? p - 1 : p); ++i) {
        for (size_t j = 0; j <= q; ++j) {
            rays.push_back({points_[place(axis, i, j)] - point, 2 * error_});
        }
    }
}

} // namespace nrb::intersect

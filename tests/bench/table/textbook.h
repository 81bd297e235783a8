// SPDX-License-Identifier: MIT
// A point of a rational surface as Piegl & Tiller's book computes it: span search by halving, basis functions by the
// recurrence with its differences of knots, the sum of homogeneous points, one division.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace bench {

class TextbookSurface {
public:
    TextbookSurface(int degree, int count, std::vector<double> knots, std::vector<double> records)
        : degree_(degree), count_(count), knots_(std::move(knots)), records_(std::move(records)) {}

    void point(double u, double v, double *out) const {
        std::array<double, 32> across{}, along{};
        const int i = span(u), j = span(v);
        basis(i, u, across.data());
        basis(j, v, along.data());
        double sum[4] = {0, 0, 0, 0};
        for (int k = 0; k <= degree_; ++k) {
            double row[4] = {0, 0, 0, 0};
            const double *record = records_.data() + 4 * ((i - degree_ + k) * count_ + j - degree_);
            for (int l = 0; l <= degree_; ++l, record += 4) {
                for (int c = 0; c < 4; ++c) {
                    row[c] += along[static_cast<size_t>(l)] * record[c];
                }
            }
            for (int c = 0; c < 4; ++c) {
                sum[c] += across[static_cast<size_t>(k)] * row[c];
            }
        }
        for (int c = 0; c < 3; ++c) {
            out[c] = sum[c] / sum[3];
        }
    }

private:
    [[nodiscard]] double knot(int i) const { return knots_[static_cast<size_t>(i)]; }
    [[nodiscard]] int span(double t) const {
        if (t >= knot(count_)) {
            return count_ - 1;
        }
        int low = degree_, high = count_;
        while (high - low > 1) {
            const int middle = (low + high) / 2;
            (t < knot(middle) ? high : low) = middle;
        }
        return low;
    }
    void basis(int i, double t, double *values) const {
        double left[32], right[32];
        values[0] = 1;
        for (int j = 1; j <= degree_; ++j) {
            left[j] = t - knot(i + 1 - j);
            right[j] = knot(i + j) - t;
            double saved = 0;
            for (int r = 0; r < j; ++r) {
                const double part = values[r] / (right[r + 1] + left[j - r]);
                values[r] = saved + right[r + 1] * part;
                saved = left[j - r] * part;
            }
            values[j] = saved;
        }
    }

    int degree_, count_;
    std::vector<double> knots_, records_;
};

} // namespace bench

// SPDX-License-Identifier: MIT
// Rows of one polar form each, collected until many rows with the same number of steps can be computed side
// by side.
#pragma once

#include "refine/knots/blossom_rows.h"

#include <algorithm>
#include <vector>

namespace nrb::refine {

class BatchedBlossoms {
public:
    static constexpr int64_t batch_rows = int64_t{8} * row_lanes;

    // `steps`: the largest number of steps of a row.
    explicit BatchedBlossoms(int steps) : batches_(static_cast<size_t>(steps) + 1) {}

    // Adds a row of `steps` > 0 arguments. Its steps + 1 coefficients (see append_argument()) are at `row`
    // when finish() returns. The knots are copied at once.
    void add(int steps, const double *left, const double *right, const double *arguments, double *row) {
        Batch &batch = batches_[static_cast<size_t>(steps)];
        if (batch.knots.empty()) {
            open(batch, steps);
        }
        double *knots = batch.knots.data() + batch.size;
        switch (steps) { // low degrees without loops
        case 1:
            fill<1>(1, left, right, arguments, knots);
            break;
        case 2:
            fill<2>(2, left, right, arguments, knots);
            break;
        case 3:
            fill<3>(3, left, right, arguments, knots);
            break;
        default:
            fill<0>(steps, left, right, arguments, knots);
        }
        batch.rows[batch.size++] = row;
        if (batch.size == batch_rows) {
            make(batch, steps);
        }
    }

    void finish();

private:
    struct Batch {
        int64_t size = 0;
        double *rows[batch_rows] = {};
        std::vector<double> knots; // [left, farthest first; right; arguments][batch_rows]
    };

    template <int kSteps>
    static void fill(int steps, const double *left, const double *right, const double *arguments,
                     double *knots) {
        const int n = kSteps > 0 ? kSteps : steps;
        for (int i = 0; i < n; ++i) {
            knots[i * batch_rows] = left[i - n];
            knots[(n + i) * batch_rows] = right[i];
            knots[(2 * n + i) * batch_rows] = arguments[i];
        }
    }

    static void open(Batch &batch, int steps);
    static void make(Batch &batch, int steps);

    std::vector<Batch> batches_;
};

} // namespace nrb::refine

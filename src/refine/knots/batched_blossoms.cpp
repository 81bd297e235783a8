// SPDX-License-Identifier: MIT
#include "refine/knots/batched_blossoms.h"

namespace nrb::refine {

// Lanes without a row are computed too. Their initial knots keep the divisors away from 0.
void BatchedBlossoms::open(Batch &batch, int steps) {
    const int64_t side = steps * batch_rows;
    batch.knots.assign(static_cast<size_t>(3 * side), 0);
    std::fill_n(batch.knots.begin() + side, side, 1.0);
}

void BatchedBlossoms::make(Batch &batch, int steps) {
    const double *knots = batch.knots.data();
    const int64_t side = steps * batch_rows;
    BlossomTerm term{steps, 0, 1, knots + side, knots + side, batch_rows, {}};
    for (int i = 0; i < steps; ++i) {
        term.arguments[i] = knots + 2 * side + i * batch_rows;
    }
    double unused[max_basis];
    int64_t count = batch.size;
    for (; count % row_lanes != 0; ++count) {
        batch.rows[count] = unused;
    }
    blossom_rows(term, count, batch.rows);
    batch.size = 0;
}

void BatchedBlossoms::finish() {
    for (size_t steps = 1; steps < batches_.size(); ++steps) {
        if (batches_[steps].size > 0) {
            make(batches_[steps], static_cast<int>(steps));
        }
    }
}

} // namespace nrb::refine

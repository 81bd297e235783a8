// SPDX-License-Identifier: MIT
// Buffers for outputs until nothing can fail any more, because a failing call must write nothing.
#pragma once

#include "eval/frames/frame_outputs.h"
#include "eval/frames/magnitude.h"

#include <vector>

namespace nrb::eval {

// Buffers with a record for each parameter of a list, and statuses. They are filled run by run by
// for_each_magnitude(), in its order.
class WaitingOutputs {
public:
    struct Array {
        Records out;   // not wanted if it has no data
        int power = 0; // the unit of the values is 1 / length^power
    };
    WaitingOutputs(std::vector<Array> arrays, int32_t *status, int64_t count);

    // The parts of the buffers that belong to a run.
    [[nodiscard]] Records part(size_t array, const MagnitudeRun &run) noexcept;
    [[nodiscard]] int32_t *status(const MagnitudeRun &run) noexcept { return status_.data() + run.first; }
    // Scales what a run has computed for the scaled copy to the values for the spline itself.
    void finish(const MagnitudeRun &run) noexcept;
    // Writes all outputs to the caller's arrays. `order` is the result of for_each_magnitude().
    void write(const std::vector<int64_t> &order) const noexcept;

private:
    std::vector<Array> arrays_;
    std::vector<std::vector<double>> values_;
    int32_t *status_out_;
    std::vector<int32_t> status_;
};

} // namespace nrb::eval

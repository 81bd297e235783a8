// SPDX-License-Identifier: MIT
// Outputs that wait until nothing can fail any more, because a failing call writes nothing.
#pragma once

#include "eval/frames/frame_outputs.h"
#include "eval/frames/magnitude.h"

#include <vector>

namespace nrb::eval {

// Arrays with a record for each parameter of a list, and statuses, filled run by run as for_each_magnitude()
// finds them.
class WaitingOutputs {
public:
    struct Array {
        Records out;   // without data: not wanted
        int power = 0; // of 1 / length, in which the values are
    };
    WaitingOutputs(std::vector<Array> arrays, int32_t *status, int64_t count);

    // The arrays that a run writes to.
    [[nodiscard]] Records part(size_t array, const MagnitudeRun &run) noexcept;
    [[nodiscard]] int32_t *status(const MagnitudeRun &run) noexcept { return status_.data() + run.first; }
    // Converts what a run has written to the spline itself.
    void finish(const MagnitudeRun &run) noexcept;
    // Writes all outputs; `order` is the result of for_each_magnitude().
    void write(const std::vector<int64_t> &order) const noexcept;

private:
    std::vector<Array> arrays_;
    std::vector<std::vector<double>> values_;
    int32_t *status_out_;
    std::vector<int32_t> status_;
};

} // namespace nrb::eval

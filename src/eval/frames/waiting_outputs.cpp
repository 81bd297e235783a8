// SPDX-License-Identifier: MIT
#include "eval/frames/waiting_outputs.h"

#include <cmath>
#include <utility>

namespace nrb::eval {

WaitingOutputs::WaitingOutputs(std::vector<Array> arrays, int32_t *status, int64_t count)
    : arrays_(std::move(arrays)), status_out_(status), status_(static_cast<size_t>(count)) {
    for (const Array &array : arrays_) {
        values_.emplace_back(array.out.data == nullptr ? 0 : static_cast<size_t>(count * array.out.width));
    }
}

Records WaitingOutputs::part(size_t array, const MagnitudeRun &run) noexcept {
    const int64_t width = arrays_[array].out.width;
    double *data = values_[array].empty() ? nullptr : values_[array].data() + run.first * width;
    return {data, run.params.count, width, width, 1};
}

void WaitingOutputs::finish(const MagnitudeRun &run) noexcept {
    for (size_t array = 0; array < arrays_.size(); ++array) {
        const Records own = part(array, run);
        const int exponent = arrays_[array].power * run.size;
        for (int64_t i = 0; own.data != nullptr && exponent != 0 && i < own.count * own.width; ++i) {
            own.data[i] = std::ldexp(own.data[i], exponent);
        }
    }
}

void WaitingOutputs::write(const std::vector<int64_t> &order) const noexcept {
    for (size_t n = 0; n < order.size(); ++n) {
        for (size_t array = 0; array < arrays_.size(); ++array) {
            const Records &out = arrays_[array].out;
            for (int64_t c = 0; out.data != nullptr && c < out.width; ++c) {
                out(order[n], c) =
                    values_[array][n * static_cast<size_t>(out.width) + static_cast<size_t>(c)];
            }
        }
        write_status(status_[n], order[n], status_out_);
    }
}

} // namespace nrb::eval

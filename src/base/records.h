// SPDX-License-Identifier: MIT
// Strided views of the caller's arrays: `count` records of `width` values, component c of record i at
// data[i * stride + c * component_stride].
#pragma once

#include <cstdint>

namespace nrb::inline base {

template <class T>
struct RecordView {
    T *data = nullptr;
    int64_t count = 0;
    int64_t width = 1;
    int64_t stride = 1;
    int64_t component_stride = 1;

    [[nodiscard]] T &operator()(int64_t i, int64_t c) const noexcept {
        return data[i * stride + c * component_stride];
    }
    [[nodiscard]] T *record(int64_t i) const noexcept { return data + i * stride; }
    // One past the largest index, relative to data, that the view can access.
    [[nodiscard]] int64_t extent() const noexcept {
        return count == 0 ? 0 : (count - 1) * stride + (width - 1) * component_stride + 1;
    }
};

using ConstRecords = RecordView<const double>;
using Records = RecordView<double>;
using FloatRecords = RecordView<float>; // results in single precision; strides in floats

} // namespace nrb::inline base

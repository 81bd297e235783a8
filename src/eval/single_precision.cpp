// SPDX-License-Identifier: MIT
#include "eval/single_precision.h"

#include "eval/blocks.h"
#include "eval/evaluate.h"

namespace nrb::eval {

namespace {

// Rounds the points in `values` to float and stores them as points first, first + 1, ...
void round_points(ConstRecords values, int64_t first, FloatRecords points) noexcept {
    if (values.component_stride == 1 && values.stride == values.width && points.component_stride == 1 &&
        points.stride == values.width) {
        const double *const from = values.data;
        float *const to = points.data + first * points.stride;
        for (int64_t i = 0; i < values.count * values.width; ++i) {
            to[i] = static_cast<float>(from[i]);
        }
        return;
    }
    for (int64_t i = 0; i < values.count; ++i) {
        for (int64_t c = 0; c < values.width; ++c) {
            points(first + i, c) = static_cast<float>(values(i, c));
        }
    }
}

// Rounds each block of points to the caller's array of floats.
class FloatSink final : public BlockSink {
public:
    explicit FloatSink(FloatRecords points) noexcept : points_(points) {}

    [[nodiscard]] bool wants_points() const noexcept override { return true; }

    void operator()(int64_t first, ConstRecords values) noexcept override {
        round_points(values, first, points_);
    }

private:
    FloatRecords points_;
};

} // namespace

void evaluate_points(const Spline &spline, const AxisRules &rules, ConstRecords params, FloatRecords points) {
    FloatSink sink(points);
    evaluate_points(spline, rules, 0, params, sink);
}

void evaluate_grid(const Spline &spline, const AxisRules &rules,
                   const std::array<ConstRecords, max_axes> &params, FloatRecords points) {
    FloatSink sink(points);
    evaluate_grid(spline, rules, 0, params, sink);
}

} // namespace nrb::eval

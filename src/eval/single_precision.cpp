#include "eval/single_precision.h"

#include "eval/blocks.h"

namespace nrb {

namespace {

class FloatSink final : public BlockSink {
public:
    explicit FloatSink(FloatRecords points) noexcept : points_(points) {}
    virtual ~FloatSink() = default;

    void operator()(int64_t first, ConstRecords values) noexcept override {
        for (int64_t i = 0; i < values.count; ++i) {
            for (int64_t c = 0; c < values.width; ++c) {
                points_(first + i, c) = static_cast<float>(values(i, c));
            }
        }
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
    if (points.count > 0) {
        FloatSink sink(points);
        evaluate_grid(spline, rules, 0, params, sink);
    }
}

} // namespace nrb

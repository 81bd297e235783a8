#include "eval/blocks.h"

#include "base/scratch.h"
#include "eval/evaluate.h"
#include "eval/slots.h"

#include <algorithm>

namespace nrb {

namespace {

int64_t components(const Spline &spline, int order) noexcept {
    return slot_count(spline.axes(), order) * spline.dim();
}

ConstRecords part(ConstRecords params, int64_t first, int64_t count) noexcept {
    params.data += first * params.stride;
    params.count = count;
    return params;
}

} // namespace

void evaluate_points(const Spline &spline, const AxisRules &rules, int order, ConstRecords params,
                     BlockSink &sink) {
    const int64_t width = components(spline, order);
    Scratch scratch(static_cast<size_t>(width * block_size));
    double *rows = scratch.take(static_cast<size_t>(width * block_size));
    for (int64_t first = 0; first < params.count; first += block_size) {
        const int64_t count = std::min(block_size, params.count - first);
        evaluate_points(spline, rules, order, part(params, first, count),
                        {rows, count, width, 1, block_size});
        sink(first, {rows, count, width, 1, block_size});
    }
}

void evaluate_grid(const Spline &spline, const AxisRules &rules, int order,
                   const std::array<ConstRecords, max_axes> &params, BlockSink &sink) {
    const auto last = static_cast<size_t>(spline.axes() - 1);
    const int64_t width = components(spline, order);
    Scratch scratch(static_cast<size_t>(width * block_size));
    double *rows = scratch.take(static_cast<size_t>(width * block_size));
    int64_t outer = 1;
    for (size_t k = 0; k < last; ++k) {
        outer *= params[k].count;
    }
    std::array<ConstRecords, max_axes> row = params;
    for (int64_t o = 0; o < outer; ++o) {
        int64_t rest = o;
        for (size_t k = last; k-- > 0;) {
            row[k] = part(params[k], rest % params[k].count, 1);
            rest /= params[k].count;
        }
        for (int64_t first = 0; first < params[last].count; first += block_size) {
            const int64_t count = std::min(block_size, params[last].count - first);
            row[last] = part(params[last], first, count);
            evaluate_grid(spline, rules, order, row, {rows, count, width, 1, block_size});
            sink(o * params[last].count + first, {rows, count, width, 1, block_size});
        }
    }
}

} // namespace nrb

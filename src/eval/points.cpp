#include "eval/curve_kernel.h"
#include "eval/evaluate.h"
#include "eval/tensor_kernel.h"

#include <memory>
#include <optional>

namespace nrb {

namespace {

size_t record_scratch(const RecordShape &shape, int64_t block) noexcept {
    return static_cast<size_t>(block * shape.size() + shape.slots) + QuotientRule::scratch_size(shape.order);
}

const QuotientRule *make_rule(std::optional<QuotientRule> &rule, const RecordShape &shape, Scratch &scratch) {
    return shape.rational ? &rule.emplace(shape.axes, shape.order, scratch) : nullptr;
}

void evaluate_curve(const Spline &curve, const AxisRule &rule, int order, ConstRecords params, Records out) {
    const RecordShape shape(curve, order);
    const int degree = curve.axis(0).degree();
    const auto piece = static_cast<size_t>(Piece::size(degree, shape.width));
    const auto values = static_cast<size_t>(shape.slots) * static_cast<size_t>(degree + 1);
    Scratch scratch(record_scratch(shape, curve_group) + 2 * piece + values + 8);
    std::optional<QuotientRule> quotient;
    const PieceArray *pieces = curve.pieces_after(params.count);
    run(CurveJob{curve, rule, shape, make_rule(quotient, shape, scratch),
                 pieces != nullptr ? &curve.axis(0).spans() : nullptr, pieces, params, out,
                 scratch.take_aligned(static_cast<size_t>(curve_group * shape.size())),
                 scratch.take(static_cast<size_t>(shape.slots)), scratch.take(piece), scratch.take(values),
                 scratch.take(piece)});
}

// Blocks of the size that suits the first-level cache.
int64_t tensor_block(const RecordShape &shape, int64_t points) noexcept {
    constexpr int64_t most = 32;
    constexpr int64_t doubles = 1024;
    return std::clamp<int64_t>(doubles / shape.size(), 1, std::min(most, points));
}

class TensorMemory {
public:
    TensorMemory(const Spline &spline, const RecordShape &shape, const AxisSource *sources, int64_t block)
        : spline_(spline), shape_(shape), sources_(sources), block_(block), scratch_(size()) {}

    Scratch &scratch() noexcept { return scratch_; }

    void give(TensorJob &job) {
        const auto axes = static_cast<size_t>(shape_.axes);
        job.records = scratch_.take(static_cast<size_t>(block_ * shape_.size()));
        job.weights = scratch_.take(static_cast<size_t>(shape_.slots));
        for (size_t k = 0; k < axes; ++k) {
            job.values[k] = scratch_.take(static_cast<size_t>(block_ * sources_[k].values_size(shape_.order)));
            job.points[k] = points_[k];
        }
        job.slabs.length[axes - 1] = shape_.width;
        for (size_t k = axes - 1; k-- > 0;) {
            job.slabs.length[k] = job.slabs.length[k + 1] * (sources_[k + 1].degree + 1);
            const auto size = slab_size(k, job.slabs.length[k]);
            job.slabs.data[k] = scratch_.take(size);
            std::fill_n(job.slabs.data[k] + size - padding, padding, 0.0);
        }
        job.window = scratch_.take(window_size());
    }

private:
    static constexpr size_t padding = 4; // records are read as whole vectors

    [[nodiscard]] size_t slab_size(size_t k, int64_t length) const noexcept {
        return static_cast<size_t>(slot_count(static_cast<int>(k) + 1, shape_.order) * length) + padding;
    }

    [[nodiscard]] size_t window_size() const noexcept {
        auto size = static_cast<size_t>(shape_.width);
        for (int k = 0; k < shape_.axes; ++k) {
            size *= static_cast<size_t>(sources_[k].degree + 1);
        }
        return size;
    }

    [[nodiscard]] size_t size() const noexcept {
        size_t size = record_scratch(shape_, block_) + window_size();
        int64_t length = shape_.width;
        for (auto k = static_cast<size_t>(shape_.axes); k-- > 0;) {
            size += static_cast<size_t>(block_ * sources_[k].values_size(shape_.order)) + sources_[k].work_size;
            if (k > 0) {
                length *= sources_[k].degree + 1;
                size += slab_size(k - 1, length);
            }
        }
        return size;
    }

    const Spline &spline_;
    const RecordShape &shape_;
    const AxisSource *sources_;
    int64_t block_;
    Scratch scratch_;
    AxisPoint points_[max_axes][32];
};

void evaluate_tensor(const Spline &spline, const AxisRules &rules, int order, ConstRecords params,
                     Records out) {
    const RecordShape shape(spline, order);
    AxisSources sources = axis_sources(spline, rules, order, {params.count, params.count, params.count});
    const int64_t block = tensor_block(shape, params.count);
    TensorMemory memory(spline, shape, sources.data(), block);
    for (int k = 0; k < spline.axes(); ++k) {
        sources[static_cast<size_t>(k)].take_work(memory.scratch());
    }
    std::optional<QuotientRule> quotient;
    TensorJob job{spline, shape, make_rule(quotient, shape, memory.scratch()), sources.data(),
                  spline.records_after(params.count), params, out, block, {}, {}, {}, nullptr, nullptr, nullptr};
    memory.give(job);
    run(job);
}

} // namespace

void evaluate_points(const Spline &spline, const AxisRules &rules, int order, ConstRecords params,
                     Records out) {
    if (params.count == 0) {
        return;
    }
    if (spline.axes() == 1) {
        evaluate_curve(spline, rules[0], order, params, out);
    } else {
        evaluate_tensor(spline, rules, order, params, out);
    }
}

} // namespace nrb

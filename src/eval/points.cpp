// SPDX-License-Identifier: MIT
// Evaluation of lists of parameters: the working memory of the kernels of curves and of surfaces and volumes.
#include "base/checked.h"
#include "eval/blocks.h"
#include "eval/evaluate.h"
#include "eval/kernels/curve_kernel.h"
#include "eval/kernels/derivative_source.h"
#include "eval/kernels/single_kernel.h"
#include "eval/kernels/tensor_kernel.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace nrb::eval {

namespace {

size_t record_scratch(const RecordShape &shape, int64_t block) noexcept {
    return static_cast<size_t>(block * shape.size() + shape.slots) + QuotientRule::scratch_size(shape.order);
}

const QuotientRule *make_rule(std::optional<QuotientRule> &rule, const RecordShape &shape, Scratch &scratch) {
    return shape.rational ? &rule.emplace(shape.axes, shape.order, scratch) : nullptr;
}

// Evaluates a curve at lists of parameters, with working memory that is allocated once.
class CurveEvaluator {
public:
    CurveEvaluator(const Spline &curve, const AxisRule &rule, int order, int64_t uses)
        : shape_(curve, order), scratch_(scratch_size(curve, shape_)),
          quotient_(make_rule(rule_, shape_, scratch_)), power_spans_(curve.power_spans_after(uses)),
          job_{curve,
               rule,
               shape_,
               quotient_,
               power_spans_ != nullptr ? &curve.axis(0).spans() : nullptr,
               power_spans_,
               net_after(curve, uses),
               scratch_.take_aligned(static_cast<size_t>(curve_group * shape_.size())),
               scratch_.take(static_cast<size_t>(shape_.slots)),
               scratch_.take(power_span_size(curve, shape_)),
               scratch_.take(values_size(curve, shape_)),
               scratch_.take(power_span_size(curve, shape_)),
               scratch_.take(lanes_size(curve, shape_))} {}

    void operator()(const ConstRecords &params, const Records &out) noexcept { run(job_, params, out); }

private:
    // The table of records, if it is needed: curves whose spans all have power spans do without it.
    static const double *net_after(const Spline &curve, int64_t uses) {
        return curve.has_power_spans(0) ? nullptr : curve.records_after(uses);
    }
    static size_t power_span_size(const Spline &curve, const RecordShape &shape) noexcept {
        return PowerSpan::head_size +
               static_cast<size_t>(curve.axis(0).degree() + 1) * lanes_size(curve, shape);
    }
    static size_t lanes_size(const Spline &curve, const RecordShape &shape) noexcept {
        return static_cast<size_t>(std::max(shape.lanes, curve.span_lanes()));
    }
    static size_t values_size(const Spline &curve, const RecordShape &shape) noexcept {
        return static_cast<size_t>(shape.slots) * static_cast<size_t>(curve.axis(0).degree() + 1);
    }
    static size_t scratch_size(const Spline &curve, const RecordShape &shape) noexcept {
        return record_scratch(shape, curve_group) + 2 * power_span_size(curve, shape) +
               values_size(curve, shape) + lanes_size(curve, shape) + Scratch::line;
    }

    RecordShape shape_;
    Scratch scratch_;
    std::optional<QuotientRule> rule_;
    const QuotientRule *quotient_;
    const PowerSpans *power_spans_;
    CurveJob job_;
};

// The number of points in a block, such that its records fit the first-level cache.
int64_t tensor_block(const RecordShape &shape, int64_t points) noexcept {
    constexpr int64_t most = 32;
    constexpr int64_t doubles = 1024;
    return std::clamp<int64_t>(doubles / shape.size(), 1, std::min(most, points));
}

// The same for a surface or a volume.
class TensorEvaluator {
public:
    TensorEvaluator(const Spline &spline, const AxisRules &rules, int order, int64_t uses)
        : shape_(spline, order), sources_(axis_sources(spline, rules, order, {uses, uses, uses})),
          block_(tensor_block(shape_, uses)), scratch_(scratch_size()),
          quotient_(make_rule(rule_, shape_, scratch_)),
          job_{spline, shape_,  quotient_, sources_.data(), spline.records_after(uses), block_, {}, {},
               {},     nullptr, nullptr,   nullptr} {
        job_.records = scratch_.take(static_cast<size_t>(block_ * shape_.size()));
        job_.weights = scratch_.take(static_cast<size_t>(shape_.slots));
        job_.window = take_padded(window_size());
        for (size_t k = 0; k < axes(); ++k) {
            sources_[k].take_work(scratch_);
            job_.values[k] =
                scratch_.take_aligned(static_cast<size_t>(block_ * sources_[k].values_size(shape_.order)));
            job_.points[k] = points_[k];
        }
        make_slabs();
    }

    void operator()(const ConstRecords &params, const Records &out) noexcept { run(job_, params, out); }

private:
    static constexpr size_t padding = 4; // records are read as whole vectors

    [[nodiscard]] size_t axes() const noexcept { return static_cast<size_t>(shape_.axes); }

    void make_slabs() noexcept {
        job_.slabs.length[axes() - 1] = shape_.width;
        for (size_t k = axes() - 1; k-- > 0;) {
            job_.slabs.length[k] = job_.slabs.length[k + 1] * (sources_[k + 1].degree + 1);
            job_.slabs.data[k] = take_padded(slab_size(k, job_.slabs.length[k]));
        }
    }

    double *take_padded(size_t size) noexcept {
        double *block = scratch_.take_aligned(size);
        std::fill_n(block + size - padding, padding, 0.0);
        return block;
    }

    [[nodiscard]] size_t slab_size(size_t k, int64_t length) const noexcept {
        return static_cast<size_t>(slot_count(static_cast<int>(k) + 1, shape_.order) * padded(length)) +
               padding;
    }

    [[nodiscard]] size_t window_size() const noexcept {
        auto size = static_cast<size_t>(shape_.width);
        for (size_t k = 0; k < axes(); ++k) {
            size *= static_cast<size_t>(sources_[k].degree + 1);
        }
        return size + padding;
    }

    [[nodiscard]] size_t scratch_size() const noexcept {
        constexpr size_t aligned_blocks = 2 * max_axes + 1;
        size_t size = record_scratch(shape_, block_) + window_size() + aligned_blocks * Scratch::line;
        int64_t length = shape_.width;
        for (size_t k = axes(); k-- > 0;) {
            size +=
                static_cast<size_t>(block_ * sources_[k].values_size(shape_.order)) + sources_[k].work_size;
            if (k > 0) {
                length *= sources_[k].degree + 1;
                size += slab_size(k - 1, length);
            }
        }
        return size;
    }

    RecordShape shape_;
    AxisSources sources_;
    int64_t block_;
    Scratch scratch_;
    std::optional<QuotientRule> rule_;
    const QuotientRule *quotient_;
    TensorJob job_;
    AxisPoint points_[max_axes][axis_block_size];
};

// Evaluates points and derivatives if the derivatives come from a moved spline. The points of the stored
// spline replace those of the moved one, so that a point is the same with derivatives and without.
template <class Evaluator>
class MovedEvaluator {
public:
    template <class Rule>
    MovedEvaluator(const Spline &spline, const Spline &moved, const Rule &rule, int order, int64_t uses)
        : derivs_(moved, rule, order, uses), points_(spline, rule, 0, uses), dim_(spline.dim()) {}

    void operator()(const ConstRecords &params, const Records &out) noexcept {
        constexpr int64_t part = 512; // few enough to stay in the caches between the two
        for (int64_t first = 0; first < params.count; first += part) {
            const int64_t count = std::min(part, params.count - first);
            const ConstRecords from{params.record(first), count, params.width, params.stride,
                                    params.component_stride};
            derivs_(from, {out.record(first), count, out.width, out.stride, out.component_stride});
            points_(from, {out.record(first), count, dim_, out.stride, out.component_stride});
        }
    }

private:
    Evaluator derivs_;
    Evaluator points_;
    int dim_;
};

// Calls run(evaluator) with the evaluator of a spline, which takes derivatives from their source.
template <class Evaluator, class Rule, class Run>
void with_evaluator(const Spline &spline, const Rule &rule, int order, int64_t uses, Run &&run) {
    const Spline &source = derivative_source(spline, order);
    if (&source == &spline) {
        run(Evaluator(spline, rule, order, uses));
    } else {
        run(MovedEvaluator<Evaluator>(spline, source, rule, order, uses));
    }
}

// Not inlined into evaluate_points(), which should stay short for single points.
[[gnu::noinline]] void evaluate_moved(const Spline &spline, const Spline &moved, const AxisRules &rules,
                                      int order, const ConstRecords &params, const Records &out) {
    if (spline.axes() == 1) {
        MovedEvaluator<CurveEvaluator>(spline, moved, rules[0], order, params.count)(params, out);
    } else {
        MovedEvaluator<TensorEvaluator>(spline, moved, rules, order, params.count)(params, out);
    }
}

// Keeps the tables for single points if this is one. That may fail, so it comes before the evaluation, but
// after the evaluator, which has made the tables that they refer to.
template <class Evaluator>
void evaluate_plain(Evaluator &&evaluate, const Spline &spline, int order, const ConstRecords &params,
                    const Records &out) {
    if (order == 0 && params.count == 1) {
        keep_single_tables(spline);
    }
    evaluate(params, out);
}

// Blocks of a list of parameters.
class ListBlocks {
public:
    static constexpr int64_t most_points = BlockSink::most_points;

    explicit ListBlocks(const ConstRecords &params) : params_(params) {}
    [[nodiscard]] int64_t count() const noexcept { return params_.count; }
    [[nodiscard]] ConstRecords operator()(int64_t first, int64_t count) const noexcept {
        return {params_.record(first), count, params_.width, params_.stride, params_.component_stride};
    }

private:
    const ConstRecords &params_;
};

// Blocks of the list of all combinations of the axes' parameters, last axis fastest.
class GridBlocks {
public:
    static constexpr int64_t most_points = block_size;

    GridBlocks(const std::array<ConstRecords, max_axes> &params, int axes) : params_(params), axes_(axes) {}
    [[nodiscard]] int64_t count() const noexcept {
        int64_t product = 1;
        for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
            product *= params_[k].count;
        }
        return product;
    }
    // The result is valid until the next call.
    [[nodiscard]] ConstRecords operator()(int64_t first, int64_t count) noexcept {
        for (int64_t i = 0; i < count; ++i) {
            int64_t rest = first + i;
            for (int k = axes_ - 1; k >= 0; --k) {
                const ConstRecords &own = params_[static_cast<size_t>(k)];
                block_[i * axes_ + k] = own(rest % own.count, 0);
                rest /= own.count;
            }
        }
        return {block_, count, axes_, axes_, 1};
    }

private:
    const std::array<ConstRecords, max_axes> &params_;
    int axes_;
    double block_[block_size * max_axes];
};

// Evaluates block after block with one evaluator and hands each to the sink.
template <class Evaluator, class Blocks>
void evaluate_blocks(Evaluator &&evaluate, Blocks &&blocks, int64_t width, BlockSink &sink) {
    const bool points = sink.wants_points();
    const int64_t size = points ? std::decay_t<Blocks>::most_points : block_size;
    const std::unique_ptr<double[]> rows(
        new double[static_cast<size_t>(checked_product(width, size, "points"))]);
    const int64_t stride = points ? width : 1, component_stride = points ? 1 : size;
    for (int64_t first = 0; first < blocks.count(); first += size) {
        const int64_t count = std::min(size, blocks.count() - first);
        evaluate(blocks(first, count), Records{rows.get(), count, width, stride, component_stride});
        sink(first, {rows.get(), count, width, stride, component_stride});
    }
}

} // namespace

void evaluate_points(const Spline &spline, const AxisRules &rules, int order, const ConstRecords &params,
                     const Records &out) {
    if (params.count == 0) {
        return;
    }
    if (order > 0) {
        const Spline &source = derivative_source(spline, order);
        if (&source != &spline) {
            return evaluate_moved(spline, source, rules, order, params, out);
        }
    }
    if (spline.axes() == 1) {
        evaluate_plain(CurveEvaluator(spline, rules[0], order, params.count), spline, order, params, out);
    } else {
        evaluate_plain(TensorEvaluator(spline, rules, order, params.count), spline, order, params, out);
    }
}

void evaluate_points(const Spline &spline, const AxisRules &rules, int order, const ConstRecords &params,
                     BlockSink &sink) {
    const int64_t width = slot_count(spline.axes(), order) * spline.dim();
    const int64_t uses = std::max<int64_t>(params.count, 1);
    const auto all = [&](auto &&evaluate) { evaluate_blocks(evaluate, ListBlocks(params), width, sink); };
    if (spline.axes() == 1) {
        with_evaluator<CurveEvaluator>(spline, rules[0], order, uses, all);
    } else {
        with_evaluator<TensorEvaluator>(spline, rules, order, uses, all);
    }
}

void evaluate_combinations(const Spline &spline, const AxisRules &rules, int order,
                           const std::array<ConstRecords, max_axes> &params, const Records &out) {
    GridBlocks blocks(params, spline.axes());
    with_evaluator<TensorEvaluator>(spline, rules, order, out.count, [&](auto &&evaluate) {
        for (int64_t first = 0; first < out.count; first += block_size) {
            const int64_t count = std::min(block_size, out.count - first);
            const Records part{out.record(first), count, out.width, out.stride, out.component_stride};
            evaluate(blocks(first, count), part);
        }
    });
}

void evaluate_combinations(const Spline &spline, const AxisRules &rules, int order,
                           const std::array<ConstRecords, max_axes> &params, BlockSink &sink) {
    GridBlocks blocks(params, spline.axes());
    const int64_t width = slot_count(spline.axes(), order) * spline.dim();
    with_evaluator<TensorEvaluator>(spline, rules, order, std::max<int64_t>(blocks.count(), 1),
                                    [&](auto &&evaluate) { evaluate_blocks(evaluate, blocks, width, sink); });
}

} // namespace nrb::eval

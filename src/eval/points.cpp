#include "eval/contraction.h"
#include "eval/evaluate.h"
#include "eval/finish.h"

namespace nrb {

namespace {

// Evaluates one parameter after the other; the scratch of a call serves them all.
class PointEvaluator {
public:
    PointEvaluator(const Spline &spline, const AxisRules &rules, int order)
        : spline_(spline), order_(order), net_(spline.records().data()),
          axes_(make_axes(spline, rules, order)), scratch_(scratch_size()),
          finisher_(spline, order, scratch_) {
        int64_t length = spline.width();
        for (int k = spline.axes() - 1; k >= 0; --k) {
            const auto at = static_cast<size_t>(k);
            slabs_.length[at] = length;
            slabs_.data[at] = scratch_.take(static_cast<size_t>(slot_count(k + 1, order) * length));
            bases_[at].values = scratch_.take(axis(k).values_size());
            length *= axis(k).degree() + 1;
        }
    }

    void operator()(ConstRecords params, Records out, int64_t i) noexcept {
        for (int k = 0; k < spline_.axes(); ++k) {
            if (!axis(k)(params(i, k), bases_[static_cast<size_t>(k)])) {
                return finisher_.write_nan(out, i);
            }
        }
        contract_net();
        for (int k = 1; k < spline_.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            const Stretch whole{0, slabs_.length[at]};
            contract_level(k, order_, axis(k).degree(), bases_[at], 0, slabs_, {&whole, 1});
        }
        finisher_.write(slabs_.data[static_cast<size_t>(spline_.axes() - 1)], bases_, out, i);
    }

private:
    using AxisEvaluators = std::array<std::optional<AxisEvaluator>, max_axes>;

    static AxisEvaluators make_axes(const Spline &spline, const AxisRules &rules, int order) {
        AxisEvaluators axes;
        for (int k = 0; k < spline.axes(); ++k) {
            axes[static_cast<size_t>(k)].emplace(spline.axis(k), rules[static_cast<size_t>(k)], order);
        }
        return axes;
    }

    [[nodiscard]] const AxisEvaluator &axis(int k) const noexcept { return *axes_[static_cast<size_t>(k)]; }

    [[nodiscard]] size_t scratch_size() const noexcept {
        size_t size = Finisher::scratch_size(spline_, order_);
        auto length = static_cast<size_t>(spline_.width());
        for (int k = spline_.axes() - 1; k >= 0; --k) {
            size += static_cast<size_t>(slot_count(k + 1, order_)) * length + axis(k).values_size();
            length *= static_cast<size_t>(axis(k).degree() + 1);
        }
        return size;
    }

    // Contracts axis 0 over the active window of the net, whose rows are contiguous along the last axis only.
    void contract_net() noexcept {
        const int axes = spline_.axes();
        const int64_t segments = axes == 3 ? axis(1).degree() + 1 : 1;
        const int64_t segment = slabs_.length[0] / segments;
        int64_t stride = spline_.width();
        int64_t offset = 0;
        int64_t segment_stride = 0;
        for (int k = axes - 1; k >= 0; --k) {
            segment_stride = k == 1 ? stride : segment_stride;
            offset += bases_[static_cast<size_t>(k)].first * stride;
            stride *= k > 0 ? spline_.count(k) : 1;
        }
        const int functions = axis(0).degree() + 1;
        for (int a = 0; a <= order_; ++a) {
            for (int64_t s = 0; s < segments; ++s) {
                contract(bases_[0].values + static_cast<int64_t>(a) * functions, functions,
                         net_ + offset + s * segment_stride, stride, segment,
                         slabs_.data[0] + a * slabs_.length[0] + s * segment);
            }
        }
    }

    const Spline &spline_;
    int order_;
    const double *net_;
    AxisEvaluators axes_;
    Scratch scratch_;
    Finisher finisher_;
    Slabs slabs_;
    Bases bases_;
};

} // namespace

void evaluate_points(const Spline &spline, const AxisRules &rules, int order, ConstRecords params,
                     Records out) {
    if (params.count == 0) {
        return;
    }
    PointEvaluator evaluate(spline, rules, order);
    for (int64_t i = 0; i < params.count; ++i) {
        evaluate(params, out, i);
    }
}

} // namespace nrb

// SPDX-License-Identifier: MIT
#include "base/checked.h"
#include "base/scratch.h"
#include "eval/adjoint/net_gradients.h"
#include "eval/adjoint/net_kernel.h"

#include <limits>
#include <vector>

namespace nrb::eval {

namespace {

// The adjoint for points. The gradients are added up in arrays of the kernel's own: over the whole net or, if
// a batch reaches only few of its control points, over the active ones of one parameter after the other. Both
// give the same bits.
class PointsAdjoint {
public:
    PointsAdjoint(const Cotangents &from, const Gradients &out)
        : from_(from), out_(out), rational_(from.spline.rational()),
          clamps_(std::any_of(from.rules.begin(), from.rules.end(),
                              [](const AxisRule &rule) { return rule.outside == Outside::clamp; })),
          order_(out.params.data != nullptr ? 1 : 0), uses_(std::max<int64_t>(from.params.count, 1)),
          sources_(axis_sources(from.spline, from.rules, order_, {uses_, uses_, uses_})),
          scratch_(scratch_size()) {
        job_.axes = from.spline.axes();
        job_.dim = from.spline.dim();
        job_.order = order_;
        job_.even = !(from.spline.all_weights().largest > 4 * from.spline.all_weights().smallest);
        job_.sources = sources_.data();
        for (size_t k = 0; k < axes(); ++k) {
            sources_[k].take_work(scratch_);
            job_.values[k] = scratch_.take_aligned(block_values(k));
            job_.points[k] = points_[k];
        }
        job_.work = scratch_.take(2 * static_cast<size_t>(job_.dim));
        job_.slopes = order_ > 0 ? slopes_ : nullptr;
        choose_arrays();
    }

    void run() noexcept {
        start();
        for (int64_t i = 0; i < from_.params.count; i += axis_block_size) {
            add_block(i, std::min(axis_block_size, from_.params.count - i));
        }
        for (int64_t i = 0; job_.whole && i < from_.spline.point_count(); ++i) {
            store(i, i);
        }
    }

private:
    [[nodiscard]] size_t axes() const noexcept { return static_cast<size_t>(from_.spline.axes()); }
    [[nodiscard]] size_t block_values(size_t k) const noexcept {
        return static_cast<size_t>(axis_block_size * sources_[k].values_size(order_));
    }
    [[nodiscard]] size_t scratch_size() const noexcept {
        size_t size = 2 * static_cast<size_t>(from_.spline.dim());
        for (size_t k = 0; k < axes(); ++k) {
            size += block_values(k) + Scratch::line + sources_[k].work_size;
        }
        return size;
    }
    static ConstRecords part(ConstRecords all, int64_t first, int64_t count) noexcept {
        return {all.record(first), count, all.width, all.stride, all.component_stride};
    }
    [[nodiscard]] bool to_net() const noexcept {
        return out_.points.data != nullptr || out_.weights.data != nullptr;
    }

    void choose_arrays() {
        int64_t active = 1;
        for (size_t k = 0; k < axes(); ++k) {
            active *= sources_[k].degree + 1;
        }
        const int64_t all = from_.spline.point_count();
        job_.whole = from_.params.count >= all / (4 * active) || (to_net() && !from_.accumulate);
        int64_t stride = 1;
        for (size_t k = axes(); k-- > 0;) {
            job_.strides[k] = stride;
            stride *= job_.whole ? from_.spline.count(static_cast<int>(k)) : sources_[k].degree + 1;
        }
        job_.size = (job_.whole ? all : active) + NetJob::padding;
        make_arrays();
    }

    void make_arrays() {
        const bool points = out_.points.data != nullptr, weights = out_.weights.data != nullptr;
        const bool products = weights || order_ > 0;
        const int64_t components =
            (points ? job_.dim : 0) + (weights ? 1 : 0) + (rational_ ? 1 : 0) + (products ? job_.dim : 0);
        arrays_.resize(static_cast<size_t>(checked_product(components, job_.size, "gradients")));
        double *next = arrays_.data();
        const auto take = [&](int64_t size, bool wanted) {
            double *own = wanted ? next : nullptr;
            next += wanted ? size * job_.size : 0;
            return own;
        };
        job_.grad_points = take(job_.dim, points);
        job_.grad_weights = take(1, weights);
        job_.weights = weights_ = take(1, rational_);
        job_.coordinates = coordinates_ = take(job_.dim, products);
    }

    void start() noexcept {
        for (int64_t i = 0; job_.whole && i < from_.spline.point_count(); ++i) {
            load(i, i);
        }
    }

    // Loads the data of control point `point` to index `at` of the arrays.
    void load(int64_t point, int64_t at) noexcept {
        for (int c = 0; from_.accumulate && job_.grad_points != nullptr && c < job_.dim; ++c) {
            job_.grad_points[c * job_.size + at] = out_.points(point, c);
        }
        if (from_.accumulate && job_.grad_weights != nullptr) {
            job_.grad_weights[at] = out_.weights(point, 0);
        }
        if (rational_) {
            weights_[at] = from_.spline.weight(point);
        }
        for (int c = 0; coordinates_ != nullptr && c < job_.dim; ++c) {
            coordinates_[c * job_.size + at] = from_.spline.coordinate(point, c);
        }
    }
    void store(int64_t point, int64_t at) const noexcept {
        for (int c = 0; job_.grad_points != nullptr && c < job_.dim; ++c) {
            out_.points(point, c) = job_.grad_points[c * job_.size + at];
        }
        if (job_.grad_weights != nullptr) {
            out_.weights(point, 0) = job_.grad_weights[at];
        }
    }

    void add_block(int64_t first, int64_t count) noexcept {
        const ConstRecords cotangents = part(from_.values, first, count);
        const bool special = find_net_bases(job_, part(from_.params, first, count));
        if (job_.whole) {
            add_to_net(job_, cotangents, 0, count);
        }
        for (int64_t i = 0; !job_.whole && i < count; ++i) {
            for_each_active(i, [&](int64_t point, int64_t at) { load(point, at); });
            add_to_net(job_, cotangents, i, 1);
            for_each_active(i, [&](int64_t point, int64_t at) { store(point, at); });
        }
        if (order_ > 0) {
            special || clamps_ ? add_each_slope(first, count) : add_slopes(first, count);
        }
    }

    void add_slopes(int64_t first, int64_t count) const noexcept {
        const double *slope = slopes_;
        for (int64_t i = 0; i < count; ++i) {
            double *out = out_.params.record(first + i);
            for (int k = 0; k < job_.axes; ++k, out += out_.params.component_stride) {
                *out = from_.accumulate ? *out + *slope++ : *slope++;
            }
        }
    }
    // Adds the slopes after correcting them: 0 for parameters that were moved to an end of the domain, NaN
    // for all parameters of a point that gives NaN.
    void add_each_slope(int64_t first, int64_t count) noexcept {
        for (int64_t i = 0; i < count; ++i) {
            const bool valid = has_value(i);
            for (int k = 0; k < job_.axes; ++k) {
                double &slope = slopes_[i * job_.axes + k];
                slope = !valid                         ? std::numeric_limits<double>::quiet_NaN()
                        : clamped(from_, first + i, k) ? 0
                                                       : slope;
            }
        }
        add_slopes(first, count);
    }
    [[nodiscard]] bool has_value(int64_t i) const noexcept {
        bool valid = true;
        for (size_t k = 0; k < axes(); ++k) {
            valid = valid && points_[k][i].valid();
        }
        return valid;
    }

    // Calls visit(control point, its index among the active ones) for all active control points of parameter
    // i; for none if the parameter gives NaN.
    template <class Visit>
    void for_each_active(int64_t i, Visit &&visit) const {
        if (!has_value(i)) {
            return;
        }
        std::array<int64_t, max_axes> first{}, sizes{1, 1, 1}, counts{1, 1, 1};
        for (size_t k = 0; k < axes(); ++k) {
            first[k] = points_[k][i].first;
            sizes[k] = sources_[k].degree + 1;
            counts[k] = from_.spline.count(static_cast<int>(k));
        }
        for (int64_t at = 0; at < sizes[0] * sizes[1] * sizes[2]; ++at) {
            const int64_t row = at / sizes[2], u = first[0] + row / sizes[1], v = first[1] + row % sizes[1];
            visit((u * counts[1] + v) * counts[2] + first[2] + at % sizes[2], at);
        }
    }

    Cotangents from_;
    Gradients out_;
    bool rational_;
    bool clamps_; // parameters may have been moved to an end
    int order_;   // of derivatives of the basis functions
    int64_t uses_;
    AxisSources sources_;
    Scratch scratch_;
    AxisPoint points_[max_axes][axis_block_size];
    double slopes_[axis_block_size * max_axes];
    NetJob job_{};
    std::vector<double> arrays_;
    double *weights_ = nullptr;
    double *coordinates_ = nullptr;
};

} // namespace

void points_adjoint(const Cotangents &from, const Gradients &out) {
    PointsAdjoint(from, out).run();
}

} // namespace nrb::eval

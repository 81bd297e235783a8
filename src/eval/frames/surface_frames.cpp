// SPDX-License-Identifier: MIT
#include "eval/frames/surface_frames.h"

#include "base/numbers.h"
#include "eval/blocks.h"
#include "eval/derivative_errors.h"
#include "eval/frames/single_frame.h"
#include "eval/frames/surface_limit.h"
#include "eval/frames/waiting_outputs.h"
#include "eval/kernels/normal_kernel.h"
#include "eval/kernels/triple_stream.h"

#include <bit>

namespace nrb::eval {

namespace {

// The parameters of point i of a list.
class ListParameters {
public:
    explicit ListParameters(ConstRecords params) : params_(params) {}
    [[nodiscard]] std::array<double, 2> operator()(int64_t i) const noexcept {
        return {params_(i, 0), params_(i, 1)};
    }
    [[nodiscard]] int64_t count() const noexcept { return params_.count; }

private:
    ConstRecords params_;
};

// The parameters of point i of a grid, axis 1 fastest.
class GridParameters {
public:
    explicit GridParameters(const std::array<ConstRecords, max_axes> &params) : params_(params) {}
    [[nodiscard]] std::array<double, 2> operator()(int64_t i) const noexcept {
        return {params_[0](i / params_[1].count, 0), params_[1](i % params_[1].count, 0)};
    }
    [[nodiscard]] int64_t count() const noexcept { return params_[0].count * params_[1].count; }

private:
    std::array<ConstRecords, max_axes> params_;
};

// Computes the normals of each block. Nearly all points are finished by the kernel. Points whose normal may
// not be regular are examined one by one; the normal of a point that turns out to be regular is still the
// kernel's, so that it does not depend on the batch.
template <class Parameters>
class FrameSink final : public BlockSink {
public:
    FrameSink(const Spline &spline, const AxisRules &rules, const Parameters &params,
              const SurfaceFrames &out)
        : spline_(spline), rules_(rules), params_(params), out_(out), points_(out_.points, large()),
          du_(out_.du, large()), dv_(out_.dv, large()), normal_stream_(out_.normals, large()) {
        if (out.normals.data != nullptr || out.status != nullptr) {
            Jet::prepare(spline);
            errors_ = derivative_errors(spline, rules, params.count());
        }
    }

    void operator()(int64_t first, ConstRecords values) noexcept override {
        const double *du = values.data + space_dim * block_size;
        const double *dv = du + space_dim * block_size;
        points_.write(values.data, first, values.count);
        du_.write(du, first, values.count);
        dv_.write(dv, first, values.count);
        if (out_.normals.data != nullptr || out_.status != nullptr) {
            normals(first, values.count, du, dv);
        }
    }

private:
    void normals(int64_t first, int64_t count, const double *du, const double *dv) noexcept {
        if (out_.status != nullptr) {
            std::fill_n(out_.status + first, count, 0);
        }
        uint64_t doubtful = unit_normals(du, dv, count, errors_.u, errors_.v, normals_.data());
        for (; doubtful != 0; doubtful &= doubtful - 1) {
            const int64_t i = std::countr_zero(doubtful);
            look_closer(first, i, row_vector(du, space_dim, i), row_vector(dv, space_dim, i));
        }
        normal_stream_.write(normals_.data(), first, count);
    }

    // Examines a doubtful point with a jet, and replaces its normal where it is a limit, undefined or out of
    // range.
    void look_closer(int64_t first, int64_t i, const Vector3 &du, const Vector3 &dv) noexcept {
        const std::array<double, 2> param = params_(first + i);
        const SurfaceNormal normal = surface_normal(spline_, rules_, param.data());
        switch (normal.kind) {
        case NormalKind::regular: {
            const Vector3 product = cross(du, dv);
            if (!in_range(dot(product, product))) {
                replace(i, unit(cross(scaled_to_one(du), scaled_to_one(dv))));
            }
            return;
        }
        case NormalKind::limit:
            replace(i, normal.direction);
            return write_status(frame_limit, first + i, out_.status);
        case NormalKind::undefined:
            replace(i, {nan_value, nan_value, nan_value});
            return write_status(frame_undefined, first + i, out_.status);
        }
    }

    void replace(int64_t i, const Vector3 &normal) noexcept {
        const auto at = static_cast<size_t>(i);
        normals_[at] = normal.x;
        normals_[at + block_size] = normal.y;
        normals_[at + 2 * block_size] = normal.z;
    }

    [[nodiscard]] bool large() const noexcept {
        int64_t arrays = 0;
        for (const Records *out : {&out_.points, &out_.du, &out_.dv, &out_.normals}) {
            arrays += out->data != nullptr ? 1 : 0;
        }
        return TripleStream::are_large(arrays * space_dim * params_.count());
    }

    const Spline &spline_;
    const AxisRules &rules_;
    Parameters params_;
    SurfaceFrames out_;
    TripleStream points_;
    TripleStream du_;
    TripleStream dv_;
    TripleStream normal_stream_;
    DerivativeErrors errors_;
    std::array<double, space_dim * block_size> normals_{};
};

void frames_of_usual_size(const Spline &spline, const AxisRules &rules, ConstRecords params,
                          const SurfaceFrames &out) {
    FrameSink sink(spline, rules, ListParameters(params), out);
    evaluate_points(spline, rules, 1, params, sink);
}

void frames_of_usual_size(const Spline &spline, const AxisRules &rules,
                          const std::array<ConstRecords, max_axes> &params, const SurfaceFrames &out) {
    FrameSink sink(spline, rules, GridParameters(params), out);
    evaluate_grid(spline, rules, 1, params, sink);
}

// Normals are computed run by run at usual magnitude. Points and derivatives, of whatever size, are written
// as evaluation returns them.
template <class Params>
void frames_of_any_size(const Spline &spline, const AxisRules &rules, ConstRecords list, const Params &params,
                        const SurfaceFrames &out) {
    WaitingOutputs waiting({{out.normals}}, out.status, list.count);
    std::vector<int64_t> order;
    if (out.normals.data != nullptr || out.status != nullptr) {
        order = for_each_magnitude(spline, rules, list, [&](const MagnitudeRun &run) {
            frames_of_usual_size(run.spline, run.rules, run.params,
                                 {{}, {}, {}, waiting.part(0, run), waiting.status(run)});
        });
    }
    if (out.points.data != nullptr || out.du.data != nullptr || out.dv.data != nullptr) {
        frames_of_usual_size(spline, rules, params, SurfaceFrames{out.points, out.du, out.dv, {}, nullptr});
    }
    waiting.write(order);
}

// The list of all combinations of the parameters of a grid, axis 1 fastest.
std::vector<double> list_of(const std::array<ConstRecords, max_axes> &params) {
    const GridParameters grid(params);
    std::vector<double> list;
    for (int64_t i = 0; i < grid.count(); ++i) {
        const std::array<double, 2> at = grid(i);
        list.insert(list.end(), at.begin(), at.end());
    }
    return list;
}

} // namespace

void surface_frames(const Spline &spline, const AxisRules &rules, ConstRecords params,
                    const SurfaceFrames &out) {
    const bool usual = usual_magnitude(spline);
    if (params.count == 1) { // first, because it may fail, and a failing call must write nothing
        keep_single_frame_tables(spline);
    }
    usual ? frames_of_usual_size(spline, rules, params, out)
          : frames_of_any_size(spline, rules, params, params, out);
}

void surface_frames(const Spline &spline, const AxisRules &rules,
                    const std::array<ConstRecords, max_axes> &params, const SurfaceFrames &out) {
    if (usual_magnitude(spline)) {
        return frames_of_usual_size(spline, rules, params, out);
    }
    const std::vector<double> list = list_of(params);
    frames_of_any_size(spline, rules, {list.data(), std::ssize(list) / 2, 2, 2, 1}, params, out);
}

} // namespace nrb::eval

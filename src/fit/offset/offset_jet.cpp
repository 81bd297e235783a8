// SPDX-License-Identifier: MIT
#include "fit/offset/offset_jet.h"

#include "base/error.h"
#include "eval/evaluate.h"

namespace nrb::fit {

namespace {

// S_u and S_v are needed up to their second derivatives along both axes.
constexpr int order = 2 * taylor_order + 1;
constexpr int64_t slots = (order + 1) * (order + 2) / 2;

// d^(i + j) S / du^i dv^j is record number (i + j)(i + j + 1) / 2 + j.
Vector3 derivative(const double *records, size_t i, size_t j) noexcept {
    const size_t total = i + j;
    const double *x = records + (total * (total + 1) / 2 + j) * space_dim;
    return {x[0], x[1], x[2]};
}

// The Taylor polynomial of the derivative of S of order `first` along u and `second` along v.
TaylorVector taylor_of(const double *records, size_t first, size_t second) noexcept {
    constexpr double factorials[Taylor::count] = {1, 1, 2};
    TaylorVector made;
    for (size_t i = 0; i < Taylor::count; ++i) {
        for (size_t j = 0; j < Taylor::count; ++j) {
            made.set(i, j, 1 / (factorials[i] * factorials[j]) * derivative(records, i + first, j + second));
        }
    }
    return made;
}

} // namespace

std::vector<TaylorVector> offset_jets(const Spline &surface, double distance,
                                      const std::array<std::vector<double>, 2> &params,
                                      const std::array<bool, 2> &left) {
    eval::AxisRules rules{};
    std::array<ConstRecords, max_axes> axes{};
    for (size_t k = 0; k < 2; ++k) {
        rules[k].left = left[k];
        axes[k] = {params[k].data(), std::ssize(params[k]), 1, 1, 1};
    }
    const int64_t count = axes[0].count * axes[1].count;
    std::vector<double> records(static_cast<size_t>(count * slots * space_dim));
    eval::evaluate_grid(surface, rules, order, axes,
                        {records.data(), count, slots * space_dim, slots * space_dim, 1});
    std::vector<TaylorVector> jets;
    jets.reserve(static_cast<size_t>(count));
    for (int64_t i = 0; i < count; ++i) {
        const double *at = records.data() + i * slots * space_dim;
        const TaylorVector s_u = taylor_of(at, 1, 0), s_v = taylor_of(at, 0, 1);
        const Vector3 u = s_u.at(0, 0), v = s_v.at(0, 0);
        if (!(length(cross(u, v)) > least_sine * length(u) * length(v))) {
            fail(Status::unsupported, "the surface has no normal at (%s, %s), where its offset is not known",
                 Number(params[0][static_cast<size_t>(i / axes[1].count)]).text,
                 Number(params[1][static_cast<size_t>(i % axes[1].count)]).text);
        }
        jets.push_back(moved(taylor_of(at, 0, 0), distance, unit(cross(s_u, s_v))));
    }
    return jets;
}

} // namespace nrb::fit

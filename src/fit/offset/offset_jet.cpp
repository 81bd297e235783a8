// SPDX-License-Identifier: MIT
#include "fit/offset/offset_jet.h"

#include "base/error.h"
#include "eval/evaluate.h"

namespace nrb::fit {

namespace {

constexpr int order = 3;
constexpr int64_t slots = 10; // of two axes
enum Slot { point, u, v, uu, uv, vv, uuu, uuv, uvv };

class Derivatives {
public:
    explicit Derivatives(const double *records) noexcept : records_(records) {}
    Vector3 operator()(Slot slot) const noexcept {
        const double *x = records_ + slot * space_dim;
        return {x[0], x[1], x[2]};
    }

private:
    const double *records_;
};

OffsetJet jet_of(const Derivatives &s, double distance) noexcept {
    const Vector3 n = cross(s(u), s(v)), n_u = cross(s(uu), s(v)) + cross(s(u), s(uv)),
                  n_v = cross(s(uv), s(v)) + cross(s(u), s(vv));
    const Vector3 n_uv = cross(s(uuv), s(v)) + cross(s(uu), s(vv)) + cross(s(u), s(uvv));
    const double l = length(n);
    const Vector3 unit = (1 / l) * n;
    const double l_u = dot(unit, n_u), l_v = dot(unit, n_v);
    const Vector3 unit_u = (1 / l) * (n_u - l_u * unit), unit_v = (1 / l) * (n_v - l_v * unit);
    const double l_uv = (dot(n_u, n_v) + dot(n, n_uv) - l_u * l_v) / l;
    const Vector3 unit_uv = (1 / l) * (n_uv - l_u * unit_v - l_v * unit_u - l_uv * unit);
    return {s(point) + distance * unit, s(u) + distance * unit_u, s(v) + distance * unit_v,
            s(uv) + distance * unit_uv};
}

} // namespace

std::vector<OffsetJet> offset_jets(const Spline &surface, double distance,
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
    std::vector<OffsetJet> jets;
    jets.reserve(static_cast<size_t>(count));
    for (int64_t i = 0; i < count; ++i) {
        const Derivatives s(records.data() + i * slots * space_dim);
        if (!(length(cross(s(u), s(v))) > least_sine * length(s(u)) * length(s(v)))) {
            fail(Status::unsupported, "the surface has no normal at (%s, %s), where its offset is not known",
                 Number(params[0][static_cast<size_t>(i / axes[1].count)]).text,
                 Number(params[1][static_cast<size_t>(i % axes[1].count)]).text);
        }
        jets.push_back(jet_of(s, distance));
    }
    return jets;
}

} // namespace nrb::fit

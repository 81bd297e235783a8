// SPDX-License-Identifier: MIT
#include "closest/patch/critical/critical_kind.h"

#include "base/numbers.h"
#include "numeric/norm.h"
#include "numeric/solvers/small_systems.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::closest {

namespace {

constexpr std::array along{0.0, 0.25, 0.5, 0.75, 1.0}; // sample positions on an axis

// Accumulates the signs of slopes and second derivatives.
class Signs {
public:
    void add(double value, double error) noexcept {
        rises_ = rises_ && value > error;
        falls_ = falls_ && value < -error;
        open_ = open_ || !(std::abs(value) > error);
    }
    [[nodiscard]] int32_t kind() const noexcept {
        return rises_   ? critical_minimum
               : falls_ ? critical_maximum
               : open_  ? critical_undecided
                        : critical_saddle;
    }

private:
    bool rises_ = true, falls_ = true, open_ = false;
};

// Whether the line of parameters through a place along an axis is mapped to one point.
bool is_point(const CriticalQuery &query, const PatchItem &whole, AxisValues at, size_t axis) {
    const std::vector<double> first = query.point(whole, at);
    return std::all_of(along.begin(), along.end(), [&](double t) {
        at[axis] = t;
        return query.apart(first, query.point(whole, at)) <= 64 * query.noise();
    });
}

// For a line of parameters that is one point: whether the distance is critical in all directions that meet
// there.
bool is_critical_point(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                       AxisValues at, size_t axis) {
    const PatchJet here = query.descent().jet(whole.values, at);
    return std::all_of(along.begin(), along.end(), [&](double t) {
        at[axis] = t;
        const PatchJet jet = query.descent().jet(whole.values, at);
        bool critical = true;
        const auto axes = static_cast<size_t>(query.shape().axes);
        for (size_t j = 0; j < axes; ++j) { // where an edge collapses, the point is like a corner
            critical = critical && (face.side[j] < 0 || jet.gradient[j] * here.gradient[j] > 0);
        }
        for (int l = 0; l < face.shape.axes; ++l) {
            const size_t j = face.shape_axis(l);
            const double noise =
                64 * query.noise() * std::sqrt(jet.metric[j][j]) + query.noise() * query.noise();
            critical = critical && std::abs(jet.gradient[j]) <= noise;
        }
        return critical;
    });
}

// The second derivatives along the face with respect to unit tangents; 0 where a tangent vanishes.
AxisMatrix unit_hessian(const PatchFace &face, const PatchJet &jet, double noise) {
    AxisMatrix hessian{};
    for (int k = 0; k < face.shape.axes; ++k) {
        for (int l = 0; l < face.shape.axes; ++l) {
            const size_t i = face.shape_axis(k), j = face.shape_axis(l);
            const double scale = std::sqrt(jet.metric[i][i] * jet.metric[j][j]);
            hessian[static_cast<size_t>(k)][static_cast<size_t>(l)] =
                scale > noise * noise ? (jet.metric[i][j] + jet.curvature[i][j]) / scale : 0.0;
        }
    }
    return hessian;
}

void add_bends(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
               const AxisValues &at, const PatchJet &jet, Signs &signs) {
    const int n = face.shape.axes;
    const AxisMatrix hessian = unit_hessian(face, jet, query.noise());
    double trace = 0;
    bool vanishes = false;
    for (int k = 0; k < n; ++k) {
        const double bend = hessian[static_cast<size_t>(k)][static_cast<size_t>(k)];
        trace += std::abs(bend);
        vanishes = vanishes || (bend == 0 && is_point(query, whole, at, face.shape_axis(k)));
    }
    if (vanishes && n == 1) { // along a collapsed edge, second derivatives say nothing
        return;
    }
    const AxisVector values = symmetric_eigenvalues(n, hessian);
    std::for_each_n(values.begin(), n, [&](double value) { signs.add(value, 1e4 * eps * (1 + trace)); });
}

} // namespace

int32_t kind_at(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                const AxisValues &at) {
    const PatchJet jet = query.descent().jet(whole.values, at);
    const double noise = query.noise();
    Signs signs;
    for (size_t i = 0; i < static_cast<size_t>(query.shape().axes); ++i) {
        if (face.side[i] >= 0) {
            const double inwards = face.side[i] == 0 ? jet.gradient[i] : -jet.gradient[i];
            signs.add(inwards, 8 * noise * std::sqrt(jet.metric[i][i]) + noise * noise);
        }
    }
    if (face.shape.axes > 0) {
        add_bends(query, face, whole, at, jet, signs);
    }
    return signs.kind();
}

bool is_critical(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                 const AxisValues &at) {
    const PatchJet here = query.descent().jet(whole.values, at);
    double largest = 0;
    for (int k = 0; k < face.shape.axes; ++k) {
        const size_t i = face.shape_axis(k);
        largest = std::max(largest, here.metric[i][i]);
    }
    for (int k = 0; k < face.shape.axes; ++k) {
        const size_t i = face.shape_axis(k);
        if (here.metric[i][i] <= eps * largest && is_point(query, whole, at, i) &&
            !is_critical_point(query, face, whole, at, i)) {
            return false;
        }
    }
    return true;
}

} // namespace nrb::closest

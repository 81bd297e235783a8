// SPDX-License-Identifier: MIT
// The caller's description of a spline: axes in one of several knot conventions, and control points with
// optional weights.
#pragma once

#include "checks.h"

#include <array>
#include <utility>
#include <vector>

namespace nrb::capi {

struct AxisData {
    int32_t degree;
    int64_t count;
    bool periodic;
};

class AxesData {
public:
    // Checks degrees, counts and creation flags.
    AxesData(int32_t axes, const int32_t *degrees, const int64_t *counts, uint32_t flags);
    // Bezier form: degree + 1 control points along each axis.
    AxesData(int32_t axes, const int32_t *degrees);

    [[nodiscard]] int size() const noexcept { return size_; }
    [[nodiscard]] const AxisData &operator[](int k) const noexcept { return axes_[static_cast<size_t>(k)]; }
    [[nodiscard]] int64_t point_count() const;
    // The sum of counts[k] + degrees[k] + extra.
    [[nodiscard]] int64_t knot_total(int extra) const;

    // The axes, from an array of full knot vectors, one axis after the other.
    [[nodiscard]] Spline::Axes with_knots(const double *knots, int64_t knot_count) const;

    // knots_of(axis, index, offset) returns the full knot vector of an axis, and the index that messages give
    // to its first knot, in the caller's array. `offset` is the number of knots of the axes before, each of
    // which has count + degree + extra.
    template <class KnotsOf>
    [[nodiscard]] Spline::Axes make(KnotsOf &&knots_of, int extra) const {
        Spline::Axes axes;
        int64_t offset = 0;
        for (int k = 0; k < size_; ++k) {
            const AxisData &axis = (*this)[k];
            auto [knots, first] = knots_of(axis, k, offset);
            axes.push_back(make_knot_vector(axis.degree, std::move(knots), axis.periodic, k, first));
            offset += axis.count + axis.degree + extra;
        }
        return axes;
    }

private:
    int size_;
    std::array<AxisData, max_axes> axes_{};
};

// Whether axis k is flagged NURBS_PERIODIC. Throws NURBS_ERROR_FLAGS for other flags.
bool decode_periodic(uint32_t flags, int32_t axes, int k);

// A packed copy of the records, with capacity for the padding of a spline.
std::vector<double> packed(ConstRecords view);
// Packed records for reading: those of the caller if they are packed, else a copy in `room`.
std::span<const double> packed(ConstRecords view, std::vector<double> &room);

struct PointsData {
    int32_t dim;
    const double *points;
    int64_t stride;
    int64_t component_stride;
    const double *weights;
    int64_t weight_stride;

    // `kept`: the weights if the caller gives none. Without either the spline is polynomial.
    [[nodiscard]] SplinePtr make(Spline::Axes axes, int64_t count, std::vector<double> kept = {}) const;
    [[nodiscard]] SplinePtr make_homogeneous(Spline::Axes axes, int64_t count) const;
};

} // namespace nrb::capi

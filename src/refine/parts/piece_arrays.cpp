// SPDX-License-Identifier: MIT
#include "refine/parts/piece_arrays.h"

#include "base/checked.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/cut.h"
#include "refine/parts/piece_order.h"

#include <algorithm>
#include <array>
#include <utility>

namespace nrb::refine {

namespace {

PieceOrder order_of(const Spline &spline) {
    std::array<PieceOrder::Axis, max_axes> axes{};
    for (int k = 0; k < spline.axes(); ++k) {
        axes[static_cast<size_t>(k)] = {spline.axis(k).spans().size(), spline.axis(k).degree() + 1};
    }
    return PieceOrder({axes.data(), static_cast<size_t>(spline.axes())});
}

// The weights of a net in homogeneous form, as an array.
std::vector<double> weights_of(const Spline &whole) {
    std::vector<double> weights(static_cast<size_t>(whole.point_count()));
    for (int64_t i = 0; i < whole.point_count(); ++i) {
        weights[static_cast<size_t>(i)] = whole.weight(i);
    }
    return weights;
}

void write_weights(const Spline &whole, const PieceOrder &order, double *weights) {
    switch (whole.form()) {
    case Form::polynomial:
        std::fill_n(weights, whole.point_count(), 1.0);
        break;
    case Form::rational:
        order.take_apart(1, whole.weights().data(), weights);
        break;
    case Form::homogeneous:
        order.take_apart(1, weights_of(whole).data(), weights);
    }
}

void write_points(const Spline &whole, const PieceOrder &order, double *points) {
    if (whole.form() == Form::homogeneous) {
        order.take_apart(whole.dim(), cartesian_points(whole).data(), points);
    } else {
        order.take_apart(whole.dim(), whole.points().data(), points);
    }
}

void write_domains(const Spline &spline, int64_t pieces, double *domains) {
    for (int64_t i = 0; i < pieces; ++i) {
        const Part part = domain_of_piece(spline, i);
        for (size_t k = 0; std::cmp_less(k, spline.axes()); ++k) {
            *domains++ = part[k].lower;
            *domains++ = part[k].upper;
        }
    }
}

} // namespace

int64_t count_pieces(const Spline &spline) {
    int64_t pieces = 1;
    for (int k = 0; k < spline.axes(); ++k) {
        pieces = checked_product(pieces, spline.axis(k).spans().size(), "pieces");
    }
    return pieces;
}

Part domain_of_piece(const Spline &spline, int64_t index) {
    Part part{};
    for (int k = spline.axes(); k-- > 0;) {
        const std::span<const double> breaks = spline.axis(k).spans().breaks();
        const auto spans = breaks.size() - 1, at = static_cast<size_t>(index) % spans;
        part[static_cast<size_t>(k)] = {breaks[at], breaks[at + 1]};
        index /= static_cast<int64_t>(spans);
    }
    return part;
}

int64_t points_of_piece(const Spline &spline) noexcept {
    int64_t points = 1;
    for (int k = 0; k < spline.axes(); ++k) {
        points *= spline.axis(k).degree() + 1;
    }
    return points;
}

void write_pieces(const SplinePtr &spline, const PieceArrays &arrays) {
    const PieceOrder order = order_of(*spline);
    if (arrays.points != nullptr || arrays.weights != nullptr) {
        const PartedSpline pieces = bezier_pieces(spline);
        if (arrays.points != nullptr) {
            write_points(pieces.whole(), order, arrays.points);
        }
        if (arrays.weights != nullptr) {
            write_weights(pieces.whole(), order, arrays.weights);
        }
    }
    if (arrays.domains != nullptr) {
        write_domains(*spline, count_pieces(*spline), arrays.domains);
    }
}

} // namespace nrb::refine

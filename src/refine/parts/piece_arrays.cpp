// SPDX-License-Identifier: MIT
#include "refine/parts/piece_arrays.h"

#include "base/checked.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/cut.h"
#include "refine/parts/piece_order.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace nrb::refine {

namespace {

PieceOrder order_of(const Spline &spline) {
    std::array<PieceOrder::Axis, max_axes> axes{};
    for (int k = 0; k < spline.axes(); ++k) {
        axes[static_cast<size_t>(k)] = {spline.axis(k).spans().size(), spline.axis(k).degree() + 1};
    }
    return PieceOrder({axes.data(), static_cast<size_t>(spline.axes())});
}

// The points and weights of a net, copied where it is homogeneous and they are wanted.
class NetArrays {
public:
    NetArrays(const Spline &whole, bool with_points, bool with_weights)
        : whole_(whole), homogeneous_(whole.form() == Form::homogeneous) {
        if (homogeneous_ && with_points) {
            points_ = cartesian_points(whole);
        }
        for (int64_t i = 0; homogeneous_ && with_weights && i < whole.point_count(); ++i) {
            weights_.push_back(whole.weight(i));
        }
    }

    void write_points(const PieceOrder &order, double *points) const noexcept {
        order.take_apart(whole_.dim(), homogeneous_ ? points_.data() : whole_.points().data(), points);
    }
    void write_weights(const PieceOrder &order, double *weights) const noexcept {
        if (whole_.rational()) {
            order.take_apart(1, homogeneous_ ? weights_.data() : whole_.weights().data(), weights);
        } else {
            std::fill_n(weights, whole_.point_count(), 1.0);
        }
    }

private:
    const Spline &whole_;
    bool homogeneous_;
    std::vector<double> points_;
    std::vector<double> weights_;
};

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
        const NetArrays net(pieces.whole(), arrays.points != nullptr, arrays.weights != nullptr);
        if (arrays.points != nullptr) {
            net.write_points(order, arrays.points);
        }
        if (arrays.weights != nullptr) {
            net.write_weights(order, arrays.weights);
        }
    }
    if (arrays.domains != nullptr) {
        write_domains(*spline, count_pieces(*spline), arrays.domains);
    }
}

} // namespace nrb::refine

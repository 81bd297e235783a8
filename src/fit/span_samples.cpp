// SPDX-License-Identifier: MIT
#include "fit/span_samples.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "basis/bspline.h"
#include "numeric/solvers/banded_least_squares.h"
#include "reduce/layers.h"
#include "refine/algebra/polynomial.h"
#include "spline/axis_view.h"
#include "spline/layer_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::fit {

namespace {

double chebyshev(double i, int degree) noexcept {
    const double x = std::sin(std::numbers::pi * i / (2.0 * degree));
    return x * x;
}

} // namespace

LocalNodes::LocalNodes(int degree) {
    if (degree == 0) {
        nodes_ = all_ = {0.5};
        return;
    }
    for (int i = 0; i <= 2 * degree; ++i) {
        all_.push_back(i == 2 * degree ? 1 : chebyshev(i / 2.0, degree));
        if (i % 2 == 0) {
            nodes_.push_back(all_.back());
        }
    }
}

namespace {

// The collocation matrix with a row for each place of every span.
LayerTable sampling_table(const KnotVector &axis, const std::vector<double> &places) {
    LayerTable table;
    double values[max_basis];
    for (const int64_t span : axis.spans().indices()) {
        const double from = axis[span], to = axis[span + 1];
        for (const double x : places) {
            const double t = x == 1 ? to : std::min(to, from + x * (to - from));
            count_work(int64_t{axis.degree() + 1} * (axis.degree() + 1));
            basis_values(axis.knots().data(), axis.degree(), span, t, values);
            table.add_row(span - axis.degree(), values, axis.degree() + 1);
        }
    }
    return table;
}

// An axis of degree 0, whose layers of control points are its values.
KnotVectorPtr index_axis(int64_t rows) {
    std::vector<double> knots(static_cast<size_t>(rows) + 1);
    for (size_t i = 0; i < knots.size(); ++i) {
        knots[i] = static_cast<double>(i);
    }
    return std::make_shared<const KnotVector>(0, std::move(knots));
}

SplinePtr applied(const Spline &spline, int k, const LayerTable &table) {
    Net net = apply_along(spline, k, table);
    Spline::Axes axes = spline.knot_vectors();
    axes[static_cast<size_t>(k)] = index_axis(table.rows());
    return refine::polynomial_spline(std::move(axes), spline.dim(), std::move(net.points));
}

} // namespace

SplinePtr sampled(const Spline &spline, const Places &places) {
    SplinePtr values = applied(spline, 0, sampling_table(spline.axis(0), places[0]));
    for (int k = 1; k < spline.axes(); ++k) {
        values = applied(*values, k, sampling_table(spline.axis(k), places[static_cast<size_t>(k)]));
    }
    return values;
}

namespace {

// The least-squares fit of the control points of an axis to samples along it.
class AxisFit {
public:
    // Along axis k there are `places` layers of samples for each span; node j of a span is number stride * j
    // of them.
    AxisFit(const Spline &samples, int k, const KnotVector &axis, const LocalNodes &nodes, size_t places,
            size_t stride)
        : samples_(samples), view_(axis_view(samples, k, samples.dim())), axis_(axis),
          nodes_(std::ssize(nodes.nodes())), places_(static_cast<int64_t>(places)),
          stride_(static_cast<int64_t>(stride)), length_(view_.outer * view_.inner),
          columns_(axis.distinct_layers()), table_(sampling_table(axis, nodes.nodes())),
          system_(columns_, axis.degree() + 1,
                  axis.periodic() ? static_cast<int>(std::min<int64_t>(columns_, axis.degree() + 1)) : 0,
                  length_),
          right_(static_cast<size_t>(length_)) {}

    // Returns the control points, [distinct_layers()][length of a layer].
    std::vector<double> run() {
        int64_t anchored = 0;
        for (int64_t r = 0; r < table_.rows(); ++r) {
            const LayerTable::Row &row = table_.row(r);
            const int64_t sample = r / nodes_ * places_ + r % nodes_ * stride_;
            for (const int64_t end = reached(r); anchored < end; ++anchored) {
                add(anchor, {anchored, 0, 0}, sample);
            }
            add(row.size == 0 ? pin : 1, row, sample);
        }
        std::vector<double> layers;
        grow_watched(layers, static_cast<size_t>(columns_ * length_));
        if (!system_.solve(layers.data())) {
            fail(Status::not_representable, "the knots lie too close for degree %d", axis_.degree());
        }
        return layers;
    }

private:
    static constexpr double anchor = eps; // weight of an anchor: moves no image by more than that
    static constexpr double pin = 0x1p30; // weight of values to be met: its square is beyond others' rounding

    // One past the last layer that acts on the span of row r or before it; all layers at the last row.
    [[nodiscard]] int64_t reached(int64_t r) const {
        const int64_t span = axis_.spans().indices()[static_cast<size_t>(r / nodes_)];
        return r + 1 == table_.rows() ? columns_ : std::min(span + 1, columns_);
    }

    void add(double factor, const LayerTable::Row &row, int64_t sample) {
        count_work(2 * length_);
        static constexpr double copied = 1;
        const double *const entries = row.size == 0 ? &copied : table_.coefficients(row);
        for (int i = 0; i < std::max(row.size, 1); ++i) {
            system_.enter((row.first + i) % columns_, factor * entries[i]);
        }
        double *right = right_.data();
        for (int64_t o = 0; o < view_.outer; ++o) {
            const double *from = samples_.points().data() + (o * view_.count + sample) * view_.inner;
            right =
                std::transform(from, from + view_.inner, right, [factor](double x) { return factor * x; });
        }
        system_.add_entered(right_.data());
    }

    const Spline &samples_;
    AxisView view_;
    const KnotVector &axis_;
    int64_t nodes_;
    int64_t places_;
    int64_t stride_;
    int64_t length_;
    int64_t columns_;
    LayerTable table_;
    BandedLeastSquares system_;
    std::vector<double> right_;
};

// Replaces the samples along axis k by control points of an axis. There are `places` samples for each span,
// of which node j is number stride * j.
SplinePtr fitted(const Spline &samples, int k, const KnotVector &axis, const LocalNodes &nodes, size_t places,
                 size_t stride) {
    const int64_t length = reduce::layer_length(samples, k);
    const std::vector<double> layers = AxisFit(samples, k, axis, nodes, places, stride).run();
    std::vector<reduce::LayerSource> sources;
    for (int64_t i = 0; i < axis.count(); ++i) {
        sources.push_back({-1, layers.data() + i % axis.distinct_layers() * length});
    }
    return reduce::spline_of_layers(samples, k, index_axis(axis.count()), sources);
}

// Samples, places[k] of them for each span of axis k, as a spline of degree 0.
SplinePtr as_spline(const Spline &spline, const std::array<size_t, max_axes> &places,
                    std::vector<double> samples, int width) {
    Spline::Axes axes;
    for (int k = 0; k < spline.axes(); ++k) {
        axes.push_back(
            index_axis(spline.axis(k).spans().size() * static_cast<int64_t>(places[static_cast<size_t>(k)])));
    }
    return refine::polynomial_spline(std::move(axes), width, std::move(samples));
}

std::array<size_t, max_axes> node_counts(const std::vector<LocalNodes> &nodes) noexcept {
    std::array<size_t, max_axes> counts{};
    for (size_t k = 0; k < nodes.size(); ++k) {
        counts[k] = nodes[k].nodes().size();
    }
    return counts;
}

} // namespace

SplinePtr control_points(const Spline &spline, const std::vector<LocalNodes> &nodes,
                         std::vector<double> samples, int width) {
    SplinePtr values = as_spline(spline, node_counts(nodes), std::move(samples), width);
    for (int k = 0; k < spline.axes(); ++k) {
        const LocalNodes &own = nodes[static_cast<size_t>(k)];
        values = fitted(*values, k, spline.axis(k), own, own.nodes().size(), 1);
    }
    return values;
}

SplinePtr projected_along(const Spline &spline, int k, const std::vector<LocalNodes> &nodes,
                          std::vector<double> samples, int width) {
    const auto at = static_cast<size_t>(k);
    const std::vector<double> &all = nodes[at].with_checks();
    std::array<size_t, max_axes> counts = node_counts(nodes);
    counts[at] = all.size();
    SplinePtr values = as_spline(spline, counts, std::move(samples), width);
    values = fitted(*values, k, spline.axis(k), nodes[at], all.size(), 2);
    return applied(*values, k, sampling_table(spline.axis(k), all));
}

} // namespace nrb::fit

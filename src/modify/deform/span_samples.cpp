#include "modify/deform/span_samples.h"

#include "basis/bspline.h"
#include "build/functions.h"
#include "modify/constrain/minimum_norm.h"
#include "spline/layer_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nrb {

namespace {

double chebyshev(double i, int degree) noexcept {
    const double x = std::sin(std::numbers::pi * i / (2.0 * degree));
    return x * x;
}

} // namespace

LocalNodes::LocalNodes(int degree) {
    if (degree == 0) {
        nodes_ = all_ = {0.5};
        bernstein_ = {1};
        return;
    }
    for (int i = 0; i <= 2 * degree; ++i) {
        all_.push_back(i == 2 * degree ? 1 : chebyshev(i / 2.0, degree));
        if (i % 2 == 0) {
            nodes_.push_back(all_.back());
        }
    }
    const size_t size = nodes_.size();
    std::vector<double> collocation, values(size), identity(size * size, 0.0);
    for (size_t i = 0; i < size; ++i) {
        bernstein_derivs(degree, nodes_[i], 0, values.data());
        collocation.insert(collocation.end(), values.begin(), values.end());
        identity[i * size + i] = 1;
    }
    const auto n = static_cast<int64_t>(size);
    bernstein_ = MinimumNorm(collocation, n, 0).solve(identity, n);
}

namespace {

// Rows that give the values at places of every span.
LayerTable sampling_table(const KnotVector &axis, const std::vector<double> &places) {
    LayerTable table;
    double values[max_basis];
    for (const int64_t span : axis.spans().indices()) {
        const double from = axis[span], to = axis[span + 1];
        for (const double x : places) {
            const double t = x == 1 ? to : std::min(to, from + x * (to - from));
            basis_values(axis.knots().data(), axis.degree(), span, t, values);
            table.add_row(span - axis.degree(), values, axis.degree() + 1);
        }
    }
    return table;
}

// Layers that stand for themselves.
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
    return polynomial_spline(std::move(axes), spline.dim(), std::move(net.points));
}

} // namespace

std::vector<double> sampled(const Spline &spline, const Places &places) {
    SplinePtr values = applied(spline, 0, sampling_table(spline.axis(0), places[0]));
    for (int k = 1; k < spline.axes(); ++k) {
        values = applied(*values, k, sampling_table(spline.axis(k), places[static_cast<size_t>(k)]));
    }
    return {values->points().begin(), values->points().end()};
}

namespace {

// The polar form of Bernstein's polynomials over a span at degree arguments.
std::vector<double> polar_row(const KnotVector &axis, int64_t span, int64_t layer) {
    const int p = axis.degree();
    std::vector<double> row(static_cast<size_t>(p) + 1, 0.0);
    row[0] = 1;
    const double from = axis[span], length = axis[span + 1] - from;
    for (int d = 1; d <= p; ++d) {
        const double x = (axis[layer + d] - from) / length;
        for (auto i = static_cast<size_t>(d); i > 0; --i) {
            row[i] = (1 - x) * row[i] + x * row[i - 1];
        }
        row[0] *= 1 - x;
    }
    return row;
}

// How far a place is from the inside of a span, negative in it.
double outside(const KnotVector &axis, int64_t span, double t) noexcept {
    const double half = (axis[span + 1] - axis[span]) / 2;
    return std::abs(t - (axis[span] + half)) - half;
}

// Where a control point is found: a copy of its layer, and the number of the span of its support in the
// domain that is nearest to its Greville abscissa.
struct Source {
    int64_t layer;
    int64_t number;
    double far; // infinite: the support is outside the domain
};

Source source_of(const KnotVector &axis, int64_t layer) noexcept {
    const auto spans = axis.spans().indices();
    const double centre = greville(axis, layer);
    const int64_t near = axis.spans().number(centre, false), p = axis.degree();
    Source best{layer, near, std::numeric_limits<double>::infinity()};
    for (int64_t i = std::max<int64_t>(0, near - p - 1); i < std::min(std::ssize(spans), near + p + 2); ++i) {
        const int64_t s = spans[static_cast<size_t>(i)];
        if (s >= layer && s <= layer + p && outside(axis, s, centre) < best.far) {
            best = {layer, i, outside(axis, s, centre)};
        }
    }
    return best;
}

// Of all copies that are stored, the same for each of them.
Source best_source(const KnotVector &axis, int64_t layer) noexcept {
    const int64_t distinct = axis.distinct_layers();
    Source best = source_of(axis, layer % distinct);
    for (int64_t copy = layer % distinct + distinct; copy < axis.count(); copy += distinct) {
        const Source other = source_of(axis, copy);
        best = other.far < best.far ? other : best;
    }
    return best;
}

// From samples of which node j is number stride * j of `places` on each span.
LayerTable control_table(const KnotVector &axis, const LocalNodes &nodes, size_t places, size_t stride) {
    const size_t size = nodes.nodes().size();
    LayerTable table;
    for (int64_t i = 0; i < axis.count(); ++i) {
        const Source source = best_source(axis, i);
        const auto number = static_cast<size_t>(source.number);
        const std::vector<double> polar = polar_row(axis, axis.spans().indices()[number], source.layer);
        std::vector<double> row(places, 0.0);
        for (size_t k = 0; k < size; ++k) {
            for (size_t j = 0; j < size; ++j) {
                row[stride * j] += polar[k] * nodes.bernstein()[k * size + j];
            }
        }
        table.add_row(static_cast<int64_t>(number * places), row.data(), static_cast<int>(places));
    }
    return table;
}

// Samples with `places[k]` of each span on axis k.
SplinePtr as_spline(const Spline &spline, const std::array<size_t, max_axes> &places,
                    std::vector<double> samples, int width) {
    Spline::Axes axes;
    for (int k = 0; k < spline.axes(); ++k) {
        axes.push_back(
            index_axis(spline.axis(k).spans().size() * static_cast<int64_t>(places[static_cast<size_t>(k)])));
    }
    return polynomial_spline(std::move(axes), width, std::move(samples));
}

std::array<size_t, max_axes> node_counts(const std::vector<LocalNodes> &nodes) noexcept {
    std::array<size_t, max_axes> counts{};
    for (size_t k = 0; k < nodes.size(); ++k) {
        counts[k] = nodes[k].nodes().size();
    }
    return counts;
}

} // namespace

std::vector<double> control_points(const Spline &spline, const std::vector<LocalNodes> &nodes,
                                   std::vector<double> samples, int width) {
    SplinePtr values = as_spline(spline, node_counts(nodes), std::move(samples), width);
    for (int k = 0; k < spline.axes(); ++k) {
        const LocalNodes &own = nodes[static_cast<size_t>(k)];
        values = applied(*values, k, control_table(spline.axis(k), own, own.nodes().size(), 1));
    }
    return {values->points().begin(), values->points().end()};
}

std::vector<double> projected_along(const Spline &spline, int k, const std::vector<LocalNodes> &nodes,
                                    std::vector<double> samples, int width) {
    const auto at = static_cast<size_t>(k);
    const std::vector<double> &all = nodes[at].with_checks();
    std::array<size_t, max_axes> counts = node_counts(nodes);
    counts[at] = all.size();
    SplinePtr values = as_spline(spline, counts, std::move(samples), width);
    values = applied(*values, k, control_table(spline.axis(k), nodes[at], all.size(), 2));
    values = applied(*values, k, sampling_table(spline.axis(k), all));
    return {values->points().begin(), values->points().end()};
}

} // namespace nrb

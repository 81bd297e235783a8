#include "refine/periodic.h"

#include "refine/boehm.h"

#include <algorithm>

namespace nrb {

namespace {

// Several periods of an axis laid out as plain knots, `margin` of them on either side of the stored ones.
// Layer i of the extension is layer (i mod distinct) of the spline.
struct Extension {
    int64_t distinct;
    int64_t margin;
    std::vector<double> knots;

    explicit Extension(const KnotVector &axis);
    // The knot `periods` periods away from a new one behind stored knot k: an existing knot's copy is the one
    // that stands there, a new one stays between its neighbours whatever the rounding.
    [[nodiscard]] double copy_of(const KnotVector &axis, double knot, int64_t k,
                                 int64_t periods) const noexcept;
};

// New layers and knots of one period depend on old ones at most degree + 1 places away.
Extension::Extension(const KnotVector &axis)
    : distinct(axis.distinct_layers()), margin((axis.degree() + 1 + distinct - 1) / distinct + 1) {
    const std::span<const double> stored = axis.knots();
    const auto lead = static_cast<size_t>(margin * distinct);
    const auto step = static_cast<size_t>(distinct);
    const double period = axis.domain().upper - axis.domain().lower;
    knots.resize(stored.size() + 2 * lead);
    std::copy(stored.begin(), stored.end(), knots.begin() + static_cast<std::ptrdiff_t>(lead));
    for (size_t i = lead; i-- > 0;) { // equal knots have equal copies, whatever the rounding
        const bool repeated = knots[i + step] == knots[i + step + 1];
        knots[i] = repeated ? knots[i + 1] : std::min(knots[i + step] - period, knots[i + 1]);
    }
    for (size_t i = lead + stored.size(); i < knots.size(); ++i) {
        const bool repeated = knots[i - step] == knots[i - step - 1];
        knots[i] = repeated ? knots[i - 1] : std::max(knots[i - step] + period, knots[i - 1]);
    }
}

double Extension::copy_of(const KnotVector &axis, double knot, int64_t k, int64_t periods) const noexcept {
    const auto at = static_cast<size_t>(k + (margin + periods) * distinct);
    if (knot == axis[k]) {
        return knots[at];
    }
    const double period = axis.domain().upper - axis.domain().lower;
    return std::clamp(knot + static_cast<double>(periods) * period, knots[at], knots[at + 1]);
}

// A table that takes the layers of the extension from those of the spline.
LayerTable unroll(const Extension &extension, int64_t count) {
    LayerTable table;
    const int64_t rows = count + 2 * extension.margin * extension.distinct;
    table.reserve(rows);
    for (int64_t i = 0; i < rows; ++i) {
        table.add_copy(i % extension.distinct);
    }
    return table;
}

SplinePtr replaced(const Spline &spline, int k, std::vector<double> knots, bool periodic,
                   const LayerTable &table) {
    Spline::Axes axes = spline.knot_vectors();
    axes[static_cast<size_t>(k)] =
        std::make_shared<const KnotVector>(spline.axis(k).degree(), std::move(knots), periodic);
    Net net = apply_along(spline, k, table);
    return std::make_shared<const Spline>(std::move(axes), spline.dim(), spline.form(), std::move(net.points),
                                          std::move(net.weights));
}

// Knots so close that rounding makes them one a period away would give a copy a multiplicity too high.
void check_copy(std::span<const double> knots, int degree, double copy, int times) {
    const int present = multiplicity(knots, copy);
    if (present + times > degree + 1) {
        fail(
            NURBS_ERROR_PERIODIC_KNOTS,
            "knot: its copy %s, a multiple of the period away, meets %d knots there that rounding made equal",
            Number(copy).text, present);
    }
}

} // namespace

SplinePtr insert_periodic(const Spline &spline, int axis, double knot, int times) {
    const KnotVector &stored = spline.axis(axis);
    const int p = stored.degree();
    const Extension extension(stored);
    const int64_t k = stored.spans().find(knot, false);

    std::vector<double> knots = extension.knots;
    SplinePtr wide = replaced(spline, axis, knots, false, unroll(extension, stored.count()));
    for (int64_t q = -extension.margin; q <= extension.margin; ++q) {
        const double copy = extension.copy_of(stored, knot, k, q);
        check_copy(knots, p, copy, times);
        LayerTable table;
        append_insertion_rows(p, knots, copy, times, table);
        knots = insert_into_knots(knots, copy, times);
        wide = replaced(*wide, axis, knots, false, table);
    }

    // The start of the domain has moved by the copies inserted before it, one in each period.
    const int64_t distinct = extension.distinct + times;
    const int64_t start = extension.margin * distinct;
    LayerTable window;
    for (int64_t i = 0; i < distinct + p; ++i) {
        window.add_copy(start + i % distinct);
    }
    const auto first = knots.begin() + start;
    SplinePtr result = replaced(*wide, axis, {first, first + distinct + 2 * int64_t{p} + 1}, true, window);
    check_spline(*result);
    return result;
}

} // namespace nrb

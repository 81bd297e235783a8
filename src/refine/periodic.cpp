#include "refine/periodic.h"

#include "refine/boehm.h"
#include "refine/period.h"

#include <algorithm>

namespace nrb {

namespace {

// The layers and knots of a periodic axis with `lead` more on either side, as plain ones. Layer i of the
// extension is layer i - lead of the endless sequence, and so is knot i.
struct Extension {
    const KnotVector &axis;
    int64_t distinct;
    int64_t lead;
    double period;
    std::vector<double> knots;

    explicit Extension(const KnotVector &stored);
    // The copy of a new knot that stands behind stored knot k, behind extended knot `at`: where the knot
    // exists its copy does too, and elsewhere the copy stays between its neighbours whatever the rounding.
    [[nodiscard]] double copy_of(double knot, int64_t k, int64_t at) const noexcept;
    // A table that takes the layers of the extension from those of the spline.
    [[nodiscard]] LayerTable unroll() const;
};

// New layers and knots of one period depend on old ones at most degree + 1 places away.
Extension::Extension(const KnotVector &stored)
    : axis(stored), distinct(stored.distinct_layers()), lead(stored.degree() + 1),
      period(stored.domain().upper - stored.domain().lower), knots(extended_knots(stored, lead)) {}

double Extension::copy_of(double knot, int64_t k, int64_t at) const noexcept {
    const auto index = static_cast<size_t>(at);
    if (knot == axis[k]) {
        return knots[index];
    }
    const int64_t periods = (at - lead - k) / distinct; // without remainder
    return std::clamp(knot + static_cast<double>(periods) * period, knots[index], knots[index + 1]);
}

LayerTable Extension::unroll() const {
    LayerTable table;
    const int64_t rows = axis.count() + 2 * lead;
    const int64_t shift =
        (lead / distinct + 1) * distinct - lead; // a multiple of the period brings it above 0
    table.reserve(rows);
    for (int64_t i = 0; i < rows; ++i) {
        table.add_copy((i + shift) % distinct);
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
    const int64_t distinct = extension.distinct;

    std::vector<double> knots = extension.knots;
    SplinePtr wide = replaced(spline, axis, knots, false, extension.unroll());
    int64_t before = 0; // copies in front of the domain
    const int64_t lowest = (k + extension.lead - p) % distinct + p;
    for (int64_t at = lowest; at < stored.count() + 2 * extension.lead; at += distinct) {
        const double copy = extension.copy_of(knot, k, at);
        check_copy(knots, p, copy, times);
        LayerTable table;
        append_insertion_rows(p, knots, copy, times, table);
        knots = insert_into_knots(knots, copy, times);
        wide = replaced(*wide, axis, knots, false, table);
        before += at < extension.lead + p ? 1 : 0;
    }

    const int64_t start = extension.lead + before * times;
    LayerTable window;
    for (int64_t i = 0; i < distinct + times + p; ++i) {
        window.add_copy(start + i % (distinct + times));
    }
    const auto first = knots.begin() + start;
    SplinePtr result =
        replaced(*wide, axis, {first, first + distinct + times + 2 * int64_t{p} + 1}, true, window);
    check_spline(*result);
    return result;
}

} // namespace nrb

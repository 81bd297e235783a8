#include "refine/cut.h"

#include "base/checked.h"

#include <algorithm>
#include <array>

namespace nrb {

std::vector<double> saturated(const KnotVector &axis, std::span<const double> breaks) {
    const std::span<const double> knots = axis.knots();
    std::vector<double> fine;
    fine.reserve(knots.size() + breaks.size() * (static_cast<size_t>(axis.degree()) + 1));
    auto from = knots.begin();
    for (const double knot : breaks) {
        const auto first = std::find_if(from, knots.end(), [knot](double t) { return t >= knot; });
        fine.insert(fine.end(), from, first);
        fine.insert(fine.end(), static_cast<size_t>(axis.degree()) + 1, knot);
        from = std::find_if(first, knots.end(), [knot](double t) { return t > knot; });
    }
    fine.insert(fine.end(), from, knots.end());
    return fine;
}

namespace {

// Layers [first, first + axis->count()) of a cut axis.
struct Part {
    int64_t first;
    KnotVectorPtr axis;
};

// An axis cut at breaks, and its parts between them.
struct CutAxis {
    AxisTable whole;
    std::vector<Part> parts;
};

// Where the part that begins at `knot` begins, as a layer and as a knot.
int64_t layer_at(const std::vector<double> &fine, double knot) {
    return std::lower_bound(fine.begin(), fine.end(), knot) - fine.begin();
}

Part part_between(const std::vector<double> &fine, int degree, int64_t first, int64_t end) {
    const auto from = fine.begin() + first;
    return {first, std::make_shared<const KnotVector>(
                       degree, std::vector<double>(from, from + (end - first) + degree + 1))};
}

CutAxis cut_at(const KnotVector &axis, std::span<const double> breaks, ClampedEnds ends) {
    const int p = axis.degree();
    std::vector<double> fine =
        saturated(axis, breaks.subspan(ends.lower ? 0 : 1,
                                       breaks.size() - (ends.lower ? 0 : 1) - (ends.upper ? 0 : 1)));
    const Refinement refinement(p, axis.knots(), fine);
    CutAxis cut;
    std::vector<int64_t> bounds;
    for (const double knot : breaks) {
        bounds.push_back(layer_at(fine, knot));
    }
    bounds.front() = ends.lower ? bounds.front() : 0;
    bounds.back() = ends.upper ? bounds.back() : refinement.rows();
    cut.whole.table = rows_of(refinement, bounds.front(), bounds.back());
    for (size_t i = 0; i + 1 < bounds.size(); ++i) {
        cut.parts.push_back(part_between(fine, p, bounds[i], bounds[i + 1]));
        cut.parts.back().first -= bounds.front();
    }
    cut.whole.axis = part_between(fine, p, bounds.front(), bounds.back()).axis;
    return cut;
}

// The net of a spline whose axis was cut, before it falls apart.
SplinePtr apply(const Spline &spline, int k, const CutAxis &cut) {
    return with_axis(spline, k, cut.whole);
}

// Copies the block of an array that belongs to one part on every axis.
std::vector<double> block(std::span<const double> values, const Spline &whole, const Part *const *parts,
                          int64_t width) {
    std::array<int64_t, max_axes> first{}, count{1, 1, 1}, total{1, 1, 1};
    const int axes = whole.axes();
    for (int k = 0; k < axes; ++k) { // the last axes of the three are those there are
        const auto at = static_cast<size_t>(max_axes - axes + k);
        first[at] = parts[k]->first;
        count[at] = parts[k]->axis->count();
        total[at] = whole.count(k);
    }
    std::vector<double> result;
    result.reserve(static_cast<size_t>(count[0] * count[1] * count[2] * width));
    for (int64_t i = first[0]; i < first[0] + count[0]; ++i) {
        for (int64_t j = first[1]; j < first[1] + count[1]; ++j) {
            const auto from = values.begin() + ((i * total[1] + j) * total[2] + first[2]) * width;
            result.insert(result.end(), from, from + count[2] * width);
        }
    }
    return result;
}

// One part of each axis.
SplinePtr piece(const Spline &whole, const Part *const *parts) {
    Spline::Axes axes;
    axes.reserve(static_cast<size_t>(whole.axes()));
    for (int k = 0; k < whole.axes(); ++k) {
        axes.push_back(parts[k]->axis);
    }
    std::vector<double> weights;
    if (whole.form() == Form::rational) {
        weights = block(whole.weights(), whole, parts, 1);
    }
    return make_spline(std::move(axes), whole.dim(), whole.form(),
                       block(whole.points(), whole, parts, whole.stored_width()), std::move(weights));
}

Part whole_axis(const KnotVectorPtr &axis) {
    return {0, axis};
}

std::vector<double> breaks_of(const KnotVector &axis) {
    std::vector<double> breaks;
    for (const int64_t span : axis.spans().indices()) {
        breaks.push_back(axis[span]);
    }
    breaks.push_back(axis.domain().upper);
    return breaks;
}

} // namespace

SplinePtr cut_axis(const SplinePtr &spline, int axis, double lower, double upper, ClampedEnds ends) {
    const Interval domain = spline->axis(axis).domain();
    const double breaks[] = {lower, upper};
    return apply(*spline, axis,
                 cut_at(spline->axis(axis), breaks,
                        {ends.lower || lower != domain.lower, ends.upper || upper != domain.upper}));
}

SplinePtr restrict_axis(const SplinePtr &spline, int axis, double lower, double upper) {
    const Interval domain = spline->axis(axis).domain();
    return lower == domain.lower && upper == domain.upper
               ? spline
               : cut_axis(spline, axis, lower, upper, {false, false});
}

std::vector<SplinePtr> split_axis(const SplinePtr &spline, int axis, std::span<const double> breaks) {
    if (breaks.size() == 2) {
        return {spline};
    }
    const CutAxis cut = cut_at(spline->axis(axis), breaks, {false, false});
    const SplinePtr whole = apply(*spline, axis, cut);
    std::array<Part, max_axes> others;
    std::array<const Part *, max_axes> parts{};
    for (int k = 0; k < spline->axes(); ++k) {
        others[static_cast<size_t>(k)] = whole_axis(whole->knot_vectors()[static_cast<size_t>(k)]);
        parts[static_cast<size_t>(k)] = &others[static_cast<size_t>(k)];
    }
    std::vector<SplinePtr> result;
    for (const Part &part : cut.parts) {
        parts[static_cast<size_t>(axis)] = &part;
        result.push_back(piece(*whole, parts.data()));
    }
    return result;
}

std::vector<double> rough_knots(const KnotVector &axis, int order) {
    const auto [lower, upper] = axis.domain();
    std::vector<double> breaks{lower};
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        if (group.knot > lower && group.knot < upper && axis.degree() - group.multiplicity < order) {
            breaks.push_back(group.knot);
        }
    }
    breaks.push_back(upper);
    return breaks;
}

BezierPieces bezier_pieces(const SplinePtr &spline) {
    BezierPieces result;
    std::array<std::vector<Part>, max_axes> parts;
    SplinePtr whole = spline;
    int64_t total = 1;
    for (int k = 0; k < spline->axes(); ++k) {
        CutAxis cut = cut_at(spline->axis(k), breaks_of(spline->axis(k)), {true, true});
        whole = apply(*whole, k, cut);
        result.counts.push_back(std::ssize(cut.parts));
        total = checked_product(total, std::ssize(cut.parts), "pieces");
        parts[static_cast<size_t>(k)] = std::move(cut.parts);
    }
    result.pieces.reserve(static_cast<size_t>(total));
    for (int64_t i = 0; i < total; ++i) {
        std::array<const Part *, max_axes> chosen{};
        int64_t rest = i;
        for (int k = spline->axes(); k-- > 0;) {
            const auto at = static_cast<size_t>(k);
            chosen[at] = &parts[at][static_cast<size_t>(rest % result.counts[at])];
            rest /= result.counts[at];
        }
        result.pieces.push_back(piece(*whole, chosen.data()));
    }
    return result;
}

} // namespace nrb

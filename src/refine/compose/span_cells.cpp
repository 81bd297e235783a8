// SPDX-License-Identifier: MIT
#include "refine/compose/span_cells.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

void check_inside(const CurvePiece &piece, int k, Interval domain) {
    const auto [least, greatest] = std::ranges::minmax_element(piece.coefficients(k));
    if ((*least < domain.lower && sign_profile(piece, k, domain.lower).below) ||
        (*greatest > domain.upper && sign_profile(piece, k, domain.upper).above)) {
        fail(Status::outside_domain,
             "coordinate %d of f leaves the domain [%s, %s] of g between t = %s and %s", k,
             Number(domain.lower).text, Number(domain.upper).text, Number(piece.lower()).text,
             Number(piece.upper()).text);
    }
}

// Where f crosses a knot of an axis of g.
struct Crossing {
    double t;
    int axis;
    double knot;
};

std::vector<Crossing> crossings(const Spline::Axes &axes, const CurvePiece &piece) {
    std::vector<Crossing> found;
    for (size_t at = 0; at < axes.size(); ++at) {
        const int k = static_cast<int>(at);
        const auto [least, greatest] = std::ranges::minmax_element(piece.coefficients(k));
        const std::span<const double> breaks = axes[at]->spans().breaks();
        for (auto knot = std::upper_bound(breaks.begin(), breaks.end(), *least);
             knot != breaks.end() && *knot < *greatest; ++knot) {
            for (const double t : sign_profile(piece, k, *knot).crossings) {
                found.push_back({t, k, *knot});
            }
        }
    }
    std::ranges::sort(found, {}, &Crossing::t);
    return found;
}

// Whether f equals the knot, to within its uncertainty, everywhere between t and the crossing.
bool stays(const CurvePiece &piece, double t, const Crossing &crossing) noexcept {
    const double uncertainty = piece.uncertainty(crossing.axis);
    if (std::fabs(piece.value(crossing.axis, t) - crossing.knot) > uncertainty) {
        return false; // mostly saves computing all coefficients
    }
    const Coefficients values = piece.coefficients_between(crossing.axis, t, crossing.t);
    return std::all_of(values.begin(), values.begin() + piece.degree() + 1,
                       [&](double value) { return std::fabs(value - crossing.knot) <= uncertainty; });
}

// The start of the piece, and the crossings inside it that can be distinguished from its ends and from each
// other.
std::vector<double> starts_of(const Spline::Axes &axes, const CurvePiece &piece) {
    std::vector<double> starts{piece.lower()};
    for (const Crossing &crossing : crossings(axes, piece)) {
        if (!stays(piece, starts.back(), crossing) && !stays(piece, piece.upper(), crossing)) {
            starts.push_back(crossing.t);
        }
    }
    return starts;
}

// The span of an axis in which the piece lies, on a part between crossings. It begins at the highest knot
// above which the piece lies, among the knots up to its value plus the uncertainty.
int64_t span_of(const KnotVector &axis, const CurvePiece &piece, int k, Interval part) {
    const double value = piece.value(k, part.lower + (part.upper - part.lower) / 2);
    const std::span<const double> breaks = axis.spans().breaks();
    const auto inner = breaks.begin() + 1;
    auto next = std::upper_bound(inner, breaks.end() - 1, value + piece.uncertainty(k));
    while (next != inner && !lies_above(piece, k, next[-1], part)) {
        --next;
    }
    return axis.find_span(next[-1], false);
}

SpanCell cell_of(const Spline::Axes &axes, const std::vector<CurvePiece> &pieces, size_t piece,
                 Interval part) {
    SpanCell cell{part.lower, piece, {}};
    for (size_t k = 0; k < axes.size(); ++k) {
        cell.spans[k] = span_of(*axes[k], pieces[piece], static_cast<int>(k), part);
    }
    return cell;
}

} // namespace

std::vector<SpanCell> span_cells(const Spline::Axes &axes, const std::vector<CurvePiece> &pieces) {
    std::vector<SpanCell> cells;
    for (size_t i = 0; i < pieces.size(); ++i) {
        for (size_t k = 0; k < axes.size(); ++k) {
            check_inside(pieces[i], static_cast<int>(k), axes[k]->domain());
        }
        const std::vector<double> starts = starts_of(axes, pieces[i]);
        for (size_t j = 0; j < starts.size(); ++j) {
            const double end = j + 1 < starts.size() ? starts[j + 1] : pieces[i].upper();
            cells.push_back(cell_of(axes, pieces, i, {starts[j], end}));
        }
    }
    return cells;
}

double snapped(const KnotVector &axis, double value, double uncertainty) noexcept {
    const std::span<const double> knots = axis.knots();
    const auto above = std::lower_bound(knots.begin(), knots.end(), value);
    double nearest = above == knots.end() ? knots.back() : *above;
    if (above != knots.begin() && value - above[-1] < std::fabs(nearest - value)) {
        nearest = above[-1];
    }
    return std::fabs(nearest - value) <= uncertainty ? nearest : value;
}

double snapped_value(const KnotVector &axis, double value, const std::vector<CurvePiece> &pieces,
                     size_t piece, int k, double t) noexcept {
    double least = pieces[piece].uncertainty_at(k, t);
    if (piece > 0 && t == pieces[piece].lower()) {
        least = std::min(least, pieces[piece - 1].uncertainty_at(k, t));
    }
    if (piece + 1 < pieces.size() && t == pieces[piece].upper()) {
        least = std::min(least, pieces[piece + 1].uncertainty_at(k, t));
    }
    return snapped(axis, value, least);
}

} // namespace nrb::refine

// SPDX-License-Identifier: MIT
#include "mesh/border/snap_lines.h"

#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Of the domain, however small the tolerance.
constexpr double least_near = 1e-9;

// The places inside the domain where homogeneous coordinates may have a kink along an axis.
std::vector<double> kinks_of(const KnotVector &axis) {
    std::vector<double> result;
    const std::vector<double> breaks = refine::breaks_of(axis);
    for (size_t i = 1; i + 1 < breaks.size(); ++i) {
        const auto [first, last] = std::ranges::equal_range(axis.knots(), breaks[i]);
        if (last - first >= axis.degree()) {
            result.push_back(breaks[i]);
        }
    }
    return result;
}

} // namespace

SnapLines::SnapLines(const face::Face &face) {
    const face::Covering &covering = face.covering();
    for (const int k : {0, 1}) {
        const auto at = static_cast<size_t>(k);
        domain_[at] = covering.domain(k);
        closed_[at] = covering.closed(k);
        const double share = covering.extent() > 0 ? face.tolerance() / covering.extent() : 0;
        near_[at] = std::clamp(share, least_near, 1e-3) * covering.period(k);
        inner_[at] = kinks_of(face.surface()->axis(k));
    }
}

bool SnapLines::passes(size_t k, const face::TrimPiece &before, const face::TrimPiece &after) const noexcept {
    const auto leaves = [&](const face::TrimPiece &piece, double line) {
        return std::max(std::abs(piece.start[k] - line), std::abs(piece.end[k] - line)) > near_[k];
    };
    const double out = before.end[k], in = after.start[k];
    const bool seam = closed_[k] && ((out == domain_[k].lower && in == domain_[k].upper) ||
                                     (out == domain_[k].upper && in == domain_[k].lower));
    const bool line = out == in && std::ranges::binary_search(inner_[k], out);
    return (seam || line) && leaves(before, out) && leaves(after, in);
}

face::Point2 SnapLines::snapped(face::Point2 x) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const auto snap = [&](double line) { x[k] = std::abs(x[k] - line) <= near_[k] ? line : x[k]; };
        snap(domain_[k].lower);
        snap(domain_[k].upper);
        std::ranges::for_each(inner_[k], snap);
    }
    return x;
}

bool SnapLines::on_seam(size_t k, const face::Point2 &x) const noexcept {
    return closed_[k] && (x[k] == domain_[k].lower || x[k] == domain_[k].upper);
}

face::Point2 SnapLines::other_side(size_t k, face::Point2 x) const noexcept {
    x[k] = x[k] == domain_[k].lower ? domain_[k].upper : domain_[k].lower;
    return x;
}

} // namespace nrb::mesh

// SPDX-License-Identifier: MIT
#include "face/meets/along_border.h"

#include "face/border_pieces.h"
#include "intersect/pairs/curve_curve.h"

#include <algorithm>
#include <utility>

namespace nrb::face {

bool cover(std::vector<Interval> parts, const Interval &domain) {
    const double room = 0x1p-20 * (domain.upper - domain.lower);
    std::ranges::sort(parts, {}, &Interval::lower);
    double reached = domain.lower;
    for (const Interval &part : parts) {
        if (part.lower <= reached + room) {
            reached = std::max(reached, part.upper);
        }
    }
    return reached >= domain.upper - room;
}

bool runs_along_border(const Face &face, const Spline &curve) {
    BorderPieces border(face);
    std::vector<Interval> along;
    border.visit_near(curve, [&](const Spline &own, const Spline &piece, const TrimPiece &) {
        for (const intersect::PairHit &hit : intersect::curve_curve(own, piece, border.room()).list) {
            if (hit.kind == intersect::HitKind::overlap) {
                along.push_back(hit.range_a);
            }
        }
    });
    return cover(std::move(along), curve.axis(0).domain());
}

} // namespace nrb::face

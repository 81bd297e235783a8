// SPDX-License-Identifier: MIT
#include "model/rays/boxed_distance.h"

#include "base/watch.h"
#include "bounds/box.h"
#include "eval/curve_point.h"
#include "face/border_pieces.h"
#include "model/rays/face_place.h"
#include "spline/part.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nrb::model {

namespace {

constexpr double largest_distance = 1.0 / 128; // that is not reduced, relative to the size of the face
constexpr int most_halved = 8;                 // times

// A bound of the distance of two points, one in each box.
double farthest(const intersect::Box3 &a, const intersect::Box3 &b) noexcept {
    double squares = 0;
    for (size_t c = 0; c < 3; ++c) {
        const double most = std::max(a.upper[c] - b.lower[c], b.upper[c] - a.lower[c]);
        squares += most * most;
    }
    return std::sqrt(squares);
}

// A box of what the surface makes of a part of a curve between two places, of which both coordinates are
// monotone and in one copy of the domain.
intersect::Box3 box_of_image(const face::Face &face, const Spline &curve, Interval part) {
    const auto at = [&](double t) {
        face::Point2 x{};
        eval::curve_point(curve, t, false, x.data());
        return x;
    };
    face::Point2 from = at(part.lower), to = at(part.upper);
    const face::Point2 middle{from[0] / 2 + to[0] / 2, from[1] / 2 + to[1] / 2},
        inside = face.covering().in_domain(middle);
    for (size_t k = 0; k < 2; ++k) {
        from[k] += inside[k] - middle[k];
        to[k] += inside[k] - middle[k];
    }
    return box_between(face, from, to);
}

intersect::Box3 box_of_edge(const face::Coedge &coedge, Interval part) {
    const Interval from = coedge.curve->axis(0).domain(), to = coedge.edge->axis(0).domain();
    const auto param = [&](double t) {
        const double share = std::clamp((t - from.lower) / (from.upper - from.lower), 0.0, 1.0);
        return parameter_in(to, coedge.against ? 1 - share : share);
    };
    const double a = param(part.lower), b = param(part.upper);
    Part range{};
    range[0] = {std::max(std::nextafter(std::min(a, b), -infinity), to.lower), // not empty
                std::min(std::nextafter(std::max(a, b), infinity), to.upper)};
    return box3_of(bounds::bounding_box(*coedge.edge, range, infinity));
}

double distance_by_parts(const face::Face &face, const face::Coedge &coedge, Interval all, double enough) {
    struct Piece {
        Interval params;
        int halvings;
    };
    double most = 0;
    std::vector<Piece> pieces{{all, 0}};
    while (!pieces.empty()) {
        const auto [params, halvings] = pieces.back();
        pieces.pop_back();
        const double own = farthest(box_of_image(face, *coedge.curve, params), box_of_edge(coedge, params));
        if (own > std::max(enough, most) && halvings < most_halved) {
            const double middle = parameter_in(params, 0.5);
            pieces.push_back({{params.lower, middle}, halvings + 1});
            pieces.push_back({{middle, params.upper}, halvings + 1});
        } else {
            most = std::max(most, own);
        }
        count_work(1 << 10);
    }
    return most;
}

} // namespace

double boxed_distance(const face::Face &face, int32_t loop, int32_t index) {
    const face::BorderPieces border(face);
    const face::Coedge &coedge = face.loops()[static_cast<size_t>(loop)][static_cast<size_t>(index)];
    const double enough = largest_distance * face_box(face).size();
    double most = 0;
    for (const face::TrimPiece &piece : face.trims().pieces().all()) {
        const face::BorderPlace from = border.place_of(piece, 0), to = border.place_of(piece, 1);
        if (piece.loop == loop && from.index == index && from.param != to.param) {
            const Interval params{std::min(from.param, to.param), std::max(from.param, to.param)};
            most = std::max(most, distance_by_parts(face, coedge, params, enough));
        }
    }
    return most;
}

} // namespace nrb::model

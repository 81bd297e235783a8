// SPDX-License-Identifier: MIT
#include "face/places_inside.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace nrb::face {

namespace {

struct Place {
    Point2 at;
    double height; // of the part of its column that is inside
    double room = 0;
};

// The place at a share of the longest part of a column that is inside of a face.
std::optional<Place> place_in_column(const Face &face, double u, double share) {
    std::optional<Place> best;
    for (const TrimMap::ColumnPart &part : face.trims().parts_of_column(u)) {
        const double height = part.v.upper - part.v.lower;
        if (part.value > 0 && height > (best ? best->height : 0)) {
            best = Place{{u, part.v.lower + share * height}, height};
        }
    }
    return best;
}

} // namespace

std::vector<Point2> places_inside(const Face &face) {
    constexpr int inner = 8; // how many of the widest intervals without ends of pieces are used
    std::vector<double> ends{face.covering().domain(0).lower, face.covering().domain(0).upper};
    for (const TrimPiece &piece : face.trims().pieces().all()) {
        ends.insert(ends.end(), {piece.lower[0], piece.upper[0]});
    }
    std::ranges::sort(ends);
    std::vector<Interval> gaps;
    for (size_t i = 0; i + 1 < ends.size(); ++i) {
        gaps.push_back({ends[i], ends[i + 1]});
    }
    std::ranges::sort(gaps, std::ranges::greater{},
                      [](const Interval &gap) { return gap.upper - gap.lower; });
    std::vector<Place> places;
    for (size_t i = 0; i < std::min<size_t>(gaps.size(), inner); ++i) {
        for (const double share : {0.5, 0.381966}) { // in the middle, a surface may touch the face
            const double u = gaps[i].lower + share * (gaps[i].upper - gaps[i].lower);
            if (auto place = place_in_column(face, u, share)) {
                place->room = std::min(place->height / face.covering().period(1),
                                       (gaps[i].upper - gaps[i].lower) / face.covering().period(0));
                places.push_back(*place);
            }
        }
    }
    std::ranges::sort(places, std::ranges::greater{}, &Place::room);
    std::vector<Point2> result;
    std::ranges::transform(places, std::back_inserter(result), [](const Place &place) { return place.at; });
    return result;
}

bool is_outside(const Face &face, const Point2 &lower, const Point2 &upper) {
    const Point2 middle{lower[0] / 2 + upper[0] / 2, lower[1] / 2 + upper[1] / 2};
    const auto is_cut = [&](const Point2 &move) {
        return face.trims().cuts(moved(lower, move), moved(upper, move));
    };
    return face.trims().side(face.covering().in_domain(middle)) < 0 && !is_cut({0, 0}) &&
           !face.covering().any_move(lower, upper, is_cut);
}

} // namespace nrb::face

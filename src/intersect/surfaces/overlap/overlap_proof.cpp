// SPDX-License-Identifier: MIT
#include "intersect/surfaces/overlap/overlap_proof.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/surfaces/curves/cubic.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr int most_looks = 40000;           // at parts of the domain, and at pairs
constexpr int most_looks_at_a_pair = 1024;  // at parts of one pair, in covers()
constexpr int64_t work_of_a_ray = 20;       // for each part of an edge
constexpr double share_of_tolerance = 0.75; // the rest is for feet a little beyond a side along each axis
constexpr double flat = 1.0 / 64;           // of the domain: the shorter side of the box of a part of an edge
constexpr PlaceBox whole{Interval{0, 1}, Interval{0, 1}};

bool holds(const PlaceBox &a, const PlaceBox &b) noexcept {
    return a[0].lower <= b[0].lower && b[0].upper <= a[0].upper && a[1].lower <= b[1].lower &&
           b[1].upper <= a[1].upper;
}

double parameter_at(const Interval &range, double place) noexcept {
    return place == 1 ? range.upper : range.lower * (1 - place) + range.upper * place;
}

// Halves a part along the axis along which it is longer in space.
template <class Push>
void halve(const CrossPiece &piece, const PlaceBox &places, Push &&push) {
    const std::array<double, 2> middle{places[0].lower / 2 + places[0].upper / 2,
                                       places[1].lower / 2 + places[1].upper / 2};
    const CrossPiece::Point at = piece.evaluate(middle);
    const double u = (places[0].upper - places[0].lower) * length(at.slope[0]),
                 v = (places[1].upper - places[1].lower) * length(at.slope[1]);
    const size_t axis = u >= v ? 0 : 1;
    for (const bool upper : {false, true}) {
        PlaceBox half = places;
        (upper ? half[axis].lower : half[axis].upper) = middle[axis];
        push(half);
    }
}

} // namespace

OverlapProof::OverlapProof(const OverlapGround &ground, const OverlapEdges &edges,
                           const OverlapRegions &regions, double near)
    : ground_(ground), edges_(edges), regions_(regions), near_(near), map_(share_of_tolerance * near),
      left_(most_looks) {
    for (const OverlapEdge &edge : edges.edges) {
        for (const CrossSegment &segment : edge.segments) {
            add_edge_parts(segment.on);
        }
    }
}

// Divides an edge until the boxes of its parts are flat or small: places in the box of a long oblique edge
// may be far from it.
void OverlapProof::add_edge_parts(const SegmentPlaces &on) {
    EdgePart part{{}, {}, {}};
    double least = infinity;
    for (size_t k = 0; k < 2; ++k) {
        const auto [lower, upper] = std::minmax({on[0][0][k], on[0][1][k], on[0][2][k], on[0][3][k]});
        part.on[k] = {lower, upper};
        part.at[k] = Cubic(on[0]).coordinate(k, 0.5);
        part.beside[k] = Cubic(on[1]).coordinate(k, 0.5);
        least = std::min(least, (upper - lower) / ground_.borders(0).period(k));
    }
    if (!(least > flat)) {
        edge_parts_.push_back(part);
        return;
    }
    SegmentPlaces first = on, second = on;
    for (size_t i = 0; i < 2; ++i) {
        for (size_t k = 0; k < 2; ++k) {
            std::array<double, 4> halved{on[i][0][k], on[i][1][k], on[i][2][k], on[i][3][k]};
            for (size_t level = 0; level < 4; ++level) {
                first[i][level][k] = halved[0];
                second[i][3 - level][k] = halved[3 - level];
                for (size_t j = 0; j + level < 3; ++j) {
                    halved[j] = halved[j] / 2 + halved[j + 1] / 2;
                }
            }
        }
    }
    add_edge_parts(first);
    add_edge_parts(second);
}

std::array<double, 2> OverlapProof::parameters(const Part &part, double u, double v) noexcept {
    const std::array<double, 2> at{u, v};
    std::array<double, 2> result{};
    for (size_t k = 0; k < 2; ++k) {
        const double place = part.places[k].lower * (1 - at[k]) + part.places[k].upper * at[k];
        result[k] = parameter_at(part.piece->range[k], place);
    }
    return result;
}

// The place on the other surface of an edge that runs through a part, near its middle; none: no edge does.
std::optional<std::array<double, 2>> OverlapProof::edge_in(const Part &part) const {
    const auto lower = parameters(part, 0, 0), upper = parameters(part, 1, 1),
               middle = parameters(part, 0.5, 0.5);
    PlaceBox box;
    for (size_t k = 0; k < 2; ++k) { // an edge along a side of the part does not run through it
        const double room = std::min(0x1p-30 * ground_.borders(0).period(k), (upper[k] - lower[k]) / 4);
        box[k] = {lower[k] + room, upper[k] - room};
    }
    count_work(4 * std::ssize(edge_parts_));
    const EdgePart *best = nullptr;
    double least = infinity;
    for (const EdgePart &edge : edge_parts_) {
        if (have_common(edge.on, box)) {
            const double far = std::max(std::abs(edge.at[0] - middle[0]) / ground_.borders(0).period(0),
                                        std::abs(edge.at[1] - middle[1]) / ground_.borders(0).period(1));
            if (far < least) {
                least = far;
                best = &edge;
            }
        }
    }
    return best == nullptr ? std::nullopt : std::optional(best->beside);
}

bool OverlapProof::lies_along(const Part &part, const CrossPiece &other, const std::array<double, 2> &start) {
    --left_;
    if (map_.look(*part.piece, part.places, other, start, nullptr) != OverlapMap::Verdict::along) {
        return false;
    }
    proven_[part.piece].push_back({part.places, &other, map_.feet()});
    return true;
}

OverlapProof::State OverlapProof::look_along(const Part &part, const std::array<double, 2> &beside,
                                             bool inside) {
    const CrossPiece *const other = ground_.solver().piece_at(1, beside.data());
    if (other == nullptr) {
        return State::halve;
    }
    const bool done = lies_along(part, *other, ground_.solver().place_in(1, *other, beside.data())) &&
                      lies_along_neighbours(part, *other, inside);
    return done ? State::done : State::halve;
}

OverlapProof::State OverlapProof::look(const Part &part) {
    const std::optional<std::array<double, 2>> edge = edge_in(part);
    const std::array<double, 2> middle = parameters(part, 0.5, 0.5);
    count_work(edge ? 0 : work_of_a_ray * std::ssize(edge_parts_));
    if (!edge && !regions_.hold(ground_, middle)) {
        return State::done;
    }
    const std::optional<OverlapGround::Point> point = ground_.point(0, middle.data());
    const auto foot = point ? ground_.nearest(1, point->at, near_) : std::nullopt;
    if (!foot && !edge) {
        return State::failed;
    }
    // A small part is as near to the other surface as its middle, or as the edge that runs through it.
    const CrossCell cell(*part.piece, part.places);
    const bool done =
        look_along(part, foot ? *foot : *edge, !edge) == State::done ||
        (cell.size() + cell.error() <= near_ / 4 && (edge || ground_.nearest(1, point->at, near_ / 2)));
    if (done && !edge) {
        inside_[part.piece].push_back(part.places);
    }
    return done ? State::done : State::halve;
}

bool OverlapProof::prove() {
    const pieces::PieceGrid &grid = ground_.grid(0);
    std::vector<Part> stack;
    for (Index index{}; index[0] < grid.count(0); ++index[0]) {
        for (index[1] = 0; index[1] < grid.count(1); ++index[1]) {
            const CrossPiece *const piece = ground_.pieces(0).piece(index);
            if (piece == nullptr) {
                return false;
            }
            stack.push_back({piece, whole});
        }
    }
    while (!stack.empty()) {
        const Part part = stack.back();
        stack.pop_back();
        if (work_ended() || left_ <= 0) {
            return false;
        }
        const State state = look(part);
        if (state == State::failed) {
            return false;
        }
        if (state == State::halve) {
            halve(*part.piece, part.places, [&](const PlaceBox &half) {
                stack.push_back({part.piece, half});
            });
        }
    }
    return true;
}

std::optional<OverlapProof::Part> OverlapProof::part_of(size_t surface, const Interval *ranges) const {
    std::array<double, 2> middle{};
    for (size_t k = 0; k < 2; ++k) {
        middle[k] = ranges[k].lower / 2 + ranges[k].upper / 2;
    }
    const CrossPiece *const piece = ground_.solver().piece_at(surface, middle.data());
    if (piece == nullptr) {
        return std::nullopt;
    }
    Part part{piece, {}};
    for (size_t k = 0; k < 2; ++k) {
        const Interval &range = piece->range[k];
        const double length = range.upper - range.lower;
        part.places[k] = {(ranges[k].lower - range.lower) / length, (ranges[k].upper - range.lower) / length};
        if (!(part.places[k].lower >= -0x1p-20 && part.places[k].upper <= 1 + 0x1p-20)) {
            return std::nullopt;
        }
    }
    return part;
}

// Whether proven parts inside of regions cover a part. They do not overlap, so that their areas add up.
bool OverlapProof::is_inside(const Part &part) const {
    const auto known = inside_.find(part.piece);
    if (known == inside_.end()) {
        return false;
    }
    double area = 0;
    count_work(4 * std::ssize(known->second));
    for (const PlaceBox &own : known->second) {
        double common = 1;
        for (size_t k = 0; k < 2; ++k) {
            common *= std::max(0.0, std::min(own[k].upper, part.places[k].upper) -
                                        std::max(own[k].lower, part.places[k].lower));
        }
        area += common;
    }
    const double all =
        (part.places[0].upper - part.places[0].lower) * (part.places[1].upper - part.places[1].lower);
    return area >= (1 - 0x1p-30) * all;
}

bool OverlapProof::is_known(const Part &a, const Part &b) const {
    const auto known = proven_.find(a.piece);
    return known != proven_.end() && std::ranges::any_of(known->second, [&](const Proven &proven) {
               return proven.piece == b.piece && holds(proven.part, a.places) && holds(proven.with, b.places);
           });
}

OverlapMap::Verdict OverlapProof::look(const Part &a, const Part &b) {
    const std::array<double, 2> start{b.places[0].lower / 2 + b.places[0].upper / 2,
                                      b.places[1].lower / 2 + b.places[1].upper / 2};
    --left_;
    return map_.look(*a.piece, a.places, *b.piece, start, &b.places);
}

// Whether a part may have places in regions: an edge runs through it, or its middle is in one.
bool OverlapProof::meets_region(const Part &part) const {
    return edge_in(part) || regions_.hold(ground_, parameters(part, 0.5, 0.5));
}

// Whether there is a place of a region in a part or near it, at distances of its own size, in case an edge
// runs along its side.
bool OverlapProof::is_beside_region(const Part &part) const {
    for (const double u : {-1.0, 0.5, 2.0}) {
        for (const double v : {-1.0, 0.5, 2.0}) {
            const std::array<double, 2> at = parameters(part, u, v);
            bool inside = true;
            for (size_t k = 0; k < 2; ++k) {
                const Interval domain = ground_.domain(0, k);
                inside = inside && at[k] >= domain.lower && at[k] <= domain.upper;
            }
            if (inside && regions_.hold(ground_, at)) {
                return true;
            }
        }
    }
    return false;
}

// Whether the verdict of map_ shows that all common points of two parts are in regions: if the first part
// lies along the second and has places in a region; or if common points can only be along one side of the
// second part, and its surface ends there or the first part is in a proven one.
bool OverlapProof::is_told(const Part &a, const Part &b, OverlapMap::Verdict verdict) {
    if (verdict == OverlapMap::Verdict::beside || verdict == OverlapMap::Verdict::open) {
        return verdict == OverlapMap::Verdict::beside;
    }
    if (verdict == OverlapMap::Verdict::along && meets_region(a)) {
        return true;
    }
    if (!map_.set_side(b.places)) {
        return false;
    }
    const auto [axis, end] = map_.side();
    const double at = end == 0 ? b.places[axis].lower : b.places[axis].upper, of_piece = end == 0 ? 0 : 1;
    if (at == of_piece && b.piece->open[axis][end]) {
        return true;
    }
    const auto known = proven_.find(a.piece);
    return known != proven_.end() && std::ranges::any_of(known->second, [&](const Proven &proven) {
               return holds(proven.part, a.places);
           });
}

// Whether ranges may contain a place where a border is near the other surface but bounds no region.
bool OverlapProof::is_loose(const std::array<Interval, 4> &ranges) const {
    return std::ranges::any_of(edges_.loose, [&](const std::array<Interval, 4> &loose) {
        for (size_t i = 0; i < 4; ++i) {
            const double period = ground_.borders(i / 2).period(i % 2), room = 0x1p-20 * period;
            bool any = false;
            for (const double shift : {0.0, period, -period}) {
                any = any || ((shift == 0 || ground_.borders(i / 2).wraps(i % 2)) &&
                              loose[i].upper + shift >= ranges[i].lower - room &&
                              loose[i].lower + shift <= ranges[i].upper + room);
            }
            if (!any) {
                return false;
            }
        }
        return true;
    });
}

bool OverlapProof::is_along(const std::array<Interval, 4> &ranges) {
    const std::optional<Part> a = part_of(0, ranges.data()), b = part_of(1, ranges.data() + 2);
    return a && b && !is_loose(ranges) && !work_ended() && meets_region(*a) &&
           (is_known(*a, *b) || look(*a, *b) == OverlapMap::Verdict::along);
}

bool OverlapProof::covers(const std::array<Interval, 4> &ranges) {
    const std::optional<Part> a = part_of(0, ranges.data()), b = part_of(1, ranges.data() + 2);
    if (!a || !b || is_loose(ranges)) {
        return false;
    }
    if (is_inside(*a)) {
        return true;
    }
    std::vector<std::pair<Part, Part>> stack{{*a, *b}};
    for (int looks = 0; !stack.empty(); ++looks) {
        const Part first = stack.back().first, second = stack.back().second;
        stack.pop_back();
        if (is_known(first, second) || is_inside(first)) {
            continue;
        }
        const CrossCell cell(*first.piece, first.places), other(*second.piece, second.places);
        if (are_apart(cell, other) || is_told(first, second, look(first, second))) {
            continue;
        }
        if (cell.size() + cell.error() <= near_ / 8 && is_beside_region(first)) {
            continue; // it is within the tolerance of the region
        }
        if (work_ended() || left_ <= 0 || looks >= most_looks_at_a_pair) {
            return false;
        }
        if (cell.size() >= other.size()) {
            halve(*first.piece, first.places, [&](const PlaceBox &half) {
                stack.emplace_back(Part{first.piece, half}, second);
            });
        } else {
            halve(*second.piece, second.places, [&](const PlaceBox &half) {
                stack.emplace_back(first, Part{second.piece, half});
            });
        }
    }
    return true;
}

} // namespace nrb::intersect

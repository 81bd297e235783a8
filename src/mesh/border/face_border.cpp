// SPDX-License-Identifier: MIT
#include "mesh/border/face_border.h"

#include "base/numbers.h"
#include "bernstein/de_casteljau.h"
#include "mesh/border/snap_lines.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

using face::Point2;

// The control points of the part of a piece between two places.
std::vector<Point2> control_points(const face::TrimPieces &pieces, const face::TrimPiece &piece, double from,
                                   double to) {
    const std::span<const double> given = pieces.coefficients(piece);
    const size_t width = piece.weighted ? 3 : 2, count = static_cast<size_t>(piece.degree) + 1;
    std::vector<Point2> points(count);
    std::array<std::vector<double>, 3> columns;
    for (size_t c = 0; c < width; ++c) {
        for (size_t i = 0; i < count; ++i) {
            columns[c].push_back(given[i * width + c]);
        }
        restrict_to(piece.degree, from, to, columns[c].data());
    }
    for (size_t i = 0; i < count; ++i) {
        const double w = piece.weighted ? columns[2][i] : 1;
        points[i] = {columns[0][i] / w, columns[1][i] / w};
    }
    return points;
}

// The control polygon of a part of a curve. `share`: an upper bound of the sum of the rational Bernstein
// functions of all control points but the first and the last.
struct PolygonPart {
    std::vector<Point2> points;
    double share;
};

// Bernstein functions of degree p have, at the two ends together, (1 - t)^p + t^p >= 2^(1-p), which is taken
// at t = 1/2. The share grows with the weights inside and falls with those at the ends. Precondition: a
// degree of 2 or more.
double share_of_polygon(const face::TrimPieces &pieces, const face::TrimPiece &piece, double from,
                        double to) {
    double ends = infinity, inner = 0;
    if (piece.weighted) {
        std::vector<double> weights;
        const std::span<const double> given = pieces.coefficients(piece);
        for (size_t i = 2; i < given.size(); i += 3) {
            weights.push_back(given[i]);
        }
        restrict_to(piece.degree, from, to, weights.data());
        ends = std::min(weights.front(), weights.back());
        inner = *std::max_element(weights.begin() + 1, weights.end() - 1);
    }
    const double ratio = piece.weighted ? inner / ends : 1;
    const double outer = std::ldexp(2.0, -piece.degree), rest = (1 - outer) * ratio;
    return std::min(1.0, rest / (outer + rest) * (1 + 64 * eps));
}

// Measures how far places that belong to a segment, such as those of its curve, are from it: across the
// segment, with the sides of the domain as units, and along the axes.
class SegmentRoom {
public:
    SegmentRoom(const face::Covering &covering, const Point2 &a, const Point2 &b)
        : covering_(covering), period_{covering.period(0), covering.period(1)}, a_(a),
          b_(b), along_{(b[0] - a[0]) / period_[0], (b[1] - a[1]) / period_[1]},
          squared_(along_[0] * along_[0] + along_[1] * along_[1]) {}

    // Extends the steps along the axes to reach a place. If it lies beyond an end of the segment, no step
    // across reaches it.
    void take_in(Point2 x, BorderSegment &segment) const noexcept {
        x = in_copy(x);
        const double along =
            ((x[0] - a_[0]) / period_[0] * along_[0] + (x[1] - a_[1]) / period_[1] * along_[1]) / squared_;
        const double t = std::clamp(along, 0.0, 1.0);
        segment.across = segment.across && std::abs(along - t) <= 1e-12;
        for (size_t k = 0; k < 2; ++k) {
            segment.over[k] = std::max(segment.over[k], std::abs(x[k] - (a_[k] * (1 - t) + b_[k] * t)));
        }
    }
    // A bound of the distance between the curve of a control polygon and the line of the segment, times the
    // length of the segment.
    [[nodiscard]] double most_across(const PolygonPart &part) const noexcept {
        double ends = 0, inner = 0;
        for (size_t i = 0; i < part.points.size(); ++i) {
            double &own = i == 0 || i + 1 == part.points.size() ? ends : inner;
            own = std::max(own, across(in_copy(part.points[i])));
        }
        return std::max(ends, (1 - part.share) * ends + part.share * inner);
    }
    // The step across the segment for such a bound.
    [[nodiscard]] Point2 step_across(double most) const noexcept {
        return {-along_[1] * most / squared_ * period_[0], along_[0] * most / squared_ * period_[1]};
    }
    // Where a curve leaves the domain on an axis that is not closed, there is no surface beyond the end. So
    // what lies between the segment and the curve is no longer than their common box, clipped to the domain.
    void leave_out_beyond(const std::vector<PolygonPart> &hull, BorderSegment &segment) const noexcept;

private:
    // The copy of a place, on closed axes, that is nearest to the middle of the segment.
    [[nodiscard]] Point2 in_copy(Point2 x) const noexcept {
        for (size_t k = 0; k < 2; ++k) {
            const double off = x[k] - (a_[k] / 2 + b_[k] / 2);
            x[k] -= covering_.closed(static_cast<int>(k)) ? std::round(off / period_[k]) * period_[k] : 0;
        }
        return x;
    }
    [[nodiscard]] double across(const Point2 &x) const noexcept {
        return std::abs((x[0] - a_[0]) / period_[0] * along_[1] - (x[1] - a_[1]) / period_[1] * along_[0]);
    }

    const face::Covering &covering_;
    Point2 period_, a_, b_, along_;
    double squared_;
};

void SegmentRoom::leave_out_beyond(const std::vector<PolygonPart> &hull,
                                   BorderSegment &segment) const noexcept {
    Point2 inside{std::abs(segment.over[0]), std::abs(segment.over[1])};
    bool less = false;
    for (size_t k = 0; k < 2; ++k) {
        const Interval domain = covering_.domain(static_cast<int>(k));
        double lower = std::min(a_[k], b_[k]), upper = std::max(a_[k], b_[k]);
        for (const PolygonPart &part : hull) {
            for (const Point2 &x : part.points) {
                const double own = in_copy(x)[k];
                lower = std::min(lower, std::max(own, domain.lower));
                upper = std::max(upper, std::min(own, domain.upper));
            }
        }
        if (!covering_.closed(static_cast<int>(k)) && upper - lower < inside[k] / 2) {
            inside[k] = upper - lower;
            less = true;
        }
    }
    if (less) {
        segment.over = inside;
        segment.across = false;
    }
}

// Follows the loops of a face piece by piece, and connects the vertices of the edges, where they are in the
// domain.
class BorderWalk {
public:
    BorderWalk(const model::Model &model, int64_t number, const ModelEdges &edges)
        : number_(number), face_(*model.faces[static_cast<size_t>(number)].face), edges_(edges),
          border_(face_), lines_(face_, edges.chord()) {}

    FaceBorder walk() {
        const auto &all = face_.trims().pieces().all();
        for (size_t i = 0; i < all.size(); ++i) {
            if (i > 0 && all[i].loop != all[i - 1].loop) {
                close();
            }
            backwards_ = border_.is_turned(all[i]);
            add(all[i]);
        }
        close();
        return std::move(result_);
    }

private:
    void add(const face::TrimPiece &piece);
    void add_behind(const face::TrimPiece &piece);
    void arrive(const Point2 &place, const CurveVertex &vertex);
    int32_t add_point(const Point2 &x, int32_t point);
    [[nodiscard]] bool is_at(int32_t number, const Point2 &x, int32_t point) const noexcept;
    [[nodiscard]] int32_t other_side(size_t k, int32_t point);
    void add_segment(int32_t from, int32_t to);
    void mirror(const BorderSegment &segment);
    void close();
    void connect(int32_t from, int32_t to);
    void collect(const face::TrimPiece &piece, double from, double to);
    [[nodiscard]] bool jumps(const Point2 &a, const Point2 &b) const noexcept;

    int64_t number_;
    const face::Face &face_;
    const ModelEdges &edges_;
    face::BorderPieces border_;
    SnapLines lines_;
    FaceBorder result_;
    int32_t first_ = -1, last_ = -1; // points of the loop
    bool backwards_ = false;
    int64_t line_ = -1, last_line_ = -1;               // polylines of the next and of the last point
    double last_edge_param_ = 0;                       // of the last point, on its edge
    std::array<double, 2> span_{nan_value, nan_value}; // on the edge, of the next segment; NaN: it is of none
    std::vector<PolygonPart> hull_;                    // of the curve since the last point
};

// Whether the step from one place to another crosses a seam, or runs along a pole.
bool BorderWalk::jumps(const Point2 &a, const Point2 &b) const noexcept {
    const face::Covering &covering = face_.covering();
    for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<size_t>(k);
        if (covering.closed(k) && std::abs(a[at] - b[at]) > covering.period(k) / 2) {
            return true;
        }
        for (const int end : {0, 1}) {
            const double t = end == 0 ? covering.domain(k).lower : covering.domain(k).upper;
            if (covering.collapsed(k, end) && a[at] == t && b[at] == t) {
                return true;
            }
        }
    }
    return false;
}

// Notes the control polygon of the part of the curve from one vertex towards the next.
void BorderWalk::collect(const face::TrimPiece &piece, double from, double to) {
    if (from < to && piece.degree > 1) {
        const std::vector<Point2> points = control_points(face_.trims().pieces(), piece, from, to);
        hull_.push_back({points, share_of_polygon(face_.trims().pieces(), piece, from, to)});
    } else if (from < to) {
        hull_.push_back(
            {{face_.trims().pieces().point(piece, from), face_.trims().pieces().point(piece, to)}, 0});
    }
}

// Adds the vertices of a segment that closes a gap. `piece`: the part of it in one copy of the domain;
// vertices are placed on it in proportion to their parameters. Those where the segment passes into the next
// copy belong to both parts.
void BorderWalk::add_behind(const face::TrimPiece &piece) {
    const face::BorderPlace at = border_.place_of(piece, 0);
    const bool turned = border_.is_turned(piece);
    const auto count = static_cast<int32_t>(face_.loops()[static_cast<size_t>(at.loop)].size());
    const int32_t before = turned ? (at.index + count - 1) % count : at.index;
    const auto &vertices = edges_.vertices_behind(number_, at.loop, before);
    if (vertices.empty()) {
        return;
    }
    line_ = edges_.line_behind(number_, at.loop, before);
    constexpr double room = 0x1p-40;
    const Interval part = border_.part_behind(piece);
    const double length = vertices.back().param - vertices.front().param;
    for (size_t i = 0; i < vertices.size(); ++i) {
        const CurveVertex &vertex = vertices[turned ? vertices.size() - 1 - i : i];
        const double share = turned ? (vertices.back().param - vertex.param) / length
                                    : (vertex.param - vertices.front().param) / length;
        if (share < part.lower - room || share > part.upper + room) {
            continue;
        }
        hull_.clear();
        if (vertex.place) {
            arrive(*vertex.place, vertex);
            continue;
        }
        const double own = std::clamp((share - part.lower) / (part.upper - part.lower), 0.0, 1.0);
        arrive({piece.start[0] * (1 - own) + piece.end[0] * own,
                piece.start[1] * (1 - own) + piece.end[1] * own},
               vertex);
    }
}

void BorderWalk::add(const face::TrimPiece &piece) {
    if (piece.range.lower == piece.range.upper) {
        add_behind(piece);
        return;
    }
    const face::BorderPlace start = border_.place_of(piece, 0), end = border_.place_of(piece, 1);
    const auto &vertices = edges_.vertices(number_, start.loop, start.index);
    const bool rising = start.param < end.param;
    const double low = std::min(start.param, end.param), high = std::max(start.param, end.param);
    auto first = std::ranges::lower_bound(vertices, low, {}, &CurveVertex::param);
    auto last = std::ranges::upper_bound(vertices, high, {}, &CurveVertex::param);
    double before = 0;
    for (auto count = last - first; count > 0; --count) {
        const CurveVertex &vertex = rising ? *first++ : *--last;
        const double place = std::clamp((vertex.param - start.param) / (end.param - start.param), 0.0, 1.0);
        const Point2 x = vertex.param == start.param ? piece.start
                         : vertex.param == end.param ? piece.end
                         : vertex.place              ? *vertex.place
                                                     : face_.trims().pieces().point(piece, place);
        collect(piece, before, place);
        before = place;
        line_ = edges_.line_of(number_, start.loop, start.index);
        arrive(x, vertex);
    }
    collect(piece, before, 1);
}

// Whether a border point is that of a vertex, and near its place in the domain: curves that meet in a corner
// of space need not end at one place of the domain.
bool BorderWalk::is_at(int32_t number, const Point2 &x, int32_t point) const noexcept {
    const BorderPoint &own = result_.points[static_cast<size_t>(number)];
    return own.point == point && std::abs(own.param[0] - x[0]) <= lines_.near(0) &&
           std::abs(own.param[1] - x[1]) <= lines_.near(1);
}

void BorderWalk::arrive(const Point2 &place, const CurveVertex &vertex) {
    const Point2 x = lines_.snapped(place);
    const bool again = last_ >= 0 && is_at(last_, x, vertex.point);
    const bool closes = last_ >= 0 && last_ != first_ && is_at(first_, x, vertex.point);
    const int32_t number = again ? last_ : closes ? first_ : add_point(x, vertex.point);
    if (last_ < 0) {
        first_ = number;
    } else if (!again) {
        const bool same = line_ == last_line_ && vertex.edge_param != last_edge_param_;
        span_ = {same ? last_edge_param_ : nan_value, vertex.edge_param};
        connect(last_, number);
    }
    last_ = number;
    last_line_ = line_;
    last_edge_param_ = vertex.edge_param;
    hull_.clear();
}

int32_t BorderWalk::add_point(const Point2 &x, int32_t point) {
    result_.points.push_back({x, point});
    return static_cast<int32_t>(result_.points.size() - 1);
}

// Adds the same point on the other side of the seam that it is on.
int32_t BorderWalk::other_side(size_t k, int32_t point) {
    const BorderPoint own = result_.points[static_cast<size_t>(point)];
    return add_point(lines_.other_side(k, own.param), own.point);
}

// An end on a seam is taken on that side of the seam on which the other end is.
void BorderWalk::connect(int32_t from, int32_t to) {
    const auto param = [&](int32_t i) { return result_.points[static_cast<size_t>(i)].param; };
    for (size_t k = 0; k < 2; ++k) {
        const int axis = static_cast<int>(k);
        if (face_.covering().closed(axis) &&
            std::abs(param(from)[k] - param(to)[k]) > face_.covering().period(axis) / 2) {
            if (lines_.on_seam(k, param(to))) {
                to = other_side(k, to);
            } else if (lines_.on_seam(k, param(from))) {
                from = other_side(k, from);
            }
        }
    }
    if (param(from) != param(to) && !jumps(param(from), param(to))) {
        add_segment(from, to);
    }
}

// A segment on a seam is there on both sides of it.
void BorderWalk::mirror(const BorderSegment &segment) {
    for (size_t k = 0; k < 2; ++k) {
        if (lines_.on_seam(k, result_.points[static_cast<size_t>(segment.from)].param) &&
            lines_.on_seam(k, result_.points[static_cast<size_t>(segment.to)].param)) {
            BorderSegment other = segment;
            other.from = other_side(k, segment.from);
            other.to = other_side(k, segment.to);
            result_.segments.push_back(other);
        }
    }
}

// Adds a segment, with the bound of how far its curve is from it.
void BorderWalk::add_segment(int32_t from, int32_t to) {
    const SegmentRoom room(face_.covering(), result_.points[static_cast<size_t>(from)].param,
                           result_.points[static_cast<size_t>(to)].param);
    BorderSegment segment{from, to};
    segment.backwards = backwards_;
    if (!std::isnan(span_[0])) {
        segment.line = line_;
        segment.params = span_;
    }
    double most = 0;
    for (const PolygonPart &part : hull_) {
        for (const Point2 &x : part.points) {
            room.take_in(x, segment);
        }
        most = std::max(most, room.most_across(part));
    }
    if (segment.across) {
        segment.over = room.step_across(most);
    }
    room.leave_out_beyond(hull_, segment);
    result_.segments.push_back(segment);
    mirror(segment);
}

void BorderWalk::close() {
    span_ = {nan_value, nan_value};
    if (last_ >= 0 && last_ != first_) {
        connect(last_, first_);
    }
    first_ = last_ = -1;
    last_line_ = -1;
    hull_.clear();
}

} // namespace

FaceBorder border_of(const model::Model &model, int64_t face, const ModelEdges &edges) {
    return BorderWalk(model, face, edges).walk();
}

} // namespace nrb::mesh

// SPDX-License-Identifier: MIT
#include "mesh/border/model_edges.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "build/polylines.h"
#include "eval/curve_point.h"
#include "face/deviation.h"
#include "mesh/border/snap_lines.h"
#include "mesh/proof/distance.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Rounds of adding vertices for the sake of faces, each between two others.
constexpr int most_polyline_rounds = 12;

// Whether a vertex would be where one end of a segment is, but for rounding: two faces ask for one place of their edge.
bool is_beside(double param, Interval segment) noexcept {
    const double room = 0x1p-20 * (segment.upper - segment.lower);
    return param - segment.lower <= room || segment.upper - param <= room;
}

// The break of an axis that a parameter is near.
double at_break(const KnotVector &axis, double t, double room) noexcept {
    const auto knots = axis.knots();
    const auto next = std::ranges::lower_bound(knots, t - room);
    return next != knots.end() && *next <= t + room ? *next : t;
}

} // namespace

EdgeCurves::EdgeCurves(const model::Model &model) : borders(model) {
    for (const model::Edge &edge : model.edges) {
        add_line(edge);
    }
    for (size_t face = 0; face < model.faces.size(); ++face) {
        const face::Face &own = *model.faces[face].face;
        for (size_t loop = 0; loop < own.loops().size(); ++loop) {
            add_own_lines(own, own.loops()[loop],
                          static_cast<size_t>(
                              borders.number(static_cast<int64_t>(face), static_cast<int32_t>(loop), 0)));
        }
    }
}

size_t &EdgeCurves::line(size_t curve) {
    line_of.resize(std::max(line_of.size(), curve + 1), none);
    return line_of[curve];
}

void EdgeCurves::add_line(const model::Edge &edge) {
    Line own{std::ssize(lines), edge.curve};
    for (const model::EdgeUse &use : edge.uses) {
        own.users.push_back(static_cast<size_t>(
            borders.number(use.face, static_cast<int32_t>(use.loop), static_cast<int32_t>(use.index))));
        line(own.users.back()) = lines.size();
    }
    lines.push_back(std::move(own));
}

// Of curves of a loop without an edge.
void EdgeCurves::add_own_lines(const face::Face &face, const face::Loop &loop, size_t first) {
    for (size_t i = 0; i < loop.size(); ++i) {
        if (line(first + i) == none) {
            line(first + i) = lines.size();
            lines.push_back({-1, face::edge_of(face, loop[i]), {first + i}});
        }
    }
}

ModelEdges::ModelEdges(const model::Model &model, const EdgeCurves &curves, const PolylineRule &rule)
    : model_(model), borders_(curves.borders) {
    set_uses();
    set_lines(curves);
    const double near = std::isfinite(rule.chord) ? rule.chord / 32 : 0;
    const size_t count = uses_.size();
    for (size_t i = 0; i < count; ++i) {
        make_pairing(uses_[i], near);
    }
    for (int64_t face = 0; face < std::ssize(model_.faces); ++face) {
        if (model_.faces[static_cast<size_t>(face)].face->has_gaps()) {
            add_gaps(face);
        }
    }
    for (size_t i = count; i < uses_.size(); ++i) {
        make_pairing(uses_[i], near);
    }
    for (face_ = 0; face_ < std::ssize(model_.faces); ++face_) {
        add_fixed(face_);
    }
    Steps steps(std::ssize(lines_));
    for (size_t line = 0; line < lines_.size(); ++line, steps.next()) {
        align_fixed(line);
        make_line(line, rule);
    }
    for (Use &use : uses_) {
        set_vertices(use);
    }
}

const face::Coedge &ModelEdges::coedge_of(const Use &use) const noexcept {
    const face::Face &face = *model_.faces[static_cast<size_t>(use.face)].face;
    return face.loops()[static_cast<size_t>(use.loop)][static_cast<size_t>(use.index)];
}

void ModelEdges::make_pairing(Use &use, double near) {
    const face::Face &face = *model_.faces[static_cast<size_t>(use.face)].face;
    const Spline &curve = use.own ? *use.own : *coedge_of(use).curve;
    use.pairing = std::make_unique<CurvePairing>(face, curve, *curves_[use.line],
                                                 !use.own && coedge_of(use).against, near);
    count_work(1 << 12);
}

// Behind curves that end farther from the next one than the tolerance.
void ModelEdges::add_gaps(int64_t number) {
    const face::Face &face = *model_.faces[static_cast<size_t>(number)].face;
    for (int32_t loop = 0; loop < static_cast<int32_t>(face.loops().size()); ++loop) {
        const auto count = static_cast<int32_t>(face.loops()[static_cast<size_t>(loop)].size());
        for (int32_t i = 0; i < count; ++i) {
            const Use &own = uses_[use_at(number, loop, i)],
                      &next = uses_[use_at(number, loop, (i + 1) % count)];
            face::Joint gap{};
            eval::end_point(*coedge_of(own).curve, true, gap.from.data());
            eval::end_point(*coedge_of(next).curve, false, gap.to.data());
            const double apart = length(own.pairing->image(coedge_of(own).curve->axis(0).domain().upper) -
                                        next.pairing->image(coedge_of(next).curve->axis(0).domain().lower));
            if (apart > face.tolerance()) {
                add_gap(number, loop, i, gap);
            }
        }
    }
}

void ModelEdges::add_gap(int64_t number, int32_t loop, int32_t index, const face::Joint &gap) {
    const face::Face &face = *model_.faces[static_cast<size_t>(number)].face;
    const face::Point2 to = face.covering().nearest_copy(gap.to, gap.from);
    Use use{number, loop, index, lines_.size()};
    use.own = build::polyline(2, {gap.from[0], gap.from[1], to[0], to[1]}, {0, 1});
    gaps_[borders_.number(number, loop, index)] = uses_.size();
    lines_.emplace_back();
    curves_.push_back(face::edge_over(face.surface(), face.covering(), use.own, face.tolerance()).curve);
    users_.push_back({uses_.size()});
    uses_.push_back(std::move(use));
}

const std::vector<CurveVertex> &ModelEdges::vertices_behind(int64_t face, int32_t loop,
                                                            int32_t index) const noexcept {
    static const std::vector<CurveVertex> none;
    const auto found = gaps_.find(borders_.number(face, loop, index));
    return found == gaps_.end() ? none : uses_[found->second].vertices;
}

int64_t ModelEdges::line_behind(int64_t face, int32_t loop, int32_t index) const noexcept {
    return static_cast<int64_t>(uses_[gaps_.at(borders_.number(face, loop, index))].line);
}

void ModelEdges::set_uses() {
    for (int64_t face = 0; face < std::ssize(model_.faces); ++face) {
        const auto &loops = model_.faces[static_cast<size_t>(face)].face->loops();
        for (int32_t loop = 0; loop < static_cast<int32_t>(loops.size()); ++loop) {
            for (int32_t i = 0; i < static_cast<int32_t>(loops[static_cast<size_t>(loop)].size()); ++i) {
                uses_.push_back({face, loop, i});
            }
        }
    }
}

void ModelEdges::set_lines(const EdgeCurves &curves) {
    for (const EdgeCurves::Line &line : curves.lines) {
        lines_.push_back({line.edge});
        curves_.push_back(line.curve);
        users_.push_back(line.users);
    }
    for (size_t at = 0; at < uses_.size(); ++at) {
        uses_[at].line = curves.line_of[at];
    }
}

// Where the border passes a seam, or a kink of the surface. What is near such a line is on it.
void ModelEdges::add_fixed(int64_t number) {
    const face::Face &face = *model_.faces[static_cast<size_t>(number)].face;
    const face::BorderPieces border(face);
    const auto &all = face.trims().pieces().all();
    for (size_t first = 0, last = 0; first < all.size(); first = last) {
        for (last = first; last < all.size() && all[last].loop == all[first].loop; ++last) {
        }
        for (const LinePassage &passage : passages_of(face, std::span(all).subspan(first, last - first))) {
            if (passage.piece->range.lower == passage.piece->range.upper) {
                fix_behind(border.place_of(*passage.piece, 0), border.is_turned(*passage.piece), passage);
            } else {
                fix(border.place_of(*passage.piece, passage.place), passage.at);
            }
        }
    }
}

// On the segment behind a curve, if it is one that is far from the next.
void ModelEdges::fix_behind(const face::BorderPlace &place, bool turned, const LinePassage &passage) {
    const auto count = static_cast<int32_t>(
        model_.faces[static_cast<size_t>(face_)].face->loops()[static_cast<size_t>(place.loop)].size());
    const int32_t before = turned ? (place.index + count - 1) % count : place.index;
    const auto found = gaps_.find(borders_.number(face_, place.loop, before));
    if (found != gaps_.end()) {
        Use &use = uses_[found->second];
        const double param = turned ? 1 - passage.place : passage.place;
        use.fixed.push_back({param, use.pairing->on_edge(param), passage.at});
    }
}

void ModelEdges::fix(const face::BorderPlace &place, const face::Point2 &x) {
    Use &use = uses_[use_at(face_, place.loop, place.index)];
    use.fixed.push_back({place.param, use.pairing->on_edge(place.param), x});
}

// Whether no other place of the same curve is near; they rise.
bool ModelEdges::is_alone(const std::vector<FixedUse> &all, size_t i, double room) {
    const auto is_other = [&](size_t k) { return all[k].second != all[i].second; };
    const auto is_near = [&](size_t k) { return std::abs(all[i].first->edge - all[k].first->edge) <= room; };
    bool alone = true;
    for (size_t k = i; k > 0 && is_near(k - 1); --k) {
        alone = alone && is_other(k - 1);
    }
    for (size_t k = i + 1; k < all.size() && is_near(k); ++k) {
        alone = alone && is_other(k);
    }
    return alone;
}

// What faces have at one place of an edge, but for rounding, is at one parameter, and so is what is at its ends. So is what is at a
// break: of what would be between them, nobody knows the direction.
void ModelEdges::align_fixed(size_t line) {
    const KnotVector &axis = curves_[line]->axis(0);
    const Interval domain = axis.domain();
    const double room = 0x1p-36 * (domain.upper - domain.lower);
    std::vector<FixedUse> all;
    for (const size_t at : users_[line]) {
        for (Fixed &fixed : uses_[at].fixed) {
            all.emplace_back(&fixed, at);
        }
    }
    std::ranges::sort(all, {}, [](const FixedUse &own) { return own.first->edge; });
    double before = domain.lower;
    size_t by = uses_.size(); // any other face may be there, too
    for (size_t i = 0; i < all.size(); ++i) {
        const auto [fixed, use] = all[i];
        if (fixed->edge - before <= room && use != by) {
            fixed->edge = before;
        } else if (domain.upper - fixed->edge <= room) {
            fixed->edge = domain.upper;
        } else {
            fixed->edge = is_alone(all, i, 2 * room) ? at_break(axis, fixed->edge, room) : fixed->edge;
            before = fixed->edge;
            by = use;
        }
    }
}

std::vector<double> ModelEdges::fixed_params(size_t line) const {
    const Interval domain = curves_[line]->axis(0).domain();
    std::vector<double> result;
    for (const size_t at : users_[line]) {
        for (const Fixed &fixed : uses_[at].fixed) {
            if (fixed.edge > domain.lower && fixed.edge < domain.upper) {
                result.push_back(fixed.edge);
            }
        }
    }
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

// Whether what a face has between two vertices is far from the segment: on its curve, or on the segment in its domain.
bool ModelEdges::is_far(const Use &use, const std::array<double, 2> &params, double chord) const {
    const face::Face &face = *model_.faces[static_cast<size_t>(use.face)].face;
    const Spline &curve = use.own ? *use.own : *coedge_of(use).curve;
    const auto place = [&](double share) {
        face::Point2 x;
        eval::curve_point(curve, params[0] * (1 - share) + params[1] * share, false, x.data());
        return x;
    };
    const auto in_space = [&](const face::Point2 &x) {
        const std::vector<double> point = face::point_at(*face.surface(), face.covering().in_domain(x));
        return Vector3{point[0], point.size() > 1 ? point[1] : 0, point.size() > 2 ? point[2] : 0};
    };
    const face::Point2 from = place(0), to = place(1);
    const Vector3 a = in_space(from), b = in_space(to);
    double off_chord = 0, off_curve = 0;
    for (const double share : {0.25, 0.5, 0.75}) {
        const face::Point2 between{from[0] * (1 - share) + to[0] * share,
                                   from[1] * (1 - share) + to[1] * share};
        const Vector3 on_chord = in_space(between);
        off_chord = std::max(off_chord, distance_from_segment(on_chord, a, b));
        off_curve = std::max(off_curve, length(in_space(place(share)) - on_chord));
    }
    return off_chord + off_curve > chord;
}

std::vector<double> ModelEdges::places_to_add(size_t line, const std::vector<double> &params,
                                              double chord) const {
    std::vector<double> result;
    for (size_t i = 0; i + 1 < params.size(); ++i) {
        const double middle = params[i] / 2 + params[i + 1] / 2;
        const bool far =
            middle > params[i] && middle < params[i + 1] && std::ranges::any_of(users_[line], [&](size_t at) {
                const Use &use = uses_[at];
                return is_far(use, {use.pairing->on_curve(params[i]), use.pairing->on_curve(params[i + 1])},
                              chord);
            });
        if (far) {
            result.push_back(middle);
        }
        count_work(1 << 10);
    }
    return result;
}

void ModelEdges::make_line(size_t line, const PolylineRule &rule) {
    std::vector<double> fixed = fixed_params(line);
    Polyline polyline = polyline_of(*curves_[line], rule, fixed);
    for (int round = 0; round < most_polyline_rounds && std::isfinite(rule.chord); ++round) {
        const std::vector<double> more = places_to_add(line, polyline.params, rule.chord);
        if (more.empty()) {
            break;
        }
        fixed = polyline.params;
        fixed.insert(fixed.end(), more.begin(), more.end());
        std::ranges::sort(fixed);
        fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
        polyline = polyline_of(*curves_[line], rule, fixed);
    }
    set_points(line, polyline);
}

int32_t ModelEdges::corner(int64_t number, const Vector3 &x) {
    const auto [known, fresh] = corners_.try_emplace(number, static_cast<int32_t>(points_.size()));
    if (fresh) {
        points_.push_back(x);
    }
    return known->second;
}

// The point at an end of a polyline, which is that of a corner. In a gap there are two of these.
int32_t ModelEdges::end_of_line(size_t line, bool upper, const Vector3 &x) {
    const Use &use = uses_[users_[line].front()];
    const auto count = static_cast<int64_t>(
        model_.faces[static_cast<size_t>(use.face)].face->loops()[static_cast<size_t>(use.loop)].size());
    const int64_t number = borders_.number(use.face, use.loop, use.index);
    const bool at_end = use.own ? !upper : upper != coedge_of(use).against; // of the curve of the loop
    if (at_end) {
        const bool gap = gaps_.contains(number);
        return corner(gap ? -1 - number : borders_.coedge(number).end, x);
    }
    const int64_t next =
        use.own ? borders_.number(use.face, use.loop, static_cast<int32_t>((use.index + 1) % count)) : number;
    return corner(borders_.coedge(next).start, x);
}

void ModelEdges::set_points(size_t line, const Polyline &polyline) {
    EdgeLine &out = lines_[line];
    const int dim = curves_[line]->dim();
    const auto point = [&](size_t i) {
        const double *x = polyline.points.data() + i * static_cast<size_t>(dim);
        return Vector3{x[0], dim > 1 ? x[1] : 0, dim > 2 ? x[2] : 0};
    };
    const size_t count = polyline.params.size();
    out.params = polyline.params;
    for (const double bound : polyline.bounds) {
        out.bound = std::max(out.bound, bound);
    }
    out.reached = polyline.reached;
    for (size_t i = 0; i < count; ++i) {
        const bool first = i == 0, last = i + 1 == count;
        if ((first || last) && !users_[line].empty()) {
            out.points.push_back(end_of_line(line, last, point(i)));
        } else {
            out.points.push_back(static_cast<int32_t>(points_.size()));
            points_.push_back(point(i));
        }
    }
}

// The bound of the segment that is divided stays that of its parts: a part of a curve within a distance of a convex set.
std::vector<int64_t> ModelEdges::add_vertex(int64_t number, double param) {
    const auto at = static_cast<size_t>(number);
    EdgeLine &line = lines_[at];
    const auto next = std::ranges::lower_bound(line.params, param);
    if (next == line.params.begin() || next == line.params.end() || is_beside(param, {*(next - 1), *next})) {
        return {};
    }
    const std::vector<double> x = eval::curve_point(*curves_[at], param, false);
    const auto index = next - line.params.begin();
    line.params.insert(next, param);
    line.points.insert(line.points.begin() + index, static_cast<int32_t>(points_.size()));
    points_.push_back({x[0], x.size() > 1 ? x[1] : 0, x.size() > 2 ? x[2] : 0});
    std::vector<int64_t> faces;
    for (const size_t use : users_[at]) {
        set_vertices(uses_[use]);
        faces.push_back(uses_[use].face);
    }
    return faces;
}

std::vector<int64_t> ModelEdges::unite(int32_t first, int32_t second) {
    const double apart =
        length(points_[static_cast<size_t>(first)] - points_[static_cast<size_t>(second)]) * (1 + 4 * eps);
    std::vector<int64_t> faces;
    for (size_t at = 0; at < lines_.size(); ++at) {
        EdgeLine &line = lines_[at];
        if (std::ranges::find(line.points, second) == line.points.end()) {
            continue;
        }
        std::ranges::replace(line.points, second, first);
        line.bound += apart;
        for (const size_t use : users_[at]) {
            set_vertices(uses_[use]);
            faces.push_back(uses_[use].face);
        }
    }
    return faces;
}

// Where curve and edge run in the same direction the vertices rise.
void ModelEdges::set_vertices(Use &use) {
    const EdgeLine &line = lines_[use.line];
    use.vertices.clear();
    for (size_t i = 0; i < line.params.size(); ++i) {
        CurveVertex vertex{use.pairing->on_curve(line.params[i]), line.points[i], line.params[i]};
        for (const Fixed &fixed : use.fixed) {
            if (fixed.edge == line.params[i]) {
                vertex.param = fixed.curve;
                vertex.place = fixed.place;
            }
        }
        use.vertices.push_back(vertex);
    }
    if (use.vertices.front().param > use.vertices.back().param) {
        std::ranges::reverse(use.vertices);
    }
}

} // namespace nrb::mesh

// SPDX-License-Identifier: MIT
#include "model/meets/meet_joints.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "face/border_pieces.h"
#include "face/meets/along_border.h"
#include "face/meets/ground.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace nrb::model {

namespace {

using intersect::MeetBranch;
using intersect::MeetNode;
using intersect::NodeKind;

constexpr double least_sine = 1.0 / 256;

Vector3 tip_of(const Spline &curve, bool upper) {
    const std::vector<double> x = eval::end_point(curve, upper);
    return {x[0], x[1], x[2]};
}

Vector3 point_of(const face::Face &face, const face::Point2 &at) {
    const std::vector<double> x = face::point_at(*face.surface(), face.covering().in_domain(at));
    return {x[0], x[1], x[2]};
}

double coordinate(const Vector3 &x, size_t c) noexcept {
    return c == 0 ? x.x : c == 1 ? x.y : x.z;
}

// The direction in space of a curve of a loop at a parameter: the difference of two points a little to either
// side, not normalized.
Vector3 way_along(const face::Face &face, const Spline &curve, double param) {
    const Interval domain = curve.axis(0).domain();
    const double step = (domain.upper - domain.lower) / 4096;
    const auto point = [&](double t) {
        const std::vector<double> on =
            eval::curve_point(curve, std::clamp(t, domain.lower, domain.upper), false);
        return point_of(face, {on[0], on[1]});
    };
    return point(param + step) - point(param - step);
}

} // namespace

MeetJoints::MeetJoints(PlacedFaces &a, PlacedFaces &b, const std::vector<FacePair> &of_branches,
                       double tolerance, intersect::Meet &meet)
    : models_{&a, &b}, of_branches_(of_branches), tolerance_(tolerance), meet_(meet) {}

void MeetJoints::run() {
    add_ends();
    joined_.assign(ends_.size(), false);
    add_matches();
    std::ranges::sort(matches_, {}, [](const Match &m) { return std::tuple(m.apart, m.from, m.to); });
    for (const Match &match : matches_) {
        if (!joined_[match.from] && !joined_[match.to]) {
            join(match);
        }
    }
    tell_open_ends();
}

void MeetJoints::add_ends() {
    for (size_t i = 0; i < meet_.branches.size(); ++i) {
        for (const bool begins : {true, false}) {
            const MeetBranch &own = meet_.branches[i];
            if (own.kind != intersect::BranchKind::edge && own.nodes[begins ? 0 : 1] >= 0) {
                add_end(i, begins);
            }
        }
    }
}

// Adds an end that lies on a border or a seam and has no continuation yet.
void MeetJoints::add_end(size_t branch, bool begins) {
    const MeetBranch &own = meet_.branches[branch];
    const MeetNode &node = meet_.nodes[static_cast<size_t>(own.nodes[begins ? 0 : 1])];
    if (node.next >= 0 || (node.kind != NodeKind::border && node.kind != NodeKind::seam)) {
        return;
    }
    End end{branch,
            begins,
            tip_of(*own.space, !begins),
            2 * (std::min(own.deviation, tolerance_) + tolerance_),
            {}};
    for (const size_t model : {size_t{0}, size_t{1}}) {
        const size_t place = place_of(end, model);
        end.room += models_[model]->room(models_[model]->places()[place]);
        end.borders[model] = borders_at(model, place, node);
    }
    if (!end.borders[0].empty() || !end.borders[1].empty()) {
        ends_.push_back(std::move(end));
    }
}

std::vector<MeetJoints::Border> MeetJoints::borders_at(size_t model, size_t place, const MeetNode &node) {
    PlacedFaces &faces = *models_[model];
    const int64_t face = faces.places()[place].face;
    const face::BorderPieces pieces(faces.own(face));
    std::vector<Border> found;
    for (const face::BorderPlace &at : pieces.nearest_to(model == 0 ? node.at : node.at_second)) {
        const int64_t coedge = faces.borders().number(face, at.loop, at.index);
        if (const int64_t pair = faces.borders().coedge(coedge).pair; pair >= 0) {
            found.push_back({pair, coedge, at.param});
        }
    }
    count_work(200);
    return found;
}

// Matches the ends and beginnings of branches on the same edge in the same instance.
void MeetJoints::add_matches() {
    std::map<std::array<int64_t, 3>, std::vector<size_t>> on_edges;
    for (size_t i = 0; i < ends_.size(); ++i) {
        for (const size_t model : {size_t{0}, size_t{1}}) {
            const int64_t instance = models_[model]->places()[place_of(ends_[i], model)].instance;
            for (const Border &border : ends_[i].borders[model]) {
                on_edges[{static_cast<int64_t>(model), instance, border.pair}].push_back(i);
            }
        }
    }
    for (const auto &[edge, ends] : on_edges) {
        match_on_edge(ends);
    }
}

// Sorts the beginnings by the coordinate in which the points spread farthest. All beginnings that may fit an
// end are then within a short interval around it.
void MeetJoints::match_on_edge(const std::vector<size_t> &ends) {
    std::vector<size_t> begins;
    double most_room = 0;
    std::array<Interval, 3> extents;
    extents.fill({infinity, -infinity});
    for (const size_t i : ends) {
        const Vector3 &x = ends_[i].point;
        most_room = std::max(most_room, ends_[i].room);
        for (size_t c = 0; c < 3; ++c) {
            const double at = coordinate(x, c);
            extents[c] = {std::min(extents[c].lower, at), std::max(extents[c].upper, at)};
        }
        if (ends_[i].begins) {
            begins.push_back(i);
        }
    }
    const auto *const longest =
        std::ranges::max_element(extents, {}, [](const Interval &x) { return x.upper - x.lower; });
    const auto along = static_cast<size_t>(longest - extents.begin());
    const auto key = [&](size_t i) { return coordinate(ends_[i].point, along); };
    std::ranges::sort(begins, {}, [&](size_t i) { return std::pair(key(i), i); });
    for (const size_t from : ends) {
        const double room = (ends_[from].room + most_room) / least_sine;
        auto to =
            ends_[from].begins ? begins.end() : std::ranges::lower_bound(begins, key(from) - room, {}, key);
        for (; to != begins.end() && key(*to) <= key(from) + room; ++to) {
            count_work(8);
            if (fit(ends_[from], ends_[*to])) {
                matches_.push_back({length(ends_[from].point - ends_[*to].point), from, *to});
            }
        }
        count_work(8);
    }
}

bool MeetJoints::fit(const End &a, const End &b) const {
    const bool crosses_first = crosses(a, b, 0), crosses_second = crosses(a, b, 1);
    const bool goes_on = (crosses_first && (crosses_second || place_of(a, 1) == place_of(b, 1))) ||
                         (crosses_second && place_of(a, 0) == place_of(b, 0));
    if (!goes_on) {
        return false;
    }
    const double gap = length(a.point - b.point), room = a.room + b.room;
    return gap <= room ||
           (gap * least_sine <= room && gap * std::max(least_sine, std::min(slope(a), slope(b))) <= room);
}

// Whether the two ends lie on opposite sides of one edge of a model, which two faces share or one face has
// twice.
bool MeetJoints::crosses(const End &a, const End &b, size_t model) const {
    const PlacedFaces &faces = *models_[model];
    return faces.places()[place_of(a, model)].instance == faces.places()[place_of(b, model)].instance &&
           std::ranges::any_of(a.borders[model], [&](const Border &first) {
               return std::ranges::any_of(b.borders[model], [&](const Border &second) {
                   return first.pair == second.pair && first.coedge != second.coedge;
               });
           });
}

// The sine of the angle between the edge at the end and the surface of the other model.
double MeetJoints::slope(const End &end) const {
    const MeetNode &node = meet_.nodes[static_cast<size_t>(node_of(end))];
    const size_t model = end.borders[0].empty() ? 1 : 0;
    const Border &border = end.borders[model].front();
    PlacedFaces &faces = *models_[model], &others = *models_[1 - model];
    const SharedCoedge &coedge = faces.borders().coedge(border.coedge);
    const face::Face &shape = *faces.shape(place_of(end, model));
    const Spline &curve =
        *shape.loops()[static_cast<size_t>(coedge.loop)][static_cast<size_t>(coedge.index)].curve;
    const face::Face &other = *others.shape(place_of(end, 1 - model));
    const Vector3 way = way_along(shape, curve, border.param),
                  normal = face::surface_normal(
                      *other.surface(), other.covering().in_domain(model == 0 ? node.at_second : node.at));
    const double far = length(way) * length(normal);
    return far > 0 ? std::abs(dot(way, normal)) / far : 0;
}

void MeetJoints::join(const Match &match) {
    const int64_t from = node_of(ends_[match.from]), to = node_of(ends_[match.to]);
    for (const auto &[node, next] : {std::pair(from, to), std::pair(to, from)}) {
        MeetNode &own = meet_.nodes[static_cast<size_t>(node)];
        own.kind = NodeKind::edge;
        own.gap = match.apart;
        own.next = next;
    }
    joined_[match.from] = joined_[match.to] = true;
}

void MeetJoints::tell_open_ends() {
    for (size_t i = 0; i < ends_.size(); ++i) {
        if (joined_[i]) {
            continue;
        }
        if (is_common_edge(ends_[i].branch)) { // both surfaces end there, so that nothing need continue
            meet_.branches[ends_[i].branch].kind = intersect::BranchKind::edge;
        } else {
            meet_.nodes[static_cast<size_t>(node_of(ends_[i]))].kind = NodeKind::undecided;
        }
    }
}

// Whether a branch runs along the borders of both faces from end to end.
bool MeetJoints::is_common_edge(size_t branch) const {
    const MeetBranch &own = meet_.branches[branch];
    const FacePair &faces = of_branches_[branch];
    return own.kind == intersect::BranchKind::edge ||
           (face::runs_along_border(*models_[0]->shape(faces.a), *own.on) &&
            face::runs_along_border(*models_[1]->shape(faces.b), *own.on_second));
}

} // namespace nrb::model

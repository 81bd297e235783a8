// SPDX-License-Identifier: MIT
#include "model/sections/section_joints.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace nrb::model {

namespace {

using intersect::MeetBranch;
using intersect::MeetNode;
using intersect::NodeKind;

// Calls visit(items) for each group of items with a common key, sorted by their order.
template <class Item, class Visit>
void visit_groups(std::vector<Item> &items, Visit &&visit) {
    std::ranges::sort(items, [](const Item &a, const Item &b) {
        return std::tie(a.key, a.order, a.end) < std::tie(b.key, b.order, b.end);
    });
    for (size_t begin = 0, end = 0; begin < items.size(); begin = end) {
        while (end < items.size() && items[end].key == items[begin].key) {
            ++end;
        }
        visit(std::span<const Item>(items).subspan(begin, end - begin));
        count_work(static_cast<int64_t>(100 * (end - begin)));
    }
}

} // namespace

SectionJoints::SectionJoints(const Model &model, const SharedBorders &borders,
                             const std::vector<Placement> &placements, std::span<const Vector3> normals,
                             FaceSections &sections)
    : model_(model), borders_(borders), placements_(placements), normals_(normals), sections_(sections),
      joined_(sections.ends.size(), false), dropped_(sections.meet.branches.size(), false) {}

void SectionJoints::run() {
    join_on_edges();
    join_at_corners();
    join_in_touches();
    tell_open_ends();
    std::vector<MeetBranch> &branches = sections_.meet.branches;
    size_t i = 0;
    std::erase_if(branches, [&](const MeetBranch &) { return dropped_[i++]; });
}

bool SectionJoints::is_open(const SectionEnd &end) const noexcept {
    const auto number = static_cast<size_t>(&end - sections_.ends.data());
    const MeetNode &node = sections_.meet.nodes[static_cast<size_t>(node_of(end))];
    return !joined_[number] && node.next < 0 && node.kind != NodeKind::undecided;
}

// An end belongs to the edge nearest to it.
void SectionJoints::join_on_edges() {
    std::vector<Item> items;
    for (size_t i = 0; i < sections_.ends.size(); ++i) {
        const SectionEnd &end = sections_.ends[i];
        if (end.places.empty() || !is_open(end)) {
            continue;
        }
        const SharedCoedge &coedge = borders_.coedge(end.places.front().coedge);
        if (coedge.pair >= 0) {
            const MeetBranch &branch = branch_of(end);
            const double param = end.places.front().param;
            items.push_back(
                {{branch.level, branch.instance, coedge.pair, 0}, coedge.against ? -param : param, i});
        }
    }
    visit_groups(items, [&](std::span<const Item> group) { join_on_edge(group); });
}

void SectionJoints::join_on_edge(std::span<const Item> items) {
    std::array<std::vector<Item>, 2> sides;
    bool closed = false;
    for (const Item &item : items) {
        const SharedCoedge &coedge = borders_.coedge(sections_.ends[item.end].places.front().coedge);
        sides[static_cast<size_t>(coedge.side)].push_back(item);
        closed = closed || coedge.start == coedge.end;
    }
    if (sides[0].empty() || sides[1].empty()) {
        return;
    }
    if (closed) { // the curves of the two faces may begin at different places
        const SectionEnd &first = sections_.ends[sides[0].front().end];
        const auto far = [&](const Item &item) {
            const SectionEnd &end = sections_.ends[item.end];
            return end.begins == first.begins ? infinity : length(end.point - first.point);
        };
        std::rotate(sides[1].begin(), std::ranges::min_element(sides[1], {}, far), sides[1].end());
    }
    join_in_order(sides[0], sides[1]);
}

// Joins the ends on both sides of an edge pairwise, in their order along it. Ends without a counterpart are
// skipped, as few as possible and at most `most` at once.
void SectionJoints::join_in_order(std::span<const Item> a, std::span<const Item> b) {
    constexpr size_t most = 4;
    size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        bool found = false;
        for (size_t skip = 0; skip <= most && !found; ++skip) {
            for (size_t k = 0; k <= skip && !found; ++k) {
                const size_t next = i + k, other = j + skip - k;
                if (next < a.size() && other < b.size() && fit(a[next].end, b[other].end)) {
                    join(a[next].end, b[other].end);
                    i = next + 1;
                    j = other + 1;
                    found = true;
                }
            }
        }
        if (!found) {
            ++i;
            ++j;
        }
    }
}

// Along an edge that is nearly parallel to the plane a small error moves the end of a section far. The
// distance of two ends may be larger by the reciprocal of the sine of the angle, which counts as at least
// 1/256.
bool SectionJoints::fit(size_t a, size_t b) const {
    const SectionEnd &one = sections_.ends[a], &other = sections_.ends[b];
    if (one.begins == other.begins) {
        return false;
    }
    const double gap = length(one.point - other.point), room = one.room + other.room;
    if (gap <= room) {
        return true;
    }
    constexpr double least = 1.0 / 256;
    return gap * least <= room && gap * std::max(least, std::min(slope(one), slope(other))) <= room;
}

const face::Coedge &SectionJoints::coedge_of(int64_t number) const {
    const SharedCoedge &coedge = borders_.coedge(number);
    const face::Face &face = *model_.faces[static_cast<size_t>(coedge.face)].face;
    return face.loops()[static_cast<size_t>(coedge.loop)][static_cast<size_t>(coedge.index)];
}

Vector3 SectionJoints::point_on(const SectionEnd &end, int64_t coedge, double param) const {
    const face::Face &face = *model_.faces[static_cast<size_t>(borders_.coedge(coedge).face)].face;
    const Interval domain = coedge_of(coedge).curve->axis(0).domain();
    const std::vector<double> on =
        eval::curve_point(*coedge_of(coedge).curve, std::clamp(param, domain.lower, domain.upper), false);
    const std::vector<double> x = face::point_at(*face.surface(), face.covering().in_domain({on[0], on[1]}));
    return placements_[static_cast<size_t>(branch_of(end).instance)].in_whole({x[0], x[1], x[2]});
}

// The sine of the angle between the edge and the plane.
double SectionJoints::slope(const SectionEnd &end) const {
    const auto &[coedge, param] = end.places.front();
    const Interval domain = coedge_of(coedge).curve->axis(0).domain();
    const double step = (domain.upper - domain.lower) / 4096;
    const Vector3 way = point_on(end, coedge, param + step) - point_on(end, coedge, param - step);
    const Vector3 &normal = normals_[static_cast<size_t>(branch_of(end).level)];
    const double far = length(way) * length(normal);
    return far > 0 ? std::abs(dot(way, normal)) / far : 0;
}

// The nearest corner within the room of an end; -1: none.
int64_t SectionJoints::corner_near(const SectionEnd &end) const {
    int64_t found = -1;
    double least = end.room;
    for (const SectionEnd::Place &place : end.places) {
        const SharedCoedge &coedge = borders_.coedge(place.coedge);
        const Interval domain = coedge_of(place.coedge).curve->axis(0).domain();
        const std::array<std::pair<double, int64_t>, 2> both{
            {{domain.lower, coedge.start}, {domain.upper, coedge.end}}};
        for (const auto &[param, corner] : both) {
            const double far = length(point_on(end, place.coedge, param) - end.point);
            if (far <= least) {
                least = far;
                found = corner;
            }
        }
    }
    return found;
}

void SectionJoints::join_at_corners() {
    std::vector<Item> items;
    for (size_t i = 0; i < sections_.ends.size(); ++i) {
        const SectionEnd &end = sections_.ends[i];
        if (!is_open(end)) {
            continue;
        }
        if (const int64_t corner = corner_near(end); corner >= 0) {
            const MeetBranch &branch = branch_of(end);
            const int64_t solid = model_.faces[static_cast<size_t>(branch.face)].solid;
            items.push_back({{branch.level, branch.instance, solid, corner}, 0, i});
        }
    }
    visit_groups(items, [&](std::span<const Item> group) { join_at_corner(group); });
}

void SectionJoints::join_at_corner(std::span<const Item> items) {
    std::map<int64_t, std::vector<size_t>> of_branch;
    for (const Item &item : items) {
        of_branch[sections_.ends[item.end].branch].push_back(item.end);
    }
    std::array<std::vector<size_t>, 2> open;
    for (const auto &[branch, ends] : of_branch) {
        const SectionEnd &first = sections_.ends[ends.front()];
        const bool through = ends.size() == 2 && is_short(first);
        dropped_[static_cast<size_t>(branch)] = through;
        for (const size_t end : ends) {
            joined_[end] = through;
            if (!through) {
                open[sections_.ends[end].begins ? 1 : 0].push_back(end);
            }
        }
    }
    if (open[0].size() == 1 && open[1].size() == 1 && fit(open[0][0], open[1][0])) {
        join(open[0][0], open[1][0]);
    }
}

// Whether a branch stays within twice the room of its end. It does if its control points do (convex hull
// property).
bool SectionJoints::is_short(const SectionEnd &end) const {
    const Spline &curve = *branch_of(end).space;
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        const Vector3 x{curve.coordinate(i, 0), curve.coordinate(i, 1), curve.coordinate(i, 2)};
        if (!(length(x - end.point) <= 2 * end.room)) {
            return false;
        }
    }
    return true;
}

// Joins branches at poles, where exactly one ends and one begins at the same place.
void SectionJoints::join_in_touches() {
    std::map<int64_t, std::vector<size_t>> of_node;
    for (size_t i = 0; i < sections_.ends.size(); ++i) {
        const SectionEnd &end = sections_.ends[i];
        if (is_open(end) && sections_.meet.nodes[static_cast<size_t>(node_of(end))].kind == NodeKind::touch) {
            of_node[node_of(end)].push_back(i);
        }
    }
    for (const auto &[node, ends] : of_node) {
        if (ends.size() != 2) {
            continue;
        }
        const SectionEnd &one = sections_.ends[ends[0]], &other = sections_.ends[ends[1]];
        if (one.begins != other.begins && length(one.point - other.point) <= one.room + other.room) {
            join(ends[0], ends[1]);
        }
    }
}

// A border node belongs to one end and becomes an edge node. A node of another kind, such as a touch, is
// reported itself: it stays, and the end gets a node of its own.
void SectionJoints::join(size_t a, size_t b) {
    std::vector<MeetNode> &nodes = sections_.meet.nodes;
    const double gap = length(sections_.ends[a].point - sections_.ends[b].point);
    for (const size_t i : {a, b}) {
        const SectionEnd &end = sections_.ends[i];
        if (nodes[static_cast<size_t>(node_of(end))].kind != NodeKind::border) {
            nodes.push_back(nodes[static_cast<size_t>(node_of(end))]);
            node_of(end) = std::ssize(nodes) - 1;
        }
        MeetNode &node = nodes[static_cast<size_t>(node_of(end))];
        node.kind = NodeKind::edge;
        node.gap = gap;
        joined_[i] = true;
    }
    const int64_t one = node_of(sections_.ends[a]), other = node_of(sections_.ends[b]);
    nodes[static_cast<size_t>(one)].next = other;
    nodes[static_cast<size_t>(other)].next = one;
}

void SectionJoints::tell_open_ends() {
    for (const SectionEnd &end : sections_.ends) {
        MeetNode &node = sections_.meet.nodes[static_cast<size_t>(node_of(end))];
        const bool shared = std::ranges::any_of(end.places, [&](const SectionEnd::Place &place) {
            return borders_.coedge(place.coedge).pair >= 0;
        });
        if (is_open(end) && (node.kind == NodeKind::seam || (node.kind == NodeKind::border && shared))) {
            node.kind = NodeKind::undecided;
        }
    }
}

} // namespace nrb::model

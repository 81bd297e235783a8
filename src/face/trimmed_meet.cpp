// SPDX-License-Identifier: MIT
#include "face/trimmed_meet.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "face/border_pieces.h"
#include "face/places_inside.h"
#include "intersect/pairs/curve_curve.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace nrb::face {

namespace {

using intersect::Meet;
using intersect::MeetBranch;
using intersect::MeetNode;
using intersect::NodeKind;

// Trims the branches of a meet one after the other, and collects what is kept.
class Trimming {
public:
    // apart: whether what runs along the border gets branches of its own.
    Trimming(const Face &face, const Meet &meet, size_t surface, bool apart, const PartsOfBranches &left_out)
        : face_(face), meet_(meet), surface_(surface), border_(face), apart_(apart), left_out_(left_out) {
        result_.of_two = meet.of_two;
        result_.periodic = meet.periodic;
        result_.limited = meet.limited;
    }

    BorderedMeet run() {
        keep_nodes();
        Steps steps(std::ssize(meet_.branches));
        for (const MeetBranch &branch : meet_.branches) {
            if (branch.kind != intersect::BranchKind::overlap) {
                add(branch);
            }
            steps.next();
        }
        close_loops();
        join_nodes();
        result_.complete = std::ranges::none_of(
            result_.nodes, [](const MeetNode &node) { return node.kind == NodeKind::undecided; });
        return {std::move(result_), std::move(places_), std::move(courses_)};
    }

private:
    // Places beyond the domain, where meets of a continued surface may be, are outside.
    [[nodiscard]] bool is_inside(const Point2 &at) const {
        return !is_beyond({Interval{at[0], at[0]}, Interval{at[1], at[1]}}) &&
               face_.trims().side(face_.covering().in_domain(at)) >= 0;
    }
    [[nodiscard]] bool is_beyond(const std::array<Interval, 2> &range) const noexcept {
        for (const int k : {0, 1}) {
            const auto &[lower, upper] = range[static_cast<size_t>(k)];
            const Interval domain = face_.covering().domain(k);
            const double room = 1e-9 * face_.covering().period(k);
            if (!face_.covering().closed(k) && (upper < domain.lower - room || lower > domain.upper + room)) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] bool is_inside(const MeetBranch &branch, double t) const {
        return is_inside(place_on(*curve_of(branch), t));
    }
    [[nodiscard]] bool is_outside(const std::array<Interval, 2> &range) const {
        return is_beyond(range) ||
               face::is_outside(face_, {range[0].lower, range[1].lower}, {range[0].upper, range[1].upper});
    }
    // The curve on the surface of the face.
    [[nodiscard]] const SplinePtr &curve_of(const MeetBranch &branch) const noexcept {
        return surface_ == 0 ? branch.on : branch.on_second;
    }
    [[nodiscard]] const std::array<double, 2> &place_of(const MeetNode &node) const noexcept {
        return surface_ == 0 ? node.at : node.at_second;
    }
    [[nodiscard]] const std::array<Interval, 2> &range_of(const MeetNode &node) const noexcept {
        return surface_ == 0 ? node.range : node.range_second;
    }
    static Point2 place_on(const Spline &curve, double t) {
        const std::vector<double> at = eval::curve_point(curve, t, false);
        return {at[0], at[1]};
    }

    // Nodes at which branches end are kept with these. What the face contains of a region of overlap is not
    // computed: such a region becomes undecided.
    void keep_nodes() {
        new_node_.assign(meet_.nodes.size(), -1);
        for (size_t i = 0; i < meet_.nodes.size(); ++i) {
            const MeetNode &node = meet_.nodes[i];
            if ((node.kind == NodeKind::undecided && !is_outside(range_of(node))) ||
                (node.kind == NodeKind::touch && is_inside(place_of(node)))) {
                new_node_[i] = add_node(node);
            }
            if (node.kind == NodeKind::overlap && !is_outside(range_of(node))) {
                MeetNode open = node;
                open.kind = NodeKind::undecided;
                open.level = 0;
                add_node(open);
            }
        }
    }
    int64_t add_node(const MeetNode &node) {
        result_.nodes.push_back(node);
        return std::ssize(result_.nodes) - 1;
    }
    int64_t kept(int64_t node) {
        int64_t &place = new_node_[static_cast<size_t>(node)];
        place = place < 0 ? add_node(meet_.nodes[static_cast<size_t>(node)]) : place;
        return place;
    }
    int64_t node_on(const MeetBranch &branch, double t, NodeKind kind) {
        MeetNode node{branch.level, kind, {}, {}};
        set_place(place_at(branch, t, 0), node.at, node.range);
        if (meet_.of_two) {
            set_place(place_at(branch, t, 1), node.at_second, node.range_second);
        }
        return add_node(node);
    }
    static void set_place(const Point2 &at, std::array<double, 2> &place, std::array<Interval, 2> &range) {
        place = at;
        range = {Interval{at[0], at[0]}, Interval{at[1], at[1]}};
    }
    // The place in the domain.
    [[nodiscard]] Point2 place_at(const MeetBranch &branch, double t, size_t surface) const {
        const Point2 at = place_on(surface == 0 ? *branch.on : *branch.on_second, t);
        return surface == surface_ ? face_.covering().in_domain(at) : in_domain(at, meet_.periodic[surface]);
    }
    static Point2 in_domain(Point2 at, const std::array<std::optional<Interval>, 2> &periodic) noexcept {
        for (size_t k = 0; k < 2; ++k) {
            if (periodic[k]) {
                const auto &[lower, upper] = *periodic[k];
                const double turns = std::floor((at[k] - lower) / (upper - lower));
                at[k] = std::clamp(at[k] - turns * (upper - lower), lower, upper);
            }
        }
        return at;
    }

    // at: parameters, with places on the border, at which a branch may enter or leave the face, and ends of
    // the parts that are left out. along: where the branch runs along the border.
    struct Crossing {
        double at;
        BorderPlace place;
    };
    struct Passage {
        Interval range;
        Course course;
    };
    struct Crossings {
        std::vector<Crossing> at; // ascending
        std::vector<Passage> along;
    };
    Crossings crossings(const MeetBranch &branch) {
        Crossings found;
        for (const Interval &part : parts_left_out(branch)) {
            found.at.push_back({part.lower, {}});
            found.at.push_back({part.upper, {}});
        }
        border_.visit_near(
            *curve_of(branch), [&](const Spline &own, const Spline &curve, const TrimPiece &piece) {
                const intersect::PairHits hits = intersect::curve_curve(own, curve, border_.room());
                for (const intersect::PairHit &hit : hits.list) {
                    if (hit.kind == intersect::HitKind::undecided) {
                        node_on(branch, hit.a, NodeKind::undecided);
                    }
                    if (hit.kind == intersect::HitKind::overlap) {
                        found.at.push_back({hit.range_a.lower, border_.place_of(piece, hit.from_b)});
                        found.at.push_back({hit.range_a.upper, border_.place_of(piece, hit.to_b)});
                        const bool with_loop = (hit.from_b < hit.to_b) != border_.is_turned(piece);
                        const BorderPlace &place = found.at.back().place;
                        found.along.push_back({hit.range_a,
                                               {with_loop ? Direction::with_loop : Direction::against_loop,
                                                place.loop, place.index}});
                    } else {
                        found.at.push_back({hit.a, border_.place_of(piece, hit.b)});
                    }
                }
            });
        std::ranges::sort(found.at, {}, &Crossing::at);
        return found;
    }

    [[nodiscard]] std::span<const Interval> parts_left_out(const MeetBranch &branch) const noexcept {
        const auto number = static_cast<size_t>(&branch - meet_.branches.data());
        return left_out_.empty() ? std::span<const Interval>() : left_out_[number];
    }

    // A part of a branch that is kept.
    struct KeptPart {
        Interval range;
        Course course;
    };
    // Keeps the parts that are inside or on the border; those that continue each other become one.
    void add(const MeetBranch &branch) {
        const Interval domain = branch.on->axis(0).domain();
        const Crossings found = crossings(branch);
        std::vector<KeptPart> parts;
        const std::vector<double> breaks = breaks_of(domain, found);
        for (size_t i = 0; i + 1 < breaks.size(); ++i) {
            const double middle = breaks[i] / 2 + breaks[i + 1] / 2;
            const auto along = std::ranges::find_if(found.along, [&](const Passage &passage) {
                return passage.range.lower <= middle && middle <= passage.range.upper;
            });
            const bool left_out = std::ranges::any_of(parts_left_out(branch), [middle](const Interval &part) {
                return part.lower <= middle && middle <= part.upper;
            });
            if (left_out || (along == found.along.end() && !is_inside(branch, middle))) {
                continue;
            }
            const Course course = along == found.along.end() || !apart_ ? Course{} : along->course;
            if (!parts.empty() && parts.back().range.upper == breaks[i] && parts.back().course == course) {
                parts.back().range.upper = breaks[i + 1];
            } else {
                parts.push_back({{breaks[i], breaks[i + 1]}, course});
            }
        }
        add_parts(branch, parts, found);
    }

    static std::vector<double> breaks_of(const Interval &domain, const Crossings &found) {
        const double least = 1e-12 * (domain.upper - domain.lower);
        std::vector<double> breaks{domain.lower};
        for (const Crossing &crossing : found.at) {
            if (crossing.at > breaks.back() + least && crossing.at < domain.upper - least) {
                breaks.push_back(crossing.at);
            }
        }
        breaks.push_back(domain.upper);
        return breaks;
    }

    void add_parts(const MeetBranch &branch, const std::vector<KeptPart> &parts, const Crossings &found) {
        const Interval domain = branch.on->axis(0).domain();
        const auto is_all = [&](const KeptPart &part) {
            return part.range.lower == domain.lower && part.range.upper == domain.upper;
        };
        const bool whole = parts.size() == 1 && is_all(parts[0]);
        if (branch.loop >= 0 && !whole) {
            cut_loops_.insert(branch.loop);
        }
        const size_t first = result_.branches.size();
        for (const KeptPart &part : parts) {
            add_part(branch, part, whole, found);
        }
        if (branch.nodes[0] < 0 && !whole && !parts.empty()) {
            const bool left = std::ranges::any_of(parts_left_out(branch), [&](const Interval &out) {
                return out.lower == domain.lower || out.upper == domain.upper;
            });
            join_where_cut(first, left ? NodeKind::edge : NodeKind::border);
        }
    }

    // Connects the first and the last part of a closed branch where it was cut at its start. A part that ends
    // there alone ends in a node of the given kind, as it does not continue.
    void join_where_cut(size_t first, NodeKind end_kind) {
        const int64_t begin = result_.branches[first].nodes[0], end = result_.branches.back().nodes[1];
        MeetNode &a = result_.nodes[static_cast<size_t>(begin)], &b = result_.nodes[static_cast<size_t>(end)];
        if (a.kind == NodeKind::seam && b.kind == NodeKind::seam) {
            a.next = end;
            b.next = begin;
            return;
        }
        for (MeetNode *node : {&a, &b}) {
            node->kind = node->kind == NodeKind::seam ? end_kind : node->kind;
        }
    }

    void add_part(const MeetBranch &branch, const KeptPart &part, bool whole, const Crossings &found) {
        const Interval domain = branch.on->axis(0).domain();
        const bool closed = branch.nodes[0] < 0;
        MeetBranch own = branch;
        if (!whole) {
            for (SplinePtr *curve : {&own.space, &own.on, &own.on_second}) {
                *curve =
                    *curve ? refine::restrict_axis(*curve, 0, part.range.lower, part.range.upper) : nullptr;
            }
        }
        std::array<std::vector<BorderPlace>, 2> places;
        if (!whole || !closed) {
            const auto end = [&](double t, double of_branch, size_t i) {
                const bool left = std::ranges::any_of(parts_left_out(branch), [t](const Interval &out) {
                    return t == out.lower || t == out.upper;
                });
                const int64_t node = t != of_branch
                                         ? node_on(branch, t, left ? NodeKind::edge : NodeKind::border)
                                     : closed ? node_on(branch, t, NodeKind::seam)
                                              : kept(branch.nodes[i]);
                places[i] = places_at(node, branch, t, found);
                return node;
            };
            own.nodes = {end(part.range.lower, domain.lower, 0), end(part.range.upper, domain.upper, 1)};
        }
        result_.branches.push_back(std::move(own));
        courses_.push_back(part.course);
        places_.push_back(std::move(places));
    }

    // The places on the border of all crossings that are too near to be told apart.
    std::vector<BorderPlace> places_at(int64_t node, const MeetBranch &branch, double t,
                                       const Crossings &found) const {
        if (!apart_) {
            return {};
        }
        const Interval domain = branch.on->axis(0).domain();
        const double room = 1e-8 * (domain.upper - domain.lower);
        std::vector<std::pair<double, size_t>> near;
        const auto first = std::ranges::lower_bound(found.at, t - room, {}, &Crossing::at);
        for (auto at = first; at != found.at.end() && at->at <= t + room; ++at) {
            near.emplace_back(std::abs(at->at - t), static_cast<size_t>(at - found.at.begin()));
        }
        std::ranges::sort(near);
        std::vector<BorderPlace> places;
        places.reserve(near.size());
        for (const auto &[apart, number] : near) {
            places.push_back(found.at[number].place);
        }
        const NodeKind kind = result_.nodes[static_cast<size_t>(node)].kind;
        if (places.empty() && (kind == NodeKind::border || kind == NodeKind::seam)) {
            places = border_.nearest_to(place_of(result_.nodes[static_cast<size_t>(node)]));
        }
        return places;
    }

    // Connects nodes that are connected in the given meet, if both are kept.
    void join_nodes() {
        for (size_t i = 0; i < new_node_.size(); ++i) {
            if (new_node_[i] >= 0) {
                const int64_t next = meet_.nodes[i].next;
                result_.nodes[static_cast<size_t>(new_node_[i])].next =
                    next < 0 ? -1 : new_node_[static_cast<size_t>(next)];
            }
        }
    }

    // Loops of which nothing was cut off stay loops.
    void close_loops() {
        std::map<int64_t, int64_t> names;
        for (MeetBranch &branch : result_.branches) {
            if (branch.loop >= 0) {
                branch.loop = cut_loops_.contains(branch.loop)
                                  ? -1
                                  : names.try_emplace(branch.loop, std::ssize(names)).first->second;
            }
        }
    }

    const Face &face_;
    const Meet &meet_;
    size_t surface_; // the one of the face
    BorderPieces border_;
    bool apart_;
    const PartsOfBranches &left_out_;
    std::vector<int64_t> new_node_;
    std::set<int64_t> cut_loops_;
    Meet result_;
    std::vector<std::array<std::vector<BorderPlace>, 2>> places_;
    std::vector<Course> courses_;
};

} // namespace

Meet trimmed(const Face &face, const Meet &meet, size_t surface, const PartsOfBranches &left_out) {
    return Trimming(face, meet, surface, false, left_out).run().meet;
}

BorderedMeet trimmed_with_places(const Face &face, const Meet &meet) {
    return Trimming(face, meet, 0, true, {}).run();
}

} // namespace nrb::face

// SPDX-License-Identifier: MIT
#include "face/kept/bridges.h"

#include "base/numbers.h"
#include "bounds/box.h"
#include "build/polylines.h"
#include "closest/closest.h"
#include "eval/curve_point.h"
#include "refine/parts/cut.h"
#include "refine/parts/join.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace nrb::face {

namespace {

using intersect::NodeKind;

// The size of a place in tolerances: the same as the distance of a mark from its node in arrangements (Cuts).
constexpr double widest_place = 16;

// An end of the domain that the face maps to a pole.
struct PoleEnd {
    size_t axis;
    int end;
};

struct PlaceBox {
    std::array<double, 3> lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};

    void add(const std::vector<double> &from, const std::vector<double> &to) {
        for (size_t c = 0; c < 3; ++c) {
            lower[c] = std::min(lower[c], from[c]);
            upper[c] = std::max(upper[c], to[c]);
        }
    }
    // Whether all of the box is within a distance of x.
    [[nodiscard]] bool is_near(const std::vector<double> &x, double distance) const {
        double farthest = 0;
        for (size_t c = 0; c < 3; ++c) {
            farthest = std::hypot(farthest, std::max(x[c] - lower[c], upper[c] - x[c]));
        }
        return farthest <= distance;
    }
};

class Bridging {
public:
    Bridging(const Face &face, const Spline &surface, const intersect::Meet &meet, double tolerance)
        : face_(face), surface_(surface), meet_(meet),
          tolerance_(tolerance), result_{{}, std::vector<bool>(meet.nodes.size(), false)},
          leads_to_(meet.branches.size()), left_out_(meet.branches.size()) {}

    Bridges run() {
        for (const size_t axis : {size_t{0}, size_t{1}}) {
            for (const int end : {0, 1}) {
                if (covering().collapsed(static_cast<int>(axis), end)) {
                    bridge_pole({axis, end});
                }
            }
        }
        for (const NodeKind kind : {NodeKind::touch, NodeKind::undecided}) {
            for (size_t i = 0; i < meet_.nodes.size(); ++i) {
                if (meet_.nodes[i].kind == kind && !result_.nodes[i]) {
                    bridge_place(i);
                }
            }
        }
        for (size_t i = 0; i < meet_.branches.size(); ++i) {
            if (meet_.branches[i].kind != intersect::BranchKind::touch && !left_out_[i]) {
                result_.curves.push_back(extended(i));
            }
        }
        return std::move(result_);
    }

private:
    struct End {
        size_t branch;
        bool upper;
    };
    using Members = std::vector<size_t>; // nodes

    [[nodiscard]] const Covering &covering() const noexcept { return face_.covering(); }
    [[nodiscard]] const intersect::MeetNode &node(size_t i) const noexcept { return meet_.nodes[i]; }
    [[nodiscard]] double end_of(const PoleEnd &pole) const noexcept {
        const Interval domain = covering().domain(static_cast<int>(pole.axis));
        return pole.end == 0 ? domain.lower : domain.upper;
    }
    [[nodiscard]] std::vector<double> point(const Point2 &x) const {
        return point_at(*face_.surface(), covering().in_domain(x));
    }

    // Whether all that a node stands for is within widest_place tolerances of a point.
    [[nodiscard]] bool is_within(size_t i, const std::vector<double> &of) const {
        const auto &[u, v] = node(i).range;
        const double most = widest_place * tolerance_;
        PlaceBox box;
        for (const Point2 &x : {node(i).at, Point2{u.lower, v.lower}, Point2{u.upper, v.upper}}) {
            const std::vector<double> own = point(x);
            box.add(own, own);
            if (!box.is_near(of, most)) {
                return false;
            }
        }
        add_parts(i, box);
        return box.is_near(of, most);
    }
    // Adds the image of the box of a node. A box that extends over a seam has parts on both sides of it.
    void add_parts(size_t i, PlaceBox &box) const {
        const auto &[u, v] = node(i).range;
        covering_moves({u.lower, v.lower}, {u.upper, v.upper}, [&](const Point2 &move) {
            Part part{};
            for (size_t k = 0; k < 2; ++k) {
                const Interval domain = covering().domain(static_cast<int>(k)), own = node(i).range[k];
                part[k] = {std::max(own.lower + move[k], domain.lower),
                           std::min(own.upper + move[k], domain.upper)};
            }
            if (part[0].lower < part[0].upper && part[1].lower < part[1].upper) {
                const bounds::Box own = bounds::bounding_box(*face_.surface(), part, tolerance_);
                box.add(own.lower, own.upper);
            }
        });
    }
    template <class Visit>
    void covering_moves(const Point2 &lower, const Point2 &upper, Visit &&visit) const {
        visit(Point2{0, 0});
        covering().any_move(lower, upper, [&](const Point2 &move) {
            if (move != Point2{0, 0}) {
                visit(move);
            }
            return false;
        });
    }

    // Whether an end is at one of the nodes, or at a seam in the place: the place continues beyond the seam.
    [[nodiscard]] bool is_of(const End &end, const Members &members, const std::vector<double> &of) const {
        const int64_t own = meet_.branches[end.branch].nodes[end.upper ? 1 : 0];
        return own >= 0 && (std::ranges::binary_search(members, static_cast<size_t>(own)) ||
                            (meet_.nodes[static_cast<size_t>(own)].kind == NodeKind::seam &&
                             is_within(static_cast<size_t>(own), of)));
    }
    // The ends of dividing branches at a place.
    [[nodiscard]] std::vector<End> ends_at(const Members &members, const std::vector<double> &of) const {
        std::vector<End> ends;
        for (size_t i = 0; i < meet_.branches.size(); ++i) {
            if (meet_.branches[i].kind == intersect::BranchKind::touch || left_out_[i] || is_all_at(i, of)) {
                continue;
            }
            for (const bool upper : {false, true}) {
                if (is_of({i, upper}, members, of)) {
                    ends.push_back({i, upper});
                }
            }
        }
        return ends;
    }
    // Whether all of a branch is in a place: rounding leaves such branches along poles. Branches are
    // parametrized by about their length.
    [[nodiscard]] bool is_all_at(size_t branch, const std::vector<double> &of) const {
        const double place_size = widest_place * tolerance_;
        const Interval domain = meet_.branches[branch].on->axis(0).domain();
        PlaceBox box;
        for (const bool upper : {false, true}) {
            const std::vector<double> end = point(place({branch, upper}));
            box.add(end, end);
        }
        return domain.upper - domain.lower <= place_size && box.is_near(of, place_size);
    }
    [[nodiscard]] Point2 place(const End &end) const {
        Point2 x;
        eval::end_point(*meet_.branches[end.branch].on, end.upper, x.data());
        return x;
    }
    // The length by which a branch is cut back before it is continued: the nearer a branch comes to a pole,
    // the shorter are the cubics of which it consists.
    [[nodiscard]] double cut_of(size_t branch) const {
        const Interval domain = meet_.branches[branch].on->axis(0).domain();
        return std::min(4 * widest_place * tolerance_, (domain.upper - domain.lower) / 4);
    }
    [[nodiscard]] Point2 cut_place(const End &end) const {
        const Spline &on = *meet_.branches[end.branch].on;
        const Interval domain = on.axis(0).domain();
        const double cut = cut_of(end.branch);
        Point2 x;
        eval::curve_point(on, end.upper ? domain.upper - cut : domain.lower + cut, false, x.data());
        return x;
    }
    // A branch continued by segments to the places that its ends lead to.
    [[nodiscard]] SplinePtr extended(size_t branch) const {
        const SplinePtr &on = meet_.branches[branch].on;
        const auto &[first, last] = leads_to_[branch];
        if (!first && !last) {
            return on;
        }
        const Interval domain = on->axis(0).domain();
        const double cut = cut_of(branch);
        const SplinePtr kept = refine::restrict_axis(on, 0, first ? domain.lower + cut : domain.lower,
                                                     last ? domain.upper - cut : domain.upper);
        const auto segment = [&](const Point2 &from, const Point2 &to) {
            return build::polyline(2, {from[0], from[1], to[0], to[1]}, {0, cut});
        };
        std::vector<SplinePtr> parts{kept};
        Point2 end;
        if (first) {
            eval::end_point(*kept, false, end.data());
            parts.insert(parts.begin(), segment(*first, end));
        }
        if (last) {
            eval::end_point(*kept, true, end.data());
            parts.push_back(segment(end, *last));
        }
        return refine::join(parts, 0, {0, false}).spline;
    }

    void bridge_pole(const PoleEnd &pole) {
        Point2 at{covering().domain(0).lower, covering().domain(1).lower};
        at[pole.axis] = end_of(pole);
        const std::vector<double> of = point(at);
        Members members;
        for (size_t i = 0; i < meet_.nodes.size(); ++i) {
            const Interval range = node(i).range[pole.axis];
            const bool reaches = range.lower <= end_of(pole) && end_of(pole) <= range.upper;
            if ((node(i).kind == NodeKind::touch && reaches) ||
                (node(i).kind == NodeKind::undecided && is_within(i, of))) {
                members.push_back(i);
            }
        }
        bridge(members, of, [&](Point2 from) {
            from[pole.axis] = end_of(pole);
            return from;
        });
    }

    // Lets all ends at a place lead to what place_for() has for each of them; does nothing if one of the
    // segments leaves the surface.
    template <class Place>
    void bridge(const Members &members, const std::vector<double> &of, Place &&place_for) {
        const std::vector<End> ends = ends_at(members, of);
        std::vector<Point2> places;
        for (const End &end : ends) {
            const Point2 from = cut_place(end);
            places.push_back(place_for(from));
            if (!is_along(from, places.back())) {
                return;
            }
        }
        for (size_t i = 0; i < ends.size(); ++i) {
            leads_to_[ends[i].branch][ends[i].upper ? 1 : 0] = places[i];
        }
        for (const size_t i : members) {
            result_.nodes[i] = true;
        }
        for (size_t i = 0; i < meet_.branches.size(); ++i) {
            left_out_[i] = left_out_[i] || is_all_at(i, of);
        }
    }

    void bridge_place(size_t first) {
        const std::vector<double> of = point(node(first).at);
        if (node(first).kind == NodeKind::undecided && !is_within(first, of)) {
            return;
        }
        Members members;
        for (size_t i = 0; i < meet_.nodes.size(); ++i) {
            const bool open = node(i).kind == NodeKind::undecided && !result_.nodes[i];
            if (i == first || (open && is_within(i, of))) {
                members.push_back(i);
            }
        }
        const std::vector<End> ends = ends_at(members, of);
        const Point2 at = ends.size() == 2 ? place(ends[0]) : node(first).at;
        if (ends.size() >= 2) { // with fewer, what is open may divide a face as narrow there
            bridge(members, of, [&](const Point2 &from) { return covering().nearest_copy(at, from); });
        }
    }

    // Whether the image of a segment is, at samples, within the tolerance of the surface.
    [[nodiscard]] bool is_along(const Point2 &from, const Point2 &to) const {
        constexpr int samples = 8;
        constexpr double rounding = 0x1p-44;
        for (int i = 0; i <= samples; ++i) {
            const double t = static_cast<double>(i) / samples;
            const std::vector<double> x =
                point({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
            const closest::Foot foot = closest::locator_of(surface_).nearest(
                {x.data(), nullptr, tolerance_ / 64, closest::usual_budget(surface_), false, true});
            if (!(foot.distance <= tolerance_ + rounding * covering().extent())) {
                return false;
            }
        }
        return true;
    }

    const Face &face_;
    const Spline &surface_;
    const intersect::Meet &meet_;
    double tolerance_;
    Bridges result_;
    std::vector<std::array<std::optional<Point2>, 2>> leads_to_; // by branches and their ends
    std::vector<bool> left_out_;
};

} // namespace

Bridges bridges(const Face &face, const Spline &surface, const intersect::Meet &meet, double tolerance) {
    return Bridging(face, surface, meet, tolerance).run();
}

} // namespace nrb::face

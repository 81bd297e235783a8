// SPDX-License-Identifier: MIT
#include "face/trimmed_meet.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "intersect/pairs/curve_curve.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace nrb::face {

namespace {

using intersect::Meet;
using intersect::MeetBranch;
using intersect::MeetNode;
using intersect::NodeKind;

// Pieces of the border as curves, moved by periods of the domain; made once.
class Border {
public:
    explicit Border(const Face &face) : face_(face) {}

    // Calls visit(curve) for the pieces, moved to where they are near a curve in the plane that covers the domain.
    template <class Visit>
    void visit_near(const Spline &curve, Visit &&visit) {
        for (const auto &[piece, turns] : near(curve)) {
            visit(*moved(piece, turns));
        }
    }

private:
    using Turns = std::array<int, 2>;
    using Key = std::pair<const TrimPiece *, Turns>;

    // By the boxes of the control points that are active on each span.
    [[nodiscard]] std::set<Key> near(const Spline &curve) const {
        std::set<Key> found;
        const int p = curve.axis(0).degree();
        for (const int64_t span : curve.axis(0).spans().indices()) {
            Point2 lower{infinity, infinity}, upper{-infinity, -infinity};
            for (int64_t i = span - p; i <= span; ++i) {
                for (size_t k = 0; k < 2; ++k) {
                    const double x = curve.points()[2 * static_cast<size_t>(i) + k];
                    lower[k] = std::min(lower[k], x);
                    upper[k] = std::max(upper[k], x);
                }
            }
            add_in(lower, upper, found);
        }
        return found;
    }

    void add_in(const Point2 &lower, const Point2 &upper, std::set<Key> &found) const {
        const std::array<std::array<int, 2>, 2> range{turns_of(0, lower[0], upper[0]),
                                                      turns_of(1, lower[1], upper[1])};
        for (int i = range[0][0]; i <= range[0][1]; ++i) {
            for (int j = range[1][0]; j <= range[1][1]; ++j) {
                const Covering &covering = face_.covering();
                const Point2 by{i * covering.period(0), j * covering.period(1)};
                const Point2 from{lower[0] - by[0], lower[1] - by[1]}, to{upper[0] - by[0], upper[1] - by[1]};
                face_.trims().any_in(from, to, [&](const TrimPiece &piece) {
                    found.insert({&piece, {i, j}});
                    return false;
                });
            }
        }
    }
    // By how many periods the domain is moved to meet an interval.
    [[nodiscard]] std::array<int, 2> turns_of(int k, double lower, double upper) const noexcept {
        const Covering &covering = face_.covering();
        if (!covering.closed(k)) {
            return {0, 0};
        }
        const auto turn = [&](double x) {
            return static_cast<int>(std::floor((x - covering.domain(k).lower) / covering.period(k)));
        };
        return {turn(lower - 1e-9 * covering.period(k)), turn(upper + 1e-9 * covering.period(k))};
    }

    const SplinePtr &moved(const TrimPiece *piece, const Turns &turns) {
        SplinePtr &curve = curves_[{piece, turns}];
        if (!curve) {
            const std::span<const double> given = face_.trims().pieces().coefficients(*piece);
            std::vector<double> records(given.begin(), given.end());
            const size_t width = piece->weighted ? 3 : 2;
            for (size_t i = 0; i < records.size(); i += width) {
                for (size_t k = 0; k < 2; ++k) {
                    const double by = turns[k] * face_.covering().period(static_cast<int>(k));
                    records[i + k] += by * (piece->weighted ? records[i + 2] : 1);
                }
            }
            std::vector<double> knots(static_cast<size_t>(piece->degree) + 1, 0.0);
            knots.insert(knots.end(), knots.size(), 1.0);
            curve = make_result({make_knot_vector(piece->degree, std::move(knots))}, 2,
                                piece->weighted ? Form::homogeneous : Form::polynomial, std::move(records));
        }
        return curve;
    }

    const Face &face_;
    std::map<Key, SplinePtr> curves_;
};

class Trimming {
public:
    Trimming(const Face &face, const Meet &meet) : face_(face), meet_(meet), border_(face) {}

    Meet run() {
        keep_nodes();
        Steps steps(std::ssize(meet_.branches));
        for (const MeetBranch &branch : meet_.branches) {
            add(branch);
            steps.next();
        }
        close_loops();
        result_.complete = std::ranges::none_of(
            result_.nodes, [](const MeetNode &node) { return node.kind == NodeKind::undecided; });
        return std::move(result_);
    }

private:
    [[nodiscard]] bool is_inside(const Point2 &at) const {
        return face_.trims().side(face_.covering().in_domain(at)) >= 0;
    }
    [[nodiscard]] bool is_inside(const MeetBranch &branch, double t) const {
        const std::vector<double> at = eval::curve_point(*branch.on, t, false);
        return is_inside(Point2{at[0], at[1]});
    }

    // Those of branches come with them.
    void keep_nodes() {
        new_node_.assign(meet_.nodes.size(), -1);
        for (size_t i = 0; i < meet_.nodes.size(); ++i) {
            const MeetNode &node = meet_.nodes[i];
            if (node.kind == NodeKind::undecided || (node.kind == NodeKind::touch && is_inside(node.at))) {
                new_node_[i] = add_node(node);
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
        const std::vector<double> on = eval::curve_point(*branch.on, t, false);
        const Point2 at = face_.covering().in_domain({on[0], on[1]});
        return add_node({branch.level, kind, at, {Interval{at[0], at[0]}, Interval{at[1], at[1]}}});
    }

    // Parameters at which a branch may come in or go out, and where it runs along the border.
    struct Crossings {
        std::vector<double> at;
        std::vector<Interval> along;
    };
    Crossings crossings(const MeetBranch &branch) {
        constexpr double near = 1e-9; // of the domain: branches are no more exact than that
        const double size = std::max(face_.covering().period(0), face_.covering().period(1));
        Crossings found;
        border_.visit_near(*branch.on, [&](const Spline &piece) {
            const intersect::PairHits hits = intersect::curve_curve(*branch.on, piece, near * size);
            for (const intersect::PairHit &hit : hits.list) {
                if (hit.kind == intersect::HitKind::undecided) {
                    node_on(branch, hit.a, NodeKind::undecided);
                }
                if (hit.kind == intersect::HitKind::overlap) {
                    found.at.push_back(hit.range_a.lower);
                    found.at.push_back(hit.range_a.upper);
                    found.along.push_back(hit.range_a);
                } else {
                    found.at.push_back(hit.a);
                }
            }
        });
        std::ranges::sort(found.at);
        return found;
    }

    // The parts that are inside; those that follow each other are one.
    void add(const MeetBranch &branch) {
        const Interval domain = branch.on->axis(0).domain();
        const double least = 1e-12 * (domain.upper - domain.lower);
        std::vector<double> breaks{domain.lower};
        const Crossings found = crossings(branch);
        for (const double t : found.at) {
            if (t > breaks.back() + least && t < domain.upper - least) {
                breaks.push_back(t);
            }
        }
        breaks.push_back(domain.upper);
        std::vector<Interval> parts;
        for (size_t i = 0; i + 1 < breaks.size(); ++i) {
            const double middle = breaks[i] / 2 + breaks[i + 1] / 2;
            const bool along = std::ranges::any_of(found.along, [&](const Interval &part) {
                return part.lower <= middle && middle <= part.upper;
            });
            if (!along && !is_inside(branch, middle)) {
                continue;
            }
            if (!parts.empty() && parts.back().upper == breaks[i]) {
                parts.back().upper = breaks[i + 1];
            } else {
                parts.push_back({breaks[i], breaks[i + 1]});
            }
        }
        const bool whole =
            parts.size() == 1 && parts[0].lower == domain.lower && parts[0].upper == domain.upper;
        if (branch.loop >= 0 && !whole) {
            cut_loops_.insert(branch.loop);
        }
        for (const Interval &part : parts) {
            add_part(branch, part, whole);
        }
    }

    void add_part(const MeetBranch &branch, const Interval &part, bool whole) {
        const Interval domain = branch.on->axis(0).domain();
        const bool closed = branch.nodes[0] < 0;
        MeetBranch own = branch;
        if (!whole) {
            own.space = refine::restrict_axis(branch.space, 0, part.lower, part.upper);
            own.on = refine::restrict_axis(branch.on, 0, part.lower, part.upper);
        }
        if (!whole || !closed) {
            const auto end = [&](double t, double of_branch, size_t i) {
                return t != of_branch ? node_on(branch, t, NodeKind::border)
                       : closed       ? node_on(branch, t, NodeKind::seam)
                                      : kept(branch.nodes[i]);
            };
            own.nodes = {end(part.lower, domain.lower, 0), end(part.upper, domain.upper, 1)};
        }
        result_.branches.push_back(std::move(own));
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
    Border border_;
    std::vector<int64_t> new_node_;
    std::set<int64_t> cut_loops_;
    Meet result_;
};

} // namespace

Meet trimmed(const Face &face, const Meet &meet) {
    return Trimming(face, meet).run();
}

} // namespace nrb::face

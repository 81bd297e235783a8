// Pairs of surfaces, and what of their meets an oracle that knows nothing of the library says.
#pragma once

#include "crossings.h"
#include "made_shapes.h"
#include "reference/pair_count.h"
#include "support/scale.h"

namespace surface_crossings {

struct Pair {
    SplineData a, b;
};

// Hilly patches over the square [-1, 1]^2.
inline SplineData hills(Random &random) {
    const std::array<int, 2> counts{random.whole(4, 7), random.whole(4, 7)};
    return net_of(counts, {3, 3}, random.chance(50), [&](double u, double v) {
        return std::array<double, 4>{2 * u - 1 + random.between(-0.15, 0.15),
                                     2 * v - 1 + random.between(-0.15, 0.15), random.between(-0.6, 0.6),
                                     random.between(0.5, 2)};
    });
}

// One lies anyhow, or over the other one, so that they meet in loops, too.
inline Pair random_pair(Random &random) {
    Pair pair{hills(random), hills(random)};
    if (random.chance(40)) {
        move(pair.b, random_motion(random, 3, 1, 0.3));
    } else {
        pair.b = support::moved(pair.b, {0, 0, random.between(-0.3, 0.3)});
    }
    return pair;
}

// The same of pieces with kinks between them: of degrees 1 to 3, 2 to 5 of them along each axis.
inline SplineData kinked_hills(Random &random) {
    SplineData data{{random.whole(1, 3), random.whole(1, 3)}, {}, {{}, {}}, 3, {}, {}, 0};
    std::array<double, 2> step{}; // between control points
    double rough = 1;
    for (size_t k = 0; k < 2; ++k) {
        const int p = data.degrees[k], pieces = random.whole(2, 5);
        for (int i = 0; i <= pieces; ++i) {
            const bool inside = i > 0 && i < pieces;
            data.knots[k].insert(data.knots[k].end(), static_cast<size_t>(inside ? p : p + 1),
                                 static_cast<double>(i) / pieces);
        }
        data.counts.push_back(p * pieces + 1);
        step[k] = 2.0 / (p * pieces);
        rough = std::min(rough, 1.0 / std::max(pieces - 1, 1));
    }
    const bool rational = random.chance(50);
    for (int64_t i = 0; i < data.counts[0]; ++i) {
        for (int64_t j = 0; j < data.counts[1]; ++j) {
            const double x = static_cast<double>(i) + random.between(-0.2, 0.2),
                         y = static_cast<double>(j) + random.between(-0.2, 0.2);
            data.points.insert(data.points.end(),
                               {x * step[0] - 1, y * step[1] - 1, rough * random.between(-0.6, 0.6)});
            if (rational) {
                data.weights.push_back(random.between(0.5, 2));
            }
        }
    }
    return data;
}
inline Pair kinked_pair(Random &random) {
    Pair pair{kinked_hills(random), kinked_hills(random)};
    if (random.chance(40)) {
        move(pair.b, random_motion(random, 3, 1, 0.3));
    } else {
        pair.b = support::moved(
            pair.b, {random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(-0.2, 0.2)});
    }
    return pair;
}

// What was compared, and what could not be.
struct Tally {
    int64_t compared = 0, in_doubt = 0, incomplete = 0, touching = 0, open = 0, closed = 0;

    [[nodiscard]] int64_t pairs() const { return compared + in_doubt + incomplete + touching; }
    void tell() const {
        const auto number = [](int64_t n) { return static_cast<long long>(n); };
        std::printf("%lld pairs, %lld compared: %lld branches are open, %lld closed; left open by the oracle "
                    "%lld, by the "
                    "library %lld; %lld touch\n",
                    number(pairs()), number(compared), number(open), number(closed), number(in_doubt),
                    number(incomplete), number(touching));
    }
};

inline Point3 point_at(const nurbs *g, double u, double v) {
    const std::vector<double> x = eval(g, {u, v});
    return {x[0], x[1], x[2]};
}

// Which way a place is on, and how far it is from there.
struct Nearest {
    size_t branch = 0;
    double distance = HUGE_VAL;
};
inline Nearest nearest_branch(const Crossing &crossing, const Point3 &place) {
    Nearest nearest;
    for (size_t i = 0; i < crossing.found.branches.size(); ++i) {
        double distance = 0;
        require_ok(nurbs_closest_points(crossing.found.branches[i].space.get(), 1, place.data(), 0, 0,
                                        nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0, &distance, 0, nullptr,
                                        0));
        if (distance < nearest.distance) {
            nearest = {i, distance};
        }
    }
    return nearest;
}

// Curves of the oracle run through the branches, each of which has one; ends of curves are nodes.
inline void check_places(const Crossing &crossing, const nurbs *a, const reference::PairCount &count,
                         double within) {
    std::vector<int> hits(crossing.found.branches.size());
    for (const reference::PairCurve &curve : count.curves) {
        const Nearest on = nearest_branch(crossing, point_at(a, curve.somewhere[0], curve.somewhere[1]));
        EXPECT_LE(on.distance, within);
        ++hits[on.branch];
        for (const reference::PairPlace &end : curve.ends) {
            const Point3 place = point_at(a, end[0], end[1]);
            double nearest = HUGE_VAL;
            for (const MeetPart &node : crossing.found.nodes) {
                nearest = std::min(nearest, distance(place, point_at(a, node.at[0], node.at[1])));
            }
            EXPECT_LE(nearest, within);
        }
    }
    if (hits.size() == count.curves.size()) { // no way of more than one branch
        EXPECT_EQ(std::ranges::count(hits, 1), std::ssize(hits));
    }
}

// What closes in a domain that does not ends where it begins, bit for bit.
inline void check_closed_branches(const Crossing &crossing) {
    for (size_t i = 0; i < crossing.found.branches.size(); ++i) {
        const Branch &branch = crossing.found.branches[i];
        if (branch.closed()) {
            for (const nurbs *curve : {branch.space.get(), branch.on.get(), crossing.on_second[i].get()}) {
                EXPECT_EQ(eval(curve, {branch.domain[0]}), eval(curve, {branch.domain[1]}));
            }
        }
    }
}

// Whether a complete meet has the curves of the oracle.
inline void compare(const Crossing &crossing, const reference::PairCount &count, Tally &tally) {
    if (!count.certain()) {
        ++tally.in_doubt;
    } else if (!crossing.found.complete) {
        ++tally.incomplete;
    } else if (crossing.found.count(NURBS_NODE_TOUCH) > 0) { // they hide how branches go on
        ++tally.touching;
    } else {
        ++tally.compared;
        tally.open += count.open();
        tally.closed += count.closed();
        EXPECT_EQ(crossing.open_ways, count.open());
        EXPECT_EQ(crossing.closed_ways, count.closed());
    }
}

} // namespace surface_crossings

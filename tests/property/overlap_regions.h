// Regions in which two surfaces are one, through the C interface, for tests.
#pragma once

#include "crossings.h"

#include <map>

namespace surface_overlaps {

using namespace surface_crossings;

// The boundary of one region, and the place inside.
struct Region {
    Place inside_a{}, inside_b{};
    std::vector<std::vector<size_t>> loops; // branches
};

struct Overlap {
    Crossing crossing;
    std::vector<int64_t> next; // of nodes
    std::vector<Region> regions;
};

inline Overlap overlap_in(const nurbs_meet *meet) {
    Overlap overlap{crossing_in(meet), {}, {}};
    const Found &found = overlap.crossing.found;
    overlap.next.resize(found.nodes.size());
    require_ok(nurbs_meet_joints(meet, std::ssize(overlap.next), overlap.next.data(), nullptr, nullptr,
                                 nullptr, nullptr));
    std::map<int64_t, Region> regions;
    for (size_t i = 0; i < found.nodes.size(); ++i) {
        const MeetPart &node = found.nodes[i];
        if (node.kind == NURBS_NODE_OVERLAP) {
            EXPECT_TRUE(regions.emplace(node.level, Region{node.at, overlap.crossing.on_b[i].at, {}}).second);
        }
    }
    std::map<int64_t, std::pair<int64_t, size_t>> loops; // the region, and which of its loops
    for (size_t i = 0; i < found.branches.size(); ++i) {
        const Branch &branch = found.branches[i];
        const bool bounds = overlap.crossing.kinds[i] == NURBS_BRANCH_OVERLAP;
        EXPECT_EQ(bounds, branch.level > 0);
        if (!bounds) {
            continue;
        }
        EXPECT_GE(branch.loop, 0);
        Region &region = regions.at(branch.level);
        const auto known = loops.find(branch.loop);
        if (known == loops.end()) {
            loops[branch.loop] = {branch.level, region.loops.size()};
            region.loops.push_back({i});
        } else {
            EXPECT_EQ(known->second.first, branch.level);
            region.loops[known->second.second].push_back(i);
        }
    }
    int64_t level = 0;
    for (auto &[own, region] : regions) {
        EXPECT_EQ(own, ++level);
        overlap.regions.push_back(std::move(region));
    }
    return overlap;
}

inline Overlap overlap_of(const nurbs *a, const nurbs *b, double tolerance,
                          const nurbs_call_options *call = nullptr) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_intersections_with(a, b, tolerance, call, &meet));
    return overlap_in(MeetHandle(meet).get());
}

// Each branch of a loop begins where the one before it ends: in one node, or across a seam.
inline void check_loops(const Overlap &overlap) {
    const Found &found = overlap.crossing.found;
    for (const Region &region : overlap.regions) {
        for (const std::vector<size_t> &loop : region.loops) {
            for (size_t i = 0; i < loop.size(); ++i) {
                const Branch &branch = found.branches[loop[i]],
                             &after = found.branches[loop[(i + 1) % loop.size()]];
                if (branch.closed()) {
                    EXPECT_EQ(loop.size(), 1U);
                    continue;
                }
                const auto end = static_cast<size_t>(branch.nodes[1]);
                EXPECT_EQ(overlap.next[end], after.nodes[0]);
                if (branch.nodes[1] != after.nodes[0]) {
                    EXPECT_EQ(found.nodes[end].kind, NURBS_NODE_SEAM);
                    continue;
                }
                EXPECT_EQ(found.nodes[end].kind, NURBS_NODE_BORDER);
                // bit for bit
                const std::vector<double> last{branch.domain[1]}, first{after.domain[0]};
                EXPECT_EQ(places_on(branch.on.get(), last), places_on(after.on.get(), first));
                EXPECT_EQ(places_on(overlap.crossing.on_second[loop[i]].get(), last),
                          places_on(overlap.crossing.on_second[loop[(i + 1) % loop.size()]].get(), first));
                EXPECT_EQ(points_on(branch.space.get(), last), points_on(after.space.get(), first));
                EXPECT_EQ(places_on(branch.on.get(), last)[0], found.nodes[end].at);
            }
        }
    }
}

inline std::vector<Place> places_of(const nurbs *curve, const Branch &branch, int n) {
    return places_on(curve, branch.params(n));
}

// Of a region on the left of its loops, by -v du: what closes along the first axis has no other boundary.
inline double area_of(const Overlap &overlap, const Region &region, bool second, int n = 2000) {
    double area = 0;
    for (const std::vector<size_t> &loop : region.loops) {
        for (const size_t i : loop) {
            const Branch &branch = overlap.crossing.found.branches[i];
            const std::vector<Place> at =
                places_of(second ? overlap.crossing.on_second[i].get() : branch.on.get(), branch, n);
            for (size_t k = 0; k + 1 < at.size(); ++k) {
                area -= (at[k][1] + at[k + 1][1]) / 2 * (at[k + 1][0] - at[k][0]);
            }
        }
    }
    return area;
}
inline double area_of(const Overlap &overlap, bool second = false) {
    double area = 0;
    for (const Region &region : overlap.regions) {
        area += area_of(overlap, region, second);
    }
    return area;
}

// How often the loops of a region wind around a place of a domain in which nothing closes.
inline int winding_of(const Overlap &overlap, const Region &region, const Place &at) {
    double angle = 0;
    for (const std::vector<size_t> &loop : region.loops) {
        for (const size_t i : loop) {
            const Branch &branch = overlap.crossing.found.branches[i];
            const std::vector<Place> on = places_of(branch.on.get(), branch, 200);
            for (size_t k = 0; k + 1 < on.size(); ++k) {
                const Place p{on[k][0] - at[0], on[k][1] - at[1]},
                    q{on[k + 1][0] - at[0], on[k + 1][1] - at[1]};
                angle += std::atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
            }
        }
    }
    return static_cast<int>(std::lround(angle / (2 * std::acos(-1.0))));
}

inline double distance_to(const nurbs *g, const Point3 &x) {
    double distance = -1;
    require_ok(nurbs_closest_points(g, 1, x.data(), 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                    &distance, 0, nullptr, 0));
    return distance;
}

// Places of a are in a region if, and only if, they are on b, but for those next to the boundary.
inline void check_inside(const Overlap &overlap, const nurbs *a, const nurbs *b, double tolerance, int n) {
    double lower[2][2];
    require_ok(nurbs_domain(a, 0, lower[0]));
    require_ok(nurbs_domain(a, 1, lower[1]));
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Place at{lower[0][0] + (lower[0][1] - lower[0][0]) * (i + 0.437) / n,
                           lower[1][0] + (lower[1][1] - lower[1][0]) * (j + 0.561) / n};
            const Point3 x = points_of(a, {at})[0];
            const double distance = distance_to(b, x);
            int turns = 0;
            for (const Region &region : overlap.regions) {
                turns += winding_of(overlap, region, at);
            }
            EXPECT_TRUE(turns == 0 || turns == 1);
            if (turns == 1) {
                EXPECT_LE(distance, 2 * tolerance) << at[0] << ", " << at[1];
            } else {
                EXPECT_GT(distance, 0.1 * tolerance) << at[0] << ", " << at[1];
            }
        }
    }
    for (const Region &region : overlap.regions) {
        EXPECT_LE(distance(points_of(a, {region.inside_a})[0], points_of(b, {region.inside_b})[0]),
                  tolerance);
        EXPECT_EQ(winding_of(overlap, region, region.inside_a), 1);
    }
}

} // namespace surface_overlaps

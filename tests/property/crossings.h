// Where surfaces meet, through the C interface, for tests.
#pragma once

#include "sections.h"
#include "support/frames.h"

namespace surface_crossings {

using namespace surface_sections;

struct Crossing {
    Found found;
    std::vector<Handle> on_second; // of branches
    std::vector<MeetPart> on_b;    // nodes
    std::vector<int32_t> kinds;    // of branches
    int64_t open_ways = 0, closed_ways = 0;
};

inline void count_ways(const nurbs_meet *meet, Crossing &crossing) {
    int64_t count = 0;
    require_ok(nurbs_meet_ways(meet, 0, nullptr, nullptr, nullptr, nullptr, nullptr, &count));
    std::vector<int32_t> closes(static_cast<size_t>(count));
    require_ok(nurbs_meet_ways(meet, count, nullptr, nullptr, nullptr, closes.data(), nullptr, nullptr));
    crossing.closed_ways = std::ranges::count(closes, 1);
    crossing.open_ways = count - crossing.closed_ways;
}

inline Crossing crossing_in(const nurbs_meet *meet) {
    Crossing crossing;
    crossing.found = found_in(meet);
    for (size_t i = 0; i < crossing.found.branches.size(); ++i) {
        crossing.on_second.push_back(
            made([&](nurbs **out) { return nurbs_meet_branch_second(meet, static_cast<int64_t>(i), out); }));
    }
    crossing.kinds.resize(crossing.found.branches.size());
    require_ok(nurbs_meet_kinds(meet, std::ssize(crossing.kinds), crossing.kinds.data(), nullptr));
    const size_t n = crossing.found.nodes.size();
    std::vector<double> params(2 * n), ranges(4 * n);
    require_ok(nurbs_meet_nodes_second(meet, static_cast<int64_t>(n), params.data(), ranges.data(), nullptr));
    for (size_t i = 0; i < n; ++i) {
        const double *range = ranges.data() + 4 * i;
        crossing.on_b.push_back({0,
                                 crossing.found.nodes[i].kind,
                                 {params[2 * i], params[2 * i + 1]},
                                 {Place{range[0], range[1]}, Place{range[2], range[3]}}});
    }
    count_ways(meet, crossing);
    return crossing;
}

inline Crossing crossing_of(const nurbs *a, const nurbs *b, double tolerance,
                            const nurbs_call_options *call = nullptr) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_intersections_with(a, b, tolerance, call, &meet));
    return crossing_in(MeetHandle(meet).get());
}

// Both curves in the domains lead to the curve in space, to within what was promised of each, and stay in the domains.
inline void check_curves(const Crossing &crossing, const Ground &a, const Ground &b, int n = 1000) {
    for (size_t i = 0; i < crossing.found.branches.size(); ++i) {
        const Branch &branch = crossing.found.branches[i];
        ASSERT_TRUE(std::isfinite(branch.deviation)) << "branch " << i;
        const std::vector<double> t = branch.params(n);
        const std::vector<Point3> space = points_on(branch.space.get(), t);
        const std::vector<Place> on_a = places_on(branch.on.get(), t),
                                 on_b = places_on(crossing.on_second[i].get(), t);
        double gap = 0;
        for (size_t k = 0; k < t.size(); ++k) {
            ASSERT_TRUE(a.contains(on_a[k]) && b.contains(on_b[k])) << "branch " << i << ", sample " << k;
            gap = std::max({gap, a.gap(on_a[k], space[k]), b.gap(on_b[k], space[k])});
        }
        EXPECT_LE(gap, 2 * branch.deviation) << "branch " << i;
    }
}

// Ends of branches are where their nodes are.
inline void check_nodes(const Crossing &crossing, double near) {
    for (size_t i = 0; i < crossing.found.branches.size(); ++i) {
        const Branch &branch = crossing.found.branches[i];
        for (size_t end = 0; end < 2 && !branch.closed(); ++end) {
            const auto node = static_cast<size_t>(branch.nodes[end]);
            const std::vector<double> t{branch.domain[end]};
            if (crossing.found.nodes[node].kind == NURBS_NODE_UNDECIDED) {
                continue;
            }
            const Place on_a = places_on(branch.on.get(), t)[0],
                        on_b = places_on(crossing.on_second[i].get(), t)[0];
            for (size_t k = 0; k < 2; ++k) {
                EXPECT_NEAR(on_a[k], crossing.found.nodes[node].at[k], near) << "branch " << i;
                EXPECT_NEAR(on_b[k], crossing.on_b[node].at[k], near) << "branch " << i;
            }
        }
    }
}

// A surface of points f(u, v) = (x, y, z, w) as control points at Greville abscissae over [0, 1]^2.
template <class Function>
SplineData net_of(std::array<int, 2> counts, std::array<int, 2> degrees, bool rational, Function &&f) {
    SplineData data{{degrees[0], degrees[1]}, {counts[0], counts[1]}, {{}, {}}, 3, {}, {}, 0};
    for (size_t k = 0; k < 2; ++k) {
        const int spans = counts[k] - degrees[k];
        for (int i = -degrees[k]; i <= spans + degrees[k]; ++i) {
            data.knots[k].push_back(std::clamp(static_cast<double>(i) / spans, 0.0, 1.0));
        }
    }
    const auto abscissa = [&](size_t k, int i) {
        double sum = 0;
        for (int r = 1; r <= degrees[k]; ++r) {
            sum += data.knots[k][static_cast<size_t>(i + r)] / degrees[k];
        }
        return sum;
    };
    for (int i = 0; i < counts[0]; ++i) {
        for (int j = 0; j < counts[1]; ++j) {
            const std::array<double, 4> point = f(abscissa(0, i), abscissa(1, j));
            data.points.insert(data.points.end(), point.begin(), point.begin() + 3);
            if (rational) {
                data.weights.push_back(point[3]);
            }
        }
    }
    return data;
}

// z = a x^2 + b x y + c y^2 + d over [x0, x0 + 2] x [y0, y0 + 2].
inline SplineData quadratic_graph(double a, double b, double c, double d, double x0, double y0) {
    const std::array<double, 3> x{x0, x0 + 1, x0 + 2}, y{y0, y0 + 1, y0 + 2},
        xx{x0 * x0, x0 * (x0 + 2), (x0 + 2) * (x0 + 2)}, yy{y0 * y0, y0 * (y0 + 2), (y0 + 2) * (y0 + 2)};
    SplineData data{{2, 2}, {3, 3}, {{0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}}, 3, {}, {}, 0};
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            data.points.insert(data.points.end(), {x[i], y[j], a * xx[i] + b * x[i] * y[j] + c * yy[j] + d});
        }
    }
    return data;
}

// The axis z becomes the axis x.
inline SplineData turned(SplineData data) {
    for (size_t i = 0; i < data.points.size(); i += 3) {
        const Point3 p{data.points[i], data.points[i + 1], data.points[i + 2]};
        data.points[i] = p[2];
        data.points[i + 1] = p[0];
        data.points[i + 2] = p[1];
    }
    return data;
}

} // namespace surface_crossings

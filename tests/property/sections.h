// Sections of surfaces through the C interface, for tests.
#pragma once

#include "support/handle.h"
#include "support/spline_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace surface_sections {

using namespace support;

struct DestroyMeet {
    void operator()(nurbs_meet *meet) const noexcept { nurbs_meet_destroy(meet); }
};
using MeetHandle = std::unique_ptr<nurbs_meet, DestroyMeet>;
using Point3 = std::array<double, 3>;
using Place = std::array<double, 2>;

inline double dot(const Point3 &a, const Point3 &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double distance(const Point3 &a, const Point3 &b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

struct Branch {
    int64_t level = -1, loop = -2;
    std::array<int64_t, 2> nodes{};
    double deviation = 0;
    Handle space, on;
    std::array<double, 2> domain{};

    [[nodiscard]] bool closed() const { return nodes[0] < 0; }
    [[nodiscard]] std::vector<double> params(int n) const {
        std::vector<double> t;
        for (int i = 0; i <= n; ++i) {
            t.push_back(i == n ? domain[1] : domain[0] + (domain[1] - domain[0]) * i / n);
        }
        return t;
    }
};

struct MeetPart {
    int64_t level = -1;
    int32_t kind = 0;
    Place at{};
    std::array<Place, 2> range{}; // [axis][end]
};

struct Found {
    std::vector<Branch> branches;
    std::vector<MeetPart> nodes;
    bool complete = false;

    [[nodiscard]] int64_t loops() const {
        int64_t most = 0;
        for (const Branch &branch : branches) {
            most = std::max(most, branch.loop + 1);
        }
        return most;
    }
    [[nodiscard]] int64_t count(int32_t kind) const {
        return std::ranges::count(nodes, kind, &MeetPart::kind);
    }
};

inline std::vector<Branch> branches_of(const nurbs_meet *meet, int64_t count) {
    const auto n = static_cast<size_t>(count);
    std::vector<int64_t> levels(n), nodes(2 * n), loops(n);
    std::vector<double> deviations(n);
    require_ok(nurbs_meet_branches(meet, count, levels.data(), nodes.data(), loops.data(), deviations.data(),
                                   nullptr));
    std::vector<Branch> branches(n);
    for (size_t i = 0; i < n; ++i) {
        nurbs *space = nullptr, *on = nullptr;
        require_ok(nurbs_meet_branch(meet, static_cast<int64_t>(i), &space, &on));
        branches[i] = {levels[i],  loops[i], {nodes[2 * i], nodes[2 * i + 1]}, deviations[i], Handle(space),
                       Handle(on), {}};
        require_ok(nurbs_domain(space, 0, branches[i].domain.data()));
    }
    return branches;
}

inline Found found_in(const nurbs_meet *meet) {
    Found found;
    int64_t branches = -1, nodes = -1;
    int32_t complete = -1;
    require_ok(nurbs_meet_counts(meet, &branches, &nodes, &complete));
    found.complete = complete == 1;
    found.branches = branches_of(meet, branches);
    const auto n = static_cast<size_t>(nodes);
    std::vector<int64_t> levels(n);
    std::vector<int32_t> kinds(n);
    std::vector<double> params(2 * n), ranges(4 * n);
    require_ok(
        nurbs_meet_nodes(meet, nodes, levels.data(), kinds.data(), params.data(), ranges.data(), nullptr));
    for (size_t i = 0; i < n; ++i) {
        const double *range = ranges.data() + 4 * i;
        found.nodes.push_back({levels[i],
                               kinds[i],
                               {params[2 * i], params[2 * i + 1]},
                               {Place{range[0], range[1]}, Place{range[2], range[3]}}});
    }
    EXPECT_EQ(found.complete, found.count(NURBS_NODE_UNDECIDED) == 0);
    return found;
}

inline Found sections_of(const nurbs *g, const Point3 &normal, const std::vector<double> &offsets,
                         double tolerance, const nurbs_call_options *call = nullptr) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_sections_with(g, normal.data(), static_cast<int64_t>(offsets.size()),
                                           offsets.data(), tolerance, call, &meet));
    return found_in(MeetHandle(meet).get());
}

// Of all branches together.
inline double length_of(const Found &found) {
    double length = 0;
    for (const Branch &branch : found.branches) {
        double own = 0;
        require_ok(nurbs_curve_length(branch.space.get(), nullptr, 1e-10, &own, nullptr));
        length += own;
    }
    return length;
}

inline std::vector<Point3> points_on(const nurbs *curve, const std::vector<double> &t) {
    std::vector<Point3> points(t.size());
    require_ok(
        nurbs_eval(curve, static_cast<int64_t>(t.size()), t.data(), 0, 0, points.front().data(), 0, 0, 0));
    return points;
}
inline std::vector<Place> places_on(const nurbs *curve, const std::vector<double> &t) {
    std::vector<Place> places(t.size());
    require_ok(
        nurbs_eval(curve, static_cast<int64_t>(t.size()), t.data(), 0, 0, places.front().data(), 0, 0, 0));
    return places;
}

inline std::vector<Point3> points_of(const nurbs *g, const std::vector<Place> &at) {
    std::vector<Point3> points(at.size());
    require_ok(nurbs_eval(g, static_cast<int64_t>(at.size()), at.front().data(), 0, 0, points.front().data(),
                          0, 0, 0));
    return points;
}

// A surface of which places may be periods away; where it jumps it is both of its limits.
class Ground {
public:
    Ground(const nurbs *g, std::array<bool, 2> periodic) : g_(g), periodic_(periodic) {
        for (int32_t k = 0; k < 2; ++k) {
            Place &domain = domain_[static_cast<size_t>(k)];
            require_ok(nurbs_domain(g, k, domain.data()));
        }
    }
    Ground(const nurbs *g, const SplineData &data) : Ground(g, {data.periodic(0), data.periodic(1)}) {}

    [[nodiscard]] const nurbs *get() const { return g_; }
    [[nodiscard]] const Place &domain(size_t axis) const { return domain_[axis]; }
    [[nodiscard]] bool contains(const Place &place) const {
        for (size_t k = 0; k < 2; ++k) {
            if (!periodic_[k] && !(place[k] >= domain_[k][0] && place[k] <= domain_[k][1])) {
                return false;
            }
        }
        return true;
    }
    [[nodiscard]] Place inside(const Place &place) const {
        return {candidates(0, place[0]).front(), candidates(1, place[1]).front()};
    }
    // How far the surface is from a point.
    [[nodiscard]] double gap(const Place &place, const Point3 &x) const {
        double least = HUGE_VAL;
        for (const double u : candidates(0, place[0])) {
            for (const double v : candidates(1, place[1])) {
                for (uint32_t sides = 0; sides < 4; ++sides) {
                    const uint32_t flags = (sides & 1U) * NURBS_ON_AXIS(0, NURBS_LEFT) +
                                           (sides >> 1) * NURBS_ON_AXIS(1, NURBS_LEFT);
                    const Place at{u, v};
                    Point3 y{};
                    require_ok(nurbs_eval(g_, 1, at.data(), 0, 0, y.data(), 0, 0, flags));
                    least = std::min(least, distance(x, y));
                }
            }
        }
        return least;
    }

private:
    // In the domain; both ends of a period are one.
    [[nodiscard]] std::vector<double> candidates(size_t axis, double at) const {
        const Place &domain = domain_[axis];
        if (!periodic_[axis]) { // curves leave the domain by rounding
            return {std::clamp(at, domain[0], domain[1])};
        }
        const double period = domain[1] - domain[0];
        const double first =
            std::clamp(at - period * std::floor((at - domain[0]) / period), domain[0], domain[1]);
        const double near = 1e-15 * (std::abs(at) + std::abs(domain[0]) + std::abs(domain[1]));
        if (first - domain[0] <= near) {
            return {first, domain[1]};
        }
        return domain[1] - first <= near ? std::vector<double>{first, domain[0]} : std::vector<double>{first};
    }

    const nurbs *g_;
    std::array<bool, 2> periodic_;
    std::array<Place, 2> domain_{};
};

} // namespace surface_sections

// SPDX-License-Identifier: MIT
// Meets of curves and surfaces, and of two surfaces: a place where they meet is in the range of a hit, whatever they are; what
// is told of branches and nodes on both surfaces holds.
#include "fuzz/harness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace {

using fuzz::Input;

constexpr int64_t most = 256;

struct Hits {
    std::array<double, most> t{};
    std::vector<double> params = std::vector<double>(2 * most), on_curve = params,
                        on_surface = std::vector<double>(4 * most);
    std::array<int32_t, most> kinds{};
    int64_t count = 0;
    int32_t complete = -1;
};

fuzz::Spline in_space(Input &in, int axes) {
    fuzz::Spline s;
    fuzz::add_axes(in, s, axes);
    fuzz::add_values(in, s, in.rarely() ? 1 + in.below(4) : 3);
    return s;
}

void check(const Hits &h, const nurbs *curve, const nurbs *surface) {
    double domain[3][2];
    FUZZ_REQUIRE(nurbs_domain(curve, 0, domain[0]) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_domain(surface, 0, domain[1]) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_domain(surface, 1, domain[2]) == NURBS_OK);
    bool undecided = false;
    FUZZ_REQUIRE(std::is_sorted(h.t.begin(), h.t.begin() + h.count));
    for (int64_t i = 0; i < h.count; ++i) {
        const auto at = static_cast<size_t>(i);
        FUZZ_REQUIRE(h.kinds[at] >= NURBS_HIT_CROSSING && h.kinds[at] <= NURBS_HIT_UNDECIDED);
        const double places[] = {h.t[at], h.params[2 * at], h.params[2 * at + 1]};
        const double lower[] = {h.on_curve[2 * at], h.on_surface[4 * at], h.on_surface[4 * at + 2]},
                     upper[] = {h.on_curve[2 * at + 1], h.on_surface[4 * at + 1], h.on_surface[4 * at + 3]};
        for (int k = 0; k < 3; ++k) {
            FUZZ_REQUIRE(places[k] >= domain[k][0] && places[k] <= domain[k][1]);
            FUZZ_REQUIRE(lower[k] <= upper[k] && lower[k] >= domain[k][0]);
        }
        undecided = undecided || h.kinds[at] == NURBS_HIT_UNDECIDED;
    }
    FUZZ_REQUIRE(h.complete == (undecided ? 0 : 1));
}

void meet(const nurbs *curve, const nurbs *surface, double tolerance, int64_t work) {
    Hits h;
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = work;
    if (FUZZ_OK(nurbs_curve_surface_intersections_with(curve, surface, tolerance, most, h.t.data(),
                                                       h.params.data(), h.kinds.data(), h.on_curve.data(),
                                                       h.on_surface.data(), &h.count, &h.complete, &call))) {
        check(h, curve, surface);
    }
}

// Regions are on levels of their own, each with one node, and their boundaries close.
void look_at_regions(const nurbs_meet *found, const std::vector<int32_t> &node_kinds,
                     const std::vector<int32_t> &branch_kinds) {
    std::vector<int64_t> levels(node_kinds.size()), own(branch_kinds.size()), loops(branch_kinds.size());
    FUZZ_REQUIRE(nurbs_meet_nodes(found, std::ssize(levels), levels.data(), nullptr, nullptr, nullptr,
                                  nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_meet_branches(found, std::ssize(own), own.data(), nullptr, loops.data(), nullptr,
                                     nullptr) == NURBS_OK);
    std::vector<int64_t> regions;
    for (size_t i = 0; i < levels.size(); ++i) {
        if (node_kinds[i] == NURBS_NODE_OVERLAP) {
            FUZZ_REQUIRE(levels[i] > 0 && std::ranges::count(regions, levels[i]) == 0);
            regions.push_back(levels[i]);
        }
    }
    for (size_t i = 0; i < own.size(); ++i) {
        if (branch_kinds[i] == NURBS_BRANCH_OVERLAP) {
            FUZZ_REQUIRE(loops[i] >= 0 && std::ranges::count(regions, own[i]) == 1);
        }
    }
}

// Branches have three curves with common knots, and nodes are in ranges on both surfaces.
void look_at(const nurbs_meet *found) {
    int64_t branches = 0, nodes = 0;
    int32_t complete = -1;
    FUZZ_REQUIRE(nurbs_meet_counts(found, &branches, &nodes, &complete) == NURBS_OK);
    const auto n = static_cast<size_t>(nodes);
    std::vector<int32_t> kinds(n);
    std::vector<double> params(2 * n), ranges(4 * n);
    FUZZ_REQUIRE(nurbs_meet_nodes(found, nodes, nullptr, kinds.data(), nullptr, nullptr, nullptr) ==
                 NURBS_OK);
    FUZZ_REQUIRE(nurbs_meet_nodes_second(found, nodes, params.data(), ranges.data(), nullptr) == NURBS_OK);
    FUZZ_REQUIRE(complete == (std::ranges::count(kinds, NURBS_NODE_UNDECIDED) == 0 ? 1 : 0));
    for (size_t i = 0; i < 2 * n; ++i) {
        FUZZ_REQUIRE(ranges[2 * i] <= params[i] && params[i] <= ranges[2 * i + 1]);
    }
    std::vector<int32_t> own_kinds(static_cast<size_t>(branches));
    FUZZ_REQUIRE(nurbs_meet_kinds(found, branches, own_kinds.data(), nullptr) == NURBS_OK);
    for (const int32_t kind : own_kinds) {
        FUZZ_REQUIRE(kind >= NURBS_BRANCH_CROSSING && kind <= NURBS_BRANCH_OVERLAP);
    }
    look_at_regions(found, kinds, own_kinds);
    for (int64_t i = 0; i < std::min<int64_t>(branches, 16); ++i) {
        nurbs *space = nullptr, *on = nullptr, *on_second = nullptr;
        FUZZ_REQUIRE(nurbs_meet_branch(found, i, &space, &on) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_meet_branch_second(found, i, &on_second) == NURBS_OK);
        double domain[2], other[2];
        FUZZ_REQUIRE(nurbs_domain(space, 0, domain) == NURBS_OK && domain[0] < domain[1]);
        FUZZ_REQUIRE(nurbs_domain(on_second, 0, other) == NURBS_OK);
        FUZZ_REQUIRE(domain[0] == other[0] && domain[1] == other[1]);
        nurbs_destroy(space);
        nurbs_destroy(on);
        nurbs_destroy(on_second);
    }
}

struct DestroyFace {
    void operator()(nurbs_face *face) const noexcept { nurbs_face_destroy(face); }
};
using Face = std::unique_ptr<nurbs_face, DestroyFace>;

// All of a surface.
Face face_of(const nurbs *g) {
    nurbs_face *face = nullptr;
    FUZZ_OK(nurbs_face_create(g, 0, nullptr, nullptr, nullptr, nullptr, 1e-6, 0, nullptr, &face));
    return Face(face);
}

// What lies in a face of each, in one after the other and in both at once: branches lie in the domains that they lay in.
void look_at_parts(const nurbs_meet *found, const nurbs *a, const nurbs *b, double tolerance,
                   const nurbs_call_options &call, bool plain) {
    const Face first = face_of(a), second = face_of(b);
    if (!first || !second) {
        return;
    }
    nurbs_meet *part = nullptr, *both = nullptr;
    if (FUZZ_OK(nurbs_meet_trim_with(found, first.get(), &call, &part))) {
        look_at(part);
        if (plain ? FUZZ_OK(nurbs_meet_trim_second(part, second.get(), &both))
                  : FUZZ_OK(nurbs_meet_trim_second_with(part, second.get(), &call, &both))) {
            look_at(both);
            nurbs_meet_destroy(both);
        }
        nurbs_meet_destroy(part);
    }
    nurbs_meet *own = nullptr;
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_face_intersections(first.get(), second.get(), -tolerance, &own)) &&
                 own == nullptr);
    if (FUZZ_OK(nurbs_face_intersections_with(first.get(), second.get(), tolerance, &call, &own))) {
        look_at(own);
        nurbs_meet_destroy(own);
    }
}

void meet_surfaces(const nurbs *a, const nurbs *b, double tolerance, int64_t work) {
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = work;
    nurbs_meet *found = nullptr;
    if (FUZZ_OK(nurbs_surface_intersections_with(a, b, tolerance, &call, &found))) {
        look_at(found);
        look_at_parts(found, a, b, tolerance, call, work % 16 == 0);
        nurbs_meet_destroy(found);
    } else {
        FUZZ_REQUIRE(found == nullptr);
    }
}

// Both curves of a branch are in one domain.
void meet_itself(const nurbs *g, double tolerance, int64_t work, bool plain = false) {
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = work;
    nurbs_meet *found = nullptr;
    if (plain ? FUZZ_OK(nurbs_surface_self_intersections(g, tolerance, &found))
              : FUZZ_OK(nurbs_surface_self_intersections_with(g, tolerance, &call, &found))) {
        look_at(found);
        nurbs_meet_destroy(found);
    } else {
        FUZZ_REQUIRE(found == nullptr);
    }
}

// Parameters are in the domains, and in the ranges but for periods; a crossing is told as one.
void meet_three(const std::array<const nurbs *, 3> &surfaces, double tolerance,
                const nurbs_call_options &call, bool plain) {
    std::vector<double> params(6 * most), points(3 * most), ranges(12 * most);
    std::vector<int32_t> kinds(most);
    int64_t count = 0;
    int32_t complete = -1;
    const auto &[a, b, c] = surfaces;
    if (!(plain ? FUZZ_OK(nurbs_surfaces_common_points(a, b, c, tolerance, most, params.data(), points.data(),
                                                       kinds.data(), ranges.data(), &count, &complete))
                : FUZZ_OK(nurbs_surfaces_common_points_with(a, b, c, tolerance, most, params.data(),
                                                            points.data(), kinds.data(), ranges.data(),
                                                            &count, &complete, &call)))) {
        return;
    }
    FUZZ_REQUIRE(complete ==
                 (std::count(kinds.begin(), kinds.begin() + count, NURBS_HIT_UNDECIDED) == 0 ? 1 : 0));
    for (size_t i = 0; i < 6 * static_cast<size_t>(count); ++i) {
        double domain[2];
        FUZZ_REQUIRE(nurbs_domain(surfaces[i % 6 / 2], static_cast<int32_t>(i % 2), domain) == NURBS_OK);
        FUZZ_REQUIRE(params[i] >= domain[0] && params[i] <= domain[1]);
        FUZZ_REQUIRE(ranges[2 * i] <= ranges[2 * i + 1] && ranges[2 * i] >= domain[0]);
    }
}

// Along curves that are projected t rises.
void look_at_projection(const nurbs_meet *found) {
    look_at(found);
    int64_t branches = 0;
    FUZZ_REQUIRE(nurbs_meet_counts(found, &branches, nullptr, nullptr) == NURBS_OK);
    for (int64_t i = 0; i < std::min<int64_t>(branches, 16); ++i) {
        nurbs *lines = nullptr;
        double domain[2], ends[4];
        FUZZ_REQUIRE(nurbs_meet_branch_second(found, i, &lines) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_domain(lines, 0, domain) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_eval(lines, 2, domain, 0, 0, ends, 0, 0, 0) == NURBS_OK);
        FUZZ_REQUIRE(ends[0] <= ends[2]);
        nurbs_destroy(lines);
    }
}

// Onto a surface, and onto all of it as a face; without a direction normally.
void project(const nurbs *curve, const nurbs *surface, const double *direction, double tolerance,
             const nurbs_call_options &call, bool plain) {
    nurbs_meet *found = nullptr;
    if (plain ? FUZZ_OK(nurbs_surface_project_curve(surface, curve, direction, tolerance, &found))
              : FUZZ_OK(
                    nurbs_surface_project_curve_with(surface, curve, direction, tolerance, &call, &found))) {
        look_at_projection(found);
        nurbs_meet_destroy(found);
    } else {
        FUZZ_REQUIRE(found == nullptr);
    }
    nurbs_face *face = nullptr;
    if (!FUZZ_OK(
            nurbs_face_create(surface, 0, nullptr, nullptr, nullptr, nullptr, 1e-6, 0, nullptr, &face))) {
        return;
    }
    if (plain ? FUZZ_OK(nurbs_face_project_curve(face, curve, direction, tolerance, &found))
              : FUZZ_OK(nurbs_face_project_curve_with(face, curve, direction, tolerance, &call, &found))) {
        look_at_projection(found);
        nurbs_meet_destroy(found);
    }
    nurbs_face_destroy(face);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Handle curve(fuzz::create(in_space(in, in.rarely() ? 2 : 1))),
        surface(fuzz::create(in_space(in, in.rarely() ? 3 : 2)));
    if (!curve || !surface) {
        return 0;
    }
    const double tolerance = std::abs(in.number()) * (in.coin() ? 0x1p-20 : 1);
    meet(curve.get(), surface.get(), tolerance, 500000);
    meet(curve.get(), surface.get(), 0, in.below(1000) + 1);
    int64_t count = 0;
    FUZZ_OK(nurbs_curve_surface_intersections(surface.get(), surface.get(), tolerance, 0, nullptr, nullptr,
                                              nullptr, nullptr, nullptr, &count, nullptr));
    const fuzz::Handle second(fuzz::create(in_space(in, 2)));
    nurbs_meet *rarely = nullptr;
    if (FUZZ_OK(nurbs_surface_intersections(curve.get(), curve.get(), tolerance, &rarely))) {
        look_at(rarely);
        nurbs_meet_destroy(rarely);
    }
    if (second) {
        meet_surfaces(surface.get(), second.get(), tolerance, 200000);
        meet_surfaces(surface.get(), surface.get(), tolerance, in.below(20000) + 1);
    }
    meet_itself(surface.get(), tolerance, 200000);
    meet_itself(in.rarely() ? curve.get() : surface.get(), tolerance, in.below(20000) + 1);
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = 50000;
    if (second) {
        const fuzz::Handle third(fuzz::create(in_space(in, 2)));
        meet_three({surface.get(), second.get(), third ? third.get() : surface.get()}, tolerance, call,
                   in.rarely());
    }
    const double direction[] = {in.number(), in.number(), in.coin() ? 1 : in.number()};
    project(curve.get(), surface.get(), direction, tolerance, call, in.rarely());
    project(curve.get(), surface.get(), nullptr, tolerance, call, in.rarely());
    nurbs *side = nullptr;
    double domain[2];
    if (FUZZ_OK(nurbs_domain(surface.get(), 0, domain)) &&
        FUZZ_OK(nurbs_iso(surface.get(), 0, domain[0], 0, &side))) {
        meet(fuzz::Handle(side).get(), surface.get(), tolerance, 500000); // an overlap
    }
    if (in.rarely()) {
        meet_itself(surface.get(), tolerance, 0, true);
    }
    return 0;
}

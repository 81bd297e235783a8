// SPDX-License-Identifier: MIT
// Sections: what is told of curves and nodes holds, whatever the surface; all of it is counted and released.
#include "fuzz/harness.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using fuzz::Input;
using Point = std::array<double, 3>;

double any_number(Input &in, const fuzz::Spline &s) {
    return in.rarely() ? in.anything() : in.coin() ? in.number() : s.size() * (2 * in.unit() - 1);
}

// A branch begins and ends in nodes of its plane, and its curves have common knots.
void look_at_branch(const nurbs_meet *meet, int64_t i, double deviation) {
    nurbs *space = nullptr, *on = nullptr;
    FUZZ_REQUIRE(nurbs_meet_branch(meet, i, &space, &on) == NURBS_OK);
    const fuzz::Handle in_space(space), on_surface(on);
    double domain[2], other[2];
    FUZZ_REQUIRE(nurbs_domain(space, 0, domain) == NURBS_OK && nurbs_domain(on, 0, other) == NURBS_OK);
    FUZZ_REQUIRE(domain[0] == other[0] && domain[1] == other[1] && domain[0] < domain[1]);
    FUZZ_REQUIRE(deviation >= 0);
}

struct Sizes {
    int64_t branches = 0, nodes = 0;
    int32_t complete = 0;
};

Sizes sizes_of(const nurbs_meet *meet) {
    Sizes sizes;
    FUZZ_REQUIRE(nurbs_meet_counts(meet, &sizes.branches, &sizes.nodes, &sizes.complete) == NURBS_OK);
    return sizes;
}

void look(const nurbs_meet *meet, int64_t planes) {
    const Sizes sizes = sizes_of(meet);
    const auto n = static_cast<size_t>(sizes.branches), m = static_cast<size_t>(sizes.nodes);
    std::vector<int64_t> levels(n), ends(2 * n), loops(n), node_levels(m);
    std::vector<double> deviations(n), params(2 * m), ranges(4 * m);
    std::vector<int32_t> kinds(m);
    FUZZ_REQUIRE(nurbs_meet_branches(meet, sizes.branches, levels.data(), ends.data(), loops.data(),
                                     deviations.data(), nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_meet_nodes(meet, sizes.nodes, node_levels.data(), kinds.data(), params.data(),
                                  ranges.data(), nullptr) == NURBS_OK);
    bool decided = true;
    for (size_t i = 0; i < m; ++i) {
        FUZZ_REQUIRE(kinds[i] >= NURBS_NODE_BORDER && kinds[i] <= NURBS_NODE_UNDECIDED);
        FUZZ_REQUIRE(node_levels[i] >= 0 && node_levels[i] < planes);
        decided = decided && kinds[i] != NURBS_NODE_UNDECIDED;
        FUZZ_REQUIRE(ranges[4 * i] <= ranges[4 * i + 1] && ranges[4 * i + 2] <= ranges[4 * i + 3]);
    }
    FUZZ_REQUIRE(sizes.complete == (decided ? 1 : 0));
    for (size_t i = 0; i < n; ++i) {
        FUZZ_REQUIRE(levels[i] >= 0 && levels[i] < planes && (i == 0 || levels[i] >= levels[i - 1]));
        for (size_t end = 0; end < 2; ++end) {
            const int64_t node = ends[2 * i + end];
            FUZZ_REQUIRE(node >= -1 && node < sizes.nodes);
            FUZZ_REQUIRE(node < 0 || node_levels[static_cast<size_t>(node)] == levels[i]);
        }
        if (i < 16) {
            look_at_branch(meet, static_cast<int64_t>(i), deviations[i]);
        }
    }
}

void release(nurbs_meet *meet) {
    nurbs_meet *copy = nullptr;
    FUZZ_REQUIRE(nurbs_meet_clone(meet, &copy) == NURBS_OK);
    nurbs_meet_destroy(meet);
    sizes_of(copy);
    nurbs_meet_destroy(copy);
}

// Contours, levels of a polynomial, and those of a coordinate of the surface itself; each trimmed to the whole surface as a face.
void look_at_others(Input &in, const nurbs *g, const Point &normal, const Point &values, double tolerance,
                    const nurbs_call_options &call) {
    nurbs_meet *meet = nullptr, *trimmed = nullptr;
    const int32_t kind = in.below(6);
    const int64_t n = kind == NURBS_CONTOUR_ISOPHOTE || in.rarely() ? in.below(3) : 0;
    const std::array<double, 10> form{normal[0], normal[1], normal[2], values[0], values[1],
                                      values[2], normal[0], 1,         values[0], values[1]};
    const bool plain = in.rarely();
    bool found = false;
    switch (in.below(4)) {
    case 3:
        found = plain ? FUZZ_OK(nurbs_surface_reflections(g, kind, normal.data(), values.data(), n,
                                                          form.data(), 0, 0, tolerance, &meet))
                      : FUZZ_OK(nurbs_surface_reflections_with(g, kind, normal.data(), values.data(), n,
                                                               form.data(), 0, 0, tolerance, &call, &meet));
        break;
    case 0:
        found =
            plain
                ? FUZZ_OK(nurbs_surface_contours(g, kind, normal.data(), n, values.data(), tolerance, &meet))
                : FUZZ_OK(nurbs_surface_contours_with(g, kind, normal.data(), n, values.data(), tolerance,
                                                      &call, &meet));
        break;
    case 1:
        found =
            plain
                ? FUZZ_OK(nurbs_surface_level(g, 1, form.data(), tolerance, &meet))
                : FUZZ_OK(nurbs_surface_level_with(g, 1 + in.below(2), form.data(), tolerance, &call, &meet));
        break;
    default:
        found =
            plain ? FUZZ_OK(nurbs_surface_level_curves(g, g, n, values.data(), tolerance, &meet))
                  : FUZZ_OK(nurbs_surface_level_curves_with(g, g, n, values.data(), tolerance, &call, &meet));
    }
    if (!found) {
        FUZZ_REQUIRE(meet == nullptr);
        return;
    }
    look(meet, std::max<int64_t>(n, 1));
    nurbs_face *face = nullptr;
    if (FUZZ_OK(nurbs_face_create(g, 0, nullptr, nullptr, nullptr, nullptr, 1e-6, 0, nullptr, &face))) {
        if (plain ? FUZZ_OK(nurbs_meet_trim(meet, face, &trimmed))
                  : FUZZ_OK(nurbs_meet_trim_with(meet, face, &call, &trimmed))) {
            sizes_of(trimmed);
            nurbs_meet_destroy(trimmed);
        }
        nurbs_face_destroy(face);
    }
    release(meet);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    Point normal{}, offsets{};
    for (double &x : normal) {
        x = any_number(in, s);
    }
    for (double &x : offsets) {
        x = any_number(in, s);
    }
    const double tolerance = in.rarely() ? in.anything() : s.size() * std::ldexp(1, -in.below(40));
    const int64_t n = in.rarely() ? in.bad_size() : in.below(4);
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = in.coin() ? 20000000 : in.below(200) * 1000 + 1;
    nurbs_meet *meet = nullptr;
    if (FUZZ_OK(nurbs_surface_sections_with(g.get(), normal.data(), n, offsets.data(), tolerance, &call,
                                            &meet))) {
        look(meet, n);
        release(meet);
    } else {
        FUZZ_REQUIRE(meet == nullptr);
    }
    look_at_others(in, g.get(), normal, offsets, tolerance, call);
    if (in.rarely() &&
        FUZZ_OK(nurbs_surface_sections(g.get(), normal.data(), 1, offsets.data(), tolerance, &meet))) {
        look(meet, 1);
        nurbs_meet_destroy(meet);
    }
    return 0;
}

// SPDX-License-Identifier: MIT
// Splines as cells: Bezier cells have the control points of pieces, hexahedra are as near to a volume as is claimed, and places are
// those of points that there are.
#include "fuzz/harness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

using fuzz::Input;

namespace {

// All places are of points, and all points have one.
void check_places(const std::vector<int64_t> &places, int64_t points) {
    std::vector<bool> used(static_cast<size_t>(points));
    for (const int64_t place : places) {
        FUZZ_REQUIRE(place >= 0 && place < points);
        used[static_cast<size_t>(place)] = true;
    }
    FUZZ_REQUIRE(std::find(used.begin(), used.end(), false) == used.end());
}

void check_bezier_cells(const nurbs *g, const fuzz::Spline &s) {
    int64_t points = -1, cells = -1, same = -1, pieces = -1, width = 1;
    int32_t kind = -1;
    if (!FUZZ_OK(nurbs_bezier_cells(g, 0, nullptr, &kind, &points, &cells))) {
        return;
    }
    for (const int32_t degree : s.degrees) {
        width *= degree + 1;
    }
    std::vector<int64_t> places(static_cast<size_t>(cells * width));
    FUZZ_REQUIRE(nurbs_bezier_cells(g, cells, places.data(), nullptr, nullptr, nullptr) == NURBS_OK);
    FUZZ_REQUIRE(kind == 73 + 2 * static_cast<int32_t>(s.degrees.size()));
    check_places(places, points);
    std::vector<double> x(static_cast<size_t>(points * s.dim)), w(static_cast<size_t>(points));
    if (!FUZZ_OK(nurbs_bezier_cell_points(g, points, x.data(), w.data(), &same))) {
        return;
    }
    FUZZ_REQUIRE(nurbs_bezier_pieces(g, 0, nullptr, nullptr, nullptr, nullptr, &pieces) == NURBS_OK);
    FUZZ_REQUIRE(same == points && pieces == cells);
    std::vector<double> own(static_cast<size_t>(cells * width * s.dim));
    FUZZ_REQUIRE(nurbs_bezier_pieces(g, cells, own.data(), nullptr, nullptr, nullptr, &pieces) == NURBS_OK);
    for (int64_t e = 0; e < cells;
         ++e) { // the first corner is the first control point, and is no end of a seam
        FUZZ_REQUIRE(fuzz::same_bits(&own[static_cast<size_t>(e * width * s.dim)],
                                     &x[static_cast<size_t>(places[static_cast<size_t>(e * width)] * s.dim)],
                                     static_cast<size_t>(s.dim)));
    }
}

void check_folds(const nurbs *g, const nurbs_call_options &call) {
    int64_t count = -1;
    if (!FUZZ_OK(nurbs_fold_pieces(g, nullptr, 0, nullptr, nullptr, &count))) {
        return;
    }
    std::vector<int32_t> folds(static_cast<size_t>(count)), signs(folds);
    if (FUZZ_OK(nurbs_fold_pieces_with(g, nullptr, count, folds.data(), signs.data(), &count, &call))) {
        for (size_t i = 0; i < folds.size(); ++i) {
            FUZZ_REQUIRE(folds[i] >= NURBS_FOLD_NONE && folds[i] <= NURBS_FOLD_UNDECIDED);
            FUZZ_REQUIRE(signs[i] == 0 || (std::abs(signs[i]) == 1 && folds[i] == NURBS_FOLD_NONE));
        }
    }
}

struct DestroyMesh {
    void operator()(nurbs_mesh *mesh) const noexcept { nurbs_mesh_destroy(mesh); }
};

struct Hexahedra {
    std::vector<double> points, domains;
    std::vector<int64_t> corners;
    double bound = -1;
};

// The corner of a hexahedron that is at upper ends where bits are set: bit k for axis k.
constexpr std::array<size_t, 8> order{0, 1, 3, 2, 4, 5, 7, 6};

void check_sample(Input &in, const nurbs *g, const fuzz::Spline &s, const Hexahedra &all) {
    const size_t cell = (static_cast<size_t>(in.byte()) * 256 + in.byte()) % (all.corners.size() / 8);
    std::array<double, 3> t{}, share{}, sum{}, x{};
    for (size_t k = 0; k < 3; ++k) {
        const double a = all.domains[6 * cell + 2 * k], b = all.domains[6 * cell + 2 * k + 1];
        FUZZ_REQUIRE(a < b);
        t[k] = std::clamp(a + (b - a) * in.unit(), a, b);
        share[k] = (t[k] - a) / (b - a);
        if (!(t[k] > a && t[k] < b)) {
            return; // where the volume may jump
        }
    }
    for (size_t i = 0; i < 8; ++i) {
        double weight = 1;
        for (size_t k = 0; k < 3; ++k) {
            weight *= (order[i] >> k & 1) != 0 ? share[k] : 1 - share[k];
        }
        for (size_t c = 0; c < 3; ++c) {
            sum[c] += weight * all.points[static_cast<size_t>(3 * all.corners[8 * cell + i]) + c];
        }
    }
    FUZZ_REQUIRE(nurbs_eval(g, 1, t.data(), 0, 0, x.data(), 0, 0, 0) == NURBS_OK);
    const double off = 64 * fuzz::accuracy(s.degrees) * fuzz::eps * s.size() * 2;
    const double miss = std::hypot(x[0] - sum[0], x[1] - sum[1], x[2] - sum[2]);
    FUZZ_REQUIRE(!s.weights.empty() || miss <= all.bound * (1 + 1e-12) + off);
}

void check_hexahedra(Input &in, const nurbs *g, const fuzz::Spline &s, nurbs_call_options &call) {
    nurbs_mesh_options options;
    FUZZ_REQUIRE(nurbs_mesh_options_init(&options, sizeof options) == NURBS_OK);
    options.chord = in.rarely() ? in.anything() : std::ldexp(s.size() + 1e-300, -in.below(14));
    options.relative_chord = in.coin() ? 0 : in.unit();
    options.longest = in.coin() ? 0 : s.size() * in.unit();
    const int64_t limit = 1 + in.below(30);
    nurbs_mesh *made = nullptr;
    call.work = 0;
    if (!FUZZ_OK(nurbs_mesh_volume(g, &options, limit, &made))) {
        FUZZ_REQUIRE(made == nullptr);
        return;
    }
    const std::unique_ptr<nurbs_mesh, DestroyMesh> mesh(made);
    int64_t points = -1, count = -1, pieces = -1;
    Hexahedra all;
    int32_t reached = -1;
    FUZZ_REQUIRE(nurbs_mesh_counts(made, &points, nullptr, nullptr, nullptr, nullptr, nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_bound(made, &all.bound, nullptr, &reached) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_hexahedra(made, 0, nullptr, nullptr, nullptr, nullptr, &count) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_bezier_pieces(g, 0, nullptr, nullptr, nullptr, nullptr, &pieces) == NURBS_OK);
    FUZZ_REQUIRE(count <= std::max(limit, pieces) && count >= pieces);
    FUZZ_REQUIRE(all.bound >= 0 && (reached == 0 || all.bound <= options.chord));
    all.points.resize(static_cast<size_t>(3 * points));
    all.corners.resize(static_cast<size_t>(8 * count));
    all.domains.resize(static_cast<size_t>(6 * count));
    FUZZ_REQUIRE(nurbs_mesh_points(made, points, all.points.data(), nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_hexahedra(made, count, all.corners.data(), all.domains.data(), nullptr, nullptr,
                                      nullptr) == NURBS_OK);
    check_places(all.corners, points);
    for (int i = 0; i < 40; ++i) {
        check_sample(in, g, s, all);
    }
    if (in.coin()) {
        return;
    }
    call.work = int64_t{1} << (6 + in.below(20));
    nurbs_mesh *again = nullptr;
    (void)FUZZ_OK(nurbs_mesh_volume_with(g, &options, limit, &call, &again));
    nurbs_mesh_destroy(again);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    fuzz::Spline s;
    fuzz::add_axes(in, s, in.coin() ? 3 : 1 + in.below(3));
    fuzz::add_values(in, s, in.rarely() ? 1 + in.below(4) : 3);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = int64_t{1} << (8 + in.below(16));
    check_bezier_cells(g.get(), s);
    if (in.coin()) {
        check_folds(g.get(), call);
    }
    check_hexahedra(in, g.get(), s, call);
    return 0;
}

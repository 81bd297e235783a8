// Splines as cells: Bezier cells have the control points of the pieces, in the order of VTK, once each; hexahedra are as near to a
// volume as is claimed, and meet side by side; signs of Jacobians are those of samples; known solids.
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace volume_cells_test {

using namespace support;

namespace {

constexpr double eps = 0x1p-52;

using Place = std::array<int, 3>;
using Ids = std::vector<int64_t>;

struct DestroyMesh {
    void operator()(nurbs_mesh *mesh) const noexcept { nurbs_mesh_destroy(mesh); }
};

// Where VTK has a control point: counted from the definition. Points that are inside along more axes come later; of those inside along
// the same axes, first come edges by what VTK says of them; then the lower axes are faster.
int64_t vtk_index(const Place &at, const std::vector<int32_t> &degrees) {
    const size_t axes = degrees.size();
    std::array<int64_t, 3> inner{1, 1, 1};
    std::array<bool, 3> ends{true, true, true};
    int inside = 0;
    for (size_t k = 0; k < axes; ++k) {
        inner[k] = degrees[k] - 1;
        ends[k] = at[k] == 0 || at[k] == degrees[k];
        inside += ends[k] ? 0 : 1;
    }
    const auto upper = [&](size_t k) { return at[k] > 0 ? 1 : 0; };
    const int around = upper(1) != 0 ? 3 - upper(0) : upper(0); // corners of a quadrilateral
    if (axes == 1) {
        return inside == 0 ? upper(0) : at[0] + 1;
    }
    const int64_t corners = int64_t{1} << axes, ring = 2 * (inner[0] + inner[1]);
    const int64_t sheet = axes == 3 ? upper(2) : 0;
    if (inside == 0) {
        return 4 * sheet + around;
    }
    if (inside == 1 && !ends[0]) {
        return corners + sheet * ring + (upper(1) != 0 ? inner[0] + inner[1] : 0) + at[0] - 1;
    }
    if (inside == 1 && !ends[1]) {
        return corners + sheet * ring + (upper(0) != 0 ? inner[0] : 2 * inner[0] + inner[1]) + at[1] - 1;
    }
    if (inside == 1) {
        return corners + 2 * ring + around * inner[2] + at[2] - 1;
    }
    if (axes == 2) {
        return corners + ring + (at[1] - 1) * inner[0] + at[0] - 1;
    }
    int64_t before = corners + 2 * ring + 4 * inner[2];
    const std::array<int64_t, 3> sides{inner[1] * inner[2], inner[0] * inner[2], inner[0] * inner[1]};
    for (size_t k = 0; k < 3 && inside == 2; ++k) {
        if (ends[k]) {
            const size_t a = k == 0 ? 1 : 0, b = k == 2 ? 1 : 2;
            return before + upper(k) * sides[k] + (at[b] - 1) * inner[a] + at[a] - 1;
        }
        before += 2 * sides[k];
    }
    return corners + 2 * ring + 4 * inner[2] + 2 * (sides[0] + sides[1] + sides[2]) +
           ((at[2] - 1) * inner[1] + at[1] - 1) * inner[0] + at[0] - 1;
}

struct Cells {
    int64_t count = 0, points_of_cell = 1;
    int32_t kind = 0, dim = 0;
    Ids own_points;
    std::vector<double> points, weights;

    [[nodiscard]] const double *point(int64_t i) const { return points.data() + i * dim; }
};

Cells cells_of(const nurbs *g, const SplineData &data) {
    Cells cells;
    cells.dim = data.dim;
    for (const int32_t degree : data.degrees) {
        cells.points_of_cell *= degree + 1;
    }
    int64_t points = 0, same = 0;
    require_ok(nurbs_bezier_cells(g, 0, nullptr, &cells.kind, &points, &cells.count));
    cells.own_points.resize(static_cast<size_t>(cells.count * cells.points_of_cell));
    require_ok(nurbs_bezier_cells(g, cells.count, cells.own_points.data(), nullptr, nullptr, nullptr));
    cells.points.resize(static_cast<size_t>(points * data.dim));
    cells.weights.resize(static_cast<size_t>(points));
    require_ok(nurbs_bezier_cell_points(g, points, cells.points.data(), cells.weights.data(), &same));
    EXPECT_EQ(points, same);
    return cells;
}

struct Pieces {
    int64_t count = 0;
    std::vector<double> points, weights, domains;
    Ids along;
};

Pieces pieces_of_spline(const nurbs *g, const SplineData &data, int64_t points_of_piece) {
    Pieces all;
    all.along.resize(data.degrees.size());
    require_ok(nurbs_bezier_pieces(g, 0, nullptr, nullptr, nullptr, all.along.data(), &all.count));
    all.points.resize(static_cast<size_t>(all.count * points_of_piece * data.dim));
    all.weights.resize(static_cast<size_t>(all.count * points_of_piece));
    all.domains.resize(static_cast<size_t>(all.count * 2) * data.degrees.size());
    require_ok(nurbs_bezier_pieces(g, all.count, all.points.data(), all.weights.data(), all.domains.data(),
                                   nullptr, &all.count));
    return all;
}

// Of all control points of a cell, last axis fastest.
template <class Body>
void for_each_place(const std::vector<int32_t> &degrees, Body &&body) {
    const auto degree = [&](size_t k) { return k < degrees.size() ? degrees[k] : 0; };
    int64_t i = 0;
    for (int a = 0; a <= degree(0); ++a) {
        for (int b = 0; b <= degree(1); ++b) {
            for (int c = 0; c <= degree(2); ++c) {
                body(Place{a, b, c}, i++);
            }
        }
    }
}

// Knots of full multiplicity inside the domain of an axis.
int64_t jumps_of(const SplineData &data, size_t axis) {
    const auto &t = data.knots[axis];
    const int p = data.degrees[axis];
    std::map<double, int> times;
    for (const double knot : t) {
        ++times[knot];
    }
    return std::count_if(times.begin(), times.end(), [&](const auto &knot) {
        return knot.second > p && knot.first > t[static_cast<size_t>(p)] &&
               knot.first < t[t.size() - static_cast<size_t>(p) - 1];
    });
}

// Whether knots of periodic axes repeat without rounding, so that the ends are one to rounding too.
bool repeats_exactly(const SplineData &data) {
    bool exact = true;
    for (int k = 0; k < data.axes(); ++k) {
        const auto &t = data.knots[static_cast<size_t>(k)];
        exact = exact && (!data.periodic(k) || std::ranges::all_of(t, [](double x) {
                    return x == std::round(x * 1024) / 1024 && std::fabs(x) < 1e6;
                }));
    }
    return exact;
}

Recipe recipe_of_cells(Random &random, int axes, int most_degree) {
    Recipe recipe = random_recipe(random, axes, most_degree);
    for (AxisRecipe &axis : recipe.axes) {
        axis.degree = std::max(axis.degree, 1);
        axis.spans = std::min(axis.spans, 3);
    }
    return recipe;
}

// Sides of cells, as the control points or corners at them, and how many cells have each.
std::map<Ids, int> sides_of(const Ids &cells, const std::vector<int32_t> &degrees) {
    std::map<Ids, int> sides;
    int64_t width = 1;
    for (const int32_t degree : degrees) {
        width *= degree + 1;
    }
    for (size_t first = 0; first < cells.size(); first += static_cast<size_t>(width)) {
        for (size_t k = 0; k < degrees.size(); ++k) {
            std::array<Ids, 2> ends{Ids{static_cast<int64_t>(k)}, Ids{static_cast<int64_t>(k)}};
            for_each_place(degrees, [&](const Place &at, int64_t) {
                const auto id = cells[first + static_cast<size_t>(vtk_index(at, degrees))];
                if (at[k] == 0) {
                    ends[0].push_back(id);
                }
                if (at[k] == degrees[k]) {
                    ends[1].push_back(id);
                }
            });
            ++sides[ends[0]];
            ++sides[ends[1]];
        }
    }
    return sides;
}

} // namespace

// What a cell has at the place that VTK looks at is the control point of the piece, bit for bit; only across a seam to rounding.
TEST(BezierCells, HaveTheControlPointsOfPieces) {
    int64_t closed_cells = 0;
    for_each_case(5101, 300, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const SplineData data = random_spline(random, recipe_of_cells(random, axes, 5 - axes));
        const Handle g = create(data);
        const Cells cells = cells_of(g.get(), data);
        const Pieces pieces = pieces_of_spline(g.get(), data, cells.points_of_cell);
        ASSERT_EQ(cells.count, pieces.count);
        ASSERT_EQ(cells.kind, axes == 1 ? 75 : axes == 2 ? 77 : 79);
        std::set<int64_t> used;
        int64_t differ = 0;
        const double far = 64 * (5 + axes) * eps * extent(data);
        for (int64_t e = 0; e < cells.count; ++e) {
            int64_t piece = e;
            std::array<bool, 3> at_seam{};
            for (int k = axes; k-- > 0;) {
                const int64_t n = pieces.along[static_cast<size_t>(k)];
                at_seam[static_cast<size_t>(k)] = data.periodic(k) && piece % n == n - 1;
                piece /= n;
            }
            for_each_place(data.degrees, [&](const Place &at, int64_t i) {
                const int64_t id = cells.own_points[static_cast<size_t>(e * cells.points_of_cell +
                                                                        vtk_index(at, data.degrees))];
                used.insert(id);
                const int64_t from = e * cells.points_of_cell + i;
                bool seam = false, same = same_bits(cells.weights[static_cast<size_t>(id)],
                                                    pieces.weights[static_cast<size_t>(from)]);
                for (int k = 0; k < axes; ++k) {
                    seam = seam || (at_seam[static_cast<size_t>(k)] &&
                                    at[static_cast<size_t>(k)] == data.degrees[static_cast<size_t>(k)]);
                }
                for (int32_t c = 0; c < data.dim; ++c) {
                    const double x = cells.point(id)[c],
                                 y = pieces.points[static_cast<size_t>(from * data.dim + c)];
                    same = same && same_bits(x, y);
                    if (seam && data.weights.empty() && repeats_exactly(data)) {
                        ASSERT_LE(std::fabs(x - y), far) << where(seed, data);
                    }
                }
                ASSERT_TRUE(same || seam) << where(seed, data);
                differ += same ? 0 : 1;
                closed_cells += seam ? 1 : 0;
            });
        }
        ASSERT_EQ(std::ssize(used), std::ssize(cells.weights)) << where(seed, data);
    });
    EXPECT_GT(closed_cells, of_whole_run(50));
}

// Each side inside is one of two cells, unless the spline jumps there; a periodic axis has no ends.
TEST(BezierCells, MeetSideBySide) {
    int64_t exact = 0;
    for_each_case(5102, 200, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const SplineData data = random_spline(random, recipe_of_cells(random, axes, 5 - axes));
        const Handle g = create(data);
        const Cells cells = cells_of(g.get(), data);
        const Pieces pieces = pieces_of_spline(g.get(), data, cells.points_of_cell);
        int64_t free = 0, shared = 0, points = 1;
        for (const auto &[side, times] : sides_of(cells.own_points, data.degrees)) {
            ASSERT_LE(times, 2) << where(seed, data);
            (times == 1 ? free : shared) += 1;
        }
        int64_t expected = 0;
        for (int k = 0; k < axes; ++k) {
            const auto at = static_cast<size_t>(k);
            const int64_t along = pieces.along[at], joints = along - 1 - jumps_of(data, at);
            const auto &t = data.knots[at];
            const bool torn =
                data.periodic(k) && std::count(t.begin(), t.end(), data.upper(k)) > data.degrees[at];
            const int64_t seams = data.periodic(k) && !torn ? 1 : 0;
            expected += (joints + seams) * (cells.count / along);
            points *= along * (data.degrees[at] + 1) - joints - seams;
        }
        ASSERT_GE(shared, expected) << where(seed, data); // more where a random spline closes
        ASSERT_EQ(free + 2 * shared, 2 * axes * cells.count);
        if (shared == expected) {
            ASSERT_EQ(std::ssize(cells.weights), points) << where(seed, data);
            ++exact;
        }
    });
    EXPECT_GT(exact, of_whole_run(190)); // of 200
}

namespace {

// Volume of a Bezier cell, put back in the order of the library.
double volume_of_cell(const Cells &cells, int64_t e, const std::vector<int32_t> &degrees) {
    std::vector<double> points, weights;
    for_each_place(degrees, [&](const Place &at, int64_t) {
        const int64_t id =
            cells.own_points[static_cast<size_t>(e * cells.points_of_cell + vtk_index(at, degrees))];
        points.insert(points.end(), cells.point(id), cells.point(id) + 3);
        weights.push_back(cells.weights[static_cast<size_t>(id)]);
    });
    nurbs *out = nullptr;
    require_ok(nurbs_create_bezier(3, degrees.data(), 3, points.data(), 0, 0, weights.data(), 0, &out));
    const Handle cell(out);
    double volume = 0;
    require_ok(nurbs_moments(out, 1e-9, &volume, nullptr, nullptr, nullptr));
    return volume;
}

// A tube: an annulus in the plane x, z (rational in neither), turned about the axis of z.
Handle tube(double inner, double sweep, int32_t form) {
    const std::vector<int32_t> degrees{1, 2};
    const std::vector<double> points{inner, 0, 0, inner, 0, 0.5, inner, 0, 1, 2, 0, 0, 2, 0, 0.7, 2, 0, 1};
    const Handle sheet = made([&](nurbs **out) {
        return nurbs_create_bezier(2, degrees.data(), 3, points.data(), 0, 0, nullptr, 0, out);
    });
    return made([&](nurbs **out) { return nurbs_revolve(sheet.get(), nullptr, nullptr, sweep, form, out); });
}

struct Hexahedra {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<int64_t, 8>> corners;
    std::vector<std::array<double, 6>> domains;
    std::vector<int32_t> folds, signs;
    double bound = -1, from_mesh = -1;
    int32_t reached = -1;
};

Hexahedra hexahedra_of(const nurbs *g, double chord, int64_t limit = 0, double longest = 0) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = 0;
    options.longest = longest;
    nurbs_mesh *mesh = nullptr;
    require_ok(nurbs_mesh_volume(g, &options, limit, &mesh));
    const std::unique_ptr<nurbs_mesh, DestroyMesh> own(mesh);
    int64_t points = 0, vertices = -1, triangles = -1, count = 0;
    require_ok(nurbs_mesh_counts(mesh, &points, &vertices, &triangles, nullptr, nullptr, nullptr));
    EXPECT_EQ(vertices, 0);
    EXPECT_EQ(triangles, 0);
    require_ok(nurbs_mesh_hexahedra(mesh, 0, nullptr, nullptr, nullptr, nullptr, &count));
    const auto n = static_cast<size_t>(count);
    Hexahedra all;
    all.points.resize(static_cast<size_t>(points));
    all.corners.resize(n);
    all.domains.resize(n);
    all.folds.resize(n);
    all.signs.resize(n);
    require_ok(nurbs_mesh_points(mesh, points, all.points[0].data(), nullptr));
    require_ok(nurbs_mesh_hexahedra(mesh, count, all.corners[0].data(), all.domains[0].data(),
                                    all.folds.data(), all.signs.data(), nullptr));
    require_ok(nurbs_mesh_bound(mesh, &all.bound, &all.from_mesh, &all.reached));
    return all;
}

constexpr std::array<Place, 8> corner_places{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

// How far the volume is from a hexahedron at a place of it.
double miss(const nurbs *g, const Hexahedra &all, size_t cell, const std::array<double, 3> &place) {
    std::vector<double> t(3);
    std::array<long double, 3> x{};
    for (size_t k = 0; k < 3; ++k) {
        const double a = all.domains[cell][2 * k], b = all.domains[cell][2 * k + 1];
        t[k] = std::clamp(a + (b - a) * place[k], a, b);
    }
    for (size_t corner = 0; corner < 8; ++corner) {
        long double share = 1;
        for (size_t k = 0; k < 3; ++k) {
            const double a = all.domains[cell][2 * k], b = all.domains[cell][2 * k + 1];
            const long double s = (static_cast<long double>(t[k]) - a) / (static_cast<long double>(b) - a);
            share *= corner_places[corner][k] == 1 ? s : 1 - s;
        }
        for (size_t c = 0; c < 3; ++c) {
            x[c] += share * all.points[static_cast<size_t>(all.corners[cell][corner])][c];
        }
    }
    const std::vector<double> y = eval(g, t);
    return static_cast<double>(std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
}

// Of an inner place, which no jump is at.
std::array<double, 3> random_place(Random &random) {
    return {random.between(0.01, 0.99), random.between(0.01, 0.99), random.between(0.01, 0.99)};
}

Recipe recipe_of_volume(Random &random) {
    Recipe recipe = recipe_of_cells(random, 3, 3);
    recipe.dim = 3;
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = std::min(axis.spans, 2);
    }
    return recipe;
}

} // namespace

TEST(BezierCells, AddUpToTheVolume) {
    for (const double sweep : {1.0, 6.283185307179586}) {
        for (const int32_t form : {NURBS_ARC_QUARTERS, NURBS_ARC_THIRDS}) {
            const Handle coarse = tube(0.5, sweep, form);
            const Handle g = insert(insert(coarse.get(), 1, 0.25, 1).get(), 0, 0.3, 1);
            const SplineData data = read_back(g.get());
            const Cells cells = cells_of(g.get(), data);
            double whole = 0, sum = 0;
            require_ok(nurbs_moments(g.get(), 1e-9, &whole, nullptr, nullptr, nullptr));
            for (int64_t e = 0; e < cells.count; ++e) {
                sum += volume_of_cell(cells, e, data.degrees);
            }
            EXPECT_NEAR(sum, whole, 1e-8 * whole);
        }
    }
}

// Dense samples are no farther than the bound, and that is what was asked for if it says so.
TEST(Hexahedra, AreAsNearAsTheySay) {
    int64_t proven = 0, reached = 0;
    for_each_case(5103, 300, [&](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, recipe_of_volume(random));
        const Handle g = create(data);
        const double size = extent(data), chord = size * random.magnitude(1e-2, 1);
        const Hexahedra all = hexahedra_of(g.get(), chord, 300);
        ASSERT_EQ(all.bound, all.from_mesh);
        ASSERT_EQ(all.reached != 0, all.bound <= chord) << where(seed, data);
        proven += std::isfinite(all.bound) ? 1 : 0;
        reached += all.reached;
        for (int i = 0; i < 300; ++i) {
            const auto cell = static_cast<size_t>(random.bits() % all.corners.size());
            ASSERT_LE(miss(g.get(), all, cell, random_place(random)), all.bound + 512 * eps * size)
                << "cell " << cell << where(seed, data);
        }
    });
    EXPECT_GT(proven, of_whole_run(200));
    EXPECT_GT(reached, of_whole_run(60));
}

// Corners are points of the volume bit for bit; inner sides are of two hexahedra; domains fill the whole.
TEST(Hexahedra, MeetSideBySide) {
    const std::vector<int32_t> linear{1, 1, 1};
    int64_t exact = 0;
    for_each_case(5104, 100, [&](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, recipe_of_volume(random));
        const Handle g = create(data);
        const Hexahedra all = hexahedra_of(g.get(), extent(data) * random.magnitude(1e-1, 1), 200);
        Ids corners;
        std::array<std::set<double>, 3> lines;
        for (size_t i = 0; i < all.corners.size(); ++i) {
            corners.insert(corners.end(), all.corners[i].begin(), all.corners[i].end());
            for (size_t k = 0; k < 6; ++k) {
                lines[k / 2].insert(all.domains[i][k]);
            }
        }
        int64_t expected = 0, shared = 0, product = 1;
        bool plain = true;
        for (size_t k = 0; k < 3; ++k) {
            product *= std::ssize(lines[k]) - 1;
        }
        ASSERT_EQ(product, std::ssize(all.corners));
        for (size_t k = 0; k < 3; ++k) {
            const int axis = static_cast<int>(k);
            const auto &t = data.knots[k];
            const bool torn = std::count(t.begin(), t.end(), data.upper(axis)) > data.degrees[k];
            const int64_t along = std::ssize(lines[k]) - 1, jumps = jumps_of(data, k);
            expected += (along - 1 - jumps + (data.periodic(axis) && !torn ? 1 : 0)) * (product / along);
            plain = plain && jumps == 0 && !data.periodic(axis);
            ASSERT_EQ(*lines[k].begin(), data.lower(axis));
            ASSERT_EQ(*lines[k].rbegin(), data.upper(axis));
            for (const double knot : t) {
                ASSERT_TRUE(knot < data.lower(axis) || knot > data.upper(axis) || lines[k].contains(knot));
            }
        }
        for (const auto &[side, times] : sides_of(corners, linear)) {
            ASSERT_LE(times, 2) << where(seed, data);
            shared += times == 2 ? 1 : 0;
        }
        ASSERT_GE(shared, expected) << where(seed, data);
        exact += shared == expected ? 1 : 0;
        if (!plain || shared > expected) {
            return;
        }
        for (size_t i = 0; i < all.corners.size(); ++i) {
            for (size_t corner = 0; corner < 8; ++corner) {
                std::vector<double> params(3);
                for (size_t k = 0; k < 3; ++k) {
                    params[k] = all.domains[i][2 * k + static_cast<size_t>(corner_places[corner][k])];
                }
                const auto &x = all.points[static_cast<size_t>(all.corners[i][corner])];
                ASSERT_TRUE(same_bits(eval(g.get(), params), {x.begin(), x.end()})) << where(seed, data);
            }
        }
    });
    EXPECT_GT(exact, of_whole_run(90)); // of 100
}

// There are no more cells than the limit, or than pieces; nor much more than a bound of second derivatives needs.
TEST(Hexahedra, AreAsFewAsAsked) {
    const Handle g = tube(1, 1.5707963267948966, NURBS_ARC_QUARTERS); // r from 1 to 2, a quarter turn
    for (const double chord : {1e-2, 1e-3, 1e-4}) {
        const Hexahedra all = hexahedra_of(g.get(), chord, int64_t{1} << 22);
        EXPECT_EQ(all.reached, 1);
        EXPECT_LE(all.bound, chord);
        double worst = 0;
        Random random(7);
        for (int i = 0; i < 20000; ++i) {
            const auto cell = static_cast<size_t>(random.bits() % all.corners.size());
            worst = std::max(worst, miss(g.get(), all, cell, random_place(random)));
        }
        EXPECT_GT(worst, 0.4 * all.bound) << chord;
        // 2 (pi / 2)^2 / 8 along the arc, 0.7 / 4 along z at most, of which each has a half
        const double least = std::sqrt(2 * 2.4674 / 8 / (chord / 2)) * std::sqrt(0.175 / (chord / 2));
        EXPECT_LT(static_cast<double>(all.corners.size()), 1.6 * least + 8) << chord;
    }
    const Hexahedra few = hexahedra_of(g.get(), 1e-9, 1000);
    EXPECT_LE(few.corners.size(), 1000u);
    EXPECT_GT(few.corners.size(), 500u);
    EXPECT_EQ(few.reached, 0);
    EXPECT_LT(few.bound, 5e-3);
    EXPECT_EQ(hexahedra_of(g.get(), 1e-9, 1).corners.size(), 1u);
    const Hexahedra shorter = hexahedra_of(g.get(), 10, 0, 0.25);
    EXPECT_EQ(shorter.reached, 1);
    for (const auto &corners : shorter.corners) {
        for (const auto &[a, b] : {std::pair{0, 1}, {3, 2}, {0, 3}, {0, 4}, {2, 6}}) {
            const auto &x = shorter.points[static_cast<size_t>(corners[static_cast<size_t>(a)])];
            const auto &y = shorter.points[static_cast<size_t>(corners[static_cast<size_t>(b)])];
            EXPECT_LE(std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]), 0.25);
        }
    }
}

// A power of two in the unit of length changes nothing but sizes.
TEST(Hexahedra, DoNotDependOnUnits) {
    for_each_case(5105, 20, [&](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, recipe_of_volume(random));
        const double chord = extent(data) * 0.05;
        const Hexahedra all = hexahedra_of(create(data).get(), chord, 200),
                        other = hexahedra_of(create(scaled(data, 0x1p-30)).get(), chord * 0x1p-30, 200);
        ASSERT_EQ(all.corners, other.corners) << where(seed, data);
        ASSERT_EQ(all.domains, other.domains) << where(seed, data);
        ASSERT_EQ(all.bound * 0x1p-30, other.bound) << where(seed, data);
        ASSERT_EQ(all.signs, other.signs) << where(seed, data);
    });
}

namespace {

double jacobian(const nurbs *g, const std::vector<double> &t) {
    const std::vector<double> d = eval_derivs(g, 1, t);
    const double *u = d.data() + 3, *v = u + 3, *w = v + 3;
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
}

// A volume near the identity, shaken so that some fold.
SplineData shaken(Random &random, double size) {
    SplineData data;
    data.dim = 3;
    for (int k = 0; k < 3; ++k) {
        const int degree = random.whole(1, 2), spans = random.whole(1, 2);
        std::vector<double> knots(static_cast<size_t>(degree + 1), 0.0);
        for (int i = 1; i <= spans; ++i) {
            knots.insert(knots.end(), static_cast<size_t>(i == spans ? degree + 1 : 1),
                         static_cast<double>(i));
        }
        data.degrees.push_back(degree);
        data.counts.push_back(std::ssize(knots) - degree - 1);
        data.knots.push_back(knots);
    }
    for (int64_t i = 0; i < data.counts[0]; ++i) {
        for (int64_t j = 0; j < data.counts[1]; ++j) {
            for (int64_t k = 0; k < data.counts[2]; ++k) {
                for (const int64_t at : {i, j, k}) {
                    data.points.push_back(static_cast<double>(at) + random.between(-size, size));
                }
            }
        }
    }
    if (random.chance(50)) {
        for (int64_t i = 0; i < data.point_count(); ++i) {
            data.weights.push_back(random.between(0.5, 2));
        }
    }
    return data;
}

} // namespace

// Signs are those of samples; of pieces as of hexahedra, and of a whole that they make up.
TEST(Hexahedra, KnowWhereVolumesFold) {
    int64_t negative = 0, folded = 0, regular = 0;
    for_each_case(5106, 60, [&](Random &random, uint64_t seed) {
        SplineData data = shaken(random, random.between(0.1, 0.6));
        if (random.chance(30)) { // turned inside out
            for (size_t i = 0; i < data.points.size(); i += 3) {
                data.points[i] = -data.points[i];
            }
        }
        const Handle g = create(data);
        const Hexahedra all = hexahedra_of(g.get(), 0.2, 100);
        for (size_t i = 0; i < all.corners.size(); ++i) {
            ASSERT_TRUE(all.signs[i] == 0 || all.folds[i] == NURBS_FOLD_NONE);
            negative += all.signs[i] < 0 ? 1 : 0;
            folded += all.folds[i] == NURBS_FOLD_FOUND ? 1 : 0;
            for (int sample = 0; sample < 20 && all.signs[i] != 0; ++sample) {
                std::vector<double> t(3);
                for (size_t k = 0; k < 3; ++k) {
                    t[k] = random.between(all.domains[i][2 * k], all.domains[i][2 * k + 1]);
                }
                ASSERT_GT(all.signs[i] * jacobian(g.get(), t), -1e-9) << where(seed, data);
            }
        }
        int64_t count = 0;
        require_ok(nurbs_fold_pieces(g.get(), nullptr, 0, nullptr, nullptr, &count));
        std::vector<int32_t> folds(static_cast<size_t>(count)), signs(folds);
        require_ok(nurbs_fold_pieces(g.get(), nullptr, count, folds.data(), signs.data(), nullptr));
        int32_t whole = -1;
        require_ok(nurbs_fold_test(g.get(), nullptr, &whole, nullptr, nullptr));
        const bool one = std::ranges::all_of(folds, [](int32_t fold) { return fold == NURBS_FOLD_NONE; }) &&
                         std::ranges::all_of(signs, [&](int32_t sign) { return sign == signs[0]; });
        if (std::ranges::none_of(folds, [](int32_t fold) { return fold == NURBS_FOLD_UNDECIDED; })) {
            ASSERT_EQ(one, whole == NURBS_FOLD_NONE) << where(seed, data);
        }
        regular += one ? 1 : 0;
    });
    EXPECT_GT(negative, of_whole_run(20));
    EXPECT_GT(folded, of_whole_run(20));
    EXPECT_GT(regular, of_whole_run(10));
}

// A solid cylinder: one point along the axis, closed around it.
TEST(Hexahedra, OfASolidCylinder) {
    const Handle g = tube(0, 6.283185307179586, NURBS_ARC_QUARTERS);
    const Hexahedra all = hexahedra_of(g.get(), 0.05);
    EXPECT_EQ(all.reached, 1);
    std::array<std::set<double>, 3> lines;
    for (const auto &domain : all.domains) {
        for (size_t k = 0; k < 6; ++k) {
            lines[k / 2].insert(domain[k]);
        }
    }
    const size_t around = lines[0].size() - 1, out = lines[1].size() - 1, up = lines[2].size();
    EXPECT_EQ(all.points.size(), (around * out + 1) * up);
    double volume = 0;
    for (size_t i = 0; i < all.corners.size(); ++i) {
        const std::set<int64_t> corners(all.corners[i].begin(), all.corners[i].end());
        EXPECT_EQ(corners.size(), all.domains[i][2] == 0 ? 6u : 8u);
        EXPECT_EQ(all.folds[i], NURBS_FOLD_NONE);
        EXPECT_EQ(all.signs[i], all.signs[0]);
        std::vector<double> points;
        for (const size_t corner : {0U, 4U, 3U, 7U, 1U, 5U, 2U, 6U}) {
            const auto &x = all.points[static_cast<size_t>(all.corners[i][corner])];
            points.insert(points.end(), x.begin(), x.end());
        }
        const std::vector<int32_t> degrees{1, 1, 1};
        const Handle cell = made([&](nurbs **made_cell) {
            return nurbs_create_bezier(3, degrees.data(), 3, points.data(), 0, 0, nullptr, 0, made_cell);
        });
        double own = 0;
        require_ok(nurbs_moments(cell.get(), 1e-6, &own, nullptr, nullptr, nullptr));
        volume += own;
    }
    double whole = 0;
    require_ok(nurbs_moments(g.get(), 1e-9, &whole, nullptr, nullptr, nullptr));
    EXPECT_NEAR(volume, whole, 0.05 * 30); // an area of 2 pi 2 1 + 2 pi 4, times the distance
    EXPECT_LT(volume, whole);
}

// Points of a side that are the same along an axis, with weights: in proportion they make one point of each, otherwise they do not.
TEST(Hexahedra, OfSidesThatCollapseButForTheirWeights) {
    const std::vector<int32_t> degrees{1, 1, 1};
    std::vector<double> points;
    for (const Place &at :
         {Place{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}}) {
        points.insert(points.end(), {static_cast<double>(at[0] * at[1]), static_cast<double>(at[1]),
                                     static_cast<double>(at[2])});
    }
    for (const double last : {6.0, 1.0}) { // of the weights 1, 2, 3, last on the side
        const std::vector<double> weights{1, 2, 1, 1, 3, last, 1, 1};
        const Handle g = made([&](nurbs **out) {
            return nurbs_create_bezier(3, degrees.data(), 3, points.data(), 0, 0, weights.data(), 0, out);
        });
        const Hexahedra all = hexahedra_of(g.get(), 0.02);
        EXPECT_EQ(all.reached, 1) << last;
        std::set<int64_t> on_side;
        for (size_t i = 0; i < all.corners.size(); ++i) {
            for (size_t corner = 0; corner < 8; ++corner) {
                std::vector<double> t(3);
                for (size_t k = 0; k < 3; ++k) {
                    t[k] = all.domains[i][2 * k + static_cast<size_t>(corner_places[corner][k])];
                }
                const auto &x = all.points[static_cast<size_t>(all.corners[i][corner])];
                const std::vector<double> y = eval(g.get(), t);
                for (size_t c = 0; c < 3; ++c) {
                    EXPECT_NEAR(x[c], y[c], 16 * eps) << last;
                }
                if (t[1] == 0 && t[2] > 0 && t[2] < 1) {
                    on_side.insert(all.corners[i][corner]);
                }
            }
        }
        std::set<double> up, along;
        for (const auto &domain : all.domains) {
            up.insert(domain[4]);
            along.insert(domain[0]);
        }
        EXPECT_EQ(on_side.size(), (up.size() - 1) * (last == 6 ? 1 : along.size() + 1)) << last;
    }
}

} // namespace volume_cells_test

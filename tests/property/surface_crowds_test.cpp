// Surfaces that touch, or cross where they touch, in hundreds of places: each is told, and what is left open in one place is no
// loss to another.
#include "face_meets.h"
#include "support/generators.h"

#include <algorithm>

namespace surface_crowds_test {

using namespace face_meets;

namespace {

constexpr double tolerance = 1e-6;

// The square [low, high]^2 in the plane z = 0.
SplineData square(double low, double high) {
    return net_of({2, 2}, {1, 1}, false, [=](double u, double v) {
        return std::array<double, 4>{low + (high - low) * u, low + (high - low) * v, 0, 1};
    });
}

// n x n bilinear saddles over [0, 1]^2 that are at z = 0 in their middles and along the lines through these.
SplineData checkerboard(int n) {
    return net_of({n + 1, n + 1}, {1, 1}, false, [=](double u, double v) {
        const auto odd = std::lround(n * (u + v)) % 2;
        return std::array<double, 4>{u, v, odd == 1 ? 1.0 : -1.0, 1};
    });
}

// n x n biquadratic Bezier pieces over [0, 1]^2, the middle of each of which is a top at z = 0; height(i, j) of control points.
template <class Height>
SplineData tops(int n, Height &&height) {
    SplineData data{{2, 2}, {2 * n + 1, 2 * n + 1}, {{}, {}}, 3, {}, {}, 0};
    for (auto &knots : data.knots) {
        knots = {0, 0, 0};
        for (int i = 1; i <= n; ++i) {
            knots.insert(knots.end(), i == n ? 3 : 2, static_cast<double>(i) / n);
        }
    }
    for (int i = 0; i <= 2 * n; ++i) {
        for (int j = 0; j <= 2 * n; ++j) {
            data.points.insert(data.points.end(), {i / (2.0 * n), j / (2.0 * n), height(i, j)});
        }
    }
    return data;
}
double height_of_top(int i, int j) {
    return 0.02 * ((i % 2 == 0 ? -1 : 1) + (j % 2 == 0 ? -1 : 1));
}

// Whether each touch is in the middle of a piece of its own.
void check_middles(const Crossing &crossing, bool second, int n) {
    std::vector<int> touches(static_cast<size_t>(n * n));
    for (const MeetPart &node : second ? crossing.on_b : crossing.found.nodes) {
        if (node.kind == NURBS_NODE_TOUCH) {
            const double u = n * node.at[0], v = n * node.at[1];
            EXPECT_NEAR(u - std::floor(u), 0.5, 1e-3);
            EXPECT_NEAR(v - std::floor(v), 0.5, 1e-3);
            ++touches[static_cast<size_t>(std::floor(u) * n + std::floor(v))];
        }
    }
    EXPECT_EQ(std::ranges::count(touches, 1), n * n);
}

TEST(SurfaceCrowds, SaddlesAtTheirLevel) {
    constexpr int n = 20;
    const Handle saddles = create(checkerboard(n)), plane = create(square(-0.1, 1.1));
    for (const bool exchanged : {false, true}) {
        const Crossing crossing =
            crossing_of((exchanged ? plane : saddles).get(), (exchanged ? saddles : plane).get(), tolerance);
        EXPECT_TRUE(crossing.found.complete);
        check_middles(crossing, exchanged, n);
        EXPECT_EQ(crossing.found.count(NURBS_NODE_TOUCH), n * n);
        EXPECT_EQ(crossing.found.count(NURBS_NODE_BORDER), 4 * n);
        EXPECT_EQ(std::ssize(crossing.found.branches), 2 * n * (n + 1));
        EXPECT_NEAR(length_of(crossing.found), 2 * n, 4 * n * n * std::sqrt(tolerance));
    }
}

// Faces and models meet as their surfaces do.
TEST(SurfaceCrowds, SaddlesOfFaces) {
    constexpr int n = 20;
    const auto whole = [](const SplineData &data) {
        const Handle surface = create(data);
        nurbs_face *face = nullptr;
        require_ok(
            nurbs_face_create(surface.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &face));
        return Face(face);
    };
    const Face saddles = whole(checkerboard(n)), plane = whole(square(-0.1, 1.1));
    const auto check = [](const Crossing &crossing) {
        EXPECT_TRUE(crossing.found.complete);
        EXPECT_EQ(crossing.found.count(NURBS_NODE_TOUCH), n * n);
        EXPECT_EQ(std::ssize(crossing.found.branches), 2 * n * (n + 1));
    };
    check(face_meet(saddles.get(), plane.get(), tolerance).crossing);
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_model_intersections(support::models::model_of({saddles.get()}).get(),
                                         support::models::model_of({plane.get()}).get(), tolerance, &meet));
    check(crossing_in(MeetHandle(meet).get()));
}

TEST(SurfaceCrowds, TopsThatTouch) {
    constexpr int n = 20;
    const Handle surface = create(tops(n, height_of_top)), plane = create(square(-0.137, 1.1));
    const Crossing crossing = crossing_of(surface.get(), plane.get(), tolerance);
    EXPECT_TRUE(crossing.found.complete);
    check_middles(crossing, false, n);
    EXPECT_EQ(crossing.found.count(NURBS_NODE_TOUCH), n * n);
    EXPECT_TRUE(crossing.found.branches.empty());
}

// How often a spline with these coefficients changes its sign.
int64_t zeros_of(const SplineData &product, int n) {
    SplineData factor{{product.degrees[0]}, {n}, {product.knots[0]}, 1, {}, {}, 0};
    for (int i = 0; i < n; ++i) {
        factor.points.push_back(std::sin(60 * product.points[static_cast<size_t>(3 * n * i)]));
    }
    const Handle f = create(factor);
    int64_t zeros = 0;
    double last = eval(f.get(), {0.5 / 20000})[0];
    for (int i = 1; i < 20000; ++i) {
        const double next = eval(f.get(), {(i + 0.5) / 20000})[0];
        zeros += (next > 0) != (last > 0) ? 1 : 0;
        last = next;
    }
    return zeros;
}

// A product of a function of u and the same of v is 0 along r lines either way, besides two sides.
TEST(SurfaceCrowds, EggCrates) {
    for (const auto &[n, degree] : std::vector<std::array<int, 2>>{{21, 3}, {61, 1}}) {
        SCOPED_TRACE(n);
        const SplineData crate = net_of({n, n}, {degree, degree}, false, [](double u, double v) {
            return std::array<double, 4>{u, v, 0.02 * std::sin(60 * u) * std::sin(60 * v), 1};
        });
        // Inside of the sides on which it is 0.
        const Handle surface = create(crate), plane = create(square(0.004, 1.1));
        const Crossing crossing = crossing_of(surface.get(), plane.get(), tolerance);
        const int64_t r = zeros_of(crate, n);
        EXPECT_GE(r, 10);
        EXPECT_TRUE(crossing.found.complete);
        EXPECT_EQ(crossing.found.count(NURBS_NODE_TOUCH), r * r);
        EXPECT_EQ(std::ssize(crossing.found.branches), 2 * r * (r + 1));
    }
}

// Tops, but for some in the middle that are flat and lie in the plane, which bounds no region there: that is left open, in one node,
// and no touch that is farther away is lost.
TEST(SurfaceCrowds, ACrowdInOnePlace) {
    constexpr int n = 20, low = 14, high = 24;
    const auto flat = [](int i) { return i >= low && i <= high; };
    const Handle surface = create(
                     tops(n, [&](int i, int j) { return flat(i) && flat(j) ? 0 : height_of_top(i, j); })),
                 plane = create(square(-0.1, 1.1));
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = 1000000000;
    const Crossing crossing = crossing_of(surface.get(), plane.get(), tolerance, &call);
    EXPECT_FALSE(crossing.found.complete);
    constexpr int beside = 9; // rows of pieces that are flat, or have such neighbours
    EXPECT_GE(crossing.found.count(NURBS_NODE_TOUCH), n * n - beside * beside);
    for (const MeetPart &node : crossing.found.nodes) {
        for (size_t k = 0; k < 2 && node.kind == NURBS_NODE_UNDECIDED; ++k) {
            EXPECT_GE(node.range[k][0], 0.25);
            EXPECT_LE(node.range[k][1], 0.7);
        }
    }
}

// n polylines of m corners, as a surface of degree 0 along the first axis.
SplineData polylines(Random &random, int64_t n, int64_t m) {
    SplineData data{{0, 1}, {n, m}, {{}, {}}, 3, {}, {}, 0};
    for (int64_t i = 0; i <= n; ++i) {
        data.knots[0].push_back(static_cast<double>(i));
    }
    for (int64_t j = 0; j < m + 2; ++j) {
        data.knots[1].push_back(static_cast<double>(std::clamp(j - 1, int64_t{0}, m - 1)));
    }
    for (int64_t i = 0; i < 3 * n * m; ++i) {
        data.points.push_back(random.between(0, 1));
    }
    return data;
}

// Pieces of degree 0 have no tangents, so that their parts are only halved: lines that do not meet are told apart.
TEST(SurfaceCrowds, PiecesOfDegree0) {
    Random random(1);
    const Handle a = create(polylines(random, 15, 66)), b = create(polylines(random, 15, 2));
    const Crossing apart = crossing_of(a.get(), b.get(), 1e-15);
    EXPECT_TRUE(apart.found.complete);
    EXPECT_TRUE(apart.found.nodes.empty());
}

} // namespace

} // namespace surface_crowds_test

// SPDX-License-Identifier: MIT
// Sides of loops: against the sides of polygons and circles, on planes and on surfaces that close.
#include "face_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace nrb;
using namespace face_shapes;
using face::Face;
using face::FaceParts;
using face::Loop;
using face::Point2;

int side(const Face &face, const Point2 &x, double tolerance = 0) {
    int32_t result = 7;
    face::classify(face, {x.data(), 1, 2, 2, 1}, tolerance, &result);
    return result;
}

bool inside_polygon(const std::vector<Point2> &corners, const Point2 &x) {
    bool inside = false;
    for (size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Point2 &a = corners[i], &b = corners[j];
        if ((a[1] > x[1]) != (b[1] > x[1]) && x[0] < (b[0] - a[0]) * (x[1] - a[1]) / (b[1] - a[1]) + a[0]) {
            inside = !inside;
        }
    }
    return inside;
}

TEST(Classify, AgreesWithThePolygonOfStars) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> radius(0.1, 0.5), place(0, 1);
    for (int shape = 0; shape < 20; ++shape) {
        std::vector<Point2> corners;
        const int n = 3 + shape * 7;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n, r = radius(random);
            corners.push_back({0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)});
        }
        SplinePtr curve = polygon(corners);
        if (shape % 2 == 1) { // turned by the face
            curve = refine::reverse(*curve, 0, false);
        }
        const Face face({plane(), {loop_of({curve})}, 0}, nullptr);
        for (int i = 0; i < 500; ++i) {
            const Point2 x{place(random), place(random)};
            EXPECT_EQ(side(face, x), inside_polygon(corners, x) ? 1 : -1)
                << shape << ": " << x[0] << ", " << x[1];
        }
        for (const Point2 &corner : corners) {
            EXPECT_EQ(side(face, corner), 0);
        }
    }
}

TEST(Classify, KnowsCirclesAndHolesHoweverTheyRun) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(0, 1);
    for (int turned = 0; turned < 8; ++turned) {
        std::vector<SplinePtr> circles{circle({0.5, 0.5}, 0.1), circle({0.5, 0.5}, 0.45),
                                       circle({0.5, 0.5}, 0.3)};
        std::vector<Loop> loops;
        for (size_t i = 0; i < 3; ++i) {
            loops.push_back(
                loop_of({(turned >> i & 1) != 0 ? refine::reverse(*circles[i], 0, false) : circles[i]}));
        }
        const Face face({plane(), loops, 1e-12}, nullptr);
        for (int i = 0; i < 500; ++i) {
            const Point2 x{place(random), place(random)};
            const double r = std::hypot(x[0] - 0.5, x[1] - 0.5);
            EXPECT_EQ(side(face, x), r < 0.1 || (r > 0.3 && r < 0.45) ? 1 : -1) << x[0] << ", " << x[1];
        }
        EXPECT_EQ(side(face, {0.5, 0.6}), 0);
        EXPECT_EQ(side(face, {0.95, 0.5}), 0);
    }
}

TEST(Classify, MeasuresTheToleranceInSpace) {
    const Face face({plane(1000), {loop_of({circle({0.5, 0.5}, 0.25)})}, 1e-9}, nullptr);
    EXPECT_EQ(side(face, {0.5 + 0.25 + 0.9e-6, 0.5}, 1e-3), 0);
    EXPECT_EQ(side(face, {0.5 + 0.25 + 1.1e-6, 0.5}, 1e-3), -1);
    EXPECT_EQ(side(face, {0.5 + 0.25 - 0.9e-6, 0.5}, 1e-3), 0);
    EXPECT_EQ(side(face, {0.5 + 0.25 - 1.1e-6, 0.5}, 1e-3), 1);
}

// On surfaces that close: a place is inside or not whatever copy of it is asked for.
void expect_all_copies(const Face &face, const Point2 &x, int expected) {
    const double u = face.covering().closed(0) ? face.covering().period(0) : 0,
                 v = face.covering().closed(1) ? face.covering().period(1) : 0;
    for (const double i : {-2.0, 0.0, 1.0}) {
        for (const double j : {-1.0, 0.0, 3.0}) {
            EXPECT_EQ(side(face, {x[0] + i * u, x[1] + j * v}), expected)
                << x[0] << ", " << x[1] << ", copy " << i << ", " << j;
        }
    }
}

Point2 at(const Face &face, double u, double v) {
    return {face.covering().domain(0).lower + u * face.covering().period(0),
            face.covering().domain(1).lower + v * face.covering().period(1)};
}

TEST(Classify, BandsAroundACylinder) {
    const SplinePtr s = cylinder();
    // The upper boundary drops from 0.75 to 0.5 over a turn, and comes back along a line.
    const Face face(
        {s,
         {loop_of({segment(*s, {0, 0.25}, {1, 0.25})}),
          loop_of({segment(*s, {1.25, 0.5}, {0.25, 0.75}), segment(*s, {0.25, 0.75}, {0.25, 0.5})})},
         1e-9,
         true},
        nullptr);
    EXPECT_TRUE(face.covering().closed(0));
    EXPECT_FALSE(face.covering().closed(1));
    for (double u = 0.015; u < 1; u += 0.03) {
        const double turned = u < 0.25 ? u + 1 : u, top = 0.75 - (turned - 0.25) / 4;
        for (double v = 0.005; v < 1; v += 0.05) {
            expect_all_copies(face, at(face, u, v), v > 0.25 && v < top ? 1 : -1);
        }
    }
    EXPECT_EQ(side(face, at(face, 0.25, 0.6)), 0);
    EXPECT_EQ(side(face, at(face, 0, 0.25)), 0);
    EXPECT_EQ(side(face, at(face, 1, 0.25)), 0);
}

TEST(Classify, CapsOfASphereLieToTheLeft) {
    const SplinePtr s = sphere();
    const Face north({s, {loop_of({segment(*s, {0, 0.6}, {1, 0.6})})}, 1e-9}, nullptr);
    const Face south({s, {loop_of({segment(*s, {1, 0.6}, {0, 0.6})})}, 1e-9}, nullptr);
    EXPECT_TRUE(north.covering().collapsed(1, 0));
    EXPECT_TRUE(north.covering().collapsed(1, 1));
    for (const double u : {0.0, 0.3, 1.0}) {
        for (const double v : {0.0, 0.3, 0.59, 0.61, 1.0}) {
            expect_all_copies(north, at(north, u, v), v > 0.6 ? 1 : -1);
            expect_all_copies(south, at(south, u, v), v > 0.6 ? -1 : 1);
        }
    }
}

// Up one meridian and down another one: the way between them leads around the pole.
TEST(Classify, WaysThroughPolesKeepTheInsideToTheLeft) {
    const SplinePtr s = sphere();
    const auto lune = [&](double up, double down) {
        return std::make_unique<Face>(
            FaceParts{
                s, {loop_of({segment(*s, {up, 0}, {up, 1}), segment(*s, {down, 1}, {down, 0})})}, 1e-9, true},
            nullptr);
    };
    const auto quarter = lune(0.5, 0.25), rest = lune(0.25, 0.5), all = lune(0.125, 0.125);
    for (const double u : {0.06, 0.2, 0.3, 0.4, 0.6, 0.8, 0.99}) {
        for (const double v : {0.01, 0.5, 0.99}) {
            const bool between = u > 0.25 && u < 0.5;
            expect_all_copies(*quarter, at(*quarter, u, v), between ? 1 : -1);
            expect_all_copies(*rest, at(*rest, u, v), between ? -1 : 1);
            expect_all_copies(*all, at(*all, u, v), 1);
        }
    }
}

TEST(Classify, DiscsOverTheCornerOfATorus) {
    const SplinePtr s = torus();
    for (const bool hole : {false, true}) {
        SplinePtr disc = circle({0, 0}, 0.25);
        const double u = s->axis(0).domain().upper, v = s->axis(1).domain().upper;
        ASSERT_EQ(s->axis(0).domain().lower, 0);
        disc = hole ? refine::reverse(*disc, 0, false) : disc;
        const Face face({s, {loop_of({disc})}, 1e-9, true}, nullptr);
        EXPECT_TRUE(face.covering().closed(0) && face.covering().closed(1));
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(0, 1);
        for (int i = 0; i < 200; ++i) {
            const Point2 x{u * place(random) / (i % 2 == 0 ? 1 : 4), v * place(random)};
            const double r = std::hypot(std::min(x[0], u - x[0]), std::min(x[1], v - x[1]));
            expect_all_copies(face, x, (r < 0.25) != hole ? 1 : -1);
        }
    }
}

template <class Call>
Status status_of(Call call) {
    try {
        call();
        return Status::ok;
    } catch (const Error &error) {
        return error.status();
    }
}

TEST(Classify, TellsWhatLoopsDoWrong) {
    const auto status = [](const FaceParts &parts, std::vector<double> *gaps = nullptr) {
        return status_of([&] { const Face face(parts, gaps); });
    };
    const Loop open = loop_of({line({0, 0}, {1, 0}), line({1, 0}, {1, 1}), line({1, 1}, {0, 0.25})});
    std::vector<double> gaps;
    EXPECT_EQ(status({plane(), {open}, 0.1}, &gaps), Status::gap);
    EXPECT_EQ(gaps, std::vector<double>{0.25});
    EXPECT_EQ(status({plane(), {open}, 0.1, false, true}), Status::ok);
    EXPECT_EQ(status({plane(), {loop_of({circle({0.5, 0.5}, 0.6)})}, 1e-3}), Status::outside_domain);
    EXPECT_EQ(
        status(
            {plane(), {loop_of({circle({0.5, 0.5}, 0.4)}), loop_of({circle({0.5, 0.5}, 0.3)})}, 1e-3, true}),
        Status::orientation);
    EXPECT_EQ(
        status({plane(), {loop_of({line({0.5, 0.1}, {0.5, 0.9}), line({0.5, 0.9}, {0.5, 0.1})})}, 1e-3}),
        Status::orientation);
}

// The boundary of the middle of a domain.
Loop ring(const Spline &surface, bool against) {
    const std::vector<Point2> corners{{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}, {0.25, 0.25}};
    std::vector<SplinePtr> sides;
    for (size_t i = 0; i < 4; ++i) {
        const size_t a = against ? 4 - i : i, b = against ? a - 1 : a + 1;
        sides.push_back(segment(surface, corners[a], corners[b]));
    }
    return loop_of(sides);
}

TEST(Classify, LoopsThatLieOnOthersBoundNothing) {
    for (const SplinePtr &surface : {plane(), cylinder(), torus()}) {
        for (const bool as_oriented : {false, true}) {
            for (const bool against : {false, true}) {
                FaceParts parts{surface, {ring(*surface, false), ring(*surface, against)}, 1e-6, as_oriented};
                EXPECT_EQ(status_of([&] { const Face face(parts, nullptr); }), Status::orientation)
                    << as_oriented << against;
                parts.loops.resize(5000, parts.loops.front()); // refused at the third one
                EXPECT_EQ(status_of([&] { const Face face(parts, nullptr); }), Status::orientation)
                    << as_oriented << against;
            }
        }
    }
}

TEST(Classify, ToriMayBeCutOpen) {
    const SplinePtr surface = torus();
    const Loop there = loop_of({segment(*surface, {0.5, 0}, {0.5, 1})}),
               back = loop_of({segment(*surface, {0.5, 1}, {0.5, 0})});
    const Loop all = loop_of({segment(*surface, {0, 0}, {1, 0}), segment(*surface, {1, 0}, {1, 1}),
                              segment(*surface, {1, 1}, {0, 1}), segment(*surface, {0, 1}, {0, 0})});
    for (const std::vector<Loop> &loops : {std::vector<Loop>{there, back}, {all}}) {
        for (const bool as_oriented : {false, true}) {
            const Face face({surface, loops, 1e-6, as_oriented}, nullptr);
            EXPECT_EQ(side(face, {surface->axis(0).domain().upper / 3, surface->axis(1).domain().upper / 3}),
                      1);
        }
    }
    EXPECT_EQ(status_of([&] {
                  const Face face({surface, {there, back, there}, 1e-6, true}, nullptr);
              }),
              Status::orientation);
}

// Two edges of each triangle lie on a third one but for rounding: what is between them tells nothing of which loop lies in which.
TEST(Classify, EdgesOnEachOtherTellNothingOfNesting) {
    const auto scaled = [](std::vector<Point2> corners) {
        for (Point2 &corner : corners) {
            corner = {corner[0] / 5, corner[1] / 5};
        }
        return face_shapes::polygon(corners);
    };
    const std::vector<Point2> first{{1, 2}, {2, 3}, {2, 4}, {3, 4}}, second{{2, 1}, {3, 2}, {4, 2}, {4, 3}},
        simple{{2, 3}, {2, 4}, {3, 4}};
    for (const std::vector<Point2> &corners : {first, simple}) {
        const Face face({face_shapes::plane(), {loop_of({scaled(corners)}), loop_of({scaled(second)})}, 1e-6},
                        nullptr);
        EXPECT_EQ(side(face, {0.02, 0.02}), -1);
        EXPECT_EQ(side(face, {0.44, 0.75}), 1);
        EXPECT_EQ(side(face, {0.75, 0.44}), 1);
    }
}

// The metric beyond the domain is that at its end: only what is within the tolerance of the boundary is on it.
TEST(Classify, PlacesBeyondOpenAxesAreOutside) {
    const Face face({plane(), {}, 0}, nullptr);
    const double tolerance = 1e-3;
    for (const double x : {-4.0, -2 * tolerance, 1 + 2 * tolerance, 5.0}) {
        EXPECT_EQ(side(face, {x, 0.5}, tolerance), -1) << x;
        EXPECT_EQ(side(face, {0.5, x}, tolerance), -1) << x;
        EXPECT_EQ(side(face, {x, x}, tolerance), -1) << x;
    }
    for (const double x : {-tolerance / 2, tolerance / 2, 1 - tolerance / 2, 1 + tolerance / 2}) {
        EXPECT_EQ(side(face, {x, 0.5}, tolerance), 0) << x;
        EXPECT_EQ(side(face, {0.5, x}, tolerance), 0) << x;
    }
}

} // namespace

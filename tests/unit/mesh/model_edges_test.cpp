// SPDX-License-Identifier: MIT
// What is told of the polylines of edges, against samples: as they are made, and where vertices are added to them.
#include "mesh/border/model_edges.h"

#include "base/numbers.h"
#include "eval/curve_point.h"
#include "mesh/proof/distance.h"
#include "model/from_faces.h"
#include "spline/part.h"
#include "support/generators.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace model_edges_test {

using namespace nrb;
using namespace nrb::mesh;

namespace {

// The unit square in the plane z = 0.
SplinePtr plate() {
    const KnotVectorPtr axis = shapes::bezier_axis(1);
    return make_spline({axis, axis}, 3, Form::polynomial, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0});
}

model::Model model_of(face::Loop loop, double tolerance) {
    face::FaceParts parts{plate(), {std::move(loop)}, tolerance};
    return model::model_of_faces({std::make_shared<const face::Face>(std::move(parts), nullptr)}, 1);
}

// The part of the square above a curve from its left side to its right side.
model::Model above(const SplinePtr &curve) {
    const auto line = [](double a, double b, double c, double d) { return shapes::bezier(2, {a, b, c, d}); };
    std::array<double, 2> left{}, right{};
    eval::end_point(*curve, false, left.data());
    eval::end_point(*curve, true, right.data());
    return model_of({{curve, nullptr},
                     {line(1, right[1], 1, 1), nullptr},
                     {line(1, 1, 0, 1), nullptr},
                     {line(0, 1, 0, left[1]), nullptr}},
                    1e-9);
}

// The largest distance of samples of an edge from its polyline.
double farthest(const model::Model &model, const ModelEdges &edges, size_t number) {
    const EdgeLine &line = edges.lines()[number];
    const Spline &edge = *model.edges[static_cast<size_t>(line.edge)].curve;
    const auto point = [&](size_t i) { return edges.points()[static_cast<size_t>(line.points[i])]; };
    double result = 0;
    for (int i = 0; i <= 400; ++i) {
        const std::vector<double> at =
            eval::curve_point(edge, parameter_in(edge.axis(0).domain(), i / 400.0), false);
        double nearest = infinity;
        for (size_t k = 0; k + 1 < line.points.size(); ++k) {
            nearest = std::min(nearest, distance_from_segment({at[0], at[1], at[2]}, point(k), point(k + 1)));
        }
        result = std::max(result, nearest);
    }
    return result;
}

} // namespace

// Where a segment is divided off its middle, a curve on both sides of it may be farther from a part than from the whole.
TEST(ModelEdges, bounds_hold_where_segments_are_divided) {
    support::Random random(20261130);
    for (int i = 0; i < 200; ++i) {
        const double a = random.between(-0.3, 0.3), b = random.between(-1.2, 0.2) * a,
                     chord = std::abs(a) * random.between(0.05, 0.6);
        const SplinePtr curve =
            shapes::curve(2, {0, 0, 0, 0.5, 1, 1, 1}, 2, {0, 0.4, 0.25, 0.4 + a, 0.75, 0.4 + b, 1, 0.4});
        const model::Model model = above(curve);
        ModelEdges edges(model, {chord});
        for (int k = 0; k < 3; ++k) {
            for (size_t line = 0; line < edges.lines().size(); ++line) {
                EXPECT_LE(farthest(model, edges, line), edges.lines()[line].bound) << i;
                EXPECT_TRUE(!edges.lines()[line].reached || edges.lines()[line].bound <= chord) << i;
            }
            edges.add_vertices(edges.line_of(0, 0, 0), std::vector{random.unit()});
        }
    }
}

// The corners of a face are those of one of its edges; others end up to the tolerance away.
TEST(ModelEdges, bounds_hold_where_edges_do_not_meet) {
    for (const double apart : {0.0, 1e-3, 0.01}) {
        face::Loop loop;
        const std::array<face::Point2, 5> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
        for (size_t k = 0; k < 4; ++k) {
            const auto [a, b] = corners[k];
            const auto [c, d] = corners[k + 1];
            const double height = k % 2 == 0 ? 0 : apart;
            loop.push_back(
                {shapes::bezier(2, {a, b, c, d}), shapes::bezier(3, {a, b, height, c, d, height})});
        }
        const model::Model model = model_of(std::move(loop), 0.05);
        const ModelEdges edges(model, {1e-3});
        for (size_t line = 0; line < edges.lines().size(); ++line) {
            EXPECT_LE(farthest(model, edges, line), edges.lines()[line].bound);
            EXPECT_LE(edges.lines()[line].bound, apart + 1e-12);
        }
    }
}

// Foot points may swap: then they are put between those that did not, and nothing else changes.
TEST(CurvePairing, parameters_are_put_in_order) {
    support::Random random(8);
    for (int i = 0; i < 1000; ++i) {
        const int n = random.whole(2, 12);
        const double noise = random.chance(50) ? 0 : random.between(0, 0.5),
                     sign = random.chance(50) ? 1 : -1;
        std::vector<PairedParam> pairs;
        for (int k = 0; k <= n; ++k) {
            const double x = static_cast<double>(k) / n;
            const bool fixed = k == 0 || k == n || random.chance(20);
            pairs.push_back(
                {x, sign * (fixed ? x : std::clamp(x + random.between(-noise, noise), 0.0, 1.0)), fixed});
        }
        std::vector<PairedParam> ordered = pairs;
        put_in_order(ordered);
        const auto at = [&](const PairedParam &x) { return sign * x.found; };
        EXPECT_TRUE(std::ranges::is_sorted(ordered, {}, at)) << i;
        const bool stays = std::ranges::is_sorted(pairs, {}, at);
        for (size_t k = 0; k < pairs.size(); ++k) {
            EXPECT_TRUE((!stays && !pairs[k].fixed) || pairs[k].found == ordered[k].found) << i;
        }
    }
}

} // namespace model_edges_test

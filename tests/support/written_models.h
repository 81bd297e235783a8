// What the tests of the writers of all formats write.
#pragma once

#include "build/placement.h"
#include "face/face.h"
#include "model/model.h"

#include <array>
#include <random>
#include <string>
#include <vector>

namespace write_test {

using namespace nrb;

inline SplinePtr spline_of(int dim, Form form, std::vector<double> knots, int degree,
                           std::vector<double> points, std::vector<double> weights = {}) {
    return make_spline({make_knot_vector(degree, std::move(knots))}, dim, form, std::move(points),
                       std::move(weights));
}

inline model::Model list_of(std::vector<SplinePtr> splines) {
    model::Model model;
    for (SplinePtr &spline : splines) {
        model.splines.push_back({"s" + std::to_string(model.splines.size()), std::move(spline)});
    }
    return model;
}

// Rows of a motion with a scale, or of its mirror image where `side` is -1.
inline std::array<double, 12> random_motion(std::mt19937 &random, double scale, double side) {
    std::uniform_real_distribution<double> some(-1, 1);
    const double axis[] = {some(random), some(random), some(random)},
                 x[] = {some(random), some(random), some(random)},
                 at[] = {100 * some(random), some(random), some(random)};
    const build::Placement frame = build::make_placement(3, at, axis, x, "origin");
    const Vector3 y = cross(frame.z, frame.x);
    return {scale * frame.x.x, side * scale * y.x, scale * frame.z.x, at[0],
            scale * frame.x.y, side * scale * y.y, scale * frame.z.y, at[1],
            scale * frame.x.z, side * scale * y.z, scale * frame.z.z, at[2]};
}

// A square at a height, on the plane z = 0.
inline face::FacePtr square_at(double height, double tolerance) {
    face::FaceParts parts;
    const auto axis = [] { return make_knot_vector(1, {0, 0, 1, 1}); };
    parts.surface =
        make_spline({axis(), axis()}, 3, Form::polynomial, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}, {});
    const double corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    face::Loop &loop = parts.loops.emplace_back();
    for (size_t i = 0; i < 4; ++i) {
        const auto &a = corners[i], &b = corners[i + 1];
        loop.push_back({nullptr, spline_of(3, Form::polynomial, {0, 0, 1, 1}, 1,
                                           {a[0], a[1], height, b[0], b[1], height})});
    }
    parts.tolerance = tolerance;
    return std::make_shared<const face::Face>(std::move(parts), nullptr);
}

} // namespace write_test

// Regions of the plane, for tests of their laws.
#pragma once

#include "property/faces.h"
#include "property/models.h"
#include "support/cases.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace support::regions {

using models::Model;
using Vec = std::vector<double>;
using Point = std::array<double, 2>;
using Curves = std::vector<Handle>; // each closes

inline Handle polygon(const std::vector<Point> &corners) {
    SplineData data{{1}, {std::ssize(corners) + 1}, {{}}, 2, {}, {}};
    data.knots[0].push_back(0);
    for (size_t i = 0; i <= corners.size(); ++i) {
        data.knots[0].push_back(static_cast<double>(i));
        const Point &corner = corners[i % corners.size()];
        data.points.insert(data.points.end(), corner.begin(), corner.end());
    }
    data.knots[0].push_back(static_cast<double>(corners.size()));
    return create(data);
}

inline Handle rectangle(double left, double low, double right, double high) {
    return polygon({{left, low}, {right, low}, {right, high}, {left, high}});
}

inline Handle circle(double x, double y, double radius) {
    const Point center{x, y};
    return made([&](nurbs **out) {
        return nurbs_curve_circle(2, center.data(), nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
    });
}

inline nurbs_status try_region(const Curves &curves, int32_t rule, double tolerance, Model &out) {
    std::vector<const nurbs *> given;
    for (const Handle &curve : curves) {
        given.push_back(curve.get());
    }
    nurbs_model *model = nullptr;
    const nurbs_status status = nurbs_region_create(std::ssize(given), given.data(), rule, tolerance, &model);
    out.reset(model);
    return status;
}

inline Model region(const Curves &curves, int32_t rule = NURBS_FILL_NON_ZERO, double tolerance = 0) {
    Model model;
    require_ok(try_region(curves, rule, tolerance, model));
    return model;
}

inline std::vector<models::Face> faces_of(const nurbs_model *model) {
    std::vector<models::Face> faces;
    const int64_t count = model == nullptr ? 0 : models::counts_of(model).faces;
    for (int64_t i = 0; i < count; ++i) {
        faces.push_back(models::face_of(model, i));
    }
    return faces;
}

inline nurbs_status try_combine(int32_t rule, const Model &a, const Model &b, Model &out) {
    const std::vector<models::Face> of_a = faces_of(a.get()), of_b = faces_of(b.get());
    std::vector<const nurbs_face *> first, second;
    for (const models::Face &face : of_a) {
        first.push_back(face.get());
    }
    for (const models::Face &face : of_b) {
        second.push_back(face.get());
    }
    nurbs_model *model = nullptr;
    const nurbs_status status = nurbs_region_combine(rule, std::ssize(first), first.data(),
                                                     std::ssize(second), second.data(), 0, &model);
    out.reset(model);
    return status;
}

inline Model combine(int32_t rule, const Model &a, const Model &b) {
    Model model;
    require_ok(try_combine(rule, a, b, model));
    return model;
}

inline double area_of(const Model &region) {
    double area = 0;
    for (const models::Face &face : faces_of(region.get())) {
        double own = 0;
        require_ok(nurbs_face_area(face.get(), 1e-12, &own, nullptr));
        area += own;
    }
    return area;
}

// Of each place: 1 inside, 0 on the border, -1 outside.
inline std::vector<int32_t> sides_of(const Model &region, const Vec &places, double tolerance = 0) {
    std::vector<int32_t> result(places.size() / 2, -1), own(result.size());
    for (const models::Face &face : faces_of(region.get())) {
        require_ok(
            nurbs_face_classify(face.get(), std::ssize(own), places.data(), 0, 0, tolerance, own.data()));
        for (size_t i = 0; i < own.size(); ++i) {
            result[i] = std::max(result[i], own[i]);
        }
    }
    return result;
}

inline Vec end_of(const nurbs *curve, bool upper) {
    double domain[2];
    require_ok(nurbs_domain(curve, 0, domain));
    return eval(curve, {domain[upper ? 1 : 0]});
}

// A curve of a loop with its edge.
struct Use {
    Handle curve, edge;
    int64_t key = 0;
};
inline std::vector<std::vector<Use>> loops_of(const nurbs_face *face) {
    int64_t count = 0;
    require_ok(nurbs_face_loops(face, 0, nullptr, &count));
    std::vector<int64_t> sizes(static_cast<size_t>(count));
    require_ok(nurbs_face_loops(face, count, sizes.data(), nullptr));
    std::vector<std::vector<Use>> loops(sizes.size());
    for (size_t i = 0; i < loops.size(); ++i) {
        const auto loop = static_cast<int64_t>(i);
        for (int64_t j = 0; j < sizes[i]; ++j) {
            Use &use = loops[i].emplace_back();
            use.curve = made([&](nurbs **out) { return nurbs_face_curve(face, loop, j, out); });
            use.edge = made([&](nurbs **out) { return nurbs_face_edge(face, loop, j, &use.key, out); });
        }
    }
    return loops;
}

} // namespace support::regions

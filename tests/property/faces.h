// Faces of surfaces that close up or do not, and loops in their domains, for tests of their laws.
#pragma once

#include "support/cases.h"
#include "support/handle.h"

#include <array>
#include <cmath>
#include <numbers>

namespace support::faces {

inline constexpr double pi = std::numbers::pi;
using Vec = std::vector<double>;
using Place = std::array<double, 2>;

struct DestroyFace {
    void operator()(nurbs_face *face) const noexcept { nurbs_face_destroy(face); }
};
using Face = std::unique_ptr<nurbs_face, DestroyFace>;
using Curves = std::vector<std::vector<const nurbs *>>; // of each loop

inline Face face_of(const nurbs *surface, const Curves &loops, double tolerance = 1e-9, uint32_t flags = 0) {
    std::vector<int64_t> sizes;
    std::vector<const nurbs *> curves;
    for (const auto &loop : loops) {
        sizes.push_back(std::ssize(loop));
        curves.insert(curves.end(), loop.begin(), loop.end());
    }
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(surface, std::ssize(sizes), sizes.data(), curves.data(), nullptr, nullptr,
                                 tolerance, flags, nullptr, &face));
    return Face(face);
}

// Of the check for crossings.
inline nurbs_status checked(const nurbs *surface, const Curves &loops, double tolerance, uint32_t flags = 0) {
    std::vector<int64_t> sizes;
    std::vector<const nurbs *> curves;
    for (const auto &loop : loops) {
        sizes.push_back(std::ssize(loop));
        curves.insert(curves.end(), loop.begin(), loop.end());
    }
    nurbs_face *face = nullptr;
    const nurbs_status status =
        nurbs_face_create(surface, std::ssize(sizes), sizes.data(), curves.data(), nullptr, nullptr,
                          tolerance, flags | NURBS_CHECK_CROSSINGS, nullptr, &face);
    nurbs_face_destroy(face);
    return status;
}

inline std::vector<int32_t> sides(const nurbs_face *face, const Vec &places, double tolerance = 0) {
    std::vector<int32_t> found(places.size() / 2);
    require_ok(nurbs_face_classify(face, std::ssize(found), places.data(), 0, 0, tolerance, found.data()));
    return found;
}
inline double area_of(const nurbs_face *face, double tolerance = 1e-10) {
    double area = 0;
    require_ok(nurbs_face_area(face, tolerance, &area, nullptr));
    return area;
}

struct Box {
    Vec lower, upper;
    double gap = -1;
};
inline Box box_of(const nurbs_face *face, double tolerance) {
    Box box{Vec(3), Vec(3), -1};
    require_ok(nurbs_face_box(face, tolerance, box.lower.data(), box.upper.data(), &box.gap));
    return box;
}

// A surface, the part of the domain that copies of loops are moved by, and its area if that is known.
struct Ground {
    Handle surface;
    std::array<bool, 2> closed{};
    Place lower{}, period{};

    [[nodiscard]] Place at(double u, double v) const {
        return {lower[0] + u * period[0], lower[1] + v * period[1]};
    }
};

inline Ground ground_of(Handle surface, bool closed_u, bool closed_v) {
    Ground ground{std::move(surface), {closed_u, closed_v}, {}, {}};
    for (const int32_t k : {0, 1}) {
        double ends[2];
        require_ok(nurbs_domain(ground.surface.get(), k, ends));
        ground.lower[static_cast<size_t>(k)] = ends[0];
        ground.period[static_cast<size_t>(k)] = ends[1] - ends[0];
    }
    return ground;
}

// The plane (size u, size v, 0) over [0, length]^2.
inline Ground plane(double size = 1, double length = 1) {
    const Vec knots{0, 0, length, length};
    return ground_of(
        create({{1, 1}, {2, 2}, {knots, knots}, 3, {0, 0, 0, 0, size, 0, size, 0, 0, size, size, 0}, {}, 0}),
        false, false);
}
inline Ground cylinder(double radius, double height) {
    return ground_of(made([&](nurbs **out) {
                         return nurbs_surface_cylinder(nullptr, nullptr, nullptr, radius, height, 0, 2 * pi,
                                                       NURBS_ARC_QUARTERS, out);
                     }),
                     true, false);
}
inline Ground sphere(double radius) {
    return ground_of(made([&](nurbs **out) {
                         return nurbs_surface_sphere(nullptr, nullptr, nullptr, radius, NURBS_ARC_QUARTERS,
                                                     out);
                     }),
                     true, false);
}
inline Ground torus(double major, double minor) {
    return ground_of(made([&](nurbs **out) {
                         return nurbs_surface_torus(nullptr, nullptr, nullptr, major, minor, 0, 2 * pi, 0,
                                                    2 * pi, NURBS_ARC_QUARTERS, out);
                     }),
                     true, true);
}

// A patch of height 1 over the unit square, with inner knots on both axes.
inline Ground wavy(Random &random) {
    const Vec knots{0, 0, 0, 0, 0.25, 0.75, 1, 1, 1, 1};
    SplineData data{{3, 3}, {6, 6}, {knots, knots}, 3, {}, {}, 0};
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            data.points.insert(data.points.end(), {i / 5.0, j / 5.0, random.between(-0.5, 0.5)});
        }
    }
    return ground_of(create(data), false, false);
}

// A closed curve about a place, in parts of the domain: radii of its control points lie between a third of the radius and all.
struct Star {
    int degree = 3;
    bool rational = false, periodic = false;
    double radius = 0.4;
};

inline SplineData star(Random &random, const Ground &ground, const Place &centre, const Star &star) {
    const int corners = star.degree + 3 + random.whole(0, 6);
    SplineData data{{star.degree}, {}, {{}}, 2, {}, {}, star.periodic ? NURBS_PERIODIC : 0};
    const int count = star.periodic ? corners + star.degree : corners + 1;
    data.counts = {count};
    for (int i = 0; i < count; ++i) {
        if (i >= corners) {
            const auto first = static_cast<size_t>(i - corners);
            const Place again{data.points[2 * first], data.points[2 * first + 1]};
            data.points.insert(data.points.end(), again.begin(), again.end());
        } else {
            const double angle = 2 * pi * i / corners, r = star.radius * random.between(0.34, 1);
            data.points.push_back(centre[0] + r * std::cos(angle) * ground.period[0]);
            data.points.push_back(centre[1] + r * std::sin(angle) * ground.period[1]);
        }
        if (star.rational) {
            data.weights.push_back(i >= corners ? data.weights[static_cast<size_t>(i - corners)]
                                                : random.between(0.3, 3));
        }
    }
    Vec &knots = data.knots[0];
    for (int i = 0; i < count + star.degree + 1; ++i) {
        knots.push_back(star.periodic ? i : std::clamp(i - star.degree, 0, count - star.degree));
    }
    return data;
}

// Plane and curved, closed and open.
inline std::vector<Ground> grounds(Random &random) {
    std::vector<Ground> all;
    all.push_back(plane(random.magnitude(1e-3, 1e3)));
    all.push_back(wavy(random));
    all.push_back(cylinder(2, 3));
    all.push_back(sphere(1.5));
    all.push_back(torus(3, 1));
    return all;
}

inline SplineData any_star(Random &random, const Ground &ground) {
    Star kind;
    kind.degree = random.whole(1, 10);
    kind.rational = random.chance(50);
    kind.periodic = kind.degree > 1 && random.chance(50);
    const Place centre =
        ground.at(ground.closed[0] ? random.unit() : 0.5, ground.closed[1] ? random.unit() : 0.5);
    return star(random, ground, centre, kind);
}

inline Handle segment(const Place &a, const Place &b) {
    return create({{1}, {2}, {{0, 0, 1, 1}}, 2, {a[0], a[1], b[0], b[1]}, {}, 0});
}
inline Handle polygon(const std::vector<Place> &corners) {
    SplineData data{{1}, {std::ssize(corners) + 1}, {{0}}, 2, {}, {}, 0};
    for (size_t i = 0; i <= corners.size(); ++i) {
        const Place &x = corners[i % corners.size()];
        data.points.insert(data.points.end(), x.begin(), x.end());
        data.knots[0].push_back(static_cast<double>(i));
    }
    data.knots[0].push_back(static_cast<double>(corners.size()));
    return create(data);
}

} // namespace support::faces

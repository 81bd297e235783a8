// SPDX-License-Identifier: MIT
// Where curves meet each other, themselves and a surface, and where rays and planes meet one, beside SISL.
#include "bench/table/rows.h"
#include "bench/table/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

namespace bench {

namespace {

constexpr int64_t most = 1000, rays = 256, planes = 100;
constexpr double resolution = 1e-6;

// Two cubics of the plane with 97 pieces each that cross some 45 times.
struct Waves {
    static constexpr int count = 100;
    std::vector<double> knots, high, low;
    Handle first, second;
    std::shared_ptr<SISLCurve> sisl_first, sisl_second;
    int64_t crossings = 0;
    std::vector<double> on_first = std::vector<double>(most), on_second = on_first;

    Waves() {
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (int i = 0; i < count + 4; ++i) {
            knots.push_back(std::min(std::max(i - 3, 0), count - 3));
        }
        for (int i = 0; i < count; ++i) {
            high.insert(high.end(), {static_cast<double>(i), unit(engine)});
            low.insert(low.end(), {static_cast<double>(i), 0.3 * unit(engine)});
        }
        first = make(high);
        second = make(low);
        sisl_first = {newCurve(count, 4, knots.data(), high.data(), 1, 2, 1), freeCurve};
        sisl_second = {newCurve(count, 4, knots.data(), low.data(), 1, 2, 1), freeCurve};
        require_ok(nurbs_curve_intersections(first.get(), second.get(), 0, 0, nullptr, nullptr, nullptr,
                                             nullptr, nullptr, &crossings, nullptr));
    }
    [[nodiscard]] Handle make(const std::vector<double> &points) const {
        const int32_t degree = 3;
        const int64_t size = count;
        nurbs *out = nullptr;
        require_ok(nurbs_create(1, &degree, &size, knots.data(), count + 4, 2, points.data(), 0, 0, nullptr,
                                0, 0, &out));
        return Handle(out);
    }
    void meet(const nurbs *a, const nurbs *b) {
        int64_t found = 0;
        require_ok(nurbs_curve_intersections(a, b, 0, crossings, on_first.data(), on_second.data(), nullptr,
                                             nullptr, nullptr, &found, nullptr));
    }
    std::vector<double> sisl_meet() const {
        double *s = nullptr, *t = nullptr;
        SISLIntcurve **curves = nullptr;
        int points = 0, overlaps = 0, status = 0;
        s1857(sisl_first.get(), sisl_second.get(), resolution, resolution, &points, &s, &t, &overlaps,
              &curves, &status);
        std::vector<double> found(s, s + points);
        std::free(s);
        std::free(t);
        if (curves != nullptr) {
            freeIntcrvlist(curves, overlaps);
        }
        std::ranges::sort(found);
        return found;
    }
    double difference() {
        meet(first.get(), second.get());
        const std::vector<double> other = sisl_meet();
        double apart = std::cmp_equal(other.size(), crossings) ? 0 : 1;
        for (size_t i = 0; i < other.size() && apart < 1; ++i) {
            apart = std::max(apart, std::abs(other[i] - on_first[i]));
        }
        return apart < 1e-5 ? 0 : 1;
    }
};

// Rays from above on 20 x 20 bicubic control points.
struct Rays {
    Net net{2, 3, 20};
    Handle surface = net.make();
    std::shared_ptr<SISLSurf> sisl = net.sisl_surface();
    std::vector<double> from, along, at = std::vector<double>(rays);
    std::unique_ptr<nurbs_face, decltype(&nurbs_face_destroy)> face{starred(), nurbs_face_destroy};

    // The part of the surface in a star of 40 spans.
    nurbs_face *starred() {
        constexpr int corners = 40, degree = 3;
        const int64_t count = corners + 1, size = 1;
        const int32_t degrees = degree;
        std::vector<double> points, knots;
        for (int i = 0; i <= corners; ++i) {
            const double angle = 2 * std::numbers::pi * (i % corners) / corners,
                         radius = i % 2 == 0 ? 0.48 : 0.35;
            points.insert(points.end(), {0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
        }
        for (int i = 0; i < corners + 1 + degree + 1; ++i) {
            knots.push_back(std::clamp(i - degree, 0, corners - degree + 1));
        }
        double u[2], v[2];
        require_ok(nurbs_domain(surface.get(), 0, u));
        require_ok(nurbs_domain(surface.get(), 1, v));
        for (size_t i = 0; i < points.size(); i += 2) {
            points[i] = u[0] + points[i] * (u[1] - u[0]);
            points[i + 1] = v[0] + points[i + 1] * (v[1] - v[0]);
        }
        nurbs *curve = nullptr;
        require_ok(nurbs_create(1, &degrees, &count, knots.data(), std::ssize(knots), 2, points.data(), 0, 0,
                                nullptr, 0, 0, &curve));
        const Handle loop(curve);
        const nurbs *given[] = {curve};
        nurbs_face *made = nullptr;
        require_ok(
            nurbs_face_create(surface.get(), 1, &size, given, nullptr, nullptr, 1e-6, 0, nullptr, &made));
        return made;
    }

    Rays() {
        std::mt19937 engine(7);
        std::uniform_real_distribution<double> unit(0, 1);
        for (int64_t i = 0; i < rays; ++i) {
            from.insert(from.end(), {19 * unit(engine), 19 * unit(engine), 10});
            along.insert(along.end(), {0.3 * unit(engine) - 0.15, 0.3 * unit(engine) - 0.15, -1});
        }
    }
    void cast() {
        require_ok(nurbs_surface_rays(surface.get(), rays, from.data(), 0, 0, along.data(), 0, 0, nullptr,
                                      at.data(), nullptr));
    }
    void cast_at_face() {
        require_ok(nurbs_face_rays(face.get(), rays, from.data(), 0, 0, along.data(), 0, 0, nullptr,
                                   at.data(), nullptr));
    }
    // All points of the whole line.
    int64_t sisl_cast(size_t ray) {
        double *points = nullptr;
        SISLIntcurve **curves = nullptr;
        int count = 0, others = 0, status = 0;
        s1856(sisl.get(), from.data() + 3 * ray, along.data() + 3 * ray, 3, resolution, resolution, &count,
              &points, &others, &curves, &status);
        std::free(points);
        if (curves != nullptr) {
            freeIntcrvlist(curves, others);
        }
        return count;
    }
    double difference() {
        cast();
        for (size_t i = 0; i < rays; ++i) {
            if ((sisl_cast(i) > 0) == std::isnan(at[i])) {
                return 1;
            }
        }
        return 0;
    }
};

// A cubic of 100 control points that winds through 20 x 20 bicubic ones some 50 times.
struct Needle {
    Net net{2, 3, 20};
    Handle surface = net.make(), curve;
    std::shared_ptr<SISLSurf> sisl_surface = net.sisl_surface();
    std::shared_ptr<SISLCurve> sisl_curve;
    int64_t crossings = 0;
    std::vector<double> at = std::vector<double>(most);

    Needle() {
        const int32_t degree = 3;
        const int64_t count = 100;
        std::vector<double> knots, points;
        std::mt19937 engine(11);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (int64_t i = 0; i < count + 4; ++i) {
            knots.push_back(static_cast<double>(std::clamp<int64_t>(i - 3, 0, count - 3)));
        }
        for (int64_t i = 0; i < count; ++i) {
            const double x = 1 + 17.0 * static_cast<double>(i) / (count - 1), y = 9.5 + 8 * std::sin(0.8 * x);
            points.insert(points.end(), {x, y, 2 * std::sin(x / 2) * std::cos(y / 3) + unit(engine)});
        }
        nurbs *out = nullptr;
        require_ok(nurbs_create(1, &degree, &count, knots.data(), count + 4, 3, points.data(), 0, 0, nullptr,
                                0, 0, &out));
        curve.reset(out);
        sisl_curve = {newCurve(count, 4, knots.data(), points.data(), 1, 3, 1), freeCurve};
        int32_t complete = 0;
        require_ok(nurbs_curve_surface_intersections(curve.get(), surface.get(), 0, most, at.data(), nullptr,
                                                     nullptr, nullptr, nullptr, &crossings, &complete));
    }
    void meet() {
        int64_t found = 0;
        require_ok(nurbs_curve_surface_intersections(curve.get(), surface.get(), 0, most, at.data(), nullptr,
                                                     nullptr, nullptr, nullptr, &found, nullptr));
    }
    std::vector<double> sisl_meet() const {
        double *on_surface = nullptr, *on_curve = nullptr;
        SISLIntcurve **curves = nullptr;
        int points = 0, overlaps = 0, status = 0;
        s1858(sisl_surface.get(), sisl_curve.get(), resolution, resolution, &points, &on_surface, &on_curve,
              &overlaps, &curves, &status);
        std::vector<double> found(on_curve, on_curve + points);
        std::free(on_surface);
        std::free(on_curve);
        if (curves != nullptr) {
            freeIntcrvlist(curves, overlaps);
        }
        std::ranges::sort(found);
        return found;
    }
    double difference() {
        meet();
        const std::vector<double> other = sisl_meet();
        double apart = std::cmp_equal(other.size(), crossings) ? 0 : 1;
        for (size_t i = 0; i < other.size() && apart < 1; ++i) {
            apart = std::max(apart, std::abs(other[i] - at[i]));
        }
        return apart < 1e-5 ? 0 : 1;
    }
};

// Curves in planes across 20 x 20 bicubic control points.
struct Planes {
    Net net{2, 3, 20};
    Handle surface = net.make();
    std::shared_ptr<SISLSurf> sisl = net.sisl_surface();
    std::array<double, 3> normal{0.6, 0.64, 0.48};
    std::vector<double> offsets;

    Planes() {
        for (int64_t i = 0; i < planes; ++i) {
            offsets.push_back(2 + 0.2 * static_cast<double>(i));
        }
    }
    int64_t cut() {
        nurbs_meet *meet = nullptr;
        int64_t branches = 0;
        require_ok(
            nurbs_surface_sections(surface.get(), normal.data(), planes, offsets.data(), resolution, &meet));
        require_ok(nurbs_meet_counts(meet, &branches, nullptr, nullptr));
        nurbs_meet_destroy(meet);
        return branches;
    }
    // Topology, then each curve by marching.
    int64_t sisl_cut() {
        int64_t branches = 0;
        for (const double offset : offsets) {
            std::array<double, 3> point{};
            for (size_t c = 0; c < 3; ++c) {
                point[c] = offset * normal[c];
            }
            double *points = nullptr;
            SISLIntcurve **curves = nullptr;
            int count = 0, others = 0, status = 0;
            s1851(sisl.get(), point.data(), normal.data(), 3, resolution, resolution, &count, &points,
                  &others, &curves, &status);
            std::free(points);
            for (int i = 0; i < others; ++i) {
                s1314(sisl.get(), point.data(), normal.data(), 3, resolution, resolution, 0.0, curves[i], 2,
                      0, &status);
            }
            branches += others;
            if (curves != nullptr) {
                freeIntcrvlist(curves, others);
            }
        }
        return branches;
    }
};

} // namespace

void add_meets(Rows &rows) {
    const auto waves = std::make_shared<Waves>();
    const auto theirs = [=] { waves->sisl_meet(); };
    rows.add({std::to_string(waves->crossings) + " meets of two curves", "SISL", 1,
              [=] { waves->meet(waves->first.get(), waves->second.get()); }, theirs,
              [=] { return waves->difference(); }});
    rows.add({"the same of new curves",
              "SISL",
              1,
              [=] {
                  const Handle a = waves->make(waves->high), b = waves->make(waves->low);
                  waves->meet(a.get(), b.get());
              },
              theirs,
              {}});
    const auto needle = std::make_shared<Needle>();
    rows.add({std::to_string(needle->crossings) + " meets of a curve and a surface", "SISL", 1,
              [=] { needle->meet(); }, [=] { needle->sisl_meet(); }, [=] { return needle->difference(); }});
    const auto beams = std::make_shared<Rays>();
    rows.add({"ray on a surface", "SISL", bench::rays, [=] { beams->cast(); },
              [=] {
                  for (size_t i = 0; i < bench::rays; ++i) {
                      beams->sisl_cast(i);
                  }
              },
              [=] { return beams->difference(); }});
    rows.add({"ray on a face of it",
              "its surface",
              bench::rays,
              [=] { beams->cast_at_face(); },
              [=] { beams->cast(); },
              {}});
    const auto slices = std::make_shared<Planes>();
    rows.add({"plane through a surface", "SISL", bench::planes, [=] { slices->cut(); },
              [=] { slices->sisl_cut(); }, [=] { return slices->cut() == slices->sisl_cut() ? 0.0 : 1.0; }});
}

} // namespace bench

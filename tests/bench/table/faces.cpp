// SPDX-License-Identifier: MIT
// Sides of places in a face: of cubic curves as they are, beside the crossing number of a polygon with eight chords for each span,
// as textbooks have it; and faces made of curves, beside their polygon.
#include "bench/table/rows.h"
#include "bench/table/shapes.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>

namespace bench {

namespace {

constexpr int chords = 8, places = 4096;

struct DestroyFace {
    void operator()(nurbs_face *face) const noexcept { nurbs_face_destroy(face); }
};

// A closed cubic with waves, over the unit square.
struct Outline {
    Handle plane, curve;
    std::vector<Handle> pieces;
    std::vector<const nurbs *> handles;
    std::unique_ptr<nurbs_face, DestroyFace> face;
    std::vector<double> at, polygon;
    std::vector<int32_t> sides = std::vector<int32_t>(places);

    explicit Outline(int spans) {
        make_curves(spans);
        face.reset(made());
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> unit(0, 1);
        for (int i = 0; i < 2 * places; ++i) {
            at.push_back(unit(random));
        }
        std::vector<double> params;
        for (int i = 0; i <= chords * spans; ++i) {
            params.push_back(i / static_cast<double>(chords));
        }
        polygon.resize(2 * params.size());
        require_ok(nurbs_eval(curve.get(), static_cast<int64_t>(params.size()), params.data(), 0, 0,
                              polygon.data(), 0, 0, 0));
    }
    void make_curves(int spans) {
        const int32_t degrees[] = {1, 1}, cubic = 3;
        const int64_t counts[] = {2, 2}, count = spans + 3;
        const double square[] = {0, 0, 1, 1, 0, 0, 1, 1}, corners[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0};
        nurbs *out = nullptr;
        require_ok(nurbs_create(2, degrees, counts, square, 8, 3, corners, 0, 0, nullptr, 0, 0, &out));
        plane.reset(out);
        std::vector<double> knots, points;
        for (int i = 0; i < spans + 7; ++i) {
            knots.push_back(std::min(std::max(i - 3, 0), spans));
        }
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * 3.141592653589793 * (i % (spans + 2)) / (spans + 2);
            const double r = 0.4 + 0.08 * std::sin(7 * angle);
            points.insert(points.end(), {0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)});
        }
        require_ok(nurbs_create(1, &cubic, &count, knots.data(), spans + 7, 2, points.data(), 0, 0, nullptr,
                                0, 0, &out));
        curve.reset(out);
        nurbs_list *list = nullptr;
        require_ok(nurbs_decompose(curve.get(), &list));
        for (int i = 0; i < spans; ++i) {
            require_ok(nurbs_list_get(list, i, &out));
            pieces.emplace_back(out);
            handles.push_back(out);
        }
        nurbs_list_destroy(list);
    }
    [[nodiscard]] nurbs_face *made() const {
        nurbs_face *out = nullptr;
        const auto size = static_cast<int64_t>(handles.size());
        require_ok(nurbs_face_create(plane.get(), 1, &size, handles.data(), nullptr, nullptr, 1e-9, 0,
                                     nullptr, &out));
        return out;
    }

    void classify() { require_ok(nurbs_face_classify(face.get(), places, at.data(), 0, 0, 0, sides.data())); }
    void count_crossings() {
        for (size_t i = 0; i < places; ++i) {
            const double u = at[2 * i], v = at[2 * i + 1];
            bool inside = false;
            for (size_t j = 0; j + 3 < polygon.size(); j += 2) {
                const double *a = polygon.data() + j, *b = a + 2;
                if ((a[1] > v) != (b[1] > v) && u < (b[0] - a[0]) * (v - a[1]) / (b[1] - a[1]) + a[0]) {
                    inside = !inside;
                }
            }
            sides[i] = inside ? 1 : -1;
        }
    }
    // The part of the places whose side is another one; the polygon is within some 1e-5 of the curve.
    double difference() {
        classify();
        const std::vector<int32_t> exact = sides;
        count_crossings();
        double others = 0;
        for (size_t i = 0; i < places; ++i) {
            others += exact[i] != sides[i] ? 1 : 0;
        }
        return others / places > 2e-3 ? 1 : 0;
    }
};

} // namespace

void add_faces(Rows &rows) {
    for (const int spans : {10, 100, 10000}) {
        const auto outline = std::make_shared<Outline>(spans);
        rows.add({"side of a place, " + std::to_string(spans) + " cubics", "textbook", places,
                  [=] { outline->classify(); }, [=] { outline->count_crossings(); },
                  [=] { return spans == 10000 ? 0 : outline->difference(); }});
    }
    const auto outline = std::make_shared<Outline>(100);
    rows.add({"face of 100 cubics", "their polygon", 1, [=] { nurbs_face_destroy(outline->made()); },
              [=] {
                  std::vector<double> params, points;
                  for (int i = 0; i <= chords * 100; ++i) {
                      params.push_back(i / static_cast<double>(chords));
                  }
                  points.resize(2 * params.size());
                  require_ok(nurbs_eval(outline->curve.get(), static_cast<int64_t>(params.size()),
                                        params.data(), 0, 0, points.data(), 0, 0, 0));
              },
              nullptr});
}

} // namespace bench

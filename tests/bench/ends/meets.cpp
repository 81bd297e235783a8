// SPDX-License-Identifier: MIT
// Planes and points on a model of many faces, and extrema of a large field.
#include "rows.h"

#include <cmath>

namespace ends {

namespace {

// 1000 balls on a grid, and planes across it that meet some 30 of them each.
struct Balls {
    nurbs_model *model = nullptr;

    Balls() {
        const Shape ball = sphere(0.15);
        std::vector<nurbs_face *> faces;
        for (int i = 0; i < 1000; ++i) {
            const Shape one = moved(ball.get(), 1, {double(i % 10), double(i / 10 % 10), double(i / 100)});
            faces.push_back(nullptr);
            good(nurbs_face_create(one.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr,
                                   &faces.back()));
        }
        good(nurbs_model_create(1000, const_cast<const nurbs_face *const *>(faces.data()), 1, &model));
        for (nurbs_face *face : faces) {
            nurbs_face_destroy(face);
        }
    }
};

} // namespace

void meets() {
    row("sections/1000 planes through 1000 balls", 4.5, [] {
        const Balls balls;
        std::vector<double> normals, offsets;
        for (int i = 0; i < 1000; ++i) {
            const double angle = 0.001 * i;
            normals.insert(normals.end(), {0.3 * std::cos(angle), 0.3 * std::sin(angle), 1});
            offsets.push_back(0.01 * i);
        }
        nurbs_meet *meet = nullptr;
        return called([&] {
            return nurbs_model_sections(balls.model, 1000, normals.data(), offsets.data(), 1e-6, &meet);
        });
    });
    row("sections/nearest of 1000 balls to 1e4 points", 1, [] {
        const Balls balls;
        std::vector<double> points;
        for (int i = 0; i < 30000; ++i) {
            points.push_back(10 * std::abs(random_number()));
        }
        return called([&] {
            return nurbs_model_closest_points(balls.model, 10000, points.data(), 0, 0, 1e-9, nullptr, nullptr,
                                              nullptr, nullptr, nullptr);
        });
    });
    row("extrema/noise of 60^2", 1, [] {
        const Shape field = noise(2, 3, 60, 1);
        int64_t count = 0;
        int32_t complete = 0;
        Found found = called([&] {
            return nurbs_extrema(field.get(),
                                 NURBS_EXTREMUM_MINIMUM | NURBS_EXTREMUM_MAXIMUM | NURBS_EXTREMUM_SADDLE, 0,
                                 nullptr, nullptr, nullptr, nullptr, &count, &complete);
        });
        return told(found.time, "%g of them, complete %g", static_cast<double>(count), complete);
    });
}

} // namespace ends

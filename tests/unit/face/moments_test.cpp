// SPDX-License-Identifier: MIT
// Areas and centroids of faces against closed forms.
#include "face/integrals/face_integral.h"
#include "face/integrals/face_moments.h"
#include "measure/elements.h"

#include "face_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace {

using namespace nrb;
using namespace face_shapes;
using face::Face;
using measure::MomentOrder;
using std::numbers::pi;

TEST(FaceMoments, OfDiscsAndHolesInThePlane) {
    const Face face(
        {plane(), {loop_of({circle({0.5, 0.5}, 0.4)}), loop_of({circle({0.6, 0.5}, 0.1)})}, 1e-12}, nullptr);
    const measure::Moments found = face::moments(face, MomentOrder::inertia, 1e-12);
    const double outer = pi * 0.16, inner = pi * 0.01, area = outer - inner,
                 x = (outer * 0.5 - inner * 0.6) / area;
    EXPECT_NEAR(found.content, area, 1e-12 * area);
    EXPECT_NEAR(found.centroid[0], x, 1e-12);
    EXPECT_NEAR(found.centroid[1], 0.5, 1e-12);
    EXPECT_NEAR(found.centroid[2], 0, 1e-15);
    const double polar =
        outer * 0.16 / 2 + outer * std::pow(0.5 - x, 2) - inner * 0.01 / 2 - inner * std::pow(0.6 - x, 2);
    EXPECT_NEAR(found.inertia[8], polar, 1e-12);
}

TEST(FaceMoments, OfTheWholeSurface) {
    for (const SplinePtr &s : {sphere(), torus(), cylinder(), plane(7)}) {
        const Face whole({s, {}, 1e-9}, nullptr);
        const measure::Moments all = measure::moments(*s, whole_domain(*s), MomentOrder::inertia, 1e-12),
                               found = face::moments(whole, MomentOrder::inertia, 1e-12);
        EXPECT_NEAR(found.content, all.content, 4e-12 * all.content);
        for (size_t i = 0; i < all.inertia.size(); ++i) {
            EXPECT_NEAR(found.inertia[i], all.inertia[i], 1e-10 * all.content);
        }
    }
}

// Archimedes: a zone of a sphere has the area of the cylinder around it.
TEST(FaceMoments, OfCapsOfASphere) {
    const SplinePtr s = sphere();
    for (const double at : {0.2, 0.5, 0.77}) {
        const Face cap({s, {loop_of({segment(*s, {0, at}, {1, at})})}, 1e-9}, nullptr);
        const std::vector<double> point =
            face::point_at(*s, face::Point2{0, s->axis(1).domain().lower + at * (s->axis(1).domain().upper -
                                                                                 s->axis(1).domain().lower)});
        const double area = 2 * pi * (1 - point[2]);
        EXPECT_NEAR(face::moments(cap, MomentOrder::content, 1e-12).content, area, 1e-11 * area) << at;
    }
}

TEST(FaceMoments, PartsAddUp) {
    const SplinePtr s = torus();
    const double total = 4 * pi * pi * 3;
    double sum = 0;
    for (const bool hole : {false, true}) {
        SplinePtr disc = circle({0, 0}, 0.375);
        disc = hole ? refine::reverse(*disc, 0, false) : disc;
        const Face face({s, {loop_of({disc})}, 1e-9, true}, nullptr);
        const measure::Moments found = face::moments(face, MomentOrder::content, 1e-12);
        EXPECT_LE(found.error, 1e-11 * total);
        sum += found.content;
    }
    EXPECT_NEAR(sum, total, 1e-11 * total);
}

// As writers of files have them: the pole has a curve of its own, and no way around it is added.
TEST(FaceMoments, OfLoopsWithCurvesAlongPoles) {
    const SplinePtr s = sphere();
    struct Case {
        std::vector<Point2> corners;
        double area;
    };
    const Case cases[] = {{{{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, 2 * pi},
                          {{{0.5, 1}, {0.25, 1}, {0.25, 0.5}, {0.5, 0.5}}, pi / 2},
                          {{{0.25, 0.5}, {0.5, 0.5}, {0.5, 1}, {0.25, 1}}, pi / 2},
                          {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 4 * pi}};
    for (const Case &one : cases) {
        for (const bool as_oriented : {false, true}) {
            std::vector<SplinePtr> curves;
            for (size_t i = 0; i < 4; ++i) {
                curves.push_back(segment(*s, one.corners[i], one.corners[(i + 1) % 4]));
            }
            const Face face({s, {loop_of(curves)}, 1e-9, as_oriented}, nullptr);
            EXPECT_NEAR(face::moments(face, MomentOrder::content, 1e-10).content, one.area, 1e-8);
        }
    }
}

// Up a meridian and down another one, begun at either pole and in between.
TEST(FaceMoments, OfLunesHoweverTheLoopBegins) {
    const SplinePtr s = sphere();
    const std::vector<SplinePtr> curves{
        segment(*s, {0.75, 0}, {0.75, 0.5}), segment(*s, {0.75, 0.5}, {0.75, 1}),
        segment(*s, {0.125, 1}, {0.125, 0.5}), segment(*s, {0.125, 0.5}, {0.125, 0})};
    for (size_t first = 0; first < 4; ++first) {
        std::vector<SplinePtr> loop = curves;
        std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
        const Face face({s, {loop_of(loop)}, 1e-9, true}, nullptr);
        const double area = face::moments(face, MomentOrder::content, 1e-10).content;
        EXPECT_GT(area, 0);
        EXPECT_LT(area, 4 * pi);
        if (first > 0) {
            const Face same({s, {loop_of(curves)}, 1e-9, true}, nullptr);
            EXPECT_NEAR(area, face::moments(same, MomentOrder::content, 1e-10).content, 1e-8) << first;
        }
    }
}

TEST(FaceMoments, CoincidingLoopsAreToldOnce) {
    const auto triangle = [] {
        return loop_of(
            {line({0.1, 0.1}, {0.9, 0.2}), line({0.9, 0.2}, {0.5, 0.8}), line({0.5, 0.8}, {0.1, 0.1})});
    };
    const auto status = [&] {
        try {
            const Face face({plane(10), {triangle(), triangle()}, 1e-9}, nullptr);
            (void)face::moments(face, MomentOrder::content, 1e-9);
            return Status::ok;
        } catch (const Error &error) {
            return error.status();
        }
    };
    EXPECT_EQ(status(), Status::orientation);
}

// Both sides of a seam: in the one case of a band that goes all around, in the other of the whole torus.
TEST(FaceMoments, OfLoopsAlongBothSidesOfASeam) {
    const SplinePtr s = torus();
    const double total = 4 * pi * pi * 3;
    const auto area = [&](const std::vector<Point2> &corners, bool as_oriented) {
        std::vector<SplinePtr> curves;
        for (size_t i = 0; i < corners.size(); ++i) {
            curves.push_back(segment(*s, corners[i], corners[(i + 1) % corners.size()]));
        }
        const Face face({s, {loop_of(curves)}, 1e-9, as_oriented}, nullptr);
        return face::moments(face, MomentOrder::content, 1e-10).content;
    };
    for (const bool as_oriented : {false, true}) {
        EXPECT_NEAR(area({{0.125, 0.1}, {0.625, 0.1}, {0.625, 1.1}, {0.125, 1.1}}, as_oriented), total / 2,
                    1e-7);
        EXPECT_NEAR(area({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, as_oriented), total, 1e-7);
        EXPECT_NEAR(area({{0.3, 0.7}, {1.3, 0.7}, {1.3, 1.7}, {0.3, 1.7}}, as_oriented), total, 1e-7);
    }
}

// The area element, and a multiple of it with a step that no rule integrates.
class Step : public measure::Integrand {
public:
    explicit Step(double at) : at_(at) {}

    [[nodiscard]] int64_t values() const noexcept override { return 2; }
    [[nodiscard]] int degree(int) const noexcept override { return -1; }
    void operator()(const double *place, const double *d, double *out) const noexcept override {
        out[0] = d[0] * d[4] - d[1] * d[3];
        out[1] = place[0] > at_ ? 16 * out[0] : 0;
    }

private:
    double at_;
};

// An integral has converged if all of its values have: at 1/3, which no number of halvings reaches, the first
// one is exact and the second one is not.
TEST(FaceMoments, ConvergeInAllValuesOrInNone) {
    const Face face({plane(), {loop_of({circle({0.5, 0.5}, 0.4)})}, 1e-12}, nullptr);
    const pieces::Frame frame = measure::integral_frame(*face.surface());
    const face::TrimmedSurface own{face.surface().get(), &face.trims()};
    const Step step(frame.coordinate(0, 1. / 3));
    for (const double tolerance : {1e-6, 1e-15}) {
        const measure::Integrals found = face::integrate({&own, 1}, step, frame, tolerance);
        const double allowed = std::max(tolerance * found.values[0], found.rounding);
        EXPECT_LE(found.errors[0], allowed);
        EXPECT_EQ(found.converged, found.errors[1] <= allowed) << found.errors[1] / allowed;
        EXPECT_EQ(found.converged, tolerance == 1e-6);
    }
}

} // namespace

// Reading STEP texts in tests of the core.
#pragma once

#include "base/error.h"
#include "eval/evaluate.h"
#include "io/formats.h"
#include "numeric/vector3.h"
#include "support/step_builder.h"

#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

namespace step_test {

inline nrb::model::Model read(const std::string &text, const nrb::io::ReadSettings &settings = {}) {
    return nrb::io::read(text, settings);
}
inline nrb::model::Model read(const StepBuilder &builder, const nrb::io::ReadSettings &settings = {}) {
    return read(builder.text(), settings);
}

// The one spline of a file without notes.
inline nrb::SplinePtr only_spline(const nrb::model::Model &document) {
    EXPECT_EQ(document.splines.size(), 1U);
    for (const nrb::model::Note &note : document.notes) {
        ADD_FAILURE() << note.text;
    }
    if (document.splines.empty()) {
        throw std::runtime_error("no spline was read");
    }
    return document.splines.front().spline;
}
inline nrb::SplinePtr only_spline(const StepBuilder &builder, const nrb::io::ReadSettings &settings = {}) {
    return only_spline(read(builder, settings));
}

// The one note of a file.
inline nrb::model::Note only_note(const nrb::model::Model &document) {
    EXPECT_EQ(document.notes.size(), 1U);
    return document.notes.empty() ? nrb::model::Note{0, 0, nrb::Status::ok, ""} : document.notes.front();
}
inline nrb::model::Note only_note(const StepBuilder &builder) {
    return only_note(read(builder));
}

struct Failure {
    nrb::Status status = nrb::Status::ok;
    std::string text;
};

// What reading a whole file throws.
inline Failure failure_of(const std::string &text, const nrb::io::ReadSettings &settings = {}) {
    try {
        (void)read(text, settings);
        return {};
    } catch (const nrb::Error &error) {
        return {error.status(), error.what()};
    }
}

// The point at the parameters of a curve or surface.
inline nrb::Vector3 point_of(const nrb::Spline &spline, double u, double v = 0) {
    const double params[2] = {u, v};
    double out[3] = {0, 0, 0};
    const int axes = spline.axes(), dim = spline.dim();
    nrb::eval::evaluate_points(spline, {}, 0, {params, 1, axes, axes, 1}, {out, 1, dim, dim, 1});
    return {out[0], out[1], out[2]};
}

inline void expect_near(const nrb::Vector3 &found, const nrb::Vector3 &expected, double tolerance = 1e-14) {
    EXPECT_LE(nrb::length(found - expected), tolerance)
        << "found (" << found.x << ", " << found.y << ", " << found.z << "), expected (" << expected.x << ", "
        << expected.y << ", " << expected.z << ")";
}

inline void expect_domain(const nrb::Spline &spline, int axis, double lower, double upper) {
    EXPECT_EQ(spline.axis(axis).domain().lower, lower);
    EXPECT_EQ(spline.axis(axis).domain().upper, upper);
}

} // namespace step_test

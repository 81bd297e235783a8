// Reading STEP texts in tests of the core.
#pragma once

#include "base/error.h"
#include "io/formats.h"
#include "support/spline_checks.h"
#include "support/step_builder.h"

#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>
#include <string>

namespace step_test {

constexpr double pi = std::numbers::pi;

// In the frame of StepBuilder::some_placement(), whose Z is (1, 0, 0).
inline nrb::Vector3 placed(double x, double y, double z = 0) {
    return {1 + z, 2 + x, 3 + y};
}

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

using spline_checks::expect_domain;
using spline_checks::expect_near;
using spline_checks::point_of;

} // namespace step_test

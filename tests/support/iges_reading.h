// Reading IGES texts in tests of the core.
#pragma once

#include "base/error.h"
#include "io/formats.h"
#include "support/iges_builder.h"

#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

namespace iges_test {

inline nrb::model::Model read(const std::string &text, const nrb::io::ReadSettings &settings = {}) {
    return nrb::io::read(text, settings);
}

inline nrb::model::Model read(const IgesBuilder &builder, const nrb::io::ReadSettings &settings = {}) {
    return read(builder.text(), settings);
}

// The one spline of a file; the test fails if there is another number of them, or an entity that is wrong.
inline nrb::SplinePtr only_spline(const nrb::model::Model &document) {
    EXPECT_EQ(document.splines.size(), 1U);
    for (const nrb::model::Note &note : document.notes) {
        EXPECT_EQ(note.reason, nrb::Status::unsupported) << note.text;
    }
    if (document.splines.empty()) {
        throw std::runtime_error("no spline was read");
    }
    return document.splines.front().spline;
}

inline nrb::SplinePtr read_one(int type, const std::string &data, const Fields &fields = {}) {
    IgesBuilder builder;
    builder.add(type, data, fields);
    return only_spline(read(builder));
}

// The note that a file with one entity leaves; one with reason nrb::Status::ok, and a failed test, if there
// is none.
inline nrb::model::Note note_of(int type, const std::string &data, const Fields &fields = {}) {
    IgesBuilder builder;
    builder.add(type, data, fields);
    const nrb::model::Model document = read(builder);
    EXPECT_EQ(document.splines.size(), 0U);
    EXPECT_EQ(document.notes.size(), 1U);
    return document.notes.empty() ? nrb::model::Note{0, 0, nrb::Status::ok, ""} : document.notes.front();
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

inline std::vector<double> points_of(const nrb::Spline &spline) {
    return {spline.points().begin(), spline.points().end()};
}

inline std::vector<double> knots_of(const nrb::Spline &spline, int axis = 0) {
    const auto knots = spline.axis(axis).knots();
    return {knots.begin(), knots.end()};
}

} // namespace iges_test

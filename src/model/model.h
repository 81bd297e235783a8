// SPDX-License-Identifier: MIT
// What a file holds.
#pragma once

#include "base/error.h"
#include "spline/spline.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace nrb::model {

struct NamedSpline {
    std::string name;
    SplinePtr spline;
};

// An entity that did not become a spline, and why. `line` is where the file has it.
struct Note {
    int entity_type;
    int64_t line;
    Status reason;
    std::string text;
};

struct Model {
    std::vector<NamedSpline> splines;
    std::vector<Note> notes;
    double metres_per_unit = 0; // 0: the file does not say
};

inline void check_metres(double metres) {
    if (!std::isfinite(metres) || metres < 0) {
        fail(Status::factor, "metres = %s, expected a finite value >= 0", Number(metres).text);
    }
}

} // namespace nrb::model

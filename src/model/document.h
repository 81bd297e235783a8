// What a file held.
#pragma once

#include "spline/spline.h"

#include <cstdint>
#include <string>
#include <vector>

namespace nrb::model {

struct NamedSpline {
    std::string name;
    SplinePtr spline;
};

// An entity that did not become a spline, and why.
struct Note {
    int entity_type;
    int64_t line;
    Status reason;
    std::string text;
};

struct Document {
    std::vector<NamedSpline> splines;
    std::vector<Note> notes;
    double metres_per_unit = 0; // 0: the file does not say
};

struct ReadSettings {
    double unit = 0; // wanted unit in metres, 0: the file's own
    int64_t max_bytes = int64_t{1} << 30;
};

} // namespace nrb::model

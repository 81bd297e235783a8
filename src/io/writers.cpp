// SPDX-License-Identifier: MIT
#include "io/writers.h"

#include "base/error.h"
#include "io/iges/write/write_iges.h"
#include "io/step/write/write_step.h"

#include <cmath>

namespace nrb::io {
namespace {

void check_setting(const char *name, double value, const char *expected) {
    if (!std::isfinite(value) || value < 0) {
        fail(Status::options, "%s = %s, expected %s", name, Number(value).text, expected);
    }
}

} // namespace

std::string write(const model::Model &model, int32_t format, const WriteSettings &settings) {
    check_setting("unit", settings.unit, "metres > 0, or 0 for the unit of the model");
    check_setting("tolerance", settings.tolerance, "a length > 0, or 0 for that of the faces");
    switch (static_cast<WrittenFormat>(format)) {
    case WrittenFormat::step:
        return write_step(model, settings);
    case WrittenFormat::iges:
        return write_iges(model, settings);
    }
    fail(Status::format, "format = %d, expected 1 for STEP or 2 for IGES", format);
}

} // namespace nrb::io

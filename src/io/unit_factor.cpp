// SPDX-License-Identifier: MIT
#include "io/unit_factor.h"

#include "base/error.h"

#include <cmath>

namespace nrb::io {

double unit_factor(double metres_per_unit, const ReadSettings &settings) {
    if (settings.unit == 0) {
        return 1;
    }
    if (metres_per_unit == 0) {
        fail(Status::options, "unit = %s cannot be reached: the unit of the file is not known",
             Number(settings.unit).text);
    }
    const double factor = metres_per_unit / settings.unit;
    if (!std::isnormal(factor)) {
        fail(Status::options, "unit = %s cannot be reached from units of %s metres",
             Number(settings.unit).text, Number(metres_per_unit).text);
    }
    return factor;
}

} // namespace nrb::io

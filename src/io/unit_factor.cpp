// SPDX-License-Identifier: MIT
#include "io/unit_factor.h"

#include "base/error.h"

#include <cmath>

namespace nrb::io {
namespace {

constexpr double millimetre = 0.001;

// `metres`: the present unit. `wanted`: the new unit in metres; 0: the present one.
double factor_between(double metres, double wanted) {
    if (wanted == 0 || wanted == metres) {
        return 1;
    }
    const double factor = metres / wanted;
    if (!std::isnormal(factor)) {
        fail(Status::options, "unit = %s cannot be reached from units of %s metres", Number(wanted).text,
             Number(metres).text);
    }
    return factor;
}

} // namespace

double unit_factor(double metres_per_unit, const ReadSettings &settings) {
    if (settings.unit != 0 && metres_per_unit == 0) {
        fail(Status::options, "unit = %s cannot be reached: the unit of the file is not known",
             Number(settings.unit).text);
    }
    return factor_between(metres_per_unit, settings.unit);
}

Lengths lengths_of(double metres_per_unit, const WriteSettings &settings) {
    const double own = metres_per_unit > 0 ? metres_per_unit : millimetre;
    return {settings.unit == 0 ? own : settings.unit, factor_between(own, settings.unit)};
}

} // namespace nrb::io

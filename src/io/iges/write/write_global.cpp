// SPDX-License-Identifier: MIT
#include "io/iges/write/write_global.h"

#include "base/numbers.h"
#include "io/iges/global.h"
#include "io/iges/lines.h"
#include "io/iges/text.h"
#include "io/iges/units.h"

#include <cmath>

namespace nrb::io::iges {
namespace {

constexpr int integer_bits = 32, single_digits = 6, double_digits = 15, single_power = 38, double_power = 308;
constexpr int line_weights = 1, version_5_3 = 11, no_standard = 0;
// A fixed date: readers require one, and the current date would make files of the same model differ.
constexpr std::string_view no_date = "19700101.000000";

struct StatedUnit {
    const Unit *unit;
    double scale; // of the model space: readers divide the unit by it
};

// Finds the scale of a unit from which readers compute exactly the same metres, if there is one.
bool found_again(const Unit &unit, double metres, double &scale) noexcept {
    const double near = unit.metres / metres;
    for (const double candidate : {near, std::nextafter(near, 0.0), std::nextafter(near, infinity)}) {
        if (unit.metres / candidate == metres) {
            scale = candidate;
            return true;
        }
    }
    return false;
}

StatedUnit stated_unit(double metres) {
    for (const Unit &unit : units) {
        if (unit.metres == metres) {
            return {&unit, 1};
        }
    }
    double scale = 1;
    for (const Unit &unit : units) {
        if (found_again(unit, metres, scale)) {
            return {&unit, scale};
        }
    }
    const Unit &metre = *unit_of_flag(metre_flag);
    return {&metre, metre.metres / metres};
}

} // namespace

Parameters write_global(const GlobalFacts &facts) {
    const auto [unit, scale] = stated_unit(facts.metres);
    Parameters global(data_columns);
    global.begin("G");
    const auto put = [&global](const auto &...values) { (global.put(values), ...); };
    const std::string product = printable(trim(facts.product));
    const std::string_view none;
    put(std::string_view(","), std::string_view(";"), std::string_view(product), none, own_preprocessor,
        own_preprocessor);
    put(integer_bits, single_power, single_digits, double_power, double_digits, none);
    put(scale, unit->flag, unit->name, line_weights, 0.0, no_date);
    put(facts.resolution);
    facts.extent > 0 ? put(facts.extent) : put(none);
    put(none, none, version_5_3, no_standard, none, none);
    global.end();
    return global;
}

} // namespace nrb::io::iges

// SPDX-License-Identifier: MIT
#include "io/step/units.h"

#include "base/error.h"
#include "io/iges/text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace nrb::io::step {
namespace {

struct Prefix {
    std::string_view name;
    int exponent;
};
constexpr Prefix prefixes[] = {{"EXA", 18},  {"PETA", 15},  {"TERA", 12},   {"GIGA", 9},
                               {"MEGA", 6},  {"KILO", 3},   {"HECTO", 2},   {"DECA", 1},
                               {"DECI", -1}, {"CENTI", -2}, {"MILLI", -3},  {"MICRO", -6},
                               {"NANO", -9}, {"PICO", -12}, {"FEMTO", -15}, {"ATTO", -18}};

double power_of(const Prefix &prefix) noexcept {
    const double power = std::pow(10.0, std::abs(prefix.exponent));
    return prefix.exponent < 0 ? 1 / power : power;
}

double power_of_ten(const Attributes &attributes, std::string_view prefix) {
    if (prefix.empty()) {
        return 1;
    }
    const auto *const found = std::ranges::find(prefixes, prefix, &Prefix::name);
    if (found == std::end(prefixes)) {
        attributes.fail_attribute(Status::syntax, "prefix",
                                  "found ." + iges::excerpt(prefix) + "., expected one of SI");
    }
    return power_of(*found);
}

// Files give few digits of these units.
double exact(double factor) noexcept {
    constexpr double known[] = {std::numbers::pi / 180, std::numbers::pi / 200, 0.0254, 0.3048, 0.9144};
    for (const double value : known) {
        if (std::fabs(factor - value) <= 1e-7 * value) {
            return value;
        }
    }
    return factor;
}

Unit read_si_unit(Attributes &attributes) {
    attributes.part("NAMED_UNIT");
    attributes.skip("dimensions");
    attributes.part("SI_UNIT");
    const std::string_view prefix = attributes.enumeration("prefix"), name = attributes.enumeration("name");
    const Quantity quantity = name == "METRE"    ? Quantity::length
                              : name == "RADIAN" ? Quantity::angle
                                                 : Quantity::other;
    return {quantity, power_of_ten(attributes, prefix)};
}

// A measure: a number of other units.
Unit read_measure(Entities &entities, const Instance &instance) {
    Attributes attributes(entities.instances(), instance);
    attributes.part("MEASURE_WITH_UNIT");
    const double value = attributes.real("value_component");
    const Instance &unit = entities.at(attributes.reference("unit_component"), attributes, "unit_component");
    if (!(value > 0)) {
        attributes.fail_attribute(Status::syntax, "value_component",
                                  std::string("found ") + Number(value).text + ", expected more than 0");
    }
    const Unit of = read_unit(entities, unit);
    return {of.quantity, exact(value * of.factor)};
}

// Reads the smallest distance that counts: the first uncertainty of a length. The unit of the result is
// `metres` long.
double read_uncertainty(Entities &entities, Attributes &attributes, double metres) {
    double least = 0;
    attributes.part("GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT");
    attributes.open("uncertainty");
    while (attributes.more("uncertainty")) {
        const Instance &instance =
            entities.at(attributes.reference("uncertainty"), attributes, "uncertainty");
        if (instance.kind() == Kind::uncertainty && least == 0 && metres > 0) {
            const Unit measure = read_measure(entities, instance);
            least = measure.quantity == Quantity::length ? measure.factor / metres : 0;
        }
    }
    return least;
}

} // namespace

std::optional<std::string_view> prefix_of(double metres) noexcept {
    if (metres == 1) {
        return "";
    }
    const auto *const found = std::ranges::find(prefixes, metres, power_of);
    return found == std::end(prefixes) ? std::nullopt : std::optional(found->name);
}

Unit read_unit(Entities &entities, const Instance &instance) {
    const Entities::Visit visit(entities, instance.number());
    Attributes attributes(entities.instances(), instance);
    if (instance.kind() == Kind::si_unit) {
        return read_si_unit(attributes);
    }
    if (instance.kind() != Kind::conversion_based_unit) {
        return {};
    }
    attributes.part("CONVERSION_BASED_UNIT");
    if (!attributes.complex()) {
        attributes.skip("dimensions");
    }
    attributes.skip("name");
    return read_measure(
        entities, entities.at(attributes.reference("conversion_factor"), attributes, "conversion_factor"));
}

Measures read_measures(Entities &entities, const Instance &context) {
    Attributes attributes(entities.instances(), context);
    Measures measures;
    attributes.part("GLOBAL_UNIT_ASSIGNED_CONTEXT");
    if (!attributes.complex()) {
        attributes.skip("context_identifier");
        attributes.skip("context_type");
    }
    attributes.open("units");
    while (attributes.more("units")) {
        const Unit unit =
            read_unit(entities, entities.at(attributes.reference("units"), attributes, "units"));
        if (unit.quantity == Quantity::length) {
            measures.metres = unit.factor;
        } else if (unit.quantity == Quantity::angle) {
            measures.radians = unit.factor;
        }
    }
    if (attributes.complex() && attributes.has_part("GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT")) {
        measures.uncertainty = read_uncertainty(entities, attributes, measures.metres);
    }
    return measures;
}

} // namespace nrb::io::step

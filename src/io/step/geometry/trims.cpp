// SPDX-License-Identifier: MIT
#include "io/step/geometry/trims.h"

namespace nrb::io::step {

Trim read_trim(Entities &entities, Attributes &attributes, const char *name, double length) {
    Trim trim;
    attributes.open(name);
    while (attributes.more(name)) {
        if (attributes.upcoming() == '#') {
            trim.point = read_point(entities, attributes.reference(name), attributes, name, length);
        } else {
            trim.parameter = attributes.real(name);
        }
    }
    if (!trim.parameter && !trim.point) {
        attributes.fail_attribute(Status::syntax, name, "is empty, expected a point or a parameter");
    }
    return trim;
}

} // namespace nrb::io::step

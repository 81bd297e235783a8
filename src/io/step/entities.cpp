// SPDX-License-Identifier: MIT
#include "io/step/entities.h"

#include "base/error.h"
#include "io/iges/text.h"

namespace nrb::io::step {

const Instance &Entities::at(int64_t number, const Attributes &owner, const char *attribute) const {
    const int64_t place = instances_.find(number);
    if (place < 0) {
        owner.fail_attribute(Status::syntax, attribute, "#" + std::to_string(number) + " is not in the file");
    }
    return instances_[place];
}

const Instance &Entities::at(int64_t number, Kind kind, const Attributes &owner, const char *attribute,
                             const char *expected) const {
    const Instance &found = at(number, owner, attribute);
    if (found.kind() != kind) {
        fail_kind(found, owner, attribute, expected);
    }
    return found;
}

void Entities::fail_kind(const Instance &found, const Attributes &owner, const char *attribute,
                         const char *expected) const {
    owner.fail_attribute(found.kind() == Kind::other ? Status::unsupported : Status::syntax, attribute,
                         "#" + std::to_string(found.number()) + " is a " +
                             iges::excerpt(instances_.keyword(found)) + ", expected " + expected);
}

void Entities::remark(int64_t number, bool approximated, std::string text) {
    approximations_ += approximated ? 1 : 0;
    if (!text.empty()) {
        remarks_.insert_or_assign(number, std::move(text));
    }
}

} // namespace nrb::io::step

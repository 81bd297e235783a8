// SPDX-License-Identifier: MIT
#include "io/step/entities.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/text.h"

#include <algorithm>

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

void Entities::spend(int64_t doubles) {
    count_work(doubles);
    if (doubles > left_) {
        fail(Status::too_large, "the instances name each other so often that more than %lld numbers come out",
             static_cast<long long>(limit_));
    }
    left_ -= doubles;
}

Entities::Visit::Visit(Entities &entities, const Instance &instance) : entities_(entities) {
    const auto *const begin = entities.path_.begin(), *const end = begin + entities.depth_;
    const auto number = static_cast<long long>(instance.number());
    if (std::find(begin, end, instance.number()) != end) {
        fail(Status::syntax, "#%lld: names itself by way of #%lld", number,
             static_cast<long long>(*(end - 1)));
    }
    if (entities.depth_ == deepest) {
        fail(Status::syntax, "#%lld: lies more than %d instances deep", number, deepest);
    }
    entities.path_[static_cast<size_t>(entities.depth_++)] = instance.number();
}

} // namespace nrb::io::step

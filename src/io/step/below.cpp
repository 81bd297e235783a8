// SPDX-License-Identifier: MIT
#include "io/step/below.h"

#include "base/watch.h"

#include <set>

namespace nrb::io::step {

std::vector<int64_t> found_below(Entities &entities, std::vector<int64_t> items, bool (*wanted)(Kind),
                                 bool (*opened)(Kind)) {
    const Instances &instances = entities.instances();
    std::vector<int64_t> found;
    std::set<int64_t> seen;
    while (!items.empty()) {
        const int64_t number = items.back();
        items.pop_back();
        const int64_t place = instances.find(number);
        if (place < 0 || !seen.insert(number).second) {
            continue;
        }
        entities.spend(1); // many items may share many faces
        const Instance &instance = instances[place];
        const Kind kind = instance.kind();
        if (wanted(kind)) {
            found.push_back(number);
        } else if (kind == Kind::topology || kind == Kind::shape_representation || opened(kind)) {
            for_each_reference(instances.text(), instance, [&](int64_t next) { items.push_back(next); });
        }
        count_work(16);
    }
    return found;
}

} // namespace nrb::io::step

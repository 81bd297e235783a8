// SPDX-License-Identifier: MIT
#include "io/step/parts.h"

namespace nrb::io::step {
namespace {

// Calls visit(place) for the instances that an owner makes parts of itself.
template <class Visit>
void for_each_part(const Instances &instances, int64_t owner, Visit &&visit) {
    if (!owns_geometry(instances[owner].kind())) {
        return;
    }
    for_each_reference(instances.text(), instances[owner], [&](int64_t number) {
        if (const int64_t place = instances.find(number); place >= 0) {
            visit(static_cast<size_t>(place));
        }
    });
}

// The places of the owners that are not parts of others.
std::vector<int64_t> find_roots(const Instances &instances) {
    std::vector<bool> part(static_cast<size_t>(instances.size()), false);
    for (int64_t owner = 0; owner < instances.size(); ++owner) {
        for_each_part(instances, owner, [&](size_t place) { part[place] = true; });
    }
    std::vector<int64_t> roots;
    for (int64_t place = 0; place < instances.size(); ++place) {
        if (!part[static_cast<size_t>(place)] && owns_geometry(instances[place].kind())) {
            roots.push_back(place);
        }
    }
    return roots;
}

} // namespace

std::vector<bool> find_parts(const Instances &instances) {
    std::vector<int64_t> waiting = find_roots(instances);
    std::vector<bool> reached(static_cast<size_t>(instances.size()), false);
    while (!waiting.empty()) {
        const int64_t owner = waiting.back();
        waiting.pop_back();
        for_each_part(instances, owner, [&](size_t place) {
            if (!reached[place]) {
                reached[place] = true;
                waiting.push_back(static_cast<int64_t>(place));
            }
        });
    }
    return reached;
}

} // namespace nrb::io::step

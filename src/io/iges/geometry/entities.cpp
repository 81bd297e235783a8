// SPDX-License-Identifier: MIT
#include "io/iges/geometry/entities.h"

#include "base/error.h"

namespace nrb::io::iges {

const Entry &Entities::at(int64_t pointer, const char *what) const {
    const std::optional<size_t> index = directory_.find(pointer);
    if (!index) {
        fail(Status::syntax, "%s: the directory has no entity at line %lld", what,
             static_cast<long long>(pointer));
    }
    return directory_.entries()[*index];
}

Record Entities::record(const Entry &entry) {
    if (!entry.damage.empty()) {
        fail(Status::syntax, "%s", entry.damage.c_str());
    }
    Record record = data_.take(entry);
    spend(record.remaining() + record.length() / static_cast<int64_t>(sizeof(double)));
    return record;
}

Placement Entities::placement(const Entry &entry, const Transform *outer, double factor,
                              bool parameter_plane) {
    Placement result{{}, factor, parameter_plane};
    if (entry.transform != 0) {
        result.transform = transforms_.resolve(entry.transform);
    }
    if (outer != nullptr) {
        result.transform = result.transform ? compose(*outer, *result.transform) : *outer;
    }
    return result;
}

std::string label_of(const Entry &entry) {
    return std::string(type_name(entry.type)) + " (" + std::to_string(entry.type) + ") at directory line " +
           std::to_string(entry.line) + ": ";
}

} // namespace nrb::io::iges

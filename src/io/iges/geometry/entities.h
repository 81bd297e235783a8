// SPDX-License-Identifier: MIT
// Entities that are read on demand, within limits.
#pragma once

#include "base/error.h"
#include "io/iges/geometry/placement.h"
#include "io/iges/names.h"
#include "io/limits.h"

namespace nrb::io::iges {

class Entities : public Limits {
public:
    // `bytes`: the size of the file. The other arguments must outlive this object.
    Entities(size_t bytes, const Directory &directory, ParameterData &data, Transforms &transforms,
             Names &names) noexcept
        : Limits(bytes, "directory line "), directory_(directory), data_(data), transforms_(transforms),
          names_(names) {}

    [[nodiscard]] const Directory &directory() const noexcept { return directory_; }

    // The entity that a pointer of another entity refers to; `what` names its role. Throws Status::syntax if
    // there is none.
    [[nodiscard]] const Entry &at(int64_t pointer, const char *what) const;

    // The parameters of an entity, as often as the limits allow. Throws Status::syntax, too_large.
    Record record(const Entry &entry);

    // The placement of the coordinates of an entity: its own chain of matrices, then that of the entity it is
    // part of, if any. Throws Status::syntax.
    Placement placement(const Entry &entry, const Transform *outer, double factor, bool parameter_plane);

    // The name of an entity whose record has been read up to the pointers at its end.
    std::string name(const Entry &entry, Record &record) { return names_.name(entry, record); }

private:
    const Directory &directory_;
    ParameterData &data_;
    Transforms &transforms_;
    Names &names_;
};

// "line (110) at directory line 5: "
std::string label_of(const Entry &entry);

// An error whose message begins with the label of the entity in which it occurred.
class LabelledError : public Error {
public:
    using Error::Error;
};

// Calls fn(); rethrows its errors with the label of the entity before messages that have none.
template <class Function>
auto labelling(const Entry &entry, Function &&function) {
    try {
        return function();
    } catch (const LabelledError &) {
        throw;
    } catch (const Error &error) {
        throw LabelledError(error.status(), (label_of(entry) + error.what()).c_str());
    }
}

} // namespace nrb::io::iges

// SPDX-License-Identifier: MIT
// Names of entities: those that a file assigns, and those of the standard for entity types.
#pragma once

#include "io/iges/directory.h"

#include <map>

namespace nrb::io::iges {

// "rational B-spline curve" for 126; "entity" for types that are not listed.
const char *type_name(int type) noexcept;

class Names {
public:
    Names(const Directory &directory, ParameterData &data) : directory_(directory), data_(data) {}

    // The name of an entity whose record has been read up to the pointers at its end: that of the first name
    // property (406 form 15) among them, else its label and subscript "LABEL(3)", else "126#17".
    std::string name(const Entry &entry, Record &record);

    // Whether the property at a directory entry has provided a name.
    [[nodiscard]] bool used(size_t index) const noexcept;

private:
    std::string property_name(Record &record);
    const std::string &read_property(size_t index);

    const Directory &directory_;
    ParameterData &data_;
    std::map<size_t, std::string> properties_; // those read already, by index of the directory entry
};

} // namespace nrb::io::iges

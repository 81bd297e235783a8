// SPDX-License-Identifier: MIT
// The levels of entities, which become layers.
#pragma once

#include "io/iges/geometry/entities.h"
#include "model/model.h"

#include <map>
#include <string>
#include <vector>

namespace nrb::io::iges {

class Levels {
public:
    explicit Levels(Entities &entities) noexcept : entities_(entities) {}

    // Reads the properties that list several levels (406 form 1) and those that name a level (406 form 3).
    // Marks their directory entries in `told`; one that cannot be read is ignored.
    void read(std::vector<bool> &told);

    // The numbers of the levels of an entity, in increasing order; empty for level 0.
    [[nodiscard]] std::vector<int64_t> of(const Entry &entry) const;

    // Replaces the levels of faces and splines by layers, in the order of the level numbers. Levels of the
    // same name become one layer; the name of a level without a property is its number.
    void make_layers(model::Model &model) const;

private:
    void read_list(const Entry &entry);
    void read_name(const Entry &entry);
    [[nodiscard]] std::string name_of(int64_t level) const;

    Entities &entities_;
    std::map<int64_t, std::vector<int64_t>> lists_; // by the pointers of their properties
    std::map<int64_t, std::string> names_;
};

} // namespace nrb::io::iges

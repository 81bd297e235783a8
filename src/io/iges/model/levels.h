// SPDX-License-Identifier: MIT
// The levels of entities, which are layers.
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

    // Reads the properties that have several levels (406 form 1) and those that name one (406 form 3). Which of the entries of the
    // directory these are is marked; one that cannot be read is none.
    void read(std::vector<bool> &told);

    // The numbers of the levels of an entity, rising; none for 0.
    [[nodiscard]] std::vector<int64_t> of(const Entry &entry) const;

    // Makes layers of the levels that faces and splines have in place of them, in the order of their numbers. Those of the same
    // name are one; what no property names has its number for a name.
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

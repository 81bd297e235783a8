// SPDX-License-Identifier: MIT
// Layers as levels.
#pragma once

#include "io/iges/write/file_text.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace nrb::io::iges {

class LevelWriter {
public:
    // layers: the names of the model. Each gets a number, all of them rising: its own name if that is one, else the next one.
    LevelWriter(FileText &text, std::span<const std::string> layers);

    // Properties that name the levels whose number does not.
    void write_names();

    // For the head of an entity: the number of a level, 0 for none, minus a pointer to a property for several.
    int64_t level(const std::vector<int64_t> &layers);

private:
    FileText &text_;
    std::span<const std::string> layers_;
    std::vector<int64_t> numbers_; // of layers
    std::map<std::vector<int64_t>, int64_t> lists_;
};

} // namespace nrb::io::iges

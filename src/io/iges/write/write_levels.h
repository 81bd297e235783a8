// SPDX-License-Identifier: MIT
// Writes layers as levels.
#pragma once

#include "io/iges/write/file_text.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace nrb::io::iges {

class LevelWriter {
public:
    // layers: the names of the model's layers. Each gets a number, and the numbers increase: its own name if
    // that is a number above the last one, else the next number.
    LevelWriter(FileText &text, std::span<const std::string> layers);

    // Writes a property with the name of each level whose name is not its number.
    void write_names();

    // For the directory entry of an entity: the number of a level, 0 for none, minus a pointer to a property
    // for several.
    int64_t level(const std::vector<int64_t> &layers);

private:
    FileText &text_;
    std::span<const std::string> layers_;
    std::vector<int64_t> numbers_; // of layers
    std::map<std::vector<int64_t>, int64_t> lists_;
};

} // namespace nrb::io::iges

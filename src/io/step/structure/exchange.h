// SPDX-License-Identifier: MIT
// The exchange structure of ISO 10303-21: header section, data sections.
#pragma once

#include "io/step/structure/instances.h"

#include <span>
#include <string>
#include <vector>

namespace nrb::io::step {

// Whether the first word is that of STEP. A byte order mark, blanks and comments may stand before it.
bool begins_step(std::span<const char> bytes) noexcept;

struct Exchange {
    std::vector<std::string> schemas; // the names in FILE_SCHEMA, without object identifiers
    Instances instances;
};

// Finds the instances of all data sections; other sections (ANCHOR, REFERENCE) are passed over. What stands in the
// parentheses of an instance is not looked at. Throws Error: Status::truncated if END-ISO-10303-21 is missing, syntax
// if the structure is broken; messages count lines from 1. Preconditions: begins_step(), and the text outlives the
// result.
Exchange read_exchange(std::span<const char> bytes);

} // namespace nrb::io::step

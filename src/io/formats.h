// SPDX-License-Identifier: MIT
// The formats of files. Which one a file has is found by its first bytes.
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

struct Format {
    const char *name;
    bool (*recognizes)(std::span<const char> bytes) noexcept;
    // The reader throws for what is wrong with a file that has this format. Null: the format is known, but
    // cannot be read.
    model::Model (*read)(std::span<const char> bytes, const ReadSettings &settings);
    // The same for faces, edges and vertices.
    model::Model (*read_model)(std::span<const char> bytes, const ReadSettings &settings);
};

std::span<const Format> formats() noexcept;

// Reads the file by the first format that recognizes it. Throws Status::options for a unit that is negative
// or not finite; too_large beyond settings.max_bytes; format if no format recognizes the file or its format
// cannot be read; and what the reader throws.
model::Model read(std::span<const char> bytes, const ReadSettings &settings);

// The same for faces, edges and vertices; format also for files of which they are not read.
model::Model read_model(std::span<const char> bytes, const ReadSettings &settings);

} // namespace nrb::io

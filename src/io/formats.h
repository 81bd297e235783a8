// SPDX-License-Identifier: MIT
// The file formats that are known. The format of a file is recognized by its first bytes.
#pragma once

#include "io/read_settings.h"
#include "model/model.h"

#include <span>

namespace nrb::io {

struct Format {
    const char *name;
    bool (*recognizes)(std::span<const char> bytes) noexcept;
    // Throws for whatever is wrong with a file of this format. Null: the format is recognized, but cannot be
    // read.
    model::Model (*read)(std::span<const char> bytes, const ReadSettings &settings);
    // The same for a model with faces, edges and vertices.
    model::Model (*read_model)(std::span<const char> bytes, const ReadSettings &settings);
};

std::span<const Format> formats() noexcept;

// Reads a file with the reader of the first format that recognizes it. Throws Status::options for a unit that
// is negative or not finite; too_large for more than settings.max_bytes; format if no format recognizes the
// file, or if its format cannot be read; and what the reader throws.
model::Model read(std::span<const char> bytes, const ReadSettings &settings);

// The same for a model with faces, edges and vertices. Also throws Status::format for a format of which these
// are not read.
model::Model read_model(std::span<const char> bytes, const ReadSettings &settings);

} // namespace nrb::io

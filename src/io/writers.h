// SPDX-License-Identifier: MIT
// Writes models as files.
#pragma once

#include "io/write_settings.h"
#include "model/model.h"

#include <cstdint>
#include <string>

namespace nrb::io {

enum class WrittenFormat : int32_t { step = 1, iges = 2 };

// A model as a file in a format. Throws Status::format for a number that stands for no format, options for
// settings that are negative or not finite, and what the writer throws.
std::string write(const model::Model &model, int32_t format, const WriteSettings &settings);

} // namespace nrb::io

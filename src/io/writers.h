// SPDX-License-Identifier: MIT
// The formats that are written.
#pragma once

#include "io/write_settings.h"
#include "model/model.h"

#include <cstdint>
#include <string>

namespace nrb::io {

enum class WrittenFormat : int32_t { step = 1, iges = 2 };

// A model as a file of a format. Throws Status::format for other numbers than those of formats, options for settings that are
// negative or not finite, and what the writer throws.
std::string write(const model::Model &model, int32_t format, const WriteSettings &settings);

} // namespace nrb::io

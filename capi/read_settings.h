// SPDX-License-Identifier: MIT
// Arguments of the functions that read files: settings, and the text of a file.
#pragma once

#include "checks.h"

#include "io/read_settings.h"

#include <span>

namespace nrb::capi {

io::ReadSettings settings_of(const nurbs_read_options *options);
std::span<const char> checked_text(const void *bytes, int64_t size);

} // namespace nrb::capi

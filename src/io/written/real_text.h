// SPDX-License-Identifier: MIT
// Reals as the texts of files have them.
#pragma once

#include <string>

namespace nrb::io {

// The shortest digits that name the value, with the decimal point that a real has to have: 1., 1.E-7. Throws
// Status::not_representable for what is not finite, which a number becomes that overflows in the unit of the file.
void append_real(double value, std::string &text);

} // namespace nrb::io

// SPDX-License-Identifier: MIT
// Real numbers as text in STEP and IGES files.
#pragma once

#include <string>

namespace nrb::io {

// Appends the shortest digits that identify the value, with the decimal point that a real needs: 1., 1.E-7.
// Throws Status::not_representable for a value that is not finite, which a number becomes if it overflows in
// the unit of the file.
void append_real(double value, std::string &text);

} // namespace nrb::io

// SPDX-License-Identifier: MIT
// The parts of ISO 8859 that strings may switch to.
#pragma once

namespace nrb::io::step {

// The character that a code has in part 1 ('A'), 2 ('B'), ... 9 ('I') of ISO 8859; letters beyond count as part 1.
char32_t code_page_character(char page, unsigned char code) noexcept;

} // namespace nrb::io::step

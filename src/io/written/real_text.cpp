// SPDX-License-Identifier: MIT
#include "io/written/real_text.h"

#include "base/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace nrb::io {

void append_real(double value, std::string &text) {
    if (!std::isfinite(value)) {
        fail(Status::not_representable, "a number overflows in the unit of the file");
    }
    char digits[32];
    const char *const end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    const std::string_view number(digits, static_cast<size_t>(end - digits));
    const size_t exponent = std::min(number.find('e'), number.size());
    text += number.substr(0, exponent);
    if (number.find('.') == std::string_view::npos) {
        text += '.';
    }
    if (exponent < number.size()) {
        text += 'E';
        text += number.substr(exponent + 1);
    }
}

} // namespace nrb::io

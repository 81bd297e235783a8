// SPDX-License-Identifier: MIT
#include "base/error.h"

#include <algorithm>
#include <charconv>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace nrb::inline base {

Error::Error(Status status, const char *text) noexcept : status_(status), text_{} {
    std::memcpy(text_, text, std::min(std::strlen(text), static_cast<size_t>(capacity) - 1));
}

Number::Number(double value) noexcept : text{} {
    std::to_chars(text, text + sizeof text - 1, value);
}

void fail(Status status, const char *format, ...) {
    char text[Error::capacity];
    va_list arguments;
    va_start(arguments, format);
    static_cast<void>(std::vsnprintf(text, sizeof text, format, arguments));
    va_end(arguments);
    throw Error(status, text);
}

} // namespace nrb::inline base

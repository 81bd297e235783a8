// SPDX-License-Identifier: MIT
#include "base/error.h"

#include <algorithm>
#include <charconv>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace nrb::inline base {

Error::Error(Status status, const char *text, double needed) noexcept
    : status_(status), needed_(needed), text_{} {
    std::memcpy(text_, text, std::min(std::strlen(text), static_cast<size_t>(capacity) - 1));
}

Number::Number(double value) noexcept : text{} {
    std::to_chars(text, text + sizeof text - 1, value);
}

namespace {

[[noreturn]] void fail_with(double needed, Status status, const char *format, va_list arguments) {
    char text[Error::capacity];
    static_cast<void>(std::vsnprintf(text, sizeof text, format, arguments));
    throw Error(status, text, needed);
}

} // namespace

void fail(Status status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fail_with(0, status, format, arguments);
}

void fail_needing(double tolerance, Status status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fail_with(tolerance, status, format, arguments);
}

} // namespace nrb::inline base

// SPDX-License-Identifier: MIT
// The one error type of the core, and how it is thrown.
#pragma once

#include "base/status.h"

#include <exception>

namespace nrb::inline base {

// Carries a status and its message. The text is stored inside, so that throwing needs no memory
// beyond the exception object itself.
class Error : public std::exception {
public:
    Error(Status status, const char *text) noexcept;
    [[nodiscard]] const char *what() const noexcept override { return text_; }
    [[nodiscard]] Status status() const noexcept { return status_; }

    static constexpr int capacity = 320;

private:
    Status status_;
    char text_[capacity];
};

// What ends a watched call from outside. It is no Error, so that nothing that copes with failures takes it for one.
struct CallEnded {
    Error why;
};

// A double as text for messages: the shortest digits that name the value, whatever the locale.
struct Number {
    explicit Number(double value) noexcept;
    char text[32];
};

// Throws Error with a printf-style message.
[[noreturn]] __attribute__((format(printf, 2, 3))) void fail(Status status, const char *format, ...);

} // namespace nrb::inline base

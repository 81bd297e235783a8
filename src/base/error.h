// SPDX-License-Identifier: MIT
// The error type of the core, and how it is thrown.
#pragma once

#include "base/status.h"

#include <exception>

namespace nrb::inline base {

// Carries a status and its message. The text is stored inside the object, so that throwing needs no memory
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

// Thrown to end a watched call from outside (see base/watch.h). It is not derived from Error, so that no
// handler that recovers from failures catches it.
struct CallEnded {
    Error why;
};

// A double as text for messages: the shortest digits that identify the value, independent of the locale.
struct Number {
    explicit Number(double value) noexcept;
    char text[32];
};

// Throws Error with a printf-style message.
[[noreturn]] __attribute__((format(printf, 2, 3))) void fail(Status status, const char *format, ...);

} // namespace nrb::inline base

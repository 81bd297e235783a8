// The one error type of the core, and how it is thrown.
#pragma once

#include <exception>
#include <nurbs/nurbs.h>

namespace nrb {

// Carries a status of the C API and its message. The text is stored inside, so that throwing needs no memory
// beyond the exception object itself.
class Error : public std::exception {
public:
    Error(nurbs_status status, const char *text) noexcept;
    [[nodiscard]] const char *what() const noexcept override { return text_; }
    [[nodiscard]] nurbs_status status() const noexcept { return status_; }

    static constexpr int capacity = 320;

private:
    nurbs_status status_;
    char text_[capacity];
};

// A double as text for messages: the shortest digits that name the value, whatever the locale.
struct Number {
    explicit Number(double value) noexcept;
    char text[32];
};

// Throws Error with a printf-style message.
[[noreturn]] __attribute__((format(printf, 2, 3))) void fail(nurbs_status status, const char *format, ...);

} // namespace nrb

/* SPDX-License-Identifier: MIT */
/// \file result.hpp
/// \brief How a failure reaches the caller: as an exception, or in the Result that a function returns.
///
/// A program chooses for each of its source files. Without a choice a failure throws Error, and a function returns a T.
/// Where NURBS_CPP_RESULTS is defined before nurbs.hpp is included, and where the compiler has no exceptions
/// (-fno-exceptions), nothing throws, and the same function returns a Result<T>. Both kinds of files may be linked.
#ifndef NURBS_CPP_RESULT_HPP
#define NURBS_CPP_RESULT_HPP

#include <nurbs/cpp/status.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#ifndef __cpp_exceptions
#define NURBS_CPP_RESULTS
#endif

// The two kinds of functions have names of their own for the linker.
#ifdef NURBS_CPP_RESULTS
#define NURBS_CPP_POLICY returning
#else
#define NURBS_CPP_POLICY throwing
#endif

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// A failure: its status, and the library's message.
class Error : public std::runtime_error {
public:
    Error(Status status, const std::string &message) : std::runtime_error(message), status_(status) {}
    [[nodiscard]] Status status() const noexcept { return status_; }
    [[nodiscard]] const char *name() const noexcept { return status_name(status_); }

private:
    Status status_;
};

#ifdef NURBS_CPP_RESULTS

namespace detail {

// The first failure inside the call that is running. What follows it in that call is left out, and the Result that
// the call returns takes it.
inline constinit thread_local Status pending = Status::ok;
inline thread_local std::string pending_message;

inline bool going() noexcept {
    return pending == Status::ok;
}

inline void fail(Status status, const std::string &message) {
    if (going()) {
        pending = status;
        pending_message = message;
    }
}

inline std::optional<Error> taken() {
    if (going()) {
        return std::nullopt;
    }
    return Error(std::exchange(pending, Status::ok), std::exchange(pending_message, {}));
}

// What a call returns that makes nothing.
struct Done {};

} // namespace detail

/// A value or an Error, in the manner of std::expected. It converts to true if there is a value.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T &&value) : value_(std::move(value)), error_(detail::taken()) {}
    Result(const T &value) : value_(value), error_(detail::taken()) {}

    explicit operator bool() const noexcept { return !error_; }
    [[nodiscard]] bool has_value() const noexcept { return !error_; }
    [[nodiscard]] Status status() const noexcept { return error_ ? error_->status() : Status::ok; }
    /// Only of a failure.
    [[nodiscard]] const Error &error() const { return *error_; }

    /// The value. Without one, the program ends with the message.
    [[nodiscard]] T &value() & {
        require_value();
        return value_;
    }
    [[nodiscard]] const T &value() const & {
        require_value();
        return value_;
    }
    [[nodiscard]] T &&value() && {
        require_value();
        return std::move(value_);
    }
    /// The value; of a failure one that is empty or 0, on which every function fails again.
    T &operator*() &noexcept { return value_; }
    const T &operator*() const &noexcept { return value_; }
    T &&operator*() &&noexcept { return std::move(value_); }
    T *operator->() noexcept { return &value_; }
    const T *operator->() const noexcept { return &value_; }
    [[nodiscard]] T value_or(T other) && { return error_ ? std::move(other) : std::move(value_); }

private:
    T value_;
    std::optional<Error> error_;

    void require_value() const {
        if (error_) {
            std::fprintf(stderr, "%s: %s\n", error_->name(), error_->what());
            std::abort();
        }
    }
};

/// Of a function that returns nothing else.
template <>
class [[nodiscard]] Result<void> {
public:
    Result(detail::Done) : error_(detail::taken()) {}

    explicit operator bool() const noexcept { return !error_; }
    [[nodiscard]] bool has_value() const noexcept { return !error_; }
    [[nodiscard]] Status status() const noexcept { return error_ ? error_->status() : Status::ok; }
    /// Only of a failure.
    [[nodiscard]] const Error &error() const { return *error_; }

private:
    std::optional<Error> error_;
};

/// What functions return: T, or Result<T> by choice.
template <class T>
using Returned = Result<T>;

namespace detail {

// Calls a function of this header inside another one, which then fails as it does.
template <class F, class... Arguments>
void run(F &&f, Arguments &&...arguments) {
    if constexpr (std::is_same_v<decltype(f(arguments...)), Result<void>>) {
        if (const Result<void> made = f(arguments...); !made) {
            fail(made.status(), made.error().what());
        }
    } else {
        f(arguments...);
    }
}

} // namespace detail

#else

/// What functions return: T, or Result<T> by choice.
template <class T>
using Returned = T;

namespace detail {

using Done = void;

constexpr bool going() noexcept {
    return true;
}

[[noreturn]] inline void fail(Status status, const std::string &message) {
    throw Error(status, message);
}

template <class F, class... Arguments>
void run(F &&f, Arguments &&...arguments) {
    f(arguments...);
}

} // namespace detail

#endif

namespace detail {

#ifdef __cpp_exceptions
#ifdef NURBS_CPP_RESULTS
inline void keep(const std::exception_ptr &) noexcept {}
inline void rethrow_kept() noexcept {}
#else
// What the callback of a long call threw, until the call has ended.
inline thread_local std::exception_ptr kept;

inline void keep(std::exception_ptr thrown) noexcept {
    kept = std::move(thrown);
}
inline void rethrow_kept() {
    if (kept != nullptr) {
        std::rethrow_exception(std::exchange(kept, nullptr));
    }
}
#endif
#endif

inline void check(nurbs_status status) {
#ifdef __cpp_exceptions
    if (status == NURBS_ERROR_CANCELLED) {
        rethrow_kept();
    }
#endif
    if (status != NURBS_OK) {
        fail(static_cast<Status>(status), last_error());
    }
}

// A copy that failed is empty, which says it where nothing throws.
inline void check_copy([[maybe_unused]] nurbs_status status) {
#ifndef NURBS_CPP_RESULTS
    check(status);
#endif
}

// Calls f(), which returns a status, unless the call has failed before.
template <class F>
void attempt(F &&f) {
    if (going()) {
        check(f());
    }
}

// The same for a function of nurbs.h, its arguments converted as in a direct call.
template <class... Parameters>
Done call(nurbs_status (*function)(Parameters...), std::type_identity_t<Parameters>... arguments) {
    attempt([&] { return function(arguments...); });
    return Done();
}

} // namespace detail

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_RESULT_HPP

/* SPDX-License-Identifier: MIT */
// Calls whose outputs are recorded: arrays, statuses and messages, and what the handles hold that they make.
// Outputs are written to memory that was filled before, so that what a call leaves alone is the same every
// time.
#ifndef NURBS_TESTS_CAPI_RECORDED_OUTPUTS_H
#define NURBS_TESTS_CAPI_RECORDED_OUTPUTS_H

#include "recorded/handles.h"
#include "recorded/record.h"

#include <algorithm>
#include <cstring>
#include <memory>

namespace recorded {

struct Function {
    const char *name;
    Tally result = {}, message = {};
};

struct Argument {
    const char *function, *name;
    bool read; // by the function, which an output need not be
    Tally tally = {};
};

// In the place of an output: it is recorded, and then nobody wants it.
struct Unread {
    template <class T>
    operator T *() const {
        return reinterpret_cast<T *>(place);
    }
    alignas(16) static inline char place[16] = {};
};
inline constexpr Unread unread;

template <class T>
bool is_unread(T *place) {
    return static_cast<const void *>(place) == Unread::place;
}

class Running {
public:
    explicit Running(Function &function) : function_(function) {}
    nurbs_status status(nurbs_status status) {
        other(status);
        if (status != NURBS_OK) {
            add_text(function_.message, "message", last_message().c_str());
        }
        return status;
    }
    template <class Result>
    Result other(Result result) {
        if constexpr (std::is_pointer_v<Result>) {
            add_text(function_.result, "return", result);
        } else {
            Output(function_.result, function_.name, "return").add(result);
        }
        return result;
    }

private:
    void add_text(Tally &tally, const char *name, const char *text) {
        Output(tally, function_.name, name).add(text, static_cast<int64_t>(std::strlen(text)));
    }

    Function &function_;
};

// An input, which is the caller's.
template <class T>
class Array {
public:
    static_assert(std::is_const_v<T>);
    Array(Argument &, T *caller, int64_t) : caller_(caller) {}
    [[nodiscard]] T *place() const { return caller_; }

private:
    T *caller_;
};

// An output, in memory of its own: those that nobody reads would overlap.
template <class T>
requires(!std::is_const_v<T>) class Array<T> {
public:
    Array(Argument &argument, T *caller, int64_t count)
        : argument_(argument), caller_(caller), count_(caller == nullptr || count < 0 ? 0 : count),
          values_(std::make_unique<T[]>(static_cast<size_t>(count_) + 1)) { // never none
        if (argument.read && caller != nullptr && !is_unread(caller)) {
            std::copy_n(caller, count_, values_.get());
        } else if (!std::is_pointer_v<T>) {
            std::memset(static_cast<void *>(values_.get()), 0x5a, bytes());
        }
    }
    Array(const Array &) = delete;
    Array &operator=(const Array &) = delete;
    ~Array() {
        if (caller_ != nullptr) {
            describe();
            hand_over();
        }
    }
    [[nodiscard]] T *place() const { return caller_ == nullptr ? nullptr : values_.get(); }

private:
    [[nodiscard]] size_t bytes() const { return static_cast<size_t>(count_) * sizeof(T); }
    void describe() {
        Output output(argument_.tally, argument_.function, argument_.name);
        if constexpr (std::is_pointer_v<T>) {
            add_handle(output, values_[0]);
        } else if constexpr (std::is_class_v<T>) {
            output.add(reinterpret_cast<const unsigned char *>(values_.get()), static_cast<int64_t>(bytes()));
        } else {
            output.add(values_.get(), count_);
        }
    }
    void hand_over() {
        if (!is_unread(caller_)) {
            std::copy_n(values_.get(), count_, caller_);
        } else if constexpr (std::is_pointer_v<T>) {
            discard(values_[0]);
        }
    }

    Argument &argument_;
    T *caller_;
    int64_t count_;
    std::unique_ptr<T[]> values_;
};

// Bytes.
template <>
class Array<void> : public Array<unsigned char> {
public:
    Array(Argument &argument, void *caller, int64_t count)
        : Array<unsigned char>(argument, static_cast<unsigned char *>(caller), count) {}
};

} // namespace recorded

#endif

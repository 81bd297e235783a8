/* SPDX-License-Identifier: MIT */
// The record of a run: for every output of every function a number of calls and a hash of all values, by
// sections; on demand the values too.
#ifndef NURBS_TESTS_CAPI_RECORDED_RECORD_H
#define NURBS_TESTS_CAPI_RECORDED_RECORD_H

#include <bit>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <type_traits>

namespace recorded {

// What one output of a function was in the calls of a section.
struct Tally {
    int64_t count = 0;
    uint64_t hash = 0x9e3779b97f4a7c15u;

    // Each bit of a value acts on all bits of the hash in the end.
    void add(uint64_t bits) {
        hash = (hash ^ bits) * 0x2545f4914f6cdd1du;
        hash ^= hash >> 32;
    }
};

// The bits of a value. The sign of a NaN is left to the compiler and the processor, so all are one.
template <class T>
uint64_t bits_of(T value) {
    if constexpr (std::is_same_v<T, double>) {
        return value == value ? std::bit_cast<uint64_t>(value) : 0x7ff8000000000000u;
    } else if constexpr (std::is_same_v<T, float>) {
        return value == value ? std::bit_cast<uint32_t>(value) : 0x7fc00000u;
    } else {
        return static_cast<uint64_t>(value);
    }
}

struct Plan {
    std::ostream *out = nullptr;
    std::optional<std::regex> values;   // of functions whose values are written
    std::optional<std::regex> sections; // that are run
    bool quick = false;                 // a part of everything
    bool again = false;                 // what is recorded are the second answers of the same handles
};

// One for the program, since functions have no place for it among their arguments.
class Record {
public:
    void start(const Plan &plan);
    [[nodiscard]] bool quick() const { return plan_.quick; }
    // Calls body(), and writes what it recorded.
    void section(const std::string &name, const std::function<void()> &body);

    // Whether calls are recorded at present, and whether the values of a function are wanted too.
    [[nodiscard]] bool on() const { return on_; }
    bool shows(const char *function);
    void begin_values(const char *function, const char *output);
    void value(double value);
    void value(float value);
    void value(int64_t value);
    void end_values();

private:
    void write_lines();
    void write_line(const char *function, const char *output, Tally &tally);

    Plan plan_;
    std::string section_;
    bool on_ = false;
    std::map<std::string, bool> shown_;
};

inline Record record;

// One output of one call, on its way into the record.
class Output {
public:
    Output(Tally &tally, const char *function, const char *name)
        : tally_(tally), on_(record.on()), shown_(on_ && record.shows(function)) {
        tally.count += on_ ? 1 : 0;
        if (shown_) {
            record.begin_values(function, name);
        }
    }
    Output(const Output &) = delete;
    Output &operator=(const Output &) = delete;
    ~Output() {
        if (shown_) {
            record.end_values();
        }
    }

    template <class T>
    void add(const T *values, int64_t n) {
        for (int64_t i = 0; on_ && i < n; ++i) {
            tally_.add(bits_of(values[i]));
        }
        for (int64_t i = 0; shown_ && i < n; ++i) {
            record.value(shown(values[i]));
        }
    }
    template <class T>
    void add(T value) {
        add(&value, 1);
    }

private:
    template <class T>
    static auto shown(T value) {
        if constexpr (std::is_floating_point_v<T>) {
            return value;
        } else {
            return static_cast<int64_t>(value);
        }
    }

    Tally &tally_;
    bool on_, shown_;
};

} // namespace recorded

#endif

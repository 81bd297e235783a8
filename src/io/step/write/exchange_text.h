// SPDX-License-Identifier: MIT
// The data section of an exchange structure as it is written (ISO 10303-21).
#pragma once

#include "base/watch.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace nrb::io::step {

// What attributes can be, besides bool for .T. and .F., integers, and reals.
struct Text {
    std::string_view utf8;
};
struct Ref {
    int64_t number;
};
struct Refs {
    std::span<const int64_t> numbers;
};
struct Integers {
    std::span<const int64_t> values;
};
struct Reals {
    std::span<const double> values;
};
struct Word { // ".UNSPECIFIED.", "$", "*"
    std::string_view text;
};
struct Measure { // "LENGTH_MEASURE(0.001)"
    std::string_view type;
    double value;
};

inline constexpr Text no_name{""};
inline constexpr Word unset{"$"};
inline constexpr Word derived{"*"};
inline constexpr Word not_told{".U."};
inline constexpr Word unspecified{".UNSPECIFIED."};

// Instances are numbered as they are added, from 1 on. Lines end behind the comma after column 72, so that old readers, which take
// no long ones, are served too; a name may be longer.
class ExchangeText {
public:
    explicit ExchangeText(std::string_view before) : text_(before) {}

    // "#12=KEYWORD(...);", and 12.
    template <class... Values>
    int64_t add(std::string_view keyword, const Values &...values) {
        const int64_t number = reserve();
        add_as(number, keyword, values...);
        return number;
    }
    // Numbers for instances that others name before they are added.
    int64_t reserve(int64_t count = 1) noexcept {
        next_ += count;
        return next_ - count;
    }
    template <class... Values>
    void add_as(int64_t number, std::string_view keyword, const Values &...values) {
        begin(number);
        part(keyword, values...);
        end();
    }

    // A complex instance: begin_complex(), its parts in alphabetical order, end_complex().
    int64_t begin_complex();
    template <class... Values>
    void part(std::string_view keyword, const Values &...values) {
        text_ += keyword;
        open_list();
        (attribute(values), ...);
        close_list();
    }
    void end_complex();

    // Lists that are more than one attribute.
    void open_list();
    void close_list();
    void attribute(Text text);
    void attribute(Ref reference);
    void attribute(Refs references) {
        list(references.numbers, [](int64_t number) { return Ref{number}; });
    }
    void attribute(Integers integers) {
        list(integers.values, [](int64_t value) { return value; });
    }
    void attribute(Reals reals) {
        list(reals.values, [](double value) { return value; });
    }
    void attribute(Word word);
    void attribute(const Measure &measure);
    void attribute(bool value) { attribute(Word{value ? ".T." : ".F."}); }
    void attribute(double value);
    void attribute(int64_t value);
    void attribute(int value) { attribute(int64_t{value}); }

    // A list of what attributes() adds.
    template <class Attributes>
    requires std::is_invocable_v<Attributes>
    void attribute(const Attributes &attributes) {
        separate();
        open_list();
        attributes();
        close_list();
    }

    std::string take() noexcept { return std::move(text_); }
    // What stands behind the data section.
    void raw(std::string_view text) { text_ += text; }

private:
    template <class Values, class Convert>
    void list(const Values &values, const Convert &convert) {
        separate();
        open_list();
        for (const auto &value : values) {
            attribute(convert(value));
        }
        close_list();
    }
    void begin(int64_t number);
    void end();
    void separate();
    void append_integer(int64_t value);

    std::string text_;
    size_t line_ = 0; // where the line begins
    bool first_ = true;
    int64_t next_ = 1;
};

} // namespace nrb::io::step

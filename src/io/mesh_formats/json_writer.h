// SPDX-License-Identifier: MIT
// Writes JSON text piece by piece.
#pragma once

#include "io/mesh_formats/text.h"

#include <array>
#include <charconv>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace nrb::io {

// Inserts commas, and closes the objects and arrays that it opens.
class JsonWriter {
public:
    // A value in an array or after a key. Precondition: numbers are finite.
    JsonWriter &operator<<(std::string_view text) { return raw(json_text(text)); }
    JsonWriter &operator<<(const char *text) { return *this << std::string_view(text); }
    JsonWriter &operator<<(const std::string &text) { return *this << std::string_view(text); }
    JsonWriter &operator<<(std::same_as<bool> auto value) { return raw(value ? "true" : "false"); }
    template <class Number>
    requires(std::integral<Number> || std::floating_point<Number>) &&
        (!std::same_as<Number, bool>)JsonWriter &operator<<(Number value) {
        char digits[32];
        return raw(
            {digits, static_cast<size_t>(std::to_chars(digits, digits + sizeof digits, value).ptr - digits)});
    }
    template <class Number, size_t size>
    JsonWriter &operator<<(const std::array<Number, size> &values) {
        return list(values);
    }
    template <class Number>
    JsonWriter &operator<<(const std::vector<Number> &values) {
        return list(values);
    }

    JsonWriter &key(std::string_view name) {
        raw(json_text(name));
        text_ += ':';
        first_ = true;
        return *this;
    }
    template <class Value>
    JsonWriter &pair(std::string_view name, const Value &value) {
        return key(name) << value;
    }
    template <class Fill>
    JsonWriter &object(Fill &&fill) {
        return nested('{', fill, '}');
    }
    template <class Fill>
    JsonWriter &array(Fill &&fill) {
        return nested('[', fill, ']');
    }

    [[nodiscard]] const std::string &text() const noexcept { return text_; }

private:
    template <class Values>
    JsonWriter &list(const Values &values) {
        return array([&] {
            for (const auto &value : values) {
                *this << value;
            }
        });
    }
    JsonWriter &raw(std::string_view text) {
        if (!first_) {
            text_ += ',';
        }
        first_ = false;
        text_ += text;
        return *this;
    }
    template <class Fill>
    JsonWriter &nested(char open, Fill &fill, char close) {
        raw({&open, 1});
        first_ = true;
        fill();
        first_ = false;
        text_ += close;
        return *this;
    }

    std::string text_;
    bool first_ = true; // whether no comma belongs before the next value
};

} // namespace nrb::io

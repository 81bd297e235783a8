// SPDX-License-Identifier: MIT
#include "io/mesh_formats/text.h"

#include "io/step/structure/text.h"

#include <algorithm>

namespace nrb::io {

namespace {

constexpr unsigned char first_printable = 0x20, delete_character = 0x7f;

bool is_control(char c) noexcept {
    const auto byte = static_cast<unsigned char>(c);
    return byte < first_printable || byte == delete_character;
}

void append_escaped(char c, std::string &text) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    text += "\\u00";
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
}

} // namespace

std::string json_text(std::string_view name) {
    std::string text = "\"";
    while (!name.empty()) {
        const size_t length = step::utf8_length(name);
        const char c = name.front();
        if (length == 0 || is_control(c)) {
            append_escaped(c, text);
        } else {
            text.append(c == '"' || c == '\\' ? 1 : 0, '\\');
            text += name.substr(0, length);
        }
        name.remove_prefix(std::max<size_t>(length, 1));
    }
    return text + '"';
}

std::string one_word(std::string_view name) {
    constexpr std::string_view others = " #\\";
    std::string word;
    while (!name.empty()) {
        const size_t length = step::utf8_length(name);
        const bool plain =
            length > 0 && !is_control(name.front()) && others.find(name.front()) == std::string_view::npos;
        word += plain ? name.substr(0, length) : std::string_view("_");
        name.remove_prefix(std::max<size_t>(length, 1));
    }
    return word;
}

} // namespace nrb::io

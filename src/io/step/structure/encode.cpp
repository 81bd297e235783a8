// SPDX-License-Identifier: MIT
#include "io/step/structure/text.h"

#include <cstdint>

namespace nrb::io::step {
namespace {

// The character that a text begins with, which goes from it.
char32_t take_character(std::string_view &text, bool utf8) noexcept {
    const auto byte = [&](size_t i) { return static_cast<char32_t>(static_cast<unsigned char>(text[i])); };
    const size_t length = utf8 ? utf8_length(text) : 1;
    char32_t c = length == 1 ? byte(0) : byte(0) & (0xFFU >> (length + 1));
    for (size_t i = 1; i < length; ++i) {
        c = (c << 6) | (byte(i) & 0x3F);
    }
    text.remove_prefix(length);
    return c;
}

class Encoder {
public:
    explicit Encoder(std::string &raw) noexcept : raw_(raw) {}

    void add(char32_t c) {
        if (c < 0x20 || (c >= 0x7F && c < 0xA0)) {
            c = U'?';
        }
        if (c < 0x7F) {
            set_width(0);
            raw_ += static_cast<char>(c);
            if (c == U'\'' || c == U'\\') {
                raw_ += static_cast<char>(c);
            }
            return;
        }
        set_width(c < 0x10000 ? 4 : 8);
        for (int shift = 4 * width_; shift > 0;) {
            shift -= 4;
            raw_ += "0123456789ABCDEF"[(c >> shift) & 0xF];
        }
    }
    // Of the digits of characters to come; 0: they stand as they are.
    void set_width(int width) {
        if (width == width_) {
            return;
        }
        if (width_ != 0) {
            raw_ += "\\X0\\";
        }
        if (width != 0) {
            raw_ += width == 4 ? "\\X2\\" : "\\X4\\";
        }
        width_ = width;
    }

private:
    std::string &raw_;
    int width_ = 0;
};

} // namespace

void append_encoded(std::string_view text, std::string &raw) {
    const bool utf8 = is_utf8(text);
    Encoder encoder(raw);
    while (!text.empty()) {
        encoder.add(take_character(text, utf8));
    }
    encoder.set_width(0);
}

} // namespace nrb::io::step

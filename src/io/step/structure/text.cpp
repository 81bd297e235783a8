// SPDX-License-Identifier: MIT
#include "io/step/structure/text.h"

#include "io/step/structure/code_pages.h"

#include <cstdint>

namespace nrb::io::step {
namespace {

constexpr char32_t no_character = 0xFFFD;

void append_utf8(std::string &text, char32_t c) {
    const auto put = [&](char32_t byte) {
        text.push_back(static_cast<char>(static_cast<unsigned char>(byte)));
    };
    if (c < 0x80) {
        put(c);
    } else if (c < 0x800) {
        put(0xC0 | (c >> 6));
        put(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        put(0xE0 | (c >> 12));
        put(0x80 | ((c >> 6) & 0x3F));
        put(0x80 | (c & 0x3F));
    } else {
        put(0xF0 | (c >> 18));
        put(0x80 | ((c >> 12) & 0x3F));
        put(0x80 | ((c >> 6) & 0x3F));
        put(0x80 | (c & 0x3F));
    }
}

bool surrogate(char32_t c) noexcept {
    return c >= 0xD800 && c < 0xE000;
}

void append_character(std::string &text, char32_t c) {
    if (c == '\n' || c == '\r') {
        return;
    }
    const bool control = c < 0x20 || (c >= 0x7F && c < 0xA0);
    append_utf8(text, control ? U'?' : (surrogate(c) || c > 0x10FFFF ? no_character : c));
}

// The number that so many hexadecimal digits make, or -1.
int64_t hexadecimal(std::string_view text, size_t digits) noexcept {
    if (text.size() < digits) {
        return -1;
    }
    int64_t value = 0;
    for (const char c : text.substr(0, digits)) {
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                                 : -1;
        if (digit < 0) {
            return -1;
        }
        value = 16 * value + digit;
    }
    return value;
}

class Decoder {
public:
    explicit Decoder(std::string_view raw) : raw_(raw), utf8_(is_utf8(raw)) {}

    std::string run() {
        while (!raw_.empty()) {
            if (raw_.front() == '\\' && take_escape()) {
                continue;
            }
            take_plain();
        }
        return std::move(text_);
    }

private:
    void take_plain() {
        const bool twice = raw_.front() == '\'' && raw_.starts_with("''");
        const auto byte = static_cast<unsigned char>(raw_.front());
        if (byte < 0x80 || !utf8_) {
            append_character(text_, byte);
            raw_.remove_prefix(twice ? 2 : 1);
            return;
        }
        const size_t length = utf8_length(raw_);
        text_.append(raw_.substr(0, length));
        raw_.remove_prefix(length);
    }

    bool take_escape() {
        if (raw_.starts_with("\\\\")) {
            return finish(2, '\\');
        }
        if (raw_.starts_with("\\S\\") && raw_.size() > 3) {
            const auto code = static_cast<unsigned char>(raw_[3] | 0x80);
            return finish(4, code_page_character(page_, code));
        }
        if (raw_.starts_with("\\P") && raw_.size() > 3 && raw_[3] == '\\' && raw_[2] >= 'A' &&
            raw_[2] <= 'I') {
            page_ = raw_[2];
            raw_.remove_prefix(4);
            return true;
        }
        if (const int64_t code = raw_.starts_with("\\X\\") ? hexadecimal(raw_.substr(3), 2) : -1; code >= 0) {
            return finish(5, static_cast<char32_t>(code));
        }
        return raw_.starts_with("\\X2\\") ? take_wide(4) : raw_.starts_with("\\X4\\") && take_wide(8);
    }

    bool finish(size_t length, char32_t c) {
        append_character(text_, c);
        raw_.remove_prefix(length);
        return true;
    }

    // Characters of so many digits up to \X0\; two surrogates make one character.
    bool take_wide(size_t digits) {
        constexpr size_t mark = 4;
        const size_t end = raw_.find("\\X0\\", mark);
        if (end == std::string_view::npos || (end - mark) % digits != 0 ||
            raw_.substr(mark, end - mark).find_first_not_of("0123456789ABCDEFabcdef") !=
                std::string_view::npos) {
            return false;
        }
        char32_t high = 0;
        for (size_t at = mark; at < end; at += digits) {
            high = append_half(high, static_cast<char32_t>(hexadecimal(raw_.substr(at), digits)));
        }
        if (high != 0) {
            append_character(text_, high);
        }
        raw_.remove_prefix(end + mark);
        return true;
    }

    // The half of a character that waits for the other one, or 0.
    char32_t append_half(char32_t high, char32_t code) {
        if (high != 0 && code >= 0xDC00 && code < 0xE000) {
            append_character(text_, 0x10000 + ((high - 0xD800) << 10) + (code - 0xDC00));
            return 0;
        }
        if (high != 0) {
            append_character(text_, high);
        }
        if (code >= 0xD800 && code < 0xDC00) {
            return code;
        }
        append_character(text_, code);
        return 0;
    }

    std::string_view raw_;
    bool utf8_;
    char page_ = 'A';
    std::string text_;
};

} // namespace

size_t utf8_length(std::string_view text) noexcept {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const size_t length = byte(0) < 0x80   ? 1U
                          : byte(0) < 0xC2 ? 0U
                          : byte(0) < 0xE0 ? 2U
                          : byte(0) < 0xF0 ? 3U
                          : byte(0) < 0xF5 ? 4U
                                           : 0U;
    if (length == 0 || length > text.size()) {
        return 0;
    }
    for (size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) {
            return 0;
        }
    }
    // overlong forms, surrogates, and what is beyond Unicode
    const bool strange = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) >= 0xA0) ||
                         (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) >= 0x90);
    return strange ? 0 : length;
}

bool is_utf8(std::string_view text) noexcept {
    while (!text.empty()) {
        const size_t length = utf8_length(text);
        if (length == 0) {
            return false;
        }
        text.remove_prefix(length);
    }
    return true;
}

std::string decode_string(std::string_view raw) {
    return Decoder(raw).run();
}

} // namespace nrb::io::step

// SPDX-License-Identifier: MIT
#include "io/iges/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace nrb::io::iges {
namespace {

bool digit(char c) noexcept {
    return c >= '0' && c <= '9';
}

// std::from_chars accepts no plus sign, but it accepts "inf", "nan", and a minus sign after the sign taken
// here. So the callers require a digit or a point next.
bool take_sign(std::string_view &text) noexcept {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    return negative;
}

// The decimal exponent of the leading digit of a number that std::from_chars found to be out of range; the
// exponent part is clamped to +-10^9.
int64_t magnitude(std::string_view mantissa, int64_t exponent) noexcept {
    const size_t point = std::min(mantissa.find('.'), mantissa.size());
    const size_t leading = mantissa.find_first_of("123456789");
    if (leading == std::string_view::npos) {
        return std::numeric_limits<int64_t>::min();
    }
    const auto place =
        static_cast<int64_t>(point) - static_cast<int64_t>(leading) - (leading < point ? 1 : 0);
    return place + std::clamp<int64_t>(exponent, -1'000'000'000, 1'000'000'000);
}

// Whether an out-of-range number is below the smallest double, rather than above the largest.
bool underflows(std::string_view number) noexcept {
    const size_t mark = std::min(number.find_first_of("eE"), number.size());
    int64_t exponent = 0;
    if (mark < number.size()) {
        std::string_view digits = number.substr(mark + 1);
        const bool negative = take_sign(digits);
        if (!parse_integer(digits, exponent)) {
            exponent = std::numeric_limits<int64_t>::max();
        }
        exponent = negative ? -exponent : exponent;
    }
    return magnitude(number.substr(0, mark), exponent) < 0;
}

bool parse_unsigned_real(std::string_view number, double &value) noexcept {
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (end != number.data() + number.size() || error == std::errc::invalid_argument) {
        return false;
    }
    if (error == std::errc::result_out_of_range) {
        value = 0;
        return underflows(number);
    }
    return std::isfinite(value);
}

// The position of the exponent mark D, or the end of the number. find_first_of() would be slower.
size_t mark_of_d(std::string_view number) noexcept {
    return static_cast<size_t>(std::ranges::find_if(number, [](char c) { return c == 'D' || c == 'd'; }) -
                               number.begin());
}

bool parse_with_e(std::string_view number, size_t mark, double &value) {
    std::array<char, 64> usual;
    if (number.size() > usual.size()) {
        std::string copy(number);
        copy[mark] = 'e';
        return parse_unsigned_real(copy, value);
    }
    std::ranges::copy(number, usual.begin());
    usual[mark] = 'e';
    return parse_unsigned_real({usual.data(), number.size()}, value);
}

// Whether char is signed depends on the platform.
bool control(char c) noexcept {
    return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}
bool prints(char c) noexcept {
    return !control(c) && static_cast<unsigned char>(c) < 0x80;
}

} // namespace

std::string_view trim(std::string_view text) noexcept {
    const size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::string excerpt(std::string_view text) {
    constexpr size_t longest = 24;
    std::string result(text.substr(0, longest));
    std::replace_if(
        result.begin(), result.end(), [](char c) { return !prints(c); }, '?');
    return text.size() > longest ? result + "..." : result;
}

std::string printable(std::string_view text) {
    std::string result(text);
    std::replace_if(result.begin(), result.end(), control, '?');
    return result;
}

bool parse_integer(std::string_view text, int64_t &value) noexcept {
    const bool negative = take_sign(text);
    if (text.empty() || !digit(text.front())) {
        return false;
    }
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    value = negative ? -value : value;
    return error == std::errc() && end == text.data() + text.size();
}

bool parse_real(std::string_view text, double &value) {
    const bool negative = take_sign(text);
    if (text.empty() || !(digit(text.front()) || text.front() == '.')) {
        return false;
    }
    const size_t mark = mark_of_d(text);
    const bool valid =
        mark < text.size() ? parse_with_e(text, mark, value) : parse_unsigned_real(text, value);
    value = negative ? -value : value;
    return valid;
}

} // namespace nrb::io::iges

// SPDX-License-Identifier: MIT
#include "io/iges/record.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/text.h"

#include <algorithm>

#include <cmath>

namespace nrb::io::iges {

constexpr int64_t work_of_a_parameter = 200; // it is scanned twice, and converted

// One pass counts the parameters, so that counts stated inside an entity can be checked before anything is
// allocated.
Record::Record(std::string text, Delimiters delimiters) : text_(std::move(text)), delimiters_(delimiters) {
    size_t at = 0;
    for (bool more = true; more; ++at) {
        count_work(work_of_a_parameter);
        (void)scan(at);
        ++count_;
        if (at >= text_.size()) {
            fail(Status::syntax, "the record delimiter '%c' is missing after %lld parameters",
                 delimiters_.record, static_cast<long long>(count_));
        }
        more = text_[at] != delimiters_.record;
    }
}

size_t Record::skip_blanks(size_t at) const noexcept {
    while (at < text_.size() && text_[at] == ' ') {
        ++at;
    }
    return at;
}

// Leaves `at` on the delimiter that ends the parameter.
Record::Parameter Record::scan(size_t &at) const {
    at = skip_blanks(at);
    size_t digits_end = at; // find_first_not_of() would be slower
    while (digits_end < text_.size() && text_[digits_end] >= '0' && text_[digits_end] <= '9') {
        ++digits_end;
    }
    if (digits_end > at && digits_end < text_.size() && text_[digits_end] == 'H') {
        int64_t length = 0;
        const std::string_view digits = std::string_view(text_).substr(at, digits_end - at);
        const auto left = static_cast<int64_t>(text_.size() - digits_end - 1);
        if (!parse_integer(digits, length) || length > left) {
            fail(Status::syntax, "parameter %lld: a string of %s characters where %lld are left",
                 static_cast<long long>(count_ + 1), excerpt(digits).c_str(), static_cast<long long>(left));
        }
        at = digits_end + 1;
        return scan_string(at, static_cast<size_t>(length));
    }
    const size_t start = at;
    at = digits_end;
    while (at < text_.size() && text_[at] != delimiters_.parameter && text_[at] != delimiters_.record) {
        ++at;
    }
    return {trim(std::string_view(text_).substr(start, at - start)), false};
}

Record::Parameter Record::scan_string(size_t &at, size_t length) const {
    const std::string_view content = std::string_view(text_).substr(at, length);
    at = skip_blanks(at + length);
    if (at < text_.size() && text_[at] != delimiters_.parameter && text_[at] != delimiters_.record) {
        fail(Status::syntax, "'%s' where a delimiter was expected after a string of %lld characters",
             excerpt(std::string_view(text_).substr(at)).c_str(), static_cast<long long>(length));
    }
    return {content, true};
}

Record::Parameter Record::take() {
    if (taken_ == count_) {
        return {{}, false};
    }
    const Parameter parameter = scan(at_);
    ++at_;
    ++taken_;
    return parameter;
}

void Record::fail_value(const Parameter &parameter, const char *what, int64_t index,
                        const char *expected) const {
    const std::string place = index < 0 ? std::string() : "[" + std::to_string(index) + "]";
    fail(Status::syntax, "%s%s (parameter %lld) is '%s', expected %s", what, place.c_str(),
         static_cast<long long>(taken_), excerpt(parameter.text).c_str(), expected);
}

namespace {

// Some programs write integers as reals: "3.".
bool parse_whole(std::string_view text, int64_t &value) {
    constexpr double limit = 1e15; // below this, every integer is exact as a double
    double real = 0;
    if (!parse_real(text, real) || std::abs(real) > limit || real != std::trunc(real)) {
        return false;
    }
    value = static_cast<int64_t>(real);
    return true;
}

} // namespace

int64_t Record::integer(const char *what, int64_t index) {
    const Parameter parameter = take();
    int64_t value = 0;
    if (parameter.is_string || (!parameter.text.empty() && !parse_integer(parameter.text, value) &&
                                !parse_whole(parameter.text, value))) {
        fail_value(parameter, what, index, "an integer");
    }
    return value;
}

double Record::real(const char *what, int64_t index) {
    const Parameter parameter = take();
    double value = 0;
    if (parameter.is_string || (!parameter.text.empty() && !parse_real(parameter.text, value))) {
        fail_value(parameter, what, index, "a number within double precision");
    }
    return value;
}

std::string_view Record::string(const char *what) {
    const Parameter parameter = take();
    if (!parameter.is_string && !parameter.text.empty()) {
        fail_value(parameter, what, -1, "a string");
    }
    return parameter.text;
}

void Record::skip(int64_t times) {
    for (int64_t i = 0; i < times && remaining() > 0; ++i) {
        (void)take();
    }
}

bool Record::next_is_blank() const {
    size_t at = at_;
    return taken_ == count_ || scan(at).text.empty();
}

} // namespace nrb::io::iges

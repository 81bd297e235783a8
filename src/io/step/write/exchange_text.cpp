// SPDX-License-Identifier: MIT
#include "io/step/write/exchange_text.h"

#include "io/step/structure/text.h"
#include "io/written/real_text.h"

#include <charconv>

namespace nrb::io::step {
namespace {

constexpr size_t longest_line = 72;

} // namespace

void ExchangeText::begin(int64_t number) {
    line_ = text_.size();
    text_ += '#';
    append_integer(number);
    text_ += '=';
    count_work(64);
}

void ExchangeText::end() {
    text_ += ";\n";
}

int64_t ExchangeText::begin_complex() {
    const int64_t number = reserve();
    begin(number);
    text_ += '(';
    return number;
}

void ExchangeText::end_complex() {
    text_ += ')';
    end();
}

void ExchangeText::open_list() {
    text_ += '(';
    first_ = true;
}

void ExchangeText::close_list() {
    text_ += ')';
    first_ = false;
}

void ExchangeText::separate() {
    if (first_) {
        first_ = false;
        return;
    }
    text_ += ',';
    if (text_.size() - line_ > longest_line) {
        text_ += '\n';
        line_ = text_.size();
        count_work(64);
    }
}

void ExchangeText::append_integer(int64_t value) {
    char digits[24];
    text_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void ExchangeText::attribute(Text text) {
    separate();
    text_ += '\'';
    append_encoded(text.utf8, text_);
    text_ += '\'';
}

void ExchangeText::attribute(Ref reference) {
    separate();
    text_ += '#';
    append_integer(reference.number);
}

void ExchangeText::attribute(Word word) {
    separate();
    text_ += word.text;
}

void ExchangeText::attribute(const Measure &measure) {
    separate();
    text_ += measure.type;
    open_list();
    attribute(measure.value);
    close_list();
}

void ExchangeText::attribute(int64_t value) {
    separate();
    append_integer(value);
}

void ExchangeText::attribute(double value) {
    separate();
    append_real(value, text_);
}

} // namespace nrb::io::step

/* SPDX-License-Identifier: MIT */
#include "check.h"

#include "recorded/outputs.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <ostream>

namespace recorded {

namespace {

// A line is words with a space between.
std::string one_word(std::string text) {
    std::replace(text.begin(), text.end(), ' ', '_');
    return text;
}

std::string hex_of(uint64_t bits) {
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(bits));
    return text;
}

} // namespace

void Record::start(const Plan &plan) {
    plan_ = plan;
    shown_.clear();
}

// Every section begins with the same message.
void Record::section(const std::string &name, const std::function<void()> &body) {
    section_ = one_word(name);
    if (plan_.sections && !std::regex_search(section_, *plan_.sections)) {
        return;
    }
    if (plan_.again) {
        body();
    }
    check_forget();
    on_ = true;
    body();
    on_ = false;
    write_lines();
}

bool Record::shows(const char *function) {
    if (!plan_.values) {
        return false;
    }
    const auto [place, added] = shown_.try_emplace(function);
    if (added) {
        place->second = std::regex_search(place->first, *plan_.values);
    }
    return place->second;
}

void Record::begin_values(const char *function, const char *output) {
    *plan_.out << section_ << ' ' << function << ' ' << output << " =";
}

void Record::value(double value) {
    char text[40];
    std::snprintf(text, sizeof text, " %a", value);
    *plan_.out << text;
}

void Record::value(float value) {
    this->value(static_cast<double>(value));
}

void Record::value(int64_t value) {
    *plan_.out << ' ' << value;
}

void Record::end_values() {
    *plan_.out << '\n';
}

// Arrays stand in the order of their functions.
void Record::write_lines() {
    Argument *array = std::begin(arrays);
    for (Function &function : functions) {
        write_line(function.name, "return", function.result);
        write_line(function.name, "message", function.message);
        for (; array != std::end(arrays) && std::strcmp(array->function, function.name) == 0; ++array) {
            write_line(function.name, array->name, array->tally);
        }
    }
}

// And begins a new tally.
void Record::write_line(const char *function, const char *output, Tally &tally) {
    if (tally.count > 0) {
        *plan_.out << section_ << ' ' << function << ' ' << output << ' ' << tally.count << ' '
                   << hex_of(tally.hash) << '\n';
    }
    tally = {};
}

} // namespace recorded

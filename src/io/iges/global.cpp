// SPDX-License-Identifier: MIT
#include "io/iges/global.h"

#include "base/error.h"
#include "io/iges/text.h"
#include "io/iges/units.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace nrb::io::iges {
namespace {

double metres_of_name(std::string_view name) {
    std::string upper(trim(name));
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    const auto *const found = std::ranges::find(units, std::string_view(upper), &Unit::name);
    return found != std::end(units) ? found->metres : 0;
}

// The rules of the unit flag; the name counts only if the flag is 3 or omitted.
double metres_of(int64_t flag, std::string_view name) {
    if (flag == flag_by_name || (flag == 0 && !trim(name).empty())) {
        return metres_of_name(name);
    }
    const Unit *const unit = unit_of_flag(flag == 0 ? inch_flag : flag);
    return unit != nullptr ? unit->metres : 0;
}

std::string joined(const Lines &lines) {
    std::string text;
    text.reserve(lines.size() * data_columns);
    for (const std::string_view line : lines) {
        text += line.substr(0, data_columns);
    }
    return text;
}

// A delimiter must not be a character that numbers and strings need.
char checked_delimiter(char c, const char *what) {
    constexpr std::string_view taken = " 0123456789+-.DEH";
    if (c < ' ' || c > '~' || taken.find(c) != std::string_view::npos) {
        fail(Status::syntax, "global section: '%s' cannot be the %s",
             excerpt(std::string_view(&c, 1)).c_str(), what);
    }
    return c;
}

// The first two parameters are strings of length 1 that define the delimiters by which they are themselves
// separated; a blank one keeps the default.
char read_delimiter(std::string_view text, size_t &at, char fallback, const char *what) {
    at = std::min(text.find_first_not_of(' ', at), text.size());
    if (text.substr(at, 2) != "1H" || at + 2 >= text.size()) {
        return fallback;
    }
    at += 3;
    return checked_delimiter(text[at - 1], what);
}

void expect_delimiter(std::string_view text, size_t &at, Delimiters delimiters) {
    at = std::min(text.find_first_not_of(' ', at), text.size());
    const bool found =
        at < text.size() && (text[at] == delimiters.parameter || text[at] == delimiters.record);
    if (!found) {
        fail(Status::syntax, "global section, column %lld of its text: '%s' where a delimiter was expected",
             static_cast<long long>(at + 1), excerpt(text.substr(at, 8)).c_str());
    }
}

// An empty record is valid: every parameter has a default.
Delimiters read_delimiters(std::string_view text) {
    Delimiters result;
    size_t at = 0;
    result.parameter = read_delimiter(text, at, result.parameter, "parameter delimiter");
    expect_delimiter(text, at, result);
    if (text[at] == result.parameter) {
        ++at;
        result.record = read_delimiter(text, at, result.record, "record delimiter");
        expect_delimiter(text, at, result);
    }
    if (result.parameter == result.record) {
        fail(Status::syntax, "global section: parameter and record delimiter are both '%c'",
             result.parameter);
    }
    return result;
}

// An invalid resolution counts as not stated: it is not important enough to refuse the file.
double read_resolution(Record &record) {
    try {
        const double value = record.real("global section: resolution");
        return value > 0 ? value : 0;
    } catch (const Error &) {
        return 0;
    }
}

} // namespace

Global read_global(const Lines &lines) {
    std::string text = joined(lines);
    Global global;
    global.delimiters = read_delimiters(text);
    Record record(std::move(text), global.delimiters);
    record.skip(2); // delimiters
    global.product = printable(trim(record.string("global section: product")));
    record.skip(2); // file and system
    global.all_digits = record.string("global section: preprocessor") == own_preprocessor;
    record.skip(6); // digits of numbers, recipient
    const bool unscaled = record.next_is_blank();
    const double given = record.real("global section: model space scale");
    const double scale = unscaled ? 1.0 : given;
    if (!(scale > 0)) {
        fail(Status::syntax, "global section: model space scale %s where a positive number was expected",
             Number(scale).text);
    }
    const int64_t flag = record.integer("global section: unit flag");
    const std::string_view name = record.string("global section: unit name");
    // The scale is model space to real world: 0.125 means that 1 in the file stands for 8 units.
    const double unit = metres_of(flag, name);
    global.metres_per_unit = unit / scale;
    if (unit > 0 && !std::isnormal(global.metres_per_unit)) {
        fail(Status::syntax, "global section: model space scale %s is out of range", Number(scale).text);
    }
    record.skip(3); // line weights, date
    global.resolution = read_resolution(record);
    return global;
}

} // namespace nrb::io::iges

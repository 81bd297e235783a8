// SPDX-License-Identifier: MIT
#include "io/formats.h"

#include "base/error.h"
#include "io/iges/lines.h"
#include "io/iges/read_iges.h"
#include "io/iges/read_model.h"
#include "io/step/read_model.h"
#include "io/step/read_step.h"
#include "io/step/structure/exchange.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace nrb::io {

namespace {

// STEP is tried first: its files begin with a word of their own, but a long line of STEP may happen to have a
// section letter of IGES in column 73.
constexpr Format known[] = {
    {"STEP", step::begins_step, read_step, read_step_model},
    {"IGES", iges::begins_iges, read_iges, read_iges_model},
    {"compressed IGES", iges::begins_compressed, nullptr, nullptr},
};

void check_settings(std::span<const char> bytes, const ReadSettings &settings) {
    if (!std::isfinite(settings.unit) || settings.unit < 0) {
        fail(Status::options, "unit = %s, expected metres > 0, or 0 for the unit of the file",
             Number(settings.unit).text);
    }
    if (std::ssize(bytes) > settings.max_bytes) {
        fail(Status::too_large, "%lld bytes where %lld are the most allowed",
             static_cast<long long>(bytes.size()), static_cast<long long>(settings.max_bytes));
    }
}

[[noreturn]] void fail_unknown(std::span<const char> bytes) {
    if (iges::first_line(bytes).empty()) {
        fail(Status::format, "the file is empty");
    }
    fail(Status::format,
         "line 1: no section letter S in column 73, so this is not fixed-length ASCII IGES, and it "
         "begins like no other format that is known");
}

const Format &format_of(std::span<const char> bytes, const ReadSettings &settings) {
    check_settings(bytes, settings);
    const auto *const format =
        std::ranges::find_if(known, [&](const Format &candidate) { return candidate.recognizes(bytes); });
    if (format == std::end(known)) {
        fail_unknown(bytes);
    }
    return *format;
}

} // namespace

std::span<const Format> formats() noexcept {
    return known;
}

model::Model read(std::span<const char> bytes, const ReadSettings &settings) {
    const Format &format = format_of(bytes, settings);
    if (format.read == nullptr) {
        fail(Status::format,
             "line 1: this is a %s file, which is not read; fixed-length ASCII IGES and STEP are",
             format.name);
    }
    return format.read(bytes, settings);
}

model::Model read_model(std::span<const char> bytes, const ReadSettings &settings) {
    const Format &format = format_of(bytes, settings);
    if (format.read_model == nullptr) {
        fail(Status::format,
             "line 1: this is a %s file, of which faces are not read; of IGES and STEP they are",
             format.name);
    }
    return format.read_model(bytes, settings);
}

} // namespace nrb::io

// SPDX-License-Identifier: MIT
// Reads the curves and surfaces of files into lists.
#include "checks.h"
#include "guard.h"
#include "read_settings.h"
#include "structs.h"

#include "base/error.h"
#include "io/file.h"
#include "io/formats.h"

#include <cmath>
#include <cstddef>

using namespace nrb;
using namespace nrb::capi;

namespace nrb::capi {

namespace {

// The size of the struct in the first release; no caller has a smaller one.
constexpr int64_t smallest_options = offsetof(nurbs_read_options, max_bytes) + sizeof(int64_t);

double tolerance_of(const nurbs_read_options &options) {
    constexpr int64_t end = offsetof(nurbs_read_options, tolerance) + sizeof(double);
    const double tolerance = options.struct_size < end ? 0 : options.tolerance;
    if (!std::isfinite(tolerance) || tolerance < 0) {
        fail(Status::options, "options: tolerance = %s, expected a finite value >= 0",
             Number(tolerance).text);
    }
    return tolerance;
}

uint32_t kinds_of(const nurbs_read_options &options) {
    constexpr int64_t end = offsetof(nurbs_read_options, reserved) + sizeof(uint32_t);
    if (options.struct_size < end) {
        return io::all_kinds;
    }
    if ((options.kinds & ~io::all_kinds) != 0 || options.reserved != 0) {
        fail(Status::options, "options: kinds = 0x%x and reserved = %u, expected bits of 0x%x and 0",
             options.kinds, options.reserved, io::all_kinds);
    }
    return options.kinds == 0 ? io::all_kinds : options.kinds;
}

} // namespace

io::ReadSettings settings_of(const nurbs_read_options *options) {
    if (options == nullptr) {
        return {};
    }
    checked_struct("options", options, smallest_options);
    if (!std::isfinite(options->unit) || options->unit < 0) {
        fail(Status::options, "options: unit = %s, expected a finite value >= 0", Number(options->unit).text);
    }
    if (options->max_bytes < 0) {
        fail(Status::options, "options: max_bytes = %lld, expected >= 0",
             static_cast<long long>(options->max_bytes));
    }
    const int64_t limit = options->max_bytes == 0 ? io::ReadSettings().max_bytes : options->max_bytes;
    return {options->unit, limit, tolerance_of(*options), kinds_of(*options)};
}

std::span<const char> checked_text(const void *bytes, int64_t size) {
    check_length(size, "size");
    if (size > 0) {
        require(bytes, "bytes");
    }
    return {static_cast<const char *>(bytes), static_cast<size_t>(size)};
}

} // namespace nrb::capi

nurbs_status nurbs_read_options_init(nurbs_read_options *options, int64_t struct_size) {
    return guard([&] {
        clear_struct("options", options, struct_size, smallest_options);
        const io::ReadSettings defaults;
        options->unit = defaults.unit;
        options->max_bytes = defaults.max_bytes;
    });
}

nurbs_status nurbs_read(const void *bytes, int64_t size, const nurbs_read_options *options,
                        nurbs_list **out) {
    return guard([&] {
        require_out(out);
        *out = new nurbs_list{io::read(checked_text(bytes, size), settings_of(options))};
    });
}

nurbs_status nurbs_read_file(const char *path, const nurbs_read_options *options, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        require(path, "path");
        const io::ReadSettings settings = settings_of(options);
        const std::vector<char> bytes = io::read_whole_file(path, settings.max_bytes);
        *out = new nurbs_list{io::read(bytes, settings)};
    });
}

// Reading files, and the lists that come of it.
#include "checks.h"
#include "guard.h"

#include "base/error.h"
#include "io/file.h"
#include "io/iges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>

using namespace nrb;
using namespace nrb::capi;

namespace {

// Size of the struct in the first release: a caller never knows less.
constexpr int64_t smallest_options = offsetof(nurbs_read_options, max_bytes) + sizeof(int64_t);

// No release will have a larger one; a size beyond is garbage rather than a newer header.
constexpr int64_t largest_options = 4096;

void check_options_size(int64_t size) {
    if (size < smallest_options || size > largest_options) {
        fail(NURBS_ERROR_OPTIONS, "options: struct_size = %lld, expected %lld to %lld",
             static_cast<long long>(size), static_cast<long long>(smallest_options),
             static_cast<long long>(largest_options));
    }
}

// A caller built against a newer header may pass fields that this library does not know; they must be zero.
void check_unknown_fields(const nurbs_read_options &options) {
    const auto *bytes = reinterpret_cast<const unsigned char *>(&options);
    const auto known = static_cast<int64_t>(sizeof options);
    if (std::any_of(bytes + known, bytes + std::max(known, options.struct_size),
                    [](unsigned char byte) { return byte != 0; })) {
        fail(NURBS_ERROR_OPTIONS, "options: fields beyond byte %lld are unknown to this version and not zero",
             static_cast<long long>(known));
    }
}

ReadSettings settings_of(const nurbs_read_options *options) {
    if (options == nullptr) {
        return {};
    }
    check_options_size(options->struct_size);
    check_unknown_fields(*options);
    if (!std::isfinite(options->unit) || options->unit < 0) {
        fail(NURBS_ERROR_OPTIONS, "options: unit = %s, expected a finite value >= 0",
             Number(options->unit).text);
    }
    if (options->max_bytes < 0) {
        fail(NURBS_ERROR_OPTIONS, "options: max_bytes = %lld, expected >= 0",
             static_cast<long long>(options->max_bytes));
    }
    const int64_t limit = options->max_bytes == 0 ? ReadSettings().max_bytes : options->max_bytes;
    return {options->unit, limit};
}

const Document &document_of(const nurbs_list *list) {
    require(list, "list");
    return list->document;
}

template <class T>
const T &item_of(const std::vector<T> &items, int64_t index) {
    if (index < 0 || index >= static_cast<int64_t>(items.size())) {
        fail(NURBS_ERROR_INDEX, "index = %lld, expected 0 to %lld", static_cast<long long>(index),
             static_cast<long long>(items.size()) - 1);
    }
    return items[static_cast<size_t>(index)];
}

void check_buffer(const char *buf, int64_t cap) {
    check_length(cap, "cap");
    if (cap > 0) {
        require(buf, "buf");
    }
}

void copy_text(const std::string &text, char *buf, int64_t cap, int64_t *length) noexcept {
    if (cap > 0) {
        const auto copied = std::min(static_cast<int64_t>(text.size()), cap - 1);
        std::memcpy(buf, text.data(), static_cast<size_t>(copied));
        buf[copied] = '\0';
    }
    if (length != nullptr) {
        *length = static_cast<int64_t>(text.size());
    }
}

template <class T>
void store_if(T *target, T value) noexcept {
    if (target != nullptr) {
        *target = value;
    }
}

} // namespace

nurbs_status nurbs_read_options_init(nurbs_read_options *options, int64_t struct_size) {
    return guard([&] {
        require(options, "options");
        check_options_size(struct_size);
        const ReadSettings defaults;
        // Fields of a newer header too: zero asks for nothing new.
        std::fill_n(reinterpret_cast<unsigned char *>(options), struct_size, static_cast<unsigned char>(0));
        options->struct_size = struct_size;
        options->unit = defaults.unit;
        options->max_bytes = defaults.max_bytes;
    });
}

nurbs_status nurbs_read(const void *bytes, int64_t size, const nurbs_read_options *options,
                        nurbs_list **out) {
    return guard([&] {
        require_out(out);
        check_length(size, "size");
        if (size > 0) {
            require(bytes, "bytes");
        }
        const std::span<const char> text(static_cast<const char *>(bytes), static_cast<size_t>(size));
        *out = new nurbs_list{read_iges(text, settings_of(options))};
    });
}

nurbs_status nurbs_read_file(const char *path, const nurbs_read_options *options, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        require(path, "path");
        const ReadSettings settings = settings_of(options);
        const std::vector<char> bytes = read_whole_file(path, settings.max_bytes);
        *out = new nurbs_list{read_iges(bytes, settings)};
    });
}

nurbs_status nurbs_list_count(const nurbs_list *list, int64_t *count) {
    return guard([&] {
        const Document &document = document_of(list);
        require(count, "count");
        *count = static_cast<int64_t>(document.splines.size());
    });
}

nurbs_status nurbs_list_get(const nurbs_list *list, int64_t index, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(item_of(document_of(list).splines, index).spline, out);
    });
}

nurbs_status nurbs_list_name(const nurbs_list *list, int64_t index, char *buf, int64_t cap, int64_t *length) {
    return guard([&] {
        const NamedSpline &item = item_of(document_of(list).splines, index);
        check_buffer(buf, cap);
        copy_text(item.name, buf, cap, length);
    });
}

nurbs_status nurbs_list_note_count(const nurbs_list *list, int64_t *count) {
    return guard([&] {
        const Document &document = document_of(list);
        require(count, "count");
        *count = static_cast<int64_t>(document.notes.size());
    });
}

nurbs_status nurbs_list_note(const nurbs_list *list, int64_t index, int32_t *entity_type, int64_t *line,
                             nurbs_status *reason, char *buf, int64_t cap, int64_t *length) {
    return guard([&] {
        const Note &note = item_of(document_of(list).notes, index);
        check_buffer(buf, cap);
        store_if(entity_type, int32_t{note.entity_type});
        store_if(line, note.line);
        store_if(reason, note.reason);
        copy_text(note.text, buf, cap, length);
    });
}

nurbs_status nurbs_list_unit(const nurbs_list *list, double *metres) {
    return guard([&] {
        const Document &document = document_of(list);
        require(metres, "metres");
        *metres = document.metres_per_unit;
    });
}

void nurbs_list_destroy(nurbs_list *list) {
    delete list;
}

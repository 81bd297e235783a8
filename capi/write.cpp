// SPDX-License-Identifier: MIT
// Writes models, lists and meshes to memory and to files.
#include "bytes.h"
#include "checks.h"
#include "guard.h"
#include "lists.h"
#include "structs.h"
#include "watched.h"

#include "base/error.h"
#include "io/file.h"
#include "io/mesh_formats/write_meshes.h"
#include "io/writers.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

using namespace nrb;
using namespace nrb::capi;

namespace {

constexpr int64_t smallest_write_options = offsetof(nurbs_write_options, tolerance) + sizeof(double);

void check_setting(const char *name, double value) {
    if (!std::isfinite(value) || value < 0) {
        fail(Status::options, "options: %s = %s, expected a finite value >= 0", name, Number(value).text);
    }
}

io::WriteSettings settings_of(const nurbs_write_options *options) {
    if (options == nullptr) {
        return {};
    }
    checked_struct("options", options, smallest_write_options);
    check_setting("unit", options->unit);
    check_setting("tolerance", options->tolerance);
    return {options->unit, options->tolerance};
}

void write_bytes(const model::Model &model, int32_t format, const nurbs_write_options *options, int64_t cap,
                 void *bytes, int64_t *length) {
    check_length(cap, "cap");
    const std::string text = io::write(model, format, settings_of(options));
    give_bytes(text.size(), cap, bytes, length,
               [&](std::span<unsigned char> out) { std::memcpy(out.data(), text.data(), text.size()); });
}

void write_file(const model::Model &model, const char *path, int32_t format,
                const nurbs_write_options *options) {
    io::write_whole_file(path, io::write(model, format, settings_of(options)));
}

// Copies the blocks that a source yields, one after the other.
void fill(std::span<unsigned char> out, const io::ByteSource &source) {
    source([&out](std::string_view block) {
        std::memcpy(out.data(), block.data(), block.size());
        out = out.subspan(block.size());
    });
}

// A watched call, which may end early, writes to the caller's array only when all bytes are known. Others write
// there at once, since a mesh may be large.
void fill_whole(std::span<unsigned char> out, const io::ByteSource &source) {
    if (Watch::current() == nullptr) {
        return fill(out, source);
    }
    std::vector<unsigned char> whole(out.size());
    fill(whole, source);
    std::ranges::copy(whole, out.begin());
}

io::ByteSource source_of(const nurbs_mesh *mesh, int32_t format, const nurbs_write_options *options) {
    return io::mesh_source(*mesh->mesh, format, settings_of(options));
}

} // namespace

nurbs_status nurbs_write_options_init(nurbs_write_options *options, int64_t struct_size) {
    return guard([&] {
        clear_struct("options", options, struct_size, smallest_write_options);
        const io::WriteSettings defaults;
        options->unit = defaults.unit;
        options->tolerance = defaults.tolerance;
    });
}

nurbs_status nurbs_model_write(const nurbs_model *model, int32_t format, const nurbs_write_options *options,
                               int64_t cap, void *bytes, int64_t *length) {
    return guard([&] {
        require(model, "model");
        write_bytes(*model->model, format, options, cap, bytes, length);
    });
}

nurbs_status nurbs_model_write_with(const nurbs_model *model, int32_t format,
                                    const nurbs_write_options *options, int64_t cap, void *bytes,
                                    int64_t *length, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_model_write(model, format, options, cap, bytes, length); });
}

nurbs_status nurbs_model_write_file(const nurbs_model *model, const char *path, int32_t format,
                                    const nurbs_write_options *options) {
    return guard([&] {
        require(model, "model");
        require(path, "path");
        write_file(*model->model, path, format, options);
    });
}

nurbs_status nurbs_model_write_file_with(const nurbs_model *model, const char *path, int32_t format,
                                         const nurbs_write_options *options, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_model_write_file(model, path, format, options); });
}

nurbs_status nurbs_list_write(const nurbs_list *list, int32_t format, const nurbs_write_options *options,
                              int64_t cap, void *bytes, int64_t *length) {
    return guard([&] {
        require(list, "list");
        model::Model room;
        write_bytes(contents_of(list, room), format, options, cap, bytes, length);
    });
}

nurbs_status nurbs_list_write_with(const nurbs_list *list, int32_t format, const nurbs_write_options *options,
                                   int64_t cap, void *bytes, int64_t *length,
                                   const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_list_write(list, format, options, cap, bytes, length); });
}

nurbs_status nurbs_list_write_file(const nurbs_list *list, const char *path, int32_t format,
                                   const nurbs_write_options *options) {
    return guard([&] {
        require(list, "list");
        require(path, "path");
        model::Model room;
        write_file(contents_of(list, room), path, format, options);
    });
}

nurbs_status nurbs_list_write_file_with(const nurbs_list *list, const char *path, int32_t format,
                                        const nurbs_write_options *options, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_list_write_file(list, path, format, options); });
}

nurbs_status nurbs_mesh_write(const nurbs_mesh *mesh, int32_t format, const nurbs_write_options *options,
                              int64_t cap, void *bytes, int64_t *length) {
    return guard([&] {
        require(mesh, "mesh");
        check_length(cap, "cap");
        const io::ByteSource source = source_of(mesh, format, options);
        const int64_t size = io::size_of(source);
        give_bytes(static_cast<size_t>(size), cap, bytes, length,
                   [&](std::span<unsigned char> out) { fill_whole(out, source); });
    });
}

nurbs_status nurbs_mesh_write_with(const nurbs_mesh *mesh, int32_t format, const nurbs_write_options *options,
                                   int64_t cap, void *bytes, int64_t *length,
                                   const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_mesh_write(mesh, format, options, cap, bytes, length); });
}

nurbs_status nurbs_mesh_write_file(const nurbs_mesh *mesh, const char *path, int32_t format,
                                   const nurbs_write_options *options) {
    return guard([&] {
        require(mesh, "mesh");
        require(path, "path");
        io::write_whole_file(path, source_of(mesh, format, options));
    });
}

nurbs_status nurbs_mesh_write_file_with(const nurbs_mesh *mesh, const char *path, int32_t format,
                                        const nurbs_write_options *options, const nurbs_call_options *call) {
    return watched(call, [&] { return nurbs_mesh_write_file(mesh, path, format, options); });
}

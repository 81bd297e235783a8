// SPDX-License-Identifier: MIT
// Serialization: handles as bytes, and back.
#include "bytes.h"

#include "guard.h"

#include "io/binary/face_bytes.h"
#include "io/binary/list_bytes.h"
#include "io/binary/model_bytes.h"
#include "io/binary/spline_bytes.h"
#include "lists.h"

namespace nrb::capi {

std::span<const unsigned char> checked_bytes(const void *bytes, int64_t size) {
    check_length(size, "size");
    if (size > 0) {
        require(bytes, "bytes");
    }
    return {static_cast<const unsigned char *>(bytes), static_cast<size_t>(size)};
}

} // namespace nrb::capi

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_to_bytes(const nurbs *g, int64_t cap, void *bytes, int64_t *length) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        give_bytes(io::size_in_bytes(spline), cap, bytes, length,
                   [&](std::span<unsigned char> out) { io::write_bytes(spline, out); });
    });
}

nurbs_status nurbs_from_bytes(const void *bytes, int64_t size, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(io::spline_from(checked_bytes(bytes, size)), out);
    });
}

nurbs_status nurbs_list_to_bytes(const nurbs_list *list, int64_t cap, void *bytes, int64_t *length) {
    return guard([&] {
        model::Model room;
        const io::ListBytes form(contents_of(list, room));
        give_bytes(form.size(), cap, bytes, length, [&](std::span<unsigned char> out) { form.write(out); });
    });
}

nurbs_status nurbs_list_from_bytes(const void *bytes, int64_t size, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        *out = new nurbs_list{io::list_from(checked_bytes(bytes, size))};
    });
}

nurbs_status nurbs_face_to_bytes(const nurbs_face *face, int64_t cap, void *bytes, int64_t *length) {
    return guard([&] {
        require(face, "face");
        const io::FaceBytes form(*face->face);
        give_bytes(form.size(), cap, bytes, length, [&](std::span<unsigned char> out) { form.write(out); });
    });
}

nurbs_status nurbs_face_from_bytes(const void *bytes, int64_t size, nurbs_face **out) {
    return guard([&] {
        require_out(out);
        *out = new nurbs_face{io::face_from(checked_bytes(bytes, size))};
    });
}

nurbs_status nurbs_model_to_bytes(const nurbs_model *model, int64_t cap, void *bytes, int64_t *length) {
    return guard([&] {
        require(model, "model");
        const io::ModelBytes form(*model->model);
        give_bytes(form.size(), cap, bytes, length, [&](std::span<unsigned char> out) { form.write(out); });
    });
}

nurbs_status nurbs_model_from_bytes(const void *bytes, int64_t size, nurbs_model **out) {
    return guard([&] {
        require_out(out);
        *out =
            new nurbs_model{std::make_shared<const model::Model>(io::model_from(checked_bytes(bytes, size)))};
    });
}

nurbs_status nurbs_bytes_kind(const void *bytes, int64_t size, int32_t *kind, int32_t *major,
                              int32_t *minor) {
    return guard([&] {
        const io::Header header = io::read_kind(checked_bytes(bytes, size));
        check_apart({memory("kind", kind, 1), memory("major", major, 1), memory("minor", minor, 1)}, {});
        put(kind, static_cast<int32_t>(header.kind));
        put(major, int32_t{header.major});
        put(minor, int32_t{header.minor});
    });
}

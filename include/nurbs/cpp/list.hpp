/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file list.hpp
/// \brief Files: the splines that one held, their names, and notes on the rest; and writing them.
#ifndef NURBS_CPP_LIST_HPP
#define NURBS_CPP_LIST_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Kinds of handles that bytes hold.
inline constexpr std::int32_t bytes_spline = NURBS_BYTES_SPLINE;
inline constexpr std::int32_t bytes_list = NURBS_BYTES_LIST;
inline constexpr std::int32_t bytes_statistics = NURBS_BYTES_STATISTICS;
inline constexpr std::int32_t bytes_face = NURBS_BYTES_FACE;
inline constexpr std::int32_t bytes_model = NURBS_BYTES_MODEL;

/// Formats of files that are written.
inline constexpr std::int32_t format_step = NURBS_FORMAT_STEP;
inline constexpr std::int32_t format_iges = NURBS_FORMAT_IGES;
inline constexpr std::int32_t format_stl = NURBS_FORMAT_STL;
inline constexpr std::int32_t format_stl_text = NURBS_FORMAT_STL_TEXT;
inline constexpr std::int32_t format_obj = NURBS_FORMAT_OBJ;
inline constexpr std::int32_t format_ply = NURBS_FORMAT_PLY;
inline constexpr std::int32_t format_glb = NURBS_FORMAT_GLB;
inline constexpr std::int32_t format_vtu = NURBS_FORMAT_VTU;

/// What files are read for.
inline constexpr std::uint32_t read_curves = NURBS_READ_CURVES;
inline constexpr std::uint32_t read_surfaces = NURBS_READ_SURFACES;
inline constexpr std::uint32_t read_faces = NURBS_READ_FACES;

/// Settings of List::read(), initialised to the defaults. Later versions of this header may know more of
/// them: where libraries that were compiled with two versions meet in one program, each has to say its own
/// size, and none the other's.
struct ReadOptions : nurbs_read_options {
    [[gnu::always_inline]] ReadOptions() : nurbs_read_options{} {
        detail::call(nurbs_read_options_init, this, static_cast<std::int64_t>(sizeof(nurbs_read_options)));
    }
};

/// Settings of List::write_file() and those like it, initialised to the defaults. Later versions of this
/// header may know more of them: where libraries that were compiled with two versions meet in one program,
/// each has to say its own size, and none the other's.
struct WriteOptions : nurbs_write_options {
    [[gnu::always_inline]] WriteOptions() : nurbs_write_options{} {
        detail::call(nurbs_write_options_init, this, static_cast<std::int64_t>(sizeof(nurbs_write_options)));
    }
};

/// An entity of a file that did not become a spline.
struct Note {
    std::int32_t entity_type; ///< Its number in the format of the file.
    std::int64_t line;        ///< Its line in the directory of the file.
    Status reason;            ///< Why not: a status.
    std::string text;         ///< The same in words.
};

/// What bytes hold, by their header.
struct BytesKind {
    std::int32_t kind;  ///< A bytes_ constant.
    std::int32_t major; ///< Version of the form: a library reads those up to its own.
    std::int32_t minor; ///< What it has in addition.
};

/// Of which kind bytes are, and in which version of the form.
inline Returned<BytesKind> bytes_kind(std::span<const std::byte> bytes) {
    BytesKind found{};
    detail::call(nurbs_bytes_kind, bytes.data(), detail::length(bytes), &found.kind, &found.major,
                 &found.minor);
    return found;
}

/// Splines in an order: the parts of one, or what a file held. It cannot be copied.
class List : public detail::ListHandle {
public:
    using ListHandle::ListHandle;

    // Files: the splines that one held, their names, and notes on the rest; and writing them

    /// Reads the contents of a file from memory.
    [[nodiscard]] static Returned<List> read(std::span<const std::byte> bytes,
                                             const ReadOptions &options = {}) {
        return detail::made<List>(nurbs_read, bytes.data(), detail::length(bytes), &options);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<List> read(std::span<const std::byte> bytes, const ReadOptions &options,
                                             const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<List>(nurbs_read_with, bytes.data(), detail::length(bytes), &options,
                                  watch.get());
    }
    /// Reads a file by its path.
    [[nodiscard]] static Returned<List> read_file(const std::string &path, const ReadOptions &options = {}) {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        return detail::made<List>(nurbs_read_file, path.c_str(), &options);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<List> read_file(const std::string &path, const ReadOptions &options,
                                                  const CallOptions &call) {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        const detail::Watch watch(call);
        return detail::made<List>(nurbs_read_file_with, path.c_str(), &options, watch.get());
    }
    /// A list of splines, with their names, none for "0", "1", ..., and the metres per unit of length, 0 if that
    /// is not known.
    [[nodiscard]] static Returned<List> create(std::span<const Spline> splines,
                                               std::span<const std::string> names = {}, double metres = 0) {
        const std::int64_t count = detail::length(splines);
        detail::require_texts(names, count, "names");
        return detail::made<List>(nurbs_list_create, count, detail::handle_list(splines).data(),
                                  detail::pointer(detail::text_list(names)), metres);
    }
    /// Number of splines.
    [[nodiscard]] Returned<std::int64_t> size() const {
        return detail::result_of<std::int64_t>([&](auto *v) { return nurbs_list_count(get(), v); });
    }
    /// Spline `index`; it outlives the list.
    [[nodiscard]] Returned<Spline> operator[](std::int64_t index) const {
        return detail::made<Spline>(nurbs_list_get, get(), index);
    }
    /// The name of a spline.
    [[nodiscard]] Returned<std::string> name(std::int64_t index) const {
        return detail::text_of([&](char *buf, std::int64_t cap, std::int64_t *length) {
            return nurbs_list_name(get(), index, buf, cap, length);
        });
    }
    /// Number of notes.
    [[nodiscard]] Returned<std::int64_t> note_count() const {
        return detail::result_of<std::int64_t>([&](auto *v) { return nurbs_list_note_count(get(), v); });
    }
    /// A note.
    [[nodiscard]] Returned<Note> note(std::int64_t index) const {
        Note found{};
        nurbs_status reason = NURBS_OK;
        found.text = detail::text_of([&](char *buf, std::int64_t cap, std::int64_t *length) {
            return nurbs_list_note(get(), index, &found.entity_type, &found.line, &reason, buf, cap, length);
        });
        found.reason = static_cast<Status>(reason);
        return found;
    }
    /// Metres per unit of length; 0 if the file does not say.
    [[nodiscard]] Returned<double> unit() const {
        return detail::result_of<double>([&](auto *v) { return nurbs_list_unit(get(), v); });
    }
    /// The list of what to_bytes() made of it.
    [[nodiscard]] static Returned<List> from_bytes(std::span<const std::byte> bytes) {
        return detail::made<List>(nurbs_list_from_bytes, bytes.data(), detail::length(bytes));
    }
    /// Writes the curves and surfaces to a file, which is replaced whole or not at all.
    Returned<void> write_file(const std::string &path, std::int32_t format,
                              const WriteOptions &options = {}) const {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        return detail::call(nurbs_list_write_file, get(), path.c_str(), format, &options);
    }
    /// The same; `call` can watch and end it.
    Returned<void> write_file(const std::string &path, std::int32_t format, const WriteOptions &options,
                              const CallOptions &call) const {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        const detail::Watch watch(call);
        return detail::call(nurbs_list_write_file_with, get(), path.c_str(), format, &options, watch.get());
    }
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_LIST_HPP

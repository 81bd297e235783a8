/* SPDX-License-Identifier: MIT */
/// \file list.hpp
/// \brief Reading files: the splines that a file held, their names, and notes on the rest.
#ifndef NURBS_CPP_LIST_HPP
#define NURBS_CPP_LIST_HPP

#include <nurbs/cpp/arrays.hpp>
#include <nurbs/cpp/spline.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Settings of List::read(), initialised to the defaults. Later versions of this header may know more of them: where
/// libraries that were compiled with two versions meet in one program, each has to say its own size, and none the other's.
struct ReadOptions : nurbs_read_options {
    [[gnu::always_inline]] ReadOptions() : nurbs_read_options{} {
        detail::call(nurbs_read_options_init, this, static_cast<std::int64_t>(sizeof(nurbs_read_options)));
    }
};

/// An entity of a file that did not become a spline.
struct Note {
    std::int32_t entity_type;
    std::int64_t line;
    Status reason;
    std::string text;
};

class List {
public:
    List() noexcept = default;
    explicit List(nurbs_list *owned) noexcept : handle_(owned) {}
    List(const List &) = delete;
    List(List &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    List &operator=(List other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~List() { nurbs_list_destroy(handle_); }

    [[nodiscard]] const nurbs_list *get() const noexcept { return handle_; }
    [[nodiscard]] nurbs_list *release() noexcept { return std::exchange(handle_, nullptr); }

    [[nodiscard]] static Returned<List> read(std::span<const std::byte> bytes,
                                             const ReadOptions &options = {}) {
        List result;
        detail::call(nurbs_read, bytes.data(), detail::length(bytes), &options, &result.handle_);
        return result;
    }
    [[nodiscard]] static Returned<List> read_file(const std::string &path, const ReadOptions &options = {}) {
        List result;
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        detail::call(nurbs_read_file, path.c_str(), &options, &result.handle_);
        return result;
    }

    [[nodiscard]] Returned<std::int64_t> size() const {
        return detail::result_of<std::int64_t>([&](auto *v) { return nurbs_list_count(handle_, v); });
    }
    [[nodiscard]] Returned<Spline> operator[](std::int64_t index) const {
        nurbs *spline = nullptr;
        detail::call(nurbs_list_get, handle_, index, &spline);
        return Spline(spline);
    }
    [[nodiscard]] Returned<std::string> name(std::int64_t index) const {
        return detail::text_of([&](char *buf, std::int64_t cap, std::int64_t *length) {
            return nurbs_list_name(handle_, index, buf, cap, length);
        });
    }
    [[nodiscard]] Returned<std::int64_t> note_count() const {
        return detail::result_of<std::int64_t>([&](auto *v) { return nurbs_list_note_count(handle_, v); });
    }
    [[nodiscard]] Returned<Note> note(std::int64_t index) const {
        Note note{};
        nurbs_status reason = NURBS_OK;
        note.text = detail::text_of([&](char *buf, std::int64_t cap, std::int64_t *length) {
            return nurbs_list_note(handle_, index, &note.entity_type, &note.line, &reason, buf, cap, length);
        });
        note.reason = static_cast<Status>(reason);
        return note;
    }
    /// Metres per unit of length; 0 if the file does not say.
    [[nodiscard]] Returned<double> unit() const {
        return detail::result_of<double>([&](auto *v) { return nurbs_list_unit(handle_, v); });
    }

private:
    nurbs_list *handle_ = nullptr;
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_LIST_HPP

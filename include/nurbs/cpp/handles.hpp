/* SPDX-License-Identifier: MIT */
/// \file handles.hpp
/// \brief What Spline, List, Statistics, Face, Model and Meet are before anything is done with them: owners of a handle.
#ifndef NURBS_CPP_HANDLES_HPP
#define NURBS_CPP_HANDLES_HPP

#include <nurbs/cpp/arrays.hpp>
#include <nurbs/cpp/calls.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

namespace detail {

// What write(handle, cap, bytes, length) says of a handle.
template <class Write, class Handle>
Returned<std::vector<std::byte>> bytes_of(Write &&write, const Handle *handle) {
    std::int64_t length = 0;
    call(write, handle, std::int64_t{0}, nullptr, &length);
    std::vector<std::byte> bytes(static_cast<std::size_t>(length));
    call(write, handle, length, bytes.data(), nullptr);
    return bytes;
}

// What write(handle, format, options, cap, bytes, length, more...) makes of a handle.
template <class Write, class Handle, class... More>
Returned<std::vector<std::byte>> file_of(Write &&write, const Handle *handle, std::int32_t format,
                                         const nurbs_write_options *options, const More &...more) {
    std::int64_t length = 0;
    call(write, handle, format, options, std::int64_t{0}, nullptr, &length, more...);
    std::vector<std::byte> bytes(static_cast<std::size_t>(length));
    call(write, handle, format, options, length, bytes.data(), nullptr, more...);
    return bytes;
}

/// A handle that is copied in constant time and freed by its destructor.
class SplineHandle {
public:
    SplineHandle() noexcept = default;
    explicit SplineHandle(nurbs *owned) noexcept : handle_(owned) {}
    /// Only memory can be missing; where nothing throws, the copy is then empty, and clone() tells.
    SplineHandle(const SplineHandle &other) {
        if (other.handle_ != nullptr) {
            check_copy(nurbs_clone(other.handle_, &handle_));
        }
    }
    SplineHandle(SplineHandle &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    SplineHandle &operator=(SplineHandle other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~SplineHandle() { nurbs_destroy(handle_); }

    [[nodiscard]] const nurbs *get() const noexcept { return handle_; }
    [[nodiscard]] nurbs *release() noexcept { return std::exchange(handle_, nullptr); }

    /// To be kept or sent: the same on every machine for the same spline.
    [[nodiscard]] Returned<std::vector<std::byte>> to_bytes() const {
        return bytes_of(nurbs_to_bytes, handle_);
    }

private:
    nurbs *handle_ = nullptr;
};

/// The same of a list, which is not copied.
class ListHandle {
public:
    ListHandle() noexcept = default;
    explicit ListHandle(nurbs_list *owned) noexcept : handle_(owned) {}
    ListHandle(const ListHandle &) = delete;
    ListHandle(ListHandle &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    ListHandle &operator=(ListHandle other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~ListHandle() { nurbs_list_destroy(handle_); }

    [[nodiscard]] const nurbs_list *get() const noexcept { return handle_; }
    [[nodiscard]] nurbs_list *release() noexcept { return std::exchange(handle_, nullptr); }

    /// To be kept or sent, with names, notes and unit: the same on every machine for the same list.
    [[nodiscard]] Returned<std::vector<std::byte>> to_bytes() const {
        return bytes_of(nurbs_list_to_bytes, handle_);
    }

    /// The contents of a file of a format (NURBS_FORMAT_), the same for the same list.
    [[nodiscard]] Returned<std::vector<std::byte>> write(std::int32_t format) const {
        return file_of(nurbs_list_write, handle_, format, nullptr);
    }
    /// The same with settings: a WriteOptions.
    [[nodiscard]] Returned<std::vector<std::byte>> write(std::int32_t format,
                                                         const nurbs_write_options &options) const {
        return file_of(nurbs_list_write, handle_, format, &options);
    }
    /// The same; `call` can watch and end it, once for the length and once for the contents.
    [[nodiscard]] Returned<std::vector<std::byte>>
    write(std::int32_t format, const nurbs_write_options &options, const CallOptions &call) const {
        const Watch watch(call);
        return file_of(nurbs_list_write_with, handle_, format, &options, watch.get());
    }

private:
    nurbs_list *handle_ = nullptr;
};

/// The same of statistics, which are copied as splines are; and what they are as bytes.
class StatisticsHandle {
public:
    StatisticsHandle() noexcept = default;
    explicit StatisticsHandle(nurbs_statistics *owned) noexcept : handle_(owned) {}
    StatisticsHandle(const StatisticsHandle &other) {
        if (other.handle_ != nullptr) {
            check_copy(nurbs_statistics_clone(other.handle_, &handle_));
        }
    }
    StatisticsHandle(StatisticsHandle &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    StatisticsHandle &operator=(StatisticsHandle other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~StatisticsHandle() { nurbs_statistics_destroy(handle_); }

    [[nodiscard]] const nurbs_statistics *get() const noexcept { return handle_; }
    [[nodiscard]] nurbs_statistics *release() noexcept { return std::exchange(handle_, nullptr); }

    /// To be kept or sent: the same on every machine for the same data, whatever their order.
    [[nodiscard]] Returned<std::vector<std::byte>> to_bytes() const {
        return bytes_of(nurbs_statistics_to_bytes, handle_);
    }

private:
    nurbs_statistics *handle_ = nullptr;
};

/// The same of faces, which are copied as splines are.
class FaceHandle {
public:
    FaceHandle() noexcept = default;
    explicit FaceHandle(nurbs_face *owned) noexcept : handle_(owned) {}
    FaceHandle(const FaceHandle &other) {
        if (other.handle_ != nullptr) {
            check_copy(nurbs_face_clone(other.handle_, &handle_));
        }
    }
    FaceHandle(FaceHandle &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    FaceHandle &operator=(FaceHandle other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~FaceHandle() { nurbs_face_destroy(handle_); }

    [[nodiscard]] const nurbs_face *get() const noexcept { return handle_; }
    [[nodiscard]] nurbs_face *release() noexcept { return std::exchange(handle_, nullptr); }

    /// To be kept or sent: the same on every machine for the same face.
    [[nodiscard]] Returned<std::vector<std::byte>> to_bytes() const {
        return bytes_of(nurbs_face_to_bytes, handle_);
    }

private:
    nurbs_face *handle_ = nullptr;
};

/// The same of models.
class ModelHandle {
public:
    ModelHandle() noexcept = default;
    explicit ModelHandle(nurbs_model *owned) noexcept : handle_(owned) {}
    ModelHandle(const ModelHandle &other) {
        if (other.handle_ != nullptr) {
            check_copy(nurbs_model_clone(other.handle_, &handle_));
        }
    }
    ModelHandle(ModelHandle &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    ModelHandle &operator=(ModelHandle other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~ModelHandle() { nurbs_model_destroy(handle_); }

    [[nodiscard]] const nurbs_model *get() const noexcept { return handle_; }
    [[nodiscard]] nurbs_model *release() noexcept { return std::exchange(handle_, nullptr); }

    /// The contents of a file of a format (NURBS_FORMAT_), the same for the same model.
    [[nodiscard]] Returned<std::vector<std::byte>> write(std::int32_t format) const {
        return file_of(nurbs_model_write, handle_, format, nullptr);
    }
    /// The same with settings: a WriteOptions.
    [[nodiscard]] Returned<std::vector<std::byte>> write(std::int32_t format,
                                                         const nurbs_write_options &options) const {
        return file_of(nurbs_model_write, handle_, format, &options);
    }
    /// The same; `call` can watch and end it, once for the length and once for the contents.
    [[nodiscard]] Returned<std::vector<std::byte>>
    write(std::int32_t format, const nurbs_write_options &options, const CallOptions &call) const {
        const Watch watch(call);
        return file_of(nurbs_model_write_with, handle_, format, &options, watch.get());
    }
    /// To be kept or sent, with all that it holds: the same on every machine for the same model.
    [[nodiscard]] Returned<std::vector<std::byte>> to_bytes() const {
        return bytes_of(nurbs_model_to_bytes, handle_);
    }

private:
    nurbs_model *handle_ = nullptr;
};

/// The same of what is found where shapes meet.
class MeetHandle {
public:
    MeetHandle() noexcept = default;
    explicit MeetHandle(nurbs_meet *owned) noexcept : handle_(owned) {}
    MeetHandle(const MeetHandle &other) {
        if (other.handle_ != nullptr) {
            check_copy(nurbs_meet_clone(other.handle_, &handle_));
        }
    }
    MeetHandle(MeetHandle &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    MeetHandle &operator=(MeetHandle other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~MeetHandle() { nurbs_meet_destroy(handle_); }

    [[nodiscard]] const nurbs_meet *get() const noexcept { return handle_; }
    [[nodiscard]] nurbs_meet *release() noexcept { return std::exchange(handle_, nullptr); }

private:
    nurbs_meet *handle_ = nullptr;
};

/// The same of triangles in place of shapes.
class MeshHandle {
public:
    MeshHandle() noexcept = default;
    explicit MeshHandle(nurbs_mesh *owned) noexcept : handle_(owned) {}
    MeshHandle(const MeshHandle &other) {
        if (other.handle_ != nullptr) {
            check_copy(nurbs_mesh_clone(other.handle_, &handle_));
        }
    }
    MeshHandle(MeshHandle &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    MeshHandle &operator=(MeshHandle other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~MeshHandle() { nurbs_mesh_destroy(handle_); }

    [[nodiscard]] const nurbs_mesh *get() const noexcept { return handle_; }
    [[nodiscard]] nurbs_mesh *release() noexcept { return std::exchange(handle_, nullptr); }

    /// The contents of a file of a format (NURBS_FORMAT_), the same for the same mesh.
    [[nodiscard]] Returned<std::vector<std::byte>> write(std::int32_t format) const {
        return file_of(nurbs_mesh_write, handle_, format, nullptr);
    }
    /// The same with settings: a WriteOptions.
    [[nodiscard]] Returned<std::vector<std::byte>> write(std::int32_t format,
                                                         const nurbs_write_options &options) const {
        return file_of(nurbs_mesh_write, handle_, format, &options);
    }
    /// The same; `call` can watch and end it, once for the length and once for the contents.
    [[nodiscard]] Returned<std::vector<std::byte>>
    write(std::int32_t format, const nurbs_write_options &options, const CallOptions &call) const {
        const Watch watch(call);
        return file_of(nurbs_mesh_write_with, handle_, format, &options, watch.get());
    }

private:
    nurbs_mesh *handle_ = nullptr;
};

// The handle that f(arguments..., &handle) makes, as a Spline, a List, Statistics, a Face, a Model, a Meet or a Mesh.
template <class Owner, class F, class... Arguments>
Owner made(F &&f, const Arguments &...arguments) {
    decltype(std::declval<Owner>().release()) handle = nullptr;
    attempt([&] { return f(arguments..., &handle); });
    return Owner(handle);
}

template <class Owners>
auto handle_list(const Owners &owners) {
    std::vector<decltype(owners[0].get())> handles;
    handles.reserve(owners.size());
    for (const auto &owner : owners) {
        handles.push_back(owner.get());
    }
    return handles;
}

// None where they were left out.
template <class Splines>
std::vector<const nurbs *> handle_list(const std::optional<Splines> &splines) {
    return splines ? handle_list(*splines) : std::vector<const nurbs *>();
}

} // namespace detail

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_HANDLES_HPP

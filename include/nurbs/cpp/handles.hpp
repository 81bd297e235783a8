/* SPDX-License-Identifier: MIT */
/// \file handles.hpp
/// \brief What Spline and List are before anything is done with them: owners of a handle.
#ifndef NURBS_CPP_HANDLES_HPP
#define NURBS_CPP_HANDLES_HPP

#include <nurbs/cpp/arrays.hpp>
#include <nurbs/cpp/calls.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

namespace detail {

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

private:
    nurbs_list *handle_ = nullptr;
};

// The handle that f(arguments..., &handle) makes, as a Spline or a List.
template <class Owner, class F, class... Arguments>
Owner made(F &&f, const Arguments &...arguments) {
    decltype(std::declval<Owner>().release()) handle = nullptr;
    attempt([&] { return f(arguments..., &handle); });
    return Owner(handle);
}

template <class Splines>
std::vector<const nurbs *> handle_list(const Splines &splines) {
    std::vector<const nurbs *> handles;
    handles.reserve(splines.size());
    for (const SplineHandle &spline : splines) {
        handles.push_back(spline.get());
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

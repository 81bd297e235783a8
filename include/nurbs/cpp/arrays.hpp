/* SPDX-License-Identifier: MIT */
/// \file arrays.hpp
/// \brief Array arguments: views of the caller's memory that know their length.
#ifndef NURBS_CPP_ARRAYS_HPP
#define NURBS_CPP_ARRAYS_HPP

#include <nurbs/cpp/result.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

namespace detail {

inline void wrong_size(const char *what, std::size_t holds, const std::string &wanted) {
    fail(Status::size, std::string(what) + " holds " + std::to_string(holds) + " values, expected " + wanted);
}

inline std::size_t to_size(std::int64_t n) {
    return n > 0 ? static_cast<std::size_t>(n) : 0;
}

template <class T>
std::int64_t length(const T &range) {
    return static_cast<std::int64_t>(range.size());
}

// Sum of counts, in the same manner as product().
inline std::int64_t sum(std::span<const std::int64_t> counts) {
    std::int64_t result = 0;
    for (const std::int64_t count : counts) {
        if (count < 0) {
            return -1;
        }
        result = result > INT64_MAX - count ? INT64_MAX : result + count;
    }
    return result;
}

// Product of counts; -1 if one is negative, which the library then reports itself, and INT64_MAX, which no
// array has, if it overflows.
template <class T>
std::int64_t product(std::span<const T> counts) {
    std::int64_t result = 1;
    for (const std::int64_t count : counts) {
        if (count < 0) {
            return -1;
        }
        result = count > 0 && result > INT64_MAX / count ? INT64_MAX : result * count;
    }
    return result;
}

// Calls f(&result) and returns the result.
template <class T, class F>
T result_of(F &&f) {
    T result{};
    attempt([&] { return f(&result); });
    return result;
}

// The text that f(buffer, capacity, &length) writes.
template <class F>
std::string text_of(F &&f) {
    std::int64_t length = 0;
    attempt([&] { return f(nullptr, 0, &length); });
    std::string text(to_size(length), '\0');
    attempt([&] { return f(text.data(), length + 1, &length); });
    return text;
}

} // namespace detail

/// A read-only array argument: any contiguous range, or a list in braces.
template <class T>
class View : public std::span<const T> {
public:
    View() noexcept = default;
    View(std::initializer_list<T> list) noexcept : std::span<const T>(list.begin(), list.size()) {}
    template <std::convertible_to<std::span<const T>> Range>
    View(Range &&range) noexcept : std::span<const T>(range) {}
};

/// An array of records in the caller's memory. Without a layout it is packed, and its length gives the
/// number of records.
template <class T>
class Records {
public:
    Records() noexcept = default;
    Records(std::initializer_list<std::remove_const_t<T>> packed) noexcept requires std::is_const_v<T>
        : values_(packed.begin(), packed.size()) {}
    template <std::convertible_to<std::span<T>> Range>
    Records(Range &&packed) noexcept : values_(packed) {}
    /// n records; component c of record i is values[i * stride + c * component_stride]; 0 means packed.
    Records(std::span<T> values, std::int64_t n, std::int64_t stride,
            std::int64_t component_stride = 0) noexcept
        : values_(values), n_(n), stride_(stride), component_stride_(component_stride), packed_(false) {}

    /// The number of records of `width` components.
    [[nodiscard]] std::int64_t count(std::int64_t width, const char *what) const {
        if (!packed_) {
            return n_;
        }
        const std::int64_t size = detail::length(values_);
        if (width > 0 && size % width != 0) {
            detail::wrong_size(what, values_.size(), "a multiple of " + std::to_string(width));
        }
        return width > 0 ? size / width : 0;
    }
    /// Fails unless exactly n records were described and the array is long enough for them.
    void require(std::int64_t n, std::int64_t width, const char *what) const {
        if (n < 0 || width < 1) {
            return;
        }
        // In floating point: exact for every size that memory can have, and free of overflow for the others.
        const double component = component_stride_ == 0 ? 1.0 : static_cast<double>(component_stride_);
        const double step =
            stride_ == 0 ? static_cast<double>(width) * component : static_cast<double>(stride_);
        const double extent =
            n == 0 ? 0.0
                   : static_cast<double>(n - 1) * step + static_cast<double>(width - 1) * component + 1.0;
        if (extent > static_cast<double>(values_.size()) || count(width, what) != n) {
            detail::wrong_size(what, values_.size(),
                               std::to_string(n) + " records of " + std::to_string(width) + " components");
        }
    }
    [[nodiscard]] T *data() const noexcept { return values_.data(); }
    [[nodiscard]] bool empty() const noexcept { return values_.empty(); }
    [[nodiscard]] std::int64_t stride() const noexcept { return stride_; }
    [[nodiscard]] std::int64_t component_stride() const noexcept { return component_stride_; }
    /// The stride of records of one component, where the library takes only one.
    [[nodiscard]] std::int64_t step() const noexcept { return stride_ == 0 ? component_stride_ : stride_; }

private:
    std::span<T> values_;
    std::int64_t n_ = 0;
    std::int64_t stride_ = 0;
    std::int64_t component_stride_ = 0;
    bool packed_ = true;
};

using Input = Records<const double>;
using Output = Records<double>;
using FloatOutput = Records<float>; ///< results in single precision; strides count floats

namespace detail {

// The number of records, all of which are in the array.
inline std::int64_t records(Input values, std::int64_t width, const char *what) {
    const std::int64_t n = values.count(width, what);
    values.require(n, width, what);
    return n;
}

// Records that may be left out.
template <class T>
void require_wanted(const Records<T> &values, std::int64_t n, std::int64_t width, const char *what) {
    if (!values.empty()) {
        values.require(n, width, what);
    }
}

// An array that has to be of one length.
template <class Range>
void require(const Range &values, std::int64_t size, const char *what) {
    if (length(values) != size) {
        wrong_size(what, values.size(), std::to_string(size));
    }
}

// The same of one that may be left out.
template <class Range>
void require_given(const Range &values, std::int64_t size, const char *what) {
    if (!values.empty()) {
        require(values, size, what);
    }
}

// The same where the library names what makes the length negative.
template <class Range>
void require_unless_negative(const Range &values, std::int64_t size, const char *what) {
    if (size >= 0) {
        require(values, size, what);
    }
}

inline void require_matrix(View<double> matrix, std::int64_t rows, std::int64_t columns) {
    // A spline that is empty has no columns, and has failed already.
    if (columns > 0 && (length(matrix) / columns != rows || length(matrix) % columns != 0)) {
        wrong_size("matrix", matrix.size(), std::to_string(rows) + " rows of " + std::to_string(columns));
    }
}

// The same of texts, in which a zero byte would be their end.
inline void require_texts(std::span<const std::string> texts, std::int64_t size, const char *what) {
    require_given(texts, size, what);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (texts[i].find('\0') != std::string::npos) {
            fail(Status::syntax, std::string(what) + "[" + std::to_string(i) + "] contains a zero byte");
        }
    }
}

// As the library takes an array of them.
inline std::vector<const char *> text_list(std::span<const std::string> texts) {
    std::vector<const char *> list;
    list.reserve(texts.size());
    for (const std::string &text : texts) {
        list.push_back(text.c_str());
    }
    return list;
}

// NULL for an array that was left out.
template <class Range>
auto pointer(const Range &values) noexcept {
    return values.empty() ? nullptr : values.data();
}

// The elements of an array of arrays, one after the other.
template <class T, std::size_t n, std::size_t m>
T *flat(std::array<std::array<T, m>, n> &rows) noexcept {
    return rows.front().data();
}

// Calls f(centroid, inertia), which returns a status and refuses what it cannot give if that is asked for: then it is
// asked for less, and the rest is NaN. A content of 0 has no centroid, and inertia overflows first.
template <class F>
void call_moments(F &&f, std::span<double> centroid, std::span<double> inertia) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    attempt([&] {
        nurbs_status status = f(centroid.data(), inertia.data());
        if (status == NURBS_ERROR_NOT_REPRESENTABLE) {
            std::fill(inertia.begin(), inertia.end(), none);
            status = f(centroid.data(), static_cast<double *>(nullptr));
        }
        if (status == NURBS_ERROR_LENGTH || status == NURBS_ERROR_NOT_REPRESENTABLE) {
            std::fill(centroid.begin(), centroid.end(), none);
            std::fill(inertia.begin(), inertia.end(), none);
            status = f(static_cast<double *>(nullptr), static_cast<double *>(nullptr));
        }
        return status;
    });
}

} // namespace detail

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_ARRAYS_HPP

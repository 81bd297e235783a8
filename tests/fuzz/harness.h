// What the fuzz targets over the C border share: a reader that turns bytes into arguments, splines that are
// mostly valid, and the checks every call has to pass. All arrays have exactly the length that is stated, so
// that a sanitizer sees the first value read or written outside.
#pragma once

#include <nurbs/nurbs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>

namespace fuzz {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

[[noreturn]] inline void violated(const char *what, int line) {
    std::array<char, 512> text{};
    nurbs_last_error(text.data(), static_cast<int64_t>(text.size()));
    std::fprintf(stderr, "line %d: %s; last message: %s\n", line, what, text.data());
    std::abort();
}

#define FUZZ_REQUIRE(condition)                                                                              \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            fuzz::violated(#condition, __LINE__);                                                            \
        }                                                                                                    \
    } while (false)

class Input {
public:
    Input(const uint8_t *data, size_t size) : next_(data), end_(data + size) {}

    uint8_t byte() { return next_ == end_ ? uint8_t{0} : *next_++; }
    int below(int n) { return byte() % n; }
    bool coin() { return (byte() & 1) != 0; }
    // One in thirty-two, and never when the bytes have run out.
    bool rarely() { return byte() % 32 == 31; }
    uint64_t bits() {
        uint64_t value = 0;
        for (int i = 0; i < 8; ++i) {
            value = value << 8 | byte();
        }
        return value;
    }
    double unit() {
        const int high = byte();
        return (high * 256 + byte()) / 65535.0;
    }

    // Sizes from 2^-20 to 2^20, and the numbers that people type.
    double number() {
        const int kind = below(4);
        if (kind == 0) {
            return below(17) - 8;
        }
        const double value = 2 * unit() - 1;
        return kind < 3 ? value : std::ldexp(value, below(41) - 20);
    }

    // Anything that a double can be.
    double anything() {
        static constexpr double telling[] = {std::numeric_limits<double>::quiet_NaN(),
                                             std::numeric_limits<double>::infinity(),
                                             -std::numeric_limits<double>::infinity(),
                                             std::numeric_limits<double>::max(),
                                             -std::numeric_limits<double>::max(),
                                             std::numeric_limits<double>::denorm_min(),
                                             std::numeric_limits<double>::min(),
                                             -0.0,
                                             0.0,
                                             -1.0};
        const int kind = below(12);
        if (kind < 10) {
            return telling[kind];
        }
        const uint64_t pattern = bits();
        double value = 0;
        std::memcpy(&value, &pattern, sizeof value);
        return value;
    }

    // Sizes and strides that every function has to refuse, or that name no memory at all.
    int64_t bad_size() {
        static constexpr int64_t telling[] = {-1, std::numeric_limits<int64_t>::min(),
                                              std::numeric_limits<int64_t>::max(),
                                              std::numeric_limits<int64_t>::max() / 2};
        return telling[below(4)];
    }
    int32_t bad_int() {
        static constexpr int32_t telling[] = {-1, std::numeric_limits<int32_t>::min(),
                                              std::numeric_limits<int32_t>::max()};
        return telling[below(3)];
    }

private:
    const uint8_t *next_;
    const uint8_t *end_;
};

// A failed call has a message. Returns whether the call succeeded.
inline bool succeeded(nurbs_status status, int line) {
    if (status != NURBS_OK && nurbs_last_error(nullptr, 0) == 0) {
        violated("a failed call without a message", line);
    }
    if (status == NURBS_ERROR_INTERNAL || status == NURBS_ERROR_MEMORY) {
        violated(nurbs_status_name(status), line);
    }
    return status == NURBS_OK;
}

// A call that makes a handle: success gives one, failure gives NULL. `out` is read here, after the call that
// gave `status`, in whatever order the arguments are evaluated.
inline nurbs *made(nurbs_status status, nurbs *const &out, int line) {
    if (succeeded(status, line) != (out != nullptr)) {
        violated("status and handle disagree", line);
    }
    return out;
}

// What `out` holds before a call that has to overwrite it.
inline nurbs *poison() {
    static char place;
    return reinterpret_cast<nurbs *>(&place);
}

#define FUZZ_OK(call) fuzz::succeeded(call, __LINE__)
#define FUZZ_MADE(call, out) fuzz::made(call, out, __LINE__)

class Handle {
public:
    explicit Handle(nurbs *g) : g_(g) {}
    Handle(const Handle &) = delete;
    Handle &operator=(const Handle &) = delete;
    ~Handle() { nurbs_destroy(g_); }
    [[nodiscard]] nurbs *get() const { return g_; }
    explicit operator bool() const { return g_ != nullptr; }

private:
    nurbs *g_;
};

struct Axis {
    int32_t degree;
    int64_t count;
    std::vector<double> knots;
    bool periodic;
};

// A full knot vector with every kind of step: repeated knots up to degree + 1, tiny, equal and wild spans.
inline std::vector<double> knot_vector(Input &in, int32_t degree, int64_t count, bool clamped) {
    std::vector<double> knots(static_cast<size_t>(count + degree + 1));
    double t = in.number();
    int repeated = 0;
    for (size_t i = 0; i < knots.size(); ++i) {
        static constexpr double steps[] = {1, 1, 0.1, 1e-9, 1000};
        const int kind = in.below(8);
        const auto place = static_cast<int64_t>(i);
        const bool at_end = clamped && ((place <= degree && i > 0) || place > count);
        const bool repeat = at_end || (kind < 2 && repeated < degree &&
                                       !(clamped && (place == count || place == degree + 1)));
        if (i > 0 && !repeat) {
            t += kind < 7 ? steps[kind % 5] : in.unit() + 1e-6;
        }
        repeated = repeat && i > 0 ? repeated + 1 : 0;
        knots[i] = t;
    }
    return knots;
}

// Knots that repeat with a period of quarters, so that they do so exactly.
inline std::vector<double> periodic_knots(Input &in, int32_t degree, int64_t count) {
    const int64_t distinct = count - degree;
    std::vector<double> steps(static_cast<size_t>(distinct)), knots;
    std::generate(steps.begin(), steps.end(), [&] { return 0.25 * (1 + in.below(8)); });
    double t = 0;
    for (int64_t i = 0; i < count + degree + 1; ++i) {
        knots.push_back(t);
        t += steps[static_cast<size_t>(i % distinct)];
    }
    return knots;
}

inline Axis any_axis(Input &in, int64_t room) {
    const int32_t degree = in.rarely() ? in.below(32) : in.below(5);
    const int64_t count = degree + 1 + in.below(static_cast<int>(std::max<int64_t>(room, 1)));
    const int form = in.below(4);
    if (form == 3) {
        return {degree, count, periodic_knots(in, degree, count), true};
    }
    return {degree, count, knot_vector(in, degree, count, form < 2), false};
}

struct Spline {
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts;
    std::vector<double> knots;
    int32_t dim = 1;
    std::vector<double> points;
    std::vector<double> weights; // empty: polynomial
    uint32_t flags = 0;
    int64_t total = 1;

    [[nodiscard]] int axes() const { return static_cast<int>(degrees.size()); }
    [[nodiscard]] int32_t axes32() const { return static_cast<int32_t>(degrees.size()); }
    [[nodiscard]] const double *weight_data() const { return weights.empty() ? nullptr : weights.data(); }
    [[nodiscard]] int64_t knot_count() const { return static_cast<int64_t>(knots.size()); }
    // Largest |coordinate|, and the largest ratio of two weights (0 if a weight is 0).
    [[nodiscard]] double size() const {
        double largest = 0;
        for (const double x : points) {
            largest = std::max(largest, std::fabs(x));
        }
        return largest;
    }
    [[nodiscard]] double weight_ratio() const {
        if (weights.empty()) {
            return 1;
        }
        const auto [least, most] = std::minmax_element(weights.begin(), weights.end());
        return *least > 0 ? *most / *least : 0;
    }
};

// Index of the record that record `i` of a periodic spline has to equal.
inline int64_t wrapped(const Spline &s, int64_t i) {
    int64_t scale = 1, result = 0;
    for (int k = s.axes(); k-- > 0;) {
        const auto axis = static_cast<size_t>(k);
        int64_t layer = i % s.counts[axis];
        i /= s.counts[axis];
        if ((s.flags & NURBS_ON_AXIS(k, NURBS_PERIODIC)) != 0) {
            layer %= s.counts[axis] - s.degrees[axis];
        }
        result += layer * scale;
        scale *= s.counts[axis];
    }
    return result;
}

inline double any_weight(Input &in) {
    const int kind = in.below(16);
    return kind == 0 ? 0 : kind == 1 ? std::ldexp(1.0, in.below(41) - 20) : 0.125 + in.unit();
}

inline void fill_values(Input &in, Spline &s, bool rational) {
    const auto dim = static_cast<size_t>(s.dim);
    s.points.resize(static_cast<size_t>(s.total) * dim);
    s.weights.resize(rational ? static_cast<size_t>(s.total) : 0);
    for (int64_t i = 0; i < s.total; ++i) {
        const auto here = static_cast<size_t>(i), from = static_cast<size_t>(wrapped(s, i));
        for (size_t c = 0; c < dim; ++c) {
            s.points[here * dim + c] = from == here ? in.number() : s.points[from * dim + c];
        }
        if (rational) {
            s.weights[here] = from == here ? any_weight(in) : s.weights[from];
        }
    }
}

// Valid but for chance: a zero weight may let all weights of a place vanish, a step may round to nothing.
inline void add_axes(Input &in, Spline &s, int axes) {
    static constexpr int64_t room[] = {12, 5, 3};
    for (int k = 0; k < axes; ++k) {
        const Axis axis = any_axis(in, room[axes - 1]);
        s.degrees.push_back(axis.degree);
        s.counts.push_back(axis.count);
        s.knots.insert(s.knots.end(), axis.knots.begin(), axis.knots.end());
        s.flags |= axis.periodic ? NURBS_ON_AXIS(k, NURBS_PERIODIC) : 0;
        s.total *= axis.count;
    }
}

inline void add_values(Input &in, Spline &s, int dim) {
    s.dim = dim;
    if (s.total <= 4096) {
        fill_values(in, s, in.coin());
    }
}

inline Spline any_spline(Input &in) {
    Spline s;
    add_axes(in, s, std::min(3, 1 + in.below(5) / 2));
    add_values(in, s, 1 + in.below(4));
    return s;
}

inline nurbs *create(const Spline &s) {
    nurbs *g = poison();
    if (s.total > 4096) {
        return nullptr;
    }
    const nurbs_status status =
        nurbs_create(s.axes32(), s.degrees.data(), s.counts.data(), s.knots.data(), s.knot_count(), s.dim,
                     s.points.data(), 0, 0, s.weight_data(), 0, s.flags, &g);
    return FUZZ_MADE(status, g);
}

// Factor c of the accuracy contract, summed over the axes.
inline double accuracy(const std::vector<int32_t> &degrees) {
    static constexpr double c[] = {1, 3, 4, 4, 6, 6, 8, 8, 12, 12};
    double sum = 0;
    for (const int32_t p : degrees) {
        sum += p < 10 ? c[p] : p < 16 ? 16 : p < 24 ? 24 : 32;
    }
    return sum;
}

inline uint32_t any_flags(Input &in, int axes) {
    uint32_t flags = 0;
    for (int k = 0; k < axes; ++k) {
        static constexpr uint32_t outside[] = {0, 0, NURBS_CLAMP, NURBS_EXTRAPOLATE, NURBS_WRAP};
        uint32_t bits = outside[in.below(5)];
        bits |= in.coin() ? NURBS_LEFT : 0;
        bits |= in.below(4) == 3 ? NURBS_NAN : 0;
        flags |= NURBS_ON_AXIS(k, bits);
    }
    return in.rarely() ? flags ^ 1u << in.below(32) : flags;
}

// A parameter of an axis: mostly inside, often a knot, now and then anything.
inline double any_param(Input &in, const nurbs *g, int32_t axis, bool inside) {
    double domain[2] = {0, 1};
    FUZZ_REQUIRE(nurbs_domain(g, axis, domain) == NURBS_OK);
    const int kind = in.below(8);
    if (kind == 0) {
        return domain[in.below(2)];
    }
    if (!inside && kind == 1) {
        return in.rarely() ? in.anything() : domain[0] + (3 * in.unit() - 1) * (domain[1] - domain[0]);
    }
    if (kind == 2) {
        int32_t degree = 0;
        int64_t count = 0;
        nurbs_degree(g, axis, &degree);
        nurbs_count(g, axis, &count);
        std::vector<double> knots(static_cast<size_t>(count + degree + 1));
        nurbs_knots(g, axis, count + degree + 1, knots.data());
        return knots[static_cast<size_t>(degree + in.below(static_cast<int>(count - degree + 1)))];
    }
    return std::clamp(domain[0] + in.unit() * (domain[1] - domain[0]), domain[0], domain[1]);
}

inline std::vector<double> any_params(Input &in, const nurbs *g, int axes, int64_t n, bool inside) {
    std::vector<double> params;
    for (int64_t i = 0; i < n * axes; ++i) {
        params.push_back(any_param(in, g, static_cast<int32_t>(i % axes), inside));
    }
    return params;
}

inline bool same_bits(const double *a, const double *b, size_t n) {
    return n == 0 || std::memcmp(a, b, n * sizeof *a) == 0;
}

} // namespace fuzz

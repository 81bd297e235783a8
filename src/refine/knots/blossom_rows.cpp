// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refine/knots/blossom_rows.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "refine/knots/blossom_rows.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace nrb::refine {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, row_lanes>;
using Register = hn::Vec<Doubles>;
inline constexpr int lanes = static_cast<int>(hn::MaxLanes(Doubles()));

// How the knots of consecutive rows are loaded. Here the knots of all rows are adjacent in memory.
struct Adjacent {
    int64_t first; // row

    [[nodiscard]] HWY_INLINE Register side(KnotLanes knots) const {
        return hn::LoadU(Doubles(), knots + first);
    }
    [[nodiscard]] HWY_INLINE Register argument(KnotLanes knots) const { return side(knots); }
};

// The knots of consecutive rows are `stride` apart.
struct Spread {
    int64_t first;
    int64_t stride;

    [[nodiscard]] HWY_INLINE Register side(KnotLanes knots) const {
        HWY_ALIGN double values[lanes];
        for (int l = 0; l < lanes; ++l) {
            values[l] = knots[(first + l) * stride];
        }
        return hn::Load(Doubles(), values);
    }
    [[nodiscard]] HWY_INLINE Register argument(KnotLanes knots) const { return side(knots); }
};

// All rows have the same knots at the sides; their arguments are adjacent.
struct Between {
    [[nodiscard]] static HWY_INLINE Register side(KnotLanes knots) { return hn::Set(Doubles(), *knots); }
    [[nodiscard]] static HWY_INLINE Register argument(KnotLanes knots) { return hn::LoadU(Doubles(), knots); }
};

struct Halves {
    Register kept;    // for the same control point
    Register carried; // for the next one
};

// One step for one coefficient, as in divide_in_ratio(), which has the explanation.
template <class Load>
HWY_INLINE Halves split_value(const BlossomTerm &term, const Load &load, int step, int r, Register t,
                              Register value) {
    const auto left = load.side(term.left - (step - r) * term.pitch);
    const auto right = load.side(term.right + r * term.pitch);
    const auto behind = hn::Sub(t, left);
    const auto ahead = hn::Sub(right, t);
    const auto smaller = hn::Mul(value, hn::Div(hn::Min(behind, ahead), hn::Sub(right, left)));
    const auto larger = hn::Sub(value, smaller);
    const auto near = hn::Lt(behind, ahead);
    return {hn::IfThenElse(near, larger, smaller), hn::IfThenElse(near, smaller, larger)};
}

// The steps of append_argument(), unrolled so that all values stay in registers.
template <int kStep, class Load>
struct Steps {
    static HWY_INLINE void run(const BlossomTerm &term, const Load &load, Register *values) {
        Steps<kStep - 1, Load>::run(term, load, values);
        const auto t = load.argument(term.arguments[kStep - 1]);
        auto carried = hn::Zero(Doubles());
        const auto append = [&](int r) HWY_ATTR {
            const Halves halves = split_value(term, load, kStep, r, t, values[r]);
            values[r] = hn::Add(carried, halves.kept);
            carried = halves.carried;
        };
        append(0);
        if constexpr (kStep > 1) {
            append(1);
        }
        if constexpr (kStep > 2) {
            append(2);
        }
        values[kStep] = carried;
    }
};

template <class Load>
struct Steps<0, Load> {
    static HWY_INLINE void run(const BlossomTerm &term, const Load & /*load*/, Register *values) {
        values[0] = hn::Set(Doubles(), term.factor);
    }
};

template <class Load>
HWY_NOINLINE void run_steps(const BlossomTerm &term, const Load &load, Register *values) {
    values[0] = hn::Set(Doubles(), term.factor);
    for (int step = 1; step <= term.steps; ++step) {
        const auto t = load.argument(term.arguments[step - 1]);
        auto carried = hn::Zero(Doubles());
        for (int r = 0; r < step; ++r) {
            const Halves halves = split_value(term, load, step, r, t, values[r]);
            values[r] = hn::Add(carried, halves.kept);
            carried = halves.carried;
        }
        values[step] = carried;
    }
}

// Rows that begin at equal distances.
struct EvenRows {
    double *rows;
    int64_t pitch;
    [[nodiscard]] HWY_INLINE double *operator[](int64_t l) const { return rows + l * pitch; }
};

template <class Rows>
HWY_INLINE void store_column(Register sum, int column, const Rows &rows, int64_t first) {
    HWY_ALIGN double values[lanes];
    hn::Store(sum, Doubles(), values);
    for (int l = 0; l < lanes; ++l) {
        rows[first + l][column] = values[l];
    }
}

template <int kSteps, class Load>
HWY_INLINE void add_short_term(const BlossomTerm &term, const Load &load, Register *sums) {
    Register values[kSteps + 1];
    Steps<kSteps, Load>::run(term, load, values);
    sums += term.target;
    sums[0] = hn::Add(sums[0], values[0]);
    if constexpr (kSteps > 0) {
        sums[1] = hn::Add(sums[1], values[1]);
    }
    if constexpr (kSteps > 1) {
        sums[2] = hn::Add(sums[2], values[2]);
    }
}

template <class Load>
HWY_INLINE void add_term(const BlossomTerm &term, const Load &load, Register *sums) {
    switch (term.steps) {
    case 0:
        return add_short_term<0>(term, load, sums);
    case 1:
        return add_short_term<1>(term, load, sums);
    case 2:
        return add_short_term<2>(term, load, sums);
    default:
        break;
    }
    Register values[max_basis];
    run_steps(term, load, values);
    for (int i = 0; i <= term.steps; ++i) {
        sums[term.target + i] = hn::Add(sums[term.target + i], values[i]);
    }
}

template <class Load>
HWY_INLINE void make_sums(std::span<const BlossomTerm> terms, const Load &load, int width, EvenRows rows) {
    Register sums[max_basis + 1];
    std::fill_n(sums, width, hn::Zero(Doubles()));
    for (const BlossomTerm &term : terms) {
        add_term(term, load, sums);
    }
    for (int i = 0; i < width; ++i) {
        store_column(sums[i], i, rows, load.first);
    }
}

void make_rows(std::span<const BlossomTerm> terms, int64_t stride, int64_t count, int width, int64_t pitch,
               double *rows) {
    for (int64_t first = 0; first < count; first += lanes) {
        if (stride == 1) {
            make_sums(terms, Adjacent{first}, width, {rows, pitch});
        } else {
            make_sums(terms, Spread{first, stride}, width, {rows, pitch});
        }
    }
}

template <int kSteps, class Load, class Rows>
HWY_INLINE void make_short_row(const BlossomTerm &term, const Load &load, const Rows &rows, int64_t first) {
    Register values[kSteps + 1];
    Steps<kSteps, Load>::run(term, load, values);
    store_column(values[0], 0, rows, first);
    store_column(values[1], 1, rows, first);
    if constexpr (kSteps > 1) {
        store_column(values[2], 2, rows, first);
    }
    if constexpr (kSteps > 2) {
        store_column(values[3], 3, rows, first);
    }
}

// Computes as many rows as there are lanes.
template <class Load, class Rows>
HWY_INLINE void make_row(const BlossomTerm &term, const Load &load, const Rows &rows, int64_t first) {
    switch (term.steps) {
    case 1:
        return make_short_row<1>(term, load, rows, first);
    case 2:
        return make_short_row<2>(term, load, rows, first);
    case 3:
        return make_short_row<3>(term, load, rows, first);
    default:
        break;
    }
    Register values[max_basis];
    run_steps(term, load, values);
    for (int i = 0; i <= term.steps; ++i) {
        store_column(values[i], i, rows, first);
    }
}

void make_single_rows(const BlossomTerm &term, int64_t count, double *const *rows) {
    for (int64_t first = 0; first < count; first += lanes) {
        make_row(term, Adjacent{first}, rows, first);
    }
}

void make_rows_between(int steps, const double *left, const double *right, const double *arguments,
                       int64_t count, double *rows) {
    BlossomTerm term; // further arguments are not used
    term.steps = steps;
    term.target = 0;
    term.factor = 1;
    term.left = left;
    term.right = right;
    term.pitch = 1;
    double last[lanes + max_basis]; // do not read beyond the arguments
    for (int64_t first = 0; first < count; first += lanes) {
        const double *from = arguments + first;
        if (first + lanes > count) {
            std::fill(std::copy_n(from, count - first + steps - 1, last), last + lanes + steps - 1, *from);
            from = last;
        }
        for (int i = 0; i < steps; ++i) {
            term.arguments[i] = from + i;
        }
        make_row(term, Between{}, EvenRows{rows, steps + 1}, first);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::refine
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::refine {

namespace {

void add_term(const BlossomTerm &term, double *row) noexcept {
    double coefficients[max_basis] = {term.factor};
    for (int d = 1; d <= term.steps; ++d) {
        append_argument(term.left, term.right, d, *term.arguments[d - 1], coefficients);
    }
    for (int i = 0; i <= term.steps; ++i) {
        row[term.target + i] += coefficients[i];
    }
}

} // namespace

void blossom_row_sum(std::span<const BlossomTerm> terms, int width, double *row) noexcept {
    std::fill_n(row, width, 0.0);
    for (const BlossomTerm &term : terms) {
        add_term(term, row);
    }
}

NURBS_FORMS(make_rows);
NURBS_FORMS(make_single_rows);
NURBS_FORMS(make_rows_between);

void blossom_row_sums(std::span<const BlossomTerm> terms, int64_t stride, int64_t count, int width,
                      int64_t pitch, double *rows) noexcept {
    NURBS_BEST(make_rows)(terms, stride, count, width, pitch, rows);
}

void blossom_rows(const BlossomTerm &term, int64_t count, double *const *rows) noexcept {
    NURBS_BEST(make_single_rows)(term, count, rows);
}

void sliding_blossom_rows(int steps, const double *left, const double *right, const double *arguments,
                          int64_t count, double *rows) noexcept {
    NURBS_BEST(make_rows_between)(steps, left, right, arguments, count, rows);
}

} // namespace nrb::refine
#endif

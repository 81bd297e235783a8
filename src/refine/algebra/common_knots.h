// SPDX-License-Identifier: MIT
// Knots over which one or two splines, their sums and their products are splines of a higher degree, and how
// control points there follow from polar forms.
//
// The polar form of a polynomial of degree p, taken at a higher degree r, is the mean of its own polar form
// over all choices of p of the r arguments. The polar form of the product of two polynomials of degrees p and
// r - p is the mean of the products of their polar forms, the second one at the remaining arguments (L.
// Ramshaw 1989; K. Morken, "Some identities for products and degree raising of splines", Constr. Approx. 7
// (1991)). A knot that occurs m times in a spline of degree p occurs at least r - p + m times here. So,
// whatever the choice, a knot of the spline strictly inside the window of a control point is among the
// arguments as often as among the knots of the spline, and the values are combinations of control points of
// the spline with factors in [0, 1].
#pragma once

#include "basis/bspline.h"
#include "basis/knot_vector.h"
#include "numeric/binomial.h"
#include "spline/layer_table.h"

#include <array>
#include <vector>

namespace nrb::refine {

// A value of a polar form: coefficients of consecutive layers; on a periodic axis, of the endless sequence.
struct BlossomRow {
    int64_t first;
    int size;
    double coefficients[max_basis];
};

class CommonKnots {
public:
    static constexpr int max_members = 2;

    // The axis of degree r, not less than those of the members, which have the same domain bit for bit; every
    // knot has `extra` more copies than it needs, up to r + 1. It is periodic if all members are. Throws
    // Status::periodic_knots if copies a period away cannot be told apart, and what make_knot_vector()
    // throws.
    CommonKnots(int degree, const std::vector<const KnotVector *> &members, int extra);

    [[nodiscard]] const KnotVectorPtr &axis() const noexcept { return axis_; }

    // Distinct knots among the degree arguments of a control point, and how often they occur.
    struct Window {
        int64_t group;
        int size;
        std::array<int, max_basis> copies;
        double start; // the knot before, where the support begins
    };
    [[nodiscard]] Window window(int64_t layer) const noexcept;

    // The value of the polar form of a member, at as many knots of each group of the window as `chosen` says;
    // they are as many as its degree. Where the member jumps, it is the value of the piece to which the
    // window's control point belongs. Every coefficient is accurate to 3 d eps of itself, where d < size is
    // the number of arguments that are not knots of the member.
    void blossom_row(int member, const Window &window, const int *chosen, BlossomRow &row) const noexcept;
    // The stored layer from which at most degree + 1 layers that begin at `layer` can be read.
    [[nodiscard]] int64_t stored_layer(int member, int64_t layer) const noexcept;

    // The mean of a member's polar form over all choices of its degree among the arguments of a window: coefficients
    // of its layers from the returned one on.
    int64_t mean_row(int member, const Window &window, std::vector<double> &coefficients) const;
    // The same from each choice, and from a recurrence that takes the choices of a knot together, which is for windows of
    // two knots or more. The first costs time and memory for each choice, the second O(r p^3) at the most.
    int64_t mean_of_choices(int member, const Window &window, std::vector<double> &coefficients) const;
    int64_t mean_by_knots(int member, const Window &window, std::vector<double> &coefficients) const;

    // The table that gives the layers of the axis from those of a member, with its degree raised to r and its
    // knots refined.
    [[nodiscard]] LayerTable raising(int member) const;

private:
    class KnotByKnot;
    // A knot: its first place and copies here, and in the knots of each member.
    struct Group {
        double knot;
        int64_t first;
        int copies;
        std::array<int64_t, max_members> place;
        std::array<int, max_members> times;
    };
    // The knots of a member, on a periodic axis of several periods.
    struct Member {
        int degree;
        std::vector<double> knots;
        int64_t shift;  // its place of stored knot 0
        int64_t period; // layers of a period; 0: none
    };

    // The knots of a member that are among its arguments: the last copies of the lowest argument, all knots
    // between, and the first copies of the highest one. Where the member jumps at its only argument, the
    // knots of one side.
    struct Run {
        int64_t first;
        int64_t size;
    };

    static std::vector<Group> merged(const std::vector<std::vector<KnotGroup>> &own);
    void append(Group group);
    void add_open(const std::vector<const KnotVector *> &members);
    void add_periodic(const std::vector<const KnotVector *> &members);
    void check_rising(double knot) const;
    void count_copies(int extra);
    void choose_open(const std::vector<const KnotVector *> &members, int extra);
    void choose_periodic(const std::vector<const KnotVector *> &members);
    [[nodiscard]] Run own_arguments(size_t member, const Group *groups, const int *chosen, int low, int high,
                                    double start) const noexcept;
    [[nodiscard]] size_t group_of(double knot) const noexcept;
    [[nodiscard]] size_t group_at(int64_t index) const noexcept;
    [[nodiscard]] std::vector<double> knots_between(int64_t first, int64_t end) const;

    int degree_;
    std::vector<Member> members_;
    std::vector<Group> groups_;
    int64_t first_ = 0; // the place of knot 0 of the axis
    KnotVectorPtr axis_;
};

// Calls body(chosen, times) for every way to choose `total` knots of a window, equal knots taken together.
// `chosen` is the number of copies of each group, `times` in how many ways they can be picked.
template <class Body>
void for_each_choice(const CommonKnots::Window &window, int total, Body &&body);

namespace detail {

template <class Body>
void choose(const CommonKnots::Window &window, int at, int left, int after, double times, int *chosen,
            Body &body) {
    if (at == window.size) {
        body(static_cast<const int *>(chosen), times);
        return;
    }
    const int copies = window.copies[static_cast<size_t>(at)];
    after -= copies; // in the groups that follow
    for (int n = left > after ? left - after : 0; n <= copies && n <= left; ++n) {
        chosen[at] = n;
        choose(window, at + 1, left - n, after, times * binomial(copies, n), chosen, body);
    }
}

} // namespace detail

template <class Body>
void for_each_choice(const CommonKnots::Window &window, int total, Body &&body) {
    int all = 0;
    for (int i = 0; i < window.size; ++i) {
        all += window.copies[static_cast<size_t>(i)];
    }
    int chosen[max_basis] = {};
    detail::choose(window, 0, total, all, 1.0, chosen, body);
}

} // namespace nrb::refine

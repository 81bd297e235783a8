// SPDX-License-Identifier: MIT
// Common knots: a knot vector of a higher degree over which one or two splines, their sums and their products
// are splines. Its control points follow from polar forms (blossoms).
//
// The polar form of a polynomial of degree p, regarded as one of degree r >= p, is the mean of its own polar
// form over all choices of p of the r arguments. The polar form of the product of two polynomials of degrees
// p and r - p is the mean of the products of their polar forms, the second factor taking the arguments that
// the first one leaves (L. Ramshaw 1989; K. Morken, "Some identities for products and degree raising of
// splines", Constr. Approx. 7 (1991)).
//
// A knot of multiplicity m in a spline of degree p has multiplicity at least r - p + m here. Any choice of p
// arguments omits only r - p of them. So if the knot lies strictly inside the window (the r consecutive knots
// that belong to a control point), every choice contains it at least m times. The value of the polar form is
// therefore a combination of control points of the spline with factors in [0, 1].
#pragma once

#include "basis/bspline.h"
#include "basis/knot_vector.h"
#include "numeric/binomial.h"
#include "spline/layer_table.h"

#include <array>
#include <vector>

namespace nrb::refine {

// A value of a polar form as a linear combination: the coefficients of `size` consecutive layers from `first`
// on. On a periodic axis, layers are numbered in the endless sequence.
struct BlossomRow {
    int64_t first;
    int size;
    double coefficients[max_basis];
};

class CommonKnots {
public:
    static constexpr int max_members = 2;

    // Builds the axis of degree r = `degree`, which is at least the degree of every member. Members have the
    // same domain, bit for bit. Every knot gets `extra` more copies than it needs, up to multiplicity r + 1.
    // The axis is periodic if all members are. Throws Status::periodic_knots if rounding makes copies of
    // different knots in other periods coincide, and what make_knot_vector() throws.
    CommonKnots(int degree, const std::vector<const KnotVector *> &members, int extra);

    [[nodiscard]] const KnotVectorPtr &axis() const noexcept { return axis_; }

    // The window of a control point: the distinct knots among its `degree` arguments, which are `size`
    // consecutive groups beginning with `group`, and how often each occurs.
    struct Window {
        int64_t group;
        int size;
        std::array<int, max_basis> copies;
        double start; // the knot before the window, where the support begins
    };
    [[nodiscard]] Window window(int64_t layer) const noexcept;

    // The value of a member's polar form whose arguments are chosen[i] copies of knot i of the window; their
    // number is the degree of the member. Where the member jumps, the value belongs to the piece on which the
    // window's control point acts. Every coefficient has a relative error of at most 3 d eps, where d =
    // row.size - 1 is the number of arguments that are not knots of the member.
    void blossom_row(int member, const Window &window, const int *chosen, BlossomRow &row) const noexcept;
    // The number of the stored layer that equals `layer` of the endless sequence. At most degree + 1 layers
    // may be read from there.
    [[nodiscard]] int64_t stored_layer(int member, int64_t layer) const noexcept;

    // The mean of a member's polar form over all choices of its arguments from a window: the coefficients of
    // its layers, beginning with the layer that is returned.
    int64_t mean_row(int member, const Window &window, std::vector<double> &coefficients) const;
    // Two ways to compute this mean. mean_of_choices() evaluates each choice; its time and memory are
    // proportional to the number of choices. mean_by_knots() combines choices knot by knot with a recurrence,
    // which takes at most O(r p^3); the window must contain at least two distinct knots.
    int64_t mean_of_choices(int member, const Window &window, std::vector<double> &coefficients) const;
    int64_t mean_by_knots(int member, const Window &window, std::vector<double> &coefficients) const;

    // The table that expresses the layers over this axis by those of a member: degree elevation to r and knot
    // insertion in one step.
    [[nodiscard]] LayerTable raising(int member) const;

private:
    class KnotByKnot;
    // A distinct knot, with the index of its first copy and its multiplicity: in the common knot vector
    // (first, copies), and in the knots of each member (place, times).
    struct Group {
        double knot;
        int64_t first;
        int copies;
        std::array<int64_t, max_members> place;
        std::array<int, max_members> times;
    };
    // The knots of a member; for a periodic axis, those of several periods.
    struct Member {
        int degree;
        std::vector<double> knots;
        int64_t shift;  // index in `knots` of the member's stored knot 0
        int64_t period; // layers in a period; 0: not periodic
    };

    // The knots of a member that are among the arguments: the last copies of the lowest argument, all knots
    // between, and the first copies of the highest argument. If all arguments are one knot at which the
    // member jumps, they are the copies on one side of the jump.
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
    int64_t first_ = 0; // index of knot 0 of the axis
    KnotVectorPtr axis_;
};

// Calls body(chosen, times) for every way to choose `total` knots from a window, not distinguishing equal
// knots. chosen[i] is the number of copies of knot i, and `times` in how many ways these copies can be
// picked.
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
    after -= copies; // now the number of copies in the groups that follow
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

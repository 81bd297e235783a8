// SPDX-License-Identifier: MIT
// The polar form along one axis of the outer function of a composition, averaged over the ways to give its
// arguments some of the knots of a window.
#pragma once

#include "basis/bspline.h"
#include "basis/knot_vector.h"
#include "numeric/sum.h"
#include "refine/knots/batched_blossoms.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::refine {

// The number of copies of each distinct knot of a window.
using Copies = std::array<int8_t, max_basis>;

// What one argument of the polar form may be: the copies of the window's knots that are chosen for it, the
// value and the weight of the inner function there, and in how many orders the knots can be arranged, equal
// ones not distinguished.
struct ArgumentChoice {
    Copies copies;
    double value;
    double weight;
    double orders;
};

// How many copies of each of the window's `knots` distinct knots the arguments of the axis together may take.
struct CopyBounds {
    size_t knots;
    Copies least, most;
};

// Averages a polar form over the ways to choose its arguments, separately for each set of copies that the
// arguments take from the window. What other axes do with the rest of the window depends on these copies
// alone, so windows that differ only in their multiplicities share the result.
//
// A polar form is affine in each argument. Let A and B be the least and the greatest value of an argument
// between the values of the inner function at the first and the last knot of the window. An argument strictly
// between A and B ("mixed") is replaced by an affine combination of A and B. An argument that is a knot of
// the axis between A and B, or lies beyond A or B ("closed"), is kept. Rows are then needed only for each
// choice of closed arguments, with B as i of the others and A as the rest. All knots between A and B remain
// arguments, so factors stay in [0, 1].
class DistributedRows {
public:
    // The mean over the ways that take `copies` from the window, with each way multiplied by the weights of
    // its choices: coefficients of the degree + 1 control points that are active in the span. `ways` is the
    // number of these ways. Different orders of the arguments count separately; orders of equal knots do not.
    struct Share {
        Copies copies;
        double ways;
        std::array<double, max_basis> row;
    };

    // between: the interval from A to B. All arguments must outlive the use of the shares.
    void make(const KnotVector &axis, int64_t span, std::span<const ArgumentChoice> choices, Interval between,
              const CopyBounds &bounds);

    [[nodiscard]] const std::vector<Share> &shares() const noexcept { return means_; }
    // The share that takes exactly these copies; null if there is none.
    [[nodiscard]] const Share *find(const Copies &copies) const noexcept;

private:
    enum class Kind { closed, mixed, end };
    struct Choice : ArgumentChoice {
        double smaller; // the smaller one of its coefficients of A and B
        bool is_upper;  // `smaller` is the coefficient of A: the value is nearer to B
        size_t powers;  // index of the first of its powers_
    };
    // The number of orders of the arguments so far and of the knots in each of them.
    struct Ways {
        double count;
        double weighted; // the same, times the weights
    };
    // All ways with the same closed arguments; the other `open` arguments are combinations of A and B.
    struct Node {
        std::vector<double> arguments;
        size_t open;
        size_t row;                  // the first of its open + 1 rows
        size_t slot;                 // the first of its slots
        std::bitset<max_basis> used; // rows with a coefficient
    };
    // The ways of a node that take the same copies. It has one sum for each row of the node.
    struct Slot {
        size_t place; // of its copies, see place_of()
        size_t sums;
        size_t node;
        Copies copies;
        CompensatedSum ways;
    };
    // The least and the largest number of copies of each knot in any of the choices from a given one on.
    struct Reach {
        Copies least, most;
    };

    void order(std::span<const ArgumentChoice> choices);
    [[nodiscard]] Kind kind_of(double value) const noexcept;
    [[nodiscard]] Choice shared(const ArgumentChoice &choice);
    [[nodiscard]] Ways with(Ways ways, const Choice &choice, int times, int missing) const noexcept;
    void bound_choices();
    void forget();
    void number_places();
    [[nodiscard]] size_t place_of(const Copies &copies) const noexcept;
    [[nodiscard]] bool can_end(int missing, size_t next) const noexcept;
    [[nodiscard]] bool take(const Choice &choice, int times) noexcept;
    void give_back(const Choice &choice, int times) noexcept;
    void take_closed(size_t next, int missing, Ways ways);
    void begin(int missing, Ways ways);
    void take_mixed(size_t next, int missing, Ways ways, size_t mixed);
    void take_ends(size_t next, int missing, Ways ways, size_t mixed, size_t upper);
    void mix(const Choice &choice, size_t mixed) noexcept;
    void add_way(Ways ways, size_t mixed, size_t upper);
    [[nodiscard]] Slot &slot_of_copies();
    void make_rows();
    void add_row(const Node &node, size_t number);
    void make_shares();

    const KnotVector *axis_ = nullptr;
    int64_t span_ = 0;
    Interval between_{};
    CopyBounds bounds_{};
    std::vector<Choice> choices_;   // closed, mixed, then ends
    std::vector<Ways> powers_;      // of 0, 1, ... arguments per choice
    size_t closed_ = 0, mixed_ = 0; // ends of the first two kinds
    std::vector<Reach> reach_;
    int inner_degree_ = 0;
    std::array<size_t, max_basis> strides_{};
    std::vector<size_t> found_; // for each place: 0, or 1 + the index of its slot or share

    // Data of the way that is being enumerated.
    Copies copies_{};
    std::vector<double> arguments_; // the closed ones
    std::array<std::array<double, max_basis + 1>, max_basis + 1>
        shares_{}; // [number of mixed arguments][copies of B]
    std::vector<Node> nodes_;
    std::vector<Slot> slots_;
    std::vector<CompensatedSum> sums_;
    std::vector<double> rows_;
    BatchedBlossoms batches_{max_degree};
    std::vector<Share> means_;
};

} // namespace nrb::refine

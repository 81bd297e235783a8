// SPDX-License-Identifier: MIT
// Values of the polar form along one axis, over all ways to give its arguments some of the knots of windows.
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

// Copies of each distinct knot of a window.
using Copies = std::array<int8_t, max_basis>;

// What one argument may be: the value and the weight of the inner function at some knots of the window, and the orders that these
// have, where equal ones do not count.
struct ArgumentChoice {
    Copies copies;
    double value;
    double weight;
    double orders;
};

// How many copies of each of the `knots` distinct knots all arguments of the axis may use up.
struct CopyBounds {
    size_t knots;
    Copies least, most;
};

// Ways that use up the same copies are taken together: what other axes do with the rest of a window depends on the copies alone,
// and so windows that differ in their copies only have these rows in common.
//
// A polar form is affine in each argument. Choices between the two values A and B at the ends of the windows are therefore
// replaced by shares of A and B, and only rows for i times B, the other times A, are made for each way to choose the arguments that
// are left: those that are knots between A and B, and those that are beyond A and B. All knots between A and B stay arguments, so
// factors remain in [0, 1].
class DistributedRows {
public:
    // The mean over the ways that use up `copies`: coefficients of the degree + 1 control points that are active in the span,
    // times the weights of the choices. Orders of equal knots count once, those of arguments as often as there are.
    struct Share {
        Copies copies;
        double ways;
        std::array<double, max_basis> row;
    };

    // between: A and B, as an interval. All must outlive the use of the shares.
    void make(const KnotVector &axis, int64_t span, std::span<const ArgumentChoice> choices, Interval between,
              const CopyBounds &bounds);

    [[nodiscard]] const std::vector<Share> &shares() const noexcept { return means_; }
    // The one that uses up just these; null: there is none.
    [[nodiscard]] const Share *find(const Copies &copies) const noexcept;

private:
    enum class Kind { closed, mixed, end };
    struct Choice : ArgumentChoice {
        double smaller; // share of A and B, whichever is smaller
        bool is_upper;  // it is that of A: the value is nearer to B, or B
        size_t powers;  // the first of its own
    };
    // Orders of some arguments, and of the knots in each.
    struct Ways {
        double count;
        double weighted; // times the weights
    };
    // Ways with the same arguments that are neither A nor B, of which `open` are missing.
    struct Node {
        std::vector<double> arguments;
        size_t open;
        size_t row;                  // the first of open + 1
        size_t slot;                 // the first of its own
        std::bitset<max_basis> used; // rows that have a share
    };
    // Those of a node that use up the same copies. Its sums are those of the rows of the node.
    struct Slot {
        size_t place; // of the copies
        size_t sums;
        size_t node;
        Copies copies;
        CompensatedSum ways;
    };
    // Copies that the choices from one on use up, of each knot, at least and at most.
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
    std::vector<Choice> choices_;   // by their kind
    std::vector<Ways> powers_;      // of 0, 1, ... arguments of each
    size_t closed_ = 0, mixed_ = 0; // where those end
    std::vector<Reach> reach_;
    int inner_degree_ = 0;
    std::array<size_t, max_basis> strides_{};
    std::vector<size_t> found_; // by places: 1 + the slot in which they were found last

    // Of the present way.
    Copies copies_{};
    std::vector<double> arguments_; // that are closed
    std::array<std::array<double, max_basis + 1>, max_basis + 1>
        shares_{}; // of 0, 1, ... mixed ones: by copies of B
    std::vector<Node> nodes_;
    std::vector<Slot> slots_;
    std::vector<CompensatedSum> sums_;
    std::vector<double> rows_;
    BatchedBlossoms batches_{max_degree};
    std::vector<Share> means_;
};

} // namespace nrb::refine

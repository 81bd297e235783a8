// SPDX-License-Identifier: MIT
// Greedy knot removal along an axis: always removes the knot whose removal moves the spline least (T. Lyche,
// K. Morken, "A data-reduction strategy for splines", IMA J. Numer. Anal. 8 (1988); Piegl & Tiller A9.8).
#pragma once

#include "reduce/removal_step.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::reduce {

// Knots and layers are linked lists, or rings on a periodic axis, so that a removal costs O(degree^2) for
// each control point of a layer, whatever their number. Each span has an error: how far the spline may have
// moved there. A removal moves it by at most the gap of its step (see removal_step.h), and the moves add up.
// If weights change, too, the gap is estimated in Cartesian space about the points of the window. This is
// only an estimate; the result must be certified.
class GreedyKnotRemoval {
public:
    // With forgive_rounding, gaps of rational splines that may be no more than the rounding of their control
    // points count as 0.
    GreedyKnotRemoval(const Spline &spline, int axis, bool forgive_rounding);

    // Removes knots as long as the errors of their spans stay within the tolerance; returns how many. Ends of
    // the domain stay. Knots whose removal costs no more than rounding go first, in the order of the axis. If
    // there are very many knots, they are processed in consecutive parts of the axis: all that a removal
    // depends on is then near, and stays in the cache.
    int64_t run(double tolerance);
    // Replaces the accumulated errors by measured ones: errors[i] belongs to [breaks[i], breaks[i + 1]),
    // where breaks are knots of the given spline over its domain.
    void set_errors(std::span<const double> breaks, const std::vector<double> &errors);
    // The remaining spline. Layers that were not touched are unchanged bit for bit.
    [[nodiscard]] SplinePtr result() const;

private:
    struct Knot {
        double value;
        int64_t next;
        int64_t previous;
        int64_t layer; // the layer whose support begins here
        double error;  // of the span after it, up to the next larger knot
        double key;    // the cost of its removal
        bool present;
        bool movable;
        bool stale; // the key belongs to an earlier state
    };
    struct Layer {
        int64_t next;
        int64_t previous;
        bool changed;
        bool present;
    };
    // The knots and layers around the last copy of a knot that its removal needs.
    struct Window {
        int multiplicity;
        int size;  // number of layers
        int after; // number of knots from the first affected span to the last copy
        int ahead;
        double knots[3 * max_basis]; // from last[-degree] on
        const double *last;
        int64_t first_knot;
        int64_t layers[max_basis + 2];
        double *points[max_basis + 2];
        RemovalStep step;
    };
    class Column;
    struct Candidate {
        double key;
        int64_t knot;
        [[nodiscard]] bool operator<(const Candidate &other) const noexcept {
            return key > other.key ||
                   (key == other.key && knot > other.knot); // for a heap with the smallest key on top
        }
    };

    void link_knots();
    void link_layers();
    void note_inert_places();
    [[nodiscard]] bool last_copy(int64_t knot) const noexcept;
    [[nodiscard]] bool removable(int64_t knot) const noexcept;
    // False if the window overlaps itself.
    bool locate(int64_t knot, Window &window) noexcept;
    // The steps of locate(), in this order.
    int64_t collect_knots_before(int64_t knot, Window &window) const noexcept;
    void collect_knots_after(int64_t knot, Window &window) const noexcept;
    void collect_layers(int64_t first, Window &window) noexcept;
    void find_gap(const Window &window) noexcept;
    double cost(const Window &window) noexcept;
    [[nodiscard]] double rounding(const Window &window) const noexcept;
    double column_cost(const Window &window, int64_t at) const noexcept;
    double gap_rounding(const Window &window, const Column &column) const noexcept;
    double key_of(int64_t knot, Window &window);
    void refresh(int64_t knot);
    void push(int64_t knot);
    template <class Body>
    void for_each_span(const Window &window, Body &&body);
    bool remove(int64_t knot, const Window &window, double tolerance);
    int64_t remove_free(double tolerance);
    bool solve(const Window &window);
    bool clear_rounded_weights(const Window &window, double *layer) const noexcept;
    void unlink(int64_t knot, const Window &window) noexcept;
    void queue_all();
    [[nodiscard]] std::vector<Candidate> &heap_of(int64_t knot) noexcept;
    int64_t run(std::vector<Candidate> &heap, double dearest, double tolerance);
    [[nodiscard]] KnotVectorPtr remaining_axis() const;

    const Spline &spline_;
    int axis_index_;
    const KnotVector &axis_;
    int degree_;
    int width_;      // doubles in a record
    int64_t length_; // doubles in a layer
    bool forgive_rounding_;
    double period_; // 0: not periodic
    int64_t head_ = 0;
    int64_t layers_left_;
    std::vector<Knot> knots_;
    std::vector<Layer> layers_;
    std::vector<double> points_; // layer by layer
    // The places of a layer whose functions along the other axes vanish on the domain; empty if there are
    // none.
    std::vector<char> inert_;
    std::vector<double> gap_;
    std::vector<double> trial_; // layers of a window, solved before they are accepted
    // Heaps of consecutive knots, and the first knot of each heap but the first.
    std::vector<std::vector<Candidate>> heaps_;
    std::vector<int64_t> heap_starts_;
};

} // namespace nrb::reduce

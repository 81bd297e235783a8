// SPDX-License-Identifier: MIT
// Finds the parts of two surfaces that have common curves, and these in them.
#pragma once

#include "intersect/surfaces/contact/contact_chart.h"
#include "intersect/surfaces/cross_arc.h"
#include "intersect/surfaces/cross_crowds.h"
#include "intersect/surfaces/cross_side.h"
#include "intersect/surfaces/self/self_pairs.h"

#include <optional>
#include <span>
#include <vector>

namespace nrb::intersect {

// A pair of parts of which it is left open what they have in common.
struct CrossCluster {
    std::array<Interval, 4> ranges; // parameters of both
};

// A pair of parts with a ContactChart.
struct CrossContact {
    std::array<Interval, 4> ranges;
    ContactPoint place;
    double change; // ContactChart::change()
};

struct CrossParts {
    std::vector<CrossArc> arcs;
    std::vector<CrossContact> contacts;
    std::vector<CrossCluster> clusters;
};

// Parameters of both parts.
std::array<Interval, 4> ranges_of(const CrossCell &a, const CrossCell &b) noexcept;
std::array<Interval, 4> ranges_of(const CrossBox &box) noexcept;

// Pairs of pieces whose boxes have common points, then pairs of their parts, all of one size before smaller ones: a pair is
// excluded, has a chart in which its arc is found, or one of both is halved. What is left where planes of tangents are all
// but one is told by how the number of such pairs grows: a touch in one place leaves as many at each size, one along a
// curve or in a region ever more.
class CrossSearch {
public:
    CrossSearch(const Spline &a, const Spline &b, const SurfaceBorders &borders_a,
                const SurfaceBorders &borders_b);
    // Of a surface with itself, where each place is common to it and itself: what else is, in both orders.
    CrossSearch(const Spline &g, const SurfaceBorders &borders);

    // tolerance: within which what is not told apart need not be. The cells that arcs are in last as long as the search.
    CrossParts run(double tolerance);

    [[nodiscard]] const pieces::Frame &frame() const noexcept { return frame_; }
    [[nodiscard]] const ContactSolver &solver() const noexcept { return solver_; }
    [[nodiscard]] CrossGround &ground(size_t surface) noexcept { return (surface == 0 ? a_ : b_).ground; }

private:
    using PairCell = closest::PairCell;
    // graph: of a pair that had a chart. What is left of its arc where parts become too small is not told as a part, since arcs on
    // both sides of it go on in each other, or end.
    // no_contact: of a pair that does not touch where it is nearest; no_shear: of one that does not bend alike.
    struct Pair {
        CrossCell *a, *b;
        CrossCrowds::Number of; // the pieces
        bool graph = false;
        bool no_contact = false;
        bool no_shear = false;
    };

    void find_pieces();
    void look_at(PairCell &a, PairCell &b);
    void divide(PairCell &a, PairCell &b);
    void look(Pair pair);
    bool is_of_one_surface(Pair &pair);
    [[nodiscard]] bool are_in_one_place(const Pair &pair) const noexcept;
    void halve_both(const Pair &pair);
    // What is halved, along an axis if it is known which one.
    using Cut = CrossShear::Cut;
    [[nodiscard]] Cut usual_cut(const Pair &pair) const noexcept;
    CrossChart::Verdict set_chart(Pair &pair);
    void keep_cut(Pair &pair);
    [[nodiscard]] bool is_little_left() const noexcept;
    void look_for_arc(const Pair &pair);
    void divide(const Pair &pair, const Cut &cut);
    void halve(const Pair &pair, const Cut &cut);
    bool take_parts(const Pair &pair);
    void look_at_flat(Pair pair);
    bool look_for_contact(Pair &pair);
    [[nodiscard]] bool are_along(const Pair &pair) const;
    [[nodiscard]] bool lies_on(const Pair &pair) const;
    void give_up_crowds();
    void settle_crowds();
    void settle_side_by_side();
    void add(const Pair &pair);
    void add_left(std::span<const Pair> pairs);
    void add_unknown(const PairCell &a, const PairCell &b);
    [[nodiscard]] static double thickness(const Pair &pair);

    pieces::Frame frame_;
    CrossSide a_, b_;
    double tolerance_ = 0;
    std::vector<std::pair<PairCell *, PairCell *>> stack_;
    struct FlatPair {
        Pair pair;
        Cut cut;
        double thickness; // if more than the tolerance, one lies on the other one, as far as its middle tells
    };
    std::vector<Pair> pairs_, next_;
    std::vector<FlatPair> flat_;
    std::vector<Pair> side_by_side_; // parts of one surface
    CrossCrowds crowds_;
    ContactSolver solver_;
    ContactChart contact_;
    ArcFinder finder_;
    CrossShear shear_;
    // Of the present pair.
    std::optional<Cut> cut_;
    CrossShear::Parts parts_;
    bool first_is_x_ = true; // of the shear
    std::optional<SelfPairs> self_;
    CrossBox box_{};
    CrossParts found_;
};

} // namespace nrb::intersect

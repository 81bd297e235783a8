// SPDX-License-Identifier: MIT
// The search for common curves of two surfaces by subdivision: finds pairs of parts with a certified common
// arc or a contact, and leaves open what it cannot decide.
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

// A pair of parts for which it is left open what they have in common.
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

// Starts with the pairs of pieces whose boxes overlap, and examines pairs of their parts breadth first, all
// of one size before smaller ones. A pair is excluded, or has a chart in which its arc is found, or one of
// its parts is halved. Pairs with nearly coincident tangent planes remain at each size, and it matters how
// their number grows: an isolated touch leaves equally many at each size, a touch along a curve or a region
// in which the surfaces coincide leaves more and more.
class CrossSearch {
public:
    CrossSearch(const Spline &a, const Spline &b, const SurfaceBorders &borders_a,
                const SurfaceBorders &borders_b);
    // Of a surface with itself. That each place meets itself is left out; all other common points are found
    // twice, with their two places in either order.
    CrossSearch(const Spline &g, const SurfaceBorders &borders);

    // tolerance: what is closer to each other need not be told apart. The arcs refer to cells of the search,
    // and are valid as long as it exists.
    CrossParts run(double tolerance);

    [[nodiscard]] const pieces::Frame &frame() const noexcept { return frame_; }
    [[nodiscard]] const ContactSolver &solver() const noexcept { return solver_; }
    [[nodiscard]] CrossGround &ground(size_t surface) noexcept { return (surface == 0 ? a_ : b_).ground; }

private:
    using PairCell = closest::PairCell;
    // graph: the pair comes from one that had a chart. What is left of its arc where parts become too small
    // is not reported as a cluster, because the arcs on both sides of it are joined, or end there.
    // no_contact: the pair is known not to touch where both are nearest, or is not tested for a contact.
    // no_shear: the parts do not bend alike, so that a shear is useless.
    struct Pair {
        CrossCell *a, *b;
        CrossCrowds::Number of; // the pair of pieces
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
    // Which part is halved, and along which axis if that is known.
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
        double thickness; // beyond the tolerance only if are_along()
    };
    std::vector<Pair> pairs_, next_;
    std::vector<FlatPair> flat_;
    std::vector<Pair> side_by_side_; // adjacent parts of one surface
    CrossCrowds crowds_;
    ContactSolver solver_;
    ContactChart contact_;
    ArcFinder finder_;
    CrossShear shear_;
    // Of the pair that is being examined.
    std::optional<Cut> cut_;
    CrossShear::Parts parts_;
    bool first_is_x_ = true; // whether part a is X of the shear
    std::optional<SelfPairs> self_;
    CrossBox box_{};
    CrossParts found_;
};

} // namespace nrb::intersect

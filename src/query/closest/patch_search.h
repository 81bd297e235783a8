// The search for the nearest or farthest points of one query: branch and bound.
#pragma once

#include "query/closest/patch_place.h"
#include "query/closest/patch_proof.h"
#include "query/closest/patch_tree.h"

#include <vector>

namespace nrb {

class PatchSearch {
public:
    PatchSearch(const PatchPieces &pieces, const PatchTree &tree, const Query &query);

    // What is allowed for rounding, as a distance of the caller.
    static double noise(const PatchPieces &pieces, const double *point) noexcept {
        return pieces.unscaled(scaled_noise(pieces, point));
    }
    Foot nearest();
    std::vector<Foot> all();
    // The minimum that a descent from these parameters comes to.
    Foot local(const double *guess);

private:
    // A point of a piece, without rounded parameters.
    struct Place {
        int64_t piece = -1;
        AxisValues at{};
        double value = 0; // sign * distance
        double error = 0; // of it
    };
    struct Candidate {
        double bound;
        int64_t node;
    };
    using Candidates = ShortList<Candidate, 96>;

    static double scaled_noise(const PatchPieces &pieces, const double *point) noexcept {
        return pieces.allowance() * pieces.weight_ratio() * (pieces.size() + pieces.magnitude(point));
    }
    void set_scales() noexcept;
    [[nodiscard]] bool far_away() const noexcept;
    [[nodiscard]] PatchBox box(int64_t piece) const noexcept;
    enum class Part { none, some, all };
    [[nodiscard]] Part inside(const PatchTree::Extent &extent) const noexcept;

    // The leaves that may hold a point that counts; sets start_.
    void collect(Candidates &leaves);
    void visit_children(int level, const Candidate &parent, Candidates &next);
    void start();
    void search();
    void search_piece(int64_t piece, const Candidate *first, const Candidate *last);
    void search_leaf(const PatchItem &whole, const PatchBox &part, const PatchTree::Leaf &leaf);
    // A part of a piece is proved not to matter, or its halves are searched.
    void examine(PatchItem &item, bool fresh);
    bool settled(PatchItem &item, bool &fresh, int &axis);
    bool is_least(const PatchItem &item, const PatchGap &gap, const PatchProof &found);
    bool settled_by_plane(const PatchItem &item);
    void split(PatchItem &item, int axis);
    [[nodiscard]] int longest_axis(const PatchItem &item) const noexcept;
    bool improve(const PatchItem &item, AxisValues at);
    bool improve_to(const PatchItem &item, const AxisValues &at, double distance);
    [[nodiscard]] PatchGoal goal(double value, const PatchItem &item) const noexcept;
    [[nodiscard]] double upper() const noexcept { return best_.value + tolerance_ + noise_; }
    // An eighth of the noise is for the rounding of the parameters.
    [[nodiscard]] double lower() const noexcept { return best_.value - tolerance_ - 0.875 * noise_; }
    [[nodiscard]] bool asks_for_others() const noexcept { return all_ || (!several_ && extra_ < 24); }

    // A minimum of an item as near as the best one: whether it is one of the spline, and elsewhere.
    void consider(const PatchItem &item, const AxisValues &at, double distance, bool strict);
    // Descends across pieces; false if it takes too many steps.
    bool walk(Place &place);
    bool walk_on(Place &place);
    [[nodiscard]] bool same_point(const Place &a, const Place &b);
    bool is_minimum(const Place &place);
    [[nodiscard]] double distance_at(const PatchItem &item, const Foot &foot) const;
    void polish(const PatchItem &item, Foot &foot) const;
    [[nodiscard]] Foot foot(const Place &place);
    [[nodiscard]] Foot any_point(); // if far_away()

    const PatchPieces &pieces_;
    const PatchTree &tree_;
    const Query &query_;
    mutable PatchMemory memory_;
    double *x_;
    PatchItems items_;
    PatchDescent descent_;
    double sign_;
    double tolerance_ = 0;
    double noise_ = 0;
    double floor_ = 0;
    double start_bound_ = 0; // of the best value, from above
    int64_t start_leaf_ = -1;
    Place best_;
    bool all_ = false;
    bool several_ = false;   // points elsewhere are as near
    bool connected_ = false; // and not isolated
    bool incomplete_ = false;
    int64_t cost_ = 1; // of an item
    int64_t spent_ = 0;
    int extra_ = 0; // items looked at only because there may be others
    std::vector<Place> others_;
};

} // namespace nrb

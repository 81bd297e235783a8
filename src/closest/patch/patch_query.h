// SPDX-License-Identifier: MIT
// One closest-point query on a surface or volume: its point in the frame of the pieces, and operations on
// candidate feet.
#pragma once

#include "closest/patch/patch_place.h"

namespace nrb::closest {

class PatchQuery {
public:
    PatchQuery(const PieceGrid &pieces, const Query &query);

    // The allowance for rounding, as a distance in the caller's units.
    static double noise(const PieceGrid &pieces, const double *point) noexcept {
        return pieces.unscaled(scaled_noise(pieces, point));
    }
    static double scaled_noise(const PieceGrid &pieces, const double *point) noexcept {
        return pieces.allowance() * pieces.weight_ratio() * (pieces.size() + pieces.magnitude(point)) +
               pieces.scaled(underflow_noise);
    }
    // The minimum that a descent from given parameters reaches.
    Foot local(const double *guess);

protected:
    // A place on a piece, not yet rounded to parameters of the spline.
    struct FootCandidate {
        int64_t piece = -1;
        AxisValues at{};
        double value = 0;     // sign * distance
        double error = 0;     // uncertainty of the value
        bool certain = false; // it is certainly a minimum
    };

    [[nodiscard]] PatchBox box(int64_t piece) const noexcept;
    // How far rounding may have moved a point of a piece.
    [[nodiscard]] double moved(int64_t piece, const AxisValues &at) const;
    // Continues a descent into neighbouring pieces; false if that takes too many steps. walk_on() takes one
    // such step.
    bool walk(FootCandidate &place);
    bool walk_on(FootCandidate &place);
    [[nodiscard]] bool same_point(const FootCandidate &a, const FootCandidate &b);
    [[nodiscard]] bool same_params(const FootCandidate &a, const FootCandidate &b) const noexcept;
    [[nodiscard]] std::vector<double> point_of(const FootCandidate &place);
    // Points at a distance of |value| from the query point that are nearer to each other than this cannot be
    // told apart because of rounding.
    [[nodiscard]] double least_apart(double value) const noexcept {
        return 8 * std::sqrt(noise_ * (std::abs(value) + noise_));
    }
    [[nodiscard]] double distance_at(int64_t piece, const Foot &foot) const;
    void polish(int64_t piece, Foot &foot) const;
    [[nodiscard]] Foot foot(const FootCandidate &place);
    [[nodiscard]] Foot any_point(); // used if the query point is very far away

    const PieceGrid &pieces_;
    const Query &query_;
    mutable PatchMemory memory_;
    PatchItems items_;
    PatchDescent descent_;
    double sign_;
    double tolerance_ = 0;
    double noise_ = 0;
    double floor_ = 0;
};

} // namespace nrb::closest

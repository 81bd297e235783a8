// SPDX-License-Identifier: MIT
// One query: its point among the pieces, and what is done with places on them.
#pragma once

#include "closest/patch/patch_place.h"

namespace nrb::closest {

class PatchQuery {
public:
    PatchQuery(const PieceGrid &pieces, const Query &query);

    // What is allowed for rounding, as a distance of the caller.
    static double noise(const PieceGrid &pieces, const double *point) noexcept {
        return pieces.unscaled(scaled_noise(pieces, point));
    }
    static double scaled_noise(const PieceGrid &pieces, const double *point) noexcept {
        return pieces.allowance() * pieces.weight_ratio() * (pieces.size() + pieces.magnitude(point)) +
               pieces.scaled(underflow_noise);
    }
    // The minimum that a descent from these parameters comes to.
    Foot local(const double *guess);

protected:
    // A point of a piece, without rounded parameters.
    struct FootCandidate {
        int64_t piece = -1;
        AxisValues at{};
        double value = 0;     // sign * distance
        double error = 0;     // of it
        bool certain = false; // that it is a minimum
    };

    [[nodiscard]] PatchBox box(int64_t piece) const noexcept;
    // How far rounding may have moved a point of a piece.
    [[nodiscard]] double moved(int64_t piece, const AxisValues &at) const;
    // Descends across pieces; false if it takes too many steps.
    bool walk(FootCandidate &place);
    bool walk_on(FootCandidate &place);
    [[nodiscard]] bool same_point(const FootCandidate &a, const FootCandidate &b);
    [[nodiscard]] bool same_params(const FootCandidate &a, const FootCandidate &b) const noexcept;
    [[nodiscard]] std::vector<double> point_of(const FootCandidate &place);
    // How far points at such a distance are apart that rounding cannot tell apart.
    [[nodiscard]] double least_apart(double value) const noexcept {
        return 8 * std::sqrt(noise_ * (std::abs(value) + noise_));
    }
    [[nodiscard]] double distance_at(int64_t piece, const Foot &foot) const;
    void polish(int64_t piece, Foot &foot) const;
    [[nodiscard]] Foot foot(const FootCandidate &place);
    [[nodiscard]] Foot any_point(); // if the query point is far away

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

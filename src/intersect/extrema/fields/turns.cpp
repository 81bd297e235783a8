// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/turns.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

using namespace extremum_kind;

class Across {
public:
    Across(const GradientField &field, const Walls &walls, const Stratum &stratum, const PieceIndex &home,
           const Part &box)
        : field_(field), walls_(walls), stratum_(stratum), home_(home), box_(box) {}

    TurnsAcross run() const {
        TurnsAcross result;
        uint32_t of_ends = 0;
        for (int k = 0; k < field_.axes(); ++k) {
            if (!stratum_.is_fixed(k)) {
                continue;
            }
            const bool end = joint(k) == JointKind::end;
            const int here = slope(stratum_, home_, k), beyond = end ? -here : beyond_joint(k);
            const bool above = !stratum_.upper_end(k);
            if (here == 0 || beyond == 0) {
                result.known = false;
                continue;
            }
            const uint32_t turn = above ? turn_of(beyond, here) : turn_of(here, beyond);
            of_ends |= end ? turn : 0;
            result.kinds |= turn == saddle ? 0 : turn;
            result.regular = result.regular || turn == saddle;
        }
        result.regular = result.regular || of_ends == (minimum | maximum);
        return result;
    }

private:
    [[nodiscard]] JointKind joint(int k) const noexcept {
        return field_.joint(k, stratum_.axes[static_cast<size_t>(k)].joint);
    }
    [[nodiscard]] int beyond_joint(int k) const {
        return joint(k) == JointKind::jump
                   ? walls_.sign(stratum_, home_, k)
                   : slope(stratum_.from_other_side(k), across(field_, stratum_, home_, k), k);
    }
    // The sign that the derivative along axis k has on all of the box, seen from one side.
    [[nodiscard]] int slope(const Stratum &stratum, const PieceIndex &home, int k) const {
        const auto parts = covered(field_, stratum, home, box_);
        if (!parts) {
            return 0;
        }
        const int sign = slope_sign(parts->front(), stratum, field_.axes(), k);
        const bool all = std::ranges::all_of(*parts, [&](const CoveredPart &part) {
            return slope_sign(part, stratum, field_.axes(), k) == sign;
        });
        return all ? sign : 0;
    }

    const GradientField &field_;
    const Walls &walls_;
    const Stratum &stratum_;
    const PieceIndex &home_;
    const Part &box_;
};

} // namespace

uint32_t TurnsAcross::together_with(uint32_t on_stratum) const noexcept {
    if (regular) {
        return 0;
    }
    const uint32_t all = kinds | on_stratum;
    if (!known || (all & undecided) != 0) {
        return undecided;
    }
    return all == minimum || all == maximum ? all : saddle;
}

TurnsAcross turns_across(const GradientField &field, const Walls &walls, const Stratum &stratum,
                         const PieceIndex &home, const Part &box) {
    return Across(field, walls, stratum, home, box).run();
}

} // namespace nrb::intersect

// SPDX-License-Identifier: MIT
// The parts of a domain on which a function is looked at by itself: all of it, the sides where it ends, and the places where
// it has a kink or jumps, of all dimensions (strata of M. Goresky and R. MacPherson, "Stratified Morse theory", 1988).
#pragma once

#include "intersect/extrema/fields/gradient_field.h"

namespace nrb::intersect {

// Along one axis: free, or at a joint, seen from the piece above or below it.
struct StratumAxis {
    bool fixed = false;
    int64_t joint = 0;
    bool from_above = true;
};

struct Stratum {
    std::array<StratumAxis, max_axes> axes{};

    [[nodiscard]] bool is_fixed(int k) const noexcept { return axes[static_cast<size_t>(k)].fixed; }
    // Which end of a piece is on it.
    [[nodiscard]] bool upper_end(int k) const noexcept { return !axes[static_cast<size_t>(k)].from_above; }
    [[nodiscard]] Sides sides() const noexcept {
        Sides result{};
        for (size_t k = 0; k < axes.size(); ++k) {
            result[k] = !axes[k].fixed ? Side::none : axes[k].from_above ? Side::lower : Side::upper;
        }
        return result;
    }
    // The same place, seen from the other piece along an axis that is fixed.
    [[nodiscard]] Stratum from_other_side(int k) const noexcept {
        Stratum other = *this;
        other.axes[static_cast<size_t>(k)].from_above = !other.axes[static_cast<size_t>(k)].from_above;
        return other;
    }
    // With an axis that is no longer fixed.
    [[nodiscard]] Stratum freed(int k) const noexcept {
        Stratum other = *this;
        other.axes[static_cast<size_t>(k)] = {};
        return other;
    }
};

// Of all dimensions, the whole domain first. At a jump there are two, one for each limit.
class Strata {
public:
    explicit Strata(const GradientField &field);

    [[nodiscard]] int64_t count() const noexcept;
    [[nodiscard]] Stratum operator[](int64_t i) const noexcept;

private:
    std::array<std::vector<StratumAxis>, max_axes> choices_; // of each axis
};

// The pieces of the field that have a part in a stratum.
std::vector<PieceIndex> pieces_of(const GradientField &field, const Stratum &stratum);

// On the stratum: of degree 0 along axes that are fixed.
RoundedPolynomial on_stratum(RoundedPolynomial f, const pieces::HomogeneousPiece &piece,
                             const Stratum &stratum, int axes);

// In places along each axis of a piece.
inline constexpr Part all_of_piece{{{0, 1}, {0, 1}, {0, 1}}};
// The parameters of a box, which is in places of a piece, or of those beside it, along axes that are free.
Part range_of(const GradientField &field, const Stratum &stratum, const PieceIndex &home, const Part &box);

// The piece on the other side of a joint along an axis that is fixed.
PieceIndex across(const GradientField &field, const Stratum &stratum, PieceIndex index, int k);

} // namespace nrb::intersect

// SPDX-License-Identifier: MIT
// Scalar splines of several axes as pieces with their gradients, and how these are joined.
#pragma once

#include "intersect/extrema/constant_layers.h"
#include "pieces/derivative_pieces.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace nrb::intersect {

using PieceIndex = std::array<int64_t, max_axes>; // by axes of the spline; 0 on those that it lacks

// f = A / w and the numerators D_k = A_k w - A w_k of its derivatives f_k = D_k / w^2 by places on the piece, whose unit
// is a power of two.
struct GradientPiece {
    pieces::HomogeneousPiece piece;
    std::vector<RoundedPolynomial> slopes;
    int exponent = 0;
    ConstantLayers constants;

    [[nodiscard]] double length(int k) const noexcept {
        const Interval range = piece.part[static_cast<size_t>(k)];
        return range.upper - range.lower;
    }
};
using GradientPiecePtr = std::shared_ptr<const GradientPiece>;

// What is known, by multiplicities, of f where pieces are joined along an axis.
enum class JointKind : unsigned char {
    end,    // of the domain
    smooth, // derivatives are continuous
    kink,   // f is
    jump,
};

class GradientField {
public:
    explicit GradientField(const Spline &spline);

    [[nodiscard]] int axes() const noexcept { return spline_.axes(); }
    [[nodiscard]] int64_t count(int k) const noexcept { return maker_.count(k); }
    [[nodiscard]] const KnotVector &axis(int k) const noexcept { return spline_.axis(k); }
    // Where joint i is, before piece i.
    [[nodiscard]] double parameter(int k, int64_t i) const noexcept {
        return maker_.breaks(k)[static_cast<size_t>(i)];
    }
    [[nodiscard]] JointKind joint(int k, int64_t i) const noexcept {
        return joints_[static_cast<size_t>(k)][static_cast<size_t>(i)];
    }
    // Of places on a piece or beside it, with what rounding may cut off; inside of the domain unless the axis is periodic.
    [[nodiscard]] Interval parameters(int k, int64_t i, Interval places) const noexcept;
    // The piece that holds a parameter of the domain.
    [[nodiscard]] int64_t piece_at(int k, double parameter) const noexcept;
    // The piece beside a joint along an axis; the axis is periodic if there is none otherwise.
    [[nodiscard]] int64_t beside(int k, int64_t joint, bool upper) const noexcept {
        return upper ? joint % count(k) : (joint + count(k) - 1) % count(k);
    }
    [[nodiscard]] ConstantLayers constants(const PieceIndex &index, const Sides &sides = {}) const;
    // Throws Status::not_representable.
    [[nodiscard]] GradientPiecePtr piece(const PieceIndex &index) const;
    [[nodiscard]] int64_t number(const PieceIndex &index) const noexcept;

private:
    [[nodiscard]] JointKind joint_of(int k, int64_t i) const;
    [[nodiscard]] bool continuous(int k, int64_t left, int64_t right) const noexcept;
    [[nodiscard]] GradientPiecePtr made(const PieceIndex &index, int64_t at) const;

    const Spline &spline_;
    pieces::PieceMaker maker_;
    std::array<std::vector<JointKind>, max_axes> joints_;
    std::array<std::vector<int64_t>, max_axes> spans_;
    // Of pieces that were asked for, as long as they are not too many.
    mutable std::unordered_map<int64_t, GradientPiecePtr> kept_;
    mutable int64_t kept_values_ = 0;
};

} // namespace nrb::intersect

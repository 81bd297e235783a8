// SPDX-License-Identifier: MIT
// Functions over a surface made of its pieces and their derivatives.
#pragma once

#include "intersect/levels/fields/level_field.h"
#include "intersect/levels/fields/surface_borders.h"
#include "pieces/derivative_pieces.h"

#include <functional>

namespace nrb::intersect {

// Throws Status::degree for a function of such a degree on an axis of degree p, if it is too high.
void check_function_degree(const Spline &surface, const std::function<int(int p)> &degree);

// Any polynomial in those of a piece, divided by its zeros along sides of one point, where normals vanish. Its other zeros
// are told apart as far as rounding allows. With a sign function zeros count where that is positive.
class PieceField final : public LevelField {
public:
    using Function = std::function<RoundedPolynomial(const pieces::HomogeneousPiece &)>;
    PieceField(const Spline &surface, const pieces::PieceGrid &grid, Function function, Function sign = {});

    [[nodiscard]] std::array<int, 2> degrees() const override { return degrees_; }
    [[nodiscard]] bool may_vanish(int64_t piece) override { return !sign_ || sign_net(piece).side(1) >= 0; }
    [[nodiscard]] bool counts(int64_t piece, const std::array<double, 2> &place) override;
    LevelNet net(int64_t piece) override;
    [[nodiscard]] bool may_jump() const noexcept override { return true; }
    [[nodiscard]] double resolution(double) const noexcept override { return 0; }

private:
    LevelNet net_of(int64_t piece, const Function &function) const;
    const LevelNet &sign_net(int64_t piece);
    void divide_at_poles(const pieces::HomogeneousPiece &made, const pieces::PieceGrid::Index &index,
                         RoundedPolynomial &f) const;

    SurfaceBorders borders_;
    pieces::PieceMaker maker_;
    Function function_, sign_;
    int64_t sign_piece_ = -1;
    LevelNet sign_net_; // of that piece
    std::array<int, 2> degrees_{};
};

} // namespace nrb::intersect

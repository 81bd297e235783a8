// SPDX-License-Identifier: MIT
#include "intersect/levels/fields/piece_field.h"

#include "base/error.h"
#include "base/watch.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

// The degrees of a polynomial on the axes of a surface.
std::array<int, 2> degrees_of(const pieces::HomogeneousPiece &piece, const RoundedPolynomial &f) noexcept {
    return {f.shape.degrees[static_cast<size_t>(piece.axis(0))],
            f.shape.degrees[static_cast<size_t>(piece.axis(1))]};
}

} // namespace

void check_function_degree(const Spline &surface, const std::function<int(int p)> &degree) {
    for (int k = 0; k < 2; ++k) {
        const int p = surface.axis(k).degree(), of_function = degree(p);
        if (of_function > max_product_degree) {
            fail(Status::degree,
                 "degree %d of the surface on axis %d gives a function of degree %d, above the limit of %d",
                 p, k, of_function, max_product_degree);
        }
    }
}

PieceField::PieceField(const Spline &surface, const pieces::PieceGrid &grid, Function function, Function sign)
    : LevelField(grid), borders_(grid),
      maker_(surface, {surface.axis(0).domain(), surface.axis(1).domain(), {}}),
      function_(std::move(function)), sign_(std::move(sign)) {
    const pieces::HomogeneousPiece first = maker_.piece(0);
    degrees_ = degrees_of(first, function_(first));
}

void PieceField::divide_at_poles(const pieces::HomogeneousPiece &made, const pieces::PieceGrid::Index &index,
                                 RoundedPolynomial &f) const {
    for (size_t k = 0; k < 2; ++k) {
        for (const bool upper : {false, true}) {
            if (borders_.is_collapsed(k, index[k], upper)) {
                divide_end(f, made.axis(static_cast<int>(k)), upper);
            }
        }
    }
}

LevelNet PieceField::net_of(int64_t piece, const Function &function) const {
    const pieces::PieceGrid::Index index = grid().index(piece);
    const pieces::HomogeneousPiece made = maker_.piece(index[0] * maker_.count(1) + index[1]);
    RoundedPolynomial f = function(made);
    divide_at_poles(made, index, f);
    const int64_t size = std::ssize(f.values);
    count_work(size * (64 + size)); // products of factors of about half the degree
    LevelNet net;
    net.degrees = degrees_of(made, f);
    net.least_weight = least_weight();
    for (size_t i = 0; i < f.values.size(); ++i) {
        net.noise.absolute = std::max(net.noise.absolute, f.error(i));
    }
    net.values = f.values;
    return net;
}

LevelNet PieceField::net(int64_t piece) {
    return net_of(piece, function_);
}

const LevelNet &PieceField::sign_net(int64_t piece) {
    if (piece != sign_piece_) {
        sign_net_ = net_of(piece, sign_);
        sign_piece_ = piece;
    }
    return sign_net_;
}

// What rounding hides counts.
bool PieceField::counts(int64_t piece, const std::array<double, 2> &place) {
    return !sign_ || sign_net(piece).value(place) >= -sign_net(piece).noise.absolute;
}

} // namespace nrb::intersect

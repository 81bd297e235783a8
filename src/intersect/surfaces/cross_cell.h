// SPDX-License-Identifier: MIT
// Bezier pieces of surfaces in space, and their parts ('cells'), with bounds of points and derivatives for
// the search for common curves by subdivision.
// A 'place' is a pair of local parameters that run from 0 to 1 over a piece or a part.
#pragma once

#include "intersect/levels/fields/surface_borders.h"
#include "intersect/wide_part.h"
#include "numeric/vector3.h"
#include "pieces/tree/framed_pieces.h"

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

namespace nrb::intersect {

// The box of a part does not end where the part does: its sides are shifted a little. Common curves often run
// exactly along knots and middles of parts, or through the corners between them, but hardly ever along lines
// that are shifted by an arbitrary number. Where the surface ends or jumps, the box ends beyond the border by
// as much, so that curves along the border are inside. Each axis has a shift of its own, since both surfaces
// may be graphs over one plane.
constexpr double shift_of_sides = 0x1.3cp-38; // the largest one, in lengths of pieces
using SideShifts = std::array<double, 2>;
constexpr std::array<SideShifts, 2> side_shifts{
    SideShifts{shift_of_sides, 0x1.1p-1 * shift_of_sides},
    SideShifts{0x1.9p-1 * shift_of_sides, 0x1.5p-2 * shift_of_sides}};
// How far arcs along a border of a piece may be beyond it, in lengths of pieces, before it is decided which
// of the two pieces has them.
constexpr double room_along_sides = 0x1p-7;

struct CrossPiece;

// What all pieces of a surface share, and the pieces themselves.
class CrossGround {
public:
    CrossGround(const Spline &surface, const pieces::Frame &frame, const SurfaceBorders &ends,
                const SideShifts &of_axes);
    ~CrossGround();
    CrossGround(const CrossGround &) = delete;
    CrossGround &operator=(const CrossGround &) = delete;

    // The piece with an index, made at the first call; null: its weights are not all positive.
    [[nodiscard]] const CrossPiece *piece(const pieces::PieceGrid::Index &index);

    const pieces::PieceGrid &grid;
    const SurfaceBorders &borders;
    SideShifts shifts;
    std::array<std::vector<double>, 2> widenings; // matrices from coefficients to those of the wide part

private:
    pieces::FramedPieces pieces_;
    std::map<int64_t, std::unique_ptr<const CrossPiece>> made_;
};

// A Bezier piece with positive weights, in the frame that both surfaces share. It is a piece of the surface,
// or a part of one that has weights of no certain sign.
struct CrossPiece {
    CrossPiece(pieces::BezierPiece made, CrossGround &of);

    struct Point {
        Vector3 at;
        std::array<Vector3, 2> slope; // derivatives by places in the piece
        std::array<double, 2> turn;   // derivatives of the weight, relative to it
    };
    // At a place in [0, 1]^2 or slightly outside.
    [[nodiscard]] Point evaluate(const std::array<double, 2> &place) const noexcept;

    CrossGround *ground;
    pieces::BezierPiece piece;
    std::array<int, 2> degrees{};
    pieces::PieceGrid::Index index{}; // of the piece of the surface that it is, or is a part of
    std::array<Interval, 2> range{};  // parameters
    // Places in that piece of the surface: all of it, if weights are positive there.
    std::array<Interval, 2> within{};
    std::array<std::array<bool, 2>, 2> open{};     // [axis][end]: the surface ends or jumps there
    std::array<std::array<bool, 2>, 2> poles{};    // [axis][end]: the side is one point (a pole)
    std::array<std::array<double, 2>, 2> shifts{}; // [axis][end]: of sides on the border, in places
    SideShifts shift{};                            // [axis]: of sides inside the piece, in places
    std::array<std::array<double, 2>, 2> rooms{};  // [axis][end]: for arcs along the border, in places
    double largest_weight = 0;
    double error = 0; // bound, of evaluated points

private:
    void set_sides(const pieces::PieceGrid &grid, const SurfaceBorders &borders);
};

// Bounds of the dot products of a vector with what is in the wide part: with points, taken from the centre,
// and with the derivatives along both axes, by places in the part.
struct CrossExtents {
    Interval points;
    std::array<Interval, 2> slopes;
};

// The same with the second derivatives: 00, 01 and 11.
struct CrossBends {
    CrossExtents extents;
    std::array<Interval, 3> bends;
};

// A part of a piece, made by halving along one axis or the other repeatedly. What is proven of it is proven
// of the wide part: the part with some room on all sides (wide_part.h). The data for that are computed by
// prepare().
class CrossCell {
public:
    // All of a piece. memory: for the part and its halves, which it outlives.
    CrossCell(const CrossPiece &piece, std::pmr::memory_resource *memory);
    // A half of a part along an axis; records: its coefficients.
    CrossCell(const CrossCell &whole, size_t axis, size_t end, std::pmr::vector<double> records);
    // What is between places of a part; records: its coefficients.
    CrossCell(const CrossCell &whole, const std::array<Interval, 2> &places,
              std::pmr::vector<double> records);
    // Any part of a piece, on its own: it is not halved further.
    CrossCell(const CrossPiece &piece, const std::array<Interval, 2> &places);
    CrossCell(CrossCell &&other) noexcept;
    ~CrossCell();

    [[nodiscard]] const CrossPiece &piece() const noexcept { return *piece_; }
    [[nodiscard]] double lower(size_t axis) const noexcept { return lower_[axis]; } // in [0, 1]
    [[nodiscard]] double length(size_t axis) const noexcept { return length_[axis]; }
    // Places in the piece from those in the part, and the other way round.
    [[nodiscard]] std::array<double, 2> in_piece(const double *place) const noexcept {
        return {lower_[0] + length_[0] * place[0], lower_[1] + length_[1] * place[1]};
    }
    [[nodiscard]] double in_part(size_t axis, double place) const noexcept {
        return (place - lower_[axis]) / length_[axis];
    }
    // The parameters that it covers.
    [[nodiscard]] std::array<Interval, 2> ranges() const noexcept;
    // The shifted side where its box ends, as a place in the part.
    [[nodiscard]] double side(size_t axis, size_t end) const noexcept;
    [[nodiscard]] bool is_open(size_t axis, size_t end) const noexcept;
    // How far beyond a side of its box arcs along that side are followed, in places of the part; 0 for sides
    // inside the piece.
    [[nodiscard]] double room(size_t axis, size_t end) const noexcept;
    // Whether a side is on the border of the piece.
    [[nodiscard]] bool is_border(size_t axis, size_t end) const noexcept { return !is_inside(axis, end); }
    // The strip of the neighbouring piece beyond a side on the border, as long as the side and as wide as
    // arcs are followed there. factor: makes its derivatives along the axis those by places in this part.
    // None: the weights of the neighbour are not positive, or an axis has degree 0. Precondition: the side is
    // not open, and its room is not 0.
    struct Beyond;
    [[nodiscard]] std::optional<Beyond> beyond(size_t axis, size_t end) const;
    // Whether a side of it is one point (a pole), where a derivative vanishes.
    [[nodiscard]] bool has_pole() const noexcept;

    // The bounding box of the control points, and its longest side.
    [[nodiscard]] const std::array<Interval, 3> &box() const noexcept { return box_; }
    [[nodiscard]] double size() const noexcept { return size_; }
    // Error bound of the control points, which each halving makes a little larger.
    [[nodiscard]] double error() const noexcept { return error_; }
    // Bounds of the dot products of a vector and the control points.
    [[nodiscard]] Interval hull_along(const Vector3 &vector) const noexcept;

    // Computes the data of the wide part, which the members below are about, up to amplified(). False: its
    // weights are not all well above 0, or an axis has degree 0.
    bool prepare();
    [[nodiscard]] const Vector3 &centre() const noexcept { return centre_; } // the point in the middle
    [[nodiscard]] const Vector3 &slope(size_t axis) const noexcept { return slope_[axis]; }
    [[nodiscard]] double slope_error(size_t axis) const noexcept { return slope_errors_[axis]; }
    [[nodiscard]] CrossExtents along(const Vector3 &vector) const noexcept;
    [[nodiscard]] Interval points_along(const Vector3 &vector) const noexcept;
    [[nodiscard]] CrossBends bends_along(const Vector3 &vector) const;
    [[nodiscard]] std::array<Interval, 3> seconds_along(const Vector3 &vector) const; // the bends alone
    // A bound of the lengths of the derivatives by places in the part.
    [[nodiscard]] double largest_slope(size_t axis) const noexcept;
    [[nodiscard]] double least_weight() const noexcept { return weights_.lower; }
    // Error bound of bounds of points of the part that follow from the control points of the wide part.
    [[nodiscard]] double wide_error() const noexcept { return wide_error_; }
    // How many times as large as in the piece errors of points may be that are evaluated in the wide part,
    // which may run beyond the piece.
    [[nodiscard]] double amplified() const noexcept { return amplified_; }

    // Its halves along an axis; without one, along an axis that is chosen at the first such call. Null: the
    // part is too small, or the axis has degree 0.
    using Halves = std::array<CrossCell *, 2>;
    Halves halves(std::deque<CrossCell> &all, std::optional<size_t> along = std::nullopt);
    // What is between places of it; null: it is too small. Precondition: at each side that is new, a margin
    // of 2^-12 of this part holds no zeros, because sides of boxes are shifted.
    CrossCell *part(std::deque<CrossCell> &all, const std::array<Interval, 2> &places) const;

private:
    [[nodiscard]] std::span<const double> points() const noexcept { return {wide_.data(), wide_.size() / 3}; }
    [[nodiscard]] std::span<const double> slopes(size_t axis) const noexcept {
        return {wide_.data() + (1 + axis) * (wide_.size() / 3), wide_.size() / 3};
    }
    [[nodiscard]] bool is_inside(size_t axis, size_t end) const noexcept; // a side: not on the border
    void set_box();
    // From the records of the part to those of the wide part. half: working memory of the same size.
    void widen(const double *records, double *half, double *wide) const;
    void set_wide(std::vector<double> &records);
    void set_errors() noexcept;
    [[nodiscard]] std::vector<double> derivatives(const std::vector<double> &records, size_t axis);
    void set_slopes(const std::vector<double> &records, size_t axis, double turn);
    [[nodiscard]] size_t axis_of_halves() const noexcept;
    [[nodiscard]] bool has_weights() const noexcept;
    [[nodiscard]] std::array<Interval, 3> seconds_from(const Vector3 &vector,
                                                       const CrossExtents &extents) const;
    struct Seconds;
    struct DeleteSeconds {
        void operator()(const Seconds *seconds) const noexcept;
    };
    [[nodiscard]] const Seconds &seconds() const; // made at the first call

    const CrossPiece *piece_;
    std::array<double, 2> lower_{0, 0}, upper_{1, 1}, length_{1, 1};
    int depth_ = 0;
    std::pmr::vector<double> records_; // [degree + 1][degree + 1][4]
    std::array<Interval, 3> box_{};
    double size_ = 0;

    enum class State { unknown, positive, other } state_ = State::unknown;
    // Of the wide part: control points from the centre, then for each axis the coefficients of set_slopes().
    // One block of memory, because there are many cells.
    std::pmr::vector<double> wide_;
    std::array<double, 2> turns_{}, bends_{}; // the largest |w_k - r w|; how much derivatives change
    Interval weights_{1, 1};
    double error_ = 0, wide_error_ = 0, amplified_ = 1, reach_ = 0;
    std::array<double, 2> slope_errors_{};
    Vector3 centre_;
    std::array<Vector3, 2> slope_;
    std::array<Halves, 2> halves_{}; // by axes
    std::optional<size_t> usual_axis_;
    mutable std::unique_ptr<const Seconds, DeleteSeconds> seconds_;
};

// Whether their boxes are apart, by more than the errors.
bool are_apart(const CrossCell &a, const CrossCell &b) noexcept;

struct CrossCell::Beyond {
    CrossCell cell;
    size_t axis;
    double factor;
};

} // namespace nrb::intersect

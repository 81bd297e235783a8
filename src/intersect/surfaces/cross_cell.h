// SPDX-License-Identifier: MIT
// Pieces of surfaces in space, and their parts, as the search for common curves looks at them.
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

// Boxes of parts do not end where the parts do, but a little farther: common curves often run exactly along knots and
// middles, or through corners of these, and hardly ever along what is shifted by a number that nobody has in mind. Where the
// surface ends or jumps boxes end beyond it by as much, so that what runs along a border is inside. Each axis has a shift of its
// own, since two surfaces may be graphs over one plane.
constexpr double shift_of_sides = 0x1.3cp-38; // the largest one, in parts of pieces
using SideShifts = std::array<double, 2>;
constexpr std::array<SideShifts, 2> side_shifts{
    SideShifts{shift_of_sides, 0x1.1p-1 * shift_of_sides},
    SideShifts{0x1.9p-1 * shift_of_sides, 0x1.5p-2 * shift_of_sides}};
// How far arcs that run along a border of a piece may be beyond it, in parts of pieces, before it is decided whose they are.
constexpr double room_along_sides = 0x1p-7;

struct CrossPiece;

// What the pieces of a surface have in common.
class CrossGround {
public:
    CrossGround(const Spline &surface, const pieces::Frame &frame, const SurfaceBorders &ends,
                const SideShifts &of_axes);
    ~CrossGround();
    CrossGround(const CrossGround &) = delete;
    CrossGround &operator=(const CrossGround &) = delete;

    // The piece of the surface with an index, made when it is first asked for; null: its weights are not positive.
    [[nodiscard]] const CrossPiece *piece(const pieces::PieceGrid::Index &index);

    const pieces::PieceGrid &grid;
    const SurfaceBorders &borders;
    SideShifts shifts;
    std::array<std::vector<double>, 2> widenings; // of coefficients along an axis, to those of the wide part

private:
    pieces::FramedPieces pieces_;
    std::map<int64_t, std::unique_ptr<const CrossPiece>> made_;
};

// A Bezier piece with positive weights, about the centre of both surfaces.
struct CrossPiece {
    CrossPiece(pieces::BezierPiece made, CrossGround &of);

    struct Point {
        Vector3 at;
        std::array<Vector3, 2> slope; // by places
        std::array<double, 2> turn;   // of the weight, in parts of it
    };
    // At a place in [0, 1]^2, or not far outside.
    [[nodiscard]] Point evaluate(const std::array<double, 2> &place) const noexcept;

    CrossGround *ground;
    pieces::BezierPiece piece;
    std::array<int, 2> degrees{};
    pieces::PieceGrid::Index index{}; // of the piece of the surface that it is a part of
    std::array<Interval, 2> range{};  // parameters
    std::array<Interval, 2>
        within{}; // places in that piece of the surface: all of it, if weights are positive there
    std::array<std::array<bool, 2>, 2> open{};     // [axis][end]: the surface ends there
    std::array<std::array<bool, 2>, 2> poles{};    // [axis][end]: the side is one point
    std::array<std::array<double, 2>, 2> shifts{}; // [axis][end], of the sides of its box, by places
    SideShifts shift{};                            // the same of sides inside of the piece
    std::array<std::array<double, 2>, 2> rooms{};  // [axis][end], for arcs along them, by places
    double largest_weight = 0;
    double error = 0; // of points that are evaluated

private:
    void set_sides(const pieces::PieceGrid &grid, const SurfaceBorders &borders);
};

// Between which numbers the products of a vector lie: with what is in the wide part, from its centre, and with the
// derivatives along both axes by places in the part.
struct CrossExtents {
    Interval points;
    std::array<Interval, 2> slopes;
};

// The same with all second derivatives: by both, 00, 01 and 11.
struct CrossBends {
    CrossExtents extents;
    std::array<Interval, 3> bends;
};

// A part of a piece, of half its length along an axis again and again. What is known of the wide part is made when it is
// asked for.
class CrossCell {
public:
    // memory: of the part and its halves, which lasts as long as they do.
    CrossCell(const CrossPiece &piece, std::pmr::memory_resource *memory);
    // A half, with its records.
    CrossCell(const CrossCell &whole, size_t axis, size_t end, std::pmr::vector<double> records);
    // A part between places, with its records.
    CrossCell(const CrossCell &whole, const std::array<Interval, 2> &places,
              std::pmr::vector<double> records);
    // Any part, which is not halved.
    CrossCell(const CrossPiece &piece, const std::array<Interval, 2> &places);
    CrossCell(CrossCell &&other) noexcept;
    ~CrossCell();

    [[nodiscard]] const CrossPiece &piece() const noexcept { return *piece_; }
    [[nodiscard]] double lower(size_t axis) const noexcept { return lower_[axis]; } // in [0, 1]
    [[nodiscard]] double length(size_t axis) const noexcept { return length_[axis]; }
    // In places of the piece from those in the part, and back.
    [[nodiscard]] std::array<double, 2> in_piece(const double *place) const noexcept {
        return {lower_[0] + length_[0] * place[0], lower_[1] + length_[1] * place[1]};
    }
    [[nodiscard]] double in_part(size_t axis, double place) const noexcept {
        return (place - lower_[axis]) / length_[axis];
    }
    // Of parameters.
    [[nodiscard]] std::array<Interval, 2> ranges() const noexcept;
    // Where its box ends, as places in the part.
    [[nodiscard]] double side(size_t axis, size_t end) const noexcept;
    [[nodiscard]] bool is_open(size_t axis, size_t end) const noexcept;
    // How far beyond its box arcs along a side may be, as places in the part; 0 for sides inside of the piece.
    [[nodiscard]] double room(size_t axis, size_t end) const noexcept;
    // Whether a side is one of the piece.
    [[nodiscard]] bool is_border(size_t axis, size_t end) const noexcept { return !is_inside(axis, end); }
    // What is beyond such a side, as wide as the room, along this part: with the factor that makes derivatives along
    // the axis those by places in this part. None: the surface ends there, or has no derivatives.
    struct Beyond;
    [[nodiscard]] std::optional<Beyond> beyond(size_t axis, size_t end) const;
    // Whether a side of it is one point, in which a derivative vanishes.
    [[nodiscard]] bool has_pole() const noexcept;

    // The box of the control points, and its largest side.
    [[nodiscard]] const std::array<Interval, 3> &box() const noexcept { return box_; }
    [[nodiscard]] double size() const noexcept { return size_; }
    // Of control points, which each halving makes a little larger.
    [[nodiscard]] double error() const noexcept { return error_; }
    // Between which numbers the products of a vector and the control points lie.
    [[nodiscard]] Interval hull_along(const Vector3 &vector) const noexcept;

    // What follows is of the wide part; false: its weights are not positive.
    bool prepare();
    [[nodiscard]] const Vector3 &centre() const noexcept { return centre_; } // the point in the middle
    [[nodiscard]] const Vector3 &slope(size_t axis) const noexcept { return slope_[axis]; }
    [[nodiscard]] double slope_error(size_t axis) const noexcept { return slope_errors_[axis]; }
    [[nodiscard]] CrossExtents along(const Vector3 &vector) const noexcept;
    [[nodiscard]] Interval points_along(const Vector3 &vector) const noexcept;
    [[nodiscard]] CrossBends bends_along(const Vector3 &vector) const;
    [[nodiscard]] std::array<Interval, 3> seconds_along(const Vector3 &vector) const; // bends alone
    // Of derivatives by places in the part.
    [[nodiscard]] double largest_slope(size_t axis) const noexcept;
    [[nodiscard]] double least_weight() const noexcept { return weights_.lower; }

    // Its halves along an axis, or along one that is always the same; null: it is too small. Of an axis without a degree there
    // are none.
    using Halves = std::array<CrossCell *, 2>;
    Halves halves(std::deque<CrossCell> &all, std::optional<size_t> axis = std::nullopt);
    // A part of it, with a 2^-12th of it at each side that is empty, as sides are shifted; null: it is too small.
    CrossCell *part(std::deque<CrossCell> &all, const std::array<Interval, 2> &places) const;

private:
    [[nodiscard]] std::span<const double> points() const noexcept { return {wide_.data(), wide_.size() / 3}; }
    [[nodiscard]] std::span<const double> slopes(size_t axis) const noexcept {
        return {wide_.data() + (1 + axis) * (wide_.size() / 3), wide_.size() / 3};
    }
    [[nodiscard]] bool is_inside(size_t axis, size_t end) const noexcept; // a side, of the piece
    void set_box();
    // Records of the wide part; half: room for as many.
    void widen(const double *records, double *half, double *wide) const;
    void set_wide(std::vector<double> &records);
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
    [[nodiscard]] const Seconds &seconds() const; // made when they are first asked for

    const CrossPiece *piece_;
    std::array<double, 2> lower_{0, 0}, upper_{1, 1}, length_{1, 1};
    int depth_ = 0;
    std::pmr::vector<double> records_; // [degree + 1][degree + 1][4]
    std::array<Interval, 3> box_{};
    double size_ = 0;

    enum class State { unknown, positive, other } state_ = State::unknown;
    // Of the wide part: points from the centre, and of both axes those of set_slopes(); in one piece, as cells are many.
    std::pmr::vector<double> wide_;
    std::array<double, 2> turns_{}, bends_{}; // of weights; how much derivatives change
    Interval weights_{1, 1};
    double error_ = 0, reach_ = 0;
    std::array<double, 2> slope_errors_{};
    Vector3 centre_;
    std::array<Vector3, 2> slope_;
    std::array<Halves, 2> halves_{}; // by axes
    std::optional<size_t> usual_axis_;
    mutable std::unique_ptr<const Seconds, DeleteSeconds> seconds_;
};

// Whether their boxes are.
bool are_apart(const CrossCell &a, const CrossCell &b) noexcept;

struct CrossCell::Beyond {
    CrossCell cell;
    size_t axis;
    double factor;
};

} // namespace nrb::intersect

// SPDX-License-Identifier: MIT
#include "face/face_box.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "face/boundary.h"
#include "face/open_ends.h"
#include "pieces/derivative_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace nrb::face {

namespace {

constexpr int most_halved_cells = 20000;
constexpr int64_t work_of_a_cell = 4000;

// The sides of a box: the largest values of the coordinates and of their negatives.
using Sides = std::vector<double>;

Sides sides_of(const bounds::Box &box) {
    Sides sides;
    for (size_t c = 0; c < box.upper.size(); ++c) {
        sides.push_back(box.upper[c]);
        sides.push_back(-box.lower[c]);
    }
    return sides;
}

// A cell: several spans of both axes, or a part of one span of each.
struct FaceCell {
    std::array<std::array<size_t, 2>, 2> breaks; // first and last, of each axis
    Part part{};
    Sides sides;
    bool alive = true;
    bool examined = false; // whether sides were dropped on which nothing inside is extreme
};

// The breaks of an axis; for each, whether tangents (crease) or points (jump) may jump there.
struct CellAxis {
    std::vector<double> breaks;
    std::vector<char> crease, jump;

    CellAxis(const KnotVector &axis, bool closed) {
        const Interval domain = axis.domain();
        for (const KnotGroup &group : distinct_knots(axis.knots())) {
            if (domain.lower <= group.knot && group.knot <= domain.upper) {
                const bool end = group.knot == domain.lower || group.knot == domain.upper;
                breaks.push_back(group.knot);
                crease.push_back(end ? closed : group.multiplicity >= axis.degree());
                jump.push_back(!end && group.multiplicity > axis.degree());
            }
        }
    }
    [[nodiscard]] bool jumps_at(double at) const {
        const auto found = std::lower_bound(breaks.begin(), breaks.end(), at);
        return found != breaks.end() && *found == at &&
               jump[static_cast<size_t>(found - breaks.begin())] != 0;
    }
    [[nodiscard]] bool touches_jump(Interval part) const {
        return jumps_at(part.lower) || jumps_at(part.upper);
    }
    // The span on the other side of a crease at a parameter, above or below it; at a seam, the span at the
    // other end of the axis.
    [[nodiscard]] std::optional<Interval> span_beyond_crease(double at, bool above) const {
        const size_t i =
            static_cast<size_t>(std::lower_bound(breaks.begin(), breaks.end(), at) - breaks.begin());
        if (i == breaks.size() || breaks[i] != at || crease[i] == 0) {
            return std::nullopt;
        }
        const size_t last = breaks.size() - 1;
        const size_t from = above ? (i == last ? 0 : i) : (i == 0 ? last : i) - 1;
        return Interval{breaks[from], breaks[from + 1]};
    }
};

using SideQueue = std::priority_queue<std::pair<double, size_t>>;

// Branch and bound: a queue of cells for each side of the box, the one that reaches farthest first.
class BoxSearch {
public:
    BoxSearch(const Face &face, double tolerance)
        : face_(face), surface_(*face.surface()), dim_(static_cast<size_t>(surface_.dim())),
          tolerance_(tolerance), axes_{CellAxis(surface_.axis(0), face.covering().closed(0)),
                                       CellAxis(surface_.axis(1), face.covering().closed(1))},
          reached_(2 * dim_, -infinity), boundary_(2 * dim_, -infinity), farthest_(2 * dim_) {}

    bounds::Box run() {
        add_boundary();
        add({{{0, axes_[0].breaks.size() - 1}, {0, axes_[1].breaks.size() - 1}}});
        for (int step = 0; step < most_halved_cells; ++step) {
            const std::optional<size_t> cell = farthest_cell();
            if (!cell || !refine(*cell)) {
                break;
            }
            count_work(work_of_a_cell);
        }
        return box();
    }

private:
    void reach(size_t side, double value) { reached_[side] = std::max(reached_[side], value); }

    void add_boundary() {
        for (const BoundaryCurve &curve : boundary_curves(face_)) {
            add_edge(curve.space);
        }
        if (!boundary_proven_) {
            reach_boundary();
        }
    }
    // Curves that cannot be composed are null; there the boundary is bounded by the cells that it cuts.
    void add_edge(const SplinePtr &edge) {
        if (edge == nullptr) {
            boundary_proven_ = false;
            return;
        }
        const bounds::Box box = bounds::bounding_box(*edge, whole_domain(*edge), tolerance_ / 4);
        const Sides sides = sides_of(box);
        for (size_t side = 0; side < 2 * dim_; ++side) {
            boundary_[side] = std::max(boundary_[side], sides[side]);
            reach(side, sides[side] - box.gap);
        }
    }
    // The starts, which are the ends of other pieces, and the middles of all pieces.
    void reach_boundary() {
        const TrimPieces &pieces = face_.trims().pieces();
        for (const TrimPiece &piece : pieces.all()) {
            for (const Point2 &x : {piece.start, pieces.point(piece, 0.5)}) {
                reach_point(point_at(surface_, face_.covering().in_domain(x)));
            }
        }
    }
    void reach_point(const std::vector<double> &point) {
        for (size_t c = 0; c < dim_; ++c) {
            reach(2 * c, point[c]);
            reach(2 * c + 1, -point[c]);
        }
    }

    // Adds the cell between breaks, unless it is outside of the face, or reaches no farther than points of
    // the face.
    void add(const std::array<std::array<size_t, 2>, 2> &breaks) {
        FaceCell cell{breaks, {}, {}};
        for (size_t k = 0; k < 2; ++k) {
            cell.part[k] = {axes_[k].breaks[breaks[k][0]], axes_[k].breaks[breaks[k][1]]};
        }
        add(std::move(cell));
    }
    void add(FaceCell cell) {
        const Point2 lower{cell.part[0].lower, cell.part[1].lower},
            upper{cell.part[0].upper, cell.part[1].upper};
        const Point2 middle{lower[0] / 2 + upper[0] / 2, lower[1] / 2 + upper[1] / 2};
        const bool cut = is_cut(cell.part);
        const bool inside = face_.trims().side(middle) >= 0;
        if (!inside && !cut) {
            return;
        }
        if (inside) {
            reach_point(point_at(surface_, middle));
        }
        cell.sides = sides_of(bounds::bounding_box(surface_, cell.part, infinity));
        push(std::move(cell));
    }
    [[nodiscard]] bool is_cut(const Part &part) const {
        return face_.trims().cuts({part[0].lower, part[1].lower}, {part[0].upper, part[1].upper});
    }
    void push(FaceCell cell) {
        bool matters = false;
        for (size_t side = 0; side < 2 * dim_; ++side) {
            if (cell.sides[side] > reached_[side]) {
                matters = true;
                farthest_[side].push({cell.sides[side], cells_.size()});
            }
        }
        if (matters) {
            cells_.push_back(std::move(cell));
        }
    }

    // How far the box has to reach on a side: as far as points of the face, the boundary and the remaining
    // cells.
    double outermost(size_t side) {
        SideQueue &queue = farthest_[side];
        while (!queue.empty() && !cells_[queue.top().second].alive) {
            queue.pop();
        }
        const double known = std::max(reached_[side], boundary_[side]);
        return queue.empty() ? known : std::max(known, queue.top().first);
    }
    // The cell that reaches farthest on the side where the box is farthest from the face; none if that is
    // near enough.
    std::optional<size_t> farthest_cell() {
        std::optional<size_t> farthest;
        double largest = tolerance_;
        for (size_t side = 0; side < 2 * dim_; ++side) {
            const double gap = outermost(side) - reached_[side];
            const SideQueue &queue = farthest_[side];
            if (gap > largest && !queue.empty() && queue.top().first > boundary_[side]) {
                largest = gap;
                farthest = queue.top().second;
            }
        }
        return farthest;
    }

    // Divides a cell; false if it cannot be made smaller.
    bool refine(size_t index) {
        FaceCell cell = cells_[index];
        cells_[index].alive = false;
        const bool one_span =
            cell.breaks[0][1] - cell.breaks[0][0] == 1 && cell.breaks[1][1] - cell.breaks[1][0] == 1;
        if (one_span && !cell.examined) {
            examine(cell);
            push(std::move(cell));
            return true;
        }
        if (one_span) {
            return quarter(cell);
        }
        const size_t k =
            cell.breaks[0][1] - cell.breaks[0][0] >= cell.breaks[1][1] - cell.breaks[1][0] ? 0 : 1;
        auto first = cell.breaks, second = cell.breaks;
        first[k][1] = second[k][0] = (cell.breaks[k][0] + cell.breaks[k][1]) / 2;
        add(first);
        add(second);
        return true;
    }
    // Drops the sides of a cell on which nothing inside is extreme. At a point inside the face where a
    // coordinate is extreme, both of its partial derivatives vanish, unless tangents jump there; extreme
    // points on the boundary are known. Across a crease, a coordinate is monotone if its derivatives on both
    // sides have the same sign. Cells beside a jump keep all sides, because points of both limits end there;
    // and so do cells that the boundary cuts if its reach is not proven.
    void examine(FaceCell &cell) const {
        cell.examined = true;
        if (axes_[0].touches_jump(cell.part[0]) || axes_[1].touches_jump(cell.part[1]) ||
            (!boundary_proven_ && is_cut(cell.part))) {
            return;
        }
        const std::array inside = derivatives(cell.part);
        std::array<std::vector<RoundedPolynomial>, 2> beyond;
        for (size_t k = 0; k < 2; ++k) {
            for (const Part &strip : strips_beyond_creases(cell.part, k)) {
                beyond[k].push_back(derivatives(strip)[k]);
            }
        }
        for (size_t c = 0; c < dim_; ++c) {
            const auto runs_on = [&](size_t k) {
                const int sign = sign_of(inside[k], c);
                return sign != 0 && std::all_of(beyond[k].begin(), beyond[k].end(),
                                                [&](const auto &other) { return sign_of(other, c) == sign; });
            };
            if (runs_on(0) || runs_on(1)) {
                cell.sides[2 * c] = cell.sides[2 * c + 1] = -infinity;
            }
        }
    }
    [[nodiscard]] std::array<RoundedPolynomial, 2> derivatives(const Part &part) const {
        const pieces::HomogeneousPiece piece = pieces::PieceMaker(surface_, part).piece(0);
        return {pieces::tangent_numerator(piece, 0), pieces::tangent_numerator(piece, 1)};
    }
    [[nodiscard]] static int sign_of(const RoundedPolynomial &derivative, size_t c) {
        return certain_sign(component(derivative, static_cast<int>(c)));
    }
    // Parts of the surface beyond the creases at the ends of a cell. They are as wide as the cell or as the
    // span beyond, whichever is less, but at least one step between neighbouring doubles, which may be larger
    // there than inside the cell.
    [[nodiscard]] std::vector<Part> strips_beyond_creases(const Part &part, size_t k) const {
        std::vector<Part> result;
        for (const bool upper : {false, true}) {
            if (const auto span = axes_[k].span_beyond_crease(upper ? part[k].upper : part[k].lower, upper)) {
                const double width = std::min(part[k].upper - part[k].lower, span->upper - span->lower);
                result.push_back(part);
                const double above = std::max(span->lower + width, std::nextafter(span->lower, span->upper)),
                             below = std::min(span->upper - width, std::nextafter(span->upper, span->lower));
                result.back()[k] = upper ? Interval{span->lower, std::min(above, span->upper)}
                                         : Interval{std::max(below, span->lower), span->upper};
            }
        }
        return result;
    }
    bool quarter(const FaceCell &cell) {
        Point2 middle;
        for (size_t k = 0; k < 2; ++k) {
            middle[k] = cell.part[k].lower / 2 + cell.part[k].upper / 2;
            if (!(cell.part[k].lower < middle[k] && middle[k] < cell.part[k].upper)) {
                return false;
            }
        }
        for (int number = 0; number < 4; ++number) {
            FaceCell part{cell.breaks, cell.part, {}};
            for (size_t k = 0; k < 2; ++k) {
                ((number >> k & 1) != 0 ? part.part[k].lower : part.part[k].upper) = middle[k];
            }
            add(std::move(part));
        }
        return true;
    }

    bounds::Box box() {
        bounds::Box result;
        for (size_t c = 0; c < dim_; ++c) {
            result.upper.push_back(outermost(2 * c));
            result.lower.push_back(-outermost(2 * c + 1));
        }
        for (size_t side = 0; side < 2 * dim_; ++side) {
            result.gap = std::max(result.gap, outermost(side) - reached_[side]);
        }
        return result;
    }

    const Face &face_;
    const Spline &surface_;
    size_t dim_;
    double tolerance_;
    std::array<CellAxis, 2> axes_;
    Sides reached_, boundary_;
    bool boundary_proven_ = true; // whether boundary_ holds for all of the boundary
    std::vector<FaceCell> cells_;
    std::vector<SideQueue> farthest_; // for each side; may contain cells that are not alive
};

} // namespace

bounds::Box bounding_box(const Face &face, double tolerance) {
    return BoxSearch(face, tolerance).run();
}

std::array<Interval, 2> smallest_rectangle(const Face &face) {
    std::array<Interval, 2> rectangle{Interval{infinity, -infinity}, Interval{infinity, -infinity}};
    const auto add = [&](const Point2 &x) {
        for (size_t k = 0; k < 2; ++k) {
            rectangle[k] = {std::min(rectangle[k].lower, x[k]), std::max(rectangle[k].upper, x[k])};
        }
    };
    for (const TrimPiece &piece : face.trims().pieces().all()) {
        add(piece.lower);
        add(piece.upper);
    }
    for (const EndPart &part : open_ends(face)) {
        add(part.from);
        add(part.to);
    }
    for (const int k : {0, 1}) {
        Interval &own = rectangle[static_cast<size_t>(k)];
        if (face.covering().closed(k) || !(own.lower <= own.upper)) {
            own = face.covering().domain(k);
        }
    }
    return rectangle;
}

} // namespace nrb::face

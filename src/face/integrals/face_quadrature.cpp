// SPDX-License-Identifier: MIT
#include "face/integrals/face_quadrature.h"

#include "base/checked.h"
#include "base/representable.h"
#include "base/watch.h"
#include "eval/evaluate.h"
#include "face/integrals/column.h"
#include "measure/elements.h"
#include "measure/spanned.h"
#include "numeric/gauss_rule.h"
#include "pieces/spline_pieces.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

constexpr int64_t work_of_a_place = 300;

// The lower or upper bound of a cell: a curve, or the line at a knot, from one side of the cell to the other.
struct Bound {
    const TrimPiece *piece; // null: the line
    double v;

    [[nodiscard]] double at(const TrimPieces &pieces, double u) const noexcept {
        return piece == nullptr ? v : pieces.point(*piece, pieces.place_of(*piece, 0, u))[1];
    }
    [[nodiscard]] bool straight() const noexcept {
        return piece == nullptr || (piece->degree == 1 && !piece->weighted);
    }
};

// Walks down the columns of the surface, and adds the points in the cells that are inside.
class CellWalk {
public:
    CellWalk(const Face &face, const std::vector<double> &v_breaks, int nodes)
        : pieces_(face.trims().pieces()), column_(face.trims(), v_breaks), rule_(gauss_rule(nodes)) {}

    void walk(Interval column, const std::vector<const TrimPiece *> &pieces) {
        column_.set(column, pieces);
        const std::vector<double> &places = column_.places();
        for (size_t i = 0; i + 1 < places.size(); ++i) {
            walk_strip({places[i], places[i + 1]}, column_.values_at_top()[i]);
        }
    }
    [[nodiscard]] FaceQuadrature &found() noexcept { return found_; }

private:
    // Goes down a strip between neighbouring places, span by span, across the curves in it.
    void walk_strip(Interval u, int value) {
        const std::vector<double> &v = column_.v_breaks();
        for (size_t row = v.size() - 1; row-- > 0;) {
            Bound above{nullptr, v[row + 1]};
            for (const Crossing &crossing : crossings(u, row)) {
                const Bound below{crossing.part->piece, 0};
                add_cell(u, value, below, above);
                value += crossing.part->passed;
                above = below;
            }
            add_cell(u, value, {nullptr, v[row]}, above);
        }
    }
    struct Crossing {
        double v; // in the middle of the strip
        const ColumnPart *part;
    };
    std::vector<Crossing> crossings(Interval u, size_t row) const {
        const double middle = u.lower / 2 + u.upper / 2;
        std::vector<Crossing> all;
        for (const ColumnPart &part : column_.parts()) {
            if (part.row == row && part.u.lower <= u.lower && u.upper <= part.u.upper) {
                all.push_back({Bound{part.piece, 0}.at(pieces_, middle), &part});
            }
        }
        std::ranges::sort(all, [](const Crossing &a, const Crossing &b) { return a.v > b.v; });
        return all;
    }

    void add_cell(Interval u, int value, const Bound &below, const Bound &above) {
        if (value <= 0) {
            return;
        }
        column_.check_value(value, u.upper - u.lower);
        const auto n = std::ssize(rule_.places);
        checked_product(checked_sum(found_.size(), n * n, "points"), 2, "params");
        count_work(n * n * work_of_a_place);
        const bool straight = below.straight() && above.straight();
        for (size_t i = 0; i < rule_.places.size(); ++i) {
            const double x = rule_.places[i], rest = rule_.rests[i];
            add_line(u, straight ? x : x * x * (1 + 2 * rest),
                     rule_.weights[i] * (straight ? 1 : 6 * x * rest), below, above);
        }
    }
    void add_line(Interval u, double share, double weight, const Bound &below, const Bound &above) {
        const double width = u.upper - u.lower, at = std::clamp(u.lower + share * width, u.lower, u.upper),
                     low = below.at(pieces_, at), height = std::max(above.at(pieces_, at) - low, 0.0);
        for (size_t j = 0; j < rule_.places.size(); ++j) {
            found_.params.push_back(at);
            found_.params.push_back(low + rule_.places[j] * height);
            found_.weights.push_back(weight * width * rule_.weights[j] * height);
        }
    }

    const TrimPieces &pieces_;
    Column column_;
    GaussRule rule_;
    FaceQuadrature found_;
};

} // namespace

FaceQuadrature face_quadrature(const Face &face, int nodes) {
    const Spline &surface = *face.surface();
    const std::vector<double> u = pieces::breaks_in(surface.axis(0), surface.axis(0).domain()),
                              v = pieces::breaks_in(surface.axis(1), surface.axis(1).domain());
    const std::vector<std::vector<const TrimPiece *>> columns = pieces_in_columns(face.trims(), u);
    CellWalk walk(face, v, nodes);
    Steps steps(std::ssize(columns));
    for (size_t i = 0; i < columns.size(); ++i, steps.next()) {
        walk.walk({u[i], u[i + 1]}, columns[i]);
    }
    FaceQuadrature found = std::move(walk.found());
    for (size_t i = 0; i < found.params.size(); ++i) {
        const Interval domain = surface.axis(static_cast<int>(i % 2)).domain();
        found.params[i] = std::clamp(found.params[i], domain.lower, domain.upper);
    }
    require_representable(found.weights, "weights");
    return found;
}

// In units of the size of the surface and of its domain.
std::vector<double> measures_of(const Face &face, const FaceQuadrature &rule) {
    const Spline &surface = *face.surface();
    const auto dim = static_cast<size_t>(surface.dim());
    const int exponent = measure::integral_frame(surface).exponent;
    const auto width = static_cast<int64_t>(3 * dim);
    std::vector<double> jets(static_cast<size_t>(rule.size() * width)), local(2 * dim), found;
    eval::evaluate_points(surface, {}, 1, {rule.params.data(), rule.size(), 2, 2, 1},
                          {jets.data(), rule.size(), width, width, 1});
    std::array<double, 2> lengths{};
    for (const int k : {0, 1}) {
        const Interval domain = surface.axis(k).domain();
        lengths[static_cast<size_t>(k)] = domain.upper - domain.lower;
    }
    for (size_t i = 0; i < rule.weights.size(); ++i) {
        for (size_t c = 0; c < 2 * dim; ++c) {
            const double derivative = jets[i * 3 * dim + dim + c];
            local[c] = std::ldexp(derivative * lengths[c / dim], -exponent);
        }
        const double share = rule.weights[i] / lengths[0] / lengths[1];
        found.push_back(std::ldexp(share * measure::spanned(local, 2, surface.dim()), 2 * exponent));
        count_work(work_of_a_place);
    }
    require_representable(found, "measures");
    return found;
}

} // namespace nrb::face

// SPDX-License-Identifier: MIT
#include "face/integrals/panel.h"

#include "face/integrals/column.h"

#include <algorithm>

namespace nrb::face {

namespace {

// Walks down the columns of the surface, and adds panels.
class ColumnWalk {
public:
    ColumnWalk(const TrimMap &trims, const std::vector<double> &v_breaks, std::vector<Panel> &out)
        : column_(trims, v_breaks), v_breaks_(v_breaks), out_(out) {}

    void walk(Interval column, const std::vector<const TrimPiece *> &pieces) {
        column_.set(column, pieces);
        values_ = column_.values_at_top();
        for (size_t row = v_breaks_.size() - 1; row-- > 0;) {
            add_rectangles(row);
            for (const ColumnPart &part : column_.parts()) {
                if (part.row == row) {
                    pass(part);
                }
            }
        }
    }

private:
    void add_rectangles(size_t row) {
        const std::vector<double> &places = column_.places();
        for (size_t i = 0; i < values_.size();) {
            size_t end = i + 1;
            while (end < values_.size() && values_[end] == values_[i]) {
                ++end;
            }
            if (values_[i] != 0) {
                column_.check_value(values_[i], places[end] - places[i]);
                out_.push_back({nullptr,
                                {places[i], places[end]},
                                {v_breaks_[row], v_breaks_[row + 1]},
                                {0, 1},
                                static_cast<double>(values_[i])});
            }
            i = end;
        }
    }
    void pass(const ColumnPart &part) {
        if (!(part.u.lower < part.u.upper)) {
            return;
        }
        out_.push_back({part.piece,
                        part.along,
                        {v_breaks_[part.row], v_breaks_[part.row + 1]},
                        {0, 1},
                        static_cast<double>(part.passed)});
        column_.pass(part, values_);
    }

    Column column_;
    const std::vector<double> &v_breaks_;
    std::vector<Panel> &out_;
    std::vector<int> values_;
};

} // namespace

Panel::Jet Panel::jet(const TrimPieces &pieces, double x, double y) const noexcept {
    const double width = along.upper - along.lower, part = share.upper - share.lower,
                 up = share.lower + y * part;
    if (piece == nullptr) {
        const double height = v.upper - v.lower;
        return {{along.lower + x * width, v.lower + up * height}, {width, 0}, {0, part * height}};
    }
    const TrimPieces::Jet jet = pieces.jet(*piece, along.lower + x * width);
    const double height = jet.point[1] - v.lower;
    return {{jet.point[0], v.lower + up * height},
            {jet.derivative[0] * width, up * jet.derivative[1] * width},
            {0, part * height}};
}

Panel Panel::halve(size_t axis) noexcept {
    Panel lower = *this;
    Interval &range = axis == 0 ? along : share, &below = axis == 0 ? lower.along : lower.share;
    range.lower = below.upper = range.lower / 2 + range.upper / 2;
    return lower;
}

std::vector<Panel> panels_of(const TrimMap &trims, const std::vector<double> &u_breaks,
                             const std::vector<double> &v_breaks) {
    const std::vector<std::vector<const TrimPiece *>> columns = pieces_in_columns(trims, u_breaks);
    std::vector<Panel> panels;
    ColumnWalk walk(trims, v_breaks, panels);
    for (size_t i = 0; i < columns.size(); ++i) {
        walk.walk({u_breaks[i], u_breaks[i + 1]}, columns[i]);
    }
    return panels;
}

} // namespace nrb::face

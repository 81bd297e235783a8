// SPDX-License-Identifier: MIT
#include "face/integrals/panel.h"

#include "base/error.h"

#include <algorithm>

namespace nrb::face {

namespace {

// A part of a piece in one column and one span of v.
struct ColumnPart {
    const TrimPiece *piece;
    Interval along;
    Interval u;
    size_t row;
    int passed;
};

class ColumnWalk {
public:
    ColumnWalk(const TrimMap &trims, const std::vector<double> &v_breaks, std::vector<Panel> &out)
        : trims_(trims), v_breaks_(v_breaks), out_(out) {}

    void walk(Interval column, const std::vector<const TrimPiece *> &pieces) {
        parts_.clear();
        for (const TrimPiece *piece : pieces) {
            add_parts(*piece, column);
        }
        set_places(column);
        for (size_t row = v_breaks_.size() - 1; row-- > 0;) {
            add_rectangles(row);
            for (const ColumnPart &part : parts_) {
                if (part.row == row) {
                    pass(part);
                }
            }
        }
    }

private:
    void add_parts(const TrimPiece &piece, Interval column) {
        const TrimPieces &pieces = trims_.pieces();
        const Interval u{std::max(column.lower, piece.lower[0]), std::min(column.upper, piece.upper[0])};
        const bool forward = piece.start[0] < piece.end[0];
        const auto place_at = [&](double at) {
            return at == piece.start[0] ? 0 : at == piece.end[0] ? 1 : pieces.place_of(piece, 0, at);
        };
        const double from = place_at(forward ? u.lower : u.upper), to = place_at(forward ? u.upper : u.lower);
        std::vector<double> places{from, to};
        for (const double v : v_breaks_) {
            if (piece.lower[1] < v && v < piece.upper[1]) {
                const double place = pieces.place_of(piece, 1, v);
                if (from < place && place < to) {
                    places.push_back(place);
                }
            }
        }
        std::sort(places.begin(), places.end());
        double before = forward ? u.lower : u.upper;
        for (size_t i = 0; i + 1 < places.size(); ++i) {
            const bool last = i + 2 == places.size();
            const double end = last ? (forward ? u.upper : u.lower)
                                    : std::clamp(pieces.point(piece, places[i + 1])[0], u.lower, u.upper);
            const double middle = pieces.point(piece, places[i] / 2 + places[i + 1] / 2)[1];
            parts_.push_back({&piece,
                              {places[i], places[i + 1]},
                              {std::min(before, end), std::max(before, end)},
                              row_of(middle),
                              trims_.passed(piece)});
            before = end;
        }
    }
    [[nodiscard]] size_t row_of(double v) const {
        const auto above = std::upper_bound(v_breaks_.begin() + 1, v_breaks_.end() - 1, v);
        return static_cast<size_t>(above - v_breaks_.begin()) - 1;
    }

    // The places between which the number of loops around a place changes at no piece, and what it is at the top.
    void set_places(Interval column) {
        places_ = {column.lower, column.upper};
        for (const ColumnPart &part : parts_) {
            places_.push_back(part.u.lower);
            places_.push_back(part.u.upper);
        }
        for (const SeamPassage &passage : trims_.passages()) {
            if (column.lower < passage.at && passage.at < column.upper) {
                places_.push_back(passage.at);
            }
        }
        std::sort(places_.begin(), places_.end());
        places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
        values_.clear();
        for (size_t i = 0; i + 1 < places_.size(); ++i) {
            values_.push_back(trims_.value_at_top(places_[i] / 2 + places_[i + 1] / 2));
        }
    }

    void add_rectangles(size_t row) {
        for (size_t i = 0; i < values_.size();) {
            size_t end = i + 1;
            while (end < values_.size() && values_[end] == values_[i]) {
                ++end;
            }
            if (values_[i] != 0) {
                check_value(values_[i], places_[end] - places_[i]);
                out_.push_back({nullptr,
                                {places_[i], places_[end]},
                                {v_breaks_[row], v_breaks_[row + 1]},
                                {0, 1},
                                static_cast<double>(values_[i])});
            }
            i = end;
        }
    }
    // Slivers between loops that run along each other are left as they are.
    void check_value(int value, double width) const {
        const bool sliver = width <= 0x1p-16 * (places_.back() - places_.front());
        if (value != 1 && !sliver) {
            fail(Status::orientation,
                 "the loops go around some places %d times, expected 0 or 1: they cross or coincide", value);
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
        const auto first = std::lower_bound(places_.begin(), places_.end(), part.u.lower) - places_.begin();
        for (auto i = static_cast<size_t>(first); i < values_.size() && places_[i] < part.u.upper; ++i) {
            values_[i] += part.passed;
        }
    }

    const TrimMap &trims_;
    const std::vector<double> &v_breaks_;
    std::vector<Panel> &out_;
    std::vector<ColumnPart> parts_;
    std::vector<double> places_;
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
    std::vector<std::vector<const TrimPiece *>> columns(u_breaks.size() - 1);
    for (const TrimPiece &piece : trims.pieces().all()) {
        for (size_t i = 0; i + 1 < u_breaks.size(); ++i) {
            if (std::max(u_breaks[i], piece.lower[0]) < std::min(u_breaks[i + 1], piece.upper[0])) {
                columns[i].push_back(&piece);
            }
        }
    }
    std::vector<Panel> panels;
    ColumnWalk walk(trims, v_breaks, panels);
    for (size_t i = 0; i < columns.size(); ++i) {
        walk.walk({u_breaks[i], u_breaks[i + 1]}, columns[i]);
    }
    return panels;
}

} // namespace nrb::face

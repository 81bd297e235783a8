// SPDX-License-Identifier: MIT
#include "face/integrals/column.h"

#include "base/error.h"

#include <algorithm>

namespace nrb::face {

void Column::set(Interval column, const std::vector<const TrimPiece *> &pieces) {
    parts_.clear();
    for (const TrimPiece *piece : pieces) {
        add_parts(*piece, column);
    }
    set_places(column);
    pass_the_top();
}

void Column::add_parts(const TrimPiece &piece, Interval column) {
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

// The last span that begins below v.
size_t Column::row_of(double v) const {
    const auto above = std::upper_bound(v_breaks_.begin() + 1, v_breaks_.end() - 1, v);
    return static_cast<size_t>(above - v_breaks_.begin()) - 1;
}

void Column::set_places(Interval column) {
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

// Pieces on the upper end of the domain, such as those around a pole, have nothing above them.
void Column::pass_the_top() {
    const auto is_on_top = [&](const ColumnPart &part) { return part.piece->lower[1] >= v_breaks_.back(); };
    for (const ColumnPart &part : parts_) {
        if (is_on_top(part)) {
            pass(part, values_);
        }
    }
    std::erase_if(parts_, is_on_top);
}

void Column::pass(const ColumnPart &part, std::vector<int> &values) const {
    const auto first = std::lower_bound(places_.begin(), places_.end(), part.u.lower) - places_.begin();
    for (auto i = static_cast<size_t>(first); i < values.size() && places_[i] < part.u.upper; ++i) {
        values[i] += part.passed;
    }
}

void Column::check_value(int value, double width) const {
    const bool sliver = width <= 0x1p-16 * (places_.back() - places_.front());
    if (value != 1 && !sliver) {
        fail(Status::orientation,
             "the loops go around some places %d times, expected 0 or 1: they cross or coincide", value);
    }
}

std::vector<std::vector<const TrimPiece *>> pieces_in_columns(const TrimMap &trims,
                                                              const std::vector<double> &u_breaks) {
    std::vector<std::vector<const TrimPiece *>> columns(u_breaks.size() - 1);
    for (const TrimPiece &piece : trims.pieces().all()) {
        for (size_t i = 0; i + 1 < u_breaks.size(); ++i) {
            if (std::max(u_breaks[i], piece.lower[0]) < std::min(u_breaks[i + 1], piece.upper[0])) {
                columns[i].push_back(&piece);
            }
        }
    }
    return columns;
}

} // namespace nrb::face

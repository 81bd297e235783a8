// SPDX-License-Identifier: MIT
// The pieces of a face in one column of its surface, a span of axis 0.
#pragma once

#include "face/trims/trim_map.h"

#include <vector>

namespace nrb::face {

// The part of a piece in one column and one span (row) of axis 1.
struct ColumnPart {
    const TrimPiece *piece;
    Interval along;
    Interval u;
    size_t row;
    int passed;
};

// Divides a column at places of axis 0, such that between neighbouring places no piece begins, ends, or
// passes from one span of v to the next.
class Column {
public:
    // v_breaks: the knots of axis 1 in the domain.
    Column(const TrimMap &trims, const std::vector<double> &v_breaks) : trims_(trims), v_breaks_(v_breaks) {}

    // Sets the column, an interval of u, and the pieces that enter it.
    void set(Interval column, const std::vector<const TrimPiece *> &pieces);

    [[nodiscard]] const TrimMap &trims() const noexcept { return trims_; }
    [[nodiscard]] const std::vector<double> &v_breaks() const noexcept { return v_breaks_; }
    [[nodiscard]] const std::vector<ColumnPart> &parts() const noexcept { return parts_; }
    [[nodiscard]] const std::vector<double> &places() const noexcept { return places_; }
    // The value (TrimMap) at places just below the top, between each place and the next one.
    [[nodiscard]] const std::vector<int> &values_at_top() const noexcept { return values_; }
    // Updates the values between the places of a part from above the part to below it.
    void pass(const ColumnPart &part, std::vector<int> &values) const;
    // Throws Status::orientation if a value is not 1, except in slivers between loops that run along each
    // other.
    void check_value(int value, double width) const;

private:
    void add_parts(const TrimPiece &piece, Interval column);
    [[nodiscard]] size_t row_of(double v) const;
    void set_places(Interval column);
    void pass_the_top();

    const TrimMap &trims_;
    const std::vector<double> &v_breaks_;
    std::vector<ColumnPart> parts_;
    std::vector<double> places_;
    std::vector<int> values_;
};

// For each column between breaks of u, the pieces that enter it.
std::vector<std::vector<const TrimPiece *>> pieces_in_columns(const TrimMap &trims,
                                                              const std::vector<double> &u_breaks);

} // namespace nrb::face

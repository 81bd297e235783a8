// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/overlaps.h"

#include "base/numbers.h"

#include <algorithm>
#include <optional>

namespace nrb::intersect {

namespace {

using Kind = MeetCell::Kind;

// Consecutive cells along the curve.
class Stretch {
public:
    Stretch(const MeetGroup &group, const Seams &seams) : group_(group), seams_(seams) {}

    [[nodiscard]] bool is_followed_by(const MeetCell &cell) const noexcept {
        return cells_.empty() || cell.box[0].lower <= reach_;
    }
    void add(size_t i) {
        const MeetCell &cell = group_.cells[i];
        cells_.push_back(i);
        reach_ = std::max(reach_, cell.box[0].upper);
        const Interval t = cell.kind == Kind::along ? cell.core[0] : cell.box[0];
        whole_ = {std::min(whole_.lower, t.lower), std::max(whole_.upper, t.upper)};
        if (cell.kind == Kind::along) {
            add_along(cell, t);
        } else if (holds_line(cell)) {
            first_line_ = std::min(first_line_, t.lower);
            last_line_ = std::max(last_line_, t.upper);
        }
    }
    [[nodiscard]] bool is_overlap() const noexcept {
        return is_along_ && ((begins() && ends()) || seams_.breaks(0).have_span_in(range()));
    }
    [[nodiscard]] SurfaceOverlap take() const {
        SurfaceOverlap overlap{{}, cells_};
        overlap.box.fill({infinity, -infinity});
        for (const size_t i : cells_) {
            for (size_t k = 1; k < 3; ++k) {
                const Interval part = group_.cells[i].box[k];
                Interval &all = overlap.box[k];
                all = {std::min(all.lower, part.lower), std::max(all.upper, part.upper)};
            }
        }
        overlap.box[0] = range();
        return overlap;
    }

private:
    void add_along(const MeetCell &cell, Interval t) noexcept {
        is_along_ = true;
        if (t.lower < along_.lower || (t.lower == along_.lower && is_knot(cell.first))) {
            along_.lower = t.lower;
            first_ = cell.first;
        }
        if (t.upper > along_.upper || (t.upper == along_.upper && is_knot(cell.last))) {
            along_.upper = t.upper;
            last_ = cell.last;
        }
    }
    // Whether the cell contains a knot line of the surface, at which pieces end.
    [[nodiscard]] bool holds_line(const MeetCell &cell) const noexcept {
        return seams_.breaks(1).hold_any_in(cell.box[1]) || seams_.breaks(2).hold_any_in(cell.box[2]);
    }
    [[nodiscard]] bool is_knot(const MeetCell::Line &line) const noexcept {
        return line.axis >= 0 && seams_.breaks(static_cast<size_t>(line.axis) + 1).hold(line.at);
    }
    // Whether the core begins, or ends, at a knot of the curve or of the surface. If not, the stretch is
    // extended over the tiny cells.
    [[nodiscard]] bool begins_along() const noexcept {
        return is_knot(first_) || seams_.breaks(0).hold(along_.lower);
    }
    [[nodiscard]] bool ends_along() const noexcept {
        return is_knot(last_) || seams_.breaks(0).hold(along_.upper);
    }
    [[nodiscard]] bool begins() const noexcept {
        return begins_along() || seams_.breaks(0).hold(whole_.lower) || first_line_ == whole_.lower;
    }
    [[nodiscard]] bool ends() const noexcept {
        return ends_along() || seams_.breaks(0).hold(whole_.upper) || last_line_ == whole_.upper;
    }
    [[nodiscard]] Interval range() const noexcept {
        return {begins_along() ? along_.lower : whole_.lower, ends_along() ? along_.upper : whole_.upper};
    }

    const MeetGroup &group_;
    const Seams &seams_;
    std::vector<size_t> cells_;
    double reach_ = -infinity;
    Interval whole_{infinity, -infinity}, along_{infinity, -infinity};
    MeetCell::Line first_{}, last_{};
    double first_line_ = infinity, last_line_ = -infinity; // ends of tiny cells on a knot line of the surface
    bool is_along_ = false;
};

} // namespace

std::vector<SurfaceOverlap> overlaps_of(const MeetGroup &group, const Seams &seams) {
    std::vector<SurfaceOverlap> overlaps;
    std::optional<Stretch> stretch;
    const auto end = [&] {
        if (stretch && stretch->is_overlap()) {
            overlaps.push_back(stretch->take());
        }
    };
    for (size_t i = 0; i < group.cells.size(); ++i) {
        const MeetCell &cell = group.cells[i];
        if (cell.kind != Kind::along && cell.kind != Kind::tiny) {
            continue;
        }
        if (!stretch || !stretch->is_followed_by(cell)) {
            end();
            stretch.emplace(group, seams);
        }
        stretch->add(i);
    }
    end();
    return overlaps;
}

} // namespace nrb::intersect

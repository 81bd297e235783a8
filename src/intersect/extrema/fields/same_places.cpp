// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/same_places.h"

#include "base/watch.h"
#include "intersect/extrema/fields/box_groups.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace nrb::intersect {

namespace {

// Two places as parameters.
struct Candidate {
    Part core, unique;
};

class Copies {
public:
    Copies(const GradientField &field, const Stratum &stratum) : field_(field), stratum_(stratum) {}

    void remove_from(CriticalPlaces &places) {
        std::vector<CriticalPlace> kept;
        for (const CriticalPlace &place : places.found) {
            if (is_new(place, places.open)) {
                kept.push_back(place);
            }
        }
        places.found = std::move(kept);
    }

private:
    bool is_new(const CriticalPlace &place, std::vector<Part> &open) {
        const Candidate one{range_of(field_, stratum_, place.home, place.core),
                            range_of(field_, stratum_, place.home, place.unique)};
        for (const PieceIndex &index : around(place.home)) {
            const std::vector<Candidate> &others = of_piece_[field_.number(index)];
            count_work(10 + 10 * std::ssize(others));
            for (const Candidate &other : others) {
                if (touch(beside(one.core, other.core), other.core, field_.axes())) {
                    leave_unless_same(one, other, open);
                    return false;
                }
            }
        }
        of_piece_[field_.number(place.home)].push_back(one);
        return true;
    }

    void leave_unless_same(const Candidate &one, const Candidate &other, std::vector<Part> &open) const {
        const Part core = beside(one.core, other.core), unique = beside(one.unique, other.core);
        if (!contains(shrunk(other.unique), core, field_.axes()) &&
            !contains(shrunk(unique), other.core, field_.axes())) {
            open.push_back(one.core);
        }
    }

    // A piece and those beside it along axes that are free, into which a core may reach.
    [[nodiscard]] std::vector<PieceIndex> around(const PieceIndex &home) const {
        std::vector<PieceIndex> list{home};
        for (int k = 0; k < field_.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            for (size_t i = 0, n = stratum_.is_fixed(k) ? 0 : list.size(); i < n; ++i) {
                for (const bool upper : {false, true}) {
                    PieceIndex other = list[i];
                    other[at] = field_.beside(k, home[at] + (upper ? 1 : 0), upper);
                    list.push_back(other);
                }
            }
        }
        return list;
    }

    // Moved by periods to where another one is.
    [[nodiscard]] Part beside(Part box, const Part &other) const {
        for (int k = 0; k < field_.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            const auto [lower, upper] = field_.axis(k).domain();
            const double period = upper - lower, off = middle(box[at]) - middle(other[at]);
            if (!field_.axis(k).periodic() || stratum_.is_fixed(k) || std::abs(off) < period / 2) {
                continue;
            }
            const double shift = off > 0 ? -period : period;
            box[at] = {box[at].lower + shift, box[at].upper + shift};
        }
        return box;
    }
    // Without what rounding of parameters adds.
    [[nodiscard]] Part shrunk(Part box) const {
        for (int k = 0; k < field_.axes(); ++k) {
            if (!stratum_.is_fixed(k)) {
                Interval &x = box[static_cast<size_t>(k)];
                const auto [lower, upper] = field_.axis(k).domain();
                const double off = 32 * eps * std::max(std::abs(lower), std::abs(upper));
                x = {x.lower == lower ? x.lower : x.lower + off, x.upper == upper ? x.upper : x.upper - off};
            }
        }
        return box;
    }

    const GradientField &field_;
    const Stratum &stratum_;
    std::unordered_map<int64_t, std::vector<Candidate>> of_piece_;
};

} // namespace

void without_copies(const GradientField &field, const Stratum &stratum, CriticalPlaces &places) {
    Copies(field, stratum).remove_from(places);
}

} // namespace nrb::intersect

// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/field_extrema.h"

#include "base/watch.h"
#include "intersect/extrema/fields/box_groups.h"
#include "intersect/extrema/fields/plateaus.h"
#include "intersect/extrema/fields/same_places.h"
#include "intersect/extrema/fields/turns.h"
#include "intersect/extrema/piece_value.h"

#include <algorithm>
#include <utility>

namespace nrb::intersect {

namespace {

using namespace extremum_kind;

class FieldExtrema {
public:
    explicit FieldExtrema(const Spline &spline) : field_(spline), walls_(spline, field_) {}

    Extrema run() {
        const Strata strata(field_);
        Steps steps(strata.count());
        for (int64_t i = 0; i < strata.count(); ++i, steps.next()) {
            look_at(strata[i]);
        }
        Extrema result{std::move(found_)};
        for (const Extremum &x : merged(std::move(plateaus_), field_.axes())) {
            result.list.push_back(x);
        }
        for (const Part &open : grouped(std::move(open_), field_.axes())) {
            result.list.push_back(left_open(open));
        }
        std::ranges::stable_sort(result.list, {}, &Extremum::at);
        return result;
    }

private:
    void look_at(const Stratum &stratum) {
        switch (std::ranges::count(stratum.axes.begin(), stratum.axes.begin() + field_.axes(), false,
                                   &StratumAxis::fixed)) {
        case 0:
            return look_at_point(stratum);
        case 1:
            return search<1>(stratum);
        case 2:
            return search<2>(stratum);
        default:
            return search<3>(stratum);
        }
    }

    void look_at_point(const Stratum &stratum) {
        for (const PieceIndex &index : pieces_of(field_, stratum)) {
            if (may_be_found(stratum, index)) {
                CriticalPlace place;
                place.home = index;
                add(stratum, place);
            }
        }
    }

    template <size_t N>
    void search(const Stratum &stratum) {
        CriticalSearch<N> search(field_, stratum);
        CriticalPlaces places;
        const std::vector<PieceIndex> pieces = pieces_of(field_, stratum);
        Steps steps(std::ssize(pieces));
        for (size_t i = 0; i < pieces.size(); ++i, steps.next()) {
            const PieceIndex &index = pieces[i];
            if (may_be_found(stratum, index) && !add_plateau(stratum, index) &&
                !turns_across(field_, walls_, stratum, index, all_of_piece).regular) {
                search.run(index, places);
            }
        }
        without_copies(field_, stratum, places);
        for (const CriticalPlace &place : places.found) {
            add(stratum, place);
        }
        open_.insert(open_.end(), places.open.begin(), places.open.end());
    }

    // Not where a plateau of more axes ends, where nothing is known, or at the limit of work.
    bool may_be_found(const Stratum &stratum, const PieceIndex &index) {
        count_work(100);
        if (ends_plateau(field_, stratum, index)) {
            return false;
        }
        if (work_ended() || !walls_.regular(stratum, index)) {
            open_.push_back(range_of(field_, stratum, index, all_of_piece));
            return false;
        }
        return true;
    }

    bool add_plateau(const Stratum &stratum, const PieceIndex &index) {
        const ConstantLayers constants = field_.constants(index, stratum.sides());
        if (!constants.all) {
            return false;
        }
        const TurnsAcross turns = turns_across(field_, walls_, stratum, index, all_of_piece);
        if (!turns.regular) {
            const bool one = turns.known && (turns.kinds == minimum || turns.kinds == maximum);
            put(plateaus_, range_of(field_, stratum, index, all_of_piece), constants.value,
                plateau | (one ? turns.kinds : 0));
        }
        return true;
    }

    void add(const Stratum &stratum, const CriticalPlace &place) {
        const uint32_t kinds =
            turns_across(field_, walls_, stratum, place.home, place.core).together_with(place.kinds);
        const Part range = range_of(field_, stratum, place.home, place.core);
        if (kinds == undecided) {
            open_.push_back(range);
        } else if (kinds != 0) {
            put(found_, range, value_at(stratum, place), kinds);
        }
    }

    // With the middle of the range as its place; on periodic axes both are moved to the domain by the period.
    void put(std::vector<Extremum> &list, Part range, double value, uint32_t kinds) const {
        Extremum x{{}, range, value, kinds};
        for (int k = 0; k < field_.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            x.at[at] = inside(k, middle(range[at]));
        }
        list.push_back(x);
    }
    [[nodiscard]] double inside(int k, double at) const noexcept {
        const auto [lower, upper] = field_.axis(k).domain();
        if (field_.axis(k).periodic() && at >= upper) {
            at = lower + (at - upper);
        } else if (field_.axis(k).periodic() && at < lower) {
            at = upper - (lower - at) < upper ? upper - (lower - at) : lower;
        }
        return std::clamp(at, lower, upper);
    }

    [[nodiscard]] double value_at(const Stratum &stratum, const CriticalPlace &place) const {
        std::array<double, max_axes> at{};
        for (int k = 0; k < field_.axes(); ++k) {
            const double end = stratum.upper_end(k) ? 1 : 0;
            at[static_cast<size_t>(k)] =
                stratum.is_fixed(k) ? end : std::clamp(place.at[static_cast<size_t>(k)], 0.0, 1.0);
        }
        return value_of(field_.piece(place.home)->piece, at);
    }

    [[nodiscard]] Extremum left_open(const Part &range) const {
        Extremum x{{}, range, 0, undecided};
        PieceIndex index{};
        std::array<double, max_axes> place{};
        for (int k = 0; k < field_.axes(); ++k) {
            const auto i = static_cast<size_t>(k);
            x.at[i] = inside(k, middle(range[i]));
            index[i] = field_.piece_at(k, x.at[i]);
            const double from = field_.parameter(k, index[i]), to = field_.parameter(k, index[i] + 1);
            place[i] = std::clamp((x.at[i] - from) / (to - from), 0.0, 1.0);
        }
        x.value = value_of(field_.piece(index)->piece, place);
        return x;
    }

    GradientField field_;
    Walls walls_;
    std::vector<Extremum> found_, plateaus_;
    std::vector<Part> open_;
};

} // namespace

Extrema field_extrema(const Spline &spline) {
    return FieldExtrema(spline).run();
}

} // namespace nrb::intersect

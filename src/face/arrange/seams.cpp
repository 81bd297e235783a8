// SPDX-License-Identifier: MIT
#include "face/arrange/seams.h"

#include "base/error.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

[[noreturn]] void fail_crowded(int k, double at) {
    fail(Status::not_converged, "curves come undecidably near each other around %s on axis %d",
         Number(at).text, k);
}

// The widest gap between the ends of pieces along a closed axis. It may extend beyond the end of the domain.
Interval widest_gap(const TrimPieces &plane, const Covering &covering, int k) {
    const auto at = static_cast<size_t>(k);
    std::vector<double> ends;
    for (const TrimPiece &piece : plane.all()) {
        for (const Point2 &end : {piece.start, piece.end}) {
            ends.push_back(covering.canonical(end)[at]);
        }
    }
    if (ends.empty()) {
        return covering.domain(k);
    }
    std::ranges::sort(ends);
    ends.push_back(ends.front() + covering.period(k));
    Interval widest{ends[0], ends[0]};
    for (size_t i = 0; i + 1 < ends.size(); ++i) {
        if (ends[i + 1] - ends[i] > widest.upper - widest.lower) {
            widest = {ends[i], ends[i + 1]};
        }
    }
    return widest;
}

// Calls visit(u) for all copies of the line u = at that a piece crosses.
template <class Visit>
void for_each_passage(const TrimPiece &piece, double at, double period, Visit &&visit) {
    for_each_copy(at, period, {piece.lower[0], piece.upper[0]}, visit);
}

// The distance of a place on the seam of axis 0 from the nearest crossing of a piece with that seam.
class Clearance {
public:
    Clearance(const TrimPieces &plane, const Covering &covering, double seam) : covering_(covering) {
        for (const TrimPiece &piece : plane.all()) {
            for_each_passage(piece, seam, covering.period(0), [&](double u) {
                passed_.push_back(plane.point(piece, plane.place_of(piece, 0, u))[1]);
            });
        }
    }

    [[nodiscard]] double of(double v) const {
        double least = covering_.period(1);
        for (const double x : passed_) {
            least = std::min(least, std::abs(covering_.nearest_copy({0, v}, {0, x})[1] - x));
        }
        return least;
    }

private:
    const Covering &covering_;
    std::vector<double> passed_;
};

double corner_in(const Interval &gap, const Clearance &clearance) {
    double best = gap.lower / 2 + gap.upper / 2;
    for (const double share : {0.381966, 0.618034, 0.25, 0.75, 0.3, 0.7}) {
        const double v = gap.lower + share * (gap.upper - gap.lower);
        best = clearance.of(v) > clearance.of(best) ? v : best;
    }
    return best;
}

} // namespace

Point2 seams_for(const TrimPieces &plane, const Covering &covering, const Point2 &rounding) {
    constexpr double enough = 64;
    Point2 seams{covering.domain(0).lower, covering.domain(1).lower};
    for (const int k : {0, 1}) {
        const auto at = static_cast<size_t>(k);
        if (!covering.closed(k)) {
            continue;
        }
        const Interval gap = widest_gap(plane, covering, k);
        if (!(gap.upper - gap.lower > enough * rounding[at])) {
            fail_crowded(k, gap.lower);
        }
        seams[at] = gap.lower / 2 + gap.upper / 2;
        if (k == 1 && covering.closed(0)) {
            const Clearance clearance(plane, covering, seams[0]);
            seams[1] = corner_in(gap, clearance);
            if (!(clearance.of(seams[1]) > enough * rounding[1])) {
                fail_crowded(k, seams[1]);
            }
        }
    }
    return seams;
}

std::vector<SeamContact> seam_contacts(const FoldedPieces &folded, const Covering &covering, int k,
                                       double rounding) {
    const auto along = static_cast<size_t>(1 - k), across = static_cast<size_t>(k);
    const auto &all = folded.pieces.all();
    std::vector<SeamContact> contacts;
    for (size_t i = 1; i < all.size(); ++i) {
        const double from = all[i - 1].end[across], to = all[i].start[across];
        const auto [lower, upper] = covering.domain(k);
        if (all[i].loop == all[i - 1].loop && std::min(from, to) == lower && std::max(from, to) == upper) {
            contacts.push_back({all[i].loop, all[i].start[along], from == upper});
        }
    }
    std::ranges::sort(contacts, {}, &SeamContact::at);
    for (size_t i = 1; i < contacts.size(); ++i) {
        if (!(contacts[i].at - contacts[i - 1].at > rounding)) {
            fail_crowded(1 - k, contacts[i].at);
        }
    }
    return contacts;
}

} // namespace nrb::face

// SPDX-License-Identifier: MIT
#include "face/checks/beside_loops.h"

#include "eval/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

namespace nrb::face {

namespace {

// Where a part of a piece is sampled. If an area beside it with a wrong value has any thickness, some samples
// show it.
constexpr std::array shares{0.5, 0.236, 0.764, 0.0625, 0.9375, 0.382, 0.618};
constexpr size_t few = 3; // samples of a piece that is not cut

// The derivatives of the surface by both parameters, in units of its extent and of the periods.
std::array<std::vector<double>, 2> slopes(const Spline &surface, const Covering &covering, const Point2 &x) {
    const int dim = surface.dim();
    std::vector<double> jet(3 * static_cast<size_t>(dim));
    eval::evaluate_points(surface, {}, 1, {x.data(), 1, 2, 2, 1}, {jet.data(), 1, 3 * dim, 3 * dim, 1});
    std::array<std::vector<double>, 2> result;
    for (const int k : {0, 1}) {
        const auto slope = jet.begin() + (k + 1) * dim;
        std::transform(slope, slope + dim, std::back_inserter(result[static_cast<size_t>(k)]),
                       [&](double value) { return value / covering.extent() * covering.period(k); });
    }
    return result;
}

double product(const std::vector<double> &a, const std::vector<double> &b) noexcept {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

} // namespace

BesideLoops::BesideLoops(const Spline &surface, const Covering &covering, const TrimMap &trims, double near)
    : surface_(surface), covering_(covering), trims_(trims), near_(near) {}

size_t BesideLoops::longer_side(const TrimPiece &piece) const noexcept {
    const auto length = [&](size_t k) {
        return (piece.upper[k] - piece.lower[k]) / covering_.period(static_cast<int>(k));
    };
    return length(1) > length(0) ? 1 : 0;
}

// On all pieces whose boxes contain the place, in all copies.
void BesideLoops::cut(const Point2 &x) {
    if (!std::isfinite(x[0]) || !std::isfinite(x[1])) {
        return;
    }
    const Point2 place = covering_.in_domain(x), &room = trims_.room();
    const Point2 lower{place[0] - room[0], place[1] - room[1]}, upper{place[0] + room[0], place[1] + room[1]};
    const auto all = std::span(trims_.pieces().all());
    const auto add = [&](const Point2 &move) {
        trims_.any_in(moved(lower, move), moved(upper, move), [&](const TrimPiece &piece) {
            const size_t k = longer_side(piece);
            const double share = (place[k] + move[k] - piece.lower[k]) / (piece.upper[k] - piece.lower[k]);
            if (piece.lower[k] < piece.upper[k]) {
                cuts_.push_back({static_cast<size_t>(&piece - all.data()), std::clamp(share, 0.0, 1.0)});
            }
            return false;
        });
        return false;
    };
    add({0, 0});
    covering_.any_move(lower, upper, [&](const Point2 &move) { return move != Point2{0, 0} && add(move); });
}

std::optional<BesideLoops::Astray> BesideLoops::astray() {
    if (!(covering_.extent() > 0)) {
        return std::nullopt; // the surface is a single point
    }
    std::ranges::sort(cuts_);
    const auto &all = trims_.pieces().all();
    Steps steps(std::ssize(all));
    for (size_t first = 0, last = 0; first < all.size(); first = last) {
        while (last < all.size() && all[last].loop == all[first].loop) {
            ++last;
        }
        if (const std::optional<Point2> at = astray_of(parts_of(first, last), steps)) {
            return Astray{all[first].loop, *at};
        }
    }
    return std::nullopt;
}

// The parts between cuts of the pieces of a loop, beginning at a cut if there is one.
std::vector<BesideLoops::Part> BesideLoops::parts_of(size_t first, size_t last) const {
    std::vector<Part> parts;
    bool cut = false;
    auto next = std::ranges::lower_bound(cuts_, Cut{first, 0});
    for (size_t i = first; i < last; ++i) {
        double from = 0;
        const auto add = [&](double to) {
            if (from < to) {
                parts.push_back({i, {from, to}, cut});
                cut = false;
            }
            from = to;
        };
        for (; next != cuts_.end() && next->piece == i; ++next) {
            add(next->share);
            cut = true;
        }
        add(1);
    }
    parts.front().cut = parts.front().cut || cut;
    std::rotate(parts.begin(), std::ranges::find_if(parts, &Part::cut), parts.end());
    return parts;
}

std::optional<Point2> BesideLoops::astray_of(std::span<const Part> parts, Steps &steps) const {
    if (!parts.front().cut) {
        return astray_of_uncut(parts);
    }
    for (size_t first = 0, last = 0; first < parts.size(); first = last) {
        do {
            ++last;
        } while (last < parts.size() && !parts[last].cut);
        const auto run = parts.subspan(first, last - first);
        const std::array ends{sample(run.front().piece, run.front().share.lower).at,
                              sample(run.back().piece, run.back().share.upper).at};
        for (const Part &part : run) {
            constexpr int64_t work = 4000;
            if (const std::optional<Point2> at = astray_in(part, ends)) {
                return at;
            }
            steps.next(work);
        }
    }
    return std::nullopt;
}

// The values beside a loop that meets nothing are the same along all of it.
std::optional<Point2> BesideLoops::astray_of_uncut(std::span<const Part> parts) const {
    for (const double share : shares) {
        const Sample own =
            sample(parts[static_cast<size_t>(share * static_cast<double>(parts.size()))].piece, shares[0]);
        if (is_astray(own)) {
            return covering_.in_domain(own.at);
        }
    }
    return std::nullopt;
}

BesideLoops::Sample BesideLoops::sample(size_t number, double share) const noexcept {
    const TrimPieces &pieces = trims_.pieces();
    const TrimPiece &piece = pieces.all()[number];
    const size_t k = longer_side(piece);
    const double value = std::clamp(piece.lower[k] + share * (piece.upper[k] - piece.lower[k]),
                                    piece.lower[k], piece.upper[k]);
    const TrimPieces::Jet jet = pieces.jet(piece, pieces.place_of(piece, static_cast<int>(k), value));
    const bool still = jet.derivative == Point2{0, 0};
    const Point2 chord{piece.end[0] - piece.start[0], piece.end[1] - piece.start[1]};
    return {jet.point, still ? chord : jet.derivative};
}

// Ignores places within twice the tolerance of the ends of the run. There curves may end a little before they
// meet, or after.
std::optional<Point2> BesideLoops::astray_in(const Part &part, const std::array<Point2, 2> &ends) const {
    const auto [lower, upper] = part.share;
    const size_t count = lower == 0 && upper == 1 ? few : shares.size();
    for (size_t i = 0; i < count; ++i) {
        const Sample own = sample(part.piece, lower + shares[i] * (upper - lower));
        const auto is_apart = [&](const Point2 &end) {
            return gap_between(surface_, covering_, own.at, end) > 2 * near_;
        };
        if (is_astray(own) && std::ranges::all_of(ends, is_apart)) {
            return covering_.in_domain(own.at);
        }
    }
    return std::nullopt;
}

// The values have to be wrong at both distances, so that areas too thin to contain both places are ignored.
bool BesideLoops::is_astray(const Sample &sample) const {
    const Point2 step = step_aside(sample);
    return std::ranges::any_of(std::array{1.0, -1.0}, [&](double side) {
        const Point2 once{side * step[0], side * step[1]};
        return is_wrong(moved(sample.at, once)) && is_wrong(moved(moved(sample.at, once), once));
    });
}

bool BesideLoops::is_wrong(const Point2 &x) const noexcept {
    if (!std::isfinite(x[0]) || !std::isfinite(x[1])) {
        return false;
    }
    const std::optional<int> value = trims_.value(x);
    return value && *value != 0 && *value != 1;
}

// A step in the domain that is perpendicular to the curve in space, and `near_` long: with the metric G of
// the surface, G^-1 (-v', u'). Where the surface has no tangent plane, `flattest` makes G regular.
Point2 BesideLoops::step_aside(const Sample &sample) const {
    constexpr double flattest = 0x1p-20; // added to the metric
    const auto [along_u, along_v] = slopes(surface_, covering_, covering_.in_domain(sample.at));
    const double e = product(along_u, along_u) + flattest, f = product(along_u, along_v),
                 g = product(along_v, along_v) + flattest;
    const double u = sample.tangent[0] / covering_.period(0), v = sample.tangent[1] / covering_.period(1);
    const double largest = std::max(std::abs(u), std::abs(v)), across_u = -v / largest,
                 across_v = u / largest;
    Point2 step{g * across_u - f * across_v, e * across_v - f * across_u};
    const double length =
        std::sqrt(e * step[0] * step[0] + 2 * f * step[0] * step[1] + g * step[1] * step[1]);
    double room = 0; // the step in multiples of what rounding may move
    for (const int k : {0, 1}) {
        const auto at = static_cast<size_t>(k);
        step[at] *= near_ / covering_.extent() / length * covering_.period(k);
        room = std::max(room, std::abs(step[at]) / trims_.room()[at]);
    }
    constexpr double least = 4;
    const double longer = room < least ? least / room : 1;
    return {longer * step[0], longer * step[1]};
}

} // namespace nrb::face

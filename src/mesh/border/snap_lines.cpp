// SPDX-License-Identifier: MIT
#include "mesh/border/snap_lines.h"

#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::mesh {

namespace {

// Limits of snapping distances as shares of the domain, however small or large the tolerance is.
constexpr double least_near = 1e-9, most_near = 1e-3;
// The part of the chord error by which snapping may move places.
constexpr double share_of_chord = 1.0 / 32;

// The breaks inside the domain of an axis where homogeneous coordinates may have a kink: knots of a
// multiplicity of at least the degree.
std::vector<double> kinks_of(const KnotVector &axis) {
    std::vector<double> result;
    const std::vector<double> breaks = refine::breaks_of(axis);
    for (size_t i = 1; i + 1 < breaks.size(); ++i) {
        const auto [first, last] = std::equal_range(axis.knots().begin(), axis.knots().end(), breaks[i]);
        if (last - first >= axis.degree()) {
            result.push_back(breaks[i]);
        }
    }
    return result;
}

} // namespace

SnapLines::SnapLines(const face::Face &face, double chord) {
    const face::Covering &covering = face.covering();
    for (const int k : {0, 1}) {
        const auto at = static_cast<size_t>(k);
        domain_[at] = covering.domain(k);
        closed_[at] = covering.closed(k);
        const auto near = [&](double distance) {
            const double share = covering.extent() > 0 ? distance / covering.extent() : 0;
            return std::clamp(share, least_near, most_near) * covering.period(k);
        };
        near_[at] = near(face.tolerance());
        close_[at] = near(std::min(face.tolerance(), share_of_chord * chord));
        inner_[at] = kinks_of(face.surface()->axis(k));
    }
}

face::Point2 SnapLines::snapped(face::Point2 x) const noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const auto snap = [&](double line, double room) {
            x[k] = std::abs(x[k] - line) <= room ? line : x[k];
        };
        const auto [lower, upper] = domain_[k];
        for (const double end : {lower, upper}) {
            snap(end, closed_[k] || x[k] < lower || x[k] > upper ? near_[k] : close_[k]);
        }
        std::ranges::for_each(inner_[k], [&](double line) { snap(line, close_[k]); });
    }
    return x;
}

bool SnapLines::on_seam(size_t k, const face::Point2 &x) const noexcept {
    return closed_[k] && (x[k] == domain_[k].lower || x[k] == domain_[k].upper);
}

face::Point2 SnapLines::other_side(size_t k, face::Point2 x) const noexcept {
    x[k] = x[k] == domain_[k].lower ? domain_[k].upper : domain_[k].lower;
    return x;
}

namespace {

// Finds where a loop crosses lines across axis k. It goes around twice, since the loop may begin on a line;
// crossings of the second round count.
class LoopWatch {
public:
    LoopWatch(const face::Face &face, std::span<const face::TrimPiece> loop, const SnapLines &lines, size_t k,
              std::vector<LinePassage> &out)
        : face_(face), loop_(loop), lines_(lines), k_(k), out_(out) {}

    // Crossings of a line inside the domain.
    void watch_line(double line) {
        int before = 0;                // the side of the line, -1 or 1, on which the loop was last
        std::optional<LinePassage> on; // the last place on the line
        for (size_t i = 0; i < 2 * loop_.size(); ++i) {
            const face::TrimPiece &piece = loop_[i % loop_.size()];
            const int start = side(piece.start, line), end = side(piece.end, line);
            if (start == 0) {
                on = {&piece, 0, piece.start};
            } else {
                go(start, before, on, i);
            }
            if (start * end < 0) {
                const double place = face_.trims().pieces().place_of(piece, static_cast<int>(k_), line);
                on = {&piece, place, face_.trims().pieces().point(piece, place)};
                on->at[k_] = line;
            } else if (end == 0) {
                on = {&piece, 1, piece.end};
            }
            if (end != 0) {
                go(end, before, on, i);
            }
        }
    }
    // Crossings of the seam, from one end of the domain to the other.
    void watch_seam() {
        int before = 0; // the end of the domain, -1 or 1, to which the last piece not along it came; 0: none
        std::optional<LinePassage> on;
        for (size_t i = 0; i < 2 * loop_.size(); ++i) {
            const face::TrimPiece &piece = loop_[i % loop_.size()];
            if (end_of(piece.start) != 0 && end_of(piece.start) == end_of(piece.end)) {
                continue;
            }
            const int start = end_of(piece.start);
            if (i >= loop_.size() && before != 0 && start != 0 && before != start && on) {
                out_.push_back(*on);
            }
            before = end_of(piece.end);
            on = LinePassage{&piece, 1, piece.end};
        }
    }

private:
    [[nodiscard]] int side(const face::Point2 &x, double line) const noexcept {
        return x[k_] < line - lines_.close(k_) ? -1 : x[k_] > line + lines_.close(k_) ? 1 : 0;
    }
    [[nodiscard]] int end_of(const face::Point2 &x) const noexcept {
        return x[k_] <= lines_.domain(k_).lower + lines_.near(k_)   ? -1
               : x[k_] >= lines_.domain(k_).upper - lines_.near(k_) ? 1
                                                                    : 0;
    }
    void go(int now, int &before, std::optional<LinePassage> &on, size_t i) {
        if (before * now < 0 && on && i >= loop_.size()) {
            out_.push_back(*on);
        }
        before = now;
        on.reset();
    }

    const face::Face &face_;
    std::span<const face::TrimPiece> loop_;
    const SnapLines &lines_;
    size_t k_;
    std::vector<LinePassage> &out_;
};

} // namespace

std::vector<LinePassage> passages_of(const face::Face &face, const SnapLines &lines,
                                     std::span<const face::TrimPiece> loop) {
    std::vector<LinePassage> result;
    for (size_t k = 0; k < 2; ++k) {
        LoopWatch watch(face, loop, lines, k, result);
        for (const double line : lines.inner(k)) {
            watch.watch_line(line);
        }
        if (lines.closed(k)) {
            watch.watch_seam();
        }
    }
    for (LinePassage &passage : result) {
        passage.at = lines.snapped(passage.at);
    }
    return result;
}

} // namespace nrb::mesh

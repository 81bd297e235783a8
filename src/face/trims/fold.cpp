// SPDX-License-Identifier: MIT
#include "face/trims/fold.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

// A place at which a piece crosses an end of a copy of the domain along an axis, and the coordinate there.
struct Cut {
    double place;
    int axis;
    double value;
};

// Moves pieces into the domain one after the other, and counts the crossings of the seam of axis 1 on the
// way.
class Folder {
public:
    Folder(const TrimPieces &plane, const Covering &covering, bool closes) noexcept
        : plane_(plane), covering_(covering), closes_(closes) {}

    FoldedPieces fold() {
        size_t first = 0;
        const auto &all = plane_.all();
        for (size_t i = 0; i < all.size(); ++i) {
            if (i > 0 && all[i].loop != all[i - 1].loop) {
                close(first, i);
                first = i;
            }
            add(all[i], i == first);
        }
        close(first, all.size());
        return std::move(result_);
    }

private:
    // Which copy of the domain, along an axis, contains the middle of an interval.
    [[nodiscard]] double copy_of(int k, double a, double b) const noexcept {
        return covering_.closed(k)
                   ? std::floor((a / 2 + b / 2 - covering_.domain(k).lower) / covering_.period(k))
                   : 0;
    }
    // The lower end of a copy, and the upper end of the one before it: the same number for both.
    [[nodiscard]] double border(int k, double copy) const noexcept {
        return covering_.domain(k).lower + copy * covering_.period(k);
    }

    [[nodiscard]] std::vector<Cut> cuts(const TrimPiece &piece) const {
        std::vector<Cut> result;
        for (const int k : {0, 1}) {
            const auto at = static_cast<size_t>(k);
            if (!covering_.closed(k)) {
                continue;
            }
            const double first =
                std::floor((piece.lower[at] - covering_.domain(k).lower) / covering_.period(k));
            for (int64_t i = 0; border(k, first + static_cast<double>(i)) < piece.upper[at]; ++i) {
                const double copy = first + static_cast<double>(i);
                if (border(k, copy) > piece.lower[at]) {
                    result.push_back({plane_.place_of(piece, k, border(k, copy)), k, border(k, copy)});
                }
            }
        }
        std::sort(result.begin(), result.end(), [](const Cut &a, const Cut &b) { return a.place < b.place; });
        return result;
    }

    void add(const TrimPiece &piece, bool first) {
        double from = 0;
        Point2 start = piece.start;
        std::vector<Cut> all = cuts(piece);
        all.push_back({1, -1, 0});
        for (const Cut &cut : all) {
            Point2 end = cut.axis < 0 ? piece.end : plane_.point(piece, cut.place);
            if (cut.axis >= 0) {
                end[static_cast<size_t>(cut.axis)] = cut.value;
            }
            if (cut.axis < 0 || from < cut.place) {
                add_part(piece, {from, cut.place}, start, end, first && from == 0);
                from = cut.place;
                start = end;
            }
        }
    }

    void add_part(const TrimPiece &piece, Interval part, const Point2 &start, const Point2 &end, bool first) {
        if (!(part.lower < part.upper)) {
            return;
        }
        Point2 copy{}, moved_start{}, moved_end{}, move{};
        for (const int k : {0, 1}) {
            const auto at = static_cast<size_t>(k);
            copy[at] = copy_of(k, start[at], end[at]);
            move[at] = -copy[at] * covering_.period(k);
            moved_start[at] = moved(k, start[at], copy[at]);
            moved_end[at] = moved(k, end[at], copy[at]);
        }
        pass(first ? copy[1] : copy_, copy[1], moved_start[0], piece.loop);
        first_copy_ = first ? copy[1] : first_copy_;
        first_at_ = first ? moved_start[0] : first_at_;
        copy_ = copy[1];
        result_.pieces.add_part(plane_, piece, part, moved_start, moved_end, move);
    }
    // Maps ends of copies to the ends of the domain, bit for bit.
    [[nodiscard]] double moved(int k, double x, double copy) const noexcept {
        if (!covering_.closed(k)) {
            return x;
        }
        const Interval domain = covering_.domain(k);
        return x == border(k, copy) ? domain.lower
               : x == border(k, copy + 1)
                   ? domain.upper
                   : std::clamp(x - copy * covering_.period(k), domain.lower, domain.upper);
    }
    void pass(double before, double after, double at, int32_t loop) {
        const int upwards = after > before ? 1 : -1;
        for (auto copies = static_cast<int64_t>(std::abs(after - before)); copies > 0; --copies) {
            result_.passages.push_back({at, upwards, loop});
        }
    }
    // The crossings on the way back to where the loop began, less the periods by which it went around.
    void close(size_t first, size_t end) {
        if (closes_ && first < end && covering_.closed(1)) {
            const auto &all = plane_.all();
            const double turns =
                std::round((all[end - 1].end[1] - all[first].start[1]) / covering_.period(1));
            pass(copy_ - turns, first_copy_, first_at_, all[first].loop);
        }
    }

    const TrimPieces &plane_;
    const Covering &covering_;
    bool closes_;
    FoldedPieces result_;
    double copy_ = 0, first_copy_ = 0, first_at_ = 0;
};

} // namespace

FoldedPieces fold(const TrimPieces &plane, const Covering &covering) {
    return Folder(plane, covering, true).fold();
}

FoldedPieces fold_chains(const TrimPieces &plane, const Covering &covering) {
    return Folder(plane, covering, false).fold();
}

} // namespace nrb::face

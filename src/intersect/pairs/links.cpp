// SPDX-License-Identifier: MIT
#include "intersect/pairs/links.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace nrb::intersect {

namespace {

// The seam of a periodic curve.
struct Seam {
    Interval domain;
    bool open; // cells continue across it

    explicit Seam(const Spline &curve)
        : domain(curve.axis(0).domain()), open(curve.axis(0).periodic() && closes(curve)) {}
    [[nodiscard]] double period() const noexcept { return domain.upper - domain.lower; }
};

// Parts of b that wait for others to touch them. They are sorted by their lower ends, in one class for each
// width up to a factor of 2, so that a search looks at no more of them than it finds, up to a constant
// factor.
class Waiting {
public:
    void add(Interval part, size_t cell) { by_width_[width_class(part)].emplace(part.lower, cell); }

    // Calls visit(cell) for all that may touch a part; those for which it returns false are removed.
    template <class Visit>
    void look(Interval part, Visit &&visit) {
        for (auto &[width, cells] : by_width_) {
            auto found = cells.lower_bound(part.lower - std::ldexp(1.0, width));
            while (found != cells.end() && found->first <= part.upper) {
                found = visit(found->second) ? std::next(found) : cells.erase(found);
            }
        }
    }

private:
    // The exponent of a power of two above the width.
    static int width_class(Interval part) noexcept {
        int exponent = -1100;
        if (part.upper > part.lower) {
            std::frexp(part.upper - part.lower, &exponent);
        }
        return exponent;
    }

    std::map<int, std::multimap<double, size_t>> by_width_;
};

// A sweep along a.
class Sweep {
public:
    Sweep(const Spline &a, const Spline &b, std::span<const NearCell> cells) : a_(a), b_(b), cells_(cells) {}

    std::vector<Link> run() {
        for (size_t i = 0; i < cells_.size(); ++i) {
            places_.push_back({i, 0});
            if (a_.open && cells_[i].a.lower == a_.domain.lower) {
                places_.push_back({i, 1});
            }
        }
        std::ranges::sort(places_, {}, [this](const Place &place) {
            return std::tuple(on_a(place).lower, cells_[place.cell].b.lower, place.cell);
        });
        for (const Place &place : places_) {
            const Interval on_b = cells_[place.cell].b;
            look_back(place, 0);
            if (b_.open && on_b.lower == b_.domain.lower) {
                look_back(place, 1);
            }
            if (b_.open && on_b.upper == b_.domain.upper) {
                look_back(place, -1);
            }
            if (place.turn == 0) {
                waiting_.add(on_b, place.cell);
            }
        }
        return std::move(links_);
    }

private:
    struct Place {
        size_t cell;
        int turn;
    };
    [[nodiscard]] Interval on_a(const Place &place) const noexcept {
        return turned(cells_[place.cell].a, place.turn, a_.period());
    }

    // Links a cell, moved by `turn` periods of b, to the earlier cells that it touches. Cells that end before
    // it touch no later one and are removed.
    void look_back(const Place &place, int turn) {
        const NearCell &cell = cells_[place.cell];
        const Interval on_b = turned(cell.b, turn, b_.period());
        const double start = on_a(place).lower;
        waiting_.look(on_b, [&](size_t other) {
            count_work(8);
            const NearCell &before = cells_[other];
            if (before.a.upper < start) {
                return false;
            }
            const bool same_parts = (place.turn != 0 || before.segment_a == cell.segment_a) &&
                                    (turn != 0 || before.segment_b == cell.segment_b);
            if (same_parts && before.b.upper >= on_b.lower && other != place.cell) {
                links_.push_back({other, place.cell, {place.turn, turn}});
            }
            return true;
        });
    }

    Seam a_, b_;
    std::span<const NearCell> cells_;
    std::vector<Place> places_;
    Waiting waiting_;
    std::vector<Link> links_;
};

// The links of each cell, in both directions.
class Neighbours {
public:
    Neighbours(size_t cells, std::span<const Link> links, const std::function<bool(const Link &)> &counts)
        : of_(cells) {
        for (const Link &link : links) {
            if (counts(link)) {
                of_[link.from].push_back({link.to, link.turns});
                of_[link.to].push_back({link.from, {-link.turns.a, -link.turns.b}});
            }
        }
    }
    [[nodiscard]] const std::vector<NearGroup::Member> &of(size_t cell) const noexcept { return of_[cell]; }

private:
    std::vector<std::vector<NearGroup::Member>> of_;
};

} // namespace

std::vector<Link> links_of(const Spline &a, const Spline &b, std::span<const NearCell> cells) {
    return Sweep(a, b, cells).run();
}

std::vector<NearGroup> groups_of(size_t cells, std::span<const Link> links,
                                 const std::function<bool(const Link &)> &counts) {
    const Neighbours neighbours(cells, links, counts);
    std::vector<bool> seen(cells, false);
    std::vector<NearGroup> groups;
    for (size_t first = 0; first < cells; ++first) {
        if (seen[first]) {
            continue;
        }
        NearGroup &group = groups.emplace_back();
        group.members.push_back({first, {}});
        seen[first] = true;
        for (size_t i = 0; i < group.members.size(); ++i) {
            const NearGroup::Member member = group.members[i];
            for (const NearGroup::Member &next : neighbours.of(member.cell)) {
                if (!seen[next.cell]) {
                    seen[next.cell] = true;
                    group.members.push_back(
                        {next.cell, {member.turns.a + next.turns.a, member.turns.b + next.turns.b}});
                }
            }
        }
    }
    return groups;
}

} // namespace nrb::intersect

// SPDX-License-Identifier: MIT
#include "refine/degree/elevation_table.h"

#include "base/error.h"
#include "base/watch.h"
#include "refine/knots/blossom_rows.h"
#include "refine/periodic/period.h"

#include <algorithm>
#include <span>

namespace nrb::refine {

namespace {

using Group = Elevation::Group;

std::vector<Group> groups_of(std::span<const double> knots) {
    std::vector<Group> groups;
    groups.reserve(knots.size());
    for (size_t i = 0; i < knots.size(); ++i) {
        if (groups.empty() || groups.back().knot != knots[i]) {
            groups.push_back({knots[i], static_cast<int64_t>(i), 0});
        }
        ++groups.back().multiplicity;
    }
    return groups;
}

// Old knots first, ..., end - 1, all of which are arguments of a polar form, and its other arguments, as
// places of old knots.
struct Arguments {
    int64_t first;
    int64_t end;
    int added;
    int64_t extra[max_basis]; // the first `added` are set
};

// What makes a row: coefficients `first`, ..., first + width - 1 are sums of terms.
struct RowShape {
    int64_t first;
    int width;
    int terms;
    BlossomTerm term[max_basis];

    // Whether all terms belong to one control point.
    [[nodiscard]] bool copies() const noexcept { return width == 1; }
    [[nodiscard]] std::span<const BlossomTerm> all() const noexcept {
        return {term, static_cast<size_t>(terms)};
    }
};

// The degree + 1 consecutive raised knots that belong to a control point, by groups.
class RaisedKnots {
public:
    RaisedKnots(int degree, std::span<const double> knots, const std::vector<Group> &groups)
        : degree_(degree), knots_(knots), groups_(groups) {}

    // Precondition: raised index `at` is in group `group`.
    void place(int64_t at, int64_t group) noexcept {
        group_ = group;
        at_start_ = at == raised_first(group);
        size_ = 0;
        for (int left = degree_ + 1; left > 0; ++group) {
            const int64_t after = raised_first(group) + this->group(group).multiplicity + 1 - at;
            copies_[size_] = static_cast<int>(std::min<int64_t>(left, after));
            at += copies_[size_];
            left -= copies_[size_++];
        }
    }
    [[nodiscard]] int64_t raised_first(int64_t group) const noexcept {
        return this->group(group).first + group; // one more of each group before
    }

    // The average over the windows without one of the knots: one term for each group, weighted by the number
    // of copies that can be dropped.
    void shape(RowShape &shape) const noexcept {
        shape.terms = size_;
        int64_t layers[max_basis];
        int64_t first = std::ssize(knots_), end = 0;
        for (int dropped = 0; dropped < size_; ++dropped) {
            layers[dropped] = make_term(dropped, shape.term[dropped]);
            first = std::min(first, layers[dropped]);
            end = std::max(end, layers[dropped] + shape.term[dropped].steps + 1);
        }
        for (int dropped = 0; dropped < size_; ++dropped) {
            shape.term[dropped].target = static_cast<int>(layers[dropped] - first);
        }
        shape.first = first;
        shape.width = static_cast<int>(end - first);
    }

private:
    [[nodiscard]] const Group &group(int64_t i) const noexcept { return groups_[static_cast<size_t>(i)]; }

    // All arguments are the same knot.
    void single(const Group &only, Arguments &arguments) const noexcept {
        // Where the curve is cut the first copies end one part and the last ones begin the next.
        const bool cut = only.multiplicity > degree_;
        const bool after = cut && (size_ == 1 ? !at_start_ : only.knot == group(group_).knot);
        arguments.first = only.first + (after ? 1 : 0);
        arguments.end = arguments.first + std::min(only.multiplicity, degree_);
        arguments.added = degree_ - std::min(only.multiplicity, degree_);
        std::fill_n(arguments.extra, arguments.added, only.first);
    }

    // The window without one copy of its group `dropped`. Old knots strictly inside it are among the
    // arguments as often as they occur; the knots at its ends are the other arguments.
    void drop(int dropped, Arguments &arguments) const noexcept {
        const auto copies = [&](int i) { return copies_[i] - (i == dropped ? 1 : 0); };
        const int low = copies(0) == 0 ? 1 : 0;
        const int high = size_ - (copies(size_ - 1) == 0 ? 2 : 1);
        if (low >= high) {
            return single(group(group_ + std::min(low, size_ - 1)), arguments);
        }
        const Group &left = group(group_ + low);
        const Group &right = group(group_ + high);
        arguments.first = left.first + left.multiplicity - std::min(copies(low), left.multiplicity);
        arguments.end = right.first + std::min(copies(high), right.multiplicity);
        arguments.added = 0;
        for (int i = low; i <= high; ++i) {
            if (copies(i) > group(group_ + i).multiplicity) {
                arguments.extra[arguments.added++] = group(group_ + i).first;
            }
        }
    }

    // With d further arguments a polar form is a combination of d + 1 control points: Cox-de Boor steps over
    // the knots around the arguments that it has (T. Lyche, K. Morken, "Making the Oslo algorithm more
    // efficient", SIAM J. Numer. Anal. 23 (1986)). Returns the first control point.
    int64_t make_term(int dropped, BlossomTerm &term) const noexcept {
        Arguments arguments;
        drop(dropped, arguments);
        term.steps = arguments.added;
        term.factor = copies_[dropped] / static_cast<double>(degree_ + 1);
        term.left = knots_.data() + arguments.first;
        term.right = knots_.data() + arguments.end;
        term.pitch = 1;
        for (int i = 0; i < arguments.added; ++i) {
            term.arguments[i] = knots_.data() + arguments.extra[i];
        }
        return arguments.first - 1 - arguments.added;
    }

    int degree_;
    std::span<const double> knots_;
    const std::vector<Group> &groups_;
    int64_t group_ = 0;
    bool at_start_ = true;
    int size_ = 0;
    int copies_[max_basis] = {};
};

// The rows of windows one after another, into a table whose layers begin at `shift`.
class RowMaker {
public:
    RowMaker(const KnotVector &axis, std::span<const double> knots, const std::vector<Group> &groups,
             int64_t shift, LayerTable &table)
        : degree_(axis.degree()), groups_(groups), shift_(shift), table_(table),
          raised_(degree_, knots, groups) {}

    // Rows that begin at raised knots `at`, ..., end - 1.
    void make(int64_t at, int64_t end) {
        for (int64_t group = first_group(at); at < end;) {
            while (group + 1 < std::ssize(groups_) && raised_.raised_first(group + 1) <= at) {
                ++group;
            }
            const int64_t blocks = at == raised_.raised_first(group) ? alike(at, group, end) : 0;
            at += blocks > 0 ? make_rows(at, group, blocks) : make_row(at, group);
        }
    }

private:
    [[nodiscard]] int multiplicity(int64_t group) const noexcept {
        return groups_[static_cast<size_t>(group)].multiplicity;
    }

    // The group of a raised knot.
    [[nodiscard]] int64_t first_group(int64_t at) const noexcept {
        int64_t low = 0, high = std::ssize(groups_) - 1;
        while (low < high) {
            const int64_t middle = (low + high + 1) / 2;
            (raised_.raised_first(middle) <= at ? low : high) =
                raised_.raised_first(middle) <= at ? middle : middle - 1;
        }
        return low;
    }

    // How many of the next groups, a multiple of row_lanes, have windows that see only knots of one
    // multiplicity. No window reaches further than degree + 1 groups before the first, and twice as many
    // after the last.
    int64_t alike(int64_t at, int64_t group, int64_t end) {
        const int64_t reach = degree_ + 1;
        const int64_t wanted = (end - at) / (multiplicity(group) + 1);
        if (group >= run_end_) {
            const int64_t last = std::min(std::ssize(groups_), group + wanted + 2 * reach + 1);
            run_first_ = group;
            run_end_ = group + 1;
            while (run_end_ < last && multiplicity(run_end_) == multiplicity(group)) {
                ++run_end_;
            }
        }
        const int64_t groups = std::min(run_end_ - 2 * reach - group, wanted);
        return group - reach < run_first_ || groups < row_lanes ? 0 : groups - groups % row_lanes;
    }

    int64_t make_row(int64_t at, int64_t group) {
        RowShape shape;
        raised_.place(at, group);
        raised_.shape(shape);
        if (shape.copies()) {
            table_.add_copy(shape.first - shift_);
        } else {
            double row[max_basis];
            blossom_row_sum(shape.all(), shape.width, row);
            table_.add_row(shape.first - shift_, row, shape.width);
        }
        return 1;
    }

    // The windows that begin in `count` groups. Windows with the same place in their group are alike.
    int64_t make_rows(int64_t at, int64_t group, int64_t count) {
        const int m = multiplicity(group);
        LayerTable::Row pattern[max_basis + 1];
        RowShape shape;
        int64_t pitch = 0;
        for (int place = 0; place <= m; ++place) {
            raised_.place(at + place, group);
            raised_.shape(shape);
            pattern[place] = {shape.first - shift_, shape.copies() ? 0 : shape.width,
                              static_cast<size_t>(pitch)};
            pitch += pattern[place].size;
        }
        double *rows = table_.room(count * pitch);
        for (int place = 0; place <= m; ++place) {
            raised_.place(at + place, group);
            raised_.shape(shape);
            if (!shape.copies()) {
                blossom_row_sums(shape.all(), m, count, shape.width, pitch, rows + pattern[place].offset);
            }
        }
        table_.add_pattern({pattern, static_cast<size_t>(m) + 1}, count, m, pitch);
        return count * (m + 1);
    }

    int degree_;
    const std::vector<Group> &groups_;
    int64_t shift_;
    LayerTable &table_;
    RaisedKnots raised_;
    int64_t run_first_ = 0; // the groups of one multiplicity around the present one
    int64_t run_end_ = 0;
};

int64_t group_at(const std::vector<Group> &groups, int64_t index) noexcept {
    const auto after = std::upper_bound(groups.begin(), groups.end(), index,
                                        [](int64_t i, const Group &group) { return i < group.first; });
    return after - groups.begin() - 1;
}

// Raised knots first, ..., end - 1 are those of the elevated axis.
struct Range {
    int64_t first;
    int64_t end;
};

// `lead` extended knots stand before the stored ones. On a periodic axis the new copy of an end of the domain
// stands after it at both ends; on any other axis it stands outside.
Range kept_knots(const KnotVector &axis, const std::vector<Group> &groups, int64_t lead) noexcept {
    const int64_t p = axis.degree();
    const int64_t lower = p + lead + group_at(groups, p + lead) + (axis.periodic() ? 0 : 1);
    const int64_t upper = axis.count() + lead + group_at(groups, axis.count() + lead);
    return {lower - p - 1, upper + p + 2};
}

void check_period(const KnotVector &axis, std::span<const double> knots) {
    const int p = axis.degree() + 1;
    const auto upper = knots[knots.size() - 1 - static_cast<size_t>(p)];
    if (knots[static_cast<size_t>(p)] != axis.domain().lower || upper != axis.domain().upper) {
        fail(Status::periodic_knots,
             "knots: the ends of the periodic domain [%s, %s] have other multiplicities than their copies",
             Number(axis.domain().lower).text, Number(axis.domain().upper).text);
    }
    check_periodic_knots(p, knots, -1, 0);
}

} // namespace

Elevation::Elevation(const KnotVector &axis)
    : axis_(axis), lead_(axis.periodic() ? 2 * int64_t{axis.degree()} + 2 : 0),
      extended_(axis.periodic() ? extended_knots(axis, lead_) : std::vector<double>()),
      groups_(groups_of(old_knots())) {
    const Range kept = kept_knots(axis, groups_, lead_);
    const int64_t p = axis.degree();
    first_ = kept.first;
    end_ = kept.end;
    rows_ = kept.end - kept.first - p - 2 - (axis.periodic() ? p + 1 : 0);
    if (axis.periodic()) {
        check_period(axis, knots());
    }
}

std::vector<double> Elevation::knots() const {
    std::vector<double> raised;
    raised.reserve(old_knots().size() + groups_.size());
    for (const Group &group : groups_) {
        raised.insert(raised.end(), static_cast<size_t>(group.multiplicity) + 1, group.knot);
    }
    raised.resize(static_cast<size_t>(end_));
    raised.erase(raised.begin(), raised.begin() + first_);
    return raised;
}

LayerTable Elevation::rows(int64_t first, int64_t end) const {
    constexpr int64_t part = 8192; // is made without a look at the watch
    LayerTable table;
    table.reserve(end - first, axis_.degree() + 2);
    for (int64_t next = std::min(first + part, end); first < end;
         first = next, next = std::min(next + part, end)) {
        count_work((next - first) * (axis_.degree() + 2) * (axis_.degree() + 2));
        RowMaker(axis_, old_knots(), groups_, lead_, table).make(first_ + 1 + first, first_ + 1 + next);
    }
    return table;
}

} // namespace nrb::refine

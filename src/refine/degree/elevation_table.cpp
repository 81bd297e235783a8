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

// The arguments of a polar form, as indices of old knots: the consecutive knots first, ..., end - 1, and
// further ones.
struct Arguments {
    int64_t first;
    int64_t end;
    int added;
    int64_t extra[max_basis]; // `added` of them are set
};

// How a row is computed: its coefficients, which belong to layers first, ..., first + width - 1, are a sum of
// terms.
struct RowShape {
    int64_t first;
    int width;
    int terms;
    BlossomTerm term[max_basis];

    // Whether all terms belong to one control point, so that the row is a copy of it.
    [[nodiscard]] bool copies() const noexcept { return width == 1; }
    [[nodiscard]] std::span<const BlossomTerm> all() const noexcept {
        return {term, static_cast<size_t>(terms)};
    }
};

// The window of a new control point: degree + 1 consecutive raised knots, grouped by value. Raised knots are
// the old ones with one more copy of each.
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
        return this->group(group).first + group; // each group before has one more
    }

    // The mean over the windows with one knot dropped. There is one term for each group, weighted by the
    // number of copies that can be dropped.
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

    // The case in which all arguments are one knot.
    void single(const Group &only, Arguments &arguments) const noexcept {
        // Where the curve may jump, the first copies end one piece and the last copies begin the next.
        const bool cut = only.multiplicity > degree_;
        const bool after = cut && (size_ == 1 ? !at_start_ : only.knot == group(group_).knot);
        arguments.first = only.first + (after ? 1 : 0);
        arguments.end = arguments.first + std::min(only.multiplicity, degree_);
        arguments.added = degree_ - std::min(only.multiplicity, degree_);
        std::fill_n(arguments.extra, arguments.added, only.first);
    }

    // The arguments that remain when one copy of group `dropped` is removed from the window. Old knots
    // strictly inside occur among them as often as in the old vector; further arguments are knots at the two
    // ends.
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

    // With d arguments that are not old knots, the polar form is a combination of d + 1 control points:
    // Cox-de Boor steps over the old knots around its other arguments (T. Lyche, K. Morken, "Making the Oslo
    // algorithm more efficient", SIAM J. Numer. Anal. 23 (1986)). Returns the first of these control points.
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

// Appends the rows of consecutive windows to a table in which old layer `shift` has number 0.
class RowMaker {
public:
    RowMaker(const KnotVector &axis, std::span<const double> knots, const std::vector<Group> &groups,
             int64_t shift, LayerTable &table)
        : degree_(axis.degree()), groups_(groups), shift_(shift), table_(table),
          raised_(degree_, knots, groups) {}

    // The rows of the windows that begin at raised knots `at`, ..., end - 1.
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

    // The group of raised knot `at`.
    [[nodiscard]] int64_t first_group(int64_t at) const noexcept {
        int64_t low = 0, high = std::ssize(groups_) - 1;
        while (low < high) {
            const int64_t middle = (low + high + 1) / 2;
            (raised_.raised_first(middle) <= at ? low : high) =
                raised_.raised_first(middle) <= at ? middle : middle - 1;
        }
        return low;
    }

    // How many groups from `group` on, a multiple of row_lanes, have windows that contain only knots of one
    // multiplicity. No window depends on groups farther than degree + 1 before the first one, or twice as
    // many after the last one.
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

    // The rows of the windows that begin in `count` groups. Windows that begin at the same copy in their
    // group have the same shape.
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
    int64_t run_first_ = 0; // the present run of groups of one multiplicity
    int64_t run_end_ = 0;
};

int64_t group_at(const std::vector<Group> &groups, int64_t index) noexcept {
    const auto after = std::upper_bound(groups.begin(), groups.end(), index,
                                        [](int64_t i, const Group &group) { return i < group.first; });
    return after - groups.begin() - 1;
}

// The raised knots first, ..., end - 1.
struct Range {
    int64_t first;
    int64_t end;
};

// The raised knots that make up the new axis. `lead` knots precede the stored ones. On a periodic axis, the
// new copy of either end of the domain follows that end; on any other axis it lies outside the domain.
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
    constexpr int64_t part = 8192; // rows between two counts of work
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

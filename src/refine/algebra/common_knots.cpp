// SPDX-License-Identifier: MIT
#include "refine/algebra/common_knots.h"

#include "base/error.h"
#include "base/watch.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nrb::refine {

namespace {

// How many copies of the knot at `index` precede it, and how many follow it.
struct Beside {
    int before;
    int after;
};

Beside beside(std::span<const double> knots, int64_t index) noexcept {
    const auto [first, last] =
        std::equal_range(knots.begin(), knots.end(), knots[static_cast<size_t>(index)]);
    return {static_cast<int>(index - (first - knots.begin())),
            static_cast<int>(last - knots.begin() - 1 - index)};
}

// The distinct knots of one period, from the lower end of the domain on, with their multiplicities.
std::vector<KnotGroup> one_period(const KnotVector &axis) {
    const auto [lower, upper] = axis.domain();
    const Beside start = beside(axis.knots(), axis.degree()), end = beside(axis.knots(), axis.count());
    if (start.before != end.before) {
        fail(Status::periodic_knots,
             "knots: the ends of the periodic domain [%s, %s] have other multiplicities than their copies",
             Number(lower).text, Number(upper).text);
    }
    const int64_t first = axis.degree() - start.before;
    return distinct_knots(
        axis.knots().subspan(static_cast<size_t>(first), static_cast<size_t>(axis.distinct_layers())));
}

constexpr int64_t work_of_a_knot = 64; // most of it is memory

// The union of the distinct knots of all members, in order.
std::vector<double> knots_of_all(const std::vector<std::vector<KnotGroup>> &own) {
    std::vector<double> all, more;
    for (const std::vector<KnotGroup> &groups : own) {
        std::vector<double> knots;
        knots.reserve(groups.size());
        for (const KnotGroup &group : groups) {
            knots.push_back(group.knot);
        }
        count_work(work_of_a_knot / 2 * std::ssize(knots));
        more.reserve(all.size() + knots.size());
        std::set_union(all.begin(), all.end(), knots.begin(), knots.end(), std::back_inserter(more));
        all = std::exchange(more, {});
    }
    return all;
}

// A knot moved by `periods` periods. The upper end of the domain is the copy of the lower one, without
// rounding.
double copy_of(double knot, int64_t periods, Interval domain) noexcept {
    if (periods == 0 || (periods == 1 && knot == domain.lower)) {
        return periods == 0 ? knot : domain.upper;
    }
    return knot + static_cast<double>(periods) * (domain.upper - domain.lower);
}

} // namespace

CommonKnots::CommonKnots(int degree, const std::vector<const KnotVector *> &members, int extra)
    : degree_(degree) {
    const bool periodic = std::all_of(members.begin(), members.end(),
                                      [](const KnotVector *member) { return member->periodic(); });
    if (periodic) {
        add_periodic(members);
    } else {
        add_open(members);
    }
    count_copies(extra);
    if (periodic) {
        choose_periodic(members);
    } else {
        choose_open(members, extra);
    }
}

// The union of the knots of all members, with the multiplicity that each has in every member.
std::vector<CommonKnots::Group> CommonKnots::merged(const std::vector<std::vector<KnotGroup>> &own) {
    const std::vector<double> all = knots_of_all(own);
    std::vector<Group> result;
    result.reserve(all.size());
    std::vector<size_t> next(own.size(), 0);
    for (const double knot : all) {
        count_work(work_of_a_knot);
        Group group{knot, 0, 0, {}, {}};
        for (size_t i = 0; i < own.size(); ++i) {
            const bool has = next[i] < own[i].size() && own[i][next[i]].knot == knot;
            group.times[i] = has ? own[i][next[i]++].multiplicity : 0;
        }
        result.push_back(group);
    }
    return result;
}

void CommonKnots::append(Group group) {
    for (size_t i = 0; i < members_.size(); ++i) {
        std::vector<double> &knots = members_[i].knots;
        group.place[i] = std::ssize(knots);
        knots.insert(knots.end(), static_cast<size_t>(group.times[i]), group.knot);
    }
    groups_.push_back(group);
}

void CommonKnots::add_open(const std::vector<const KnotVector *> &members) {
    std::vector<std::vector<KnotGroup>> own;
    for (const KnotVector *member : members) {
        members_.push_back({member->degree(), {}, 0, 0});
        own.push_back(distinct_knots(member->knots()));
    }
    const std::vector<Group> all = merged(own);
    groups_.reserve(all.size());
    for (const Group &group : all) {
        count_work(work_of_a_knot);
        append(group);
    }
}

// Appends enough periods that each member has 2 r + 2 knots on either side of the domain: r + 1 of them may
// be arguments of a polar form, the others are the knots next to these.
void CommonKnots::add_periodic(const std::vector<const KnotVector *> &members) {
    const Interval domain = members.front()->domain();
    std::vector<std::vector<KnotGroup>> own;
    int64_t fewest = members.front()->distinct_layers();
    for (const KnotVector *member : members) {
        members_.push_back({member->degree(), {}, 0, member->distinct_layers()});
        own.push_back(one_period(*member));
        fewest = std::min(fewest, member->distinct_layers());
    }
    const std::vector<Group> period = merged(own);
    const int64_t periods = (2 * int64_t{degree_} + 1) / fewest + 1;
    for (int64_t turn = -periods; turn <= periods; ++turn) {
        for (Group group : period) {
            group.knot = copy_of(group.knot, turn, domain);
            check_rising(group.knot);
            append(group);
        }
    }
    const Group &lower = groups_[group_of(domain.lower)];
    for (size_t i = 0; i < members_.size(); ++i) {
        const KnotVector &member = *members[i];
        members_[i].shift = lower.place[i] - member.degree() + beside(member.knots(), member.degree()).before;
    }
}

void CommonKnots::check_rising(double knot) const {
    if (!groups_.empty() && !(groups_.back().knot < knot)) {
        fail(Status::periodic_knots,
             "knots: copies a multiple of the period away meet at %s, where rounding makes knots equal that "
             "differ",
             Number(knot).text);
    }
}

void CommonKnots::count_copies(int extra) {
    int64_t first = 0;
    for (Group &group : groups_) {
        count_work(work_of_a_knot / 4);
        int copies = 0;
        for (size_t i = 0; i < members_.size(); ++i) {
            const int raised = degree_ - members_[i].degree + group.times[i];
            copies = std::max(copies, group.times[i] > 0 ? raised : 0);
        }
        group.first = first;
        group.copies = std::min(copies + extra, degree_ + 1);
        first += group.copies;
    }
}

// Clamping and the knots outside the domain: each end of the domain gets as many copies beyond it as any
// member requires.
void CommonKnots::choose_open(const std::vector<const KnotVector *> &members, int extra) {
    Beside most{0, 0};
    for (const KnotVector *member : members) {
        const int raise = degree_ - member->degree() + extra;
        most.before = std::max(most.before, beside(member->knots(), member->degree()).before + raise);
        most.after = std::max(most.after, beside(member->knots(), member->count()).after + raise);
    }
    const auto [lower, upper] = members.front()->domain();
    const Group &start = groups_[group_of(lower)], &end = groups_[group_of(upper)];
    first_ = start.first + std::min(most.before, degree_) - degree_;
    const int64_t last = end.first + end.copies - 1 - std::min(most.after, degree_) + degree_;
    axis_ = make_knot_vector(degree_, knots_between(first_, last + 1));
}

// The period begins at the copy of its first knot at which the period of a member begins, the latest copy if
// the members differ.
void CommonKnots::choose_periodic(const std::vector<const KnotVector *> &members) {
    int before = 0;
    for (const KnotVector *member : members) {
        before = std::max(before, beside(member->knots(), member->degree()).before);
    }
    const auto [lower, upper] = members.front()->domain();
    const Group &start = groups_[group_of(lower)], &end = groups_[group_of(upper)];
    before = std::min(before, start.copies - 1);
    first_ = start.first + before - degree_;
    axis_ = make_knot_vector(degree_, knots_between(first_, end.first + before + degree_ + 1), true);
}

size_t CommonKnots::group_of(double knot) const noexcept {
    return static_cast<size_t>(
        std::lower_bound(groups_.begin(), groups_.end(), knot,
                         [](const Group &group, double value) { return group.knot < value; }) -
        groups_.begin());
}

size_t CommonKnots::group_at(int64_t index) const noexcept {
    return static_cast<size_t>(
        std::upper_bound(groups_.begin(), groups_.end(), index,
                         [](int64_t i, const Group &group) { return i < group.first; }) -
        groups_.begin() - 1);
}

std::vector<double> CommonKnots::knots_between(int64_t first, int64_t end) const {
    std::vector<double> knots;
    knots.reserve(static_cast<size_t>(end - first));
    for (size_t g = group_at(first); std::ssize(knots) < end - first; ++g) {
        count_work(work_of_a_knot / 4);
        const int64_t from = std::max(groups_[g].first, first);
        const int64_t to = std::min(groups_[g].first + groups_[g].copies, end);
        knots.insert(knots.end(), static_cast<size_t>(to - from), groups_[g].knot);
    }
    return knots;
}

// The layers that a periodic axis wraps around have the windows of the first ones, of which they are copies.
CommonKnots::Window CommonKnots::window(int64_t layer) const noexcept {
    const int64_t before = first_ + layer % axis_->distinct_layers();
    const Group &start = groups_[group_at(before)];
    Window window{};
    window.start = start.knot;
    int64_t at = before + 1;
    auto g = static_cast<size_t>(&start - groups_.data());
    g += at < start.first + start.copies ? 0 : 1;
    window.group = static_cast<int64_t>(g);
    for (int left = degree_; left > 0; ++g) {
        const auto copies =
            static_cast<int>(std::min<int64_t>(left, groups_[g].first + groups_[g].copies - at));
        window.copies[static_cast<size_t>(window.size++)] = copies;
        at += copies;
        left -= copies;
    }
    return window;
}

// A member of degree 0 has no arguments. Its run is then empty and is located after the last copy of the
// start of the support.
CommonKnots::Run CommonKnots::own_arguments(size_t member, const Group *groups, const int *chosen, int low,
                                            int high, double start) const noexcept {
    if (low > high) {
        const Group &last = groups_[group_of(start)];
        return {last.place[member] + last.times[member], 0};
    }
    if (low == high) {
        const Group &only = groups[low];
        const int used = std::min(only.times[member], members_[member].degree);
        return {only.place[member] + (only.knot == start ? only.times[member] - used : 0), used};
    }
    const int64_t first = groups[low].place[member] + std::max(groups[low].times[member] - chosen[low], 0);
    return {first, groups[high].place[member] + std::min(groups[high].times[member], chosen[high]) - first};
}

void CommonKnots::blossom_row(int member, const Window &window, const int *chosen,
                              BlossomRow &row) const noexcept {
    const auto m = static_cast<size_t>(member);
    const Group *groups = groups_.data() + window.group;
    int low = 0, high = window.size - 1;
    while (low < window.size && chosen[low] == 0) {
        ++low;
    }
    while (high >= 0 && chosen[high] == 0) {
        --high;
    }
    const Run run = own_arguments(m, groups, chosen, low, high, window.start);
    const double *first = members_[m].knots.data() + run.first, *end = first + run.size;
    row.coefficients[0] = 1;
    row.size = 1;
    for (int i = low; i <= high; ++i) {
        for (int extra = chosen[i] - groups[i].times[m]; extra > 0; --extra) {
            append_argument(first, end, row.size++, groups[i].knot, row.coefficients);
        }
    }
    row.first = run.first - row.size - members_[m].shift;
}

int64_t CommonKnots::stored_layer(int member, int64_t layer) const noexcept {
    const int64_t period = members_[static_cast<size_t>(member)].period;
    return period == 0 ? layer : (layer % period + period) % period;
}

} // namespace nrb::refine

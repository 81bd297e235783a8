// SPDX-License-Identifier: MIT
#include "refine/compose/distributed_rows.h"

#include "base/watch.h"
#include "numeric/binomial.h"
#include "refine/knots/blossom.h"
#include "spline/contract.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace nrb::refine {

namespace {

constexpr int64_t work_of_all = 400, work_of_a_choice = 100, work_of_a_way = 100;

} // namespace

void DistributedRows::make(const KnotVector &axis, int64_t span, std::span<const ArgumentChoice> choices,
                           Interval between, const CopyBounds &bounds) {
    count_work(work_of_all + work_of_a_choice * std::ssize(choices));
    axis_ = &axis;
    span_ = span;
    between_ = between;
    bounds_ = bounds;
    order(choices);
    bound_choices();
    forget();
    number_places();
    copies_ = {};
    take_closed(0, axis.degree(), {1, 1});
    make_rows();
    make_shares();
}

void DistributedRows::order(std::span<const ArgumentChoice> choices) {
    choices_.clear();
    powers_.clear();
    std::array<size_t, 3> ends{};
    for (const Kind kind : {Kind::closed, Kind::mixed, Kind::end}) {
        for (const ArgumentChoice &choice : choices) {
            if (kind_of(choice.value) == kind) {
                choices_.push_back(shared(choice));
            }
        }
        ends[static_cast<size_t>(kind)] = choices_.size();
    }
    closed_ = ends[0];
    mixed_ = ends[1];
}

DistributedRows::Kind DistributedRows::kind_of(double value) const noexcept {
    const auto [lower, upper] = between_;
    if (value == lower || value == upper) {
        return Kind::end;
    }
    const int p = axis_->degree();
    const auto around =
        axis_->knots().subspan(static_cast<size_t>(span_ - p + 1), 2 * static_cast<size_t>(p));
    const bool is_between =
        value > lower && value < upper && std::ranges::find(around, value) == around.end();
    return is_between ? Kind::mixed : Kind::closed;
}

DistributedRows::Choice DistributedRows::shared(const ArgumentChoice &choice) {
    const auto [lower, upper] = between_;
    const double after = choice.value - lower, ahead = upper - choice.value;
    const size_t powers = powers_.size();
    powers_.push_back({1, 1});
    for (int n = 0; n < axis_->degree(); ++n) {
        const auto [count, weighted] = powers_.back();
        powers_.push_back({count * choice.orders, weighted * (choice.orders * choice.weight)});
    }
    return {choice, after == 0 ? 0 : std::min(after, ahead) / (upper - lower), ahead < after, powers};
}

void DistributedRows::bound_choices() {
    Reach reach;
    inner_degree_ =
        choices_.empty() ? 0 : std::reduce(choices_[0].copies.begin(), choices_[0].copies.end(), 0);
    reach.least.fill(std::numeric_limits<int8_t>::max());
    reach.most.fill(0);
    reach_.assign(choices_.size() + 1, reach);
    for (size_t i = choices_.size(); i-- > 0;) {
        for (size_t j = 0; j < bounds_.knots; ++j) {
            reach.least[j] = std::min(reach.least[j], choices_[i].copies[j]);
            reach.most[j] = std::max(reach.most[j], choices_[i].copies[j]);
        }
        reach_[i] = reach;
    }
}

// A place is a number for each set of copies, in mixed radix. The total number of copies is fixed, so the
// copies of one knot follow from those of the others: the knot with the largest range is left out.
void DistributedRows::number_places() {
    const auto range = [&](size_t i) { return bounds_.most[i] - bounds_.least[i] + 1; };
    size_t longest = 0, places = 1;
    for (size_t i = 1; i < bounds_.knots; ++i) {
        longest = range(i) > range(longest) ? i : longest;
    }
    for (size_t i = 0; i < bounds_.knots; ++i) {
        strides_[i] = i == longest ? 0 : places;
        places *= i == longest ? 1 : static_cast<size_t>(range(i));
    }
    found_.resize(std::max(found_.size(), places));
}

// There may be many places, most of which were never found. Only those that were found are reset.
void DistributedRows::forget() {
    for (const Slot &slot : slots_) {
        found_[slot.place] = 0;
    }
    nodes_.clear();
    slots_.clear();
    sums_.clear();
}

size_t DistributedRows::place_of(const Copies &copies) const noexcept {
    size_t place = 0;
    for (size_t i = 0; i < bounds_.knots; ++i) {
        place += strides_[i] * static_cast<size_t>(copies[i] - bounds_.least[i]);
    }
    return place;
}

// Whether choices from `next` on may supply the missing arguments within the bounds. (A necessary condition.)
bool DistributedRows::can_end(int missing, size_t next) const noexcept {
    const auto &[least, most] = reach_[next];
    int wanted = 0, usable = 0;
    for (size_t i = 0; i < bounds_.knots; ++i) {
        const int left = bounds_.most[i] - copies_[i], needed = bounds_.least[i] - copies_[i];
        if (missing * least[i] > left || missing * most[i] < needed) {
            return false;
        }
        wanted += std::max(0, needed);
        usable += std::min(left, missing * most[i]);
    }
    const int all = missing * inner_degree_;
    return wanted <= all && all <= usable && (missing == 0 || next < choices_.size());
}

// Takes a choice `times` times if the bounds allow it. Returns whether they do.
bool DistributedRows::take(const Choice &choice, int times) noexcept {
    for (size_t i = 0; i < bounds_.knots; ++i) {
        if (copies_[i] + times * choice.copies[i] > bounds_.most[i]) {
            return false;
        }
    }
    give_back(choice, -times);
    return true;
}

void DistributedRows::give_back(const Choice &choice, int times) noexcept {
    for (size_t i = 0; i < bounds_.knots; ++i) {
        copies_[i] = static_cast<int8_t>(copies_[i] - times * choice.copies[i]);
    }
}

// The number of ways after `times` of the `missing` arguments have been given this choice.
DistributedRows::Ways DistributedRows::with(Ways ways, const Choice &choice, int times,
                                            int missing) const noexcept {
    const auto n = static_cast<size_t>(times);
    const double places = binomials(missing)[n];
    const auto [count, weighted] = powers_[choice.powers + n];
    return {ways.count * (places * count), ways.weighted * (places * weighted)};
}

void DistributedRows::take_closed(size_t next, int missing, Ways ways) {
    if (!can_end(missing, next)) {
        return;
    }
    if (next == closed_) {
        return begin(missing, ways);
    }
    const Choice &choice = choices_[next];
    const size_t before = arguments_.size();
    int times = 0;
    for (bool more = true; more; more = times < missing && take(choice, 1), ++times) {
        take_closed(next + 1, missing - times, with(ways, choice, times, missing));
        arguments_.push_back(choice.value);
    }
    give_back(choice, times - 1);
    arguments_.resize(before);
}

void DistributedRows::begin(int missing, Ways ways) {
    const auto open = static_cast<size_t>(missing);
    const size_t row = nodes_.empty() ? 0 : nodes_.back().row + nodes_.back().open + 1;
    nodes_.push_back({arguments_, open, row, slots_.size(), {}});
    shares_[0][0] = 1;
    take_mixed(closed_, missing, ways, 0);
    if (slots_.size() == nodes_.back().slot) {
        nodes_.pop_back();
    }
}

// Precondition of take_mixed() and take_ends(): can_end(missing, next).
void DistributedRows::take_mixed(size_t next, int missing, Ways ways, size_t mixed) {
    if (next == mixed_) {
        return take_ends(next, missing, ways, mixed, 0);
    }
    const Choice &choice = choices_[next];
    int times = 0;
    for (bool more = true; more; ++times) {
        if (can_end(missing - times, next + 1)) {
            take_mixed(next + 1, missing - times, with(ways, choice, times, missing), mixed);
        }
        more = times < missing && take(choice, 1);
        if (more) {
            mix(choice, mixed++);
        }
    }
    give_back(choice, times - 1);
}

// `upper` counts the arguments so far that are B. The last choice has to supply all arguments that are
// missing.
void DistributedRows::take_ends(size_t next, int missing, Ways ways, size_t mixed, size_t upper) {
    if (missing == 0) {
        return add_way(ways, mixed, upper);
    }
    const Choice &choice = choices_[next];
    const int least = next + 1 == choices_.size() ? missing : 0;
    if (!take(choice, least)) {
        return;
    }
    int times = least;
    for (bool more = true; more; more = times < missing && take(choice, 1), ++times) {
        if (can_end(missing - times, next + 1)) {
            const int more_upper = choice.is_upper ? times : 0;
            take_ends(next + 1, missing - times, with(ways, choice, times, missing), mixed,
                      upper + static_cast<size_t>(more_upper));
        }
    }
    give_back(choice, times - 1);
}

// From the coefficients for `mixed` mixed arguments, computes those for one more.
void DistributedRows::mix(const Choice &choice, size_t mixed) noexcept {
    const auto &shares = shares_[mixed];
    auto &more = shares_[mixed + 1];
    more[0] = 0;
    for (size_t i = 0; i <= mixed; ++i) {
        const double smaller = shares[i] * choice.smaller, larger = shares[i] - smaller;
        more[i] += choice.is_upper ? smaller : larger;
        more[i + 1] = choice.is_upper ? larger : smaller;
    }
}

void DistributedRows::add_way(Ways ways, size_t mixed, size_t upper) {
    count_work(work_of_a_way);
    Slot &slot = slot_of_copies();
    slot.ways.add(ways.count);
    CompensatedSum *sums = sums_.data() + slot.sums + upper;
    for (size_t i = 0; i <= mixed; ++i) {
        sums[i].add(ways.weighted * shares_[mixed][i]);
        nodes_.back().used.set(upper + i);
    }
}

DistributedRows::Slot &DistributedRows::slot_of_copies() {
    const size_t place = place_of(copies_);
    size_t &found = found_[place];
    if (found <= nodes_.back().slot) { // of another node, or not yet found
        slots_.push_back({place, sums_.size(), nodes_.size() - 1, copies_, {}});
        sums_.resize(sums_.size() + nodes_.back().open + 1);
        found = slots_.size();
    }
    return slots_[found - 1];
}

void DistributedRows::make_rows() {
    const auto length = static_cast<size_t>(axis_->degree()) + 1;
    const size_t rows = nodes_.empty() ? 0 : nodes_.back().row + nodes_.back().open + 1;
    rows_.assign(rows * length, 0);
    for (const Node &node : nodes_) {
        for (size_t i = 0; i <= node.open; ++i) {
            if (node.used[i]) {
                add_row(node, i);
            }
        }
    }
    batches_.finish();
}

// Adds the row of a node in which B occurs `number` times and A in all other open arguments.
void DistributedRows::add_row(const Node &node, size_t number) {
    std::array<double, max_basis> arguments;
    double *end = std::ranges::copy(node.arguments, arguments.data()).out;
    end = std::fill_n(end, node.open - number, between_.lower);
    end = std::fill_n(end, number, between_.upper);
    const KnotArguments split = split_arguments(*axis_, span_, std::span(arguments.data(), end));
    double *const row = rows_.data() + (node.row + number) * (static_cast<size_t>(axis_->degree()) + 1) +
                        (split.begin - split.others - 1 - span_ + axis_->degree());
    if (split.others == 0) {
        *row = 1;
    } else {
        const double *knots = axis_->knots().data();
        batches_.add(split.others, knots + split.begin, knots + split.end, split.values.data(), row);
    }
}

void DistributedRows::make_shares() {
    const auto length = static_cast<int>(axis_->degree()) + 1;
    means_.clear();
    for (const Slot &slot : slots_) {
        found_[slot.place] = 0;
    }
    for (const Slot &slot : slots_) {
        size_t &found = found_[slot.place];
        if (found == 0) {
            means_.push_back({slot.copies, 0, {}});
            found = means_.size();
        }
        Share &share = means_[found - 1];
        share.ways += slot.ways.value();
    }
    std::array<double, max_basis> factors, part;
    for (const Slot &slot : slots_) {
        const Node &node = nodes_[slot.node];
        Share &share = means_[found_[slot.place] - 1];
        for (size_t i = 0; i <= node.open; ++i) {
            factors[i] = sums_[slot.sums + i].value() / share.ways;
        }
        contract(factors.data(), static_cast<int>(node.open) + 1,
                 rows_.data() + node.row * static_cast<size_t>(length), length, length, part.data());
        for (size_t i = 0; i < static_cast<size_t>(length); ++i) {
            share.row[i] += part[i];
        }
    }
}

const DistributedRows::Share *DistributedRows::find(const Copies &copies) const noexcept {
    for (size_t i = 0; i < bounds_.knots; ++i) {
        if (copies[i] < bounds_.least[i] || copies[i] > bounds_.most[i]) {
            return nullptr;
        }
    }
    const size_t found = found_[place_of(copies)];
    return found == 0 ? nullptr : &means_[found - 1];
}

} // namespace nrb::refine

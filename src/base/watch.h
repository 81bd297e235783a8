// SPDX-License-Identifier: MIT
// Watches a long call from outside: progress callbacks, cancellation and a limit on its work.
//
// Time-consuming loops count their work. They lie many layers below the C interface, in functions with other
// concerns, so the watch is not passed down as an argument but found in a thread-local slot. The slot is set
// while a watched call runs, and empty while its callback runs: a call made by the callback is a call of its
// own. Where nobody watches, counting costs one read of the slot.
#pragma once

#include "base/error.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace nrb::inline base {

class Watch {
public:
    struct Wishes {
        int64_t work = 0; // limit, in multiply-adds; 0: none
        int32_t (*progress)(double done, void *user) = nullptr;
        void *user = nullptr;
    };

    // Watches the calling thread until it is destroyed.
    explicit Watch(const Wishes &wishes) noexcept;
    ~Watch();
    Watch(const Watch &) = delete;
    Watch &operator=(const Watch &) = delete;

    // The watch of the calling thread, or null.
    [[nodiscard]] static Watch *current() noexcept;

    // Throws CallEnded if the callback asks for it. Reaching the work limit throws, too, unless a limited
    // search is under way, which asks for the limit and ends by itself.
    void count(int64_t work) {
        left_ -= work;
        if (left_ < 0) {
            look();
        }
    }

    // Whether a limited search has reached the work limit.
    [[nodiscard]] bool ended() const noexcept { return ended_; }
    // From here on the limit ends nothing: for callers that answer with what they have.
    void pass_limit() noexcept { ended_ = true; }

private:
    friend class Steps;
    friend class Phase;
    friend class SearchSteps;
    friend class LimitedSearch;
    friend class PartOfWork;
    friend class NotCounted;
    friend class NeededWork;
    friend class UsualLimit;
    friend int64_t work_left() noexcept;
    friend bool work_is_limited() noexcept;
    friend void require_work();
    friend void end_for_work();
    using Clock = std::chrono::steady_clock;
    // Multiply-adds between two reads of the clock, each of which takes as long as about 100 of them.
    static constexpr int64_t often = 1 << 14;

    void settle() noexcept;
    void grant() noexcept;
    void look();
    void end();
    void look_at_clock();
    void report();
    int32_t ask();

    Wishes wishes_;
    int64_t limit_;
    // Work counted towards the limit, and work since the last look at the clock; both without the work still
    // granted.
    int64_t counted_ = 0, unseen_ = 0;
    // Work that may be done before anything needs checking, and what is left of it.
    int64_t granted_ = 0, left_ = 0;
    int uncounted_ = 0, searches_ = 0;
    bool ended_ = false, usual_ = false; // usual_: the limit is that of a UsualLimit
    double from_ = 0, to_ = 1;           // the part of the call that the present loop makes up
    double done_ = 0;
    Clock::time_point last_;
    Watch *outer_;
};

inline void count_work(int64_t multiply_adds) {
    if (Watch *watch = Watch::current()) {
        watch->count(multiply_adds);
    }
}

// Resizes a vector, in parts, because the system may be slow to provide memory.
template <class T>
void grow_watched(std::vector<T> &values, size_t size) {
    constexpr size_t part = size_t{1} << 15;
    values.reserve(size);
    while (Watch::current() != nullptr && values.size() + part < size) {
        values.resize(values.size() + part);
        count_work(part);
    }
    values.resize(size);
}

// A copy, made in parts for the same reason, with capacity for `more` further elements.
template <class T>
std::vector<T> copied_watched(std::span<const T> values, size_t more = 0) {
    std::vector<T> copy;
    copy.reserve(values.size() + more);
    constexpr size_t part = size_t{1} << 15;
    for (size_t first = 0; first < values.size(); first += part) {
        const auto some = values.subspan(first, std::min(part, values.size() - first));
        copy.insert(copy.end(), some.begin(), some.end());
        count_work(static_cast<int64_t>(some.size()) / 2);
    }
    return copy;
}

// A loop of steps that take about equally long; reports how much of the call is done. Loops inside a step
// subdivide its share.
class Steps {
public:
    explicit Steps(int64_t count) noexcept;
    ~Steps();
    Steps(const Steps &) = delete;
    Steps &operator=(const Steps &) = delete;

    // Ends a step that took `work` beyond what was counted inside it. Throws as Watch::count() does.
    void next(int64_t work = 0) {
        if (watch_ != nullptr) {
            ++step_;
            set_step();
            watch_->count(work);
        }
    }

private:
    void set_step() noexcept {
        watch_->from_ = std::min(from_ + step_ * length_, to_);
        watch_->to_ = std::min(watch_->from_ + length_, to_);
    }

    Watch *watch_;
    double step_ = 0, length_ = 0; // steps done, and the share of one step
    double from_ = 0, to_ = 1;     // the share of all steps
};

// A part of a call that other parts follow. Its share of the remaining progress is a guess; what is left at
// its end belongs to the parts that follow. In a loop with an unknown number of rounds, each round takes half
// of what is left.
class Phase {
public:
    explicit Phase(double share = 0.5) noexcept;
    ~Phase();
    Phase(const Phase &) = delete;
    Phase &operator=(const Phase &) = delete;

private:
    Watch *watch_;
    double end_ = 0, to_ = 0;
};

// Progress of a search whose length is unknown: the number of items examined, relative to those examined and
// those waiting.
class SearchSteps {
public:
    SearchSteps() noexcept;
    ~SearchSteps();
    SearchSteps(const SearchSteps &) = delete;
    SearchSteps &operator=(const SearchSteps &) = delete;

    void next(size_t waiting) noexcept {
        if (watch_ != nullptr) {
            advance(waiting);
        }
    }

private:
    void advance(size_t waiting) noexcept;

    Watch *watch_;
    double looked_ = 0, from_ = 0, to_ = 0;
};

// While this exists, reaching the work limit does not throw: the search asks work_ended() and answers with
// what it has.
class LimitedSearch {
public:
    LimitedSearch() noexcept;
    ~LimitedSearch();
    LimitedSearch(const LimitedSearch &) = delete;
    LimitedSearch &operator=(const LimitedSearch &) = delete;

private:
    Watch *watch_;
};

// Whether a limited search has reached the work limit.
[[nodiscard]] bool work_ended() noexcept;
// The work that is left before the limit; the largest int64_t if there is no limit.
[[nodiscard]] int64_t work_left() noexcept;
[[nodiscard]] bool work_is_limited() noexcept;
// Throws as Watch::count() does if a limited search has reached the work limit: for callers that have no use
// for an incomplete answer.
void require_work();
// Ends the work as reaching the limit does, for callers whose part of it, such as a PartOfWork, is used up;
// does nothing without a limit.
void end_for_work();

// While this exists, and if the caller has set no work limit, a default limit of `work` multiply-adds holds.
// At the limit, a limited search ends with what it has; any other loop fails with Status::not_converged.
class UsualLimit {
public:
    explicit UsualLimit(int64_t work) noexcept;
    ~UsualLimit();
    UsualLimit(const UsualLimit &) = delete;
    UsualLimit &operator=(const UsualLimit &) = delete;

private:
    std::optional<Watch> own_; // if the caller set up no watch
    Watch *watch_;             // null: the caller has set a limit
    int64_t limit_ = 0;        // the previous limit
};

// While this exists, only a share of the remaining work may be used; the rest is kept for finishing what was
// found by then.
class PartOfWork {
public:
    explicit PartOfWork(double share = 0.5) noexcept;
    ~PartOfWork();
    PartOfWork(const PartOfWork &) = delete;
    PartOfWork &operator=(const PartOfWork &) = delete;

private:
    Watch *watch_;
    int64_t limit_ = 0; // the previous limit
    bool ended_ = false;
};

// Whether an attempt, which is worthless unless it is complete, ended before the work limit. If not, the
// limit ends nothing from then on.
template <class Attempt>
[[nodiscard]] bool attempted(Attempt &&attempt) {
    if (work_ended()) {
        return false;
    }
    try {
        attempt();
    } catch (const CallEnded &end) {
        if (end.why.status() == Status::cancelled) {
            throw;
        }
        Watch::current()->pass_limit();
        return false;
    }
    return true;
}

// The usual limit: about a second, plus for_a_point multiply-adds for each control point, enough where all
// goes well.
constexpr int64_t usual_work(int64_t points, int64_t for_a_point = 20000) noexcept {
    return 800000000 + for_a_point * points;
}

// While this exists, work does not count towards the limit. It is for tables that a handle keeps, so that an
// answer does not depend on earlier queries.
class NotCounted {
public:
    NotCounted() noexcept;
    ~NotCounted();
    NotCounted(const NotCounted &) = delete;
    NotCounted &operator=(const NotCounted &) = delete;

private:
    Watch *watch_;
};

// As NotCounted, but only under a usual limit: for work that no answer can do without, however long it takes.
class NeededWork {
public:
    NeededWork() noexcept;
    [[nodiscard]] bool is_free() const noexcept { return free_.has_value(); }

private:
    std::optional<NotCounted> free_;
};

} // namespace nrb::inline base

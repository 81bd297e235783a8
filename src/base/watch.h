// SPDX-License-Identifier: MIT
// How a long call is watched and ended from outside.
//
// The loops in which time passes count their work. They lie many layers below the border, under functions that
// have other business, so that the watch is found in a slot of the thread instead of being handed down. The slot
// is set while a watched call runs, and empty while its callback runs: a call that the callback makes is a call
// of its own. Where nobody watches, counting costs a read of the slot.
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
        int64_t work = 0; // most multiply-adds; 0: no limit
        int32_t (*progress)(double done, void *user) = nullptr;
        void *user = nullptr;
    };

    // Watches the calling thread until it is destroyed.
    explicit Watch(const Wishes &wishes) noexcept;
    ~Watch();
    Watch(const Watch &) = delete;
    Watch &operator=(const Watch &) = delete;

    // The one of the calling thread, or null.
    [[nodiscard]] static Watch *current() noexcept;

    // Throws CallEnded if the callback asks for it, and at the limit of work, unless a search is
    // under way that ends by itself.
    void count(int64_t work) {
        left_ -= work;
        if (left_ < 0) {
            look();
        }
    }

    // Whether the limit of work is reached.
    [[nodiscard]] bool ended() const noexcept { return ended_; }
    // From here on the limit ends nothing: for those who answer with what they have.
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
    // Multiply-adds between two looks at the clock, which takes as long as about 100 of them.
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
    // For the limit, and since the clock was looked at; without what is taken.
    int64_t counted_ = 0, unseen_ = 0;
    // Work that may be done before anything can happen, and what is left of it.
    int64_t granted_ = 0, left_ = 0;
    int uncounted_ = 0, searches_ = 0;
    bool ended_ = false, usual_ = false; // whether the limit is that of a UsualLimit
    double from_ = 0, to_ = 1;           // the part of the whole that the present loop makes up
    double done_ = 0;
    Clock::time_point last_;
    Watch *outer_;
};

inline void count_work(int64_t multiply_adds) {
    if (Watch *watch = Watch::current()) {
        watch->count(multiply_adds);
    }
}

// Makes a vector longer: in parts, because a system may be slow to give memory.
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

// A copy, in parts too, with room for more.
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

// A loop of steps that take about equally long: tells how much of the call is done. Loops inside a step divide it
// further.
class Steps {
public:
    explicit Steps(int64_t count) noexcept;
    ~Steps();
    Steps(const Steps &) = delete;
    Steps &operator=(const Steps &) = delete;

    // A step is done, which took so much work beyond what was counted in it. Throws as Watch::count() does.
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
    double step_ = 0, length_ = 0; // of a step
    double from_ = 0, to_ = 1;     // of all steps
};

// A part of a call that others follow, whose share of it is a guess: what is left at its end is theirs. In a loop of
// which nobody knows how long it goes on, each round takes half of what is left.
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

// A search of which nobody knows how long it takes: what has been looked at, of that and of what waits.
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

// While this exists, the limit of work does not end the call: the search asks, and answers with what it has.
class LimitedSearch {
public:
    LimitedSearch() noexcept;
    ~LimitedSearch();
    LimitedSearch(const LimitedSearch &) = delete;
    LimitedSearch &operator=(const LimitedSearch &) = delete;

private:
    Watch *watch_;
};

// Whether the limit of work is reached.
[[nodiscard]] bool work_ended() noexcept;
// What is left of it; without a limit more than any work.
[[nodiscard]] int64_t work_left() noexcept;
[[nodiscard]] bool work_is_limited() noexcept;
// Throws as Watch::count() does if a limited search has come to the limit of work: for those to whom half an answer is none.
void require_work();
// The same where a part of the work, such as its half, has ended; without a limit it does nothing.
void end_for_work();

// While this exists, and the caller has set no limit of work, there is one of so many multiply-adds: a limited search ends
// with what it has, any other loop with Status::not_converged.
class UsualLimit {
public:
    explicit UsualLimit(int64_t work) noexcept;
    ~UsualLimit();
    UsualLimit(const UsualLimit &) = delete;
    UsualLimit &operator=(const UsualLimit &) = delete;

private:
    std::optional<Watch> own_; // where nobody watches
    Watch *watch_;             // null: the caller has a limit
    int64_t limit_ = 0;        // before
};

// While this exists, a share of the work that is left is all there is: what was found by then is finished with the rest.
class PartOfWork {
public:
    explicit PartOfWork(double share = 0.5) noexcept;
    ~PartOfWork();
    PartOfWork(const PartOfWork &) = delete;
    PartOfWork &operator=(const PartOfWork &) = delete;

private:
    Watch *watch_;
    int64_t limit_ = 0; // before
    bool ended_ = false;
};

// Whether an attempt, half of which is worth nothing, came to its end before the limit of work. If not, the limit ends
// nothing from then on.
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

// About a second, and more for splines of many control points, which take so much each where all goes well.
constexpr int64_t usual_work(int64_t points, int64_t for_a_point = 20000) noexcept {
    return 800000000 + for_a_point * points;
}

// While this exists, work does not count for the limit: that of tables that a handle keeps, so that an answer does
// not depend on what was asked before.
class NotCounted {
public:
    NotCounted() noexcept;
    ~NotCounted();
    NotCounted(const NotCounted &) = delete;
    NotCounted &operator=(const NotCounted &) = delete;

private:
    Watch *watch_;
};

// The same for a usual limit alone: for what no answer can do without, however long it takes.
class NeededWork {
public:
    NeededWork() noexcept;
    [[nodiscard]] bool is_free() const noexcept { return free_.has_value(); }

private:
    std::optional<NotCounted> free_;
};

} // namespace nrb::inline base

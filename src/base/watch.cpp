// SPDX-License-Identifier: MIT
#include "base/watch.h"

#include "base/error.h"
#include "base/no_cancellation.h"

#include <algorithm>
#include <cstdio>
#include <cxxabi.h>
#include <limits>
#include <utility>

namespace nrb::inline base {

namespace {

thread_local Watch *watch_of_thread = nullptr;

constexpr std::chrono::milliseconds pause{10}; // between two calls of the callback

} // namespace

Watch::Watch(const Wishes &wishes) noexcept
    : wishes_(wishes), limit_(wishes.work > 0 ? wishes.work : std::numeric_limits<int64_t>::max()),
      last_(Clock::now()), outer_(std::exchange(watch_of_thread, this)) {
    grant();
}

Watch::~Watch() {
    watch_of_thread = outer_;
}

Watch *Watch::current() noexcept {
    return watch_of_thread;
}

void Watch::end() {
    if (searches_ == 0) {
        char text[96];
        std::snprintf(text, sizeof text,
                      usual_ ? "no result within the usual limit of work, %lld multiply-adds"
                             : "call.work = %lld multiply-adds were not enough",
                      static_cast<long long>(wishes_.work));
        throw CallEnded{{usual_ ? Status::not_converged : Status::work, text}};
    }
    ended_ = true;
}

// Accounts for the part of the granted work that has been used.
void Watch::settle() noexcept {
    const int64_t taken = granted_ - left_;
    unseen_ += taken;
    counted_ += uncounted_ > 0 ? 0 : taken;
    granted_ = left_ = 0;
}

// Grants the work that may be done before the next look at the clock or before the limit is exceeded.
void Watch::grant() noexcept {
    const bool limited = uncounted_ == 0 && !ended_;
    granted_ = left_ = std::min(often - 1 - unseen_, limited ? limit_ - counted_ : often);
}

void Watch::look() {
    settle();
    if (counted_ > limit_ && !ended_) {
        end();
    }
    if (unseen_ >= often) {
        unseen_ = 0;
        look_at_clock();
    }
    grant();
}

void Watch::look_at_clock() {
    if (wishes_.progress == nullptr) {
        return;
    }
    const Clock::time_point now = Clock::now();
    if (now - last_ >= pause) {
        report();
        last_ = Clock::now();
    }
}

void Watch::report() {
    done_ = std::max(done_, from_);
    const int32_t answer = ask();
    if (answer != 0) {
        char text[48];
        std::snprintf(text, sizeof text, "call.progress returned %d", static_cast<int>(answer));
        throw CallEnded{{Status::cancelled, text}};
    }
}

// No exception of the callback escapes, whatever its language.
int32_t Watch::ask() {
    const NoCancellation shield;
    watch_of_thread = nullptr;
    int32_t answer = 1;
    try {
        answer = wishes_.progress(done_, wishes_.user);
    } catch (abi::__forced_unwind &) { // the callback ends the thread, as Python does with threads at exit
        throw;
    } catch (...) {
        watch_of_thread = this;
        throw CallEnded{{Status::cancelled, "call.progress threw an exception"}};
    }
    watch_of_thread = this;
    return answer;
}

Steps::Steps(int64_t count) noexcept : watch_(Watch::current()) {
    if (watch_ != nullptr) {
        from_ = watch_->from_;
        to_ = watch_->to_;
        length_ = (to_ - from_) / static_cast<double>(std::max<int64_t>(count, 1));
        set_step();
    }
}

Steps::~Steps() {
    if (watch_ != nullptr) {
        watch_->from_ = watch_->to_ = to_;
    }
}

Phase::Phase(double share) noexcept : watch_(Watch::current()) {
    if (watch_ != nullptr) {
        to_ = watch_->to_;
        end_ = watch_->to_ = watch_->from_ + share * (to_ - watch_->from_);
    }
}

Phase::~Phase() {
    if (watch_ != nullptr) {
        watch_->from_ = end_;
        watch_->to_ = to_;
    }
}

SearchSteps::SearchSteps() noexcept : watch_(Watch::current()) {
    if (watch_ != nullptr) {
        from_ = watch_->from_;
        to_ = watch_->to_;
        watch_->to_ = from_;
    }
}

SearchSteps::~SearchSteps() {
    if (watch_ != nullptr) {
        watch_->from_ = watch_->to_ = to_;
    }
}

void SearchSteps::advance(size_t waiting) noexcept {
    constexpr double few = 100; // the number of items below which the share says little
    ++looked_;
    const double share = looked_ / (looked_ + static_cast<double>(waiting) + few);
    watch_->from_ = watch_->to_ = std::max(watch_->from_, from_ + share * (to_ - from_));
}

LimitedSearch::LimitedSearch() noexcept : watch_(Watch::current()) {
    if (watch_ != nullptr) {
        ++watch_->searches_;
    }
}

LimitedSearch::~LimitedSearch() {
    if (watch_ != nullptr) {
        --watch_->searches_;
    }
}

bool work_ended() noexcept {
    return watch_of_thread != nullptr && watch_of_thread->ended();
}

bool work_is_limited() noexcept {
    const Watch *const watch = Watch::current();
    return watch != nullptr && watch->limit_ < std::numeric_limits<int64_t>::max();
}

int64_t work_left() noexcept {
    Watch *const watch = Watch::current();
    if (watch == nullptr) {
        return std::numeric_limits<int64_t>::max();
    }
    watch->settle();
    watch->grant();
    return watch->ended_ ? 0 : std::max<int64_t>(0, watch->limit_ - watch->counted_);
}

void require_work() {
    if (work_ended()) {
        watch_of_thread->end();
    }
}

void end_for_work() {
    if (work_is_limited()) {
        watch_of_thread->end();
    }
}

UsualLimit::UsualLimit(int64_t work) noexcept : watch_(Watch::current()) {
    if (watch_ == nullptr) {
        watch_ = &own_.emplace(Watch::Wishes{});
    } else if (watch_->wishes_.work > 0 || watch_->usual_) {
        watch_ = nullptr;
        return;
    }
    watch_->settle();
    limit_ = std::exchange(watch_->limit_, watch_->counted_ + work);
    watch_->wishes_.work = work; // as messages give it
    watch_->usual_ = true;
    watch_->grant();
}

UsualLimit::~UsualLimit() {
    if (watch_ != nullptr) {
        watch_->settle();
        watch_->limit_ = limit_;
        watch_->wishes_.work = 0;
        watch_->usual_ = watch_->ended_ = false;
        watch_->grant();
    }
}

PartOfWork::PartOfWork(double share) noexcept : watch_(Watch::current()) {
    if (watch_ != nullptr) {
        watch_->settle();
        ended_ = watch_->ended_;
        limit_ = watch_->limit_;
        if (work_is_limited()) {
            const auto left = static_cast<double>(std::max<int64_t>(0, limit_ - watch_->counted_));
            watch_->limit_ -= static_cast<int64_t>((1 - share) * left);
        }
        watch_->grant();
    }
}

PartOfWork::~PartOfWork() {
    if (watch_ != nullptr) {
        watch_->settle();
        watch_->limit_ = limit_;
        watch_->ended_ = ended_;
        watch_->grant();
    }
}

NotCounted::NotCounted() noexcept : watch_(Watch::current()) {
    if (watch_ != nullptr) {
        watch_->settle();
        ++watch_->uncounted_;
        watch_->grant();
    }
}

NotCounted::~NotCounted() {
    if (watch_ != nullptr) {
        watch_->settle();
        --watch_->uncounted_;
        watch_->grant();
    }
}

NeededWork::NeededWork() noexcept {
    if (const Watch *watch = Watch::current(); watch != nullptr && watch->usual_) {
        free_.emplace();
    }
}

} // namespace nrb::inline base

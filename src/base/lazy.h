// SPDX-License-Identifier: MIT
// Slots for tables derived from an immutable object: built on demand by any thread, then shared.
#pragma once

#include "base/watch.h"

#include <atomic>
#include <cstdint>
#include <memory>

namespace nrb::inline base {

// Building a table does not count towards the work limit of the call that happens to need it first. If two
// threads build at the same time, the first to store wins and the other result is dropped. No thread ever
// waits, and a builder that throws leaves the slot empty.
template <class T>
class Lazy {
public:
    Lazy() noexcept = default;
    Lazy(const Lazy &) = delete;
    Lazy &operator=(const Lazy &) = delete;
    ~Lazy() { delete slot_.load(std::memory_order_acquire); }

    // The table, or null if it does not exist yet.
    [[nodiscard]] const T *peek() const noexcept { return slot_.load(std::memory_order_acquire); }

    template <class Build>
    const T &get(Build &&build) const {
        if (const T *ready = peek()) {
            return *ready;
        }
        const NotCounted kept;
        const Phase phase(0.2); // small tables do not report their progress any finer
        auto fresh = std::make_unique<const T>(build());
        const T *expected = nullptr;
        if (slot_.compare_exchange_strong(expected, fresh.get(), std::memory_order_acq_rel)) {
            return *fresh.release();
        }
        return *expected;
    }

private:
    mutable std::atomic<const T *> slot_{nullptr};
};

// A slot for one table, of any type, that belongs to a copyable, mutable value. A copy of the value starts
// without the table.
class OwnTable {
public:
    OwnTable() noexcept = default;
    OwnTable(const OwnTable &) noexcept {}
    OwnTable &operator=(const OwnTable &other) noexcept {
        if (this != &other) {
            std::destroy_at(&slot_);
            std::construct_at(&slot_);
        }
        return *this;
    }
    ~OwnTable() = default;

    // The table that make() returns as a std::shared_ptr.
    template <class T, class Make>
    [[nodiscard]] const T &get(Make &&make) const {
        const auto &kept =
            slot_.get([&] { return std::shared_ptr<const void>(std::shared_ptr<const T>(make())); });
        return *static_cast<const T *>(kept.get());
    }

private:
    Lazy<std::shared_ptr<const void>> slot_;
};

// Decides when a table is built: as soon as the uses of the object so far have paid for it. Until then each
// use works without the table, at the price of a share of the cost of the table. So neither a single use nor
// many uses take more than twice the time that is necessary.
class Uses {
public:
    // Adds `uses` to the count; `cost` is the cost of the table in uses.
    [[nodiscard]] bool pay(int64_t uses, int64_t cost) const noexcept {
        return uses >= cost || count_.fetch_add(uses, std::memory_order_relaxed) + uses >= cost;
    }

private:
    mutable std::atomic<int64_t> count_{0};
};

} // namespace nrb::inline base

// SPDX-License-Identifier: MIT
// Slots for tables that are derived from an immutable object: built when needed, by any thread, then shared.
#pragma once

#include "base/watch.h"

#include <atomic>
#include <cstdint>
#include <memory>

namespace nrb::inline base {

// Building does not count for the limit of work of the call that needs the table first. If two threads meet, both may
// build; the first to store wins, and the other result is dropped. No thread ever waits, and a builder that throws
// leaves the slot empty.
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
        const Phase phase(0.2); // small tables are told by no more
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

// A slot for one table, of any kind, of a value that can be copied and changed: its copies begin without the table.
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

    // What make() returns a std::shared_ptr of.
    template <class T, class Make>
    [[nodiscard]] const T &get(Make &&make) const {
        const auto &kept =
            slot_.get([&] { return std::shared_ptr<const void>(std::shared_ptr<const T>(make())); });
        return *static_cast<const T *>(kept.get());
    }

private:
    Lazy<std::shared_ptr<const void>> slot_;
};

// Decides when a table is built: as soon as the uses of an object so far have paid for it. Until then every
// use works without the table, which costs as much as a share of the table. So neither one use nor many uses
// cost more than twice the necessary time.
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

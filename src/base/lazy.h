// Slots for tables that are derived from an immutable object: built when needed, by any thread, then shared.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

namespace nrb::inline base {

// Two threads that meet may both build; the first to store wins and the other result is dropped. Nobody ever
// waits, and a builder that throws leaves the slot empty.
template <class T>
class Lazy {
public:
    Lazy() noexcept = default;
    Lazy(const Lazy &) = delete;
    Lazy &operator=(const Lazy &) = delete;
    ~Lazy() { delete slot_.load(std::memory_order_acquire); }

    // The table, or null while there is none.
    [[nodiscard]] const T *peek() const noexcept { return slot_.load(std::memory_order_acquire); }

    template <class Build>
    const T &get(Build &&build) const {
        if (const T *ready = peek()) {
            return *ready;
        }
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

// Whether the uses of an object so far have paid for a table: until then every use does without, which costs
// as much as the table's share, so that neither one use nor many cost more than twice what they must.
class Uses {
public:
    // Counts `uses` more; `cost` is the cost of the table in uses.
    [[nodiscard]] bool pay(int64_t uses, int64_t cost) const noexcept {
        return uses >= cost || count_.fetch_add(uses, std::memory_order_relaxed) + uses >= cost;
    }

private:
    mutable std::atomic<int64_t> count_{0};
};

} // namespace nrb::inline base

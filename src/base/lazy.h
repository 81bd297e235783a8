// A slot for a table that is derived from an immutable object: built at first use, by any thread, then
// shared.
#pragma once

#include <atomic>
#include <memory>

namespace nrb {

// Two threads that meet may both build; the first to store wins and the other result is dropped. Nobody ever
// waits, and a builder that throws leaves the slot empty.
template <class T>
class Lazy {
public:
    Lazy() noexcept = default;
    Lazy(const Lazy &) = delete;
    Lazy &operator=(const Lazy &) = delete;
    ~Lazy() { delete slot_.load(std::memory_order_acquire); }

    template <class Build>
    const T &get(Build &&build) const {
        if (const T *ready = slot_.load(std::memory_order_acquire)) {
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

} // namespace nrb

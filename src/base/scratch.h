// SPDX-License-Identifier: MIT
// Scratch memory of one call. It is on the stack while it is small, so that evaluating a few points allocates
// nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace nrb::inline base {

class Scratch {
public:
    explicit Scratch(size_t size)
        : heap_(size > inline_size ? new double[size] : nullptr), next_(heap_ ? heap_.get() : inline_) {}
    Scratch(const Scratch &) = delete;
    Scratch &operator=(const Scratch &) = delete;

    // The next `size` doubles, uninitialised. Precondition: the sizes taken add up to at most the size given
    // to the constructor.
    double *take(size_t size) noexcept {
        double *block = next_;
        next_ += size;
        return block;
    }
    // As take(), but aligned to a cache line, which may skip up to line - 1 doubles.
    double *take_aligned(size_t size) noexcept {
        const size_t over = reinterpret_cast<uintptr_t>(next_) / sizeof(double) % line;
        next_ += (line - over) % line;
        return take(size);
    }
    static constexpr size_t line = 64 / sizeof(double);

private:
    static constexpr size_t inline_size = 1024;
    alignas(64) double inline_[inline_size];
    std::unique_ptr<double[]> heap_;
    double *next_;
};

} // namespace nrb::inline base

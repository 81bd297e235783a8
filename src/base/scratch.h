// Working memory of one call: on the stack while it is small, so that evaluating a few points allocates
// nothing.
#pragma once

#include <cstddef>
#include <memory>

namespace nrb {

class Scratch {
public:
    explicit Scratch(size_t size)
        : heap_(size > inline_size ? new double[size] : nullptr), next_(heap_ ? heap_.get() : inline_) {}
    Scratch(const Scratch &) = delete;
    Scratch &operator=(const Scratch &) = delete;

    // The next `size` doubles, uninitialised. Precondition: the sizes taken add up to at most the size asked
    // for.
    double *take(size_t size) noexcept {
        double *block = next_;
        next_ += size;
        return block;
    }

private:
    static constexpr size_t inline_size = 1024;
    double inline_[inline_size];
    std::unique_ptr<double[]> heap_;
    double *next_;
};

} // namespace nrb

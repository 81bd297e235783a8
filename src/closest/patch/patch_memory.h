// SPDX-License-Identifier: MIT
// Working memory of one query: on the stack while it is small.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace nrb::closest {

// A stack of doubles, which a Hold gives back in the reverse order.
class PatchMemory {
public:
    PatchMemory() noexcept = default;
    PatchMemory(const PatchMemory &) = delete;
    PatchMemory &operator=(const PatchMemory &) = delete;

    // An uninitialised array, padded to a multiple of a cache line.
    double *take(int64_t size) {
        const auto rounded = (static_cast<size_t>(size) + 7) / 8 * 8;
        if (block_ == 0 && used_ + rounded <= inline_size) {
            used_ += rounded;
            return inline_ + used_ - rounded;
        }
        return take_more(rounded);
    }

    // Gives back at the end of its life what was taken since its beginning.
    class Hold {
    public:
        explicit Hold(PatchMemory &memory) noexcept
            : memory_(memory), block_(memory.block_), used_(memory.used_) {}
        Hold(const Hold &) = delete;
        Hold &operator=(const Hold &) = delete;
        ~Hold() {
            memory_.block_ = block_;
            memory_.used_ = used_;
        }

    private:
        PatchMemory &memory_;
        size_t block_;
        size_t used_;
    };

private:
    struct Block {
        std::unique_ptr<double[]> data;
        size_t size;
    };
    static constexpr size_t inline_size = 4096;
    static constexpr size_t block_size = 1 << 16;

    double *take_more(size_t size) {
        if (block_ == 0 || used_ + size > blocks_[block_ - 1].size) {
            ++block_;
            used_ = 0;
        }
        if (block_ > blocks_.size()) {
            const size_t made = size > block_size ? size : block_size;
            blocks_.push_back({std::unique_ptr<double[]>(new double[made]), made});
        } else if (blocks_[block_ - 1].size < size) {
            blocks_[block_ - 1] = {std::unique_ptr<double[]>(new double[size]), size};
        }
        used_ += size;
        return blocks_[block_ - 1].data.get() + used_ - size;
    }

    alignas(64) double inline_[inline_size];
    std::vector<Block> blocks_;
    size_t block_ = 0; // the current block is blocks_[block_ - 1]; 0: inline_
    size_t used_ = 0;
};

// A vector whose first N elements need no allocation.
template <class T, size_t N>
class ShortList {
public:
    ShortList() noexcept {} // the elements stay uninitialised
    ShortList(const ShortList &) = delete;
    ShortList &operator=(const ShortList &) = delete;

    void clear() noexcept {
        size_ = 0;
        rest_.clear();
    }
    void push_back(const T &value) {
        if (size_ < N) {
            first_[size_] = value;
        } else {
            if (size_ == N) {
                rest_.assign(first_, first_ + N);
            }
            rest_.push_back(value);
        }
        ++size_;
    }
    [[nodiscard]] size_t size() const noexcept { return size_; }
    [[nodiscard]] T *begin() noexcept { return size_ <= N ? first_ : rest_.data(); }
    [[nodiscard]] T *end() noexcept { return begin() + size_; }
    [[nodiscard]] T &operator[](size_t i) noexcept { return begin()[i]; }

private:
    T first_[N];
    size_t size_ = 0;
    std::vector<T> rest_;
};

} // namespace nrb::closest

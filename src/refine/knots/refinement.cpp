// SPDX-License-Identifier: MIT
#include "refine/knots/refinement.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::refine {

namespace {

constexpr int64_t work_of_a_knot = 16; // for each coarse knot and the fine ones up to the next

size_t at(int64_t i) noexcept {
    return static_cast<size_t>(i);
}

} // namespace

Refinement::Refinement(int degree, std::span<const double> coarse, std::span<const double> fine)
    : degree_(degree), coarse_(coarse), fine_(fine),
      old_first_(std::make_unique_for_overwrite<int64_t[]>(fine.size() + 1)),
      old_last_(std::make_unique_for_overwrite<int64_t[]>(fine.size() + 1)) {
    int64_t old = 0, begin = 0;
    const auto rows = std::ssize(fine);
    while (old < std::ssize(coarse)) {
        count_work(work_of_a_knot);
        const double knot = coarse[at(old)];
        for (; fine[at(begin)] < knot; ++begin) {
            old_first_[at(begin)] = old_last_[at(begin)] = old;
        }
        const int64_t first = old;
        int64_t after = old + 1, end = begin + 1;
        while (after < std::ssize(coarse) && coarse[at(after)] == knot) {
            ++after;
        }
        while (end < rows && fine[at(end)] == knot) {
            ++end;
        }
        for (; begin < end; ++begin) {
            old_first_[at(begin)] = old;
            old_last_[at(begin)] = std::max(first, after - (end - begin));
            old = std::min(old + 1, after);
        }
        old = after;
    }
    std::fill(old_first_.get() + begin, old_first_.get() + rows + 1, old);
    std::fill(old_last_.get() + begin, old_last_.get() + rows + 1, old);
}

} // namespace nrb::refine

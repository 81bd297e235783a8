#include "refine/refinement.h"

#include "basis/bspline.h"

#include <algorithm>

namespace nrb {

Refinement::Refinement(int degree, std::span<const double> coarse, std::span<const double> fine)
    : degree_(degree), coarse_(coarse), fine_(fine) {
    old_first_.reserve(fine.size() + 1);
    old_last_.reserve(fine.size() + 1);
    int64_t old = 0;
    for (size_t begin = 0; begin < fine.size();) {
        size_t end = begin + 1;
        while (end < fine.size() && fine[end] == fine[begin]) {
            ++end;
        }
        int64_t behind = old;
        while (behind < std::ssize(coarse) && coarse[static_cast<size_t>(behind)] == fine[begin]) {
            ++behind;
        }
        const auto total = static_cast<int64_t>(end - begin);
        for (int64_t i = 0; i < total; ++i) {
            old_first_.push_back(std::min(old + i, behind));
            old_last_.push_back(std::max(old, behind - (total - i)));
        }
        old = behind;
        begin = end;
    }
    old_first_.push_back(old);
    old_last_.push_back(old);
}

void append_argument(const double *left, const double *right, int d, double t,
                     double *coefficients) noexcept {
    left -= d;
    double carried = 0;
    for (int r = 0; r < d; ++r) {
        const auto [alpha, beta] = split(coefficients[r], left[r], t, right[r]);
        coefficients[r] = carried + beta;
        carried = alpha;
    }
    coefficients[d] = carried;
}

Refinement::Band Refinement::row(int64_t j, double *coefficients) const noexcept {
    const double *arguments = fine_.data() + j + 1;
    const int64_t shared = old_last_[static_cast<size_t>(j + 1)];
    const int64_t shared_end = old_first_[static_cast<size_t>(j + degree_ + 1)];
    const double *left = coarse_.data() + shared;
    const double *right = coarse_.data() + shared_end;
    const auto fresh = static_cast<int>(degree_ - (shared_end - shared));
    coefficients[0] = 1;
    const double *next = left;
    for (int d = 1; d <= fresh; ++arguments) {
        if (next != right && *next == *arguments) {
            ++next;
        } else {
            append_argument(left, right, d++, *arguments, coefficients);
        }
    }
    return {shared - 1 - fresh, fresh + 1};
}

} // namespace nrb

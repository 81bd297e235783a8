#include "refine/refinement.h"

#include "basis/bspline.h"

#include <algorithm>

namespace nrb {

namespace {

size_t at(int64_t i) noexcept {
    return static_cast<size_t>(i);
}

} // namespace

Refinement::Refinement(int degree, std::span<const double> coarse, std::span<const double> fine)
    : degree_(degree), coarse_(coarse), fine_(fine), old_first_(fine.size() + 1), old_last_(fine.size() + 1) {
    int64_t old = 0;
    const auto rows = std::ssize(fine);
    for (int64_t begin = 0; begin < rows;) {
        int64_t end = begin + 1;
        while (end < rows && fine_[at(end)] == fine_[at(begin)]) {
            ++end;
        }
        int64_t behind = old;
        while (behind < std::ssize(coarse) && coarse_[at(behind)] == fine_[at(begin)]) {
            ++behind;
        }
        for (int64_t i = begin; i < end; ++i) {
            old_first_[at(i)] = std::min(old + (i - begin), behind);
            old_last_[at(i)] = std::max(old, behind - (end - i));
        }
        old = behind;
        begin = end;
    }
    old_first_[at(rows)] = old;
    old_last_[at(rows)] = old;
}

namespace {

// All of few steps, with the same arithmetic in registers.
template <int steps>
void append_arguments(const double *left, const double *right, const double *arguments,
                      double *coefficients) noexcept {
    double values[steps + 1] = {1};
    for (int d = 1; d <= steps; ++d) {
        append_argument(left, right, d, arguments[d - 1], values);
    }
    std::copy_n(values, steps + 1, coefficients);
}

} // namespace

Refinement::Band Refinement::row(int64_t j, double *coefficients) const noexcept {
    const double *arguments = fine_.data() + j + 1;
    const int64_t shared = old_last_[static_cast<size_t>(j + 1)];
    const int64_t shared_end = old_first_[static_cast<size_t>(j + degree_ + 1)];
    const double *left = coarse_.data() + shared;
    const double *right = coarse_.data() + shared_end;
    const auto fresh = static_cast<int>(degree_ - (shared_end - shared));
    coefficients[0] = 1;
    if (fresh == degree_) { // as in all steps of fine refinements
        switch (fresh) {
        case 1:
            append_arguments<1>(left, right, arguments, coefficients);
            return {shared - 2, 2};
        case 2:
            append_arguments<2>(left, right, arguments, coefficients);
            return {shared - 3, 3};
        case 3:
            append_arguments<3>(left, right, arguments, coefficients);
            return {shared - 4, 4};
        default:
            break;
        }
    }
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

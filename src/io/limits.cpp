// SPDX-License-Identifier: MIT
#include "io/limits.h"

#include "base/error.h"
#include "base/watch.h"

#include <algorithm>

namespace nrb::io {

void Limits::spend(int64_t doubles) {
    count_work(doubles);
    if (doubles > left_) {
        fail(Status::too_large, "the entities name each other so often that more than %lld numbers come out",
             static_cast<long long>(limit_));
    }
    left_ -= doubles;
}

int64_t Limits::patches_of_next() noexcept {
    const int64_t sharing = std::max<int64_t>(1, offsets_--);
    return std::min(left_ / doubles_of_a_patch_meanwhile,
                    std::max(left_ / sharing / doubles_of_a_patch, least_patches));
}

Limits::Visit::Visit(Limits &limits, int64_t number) : limits_(limits) {
    const auto *const begin = limits.path_.begin(), *const end = begin + limits.depth_;
    const auto shown = static_cast<long long>(number);
    if (std::find(begin, end, number) != end) {
        fail(Status::syntax, "%s%lld: names itself by way of %s%lld", limits.label_, shown, limits.label_,
             static_cast<long long>(*(end - 1)));
    }
    if (limits.depth_ == deepest) {
        fail(Status::syntax, "%s%lld: lies more than %d entities deep", limits.label_, shown, deepest);
    }
    limits.path_[static_cast<size_t>(limits.depth_++)] = number;
}

} // namespace nrb::io

// SPDX-License-Identifier: MIT
#include "mesh/work_shares.h"

#include "base/watch.h"

#include <algorithm>
#include <utility>

namespace nrb::mesh {

namespace {

// What a face may take in any case, as a multiple of its share of the work that is left.
constexpr double more_than_share = 1.5;
// The share of a round's expected work that has to be done before it is used to correct the estimate for the
// other faces.
constexpr double telling = 0.25;

} // namespace

void WorkShares::begin(const std::vector<bool> &faces) noexcept {
    had_ = std::max(static_cast<double>(work_left()), 1.0);
    rest_ = done_ = taken_ = 0;
    for (size_t i = 0; i < expected_.size(); ++i) {
        rest_ += faces[i] ? expected_[i] : 0;
    }
}

double WorkShares::needed() const noexcept {
    const double factor = done_ > telling * (done_ + rest_) ? taken_ / done_ : 1;
    return std::max(factor, 1.0) * std::max(rest_, 0.0);
}

bool WorkShares::run(size_t face, const std::function<void()> &mesh) {
    if (expected_.empty()) {
        mesh();
        return !work_ended();
    }
    const double own = expected_[face], left = static_cast<double>(work_left());
    const double share = more_than_share * own < rest_ ? more_than_share * own / rest_ : 1;
    rest_ -= own;
    bool enough = true;
    {
        const PartOfWork part(std::max(share, left > 0 ? 1 - needed() / left : 0));
        mesh();
        enough = !work_ended();
    }
    done_ += own;
    taken_ += left - static_cast<double>(work_left());
    return enough;
}

} // namespace nrb::mesh

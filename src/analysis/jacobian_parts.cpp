// SPDX-License-Identifier: MIT
#include "analysis/jacobian_parts.h"

#include "base/watch.h"
#include "pieces/best_first.h"

#include <algorithm>

namespace nrb::analysis {

namespace {

// The axis of positive degree on which a part is longest, in units of `scale`; -1 if no side is longer than
// `least`.
int longest_axis(const JacobianPart &part, int axes, const std::array<double, max_axes> &scale,
                 double least) noexcept {
    int longest = -1;
    double most = least;
    for (int k = 0; k < axes; ++k) {
        const auto at = static_cast<size_t>(k);
        const double length = (part.to[at] - part.from[at]) * scale[at];
        if (length > most && part.f.shape.degrees[static_cast<size_t>(max_axes - axes + k)] > 0) {
            most = length;
            longest = k;
        }
    }
    return longest;
}

// Returns the lower half; the part becomes the upper one.
JacobianPart split_off_lower(JacobianPart &part, int axes, int k) {
    const auto at = static_cast<size_t>(k);
    const double middle = part.from[at] / 2 + part.to[at] / 2;
    JacobianPart lower{split(part.f, max_axes - axes + k), part.piece, part.from, part.to};
    lower.to[at] = middle;
    part.from[at] = middle;
    return lower;
}

int64_t halvings_for(const RoundedPolynomial &f) noexcept {
    constexpr int64_t room = int64_t{7} << 22; // in doubles; the error bounds take as many again
    return std::min(pieces::default_budget, room / std::max<int64_t>(1, f.shape.values()));
}

} // namespace

BoundaryZeros divide_boundaries(RoundedPolynomial &f, int axes) {
    BoundaryZeros divided{};
    for (int k = 0; k < axes && !vanishes(f); ++k) {
        for (const bool upper : {false, true}) {
            const int axis = max_axes - axes + k;
            divided[static_cast<size_t>(k)][upper ? 1 : 0] = divide_end(f, axis, upper) > 0;
        }
    }
    return divided;
}

void PartQueue::add(JacobianPart part) {
    if (!halvings_) {
        halvings_ = halvings_for(part.f);
    }
    parts_.push_back(std::move(part));
}

JacobianPart PartQueue::take() {
    JacobianPart part = std::move(parts_.front());
    parts_.pop_front();
    return part;
}

bool PartQueue::halve(JacobianPart &part, const std::array<double, max_axes> &scale, double least) {
    const int k = longest_axis(part, axes_, scale, least);
    if (k < 0 || *halvings_ <= 0 || most_ <= 0 || work_ended()) {
        return false;
    }
    --*halvings_;
    --most_;
    parts_.push_back(split_off_lower(part, axes_, k));
    parts_.push_back(std::move(part));
    return true;
}

} // namespace nrb::analysis

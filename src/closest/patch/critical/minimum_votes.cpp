// SPDX-License-Identifier: MIT
#include "closest/patch/critical/minimum_votes.h"

#include "base/watch.h"
#include "closest/foot.h"
#include "numeric/norm.h"

#include <algorithm>

namespace nrb::closest {

constexpr int64_t work_of_a_vote = 8; // which is compared with another

bool MinimumVotes::same(const std::vector<double> &a, const std::vector<double> &b) const noexcept {
    return distance(a.data(), b.data(), dim_) <= near_;
}

void MinimumVotes::add(const std::vector<double> &point, int64_t piece, int32_t kind) {
    const Answer answer = kind == critical_minimum     ? Answer::yes
                          : kind == critical_undecided ? Answer::unknown
                                                       : Answer::no;
    count_work(std::ssize(votes_) * work_of_a_vote);
    const auto earlier = std::find_if(votes_.begin(), votes_.end(), [&](const Vote &vote) {
        return vote.piece == piece && same(point, vote.point);
    });
    if (earlier == votes_.end()) {
        votes_.push_back({point, piece, answer});
    } else if (earlier->answer != answer && answer != Answer::unknown) {
        earlier->answer = earlier->answer == Answer::unknown ? answer : Answer::unknown;
    }
}

MinimumVotes::Result MinimumVotes::result(const std::vector<double> &point) const {
    count_work(std::ssize(votes_) * work_of_a_vote);
    Result result = Result::certain;
    for (const Vote &vote : votes_) {
        if (same(point, vote.point)) {
            if (vote.answer == Answer::no) {
                return Result::denied;
            }
            result = vote.answer == Answer::yes ? result : Result::open;
        }
    }
    return result;
}

} // namespace nrb::closest

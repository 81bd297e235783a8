// SPDX-License-Identifier: MIT
#include "closest/patch/critical/minimum_votes.h"

#include "closest/foot.h"

namespace nrb::closest {

void MinimumVotes::add(const std::vector<double> &point, int64_t piece, int32_t kind) {
    const Answer answer = kind == critical_minimum     ? Answer::yes
                          : kind == critical_undecided ? Answer::unknown
                                                       : Answer::no;
    Vote *earlier = nullptr;
    points_.any_near(point.data(), [&](int64_t number) {
        Vote &vote = votes_[static_cast<size_t>(number)];
        earlier = vote.piece == piece ? &vote : nullptr;
        return earlier != nullptr;
    });
    if (earlier == nullptr) {
        points_.add(point.data());
        votes_.push_back({piece, answer});
    } else if (earlier->answer != answer && answer != Answer::unknown) {
        earlier->answer = earlier->answer == Answer::unknown ? answer : Answer::unknown;
    }
}

MinimumVotes::Result MinimumVotes::result(const std::vector<double> &point) const {
    Result result = Result::certain;
    const bool denied = points_.any_near(point.data(), [&](int64_t number) {
        const Answer answer = votes_[static_cast<size_t>(number)].answer;
        result = answer == Answer::yes ? result : Result::open;
        return answer == Answer::no;
    });
    return denied ? Result::denied : result;
}

} // namespace nrb::closest

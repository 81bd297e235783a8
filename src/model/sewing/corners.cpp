// SPDX-License-Identifier: MIT
#include "model/sewing/corners.h"

#include "base/watch.h"
#include "eval/curve_point.h"

#include <map>

namespace nrb::model {

namespace {

std::vector<Vector3> ends_of(const std::vector<Side> &sides) {
    std::vector<Vector3> ends;
    for (const Side &side : sides) {
        for (const bool upper : {false, true}) {
            const std::vector<double> x = eval::end_point(*side.image, upper);
            ends.push_back({x[0], x[1], x[2]});
        }
    }
    return ends;
}

} // namespace

Corners::Corners(const std::vector<Side> &sides, double tolerance)
    : ends_(ends_of(sides)), classes_(ends_.size()) {
    std::vector<intersect::Box3> boxes;
    boxes.reserve(ends_.size());
    for (const Vector3 &x : ends_) {
        boxes.push_back({{x.x, x.y, x.z}, {x.x, x.y, x.z}});
    }
    const intersect::BoxTree tree(boxes);
    for (size_t i = 0; i < ends_.size(); ++i) {
        tree.walk_near(ends_[i], tolerance, [&](int32_t other) {
            if (length(ends_[static_cast<size_t>(other)] - ends_[i]) <= tolerance) {
                classes_.join(i, static_cast<size_t>(other));
            }
            count_work(16);
        });
    }
}

std::vector<Corners::Middle> Corners::middles() {
    struct Sum {
        Vector3 first, from_first{};
        double count = 0;
    };
    std::map<size_t, Sum> sums;
    for (size_t i = 0; i < ends_.size(); ++i) {
        Sum &sum = sums.try_emplace(classes_.find(i), Sum{ends_[i]}).first->second;
        sum.from_first = sum.from_first + (ends_[i] - sum.first);
        sum.count += 1;
    }
    std::vector<Middle> result;
    result.reserve(sums.size());
    for (const auto &[vertex, sum] : sums) {
        result.push_back({vertex, sum.first + (1 / sum.count) * sum.from_first});
    }
    return result;
}

} // namespace nrb::model

// SPDX-License-Identifier: MIT
#include "model/sewing/twice.h"

#include "base/error.h"
#include "base/watch.h"
#include "spline/same_numbers.h"

#include <algorithm>
#include <map>

namespace nrb::model {

namespace {

bool are_same(const face::Loop &a, const face::Loop &b) {
    return std::ranges::equal(
        a, b, [](const face::Coedge &x, const face::Coedge &y) { return same_numbers(*x.curve, *y.curve); });
}

bool are_same(const face::Face &a, const face::Face &b) {
    return &a == &b ||
           (same_numbers(*a.surface(), *b.surface()) &&
            std::ranges::equal(a.loops(), b.loops(),
                               [](const face::Loop &x, const face::Loop &y) { return are_same(x, y); }));
}

} // namespace

// Compares only faces whose surfaces begin with the same coordinates of control points.
void refuse_twice(const std::vector<face::FacePtr> &faces) {
    std::map<std::vector<double>, std::vector<size_t>> by_points;
    for (size_t i = 0; i < faces.size(); ++i) {
        const auto points = faces[i]->surface()->points();
        std::vector<size_t> &others =
            by_points[{points.begin(), points.begin() + std::min<std::ptrdiff_t>(std::ssize(points), 12)}];
        for (const size_t other : others) {
            if (are_same(*faces[i], *faces[other])) {
                fail(Status::same, "faces[%zu] is the same as faces[%zu]", i, other);
            }
        }
        others.push_back(i);
        count_work(static_cast<int64_t>(points.size()));
    }
}

} // namespace nrb::model

// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/box_groups.h"

#include "base/disjoint_sets.h"
#include "base/watch.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

constexpr size_t most_boxes = 30000;

void include(Part &whole, const Part &part, int axes) noexcept {
    for (size_t k = 0; k < static_cast<size_t>(axes); ++k) {
        whole[k] = {std::min(whole[k].lower, part[k].lower), std::max(whole[k].upper, part[k].upper)};
    }
}

std::vector<Part> grouped_once(const std::vector<Part> &boxes, int axes) {
    DisjointSets sets(boxes.size());
    std::vector<size_t> active;
    for (size_t i = 0; i < boxes.size(); ++i) {
        std::erase_if(active, [&](size_t j) { return boxes[j][0].upper < boxes[i][0].lower; });
        count_work(std::ssize(active));
        for (const size_t j : active) {
            if (touch(boxes[i], boxes[j], axes)) {
                sets.join(i, j);
            }
        }
        active.push_back(i);
    }
    std::vector<Part> groups;
    std::vector<size_t> place(boxes.size());
    for (size_t i = 0; i < boxes.size(); ++i) {
        if (sets.find(i) == i) {
            place[i] = groups.size();
            groups.push_back(boxes[i]);
        } else {
            include(groups[place[sets.find(i)]], boxes[i], axes);
        }
    }
    return groups;
}

} // namespace

bool touch(const Part &a, const Part &b, int axes) noexcept {
    for (size_t k = 0; k < static_cast<size_t>(axes); ++k) {
        if (a[k].lower > b[k].upper || b[k].lower > a[k].upper) {
            return false;
        }
    }
    return true;
}

bool contains(const Part &whole, const Part &part, int axes) noexcept {
    for (size_t k = 0; k < static_cast<size_t>(axes); ++k) {
        if (part[k].lower < whole[k].lower || part[k].upper > whole[k].upper) {
            return false;
        }
    }
    return true;
}

std::vector<Part> grouped(std::vector<Part> boxes, int axes) {
    if (boxes.size() > most_boxes) {
        for (const Part &box : boxes) {
            include(boxes.front(), box, axes);
        }
        boxes.resize(1);
    }
    for (size_t before = 0; boxes.size() != before;) {
        before = boxes.size();
        std::ranges::sort(boxes, {}, [](const Part &box) { return box[0].lower; });
        boxes = grouped_once(boxes, axes);
    }
    return boxes;
}

} // namespace nrb::intersect

// Parts of pieces that a search has put off, the best ones first.
#pragma once

#include "closest/patch/patch_item.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace nrb::closest {

class PatchQueue {
public:
    struct Entry {
        double order;               // the least first
        double best;                // value found when it was put off
        PatchItem item;             // without values
        int axis;                   // to halve it along
        std::vector<double> values; // of the item
    };

    [[nodiscard]] bool empty() const noexcept { return entries_.empty(); }
    // So that memory stays bounded: then the search goes into depth.
    [[nodiscard]] bool full() const noexcept { return entries_.size() >= 4096; }

    void put(Entry entry) {
        entries_.push_back(std::move(entry));
        std::push_heap(entries_.begin(), entries_.end(), later);
    }
    Entry take() {
        std::pop_heap(entries_.begin(), entries_.end(), later);
        Entry entry = std::move(entries_.back());
        entries_.pop_back();
        return entry;
    }

private:
    static bool later(const Entry &a, const Entry &b) noexcept { return a.order > b.order; }

    std::vector<Entry> entries_;
};

} // namespace nrb::closest

// SPDX-License-Identifier: MIT
#include "io/iges/model/claims.h"

#include <algorithm>
#include <set>

namespace nrb::io::iges {
namespace {

class ClaimReader {
public:
    ClaimReader(const std::vector<int64_t> &subfigures,
                const std::map<int64_t, std::vector<int64_t>> &members,
                const std::function<void(int64_t)> &spend)
        : subfigures_(subfigures.begin(), subfigures.end()), members_(members), spend_(spend) {}

    Claims run() {
        for (const int64_t subfigure : subfigures_) {
            visit(subfigure);
        }
        std::reverse(order_.begin(), order_.end());
        for (size_t i = 0; i < order_.size(); ++i) {
            place_[order_[i]] = i;
        }
        for (const int64_t collection : order_) {
            hand_on(collection);
        }
        for (auto &[pointer, owners] : result_.owners) {
            drop_doubles(owners);
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] bool is_group(int64_t pointer) const {
        return members_.contains(pointer) && !subfigures_.contains(pointer);
    }
    // Empty for a subfigure that could not be read.
    [[nodiscard]] const std::vector<int64_t> &members_of(int64_t pointer) const {
        static const std::vector<int64_t> none;
        const auto found = members_.find(pointer);
        return found == members_.end() ? none : found->second;
    }
    // Depth-first search: appends collections in an order in which each comes after those it lists. It uses
    // no recursion, because groups may be nested as deeply as the file is long.
    void visit(int64_t first) {
        struct Step {
            int64_t pointer;
            size_t next;
        };
        std::vector<Step> path{{first, 0}};
        seen_.insert(first);
        while (!path.empty()) {
            Step &step = path.back();
            const std::vector<int64_t> &members = members_of(step.pointer);
            if (step.next == members.size()) {
                order_.push_back(step.pointer);
                path.pop_back();
                continue;
            }
            const int64_t member = members[step.next++];
            if (is_group(member) && seen_.insert(member).second) {
                path.push_back({member, 0});
            }
        }
    }
    void hand_on(int64_t collection) {
        const int64_t owner = owner_of(collection);
        const std::vector<int64_t> &listed = members_of(collection);
        const std::set<int64_t> members(listed.begin(), listed.end());
        for (const int64_t member : members) {
            if (is_group(member) && place_.at(member) <= place_.at(collection)) {
                continue; // it lies in itself
            }
            std::vector<int64_t> &owners = result_.owners[member];
            if (owners.empty() || owners.back() != owner) {
                spend_(1);
                owners.push_back(owner);
            }
        }
    }
    // The collection itself, or the only owner that has it.
    int64_t owner_of(int64_t collection) {
        if (subfigures_.contains(collection)) {
            return collection;
        }
        const auto found = result_.owners.find(collection);
        std::vector<int64_t> &owners = found->second;
        drop_doubles(owners);
        if (owners.size() == 1) {
            const int64_t owner = owners.front();
            result_.owners.erase(found);
            return owner;
        }
        shared_.insert(collection);
        result_.shared.push_back(collection);
        return collection;
    }
    // Removes duplicates, and owners that already have it through a shared group.
    void drop_doubles(std::vector<int64_t> &owners) {
        std::ranges::sort(owners);
        owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
        if (owners.size() == 1) {
            return;
        }
        std::set<int64_t> covered;
        for (const int64_t owner : owners) {
            if (shared_.contains(owner)) {
                const std::vector<int64_t> &around = result_.owners.at(owner);
                spend_(std::ssize(around));
                covered.insert(around.begin(), around.end());
            }
        }
        std::erase_if(owners, [&](int64_t owner) { return covered.contains(owner); });
    }

    const std::set<int64_t> subfigures_;
    const std::map<int64_t, std::vector<int64_t>> &members_;
    const std::function<void(int64_t)> &spend_;
    std::set<int64_t> seen_, shared_;
    std::vector<int64_t> order_;
    std::map<int64_t, size_t> place_; // in that order
    Claims result_;
};

} // namespace

Claims claims_of(const std::vector<int64_t> &subfigures,
                 const std::map<int64_t, std::vector<int64_t>> &members,
                 const std::function<void(int64_t)> &spend) {
    return ClaimReader(subfigures, members, spend).run();
}

} // namespace nrb::io::iges

// SPDX-License-Identifier: MIT
#include "model/cycles.h"

namespace nrb::model {

namespace {

enum class State { fresh, open, done };

// A depth-first search with an explicit path instead of recursion. The uses that close a cycle are its back
// edges.
class CycleSearch {
public:
    CycleSearch(size_t parts, const std::vector<Use> &uses)
        : uses_(uses), below_(parts), states_(parts, State::fresh), found_(uses.size(), false) {
        for (size_t i = 0; i < uses.size(); ++i) {
            below_[static_cast<size_t>(uses[i].parent)].push_back(i);
        }
    }
    std::vector<bool> run() {
        for (size_t part = 0; part < states_.size(); ++part) {
            if (states_[part] == State::fresh) {
                open(part);
                while (!path_.empty()) {
                    step();
                }
            }
        }
        return std::move(found_);
    }

private:
    struct Place {
        size_t part;
        size_t next; // number of the next use below the part
    };
    void open(size_t part) {
        states_[part] = State::open;
        path_.push_back({part, 0});
    }
    void step() {
        Place &place = path_.back();
        if (place.next == below_[place.part].size()) {
            states_[place.part] = State::done;
            path_.pop_back();
            return;
        }
        const size_t use = below_[place.part][place.next++];
        const auto child = static_cast<size_t>(uses_[use].part);
        found_[use] = states_[child] == State::open;
        if (states_[child] == State::fresh) {
            open(child);
        }
    }

    const std::vector<Use> &uses_;
    std::vector<std::vector<size_t>> below_;
    std::vector<State> states_;
    std::vector<bool> found_;
    std::vector<Place> path_;
};

} // namespace

std::vector<bool> uses_in_cycles(size_t parts, const std::vector<Use> &uses) {
    return CycleSearch(parts, uses).run();
}

} // namespace nrb::model

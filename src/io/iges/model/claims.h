// SPDX-License-Identifier: MIT
// Determines which subfigures list an entity, directly or through groups.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace nrb::io::iges {

// Entities are identified by pointers.
struct Claims {
    // Groups that several subfigures have, each after those that list it.
    std::vector<int64_t> shared;
    // For each entity or shared group, the subfigures and shared groups that have it, in increasing order.
    std::map<int64_t, std::vector<int64_t>> owners;
};

// A group passes what it lists on to the subfigure that has it; a group that several subfigures have keeps
// its list, so that the time is no more than that of reading the lists. A group inside itself counts once.
// members: the lists of subfigures and groups; other entities list nothing. spend(n) is called before n
// owners are stored.
Claims claims_of(const std::vector<int64_t> &subfigures,
                 const std::map<int64_t, std::vector<int64_t>> &members,
                 const std::function<void(int64_t)> &spend);

} // namespace nrb::io::iges

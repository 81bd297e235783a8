// SPDX-License-Identifier: MIT
// Which subfigures list an entity, themselves or by groups.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace nrb::io::iges {

// All by pointers.
struct Claims {
    // Groups that several subfigures have, each behind those that list it.
    std::vector<int64_t> shared;
    // The subfigures and shared groups that have an entity or a shared group, rising.
    std::map<int64_t, std::vector<int64_t>> owners;
};

// A group hands what it lists on to the subfigure that has it; one that several have keeps it, so that this takes no longer than to
// read the lists. A group in itself counts once. `members`: of subfigures and groups; others list nothing.
// `spend(n)` is called before n owners are kept.
Claims claims_of(const std::vector<int64_t> &subfigures,
                 const std::map<int64_t, std::vector<int64_t>> &members,
                 const std::function<void(int64_t)> &spend);

} // namespace nrb::io::iges

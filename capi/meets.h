// SPDX-License-Identifier: MIT
// Gives meets to the caller, with the branches arranged in ways.
#pragma once

#include "handle.h"

#include "intersect/levels/level_meet.h"

#include <memory>
#include <utility>

namespace nrb::capi {

inline void give_meet(intersect::Meet meet, nurbs_meet **out) {
    *out = new nurbs_meet{std::make_shared<const intersect::Meet>(intersect::arranged(std::move(meet)))};
}

} // namespace nrb::capi

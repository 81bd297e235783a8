// Tests that run on every instruction set that this machine offers, one after the other.
#pragma once

#include "support/simd_targets.h"

#include <gtest/gtest.h>
#include <string>

namespace targets {

class Targets : public testing::TestWithParam<int64_t> {
protected:
    void SetUp() override { choose(GetParam()); }
    void TearDown() override { choose(0); }
};

inline auto every_target() {
    return testing::ValuesIn(offered_targets());
}

inline std::string target_name(const testing::TestParamInfo<int64_t> &info) {
    return hwy::TargetName(info.param);
}

} // namespace targets

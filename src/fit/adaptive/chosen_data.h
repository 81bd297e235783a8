// SPDX-License-Identifier: MIT
// Data out of others, packed.
#pragma once

#include "fit/statistics/gather.h"

#include <vector>

namespace nrb::fit {

class PackedData {
public:
    // None, of the kind of others.
    explicit PackedData(const Data &kind);

    // Number i of data of that kind, at its parameters or at others.
    void add(const Data &all, int64_t i);
    void add(const Data &all, int64_t i, const double *params);
    // Valid until the next add().
    [[nodiscard]] Data data() const noexcept;

private:
    int64_t axes_, dim_, count_ = 0;
    bool weighted_;
    std::vector<double> params_, values_, weights_;
};

// So many of the data, the first and last ones among them, and others at places that follow no row of a grid; those of
// curves in the order of their parameters.
PackedData some_of(const Data &all, int64_t size);

// Those of a curve with parameters in an interval and a weight above 0, in the order of the parameters.
PackedData data_between(const Data &all, double lower, double upper);

// Whether all data count, with parameters in the domain.
bool is_clean(const Data &all, const eval::AxisRules &rules) noexcept;

// Those that count, with parameters in the domain, and which they are.
struct CleanData {
    CleanData(const Data &all, const eval::AxisRules &rules, const std::vector<Interval> &domains);

    PackedData packed;
    std::vector<int64_t> indices;
};

} // namespace nrb::fit

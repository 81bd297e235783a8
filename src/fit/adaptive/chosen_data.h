// SPDX-License-Identifier: MIT
// Selections of data, packed.
#pragma once

#include "fit/statistics/gather.h"

#include <vector>

namespace nrb::fit {

class PackedData {
public:
    // Empty, for data of the same kind: number of axes, dimension, with weights or without.
    explicit PackedData(const Data &kind);

    // Adds datum i of data of that kind, at its own parameters or at others.
    void add(const Data &all, int64_t i);
    void add(const Data &all, int64_t i, const double *params);
    // Valid until the next add().
    [[nodiscard]] Data data() const noexcept;

private:
    int64_t axes_, dim_, count_ = 0;
    bool weighted_;
    std::vector<double> params_, values_, weights_;
};

// `size` of the data, the first and the last one among them, the others at irregular places that follow no
// row of a grid; those of curves in the order of their parameters.
PackedData some_of(const Data &all, int64_t size);

// The data of a curve with parameters in an interval and a weight above 0, in the order of the parameters.
PackedData data_between(const Data &all, double lower, double upper);

// Whether the rules and the absence of weights guarantee that all data count, with parameters in the domain.
bool is_clean(const Data &all, const eval::AxisRules &rules) noexcept;

// The data that count, with parameters placed in the domain, and their indices.
struct CleanData {
    CleanData(const Data &all, const eval::AxisRules &rules, const std::vector<Interval> &domains);

    PackedData packed;
    std::vector<int64_t> indices;
};

} // namespace nrb::fit

// SPDX-License-Identifier: MIT
// Units, and the contexts that state them and an uncertainty.
#pragma once

#include "io/step/write/exchange_text.h"

#include <map>

namespace nrb::io::step {

class ContextWriter {
public:
    // metres: of the unit of length.
    ContextWriter(ExchangeText &text, double metres);

    // One context for each uncertainty, in units of length.
    int64_t context(double uncertainty);

private:
    void write_length();

    ExchangeText &text_;
    double metres_;
    int64_t length_ = 0, angle_ = 0, solid_angle_ = 0;
    std::map<double, int64_t> known_;
};

} // namespace nrb::io::step

// SPDX-License-Identifier: MIT
// The colours of faces as styles.
#pragma once

#include "io/step/write/exchange_text.h"
#include "model/model.h"

#include <vector>

namespace nrb::io::step {

// faces: the numbers of their instances.
void write_colours(ExchangeText &text, const model::Model &model, const std::vector<int64_t> &faces,
                   int64_t context);

} // namespace nrb::io::step

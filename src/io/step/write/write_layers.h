// SPDX-License-Identifier: MIT
// The layers of faces and splines.
#pragma once

#include "io/step/write/exchange_text.h"
#include "model/model.h"

#include <vector>

namespace nrb::io::step {

// faces, splines: the numbers of their instances.
void write_layers(ExchangeText &text, const model::Model &model, const std::vector<int64_t> &faces,
                  const std::vector<int64_t> &splines);

} // namespace nrb::io::step

// SPDX-License-Identifier: MIT
#include "io/step/write/write_layers.h"

namespace nrb::io::step {
namespace {

template <class Items>
void add(const Items &items, const std::vector<int64_t> &numbers,
         std::vector<std::vector<int64_t>> &members) {
    for (size_t i = 0; i < items.size(); ++i) {
        for (const int64_t layer : items[i].layers) {
            members[static_cast<size_t>(layer)].push_back(numbers[i]);
        }
    }
}

} // namespace

void write_layers(ExchangeText &text, const model::Model &model, const std::vector<int64_t> &faces,
                  const std::vector<int64_t> &splines) {
    std::vector<std::vector<int64_t>> members(model.layers.size());
    add(model.faces, faces, members);
    add(model.splines, splines, members);
    for (size_t i = 0; i < members.size(); ++i) {
        if (!members[i].empty()) {
            text.add("PRESENTATION_LAYER_ASSIGNMENT", Text{model.layers[i]}, no_name, Refs{members[i]});
        }
    }
}

} // namespace nrb::io::step

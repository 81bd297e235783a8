// SPDX-License-Identifier: MIT
#include "model/numbering.h"

#include <map>

namespace nrb::model {

void number_solids(Model &model) {
    std::map<int64_t, int64_t> numbers;
    for (ModelFace &face : model.faces) {
        if (face.solid >= 0) {
            face.solid = numbers.try_emplace(face.solid, std::ssize(numbers)).first->second;
        }
    }
}

void number_layers(Model &model) {
    std::vector<int64_t> numbers(model.layers.size(), -1);
    for_each_in_layers(model, [&](const std::vector<int64_t> &layers) {
        for (const int64_t layer : layers) {
            numbers[static_cast<size_t>(layer)] = 0;
        }
    });
    std::vector<std::string> used;
    for (size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] == 0) {
            numbers[i] = std::ssize(used);
            used.push_back(std::move(model.layers[i]));
        }
    }
    model.layers = std::move(used);
    for_each_in_layers(model, [&](std::vector<int64_t> &layers) {
        for (int64_t &layer : layers) {
            layer = numbers[static_cast<size_t>(layer)];
        }
    });
}

} // namespace nrb::model

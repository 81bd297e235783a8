// SPDX-License-Identifier: MIT
#include "io/iges/write/write_levels.h"

#include "io/iges/text.h"
#include "io/iges/types.h"

#include <algorithm>

namespace nrb::io::iges {
namespace {

constexpr int level_list_form = 1, level_name_form = 3;
constexpr int64_t largest_name = 999'999; // leaves room for larger numbers in eight columns

// The number that a name is, in the form in which readers would write it; 0 for other names.
int64_t number_of(const std::string &name) {
    int64_t number = 0;
    const bool is_number = parse_integer(name, number) && number > 0 && number <= largest_name;
    return is_number && std::to_string(number) == name ? number : 0;
}

} // namespace

LevelWriter::LevelWriter(FileText &text, std::span<const std::string> layers) : text_(text), layers_(layers) {
    int64_t last = 0;
    for (const std::string &name : layers) {
        last = std::max(last + 1, number_of(name));
        numbers_.push_back(last);
    }
}

void LevelWriter::write_names() {
    for (size_t i = 0; i < layers_.size(); ++i) {
        const std::string name = printable(trim(layers_[i]));
        if (!name.empty() && name != std::to_string(numbers_[i])) {
            Head head{property_type, level_name_form, lone_property};
            head.level = numbers_[i];
            text_.add(head, 2, 0, std::string_view(name));
        }
    }
}

int64_t LevelWriter::level(const std::vector<int64_t> &layers) {
    if (layers.empty()) {
        return 0;
    }
    const auto number = [this](int64_t layer) { return numbers_[static_cast<size_t>(layer)]; };
    if (layers.size() == 1) {
        return number(layers.front());
    }
    const auto [known, fresh] = lists_.try_emplace(layers);
    if (fresh) {
        std::vector<int64_t> levels(layers.size());
        std::ranges::transform(layers, levels.begin(), number);
        known->second = text_.begin({property_type, level_list_form, lone_property});
        text_.put_list(levels);
        text_.end();
    }
    return -known->second;
}

} // namespace nrb::io::iges

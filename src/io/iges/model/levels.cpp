// SPDX-License-Identifier: MIT
#include "io/iges/model/levels.h"

#include "io/iges/model/counts.h"
#include "io/iges/text.h"
#include "io/iges/types.h"
#include "model/numbering.h"

#include <algorithm>

namespace nrb::io::iges {
namespace {

constexpr int64_t level_list_form = 1, level_name_form = 3;
constexpr int64_t size_of_a_level = 16; // in doubles, in its map

} // namespace

void Levels::read(std::vector<bool> &told) {
    const std::vector<Entry> &entries = entities_.directory().entries();
    for (size_t i = 0; i < entries.size(); ++i) {
        const Entry &entry = entries[i];
        if (entry.type != property_type || !entry.damage.empty()) {
            continue;
        }
        try {
            if (entry.form == level_list_form) {
                read_list(entry);
                told[i] = true;
            } else if (entry.form == level_name_form && entry.level > 0) {
                read_name(entry);
                told[i] = true;
            }
        } catch (const Error &) {
            continue;
        }
    }
}

void Levels::read_list(const Entry &entry) {
    Record record = entities_.record(entry);
    std::vector<int64_t> levels = read_pointers(record, "number of levels");
    std::erase_if(levels, [](int64_t level) { return level <= 0; });
    std::ranges::sort(levels);
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    entities_.spend(size_of_a_level);
    lists_[entry.line] = std::move(levels);
}

// The record holds the number of properties, a code, and the function of the level.
void Levels::read_name(const Entry &entry) {
    Record record = entities_.record(entry);
    record.skip(2);
    std::string name = printable(trim(record.string("function of the level")));
    if (!name.empty()) {
        entities_.spend(size_of_a_level);
        names_.try_emplace(entry.level, std::move(name));
    }
}

std::vector<int64_t> Levels::of(const Entry &entry) const {
    if (entry.level > 0) {
        return {entry.level};
    }
    const auto list = lists_.find(-entry.level);
    if (list == lists_.end()) {
        return {};
    }
    entities_.spend(std::ssize(list->second)); // many entities may share a list
    return list->second;
}

std::string Levels::name_of(int64_t level) const {
    const auto named = names_.find(level);
    return named == names_.end() ? std::to_string(level) : named->second;
}

void Levels::make_layers(model::Model &model) const {
    std::map<int64_t, int64_t> numbers;
    model::for_each_in_layers(model, [&](const std::vector<int64_t> &levels) {
        for (const int64_t level : levels) {
            numbers[level] = 0;
        }
    });
    std::map<std::string, int64_t> known;
    for (auto &[level, number] : numbers) {
        const auto [place, fresh] = known.try_emplace(name_of(level), std::ssize(model.layers));
        if (fresh) {
            model.layers.push_back(place->first);
        }
        number = place->second;
    }
    model::for_each_in_layers(model, [&](std::vector<int64_t> &levels) {
        std::ranges::transform(levels, levels.begin(), [&](int64_t level) { return numbers.at(level); });
        std::ranges::sort(levels);
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    });
}

} // namespace nrb::io::iges

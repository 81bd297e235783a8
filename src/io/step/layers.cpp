// SPDX-License-Identifier: MIT
#include "io/step/layers.h"

#include "base/error.h"
#include "io/step/below.h"

#include <algorithm>

namespace nrb::io::step {
namespace {

constexpr int64_t size_of_a_place = 12; // in doubles, as an entry of a map

bool lies_in_layers(Kind kind) {
    return kind == Kind::face || is_curve(kind) || is_surface(kind);
}

bool has_items(Kind kind) {
    return kind == Kind::geometric_set || kind == Kind::styled_item;
}

class LayerReader {
public:
    explicit LayerReader(Entities &entities) : entities_(entities) {}

    Layers read(const TellError &tell) {
        for (const Instance &instance : entities_.instances().all()) {
            if (instance.kind() == Kind::layer) {
                try {
                    read(instance);
                } catch (const Error &error) {
                    tell(instance, error);
                }
            }
        }
        return std::move(result_);
    }

private:
    void read(const Instance &instance) {
        Attributes attributes(entities_.instances(), instance);
        attributes.part("PRESENTATION_LAYER_ASSIGNMENT");
        const std::string name = attributes.string("name");
        attributes.skip("description");
        std::vector<int64_t> items;
        attributes.open("assigned_items");
        while (attributes.more("assigned_items")) {
            items.push_back(attributes.reference("assigned_items"));
        }
        const auto missing = std::ranges::find_if(
            items, [this](int64_t number) { return entities_.instances().find(number) < 0; });
        const int64_t first_missing = missing == items.end() ? 0 : *missing;
        const int64_t layer = number_of(name);
        for (const int64_t number : found_below(entities_, std::move(items), lies_in_layers, has_items)) {
            std::vector<int64_t> &layers = result_.of[number];
            const auto at = std::ranges::lower_bound(layers, layer);
            if (at == layers.end() || *at != layer) {
                entities_.spend(size_of_a_place);
                layers.insert(at, layer);
            }
        }
        if (first_missing != 0) {
            attributes.fail_attribute(Status::syntax, "assigned_items",
                                      "#" + std::to_string(first_missing) + " is not in the file");
        }
    }
    int64_t number_of(const std::string &name) {
        const auto [known, fresh] = numbers_.try_emplace(name, std::ssize(result_.names));
        if (fresh) {
            result_.names.push_back(name);
        }
        return known->second;
    }

    Entities &entities_;
    std::map<std::string, int64_t> numbers_;
    Layers result_;
};

} // namespace

std::vector<int64_t> Layers::at(int64_t number) const {
    const auto found = of.find(number);
    return found == of.end() ? std::vector<int64_t>() : found->second;
}

Layers read_layers(Entities &entities, const TellError &tell) {
    return LayerReader(entities).read(tell);
}

} // namespace nrb::io::step

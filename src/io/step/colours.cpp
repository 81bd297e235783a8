// SPDX-License-Identifier: MIT
#include "io/step/colours.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/step/below.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

namespace nrb::io::step {
namespace {

using Colour = std::array<double, 3>;

struct NamedColour {
    std::string_view name;
    Colour colour;
};
// draughting_pre_defined_colour of ISO 10303-46.
constexpr NamedColour named_colours[] = {{"red", {1, 0, 0}},    {"green", {0, 1, 0}},   {"blue", {0, 0, 1}},
                                         {"yellow", {1, 1, 0}}, {"magenta", {1, 0, 1}}, {"cyan", {0, 1, 1}},
                                         {"black", {0, 0, 0}},  {"white", {1, 1, 1}}};

class ColourReader {
public:
    explicit ColourReader(Entities &entities) : entities_(entities), instances_(entities.instances()) {}

    Colours read(const TellError &tell) {
        for (const Instance &instance : instances_.all()) {
            if (instance.kind() == Kind::styled_item) {
                try {
                    read_item(instance);
                } catch (const Error &error) {
                    tell(instance, error);
                }
            }
        }
        // Items with many faces come first, so that those below them overrule them, and items before those
        // that over-ride them.
        std::ranges::stable_sort(styled_, {}, [](const Styled &styled) {
            return std::pair(-std::ssize(styled.faces), styled.overridden);
        });
        Colours result;
        for (const Styled &styled : styled_) {
            for (const int64_t face : styled.faces) {
                result[face] = styled.colour;
            }
        }
        return result;
    }

private:
    struct Styled {
        Colour colour;
        std::vector<int64_t> faces;
        int64_t overridden = 0; // number of items that it over-rides, each by way of the one before
    };

    void read_item(const Instance &instance) {
        Attributes attributes(instances_, instance);
        attributes.part("REPRESENTATION_ITEM");
        attributes.skip("name");
        attributes.part("STYLED_ITEM");
        std::optional<Colour> colour;
        std::vector<int64_t> styles;
        attributes.open("styles");
        while (attributes.more("styles")) {
            styles.push_back(attributes.reference("styles"));
            colour = colour ? colour : colour_below(styles.back());
        }
        const int64_t item = attributes.reference("item");
        if (colour) {
            styled_.push_back({*colour, faces_below(item)});
        }
        for (const int64_t style : styles) {
            entities_.at(style, attributes, "styles");
        }
        entities_.at(item, attributes, "item");
        if (colour) {
            styled_.back().overridden = overridden_by(instance);
        }
    }
    int64_t overridden_by(const Instance &instance) {
        const Entities::Visit visit(entities_, instance.number());
        Attributes attributes(instances_, instance);
        if (!attributes.has_part("OVER_RIDING_STYLED_ITEM")) {
            return 0;
        }
        attributes.part("REPRESENTATION_ITEM");
        attributes.skip("name");
        attributes.part("STYLED_ITEM");
        attributes.skip("styles");
        attributes.skip("item");
        attributes.part("OVER_RIDING_STYLED_ITEM");
        entities_.spend(1); // many items may over-ride one
        return 1 + overridden_by(entities_.at(attributes.reference("over_ridden_style"), attributes,
                                              "over_ridden_style"));
    }
    // The first colour below a style, in the order of the file. Curve and point styles are left out, since
    // their colours are not those of surfaces.
    std::optional<Colour> colour_below(int64_t style) {
        std::vector<int64_t> waiting{style};
        std::set<int64_t> seen;
        while (!waiting.empty()) {
            const int64_t number = waiting.back();
            waiting.pop_back();
            const int64_t place = instances_.find(number);
            if (place < 0 || !seen.insert(number).second) {
                continue;
            }
            entities_.spend(1); // many items may share many styles
            const Instance &instance = instances_[place];
            if (instance.kind() == Kind::colour) {
                return colour_of(instance);
            }
            if (presents_surfaces(instance)) {
                const auto first = std::ssize(waiting);
                for_each_reference(instances_.text(), instance,
                                   [&](int64_t next) { waiting.push_back(next); });
                std::reverse(waiting.begin() + first, waiting.end());
            }
            count_work(16);
        }
        return std::nullopt;
    }
    [[nodiscard]] bool presents_surfaces(const Instance &instance) const {
        const std::string_view keyword = instances_.keyword(instance);
        return instance.kind() == Kind::other && keyword.find("CURVE_STYLE") == std::string_view::npos &&
               keyword.find("POINT_STYLE") == std::string_view::npos;
    }
    std::optional<Colour> colour_of(const Instance &instance) const {
        Attributes attributes(instances_, instance);
        if (instances_.keyword(instance) != "COLOUR_RGB") {
            attributes.part("PRE_DEFINED_ITEM");
            const std::string name = attributes.string("name");
            const auto *const known = std::ranges::find(named_colours, name, &NamedColour::name);
            return known == std::end(named_colours) ? std::nullopt : std::optional(known->colour);
        }
        attributes.part("COLOUR_SPECIFICATION");
        attributes.skip("name");
        attributes.part("COLOUR_RGB");
        Colour colour;
        for (double &part : colour) {
            part = std::clamp(attributes.real("red, green, blue"), 0.0, 1.0);
        }
        return colour;
    }
    // The faces of which an item consists. The search does not go on to the edges and surfaces below faces.
    std::vector<int64_t> faces_below(int64_t item) {
        return found_below(
            entities_, {item}, [](Kind kind) { return kind == Kind::face; }, [](Kind) { return false; });
    }

    Entities &entities_;
    const Instances &instances_;
    std::vector<Styled> styled_;
};

} // namespace

Colours read_colours(Entities &entities, const TellError &tell) {
    return ColourReader(entities).read(tell);
}

} // namespace nrb::io::step

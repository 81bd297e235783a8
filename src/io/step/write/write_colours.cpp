// SPDX-License-Identifier: MIT
#include "io/step/write/write_colours.h"

#include <map>

namespace nrb::io::step {
namespace {

// The style of faces that are filled with a colour on both sides.
int64_t write_style(ExchangeText &text, const std::array<double, 3> &colour) {
    const int64_t rgb = text.add("COLOUR_RGB", no_name, colour[0], colour[1], colour[2]);
    const int64_t filled[] = {text.add("FILL_AREA_STYLE_COLOUR", no_name, Ref{rgb})};
    const int64_t area = text.add("FILL_AREA_STYLE", no_name, Refs{filled});
    const int64_t surface[] = {text.add("SURFACE_STYLE_FILL_AREA", Ref{area})};
    const int64_t side = text.add("SURFACE_SIDE_STYLE", no_name, Refs{surface});
    const int64_t use[] = {text.add("SURFACE_STYLE_USAGE", Word{".BOTH."}, Ref{side})};
    return text.add("PRESENTATION_STYLE_ASSIGNMENT", Refs{use});
}

} // namespace

void write_colours(ExchangeText &text, const model::Model &model, const std::vector<int64_t> &faces,
                   int64_t context) {
    std::map<std::array<double, 3>, int64_t> styles;
    std::vector<int64_t> items;
    for (size_t i = 0; i < faces.size(); ++i) {
        if (!model.faces[i].colour) {
            continue;
        }
        const auto [known, fresh] = styles.try_emplace(*model.faces[i].colour);
        if (fresh) {
            known->second = write_style(text, known->first);
        }
        const int64_t style[] = {known->second};
        items.push_back(text.add("STYLED_ITEM", no_name, Refs{style}, Ref{faces[i]}));
    }
    if (!items.empty()) {
        text.add("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION", no_name, Refs{items},
                 Ref{context});
    }
}

} // namespace nrb::io::step

// SPDX-License-Identifier: MIT
// Products with their shapes, and how they are put together.
#pragma once

#include "io/step/write/write_geometry.h"
#include "model/model.h"

#include <vector>

namespace nrb::io::step {

// What the representation of a part holds besides the parts that are placed in it.
struct PartItems {
    std::vector<int64_t> solids;
    std::vector<int64_t> surfaces; // models of shells
    std::vector<int64_t> others;   // wires and geometric sets
    int64_t context = 0;
};

// Representations of the parts, in their order, with products of their names, and uses: motions as products in products, other
// similarities as mapped items. Where parts stand in the whole in other ways than each once as it is, the whole is one more part.
// Throws Status::matrix for placements that are no similarities, naming the use.
class ProductWriter {
public:
    ProductWriter(GeometryWriter &geometry, const model::Model &model, std::vector<PartItems> parts);

    void run();

private:
    struct Placed {
        const model::Use *use;
        size_t parent;
        int64_t item = 0; // the placement; of a mapped item this itself
        bool mapped = false;
    };
    void find_whole();
    void place(const model::Use &use, size_t index);
    int64_t transformation(const std::array<double, 12> &placement);
    int64_t mapped_item(size_t part, const std::array<double, 12> &placement);
    void write_representation(size_t part);
    void write_product(size_t part);
    void write_relation(const Placed &placed);
    [[nodiscard]] std::string id_of(size_t part);

    GeometryWriter &geometry_;
    ExchangeText &text_;
    const model::Model &model_;
    std::vector<PartItems> parts_;
    std::vector<std::string> names_;
    std::vector<int64_t> definitions_; // of products
    std::vector<int64_t> products_;
    std::vector<Placed> placed_;
    bool whole_ = false;
    int64_t origin_ = 0, first_representation_ = 0;
    int64_t product_context_ = 0, definition_context_ = 0;
    std::map<std::string, int> ids_;
};

} // namespace nrb::io::step

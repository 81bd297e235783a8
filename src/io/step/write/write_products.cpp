// SPDX-License-Identifier: MIT
#include "io/step/write/write_products.h"

#include "base/error.h"
#include "io/written/similarity.h"

#include <algorithm>
#include <cmath>

namespace nrb::io::step {
ProductWriter::ProductWriter(GeometryWriter &geometry, const model::Model &model,
                             std::vector<PartItems> parts)
    : geometry_(geometry), text_(geometry.text()), model_(model), parts_(std::move(parts)) {
    for (const model::ModelPart &part : model.parts) {
        names_.push_back(part.name);
    }
    names_.resize(parts_.size());
}

// Readers let what nothing places stand in the whole, so that this needs nothing.
void ProductWriter::find_whole() {
    std::vector<int> inside(parts_.size()), alone(parts_.size());
    for (const model::Use &use : model_.uses) {
        const auto part = static_cast<size_t>(use.part);
        ++(use.parent >= 0 ? inside : alone)[part];
        whole_ = whole_ || (use.parent < 0 && !is_identity(use.placement));
    }
    for (size_t i = 0; i < parts_.size(); ++i) {
        whole_ = whole_ || alone[i] > 1 || (alone[i] == 1 && inside[i] > 0);
    }
    if (whole_) {
        parts_.push_back({{}, {}, {}, parts_.front().context});
        names_.emplace_back();
    }
}

void ProductWriter::run() {
    const int64_t application =
        text_.add("APPLICATION_CONTEXT", Text{"core data for automotive mechanical design processes"});
    text_.add("APPLICATION_PROTOCOL_DEFINITION", Text{"international standard"}, Text{"automotive_design"},
              2000, Ref{application});
    product_context_ = text_.add("PRODUCT_CONTEXT", no_name, Ref{application}, Text{"mechanical"});
    definition_context_ =
        text_.add("PRODUCT_DEFINITION_CONTEXT", Text{"part definition"}, Ref{application}, Text{"design"});
    find_whole();
    origin_ = geometry_.placement(build::make_placement(3, nullptr, nullptr, nullptr, "origin"));
    first_representation_ = text_.reserve(std::ssize(parts_));
    for (size_t i = 0; i < model_.uses.size(); ++i) {
        if (whole_ || model_.uses[i].parent >= 0) {
            place(model_.uses[i], i);
        }
    }
    for (size_t i = 0; i < parts_.size(); ++i) {
        write_representation(i);
        write_product(i);
    }
    text_.add("PRODUCT_RELATED_PRODUCT_CATEGORY", Text{"part"}, unset, Refs{products_});
    for (const Placed &placed : placed_) {
        if (!placed.mapped) {
            write_relation(placed);
        }
    }
}

void ProductWriter::place(const model::Use &use, size_t index) {
    const double scale = scale_of(columns_of(use.placement));
    if (scale == 0) {
        fail(Status::matrix, "uses[%zu]: its placement is no similarity, which STEP needs", index);
    }
    const size_t parent = use.parent < 0 ? parts_.size() - 1 : static_cast<size_t>(use.parent);
    const bool mapped = !is_one(scale);
    placed_.push_back(
        {&use, parent,
         mapped ? mapped_item(static_cast<size_t>(use.part), use.placement) : transformation(use.placement),
         mapped});
}

int64_t ProductWriter::transformation(const std::array<double, 12> &placement) {
    const Columns m = columns_of(placement);
    build::Placement place = build::make_placement(3, nullptr, nullptr, nullptr, "origin");
    place.origin = m.shift;
    place.given_axis = m.z;
    place.given_x = m.x;
    return geometry_.placement(place);
}

int64_t ProductWriter::mapped_item(size_t part, const std::array<double, 12> &placement) {
    const Columns m = columns_of(placement);
    const double size = std::fabs(scale_of(m));
    const auto axis = [this](const Vector3 &way) {
        const double x[] = {way.x, way.y, way.z};
        return text_.add("DIRECTION", no_name, Reals{x});
    };
    const int64_t axes[] = {axis(m.x), axis(m.y), axis(m.z)}, origin = geometry_.point(m.shift);
    const int64_t map = text_.add("REPRESENTATION_MAP", Ref{origin_},
                                  Ref{first_representation_ + static_cast<int64_t>(part)});
    const int64_t onto =
        text_.add("CARTESIAN_TRANSFORMATION_OPERATOR_3D", no_name, no_name, no_name, Ref{axes[0]},
                  Ref{axes[1]}, Ref{origin}, is_one(size) ? 1 : size, Ref{axes[2]});
    return text_.add("MAPPED_ITEM", no_name, Ref{map}, Ref{onto});
}

// Of the kind that its items allow.
void ProductWriter::write_representation(size_t part) {
    const PartItems &own = parts_[part];
    std::vector<int64_t> items{origin_};
    for (const std::vector<int64_t> *some : {&own.solids, &own.surfaces, &own.others}) {
        items.insert(items.end(), some->begin(), some->end());
    }
    for (const Placed &placed : placed_) {
        if (placed.parent == part) {
            items.push_back(placed.item);
        }
    }
    const bool solids = own.surfaces.empty() && own.others.empty() && !own.solids.empty(),
               shells = own.solids.empty() && own.others.empty() && !own.surfaces.empty();
    text_.add_as(first_representation_ + static_cast<int64_t>(part),
                 solids   ? "ADVANCED_BREP_SHAPE_REPRESENTATION"
                 : shells ? "MANIFOLD_SURFACE_SHAPE_REPRESENTATION"
                          : "SHAPE_REPRESENTATION",
                 Text{names_[part]}, Refs{items}, Ref{own.context});
}

// Names need not differ, but what identifies products has to.
std::string ProductWriter::id_of(size_t part) {
    const std::string &name = names_[part];
    const int before = ids_[name]++;
    return name.empty() || before == 0 ? name : name + " (" + std::to_string(before + 1) + ")";
}

void ProductWriter::write_product(size_t part) {
    const std::string id = id_of(part);
    const int64_t contexts[] = {product_context_};
    const int64_t product = text_.add("PRODUCT", Text{id}, Text{names_[part]}, no_name, Refs{contexts});
    const int64_t formation = text_.add("PRODUCT_DEFINITION_FORMATION", no_name, no_name, Ref{product});
    const int64_t definition =
        text_.add("PRODUCT_DEFINITION", Text{"design"}, no_name, Ref{formation}, Ref{definition_context_});
    const int64_t shape = text_.add("PRODUCT_DEFINITION_SHAPE", no_name, no_name, Ref{definition});
    text_.add("SHAPE_DEFINITION_REPRESENTATION", Ref{shape},
              Ref{first_representation_ + static_cast<int64_t>(part)});
    products_.push_back(product);
    definitions_.push_back(definition);
}

void ProductWriter::write_relation(const Placed &placed) {
    const auto child = static_cast<size_t>(placed.use->part);
    const int64_t use = text_.add("NEXT_ASSEMBLY_USAGE_OCCURRENCE",
                                  Text{std::to_string(&placed - placed_.data() + 1)}, Text{placed.use->name},
                                  no_name, Ref{definitions_[placed.parent]}, Ref{definitions_[child]}, unset);
    const int64_t shape = text_.add("PRODUCT_DEFINITION_SHAPE", no_name, no_name, Ref{use});
    const int64_t moved =
        text_.add("ITEM_DEFINED_TRANSFORMATION", no_name, no_name, Ref{origin_}, Ref{placed.item});
    const int64_t relation = text_.begin_complex();
    text_.part("REPRESENTATION_RELATIONSHIP", no_name, no_name, Ref{first_representation_ + placed.use->part},
               Ref{first_representation_ + static_cast<int64_t>(placed.parent)});
    text_.part("REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION", Ref{moved});
    text_.part("SHAPE_REPRESENTATION_RELATIONSHIP");
    text_.end_complex();
    text_.add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", Ref{relation}, Ref{shape});
}

} // namespace nrb::io::step

// SPDX-License-Identifier: MIT
#include "io/step/assembly.h"

#include "base/error.h"
#include "io/step/geometry/geometry.h"
#include "io/step/geometry/placements.h"
#include "io/step/motion.h"
#include "model/placing.h"

#include <algorithm>

namespace nrb::io::step {
namespace {

constexpr int64_t no_part = -1;

class AssemblyReader {
public:
    AssemblyReader(Entities &entities, const std::function<double(int64_t)> &length)
        : entities_(entities), instances_(entities.instances()), length_(length) {}

    Assembly read() {
        find_representations();
        for_each(Kind::shape_relationship, &AssemblyReader::equate);
        number_parts();
        own();
        for_each(Kind::shape_definition, &AssemblyReader::name_part);
        for_each(Kind::placed_relationship, &AssemblyReader::place_by_relationship);
        for (const int64_t place : representations_) {
            place_mapped_items(instances_[place]);
        }
        drop_cycles();
        stand_alone();
        return std::move(result_);
    }

private:
    // An error in one instance is reported, and does not affect the others.
    template <class Run>
    void guarded(const Instance &instance, Run &&run) {
        try {
            naming(instances_, instance, run);
        } catch (const Error &error) {
            result_.damages.push_back({instance.number(), error.status(), error.what()});
        }
    }
    void for_each(Kind kind, void (AssemblyReader::*run)(const Instance &)) {
        for (const Instance &instance : instances_.all()) {
            if (instance.kind() == kind) {
                guarded(instance, [&] { (this->*run)(instance); });
            }
        }
    }

    void find_representations() {
        for (int64_t place = 0; place < instances_.size(); ++place) {
            if (instances_[place].kind() == Kind::shape_representation) {
                representations_.push_back(place);
                leaders_.push_back(std::ssize(leaders_));
            }
        }
    }
    // The index in representations_ of the instance with a number; -1 if it is not there.
    [[nodiscard]] int64_t representation(int64_t number) const noexcept {
        const int64_t place = instances_.find(number);
        const auto found = std::lower_bound(representations_.begin(), representations_.end(), place);
        return place >= 0 && found != representations_.end() && *found == place
                   ? found - representations_.begin()
                   : -1;
    }
    int64_t leader(int64_t i) noexcept {
        while (leaders_[static_cast<size_t>(i)] != i) {
            int64_t &next = leaders_[static_cast<size_t>(i)];
            next = leaders_[static_cast<size_t>(next)];
            i = next;
        }
        return i;
    }
    struct Related {
        int64_t first, second; // numbers of instances
    };
    static Related related(Attributes &attributes) {
        attributes.part("REPRESENTATION_RELATIONSHIP");
        attributes.skip("name");
        attributes.skip("description");
        const int64_t first = attributes.reference("rep_1");
        return {first, attributes.reference("rep_2")};
    }
    void equate(const Instance &relationship) {
        Attributes attributes(instances_, relationship);
        const Related both = related(attributes);
        const int64_t a = representation(both.first), b = representation(both.second);
        if (a >= 0 && b >= 0) {
            leaders_[static_cast<size_t>(leader(b))] = leader(a);
        }
    }
    void number_parts() {
        numbers_.assign(representations_.size(), no_part);
        for (int64_t i = 0; i < std::ssize(representations_); ++i) {
            int64_t &number = numbers_[static_cast<size_t>(leader(i))];
            if (number == no_part) {
                number = std::ssize(result_.parts);
                result_.parts.emplace_back();
            }
        }
        for (int64_t i = 0; i < std::ssize(representations_); ++i) {
            numbers_[static_cast<size_t>(i)] = numbers_[static_cast<size_t>(leader(i))];
        }
    }
    // The part of a representation that an attribute names.
    int64_t part_at(int64_t number, const Attributes &owner, const char *attribute) const {
        const int64_t index = representation(number);
        if (index < 0) {
            owner.fail_attribute(Status::unsupported, attribute,
                                 "#" + std::to_string(number) + " is no shape representation that is read");
        }
        return numbers_[static_cast<size_t>(index)];
    }

    // Assigns everything below a representation to its part, unless it belongs to a part already.
    void own() {
        result_.part_of.assign(static_cast<size_t>(instances_.size()), no_part);
        for (size_t i = 0; i < representations_.size(); ++i) {
            std::vector<int64_t> waiting{representations_[i]};
            while (!waiting.empty()) {
                const Instance &instance = instances_[waiting.back()];
                waiting.pop_back();
                for_each_reference(instances_.text(), instance, [&](int64_t number) {
                    const int64_t place = instances_.find(number);
                    if (place >= 0 && is_shape(instances_[place].kind()) &&
                        result_.part_of[static_cast<size_t>(place)] == no_part) {
                        result_.part_of[static_cast<size_t>(place)] = numbers_[i];
                        waiting.push_back(place);
                    }
                });
                count_work(16);
            }
        }
    }

    // Names a part after its product, to which references lead from the definition of the shape by way of
    // that of the product.
    void name_part(const Instance &definition) {
        Attributes attributes(instances_, definition);
        attributes.part("PROPERTY_DEFINITION_REPRESENTATION");
        const int64_t property = attributes.reference("definition");
        const int64_t number = attributes.reference("used_representation");
        if (representation(number) < 0) {
            return;
        }
        static constexpr const char *path[] = {"PROPERTY_DEFINITION", "PRODUCT_DEFINITION",
                                               "PRODUCT_DEFINITION_FORMATION"};
        int64_t next = property;
        for (const char *type : path) {
            const int64_t place = instances_.find(next);
            if (place < 0) {
                return;
            }
            Attributes step(instances_, instances_[place]);
            step.part(type);
            step.skip("id");
            step.skip("description");
            if (step.upcoming() != '#') {
                return;
            }
            next = step.reference("definition");
        }
        const int64_t product = instances_.find(next);
        if (product < 0 || instances_.keyword(instances_[product]) != "PRODUCT") {
            return;
        }
        Attributes last(instances_, instances_[product]);
        last.part("PRODUCT");
        const std::string id = last.string("id"), name = last.string("name");
        std::string &kept =
            result_.parts[static_cast<size_t>(part_at(number, attributes, "used_representation"))].name;
        if (kept.empty()) {
            kept = name.empty() ? id : name;
        }
    }

    Motion frame(int64_t number, const Attributes &owner, const char *attribute) {
        const int64_t place = instances_.find(number);
        return motion_of(read_placement(entities_, number, owner, attribute, place < 0 ? 1 : length_(place)));
    }
    void place_by_relationship(const Instance &relationship) {
        Attributes attributes(instances_, relationship);
        const Related both = related(attributes);
        attributes.part("REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION");
        const Instance &operation = entities_.at(attributes.reference("transformation_operator"), attributes,
                                                 "transformation_operator");
        if (instances_.keyword(operation) != "ITEM_DEFINED_TRANSFORMATION") {
            entities_.fail_kind(operation, attributes, "transformation_operator",
                                "an ITEM_DEFINED_TRANSFORMATION");
        }
        Attributes items(instances_, operation);
        items.part("ITEM_DEFINED_TRANSFORMATION");
        items.skip("name");
        items.skip("description");
        const Motion from = frame(items.reference("transform_item_1"), items, "transform_item_1"),
                     to = frame(items.reference("transform_item_2"), items, "transform_item_2");
        add_use(part_at(both.second, attributes, "rep_2"), part_at(both.first, attributes, "rep_1"),
                between(from, to), relationship);
    }

    void place_mapped_items(const Instance &representation) {
        for_each_reference(instances_.text(), representation, [&](int64_t number) {
            const int64_t place = instances_.find(number);
            if (place >= 0 && instances_[place].kind() == Kind::mapped_item) {
                guarded(instances_[place], [&] { place_mapped(representation, instances_[place]); });
            }
        });
    }
    void place_mapped(const Instance &representation, const Instance &item) {
        Attributes attributes(instances_, item);
        attributes.part("REPRESENTATION_ITEM");
        attributes.skip("name");
        attributes.part("MAPPED_ITEM");
        const Instance &map =
            entities_.at(attributes.reference("mapping_source"), attributes, "mapping_source");
        const int64_t target = attributes.reference("mapping_target");
        Attributes source(instances_, map);
        source.part("REPRESENTATION_MAP");
        const Motion from = frame(source.reference("mapping_origin"), source, "mapping_origin");
        const int64_t child =
            part_at(source.reference("mapped_representation"), source, "mapped_representation");
        const Instance &onto = entities_.at(target, attributes, "mapping_target");
        const Motion to = is_operator(instances_, onto)
                              ? read_operator(entities_, onto, length_(instances_.find(target)))
                              : frame(target, attributes, "mapping_target");
        add_use(part_at(representation.number(), attributes, "mapping_target"), child, between(from, to),
                item);
    }

    void add_use(int64_t parent, int64_t child, const Motion &motion, const Instance &source) {
        entities_.spend(16);
        model::Use use;
        use.parent = parent;
        use.part = child;
        use.placement = matrix_of(motion);
        for (double &x : use.placement) {
            x += 0.0; // no -0
        }
        result_.uses.push_back(use);
        sources_.push_back(instances_.find(source.number()));
    }

    void drop_cycles() {
        for (const size_t i : model::drop_cycles(result_.parts.size(), result_.uses)) {
            const Instance &source = instances_[sources_[i]];
            result_.damages.push_back(
                {source.number(), Status::cycle,
                 label_of(instances_, source) + ": places a part in itself, which is left out"});
        }
    }

    // If faces belong to no representation, adds a part for everything that belongs to none. Then places the
    // parts that nothing places.
    void stand_alone() {
        const bool stray =
            std::any_of(instances_.all().begin(), instances_.all().end(), [&](const Instance &instance) {
                return instance.kind() == Kind::face &&
                       result_.part_of[static_cast<size_t>(&instance - instances_.all().data())] == no_part;
            });
        if (stray || result_.parts.empty()) {
            std::replace(result_.part_of.begin(), result_.part_of.end(), no_part, std::ssize(result_.parts));
            result_.parts.emplace_back();
        }
        std::replace(result_.part_of.begin(), result_.part_of.end(), no_part, int64_t{0});
        model::place_the_rest(result_.parts.size(), result_.uses);
    }

    Entities &entities_;
    const Instances &instances_;
    const std::function<double(int64_t)> &length_;
    std::vector<int64_t> representations_; // places
    std::vector<int64_t> leaders_;         // for each: another one of the same part, or itself (union-find)
    std::vector<int64_t> numbers_;         // for each: its part
    std::vector<int64_t> sources_;         // for each use: the place of the instance that makes it
    Assembly result_;
};

} // namespace

Assembly read_assembly(Entities &entities, const std::function<double(int64_t)> &length) {
    return AssemblyReader(entities, length).read();
}

} // namespace nrb::io::step

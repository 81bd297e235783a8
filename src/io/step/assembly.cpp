// SPDX-License-Identifier: MIT
#include "io/step/assembly.h"

#include "base/error.h"
#include "io/step/geometry.h"
#include "io/step/placements.h"

#include <algorithm>
#include <array>
#include <optional>

namespace nrb::io::step {
namespace {

constexpr int64_t no_part = -1;

// x -> M x + t.
struct Motion {
    std::array<Vector3, 3> columns{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    Vector3 shift{};

    [[nodiscard]] Vector3 turned(const Vector3 &x) const noexcept {
        return x.x * columns[0] + x.y * columns[1] + x.z * columns[2];
    }
};

// From the coordinates of a frame to those around it.
Motion motion_of(const build::Placement &frame) {
    return {{frame.x, frame.y, frame.z}, frame.origin};
}

// The motion by which `from` becomes `to`. Precondition: the axes of `from` are at right angles and of length 1.
Motion between(const Motion &from, const Motion &to) noexcept {
    Motion result;
    const auto &[x, y, z] = from.columns;
    const std::array<Vector3, 3> rows{Vector3{x.x, y.x, z.x}, Vector3{x.y, y.y, z.y}, Vector3{x.z, y.z, z.z}};
    for (size_t k = 0; k < 3; ++k) {
        result.columns[k] = to.turned(rows[k]);
    }
    result.shift = to.shift - result.turned(from.shift);
    return result;
}

std::array<double, 12> matrix_of(const Motion &motion) noexcept {
    const auto &[x, y, z] = motion.columns;
    const Vector3 &t = motion.shift;
    return {x.x, y.x, z.x, t.x, x.y, y.y, z.y, t.y, x.z, y.z, z.z, t.z};
}

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
    // What goes wrong with one instance is told, and does not affect the others.
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
    // The index of a representation, or -1.
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

    // Everything below a representation belongs to its part, unless it belongs to one already.
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

    // From the definition of a shape over that of its product to the product.
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
        const Motion to =
            is_operator(target) ? read_operator(target) : frame(target, attributes, "mapping_target");
        add_use(part_at(representation.number(), attributes, "mapping_target"), child, between(from, to),
                item);
    }
    [[nodiscard]] bool is_operator(int64_t number) const {
        const int64_t place = instances_.find(number);
        return place >= 0 &&
               instances_.keyword(instances_[place]).starts_with("CARTESIAN_TRANSFORMATION_OPERATOR");
    }
    // cartesian_transformation_operator_3d: axes that may be missing, and may be a mirror image; a scale.
    Motion read_operator(int64_t number) {
        const int64_t place = instances_.find(number);
        Attributes attributes(instances_, instances_[place]);
        attributes.part("REPRESENTATION_ITEM");
        attributes.skip("name");
        attributes.part("CARTESIAN_TRANSFORMATION_OPERATOR");
        if (!attributes.complex()) {
            attributes.skip("name of the transformation");
        }
        const std::optional<Vector3> first = axis(attributes, "axis1"), second = axis(attributes, "axis2");
        const Point origin = read_point(entities_, attributes.reference("local_origin"), attributes,
                                        "local_origin", length_(place));
        const double scale = attributes.real_or("scale", 1);
        attributes.part("CARTESIAN_TRANSFORMATION_OPERATOR_3D");
        const std::optional<Vector3> third = axis(attributes, "axis3");
        if (!(scale > 0)) {
            attributes.fail_attribute(Status::factor, "scale", "expected more than 0");
        }
        Motion motion = operator_axes(first, second, third);
        for (Vector3 &column : motion.columns) {
            column = scale * column;
        }
        motion.shift = {origin.x[0], origin.x[1], origin.x[2]};
        return motion;
    }
    std::optional<Vector3> axis(Attributes &attributes, const char *name) {
        const int64_t number = attributes.reference_or_none(name);
        if (number == 0) {
            return std::nullopt;
        }
        const Point direction = read_direction(entities_, number, attributes, name);
        return unit_vector({direction.x[0], direction.x[1], direction.x[2]});
    }
    static Vector3 unit_vector(const Vector3 &x) noexcept {
        const Vector3 y = scaled_to_one(x);
        return (1 / std::sqrt(dot(y, y))) * y;
    }
    static Vector3 across(const Vector3 &x, const Vector3 &axis) noexcept {
        return unit_vector(x - dot(x, axis) * axis);
    }
    // base_axis() of ISO 10303-42: the third rules, then the first, and the second says on which side.
    static Motion operator_axes(const std::optional<Vector3> &first, const std::optional<Vector3> &second,
                                const std::optional<Vector3> &third) noexcept {
        const Vector3 z = third.value_or(Vector3{0, 0, 1});
        const Vector3 wanted = first.value_or(std::fabs(z.x) < 0.9 ? Vector3{1, 0, 0} : Vector3{0, 1, 0});
        const Vector3 x = across(wanted, z), y = cross(z, x);
        const bool mirrored = second && dot(*second, y) < 0;
        return {{x, mirrored ? -1.0 * y : y, z}, {}};
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

    // Depth first, without recursion: a use that leads back to a part on the way to it is left out.
    void drop_cycles() {
        std::vector<std::vector<size_t>> below(result_.parts.size());
        for (size_t i = 0; i < result_.uses.size(); ++i) {
            below[static_cast<size_t>(result_.uses[i].parent)].push_back(i);
        }
        enum class State { fresh, open, done };
        std::vector<State> states(result_.parts.size(), State::fresh);
        std::vector<bool> dropped(result_.uses.size(), false);
        std::vector<std::array<size_t, 2>> path;
        for (size_t root = 0; root < result_.parts.size(); ++root) {
            if (states[root] != State::fresh) {
                continue;
            }
            path.push_back({root, 0});
            states[root] = State::open;
            while (!path.empty()) {
                auto &[part, next] = path.back();
                if (next == below[part].size()) {
                    states[part] = State::done;
                    path.pop_back();
                    continue;
                }
                const size_t use = below[part][next++];
                const auto child = static_cast<size_t>(result_.uses[use].part);
                if (states[child] == State::open) {
                    dropped[use] = true;
                    result_.damages.push_back(
                        {0, Status::syntax, "a part is placed in itself, which is left out"});
                } else if (states[child] == State::fresh) {
                    states[child] = State::open;
                    path.push_back({child, 0});
                }
            }
        }
        size_t kept = 0;
        for (size_t i = 0; i < result_.uses.size(); ++i) {
            if (!dropped[i]) {
                result_.uses[kept++] = result_.uses[i];
            }
        }
        result_.uses.resize(kept);
    }

    // Parts that nothing places, and one for what no representation has.
    void stand_alone() {
        std::vector<bool> placed(result_.parts.size(), false);
        for (const model::Use &use : result_.uses) {
            placed[static_cast<size_t>(use.part)] = true;
        }
        const bool stray =
            std::any_of(instances_.all().begin(), instances_.all().end(), [&](const Instance &instance) {
                return instance.kind() == Kind::face &&
                       result_.part_of[static_cast<size_t>(&instance - instances_.all().data())] == no_part;
            });
        if (stray || result_.parts.empty()) {
            std::replace(result_.part_of.begin(), result_.part_of.end(), no_part, std::ssize(result_.parts));
            result_.parts.emplace_back();
            placed.push_back(false);
        }
        std::replace(result_.part_of.begin(), result_.part_of.end(), no_part, int64_t{0});
        for (size_t i = 0; i < placed.size(); ++i) {
            if (!placed[i]) {
                model::Use use;
                use.part = static_cast<int64_t>(i);
                result_.uses.push_back(use);
            }
        }
    }

    Entities &entities_;
    const Instances &instances_;
    const std::function<double(int64_t)> &length_;
    std::vector<int64_t> representations_; // places
    std::vector<int64_t> leaders_;         // of each: another one of the same part, or itself
    std::vector<int64_t> numbers_;         // of each: its part
    std::vector<int64_t> sources_;         // of each use: the place of the instance that makes it
    Assembly result_;
};

} // namespace

Assembly read_assembly(Entities &entities, const std::function<double(int64_t)> &length) {
    return AssemblyReader(entities, length).read();
}

} // namespace nrb::io::step

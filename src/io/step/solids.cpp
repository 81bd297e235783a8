// SPDX-License-Identifier: MIT
#include "io/step/solids.h"

#include "base/error.h"

namespace nrb::io::step {
namespace {

class SolidReader {
public:
    explicit SolidReader(Entities &entities) : entities_(entities), instances_(entities.instances()) {}

    PlacesInSolids read(const TellError &tell) {
        for (const Instance &instance : instances_.all()) {
            if (instance.kind() == Kind::topology && is_solid(instance)) {
                try {
                    read_solid(instance);
                } catch (const Error &error) { // faces are read without it
                    tell(instance, error);
                }
                ++place_.solid;
            }
        }
        return std::move(result_);
    }

private:
    // A complex instance of a subtype also has the part of its supertype.
    [[nodiscard]] bool is_solid(const Instance &instance) const {
        const Attributes attributes(instances_, instance);
        return attributes.has_part("MANIFOLD_SOLID_BREP") || attributes.has_part("BREP_WITH_VOIDS") ||
               attributes.has_part("FACETED_BREP");
    }
    Attributes item(const Instance &instance) const {
        Attributes attributes(instances_, instance);
        attributes.part("REPRESENTATION_ITEM");
        attributes.skip("name");
        return attributes;
    }
    void read_solid(const Instance &instance) {
        Attributes attributes = item(instance);
        attributes.part("MANIFOLD_SOLID_BREP");
        place_.in_void = place_.turned = false;
        read_shell(attributes.reference("outer"), attributes, "outer");
        if (!attributes.has_part("BREP_WITH_VOIDS")) {
            return;
        }
        attributes.part("BREP_WITH_VOIDS");
        attributes.open("voids");
        while (attributes.more("voids")) {
            const int64_t number = attributes.reference("voids");
            place_.in_void = true;
            place_.turned = false;
            read_shell(number, attributes, "voids");
        }
    }
    // Oriented shells wrap other shells, and may reverse them.
    void read_shell(int64_t number, const Attributes &owner, const char *attribute) {
        const Instance &shell = entities_.at(number, owner, attribute);
        const Entities::Visit visit(entities_, number);
        Attributes attributes = item(shell);
        if (attributes.has_part("ORIENTED_CLOSED_SHELL")) {
            attributes.part("CONNECTED_FACE_SET");
            attributes.skip("cfs_faces");
            attributes.part("ORIENTED_CLOSED_SHELL");
            const int64_t element = attributes.reference("closed_shell_element");
            place_.turned = place_.turned == attributes.boolean("orientation");
            return read_shell(element, attributes, "closed_shell_element");
        }
        attributes.part("CONNECTED_FACE_SET");
        attributes.open("cfs_faces");
        while (attributes.more("cfs_faces")) {
            entities_.spend(size_of_a_place);
            result_.try_emplace(attributes.reference("cfs_faces"), place_);
        }
    }

    static constexpr int64_t size_of_a_place = 10; // in doubles, as an entry of a map
    Entities &entities_;
    const Instances &instances_;
    PlaceInSolid place_{0, false, false};
    PlacesInSolids result_;
};

} // namespace

PlacesInSolids read_solids(Entities &entities, const TellError &tell) {
    return SolidReader(entities).read(tell);
}

} // namespace nrb::io::step

// SPDX-License-Identifier: MIT
// The parts of a file and where they are placed.
#pragma once

#include "io/iges/model/topology.h"
#include "model/model.h"

#include <map>
#include <vector>

namespace nrb::io::iges {

struct Assembly {
    std::vector<model::ModelPart> parts; // the first one: what no subfigure has
    std::vector<model::Use> uses;
    std::map<int64_t, int64_t> part_of; // of entities by their pointers; the first part for others
    std::vector<bool> told;             // of each directory entry: it places or collects others, and is read

    [[nodiscard]] int64_t part(int64_t pointer) const noexcept {
        const auto found = part_of.find(pointer);
        return found == part_of.end() ? 0 : found->second;
    }
};

// Subfigures (308) are parts, which their instances (408) place: x at R (s x + T) + t with the scale s and the translation T of the
// instance and its matrix (124); in the subfigure that lists the instance, else in the first part. A solid with instances (430), an
// entity that several subfigures list, and a bounded surface, a face, a shell or a solid with a matrix are parts of their own.
// Groups (402) hand what they list on to the subfigure that lists them; one that several list is a part of its own. Placements are
// in the unit that is wanted, of which that of the file is `factor`. Uses that would put a part into itself are told and left out.
// Cost: n log n in the size of the file, whatever the parts would be if they were multiplied.
Assembly read_assembly(Entities &entities, double factor, const TopologyEntities &topology,
                       std::vector<Damage> &damages);

} // namespace nrb::io::iges

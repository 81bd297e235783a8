// SPDX-License-Identifier: MIT
// The parts (subfigures) of a file and their placements.
#pragma once

#include "io/iges/model/topology.h"
#include "model/model.h"

#include <map>
#include <vector>

namespace nrb::io::iges {

struct Assembly {
    std::vector<model::ModelPart> parts; // the first part: everything that is in no subfigure
    std::vector<model::Use> uses;
    std::map<int64_t, int64_t> part_of; // of entities by their pointers; the first part for others
    std::vector<bool> told;             // by directory entry: handled here, as it places or collects others

    [[nodiscard]] int64_t part(int64_t pointer) const noexcept {
        const auto found = part_of.find(pointer);
        return found == part_of.end() ? 0 : found->second;
    }
};

// Subfigures (308) become parts, which their instances (408) place: x is mapped to R (s x + T) + t, with the
// scale s and the translation T of the instance and its matrix (124). The instance is used in the subfigure
// that lists it, else in the first part.
//
// These become parts of their own: solids with instances (430), entities listed by several subfigures, and
// bounded surfaces, faces, shells and solids with a matrix. Groups (402) pass what they list on to the
// subfigure that lists them; a group listed by several subfigures is a part of its own.
//
// Placements are in the wanted unit; `factor` converts from the unit of the file. Uses that would place a
// part in itself are reported and left out. Cost: O(n log n) in the size of the file, however large the
// expanded assembly would be.
Assembly read_assembly(Entities &entities, double factor, const TopologyEntities &topology,
                       std::vector<Damage> &damages);

} // namespace nrb::io::iges

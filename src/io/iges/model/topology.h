// SPDX-License-Identifier: MIT
// The entities that bound faces and collect them, as they are in the file.
#pragma once

#include "io/iges/geometry/entities.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace nrb::io::iges {

// Pointers are directory lines; 0: none.

// 142: a closed curve on a surface, given in its domain, in space, or both.
struct CurveOnSurface {
    int64_t surface;
    int64_t domain_curve;
    int64_t space_curve;
    int64_t preference; // 1: the curve in the domain, 2: the curve in space, 0 and 3: either
};

// 144.
struct TrimmedSurface {
    int64_t surface;
    int64_t outer; // 0: the boundary of the domain
    std::vector<int64_t> inner;
};

// A curve of a boundary (141), which is a sequence of curves.
struct BoundaryCurve {
    int64_t curve;
    bool reversed;
    std::vector<int64_t> domain_curves;
};
struct Boundary {
    int64_t preference;
    std::vector<BoundaryCurve> curves;
};

// 143.
struct BoundedSurface {
    int64_t surface;
    std::vector<int64_t> boundaries;
};

// A shell of a solid (186), or a face of a shell (514).
struct Oriented {
    int64_t pointer;
    bool against;
};

// 510.
struct FaceEntity {
    int64_t surface;
    std::vector<int64_t> loops;
};

// 508: an edge by its index in a list, or a vertex where the boundary degenerates to a point.
struct EdgeReference {
    bool vertex;
    int64_t list;
    int64_t index; // from 1
    bool against;
    std::vector<int64_t> domain_curves;
};

// 504.
struct EdgeEntity {
    int64_t curve;
    std::array<int64_t, 2> vertex_lists;
    std::array<int64_t, 2> vertex_indices;
};

// All entities by their pointers. Those that cannot be read are missing.
struct TopologyEntities {
    std::map<int64_t, CurveOnSurface> curves_on_surfaces;
    std::map<int64_t, TrimmedSurface> trimmed;
    std::map<int64_t, Boundary> boundaries;
    std::map<int64_t, BoundedSurface> bounded;
    std::map<int64_t, std::vector<Oriented>> solids;
    std::map<int64_t, std::vector<Oriented>> shells;
    std::map<int64_t, FaceEntity> faces;
    std::map<int64_t, std::vector<EdgeReference>> loops;
    std::map<int64_t, std::vector<EdgeEntity>> edge_lists;
    std::map<int64_t, std::vector<std::array<double, 3>>> vertex_lists; // placed, in the wanted unit
    std::map<int64_t, std::string> names;
};

// An error in an entity.
struct Damage {
    int64_t pointer;
    Status reason;
    std::string text; // begins with the label of the entity
};

// `factor`: from the unit of the file to the wanted unit.
TopologyEntities read_topology(Entities &entities, double factor, std::vector<Damage> &damages);

} // namespace nrb::io::iges

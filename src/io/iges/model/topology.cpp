// SPDX-License-Identifier: MIT
#include "io/iges/model/topology.h"

#include "base/watch.h"
#include "io/iges/model/counts.h"
#include "io/iges/types.h"

namespace nrb::io::iges {
namespace {

constexpr int64_t size_of_an_entity = 16; // in doubles, in its map

CurveOnSurface read_curve_on_surface(Record &record) {
    record.skip(1); // how it was created
    CurveOnSurface curve{};
    curve.surface = record.integer("surface");
    curve.domain_curve = record.integer("curve in the domain");
    curve.space_curve = record.integer("curve in space");
    curve.preference = record.integer("preference");
    return curve;
}

TrimmedSurface read_trimmed_surface(Record &record) {
    TrimmedSurface trimmed{};
    trimmed.surface = record.integer("surface");
    const bool has_outer = record.integer("outer boundary flag") != 0;
    const int64_t count = read_count(record, "number of inner boundaries", 1);
    const int64_t outer = record.integer("outer boundary");
    trimmed.outer = has_outer ? outer : 0;
    for (int64_t i = 0; i < count; ++i) {
        trimmed.inner.push_back(record.integer("inner boundary", i));
    }
    return trimmed;
}

Boundary read_boundary(Record &record) {
    record.skip(1); // whether there are curves in the domain
    Boundary boundary{record.integer("preference"), {}};
    record.skip(1); // the surface, which the bounded surface states as well
    const int64_t count = read_count(record, "number of curves", 3);
    for (int64_t i = 0; i < count; ++i) {
        BoundaryCurve curve{record.integer("curve in space", i), false, {}};
        curve.reversed = record.integer("sense", i) == 2;
        curve.domain_curves = read_pointers(record, "number of curves in the domain");
        boundary.curves.push_back(std::move(curve));
    }
    return boundary;
}

BoundedSurface read_bounded_surface(Record &record) {
    record.skip(1); // whether there are curves in the domain
    const int64_t surface = record.integer("surface");
    return {surface, read_pointers(record, "number of boundaries")};
}

std::vector<Oriented> read_oriented(Record &record, int64_t count, const char *what) {
    std::vector<Oriented> result;
    for (int64_t i = 0; i < count; ++i) {
        const int64_t pointer = record.integer(what, i);
        result.push_back({pointer, record.integer("orientation", i) == 0});
    }
    return result;
}

// The outer shell, then the voids.
std::vector<Oriented> read_solid(Record &record) {
    std::vector<Oriented> shells = read_oriented(record, 1, "shell");
    const int64_t count = read_count(record, "number of voids", 2);
    for (const Oriented &shell : read_oriented(record, count, "void")) {
        shells.push_back(shell);
    }
    return shells;
}

std::vector<Oriented> read_shell(Record &record) {
    const int64_t count = read_count(record, "number of faces", 2);
    return read_oriented(record, count, "face");
}

FaceEntity read_face(Record &record) {
    FaceEntity face{record.integer("surface"), {}};
    const int64_t count = read_count(record, "number of loops", 1);
    record.skip(1); // whether the first loop is the outer one
    for (int64_t i = 0; i < count; ++i) {
        face.loops.push_back(record.integer("loop", i));
    }
    return face;
}

std::vector<EdgeReference> read_loop(Record &record) {
    std::vector<EdgeReference> loop;
    const int64_t count = read_count(record, "number of edges", 5);
    for (int64_t i = 0; i < count; ++i) {
        EdgeReference edge{};
        edge.vertex = record.integer("edge type", i) == 1;
        edge.list = record.integer("edge list", i);
        edge.index = record.integer("edge index", i);
        edge.against = record.integer("edge orientation", i) == 0;
        const int64_t curves = read_count(record, "number of curves in the domain", 2);
        for (int64_t k = 0; k < curves; ++k) {
            record.skip(1); // whether it is isoparametric, which its geometry shows
            edge.domain_curves.push_back(record.integer("curve in the domain", k));
        }
        loop.push_back(std::move(edge));
    }
    return loop;
}

std::vector<EdgeEntity> read_edge_list(Record &record) {
    std::vector<EdgeEntity> edges(static_cast<size_t>(read_count(record, "number of edges", 5)));
    for (EdgeEntity &edge : edges) {
        edge.curve = record.integer("curve");
        for (size_t end = 0; end < 2; ++end) {
            edge.vertex_lists[end] = record.integer("vertex list");
            edge.vertex_indices[end] = record.integer("vertex index");
        }
    }
    return edges;
}

std::vector<std::array<double, 3>> read_vertex_list(Record &record, const Placement &placement) {
    std::vector<std::array<double, 3>> points(
        static_cast<size_t>(read_count(record, "number of vertices", 3)));
    for (std::array<double, 3> &point : points) {
        for (double &x : point) {
            x = record.real("vertex");
        }
        point = placement.point(point);
    }
    return points;
}

class TopologyReader {
public:
    TopologyReader(Entities &entities, double factor, std::vector<Damage> &damages)
        : entities_(entities), factor_(factor), damages_(damages) {}

    TopologyEntities run() {
        for (const Entry &entry : entities_.directory().entries()) {
            try {
                labelling(entry, [&] { read(entry); });
            } catch (const Error &error) {
                damages_.push_back({entry.line, error.status(), error.what()});
            }
        }
        return std::move(result_);
    }

private:
    void read(const Entry &entry) {
        switch (entry.type) {
        case boundary_type:
            return add(entry, result_.boundaries, read_boundary);
        case curve_on_surface_type:
            return add(entry, result_.curves_on_surfaces, read_curve_on_surface);
        case bounded_surface_type:
            return add(entry, result_.bounded, read_bounded_surface);
        case trimmed_surface_type:
            return add(entry, result_.trimmed, read_trimmed_surface);
        case solid_type:
            return add(entry, result_.solids, read_solid);
        case vertex_list_type:
            return add(entry, result_.vertex_lists, [&](Record &record) {
                return read_vertex_list(record, entities_.placement(entry, nullptr, factor_, false));
            });
        case edge_list_type:
            return add(entry, result_.edge_lists, read_edge_list);
        case loop_type:
            return add(entry, result_.loops, read_loop);
        case face_type:
            return add(entry, result_.faces, read_face);
        case shell_type:
            return add(entry, result_.shells, read_shell);
        default:
            return;
        }
    }
    template <class Value, class Read>
    void add(const Entry &entry, std::map<int64_t, Value> &all, Read &&read) {
        entities_.spend(size_of_an_entity);
        Record record = entities_.record(entry);
        all.emplace(entry.line, read(record));
        result_.names.emplace(entry.line, entities_.name(entry, record));
    }

    Entities &entities_;
    double factor_;
    std::vector<Damage> &damages_;
    TopologyEntities result_;
};

} // namespace

TopologyEntities read_topology(Entities &entities, double factor, std::vector<Damage> &damages) {
    return TopologyReader(entities, factor, damages).run();
}

} // namespace nrb::io::iges

// SPDX-License-Identifier: MIT
#include "io/iges/model/uses.h"

namespace nrb::io::iges {
namespace {

class UseMarker {
public:
    UseMarker(const TopologyEntities &topology, const Directory &directory, std::vector<bool> &used)
        : topology_(topology), directory_(directory), used_(used) {}

    void run() {
        for (const auto &[line, trimmed] : topology_.trimmed) {
            mark(trimmed.surface);
            mark_curve_on_surface(trimmed.outer);
            for (const int64_t pointer : trimmed.inner) {
                mark_curve_on_surface(pointer);
            }
        }
        for (const auto &[line, bounded] : topology_.bounded) {
            mark(bounded.surface);
            for (const int64_t pointer : bounded.boundaries) {
                mark_boundary(pointer);
            }
        }
        for (const auto &[line, face] : topology_.faces) {
            mark(face.surface);
        }
        mark_edges();
    }

private:
    void mark(int64_t pointer) {
        if (const std::optional<size_t> index = directory_.find(pointer)) {
            used_[*index] = true;
        }
    }
    void mark_curve_on_surface(int64_t pointer) {
        mark(pointer);
        if (const auto curve = topology_.curves_on_surfaces.find(pointer);
            curve != topology_.curves_on_surfaces.end()) {
            mark(curve->second.domain_curve);
            mark(curve->second.space_curve);
        }
    }
    void mark_boundary(int64_t pointer) {
        mark(pointer);
        if (const auto boundary = topology_.boundaries.find(pointer);
            boundary != topology_.boundaries.end()) {
            for (const BoundaryCurve &curve : boundary->second.curves) {
                mark(curve.curve);
                mark_all(curve.domain_curves);
            }
        }
    }
    void mark_edges() {
        for (const auto &[line, loop] : topology_.loops) {
            for (const EdgeReference &edge : loop) {
                mark_all(edge.domain_curves);
            }
        }
        for (const auto &[line, edges] : topology_.edge_lists) {
            for (const EdgeEntity &edge : edges) {
                mark(edge.curve);
            }
        }
    }
    void mark_all(const std::vector<int64_t> &pointers) {
        for (const int64_t pointer : pointers) {
            mark(pointer);
        }
    }

    const TopologyEntities &topology_;
    const Directory &directory_;
    std::vector<bool> &used_;
};

} // namespace

void mark_used(const TopologyEntities &topology, const Directory &directory, std::vector<bool> &used) {
    UseMarker(topology, directory, used).run();
}

} // namespace nrb::io::iges

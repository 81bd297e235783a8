// SPDX-License-Identifier: MIT
// What is right about the meshes of the faces of a file.
#pragma once

#include "bench/meshes/foot.h"

#include <string>

namespace bench::meshes {

struct Verdict {
    int64_t faces = 0;
    int64_t missing = 0;  // faces without triangles
    int64_t off = 0;      // others whose area is wrong by more than a tenth of it
    int64_t exceeded = 0; // faces of which such a distance is larger than is proven
    double far = 0;       // the largest distance of a middle of triangles or sides from the surface

    // Of one face, whose surface is evaluated as foot_distance() asks for it.
    template <class Evaluate>
    void add(const Mesh &mesh, double area, double proven, const Domain &domain, Evaluate &&jet_of) {
        double sum = 0, most = 0;
        for (size_t i = 0; i < mesh.triangles.size(); ++i) {
            sum += mesh.area(i);
            for (const Point &shares : middles) {
                most = std::max(most, foot_distance(mesh.point(i, shares), mesh.param(i, shares), domain,
                                                    most, 8, jet_of));
            }
        }
        ++faces;
        far = std::max(far, most);
        exceeded += most > proven ? 1 : 0;
        missing += mesh.triangles.empty() ? 1 : 0;
        off += !mesh.triangles.empty() && !(std::fabs(sum - area) <= 0.1 * area) ? 1 : 0;
    }
    [[nodiscard]] std::string told(double chord) const {
        char text[256];
        std::snprintf(
            text, sizeof text,
            ", \"faces\": %lld, \"missing\": %lld, \"off\": %lld, \"exceeded\": %lld, \"far\": %.6g, "
            "\"chord\": %.17g",
            static_cast<long long>(faces), static_cast<long long>(missing), static_cast<long long>(off),
            static_cast<long long>(exceeded), far, chord);
        return text;
    }
};

} // namespace bench::meshes

// SPDX-License-Identifier: MIT
// Meshes all faces of a model. Each edge becomes a polyline once, whose points all faces at it share.
#pragma once

#include "mesh/border/model_edges.h"
#include "mesh/domain/domain_mesh.h"
#include "mesh/work_shares.h"

#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace nrb::mesh {

MeshDomain domain_of(const Spline &surface, const face::Covering &covering);
// Appends the mesh of a face to that of the model. Its own points follow those that are there.
void append(const DomainMesh &part, Mesh &mesh);

class ModelMesher {
public:
    // `work_of_faces`: the expected work of each face, as for WorkShares.
    ModelMesher(const model::Model &model, const MeshRule &rule, std::vector<double> work_of_faces);
    ~ModelMesher();
    ModelMesher(const ModelMesher &) = delete;
    ModelMesher &operator=(const ModelMesher &) = delete;

    // Returns nothing only if it may fail, and the work is not enough for triangles about as close as the
    // rule asks.
    std::optional<Mesh> mesh(bool may_fail);
    // After a failure: the work that would have been enough, roughly.
    [[nodiscard]] double wanted_work() const noexcept { return wanted_work_; }

private:
    struct FaceWork;
    // Segments of the border of a face that cross others.
    struct Crossings {
        size_t fewest = std::numeric_limits<size_t>::max(); // so far
        int in_vain = 0; // how often in a row dividing them did not make them fewer
    };
    [[nodiscard]] bool has_old() const;
    // Meshes the faces whose edges changed. `last`: edges may not change any more.
    void mesh_faces(bool last);
    void judge(size_t face, bool enough) noexcept;
    void mesh_face(size_t face, bool last);
    void run(FaceWork &work);
    [[nodiscard]] static bool is_better_in_space(const FaceWork &work, const DomainMesh &made) noexcept;
    [[nodiscard]] std::unique_ptr<FaceWork> work_for(size_t face);
    void drop_work(size_t face);
    [[nodiscard]] bool is_kept(const FaceWork &work, size_t triangles) noexcept;
    [[nodiscard]] bool is_hopeless(size_t face, size_t crossed) noexcept;
    bool change_edges(size_t face, const FaceBorder &border, const BorderWish &wish);

    const model::Model &model_;
    MeshRule rule_;
    WorkShares shares_;
    bool may_fail_ = false;
    double wanted_work_ = 0;
    ModelEdges edges_;
    std::vector<DomainMesh> parts_;
    std::vector<std::unique_ptr<FaceWork>> works_; // state kept of faces, to resume when their edges change
    size_t kept_ = 0;                              // number of triangles in works_
    std::vector<bool> old_;            // of each face, whether its edges changed since it was meshed
    std::vector<Crossings> crossings_; // of each face
};

} // namespace nrb::mesh

// SPDX-License-Identifier: MIT
// The faces of a model as triangles, with edges in common.
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
// With own points behind all others.
void append(const DomainMesh &part, Mesh &mesh);

class ModelMesher {
public:
    // With what is expected of each face, as for WorkShares.
    ModelMesher(const model::Model &model, const MeshRule &rule, std::vector<double> work_of_faces);
    ~ModelMesher();
    ModelMesher(const ModelMesher &) = delete;
    ModelMesher &operator=(const ModelMesher &) = delete;

    // None if it may fail, and the work is not enough for triangles about as near as the rule wants them.
    std::optional<Mesh> mesh(bool may_fail);
    // After that: what would have been enough, roughly.
    [[nodiscard]] double wanted_work() const noexcept { return wanted_work_; }

private:
    struct FaceWork;
    struct Crossings { // of segments of a border
        size_t fewest = std::numeric_limits<size_t>::max();
        int in_vain = 0;
    };
    [[nodiscard]] bool has_old() const;
    // Those whose edges changed; last: no edge may change any more.
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
    std::vector<std::unique_ptr<FaceWork>> works_; // of faces that go on where they are old
    size_t kept_ = 0;                              // triangles of these
    std::vector<bool> old_;                        // faces whose edges changed
    std::vector<Crossings> crossings_;             // of faces
};

} // namespace nrb::mesh

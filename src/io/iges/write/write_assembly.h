// SPDX-License-Identifier: MIT
// Parts as subfigures, and where they are placed.
#pragma once

#include "io/iges/write/write_geometry.h"
#include "model/model.h"

#include <vector>

namespace nrb::io::iges {

// Whether the first part is what stands in the file outside of subfigures, as readers have it.
bool first_is_whole(const model::Model &model);

// Subfigures (308) with their instances (408), in the order of parts and of uses. Throws Status::matrix for placements that are no
// similarities, naming the use.
class AssemblyWriter {
public:
    // items: the pointers of what stands in each part.
    AssemblyWriter(GeometryWriter &geometry, const model::Model &model,
                   std::vector<std::vector<int64_t>> items);

    void run();

private:
    [[nodiscard]] bool is_whole(int64_t part) const noexcept { return part < first_; }
    void place(const model::Use &use);
    void find_depths(const std::vector<model::Use> &uses);
    void write_subfigure(int64_t part);
    [[nodiscard]] int64_t pointer(int64_t part) const noexcept {
        return first_pointer_ + 2 * (part - first_);
    }

    GeometryWriter &geometry_;
    FileText &text_;
    const model::Model &model_;
    std::vector<std::vector<int64_t>> items_;
    int64_t first_; // of the parts that are subfigures
    int64_t first_pointer_ = 0;
    std::vector<int64_t> depths_;
};

} // namespace nrb::io::iges

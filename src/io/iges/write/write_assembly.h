// SPDX-License-Identifier: MIT
// Writes parts as subfigures, and their placements.
#pragma once

#include "io/iges/write/write_geometry.h"
#include "model/model.h"

#include <vector>

namespace nrb::io::iges {

// Whether the first part holds what is outside of subfigures in the file, as readers assume.
bool first_is_whole(const model::Model &model);

// Writes subfigures (308) with their instances (408), in the order of parts and uses. Throws Status::matrix
// for placements that are not similarities, naming the use.
class AssemblyWriter {
public:
    // items: for each part, the pointers of what it contains.
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
    int64_t first_; // the first part that is a subfigure
    int64_t first_pointer_ = 0;
    std::vector<int64_t> depths_;
};

} // namespace nrb::io::iges

// SPDX-License-Identifier: MIT
// What was found out about parts of a domain, for further trees of cells over it.
#pragma once

#include "mesh/cells/cell_shape.h"
#include "mesh/proof/triangle_bound.h"

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace nrb::mesh {

// What does not depend on the limits that cells keep.
struct LookedAt {
    HessianBox box;
    CellBend bend;
    double off = 0; // bend.in_parts(1, 1)
};

// Parts are known by the way that led to them: nets of halves depend on it by their rounding, and trees have to be the same, bit for
// bit, with and without a memo. A way begins where a part has nets of its own, which depend on nothing else.
class CellMemo {
public:
    static constexpr int32_t unknown = -1;

    // room: how many more parts may be known, of all domains that have the same.
    explicit CellMemo(std::shared_ptr<int64_t> room) : room_(std::move(room)) {}

    // Numbers of parts: of one in which a way begins, and of the two of a numbered one, which may be `unknown`, at a place of an axis.
    // `unknown` where there is no room for more.
    [[nodiscard]] int32_t first(const Rectangle &part, int divisions);
    [[nodiscard]] std::array<int32_t, 2> halves(int32_t parent, size_t axis, double at);

    // Null if nothing is known.
    [[nodiscard]] const LookedAt *find(int32_t number) const noexcept;
    void keep(int32_t number, const LookedAt &looked);
    // From here on nothing new is kept.
    void close() noexcept { *room_ = 0; }

private:
    struct Halves {
        size_t axis;
        double at;
        int32_t first, next; // numbers of the lower part, and of further halves of the same part
    };
    struct Part {
        int32_t known = unknown, halves = unknown;
    };
    int32_t add_parts(int32_t count);

    std::shared_ptr<int64_t> room_;
    std::map<std::array<double, 5>, int32_t> firsts_;
    std::vector<Part> parts_;
    std::vector<Halves> halves_;
    static constexpr size_t block = 64;
    std::vector<std::unique_ptr<std::array<LookedAt, block>>> known_;
    size_t count_ = 0;
};

} // namespace nrb::mesh

// SPDX-License-Identifier: MIT
// Transformation matrices (entity 124).
#pragma once

#include "base/error.h"
#include "io/iges/directory.h"

#include <array>
#include <map>
#include <set>

namespace nrb::io::iges {

// x -> R x + T.
struct Transform {
    std::array<std::array<double, 3>, 3> r = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::array<double, 3> t = {0, 0, 0};

    [[nodiscard]] std::array<double, 3> apply(const std::array<double, 3> &x) const noexcept;
};

// x -> outer(inner(x)).
Transform compose(const Transform &outer, const Transform &inner) noexcept;

// Resolves pointers to matrices, which may themselves point to matrices that are applied after them. Each
// matrix is read once.
class Transforms {
public:
    Transforms(const Directory &directory, ParameterData &data) : directory_(directory), data_(data) {}

    // The composition of the whole chain that starts at `pointer`. Throws Status::syntax if a link is
    // missing, is not a matrix, cannot be read, or closes a cycle.
    const Transform &resolve(int64_t pointer);

    // Checks the chain of a matrix that nothing uses. Throws as resolve(), but Status::cycle for a matrix
    // that is in a cycle or leads to one.
    void check(int64_t pointer);

    // Whether the matrix at a directory entry was part of a chain that resolve() was called for, and could be
    // resolved.
    [[nodiscard]] bool used(size_t index) const noexcept;

private:
    struct Resolved {
        Transform transform;
        std::string damage; // empty: valid
        Status reason = Status::syntax;
    };
    Resolved value_of(int64_t pointer);
    std::vector<size_t> unresolved_chain(int64_t pointer, Resolved &end);
    Resolved read_link(const Entry &entry, const Resolved &outer);

    const Directory &directory_;
    ParameterData &data_;
    std::map<size_t, Resolved> resolved_; // by index of the directory entry
    std::set<size_t> asked_;              // those in chains that resolve() was called for
};

} // namespace nrb::io::iges

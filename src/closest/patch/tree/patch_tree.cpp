// SPDX-License-Identifier: MIT
#include "closest/patch/tree/patch_tree.h"

namespace nrb::closest {

void PatchTree::bound(int level, int64_t node, const double *x, bool farthest,
                      const pieces::DiscBounds &out) const {
    of_parts(level + 1) ? leaves_.bound(node, x, farthest, out) : tree_.bound(level, node, x, farthest, out);
}

PatchTree::Extent PatchTree::extent(int level, int64_t node) const noexcept {
    return of_parts(level) ? tree_.extent(level - 1, node / leaves_.count()) : tree_.extent(level, node);
}

PatchTree::Leaf PatchTree::leaf(int64_t node) const noexcept {
    Leaf result{tree_.order()[static_cast<size_t>(node / leaves_.count())], {}};
    int64_t rest = node % leaves_.count();
    for (int k = tree_.grid().shape().axes; k-- > 0; rest /= parts()) {
        result.part[static_cast<size_t>(k)] = static_cast<int>(rest % parts());
    }
    return result;
}

PatchTree::Centre PatchTree::centre(int level, int64_t node) const noexcept {
    if (!of_parts(level)) {
        return {tree_.middle(level, node), {0.5, 0.5, 0.5}};
    }
    const Leaf part = leaf(node);
    Centre result{part.piece, {}};
    for (size_t k = 0; k < result.at.size(); ++k) {
        result.at[k] = (part.part[k] + 0.5) / parts();
    }
    return result;
}

} // namespace nrb::closest

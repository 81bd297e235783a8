// SPDX-License-Identifier: MIT
#include "io/mesh_formats/blocks.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::io {

void Blocks::text(std::string_view text) {
    while (!text.empty()) {
        char *const start = room(1);
        const size_t fits = std::min(text.size(), block - used_);
        std::memcpy(start, text.data(), fits);
        used_ += fits;
        text.remove_prefix(fits);
    }
}

void Blocks::flush() {
    if (used_ > 0) {
        sink_(std::string_view(buffer_.get(), used_));
        count_work(static_cast<int64_t>(used_));
        used_ = 0;
    }
}

void Blocks::turn_around(size_t size) noexcept {
    char *const start = buffer_.get() + used_;
    std::reverse(start, start + size);
}

int64_t size_of(const ByteSource &source) {
    int64_t size = 0;
    source([&size](std::string_view bytes) { size += std::ssize(bytes); });
    return size;
}

} // namespace nrb::io

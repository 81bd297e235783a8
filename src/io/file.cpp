// SPDX-License-Identifier: MIT
#include "io/file.h"

#include "base/error.h"
#include "base/no_cancellation.h"
#include "base/watch.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <new>
#include <system_error>

namespace nrb::io {

namespace {

struct Close {
    void operator()(std::FILE *file) const noexcept { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail_file(const char *path) {
    if (errno == ENOMEM) {
        throw std::bad_alloc();
    }
    fail(Status::file, "path = \"%.200s\": %s", path, std::generic_category().message(errno).c_str());
}

} // namespace

std::vector<char> read_whole_file(const char *path, int64_t max_bytes) {
    const NoCancellation shield;
    const File file(std::fopen(path, "rb"));
    if (!file) {
        fail_file(path);
    }
    // Reads growing blocks instead of asking for the size first: the path may be a pipe.
    std::vector<char> bytes;
    size_t block = size_t{1} << 16;
    for (;;) {
        const size_t used = bytes.size();
        count_work(static_cast<int64_t>(block));
        bytes.resize(used + block);
        const size_t got = std::fread(bytes.data() + used, 1, block, file.get());
        bytes.resize(used + got);
        if (static_cast<int64_t>(bytes.size()) > max_bytes) {
            fail(Status::too_large, "path = \"%.200s\": more than max_bytes = %lld bytes", path,
                 static_cast<long long>(max_bytes));
        }
        if (got < block) {
            break;
        }
        block = bytes.size();
    }
    if (std::ferror(file.get()) != 0) {
        fail_file(path);
    }
    return bytes;
}

} // namespace nrb::io

// SPDX-License-Identifier: MIT
// Uses POSIX to create a file that is certain to be new, and to replace another file by renaming. The streams
// of C++20 and std::rename() promise neither.
#include "base/error.h"
#include "base/no_cancellation.h"
#include "base/watch.h"
#include "io/file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace nrb::io {

namespace {

constexpr size_t block = size_t{1} << 20;

[[noreturn]] void fail_path(const std::string &path, int error) {
    if (error == ENOMEM) {
        throw std::bad_alloc();
    }
    fail(Status::file, "path = \"%.200s\": %s", path.c_str(), std::generic_category().message(error).c_str());
}

class Descriptor {
public:
    explicit Descriptor(int number) noexcept : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;

    [[nodiscard]] int number() const noexcept { return number_; }
    // Errors of earlier writes may be reported only here.
    int close() noexcept {
        const int number = std::exchange(number_, -1);
        return number < 0 ? 0 : ::close(number);
    }

private:
    int number_;
};

void write_all(const std::string &path, int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), std::min(bytes.size(), block));
        if (written < 0 && errno != EINTR) {
            fail_path(path, errno);
        }
        bytes.remove_prefix(static_cast<size_t>(std::max<ssize_t>(written, 0)));
        count_work(static_cast<int64_t>(block));
    }
}

// A new file in the directory of the file that it is to replace. The destructor removes it, unless it has
// replaced that file.
class Replacement {
public:
    explicit Replacement(std::string path, mode_t mode) : path_(std::move(path)) {
        static std::atomic<unsigned> made{0};
        const std::string directory =
            path_.substr(0, path_.rfind('/') + 1); // names may be as long as allowed
        do {
            name_ = directory + ".nurbs-" + std::to_string(::getpid()) + "-" + std::to_string(made++);
            number_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        } while (number_ < 0 && errno == EEXIST);
        if (number_ < 0) {
            fail_path(path_, errno);
        }
    }
    ~Replacement() {
        if (number_ >= 0) {
            ::unlink(name_.c_str());
        }
    }
    Replacement(const Replacement &) = delete;
    Replacement &operator=(const Replacement &) = delete;

    void run(const ByteSource &source, const struct stat *old) {
        Descriptor file(number_);
        if (old != nullptr && ::fchmod(number_, old->st_mode & 07777U) != 0) {
            fail_path(path_, errno);
        }
        source([this](std::string_view bytes) { write_all(path_, number_, bytes); });
        if (::fsync(number_) != 0 || file.close() != 0 || std::rename(name_.c_str(), path_.c_str()) != 0) {
            fail_path(path_, errno);
        }
        number_ = -1;
    }

private:
    std::string path_, name_;
    int number_ = -1;
};

// The path with its symbolic links resolved, also those that lead to a file that does not exist yet.
std::string target_of(std::string path) {
    struct Free {
        void operator()(char *text) const noexcept { std::free(text); } // NOLINT: as realpath() wants it
    };
    constexpr int most_links = 40; // as Linux has it
    for (int links = 0; links < most_links; ++links) {
        const std::unique_ptr<char, Free> target(::realpath(path.c_str(), nullptr));
        if (target) {
            return target.get();
        }
        if (errno == ENOMEM) {
            throw std::bad_alloc();
        }
        std::error_code error;
        if (std::filesystem::exists(path, error)) { // such as /dev/stdout: the link of a pipe holds no path
            return path;
        }
        const std::filesystem::path link = std::filesystem::read_symlink(path, error);
        if (error) {
            return path;
        }
        path = std::filesystem::path(path).parent_path() / link;
    }
    fail_path(path, ELOOP);
}

void write_into(const std::string &path, const ByteSource &source) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.number() < 0) {
        fail_path(path, errno);
    }
    source([&](std::string_view bytes) { write_all(path, file.number(), bytes); });
    if (file.close() != 0) {
        fail_path(path, errno);
    }
}

} // namespace

void write_whole_file(const char *path, std::string_view bytes) {
    write_whole_file(path, [bytes](const ByteSink &sink) { sink(bytes); });
}

void write_whole_file(const char *path, const ByteSource &source) {
    const NoCancellation shield;
    const std::string target = target_of(path);
    struct stat old {};
    const bool exists = ::stat(target.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode)) {
        fail_path(path, EISDIR);
    }
    if (exists && !S_ISREG(old.st_mode)) {
        return write_into(target, source);
    }
    if (exists && ::access(target.c_str(), W_OK) != 0) { // rename() does not check this
        fail_path(path, errno);
    }
    constexpr mode_t usual = 0666;
    Replacement(target, usual).run(source, exists ? &old : nullptr);
}

} // namespace nrb::io

/* SPDX-License-Identifier: MIT */
// Arrays of a call in memory of their own, which end where a page begins that is not mapped, or begin where
// one ends. Reading or writing beside them ends the program, writing to an input too.
#ifndef NURBS_TESTS_CAPI_GUARDED_PAGES_H
#define NURBS_TESTS_CAPI_GUARDED_PAGES_H

#include <nurbs/nurbs.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace guarded {

struct Function {
    const char *name;
    int64_t calls = 0; // that did not fail
};

// An array of a function: how often it was not empty in a call.
struct Argument {
    const char *function, *name;
    bool read; // by the function
    int64_t times = 0;
};

enum class Side { end, start };

inline Side side = Side::end;
inline const char *running = "no function"; // for a report

class Running {
public:
    explicit Running(Function &function) : function_(function) {
        running = function.name;
        ++function_.calls;
    }
    Running(const Running &) = delete;
    Running &operator=(const Running &) = delete;
    ~Running() { running = "no function"; }
    // A call that failed does not count.
    nurbs_status status(nurbs_status status) {
        function_.calls -= status == NURBS_OK ? 0 : 1;
        return status;
    }
    template <class Result>
    Result other(Result result) {
        return result;
    }

private:
    Function &function_;
};

// Memory between two pages without access. That of a single page, as most is, is used again.
class Pages {
public:
    explicit Pages(size_t bytes) : bytes_(bytes), inner_((bytes / page() + 1) * page()) {
        if (inner_ == page() && !spare.empty()) {
            first_ = spare.back();
            spare.pop_back();
        } else {
            map();
        }
    }
    Pages(const Pages &) = delete;
    Pages &operator=(const Pages &) = delete;
    ~Pages() {
        if (inner_ == page()) {
            allow(PROT_READ | PROT_WRITE);
            spare.push_back(first_);
        } else {
            munmap(first_ - page(), inner_ + 2 * page());
        }
    }

    // That of no bytes is a guarding page.
    [[nodiscard]] void *place() const {
        return side == Side::end || bytes_ == 0 ? first_ + (inner_ - bytes_) : first_;
    }
    void allow(int access) {
        if (access != access_ && mprotect(first_, inner_, access) != 0) {
            std::perror("mprotect");
            std::exit(2);
        }
        access_ = access;
    }

private:
    static size_t page() {
        static const auto size = static_cast<size_t>(sysconf(_SC_PAGESIZE));
        return size;
    }
    void map() {
        void *const all = mmap(nullptr, inner_ + 2 * page(), PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (all == MAP_FAILED) {
            std::perror("mmap");
            std::exit(2);
        }
        first_ = static_cast<char *>(all) + page();
        access_ = PROT_NONE;
        allow(PROT_READ | PROT_WRITE);
    }

    static inline std::vector<char *> spare;
    size_t bytes_, inner_;
    char *first_ = nullptr;
    int access_ = PROT_READ | PROT_WRITE;
};

// What a call is given in place of an array of its caller, who finds in his what the call left in it.
template <class T>
class Array {
public:
    Array(Argument &argument, T *caller, int64_t count)
        : caller_(caller), bytes_(static_cast<size_t>(count) * size), pages_(bytes_) {
        argument.times += caller_ != nullptr && bytes_ > 0 ? 1 : 0;
        if (caller_ != nullptr && bytes_ > 0) {
            std::memcpy(pages_.place(), caller_, bytes_);
        }
        if constexpr (std::is_const_v<T>) {
            pages_.allow(PROT_READ);
        }
    }
    Array(const Array &) = delete;
    Array &operator=(const Array &) = delete;
    ~Array() {
        if constexpr (!std::is_const_v<T>) {
            if (caller_ != nullptr && bytes_ > 0) {
                std::memcpy(caller_, pages_.place(), bytes_);
            }
        }
    }
    [[nodiscard]] T *place() const { return caller_ == nullptr ? nullptr : static_cast<T *>(pages_.place()); }

private:
    static constexpr size_t size = sizeof(std::conditional_t<std::is_void_v<T>, char, T>);
    T *caller_;
    size_t bytes_;
    Pages pages_;
};

} // namespace guarded

#endif

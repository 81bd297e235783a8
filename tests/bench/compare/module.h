// A module of rows, loaded beside one build of the library.
#pragma once

#include "bench/compare/rows.h"

#include <filesystem>

namespace bench {

class Module {
public:
    // `apart` loads it with everything that it needs once more, so that two builds live in one process.
    Module(const std::filesystem::path &path, bool apart);

    int64_t open(const std::string &folder) const { return open_(folder.c_str()); }
    [[nodiscard]] std::string name(int64_t row) const { return name_(row); }
    void prepare(int64_t row) const { prepare_(row); }
    void run(int64_t times) const { run_(times); }

private:
    bench_open_function *open_;
    bench_name_function *name_;
    bench_prepare_function *prepare_;
    bench_run_function *run_;
};

// The names of the families, in the order of the tables.
std::vector<std::string> families();

// The module of a family in a folder.
std::filesystem::path module_path(const std::filesystem::path &folder, const std::string &family);

} // namespace bench

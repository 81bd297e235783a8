// Runs each row once under callgrind, which writes a file of counts for each. Everything is done once before,
// so that tables and caches are there.
#include "bench/compare/module.h"

#include <cstdio>
#include <regex>
#include <valgrind/callgrind.h>

namespace {

void count(const bench::Module &module, int64_t row) {
    module.prepare(row);
    module.run(1);
    const std::string name = module.name(row);
    CALLGRIND_ZERO_STATS;
    module.run(1);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: %s FOLDER DATA_FOLDER REGEX\n", argv[0]);
        return 2;
    }
    const std::regex wanted(argv[3]);
    for (const std::string &family : bench::families()) {
        const bench::Module module(bench::module_path(argv[1], family), false);
        const int64_t rows = module.open(argv[2]);
        for (int64_t row = 0; row < rows; ++row) {
            if (std::regex_search(module.name(row), wanted)) {
                count(module, row);
            }
        }
    }
}

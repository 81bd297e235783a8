// Rows of work that two builds of the library do in turns. Each family of rows is a module, which is loaded
// once for each build, with a copy of everything that it needs: so what passes between it and the program is
// C.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bench {

using Run = std::function<void()>; // does the work of a row once
struct Row {
    std::string name;
    std::function<Run()> prepare;
};

// Each module defines its own. The folder is the one that bench_write_cases wrote.
std::vector<Row> make_rows(const std::string &folder);

} // namespace bench

extern "C" {
using bench_open_function = int64_t(const char *folder); // makes the rows, and says how many there are
using bench_name_function = const char *(int64_t row);
using bench_prepare_function = void(int64_t row); // the row that bench_run() does from now on
using bench_run_function = void(int64_t times);

bench_open_function bench_open;
bench_name_function bench_name;
bench_prepare_function bench_prepare;
bench_run_function bench_run;
}

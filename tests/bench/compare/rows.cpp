#include "bench/compare/rows.h"

namespace {

std::vector<bench::Row> rows;
bench::Run current;

const bench::Row &row_at(int64_t row) {
    return rows.at(static_cast<size_t>(row));
}

} // namespace

int64_t bench_open(const char *folder) {
    rows = bench::make_rows(folder);
    return std::ssize(rows);
}

const char *bench_name(int64_t row) {
    return row_at(row).name.c_str();
}

void bench_prepare(int64_t row) {
    current = nullptr; // frees what the last row held before more is made
    current = row_at(row).prepare();
}

void bench_run(int64_t times) {
    for (; times > 0; --times) {
        current();
    }
}

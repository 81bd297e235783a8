// SPDX-License-Identifier: MIT
#include "rows.h"

#include <array>
#include <chrono>
#include <cstdio>

namespace ends {

using Clock = std::chrono::steady_clock;

namespace {
std::vector<Row> rows;
} // namespace

double seconds(const std::function<void()> &call) {
    const auto start = Clock::now();
    call();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Found told(double time, const char *format, double a, double b) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), format, a, b); // NOLINT: a constant of this file
    return {time, text.data()};
}

Found called(const std::function<nurbs_status()> &call) {
    nurbs_status status = NURBS_OK;
    const double time = seconds([&] { status = call(); });
    return {time, nurbs_status_name(status)};
}
Found made(const std::function<nurbs_status(nurbs **)> &call) {
    nurbs *out = nullptr;
    Found found = called([&] { return call(&out); });
    nurbs_destroy(out);
    return found;
}

const std::vector<Row> &all_rows() {
    return rows;
}

void row(std::string name, double limit, std::function<Found()> run) {
    rows.push_back({std::move(name), limit, std::move(run)});
}
std::string numbered(const char *name, int64_t number) {
    return std::string(name) + std::to_string(number);
}

} // namespace ends

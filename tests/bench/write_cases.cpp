// Writes the data of every job to a folder, and jobs.json, the list of them.
#include "bench/make_case.h"

#include <fstream>
#include <iostream>

namespace {

const char *group_name(bench::Group group) {
    switch (group) {
    case bench::Group::main:
        return "main";
    case bench::Group::variants:
        return "variants";
    case bench::Group::points:
        return "points";
    }
    return "";
}

void write_list(const std::filesystem::path &path) {
    std::ofstream out(path);
    const char *separator = "[\n";
    for (const bench::Job &job : bench::jobs()) {
        out << separator << R"({"name": ")" << job.name << R"(", "title": ")" << job.title
            << R"(", "group": ")" << group_name(job.group) << R"(", "target": )" << job.target
            << R"(, "order": )" << job.order << R"(, "normal": )" << (job.normal ? "true" : "false") << "}";
        separator = ",\n";
    }
    out << "\n]\n";
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        std::cerr << "usage: bench_write_cases FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    for (const bench::Job &job : bench::jobs()) {
        bench::write(bench::make_case(job), folder / (job.name + ".case"));
    }
    write_list(folder / "jobs.json");
}

/* SPDX-License-Identifier: MIT */
// Records the outputs of many calls, so that two builds of the library can be compared bit for bit.
#include "recorded/batteries/batteries.h"
#include "recorded/sections.h"

#include "check.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <stdexcept>

#include <unistd.h>

namespace {

constexpr const char *usage = R"(usage: record_outputs [OPTION...] FILE

Writes a line for every output of every function in every section: section, function, output, calls, hash.
  --quick            a part of everything
  --again            asks every handle twice, and records the second answers
  --sections REGEX   only these
  --values REGEX     writes all values of these functions too: section, function, output, =, values
Real files are looked for in the folder that the environment variable NURBS_TEST_DATA names.
)";

struct Choice {
    recorded::Plan plan;
    std::string file;
};

// Takes the option's value, if it has one, from the rest of the arguments.
void read_option(const std::string &option, std::span<char *> &rest, Choice &choice) {
    const auto value = [&] {
        if (rest.empty()) {
            throw std::runtime_error(option + " lacks its value");
        }
        const std::string text = rest.front();
        rest = rest.subspan(1);
        return text;
    };
    if (option == "--values") {
        choice.plan.values = std::regex(value());
    } else if (option == "--sections") {
        choice.plan.sections = std::regex(value());
    } else if (option == "--quick") {
        choice.plan.quick = true;
    } else if (option == "--again") {
        choice.plan.again = true;
    } else if (option.starts_with("-") || !choice.file.empty()) {
        throw std::runtime_error(usage);
    } else {
        choice.file = option;
    }
}

Choice read_arguments(std::span<char *> arguments) {
    Choice choice;
    while (!arguments.empty()) {
        const std::string option = arguments.front();
        arguments = arguments.subspan(1);
        read_option(option, arguments, choice);
    }
    if (choice.file.empty()) {
        throw std::runtime_error(usage);
    }
    return choice;
}

// Several of these programs run at once.
std::string own_file() {
    const std::string name = "record_outputs." + std::to_string(getpid()) + ".igs";
    return (std::filesystem::temp_directory_path() / name).string();
}

void run(Choice choice) {
    std::ofstream out(choice.file);
    choice.plan.out = &out;
    recorded::record.start(choice.plan);
    recorded::record_everything(NURBS_SOURCE_DIR, std::getenv("NURBS_TEST_DATA"), own_file());
    out.close();
    if (!out) {
        throw std::runtime_error("cannot write " + choice.file);
    }
}

} // namespace

int main(int count, char **arguments) {
    try {
        run(read_arguments(std::span(arguments, static_cast<size_t>(count)).subspan(1)));
    } catch (const std::exception &error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
    return check_failures == 0 ? 0 : 1;
}

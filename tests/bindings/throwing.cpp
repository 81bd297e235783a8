// SPDX-License-Identifier: MIT
// The file with exceptions that results.cpp is linked with.
#include "expect.hpp"

bool other_files_throw();

bool other_files_throw() {
    return status_of([] { (void)libnurbs::circle({}, -1); }) == libnurbs::Status::length &&
           libnurbs::circle({}, 1).count(0) == 9;
}

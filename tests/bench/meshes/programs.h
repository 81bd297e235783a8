// SPDX-License-Identifier: MIT
// What each library has to do, and the arguments of its program.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace bench::meshes {

// Both tell one line for the driver.
void mesh_shape(const std::string &name, double chord, const char *path);
void mesh_file(const std::string &path, double chord);

inline int run(int count, char **arguments) {
    if (count < 3 || count > 4) {
        std::fprintf(stderr, "usage: %s SHAPE|FILE CHORD [MESH]\n", arguments[0]);
        return 2;
    }
    const std::string what = arguments[1];
    const double chord = std::strtod(arguments[2], nullptr);
    if (what.find('.') == std::string::npos) {
        mesh_shape(what, chord, count == 4 ? arguments[3] : nullptr);
    } else {
        mesh_file(what, chord);
    }
    return 0;
}

inline bool is_iges(const std::string &path) {
    return path.ends_with(".igs") || path.ends_with(".iges");
}

} // namespace bench::meshes

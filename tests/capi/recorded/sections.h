/* SPDX-License-Identifier: MIT */
// Everything that is recorded, in its sections: good calls of every function, and batteries of calls for many
// splines.
#ifndef NURBS_TESTS_CAPI_RECORDED_SECTIONS_H
#define NURBS_TESTS_CAPI_RECORDED_SECTIONS_H

#include <string>

namespace recorded {

// The calls of the other tests; the file that some of them read is written to a path.
void record_calls(const std::string &path);
// Shapes by their names, with many sizes.
void record_constructors();
// The shapes that good calls make.
void record_shapes();
// Random splines of every kind.
void record_made();
// Some with a negative weight and a point at infinity.
void record_homogeneous();
// The splines of the golden values, in the project's folder.
void record_golden(const std::string &top);
// The splines of the files of a folder that nurbs_read_file() reads.
void record_files(const std::string &folder);

// All of these; without a folder of files none, nor in a quick run.
void record_everything(const std::string &top, const char *folder, const std::string &path);

} // namespace recorded

#endif

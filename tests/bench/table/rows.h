// SPDX-License-Identifier: MIT
// Pairs of jobs, the same work by this library and by another one, measured by turns in one process: what counts is the
// ratio of their times.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Row {
    std::string job, peer;
    double work; // points, or calls, of one run
    std::function<void()> ours, theirs;
    std::function<double()> difference; // of the results, relative; none: nothing to compare
};

class Rows {
public:
    void add(Row row) { rows_.push_back(std::move(row)); }
    // Prints a table of those whose job contains the word; returns whether all results agree.
    bool measure(const std::string &word, double seconds) const;

private:
    std::vector<Row> rows_;
};

void add_points(Rows &rows);
void add_first_calls(Rows &rows);
void add_forms(Rows &rows);
void add_operations(Rows &rows);
void add_fits(Rows &rows);
void add_faces(Rows &rows);
void add_meets(Rows &rows);

} // namespace bench

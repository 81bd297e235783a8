// What is measured: one list that every program, and the table, follows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

enum class Params { random, sorted, grid, single }; // single: one call for each of few random parameters
enum class Group { main, variants, points };        // main: compared with other libraries and with a target

struct Job {
    std::string name;
    std::string title;
    double target; // ns per point; 0: none
    int axes;
    int degree;
    int64_t count; // control points along each axis
    Params params = Params::random;
    int order = 0;       // of the derivatives
    bool normal = false; // and the unit normal, for surfaces
    int dim = 3;
    bool rational = true;
    Group group = Group::main;

    // Vectors of `dim` numbers in the result for one point: partial derivatives in the order of
    // nurbs_eval_derivs(), then the normal.
    [[nodiscard]] int derivative_slots() const;
    [[nodiscard]] int vectors() const { return derivative_slots() + (normal ? 1 : 0); }
};

const std::vector<Job> &jobs();
const Job &job_named(const std::string &name);

} // namespace bench

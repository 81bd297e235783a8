#include "bench/jobs.h"

#include <algorithm>
#include <stdexcept>

namespace bench {

int Job::derivative_slots() const {
    int slots = 1;
    for (int k = 1; k <= axes; ++k) {
        slots = slots * (order + k) / k;
    }
    return slots;
}

namespace {

Job curve(const std::string &name, const std::string &title, double target, int degree) {
    return {.name = name, .title = title, .target = target, .axes = 1, .degree = degree, .count = 100};
}

Job surface(const std::string &name, const std::string &title, double target, int degree) {
    return {.name = name, .title = title, .target = target, .axes = 2, .degree = degree, .count = 20};
}

Job derivatives(Job job, int order, bool normal = false) {
    job.order = order;
    job.normal = normal;
    return job;
}

Job at(Job job, Params params) {
    job.params = params;
    return job;
}

Job variant(const std::string &name, const std::string &title, int dim, bool rational) {
    Job job = curve(name, title, 0, 3);
    job.dim = dim;
    job.rational = rational;
    job.group = Group::variants;
    return job;
}

Job with_points(const std::string &name, const std::string &title, int64_t count) {
    Job job = curve(name, title, 0, 3);
    job.count = count;
    job.group = Group::points;
    return job;
}

std::vector<Job> make_jobs() {
    return {
        curve("curve", "curve, degree 3, random parameters", 4, 3),
        at(curve("curve_sorted", "the same, sorted parameters", 2, 3), Params::sorted),
        derivatives(curve("curve_d1", "point and first derivative", 8, 3), 1),
        derivatives(curve("curve_d2", "point, first and second derivative", 12, 3), 2),
        curve("curve_degree5", "curve, degree 5", 7, 5),
        curve("curve_degree9", "curve, degree 9", 12, 9),
        at(curve("curve_single", "curve, degree 3, one call for each point", 60, 3), Params::single),
        surface("surface", "surface, degree 3, random parameters", 12, 3),
        derivatives(surface("surface_frames", "point, first derivatives, unit normal", 20, 3), 1, true),
        derivatives(surface("surface_d2", "all derivatives to order 2", 40, 3), 2),
        surface("surface_degree5", "surface, degree 5", 25, 5),
        surface("surface_degree9", "surface, degree 9", 60, 9),
        at(surface("grid", "surface, degree 3, grid of 1000 x 1000", 1.5, 3), Params::grid),
        at(derivatives(surface("grid_frames", "grid: point, first derivatives, unit normal", 6, 3), 1, true),
           Params::grid),
        {.name = "volume",
         .title = "volume, degree 3, random parameters",
         .target = 40,
         .axes = 3,
         .degree = 3,
         .count = 10},
        variant("curve_1d", "1D rational", 1, true),
        variant("curve_2d", "2D rational", 2, true),
        variant("curve_3d", "3D rational", 3, true),
        variant("curve_6d", "6D rational", 6, true),
        variant("curve_polynomial", "3D polynomial", 3, false),
        with_points("points_10", "10 control points", 10),
        with_points("points_100", "100 control points", 100),
        with_points("points_1000", "1000 control points", 1000),
        with_points("points_10000", "10000 control points", 10000),
    };
}

} // namespace

const std::vector<Job> &jobs() {
    static const std::vector<Job> all = make_jobs();
    return all;
}

const Job &job_named(const std::string &name) {
    const auto found = std::ranges::find(jobs(), name, &Job::name);
    if (found == jobs().end()) {
        throw std::runtime_error("no job is named " + name);
    }
    return *found;
}

} // namespace bench

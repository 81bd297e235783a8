// SPDX-License-Identifier: MIT
// Fits by this library, through its C interface.     bench_fits_nurbs FOLDER JOB
#include "bench/fits/job.h"

#include <nurbs/nurbs.h>

#include <cmath>
#include <map>

namespace {

using namespace bench::fits;

void good(nurbs_status status) {
    if (status != NURBS_OK) {
        char text[256];
        nurbs_last_error(text, sizeof text);
        std::fprintf(stderr, "%s: %s\n", nurbs_status_name(status), text);
        std::exit(1);
    }
}

struct Data {
    std::vector<double> params, values;
    nurbs_data view{};

    Data(const std::string &folder, const std::string &name, int32_t axes, int32_t dim)
        : params(read(folder, name + "_params")), values(read(folder, name + "_values")) {
        good(nurbs_data_init(&view, sizeof view));
        view.n = static_cast<int64_t>(params.size()) / axes;
        view.axes = axes;
        view.dim = dim;
        view.params = params.data();
        view.values = values.data();
    }
};

// Even knots of the same number of control points on each axis.
struct Space {
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts;
    std::vector<double> knots;

    Space(size_t axes, int64_t count) : degrees(axes, 3), counts(axes, count) {
        std::vector<double> one(static_cast<size_t>(count) + 4);
        good(nurbs_knots_open_uniform(3, count, 0, 1, count + 4, one.data()));
        for (size_t k = 0; k < axes; ++k) {
            knots.insert(knots.end(), one.begin(), one.end());
        }
    }
};

nurbs_fit_report report_of() {
    nurbs_fit_report report{};
    report.struct_size = sizeof report;
    return report;
}

// With or without the largest distance of a point; other libraries do not tell it.
void interpolate(const std::string &folder, const std::string &name, int32_t axes, int64_t count,
                 bool with_residual = false) {
    const std::vector<double> points = read(folder, name);
    const std::vector<int64_t> counts(static_cast<size_t>(axes), count);
    const std::vector<int32_t> degrees(counts.size(), 3);
    std::vector<double> params(static_cast<size_t>(axes * count));
    const auto once = [&](double *residual) {
        nurbs *out = nullptr;
        good(nurbs_parametrize(axes, counts.data(), 3, points.data(), 0, 0, NURBS_PARAMS_CHORD, 0, 0,
                               params.data()));
        good(nurbs_interpolate(axes, degrees.data(), counts.data(), params.data(), 3, points.data(), 0, 0,
                               nullptr, 0, residual, &out));
        nurbs_destroy(out);
    };
    double residual = 0;
    once(&residual);
    const double ms = milliseconds([&] { once(with_residual ? &residual : nullptr); });
    tell(ms, axes == 1 ? count : count * count, residual);
}

nurbs_fit_report fit_once(const Data &data, const Space &space, const nurbs_fit_options *options) {
    nurbs_fit_report report = report_of();
    nurbs *out = nullptr;
    good(nurbs_fit_points(&data.view, space.degrees.data(), space.counts.data(), space.knots.data(),
                          static_cast<int64_t>(space.knots.size()), 0, options, &report, &out));
    nurbs_destroy(out);
    return report;
}

void least_squares(const Data &data, const Space &space, int32_t smoothing = NURBS_SMOOTHING_NONE) {
    nurbs_fit_options options;
    good(nurbs_fit_options_init(&options, sizeof options));
    options.smoothing = smoothing;
    nurbs_fit_report report{};
    const double ms = milliseconds([&] { report = fit_once(data, space, &options); });
    int64_t count = 1;
    for (const int64_t each : space.counts) {
        count *= each;
    }
    tell(ms, count, report.largest);
}

void tolerance(const Data &data, double within) {
    const int32_t cubic = 3;
    nurbs_fit_report report = report_of();
    int64_t count = 0;
    const double ms = milliseconds([&] {
        nurbs *out = nullptr;
        good(nurbs_fit_tolerance(&data.view, &cubic, nullptr, within, 0, 0, nullptr, &report, &out));
        good(nurbs_point_count(out, &count));
        nurbs_destroy(out);
    });
    tell(ms, count, report.largest);
}

void merge(const Data &data, int parts) {
    const int32_t cubic = 3;
    const int64_t break_count = 998;
    std::vector<double> breaks;
    for (int64_t i = 0; i < break_count; ++i) {
        breaks.push_back(static_cast<double>(i) / static_cast<double>(break_count - 1));
    }
    nurbs_statistics *empty = nullptr;
    good(nurbs_statistics_create(1, &cubic, &break_count, breaks.data(), break_count, 3, 4, 1, &empty));
    std::vector<nurbs_statistics *> chunks(static_cast<size_t>(parts));
    for (int i = 0; i < parts; ++i) {
        nurbs_data part = data.view;
        part.n /= parts;
        part.params += i * part.n;
        part.values += 3 * i * part.n;
        good(nurbs_statistics_add(empty, &part, &chunks[static_cast<size_t>(i)]));
    }
    tell(milliseconds([&] {
        nurbs_statistics *sum = nullptr;
        good(nurbs_statistics_merge(parts, chunks.data(), nullptr, &sum));
        nurbs_statistics_destroy(sum);
    }));
    for (nurbs_statistics *chunk : chunks) {
        nurbs_statistics_destroy(chunk);
    }
    nurbs_statistics_destroy(empty);
}

// The most memory that this process has had, in MB. getrusage() would count what its parent had.
double most_memory() {
    std::ifstream file("/proc/self/status");
    std::string word;
    double kilobytes = 0;
    while (file >> word && word != "VmHWM:") {
    }
    file >> kilobytes;
    return kilobytes / 1024;
}

// The memory of one fit beyond that of the data, in MB, in the place of milliseconds.
void memory(const Data &data, const Space &space) {
    const double before = most_memory();
    (void)fit_once(data, space, nullptr);
    tell(most_memory() - before);
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: bench_fits_nurbs FOLDER JOB\n");
        return 2;
    }
    const std::string folder = argv[1], job = argv[2];
    const std::map<std::string, std::function<void()>> jobs{
        {"curve_1e3", [&] { interpolate(folder, "spiral_1000", 1, 1000); }},
        {"curve_1e5", [&] { interpolate(folder, "spiral_100000", 1, 100000); }},
        {"residual_1e5", [&] { interpolate(folder, "spiral_100000", 1, 100000, true); }},
        {"surface_100", [&] { interpolate(folder, "heights_100", 2, 100); }},
        {"surface_300", [&] { interpolate(folder, "heights_300", 2, 300); }},
        {"lsq_1e5",
         [&] {
             least_squares({folder, "noisy_100000", 1, 3}, {1, 1000});
         }},
        {"lsq_1e7",
         [&] {
             least_squares({folder, "noisy_10000000", 1, 3}, {1, 1000});
         }},
        {"merge_100",
         [&] {
             merge({folder, "noisy_1000000", 1, 3}, 100);
         }},
        {"tolerance_1e5",
         [&] {
             tolerance({folder, "flower_100000", 1, 3}, 1e-4);
         }},
        {"gcv_1e3",
         [&] {
             least_squares({folder, "wave_1000", 1, 1}, {1, 1000}, NURBS_SMOOTHING_GCV);
         }},
        {"gcv_1e5",
         [&] {
             least_squares({folder, "wave_100000", 1, 1}, {1, 1000}, NURBS_SMOOTHING_GCV);
         }},
        {"scattered_1e5_30",
         [&] {
             least_squares({folder, "scattered_100000", 2, 1}, {2, 30});
         }},
        {"scattered_1e6_100",
         [&] {
             least_squares({folder, "scattered_1000000", 2, 1}, {2, 100});
         }},
        {"growth_1e3",
         [&] {
             least_squares({folder, "noisy_1000", 1, 3}, {1, 100});
         }},
        {"growth_1e4",
         [&] {
             least_squares({folder, "noisy_10000", 1, 3}, {1, 100});
         }},
        {"growth_1e5",
         [&] {
             least_squares({folder, "noisy_100000", 1, 3}, {1, 100});
         }},
        {"growth_1e6",
         [&] {
             least_squares({folder, "noisy_1000000", 1, 3}, {1, 100});
         }},
        {"growth_1e7",
         [&] {
             least_squares({folder, "noisy_10000000", 1, 3}, {1, 100});
         }},
        {"memory_1e7",
         [&] {
             memory({folder, "noisy_10000000", 1, 3}, {1, 1000});
         }},
    };
    const auto found = jobs.find(job);
    if (found == jobs.end()) {
        return 77;
    }
    found->second();
    return 0;
}

// Points and derivatives, and what a new handle costs.
#include "bench/compare/rows.h"
#include "bench/nurbs_work.h"
#include "support/handle.h"

namespace bench {

namespace {

struct Prepared {
    Case data;
    Output output;
    Work work;
};

Run job_run(const Job &job, const std::string &folder) {
    const auto all = std::make_shared<Prepared>();
    all->data = read(folder + "/" + job.name + ".case");
    all->output = packed_output(job, all->data);
    all->work = nurbs_work(job, all->data, all->output);
    return [all] { all->work(); };
}

// What is asked of a new spline is little, so it is asked of many.
Run fresh_run(const Case &data, int64_t points) {
    return [data, points, out = std::vector<double>(1000)]() mutable {
        for (int i = 0; i < 100; ++i) {
            const support::Handle g = support::create(data.spline);
            support::require_ok(nurbs_eval(g.get(), points, data.params.data(), 0, 0, out.data(), 0, 0, 0));
        }
    };
}

} // namespace

std::vector<Row> make_rows(const std::string &folder) {
    std::vector<Row> rows;
    for (const Job &job : jobs()) {
        rows.push_back({job.name, [&job, folder] { return job_run(job, folder); }});
    }
    for (const std::string name : {"curve", "surface"}) {
        for (const int64_t points : {1, 16}) {
            rows.push_back({name + "_fresh_" + std::to_string(points), [name, points, folder] {
                                return fresh_run(read(folder + "/" + name + ".case"), points);
                            }});
        }
    }
    return rows;
}

} // namespace bench

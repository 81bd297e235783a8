#include "bench/compare/rows.h"
#include "bench/operations/nurbs_work.h"

namespace bench {

std::vector<Row> make_rows(const std::string & /*folder*/) {
    std::vector<Row> rows;
    for (const Task &task : tasks()) {
        rows.push_back({task.name, [&task] { return nurbs_work(task).run; }});
    }
    return rows;
}

} // namespace bench

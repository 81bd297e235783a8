#include "bench/compare/rows.h"
#include "bench/queries/nurbs_work.h"

namespace bench {

std::vector<Row> make_rows(const std::string & /*folder*/) {
    std::vector<Row> rows;
    for (const Question &question : questions()) {
        rows.push_back({question.name, [&question] { return Run([ask = nurbs_ask(question)] { ask(); }); }});
    }
    return rows;
}

} // namespace bench

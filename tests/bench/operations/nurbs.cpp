// libnurbs, through its C API.
#include "bench/operations/task.h"
#include "support/handle.h"

namespace {

using namespace bench;
using support::Handle;
using support::SplineData;
using Curve = std::shared_ptr<nurbs>;
using List = std::unique_ptr<nurbs_list, decltype(&nurbs_list_destroy)>;
using Unary = std::function<nurbs *(const nurbs *)>;

Work unary(const Task &task, const Unary &operation) {
    const Curve curve = support::create(task.inputs[0]);
    return {
        [=] { nurbs_destroy(operation(curve.get())); },
        [=] { return std::vector<SplineData>{support::read_back(Handle(operation(curve.get())).get())}; }};
}

nurbs *refined(const nurbs *g, const std::vector<double> &knots) {
    nurbs *out = nullptr;
    support::require_ok(nurbs_refine(g, 0, std::ssize(knots), knots.data(), &out));
    return out;
}

nurbs *elevated(const nurbs *g) {
    nurbs *out = nullptr;
    support::require_ok(nurbs_elevate(g, 0, 1, &out));
    return out;
}

List decomposed(const nurbs *g) {
    nurbs_list *list = nullptr;
    support::require_ok(nurbs_decompose(g, &list));
    return {list, nurbs_list_destroy};
}

std::vector<SplineData> items(const List &list) {
    int64_t count = 0;
    support::require_ok(nurbs_list_count(list.get(), &count));
    std::vector<SplineData> results;
    for (int64_t i = 0; i < count; ++i) {
        nurbs *item = nullptr;
        support::require_ok(nurbs_list_get(list.get(), i, &item));
        results.push_back(support::read_back(Handle(item).get()));
    }
    return results;
}

Work decompose_work(const Task &task) {
    const Curve curve = support::create(task.inputs[0]);
    return {[=] { decomposed(curve.get()); }, [=] { return items(decomposed(curve.get())); }};
}

Work prepare(const Task &task) {
    switch (task.operation) {
    case Operation::refine:
        return unary(task, [knots = task.knots](const nurbs *g) { return refined(g, knots); });
    case Operation::elevate:
        return unary(task, elevated);
    case Operation::decompose:
        return decompose_work(task);
    case Operation::remove:
    case Operation::compatible:
        break;
    }
    return {};
}

} // namespace

int main(int argc, char **argv) {
    return bench::run(argc, argv, "libnurbs", prepare);
}

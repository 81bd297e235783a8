#include "bench/operations/task.h"

#include "support/handle.h"

#include <algorithm>
#include <random>

namespace bench {

namespace {

using support::SplineData;

class Generator {
public:
    explicit Generator(uint64_t seed) : engine_(seed) {}

    double uniform(double lower, double upper) {
        return std::uniform_real_distribution<double>(lower, upper)(engine_);
    }
    std::vector<double> sorted(int64_t count) {
        std::vector<double> values(static_cast<size_t>(count));
        std::ranges::generate(values, [this] { return uniform(0, 1); });
        std::ranges::sort(values);
        return values;
    }
    // A clamped cubic over [0, 1] with simple inner knots, weights from 1/2 to 2.
    SplineData cubic(int64_t count, const std::vector<double> &inner) {
        SplineData data{
            .degrees = {3}, .counts = {count}, .knots = {{}}, .dim = 3, .points = {}, .weights = {}};
        std::vector<double> &knots = data.knots[0];
        knots.assign(4, 0.0);
        knots.insert(knots.end(), inner.begin(), inner.end());
        knots.insert(knots.end(), 4, 1.0);
        for (int64_t i = 0; i < count; ++i) {
            for (int c = 0; c < 3; ++c) {
                data.points.push_back(uniform(-1, 1));
            }
            data.weights.push_back(uniform(0.5, 2));
        }
        return data;
    }
    SplineData cubic(int64_t count) { return cubic(count, sorted(count - 4)); }

private:
    std::mt19937_64 engine_;
};

SplineData refined(const SplineData &data, const std::vector<double> &knots) {
    nurbs *out = nullptr;
    support::require_ok(nurbs_refine(support::create(data).get(), 0, std::ssize(knots), knots.data(), &out));
    return support::read_back(support::Handle(out).get());
}

Task refine_task(Generator &random) {
    return {"refine",
            "insert 1000 knots into a curve of 100 points",
            Operation::refine,
            {random.cubic(100)},
            random.sorted(1000)};
}

Task remove_task(Generator &random) {
    const std::vector<double> knots = random.sorted(500);
    return {"remove",
            "remove 500 knots that were inserted, 600 points left",
            Operation::remove,
            {refined(random.cubic(600), knots)},
            knots,
            1e-9};
}

// Pairs share no inner knots.
Task compatible_task(Generator &random) {
    Task task{"compatible", "make 50 curves of 20 points compatible", Operation::compatible, {}, {}};
    for (int i = 0; i < 50; ++i) {
        task.inputs.push_back(random.cubic(20));
    }
    return task;
}

std::vector<Task> make_tasks() {
    Generator random(20261121);
    std::vector<Task> list{refine_task(random)};
    list.push_back(
        {"elevate", "elevate a curve of 1000 points", Operation::elevate, {random.cubic(1000)}, {}});
    list.push_back(
        {"decompose", "decompose a curve of 1000 points", Operation::decompose, {list.back().inputs[0]}, {}});
    list.push_back(remove_task(random));
    list.push_back(compatible_task(random));
    for (const int64_t count : {1000, 10'000, 100'000, 1'000'000}) {
        const SplineData data = random.cubic(count);
        const std::string size = "_" + std::to_string(count);
        list.push_back({"refine" + size, "", Operation::refine, {data}, random.sorted(count), 0, true});
        list.push_back({"elevate" + size, "", Operation::elevate, {data}, {}, 0, true});
        list.push_back({"decompose" + size, "", Operation::decompose, {data}, {}, 0, true});
    }
    return list;
}

} // namespace

const std::vector<Task> &tasks() {
    static const std::vector<Task> list = make_tasks();
    return list;
}

} // namespace bench

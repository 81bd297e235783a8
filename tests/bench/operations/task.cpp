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
    // A polynomial cubic Bezier curve with given ends.
    SplineData bezier(const std::vector<double> &first, const std::vector<double> &last) {
        SplineData data = cubic(4);
        data.weights.clear();
        std::ranges::copy(first, data.points.begin());
        std::ranges::copy(last, data.points.end() - 3);
        return data;
    }

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

// The polynomial Bezier curves are where the surfaces of all libraries are the same.
Task coons_task(Generator &random) {
    const std::vector<double> corners[4] = {{0, 0, 0.1}, {0, 1, -0.2}, {1, 0, 0.3}, {1, 1, 0}};
    return {"coons",
            "fill four cubic Bezier curves by Coons' rule",
            Operation::coons,
            {random.bezier(corners[0], corners[1]), random.bezier(corners[2], corners[3]),
             random.bezier(corners[0], corners[2]), random.bezier(corners[1], corners[3])},
            {}};
}

void add_shapes(std::vector<Task> &list, Generator &random) {
    list.push_back({"circle", "a circle in space as a spline", Operation::circle, {}, {}});
    list.push_back(
        {"revolve", "turn a curve of 100 points fully", Operation::revolve, {random.cubic(100)}, {}});
    list.push_back({"ruled",
                    "rule between two curves of 100 points",
                    Operation::ruled,
                    {random.cubic(100), random.cubic(100)},
                    {}});
    list.push_back(coons_task(random));
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
    add_shapes(list, random);
    return list;
}

} // namespace

const std::vector<Task> &tasks() {
    static const std::vector<Task> list = make_tasks();
    return list;
}

} // namespace bench

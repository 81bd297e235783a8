#include "bench/case.h"

#include <fstream>

namespace bench {

namespace {

template <class T>
void put(std::ostream &out, const std::vector<T> &values) {
    static_assert(sizeof(T) == 8);
    const auto length = static_cast<int64_t>(values.size());
    out.write(reinterpret_cast<const char *>(&length), sizeof length);
    out.write(reinterpret_cast<const char *>(values.data()), length * 8);
}

template <class T>
std::vector<T> get(std::istream &in) {
    int64_t length = 0;
    in.read(reinterpret_cast<char *>(&length), sizeof length);
    std::vector<T> values(static_cast<size_t>(length));
    in.read(reinterpret_cast<char *>(values.data()), length * 8);
    return values;
}

std::vector<std::vector<double>> split_knots(const std::vector<double> &all,
                                             const support::SplineData &spline) {
    std::vector<std::vector<double>> result;
    auto from = all.begin();
    for (size_t k = 0; k < spline.degrees.size(); ++k) {
        const auto to = from + spline.counts[k] + spline.degrees[k] + 1;
        result.emplace_back(from, to);
        from = to;
    }
    return result;
}

} // namespace

int64_t Case::points() const {
    return grid.empty() ? static_cast<int64_t>(params.size()) / spline.axes() : grid[0] * grid[1];
}

void write(const Case &data, const std::filesystem::path &path) {
    std::ofstream out(path, std::ios::binary);
    out.exceptions(std::ios::failbit | std::ios::badbit);
    put(out, std::vector<int64_t>(data.spline.degrees.begin(), data.spline.degrees.end()));
    put(out, data.spline.counts);
    put(out, std::vector<int64_t>{data.spline.dim});
    put(out, data.grid);
    put(out, data.sample);
    for (const auto &values : {data.spline.all_knots(), data.spline.points, data.spline.weights, data.params,
                               data.expected, data.bounds}) {
        put(out, values);
    }
}

Case read(const std::filesystem::path &path) {
    std::ifstream in(path, std::ios::binary);
    in.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    Case data;
    for (const int64_t degree : get<int64_t>(in)) {
        data.spline.degrees.push_back(static_cast<int32_t>(degree));
    }
    data.spline.counts = get<int64_t>(in);
    data.spline.dim = static_cast<int32_t>(get<int64_t>(in).at(0));
    data.grid = get<int64_t>(in);
    data.sample = get<int64_t>(in);
    data.spline.knots = split_knots(get<double>(in), data.spline);
    for (auto *values :
         {&data.spline.points, &data.spline.weights, &data.params, &data.expected, &data.bounds}) {
        *values = get<double>(in);
    }
    return data;
}

} // namespace bench

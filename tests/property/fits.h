// Fits and statistics of data for tests.
#pragma once

#include "property/products.h"

#include <memory>
#include <numeric>

namespace support::fits {

struct DestroyStatistics {
    void operator()(nurbs_statistics *s) const noexcept { nurbs_statistics_destroy(s); }
};
using Statistics = std::unique_ptr<nurbs_statistics, DestroyStatistics>;

template <class Call>
Statistics made_statistics(Call &&call) {
    nurbs_statistics *out = nullptr;
    require_ok(call(&out));
    return Statistics(out);
}

// Data of any number of axes, packed.
struct Sample {
    int32_t axes = 1, dim = 1;
    std::vector<double> params, values, weights;

    [[nodiscard]] int64_t size() const { return std::ssize(params) / axes; }
    [[nodiscard]] nurbs_data view(uint32_t flags = 0) const {
        nurbs_data data;
        require_ok(nurbs_data_init(&data, sizeof data));
        data.n = size();
        data.axes = axes;
        data.dim = dim;
        data.params = params.data();
        data.values = values.data();
        data.weights = weights.empty() ? nullptr : weights.data();
        data.flags = flags;
        return data;
    }
    // Those of the indices, in their order.
    [[nodiscard]] Sample part(const std::vector<size_t> &indices) const {
        Sample some{axes, dim, {}, {}, {}};
        for (const size_t i : indices) {
            const auto append = [i](const std::vector<double> &from, int32_t width, std::vector<double> &to) {
                const auto first = from.begin() + static_cast<int64_t>(i) * width;
                to.insert(to.end(), first, first + width);
            };
            append(params, axes, some.params);
            append(values, dim, some.values);
            if (!weights.empty()) {
                append(weights, 1, some.weights);
            }
        }
        return some;
    }
};

inline std::vector<size_t> permutation(Random &random, size_t size) {
    std::vector<size_t> order(size);
    std::iota(order.begin(), order.end(), size_t{0});
    for (size_t i = size; i > 1; --i) {
        std::swap(order[i - 1], order[random.bits() % i]);
    }
    return order;
}

inline std::vector<unsigned char> bytes_of(const Statistics &statistics) {
    int64_t size = 0;
    require_ok(nurbs_statistics_to_bytes(statistics.get(), 0, nullptr, &size));
    std::vector<unsigned char> bytes(static_cast<size_t>(size));
    require_ok(nurbs_statistics_to_bytes(statistics.get(), size, bytes.data(), nullptr));
    return bytes;
}

// What nurbs_fit_points() takes besides the data, from a spline whose knots are meant.
struct Fit {
    SplineData over;
    nurbs_fit_options options{};
    nurbs_fit_report report{};

    explicit Fit(SplineData knots) : over(std::move(knots)) {
        require_ok(nurbs_fit_options_init(&options, sizeof options));
        report.struct_size = sizeof report;
    }
    nurbs_status run(const Sample &sample, Handle &out, uint32_t flags = 0) {
        const auto knots = over.all_knots();
        const nurbs_data data = sample.view(flags);
        nurbs *made = nullptr;
        const nurbs_status status =
            nurbs_fit_points(&data, over.degrees.data(), over.counts.data(), knots.data(), std::ssize(knots),
                             over.flags, &options, &report, &made);
        out.reset(made);
        return status;
    }
    Handle operator()(const Sample &sample) {
        Handle out;
        require_ok(run(sample, out));
        return out;
    }
    Handle operator()(const Statistics &statistics) {
        const auto knots = over.all_knots();
        return made([&](nurbs **out) {
            return nurbs_fit(statistics.get(), over.degrees.data(), over.counts.data(), knots.data(),
                             std::ssize(knots), over.flags, &options, &report, out);
        });
    }
};

// A clamped curve over even knots from 0 to 1, whose points are 0.
inline SplineData even_curve(int degree, int64_t count, int32_t dim = 1) {
    std::vector<double> knots(static_cast<size_t>(count + degree + 1));
    require_ok(nurbs_knots_open_uniform(degree, count, 0, 1, std::ssize(knots), knots.data()));
    const std::vector<double> points(static_cast<size_t>(count * dim), 0.0);
    return read_back(made([&](nurbs **out) {
                         return nurbs_create(1, &degree, &count, knots.data(), std::ssize(knots), dim,
                                             points.data(), 0, 0, nullptr, 0, 0, out);
                     }).get());
}

} // namespace support::fits

// Statistics of data: sums that do not depend on order or partition, bit for bit.
#include "property/fits.h"

namespace statistics_test {

using namespace support;
using namespace support::fits;

namespace {

struct Cells {
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts;
    std::vector<double> breaks;
};

Cells random_cells(Random &random, int axes) {
    Cells cells;
    for (int k = 0; k < axes; ++k) {
        cells.degrees.push_back(random.whole(0, axes == 1 ? 31 : axes == 2 ? 4 : 2));
        cells.counts.push_back(random.whole(2, axes == 1 ? 40 : 6));
        double t = random.between(-1, 1);
        for (int64_t i = 0; i < cells.counts.back(); ++i, t += random.magnitude(0.01, 1)) {
            cells.breaks.push_back(t);
        }
    }
    return cells;
}

Statistics empty(const Cells &cells, int32_t dim, double value_scale, double weight_scale) {
    return made_statistics([&](nurbs_statistics **out) {
        return nurbs_statistics_create(static_cast<int32_t>(cells.degrees.size()), cells.degrees.data(),
                                       cells.counts.data(), cells.breaks.data(), std::ssize(cells.breaks),
                                       dim, value_scale, weight_scale, out);
    });
}

Statistics with(const Statistics &statistics, const Sample &sample, uint32_t flags = 0) {
    const nurbs_data data = sample.view(flags);
    return made_statistics(
        [&](nurbs_statistics **out) { return nurbs_statistics_add(statistics.get(), &data, out); });
}

Statistics merged(const std::vector<const nurbs_statistics *> &parts,
                  const std::vector<int32_t> &signs = {}) {
    return made_statistics([&](nurbs_statistics **out) {
        return nurbs_statistics_merge(std::ssize(parts), parts.data(), signs.empty() ? nullptr : signs.data(),
                                      out);
    });
}

Sample random_sample(Random &random, const Cells &cells, int32_t dim, size_t size) {
    Sample sample{static_cast<int32_t>(cells.degrees.size()), dim, {}, {}, {}};
    for (size_t i = 0; i < size; ++i) {
        auto first = cells.breaks.begin();
        for (const int64_t count : cells.counts) {
            const bool at_break = random.chance(10);
            sample.params.push_back(
                at_break ? first[static_cast<int64_t>(random.bits() % static_cast<size_t>(count))]
                         : random.between(first[0], first[count - 1]));
            first += count;
        }
        for (int c = 0; c < dim; ++c) {
            sample.values.push_back(random.chance(20) ? random.magnitude(1e-12, 1) : random.between(-1, 1));
        }
        sample.weights.push_back(random.chance(10) ? 0 : random.magnitude(1e-6, 1));
    }
    if (random.chance(50)) {
        sample.weights.clear();
    }
    return sample;
}

} // namespace

TEST(Statistics, are_the_same_bits_in_any_order_and_partition) {
    for_each_case(895000, 60, [](Random &random, uint64_t seed) {
        const Cells cells = random_cells(random, random.whole(1, 3));
        const int32_t dim = random.whole(1, 3);
        const Statistics none = empty(cells, dim, 1, random.chance(50) ? 1 : 4);
        const size_t size = static_cast<size_t>(random.whole(1, 600));
        const Sample sample = random_sample(random, cells, dim, size);
        const Statistics all = with(none, sample);
        const auto order = permutation(random, size);
        // Chunks of any lengths, none too, merged pairwise in any order.
        std::vector<Statistics> parts;
        for (size_t first = 0; first < size;) {
            const size_t end = std::min(size, first + random.bits() % (size / 3 + 2));
            parts.push_back(with(none, sample.part({order.begin() + static_cast<int64_t>(first),
                                                    order.begin() + static_cast<int64_t>(end)})));
            first = end;
        }
        const Statistics kept = merged({parts[0].get()});
        std::vector<const nurbs_statistics *> every;
        for (const Statistics &part : parts) {
            every.push_back(part.get());
        }
        ASSERT_EQ(bytes_of(merged(every)), bytes_of(all)) << "seed " << seed;
        const Statistics rest = merged({all.get(), kept.get()}, {1, -1});
        while (parts.size() > 2) {
            const size_t i = random.bits() % (parts.size() - 1);
            parts[i] = merged({parts[i].get(), parts.back().get()});
            parts.pop_back();
        }
        if (parts.size() == 2) {
            parts[0] = merged({parts[0].get(), parts[1].get()});
        }
        ASSERT_EQ(bytes_of(parts[0]), bytes_of(all)) << "seed " << seed;
        ASSERT_EQ(bytes_of(merged({rest.get(), kept.get()})), bytes_of(all)) << "seed " << seed;
        ASSERT_EQ(bytes_of(merged({all.get(), all.get()}, {1, -1})), bytes_of(none)) << "seed " << seed;
    });
}

// More than 128 bits have room for, in one cell.
TEST(Statistics, do_not_overflow) {
    const Cells cells{{2}, {2}, {0, 1}};
    const Statistics none = empty(cells, 1, 1, 1);
    Sample sample;
    sample.params.assign(20000, 0.5);
    sample.values.assign(20000, -1.0);
    const Statistics all = with(none, sample);
    sample.weights.assign(20000, 1.0);
    const Statistics weighted = with(none, sample);
    EXPECT_EQ(bytes_of(all), bytes_of(weighted));
    int64_t count = 0;
    double weight = 0;
    require_ok(nurbs_statistics_size(all.get(), nullptr, nullptr, &count, nullptr, &weight));
    EXPECT_EQ(count, 20000);
    EXPECT_EQ(weight, 20000);
    Statistics sum = merged({all.get(), all.get()});
    for (int i = 0; i < 20; ++i) {
        sum = merged({sum.get(), sum.get()});
    }
    require_ok(nurbs_statistics_size(sum.get(), nullptr, nullptr, &count, nullptr, &weight));
    EXPECT_EQ(weight, 20000 * std::exp2(21));
    Fit fit(even_curve(0, 1));
    fit.over.degrees[0] = 0;
    EXPECT_EQ(read_back(fit(sum).get()).points[0], -1);
}

TEST(Statistics, survive_bytes) {
    for_each_case(896000, 40, [](Random &random, uint64_t seed) {
        const Cells cells = random_cells(random, random.whole(1, 3));
        const Statistics none = empty(cells, 2, 1, 1);
        const Statistics all = with(none, random_sample(random, cells, 2, 50));
        const auto bytes = bytes_of(all);
        const auto read = [](const std::vector<unsigned char> &from, nurbs_statistics **out) {
            return nurbs_statistics_from_bytes(from.data(), std::ssize(from), out);
        };
        const Statistics back = made_statistics([&](nurbs_statistics **out) { return read(bytes, out); });
        ASSERT_EQ(bytes_of(back), bytes) << "seed " << seed;
        for (int i = 0; i < 50; ++i) { // each change is found, and each end that is missing
            auto other = bytes;
            nurbs_statistics *out = nullptr;
            const size_t place = random.bits() % other.size();
            other[place] = static_cast<unsigned char>(other[place] ^ (1 + random.bits() % 255));
            ASSERT_NE(read(other, &out), NURBS_OK) << "seed " << seed << " byte " << place;
            ASSERT_EQ(out, nullptr);
            other = bytes;
            other.resize(place);
            ASSERT_EQ(read(other, &out), NURBS_ERROR_TRUNCATED) << "seed " << seed;
        }
    });
}

// Knots, degree and smoothing are chosen afterwards: the fit is that of the data.
TEST(Statistics, fit_any_knots_among_the_breaks) {
    for_each_case(897000, 60, [](Random &random, uint64_t seed) {
        const int q = random.whole(0, 5);
        SplineData over = even_curve(q, q + 8);
        Cells cells{{q + random.whole(0, 3)}, {65}, {}};
        for (int i = 0; i <= 64; ++i) {
            cells.breaks.push_back(i / 64.0);
        }
        Sample sample = random_sample(random, {{0}, {2}, {0, 1}}, 2, 400);
        const Statistics all = with(empty(cells, 2, 1, 1), sample);
        Fit fine(over), direct(over);
        fine.options.smoothing = direct.options.smoothing = q > 1 ? random.whole(0, 3) : 0;
        fine.options.lambda = direct.options.lambda = 1e-4;
        const SplineData a = read_back(fine(all).get()), b = read_back(direct(sample).get());
        for (size_t i = 0; i < a.points.size(); ++i) {
            ASSERT_NEAR(a.points[i], b.points[i], 1e-10) << "seed " << seed << " degree " << q;
        }
        ASSERT_EQ(fine.report.data_count, direct.report.data_count);
        ASSERT_NEAR(fine.report.rms, direct.report.rms, 1e-8);
    });
}

} // namespace statistics_test

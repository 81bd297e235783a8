// SPDX-License-Identifier: MIT
#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/intervals.h"
#include "intersect/surfaces/cross_cell.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr size_t record_width = 4; // x w, y w, z w, w

// A net of records [counts[0]][counts[1]].
struct RecordNet {
    std::array<int, 2> counts{};
    std::vector<double> records;

    [[nodiscard]] RecordNet derivative(size_t axis, double factor) const {
        RecordNet result{counts, {}};
        --result.counts[axis];
        const size_t row = record_width * static_cast<size_t>(counts[1]),
                     step = axis == 0 ? row : record_width,
                     width = record_width * static_cast<size_t>(result.counts[1]);
        result.records.reserve(static_cast<size_t>(result.counts[0]) * width);
        for (size_t i = 0; i < static_cast<size_t>(result.counts[0]); ++i) {
            const double *const own = records.data() + i * row;
            for (size_t c = 0; c < width; ++c) {
                result.records.push_back(factor * (own[c + step] - own[c]));
            }
        }
        return result;
    }
    [[nodiscard]] Interval weights(double room) const noexcept {
        Interval all{infinity, -infinity};
        for (size_t i = 3; i < records.size(); i += record_width) {
            all = {std::min(all.lower, records[i]), std::max(all.upper, records[i])};
        }
        return records.empty() ? Interval{0, 0} : Interval{all.lower - room, all.upper + room};
    }
};

Interval along_records(const std::vector<double> &records, const Vector3 &vector, double room) noexcept {
    Interval all{infinity, -infinity};
    for (size_t i = 0; i < records.size(); i += record_width) {
        const double x = vector.x * records[i] + vector.y * records[i + 1] + vector.z * records[i + 2];
        all = {std::min(all.lower, x), std::max(all.upper, x)};
    }
    return records.empty() ? Interval{0, 0} : Interval{all.lower - room, all.upper + room};
}

} // namespace

// The second derivatives over the wide part of A = w (S - centre) and of w, by places in the part.
struct CrossCell::Seconds {
    std::array<std::vector<double>, 3> nets; // records of 00, 01 and 11
    std::array<Interval, 2> turns;           // w_0 and w_1
    std::array<Interval, 3> second_turns;    // w_00, w_01 and w_11
    double room;                             // error bound of dot products with unit vectors
    bool weighted;                           // whether the weights are not all equal
    std::array<double, 2> largest_slopes;
};

void CrossCell::DeleteSeconds::operator()(const Seconds *seconds) const noexcept {
    delete seconds;
}

CrossCell::~CrossCell() = default;
CrossCell::CrossCell(CrossCell &&) noexcept = default;

bool CrossCell::has_weights() const noexcept {
    for (size_t i = 3; i < records_.size(); i += record_width) {
        if (records_[i] != records_[3]) {
            return true;
        }
    }
    return false;
}

const CrossCell::Seconds &CrossCell::seconds() const {
    if (seconds_) {
        return *seconds_;
    }
    const auto [p, q] = piece_->degrees;
    RecordNet net{{p + 1, q + 1}, std::vector<double>(records_.size())};
    std::vector<double> half(records_.size());
    widen(records_.data(), half.data(), net.records.data());
    double largest_weight = 0;
    for (double *record = net.records.data(); record < net.records.data() + net.records.size();
         record += record_width) {
        largest_weight = std::max(largest_weight, record[3]);
        record[0] -= record[3] * centre_.x;
        record[1] -= record[3] * centre_.y;
        record[2] -= record[3] * centre_.z;
    }
    count_work(20 * std::ssize(net.records));
    const double wider = 1 + 2 * widening;
    const std::array<double, 2> factors{p / wider, q / wider};
    const std::array<RecordNet, 2> first{net.derivative(0, factors[0]), net.derivative(1, factors[1])};
    auto result = std::make_unique<Seconds>();
    result->weighted = has_weights();
    result->largest_slopes = {largest_slope(0), largest_slope(1)};
    result->room = 16 * (factors[0] + factors[1] + 1) * (factors[0] + factors[1] + 1) * largest_weight *
                   (error_ + 8 * eps * reach_) * std::pow(wider, p + q);
    const double room_of_weight = result->room / std::max(piece_->piece.reach(), eps);
    for (size_t d = 0; d < 3; ++d) {
        const size_t k = d == 2 ? 1 : 0, l = d == 0 ? 0 : 1;
        RecordNet second =
            first[k].derivative(l, l == k ? std::max(factors[l] - 1 / wider, 0.0) : factors[l]);
        result->second_turns[d] = second.weights(room_of_weight);
        result->nets[d] = std::move(second.records);
    }
    result->turns = {first[0].weights(room_of_weight), first[1].weights(room_of_weight)};
    seconds_.reset(result.release());
    return *seconds_;
}

// S_kl = (A_kl - w_kl (S - centre) - w_k S_l - w_l S_k) / w.
std::array<Interval, 3> CrossCell::seconds_from(const Vector3 &vector, const CrossExtents &extents) const {
    const Seconds &seconds = this->seconds();
    const double room = 1.0001 * numeric::length(vector) * seconds.room;
    count_work(4 * std::ssize(seconds.nets[1]));
    std::array<Interval, 3> result{};
    for (size_t d = 0; d < 3; ++d) {
        const size_t k = d == 2 ? 1 : 0, l = d == 0 ? 0 : 1;
        const Interval sum = along_records(seconds.nets[d], vector, room) -
                             seconds.second_turns[d] * extents.points - seconds.turns[k] * extents.slopes[l] -
                             seconds.turns[l] * extents.slopes[k];
        result[d] = sum * Interval{1 / weights_.upper, 1 / weights_.lower};
    }
    return result;
}

CrossBends CrossCell::bends_along(const Vector3 &vector) const {
    const CrossExtents extents = along(vector);
    return {extents, seconds_from(vector, extents)};
}

// Extents are multiplied by derivatives of the weight: where all weights are equal, rough bounds are enough.
std::array<Interval, 3> CrossCell::seconds_along(const Vector3 &vector) const {
    const Seconds &seconds = this->seconds();
    if (seconds.weighted) {
        return seconds_from(vector, along(vector));
    }
    const double size = 1.0001 * numeric::length(vector);
    return seconds_from(
        vector, {around(size * reach_),
                 {around(size * seconds.largest_slopes[0]), around(size * seconds.largest_slopes[1])}});
}

} // namespace nrb::intersect

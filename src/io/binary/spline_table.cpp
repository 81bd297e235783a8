// SPDX-License-Identifier: MIT
#include "io/binary/spline_table.h"

#include "base/error.h"
#include "io/binary/crc64.h"
#include "io/binary/spline_bytes.h"

namespace nrb::io {

namespace {

// The checksum of the points as they are in memory. It may depend on the byte order of the machine, since it
// is never stored.
uint64_t checksum_of_points(const Spline &spline) noexcept {
    const std::span<const double> points = spline.points();
    return crc64({reinterpret_cast<const unsigned char *>(points.data()), points.size_bytes()});
}

SplinePtr numbered_spline(std::span<const unsigned char> bytes, size_t number) {
    try {
        return spline_from(bytes);
    } catch (const Error &error) {
        fail(error.status(), "spline %zu: %s", number, error.what());
    }
}

} // namespace

int64_t SplineTable::add(const SplinePtr &spline) {
    const auto [at, fresh] = known_.try_emplace(spline, 0);
    if (fresh) {
        at->second = add_contents(spline);
    }
    return at->second;
}

int64_t SplineTable::add_contents(const SplinePtr &spline) {
    const uint64_t checksum = checksum_of_points(*spline);
    const auto found = by_checksum_.equal_range(checksum);
    for (auto at = found.first; at != found.second; ++at) {
        if (same_bytes(*splines_[static_cast<size_t>(at->second)], *spline)) {
            return at->second;
        }
    }
    by_checksum_.emplace(checksum, count());
    splines_.push_back(spline);
    return count() - 1;
}

size_t SplineTable::size_in_bytes() const noexcept {
    size_t size = aligned(8 * splines_.size());
    for (const SplinePtr &spline : splines_) {
        size += aligned(io::size_in_bytes(*spline));
    }
    return size;
}

void SplineTable::write(ByteWriter &writer) const noexcept {
    size_t place = writer.place() + aligned(8 * splines_.size());
    for (const SplinePtr &spline : splines_) {
        writer.put(uint64_t{place});
        place += aligned(io::size_in_bytes(*spline));
    }
    for (const SplinePtr &spline : splines_) {
        writer.align();
        write_bytes(*spline, writer.room(io::size_in_bytes(*spline)));
    }
    writer.align();
}

std::vector<SplinePtr> splines_from(ByteReader &reader, int64_t count) {
    const std::vector<int64_t> places = reader.take_integers(count);
    std::vector<SplinePtr> splines;
    for (const int64_t place : places) {
        reader.align();
        splines.push_back(numbered_spline(reader.take_record(place), splines.size()));
    }
    reader.align();
    return splines;
}

} // namespace nrb::io

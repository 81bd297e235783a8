// Bytes of handles, and what is true of those of every kind.
#pragma once

#include "support/cases.h"
#include "support/handle.h"

#include <gtest/gtest.h>
#include <memory>

namespace support {

using Bytes = std::vector<unsigned char>;

template <class Write, class Owner>
Bytes written(Write &&write, const Owner &owner) {
    int64_t size = 0;
    require_ok(write(owner.get(), 0, nullptr, &size));
    Bytes bytes(static_cast<size_t>(size));
    require_ok(write(owner.get(), size, bytes.data(), nullptr));
    return bytes;
}

// As a function of the C API reads them.
template <class Owner, class Read>
nurbs_status read_bytes(Read &&read, const Bytes &bytes, Owner &out) {
    typename Owner::pointer handle = nullptr;
    const nurbs_status status = read(bytes.data(), std::ssize(bytes), &handle);
    out.reset(handle);
    return status;
}

// Each change is found, and each end that is missing.
template <class Owner, class Read>
void expect_every_change_found(Read &&read, Random &random, uint64_t seed, const Bytes &bytes) {
    for (int i = 0; i < 40; ++i) {
        Bytes other = bytes;
        Owner none;
        const size_t place = random.bits() % other.size();
        other[place] = static_cast<unsigned char>(other[place] ^ (1 + random.bits() % 255));
        ASSERT_NE(read_bytes(read, other, none), NURBS_OK) << "seed " << seed << " byte " << place;
        ASSERT_EQ(none, nullptr);
        other = bytes;
        other.resize(place);
        ASSERT_EQ(read_bytes(read, other, none), NURBS_ERROR_TRUNCATED)
            << "seed " << seed << " byte " << place;
    }
}

} // namespace support

/* SPDX-License-Identifier: MIT */
/* Bytes of handles that a test changes and signs anew, as a program of another maker would write them. */
#ifndef NURBS_TESTS_CAPI_SIGNED_BYTES_H
#define NURBS_TESTS_CAPI_SIGNED_BYTES_H

#include "check.h"

#include <stdint.h>
#include <string.h>

enum { most_bytes = 8192, header_bytes = 64 };

typedef struct Bytes {
    int64_t size;
    unsigned char data[most_bytes];
} Bytes;

static inline void number_into(unsigned char *place, uint64_t value, int size) {
    for (int i = 0; i < size; ++i) {
        place[i] = (unsigned char)(value >> (8 * i));
    }
}

static inline uint64_t number_from(const unsigned char *place, int size) {
    uint64_t value = 0;
    for (int i = size; i-- > 0;) {
        value = value << 8 | place[i];
    }
    return value;
}

/* The checksum of ECMA-182 over all bytes but its own. */
static inline void sign(unsigned char *bytes, int64_t size) {
    uint64_t sum = ~UINT64_C(0);
    for (int64_t i = 0; i < size; ++i) {
        if (i >= 24 && i < 32) {
            continue;
        }
        sum ^= bytes[i];
        for (int k = 0; k < 8; ++k) {
            sum = sum >> 1 ^ (sum & 1 ? UINT64_C(0xC96C5795D7870F42) : 0);
        }
    }
    number_into(bytes + 24, ~sum, 8);
}

static inline uint64_t bits_of(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* Numbers in [0, 1) that are the same everywhere. */
static inline double next_number(uint64_t *state) {
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(*state >> 11) * 0x1p-53;
}

#endif

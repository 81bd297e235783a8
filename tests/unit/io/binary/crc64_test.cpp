#include "io/binary/crc64.h"

#include <gtest/gtest.h>
#include <string_view>

namespace crc64_test {

using nrb::io::crc64;

namespace {

std::span<const unsigned char> bytes_of(std::string_view text) {
    return {reinterpret_cast<const unsigned char *>(text.data()), text.size()};
}

} // namespace

TEST(Crc64, has_the_check_value_of_its_polynomial) {
    EXPECT_EQ(crc64(bytes_of("123456789")), 0x995DC9BBDF1939FAu);
    EXPECT_EQ(crc64({}), 0u);
}

TEST(Crc64, goes_on_where_it_ended) {
    const std::string_view text = "the quick brown fox jumps over the lazy dog";
    for (size_t cut = 0; cut <= text.size(); ++cut) {
        EXPECT_EQ(crc64(bytes_of(text.substr(cut)), crc64(bytes_of(text.substr(0, cut)))),
                  crc64(bytes_of(text)));
    }
}

} // namespace crc64_test

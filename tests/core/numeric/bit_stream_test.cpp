// SPDX-License-Identifier: MIT
// Numbers packed into bits are read back, and a table may outgrow its usual number of bits.
#include "core/numeric/bit_stream.h"

#include <catch_amalgamated.hpp>

namespace gaitsmith::test {

TEST_CASE("bit stream: an index of a table of any length comes back, short ones in the bits they always had",
          "[document]") {
  const int bits = GENERATE(1, 3, 4, 6);
  const std::size_t rows = LongestTable(bits);
  CAPTURE(bits, rows);
  for (std::size_t index = 0; index < rows; ++index) {
    BitWriter out;
    out.PutIndex(index, bits);
    out.Put(0x2d, 6);  // later bits are not changed
    BitReader in(out.Bytes());
    REQUIRE(in.TakeIndex(bits) == index);
    REQUIRE(in.Take(6) == 0x2d);
    REQUIRE(in.AtEnd());
    if (index + 1 < (std::size_t{1} << bits)) {
      BitWriter plain;
      plain.Put(index, bits);
      plain.Put(0x2d, 6);
      REQUIRE(plain.Bytes() == out.Bytes());
    }
  }
}

TEST_CASE("bit stream: a reader past the end says so and gives zeros", "[document]") {
  BitWriter out;
  out.Put(0b101, 3);
  BitReader in(out.Bytes());
  CHECK(in.Take(3) == 0b101);
  CHECK_FALSE(in.Overrun());
  CHECK(in.Take(20) == 0);
  CHECK(in.Overrun());
  CHECK_FALSE(in.AtEnd());
}

}  // namespace gaitsmith::test

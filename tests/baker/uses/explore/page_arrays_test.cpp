// SPDX-License-Identifier: MIT
#include "uses/explore/page_arrays.h"

#include "baker/uses/explore/page_data.h"
#include "support/testing.h"

namespace coppermoon::uses::page_arrays_test {

TEST(PageArrays, ComeBackAsTheyWere) {
  PageArrays arrays;
  arrays.add("bytes", {2, 3}, std::vector<std::uint8_t>{10, 255, 0, 7, 7, 9});
  arrays.add("numbers", {3}, std::vector<double>{1e-30, -2.5, 3e8});
  arrays.add("text", "Tycho\n");
  EXPECT_EQ(numbers_in_page(arrays, "numbers"), (std::vector<float>{1e-30F, -2.5F, 3e8F}));
  const auto bytes = bytes_in_page(arrays);
  // each byte is its difference from the one before it in its row, modulo 256
  EXPECT_EQ(std::vector<unsigned char>(bytes.begin(), bytes.begin() + 6),
            (std::vector<unsigned char>{10, 245, 1, 7, 0, 2}));
  const auto at = arrays.index()["text"]["at"].get<std::size_t>();
  EXPECT_EQ(std::string(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end()), "Tycho\n");
}

TEST(PageArrays, OfAnotherStandBehindTheirOwn) {
  PageArrays first, second;
  first.add("text", "x");
  second.add("numbers", {2}, std::vector<double>{1, 2});
  first.append(second);
  EXPECT_EQ(numbers_in_page(first, "numbers"), (std::vector<float>{1, 2}));
}

TEST(PageArrays, OfAnotherShapeOrNoNumbersAreRefused) {
  PageArrays arrays;
  EXPECT_THROW(arrays.add("a", {3}, std::vector<double>{1, 2}), algebra::Error);
  EXPECT_THROW(arrays.add("a", {1}, std::vector<double>{std::numeric_limits<double>::quiet_NaN()}),
               algebra::Error);
  EXPECT_THROW(arrays.add("a", {1}, std::vector<double>{1e300}), algebra::Error)
      << "infinite in single precision";
}

}  // namespace coppermoon::uses::page_arrays_test

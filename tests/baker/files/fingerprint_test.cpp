// SPDX-License-Identifier: MIT
#include "files/fingerprint.h"

#include "support/testing.h"

namespace coppermoon::files::fingerprint_test {

TEST(Fingerprint, IsXxHashs) {
  EXPECT_EQ(fingerprint(""), 0x2d06800538d394c2ULL) << "the published value for no bytes";
}

TEST(Fingerprint, TellsOneBitApart) {
  EXPECT_NE(fingerprint("moon"), fingerprint("moom"));
  EXPECT_NE(fingerprint("moon"), fingerprint(std::string_view("moon\0", 5)));
}

TEST(Fingerprint, OfPiecesIsThatOfTheWhole) {
  int pieces = 0;
  const auto next = [&] { return std::string(pieces++ < 300 ? "moon" : ""); };
  std::string whole;
  for (int i = 0; i < 300; ++i) whole += "moon";
  EXPECT_EQ(fingerprint_of_pieces(next), fingerprint(whole));
}

}  // namespace coppermoon::files::fingerprint_test

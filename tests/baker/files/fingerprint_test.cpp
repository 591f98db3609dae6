// SPDX-License-Identifier: MIT
#include "files/fingerprint.h"

#include <gtest/gtest.h>

namespace coppermoon::files {
namespace {

TEST(Fingerprint, IsFarmHashs) {
  EXPECT_EQ(fingerprint(""), 0x9ae16a3b2f90404fULL) << "k2 of the published algorithm, for no bytes";
}

TEST(Fingerprint, TellsOneBitApart) {
  EXPECT_NE(fingerprint("moon"), fingerprint("moom"));
  EXPECT_NE(fingerprint("moon"), fingerprint(std::string_view("moon\0", 5)));
}

}  // namespace
}  // namespace coppermoon::files

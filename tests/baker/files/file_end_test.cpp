// SPDX-License-Identifier: MIT
#include "files/file_end.h"

#include "baker/texture/scratch_folder.h"
#include "files/child_process.h"
#include "support/testing.h"

namespace file_end_test {

using namespace std::string_literals;
using coppermoon::files::has_its_end;
using coppermoon::files::opened;

class FileEnd : public ScratchFolder {
 protected:
  bool is_whole(const std::string& bytes) const { return has_its_end(opened(file("a", bytes))); }
};

/// Smallest files of their kinds: what stands between head and end is not looked at.
const std::string png = "\x89PNG\r\n\x1a\n...\0\0\0\0IEND\xae\x42\x60\x82"s,
                  pdf = "%PDF-1.5\nstartxref\n12\n%%EOF\n",
                  svg = "<?xml version=\"1.0\"?>\n<svg width=\"1\"><g></g></svg>\n",
                  avif =
                      "\0\0\0\x10"
                      "ftypavif\0\0\0\0\0\0\0\x09mdatx"s,
                  movie =
                      "\0\0\0\x08"
                      "ftyp\0\0\0\x01mdat\0\0\0\0\0\0\0\x12xx\0\0\0\x08moov"s;

TEST_F(FileEnd, IsThatOfItsKind) {
  for (const auto& whole : {png, pdf, svg, avif, movie}) {
    EXPECT_TRUE(is_whole(whole)) << whole;
    EXPECT_FALSE(is_whole(whole.substr(0, whole.size() - 7))) << whole;
    EXPECT_FALSE(is_whole(whole.substr(0, 9))) << whole;
  }
  EXPECT_TRUE(is_whole(pdf + "\n"));
  EXPECT_FALSE(is_whole(png + "more"));
}

TEST_F(FileEnd, OfAnotherKindIsNotKnown) {
  EXPECT_TRUE(is_whole("1,2,3\n4,5,6"));
  EXPECT_FALSE(is_whole(""));
  EXPECT_FALSE(is_whole("\x89PNG")) << "cut off before it says what it is";
}

}  // namespace file_end_test

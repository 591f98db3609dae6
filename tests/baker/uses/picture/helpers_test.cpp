// SPDX-License-Identifier: MIT
// Programs that draw and code for us, when they do not as they should.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "algebra/error.h"
#include "files/temporary_folder.h"
#include "support/left_behind.h"
#include "uses/picture/avif_file.h"
#include "uses/picture/gnuplot.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

/// A folder that is all of PATH that a helper is found in.
class Helpers : public testing::Test {
 protected:
  Helpers() { ::setenv("PATH", (here().string() + ":" + path_).c_str(), 1); }
  ~Helpers() override { ::setenv("PATH", path_.c_str(), 1); }

  const fs::path& here() const { return folder_.path(); }

  void stand_in(const std::string& name, const std::string& script) const {
    std::ofstream(here() / name) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(here() / name, fs::perms::owner_all);
  }

  template <typename Make>
  std::string refusal(Make make) const {
    try {
      make();
    } catch (const algebra::Error& error) {
      return error.what();
    }
    return {};
  }

 private:
  std::string path_ = std::getenv("PATH");
  files::TemporaryFolder folder_;
};

TEST_F(Helpers, ThatEndWellWithoutAResultAreSaid) {
  for (const char* name : {"gnuplot", "avifenc"}) stand_in(name, "exit 0");
  EXPECT_EQ(refusal([&] { write_plot(here() / "a.svg", "svg", "plot x"); }),
            "gnuplot: ended without a result");
  const texture::Image picture(2, 2, {"R", "G", "B"});
  EXPECT_EQ(refusal([&] { write_avif(here() / "a.avif", picture, {}); }),
            "avifenc: ended without a result");
  for (const char* name : {"a.svg", "a.avif"}) EXPECT_FALSE(fs::exists(here() / name));
}

TEST_F(Helpers, ThatFailHaveTheFirstWord) {
  stand_in("gnuplot", "echo >&2; echo 'out of ink' >&2; echo end >&2; exit 1");
  EXPECT_EQ(refusal([&] { write_plot(here() / "a.svg", "svg", "plot x"); }), "gnuplot: out of ink");
}

TEST_F(Helpers, ThatHangAreNotLeftBehind) {
  stand_in("gnuplot",
           "cd " + here().string() + "; echo $$ > pid.tmp; mv pid.tmp pid; exec sleep 20");
  EXPECT_EQ(signal_after_our_death(here() / "pid",
                                   [&] { write_plot(here() / "a.svg", "svg", "plot x"); }),
            SIGKILL);
}

}  // namespace
}  // namespace coppermoon::uses

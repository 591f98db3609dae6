// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "algebra/error.h"
#include "files/temporary_folder.h"
#include "support/refusals.h"

namespace coppermoon {

/// A folder that a helper program is looked for in first.
class HelperFolder : public testing::Test {
 protected:
  HelperFolder() { ::setenv("PATH", (here().string() + ":" + path_).c_str(), 1); }
  ~HelperFolder() override { ::setenv("PATH", path_.c_str(), 1); }

  const std::filesystem::path& here() const { return folder_.path(); }

  void stand_in(const std::string& name, const std::string& script) const {
    std::ofstream(here() / name) << "#!/bin/sh\n" << script << "\n";
    std::filesystem::permissions(here() / name, std::filesystem::perms::owner_all);
  }

 private:
  std::string path_ = std::getenv("PATH");
  files::TemporaryFolder folder_;
};

}  // namespace coppermoon

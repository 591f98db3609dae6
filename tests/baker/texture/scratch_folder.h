// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include "support/testing.h"

/// An empty folder of its own for each test, gone afterwards.
class ScratchFolder : public testing::Test {
 protected:
  ScratchFolder() {
    auto name = (std::filesystem::temp_directory_path() / "coppermoon_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~ScratchFolder() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path in_folder(std::string_view name) const { return folder_ / name; }

  std::filesystem::path file(std::string_view name, std::string_view bytes) const {
    std::ofstream(in_folder(name), std::ios::binary) << bytes;
    return in_folder(name);
  }

  std::size_t files_in_folder() const {
    using Walk = std::filesystem::directory_iterator;
    return static_cast<std::size_t>(std::distance(Walk(folder_), Walk()));
  }

 private:
  std::filesystem::path folder_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// One line that says what is wanted.
#define EXPECT_ERROR(action, part)                                    \
  do {                                                                \
    const std::string text = coppermoon::refusal_of([&] { action; }); \
    EXPECT_SAYS(text, part) << "got: " << text;                       \
    EXPECT_SAYS_NOT(text, '\n') << "got: " << text;                   \
  } while (false)

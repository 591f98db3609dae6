// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::texture {

/// Keeps stderr closed to the libraries below for as long as any is there, in whatever thread: libpng,
/// libjpeg and libtiff print lines of their own about files that end early, which an Error then tells again.
/// Nothing of ours may print meanwhile. OpenEXR prints nothing, and needs none.
class Silence {
 public:
  Silence();
  /// Of a file that is read: none for one of OpenEXR.
  explicit Silence(const std::filesystem::path& file);
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  explicit Silence(bool wanted);

  bool wanted_;
};

}  // namespace coppermoon::texture

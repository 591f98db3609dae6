// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::texture {

/// Silences stderr as long as any Silence exists, in any thread: libpng, libjpeg and libtiff print
/// their own messages about files that end early, which an Error then reports again.
/// Our own code must not print meanwhile. OpenEXR prints nothing, and so needs no Silence.
class Silence {
 public:
  Silence();
  /// For reading a file: does nothing if it is an OpenEXR file.
  explicit Silence(const std::filesystem::path& file);
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  explicit Silence(bool wanted);

  bool wanted_;
};

}  // namespace coppermoon::texture

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::texture {

/// Silences stderr for all threads as long as any Silence exists. It is for libpng, libjpeg and libtiff, whose messages
/// about truncated files only repeat what an Error reports. Our own code must not print meanwhile. OpenEXR prints
/// nothing, so no Silence is needed for it.
class Silence {
 public:
  Silence();
  /// Silences stderr while a file is read, unless it is an OpenEXR file.
  explicit Silence(const std::filesystem::path& file);
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  explicit Silence(bool wanted);

  bool wanted_;
};

}  // namespace coppermoon::texture

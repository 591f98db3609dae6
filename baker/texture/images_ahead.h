// SPDX-License-Identifier: MIT
#pragma once

#include <thread>

namespace coppermoon::texture {

/// Loads, in the background, the code for reading and writing images, because loading takes 0.2 s on one processor.
/// Errors are reported only when an image is first read or written. Nothing is loaded if the address space is limited.
class ImagesAhead {
 public:
  ImagesAhead();
  /// Waits until loading has finished.
  ~ImagesAhead();
  ImagesAhead(const ImagesAhead&) = delete;
  ImagesAhead& operator=(const ImagesAhead&) = delete;

 private:
  std::thread loading_;
};

}  // namespace coppermoon::texture

// SPDX-License-Identifier: MIT
#pragma once

#include <thread>

namespace coppermoon::texture {

/// Loading of what reads and writes images, beside other work: it takes one processor 0.2 s. An error is kept for
/// whoever first reads or writes an image. Nothing is loaded ahead where the address space is limited.
class ImagesAhead {
 public:
  ImagesAhead();
  /// Waits for the end of the loading.
  ~ImagesAhead();
  ImagesAhead(const ImagesAhead&) = delete;
  ImagesAhead& operator=(const ImagesAhead&) = delete;

 private:
  std::thread loading_;
};

}  // namespace coppermoon::texture

// SPDX-License-Identifier: MIT
#pragma once

namespace coppermoon::verbs {

/// Keeps stderr closed to the libraries below for as long as it lives: libpng prints a line of its
/// own about a file that ends early, which an Error then tells again. Nothing of ours may print
/// meanwhile.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int kept_;
};

}  // namespace coppermoon::verbs

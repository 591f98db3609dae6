// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <fmt/format.h>

#include "algebra/error.h"
#include "files/loaded_library.h"

namespace coppermoon::files {

void* function_of(const std::filesystem::path& library, const char* name) {
  void* const loaded = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
  if (!loaded)
    throw algebra::Error(fmt::format("{}: cannot be loaded: {}", library.string(), ::dlerror()));
  return ::dlsym(loaded, name);
}

}  // namespace coppermoon::files

// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include "algebra/error.h"
#include "files/loaded_library.h"

namespace coppermoon::files {

namespace fs = std::filesystem;

fs::path own_program() { return fs::read_symlink("/proc/self/exe"); }

/// The dynamic linker reports an empty name if the part is in the program itself.
fs::path file_that_has(const void* part) {
  Dl_info info{};
  void* map = nullptr;
  if (::dladdr1(part, &info, &map, RTLD_DL_LINKMAP) != 0 && map != nullptr)
    if (const auto* name = static_cast<link_map*>(map)->l_name; name != nullptr && *name != 0)
      return fs::absolute(name);
  return own_program();
}

void* function_of(const fs::path& library, const char* name) {
  void* const loaded = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
  if (!loaded)
    throw algebra::Error(fmt::format("{}: cannot be loaded: {}", library.string(), ::dlerror()));
  return ::dlsym(loaded, name);
}

}  // namespace coppermoon::files

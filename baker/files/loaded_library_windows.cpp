// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <windows.h>

#include "algebra/error.h"
#include "files/handle_windows.h"
#include "files/loaded_library.h"

namespace coppermoon::files {
namespace {

namespace fs = std::filesystem;

/// The file from which a module was loaded; for a null pointer, the running program's file.
fs::path file_of(HMODULE module) {
  std::wstring name(32768, L'\0');
  name.resize(::GetModuleFileNameW(module, name.data(), static_cast<DWORD>(name.size())));
  return name;
}

}  // namespace

fs::path own_program() { return file_of(nullptr); }

fs::path file_that_has(const void* part) {
  HMODULE module = nullptr;
  ::GetModuleHandleExW(
      GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
      static_cast<LPCWSTR>(part), &module);
  return file_of(module);
}

void* function_of(const fs::path& library, const char* name) {
  const auto loaded =
      ::LoadLibraryExW(fs::absolute(library).c_str(), nullptr, LOAD_WITH_ALTERED_SEARCH_PATH);
  if (!loaded)
    throw algebra::Error(
        fmt::format("{}: cannot be loaded: {}", library.string(), last_error().message()));
  return reinterpret_cast<void*>(::GetProcAddress(loaded, name));
}

}  // namespace coppermoon::files

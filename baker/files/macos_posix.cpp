// SPDX-License-Identifier: MIT
// tests/macos.sh compiles this file, but it has never been run.
#include <dlfcn.h>
#include <fcntl.h>
#include <mach-o/dyld.h>
#include <sys/sysctl.h>
#include <unistd.h>

#include <climits>
#include <system_error>

#include "files/descriptor_posix.h"
#include "files/linux_or_macos.h"
#include "files/loaded_library.h"
#include "files/memory.h"

namespace coppermoon::files {

namespace fs = std::filesystem;

bool make_pipe(int (&ends)[2]) {
  return ::pipe(ends) == 0 && ::fcntl(ends[0], F_SETFD, FD_CLOEXEC) == 0 &&
         ::fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0;
}

/// macOS has nothing like prctl, so a program that this process runs continues if this process is killed.
bool end_with(int parent) { return ::getppid() == parent; }

void execute(char* const* arguments, char* const* variables) {
  environ = const_cast<char**>(variables);
  ::execvp(arguments[0], arguments);
}

/// kqueue does not report when a file is closed, so the caller waits until the child process that writes it ends.
Handle watch(const fs::path&, const std::string&) { return {}; }

bool has_closed(const Handle&, const std::string&) { return false; }

std::string name_of(const Handle& file) {
  char path[PATH_MAX] = "";
  ::fcntl(descriptor_of(file), F_GETPATH, path);
  return path;
}

/// On macOS, every file has a name, so a new file has a temporary name until it is complete.
Handle nameless_file(const fs::path&) { return {}; }

FILE* stream_to_say_or_lose() {
  const auto say = [](void*, const char* words, int size) {
    return static_cast<int>(say_or_lose(words, static_cast<std::size_t>(size)));
  };
  return ::funopen(nullptr, nullptr, say, nullptr, nullptr);
}

/// Returns the size of all memory, because macOS reclaims memory from caches and compresses idle memory.
double available_memory() {
  std::uint64_t bytes = 0;
  std::size_t size = sizeof bytes;
  return ::sysctlbyname("hw.memsize", &bytes, &size, nullptr, 0) == 0 ? static_cast<double>(bytes)
                                                                      : 1e9;
}

void keep_freed_memory() {}  // the allocator of macOS cannot be told to keep freed memory

fs::path own_program() {
  char path[PATH_MAX];
  std::uint32_t size = sizeof path;
  if (::_NSGetExecutablePath(path, &size) != 0)
    throw fs::filesystem_error("own program", std::make_error_code(std::errc::filename_too_long));
  return fs::canonical(path);
}

fs::path file_that_has(const void* part) {
  Dl_info info{};
  return ::dladdr(part, &info) != 0 ? fs::canonical(info.dli_fname) : own_program();
}

}  // namespace coppermoon::files

// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <link.h>
#include <malloc.h>
#include <signal.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <limits>

#include "files/descriptor_posix.h"
#include "files/linux_or_macos.h"
#include "files/loaded_library.h"
#include "files/memory.h"

namespace coppermoon::files {

namespace fs = std::filesystem;

bool make_pipe(int (&ends)[2]) { return ::pipe2(ends, O_CLOEXEC) == 0; }

bool end_with(int parent) {
  return ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && ::getppid() == parent;
}

void execute(char* const* arguments, char* const* variables) {
  ::execvpe(arguments[0], arguments, variables);
}

Handle watch(const fs::path& folder, const std::string& file) {
  Handle made(file.empty() ? -1 : ::inotify_init1(IN_CLOEXEC | IN_NONBLOCK));
  if (made && ::inotify_add_watch(descriptor_of(made), folder.c_str(), IN_CLOSE_WRITE) < 0)
    made.close();
  return made;
}

bool has_closed(const Handle& watch, const std::string& file) {
  alignas(inotify_event) std::array<char, 4096> events;
  const auto count = ::read(descriptor_of(watch), events.data(), events.size());
  for (std::ptrdiff_t at = 0; at < count;) {
    const auto* event = reinterpret_cast<const inotify_event*>(events.data() + at);
    if (event->len > 0 && file == event->name) return true;
    at += static_cast<std::ptrdiff_t>(sizeof *event + event->len);
  }
  return false;
}

std::string name_of(const Handle& file) { return fmt::format("/proc/self/fd/{}", file.number); }

Handle nameless_file(const fs::path& folder) {
  if (!fs::exists("/proc/self/fd")) return {};
  return Handle(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666));
}

FILE* stream_to_say_or_lose() {
  cookie_io_functions_t voice{};
  voice.write = [](void*, const char* words, std::size_t size) {
    return static_cast<ssize_t>(say_or_lose(words, size));
  };
  return ::fopencookie(nullptr, "w", voice);
}

double available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string name; file >> name;
       file.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
    if (double kibibytes = 0; name == "MemAvailable:" && file >> kibibytes) return 1024 * kibibytes;
  return 1e9;
}

void keep_freed_memory() {
  constexpr int largest_kept = 1 << 30;
  ::mallopt(M_MMAP_THRESHOLD, largest_kept);
  ::mallopt(M_TRIM_THRESHOLD, largest_kept);
}

fs::path own_program() { return fs::read_symlink("/proc/self/exe"); }

/// The dynamic linker reports an empty name if `part` belongs to the program itself.
fs::path file_that_has(const void* part) {
  Dl_info info{};
  void* map = nullptr;
  if (::dladdr1(part, &info, &map, RTLD_DL_LINKMAP) != 0 && map != nullptr)
    if (const auto* name = static_cast<link_map*>(map)->l_name; name != nullptr && *name != 0)
      return fs::absolute(name);
  return own_program();
}

}  // namespace coppermoon::files

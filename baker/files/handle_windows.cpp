// SPDX-License-Identifier: MIT
#include "files/handle_windows.h"

#include <windows.h>

#include <algorithm>
#include <array>
#include <cwchar>

/// Replaces mbrtowc, with which libstdc++ converts the narrow characters of a path to wide ones, because the version in
/// msvcrt.dll does not support UTF-8. `state` keeps the second half of a surrogate pair for the next call.
extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t count,
                                      std::mbstate_t* state);
extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t count,
                                      std::mbstate_t* state) {
  if (*state != 0) {
    *to = static_cast<wchar_t>(std::exchange(*state, 0));
    return 1;
  }
  constexpr int longest = 4;  // largest number of bytes in a UTF-8 character
  std::array<wchar_t, 2> units{};
  for (int bytes = 1; bytes <= longest && static_cast<std::size_t>(bytes) <= count; ++bytes) {
    const int made =
        ::MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, from, bytes, units.data(), 2);
    if (made == 0) continue;
    *to = units[0];
    if (made == 2) *state = units[1];
    return units[0] == 0 ? 0 : static_cast<std::size_t>(bytes - (made - 1));
  }
  return static_cast<std::size_t>(count < longest ? -2 : -1);  // incomplete or invalid UTF-8
}

namespace coppermoon::files {
namespace {

constexpr std::size_t most_at_once = 1 << 30;  // largest number of bytes read or written at once

}  // namespace

Handle copied(void* system, bool inherited) {
  const auto ours = ::GetCurrentProcess();
  HANDLE copy = nullptr;
  ::DuplicateHandle(ours, system, ours, &copy, 0, inherited, DUPLICATE_SAME_ACCESS);
  return owned(copy);
}

std::error_code last_error() {
  return {static_cast<int>(::GetLastError()), std::system_category()};
}

void Handle::close() {
  if (number >= 0) ::CloseHandle(system_handle(*this));
  number = -1;
}

/// Other processes may write, rename or remove the file while it is open, as on POSIX. Folders can be opened too.
Handle opened(const std::filesystem::path& file) {
  return owned(::CreateFileW(file.c_str(), GENERIC_READ,
                             FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                             OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr));
}

std::uint64_t size_of(const Handle& file) {
  LARGE_INTEGER size{};
  if (::GetFileType(system_handle(file)) != FILE_TYPE_DISK ||
      !::GetFileSizeEx(system_handle(file), &size))
    return 0;
  return static_cast<std::uint64_t>(size.QuadPart);
}

std::string bytes_at(const Handle& file, std::uint64_t place, std::size_t count) {
  std::string bytes(std::min(count, most_at_once), '\0');
  auto where = offset<OVERLAPPED>(place);
  DWORD got = 0;
  ::ReadFile(system_handle(file), bytes.data(), static_cast<DWORD>(bytes.size()), &got, &where);
  bytes.resize(got);
  return bytes;
}

std::error_code write_at(const Handle& file, std::uint64_t place, std::string_view bytes) {
  while (!bytes.empty()) {
    auto where = offset<OVERLAPPED>(place);
    const auto count = static_cast<DWORD>(std::min(bytes.size(), most_at_once));
    DWORD written = 0;
    if (!::WriteFile(system_handle(file), bytes.data(), count, &written, &where))
      return last_error();
    bytes.remove_prefix(written);
    place += written;
  }
  return {};
}

/// The prefix \\?\ is removed, because other libraries do not accept it.
std::string name_of(const Handle& file) {
  std::wstring name(32768, L'\0');
  name.resize(::GetFinalPathNameByHandleW(system_handle(file), name.data(),
                                          static_cast<DWORD>(name.size()), FILE_NAME_NORMALIZED));
  if (name.starts_with(LR"(\\?\UNC\)"))
    name.erase(2, 6);
  else if (name.starts_with(LR"(\\?\)"))
    name.erase(0, 4);
  return std::filesystem::path(name).string();
}

}  // namespace coppermoon::files

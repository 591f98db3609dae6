// SPDX-License-Identifier: MIT
#include <windows.h>
// must be included after windows.h
#include <aclapi.h>
#include <sddl.h>

#include <array>
#include <cstdlib>
#include <memory>

#include "files/environment.h"
#include "files/handle_windows.h"

namespace coppermoon::files {
namespace {

using Freed = std::unique_ptr<void, HLOCAL(WINAPI*)(HLOCAL)>;

/// Whether an owner is this user or the system. The owner "everyone" counts too: file systems without owners report it.
bool is_us_or_system(PSID owner) {
  for (const auto kind : {WinWorldSid, WinLocalSystemSid, WinBuiltinAdministratorsSid})
    if (::IsWellKnownSid(owner, kind)) return true;
  HANDLE ours = nullptr;
  if (!::OpenProcessToken(::GetCurrentProcess(), TOKEN_QUERY, &ours)) return false;
  const auto token = owned(ours);
  alignas(TOKEN_USER) std::array<std::byte, 256> told;
  DWORD size = 0;
  return ::GetTokenInformation(ours, TokenUser, told.data(), told.size(), &size) &&
         ::EqualSid(owner, reinterpret_cast<const TOKEN_USER*>(told.data())->User.Sid);
}

/// Whether the file or folder that opens at `path` with these flags belongs to this user or to the system.
bool is_own(const std::filesystem::path& path, DWORD flags) {
  const auto file = owned(::CreateFileW(
      path.c_str(), READ_CONTROL, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
      OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS | flags, nullptr));
  PSID owner = nullptr;
  PSECURITY_DESCRIPTOR about = nullptr;
  if (!file || ::GetSecurityInfo(system_handle(file), SE_FILE_OBJECT, OWNER_SECURITY_INFORMATION,
                                 &owner, nullptr, nullptr, nullptr, &about) != ERROR_SUCCESS)
    return false;
  const Freed freed(about, &::LocalFree);
  return owner != nullptr && is_us_or_system(owner);
}

}  // namespace

/// The program's code page is UTF-8, so getenv returns UTF-8.
std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

void set_missing_variable(const char* name, const std::string& value) {
  if (variable(name).empty()) ::_putenv_s(name, value.c_str());
}

std::filesystem::path users_caches() {
  const std::filesystem::path local = variable("LOCALAPPDATA");
  return local.is_absolute() ? local : "";
}

bool belongs_to_user(const std::filesystem::path& path) {
  return is_own(path, FILE_FLAG_OPEN_REPARSE_POINT) && is_own(path, 0);
}

/// Only the owner, the system and administrators get access to the folder and to the files that it will hold.
std::error_code make_folder_for_user(const std::filesystem::path& folder) {
  SECURITY_ATTRIBUTES security{sizeof security, nullptr, FALSE};
  if (!::ConvertStringSecurityDescriptorToSecurityDescriptorW(
          L"D:P(A;OICI;FA;;;OW)(A;OICI;FA;;;SY)(A;OICI;FA;;;BA)", SDDL_REVISION_1,
          &security.lpSecurityDescriptor, nullptr))
    return last_error();
  const Freed freed(security.lpSecurityDescriptor, &::LocalFree);
  if (::CreateDirectoryW(folder.c_str(), &security) || ::GetLastError() == ERROR_ALREADY_EXISTS)
    return {};
  return last_error();
}

}  // namespace coppermoon::files

// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <windows.h>

#include "files/cache_folder.h"
#include "files/handle_windows.h"
#include "files/lock.h"

namespace coppermoon::files {
namespace {

/// Offset of the byte that lock_folder locks. claim_folder locks single bytes below this offset.
constexpr std::uint64_t past_all_claims = std::uint64_t{1} << 62U;

/// Opens a hidden file on which locks are set, and makes it if it is missing. The file is never removed.
Handle lock_in(const std::filesystem::path& file) {
  return owned(::CreateFileW(file.c_str(), GENERIC_READ | GENERIC_WRITE,
                             FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                             OPEN_ALWAYS, FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_OPEN_REPARSE_POINT,
                             nullptr));
}

/// Windows cannot lock the folder itself, so a hidden file in the folder is locked instead.
Handle lock_of_folder(const std::filesystem::path& folder) {
  return lock_in(folder / ".coppermoon.lock");
}

/// Locks a range of bytes, which need not exist, until the handle closes.
bool lock(const Handle& file, std::uint64_t from, std::uint64_t length, DWORD how) {
  auto where = offset<OVERLAPPED>(from);
  return ::LockFileEx(system_handle(file), how, 0, static_cast<DWORD>(length),
                      static_cast<DWORD>(length >> 32U), &where) != 0;
}

/// Whether any other process has locked any byte of a range in a file. To find out, briefly locks the range itself.
bool others_hold(const Handle& file, std::uint64_t from, std::uint64_t length) {
  if (length == 0) return false;
  if (!lock(file, from, length, LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY))
    return ::GetLastError() == ERROR_LOCK_VIOLATION;
  auto where = offset<OVERLAPPED>(from);
  ::UnlockFileEx(system_handle(file), 0, static_cast<DWORD>(length),
                 static_cast<DWORD>(length >> 32U), &where);
  return false;
}

}  // namespace

Handle lock_folder(const std::filesystem::path& folder) {
  auto handle = lock_of_folder(folder);
  if (handle) lock(handle, past_all_claims, 1, LOCKFILE_EXCLUSIVE_LOCK);
  return handle;
}

Handle lock_file(const std::filesystem::path& file, const std::function<void()>& waiting) {
  const auto name = file.parent_path() / fmt::format(".{}.lock", file.filename().string());
  auto handle = lock_in(name);
  if (!handle || !is_users_own(name)) return handle;
  if (lock(handle, 0, 1, LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY) ||
      ::GetLastError() != ERROR_LOCK_VIOLATION)
    return handle;
  waiting();
  lock(handle, 0, 1, LOCKFILE_EXCLUSIVE_LOCK);
  return handle;
}

/// The claim is a shared lock on a single byte, and the byte's offset stands for the purpose.
FolderClaim claim_folder(const std::filesystem::path& folder, std::uint64_t purpose) {
  FolderClaim claim{lock_of_folder(folder)};
  const auto byte = purpose >> 2U;
  if (claim.handle && lock(claim.handle, byte, 1, LOCKFILE_FAIL_IMMEDIATELY))
    claim.alone = !others_hold(claim.handle, 0, byte) &&
                  !others_hold(claim.handle, byte + 1, past_all_claims - byte - 1);
  return claim;
}

}  // namespace coppermoon::files

// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>

#include "files/cache_folder.h"
#include "files/descriptor_posix.h"
#include "files/lock.h"

namespace coppermoon::files {
namespace {

struct flock lock_of(short type, off_t from, off_t length) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_start = from;
  lock.l_len = length;
  return lock;
}

/// Whether any other process has locked any byte of a range in a file.
///
/// Given  length  number of bytes from the offset `from` on; 0 means all bytes from there on
bool others_hold(int descriptor, off_t from, off_t length) {
  auto asked = lock_of(F_WRLCK, from, length);
  return ::fcntl(descriptor, F_OFD_GETLK, &asked) == 0 && asked.l_type != F_UNLCK;
}

}  // namespace

Handle lock_folder(const std::filesystem::path& folder) {
  auto handle = opened(folder);
  if (handle) ::flock(descriptor_of(handle), LOCK_EX);
  return handle;
}

Handle lock_file(const std::filesystem::path& file, const std::function<void()>& waiting) {
  const auto lock = file.parent_path() / fmt::format(".{}.lock", file.filename().string());
  const int descriptor =
      ::open(lock.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0600);
  Handle handle(descriptor);
  if (!handle || !is_users_own(lock)) return handle;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return handle;
  waiting();
  while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) continue;
  return handle;
}

/// The claim is a read lock on a single byte, and the byte's offset stands for the purpose.
FolderClaim claim_folder(const std::filesystem::path& folder, std::uint64_t purpose) {
  FolderClaim claim{opened(folder)};
  const auto descriptor = descriptor_of(claim.handle);
  const auto byte = static_cast<off_t>(purpose >> 2) + 1;  // neither the first nor the last offset
  auto mine = lock_of(F_RDLCK, byte, 1);
  if (::fcntl(descriptor, F_OFD_SETLK, &mine) == 0)
    claim.alone = !others_hold(descriptor, 0, byte) && !others_hold(descriptor, byte + 1, 0);
  return claim;
}

}  // namespace coppermoon::files

// SPDX-License-Identifier: MIT
#include "files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace coppermoon::files {
namespace {

int opened(const std::filesystem::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

/// Whether another open file holds a lock on any byte of a range, by F_OFD_GETLK.
///
/// Given  length  0: all from there on
bool others_hold(int descriptor, off_t from, off_t length) {
  struct flock asked {};
  asked.l_type = F_WRLCK;
  asked.l_start = from;
  asked.l_len = length;
  return ::fcntl(descriptor, F_OFD_GETLK, &asked) == 0 && asked.l_type != F_UNLCK;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : descriptor_(opened(folder)) {
  if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

/// Claims by a read lock on one byte, whose offset is the purpose.
FolderClaim::FolderClaim(const std::filesystem::path& folder, std::uint64_t purpose)
    : descriptor_(opened(folder)) {
  const auto byte = static_cast<off_t>(purpose >> 2) + 1;  // neither the first nor the last
  struct flock mine {};
  mine.l_type = F_RDLCK;
  mine.l_start = byte;
  mine.l_len = 1;
  if (::fcntl(descriptor_, F_OFD_SETLK, &mine) != 0) return;
  alone_ = !others_hold(descriptor_, 0, byte) && !others_hold(descriptor_, byte + 1, 0);
}

FolderClaim::~FolderClaim() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace coppermoon::files

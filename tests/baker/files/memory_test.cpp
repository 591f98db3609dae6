// SPDX-License-Identifier: MIT
#include "files/memory.h"

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"

namespace memory_test {

using namespace coppermoon::files;

TEST(Memory, ThatThereIsNotIsRefused) {
  EXPECT_NO_THROW(require_memory("a.glb", 1));
  EXPECT_ERROR(require_memory("a.glb", 3e15), "a.glb: takes 3000000.0 GB of memory, allowed the ");
  EXPECT_GT(available_memory(), 1e6) << "of any machine on which this runs";
}

}  // namespace memory_test

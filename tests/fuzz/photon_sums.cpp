// SPDX-License-Identifier: MIT
// Files of --keep, a zero byte between: read, put together, and made light of.
#include "uses/light/photon_file.h"

#include <optional>
#include <string>

#include "fuzz/refused.h"
#include "fuzz/scratch_file.h"

namespace {

using namespace coppermoon;

void add(std::optional<shadow::PhotonSums>& all, std::string_view text) {
  static const fuzz::ScratchFile file("sums.json");
  auto sums = uses::read_sums(file.holding(text));
  const auto blocks = shadow::blocks_in(sums.done);
  all = all ? shadow::merged(std::move(*all), sums) : std::move(sums);
  fuzz::require(shadow::blocks_in(all->done) >= blocks);
}

/// All that the text holds.
void read(std::string_view text) {
  std::optional<shadow::PhotonSums> all;
  for (auto end = text.find('\0'); end != text.npos; end = text.find('\0')) {
    add(all, text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  add(all, text);
  const auto light = shadow::estimated(*all);
  fuzz::require(light.ratio.size() == all->sum.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::done([&] { read(fuzz::as_text(data, size)); });
  return 0;
}

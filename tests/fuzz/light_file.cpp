// SPDX-License-Identifier: MIT
// A film's eclipse.light with a fingerprint that is right: read, completed and looked up.
#include "uses/light/light_file.h"

#include <fmt/format.h>

#include <array>

#include "almanac/instant.h"
#include "files/fingerprint.h"
#include "fuzz/refused.h"
#include "fuzz/scratch_file.h"
#include "uses/light/spectral_bands.h"

namespace {

using namespace coppermoon;

/// The Moon of the film that finds the file in its folder.
uses::ShadowedMoon moon_of_film() {
  uses::LightRequest request;
  request.air.atmosphere = "paper";
  const std::array skies{almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z"))};
  return uses::moon_on_its_way(request, skies);
}

void read(std::string_view text) {
  static const fuzz::ScratchFile file("eclipse.light");
  static const auto moon = moon_of_film();
  auto kept = uses::read_light(
      file.holding(std::string(text) + fmt::format("{:016x}", files::fingerprint(text))));
  if (!kept || !uses::complete(moon, kept->light)) return;
  const auto lookup = kept->light.in_channels(uses::luminance_weights());
  std::array<double, 1> ratio{};
  lookup.read(moon.centre, ratio);
  fuzz::require(ratio[0] >= 0 && ratio[0] <= 1e15);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::done([&] { read(fuzz::as_text(data, size)); });
  return 0;
}

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "uses/light/air.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// The title in --help of all flags of the Earth's air.
inline constexpr const char* air_group = "The Earth's air";

/// The atmosphere and its terms; layers that a fit does not seek.
void add_air_but_sought(CLI::App& verb, uses::Air& air);

/// All of the air: also dust, cloud cover, ozone, Danjon's scale, regions.
void add_air_options(CLI::App& verb, uses::Air& air);

/// The air that was asked for, as titles name it: "standard air, stratospheric aerosol extreme".
std::string air_in_words(const CLI::App& verb);

/// Tells who waits when no air makes the eclipse as dark or as bright as --danjon asks.
void say_unless_danjon_is_reached(const uses::Air& air, const almanac::SkyState& sky);

/// What a region may say, and what it said once it was read.
class RegionReader {
 public:
  RegionReader();
  ~RegionReader();
  RegionReader(const RegionReader&) = delete;
  RegionReader& operator=(const RegionReader&) = delete;

  /// Given   text   "from-latitude=-90,to-latitude=0,dust-extinction=1e-5"
  /// Throws  Error  when it cannot be understood, or does not say where the region is
  const uses::AirRegion& read(const std::string& text);

  const CLI::App& app() const { return *app_; }

 private:
  std::unique_ptr<CLI::App> app_;
  uses::AirRegion region_;
};

}  // namespace coppermoon::verbs

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace coppermoon::texture {

/// Colour profile of an image file: an ICC profile, or primaries and a tone curve. Converts colours to linear Rec. 709.
class ColourProfile {
 public:
  /// Converts an ICC profile to a ColourProfile. It must be for grey if `channels` is 1, for RGB if it is 3.
  /// Returns nothing if the profile agrees with sRGB to within 1/200 of full scale in linear light.
  ///
  /// Throws  Error  when the profile is corrupt, or is for other channels, such as CMYK (the message then names it)
  static std::optional<ColourProfile> of_icc(std::string_view bytes, std::size_t channels);

  /// Makes a profile from x and y of red, green, blue and white. Linear light is the file's number raised to the given
  /// power or, without one, decoded by sRGB's curve. Returns nothing if x and y agree with Rec. 709 to within 1/200.
  ///
  /// Throws  Error  when no light can have these primaries
  static std::optional<ColourProfile> of_primaries(const std::array<double, 8>& xy,
                                                   std::optional<double> power);

  /// The profile for Adobe RGB (1998).
  static ColourProfile adobe_rgb();

  /// Converts coded texels, each of which has one or three numbers, to linear Rec. 709. Thread-safe.
  void light(const float* coded, float* rgb, std::size_t texels) const;

 private:
  explicit ColourProfile(std::shared_ptr<void> transform) : transform_(std::move(transform)) {}
  std::shared_ptr<void> transform_;
};

}  // namespace coppermoon::texture

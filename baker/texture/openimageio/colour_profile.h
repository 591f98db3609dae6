// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace coppermoon::texture {

/// Colours of light as a file means them, by which its numbers become linear Rec. 709. Of an ICC profile,
/// or of primaries and a curve.
class ColourProfile {
 public:
  /// An ICC profile, of grey for one channel, of red, green and blue for three. Nothing where it is
  /// sRGB's own, to a part in two hundred of full light.
  ///
  /// Throws  Error  when it is broken, or of other channels: names it
  static std::optional<ColourProfile> of_icc(std::string_view bytes, std::size_t channels);

  /// Red, green, blue and white as x and y; light is a power of the numbers, or by sRGB's curve. Nothing
  /// where they are Rec. 709's, to a two-hundredth.
  ///
  /// Throws  Error  when no light has such primaries
  static std::optional<ColourProfile> of_primaries(const std::array<double, 8>& xy,
                                                   std::optional<double> power);

  /// Profile of Adobe RGB (1998).
  static ColourProfile adobe_rgb();

  /// Linear Rec. 709 of coded texels, which have one or three numbers each; thread-safe.
  void light(const float* coded, float* rgb, std::size_t texels) const;

 private:
  explicit ColourProfile(std::shared_ptr<void> transform) : transform_(std::move(transform)) {}
  std::shared_ptr<void> transform_;
};

}  // namespace coppermoon::texture

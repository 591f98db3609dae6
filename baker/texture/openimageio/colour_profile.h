// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace coppermoon::texture {

/// What a file's numbers mean as colours, by which they become linear Rec. 709; made from an ICC profile,
/// or from primaries and a curve.
class ColourProfile {
 public:
  /// From an ICC profile, for grey if there is one channel, for red, green and blue if there are three. Nothing if it
  /// agrees with sRGB to within 1/200 of full light.
  ///
  /// Throws  Error  when the profile is broken or for other channels; names it
  static std::optional<ColourProfile> of_icc(std::string_view bytes, std::size_t channels);

  /// From x and y of red, green, blue and white; light is a power of the numbers or, if `power` is absent, follows
  /// sRGB's curve. Nothing if they are those of Rec. 709, to within 1/200.
  ///
  /// Throws  Error  when the primaries are impossible
  static std::optional<ColourProfile> of_primaries(const std::array<double, 8>& xy,
                                                   std::optional<double> power);

  /// The profile for Adobe RGB (1998).
  static ColourProfile adobe_rgb();

  /// Converts coded texels, which have one or three numbers each, to linear Rec. 709; thread-safe.
  void light(const float* coded, float* rgb, std::size_t texels) const;

 private:
  explicit ColourProfile(std::shared_ptr<void> transform) : transform_(std::move(transform)) {}
  std::shared_ptr<void> transform_;
};

}  // namespace coppermoon::texture

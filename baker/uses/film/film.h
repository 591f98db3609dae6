// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "uses/film/film_record.h"
#include "uses/film/film_times.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/development.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Stem of the numbered textures that POV-Ray reads.
inline constexpr const char* texture_stem = "moon_lin_rec709";

/// Kinds of files to make for each frame; if none, only the film's light is made.
struct Products {
  bool light = false, textures = false, scenes = false, frames = false, pictures = false;
  bool mipmapped = false;   ///< make textures tiled and mip-mapped: .tx
  bool high_range = false;  ///< add a second picture, of high dynamic range, to each

  bool light_alone() const { return !textures && !scenes && !frames && !pictures; }
  bool framed() const { return scenes || rendered(); }  ///< seen by a camera
  bool rendered() const { return frames || pictures; }
};

/// A film: its requests, its moments, its folder, and the light that all frames share.
struct Film {
  FrameRate fps = {};  ///< 1 to 1000
  MoonRequest moon;    ///< set_up sets its texture width
  ViewRequest view;
  Development development;
  TextureContent content;
  /// Stops between a picture and its under- and overexposed companions, 0.01 to 10
  std::optional<double> bracket_ev;
  Products products;
  std::filesystem::path folder;
  std::filesystem::path scene = {};  ///< the user's own, for POV-Ray; if empty, the Moon alone
  Moments moments{};
  FilmRecord record{};
  std::shared_ptr<const Moonlight> light{};
  std::shared_ptr<const algebra::Grid<float>> albedo{};  ///< at the textures' size
  std::shared_ptr<const surface::Ground> ground{};  ///< colour and surge at each place, if used
  /// exposure times [s] at moments, in order of time; if empty, as `development` says
  std::vector<std::pair<almanac::Instant, double>> time_keys{};

  /// Sky at the moment of a frame, which is numbered as in its files' names.
  almanac::SkyState sky(std::size_t frame) const;

  /// Paths of a frame's files. Linear ones are named after their colour space: "moon_lin_rec709.0007.exr",
  /// "frame_lin_rec709.0007.exr". Pictures are "frame.0007.png", "frame_under.0007.png" and "frame_hdr.0007.png" (high
  /// dynamic range).
  std::filesystem::path texture(std::size_t frame) const;
  std::filesystem::path linear_frame(std::size_t frame) const;
  std::filesystem::path picture(std::size_t frame, const char* stem = "frame") const;
  std::filesystem::path high_range_picture(std::size_t frame) const;

  /// All files of a frame that the products ask for.
  std::vector<std::filesystem::path> files(std::size_t frame) const;
};

/// The camera's view at a frame's moment; for a user's scene with its own camera, scene_view.
View view_of(const Film& film, const almanac::SkyState& sky);

/// The Moon of a film at a moment, as a view sees it; in full sunlight if the film is unshadowed.
LitMoon moon_of(const Film& film, const almanac::SkyState& sky, const View& view);

}  // namespace coppermoon::uses

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

/// Kinds of files that are made of each frame; without any, the film's light alone.
struct Products {
  bool light = false, textures = false, scenes = false, frames = false, pictures = false;
  bool mipmapped = false;   ///< textures are tiled and mip-mapped: .tx
  bool high_range = false;  ///< a second picture, of high dynamic range, beside each

  bool light_alone() const { return !textures && !scenes && !frames && !pictures; }
  bool framed() const { return scenes || rendered(); }  ///< by a camera
  bool rendered() const { return frames || pictures; }
};

/// Film: its requests, its moments, its folder, and the light that all frames share.
struct Film {
  FrameRate fps = {};  ///< 1 to 1000
  MoonRequest moon;    ///< set_up gives it a texture width
  ViewRequest view;
  Development development;
  TextureContent content;
  /// Stops between a picture and its under- and overexposed companions, 0.01 to 10
  std::optional<double> bracket_ev;
  Products products;
  std::filesystem::path folder;
  std::filesystem::path scene = {};  ///< of POV-Ray, of the user's own; empty: the Moon alone
  Moments moments{};
  FilmRecord record{};
  std::shared_ptr<const Moonlight> light{};
  std::shared_ptr<const algebra::Grid<float>> albedo{};  ///< at the textures' size
  std::shared_ptr<const surface::Ground> ground{};  ///< colour and surge by place, where they count
  /// exposure times [s] at moments, in order of time; empty: as `development` has it
  std::vector<std::pair<almanac::Instant, double>> time_keys{};

  /// Sky at the moment of a frame, which has the number of its files.
  almanac::SkyState sky(std::size_t frame) const;

  /// Paths of a frame's files. Linear ones are named by their space: "moon_lin_rec709.0007.exr",
  /// "frame_lin_rec709.0007.exr". Pictures: "frame.0007.png", "frame_under.0007.png", "frame_hdr.0007.png" (of high
  /// dynamic range).
  std::filesystem::path texture(std::size_t frame) const;
  std::filesystem::path linear_frame(std::size_t frame) const;
  std::filesystem::path picture(std::size_t frame, const char* stem = "frame") const;
  std::filesystem::path high_range_picture(std::size_t frame) const;

  /// All files of a frame, as the products ask for them.
  std::vector<std::filesystem::path> files(std::size_t frame) const;
};

/// View of the camera at a frame's moment; of a scene that has its own: scene_view.
View view_of(const Film& film, const almanac::SkyState& sky);

/// Moon of a film at a moment, as a view sees it; of an unshadowed film in full sunlight.
LitMoon moon_of(const Film& film, const almanac::SkyState& sky, const View& view);

}  // namespace coppermoon::uses

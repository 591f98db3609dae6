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

/// What a film's textures are called before their number where POV-Ray reads them.
inline constexpr const char* texture_stem = "moon_lin_rec709";

/// What is made of each frame; light alone is made where nothing else is.
struct Products {
  bool light = false, textures = false, scenes = false, frames = false, pictures = false;
  bool high_range = false;  ///< beside each picture another for screens of high dynamic range

  bool light_alone() const { return !textures && !scenes && !frames && !pictures; }
  bool framed() const { return scenes || rendered(); }  ///< by a camera
  bool rendered() const { return frames || pictures; }
};

/// What makes a film's frames, for as long as any is made.
struct Film {
  double fps = 24;   ///< frames in a second of the film, 1 to 1000
  MoonRequest moon;  ///< with its texture's width, once the film is set up
  ViewRequest view;
  Development development;
  TextureContent content;
  std::optional<double> bracket_ev;  ///< pictures so many stops under and over as well, 0.01 to 10
  Products products;
  std::filesystem::path folder;
  Moments moments{};
  FilmRecord record{};
  std::shared_ptr<const Moonlight> light{};
  std::shared_ptr<const algebra::Grid<float>> albedo{};  ///< at the textures' size
  std::shared_ptr<const surface::Ground> ground{};       ///< what else differs by place, if any
  /// exposures [s] at moments, in order of time; empty: as `development` says
  std::vector<std::pair<almanac::Instant, double>> time_keys{};

  almanac::SkyState sky(std::size_t frame) const;

  /// In the folder: "moon_lin_rec709.0007.exr" and "frame_lin_rec709.0007.exr" (the space they are in),
  /// "frame.0007.png", "frame_under.0007.png"; "frame_hdr.0007.png" is of high dynamic range.
  std::filesystem::path texture(std::size_t frame) const;
  std::filesystem::path linear_frame(std::size_t frame) const;
  std::filesystem::path picture(std::size_t frame, const char* stem = "frame") const;
  std::filesystem::path high_range_picture(std::size_t frame) const;

  /// All files that its products leave of a frame.
  std::vector<std::filesystem::path> files(std::size_t frame) const;
};

/// What a frame shows.
View view_of(const Film& film, const almanac::SkyState& sky);

}  // namespace coppermoon::uses

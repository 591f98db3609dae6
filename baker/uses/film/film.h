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

/// File-name stem of the numbered textures that POV-Ray reads.
inline constexpr const char* texture_stem = "moon_lin_rec709";

/// Kinds of files to make for each frame. If none is chosen, only light in the Earth's shadow is computed.
struct Products {
  bool light = false, textures = false, scenes = false, frames = false, pictures = false;
  bool mipmapped = false;   ///< whether textures are tiled, mip-mapped .tx files
  bool high_range = false;  ///< whether each picture also has a high-dynamic-range version

  bool light_alone() const { return !textures && !scenes && !frames && !pictures; }
  bool framed() const { return scenes || rendered(); }  ///< whether a camera is needed
  bool rendered() const { return frames || pictures; }
};

/// A film: what was requested, the moments of its frames, its folder, and the light that all frames share.
struct Film {
  FrameRate fps = {};  ///< frames per second, 1 to 1000
  MoonRequest moon;    ///< request for the Moon; set_up sets its texture width
  ViewRequest view;
  Development development;
  TextureContent content;
  /// Exposure difference in stops between a picture and its under- and overexposed versions, 0.01 to 10.
  std::optional<double> bracket_ev;
  Products products;
  std::filesystem::path folder;
  std::filesystem::path scene = {};  ///< user's POV-Ray scene; if empty, only the Moon is shown
  Moments moments{};
  FilmRecord record{};
  std::shared_ptr<const Moonlight> light{};
  std::shared_ptr<const algebra::Grid<float>> albedo{};  ///< map at the textures' resolution
  std::shared_ptr<const surface::Ground> ground{};       ///< maps of colour and surge, if used
  /// Exposure times [s] at certain moments, in order of time. If empty, `development` sets the exposure time.
  std::vector<std::pair<almanac::Instant, double>> time_keys{};

  /// The sky at a frame's moment. Frame numbers are those in the file names.
  almanac::SkyState sky(std::size_t frame) const;

  /// Paths of a frame's files. Names of linear files include their colour space: "moon_lin_rec709.0007.exr",
  /// "frame_lin_rec709.0007.exr". Pictures have names such as "frame.0007.png", "frame_under.0007.png" and
  /// "frame_hdr.0007.png" (high dynamic range).
  std::filesystem::path texture(std::size_t frame) const;
  std::filesystem::path linear_frame(std::size_t frame) const;
  std::filesystem::path picture(std::size_t frame, const char* stem = "frame") const;
  std::filesystem::path high_range_picture(std::size_t frame) const;

  /// Paths of all files that the film makes for a frame.
  std::vector<std::filesystem::path> files(std::size_t frame) const;
};

/// The camera's view at a frame's moment. For a user's scene, which has its own camera, it is the result of scene_view.
View view_of(const Film& film, const almanac::SkyState& sky);

/// The Moon at a moment of a film, as seen in a view. It is in full sunlight if the film leaves out the Earth's shadow.
LitMoon moon_of(const Film& film, const almanac::SkyState& sky, const View& view);

}  // namespace coppermoon::uses

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plan/plan.h"
#include "texture/image.h"
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

/// What a film's files say they were made from, and how to tell from a file whether it was made from
/// the same. An empty function: no file is of this film. Functions are called from any thread.
struct FilmRecord {
  texture::Attributes frame_header;  ///< attributes in each file of a frame, beside its number
  texture::Attributes film_header;   ///< attributes in each file made of many frames
  std::string
      light_key;  ///< lines, as "ozone-du = 200", that name all the light depends on but time
  std::string film_key;  ///< tells the film from others, whatever is made of it

  /// Whether a file was made from the same, as far as that file depends on it.
  std::function<bool(const std::filesystem::path& file)> made_alike = {};
  /// The same for a linear frame's pixels, whatever its exposure.
  std::function<bool(const std::filesystem::path& frame)> shows_the_same = {};
  /// What a file holds that is not of this film, in words; empty where it is of it, or damaged. Work
  /// need not be planned yet.
  std::function<std::string(const std::filesystem::path& file)> foreign_contents = {};
  /// What two light keys differ in, for who asked for the second, in words.
  std::function<std::string(const std::string& there, const std::string& asked)> differences = {};
  /// A light key with the work that was planned, in place of what it was planned from: what a frame's
  /// header says.
  std::function<std::string(const std::string& light_key, const plan::Work& work)> planned_key = {};
  std::string way_out;  ///< ends a refusal of another film's files, behind "allowed another folder"
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

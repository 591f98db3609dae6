// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "verbs/baked_moon.h"
#include "verbs/develop_options.h"
#include "verbs/film_times.h"
#include "verbs/observer_options.h"

namespace coppermoon::verbs {

/// What a film's textures are called before their number where POV-Ray reads them.
inline constexpr const char* texture_stem = "moon_lin_rec709";

/// What is made of each frame.
struct Products {
  bool light = false, textures = false, scenes = false, frames = false, pictures = false;

  bool light_alone() const { return !textures && !scenes && !frames && !pictures; }
  bool framed() const { return scenes || rendered(); }  ///< by a camera
  bool rendered() const { return frames || pictures; }
};

/// "light" alone, or "textures", "scenes" (with their textures), "frames", "pictures", with commas between.
///
/// Throws  Error  when one of them is none
Products products_from(const std::string& text);

/// What makes a film's frames, for as long as any is made.
struct Film {
  FilmTimes times;
  MoonOptions moon;  ///< with its texture's width
  ViewOptions view;
  DevelopOptions develop;
  TextureOptions content;
  std::optional<double> bracket_ev;  ///< pictures so much under and over as well
  Products products;
  std::filesystem::path folder;
  Moments moments{};
  std::string recipe{};  ///< in each file's header, beside the frame's number
  std::string map_contents{}, view_contents{};  ///< fingerprints of what stands in files
  std::shared_ptr<const Moonlight> light{};
  std::shared_ptr<const algebra::Grid<float>> albedo{};
  std::vector<std::pair<almanac::Instant, double>> time_keys{};  ///< exposures [s]

  almanac::SkyState sky(std::size_t frame) const;

  /// In the folder: "moon_lin_rec709.0007.exr" (the space it is in), "frame_lin_rec709.0007.exr", "frame.0007.png", "frame_under.0007.png".
  std::filesystem::path texture(std::size_t frame) const;
  std::filesystem::path linear_frame(std::size_t frame) const;
  std::filesystem::path picture(std::size_t frame, const char* stem = "frame") const;

  /// All that its products leave of a frame.
  std::vector<std::filesystem::path> files(std::size_t frame) const;
};

/// What a frame shows.
View view_of(const Film& film, const almanac::SkyState& sky);

/// A frame that was made: its number, and the exposure of its picture.
struct MadeFrame {
  std::size_t frame;
  std::optional<double> time_s;
};

/// Makes frames, some at a time, as memory and processors allow.
///
/// Given   made   told each frame once its files are there, from any thread, one at a time
/// Throws  Error  the first that any frame met; those under way are then left
void make_frames(const Film& film, const std::vector<std::size_t>& frames,
                 const std::function<void(const MadeFrame&)>& made);

/// The POV-Ray scene of all frames, beside their textures.
void write_film_scene(const Film& film);

}  // namespace coppermoon::verbs

// SPDX-License-Identifier: MIT
#include "povray_scenes/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string_view>

#include "algebra/error.h"
#include "povray_scenes/moon_scene.h"
#include "povray_scenes/process.h"
#include "povray_scenes/scene_text.h"

namespace coppermoon::povray_scenes {
namespace {

using algebra::Error;

constexpr const char *first_frame_key = "Subset_Start_Frame=",
                     *last_frame_key = "Subset_End_Frame=";

std::size_t digits(std::size_t last) {
  return std::max(std::to_string(last).size(), std::size_t{4});
}

MoonScene single_scene(const Sequence& sequence, std::size_t frame) {
  return {.camera = sequence.cameras[frame - sequence.first_frame],
          .texture = numbered_file(sequence.textures, frame, sequence.last_frame()),
          .lights = {},
          .alpha = sequence.alpha};
}

void require_same_picture(const SceneCamera& camera, const SceneCamera& first) {
  if (camera.width == first.width && camera.height == first.height &&
      camera.horizontal_field == first.horizontal_field)
    return;
  const auto picture = [](const SceneCamera& of) {
    return fmt::format("{} x {} pixels, {} degrees wide", of.width, of.height,
                       in_degrees(of.horizontal_field));
  };
  throw Error(fmt::format("picture = {}, allowed: that of the first frame, {}", picture(camera),
                          picture(first)));
}

void require_frame(const Sequence& sequence, std::size_t frame) {
  try {
    require_renderable(single_scene(sequence, frame));
    require_same_picture(sequence.cameras[frame - sequence.first_frame], sequence.cameras[0]);
  } catch (const Error& error) {
    throw Error(fmt::format("frame {}: {}", frame, error.what()));
  }
}

void require_renderable(const Sequence& sequence) {
  constexpr double most = 999999;
  algebra::require_within("frames", static_cast<double>(sequence.cameras.size()), 1, most);
  algebra::require_within("last frame", static_cast<double>(sequence.last_frame()), 0, most);
  for (auto frame = sequence.first_frame; frame <= sequence.last_frame(); ++frame)
    require_frame(sequence, frame);
}

/// An array with one element for each frame, as text for POV-Ray.
template <class ElementOf>
std::string array(std::string_view name, const std::vector<CameraText>& frames, ElementOf element) {
  std::string text = fmt::format("#declare {} {{\n", name);
  for (const auto& frame : frames)
    text += fmt::format("  {}{}\n", element(frame), &frame == &frames.back() ? "" : ",");
  return text + "}\n";
}

std::string squash_or_none(const CameraText& frame) {
  return fmt::format("{{ {} }}", frame.squash.empty() ? "1, 0, 0, 0, 1, 0, 0, 0, 1" : frame.squash);
}

std::string declarations(const Sequence& sequence, const std::vector<CameraText>& frames,
                         bool flattened) {
  const auto n = frames.size();
  auto text = fmt::format(R"(#if (frame_number > {1})
  #error concat("frame ", str(frame_number, 0, 0), ": this sequence has frames {0} to {1}\n")
#end
#declare Frame = max(frame_number, {0}) - {0};
)",
                          sequence.first_frame, sequence.last_frame());
  text += array(fmt::format("Location = array[{}]", n), frames, [](auto& f) { return f.location; });
  text += array(fmt::format("Sky = array[{}]", n), frames, [](auto& f) { return f.sky; });
  text += array(fmt::format("Look_At = array[{}]", n), frames, [](auto& f) { return f.look_at; });
  if (!flattened) return text;
  text += array(fmt::format("Flattened = array[{}]", n), frames,
                [](auto& f) { return f.squash.empty() ? "0" : "1"; });
  return text + array(fmt::format("Squash = array[{}][9]", n), frames, squash_or_none);
}

constexpr const char* squashed_sphere = R"(  #if (Flattened[Frame])
    matrix <Squash[Frame][0], Squash[Frame][1], Squash[Frame][2],
            Squash[Frame][3], Squash[Frame][4], Squash[Frame][5],
            Squash[Frame][6], Squash[Frame][7], Squash[Frame][8], 0, 0, 0>
  #end
)";

/// The number of the first or last frame, read from the eclipse.ini in a sequence's folder.
std::size_t frame_in_settings(const std::filesystem::path& folder, std::string_view key) {
  std::ifstream settings(folder / settings_file);
  for (std::string line; std::getline(settings, line);)
    if (std::size_t number = 0;
        line.starts_with(key) &&
        std::from_chars(line.data() + key.size(), line.data() + line.size(), number).ec ==
            std::errc())
      return number;
  throw Error(fmt::format("{}: no sequence of frames", (folder / settings_file).string()));
}

/// Passes each frame of a run to a callback when it is finished.
struct Delivery {
  const Draft& draft;
  const FrameDone& frame_done;
  const RenderSettings& settings;
  std::size_t next, of;

  void hand_over_before(std::size_t end) {
    for (; next < end; ++next) {
      const auto file = draft.finish(numbered_file({}, next, of),
                                     numbered_file(frame_stem, next, of), settings.povray);
      frame_done(next, file);
    }
  }
};

}  // namespace

std::string numbered_file(const std::string& stem, std::size_t frame, std::size_t last) {
  return fmt::format("{}.{:0{}}.exr", stem, frame, digits(last));
}

std::string to_pov(const Sequence& sequence) {
  require_renderable(sequence);
  std::vector<CameraText> frames;
  for (const auto& camera : sequence.cameras) frames.push_back(camera_text(camera));
  const bool flattened = !std::ranges::all_of(frames, &std::string::empty, &CameraText::squash);
  return pov_text(single_scene(sequence, sequence.first_frame),
                  {.declarations = declarations(sequence, frames, flattened),
                   .location = "Location[Frame]",
                   .sky = "Sky[Frame]",
                   .look_at = "Look_At[Frame]",
                   .texture = fmt::format(R"(concat("{}.", str(Frame + {}, -{}, 0), ".exr"))",
                                          sequence.textures, sequence.first_frame,
                                          digits(sequence.last_frame())),
                   .flattened = flattened ? squashed_sphere : ""});
}

std::string to_ini(const Sequence& sequence) {
  require_renderable(sequence);
  const std::size_t first = sequence.first_frame, last = sequence.last_frame();
  return ini_text(
      single_scene(sequence, first), fmt::format("{}..exr", frame_stem),
      fmt::format("Initial_Frame={}\nFinal_Frame={}\n{}{}\n{}{}\n", first,
                  std::string(digits(last), '9'), first_frame_key, first, last_frame_key, last));
}

void write_sequence(const std::filesystem::path& folder, const Sequence& sequence) {
  write_texts(folder, to_pov(sequence), to_ini(sequence));
}

void render_sequence(const std::filesystem::path& folder, std::size_t first, std::size_t last,
                     const FrameDone& frame_done, const RenderSettings& settings) {
  const Draft draft(folder);
  const std::size_t from = frame_in_settings(folder, first_frame_key),
                    of = frame_in_settings(folder, last_frame_key);
  algebra::require_within("last frame", static_cast<double>(last), static_cast<double>(from),
                          static_cast<double>(of));
  algebra::require_within("first frame", static_cast<double>(first), static_cast<double>(from),
                          static_cast<double>(last));
  Delivery delivery{draft, frame_done, settings, first, of};
  run_povray(settings, draft,
             {.output = draft.stem + "..exr",
              .subset = {fmt::format("+SF{}", first), fmt::format("+EF{}", last)},
              .begun = [&](std::size_t begun) {
                delivery.hand_over_before(std::min(first + begun - 1, last + 1));
              }});
  delivery.hand_over_before(last + 1);
}

}  // namespace coppermoon::povray_scenes

// SPDX-License-Identifier: MIT
#include "povray_scenes/own_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "files/whole_file.h"
#include "povray_scenes/process.h"
#include "povray_scenes/scene.h"
#include "povray_scenes/scene_text.h"

namespace coppermoon::povray_scenes {
namespace {

namespace fs = std::filesystem;

constexpr const char* beside_scene = "scene_folder";  ///< link to it; in messages

/// Name for the scene that POV-Ray reads in its settings: its own, so that messages name it, where that is plain.
std::string plain_name(const fs::path& file) {
  const auto name = file.filename().string();
  const bool plain = std::ranges::all_of(
      name, [](char c) { return c > ' ' && c <= '~' && c != '"' && c != '\\' && c != ';'; });
  return plain ? name : "scene.pov";
}

}  // namespace

fs::path render_own(const fs::path& folder, const OwnScene& scene, const RenderSettings& settings) {
  const auto file = fs::absolute(scene.file);
  const auto name = plain_name(file);
  fs::create_symlink(file, folder / name);
  fs::create_directory_symlink(file.parent_path(), folder / beside_scene);
  const auto last = std::max(scene.last, scene.first + 1);  // a range of one has no clock
  MoonScene picture{.camera = {}, .texture = {}};
  picture.camera.width = scene.width;
  picture.camera.height = scene.height;
  files::write_whole(
      folder / settings_file,
      ini_text(picture, frame_file,
               fmt::format("Input_File_Name={}\nLibrary_Path={}\nInitial_Frame={}\nFinal_Frame={}\n"
                           "Final_Clock=1\nHigh_Reproducibility=on\n",
                           name, beside_scene, scene.first, last)));
  const Draft draft(folder);
  run_povray(settings, draft,
             {.output = draft.stem + "..exr",
              .subset = {fmt::format("+SF{}", scene.frame), fmt::format("+EF{}", scene.frame)},
              .with_users_settings = true});
  return draft.finish(fmt::format(".{:0{}}.exr", scene.frame, std::to_string(last).size()),
                      frame_file, settings.povray);
}

}  // namespace coppermoon::povray_scenes

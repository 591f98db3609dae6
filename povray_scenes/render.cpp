// SPDX-License-Identifier: MIT
#include "povray_scenes/render.h"

#include <fmt/format.h>

#include <algorithm>

#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "povray_scenes/moon_scene.h"
#include "povray_scenes/process.h"
#include "povray_scenes/scene_text.h"

namespace coppermoon::povray_scenes {

std::filesystem::path render(const std::filesystem::path& folder, const RenderSettings& settings,
                             const algebra::Progress& progress) {
  const Draft draft(folder);
  run_povray(settings, draft, {.output = draft.stem + ".exr", .progress = progress});
  auto frame = draft.finish(".exr", frame_file, settings.povray);
  if (progress) progress(1);
  return frame;
}

void render_for(const std::function<void(const std::filesystem::path& exr)>& read,
                const std::filesystem::path& folder, const RenderSettings& settings,
                const algebra::Progress& progress) {
  const Draft draft(folder);
  const auto output = draft.stem + ".exr";
  run_povray(settings, draft, {.output = output, .progress = progress, .until_closed = true});
  const auto file = draft.finish(".exr", output, settings.povray);
  if (progress) progress(1);
  read(file);
}

std::filesystem::path render_own(const std::filesystem::path& folder, const OwnScene& scene,
                                 const RenderSettings& settings) {
  const auto file = std::filesystem::absolute(scene.file);
  files::name_also(file, folder / "scene.pov");  // POV-Ray accepts only plain file names
  std::error_code failed;
  std::filesystem::create_directory_symlink(file.parent_path(), folder / "scene_folder", failed);
  const auto library = failed ? fmt::format("\"{}\"", file.parent_path().string()) : "scene_folder";
  const auto last = std::max(scene.last, scene.first + 1);  // a single frame would have no clock
  MoonScene picture{.camera = {}, .texture = {}};
  picture.camera.width = scene.width;
  picture.camera.height = scene.height;
  files::write_whole(
      folder / settings_file,
      ini_text(picture, frame_file,
               fmt::format("Input_File_Name=scene.pov\nLibrary_Path={}\nInitial_Frame={}\n"
                           "Final_Frame={}\nHigh_Reproducibility=on\n",
                           library, scene.first, last)));
  const Draft draft(folder);
  run_povray(settings, draft,
             {.output = draft.stem + "..exr",
              .subset = {fmt::format("+SF{}", scene.frame), fmt::format("+EF{}", scene.frame)},
              .with_users_settings = true});
  return draft.finish(fmt::format(".{:0{}}.exr", scene.frame, std::to_string(last).size()),
                      frame_file, settings.povray);
}

}  // namespace coppermoon::povray_scenes

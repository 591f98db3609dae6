// SPDX-License-Identifier: MIT
#include "povray_scenes/render.h"

#include "povray_scenes/process.h"
#include "povray_scenes/scene.h"

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

}  // namespace coppermoon::povray_scenes

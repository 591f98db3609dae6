// SPDX-License-Identifier: MIT
#include "povray_scenes/render.h"

#include "povray_scenes/process.h"
#include "povray_scenes/scene.h"

namespace coppermoon::povray_scenes {

std::filesystem::path render(const std::filesystem::path& folder, const RenderSettings& settings,
                             const algebra::Progress& progress) {
  const Draft draft(folder);
  run_povray(settings, draft, {.output = draft.stem + ".exr", .progress = progress});
  const auto frame = draft.finish(".exr", frame_file, settings.povray);
  if (progress) progress(1);
  return frame;
}

}  // namespace coppermoon::povray_scenes

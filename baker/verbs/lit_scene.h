// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verbs/baked_moon.h"
#include "verbs/observer_options.h"

namespace coppermoon::verbs {

/// A scene made: what it holds, and for whom.
struct LitScene {
  LitMoon moon;
  View view;
  BakedMoon texture;
};

/// A view with what its frame does not show left out: the flattening of a disc by less than a quarter
/// of a pixel.
struct FrameView {
  View view;
  std::vector<std::string> left_out;
};

/// Who writes into a folder for as long as this is there; another waits. On a file system without
/// locks none does.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

/// Throws  Error  as view_of
FrameView view_for_frame(const ViewOptions& options, const almanac::SkyState& sky);

/// A texture without a width of its own has as many texels around the equator as the middle of the
/// disc has pixels: π times the disc's diameter; half as many for a draft.
MoonOptions fitted(MoonOptions moon, const povray_scenes::Camera& camera);

/// The view, and the Moon ready to be baked: all of a scene but its files.
LitScene lit_scene(const MoonOptions& options, const ViewOptions& view, const std::string& recipe,
                   texture::Extent extent = texture::Extent::whole);

/// Bakes the texture, and writes it, scene and settings into a folder, made when only its last part
/// is missing; a folder made so is gone again when they cannot be written.
void write_lit_scene(const std::filesystem::path& folder, const LitScene& scene,
                     const texture::ExrOptions& options = {});

}  // namespace coppermoon::verbs

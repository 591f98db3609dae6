// SPDX-License-Identifier: MIT
#pragma once

#include "uses/picture/development.h"
#include "uses/picture/lit_scene.h"

namespace coppermoon::uses {

/// A scene-linear frame of a scene, linear Rec.709 [cd/m²]: POV-Ray renders it in a folder that is gone
/// afterwards.
///
/// Throws  Error  when POV-Ray is not there, or fails
texture::Image rendered(const LitScene& scene, const algebra::Progress& progress = {});

/// A frame's header: the texture's, and the exposure and what a camera has to know of it.
texture::Attributes frame_header(const LitScene& scene, const Exposures& exposures);

/// Writes a frame in a working space, which its header says.
///
/// Given  frame  linear Rec.709, with its header
void write_frame(const std::filesystem::path& file, const texture::Image& frame,
                 texture::Attributes header, colour::WorkingSpace space);

}  // namespace coppermoon::uses

// SPDX-License-Identifier: MIT
#pragma once

#include "texture/write_image.h"
#include "uses/picture/development.h"
#include "uses/picture/lit_scene.h"

namespace coppermoon::uses {

/// A scene-linear frame of a scene, linear Rec.709 [cd/m²]: POV-Ray renders the Moon in a folder that is gone
/// afterwards, and the stars of the view are added (see sky_lights).
///
/// Throws  Error  when POV-Ray is not there, or fails; when a catalogue of stars is damaged
texture::Image rendered(const LitScene& scene, const algebra::Progress& progress = {});

/// A frame's header: the texture's, and the exposure and what a camera has to know of it.
texture::Attributes frame_header(const LitScene& scene, const Exposures& exposures);

/// How a frame's numbers are stored: as half floats, where no star is brighter than these go.
texture::ExrType frame_type(const texture::Image& frame);

/// Writes a frame in a working space, which its header says.
///
/// Given  frame  linear Rec.709, with its header
void write_frame(const std::filesystem::path& file, const texture::Image& frame,
                 texture::Attributes header, colour::WorkingSpace space);

}  // namespace coppermoon::uses

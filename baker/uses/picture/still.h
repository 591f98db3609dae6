// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "texture/write_image.h"
#include "uses/picture/development.h"
#include "uses/picture/lit_scene.h"
#include "uses/picture/sky_lights.h"

namespace coppermoon::uses {

/// Scene-linear frame [cd/m²].
struct LinearFrame {
  texture::Image light;  ///< channels R, G, B: Moon and stars, and the sky but for passes
  /// R, G, B, A: the Moon without stars, its colours times the share of the pixel that is seen of it; empty unless
  /// passes are asked for
  texture::Image moon = {};
  texture::Image sky =
      {};  ///< of passes, R, G, B: light of the air before and beside the Moon; empty: none

  /// Moon, stars and sky together.
  texture::Image whole() const;
};

/// Completes a frame of POV-Ray, linear Rec.709: adds stars and planets and the sky's light, and hides what is below the
/// horizon.
///
/// Given     rendered  with a channel A where passes are asked for
/// Returned  without passes, numbers that half floats hold
LinearFrame completed(texture::Image rendered, const View& view, const almanac::SkyState& sky,
                      std::span<const SkyLight> lights, const FrameSky& air);

/// Frame of a scene, linear Rec.709: POV-Ray renders the Moon in a folder that is gone afterwards, and the stars of
/// the view and the sky's light are added.
///
/// Throws  Error  when POV-Ray is not there, or fails; when a catalogue of stars is damaged
LinearFrame rendered(const LitScene& scene, bool passes = false,
                     const algebra::Progress& progress = {});

/// Memory that a frame takes while it is rendered and developed [bytes]: 75 a pixel, measured at 3000 x 3000; through a
/// camera 128 more, for its glow.
double frame_memory(std::size_t width, std::size_t height, bool through_camera = false);

/// Frame in another working space.
LinearFrame in_space(const LinearFrame& frame, colour::WorkingSpace from, colour::WorkingSpace to);

/// A frame's header: the texture's, and the exposure and what a camera has to know of it.
texture::Attributes frame_header(const LitScene& scene, const Exposures& exposures);

/// Writes a frame: its numbers are half floats, where no star is brighter than these go.
///
/// With passes the file has parts:
///
///     rgba      R, G, B, A: the frame, and the share of the pixel that the Moon covers, by which its colours are multiplied;
///               floats where there is a sky
///     moon      moon.R and so on: the same without sky and stars
///     sky       sky.R, sky.G, sky.B, floats: the sky's light; no part of a black sky
///     stars     stars.R, stars.G, stars.B, floats: rgba is moon + sky + stars, added so in floats, exactly as they are stored
///     position  position.X, position.Y, position.Z, floats: place on the Moon in the pixel's middle, Moon-fixed (X to
///               longitude 0, Y to 90° east, Z north), in radii; 0 beside the Moon
///
/// Given  camera  of the frame; for passes alone
///        header  says the frame's space
void write_frame(const std::filesystem::path& file, const LinearFrame& frame,
                 const povray_scenes::SceneCamera& camera, const texture::Attributes& header);

}  // namespace coppermoon::uses

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
  texture::Image light;  ///< R, G, B: Moon and stars; without passes, also the sky
  /// R, G, B, A: the Moon without stars. A is the share of a pixel in which the Moon is seen. The colours are already
  /// multiplied by A. Empty unless passes are requested.
  texture::Image moon = {};
  texture::Image sky =
      {};  ///< R, G, B: the sky's light, in front of and around the Moon; empty without passes

  /// Moon, stars and sky together.
  texture::Image whole() const;
};

/// Completes a frame from POV-Ray, linear Rec.709: adds stars, planets and the sky's light, and hides what is below the
/// horizon.
///
/// Given     rendered  with a channel A if passes are requested
/// Returned  if passes are not requested, the numbers are rounded to half floats
LinearFrame completed(texture::Image rendered, const View& view, const almanac::SkyState& sky,
                      std::span<const SkyLight> lights, const FrameSky& air);

/// Renders a scene's frame, linear Rec.709: POV-Ray renders the Moon in a temporary folder, and then the view's stars
/// and the sky's light are added.
///
/// Throws  Error  when POV-Ray is missing or fails; when a star catalogue is damaged
LinearFrame rendered(const LitScene& scene, bool passes = false,
                     const algebra::Progress& progress = {});

/// Memory for rendering and developing a frame [bytes]: 75 per pixel, measured at 3000 x 3000 pixels. A camera needs
/// 128 more per pixel to compute the light that its optics and the air scatter (glow).
double frame_memory(std::size_t width, std::size_t height, bool through_camera = false);

/// Converts a frame to another working space.
LinearFrame in_space(const LinearFrame& frame, colour::WorkingSpace from, colour::WorkingSpace to);

/// A frame's header: that of the texture, with the exposure and the facts needed for development (SeenFrame) added.
texture::Attributes frame_header(const LitScene& scene, const Exposures& exposures);

/// Writes a frame, as half floats unless a star is too bright for them.
///
/// With passes, the file has these parts:
///
///     rgba      R, G, B, A: the frame. A is the share of the pixel that the Moon covers, and the Moon's colours are
///               already multiplied by A; stored as floats if there is a sky
///     moon      moon.R, moon.G, moon.B, moon.A: the frame without sky and stars
///     sky       sky.R, sky.G, sky.B, floats: the sky's light; left out if the sky is black
///     stars     stars.R, stars.G, stars.B, floats: rgba is exactly moon + sky + stars, added as floats in this order
///     position  position.X, position.Y, position.Z, floats: point of the Moon in the pixel's middle, Moon-fixed (X to
///               longitude 0, Y to 90° east, Z north), in lunar radii; 0 outside the Moon
///
/// Given  camera  of the frame; used only for passes
///        header  names the frame's colour space
void write_frame(const std::filesystem::path& file, const LinearFrame& frame,
                 const povray_scenes::SceneCamera& camera, const texture::Attributes& header);

}  // namespace coppermoon::uses

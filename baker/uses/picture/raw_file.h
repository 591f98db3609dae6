// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "colour/photograph.h"
#include "texture/image.h"
#include "uses/picture/camera.h"

namespace coppermoon::uses {

/// Refuses a raw file before its photograph is taken.
///
/// Throws  Error  when it ends neither in .tif nor in .dng, or is a .dng of a sensor without colours
void require_raw_file(const std::filesystem::path& file, const colour::Camera& camera);

/// Writes what the sensor counted: all three channels of every pixel into a .tif; into a .dng one channel
/// of each, as the sensor's mosaic of colour filters has it, for raw converters. White under D65 is its
/// as-shot white balance.
///
/// Given   attributes  moment and exposure become EXIF's
/// Throws  Error       as require_raw_file and texture::write_dng
void write_raw(const std::filesystem::path& file, const CameraRequest& request,
               const colour::Camera& camera, double iso, const colour::Photograph& photograph,
               const texture::Attributes& attributes);

}  // namespace coppermoon::uses

// SPDX-License-Identifier: MIT
#pragma once

#include "texture/contact_sheet.h"
#include "texture/read_image.h"
#include "texture/write_dng.h"
#include "texture/write_glb.h"
#include "texture/write_image.h"
#include "texture/write_usdz.h"

namespace coppermoon::texture {

/// All functions that need OpenImageIO. The program does not contain them. When it first calls one, it loads all of
/// them from a module, coppermoon_images.so (see image_module.cpp and loaded_images.cpp). Other programs get these
/// functions from the library and do not use this struct.
struct ImageFunctions {
  const char* version;  ///< version of coppermoon to which the functions belong

  decltype(texture::read_image)* read_image;
  decltype(texture::read_channels)* read_channels;
  decltype(texture::windows_of)* windows_of;
  decltype(texture::read_attributes)* read_attributes;
  decltype(texture::read_light)* read_light;
  decltype(texture::is_raw_file)* is_raw_file;
  decltype(texture::read_albedo_map)* read_albedo_map;
  decltype(texture::require_albedo_map)* require_albedo_map;

  void (*write_exr)(const std::filesystem::path&, const Image&, const Attributes&,
                    const ExrOptions&);
  void (*write_exr_of_parts)(const std::filesystem::path&, std::span<const Part>, const Attributes&,
                             const ExrOptions&);
  decltype(texture::write_mipmapped)* write_mipmapped;
  decltype(texture::write_picture)* write_picture;
  decltype(texture::write_png)* write_png;
  decltype(texture::write_tiff)* write_tiff;
  decltype(texture::write_dng)* write_dng;
  decltype(texture::write_glb)* write_glb;
  decltype(texture::write_usdz)* write_usdz;

  decltype(texture::sheet_font)* sheet_font;
  decltype(texture::drawn)* drawn;
  decltype(texture::write_captions)* write_captions;
};

/// Name of the only function that the module exports.
inline constexpr const char* image_functions_name = "coppermoon_image_functions";

/// Type of the only function that the module exports; image_functions_name is its name.
using GiveImageFunctions = const ImageFunctions*();

}  // namespace coppermoon::texture

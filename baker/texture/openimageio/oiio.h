// SPDX-License-Identifier: MIT
// OpenImageIO with the fmt that all else here has. Included first it would compile another, whose functions have the
// same names and end the program where ours throw; they would also be reason enough to link whatever has them.
#pragma once

#include <fmt/format.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/tiffutils.h>

// SPDX-License-Identifier: MIT
// OpenImageIO with the same fmt as the rest of the program. Included first, OpenImageIO would compile another fmt. Its
// functions have the same names but end the program where ours throw; whatever contains them would be linked as well.
#pragma once

#include <fmt/format.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/tiffutils.h>

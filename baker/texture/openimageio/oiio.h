// SPDX-License-Identifier: MIT
// Includes OpenImageIO after fmt, so that it uses the program's fmt. Otherwise it would compile its own copy, whose
// functions have the same names but end the program where ours throw, and which might be linked in place of ours.
#pragma once

#include <fmt/format.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/tiffutils.h>

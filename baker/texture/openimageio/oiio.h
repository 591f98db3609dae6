// SPDX-License-Identifier: MIT
// Includes fmt before OpenImageIO, so that OpenImageIO uses the program's fmt. Its own copy of fmt has functions of the
// same names, which abort where ours throw, and which might be linked in place of ours.
#pragma once

#include <fmt/format.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/tiffutils.h>

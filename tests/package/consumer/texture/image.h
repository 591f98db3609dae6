// SPDX-License-Identifier: MIT
#pragma once

/// The consumer's own, of the same name as one of ours: each finds its own.
namespace consumer {
inline constexpr const char* texture = "its own texture/image.h";
}

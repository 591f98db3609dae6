// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/picture/development.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// "auto", "follow", "composite" or seconds.
///
/// Throws  Error  when the text is none of them
uses::ExposureTime exposure_time_from(const std::string& text);

/// --time as text, for who reads more than an exposure time in it.
void add_time_option(CLI::App& verb, std::string& time);

/// All but --time: f-number, ISO speed, view, display, configuration, bits.
void add_picture_options(CLI::App& verb, uses::Development& development);

/// All of how a frame is exposed and developed.
void add_develop_options(CLI::App& verb, uses::Development& development);

}  // namespace coppermoon::verbs

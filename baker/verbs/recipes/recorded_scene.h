// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/picture/lit_scene.h"
#include "verbs/flags/flags.h"
#include "verbs/flags/moon_options.h"
#include "verbs/reports/report.h"

namespace coppermoon::verbs {

/// Computes the lit scene that the flags describe, and stores its recipe in the texture's header. Shows a progress bar
/// while light is computed.
///
/// Given   baking  receives the progress of writing the texture
/// Throws  Error  like moon_request, eclipsed_sky and uses::lit_scene
uses::LitScene lit_scene(const Verb& verb, const MoonOptions& moon, const uses::ViewRequest& view,
                         uses::Baking baking);

/// Report on a file that was made from a lit scene.
Report report_of(const std::string& file, const uses::LitScene& scene, double seconds);

}  // namespace coppermoon::verbs

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/picture/lit_scene.h"
#include "verbs/flags/flags.h"
#include "verbs/flags/moon_options.h"
#include "verbs/reports/report.h"

namespace coppermoon::verbs {

/// Lit scene that the flags describe, with its recipe in the texture's header. A progress bar shows how the computation
/// of light proceeds.
///
/// Given   baking  receives the progress of the texture while its file is written
/// Throws  Error  as moon_request, eclipsed_sky, uses::lit_scene
uses::LitScene lit_scene(const Verb& verb, const MoonOptions& moon, const uses::ViewRequest& view,
                         uses::Baking baking);

/// Report on a file made from a scene.
Report report_of(const std::string& file, const uses::LitScene& scene, double seconds);

}  // namespace coppermoon::verbs

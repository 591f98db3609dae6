// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "uses/film/film.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Job of a film for a render farm: a template of Open Job Description, revision 2023-09, in YAML. The step `frames`
/// has a task for each shard; the step `film`, after it, makes what needs every frame. The job's parameters are the
/// program, the folder that it runs in, the number of shards, and each file or folder that the command names;
/// a path when it stands in the job's folder, else a text, since a template may not name paths elsewhere.
///
/// Given   verb      `animate`, its flags read: the tasks get those that were given, a recipe's among them
///         job_file  in the current folder or above it: names of files are written relative to its folder
/// Throws  Error     for another file; for a flag with {{, which a template would take for a name of its own
std::string film_job(const Verb& verb, const uses::Film& film,
                     const std::filesystem::path& job_file);

}  // namespace coppermoon::verbs

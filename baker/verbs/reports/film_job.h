// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "uses/film/film.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Job that makes a film on a render farm, as an Open Job Description template in YAML (revision 2023-09). The step
/// `frames` has a task for each shard. The step `film` follows and makes what depends on all frames. The parameters of
/// the job are the program, the folder in which it runs, the number of shards, and each file or folder that the command
/// names. A file in the job's folder is passed as a path, any other as a string, because a template must not contain
/// paths outside its folder.
///
/// Given   verb      `animate` with its flags set; the tasks receive all flags that the user or a recipe gave
///         job_file  in the current folder or a folder above it; file names are written relative to its folder
/// Throws  Error     for a job file elsewhere; for a flag that contains {{, which a template would interpret
std::string film_job(const Verb& verb, const uses::Film& film,
                     const std::filesystem::path& job_file);

}  // namespace coppermoon::verbs

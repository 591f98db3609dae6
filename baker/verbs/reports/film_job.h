// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "uses/film/film.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Job that makes a film on a render farm: an Open Job Description template, revision 2023-09, in YAML. Its step
/// `frames` has a task for each shard; the later step `film` makes what depends on all frames. The job's parameters
/// are the program, the folder in which it runs, the number of shards, and each file or folder that the command names.
/// One that lies in the job's folder is a path; another is a string, since a template may not name paths elsewhere.
///
/// Given   verb      `animate` with its flags set: the tasks get those that were given, including those from a recipe
///         job_file  in the current folder or a folder above it; names of files are written relative to its folder
/// Throws  Error     for a job file elsewhere; for a flag that contains {{, which a template would interpret
std::string film_job(const Verb& verb, const uses::Film& film,
                     const std::filesystem::path& job_file);

}  // namespace coppermoon::verbs

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace coppermoon::uses {

/// A picture that gnuplot draws, whole or not at all.
///
/// Given   terminal  as "svg size 900,600"
///         script    all but its terminal and output
/// Throws  Error     when gnuplot is not there, or cannot do what it was told
void write_plot(const std::filesystem::path& picture, const std::string& terminal,
                const std::string& script);

}  // namespace coppermoon::uses

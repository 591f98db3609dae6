// SPDX-License-Identifier: MIT
#include "verbs/gnuplot.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "algebra/error.h"
#include "texture/whole_file.h"

namespace coppermoon::verbs {
namespace {

/// Whether gnuplot did all it was told. One that is not there hangs up while it is spoken to.
bool gnuplot_did(const std::string& script) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  FILE* gnuplot = popen("gnuplot 2>/dev/null", "w");
  const bool told =
      gnuplot != nullptr && std::fwrite(script.data(), 1, script.size(), gnuplot) == script.size();
  const bool done = gnuplot != nullptr && pclose(gnuplot) == 0 && told;
  std::signal(SIGPIPE, before);
  return done;
}

}  // namespace

void write_plot(const std::filesystem::path& picture, const std::string& terminal,
                const std::string& script) {
  texture::write_whole(picture, [&](int descriptor) {
    const auto output = fmt::format("/proc/{}/fd/{}", getpid(), descriptor);
    if (!gnuplot_did(fmt::format("set terminal {}\nset output '{}'\n{}", terminal, output, script)))
      throw algebra::Error("gnuplot failed; install the package gnuplot-nox");
  });
}

}  // namespace coppermoon::verbs

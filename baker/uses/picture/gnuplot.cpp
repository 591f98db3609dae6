// SPDX-License-Identifier: MIT
#include "uses/picture/gnuplot.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "algebra/error.h"
#include "files/whole_file.h"

namespace coppermoon::uses {
namespace {

/// Whether gnuplot did all it was told, nobody's own settings (-d) among it. One that is not there hangs up while it is spoken to.
///
/// Given  picture  a file that it inherits and draws into: no file's name comes into its script,
///                 where a line of it could be taken for an order
bool gnuplot_did(const std::string& script, int picture) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  const auto command = fmt::format("gnuplot -d >/dev/fd/{} 2>/dev/null", picture);
  FILE* gnuplot = popen(command.c_str(), "w");
  const bool told =
      gnuplot != nullptr && std::fwrite(script.data(), 1, script.size(), gnuplot) == script.size();
  const bool done = gnuplot != nullptr && pclose(gnuplot) == 0 && told;
  std::signal(SIGPIPE, before);
  return done;
}

}  // namespace

void write_plot(const std::filesystem::path& picture, const std::string& terminal,
                const std::string& script) {
  files::write_whole(picture, [&](int descriptor) {
    const int inherited = ::dup(descriptor);  // what is opened here is closed to other programs
    const bool done = gnuplot_did(fmt::format("set terminal {}\n{}", terminal, script), inherited);
    ::close(inherited);
    if (!done) throw algebra::Error("gnuplot failed; install the package gnuplot-nox");
  });
}

}  // namespace coppermoon::uses

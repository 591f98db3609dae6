// SPDX-License-Identifier: MIT
#include "uses/picture/gnuplot.h"

#include <fmt/format.h>

#include "files/child_process.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"

namespace coppermoon::uses {

/// Nobody's own settings count (-d), and no file's name comes into the script, where a line of it could
/// be taken for an order.
void write_plot(const std::filesystem::path& picture, const std::string& terminal,
                const std::string& script) {
  const files::TemporaryFolder folder;
  files::write_whole(folder.path() / "plot.gp",
                     fmt::format("set terminal {}\n{}", terminal, script));
  files::write_whole(picture, [&](int descriptor) {
    files::run_program(
        {.words = {"gnuplot", "-d", "plot.gp"}, .package = "gnuplot-nox", .folder = folder.path()},
        descriptor);
  });
}

}  // namespace coppermoon::uses

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/endings.h"

namespace coppermoon::uses {

/// Horizontal or vertical axis of a plot.
struct PlotAxis {
  std::string label{};
  std::optional<std::pair<double, double>> range{};  ///< without: as the curves need
  bool logarithmic = false, reversed = false;
  double tic_spacing = 0;  ///< 0: chosen by gnuplot
  std::string unit{};      ///< behind the number of each tic
};

/// Data of one look. Without rows it stands in the key alone, without a title in the plot alone.
struct PlotCurve {
  std::string rows;  ///< comma-separated columns; an empty row interrupts a line
  std::string look;  ///< in gnuplot's words: "lines lw 2 lc rgb 'red'"
  std::string title{};
};

/// Something that is marked along the x axis.
struct PlotMark {
  enum Kind {
    edge,     ///< dashed line, the name along it
    instant,  ///< line through all panels, the name above
    band      ///< ground up to `end`, the name at its foot
  } kind;
  double x;
  std::string name;
  double end = 0;
};

struct PlotPanel {
  PlotAxis y;
  std::vector<PlotCurve> curves;
};

struct Plot {
  std::string title{};
  int title_size = 12;              ///< points
  int width = 1000, height = 640;   ///< pixels; 40 to a centimetre in PDF
  PlotAxis x{};                     ///< of all panels
  std::vector<PlotPanel> panels{};  ///< one, or two above one another
  std::vector<PlotMark> marks{};
  std::string key = "off";      ///< its place in gnuplot's words: "top left"
  std::string grid = "lt 0";    ///< its lines in gnuplot's words: dotted
  double margin = 0;            ///< around the curves, as share of the plot
  double height_per_width = 0;  ///< of the panel; 0: as it fits
};

/// Format of a plot's file.
struct PlotFile : files::Ending {
  std::string (*terminal)(const Plot& plot);  ///< gnuplot's, and its settings
};

/// All of them.
std::span<const PlotFile> plot_files();

/// Draws a plot with gnuplot. The file appears whole or not at all.
///
/// Given   file   ends as one of plot_files()
/// Throws  Error  for another ending; when gnuplot is not there, or fails
void write_plot(const std::filesystem::path& file, const Plot& plot);

/// Refuses a file that is neither a plot nor, where that is allowed, a table.
///
/// Given   what   is to be written, as "a curve"
/// Throws  Error  when the path ends as none of plot_files() nor, with `or_table`, in .csv
void require_plot_ending(const std::filesystem::path& file, std::string_view what, bool or_table);

}  // namespace coppermoon::uses

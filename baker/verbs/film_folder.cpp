// SPDX-License-Identifier: MIT
#include "verbs/film_folder.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>

#include "algebra/error.h"
#include "texture/read_image.h"
#include "texture/seal.h"
#include "verbs/film_account.h"
#include "verbs/plan_options.h"

namespace coppermoon::verbs {
namespace {

namespace fs = std::filesystem;

/// "frame" and ".png" of "frame.0012.png": a numbered file's name without its number.
std::pair<std::string, std::string> around_number(const fs::path& file) {
  return {file.stem().stem().string(), file.extension().string()};
}

bool is_number(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// All files in the folder that are called as frames of the film's products are, whatever their number.
std::vector<fs::path> files_so_called(const Film& film) {
  std::set<std::pair<std::string, std::string>> own;
  for (const auto& file : film.files(1)) own.insert(around_number(file));
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(film.folder)) {
    const auto number = entry.path().stem().extension().string();
    if (!number.empty() && is_number(number.substr(1)) && own.contains(around_number(entry.path())))
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// A file of another film, and in what they differ.
struct Foreign {
  fs::path file;
  std::string why;  ///< empty: it is of this film, or damaged
};

/// Work is planned later, or was: what is planned from is compared.
std::string why_foreign(const fs::path& file, const Account& asked) {
  try {
    const auto there = account_in(file);
    if (there.empty()) return "what is no film of coppermoon's";
    const auto why = differences(without_work(of_file(file, there)), of_file(file, asked));
    return why.empty() ? "" : "a film made with " + why;
  } catch (const algebra::Error&) {
    return {};
  }
}

std::vector<Foreign> foreign_files(const Film& film) {
  std::vector<Foreign> all;
  for (const auto& file : files_so_called(film)) all.push_back({file, {}});
  const auto asked = without_work(account_of(film));
  tbb::parallel_for(std::size_t{0}, all.size(),
                    [&](std::size_t i) { all[i].why = why_foreign(all[i].file, asked); });
  std::erase_if(all, [](const auto& one) { return one.why.empty(); });
  return all;
}

/// PNG has checks of its own.
bool is_whole(const fs::path& file) {
  return file.extension() == ".exr" ? texture::is_sealed(file)
                                    : texture::read_image(file).width > 0;
}

/// Whether a file is of that frame, whole, and made from what the film is, as far as `part` looks.
bool is_whole_of(const Film& film, const fs::path& file, std::size_t frame, const auto& part) try {
  return fs::is_regular_file(file) &&
         texture::read_attribute(file, "coppermoon:frame") == fmt::format("{}", frame) &&
         part(account_in(file)) == part(account_of(film)) && is_whole(file);
} catch (const algebra::Error&) {
  return false;
}

}  // namespace

void require_own(const Film& film, bool replace) {
  const auto foreign = foreign_files(film);
  if (foreign.empty()) return;
  if (!replace)
    throw algebra::Error(fmt::format(
        "{}: holds {} ({}{}), allowed another folder, or --replace", film.folder.string(),
        foreign.front().why, foreign.front().file.filename().string(),
        foreign.size() > 1 ? fmt::format(" and {} more", foreign.size() - 1) : ""));
  std::set<fs::path> own;
  for (std::size_t frame = 1; frame <= film.moments.frames.size(); ++frame)
    for (const auto& file : film.files(frame)) own.insert(file.filename());
  for (const auto& one : foreign)
    if (!own.contains(one.file.filename())) fs::remove(one.file);
}

bool is_own(const Film& film, const fs::path& file, std::size_t frame) {
  return is_whole_of(film, file, frame, [&](const Account& all) { return of_file(file, all); });
}

bool is_made(const Film& film, std::size_t frame) {
  return std::ranges::all_of(film.files(frame),
                             [&](const auto& file) { return is_own(film, file, frame); });
}

bool shows_scene(const Film& film, std::size_t frame) {
  return is_whole_of(film, film.linear_frame(frame), frame, of_scene);
}

}  // namespace coppermoon::verbs

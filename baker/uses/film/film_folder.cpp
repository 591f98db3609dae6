// SPDX-License-Identifier: MIT
#include "uses/film/film_folder.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>

#include "algebra/error.h"
#include "files/fingerprint.h"
#include "files/own_file.h"
#include "povray_scenes/moon_scene.h"
#include "texture/read_image.h"
#include "texture/seal.h"
#include "uses/film/film_light.h"
#include "uses/light/light_file.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

/// The parts of a numbered file's name before and after the number: "frame" and ".png" for "frame.0012.png".
std::pair<std::string, std::string> around_number(const fs::path& file) {
  return {file.stem().stem().string(), file.extension().string()};
}

bool is_number(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// Files in the film's folder that have names like those of the film's frames, whatever number the names contain.
std::vector<fs::path> numbered_files(const Film& film) {
  std::set<std::pair<std::string, std::string>> own;
  for (const auto& file : film.files(film.moments.first_frame)) own.insert(around_number(file));
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(film.folder)) {
    const auto number = entry.path().stem().extension().string();
    if (!number.empty() && is_number(number.substr(1)) && own.contains(around_number(entry.path())))
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// A file in the film's folder that may belong to something other than the film.
struct Foreign {
  fs::path file;
  std::string contents;  ///< description; empty if the file belongs to this film or is damaged
};

std::string contents_of(const Film& film, const fs::path& file) {
  if (fs::is_symlink(file)) return "a link";  // writing to a link would change another file
  return film.record.foreign_contents(file);
}

/// Existing files, other than frames, that making the film would overwrite: the shadow's light and POV-Ray's scene.
std::vector<fs::path> files_beside_frames(const Film& film) {
  std::vector<fs::path> files{film.folder / light_file};
  if (film.products.scenes)
    for (const char* name : {povray_scenes::scene_file, povray_scenes::settings_file})
      files.push_back(film.folder / name);
  std::erase_if(files, [](const auto& file) { return !fs::exists(fs::symlink_status(file)); });
  return files;
}

/// Describes a light or scene file that is a link or was not written by coppermoon. The text is empty for any other
/// file, including a light file of another film, which film_light refuses.
std::string contents_beside_frames(const fs::path& file) {
  if (fs::is_symlink(file)) return "a link";
  const bool ours = file.filename() == light_file ? is_light(file) : files::is_stamped(file);
  return ours ? "" : "what is not as coppermoon wrote it";
}

std::vector<Foreign> foreign_files(const Film& film) {
  std::vector<Foreign> all;
  for (const auto& file : numbered_files(film)) all.push_back({file, {}});
  tbb::parallel_for(std::size_t{0}, all.size(),
                    [&](std::size_t i) { all[i].contents = contents_of(film, all[i].file); });
  std::erase_if(all, [](const auto& one) { return one.contents.empty(); });
  for (const auto& file : files_beside_frames(film))
    if (const auto contents = contents_beside_frames(file); !contents.empty())
      all.push_back({file, contents});
  return all;
}

/// Whether a file is complete and undamaged, according to the fingerprint in its header or, for a PNG, its checksums.
bool is_whole(const fs::path& file) {
  return file.extension() == ".png" ? texture::read_image(file).width > 0
                                    : texture::is_sealed(file);
}

/// Whether a file is undamaged, shows the given frame, and belongs to this film according to `alike`.
bool is_whole_of(const fs::path& file, std::size_t frame, const auto& alike) try {
  return fs::is_regular_file(fs::symlink_status(file)) &&
         texture::read_attribute(file, "coppermoon:frame") == fmt::format("{}", frame) &&
         alike(file) && is_whole(file);
} catch (const algebra::Error&) {
  return false;
}

}  // namespace

FilmClaim::FilmClaim(const Film& film)
    : claim_(files::claim_folder(film.folder, files::fingerprint(film.record.film_key()))) {
  if (!claim_.alone)
    throw algebra::Error(fmt::format("{}: another film is being made in it, allowed another folder",
                                     film.folder.string()));
}

void require_own(const Film& film, bool replace) {
  const auto foreign = foreign_files(film);
  if (foreign.empty()) return;
  if (!replace)
    throw algebra::Error(
        fmt::format("{}: holds {} ({}{}), allowed another folder{}", film.folder.string(),
                    foreign.front().contents, foreign.front().file.filename().string(),
                    foreign.size() > 1 ? fmt::format(" and {} more", foreign.size() - 1) : "",
                    film.record.way_out));
  std::set<fs::path> own;
  for (auto frame = film.moments.first_frame; frame <= film.moments.last_frame(); ++frame)
    for (const auto& file : film.files(frame)) own.insert(file.filename());
  for (const auto& one : foreign)
    if (fs::is_symlink(one.file) || !own.contains(one.file.filename())) fs::remove(one.file);
}

bool is_own(const Film& film, const fs::path& file, std::size_t frame) {
  return is_whole_of(file, frame, [&](const fs::path& one) { return film.record.made_alike(one); });
}

bool is_made(const Film& film, std::size_t frame) {
  return std::ranges::all_of(film.files(frame),
                             [&](const auto& file) { return is_own(film, file, frame); });
}

bool shows_scene(const Film& film, std::size_t frame) {
  return is_whole_of(film.linear_frame(frame), frame,
                     [&](const fs::path& one) { return film.record.shows_the_same(one); });
}

}  // namespace coppermoon::uses

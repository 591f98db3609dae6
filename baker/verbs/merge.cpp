// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "colour/bracket.h"
#include "files/whole_file.h"
#include "result/as_json.h"
#include "texture/write_image.h"
#include "uses/picture/photo_file.h"
#include "uses/picture/pixels.h"
#include "verbs/command_line.h"
#include "verbs/recipes/one_scene.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {
namespace of_merge {
namespace {

struct Options {
  std::vector<std::string> photographs;
  std::string output;
  bool json = false;
};

/// Result of the command: one photograph merged from several.
struct Merged {
  std::string file;
  std::size_t photographs = 0;
  double share_valid = 0;
};

template <class Field>
void describe(Field&& is, const Merged& merged) {
  is.a("Merged", "A photograph of the scene's luminance, made of others.");
  is("file", merged.file, "the file that was made");
  is("photographs", merged.photographs, "number of photographs that it is made of");
  is("share_valid", merged.share_valid, "share of the pixels within the photographs' range");
}

double share_valid(const colour::Bracketed& photograph) {
  double sum = 0;
  for (const float valid : photograph.valid.values()) sum += valid;
  return sum / static_cast<double>(photograph.valid.values().size());
}

void run(const Options& options) {
  files::require_place_for(options.output);
  std::vector<colour::Bracketed> photographs;
  for (const auto& file : options.photographs) {
    require_one_scene(options.photographs.front(), file);
    photographs.push_back(uses::bracketed(file));
  }
  const auto merged = colour::merged(photographs);
  texture::write_exr(options.output, uses::image_of(merged.scene_linear, merged.valid),
                     uses::scene_attributes(options.photographs.front()),
                     {.type = texture::ExrType::floating, .allow_negative = true});
  const Merged made{options.output, photographs.size(), share_valid(merged)};
  if (options.json)
    fmt::print("{}\n", result::as_json(made).dump(2));
  else
    fmt::print("{}: {} photographs, {:.1f} % of the pixels within their range\n",
               one_line(made.file), made.photographs, 100 * made.share_valid);
}

}  // namespace
}  // namespace of_merge

void add_merge(Program& program) {
  using namespace of_merge;
  auto& verb =
      add_verb(program, "merge", "merges bracketed photographs into one of the scene's luminance");
  const auto options = std::make_shared<Options>();
  add_flag(verb, "photographs,--photographs", options->photographs,
           "photographs of one scene, .exr, as --photograph writes them")
      .reads_file()
      .of(request::Affects::share)
      .required();
  add_flag(verb, "-o,--output", options->output, "scene-linear [cd/m2], .exr")
      .writes_file()
      .required();
  add_json_switch(verb, options->json, {result::fields_of<Merged>});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs

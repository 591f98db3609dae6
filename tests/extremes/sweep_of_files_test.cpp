// SPDX-License-Identifier: MIT
// Random command lines of the words that read files: each ends in valid files or in one clear line, and no file but its
// outputs is another afterwards. A hundred tests of five each.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algebra/random.h"
#include "extremes/tried.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::extremes::sweep_of_files_test {

using algebra::Random;
using Files = std::map<std::string, std::string>;  ///< bytes by name
namespace fs = std::filesystem;

constexpr std::uint64_t seed = 20000, runs_a_test = 5;
constexpr const char* instant = "2018-07-27T19:00:00Z";

std::string one_of(Random& random, const Words& words) {
  return words[static_cast<std::size_t>(random.uniform() * static_cast<double>(words.size()))];
}

/// A command line, what it reads, and what it may write.
struct Command {
  Words words;
  std::vector<std::string> reads, writes;

  void add(const Words& more) { words += more; }

  void maybe_add(Random& random, double chance, const std::string& flag, const Words& values) {
    if (random.uniform() < chance) add({flag, one_of(random, values)});
  }

  void read(const std::string& file) {
    words.push_back(file);
    reads.push_back(file);
  }

  void write(const std::string& flag, const std::string& file) {
    add({flag, file});
    writes.push_back(file);
  }
};

/// A name of its own; seldom one that stands there already, or of no kind that is written.
std::string output(Random& random, const std::string& usual) {
  const double which = random.uniform();
  if (which < 0.08)
    return one_of(random, {"frame.exr", "picture.png", "under.exr", "./frame.exr", "list.csv"});
  if (which < 0.11) return one_of(random, {"out.jpg", "no/such/folder.png", ".", "out"});
  return usual;
}

std::string input(Random& random, const std::string& usual) {
  return random.uniform() < 0.9 ? usual
                                : one_of(random, {"frame.exr", "picture.png", "under.exr",
                                                  "over.exr", "list.csv", "none.exr"});
}

void add_camera(Random& random, Command& command) {
  command.maybe_add(random, 0.4, "--time", {"auto", "follow", "0.01", "4", "1e6", "soon"});
  command.maybe_add(random, 0.3, "--iso", {"100", "1600", "800", "6400", "nan"});
  command.maybe_add(random, 0.2, "--bits", {"8", "16", "8", "12"});
  command.maybe_add(random, 0.3, "--view",
                    {"ACES 1.0 SDR Video", "Raw", "Log", "Un-tone-mapped", "None"});
  command.maybe_add(random, 0.3, "--camera",
                    {"paper", "refractor", "400mm", "schmidt-cassegrain", "box"});
}

Command develop(Random& random) {
  Command command{{"develop"}, {}, {}};
  command.read(input(random, "frame.exr"));
  command.write("-o", output(random, "developed.png"));
  add_camera(random, command);
  if (random.uniform() < 0.2) command.write("--raw", output(random, "raw.tif"));
  if (random.uniform() < 0.2) command.write("--photograph", output(random, "photograph.exr"));
  return command;
}

Command merge(Random& random) {
  Command command{{"merge"}, {}, {}};
  command.read(input(random, "under.exr"));
  if (random.uniform() < 0.9) command.read(input(random, "over.exr"));
  command.write("-o", output(random, "merged.exr"));
  return command;
}

Command compare(Random& random) {
  Command command{{"compare"}, {}, {}};
  command.read(input(random, "picture.png"));
  command.read(input(random, "frame.exr"));
  if (random.uniform() < 0.7) command.write("-o", output(random, "sheet.png"));
  command.maybe_add(random, 0.3, "--bins", "1 12 1000 0 -1");
  command.maybe_add(random, 0.3, "--exposure", {"exif", "fit", "none"});
  command.maybe_add(random, 0.2, "--coding", {"srgb", "linear", "gamma"});
  return command;
}

Command fit(Random& random) {
  Command command{{"fit"}, {}, {}};
  if (random.uniform() < 0.5) {
    command.add({"--magnitudes"});
    command.read(input(random, "list.csv"));
  } else {
    command.read(input(random, "picture.png"));
    command.maybe_add(random, 0.9, "--instants", {instant, "2018-07-27T20:21:00Z", "noon"});
    command.maybe_add(random, 0.9, "--times", "1 0.1 -1");
    command.maybe_add(random, 0.9, "--isos", {"800", "0"});
    command.maybe_add(random, 0.9, "--f-number", {"8", "0"});
  }
  command.maybe_add(random, 0.3, "--albedo-map", {"built-in", "picture.png", "none.png"});
  command.add("--quality draft --json");
  return command;
}

Command ring(Random& random) {
  Command command{{"ring"}, {}, {}};
  command.read(random.uniform() < 0.9 ? instant : one_of(random, {"frame.exr", "2018-07-28"}));
  command.write("-o", output(random, "ring.exr"));
  command.maybe_add(random, 0.3, "--atmosphere", {"paper", "clear", "none", "thin"});
  command.maybe_add(random, 0.3, "--on", "0,0 89,10 -91,0 here");
  command.maybe_add(random, 0.3, "--scale", {"1e-3", "1e9", "0"});
  return command;
}

/// Into one folder, whatever stands there from another.
Command animate(Random& random) {
  Command command{{"animate", random.uniform() < 0.95 ? "2018-07-27" : "2018-03-01"}, {}, {}};
  command.write("-o", random.uniform() < 0.9 ? "film" : output(random, "film"));
  command.add("--from U1 --to U2 --quality draft --width 16 --height 12 --texture-width 32");
  command.maybe_add(random, 0.9, "--albedo-map", {"built-in", "picture.png"});
  command.maybe_add(random, 0.9, "--frames", {"1", "2", "3", "0"});
  command.maybe_add(random, 0.7, "--make",
                    {"textures", "scenes", "frames", "pictures,frames", "light", "films"});
  command.maybe_add(random, 0.3, "--range", {"1", "1-2", "2-1", "7"});
  command.maybe_add(random, 0.2, "--shard", {"1/2", "2/2", "3/2"});
  command.maybe_add(random, 0.2, "--bracket", {"1", "11"});
  if (random.uniform() < 0.3) command.add({"--replace"});
  if (random.uniform() < 0.2) command.write("--curve", output(random, "curve.csv"));
  if (random.uniform() < 0.2) command.write("--contact-sheet", output(random, "sheet.png"));
  add_camera(random, command);
  return command;
}

Command random_command(std::uint64_t index) {
  Random random(seed, index);
  if (random.uniform() < 0.03) return fit(random);  // which takes minutes
  constexpr std::array kinds{develop, merge, compare, ring, animate, animate, animate, animate};
  return kinds[static_cast<std::size_t>(random.uniform() * kinds.size())](random);
}

class SweepOfFiles : public ProgramTest, public testing::WithParamInterface<int> {
 protected:
  void SetUp() override {
    const Words camera = "--camera refractor --focal-length 400 --width 48 --height 32";
    require_made(words_of("still {} --albedo-map built-in --quality draft -o picture.png --frame "
                          "frame.exr --time 1 --photograph over.exr",
                          instant),
                 camera);
    require_made(
        "develop frame.exr -o under.png --time 0.1 --photograph under.exr --camera refractor", {});
    file("list.csv",
         "instant,band,magnitude,error\n2018-07-27T19:00:00Z,V,-5.2,0.1\n"
         "2018-07-27T20:21:00Z,V,-0.4,0.1\n");
  }

  Files files() const {
    Files all;
    for (const auto& name : listing())
      if (const auto at = here("..") / name; fs::is_regular_file(at)) all[name] = text_of(at);
    return all;
  }

  /// What is wrong with the folder after a command; empty when nothing is.
  std::string flaw(const Command& command, const Outcome& outcome, const Files& before) const {
    for (const auto& [name, bytes] : files())
      if (const auto was = before.find(name); was == before.end() || was->second != bytes) {
        if (outcome.status != 0) return "refused, and yet " + name + " is another";
        if (!may_write(command, name)) return name + " is no output, and yet another";
        if (const auto wrong = flaw_of_image(here("..") / name); !wrong.empty()) return wrong;
      }
    for (const auto& [name, bytes] : before)
      if (!fs::exists(here("..") / name) && !may_write(command, name)) return name + " is gone";
    if (outcome.status == 0) return "";
    if (outcome.status != 1 && outcome.status != 2) return fmt::format("status {}", outcome.status);
    const bool one_line =
        outcome.err.starts_with("coppermoon: ") && std::ranges::count(outcome.err, '\n') == 1;
    return one_line ? "" : "not one line";
  }

 private:
  void require_made(Words words, const Words& more) const {
    words += more;
    const auto outcome = coppermoon(words);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }

  /// An output that is an input is none.
  bool may_write(const Command& command, const std::string& name) const {
    const auto path = fs::weakly_canonical(here("..") / name);
    const auto is = [&](const std::string& file) {
      const auto at = fs::weakly_canonical(here(file));
      return path == at || path.parent_path() == at;
    };
    return std::ranges::any_of(command.writes, is) && std::ranges::none_of(command.reads, is);
  }

  static std::string flaw_of_image(const fs::path& path) {
    const auto ending = path.extension();
    if (ending != ".exr" && ending != ".png" && ending != ".tif") return "";
    const auto image = texture::read_image(path);
    const bool finite = std::ranges::all_of(image.values, [](float v) { return std::isfinite(v); });
    return finite && !image.values.empty() ? "" : path.string() + ": values that are no numbers";
  }
};

TEST_P(SweepOfFiles, ChangesNoFileButItsOutputs) {
  int done = 0;
  const auto first = static_cast<std::uint64_t>(GetParam()) * runs_a_test;
  for (std::uint64_t i = first; i < first + runs_a_test; ++i) {
    const auto command = random_command(i);
    const auto before = files();
    Words words{"timeout", "600", COPPERMOON_PROGRAM};
    words += command.words;
    const auto outcome = run(words, {.processor_limit = 300});
    EXPECT_EQ(flaw(command, outcome, before), "")
        << "seed " << seed << ", command " << i << ": "
        << fmt::format("{}", fmt::join(command.words, " ")) << "\n"
        << outcome.err;
    done += outcome.status == 0;
  }
  tried(fmt::format("random commands on files {} to {}", first, first + runs_a_test - 1),
        fmt::format("{} done, {} refused in one line, no other file changed", done,
                    static_cast<int>(runs_a_test) - done));
}

INSTANTIATE_TEST_SUITE_P(FiveHundred, SweepOfFiles, testing::Range(0, 100));

}  // namespace coppermoon::extremes::sweep_of_files_test

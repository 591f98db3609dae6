// SPDX-License-Identifier: MIT
// A film for a render farm: its job, and the list of what a shard makes. tests/hand_off runs the job by OpenJD's own program.
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace coppermoon::end_to_end::film_job_test {

namespace fs = std::filesystem;

const Words film =
    "animate 2018-07-27 --frames 5 --make textures --albedo-map built-in --texture-width 128 "
    "--atmosphere undated --quality draft";

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

class FilmJob : public ProgramTest {
 protected:
  /// Files of a folder, and when each was last written.
  std::map<std::string, fs::file_time_type> written() const {
    std::map<std::string, fs::file_time_type> all;
    for (const auto& name : listing())
      if (fs::is_regular_file(here() / ".." / name))
        all[name.substr(name.find('/') + 1)] = fs::last_write_time(here() / ".." / name);
    return all;
  }

  /// What is listed is what the same command then writes.
  void expect_listed(const Words& words, std::size_t count) const {
    const auto before = written();
    const auto outcome = coppermoon(words + Words{"--dry-run"});
    expect_done(outcome);
    EXPECT_EQ(written(), before) << "a dry run writes nothing";
    const auto listed = lines_of(outcome.out);
    EXPECT_EQ(listed.size(), count);
    expect_done(coppermoon(words));
    std::set<std::string> made;
    for (const auto& [name, when] : written())
      if (const auto old = before.find(name); old == before.end() || old->second != when)
        made.insert(name);
    EXPECT_EQ(std::set<std::string>(listed.begin(), listed.end()), made);
  }
};

TEST_F(FilmJob, IsATemplateOfOpenJobDescription) {
  expect_done(coppermoon(
      film +
      "--at -21.1,55.5 -o film --curve 'film/a curve.csv' --curve /tmp/b.svg --job job.yaml"));
  EXPECT_FALSE(fs::exists(here("film"))) << "nothing is made yet";
  const std::string flags = R"(            - "--chdir={{Param.Folder}}"
            - "{{Param.Program}}"
            - "animate"
            - "--albedo-map=built-in"
            - "--texture-width=128"
            - "--atmosphere=undated"
            - "--quality=draft"
            - "--eclipse=2018-07-27"
            - "--frames=5"
            - "--make=textures"
)",
                    place = R"(            - "--at=-21.1,55.5"
            - "--output={{Param.Output}}"
)",
                    action = R"(    script:
      actions:
        onRun:
          command: env
          args:
)";
  EXPECT_EQ(text_of(here("job.yaml")), R"(specificationVersion: jobtemplate-2023-09
name: coppermoon 2018-07-27
parameterDefinitions:
  - name: Program
    type: STRING
    default: coppermoon
    description: the program, of one version on all workers
  - name: Shards
    type: INT
    minValue: 1
    maxValue: 5
    default: 5
    description: tasks that share the frames
  - name: Folder
    type: PATH
    objectType: DIRECTORY
    dataFlow: NONE
    default: "."
    description: "folder that the program runs in"
  - name: Curve
    type: PATH
    objectType: FILE
    dataFlow: OUT
    default: "film/a curve.csv"
    description: "--curve"
  - name: Curve2
    type: STRING
    default: "/tmp/b.svg"
    description: "--curve"
  - name: Output
    type: PATH
    objectType: DIRECTORY
    dataFlow: OUT
    default: "film"
    description: "--output"
steps:
  - name: frames
    parameterSpace:
      taskParameterDefinitions:
        - name: Shard
          type: INT
          range: "1-{{Param.Shards}}"
)" + action + flags + place + R"(            - "--shard={{Task.Param.Shard}}/{{Param.Shards}}"
  - name: film
    dependencies:
      - dependsOn: frames
)" + action + flags + R"(            - "--curve={{Param.Curve}}"
            - "--curve={{Param.Curve2}}"
)" + place);
}

TEST_F(FilmJob, HoldsWhatARecipeSays) {
  file("film.toml",
       "eclipse = \"2018-07-27\"\nalbedo-map = \"map.png\"\n[atmosphere]\nmodel = "
       "\"undated\"\n");
  expect_done(run("oiiotool --create 64x32 1 -o map.png"));
  expect_done(coppermoon("animate --recipe film.toml --make textures -o film --job job.yaml"));
  const auto text = text_of(here("job.yaml"));
  for (const char* part :
       {"name: AlbedoMap\n    type: PATH\n    objectType: FILE\n    dataFlow: IN\n    default: "
        "\"map.png\"\n",
        "- \"--albedo-map={{Param.AlbedoMap}}\"\n", "- \"--atmosphere=undated\"\n",
        "- \"--eclipse=2018-07-27\"\n", "default: 8\n", "default: \".\"\n"})
    EXPECT_SAYS(text, part) << part << "of\n" << text;
  EXPECT_SAYS_NOT(text, "film.toml") << "the job needs no recipe beside it";
}

TEST_F(FilmJob, RefusesWhatNoJobCouldSay) {
  expect_refused(film + "-o film --job job.txt", "job.txt: a job ends in .yaml");
  expect_refused(film + "-o film --job job.yaml --shard 1/2", "allowed 1/1 with --job");
  expect_refused(film + "-o film --job job.yaml --dry-run", "allowed one of the two", wrong_usage);
  expect_refused(film + "-o film --job job.yaml --make light",
                 "allowed where --photons says how many");
  expect_refused(film + "-o film --job /usr/share/job.yaml",
                 "allowed in the current folder, or above it");
}

TEST_F(FilmJob, HasAllTasksMakeWhatTheLastOneNeeds) {
  expect_done(coppermoon(
      "animate 2018-07-27 --start-frame 1001 --composite all.png -o film --job job.yaml"));
  const auto text = text_of(here("job.yaml"));
  const auto last = text.find("  - name: film");
  for (const auto& step : {text.substr(0, last), text.substr(last)})
    for (const char* word : {"\"--make=frames,pictures\"", "\"--start-frame=1001\""})
      EXPECT_SAYS(step, word);
}

TEST_F(FilmJob, ListsWhatAShardMakes) {
  const auto words = film + "-o film";
  expect_listed(words + "--shard 2/3", 3);  // the light, and frames 2 and 5
  expect_listed(words + "--shard 2/3", 0);
  fs::resize_file(here("film/moon_lin_rec709.0005.exr"), 900);
  expect_listed(words + "--shard 2/3", 1);
  expect_listed(words + "--curve film/curve.csv --curve curve.svg", 5);
  expect_listed(words + "--make scenes", 2);
  expect_listed(words + "--texture-width 64 --range 1-2 --replace", 2);
}

TEST_F(FilmJob, ListsALightAlone) {
  const auto words = film + "-o film --make light";
  expect_listed(words + "--photons 1e4 --shard 2/3", 1);
  expect_listed(words, 1);
  const auto outcome = coppermoon(film + "-o film --range 3 --dry-run --json");
  expect_done(outcome);
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["file"], "film/moon_lin_rec709.0003.exr");
}

TEST_F(FilmJob, OfAnotherFilmInTheFolderIsRefusedInADryRunToo) {
  expect_done(coppermoon(film + "-o film --range 1"));
  const auto before = written();
  const auto outcome = coppermoon(film + "-o film --texture-width 64 --dry-run");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_SAYS(outcome.err, "texture-width = 128, asked 64");
  EXPECT_EQ(written(), before);
}

}  // namespace coppermoon::end_to_end::film_job_test

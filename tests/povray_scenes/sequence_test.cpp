// SPDX-License-Identifier: MIT
#include "povray_scenes/sequence.h"

#include <cstdio>
#include <future>

#include "povray_scenes/folder.h"
#include "povray_scenes/moon_scene.h"
#include "povray_scenes/pictures.h"
#include "support/left_behind.h"
#include "support/testing.h"

namespace coppermoon::povray_scenes::sequence_test {

using algebra::degrees;
using algebra::Error;
using Frames = std::vector<std::size_t>;

SceneCamera camera_of(std::size_t frame) {
  const auto step = static_cast<double>(frame);
  return {.position = {221 + 0.1 * step, 3 * step, -step},
          .up = {0, 0.1 * step, 1},
          .horizontal_field = degrees(0.7),
          .width = 60,
          .height = 40,
          .flattening = frame % 2 == 0 ? 0.85 : 1,
          .zenith = {0, 0, 1},
          .direction = frame == 3 ? glm::dvec3(-1, -0.04, 0.016) : glm::dvec3(0, 0, 0)};
}

Sequence of_frames(std::size_t frames) {
  Sequence sequence{.cameras = {}, .textures = "moon"};
  for (std::size_t frame = 1; frame <= frames; ++frame)
    sequence.cameras.push_back(camera_of(frame));
  return sequence;
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

std::string refusal(const Sequence& sequence) {
  return refusal_of([&] { to_pov(sequence); });
}

TEST(NumberedFile, HasFourDigitsOrAsManyAsTheLast) {
  EXPECT_EQ(numbered_file("moon_lin_rec709", 1, 12), "moon_lin_rec709.0001.exr");
  EXPECT_EQ(numbered_file("moon", 9999, 9999), "moon.9999.exr");
  EXPECT_EQ(numbered_file("moon", 7, 12345), "moon.00007.exr");
}

TEST(SequenceToPov, NeverAsksForTheClock) {
  EXPECT_FALSE(says(to_pov(of_frames(3)), "clock"));
  EXPECT_FALSE(says(to_ini(of_frames(3)), "Clock"));
}

TEST(SequenceToPov, IsTheSingleScenesTextButForWhatMoves) {
  auto sequence = of_frames(1);
  const auto single = to_pov(MoonScene{.camera = sequence.cameras[0], .texture = "moon.0001.exr"});
  const auto text = to_pov(sequence);
  const auto camera = text.find("camera {"), moves = single.find("  location");
  ASSERT_NE(camera, std::string::npos);
  EXPECT_EQ(text.substr(camera, 30), single.substr(single.find("camera {"), 30));
  EXPECT_TRUE(
      text.starts_with(single.substr(0, moves - std::string("camera {\n  perspective\n").size())));
  EXPECT_TRUE(text.ends_with(single.substr(single.find(" map_type"))));
}

TEST(SequenceToPov, NamesTheFrameThatIsNotSound) {
  auto sequence = of_frames(4);
  sequence.cameras[2].up = {-1, -0.04, 0.016};
  EXPECT_TRUE(refusal(sequence).starts_with("frame 3: angle between up and the line of sight"))
      << refusal(sequence);
}

TEST(SequenceToPov, RefusesFramesOfDifferentPictures) {
  const auto with = [](auto change) {
    auto sequence = of_frames(3);
    change(sequence.cameras[1]);
    return refusal(sequence);
  };
  EXPECT_EQ(
      with([](SceneCamera& camera) { camera.height = 41; }),
      "frame 2: picture = 60 x 41 pixels, 0.7 degrees wide, allowed: that of the first frame, "
      "60 x 40 pixels, 0.7 degrees wide");
  EXPECT_TRUE(says(with([](SceneCamera& camera) { camera.width = 61; }), "61 x 40"));
  EXPECT_TRUE(
      says(with([](SceneCamera& camera) { camera.horizontal_field = degrees(0.75); }), "0.75"));
}

TEST(SequenceToPov, RefusesNoFramesAndNamesThatPovRayDoesNotFind) {
  EXPECT_TRUE(says(refusal(of_frames(0)), "frames = 0, allowed 1 to 999999"));
  for (const char* name : {"mönd", "a/moon", "a\"b", "a\\b", "a\nb"}) {
    auto sequence = of_frames(2);
    sequence.textures = name;
    EXPECT_TRUE(says(refusal(sequence), "texture = ")) << name;
  }
}

TEST(SequenceToIni, NamesTheLastFrameAndFourDigits) {
  EXPECT_TRUE(
      to_ini(of_frames(3))
          .ends_with(
              "Initial_Frame=1\nFinal_Frame=9999\nSubset_Start_Frame=1\nSubset_End_Frame=3\n"));
  EXPECT_TRUE(to_ini(of_frames(10000))
                  .ends_with("Final_Frame=99999\nSubset_Start_Frame=1\nSubset_End_Frame=10000\n"));
}

TEST(SequenceToPov, CountsFromTheFirstFrameOn) {
  auto sequence = of_frames(3);
  sequence.first_frame = 1001;
  const auto text = to_pov(sequence);
  EXPECT_TRUE(says(text, "this sequence has frames 1001 to 1003"));
  EXPECT_TRUE(says(text, "#declare Frame = max(frame_number, 1001) - 1001;"));
  EXPECT_TRUE(says(text, "str(Frame + 1001, -4, 0)"));
  EXPECT_TRUE(to_ini(sequence).ends_with(
      "Initial_Frame=1001\nFinal_Frame=9999\nSubset_Start_Frame=1001\nSubset_End_Frame=1003\n"));
  sequence.first_frame = 999998;
  EXPECT_TRUE(says(refusal(sequence), "last frame = 1e+06, allowed 0 to 999999"));
}

/// A texture with no two texels alike, nor any two frames.
OIIO::ImageBuf shades(float frame) {
  OIIO::ImageBuf texture(OIIO::ImageSpec(128, 64, 3, OIIO::TypeHalf));
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 128; ++column) {
      const float light[] = {frame, 1.f + static_cast<float>(column),
                             1.f + static_cast<float>(row)};
      texture.setpixel(column, row, light);
    }
  return texture;
}

/// A sequence in a folder with spaces and letters outside ASCII, a texture of its own for each
/// frame.
struct SmallSequence {
  TemporaryFolder parent;
  std::filesystem::path folder = parent.path / "Mönd und Schatten";
  std::size_t last;

  explicit SmallSequence(std::size_t frames) : last(frames) {
    write_sequence(folder, of_frames(frames));
    for (std::size_t frame = 1; frame <= frames; ++frame)
      shades(static_cast<float>(frame))
          .write((folder / numbered_file("moon", frame, frames)).string());
  }
  std::set<std::string> frames_there() const {
    std::set<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(folder))
      if (file.path().filename().string().starts_with("frame"))
        names.insert(file.path().filename().string());
    return names;
  }
};

void expect_same_pixels(const Luminance& frame, const Luminance& reference) {
  ASSERT_EQ(frame.image.spec().width, reference.image.spec().width);
  ASSERT_EQ(frame.image.spec().height, reference.image.spec().height);
  EXPECT_GT(reference.total(), 0);
  for (int y = 0; y < frame.image.spec().height; ++y)
    for (int x = 0; x < frame.image.spec().width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_EQ(frame.image.getchannel(x, y, 0, channel),
                  reference.image.getchannel(x, y, 0, channel))
            << x << ", " << y;
}

Luminance single_frame(const SmallSequence& sequence, std::size_t frame) {
  const TemporaryFolder folder;
  const auto texture = numbered_file("moon", frame, sequence.last);
  write_scene(folder.path, {.camera = camera_of(frame), .texture = texture});
  std::filesystem::copy(sequence.folder / texture, folder.path);
  return Luminance(render(folder.path));
}

/// What a command says in the folder, both streams, in one line; and its status.
struct Said {
  std::string words;
  int status;
};
Said said_in(const std::filesystem::path& folder, const std::string& command) {
  Said said;
  FILE* pipe = ::popen(("cd '" + folder.string() + "' && exec 2>&1; " + command).c_str(), "r");
  for (int c; (c = std::fgetc(pipe)) != EOF;)
    if (c != '\n') said.words += static_cast<char>(c);
  said.status = ::pclose(pipe);
  return said;
}

TEST(RenderSequence, GivesTheVeryPixelsOfSingleScenes) {
  const SmallSequence sequence(4);
  Frames done;
  render_sequence(sequence.folder, 1, 4, [&](std::size_t frame, const auto& file) {
    done.push_back(frame);
    EXPECT_EQ(file, sequence.folder / numbered_file("frame", frame, 4));
    expect_same_pixels(Luminance(file), single_frame(sequence, frame));
  });
  EXPECT_EQ(done, (Frames{1, 2, 3, 4}));
}

TEST(RenderSequence, MakesTheFramesThatAreAskedForAndNothingElse) {
  const SmallSequence sequence(4);
  Frames done;
  render_sequence(sequence.folder, 2, 3, [&](auto frame, const auto&) { done.push_back(frame); });
  EXPECT_EQ(done, (Frames{2, 3}));
  EXPECT_EQ(sequence.frames_there(), (std::set<std::string>{"frame.0002.exr", "frame.0003.exr"}));
}

TEST(RenderSequence, MayRunTwiceInAFolderAtTheSameTime) {
  const SmallSequence sequence(4);
  Frames early, late;
  auto other = std::async(std::launch::async, [&] {
    render_sequence(sequence.folder, 3, 4, [&](auto frame, const auto&) { late.push_back(frame); });
  });
  render_sequence(sequence.folder, 1, 2, [&](auto frame, const auto&) { early.push_back(frame); });
  other.get();
  EXPECT_EQ(early, (Frames{1, 2}));
  EXPECT_EQ(late, (Frames{3, 4}));
  EXPECT_EQ(sequence.frames_there().size(), 4u);
  expect_same_pixels(Luminance(sequence.folder / "frame.0003.exr"), single_frame(sequence, 3));
}

TEST(RenderSequence, MakesASequenceOfOneFrame) {
  const SmallSequence sequence(1);
  render_sequence(sequence.folder, 1, 1, [&](std::size_t, const auto& file) {
    expect_same_pixels(Luminance(file), single_frame(sequence, 1));
  });
  EXPECT_EQ(sequence.frames_there(), (std::set<std::string>{"frame.0001.exr"}));
}

TEST(SequenceFolder, NeedsNothingButPovRay) {
  const SmallSequence sequence(3);
  EXPECT_EQ(said_in(sequence.folder, "povray eclipse.ini").status, 0);
  EXPECT_EQ(sequence.frames_there(),
            (std::set<std::string>{"frame.0001.exr", "frame.0002.exr", "frame.0003.exr"}));
  for (std::size_t frame = 1; frame <= 3; ++frame)
    expect_same_pixels(Luminance(sequence.folder / numbered_file("frame", frame, 3)),
                       single_frame(sequence, frame));
}

TEST(SequenceFolder, RendersASubsetByPovRaysOwnSwitches) {
  const SmallSequence sequence(5);
  EXPECT_EQ(said_in(sequence.folder, "povray eclipse.ini +SF3 +EF4").status, 0);
  EXPECT_EQ(sequence.frames_there(), (std::set<std::string>{"frame.0003.exr", "frame.0004.exr"}));
  expect_same_pixels(Luminance(sequence.folder / "frame.0004.exr"), single_frame(sequence, 4));
}

TEST(SequenceFolder, ShowsTheFirstFrameWithoutAnAnimation) {
  const SmallSequence sequence(2);
  const auto said = said_in(sequence.folder,
                            "povray +Ieclipse.pov +Ostill.exr +FE +W60 +H40 +A0.0 +AM2 +R2 -J -D");
  EXPECT_EQ(said.status, 0) << said.words;
  expect_same_pixels(Luminance(sequence.folder / "still.exr"), single_frame(sequence, 1));
}

TEST(SequenceFolder, SaysThatAFrameIsPastTheLast) {
  const SmallSequence sequence(2);
  const auto said = said_in(sequence.folder, "povray eclipse.ini +SF3 +EF3");
  EXPECT_NE(said.status, 0);
  EXPECT_TRUE(says(said.words, "frame 3: this sequence")) << said.words;
  EXPECT_TRUE(sequence.frames_there().empty());
}

TEST(RenderSequence, HandsOverTheFramesBeforeAMissingTexture) {
  const SmallSequence sequence(4);
  std::filesystem::remove(sequence.folder / "moon.0003.exr");
  Frames done;
  const auto said = refusal_of([&] {
    render_sequence(sequence.folder, 1, 4, [&](std::size_t frame, const auto& file) {
      done.push_back(frame);
      EXPECT_GT(Luminance(file).total(), 0);
    });
  });
  EXPECT_TRUE(says(said, "Cannot find file 'moon.0003.exr'") && !says(said, "\\n")) << said;
  EXPECT_EQ(done, (Frames{1, 2}));
  EXPECT_EQ(sequence.frames_there(), (std::set<std::string>{"frame.0001.exr", "frame.0002.exr"}));
}

/// A folder for stand-ins of POV-Ray, which are run in it as
/// `stand-in eclipse.ini +Oframe.tmp.….exr … +SF1 +EF3`.
struct StandIn {
  TemporaryFolder parent;
  std::filesystem::path folder = parent.path;

  StandIn() { write_sequence(folder, of_frames(3)); }
  RenderSettings settings(const std::string& script, double timeout_s = 0) const {
    const std::string frame =
        "o=\"${2#+O}\"; frame() { echo \"$1\" > \"${o%.exr}000$1.exr\"; }\n"
        "begin() { printf '\\nRendering frame %s of 3\\n' \"$1\" >&2; }\n";
    return {.threads = 0, .timeout_s = timeout_s, .povray = script_in(folder, frame + script)};
  }
  bool has(const char* name) const { return std::filesystem::exists(folder / name); }
};

TEST(RenderSequence, HandsOverAFrameWhenTheNextBegins) {
  const StandIn stand_in;
  Frames done;
  // It waits for the word of the listener, for 50 s.
  const auto settings = stand_in.settings(
      "begin 1; begin 1; frame 1; begin 2; n=0\n"
      "until [ -e go ]; do n=$((n+1)); [ $n -lt 500 ] || exit 1; sleep 0.1; done\n"
      "frame 2; begin 3; frame 3");
  render_sequence(
      stand_in.folder, 1, 3,
      [&](std::size_t frame, const auto& file) {
        done.push_back(frame);
        EXPECT_EQ(std::filesystem::file_size(file), 2u);
        std::ofstream(stand_in.folder / "go") << "on";
      },
      settings);
  EXPECT_EQ(done, (Frames{1, 2, 3}));
}

TEST(RenderSequence, HandsOverNoFrameThatFailed) {
  const StandIn stand_in;
  Frames done;
  const auto settings = stand_in.settings(
      "begin 1; frame 1; begin 2; frame 2; begin 3; frame 3; echo 'Out of ink' >&2; exit 1");
  EXPECT_THROW(render_sequence(
                   stand_in.folder, 1, 3,
                   [&](std::size_t frame, const auto&) { done.push_back(frame); }, settings),
               Error);
  EXPECT_EQ(done, (Frames{1, 2}));
  EXPECT_FALSE(stand_in.has("frame.0003.exr"));
  EXPECT_EQ(files_in(stand_in.folder), 5);
}

TEST(RenderSequence, DoesNotTakeSilenceForFrames) {
  const StandIn stand_in;
  const auto said = refusal_of([&] {
    render_sequence(
        stand_in.folder, 1, 2, [](std::size_t, const auto&) {},
        stand_in.settings("begin 1; frame 1"));
  });
  EXPECT_TRUE(says(said, "wrote no ") && says(said, "frame.0002.exr")) << said;
}

TEST(RenderSequence, StopsPovRayWhenTheListenerThrows) {
  const StandIn stand_in;
  struct Enough {};
  EXPECT_THROW(render_sequence(
                   stand_in.folder, 1, 3, [](std::size_t, const auto&) { throw Enough{}; },
                   stand_in.settings("echo $$ > pid; frame 1; begin 2; exec sleep 20")),
               Enough);
  pid_t povray = 0;
  std::ifstream(stand_in.folder / "pid") >> povray;
  ASSERT_GT(povray, 0);
  EXPECT_EQ(::kill(povray, 0), -1);
  EXPECT_TRUE(stand_in.has("frame.0001.exr"));
}

TEST(RenderSequence, StopsARealPovRayWhenTheListenerThrows) {
  const SmallSequence sequence(4);
  EXPECT_THROW(render_sequence(sequence.folder, 1, 4,
                               [](std::size_t, const auto&) { throw Error("enough"); }),
               Error);
  EXPECT_EQ(sequence.frames_there(), (std::set<std::string>{"frame.0001.exr"}));
}

TEST(RenderSequence, LeavesNoPovRayBehindWhenItIsKilled) {
  const StandIn stand_in;
  const auto settings = stand_in.settings("echo $$ > pid.tmp; mv pid.tmp pid; exec sleep 20");
  EXPECT_EQ(signal_after_our_death(stand_in.folder / "pid",
                                   [&] {
                                     render_sequence(
                                         stand_in.folder, 1, 3, [](std::size_t, const auto&) {},
                                         settings);
                                   }),
            SIGKILL);
}

TEST(RenderSequence, StopsPovRayWhenTheTimeIsUp) {
  const StandIn stand_in;
  Frames done;
  EXPECT_THROW(
      render_sequence(
          stand_in.folder, 1, 3, [&](std::size_t frame, const auto&) { done.push_back(frame); },
          stand_in.settings("frame 1; begin 2; exec sleep 20", 2)),
      Error);
  EXPECT_EQ(done, (Frames{1}));
}

TEST(RenderSequence, RefusesFramesThatTheSequenceHasNot) {
  const StandIn stand_in;
  const auto refuse = [&](std::size_t first, std::size_t last) {
    EXPECT_THROW(render_sequence(
                     stand_in.folder, first, last, [](std::size_t, const auto&) {},
                     stand_in.settings("exit 0")),
                 Error)
        << first << " to " << last;
  };
  refuse(0, 1), refuse(1, 4), refuse(3, 2), refuse(4, 4);
}

TEST(RenderSequence, RefusesAFolderWithoutASequence) {
  const TemporaryFolder folder;
  const auto frames = [&] { render_sequence(folder.path, 1, 1, [](std::size_t, const auto&) {}); };
  EXPECT_THROW(frames(), Error);
  write_scene(folder.path, {.camera = camera_of(1), .texture = "moon.0001.exr"});
  EXPECT_THROW(frames(), Error);
  EXPECT_EQ(files_in(folder.path), 2);
}

}  // namespace coppermoon::povray_scenes::sequence_test

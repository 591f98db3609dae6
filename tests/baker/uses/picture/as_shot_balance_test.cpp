// SPDX-License-Identifier: MIT
#include "uses/picture/as_shot_balance.h"

#include "baker/texture/scratch_folder.h"
#include "support/maker_notes.h"
#include "texture/write_image.h"

namespace coppermoon::uses::as_shot_balance_test {

using Gains = std::array<double, 3>;

class AsShotBalance : public ScratchFolder {
 protected:
  std::string photo() const {
    const auto file = in_folder("a.png");
    texture::write_png(file, texture::Image(4, 4, {"R", "G", "B"}), 8);
    return file.string();
  }
  std::optional<Gains> of(const std::string& make, const Gains& gains) const {
    const auto file = photo();
    support::write_balance(file, make, gains);
    return as_shot_balance(file);
  }
};

TEST_F(AsShotBalance, IsReadAsCanonAndNikonWriteIt) {
  // frames of an EOS 550D in the partial phase and in totality, over 1024
  for (const auto& [red, blue] : {std::pair{2166., 1686.}, {1542., 2260.}}) {
    const auto found = of("Canon", {red / 1024, 1, blue / 1024}).value();
    EXPECT_WITHIN_RELATIVE(found[0], red / 1024, 1e-6, "whole numbers, in floats");
    EXPECT_EQ(found[1], 1);
    EXPECT_WITHIN_RELATIVE(found[2], blue / 1024, 1e-6, "whole numbers, in floats");
  }
  const auto found = of("NIKON CORPORATION", {2.0625, 1, 1.375}).value();
  EXPECT_EQ(found, (Gains{2.0625, 1, 1.375})) << "these are in 256ths";
}

TEST_F(AsShotBalance, IsRelativeToGreen) { EXPECT_EQ(of("Canon", {4, 2, 3}), (Gains{2, 1, 1.5})); }

TEST_F(AsShotBalance, IsNothingWithoutSoundNotes) {
  EXPECT_EQ(as_shot_balance(photo()), std::nullopt) << "no notes";
  for (const auto* make : {"Canon", "NIKON CORPORATION"}) {
    EXPECT_EQ(of(make, {20, 1, 1.5}), std::nullopt) << make;
    EXPECT_EQ(of(make, {2, 1, 0.05}), std::nullopt) << make;
  }
  EXPECT_EQ(of("Canon", {0, 0, 0}), std::nullopt) << "0/0";
}

TEST_F(AsShotBalance, IsNothingForAFileThatIsNoPhotograph) {
  EXPECT_EQ(as_shot_balance(file("a.txt", "a text").string()), std::nullopt);
  EXPECT_EQ(as_shot_balance(in_folder("absent.jpg").string()), std::nullopt);
}

}  // namespace coppermoon::uses::as_shot_balance_test

// SPDX-License-Identifier: MIT
// Pages in a real browser, Chromium without a window.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "end_to_end/program.h"

namespace coppermoon::end_to_end {

class BrowserTest : public ProgramTest {
 protected:
  /// JavaScript by which a page says `said`, for answer_of.
  static constexpr const char* saying =
      "const place = document.createElement('pre');\n"
      "place.id = 'said';\n"
      "place.textContent = btoa(unescape(encodeURIComponent(JSON.stringify(said))));\n"
      "document.body.append(place);";

  /// What a page says.
  nlohmann::json answer_of(const std::filesystem::path& page, const std::string& size) const {
    const auto outcome =
        run({"chromium-headless-shell", "--no-sandbox", "--disable-gpu-sandbox",
             "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             "--disable-background-networking", "--disable-component-update", "--no-first-run",
             "--user-data-dir=" + here("../tmp/browser").string(), "--window-size=" + size,
             "--virtual-time-budget=120000", "--dump-dom", "file://" + page.string()});
    return answer_in(outcome.out);
  }

 private:
  static nlohmann::json answer_in(const std::string& dom) {
    const std::string before = "<pre id=\"said\">";
    const auto from = dom.find(before);
    if (from == std::string::npos) {
      ADD_FAILURE() << "the browser said nothing: is chromium-headless-shell installed?";
      return {{"problems", nlohmann::json::array()}, {"answer", {}}};
    }
    const auto coded =
        dom.substr(from + before.size(), dom.find('<', from + 1) - from - before.size());
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    unsigned bits = 0, count = 0;
    for (const char letter : coded) {
      if (letter == '=') break;
      bits = bits << 6 | static_cast<unsigned>(letters.find(letter));
      if ((count += 6) >= 8) text += static_cast<char>(bits >> (count -= 8));
    }
    return nlohmann::json::parse(text);
  }
};

}  // namespace coppermoon::end_to_end

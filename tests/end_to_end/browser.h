// SPDX-License-Identifier: MIT
// Pages in a real browser, Chromium without a window.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "support/program.h"

namespace coppermoon::end_to_end {

/// What a page printed last.
inline nlohmann::json said_in(const std::string& dom, const std::string& errors) {
  const std::string before = "<pre id=\"said\">";
  const auto from = dom.find(before);
  if (from == std::string::npos) {
    ADD_FAILURE() << "the browser said nothing: is chromium-headless-shell installed?\n"
                  << errors << dom.substr(0, 1000);
    return nlohmann::json::object();
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

/// What a script returns that runs beside a page, within two minutes. A problem of the page's or the
/// script's fails; so does a script that throws. The browser holds a page to be loading while a document within
/// it is open, and prints it when it is loaded: so it waits as long as the script does.
inline nlohmann::json answer_of(const ProgramFolder& folder, const std::string& page,
                                const std::string& script, const std::string& size) {
  const auto probe = folder.file(
      "probe.html",
      "<iframe hidden id=\"asked\"></iframe>\n"
      "<script>document.getElementById('asked').contentDocument.open();\n"
      "window.problems = [];\n"
      "window.onerror = (text) => problems.push(String(text));\n"
      "window.onunhandledrejection = (event) => problems.push(String(event.reason));\n"
      "console.error = console.warn = (...texts) => problems.push(texts.join(' '));</script>" +
          page +
          "<script>(async () => {\n"
          "let answer;\n"
          "try { answer = await (async () => {" +
          script +
          "})(); } catch (problem) { problems.push(String(problem.stack)); }\n"
          "const place = document.createElement('pre');\n"
          "place.id = 'said';\n"
          "place.textContent = btoa(unescape(encodeURIComponent(JSON.stringify({answer, "
          "problems}))));\n"
          "document.body.append(place);\n"
          "document.getElementById('asked').contentDocument.close();\n"
          "})();</script>");
  const auto outcome = folder.run(
      {"chromium-headless-shell", "--no-sandbox", "--disable-gpu-sandbox",
       "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking",
       "--disable-component-update", "--no-first-run",
       "--user-data-dir=" + folder.here("../tmp/browser").string(), "--window-size=" + size,
       "--timeout=120000", "--dump-dom", "file://" + probe.string()});
  const auto said = said_in(outcome.out, outcome.err);
  EXPECT_EQ(said.value("problems", nlohmann::json::array()), nlohmann::json::array());
  return said.value("answer", nlohmann::json());
}

}  // namespace coppermoon::end_to_end

// SPDX-License-Identifier: MIT
#include "result/fields.h"

#include <fmt/format.h>

namespace coppermoon::result {
namespace {

const char* name(Kind kind) {
  constexpr const char* names[] = {"truth",   "whole",   "number", "text",    "word",
                                   "instant", "numbers", "list",   "by-name", "object"};
  return names[static_cast<std::size_t>(kind)];
}

nlohmann::ordered_json as_json(const Field& field) {
  nlohmann::ordered_json json{{"key", field.key}, {"kind", name(field.kind)}};
  if (field.kind == Kind::list || field.kind == Kind::by_name) json["of"] = name(field.of);
  if (!field.unit.empty()) json["unit"] = field.unit;
  if (!field.words.empty()) json["words"] = field.words;
  if (field.may_be_none) json["may_be"] = field.may_be_absent ? "absent" : "null";
  json["meaning"] = field.meaning;
  for (const auto& part : field.parts) json["fields"].push_back(as_json(part));
  return json;
}

}  // namespace

std::string meaning_of(const Field& field) {
  return field.unit.empty() ? field.meaning : fmt::format("{} [{}]", field.meaning, field.unit);
}

nlohmann::ordered_json as_json(const Fields& fields) {
  auto all = nlohmann::ordered_json::array();
  for (const auto& field : fields.all) all.push_back(as_json(field));
  return all;
}

}  // namespace coppermoon::result

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "algebra/error.h"

namespace coppermoon::request {

/// Kind of the values that a parameter takes.
enum class Kind {
  number,    ///< a number
  whole,     ///< a whole number
  natural,   ///< a whole number, 0 or more
  word,      ///< one of `Parameter::words`
  on_off,    ///< "on" or "off"
  presence,  ///< "true", or no value: a flag without one
  text,      ///< text that `Parameter::meaning` explains
  file_read,
  file_written,
  folder_written
};

/// Stage of the work that a parameter affects first; all later stages follow.
enum class Affects {
  photons,  ///< photons traced, and light, which is made of them
  light,    ///< light on the Moon
  ground,   ///< the Moon's ground, its texture, or the moment
  sight,    ///< air between the Moon and the observer: textures and frames
  frame,    ///< the camera's place and field: frames
  picture,  ///< exposure and development: pictures
  share,    ///< part of the work that this run does
  run       ///< where results go, and how a run is reported
};

/// Lowest and highest value allowed.
struct Range {
  double low, high;
};

using Texts = std::vector<std::string>;

/// Error of a text that is no value of its parameter's kind, or none of the words allowed.
struct UnknownWord : algebra::Error {
  using algebra::Error::Error;
};

class Parameters;

/// What stands at another parameter of a request: any value, or one of some.
struct Condition {
  std::string name;  ///< of the other parameter
  /// Values that count, of a list with commas any of its parts; ".png" is the ending of a file's name. Empty: any value.
  Texts values{};
};
using Conditions = std::vector<Condition>;

/// Dependence of a parameter's effect on other parameters. Those that a command has not are passed over.
struct Relation {
  bool
      needed;  ///< an effect only with one of the conditions, never without any; else none beside any of them
  Conditions conditions;
  Texts of{};  ///< values of the parameter itself that depend so; empty: all
};

/// One parameter of a request, bound to the field that holds its value.
///
/// Every door speaks text: a number is spelt so that it reads back as the same number.
struct Parameter {
  std::string name;  ///< "ozone-du": its flag without dashes, its key in a recipe
  /// Of its flag, as "-o,--output"; the name alone where it is "--" and the name
  std::string spelling;
  Kind kind = Kind::text;
  std::string meaning;  ///< for help, docstrings and tables; with unit and range
  std::optional<Range> range{};
  Texts words{};
  /// Endings of a file that is written, and what each holds; none: those that `meaning` names
  std::vector<std::pair<std::string, std::string>> endings{};
  std::string usual{};    ///< the field's first value; empty: none
  std::string heading{};  ///< in help; for readers alone
  std::string table{};    ///< of a recipe, as "camera"; empty: above all tables
  Affects affects = Affects::ground;
  bool planned = false;  ///< replaced by the plan's work in the recipe of what was made
  bool many = false;     ///< may be given again, and every value counts
  bool is_required = false;
  Texts excluded{};  ///< names of parameters that it is refused beside
  std::shared_ptr<Parameters> parts{};  ///< of a value "name=text,name=text"; else none
  std::vector<Relation> relations{};    ///< that decide whether it has an effect
  std::optional<Texts> given{};         ///< texts that a door gave, as a recipe spells them

  std::function<Texts()> read{};  ///< texts of the field's value; empty: no value
  /// Throws algebra::Error for texts that are not allowed
  std::function<void(const Texts&)> write{};
  std::function<void()> restore{};  ///< puts back the field's first value
  /// Text as recipes spell it, in place of `spelt`: "10" of "10s". Throws algebra::Error for texts that are not allowed
  std::function<std::string(const std::string&)> respelt{};

  /// Texts that were given, else of the field's value.
  Texts texts() const { return given ? *given : read(); }

  /// Whether words of a command line without a flag are its values, as the instant.
  bool is_positional() const {
    return spelling.front() != '-' && spelling.find(',') != std::string::npos;
  }

  /// The last of `texts`; empty: no value.
  std::string text() const;

  /// Whether some value stands there: given, or the field's own.
  bool has_value() const { return !texts().empty(); }

  /// Sets the field from the texts of a flag, a recipe or a Python argument.
  ///
  /// Throws  UnknownWord     for a text that is no value of its kind, or none of the words
  ///         algebra::Error  for one that is not allowed: also for a number outside the range
  void take(const Texts& texts);

  /// Forgets what was given.
  void reset();

  Parameter& in(std::string title) { return heading = std::move(title), *this; }
  Parameter& of(Affects what) { return affects = what, *this; }
  Parameter& within(double low, double high) { return range = Range{low, high}, *this; }
  Parameter& replaced_by_plan() { return planned = true, *this; }
  Parameter& one_of(Texts allowed) {
    return kind = Kind::word, words = std::move(allowed), *this;
  }
  Parameter& required() { return is_required = true, *this; }
  Parameter& excludes(std::string other) {
    return excluded.push_back(std::move(other)), *this;
  }
  Parameter& reads_file() { return as(Kind::file_read); }
  Parameter& writes_file() { return as(Kind::file_written).of(Affects::run); }
  /// Names a file that is written, in one of the formats of a table.
  template <class Formats>
  Parameter& writes_file(const Formats& formats) {
    for (const auto& format : formats) endings.emplace_back(format.ending, format.help);
    return writes_file();
  }
  Parameter& writes_folder() { return as(Kind::folder_written).of(Affects::run); }
  Parameter& as(Kind what) { return kind = what, *this; }
  Parameter& spelt_by(std::function<std::string(const std::string&)> how) {
    return respelt = std::move(how), *this;
  }
  /// Has an effect only where one of the conditions holds, never where there is none; `own`: of these values alone.
  Parameter& only_with(Conditions any, Texts own = {}) {
    return relations.push_back({true, std::move(any), std::move(own)}), *this;
  }
  /// Has no effect where one of the conditions holds; `own`: of these values alone.
  Parameter& not_beside(Conditions any, Texts own = {}) {
    return relations.push_back({false, std::move(any), std::move(own)}), *this;
  }
};

/// Whether the recipe of what is made holds that parameter.
inline bool in_recipes(const Parameter& parameter) { return parameter.affects < Affects::share; }

/// Whether values of that kind are numbers in TOML, JSON and Python.
inline bool is_number(Kind kind) {
  return kind == Kind::number || kind == Kind::whole || kind == Kind::natural;
}

/// Whether values of that kind name what is read or written.
inline bool is_written(Kind kind) {
  return kind == Kind::file_written || kind == Kind::folder_written;
}

/// Unit that the meaning of a number tells, as "km" of "step of a path [km]"; empty: none.
std::string unit_of(const Parameter& parameter);

/// Why a text is no value of that kind, as "1.5, allowed whole numbers"; empty where it is one.
std::string fault_in(Kind kind, const std::string& text);

/// The text as recipes spell it: numbers alike however they were given.
std::string spelt(Kind kind, const std::string& text);

/// Text of a value as recipes write it; read_text reads it back.
std::string text_of(double value);
std::string text_of(int value);
std::string text_of(std::size_t value);
inline std::string text_of(const std::string& value) { return value; }
inline std::string text_of(const std::filesystem::path& value) { return value.string(); }
void read_text(const std::string& text, double& value);
void read_text(const std::string& text, int& value);
void read_text(const std::string& text, std::size_t& value);
inline void read_text(const std::string& text, std::string& value) { value = text; }
inline void read_text(const std::string& text, std::filesystem::path& value) { value = text; }

/// "ozone-du", "output", "instant" of "ozone-du", "-o,--output", "instant,--instant".
std::string name_in(std::string_view spelling);

template <class Value>
constexpr Kind kind_of() {
  if constexpr (std::is_same_v<Value, double>)
    return Kind::number;
  else if constexpr (std::is_same_v<Value, std::size_t>)
    return Kind::natural;
  else if constexpr (std::is_same_v<Value, int>)
    return Kind::whole;
  else
    return Kind::text;
}

/// A parameter of a field: a double, int, std::size_t, std::string or path, one of these that may be without a
/// value, or a list of texts or paths.
template <class Value>
Parameter parameter(const std::string& spelling, Value& value, std::string meaning) {
  Parameter made{.name = name_in(spelling), .spelling = spelling, .meaning = std::move(meaning)};
  made.kind = kind_of<Value>();
  made.read = [&value] {
    const auto text = text_of(value);
    return text.empty() ? Texts{} : Texts{text};
  };
  made.write = [&value](const Texts& texts) { read_text(texts.back(), value); };
  made.restore = [&value, first = value] { value = first; };
  return made;
}

template <class Value>
Parameter parameter(const std::string& spelling, std::optional<Value>& value, std::string meaning) {
  Parameter made{.name = name_in(spelling), .spelling = spelling, .meaning = std::move(meaning)};
  made.kind = kind_of<Value>();
  made.read = [&value] { return value ? Texts{text_of(*value)} : Texts{}; };
  made.write = [&value](const Texts& texts) {
    value.reset();
    if (!texts.empty()) read_text(texts.back(), value.emplace());
  };
  made.restore = [&value, first = value] { value = first; };
  return made;
}

template <class Value>
Parameter parameter(const std::string& spelling, std::vector<Value>& values, std::string meaning) {
  Parameter made{.name = name_in(spelling), .spelling = spelling, .meaning = std::move(meaning)};
  made.many = true;
  made.read = [&values] {
    Texts texts;
    for (const auto& value : values) texts.push_back(text_of(value));
    return texts;
  };
  made.write = [&values](const Texts& texts) { values.assign(texts.begin(), texts.end()); };
  made.restore = [&values, first = values] { values = first; };
  return made;
}

/// A parameter whose text a function reads, as "2s" or "42.86,-73.77".
///
/// Given  read   text of the field's value; empty: no value
///        write  puts the text's value into the field; throws algebra::Error for one that it cannot read
template <class Value>
Parameter parsed(const std::string& spelling, Value& value, std::function<std::string()> read,
                 std::function<void(const std::string&)> write, std::string meaning) {
  Parameter made{.name = name_in(spelling), .spelling = spelling, .meaning = std::move(meaning)};
  made.read = [read = std::move(read)] {
    const auto text = read();
    return text.empty() ? Texts{} : Texts{text};
  };
  made.write = [write = std::move(write)](const Texts& texts) { write(texts.back()); };
  made.restore = [&value, first = value] { value = first; };
  return made;
}

/// Words of a parameter, each with its value.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

/// Place of a word among a parameter's words.
///
/// Throws  algebra::Error  when it is none of them: names them
std::size_t word_in(const Texts& words, const std::string& name, const std::string& text);

template <class Value>
std::string word_for(const Words<Value>& words, const Value& value) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return word;
  return {};
}

namespace detail {
template <class Value>
// NOLINTNEXTLINE(performance-unnecessary-value-param): clang-tidy 14 does not see that it is moved
Parameter one_of(const std::string& spelling, const Words<Value>& words, std::string meaning) {
  Parameter made{.name = name_in(spelling),
                 .spelling = spelling,
                 .kind = std::is_same_v<Value, bool> && words.front().first == "on" ? Kind::on_off
                                                                                    : Kind::word,
                 .meaning = std::move(meaning)};
  for (const auto& word : words) made.words.push_back(word.first);
  return made;
}
}  // namespace detail

/// A parameter of one of some words.
template <class Value>
Parameter choice(const std::string& spelling, Value& value,
                 const Words<std::type_identity_t<Value>>& words, std::string meaning) {
  auto made = detail::one_of<Value>(spelling, words, std::move(meaning));
  made.read = [&value, words] {
    const auto word = word_for<Value>(words, value);
    return word.empty() ? Texts{} : Texts{word};
  };
  made.write = [&value, words, all = made.words, name = made.name](const Texts& texts) {
    value = words[word_in(all, name, texts.back())].second;
  };
  made.restore = [&value, first = value] { value = first; };
  return made;
}

template <class Value>
Parameter choice(const std::string& spelling, std::optional<Value>& value,
                 const Words<std::type_identity_t<Value>>& words, std::string meaning) {
  auto made = detail::one_of<Value>(spelling, words, std::move(meaning));
  made.read = [&value, words] { return value ? Texts{word_for<Value>(words, *value)} : Texts{}; };
  made.write = [&value, words, all = made.words, name = made.name](const Texts& texts) {
    value.reset();
    if (!texts.empty()) value = words[word_in(all, name, texts.back())].second;
  };
  made.restore = [&value, first = value] { value = first; };
  return made;
}

/// "on" or "off".
template <class Switch>
Parameter on_off(const std::string& spelling, Switch& value, std::string meaning) {
  return choice(spelling, value, Words<bool>{{"on", true}, {"off", false}}, std::move(meaning));
}

/// A flag without a value.
Parameter presence(const std::string& spelling, bool& value, std::string meaning);

/// Parameters in the order of help. Fields that they are bound to stay where they are for as long as they are used.
class Parameters {
 public:
  /// Heading, recipe's table, and what is affected, of all that is added from here on.
  void begin(std::string heading, std::string table, Affects affects);

  Parameter& add(Parameter parameter);

  /// Keeps a parameter of another list as it is.
  Parameter& keep(Parameter parameter) { return all_.emplace_back(std::move(parameter)); }

  Parameter* find(std::string_view name);
  const Parameter* find(std::string_view name) const;

  auto begin() { return all_.begin(); }
  auto end() { return all_.end(); }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  std::size_t size() const { return all_.size(); }

  /// Addresses last when more are added
 private:
  std::deque<Parameter> all_;
  std::string heading_, table_;
  Affects affects_ = Affects::ground;
};

/// Given parameters that have no effect beside the others, as "--sky, --glow: no effect without --camera"; one line for
/// each reason.
///
/// Given  spelt  a parameter's name as the door spells it
///        asked  those that are asked for by somebody, not by a recipe that holds all values
std::vector<std::string> without_effect(const Parameters& parameters,
                                        const std::function<std::string(const Parameter&)>& spelt,
                                        const std::function<bool(const Parameter&)>& asked);

/// Takes the parts of a value, as "from-latitude=-90,to-latitude=0"; all others are reset.
///
/// Throws  algebra::Error  for a part that there is not, or that is not allowed
void take_parts(Parameters& parts, const std::string& text);

}  // namespace coppermoon::request

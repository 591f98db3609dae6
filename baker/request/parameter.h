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

/// The earliest stage of the work that a parameter affects; all later stages are affected too.
enum class Affects {
  photons,  ///< photons traced, and the light computed from them
  light,    ///< light on the Moon
  ground,   ///< the Moon's ground, its texture, or the moment
  sight,    ///< air between the Moon and the observer, in textures and frames
  frame,    ///< position and field of the camera, in frames
  picture,  ///< exposure and development, in pictures
  share,    ///< which part of the work this run does
  run       ///< where results go, and how a run is reported
};

/// Lowest and highest value allowed.
struct Range {
  double low, high;
};

using Texts = std::vector<std::string>;

/// Error for a text that is not a value of its parameter's kind, or not one of the words allowed.
struct UnknownWord : algebra::Error {
  using algebra::Error::Error;
};

class Parameters;

/// Condition on another parameter of a request: that it has a value, or one of certain values.
struct Condition {
  std::string name;  ///< name of the other parameter
  /// Values that meet it; in a list with commas, any part may match. ".png" is the ending of a file's name. If empty,
  /// any value meets it.
  Texts values{};
};
using Conditions = std::vector<Condition>;

/// How a parameter's effect depends on other parameters. Parameters that a command does not have are ignored.
struct Relation {
  bool
      needed;  ///< true: has an effect only if one of the conditions holds; false: only if none does
  Conditions conditions;
  Texts of{};  ///< values of the parameter itself that this applies to; empty: all
};

/// One parameter of a request, bound to the field that holds its value.
///
/// All values pass through text: a number is spelt so that it reads back as the same number.
struct Parameter {
  std::string name;  ///< "ozone-du": its flag without dashes, its key in a recipe
  /// Spellings of its flag, such as "-o,--output"; just the name if the flag is "--" and the name
  std::string spelling;
  Kind kind = Kind::text;
  std::string meaning;  ///< explanation for help, docstrings and tables, with unit and range
  std::optional<Range> range{};
  Texts words{};
  /// Endings allowed for a file to write, and what each holds. If empty, `meaning` names them.
  std::vector<std::pair<std::string, std::string>> endings{};
  std::string usual{};    ///< default, the field's initial value; empty if none
  std::string heading{};  ///< heading in help, only for readers
  std::string table{};    ///< table in a recipe, such as "camera"; empty: above all tables
  Affects affects = Affects::ground;
  bool planned = false;  ///< replaced in the result's recipe by what the plan chose
  bool many = false;     ///< may be given several times, and every value counts
  bool is_required = false;
  Texts excluded{};                     ///< names of parameters that it cannot be combined with
  std::shared_ptr<Parameters> parts{};  ///< parts of a value "name=text,name=text", if it has any
  std::vector<Relation> relations{};    ///< decide whether it has an effect
  std::optional<Texts> given{};         ///< texts that the caller gave, as a recipe spells them

  std::function<Texts()> read{};  ///< returns the field's value as texts
  /// Sets the field; throws algebra::Error for texts that are not allowed
  std::function<void(const Texts&)> write{};
  std::function<void()> restore{};  ///< restores the field's initial value
  /// Text as recipes spell it, used in place of `spelt`: "10" for "10s". Throws algebra::Error for a text not allowed
  std::function<std::string(const std::string&)> respelt{};

  /// The texts that were given, else those of the field's value.
  Texts texts() const { return given ? *given : read(); }

  /// Whether its value may stand on a command line without a flag, as the instant may.
  bool is_positional() const {
    return spelling.front() != '-' && spelling.find(',') != std::string::npos;
  }

  /// The last of `texts`; empty if there is no value.
  std::string text() const;

  /// Whether there is a value, given or the field's own.
  bool has_value() const { return !texts().empty(); }

  /// Sets the field from the texts of a flag, a recipe or a Python argument.
  ///
  /// Throws  UnknownWord     for a text that is not a value of its kind, or not one of the words
  ///         algebra::Error  for a text that is not allowed, such as a number outside the range
  void take(const Texts& texts);

  /// Forgets the texts that were given.
  void reset();

  Parameter& in(std::string title) { return heading = std::move(title), *this; }
  Parameter& of(Affects what) { return affects = what, *this; }
  Parameter& within(double low, double high) { return range = Range{low, high}, *this; }
  Parameter& replaced_by_plan() { return planned = true, *this; }
  Parameter& one_of(Texts allowed) { return kind = Kind::word, words = std::move(allowed), *this; }
  Parameter& required() { return is_required = true, *this; }
  Parameter& excludes(std::string other) { return excluded.push_back(std::move(other)), *this; }
  Parameter& reads_file() { return as(Kind::file_read); }
  Parameter& writes_file() { return as(Kind::file_written).of(Affects::run); }
  /// Its value names a file to write, in one of the formats in a table.
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
  /// Has an effect only if one of the conditions holds; `own`: this applies only to these values of its own.
  Parameter& only_with(Conditions any, Texts own = {}) {
    return relations.push_back({true, std::move(any), std::move(own)}), *this;
  }
  /// Has no effect if one of the conditions holds; `own`: this applies only to these values of its own.
  Parameter& not_beside(Conditions any, Texts own = {}) {
    return relations.push_back({false, std::move(any), std::move(own)}), *this;
  }
};

/// Whether the recipe of a result includes a parameter.
inline bool in_recipes(const Parameter& parameter) { return parameter.affects < Affects::share; }

/// Whether values of a kind are numbers in TOML, JSON and Python.
inline bool is_number(Kind kind) {
  return kind == Kind::number || kind == Kind::whole || kind == Kind::natural;
}

/// Whether values of a kind name a file or folder to write.
inline bool is_written(Kind kind) {
  return kind == Kind::file_written || kind == Kind::folder_written;
}

/// Unit that the meaning of a number gives in brackets, such as "km" in "step of a path [km]"; empty if none.
std::string unit_of(const Parameter& parameter);

/// Why a text is not a value of a kind, such as "1.5, allowed whole numbers"; empty if it is one.
std::string fault_in(Kind kind, const std::string& text);

/// The text as recipes spell it: equal numbers are spelt alike however they were given.
std::string spelt(Kind kind, const std::string& text);

/// A value as recipes write it; read_text reads it back.
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

/// Name in a spelling: "ozone-du", "output", "instant" for "ozone-du", "-o,--output", "instant,--instant".
std::string name_in(std::string_view spelling);

constexpr Kind kind_of(double) { return Kind::number; }
constexpr Kind kind_of(int) { return Kind::whole; }
constexpr Kind kind_of(std::size_t) { return Kind::natural; }
template <class Value>
constexpr Kind kind_of(const Value&) {
  return Kind::text;
}
template <class Value>
constexpr Kind kind_of(const std::optional<Value>&) {
  return kind_of(Value{});
}

/// A field's value as texts; empty if it has none. `put` reads them back.
template <class Value>
Texts texts_of(const Value& value) {
  auto text = text_of(value);
  return text.empty() ? Texts{} : Texts{std::move(text)};
}
template <class Value>
Texts texts_of(const std::optional<Value>& value) {
  return value ? Texts{text_of(*value)} : Texts{};
}
template <class Value>
Texts texts_of(const std::vector<Value>& values) {
  Texts texts;
  for (const auto& value : values) texts.push_back(text_of(value));
  return texts;
}

template <class Value>
void put(const Texts& texts, Value& value) {
  read_text(texts.back(), value);
}
template <class Value>
void put(const Texts& texts, std::optional<Value>& value) {
  value.reset();
  if (!texts.empty()) read_text(texts.back(), value.emplace());
}
template <class Value>
void put(const Texts& texts, std::vector<Value>& values) {
  values.assign(texts.begin(), texts.end());
}

/// A parameter bound to a field by functions that convert the field's value from and to text.
template <class Value>
Parameter bound(const std::string& spelling, Value& value, std::string meaning,
                std::function<Texts()> read, std::function<void(const Texts&)> write) {
  Parameter made{.name = name_in(spelling), .spelling = spelling, .meaning = std::move(meaning)};
  made.read = std::move(read);
  made.write = std::move(write);
  made.restore = [&value, first = value] { value = first; };
  return made;
}

/// A parameter bound to a field: a double, int, std::size_t, std::string or path, an optional one of these, or a list
/// of texts or paths.
template <class Value>
Parameter parameter(const std::string& spelling, Value& value, std::string meaning) {
  auto made = bound(
      spelling, value, std::move(meaning), [&value] { return texts_of(value); },
      [&value](const Texts& texts) { put(texts, value); });
  made.kind = kind_of(value);
  made.many =
      std::is_same_v<Value, Texts> || std::is_same_v<Value, std::vector<std::filesystem::path>>;
  return made;
}

/// A parameter whose text is read by a function, such as "2s" or "42.86,-73.77".
///
/// Given  read   returns the field's value as text; empty if it has none
///        write  sets the field from a text; throws algebra::Error for a text that it cannot read
template <class Value>
Parameter parsed(const std::string& spelling, Value& value, std::function<std::string()> read,
                 std::function<void(const std::string&)> write, std::string meaning) {
  return bound(
      spelling, value, std::move(meaning), [read = std::move(read)] { return texts_of(read()); },
      [write = std::move(write)](const Texts& texts) { write(texts.back()); });
}

/// Words that a parameter accepts, each with its value.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

/// Index of a text among a parameter's words.
///
/// Throws  algebra::Error  if the text is none of the words; the message lists them
std::size_t word_in(const Texts& words, const std::string& name, const std::string& text);

/// Word that stands for a value; empty if none does.
template <class Value, class Field>
std::string word_for(const Words<Value>& words, const Field& field) {
  for (const auto& [word, value] : words)
    if (field == value) return word;
  return {};
}

template <class Field>
struct Held {
  using Value = Field;
};
template <class Field>
struct Held<std::optional<Field>> {
  using Value = Field;
};

/// A parameter whose value is one of several words; the field may be optional.
template <class Field>
Parameter choice(const std::string& spelling, Field& field,
                 const Words<typename Held<Field>::Value>& words, std::string meaning) {
  Texts names;
  for (const auto& word : words) names.push_back(word.first);
  auto made = bound(
      spelling, field, std::move(meaning),
      [&field, words] { return texts_of(word_for(words, field)); },
      [&field, words, names, name = name_in(spelling)](const Texts& texts) {
        field = texts.empty() ? Field{} : Field{words[word_in(names, name, texts.back())].second};
      });
  made.kind = names.front() == "on" && names.size() == 2 ? Kind::on_off : Kind::word;
  made.words = std::move(names);
  return made;
}

/// A parameter whose value is "on" or "off".
template <class Switch>
Parameter on_off(const std::string& spelling, Switch& value, std::string meaning) {
  return choice(spelling, value, Words<bool>{{"on", true}, {"off", false}}, std::move(meaning));
}

/// A flag without a value.
Parameter presence(const std::string& spelling, bool& value, std::string meaning);

/// Parameters in the order of help. The fields that they are bound to must not move while the parameters are in use.
class Parameters {
 public:
  /// Sets the heading, the recipe's table and the stage affected for all parameters added from here on.
  void begin(std::string heading, std::string table, Affects affects);

  Parameter& add(Parameter parameter);

  /// Adds a parameter from another list unchanged.
  Parameter& keep(Parameter parameter) { return all_.emplace_back(std::move(parameter)); }

  Parameter* find(std::string_view name);
  const Parameter* find(std::string_view name) const;

  auto begin() { return all_.begin(); }
  auto end() { return all_.end(); }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  std::size_t size() const { return all_.size(); }

  /// A deque, so that addresses stay valid when more are added
 private:
  std::deque<Parameter> all_;
  std::string heading_, table_;
  Affects affects_ = Affects::ground;
};

/// Which of the given parameters have no effect, such as "--sky, --glow: no effect without --camera", one line for each
/// reason.
///
/// Given  spelt  spells a parameter's name for the user
///        asked  which parameters the user asked for, rather than a recipe that holds all values
std::vector<std::string> without_effect(const Parameters& parameters,
                                        const std::function<std::string(const Parameter&)>& spelt,
                                        const std::function<bool(const Parameter&)>& asked);

/// Sets the parts of a value from a text such as "from-latitude=-90,to-latitude=0" and resets all other parts.
///
/// Throws  algebra::Error  for a part that does not exist, or a value that is not allowed
void take_parts(Parameters& parts, const std::string& text);

}  // namespace coppermoon::request

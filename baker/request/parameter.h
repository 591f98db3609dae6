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

/// The kind of value that a parameter takes.
enum class Kind {
  number,    ///< any real number
  whole,     ///< a whole number
  natural,   ///< a whole number, 0 or more
  word,      ///< one of `Parameter::words`
  on_off,    ///< "on" or "off"
  presence,  ///< a flag that is given without a value
  text,      ///< any other text, explained in `Parameter::meaning`
  file_read,
  file_written,
  folder_written
};

/// The earliest step of the computation that a parameter affects; all later steps are affected too.
enum class Affects {
  photons,  ///< tracing photons and computing light from them
  light,    ///< the light that reaches the Moon
  ground,   ///< the Moon's surface, the texture, or the moment
  sight,    ///< the air between the Moon and the observer
  frame,    ///< the camera's position and field of view
  picture,  ///< exposure and development of pictures
  share,    ///< which share of the work this run does
  run       ///< where results are written and how progress is reported
};

/// Lowest and highest value allowed.
struct Range {
  double low, high;
};

using Texts = std::vector<std::string>;

/// Error for a string that is not of the parameter's kind, or is not one of the allowed words.
struct UnknownWord : algebra::Error {
  using algebra::Error::Error;
};

class Parameters;

/// A condition that another parameter must meet: to have any value at all, or to have one of several values.
struct Condition {
  std::string name;  ///< name of the other parameter
  /// Values that meet the condition; if empty, any value does. If the parameter's value is a list separated by commas,
  /// one matching item is enough. A value such as ".png" matches all strings with this ending.
  Texts values{};
};
using Conditions = std::vector<Condition>;

/// How other parameters decide whether a parameter has an effect. Parameters that a command does not have are ignored.
struct Relation {
  bool
      needed;  ///< if true, at least one condition must hold for an effect; if false, none may hold
  Conditions conditions;
  Texts of{};  ///< the parameter's values to which the relation applies; if empty, all
};

/// One parameter of a request, bound to the variable that holds its value (its field).
///
/// Values are passed as text. A number is written so that reading it gives exactly the same number.
struct Parameter {
  std::string name;  ///< flag without dashes, and key in recipes, such as "ozone-du"
  /// All spellings of the flag, such as "-o,--output". If the long spelling is the only one, it is without dashes.
  std::string spelling;
  Kind kind = Kind::text;
  std::string meaning;  ///< explanation for users, with unit and range
  std::optional<Range> range{};
  Texts words{};
  /// Endings allowed for a file to be written, each with a description of the content. If empty, `meaning` lists them.
  std::vector<std::pair<std::string, std::string>> endings{};
  std::string usual{};    ///< the default, which is the field's initial value; empty if none
  std::string heading{};  ///< heading under which help lists the parameter
  std::string table{};    ///< TOML table in recipes, such as "camera"; empty if there is none
  Affects affects = Affects::ground;
  bool planned = false;  ///< if true, a result's recipe holds planned settings instead of the value
  bool many = false;     ///< may be given several times, and all its values are used
  bool is_required = false;
  Texts excluded{};                     ///< parameters with which this one cannot be combined
  std::shared_ptr<Parameters> parts{};  ///< parts of a value such as "name=text,name=text"
  std::vector<Relation> relations{};    ///< conditions for the parameter to have an effect
  std::optional<Texts> given{};         ///< strings that the user gave, as recipes spell them

  std::function<Texts()> read{};  ///< returns the field's value as strings
  /// Sets the field; throws algebra::Error for strings that are not allowed
  std::function<void(const Texts&)> write{};
  std::function<void()> restore{};  ///< restores the field's initial value
  /// Spells a string as recipes do, such as "10" for "10s". Throws algebra::Error for a string that is not allowed. If
  /// this function is empty, the function `spelt` is used.
  std::function<std::string(const std::string&)> respelt{};

  /// The strings that the user gave, or else the field's value as strings.
  Texts texts() const { return given ? *given : read(); }

  /// Whether the parameter is a positional argument: a command line may give its value without a flag.
  bool is_positional() const {
    return spelling.front() != '-' && spelling.find(',') != std::string::npos;
  }

  /// The parameter's value as text, or the last one if it has several; empty if it has none.
  std::string text() const;

  /// Whether the parameter has a value, either given by the user or as the default of its variable.
  bool has_value() const { return !texts().empty(); }

  /// Sets the field from the strings of a flag, a recipe or a Python argument.
  ///
  /// Throws  UnknownWord     for a string that is not of the parameter's kind, or is not one of the allowed words
  ///         algebra::Error  for any other string that is not allowed, such as a number outside the range
  void take(const Texts& texts);

  /// Forgets the strings that the user gave, and restores the field's initial value.
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
  /// Declares that the value names a file to be written, in one of the given formats.
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
  /// Declares that the parameter has an effect only if one of the conditions holds. If `own` lists values of this
  /// parameter, the rule applies only to those values.
  Parameter& only_with(Conditions any, Texts own = {}) {
    return relations.push_back({true, std::move(any), std::move(own)}), *this;
  }
  /// Declares that the parameter has no effect if one of the conditions holds. If `own` lists values of this parameter,
  /// the rule applies only to those values.
  Parameter& not_beside(Conditions any, Texts own = {}) {
    return relations.push_back({false, std::move(any), std::move(own)}), *this;
  }
};

/// Whether a parameter is included in a result's recipe.
inline bool in_recipes(const Parameter& parameter) { return parameter.affects < Affects::share; }

/// Whether values of this kind are numbers in TOML, JSON and Python.
inline bool is_number(Kind kind) {
  return kind == Kind::number || kind == Kind::whole || kind == Kind::natural;
}

/// Whether values of this kind name a file or folder to be written.
inline bool is_written(Kind kind) {
  return kind == Kind::file_written || kind == Kind::folder_written;
}

/// The unit in brackets in a numeric parameter's meaning: "km" in "step of a path [km]". Empty if there is none.
std::string unit_of(const Parameter& parameter);

/// Why a string is not a value of the given kind, such as "1.5, allowed whole numbers"; empty if it is valid.
std::string fault_in(Kind kind, const std::string& text);

/// A string as recipes spell it. Equal numbers are spelt alike, however the user wrote them.
std::string spelt(Kind kind, const std::string& text);

/// Converts a value to the text that recipes hold for it. The function read_text converts it back.
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

/// The parameter's name, taken from its spelling: "output" from "-o,--output", "ozone-du" from "ozone-du".
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

/// A field's value as strings that `put` can read; empty if the field has no value.
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
/// of strings or paths.
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

/// A parameter given as a string, such as "2s" or "42.86,-73.77", that a function supplied by the caller parses.
///
/// Given  read   returns the field's value as a string; empty if it has none
///        write  sets the field from a string; throws algebra::Error if the string cannot be parsed
template <class Value>
Parameter parsed(const std::string& spelling, Value& value, std::function<std::string()> read,
                 std::function<void(const std::string&)> write, std::string meaning) {
  return bound(
      spelling, value, std::move(meaning), [read = std::move(read)] { return texts_of(read()); },
      [write = std::move(write)](const Texts& texts) { write(texts.back()); });
}

/// Words that a parameter accepts, each with the value for which it stands.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

/// Index of a string in the list of words that a parameter accepts.
///
/// Throws  algebra::Error  if the string is none of the words; the message lists them
std::size_t word_in(const Texts& words, const std::string& name, const std::string& text);

/// The word that stands for a value; empty if there is no such word.
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

/// A parameter whose value is one of several words. Its field may be a std::optional.
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

/// A parameter that is a flag without a value.
Parameter presence(const std::string& spelling, bool& value, std::string meaning);

/// A list of parameters, in the order in which help shows them. Their fields must not move while the list is in use.
class Parameters {
 public:
  /// Sets the heading in the help, the table in recipes and the affected step for all parameters that are added later.
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

  // a deque, so that the addresses of parameters stay valid when more are added
 private:
  std::deque<Parameter> all_;
  std::string heading_, table_;
  Affects affects_ = Affects::ground;
};

/// Reports which parameters have no effect although the user gave them. There is one line for each reason, such as
/// "--sky, --glow: no effect without --camera".
///
/// Given  spelt  returns a parameter's name as the user knows it
///        asked  whether the user set a parameter on purpose; a recipe may list parameters that the user did not set
std::vector<std::string> without_effect(const Parameters& parameters,
                                        const std::function<std::string(const Parameter&)>& spelt,
                                        const std::function<bool(const Parameter&)>& asked);

/// Sets the parts that a string such as "from-latitude=-90,to-latitude=0" names, and resets all other parts.
///
/// Throws  algebra::Error  if a part does not exist or a value is not allowed
void take_parts(Parameters& parts, const std::string& text);

}  // namespace coppermoon::request

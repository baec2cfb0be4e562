#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/fit/curves.h"

namespace tank_datum {

/// What a number is in for people and files; the structs hold metres, megapascals and radians.
enum class Unit { None, Metres, Megapascals, Degrees, ArcSeconds };

/// What a number may be, in its unit.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above = false, below = false;  ///< low, high itself is refused
  bool or_zero = false;               ///< 0 too, which has a meaning of its own

  bool hold(double value) const;
  /// "> 0 and < 90"
  std::string text() const;
};

inline Bounds atLeast(double low) { return {low}; }
inline Bounds above(double low) { return {low, std::numeric_limits<double>::infinity(), true}; }
inline Bounds aboveUpTo(double low, double high) { return {low, high, true}; }
inline Bounds within(double low, double high) { return {low, high}; }

/// One of a few words.
struct Choice {
  std::vector<std::string> words;
  bool needed = true;  ///< false: "", none of them, may be
  std::function<std::string()> get;
  std::function<void(const std::string&)> set;  ///< to one of the words, or to none where none may be
};

/// A figure of the tank; NaN: not given. In metres people type it with a unit.
struct Fact {
  double* value;
};

/// A file or folder; empty: none.
struct Path {
  std::string* path;
  bool folder = false;
};

/// Where setups stood: a file, or the places themselves.
struct Places {
  std::string* path;
  std::map<std::string, Eigen::Vector3d>* places;
};

/// Where the value of an option is kept.
using OptionValue = std::variant<bool*, int*, std::size_t*, double*, std::vector<double>*, std::vector<int>*,
                                 std::vector<std::string>*, std::optional<Circle>*, Fact, Path, Places, Choice>;

/// Who may give an option.
enum class Giver { All, Command, Library };

/// What there is to say of one option, and its value.
struct Option {
  std::string name;   ///< Python's keyword; at the command line "--" and dashes for underscores
  std::string place;  ///< in datum.json's `options`, "normals.k"; empty: it does not bear on the result
  OptionValue value;
  std::string help;   ///< without its unit
  std::string topic;  ///< heading of the page of options under which it stands
  Unit unit = Unit::None;
  Bounds bounds;
  Giver giver = Giver::All;
  char letter = 0;           ///< "-o" at the command line
  bool negatable = false;    ///< a flag that has "--no-" too
  bool configurable = true;  ///< may stand in a file of options
  bool of_scans = false;     ///< a levelling survey, which has no points, has no use for it

  Option& in(Unit u) { return unit = u, *this; }
  Option& within(const Bounds& b) { return bounds = b, *this; }
  Option& withNo() { return negatable = true, *this; }
  Option& ofCommand() { return giver = Giver::Command, *this; }
  Option& notInFiles() { return configurable = false, *this; }
  Option& ofLevellingsToo() { return of_scans = false, *this; }

  /// The help with its unit: "the smallest tank to look for [m]".
  std::string text() const;
  /// A number of the struct in the unit that people type, and back.
  double typed(double kept) const;
  double kept(double typed) const;
  /// A Fact that is given: NaN, which stands for none, is refused.
  /// @throws Error (Option)
  double given(double fact) const;
  /// What its value must be: "> 0 and < 90 deg", "refined or paper"; empty of flags and paths.
  std::string expected() const;
  /// Nothing when the value is fine.
  std::optional<Refusal> refused() const;
  /// Sets a Choice.
  /// @throws Error (Option) when the word is none of it
  void choose(const std::string& word);
};

}  // namespace tank_datum

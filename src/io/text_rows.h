#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/scan_source.h"
#include "io/text_lines.h"

namespace tank_datum {

class InputFile;

/// Which columns of a line are read.
struct TextColumns {
  static constexpr int kPassedOver = -1, kLabel = 3;  // 0, 1, 2: x, y, z

  char separator = ' ';               ///< ' ' means any blanks and tabs
  std::vector<int> meaning{0, 1, 2};  ///< of each column, up to the last that is read

  bool labelled() const;
};

/// Lines one after the other that are points of one setup.
struct TextSection {
  std::uint64_t first_line = 0, rows = 0;
  std::uint32_t label = 0;
  /// From the scanner's frame: point = pose * (x, y, z, 1). A point at zero is a beam without return then.
  std::optional<Eigen::Matrix<double, 3, 4>> pose;
  std::optional<Eigen::Vector3d> viewpoint;  ///< where the scanner stood, in stored units
};

/// A text of points.
struct TextRows {
  std::shared_ptr<const InputFile> file;
  TextLines lines;
  TextColumns columns;
  std::vector<TextSection> sections;  ///< in the order of their lines
  std::string label_field;            ///< what tells setups apart; empty: there is one
};

/// Fills the columns' values from a line: x, y, z and the label.
/// @return null when all are there, else where the first stands that is none
const char* parseRow(std::string_view line, const TextColumns& columns, std::array<double, 4>& values);

/// What the error of a line says that has no number at a place in it.
Error rowError(const TextLines& lines, std::uint64_t line, std::string_view text, const char* at);

/// The error of a line whose numbers have decimal commas.
Error commaError(const TextLines& lines, std::uint64_t line, std::string_view text);

/// The points of such a text, parsed by several threads, chunk by chunk.
std::shared_ptr<const Scan::Source> textSource(TextRows rows, double metres_per_unit);

}  // namespace tank_datum

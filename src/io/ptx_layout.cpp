#include "io/ptx_layout.h"

#include <Eigen/LU>
#include <cmath>
#include <string>

#include "io/io_error.h"
#include "io/text_number.h"

namespace tank_datum {
namespace {

constexpr std::uint64_t kHeaderLines = 10;

/// The next line's numbers, which are as many as asked for.
template <int Count>
Eigen::Matrix<double, Count, 1> numbersOf(const TextLines& lines, TextCursor& cursor, const char* what) {
  const std::uint64_t number = cursor.line();
  const auto line = cursor.next();
  if (!line) throw lines.error(number, "the end of the file", what);
  Eigen::Matrix<double, Count, 1> values;
  const char* const end = line->data() + line->size();
  const char* at = skipBlanks(line->data(), end);
  for (Eigen::Index i = 0; i < Count; ++i) {
    const char* stop = parseNumber(at, end, values[i]);
    if (stop == nullptr || (stop != end && !isBlank(*stop)) || !std::isfinite(values[i])) {
      throw lines.error(number, "\"" + echo(*line) + "\"", what);
    }
    at = skipBlanks(stop, end);
  }
  if (at != end) throw lines.error(number, "\"" + echo(*line) + "\"", what);
  return values;
}

/// The next line's count.
std::uint64_t countOf(const TextLines& lines, TextCursor& cursor, const char* what) {
  const std::uint64_t number = cursor.line();
  const auto line = cursor.next();
  const long long count = line ? parseWhole(*line) : -1;
  if (count < 0) throw lines.error(number, line ? "\"" + echo(*line) + "\"" : "the end of the file", what);
  return static_cast<std::uint64_t>(count);
}

/// The pose of a scan: the transposed of the matrix that the next lines are.
Eigen::Matrix<double, 3, 4> poseOf(const TextLines& lines, TextCursor& cursor) {
  constexpr double kRounding = 5e-5;  // in R R^T of entries of five decimals
  const std::uint64_t number = cursor.line();
  Eigen::Matrix4d matrix;
  for (Eigen::Index row = 0; row < 4; ++row) {
    matrix.row(row) = numbersOf<4>(lines, cursor, "a row of the matrix, 4 numbers").transpose();
  }
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const Eigen::Matrix3d off = rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  if (off.cwiseAbs().maxCoeff() > kRounding || rotation.determinant() < 0.0) {
    throw lines.error(number, "a matrix that is no rotation", "rows of length 1 at right angles, right-handed");
  }
  if (matrix.col(3) != Eigen::Vector4d(0, 0, 0, 1)) {
    throw lines.error(number, "another last column of the matrix", "0, 0, 0, 1");
  }
  return matrix.transpose().topRows<3>();
}

}  // namespace

void readPtx(TextRows& text) {
  TextCursor cursor(text.lines);
  for (std::uint64_t line = 0; line < text.lines.count();) {
    cursor.seek(line);
    const std::uint64_t columns = countOf(text.lines, cursor, "the columns of a scan");
    const std::uint64_t rows = countOf(text.lines, cursor, "the rows of a scan");
    Eigen::Vector3d position = numbersOf<3>(text.lines, cursor, "the scanner's position, 3 numbers");
    for (int axis = 0; axis < 3; ++axis) numbersOf<3>(text.lines, cursor, "an axis of the scanner, 3 numbers");
    const Eigen::Matrix<double, 3, 4> pose = poseOf(text.lines, cursor);
    const std::uint64_t first = line + kHeaderLines, most = text.lines.count() - first;
    std::uint64_t points = 0;
    if (__builtin_mul_overflow(columns, rows, &points) || points > most) {
      throw text.lines.error(line, std::to_string(columns) + " columns of " + std::to_string(rows) + " points",
                             "at most " + std::to_string(most) + " points, the lines that follow");
    }
    if (position.isZero(0.0)) position = pose.col(3);
    std::optional<Eigen::Vector3d> viewpoint;
    if (!position.isZero(0.0)) viewpoint = position;
    const auto label = static_cast<std::uint32_t>(text.sections.size());
    if (points > 0) text.sections.push_back({first, points, label, pose, viewpoint});
    line = first + points;
  }
  if (text.sections.size() > 1) text.label_field = "scan";
}

}  // namespace tank_datum

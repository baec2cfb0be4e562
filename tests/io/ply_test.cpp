#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/read_scans.h"

/// PLY files made byte by byte: both byte orders and ascii, what stands beside the vertices, headers that lie.
namespace tank_datum::ply_test {

using read_scans::passOf;
using read_scans::refusalOf;

enum class Order { Ascii, Little, Big };
constexpr Order kOrders[] = {Order::Ascii, Order::Little, Order::Big};

/// A value as its type is stored, or written with a blank.
std::string stored(const std::string& type, double value, Order order) {
  if (order == Order::Ascii) {
    std::ostringstream text;
    text.precision(17);
    text << value << ' ';
    return text.str();
  }
  const bool is_float = type == "float" || type == "double" || type.rfind("float", 0) == 0;
  const bool is_unsigned = type[0] == 'u';
  const int size = type == "double" || type == "float64"                              ? 8
                   : type.find("char") != type.npos || type.find("int8") != type.npos ? 1
                   : type.find("short") != type.npos || type.find("16") != type.npos  ? 2
                                                                                      : 4;
  std::string bytes = pcd_files::bytesOf(value, {"", is_float ? 'F' : is_unsigned ? 'U' : 'I', size});
  if (order == Order::Big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string formatLine(Order order) {
  return std::string("format ") +
         (order == Order::Ascii    ? "ascii"
          : order == Order::Little ? "binary_little_endian"
                                   : "binary_big_endian") +
         " 1.0\n";
}

using Columns = std::vector<std::pair<std::string, std::string>>;  // type, name

std::string element(const std::string& name, std::size_t count, const Columns& columns) {
  std::string text = "element " + name + " " + std::to_string(count) + "\n";
  for (const auto& [type, column] : columns) text += "property " + type + " " + column + "\n";
  return text;
}

std::string rows(const Columns& columns, const std::vector<std::vector<double>>& values, Order order) {
  std::string bytes;
  for (const auto& row : values) {
    for (std::size_t i = 0; i < columns.size(); ++i) bytes += stored(columns[i].first, row[i], order);
    if (order == Order::Ascii) bytes += "\n";
  }
  return bytes;
}

std::string ply(const Columns& columns, const std::vector<std::vector<double>>& values, Order order) {
  return "ply\n" + formatLine(order) + "comment made\nobj_info here\n" + element("vertex", values.size(), columns) +
         "end_header\n" + rows(columns, values, order);
}

const Columns kFloats = {{"float", "x"}, {"float", "y"}, {"float", "z"}};

Points pointsOf(const std::string& bytes) {
  const pcd_files::Folder folder;
  return passOf(Scan::open({folder.file("scan.txt", bytes)})).points;
}

TEST(Ply, EveryTypeInEveryOrder) {
  for (const Order order : kOrders) {
    for (const char* type :
         {"char", "int8", "short", "int16", "int", "int32", "float", "float32", "double", "float64"}) {
      const Columns columns = {{type, "x"}, {"uchar", "red"}, {type, "y"}, {"ushort", "t"}, {"uint", "u"}, {type, "z"}};
      const Points points = pointsOf(ply(columns, {{1, 9, -2, 65535, 7, 100}, {-128, 9, 5, 8, 4e9, 6}}, order));
      EXPECT_EQ(points, (Points{{1, -2, 100}, {-128, 5, 6}})) << type;
    }
    for (const char* type : {"uchar", "uint8", "ushort", "uint16", "uint", "uint32"}) {
      const Columns columns = {{type, "z"}, {type, "y"}, {type, "x"}};
      EXPECT_EQ(pointsOf(ply(columns, {{1, 2, 250}, {4, 0, 6}}, order)), (Points{{250, 2, 1}, {6, 0, 4}})) << type;
    }
  }
}

TEST(Ply, NotFinitePointsStepsAndUnits) {
  const pcd_files::Folder folder;
  for (const Order order : kOrders) {
    const std::string bytes = ply(kFloats, {{8e6, 1, 2}, {NAN, 1, 2}, {3, HUGE_VAL, 2}, {8e6, 5, 6}}, order);
    const Scan scan = Scan::open({folder.file("a.ply", bytes)}, 0.5);
    const auto pass = passOf(scan);
    read_scans::expectNear(pass.points, {{4e6, 0.5, 1}, {4e6, 2.5, 3}}, 1e-9);
    EXPECT_EQ(pass.counts.points, 4U);
    EXPECT_EQ(pass.counts.invalid, 2U);
    EXPECT_EQ(scan.coordinateStep(), order == Order::Ascii ? 0.0 : 0.25);  // of 4-byte floats near 8e6, halved
  }
}

TEST(Ply, ManyRowsInAnyThread) {
  std::vector<std::vector<double>> values;
  for (int i = 0; i < 60'000; ++i) values.push_back({1.0 * i, i % 100 == 7 ? NAN : 2.0, 3.0});
  const pcd_files::Folder folder;
  for (const Order order : kOrders) {
    const Scan scan = Scan::open({folder.file("a.ply", ply(kFloats, values, order))});
    const auto one = passOf(scan, 1), two = passOf(scan, 2), some = passOf(scan, 2, 7);
    EXPECT_EQ(one.points, two.points);
    EXPECT_EQ(one.counts.invalid, 600U);
    EXPECT_EQ(one.points.size(), 59'400U);
    EXPECT_EQ(some.counts.points, 60'000U);
    EXPECT_EQ(some.counts.invalid, 600U);
    EXPECT_NEAR(static_cast<double>(some.points.size()), 59'400.0 / 7.0, 5.0);
  }
}

TEST(Ply, OtherElementsArePassedOver) {
  const Columns two = {{"uchar", "a"}, {"double", "b"}};
  for (const Order order : kOrders) {
    const auto list = [order](const std::vector<double>& items) {
      std::string bytes = stored("uchar", static_cast<double>(items.size()), order);
      for (const double item : items) bytes += stored("int", item, order);
      return bytes + stored("float", 0.5, order) + (order == Order::Ascii ? "\n" : "");
    };
    const std::string lists = "element face 3\nproperty list uchar int at\nproperty float area\n";
    const std::string faces = list({1, 2, 3}) + list({}) + list({7});
    const std::string vertices = rows(kFloats, {{1, 2, 3}, {4, 5, 6}}, order);
    const std::string begin = "ply\n" + formatLine(order), points = element("vertex", 2, kFloats);
    const std::string camera = element("camera", 2, two), cameras = rows(two, {{1, 2}, {3, 4}}, order);
    const Points expected = {{1, 2, 3}, {4, 5, 6}};
    EXPECT_EQ(pointsOf(begin + points + lists + "end_header\n" + vertices + faces), expected);
    EXPECT_EQ(pointsOf(begin + camera + points + "end_header\n" + cameras + vertices), expected);
    EXPECT_EQ(pointsOf(begin + lists + camera + points + "end_header\n" + faces + cameras + vertices), expected);
    EXPECT_EQ(pointsOf(begin + "element nothing 5\n" + points + "end_header\n" + vertices), expected);
  }
}

TEST(Ply, ListsLongerThanWhatIsReadAtOnce) {
  std::string list = stored("uint", 400'000, Order::Little);
  for (int i = 0; i < 400'000; ++i) list += stored("int", i, Order::Little);
  const std::string header = "ply\n" + formatLine(Order::Little) + "element strip 3\nproperty list uint int at\n" +
                             element("vertex", 1, kFloats);
  const std::string bytes = header + "end_header\n" + list + list + list + rows(kFloats, {{1, 2, 3}}, Order::Little);
  EXPECT_EQ(pointsOf(bytes), (Points{{1, 2, 3}}));
}

TEST(Ply, LineEndsAndDataThatBeginsWithOne) {
  std::string text = ply(kFloats, {{1, 2, 3}}, Order::Ascii);
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(pointsOf(windows), (Points{{1, 2, 3}}));
  const Columns bytes = {{"uchar", "x"}, {"uchar", "y"}, {"uchar", "z"}};
  std::string binary = ply(bytes, {{10, 13, 3}}, Order::Little);
  EXPECT_EQ(pointsOf(binary), (Points{{10, 13, 3}}));
  binary.replace(binary.find("end_header\n"), 11, "end_header\r\n");
  EXPECT_EQ(pointsOf(binary), (Points{{10, 13, 3}}));
}

TEST(Ply, APropertyOfSetups) {
  const pcd_files::Folder folder;
  const Columns columns = {{"float", "X"}, {"float", "Y"}, {"float", "Z"}, {"ushort", "scan_id"}};
  for (const Order order : kOrders) {
    const Scan scan = Scan::open({folder.file("a", ply(columns, {{1, 2, 3, 7}, {4, 5, 6, 300}, {7, 8, 9, 7}}, order))});
    const auto pass = passOf(scan);
    ASSERT_EQ(pass.setups.size(), 2U);
    EXPECT_EQ(pass.setups.at(7), (Points{{1, 2, 3}, {7, 8, 9}}));
    EXPECT_EQ(pass.setups.at(300), (Points{{4, 5, 6}}));
    EXPECT_EQ(scan.setupName({0, 300}), "300");
  }
}

void expectRefusal(const std::string& bytes, const std::string& part) {
  const std::string message = refusalOf(bytes);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(Ply, HeadersThatAreNone) {
  const std::string good = ply(kFloats, {{1, 2, 3}, {4, 5, 6}}, Order::Ascii);
  const auto with = [&good](const std::string& old, const std::string& other) {
    std::string bytes = good;
    return bytes.replace(bytes.find(old), old.size(), other);
  };
  expectRefusal(with("end_header\n", ""), "header line 9 of ");
  expectRefusal("ply\nformat ascii 1.0\n", "no line end_header in 21 bytes");
  expectRefusal(with("ascii", "binary"), "expected once format ascii, binary_little_endian or binary_big_endian 1.0");
  expectRefusal(with("1.0", "2.0"), "header line 2 of ");
  expectRefusal(with("format ascii 1.0\n", ""), "a line \"format\" before it");
  expectRefusal(with("comment", "format ascii 1.0\ncomment"), "expected once format");
  expectRefusal(with("vertex 2", "vertex -2"), "expected element NAME and a whole number >= 0");
  expectRefusal(with("vertex 2", "vertex"), "expected element NAME and a whole number >= 0");
  expectRefusal(with("float y", "real y"), "\"property real y\", expected char, uchar");
  expectRefusal(with("float y", "list uchar y"), "expected property TYPE NAME");
  expectRefusal(with("float y", "list float int y"), "a list whose length is a whole number");
  expectRefusal(with("float y", "list uchar int y"), "properties of vertex of ");
  expectRefusal(with("element vertex 2\n", ""), "an element before it");
  expectRefusal(with("vertex 2", "points 2"), "no vertex, expected one element vertex");
  expectRefusal(with("end_header", "element vertex 0\nend_header"), "several named vertex");
  expectRefusal(with("float y", "float x"), "x twice, expected it once");
  expectRefusal(with("float y", "float w"), "no y, expected x, y and z");
}

TEST(Ply, CountsThatLie) {
  for (const Order order : kOrders) {
    const std::string good = ply(kFloats, {{1, 2, 3}, {4, 5, 6}}, order);
    for (const char* count : {"3", "1099511627776", "18446744073709551615"}) {
      std::string bytes = good;
      bytes.replace(bytes.find("vertex 2"), 8, std::string("vertex ") + count);
      expectRefusal(bytes, std::string(count) + " in the header, expected at most 2, all that the file holds");
    }
    std::string bytes = good;
    bytes.insert(bytes.find("element"), "element camera 99999999999\nproperty double a\n");
    expectRefusal(bytes, "99999999999 in the header, expected at most ");
    if (order == Order::Ascii) continue;
    bytes = good;
    bytes.insert(bytes.find("element"), "element face 99999999999\nproperty list uchar int a\n");
    expectRefusal(bytes, "element face of ");
    bytes = good;
    bytes.insert(bytes.find("element"), "element face 1\nproperty list int int a\n");
    bytes.insert(bytes.find("end_header\n") + 11, "\xff\xff\xff\xff");  // -1
    expectRefusal(bytes, "1 in the header, expected at most 0");
  }
}

TEST(Ply, CutAnywhereOrWithAnyByteChanged) {
  for (const Order order : {Order::Ascii, Order::Big}) {
    const std::string good = ply({{"uchar", "x"}, {"short", "y"}, {"float", "z"}}, {{1, 2, 3}, {4, 5, 6}}, order);
    const std::size_t whole = order == Order::Ascii ? good.size() - 2 : good.size();
    for (std::size_t length = 1; length < whole; ++length) EXPECT_FALSE(refusalOf(good.substr(0, length)).empty());
    for (std::size_t at = 0; at < good.size(); ++at) {
      for (const char byte : {'\n', '9', '\xff'}) {
        std::string bytes = good;
        bytes[at] = byte;
        read_scans::readHostile(bytes);
      }
    }
  }
}

}  // namespace tank_datum::ply_test

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "support/read_scans.h"

/// Real files of other people's programs: counts and bounds as independent readers (laspy, plyfile, a small one for
/// text) found them, which stand in NOTE.txt beside the files.
namespace tank_datum::real_formats_test {

struct Known {
  std::uint64_t points = 0, finite = 0;
  Eigen::Vector3d low, high;
};

std::string formatsFolder() { return pcd_files::dataFolder() + "/formats/"; }

/// "las/a.las 100 7 pts, finite 6, min [1.0, 2.0, 3.0] max [4.0, 5.0, 6.0]"
std::map<std::string, Known> readNote() {
  std::map<std::string, Known> all;
  std::ifstream note(formatsFolder() + "NOTE.txt");
  for (std::string line; std::getline(note, line);) {
    if (line.find(" pts, finite ") == line.npos) continue;
    for (char& c : line) {
      if (c == ',' || c == '[' || c == ']') c = ' ';
    }
    std::istringstream words(line);
    std::string name, skipped;
    Known known;
    words >> name >> skipped >> known.points >> skipped >> skipped >> known.finite >> skipped;
    words >> known.low.x() >> known.low.y() >> known.low.z() >> skipped;
    words >> known.high.x() >> known.high.y() >> known.high.z();
    EXPECT_TRUE(words) << line;
    all[name] = known;
  }
  return all;
}

void expectAsKnown(const std::string& name, const Known& known) {
  SCOPED_TRACE(name);
  const Scan scan = Scan::open({formatsFolder() + name});
  const auto pass = read_scans::passOf(scan);
  EXPECT_EQ(scan.size(), known.points);
  EXPECT_EQ(pass.counts.points, known.points);
  ASSERT_EQ(pass.points.size(), known.finite);
  Eigen::Vector3d low = pass.points[0], high = low;
  for (const auto& p : pass.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  constexpr double kPrinted = 0.00051;  // NOTE.txt has three digits
  EXPECT_LE((low - known.low).cwiseAbs().maxCoeff(), kPrinted) << low.transpose();
  EXPECT_LE((high - known.high).cwiseAbs().maxCoeff(), kPrinted) << high.transpose();
}

TEST(RealFormats, CountsAndBoundsAreThoseOfIndependentReaders) {
  if (pcd_files::dataFolder().empty()) GTEST_SKIP() << "TANK_DATUM_DATA is not set";
  std::map<std::string, int> tried;
  for (const auto& [name, known] : readNote()) {
    const std::string kind = name.substr(0, name.find('/'));
    if (kind == "e57" || kind == "laz" || kind == "pcd") continue;
    expectAsKnown(name, known);
    ++tried[kind];
  }
  EXPECT_EQ(tried["las"], 17);
  EXPECT_EQ(tried["ply"], 13);
  EXPECT_EQ(tried["pts"], 4);
  EXPECT_EQ(tried["txt"], 13);
}

TEST(RealFormats, TheOnesThatTheIndependentReadersCouldNotRead) {
  if (pcd_files::dataFolder().empty()) GTEST_SKIP() << "TANK_DATUM_DATA is not set";
  expectAsKnown("ply/assimp_cube_binary_header_with_RN_newline.ply", {8, 8, {0, 0, 0}, {1, 1, 1}});
  expectAsKnown("ply/pdal_simple_text.ply", {3, 3, {-1, 0, 0}, {1, 1, 0}});
  const Known b9 = readNote().at("ply/cgal_b9_training.ply");
  expectAsKnown("ply/derived_b9_big_endian.ply", b9);
  EXPECT_EQ(read_scans::passOf(Scan::open({formatsFolder() + "ply/derived_b9_big_endian.ply"})).points,
            read_scans::passOf(Scan::open({formatsFolder() + "ply/cgal_b9_training.ply"})).points);
}

TEST(RealFormats, PtxScansWithTheirPoses) {
  if (pcd_files::dataFolder().empty()) GTEST_SKIP() << "TANK_DATUM_DATA is not set";
  const auto counts = [](const std::string& name) {
    return read_scans::passOf(Scan::open({formatsFolder() + "ptx/" + name})).counts;
  };
  EXPECT_EQ(counts("pdal_1.2-with-color.ptx").kept(), 1065U);
  EXPECT_EQ(counts("pdal_no-color.ptx").points, 15U);
  EXPECT_EQ(counts("pdal_complex-transform.ptx").points, 12U);
  const Scan turned = Scan::open({formatsFolder() + "ptx/pdal_complex-transform.ptx"});
  const Eigen::Vector3d stood(-3.028748, -3.819741, -1.384333);
  EXPECT_LE((*turned.setupOrigin({0, 0}) + turned.origin() - stood).norm(), 1e-9);
}

TEST(RealFormats, RefusedOnes) {
  if (pcd_files::dataFolder().empty()) GTEST_SKIP() << "TANK_DATUM_DATA is not set";
  const std::map<std::string, std::string> refused = {
      {"formats/ply/pdal_sized_dims.ply", "no z, expected x, y and z"},
      {"formats/ply/pdal_unsized_dims.ply", "no z, expected x, y and z"},
      {"formats/ptx/pdal_multiple-and-transform.ptx", "a matrix that is no rotation"},  // z is doubled
      {"formats/laz/laspy_simple.laz", "LAZ, expected "},
      {"formats/laz/laspy_simple.copc.laz", "LAZ, expected "},
      {"formats/e57/pdal_A4.e57", "E57, expected "},
      {"bad/derived/empty_0bytes.las", "an empty file"},
      {"bad/derived/las_bad_magic.las", "format of "},
      {"bad/derived/las_count_too_big.las", "in the header, expected at most 1065"},
      {"bad/derived/las_header_scale_zero.las", "LAS scale of x"},
      {"bad/derived/las_truncated_half.las", "1065 in the header, expected at most 529"},
      {"bad/derived/las_truncated_in_header.las", "LAS header of "},
      {"bad/derived/laz_named_las.las", "LAZ, expected "},
      {"bad/derived/ply_binary_truncated_half.ply", "22300 in the header, expected at most 11146"},
      {"bad/derived/ply_no_end_header.ply", "no line end_header"},
      {"bad/derived/pts_count_too_big.pts", "999999 points, expected at most 10"},
      {"bad/derived/ptx_dims_wrong.ptx", "line 1 of "},
      {"bad/derived/ptx_truncated_rows.ptx", "15 columns of 71 points, expected at most 535 points"},
      {"bad/derived/xyz_binary_garbage.xyz", "format of "},
      {"bad/derived/xyz_decimal_comma.txt", "decimal points, not commas"},
      {"bad/derived/xyz_nan_inf_rows.xyz", "\"1e400\", expected a number"},
      {"bad/derived/xyz_only_two_columns.xyz", "line 1 of "},
      {"bad/derived/xyz_utf16_bom.txt", "UTF-16 text"},
      {"bad/las/pdal_garbage_nVariableLength.las", "719 in the header, expected at most 718"},
      {"bad/laz/pdal_ept_invalid-tile_2-2-2-2.laz", "LAZ, expected "},
      {"bad/ply/pdal_no_vertex.ply", "no vertex"},
      {"bad/ply/assimp_issue623.ply", "a list, expected single numbers"},
      {"bad/ply/assimp_crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply", " of "},
      {"bad/txt/pdal_badheader.txt", "line 1 of "},
      {"bad/txt/pdal_text_prose_not_points.txt", "line 1 of "},
      {"bad/txt/pdal_japanese_not_points.txt", "line 1 of "},
  };
  for (const auto& [name, part] : refused) {
    const std::string path = pcd_files::dataFolder() + "/" + name;
    const std::string message = pcd_files::errorOf([&] { read_scans::passOf(Scan::open({path})); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(RealFormats, OddOnesThatAreRead) {
  if (pcd_files::dataFolder().empty()) GTEST_SKIP() << "TANK_DATUM_DATA is not set";
  const std::map<std::string, std::uint64_t> points = {
      {"las/laspy_unregistered_extra_bytes.las", 4},
      {"las/pdal_1.2-empty-geotiff-vlrs.las", 43},
      {"las/pdal_bad_vlr_count.las", 10},
      {"las/pdal_gps-time-nan.las", 1},
      {"las/pdal_lots_of_vlr.las", 1},
      {"las/pdal_no-points.las", 0},
      {"las/pdal_prec3.las", 110},

      {"las/pdal_spec_3.las", 10},
      {"las/pdal_wontcompress3.las", 105},
      {"derived/xyz_all_identical_points.xyz", 5000},
      {"derived/xyz_one_point.xyz", 1},
      {"derived/xyz_utf8_bom_header.txt", 200},
      {"txt/pdal_duplicates-unsorted.txt", 7},
      {"txt/pdal_missingheader.txt", 5},
      {"pcd/pdal_missingheader.pcd", 10},
  };
  for (const auto& [name, finite] : points) {
    EXPECT_EQ(read_scans::passOf(Scan::open({pcd_files::dataFolder() + "/bad/" + name})).points.size(), finite) << name;
  }
}

}  // namespace tank_datum::real_formats_test

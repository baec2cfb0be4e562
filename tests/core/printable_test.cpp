#include "core/printable.h"

#include <gtest/gtest.h>

namespace tank_datum::printable_test {

TEST(Printable, HasNoControlCharacters) {
  EXPECT_EQ(printable("a\x1b[31mb\nc\r\td\x7f" + std::string(1, '\0')), "a?[31mb?c??d??");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "??31m");  // U+009B, the one-character form of ESC [
}

TEST(Printable, LeavesOtherCharactersAlone) {
  EXPECT_EQ(printable("Behälter 7 \xc2\xb0 \xe2\x9c\x93 ~"), "Behälter 7 \xc2\xb0 \xe2\x9c\x93 ~");
  EXPECT_EQ(printable("\xe3\x82\x9b"), "\xe3\x82\x9b");  // the same byte inside another character
}

TEST(PrintableLines, KeepsTheLines) {
  EXPECT_EQ(printableLines("a\x1b\n\nb\r\nc"), "a?\n\nb?\nc");
  EXPECT_EQ(printableLines(""), "");
}

}  // namespace tank_datum::printable_test

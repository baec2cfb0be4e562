#include "io/sha256.h"

#include <gtest/gtest.h>
#include <openssl/crypto.h>

#include <cstdlib>

#include "support/pcd_files.h"

namespace tank_datum::sha256_test {

TEST(Sha256, KnownAnswers) {  // FIPS 180-4 examples
  const pcd_files::Folder folder;
  EXPECT_EQ(sha256OfFile(folder.file("empty", "")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256OfFile(folder.file("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256OfFile(folder.file("million", std::string(1000000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, SeveralBlocks) {
  const pcd_files::Folder folder;
  EXPECT_EQ(sha256OfFile(folder.file("zeros", std::string((std::size_t{1} << 21) + 5, '\0'))),
            "64fd2e4967cabd6182fc63e4e49ba8864445ea69fbd1156e52f7572636050d80");
}

TEST(Sha256, NoLongerWantedEndsIt) {
  const pcd_files::Folder folder;
  const std::string path = folder.file("zeros", std::string(std::size_t{5} << 20, '\0'));
  int asked = 0;
  EXPECT_EQ(sha256OfFile(path, [&asked] { return ++asked < 3; }), "");
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(sha256OfFile(path, [] { return true; }), sha256OfFile(path));
}

TEST(Sha256, FileThatCannotBeRead) {
  const pcd_files::Folder folder;
  EXPECT_NE(pcd_files::errorOf([&] { sha256OfFile(folder.path("none")); }).find("No such file"), std::string::npos);
  EXPECT_NE(pcd_files::errorOf([&] { sha256OfFile(folder.path("")); }).find("a folder"), std::string::npos);
}

/// Where memory ends libcrypto would end the process by SIGSEGV.
TEST(Sha256, AsksLibcryptoForNoMemory) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // a process that has not used libcrypto yet
  const pcd_files::Folder folder;
  const std::string path = folder.file("abc", "abc");
  const auto hash_without_memory = [&path] {
    const bool none = CRYPTO_set_mem_functions([](std::size_t, const char*, int) -> void* { return nullptr; },
                                               [](void*, std::size_t, const char*, int) -> void* { return nullptr; },
                                               [](void*, const char*, int) {}) == 1;
    std::exit(none && sha256OfFile(path).substr(0, 8) == "ba7816bf" ? 0 : 1);
  };
  EXPECT_EXIT(hash_without_memory(), testing::ExitedWithCode(0), "");
}

}  // namespace tank_datum::sha256_test

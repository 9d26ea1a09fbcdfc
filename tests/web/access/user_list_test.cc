// Users in their file, and their passwords.
#include "web/access/user_list.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <filesystem>
#include <fstream>

#include "base/file_descriptor.h"
#include "tests/support/temporary_directory.h"
#include "web/access/password.h"
#include "web/access/secret_text.h"

namespace stanok::web {
namespace {

using protocol::Role;

void write_private(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
  std::filesystem::permissions(file, std::filesystem::perms(0600));
}

TEST(UserList, IsTheSameBehindItsFile) {
  const testing::TemporaryDirectory folder;
  const auto file = folder.path() / "users";
  EXPECT_TRUE(UserList::from_file(file).users().empty()) << "there is no file";
  UserList list;
  list.set({"anna", Role::observer, "hash"});
  list.set({"Борис", Role::programmer, "$argon2id$v=19$m=65536,t=2,p=1$x$y"});
  list.set({"anna", Role::integrator, "other"});
  list.write(file);
  EXPECT_EQ(UserList::from_file(file).users(), list.users());
  EXPECT_EQ(list.find("anna")->role, Role::integrator);
  EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms(0600));
  EXPECT_TRUE(list.remove("anna"));
  EXPECT_FALSE(list.remove("anna"));
}

// A power failure in the middle of a write left it there; no user could be added any more.
TEST(UserList, IsWrittenThoughAnEarlierWriteWasCut) {
  const testing::TemporaryDirectory folder;
  const auto file = folder.path() / "users";
  std::ofstream(file.string() + ".new") << "anna:oper";
  UserList list;
  list.set({"anna", Role::observer, "hash"});
  list.write(file);
  EXPECT_EQ(UserList::from_file(file).users(), list.users());
}

TEST(UserList, ADamagedFileIsToldWithItsLine) {
  const testing::TemporaryDirectory folder;
  const auto file = folder.path() / "users";
  for (const char* line :
       {"anna", "anna:operator", "anna:boss:hash", ":operator:hash",
        "anna:operator:a\nanna:operator:b", "\x01:operator:hash", "\xff:operator:hash"}) {
    write_private(file, line);
    EXPECT_THROW(static_cast<void>(UserList::from_file(file)), std::runtime_error) << line;
  }
  write_private(file, "# comment\n\nanna:operator:hash\n");
  EXPECT_EQ(UserList::from_file(file).users().size(), 1U);
}

TEST(UserList, AFileThatOthersMayChangeIsNotBelieved) {
  const testing::TemporaryDirectory folder;
  const auto file = folder.path() / "users";
  for (const int mode : {0604, 0602, 0620, 0666}) {
    write_private(file, "anna:operator:hash\n");
    std::filesystem::permissions(file, std::filesystem::perms(mode));
    EXPECT_THROW(static_cast<void>(UserList::from_file(file)), std::runtime_error) << mode;
  }
}

TEST(UserList, AWriteThatFailsLeavesTheFileAsItWas) {
  const testing::TemporaryDirectory folder;
  const auto file = folder.path() / "users";
  write_private(file, "anna:operator:hash\n");
  write_private(folder.path() / "users.new", "another one writes");
  const FileDescriptor other(::open((folder.path() / "users.new").c_str(), O_WRONLY | O_CLOEXEC));
  ASSERT_EQ(::flock(other.number(), LOCK_EX), 0);
  EXPECT_THROW(UserList().write(file), std::runtime_error);
  EXPECT_EQ(UserList::from_file(file).users().size(), 1U);
}

TEST(Passwords, AreKnownByTheirHash) {
  static_cast<void>(new_secret());  // libsodium is ready
  const std::string hash = hash_of_password("correct horse");
  EXPECT_TRUE(hash.starts_with("$argon2id$v=19$m=65536,")) << hash;  // 64 MiB
  EXPECT_TRUE(is_password_of(hash, "correct horse"));
  EXPECT_FALSE(is_password_of(hash, "correct horsf"));
  EXPECT_FALSE(is_password_of("nonsense", "correct horse"));
  EXPECT_NE(hash_of_password("correct horse"), hash) << "salted";
}

}  // namespace
}  // namespace stanok::web

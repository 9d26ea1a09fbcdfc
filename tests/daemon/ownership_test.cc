// What belongs to one daemon: its state directory and its socket.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <fstream>

#include "daemon/host/state_directory.h"
#include "daemon/server/listening_socket.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

// A socket that nobody listens on, as a killed daemon leaves it.
void leave_stale_socket(const fs::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.string().copy(address.sun_path, sizeof address.sun_path - 1);
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_GE(descriptor, 0);
  ASSERT_EQ(::bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  ::close(descriptor);
}

TEST(StateDirectory, IsMadeWhenItIsAbsent) {
  const stanok::testing::TemporaryDirectory here;
  const StateDirectory state(here.path() / "a" / "b");
  EXPECT_TRUE(fs::is_directory(here.path() / "a" / "b"));
}

TEST(StateDirectory, BelongsToOneDaemonAndNamesItsPid) {
  const stanok::testing::TemporaryDirectory here;
  const StateDirectory first(here.path());
  try {
    const StateDirectory second(here.path());
    FAIL() << "two daemons on one state directory";
  } catch (const StateDirectoryError& error) {
    EXPECT_NE(std::string(error.what()).find("pid " + std::to_string(getpid())), std::string::npos);
  }
}

// Who can open a file, even to read, can lock it, and keep the daemon from starting.
TEST(StateDirectory, CanBeLockedByNobodyElse) {
  const stanok::testing::TemporaryDirectory here;
  const fs::path lock = here.path() / "stanokd.lock";
  std::ofstream(lock) << "1\n";
  fs::permissions(lock, fs::perms(0666));
  const StateDirectory state(here.path());
  EXPECT_EQ(fs::status(lock).permissions(), fs::perms(0600));
}

TEST(StateDirectory, IsFreeAgainWhenItsDaemonHasGone) {
  const stanok::testing::TemporaryDirectory here;
  {
    const StateDirectory first(here.path());
  }
  EXPECT_NO_THROW(const StateDirectory second(here.path()));
}

TEST(StateDirectory, CannotBeAFile) {
  const stanok::testing::TemporaryDirectory here;
  std::ofstream(here.path() / "file") << "x";
  EXPECT_THROW(const StateDirectory state(here.path() / "file" / "state"), StateDirectoryError);
  EXPECT_THROW(const StateDirectory state(here.path() / "file"), StateDirectoryError);
}

TEST(ListeningSocket, IsOpenToOwnerAndGroupOnly) {
  const stanok::testing::TemporaryDirectory here;
  const ListeningSocket socket(here.path() / "s.sock");
  struct stat status{};
  ASSERT_EQ(::stat(socket.path().c_str(), &status), 0);
  EXPECT_TRUE(S_ISSOCK(status.st_mode));
  EXPECT_EQ(status.st_mode & 0777U, 0660U);
}

TEST(ListeningSocket, GoesWithItsDaemon) {
  const stanok::testing::TemporaryDirectory here;
  {
    const ListeningSocket socket(here.path() / "s.sock");
  }
  EXPECT_FALSE(fs::exists(here.path() / "s.sock"));
}

TEST(ListeningSocket, TakesTheWayOfADeadOne) {
  const stanok::testing::TemporaryDirectory here;
  leave_stale_socket(here.path() / "s.sock");
  EXPECT_NO_THROW(const ListeningSocket socket(here.path() / "s.sock"));
}

TEST(ListeningSocket, LeavesALivingOneAlone) {
  const stanok::testing::TemporaryDirectory here;
  const ListeningSocket first(here.path() / "s.sock");
  EXPECT_THROW(const ListeningSocket second(here.path() / "s.sock"), SocketError);
  EXPECT_TRUE(fs::exists(first.path()));
}

TEST(ListeningSocket, DoesNotRemoveWhatIsNoSocket) {
  const stanok::testing::TemporaryDirectory here;
  std::ofstream(here.path() / "s.sock") << "precious";
  EXPECT_THROW(const ListeningSocket socket(here.path() / "s.sock"), SocketError);
  EXPECT_TRUE(fs::exists(here.path() / "s.sock"));
}

TEST(ListeningSocket, LeavesTheSocketOfItsSuccessor) {
  const stanok::testing::TemporaryDirectory here;
  const fs::path path = here.path() / "s.sock";
  {
    const ListeningSocket first(path);
    fs::rename(path, here.path() / "old.sock");
    leave_stale_socket(path);
  }
  EXPECT_TRUE(fs::exists(path));
}

TEST(ListeningSocket, SaysThatItsNameIsTooLong) {
  const stanok::testing::TemporaryDirectory here;
  EXPECT_THROW(const ListeningSocket socket(here.path() / std::string(120, 's')), SocketError);
}

}  // namespace
}  // namespace stanok::daemon

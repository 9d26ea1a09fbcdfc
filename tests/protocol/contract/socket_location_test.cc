// Where sockets stand, by the variables of the XDG base directory specification.
#include "protocol/contract/socket_location.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace stanok::protocol {
namespace {

class SocketLocation : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"XDG_RUNTIME_DIR", "XDG_STATE_HOME", "STATE_DIRECTORY"})
      unsetenv(name);
    setenv("HOME", "/home/somebody", 1);
  }
};

TEST_F(SocketLocation, IsTheRuntimeDirectoryWhereThereIsOne) {
  setenv("XDG_RUNTIME_DIR", "/run/user/1000", 1);
  EXPECT_EQ(default_socket("mill3", "/var/lib/x"), "/run/user/1000/stanok/mill3.sock");
}

TEST_F(SocketLocation, IsTheStateDirectoryElse) {
  EXPECT_EQ(default_socket("mill3", "/var/lib/x"), "/var/lib/x/mill3.sock");
  EXPECT_EQ(default_state_directory("mill3"), "/home/somebody/.local/state/stanok/mill3");
  setenv("XDG_STATE_HOME", "/state", 1);
  EXPECT_EQ(default_state_directory("mill3"), "/state/stanok/mill3");
  setenv("STATE_DIRECTORY", "/var/lib/stanok", 1);
  EXPECT_EQ(default_state_directory("mill3"), "/var/lib/stanok");
}

}  // namespace
}  // namespace stanok::protocol

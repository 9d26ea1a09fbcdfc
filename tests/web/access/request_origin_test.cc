// Names of this server, and pages of others.
#include "web/access/request_origin.h"

#include <gtest/gtest.h>

namespace stanok::web {
namespace {

TEST(OwnNames, AreLoopbackAndWhatWasSaid) {
  const OwnNames names(Scheme::http, {"Mill.Example"});
  for (const char* own : {"localhost", "localhost:8080", "LOCALHOST:1", "127.0.0.1:65535",
                          "[::1]:8080", "[::1]", "mill.example:80", "MILL.example"}) {
    EXPECT_TRUE(names.is_own_host(own)) << own;
  }
  for (const char* foreign :
       {"", ":", ":8080", "evil.example", "localhost.evil.example", "127.0.0.1.evil.example",
        "localhost:", "localhost:80x", "localhost:808080", "a@localhost", "localhost@evil.example",
        "[::1", "::1", "[::1]:80:80", "192.0.2.1", "[2001:db8::1]:80"}) {
    EXPECT_FALSE(names.is_own_host(foreign)) << foreign;
  }
}

TEST(OwnNames, AnAddressCannotBeMadeToPointHere) {
  OwnNames names(Scheme::https, {});
  names.allow_addresses();
  EXPECT_TRUE(names.is_own_host("192.0.2.1:8443"));
  EXPECT_TRUE(names.is_own_host("[2001:db8::1]:8443"));
  EXPECT_FALSE(names.is_own_host("192.0.2.1.evil.example"));
  EXPECT_FALSE(names.is_own_host("[evil.example]"));
}

TEST(OwnNames, AnOriginIsThisServerOnly) {
  const OwnNames names(Scheme::https, {});
  EXPECT_TRUE(names.is_own_origin("https://localhost:8443", "localhost:8443"));
  EXPECT_TRUE(names.is_own_origin("https://LOCALHOST:8443", "localhost:8443"));
  for (const char* foreign :
       {"http://localhost:8443", "https://localhost", "https://localhost:80", "null", "",
        "https://evil.example", "https://localhost:8443/", "https://localhost:8443.evil.example"}) {
    EXPECT_FALSE(names.is_own_origin(foreign, "localhost:8443")) << foreign;
  }
}

}  // namespace
}  // namespace stanok::web

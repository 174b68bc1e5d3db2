// SPDX-License-Identifier: BSD-3-Clause
#include "live/http_server.hpp"

#include <gtest/gtest.h>

namespace crumple::live::http_server_test {
namespace {

TEST(LoopbackHost, KnowsItsNames) {
  for (const char* host : {"127.0.0.1", "127.0.0.1:8000", "localhost", "localhost:1", "[::1]", "[::1]:65535"})
    EXPECT_TRUE(is_loopback_host(host)) << host;
}

TEST(LoopbackHost, RefusesOthers) {
  for (const char* host : {"", "crumple.example", "127.0.0.1.crumple.example", "127.0.0.1:80.example",
                           "localhost:", "localhost.example:80", "127.0.0.11", "192.168.0.1", "::1",
                           "localhost:123456", "crumple.example:80@localhost"})
    EXPECT_FALSE(is_loopback_host(host)) << host;
}

}  // namespace
}  // namespace crumple::live::http_server_test

// SPDX-License-Identifier: BSD-3-Clause
#include "live/http_request.hpp"

#include <gtest/gtest.h>

#include <string>

namespace crumple::live::http_request_test {
namespace {

TEST(HttpRequest, HasMethodPathAndHost) {
  const std::string text = "GET /a/status?x=1 HTTP/1.1\r\nAccept: */*\r\nhOsT:\t localhost:80 \r\n\r\nbody";
  const ParsedRequest parsed = parse_request(text);
  ASSERT_EQ(parsed.state, RequestState::Complete);
  EXPECT_EQ(parsed.request.method, "GET");
  EXPECT_EQ(parsed.request.path, "/a/status");
  EXPECT_EQ(parsed.request.host, "localhost:80");
  EXPECT_EQ(parsed.request.hosts, 1);
}

TEST(HttpRequest, IsIncompleteUntilTheEmptyLine) {
  const std::string text = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n";
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_EQ(parse_request(text.substr(0, length)).state, RequestState::Incomplete) << length;
  EXPECT_EQ(parse_request(text).state, RequestState::Complete);
  EXPECT_EQ(parse_request("GET / HTTP/1.0\nHost: localhost\n\n").state, RequestState::Complete);
}

TEST(HttpRequest, IsBounded) {
  const std::string start = "GET / HTTP/1.1\r\nX: ";
  EXPECT_EQ(parse_request(start + std::string(longest_head - start.size() - 1, 'x')).state,
            RequestState::Incomplete);
  EXPECT_EQ(parse_request(start + std::string(longest_head - start.size(), 'x')).state,
            RequestState::TooLong);
  EXPECT_EQ(parse_request(start + std::string(longest_head, 'x') + "\r\n\r\n").state, RequestState::TooLong);
}

TEST(HttpRequest, RefusesWhatIsNone) {
  for (const char* text :
       {"\r\n\r\n", "GET\r\n\r\n", "GET /\r\n\r\n", "get / HTTP/1.1\r\n\r\n", "GET / HTTP/2\r\n\r\n",
        "GET x HTTP/1.1\r\n\r\n", "GET http://a/ HTTP/1.1\r\n\r\n", "GET /\x01 HTTP/1.1\r\n\r\n",
        "GET / HTTP/1.1\r\nno colon\r\n\r\n", "GET / HTTP/1.1\r\nHost : a\r\n\r\n",
        "GET / HTTP/1.1\r\nA: b\r\n goes on: c\r\n\r\n"})
    EXPECT_EQ(parse_request(text).state, RequestState::Bad) << text;
}

TEST(HttpRequest, CountsHosts) {
  EXPECT_EQ(parse_request("GET / HTTP/1.1\r\n\r\n").request.hosts, 0);
  EXPECT_EQ(parse_request("GET / HTTP/1.1\r\nHost: a\r\nHOST: b\r\n\r\n").request.hosts, 2);
}

}  // namespace
}  // namespace crumple::live::http_request_test

// SPDX-License-Identifier: BSD-3-Clause
// Stands in for http_server.cpp where cpp-httplib is missing.
#include "base/error.hpp"
#include "live/http_server.hpp"

namespace crumple::live {

struct HttpServer::Listener {};

HttpServer::HttpServer(int /*port*/, Handler /*handler*/) {
  throw Error(
      "--serve needs cpp-httplib, which was missing when crumple was built: install it (on Debian: apt-get "
      "install libcpp-httplib-dev) and build crumple anew.");
}

HttpServer::~HttpServer() = default;

int HttpServer::port() const {
  return 0;
}

}  // namespace crumple::live

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace crumple::live {

/// What a request gets.
struct Answer {
  int status = 200;  ///< of HTTP
  std::string type;  ///< of the content, as "text/html; charset=utf-8"
  std::shared_ptr<const std::string> content;
};

/// An HTTP server for the browsers of this machine, in threads of its own. It listens at 127.0.0.1 alone,
/// answers GET alone, and refuses requests that name another host: with those, a page of the network whose
/// name was made to mean this machine could read along (DNS rebinding). It knows no files. Clients cannot
/// hold it up: requests, connections and times are bounded.
class HttpServer {
 public:
  /// Answers a path such as "/status". Called by several threads at a time; must not throw.
  using Handler = std::function<Answer(const std::string& path)>;

  /// Listens from here on. Port 0 takes any free one. Throws Error if the port is taken.
  HttpServer(int port, Handler handler);
  /// Stops listening, and returns when the last answer is out, after a second in any case and when the
  /// handler has returned.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;

 private:
  struct Listener;
  std::unique_ptr<Listener> listener_;
};

/// Whether the value of a Host header names this machine's loopback, with any port or none.
bool is_loopback_host(std::string_view host);

}  // namespace crumple::live

// SPDX-License-Identifier: BSD-3-Clause
#include "live/http_server.hpp"

#include <fmt/core.h>
#include <httplib.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include "base/error.hpp"

namespace crumple::live {

namespace {

constexpr const char* address = "127.0.0.1";
/// A browser keeps connections open without asking anything; so many may hang at a time.
constexpr std::size_t threads = 6;

/// While it lives, the thread gets no signals, nor do those that it starts: they are for the thread of the
/// run. A write to a connection that was closed then is an error of the write and no SIGPIPE.
class BlockedSignals {
 public:
  BlockedSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &earlier_);
  }
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &earlier_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t earlier_{};
};

/// httplib ignores SIGPIPE for the whole program, which would then go on where nobody reads its output.
class KeptPipeSignal {
 public:
  KeptPipeSignal() { sigaction(SIGPIPE, nullptr, &earlier_); }
  ~KeptPipeSignal() { sigaction(SIGPIPE, &earlier_, nullptr); }
  KeptPipeSignal(const KeptPipeSignal&) = delete;
  KeptPipeSignal& operator=(const KeptPipeSignal&) = delete;

 private:
  struct sigaction earlier_ {};
};

/// A page that is made must not hold up the threads of a step, which wait for one another.
void let_the_run_go_first() {
#ifdef __linux__
  // Elsewhere it would be for the whole program; on Linux it is for this thread and those that it starts.
  constexpr int nice_value = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), nice_value);
#endif
}

std::unique_ptr<httplib::Server> make_server() {
  const KeptPipeSignal kept;
  return std::make_unique<httplib::Server>();
}

void set_answer(httplib::Response& response, const Answer& answer) {
  response.status = answer.status;
  // Handed over in pieces: no copy of a large page is made, and it is not compressed for a way through
  // memory.
  response.set_content_provider(
      answer.content->size(), answer.type,
      [content = answer.content](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        return sink.write(content->data() + offset, length);
      });
}

Answer refusal(int status, const char* reason) {
  return {status, "text/plain; charset=utf-8", std::make_shared<const std::string>(reason)};
}

Answer answer_to(const httplib::Request& request, const HttpServer::Handler& handler) {
  if (request.get_header_value_count("Host") != 1 || !is_loopback_host(request.get_header_value("Host")))
    return refusal(403, "Only for this machine: 127.0.0.1 or localhost.\n");
  if (request.method != "GET") return refusal(405, "Only GET.\n");
  return handler(request.path);
}

}  // namespace

struct HttpServer::Listener {
  std::unique_ptr<httplib::Server> server;
  int port = 0;
  std::atomic<bool> over = false;
  std::thread thread;
};

HttpServer::HttpServer(int port, Handler handler) : listener_(std::make_unique<Listener>()) {
  listener_->server = make_server();
  httplib::Server& server = *listener_->server;
  server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
  server.set_keep_alive_max_count(1);
  server.set_read_timeout(2);
  // Not as httplib has it: with SO_REUSEPORT two programs could share a port, each getting half of the
  // requests.
  server.set_socket_options([](int socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.set_default_headers({{"Cache-Control", "no-store"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Cross-Origin-Resource-Policy", "same-origin"},
                              {"Content-Security-Policy", "frame-ancestors 'self'"}});
  server.set_pre_routing_handler(
      [handler = std::move(handler)](const httplib::Request& request, httplib::Response& response) {
        set_answer(response, answer_to(request, handler));
        return httplib::Server::HandlerResponse::Handled;
      });
  if (port == 0)
    listener_->port = server.bind_to_any_port(address);
  else
    listener_->port = server.bind_to_port(address, port) ? port : -1;
  if (listener_->port <= 0)
    throw Error(
        fmt::format("Port {} cannot be listened at: another program does, or the system reserves it. "
                    "--serve 0 takes any free one.",
                    port));
  const BlockedSignals blocked;
  listener_->thread = std::thread([&server, &over = listener_->over] {
    let_the_run_go_first();
    server.listen_after_bind();
    over = true;
  });
  // What is stopped before it runs would run for ever.
  while (!server.is_running() && !listener_->over) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

HttpServer::~HttpServer() {
  if (!listener_->thread.joinable()) return;
  listener_->server->stop();
  listener_->thread.join();
}

int HttpServer::port() const {
  return listener_->port;
}

}  // namespace crumple::live

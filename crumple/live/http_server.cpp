// SPDX-License-Identifier: BSD-3-Clause
//
// One thread has all connections and never waits for one of them; some more make the answers, which may take
// long. Whatever clients do, there are bounds: on the length of a request, the number of connections, the
// time for a request to come and for an answer to be taken, and the time until all is over.
#include "live/http_server.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <deque>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "live/http_request.hpp"

namespace crumple::live {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// A browser has up to six at a time.
constexpr std::size_t most_connections = 32;
constexpr std::size_t answering_threads = 3;
constexpr milliseconds longest_request{5000};  ///< from the connection to the end of its head
constexpr milliseconds longest_answer{10000};  ///< and one more second for each megabyte
constexpr milliseconds longest_close{1000};    ///< for what the client still sends, and at the end for all
constexpr milliseconds pause{100};             ///< when the system has no more descriptors

/// While it lives, the thread gets no signals, nor do those that it starts: they are for the thread of the
/// run.
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

/// A page that is made must not hold up the threads of a step, which wait for one another.
void let_the_run_go_first() {
#ifdef __linux__
  // Elsewhere it would be for the whole program; on Linux it is for this thread.
  constexpr int nice_value = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), nice_value);
#endif
}

class Socket {
 public:
  explicit Socket(int number = -1) : number_(number) {}
  Socket(Socket&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Socket& operator=(Socket&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

enum class Stage { Reading, Waiting, Writing, Closing, Over };

struct Connection {
  Socket socket;
  std::uint64_t id = 0;
  Stage stage = Stage::Reading;
  Clock::time_point deadline;
  std::string received;
  std::string head;
  std::shared_ptr<const std::string> content;
  std::size_t sent = 0;  ///< of both
};

Answer refusal(int status, const char* reason) {
  return {status, "text/plain; charset=utf-8", std::make_shared<const std::string>(reason)};
}

/// What is answered without the handler; a status of 0 if that is to be asked.
Answer answer_at_once(const ParsedRequest& parsed) {
  if (parsed.state == RequestState::TooLong) return refusal(431, "The request is too long.\n");
  if (parsed.state == RequestState::Bad) return refusal(400, "This is no request of HTTP/1.1.\n");
  if (parsed.request.hosts != 1 || !is_loopback_host(parsed.request.host))
    return refusal(403, "Only for this machine: 127.0.0.1 or localhost.\n");
  if (parsed.request.method != "GET") return refusal(405, "Only GET.\n");
  return {0, {}, {}};
}

}  // namespace

struct HttpServer::Listener {
  struct Job {
    std::uint64_t connection = 0;
    std::string path;
    Answer answer;
  };

  Listener(int port_asked, Handler handler_given);
  void serve();
  void make_answers();
  void poll_once();
  void accept_all();
  void read_from(Connection& connection);
  void write_to(Connection& connection);
  void discard_from(Connection& connection) const;
  void give(Connection& connection, Answer answer) const;
  void take_answers();
  void wake() const;
  void end();

  Handler handler;
  Socket socket;
  Socket wake_reader;
  Socket wake_writer;
  int port = 0;
  std::vector<Connection> connections;
  std::uint64_t next_id = 0;
  Clock::time_point accepts_from;
  std::mutex mutex;
  std::condition_variable has_work;
  std::deque<Job> jobs;  ///< to be answered
  std::deque<Job> done;
  std::atomic<bool> over = false;
  std::vector<std::thread> threads;
};

HttpServer::Listener::Listener(int port_asked, Handler handler_given)
    : handler(std::move(handler_given)),
      socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0) {
    wake_reader = Socket(ends[0]);
    wake_writer = Socket(ends[1]);
  }
  // Without SO_REUSEPORT, with which two programs could share a port, each getting half of the requests.
  const int yes = 1;
  setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port_asked));
  socklen_t length = sizeof address;
  auto* const general = reinterpret_cast<sockaddr*>(&address);
  if (ends[0] < 0 || ::bind(socket.number(), general, length) != 0 ||
      ::listen(socket.number(), SOMAXCONN) != 0 || ::getsockname(socket.number(), general, &length) != 0)
    throw Error(
        fmt::format("Port {} cannot be listened at: another program does, or the system reserves it. "
                    "--serve 0 takes any free one.",
                    port_asked));
  port = ntohs(address.sin_port);
}

void HttpServer::Listener::wake() const {
  const char byte = 0;
  // Where the pipe is full the reader wakes anyway.
  [[maybe_unused]] const ssize_t ignored = ::write(wake_writer.number(), &byte, 1);
}

void HttpServer::Listener::make_answers() {
  let_the_run_go_first();
  std::unique_lock lock(mutex);
  for (;;) {
    has_work.wait(lock, [this] { return over || !jobs.empty(); });
    if (over) return;
    Job job = std::move(jobs.front());
    jobs.pop_front();
    lock.unlock();
    job.answer = handler(job.path);
    lock.lock();
    done.push_back(std::move(job));
    wake();
  }
}

void HttpServer::Listener::give(Connection& connection, Answer answer) const {
  connection.head = answer_head(answer.status, answer.type, answer.content->size());
  connection.content = std::move(answer.content);
  connection.stage = Stage::Writing;
  constexpr std::size_t bytes_by_millisecond = 1000;
  connection.deadline =
      Clock::now() + longest_answer + milliseconds(connection.content->size() / bytes_by_millisecond);
}

void HttpServer::Listener::take_answers() {
  std::array<char, 64> bytes{};
  while (::read(wake_reader.number(), bytes.data(), bytes.size()) > 0) {
  }
  const std::lock_guard lock(mutex);
  for (Job& job : done)
    for (Connection& connection : connections)
      if (connection.id == job.connection && connection.stage == Stage::Waiting)
        give(connection, std::move(job.answer));
  done.clear();
}

void HttpServer::Listener::accept_all() {
  for (;;) {
    const int number = ::accept4(socket.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (number < 0 && errno == EINTR) continue;
    if (number < 0) {
      if (errno != EAGAIN) accepts_from = Clock::now() + pause;
      return;
    }
    // Who connects and says nothing makes room for others.
    if (connections.size() >= most_connections) {
      const auto silent =
          std::find_if(connections.begin(), connections.end(), [](const Connection& connection) {
            return connection.stage == Stage::Reading || connection.stage == Stage::Closing;
          });
      connections.erase(silent == connections.end() ? connections.begin() : silent);
    }
    Connection connection;
    connection.socket = Socket(number);
    connection.id = ++next_id;
    connection.deadline = Clock::now() + longest_request;
    connections.push_back(std::move(connection));
  }
}

void HttpServer::Listener::read_from(Connection& connection) {
  std::array<char, 4096> bytes{};
  const ssize_t got = ::recv(connection.socket.number(), bytes.data(), bytes.size(), 0);
  if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (got <= 0) {
    connection.stage = Stage::Over;
    return;
  }
  connection.received.append(bytes.data(), static_cast<std::size_t>(got));
  const ParsedRequest parsed = parse_request(connection.received);
  if (parsed.state == RequestState::Incomplete) return;
  connection.received.clear();
  if (Answer answer = answer_at_once(parsed); answer.status != 0) {
    give(connection, std::move(answer));
    return;
  }
  connection.stage = Stage::Waiting;
  connection.deadline = Clock::time_point::max();
  std::unique_lock lock(mutex);
  // Those of connections that are gone stay in the line.
  if (jobs.size() >= 2 * most_connections) {
    lock.unlock();
    give(connection, refusal(503, "Too many requests at once.\n"));
    return;
  }
  jobs.push_back({connection.id, parsed.request.path, {}});
  has_work.notify_one();
}

void HttpServer::Listener::write_to(Connection& connection) {
  const std::size_t head = connection.head.size();
  const std::size_t all = head + connection.content->size();
  while (connection.sent < all) {
    const bool in_head = connection.sent < head;
    const std::string_view rest = std::string_view(in_head ? connection.head : *connection.content)
                                      .substr(connection.sent - (in_head ? 0 : head));
    const ssize_t sent = ::send(connection.socket.number(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (sent < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (sent <= 0) {
      connection.stage = Stage::Over;
      return;
    }
    connection.sent += static_cast<std::size_t>(sent);
  }
  // A close with something unread would take the answer from the client.
  ::shutdown(connection.socket.number(), SHUT_WR);
  connection.content.reset();
  connection.stage = Stage::Closing;
  connection.deadline = Clock::now() + longest_close;
}

void HttpServer::Listener::discard_from(Connection& connection) const {
  std::array<char, 4096> bytes{};
  const ssize_t got = ::recv(connection.socket.number(), bytes.data(), bytes.size(), 0);
  if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR)) connection.stage = Stage::Over;
}

void HttpServer::Listener::poll_once() {
  const bool accepts = !over && Clock::now() >= accepts_from;
  std::vector<pollfd> watched;
  watched.push_back({wake_reader.number(), POLLIN, 0});
  watched.push_back({accepts ? socket.number() : -1, POLLIN, 0});
  Clock::time_point next = Clock::now() + (accepts ? milliseconds(1000) : pause);
  for (const Connection& connection : connections) {
    const short events = connection.stage == Stage::Writing   ? POLLOUT
                         : connection.stage == Stage::Waiting ? 0
                                                              : POLLIN;
    watched.push_back({connection.socket.number(), events, 0});
    next = std::min(next, connection.deadline);
  }
  const auto wait = std::chrono::ceil<milliseconds>(next - Clock::now()).count();
  ::poll(watched.data(), watched.size(), static_cast<int>(std::max<std::int64_t>(0, wait)));
  for (std::size_t i = 0; i < connections.size(); ++i) {
    Connection& connection = connections[i];
    const int events = watched[i + 2].revents;
    if (events == 0) continue;
    if (connection.stage == Stage::Reading)
      read_from(connection);
    else if (connection.stage == Stage::Writing)
      write_to(connection);
    else if (connection.stage == Stage::Closing)
      discard_from(connection);
    else if ((events & (POLLERR | POLLHUP)) != 0)
      connection.stage = Stage::Over;
  }
  if (watched[0].revents != 0) take_answers();
  if (watched[1].revents != 0) accept_all();
  const Clock::time_point now = Clock::now();
  std::erase_if(connections, [&](const Connection& connection) {
    return connection.stage == Stage::Over || connection.deadline <= now;
  });
}

void HttpServer::Listener::serve() {
  let_the_run_go_first();
  while (!over) poll_once();
  // Answers that are on their way get a moment.
  const Clock::time_point end = Clock::now() + longest_close;
  socket = Socket();
  std::erase_if(connections, [](const Connection& connection) {
    return connection.stage != Stage::Writing && connection.stage != Stage::Closing;
  });
  for (Connection& connection : connections) connection.deadline = std::min(connection.deadline, end);
  while (!connections.empty() && Clock::now() < end) poll_once();
  connections.clear();
}

HttpServer::HttpServer(int port, Handler handler)
    : listener_(std::make_unique<Listener>(port, std::move(handler))) {
  const BlockedSignals blocked;
  Listener& listener = *listener_;
  try {
    listener.threads.emplace_back([&listener] { listener.serve(); });
    for (std::size_t i = 0; i < answering_threads; ++i)
      listener.threads.emplace_back([&listener] { listener.make_answers(); });
  } catch (const std::system_error& fault) {
    listener.end();
    throw Error(fmt::format("The live page cannot be served: {}.", fault.what()));
  }
}

void HttpServer::Listener::end() {
  {
    const std::lock_guard lock(mutex);
    over = true;
  }
  has_work.notify_all();
  wake();
  for (std::thread& thread : threads) thread.join();
}

HttpServer::~HttpServer() {
  listener_->end();
}

int HttpServer::port() const {
  return listener_->port;
}

}  // namespace crumple::live

// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

#include "output/files/write_error.hpp"

namespace crumple::output {

namespace {

std::string host_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "unknown";
  return name.data();
}

/// Whether the process that has left this text is on this machine and gone.
bool is_gone(const std::string& owner) {
  int process = 0;
  std::array<char, 256> host{};
  if (std::sscanf(owner.c_str(), "process %d on %255s", &process, host.data()) != 2) return owner.empty();
  return host.data() == host_name() && ::kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : file_(folder / ".crumple.lock") {
  while (!take()) {
  }
}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  // Before it is let go: who waits for it then sees that it is another file.
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

bool FolderLock::take() {
  descriptor_ =
      ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, 0666);
  struct stat mine {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &mine) != 0)
    throw WriteError(fmt::format("Cannot write {}: {}.", file_.string(), std::strerror(errno)));
  const auto give_up = [this] { ::close(std::exchange(descriptor_, -1)); };
  if (!S_ISREG(mine.st_mode) || mine.st_nlink > 1) {
    give_up();
    throw WriteError(fmt::format("Cannot write {}: it is no file of crumple.", file_.string()));
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const bool is_held = errno == EWOULDBLOCK;
    if (is_held || !is_gone(owner())) {
      const std::string text = owner();
      give_up();
      throw WriteError(
          fmt::format("{} is in use by another run{}: wait for its end, choose another folder with -o{}.",
                      file_.parent_path().string(), text.empty() ? "" : " (" + text + ")",
                      is_held ? "" : ", or remove " + file_.string() + " if there is no such run"));
    }
  }
  struct stat there {};
  if (::lstat(file_.c_str(), &there) != 0 || there.st_ino != mine.st_ino || there.st_dev != mine.st_dev) {
    give_up();
    return false;
  }
  const std::string text = fmt::format("process {} on {}\n", ::getpid(), host_name());
  // A full disk does not matter here: the text is for people.
  if (::ftruncate(descriptor_, 0) != 0 || ::pwrite(descriptor_, text.data(), text.size(), 0) < 0) return true;
  return true;
}

std::string FolderLock::owner() const {
  std::array<char, 300> text{};
  const ssize_t bytes = ::pread(descriptor_, text.data(), text.size() - 1, 0);
  std::string line(text.data(), bytes > 0 ? static_cast<std::size_t>(bytes) : 0);
  line.resize(std::min(line.size(), line.find('\n')));
  for (char& letter : line)
    if (static_cast<unsigned char>(letter) < 32 || letter == 127) letter = '?';
  return line;
}

}  // namespace crumple::output

// SPDX-License-Identifier: BSD-3-Clause
#include "files/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

namespace crumple {

namespace {

std::string fault_of(int reason) {
  if (reason == ENOENT || reason == ENOTDIR) return "there is no such file";
  if (reason == EACCES || reason == EPERM) return "the file cannot be opened; check its permissions";
  return std::string("the file cannot be opened: ") + std::strerror(reason);
}

/// Nothing for a regular file.
const char* what_else(mode_t mode) {
  if (S_ISDIR(mode)) return "this is a folder, expected a file";
  if (S_ISFIFO(mode)) return "this is a pipe, expected a regular file";
  if (S_ISSOCK(mode)) return "this is a socket, expected a regular file";
  if (!S_ISREG(mode)) return "this is a device, expected a regular file";
  return nullptr;
}

/// A regular file, or why there is none.
class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path) {
    // Opening a device can have effects: look first. What is opened is looked at again.
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
      fault_ = fault_of(errno);
      return;
    }
    if (const char* kind = what_else(status.st_mode)) {
      fault_ = kind;
      return;
    }
    // Without waiting: opening a pipe would wait for its writer, and a terminal must not become ours.
    number_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (number_ < 0 || ::fstat(number_, &status) != 0)
      fault_ = fault_of(errno);
    else if (const char* kind = what_else(status.st_mode))
      fault_ = kind;
    bytes_ = static_cast<std::uint64_t>(std::max<off_t>(0, status.st_size));
  }
  ~OpenFile() {
    if (number_ >= 0) ::close(number_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  const std::string& fault() const { return fault_; }
  int number() const { return number_; }
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::string fault_;
  int number_ = -1;
  std::uint64_t bytes_ = 0;
};

/// How many bytes came, at most `bytes`; -1 for a fault.
std::int64_t read_up_to(int file, char* at, std::uint64_t bytes) {
  std::uint64_t done = 0;
  while (done < bytes) {
    const ssize_t got = ::read(file, at + done, std::min<std::uint64_t>(bytes - done, 1U << 30U));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return -1;
    if (got == 0) break;
    done += static_cast<std::uint64_t>(got);
  }
  return static_cast<std::int64_t>(done);
}

std::string read_whole(int file, std::uint64_t bytes, InputFile& input) {
  try {
    input.text.resize(bytes);
  } catch (const std::bad_alloc&) {
    return "there is no memory for its " + size_text(bytes);
  } catch (const std::length_error&) {
    return "there is no memory for its " + size_text(bytes);
  }
  const std::int64_t got = read_up_to(file, input.text.data(), bytes);
  if (got < 0) return "the file cannot be read to its end";
  // What is being cut off at this moment is as long as it is.
  input.text.resize(static_cast<std::size_t>(got));
  // Files that the kernel makes up have no length, and may have no end.
  char more = 0;
  if (bytes == 0 && read_up_to(file, &more, 1) != 0)
    return "the kernel makes this file up, expected a regular one";
  return {};
}

}  // namespace

std::uint64_t most_input_bytes() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long bytes = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || bytes <= 0) return UINT64_MAX;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes) / 2;
}

std::string size_text(std::uint64_t bytes) {
  constexpr std::array<const char*, 5> units{"kB", "MB", "GB", "TB", "PB"};
  if (bytes < 1000) return std::to_string(bytes) + " bytes";
  double value = static_cast<double>(bytes) / 1000;
  std::size_t unit = 0;
  for (; value >= 1000 && unit + 1 < units.size(); ++unit) value /= 1000;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.1f %s", value, units[unit]);
  return text.data();
}

InputFile read_input_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
  InputFile input;
  const OpenFile file(path);
  input.fault = file.fault();
  if (!input.fault.empty()) return input;
  const std::uint64_t most = std::min(most_bytes, most_input_bytes());
  if (file.bytes() > most)
    input.fault = "the file has " + size_text(file.bytes()) + ", more than the " + size_text(most) +
                  " that can be read";
  else
    input.fault = read_whole(file.number(), file.bytes(), input);
  if (!input.fault.empty()) input.text.clear();
  return input;
}

std::string read_start(const std::filesystem::path& path, std::size_t most_bytes) {
  const OpenFile file(path);
  if (!file.fault().empty()) return {};
  std::string text(most_bytes, '\0');
  const std::int64_t got = read_up_to(file.number(), text.data(), most_bytes);
  text.resize(static_cast<std::size_t>(std::max<std::int64_t>(0, got)));
  return text;
}

}  // namespace crumple

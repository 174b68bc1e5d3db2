// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/own_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "output/files/write_error.hpp"

namespace crumple::output {

namespace {

constexpr std::string_view unfinished = ".tmp";
constexpr std::size_t random_digits = 16;
/// Of the file's own name in the name beside it: names may have 255 bytes in all.
constexpr std::size_t longest_stem = 200;

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view reason) {
  throw WriteError(fmt::format("Cannot write {}: {}.", path.string(), reason));
}

std::string random_name(const std::filesystem::path& path) {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number))
    refuse(path, "there are no random numbers");
  return fmt::format(".{}.{:0{}x}{}", path.filename().string().substr(0, longest_stem), number, random_digits,
                     unfinished);
}

bool is_unfinished(const std::string& name) {
  return name.starts_with('.') && name.ends_with(unfinished) &&
         name.size() > random_digits + unfinished.size() + 2 &&
         name[name.size() - unfinished.size() - random_digits - 1] == '.';
}

/// What stands in the place of a new file must be a file, or a link to one or to nothing.
void require_replaceable(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return;
  if (S_ISDIR(status.st_mode)) refuse(path, std::strerror(EISDIR));
  if (!S_ISREG(status.st_mode)) refuse(path, "it is a device, a pipe or a socket, not a file");
}

}  // namespace

OwnFile::OwnFile(OwnFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

OwnFile& OwnFile::operator=(OwnFile&& other) noexcept {
  if (this == &other) return *this;
  if (descriptor_ >= 0) ::close(descriptor_);
  path_ = std::move(other.path_);
  descriptor_ = std::exchange(other.descriptor_, -1);
  return *this;
}

OwnFile::~OwnFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OwnFile::fail() const {
  refuse(path_, std::strerror(errno));
}

OwnFile OwnFile::create(const std::filesystem::path& path) {
  NewFile file(path);
  file.rename();
  return std::move(file.file_);
}

OwnFile OwnFile::open(const std::filesystem::path& path) {
  OwnFile file;
  file.path_ = path;
  // Without waiting for the reader of a pipe.
  file.descriptor_ = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file.descriptor_ < 0 && errno == ELOOP) refuse(path, "it is a link, not a file");
  if (file.descriptor_ < 0) file.fail();
  struct stat status {};
  if (::fstat(file.descriptor_, &status) != 0) file.fail();
  if (!S_ISREG(status.st_mode)) refuse(path, "it is a device, a pipe or a socket, not a file");
  if (status.st_nlink < 2) return file;
  // Its other name belongs to somebody else, such as a copy of the folder by hard links.
  NewFile copy(path);
  std::string piece(1U << 20U, '\0');
  for (ssize_t got = 0; (got = ::read(file.descriptor_, piece.data(), piece.size())) != 0;) {
    if (got < 0) file.fail();
    copy.write(std::string_view(piece).substr(0, static_cast<std::size_t>(got)));
  }
  copy.rename();
  return std::move(copy.file_);
}

std::uint64_t OwnFile::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail();
  return static_cast<std::uint64_t>(status.st_size);
}

void OwnFile::truncate(std::uint64_t bytes) {
  if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) fail();
}

void OwnFile::write_at(std::uint64_t place, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(place));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail();
    place += static_cast<std::uint64_t>(written);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OwnFile::require_name() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail();
  if (status.st_nlink == 0) refuse(path_, "it has been removed or replaced since the run opened it");
}

void OwnFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
}

NewFile::NewFile(std::filesystem::path path) : path_(std::move(path)) {
  require_replaceable(path_);
  file_.path_ = path_;
  constexpr int tries = 100;
  for (int i = 0; i < tries && !file_; ++i) {
    temporary_ = path_;
    temporary_.replace_filename(random_name(path_));
    file_.descriptor_ =
        ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC | O_NOCTTY, 0666);
    if (!file_ && errno != EEXIST) file_.fail();
  }
  if (!file_) file_.fail();
}

NewFile::~NewFile() {
  if (!in_place_ && !temporary_.empty()) ::unlink(temporary_.c_str());
}

void NewFile::write(std::string_view bytes) {
  file_.write_at(bytes_, bytes);
  bytes_ += bytes.size();
}

void NewFile::synchronize() {
  if (::syncfs(file_.descriptor()) != 0) file_.fail();
}

void NewFile::rename() {
  require_replaceable(path_);
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) file_.fail();
  in_place_ = true;
}

void NewFile::put_in_place() {
  file_.close();
  rename();
}

void remove_unfinished_files(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (is_unfinished(name) && !name.starts_with(".report.html."))
      std::filesystem::remove(entry.path(), ignored);
  }
}

}  // namespace crumple::output

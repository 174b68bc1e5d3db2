// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/report_pictures.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "base/error.hpp"
#include "output/files/atomic_file.hpp"
#include "report/text_file.hpp"

namespace crumple::app {

namespace {

/// Longer than the largest report takes to be drawn without a graphics card.
constexpr std::chrono::seconds patience{120};

std::string percent_encoded(const std::string& text, bool keep_slashes) {
  std::string encoded;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    const bool plain = (code >= '0' && code <= '9') || (code >= 'A' && code <= 'Z') ||
                       (code >= 'a' && code <= 'z') || letter == '-' || letter == '_' || letter == '.' ||
                       (letter == '/' && keep_slashes);
    encoded += plain ? std::string(1, letter) : fmt::format("%{:02X}", code);
  }
  return encoded;
}

/// Removes a folder when it goes.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    // One of our own, which nobody else can have made before.
    std::string name = (std::filesystem::temp_directory_path() / "crumple_picture_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw Error(fmt::format("The folder {} cannot be made.", name));
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs a program without its words; false if it cannot be started, fails or does not end in time.
bool run_quietly(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  pid_t child = 0;
  const bool started = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  if (!started) return false;
  int status = 0;
  const auto end = std::chrono::steady_clock::now() + patience;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool is_program(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0;
}

}  // namespace

std::filesystem::path find_browser() {
  if (const char* named = std::getenv("CHROMIUM"); named != nullptr && *named != '\0') {
    if (is_program(named)) return named;
    throw Error(fmt::format("CHROMIUM names {}, which is no program.", named));
  }
  const char* path = std::getenv("PATH");
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
      if (auto file = std::filesystem::path(folder) / name; is_program(file)) return file;
  }
  throw Error(
      "Pictures are drawn by chromium, which was not found: on Debian \"apt-get install chromium\" installs "
      "it; "
      "CHROMIUM=FILE names one that lies elsewhere.");
}

std::string picture_address(const std::filesystem::path& report, const PictureOptions& options,
                            const std::string& frame) {
  std::string address = "file://" + percent_encoded(std::filesystem::absolute(report).string(), true) +
                        "#picture&theme=light&frame=" + percent_encoded(frame, false);
  if (!options.view.empty()) address += "&view=" + percent_encoded(options.view, false);
  if (options.field) address += "&field=" + percent_encoded(*options.field, false);
  return address;
}

std::vector<std::filesystem::path> draw_pictures(const std::filesystem::path& report,
                                                 const PictureOptions& options) {
  const std::string browser = find_browser().string();
  const TemporaryFolder profile;
  std::vector<std::filesystem::path> pictures;
  for (const std::string& frame : options.frames) {
    const std::filesystem::path picture = std::filesystem::absolute(
        report.parent_path() / fmt::format("{}_{}.png", report.stem().string(), pictures.size() + 1));
    // Not where it shall lie: the browser would follow a link there.
    const std::filesystem::path drawn = profile.path() / "picture.png";
    std::error_code ignored;
    std::filesystem::remove(drawn, ignored);
    std::vector<std::string> words = {browser,
                                      "--headless",
                                      "--use-angle=swiftshader",
                                      "--enable-unsafe-swiftshader",
                                      "--ignore-gpu-blocklist",
                                      "--hide-scrollbars",
                                      "--no-first-run",
                                      "--virtual-time-budget=10000",
                                      fmt::format("--window-size={},{}", options.width, options.height),
                                      "--user-data-dir=" + profile.path().string(),
                                      "--screenshot=" + drawn.string()};
    // Containers give /dev/shm little room.
    words.emplace_back("--disable-dev-shm-usage");
    // Chromium refuses its sandbox to root.
    if (geteuid() == 0) words.emplace_back("--no-sandbox");
    words.push_back(picture_address(report, options, frame));
    if (!run_quietly(words) || !std::filesystem::is_regular_file(drawn))
      throw Error(fmt::format("{} did not draw {}.", browser, picture.string()));
    output::write_atomically(picture, report::read_file(drawn));
    pictures.push_back(report.parent_path() / picture.filename());
  }
  return pictures;
}

}  // namespace crumple::app

// SPDX-License-Identifier: BSD-3-Clause
#include "live/live_page.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "output/files/atomic_file.hpp"
#include "output/paraview/vtu_file.hpp"

namespace crumple::live::live_page_test {
namespace {

/// A triangle whose third node has moved.
std::string triangle(float height) {
  output::VtuPacker packer;
  const auto position =
      packer.array<float>("position", 3, std::vector<float>{0, 0, 0, 1, 0, 0, 0, height, 0});
  const auto connectivity = packer.array<std::int32_t>("connectivity", 1, std::vector<std::int32_t>{0, 1, 2});
  const auto offsets = packer.array<std::int32_t>("offsets", 1, std::vector<std::int32_t>{3});
  const auto types = packer.array<std::uint8_t>("types", 1, std::vector<std::uint8_t>{5});
  const auto node = packer.array<std::int64_t>("node_id", 1, std::vector<std::int64_t>{1, 2, 3});
  const auto element = packer.array<std::int64_t>("element_id", 1, std::vector<std::int64_t>{1});
  const auto part = packer.array<std::int64_t>("part", 1, std::vector<std::int64_t>{1});
  output::VtuGrid grid;
  grid.points = 3;
  grid.cells = 1;
  grid.positions = {&position};
  grid.topology = {&connectivity, &offsets, &types};
  grid.point_data = {&node};
  grid.cell_data = {&part, &element};
  return output::vtu_text(grid);
}

class LivePageTest : public ::testing::Test {
 public:
  ~LivePageTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

 protected:
  LivePageTest() {
    std::filesystem::create_directories(folder_);
    output::write_atomically(files_.report_template, "<!-- crumple-data -->");
    output::write_atomically(files_.live_template, "the page around");
  }

  void SetUp() override {
    try {
      page_ = std::make_unique<LivePage>(files_, 0, "", [this] { return board_.read(); });
    } catch (const Error& fault) {
      GTEST_SKIP() << fault.what();
    }
  }

  /// What a run does for a frame.
  void add_frame() {
    const int number = status_.frames++;
    output::write_atomically(folder_ / fmt::format("{}.vtu", number),
                             triangle(1 + static_cast<float>(number)));
    listed_ += fmt::format("<DataSet timestep=\"{0}\" part=\"0\" file=\"{0}.vtu\"/>", number);
    output::write_atomically(folder_ / "a.pvd", listed_);
    std::ofstream(folder_ / "glstat.csv", std::ios::app) << (number == 0 ? "time\n" : "") << number << "\n";
    status_.state = RunState::Running;
    board_.post(status_);
  }

  struct Reply {
    int status = 0;
    std::string content;
  };

  Reply get(const std::string& path) const {
    const std::string address = page_->address();
    sockaddr_in server{};
    server.sin_family = AF_INET;
    server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    server.sin_port = htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
    const int caller = socket(AF_INET, SOCK_STREAM, 0);
    std::string text;
    if (connect(caller, reinterpret_cast<const sockaddr*>(&server), sizeof server) == 0) {
      const std::string request = fmt::format("GET {} HTTP/1.1\r\nHost: localhost\r\n\r\n", path);
      send(caller, request.data(), request.size(), MSG_NOSIGNAL);
      char part[4096];
      for (ssize_t got = 0; (got = recv(caller, part, sizeof part, 0)) > 0;)
        text.append(part, static_cast<std::size_t>(got));
    }
    close(caller);
    const std::size_t head = text.find("\r\n\r\n");
    if (!text.starts_with("HTTP/1.1 ") || head == std::string::npos) return {};
    return {std::stoi(text.substr(9)), text.substr(head + 4)};
  }

  static std::size_t frames_in(const std::string& report) {
    const std::string key = "id=\"crumple-meta\">";
    const std::size_t start = report.find(key) + key.size();
    const std::string meta = report.substr(start, report.find("</script>", start) - start);
    return nlohmann::json::parse(meta).at("times").size();
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      fmt::format("crumple_live_{}_{}", ::testing::UnitTest::GetInstance()->current_test_info()->name(),
                  getpid());
  LiveFiles files_{folder_, folder_ / "report.html", folder_ / "live.html"};
  StatusBoard board_;
  RunStatus status_;
  std::string listed_;
  std::unique_ptr<LivePage> page_;
};

TEST_F(LivePageTest, HasNoReportBeforeTheFirstFrame) {
  EXPECT_EQ(get("/").content, "the page around");
  EXPECT_EQ(get("/report").status, 503);
  EXPECT_EQ(nlohmann::json::parse(get("/status").content)["state"], "starting");
  add_frame();
  const Reply report = get("/report");
  EXPECT_EQ(report.status, 200);
  EXPECT_EQ(frames_in(report.content), 1U);
}

TEST_F(LivePageTest, MakesTheReportAnewForANewFrameAndForTheEndOnly) {
  add_frame();
  const std::string first = get("/report").content;
  std::ofstream(folder_ / "glstat.csv", std::ios::app) << "0.5\n";
  EXPECT_EQ(get("/report").content, first);
  add_frame();
  const std::string second = get("/report").content;
  EXPECT_EQ(frames_in(second), 2U);
  std::ofstream(folder_ / "run.json") << R"({"termination": "normal"})";
  EXPECT_EQ(get("/report").content, second);
  board_.end("normal");
  EXPECT_NE(get("/report").content.find(R"("run":{"termination":"normal"})"), std::string::npos);
}

TEST_F(LivePageTest, TellsWhatIsWrongWithTheResults) {
  add_frame();
  std::ofstream(folder_ / "0.vtu") << "cut short";
  const Reply report = get("/report");
  EXPECT_EQ(report.status, 500);
  EXPECT_NE(report.content.find("0.vtu"), std::string::npos);
}

TEST_F(LivePageTest, ServesWhileTheRunWrites) {
  add_frame();
  const auto read_all = [this] {
    for (bool ended = false; !ended;) {
      const auto status = nlohmann::json::parse(get("/status").content);
      ended = status["state"] == "ended";
      const Reply report = get("/report");
      ASSERT_EQ(report.status, 200) << report.content;
      EXPECT_GE(frames_in(report.content), status["frames"].get<std::size_t>());
    }
  };
  std::thread one(read_all);
  std::thread other(read_all);
  for (int frame = 0; frame < 20; ++frame) {
    add_frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  board_.end("normal");
  one.join();
  other.join();
  EXPECT_EQ(frames_in(get("/report").content), 21U);
}

TEST_F(LivePageTest, WaitsForNobodyButReaders) {
  const Stopwatch watch;
  page_->wait_for_readers(false);
  EXPECT_LT(watch.seconds(), 1);
  get("/status");
  const Stopwatch after;
  page_->wait_for_readers(false);
  EXPECT_GT(after.seconds(), 1);
}

TEST_F(LivePageTest, WaitsNotLongInHaste) {
  get("/status");
  const Stopwatch watch;
  page_->wait_for_readers(true);
  EXPECT_LT(watch.seconds(), 1.5);
}

TEST_F(LivePageTest, AnswersOnlyBehindItsToken) {
  page_.reset();
  const std::string token = random_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_NE(token, random_token());
  page_ = std::make_unique<LivePage>(files_, 0, token, [this] { return board_.read(); });
  EXPECT_TRUE(page_->address().ends_with("/" + token + "/"));
  EXPECT_EQ(get("/" + token + "/").content, "the page around");
  EXPECT_EQ(get("/" + token + "/nothing").status, 404);
  for (const std::string& path : {std::string("/"), std::string("/status"), "/" + token, "/x" + token + "/"})
    EXPECT_EQ(get(path).status, 403) << path;
}

TEST_F(LivePageTest, StopsWithoutAnyRequest) {
  page_.reset();
}

TEST_F(LivePageTest, DoesNotShareItsPort) {
  const std::string address = page_->address();
  const int port = std::stoi(address.substr(address.rfind(':') + 1));
  EXPECT_THROW(LivePage(files_, port, "", [] { return RunStatus{}; }), Error);
}

}  // namespace
}  // namespace crumple::live::live_page_test

// polhode check: a line for every certificate, the exit status, and what it says of input that is none.

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "refusal.hpp"

namespace polhode::test {
namespace {

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

TEST(Check, VerifiesWhatCertifyWrote) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "beta", "physical", "--digits", "20", "--out", directory});
  const std::string out = certified({"check", directory});
  const auto lines = lines_of(out);
  ASSERT_EQ(lines.size(), 3U) << out;
  EXPECT_EQ(lines[0].rfind(directory + "/beta.json: verified: beta, ", 0), 0U) << out;
  EXPECT_EQ(lines[1].rfind(directory + "/physical.json: verified: physical, ", 0), 0U) << out;
  EXPECT_EQ(lines[2], "2 certificates: 2 verified");
  EXPECT_NE(certified({"check", directory + "/beta.json", "--verbose"}).find("beta = 0.028973"),
            std::string::npos);
}

TEST(Check, NamesTheFileAndThePlaceOfWhatIsWrong) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "beta", "physical", "--digits", "20", "--out", directory});
  std::string text = contents(directory + "/beta.json");
  const auto digit = text.find("0.028973228") + 8;
  text[digit] = '4';
  write(directory + "/beta.json", text);
  const outcome result = run({"check", directory});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("/beta.json: refuted: at /numbers/beta/value: "), std::string::npos);
  EXPECT_NE(result.out.find("2 certificates: 1 verified\n"), std::string::npos);
}

TEST(Check, SaysWhatIsNoCertificate) {
  const scratch_directory scratch;
  write(scratch.path("broken.json"), "{\"format\":");
  const outcome result = run({"check", scratch.path("broken.json")});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.out.find("malformed"), std::string::npos);
  EXPECT_NE(result.err.find("/format"), std::string::npos);
  expect_refused({"check"}, {"PATH"});
}

/// A path that cannot be read has a line of its own, costs the status 2, and no other file its line.
TEST(Check, WhatCannotBeReadCostsOnlyItsOwnLine) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "physical", "--out", directory});
  const auto expect_line = [&](const std::string& path, const std::string& why) {
    const outcome result = run({"check", path, directory + "/physical.json"});
    EXPECT_EQ(result.status, 2) << path;
    const auto lines = lines_of(result.out);
    ASSERT_EQ(lines.size(), 3U) << result.out;
    EXPECT_EQ(lines[0], path + ": not read: " + why);
    EXPECT_NE(lines[1].find("physical.json: verified"), std::string::npos);
    EXPECT_EQ(lines[2], "2 certificates: 1 verified");
    EXPECT_EQ(result.err, "polhode: \"" + path + "\": " + why + "\n");
  };
  expect_line(scratch.path("missing.json"), "No such file or directory");
  const std::string device = "a pipe, a socket or a device; it must be a regular file";
  const std::string pipe = scratch.path("pipe.json");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expect_line(pipe, device);
  expect_line("/dev/zero", device);
  const std::string empty = scratch.path("empty");
  std::filesystem::create_directory(empty);
  expect_line(empty,
              "a directory with no .json file; it must hold certificates, as `polhode certify "
              "--out DIR` writes them");
  const std::string circle = scratch.path("circle.json");
  std::filesystem::create_symlink(circle, circle);
  expect_line(circle, "Too many levels of symbolic links");
  if (geteuid() != 0) {  // who may read everything
    write(scratch.path("secret.json"), "{}");
    chmod(scratch.path("secret.json").c_str(), 0);
    expect_line(scratch.path("secret.json"), "Permission denied");
  }
}

TEST(Check, NamesWhatIsNoFileInADirectory) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "physical", "--out", directory});
  std::filesystem::create_directory(directory + "/a.json");
  std::filesystem::create_symlink("nowhere", directory + "/b.json");
  ASSERT_EQ(mkfifo((directory + "/z.json").c_str(), 0600), 0);
  write(directory + "/notes.txt", "no certificate");
  const outcome result = run({"check", directory});
  EXPECT_EQ(result.status, 2);
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 5U) << result.out;
  EXPECT_EQ(lines[0], directory + "/a.json: not read: a directory; it must be a file");
  EXPECT_EQ(lines[1], directory + "/b.json: not read: No such file or directory");
  EXPECT_NE(lines[2].find("/physical.json: verified: physical, "), std::string::npos);
  EXPECT_NE(lines[3].find("/z.json: not read: a pipe"), std::string::npos);
  EXPECT_EQ(lines[4], "4 certificates: 1 verified");
}

}  // namespace
}  // namespace polhode::test

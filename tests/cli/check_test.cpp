// polhode check: a line for every certificate, the exit status, and what it says of input that is
// none.

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "polhode/certificate/digest.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace check_test {

using json = nlohmann::ordered_json;

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

/// The lines of files, without what is said of each.
std::vector<std::string> unindented(const std::string& text) {
  std::vector<std::string> lines;
  for (const std::string& line : lines_of(text)) {
    if (!line.starts_with("  ")) lines.push_back(line);
  }
  return lines;
}

TEST(Check, VerifiesWhatCertifyWrote) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "beta", "physical", "--digits", "20", "--out", directory});
  const std::string out = certified({"check", directory});
  const auto lines = unindented(out);
  ASSERT_EQ(lines.size(), 3U) << out;
  EXPECT_EQ(lines[0].rfind(
                directory + "/beta.json: verified, for all bodies by Coq's kernel (not run here): "
                            "claim \"beta\", ",
                0),
            0U)
      << out;
  EXPECT_EQ(lines[1].rfind(directory + "/physical.json: verified, for all bodies by Coq's kernel "
                                       "(not run here): claim \"physical\" for the "
                                       "physical body a = 253/20, b = 629/10000, ",
                           0),
            0U)
      << out;
  EXPECT_EQ(lines[2], "2 certificates: 2 verified");
  EXPECT_NE(out.find("\n  beta is between 0.0289732280"), std::string::npos) << out;
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
  EXPECT_NE(result.err.find("malformed"), std::string::npos);
  EXPECT_NE(result.err.find("/format"), std::string::npos);
  expect_refused({"check"}, {"PATH"});
}

/// A path that cannot be read has a line of its own, costs the status 2, and no other file its
/// line.
TEST(Check, WhatCannotBeReadCostsOnlyItsOwnLine) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "physical", "--out", directory});
  const auto expect_line = [&](const std::string& path, const std::string& why) {
    const outcome result = run({"check", path, directory + "/physical.json"});
    EXPECT_EQ(result.status, 2) << path;
    const auto lines = unindented(result.out);
    ASSERT_EQ(lines.size(), 2U) << result.out;
    EXPECT_NE(lines[0].find("physical.json: verified, for all bodies"), std::string::npos);
    EXPECT_EQ(lines[1], "2 certificates: 1 verified");
    EXPECT_EQ(result.err, "polhode: " + path + ": not read: " + why + "\n");
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
  const auto lines = unindented(result.out);
  ASSERT_EQ(lines.size(), 2U) << result.out;
  EXPECT_NE(lines[0].find("/physical.json: verified, for all bodies by Coq's kernel (not run "
                          "here): claim \"physical\" for "),
            std::string::npos);
  EXPECT_EQ(lines[1], "4 certificates: 1 verified");
  const auto faults = lines_of(result.err);
  ASSERT_EQ(faults.size(), 3U) << result.err;
  EXPECT_EQ(faults[0],
            "polhode: " + directory + "/a.json: not read: a directory; it must be a file");
  EXPECT_EQ(faults[1], "polhode: " + directory + "/b.json: not read: No such file or directory");
  EXPECT_NE(faults[2].find("/z.json: not read: a pipe"), std::string::npos);
}

/// The integral of pi and that of 4/(1+x^2) have one value, and must not look alike.
TEST(Check, SaysWhatIsVerified) {
  const scratch_directory scratch;
  const std::string file = scratch.path("c.json");
  certified({"integrate", "4/(1+x^2)", "--from", "0", "--to", "1", "--certificate", file});
  const std::string out = certified({"check", file});
  EXPECT_NE(out.find(": verified: integral, "), std::string::npos) << out;
  EXPECT_NE(out.find("\n  the integral of 4/(1 + x^2) over x from 0 to 1\n  is between 3.14159265"),
            std::string::npos)
      << out;
  certified({"certify", "physical", "--ab", "39.95,0.0629", "--out", scratch.path("out")});
  EXPECT_NE(certified({"check", scratch.path("out")}).find("for the non-physical body a = 799/20"),
            std::string::npos);
}

/// What is left out is said first, and costs the status 1.
TEST(Check, AnEmptiedCertificateIsNotVerified) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "separatrix_twist", "--out", directory});
  json c = json::parse(contents(directory + "/separatrix_twist.json"));
  c["numbers"] = json::object();
  c["rests_on"].erase(1);  // it rests on no enclosure then
  c["method"] = c["method"].get<std::string>() +
                " (For the given body an enclosure of epsilon0 was not found at the precisions "
                "tried. The proof does not need it.)";
  c.erase("digest");
  c["digest"] = digest_of(c.dump());
  write(directory + "/separatrix_twist.json", c.dump());
  const outcome result = run({"check", directory});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(
      result.out.find(
          ": verified, for all bodies by Coq's kernel (not run here), without an enclosure of "
          "epsilon0: claim "),
      std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("1 certificate: 0 verified, 1 without a part\n"), std::string::npos);
}

TEST(Check, NamesOfFilesCannotFakeALine) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  std::filesystem::create_directory(directory);
  write(directory + "/x\ny.json: verified: integral.json", "{}");
  write(directory + "/\x1b[1A.json", "{}");
  const outcome result = run({"check", directory});
  EXPECT_EQ(result.status, 2);
  for (const std::string* text : {&result.out, &result.err}) {
    EXPECT_EQ(text->find('\x1b'), std::string::npos) << *text;
    EXPECT_EQ(text->find("\ny.json"), std::string::npos) << *text;
  }
  EXPECT_NE(result.err.find("/x\\x0ay.json: verified: integral.json\": malformed: "),
            std::string::npos)
      << result.err;
}

TEST(Check, HasABudget) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "beta", "--out", directory});
  const outcome result = run({"check", directory, "--budget", "1"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.out.find("/beta.json: not checkable: at /"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("budget of 1 million operations"), std::string::npos) << result.out;
  EXPECT_NE(certified({"check", directory, "--verbose"}).find("\n  cost: "), std::string::npos);
  expect_refused({"check", directory, "--budget", "0"}, {"--budget", "whole number"});
  expect_refused({"check", directory, "--memory", "much"}, {"--memory", "whole number"});
}

/// The budget is that of the call: each file has an equal share of what is left.
TEST(Check, SharesItsBudget) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "beta", "--digits", "300", "--out", directory});
  const std::string text = contents(directory + "/beta.json");
  for (int i = 0; i < 9; ++i) write(directory + "/b" + std::to_string(i) + ".json", text);
  // One of them costs about twelve million operations: enough for one, and too little for ten.
  EXPECT_EQ(run({"check", directory + "/beta.json", "--budget", "13"}).status, 0);
  const outcome all = run({"check", directory, "--budget", "13"});
  EXPECT_EQ(all.status, 1);
  EXPECT_NE(all.out.find("not checkable"), std::string::npos) << all.out;
  EXPECT_EQ(run({"check", directory, "--budget", "130"}).status, 0);
}

/// The program of its own prints the same, with the same status.
TEST(Check, IsAProgramOfItsOwn) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  certified({"certify", "beta", "physical", "--out", directory});
  const auto expect_same = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> command{POLHODE_CHECK_PATH};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const outcome own = run_command(command);
    std::vector<std::string> with = arguments;
    with.insert(with.begin(), "check");
    const outcome result = run(with);
    EXPECT_EQ(own.status, result.status);
    EXPECT_EQ(own.out, result.out);
  };
  expect_same({directory});
  expect_same({"--verbose", directory + "/beta.json"});
  expect_same({directory, "--budget", "1"});
  expect_same({directory, "--memory", "1"});
  expect_same({directory, "--format", "json"});
  expect_same({"--verbose", "--format", "json", directory + "/beta.json"});
  write(directory + "/c.json", "{}");
  expect_same({directory, scratch.path("nothing")});
  expect_same({directory, scratch.path("nothing"), "--format", "json"});
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{},
                                             {"--fast", "x"},
                                             {"x", "--budget"},
                                             {"x", "--budget", "-1"},
                                             {"x", "--format"},
                                             {"x", "--format", "xml"}}) {
    std::vector<std::string> command{POLHODE_CHECK_PATH};
    command.insert(command.end(), wrong.begin(), wrong.end());
    const outcome own = run_command(command);
    EXPECT_EQ(own.status, 2);
    EXPECT_EQ(own.out, "");
    EXPECT_EQ(lines_of(own.err).size(), 1U) << own.err;
  }
  EXPECT_EQ(run_command({POLHODE_CHECK_PATH, "--help"}).status, 0);
}

// ---------------------------------------------------------------------------------------------
// --certificate

TEST(CertificateOption, WhatIsWrittenIsVerified) {
  const scratch_directory scratch;
  const std::string file = scratch.path("c.json");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"integrate", "4/(1+x^2)", "--from", "0", "--to", "1"},
        {"integrate", "k*exp(t)*sin(t)", "--from", "0", "--to", "pi", "--let", "k=1/3",
         "--variable", "t", "--digits", "20", "--format", "json"},
        {"integrate", "exp(-x^2)", "--from", "1", "--to", "-1", "--digits", "100"},
        {"integrate", "sin(x)", "--from", "-1", "--to", "1"},
        {"roots", "cos(x)-x", "--in", "0..1"},
        {"roots", "sin(t) - k*t", "--in", "-10..10", "--let", "k=1/10", "--variable", "t"},
        {"roots", "exp(x)", "--in", "-pi..pi", "--format", "csv"},
        {"constants", "beta"},
        {"constants", "delta_psi_max", "--digits", "200"}}) {
    const std::string without = certified(arguments);
    std::vector<std::string> with = arguments;
    with.insert(with.end(), {"--certificate", file});
    const std::string printed = certified(with);
    if (arguments.front() != "integrate") {  // whose account may differ
      EXPECT_EQ(printed, without);
    }
    EXPECT_NE(certified({"check", file}).find(": verified"), std::string::npos)
        << arguments[0] << ' ' << arguments[1];
  }
}

TEST(CertificateOption, WhatNoCertificateCanHoldIsRefusedAndNothingWritten) {
  const scratch_directory scratch;
  const std::string file = scratch.path("c.json");
  const auto refused = [&](std::vector<std::string> arguments,
                           const std::vector<std::string>& words) {
    arguments.insert(arguments.end(), {"--certificate", file});
    expect_refused(arguments, words);
    EXPECT_TRUE(names_in(scratch.path("")).empty()) << arguments[1];
  };
  refused({"integrate", "erf(x)", "--from", "0", "--to", "1"}, {"erf", "sqrt, exp"});
  refused({"integrate", "abs(x)", "--from", "-1", "--to", "1"}, {"abs"});
  refused({"integrate", "exp(-x)", "--from", "0", "--to", "inf"}, {"--certificate", "finite"});
  refused({"integrate", "1", "--from", "0", "--to", "gamma(1/3)"}, {"upper end", "gamma"});
  refused({"integrate", "sqrt(x)", "--from", "0", "--to", "1"}, {"analytic", "limits"});
  refused({"integrate", "a*x", "--from", "0", "--to", "1", "--let", "a=[1, 2]"},
          {"--certificate", "--from and --to"});
  refused({"integrate", "x", "--along", "0, 1"}, {"--certificate", "--from and --to"});
  refused({"integrate", "Pi", "--from", "0", "--to", "1", "--variable", "Pi"},
          {"\"Pi\"", "constant"});
  refused({"roots", "root(x, 3) - 1", "--in", "0..2"}, {"root"});
  refused({"roots", "exp(x) - 1", "--in", "-inf..1"}, {"--certificate", "finite"});
  refused({"roots", "(x-1)^2", "--in", "0..2"}, {"--certificate", "multiple"});
  refused({"roots", "sin(x)", "--in", "0..1"}, {"root 0", "end of the range"});
  refused({"roots", "tan(x)", "--in", "1..4"}, {"--certificate", "not defined everywhere"});
  refused({"constants"}, {"--certificate", "one constant"});
}

TEST(CertificateOption, WithoutAProofThereIsNoFile) {
  const scratch_directory scratch;
  const std::string file = scratch.path("c.json");
  const outcome result =
      run({"integrate", "1/x", "--from", "-1", "--to", "1", "--certificate", file});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("not certified"), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(CertificateOption, TheFileMustBeOne) {
  const scratch_directory scratch;
  const std::vector<std::string> integral{"integrate", "x", "--from", "0", "--to", "1"};
  const auto refused = [&](const std::string& path, const std::vector<std::string>& words) {
    std::vector<std::string> arguments = integral;
    arguments.insert(arguments.end(), {"--certificate", path});
    expect_refused(arguments, words);
  };
  refused("", {"--certificate", "name of a file"});
  refused(scratch.path(""), {"--certificate", "name of a file"});
  refused("/tmp", {"--certificate", "directory"});
  refused("/dev/null", {"--certificate", "device"});
  refused("/dev/null/c.json", {"--certificate", "is a file"});
}

}  // namespace check_test
}  // namespace polhode::test

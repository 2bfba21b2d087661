// polhode check: a line for every certificate, the exit status, and what it says of input that is none.

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
  expect_refused({"check", scratch.path("missing.json")}, {"missing.json", "No such file"});
}

}  // namespace
}  // namespace polhode::test

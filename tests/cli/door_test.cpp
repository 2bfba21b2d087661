// What people type at the command line: limits, names, options and help in more than one form.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace door_test {

using nlohmann::json;
using words = std::vector<std::string>;

std::string first_line(const words& arguments) {
  const std::string out = certified(arguments);
  return out.substr(0, out.find('\n'));
}

TEST(Limits, AreTakenInEachForm) {
  for (const words& range : std::vector<words>{{"-1", "2"},
                                               {"--from", "-1", "--to", "2"},
                                               {"--to=2", "--from=-1"},
                                               {"--in", "-1..2"},
                                               {"--in=-1 .. 2"},
                                               {"-1..2"},
                                               {"-1.0 .. 2."}}) {
    words integral{"integrate", "x^2 + x", "--digits", "20"};
    words roots{"roots", "x^2 - x", "--digits", "20"};
    integral.insert(integral.end(), range.begin(), range.end());
    roots.insert(roots.end(), range.begin(), range.end());
    EXPECT_EQ(first_line(integral),
              first_line({"integrate", "x^2 + x", "-1", "2", "--digits", "20"}));
    EXPECT_EQ(certified(roots), certified({"roots", "x^2 - x", "--in", "-1..2", "--digits", "20"}));
  }
  const json integral = json::parse(
      certified({"integrate", "x", "--in", "0..pi/2", "--format", "json", "--digits", "5"}));
  EXPECT_EQ(integral["from"], "0");
  EXPECT_EQ(integral["to"], "pi/2");
}

TEST(Limits, InfinityHasSeveralNames) {
  const std::string usual = first_line({"integrate", "exp(-x^2)", "-inf", "inf"});
  EXPECT_EQ(usual.substr(0, 12), "1.7724538509");
  for (const words& range : std::vector<words>{{"-oo", "oo"},
                                               {"-Infinity", "+Infinity"},
                                               {"--from", "-INF", "--to", "+oo"},
                                               {"--in", "-oo..oo"},
                                               {"--in", "−∞..∞"},
                                               {"--in", "- inf .. inf"}}) {
    words arguments{"integrate", "exp(-x^2)"};
    arguments.insert(arguments.end(), range.begin(), range.end());
    EXPECT_EQ(first_line(arguments), usual);
  }
  EXPECT_EQ(certified({"roots", "x^2-2", "-oo", "oo"}),
            certified({"roots", "x^2-2", "--in", "-inf..inf"}));
  expect_refused({"integrate", "x + oo", "0", "1"}, {"\"oo\"", "limits"});
  expect_refused({"integrate", "x", "0", "2*oo"}, {"\"oo\"", "limits"});
}

TEST(Limits, ThatAreMissingOrTooManyAreRefused) {
  for (const char* command : {"integrate", "roots"}) {
    expect_refused({command, "x"}, {"there is no", "EXPR A B"});
    expect_refused({command, "x", "0"}, {"limit A and no B"});
    expect_refused({command, "x", "--from", "0"}, {"--from and no --to"});
    expect_refused({command, "x", "--to", "0"}, {"--to and no --from"});
    expect_refused({command, "x", "0", "1", "--in", "0..1"}, {"more than one"});
    expect_refused({command, "x", "0", "1", "--from", "0"}, {"more than one"});
    expect_refused({command, "x", "0", "1", "2"}, {"\"2\" was not expected"});
    expect_refused({command, "x", "--in", "0-1"}, {"LO..HI"});
    expect_refused({command, "x", "0..1", "2"}, {"0..1"});
    expect_refused({command, "x", "0..1", "--to", "2"}, {"more than one"});
    expect_refused({command, "x", "0..y"}, {"\"0..y\"", "\"y\""});
    expect_refused({command, "x", "--in", "0..y"}, {"--in", "\"y\""});
    expect_refused({command}, {"EXPR is missing"});
  }
}

TEST(Names, OfFunctionsAndConstantsInOtherSpellings) {
  EXPECT_EQ(certified({"eval", "arctan(1) + Pi - PI"}), certified({"eval", "atan(1) + pi - pi"}));
  EXPECT_EQ(certified({"eval", "2pi"}), certified({"eval", "2*pi"}));
  EXPECT_EQ(certified({"eval", "sec(1)*csc(1)*cot(1)"}),
            certified({"eval", "1/cos(1)*(1/sin(1))*(cos(1)/sin(1))"}));
  EXPECT_EQ(first_line({"integrate", "sign(x)", "-1", "2"}).substr(0, 2), "1 ");
  EXPECT_EQ(first_line({"eval", "7!!"}), "105 exactly");
  EXPECT_NE(certified({"eval", "--functions"}).find("arctan        the same as atan\n"),
            std::string::npos);
}

/// acot(x) is pi/2 - atan(x), not atan(1/x), which jumps at 0; the others are the usual inverses of
/// reciprocals.
TEST(Names, OfInversesOfReciprocals) {
  EXPECT_EQ(first_line({"eval", "acot(-1)/pi"}), "3/4 exactly");
  EXPECT_EQ(first_line({"eval", "arccot(0)/pi"}), "1/2 exactly");
  EXPECT_EQ(first_line({"eval", "(acot(2) + acot(3))/pi"}), "1/4 exactly");
  EXPECT_EQ(first_line({"eval", "acot(10)", "--digits", "20"}), "0.099668652491162027378...");
  EXPECT_EQ(first_line({"eval", "acot(-10) + atan(1/10) - pi"}), "0 exactly");
  EXPECT_EQ(first_line({"eval", "arcsec(-2)/pi"}), "2/3 exactly");
  EXPECT_EQ(first_line({"eval", "arccsc(-2)/pi"}), "-1/6 exactly");
  EXPECT_EQ(first_line({"eval", "arccoth(3)/log(2)"}), "1/2 exactly");
  // acot is analytic at 0: pi/2 is its mean over -1..1.
  EXPECT_EQ(first_line({"integrate", "acot(x) - pi/2", "-1", "1"}).substr(0, 2), "0 ");
  EXPECT_EQ(first_line({"roots", "acot(x) - 3*pi/4", "-2..0"}), "-1 exactly  unique");
  EXPECT_NE(certified({"eval", "--help"}).find(" arccot "), std::string::npos);
}

/// The checker, whose reader knows the older names alone, reads what is written of the others.
TEST(Names, InOtherSpellingsHaveCertificates) {
  const scratch_directory scratch;
  const std::string file = scratch.path("c.json");
  certified({"integrate", "2arctan(x)*sec(x)", "0", "1", "--let", "k=Pi", "--certificate", file});
  EXPECT_NE(certified({"check", file}).find("atan(x)"), std::string::npos);
}

TEST(Names, LetTakesThemInAnyOrder) {
  EXPECT_EQ(first_line({"eval", "a + 1", "--let", "a=b", "--let", "b = 2"}), "3 exactly");
  EXPECT_EQ(first_line({"eval", "a", "--let", " a = 2 b", "--let=b=c^2", "--let", "c=3"}),
            "18 exactly");
  expect_refused({"eval", "a", "--let", "a=b", "--let", "b=a"}, {"a, b", "each other"});
  expect_refused({"eval", "a", "--let", "a=a"}, {"needs a itself"});
  expect_refused({"eval", "a", "--let", "a=1", "b=2"}, {"--let b=2"});
  expect_refused({"eval", "a", "--let", "a=1", "--let", "a=2"}, {"--let", "twice"});
  expect_refused({"eval", "1", "--let", "2a=1"}, {"--let", "\"2a\"", "cannot be a name"});
  expect_refused({"eval", "1", "--let", "=1"}, {"--let", "NAME=VALUE"});
  expect_refused({"eval", "1", "--let", "oo=1"}, {"--let", "infinity"});
}

TEST(Names, OfVariablesAreJudgedByThemselves) {
  for (const char* command : {"integrate", "roots"}) {
    for (const char* name : {"2x", "", "x y"}) {
      expect_refused({command, "x", "0", "1", "--variable", name},
                     {"--variable", "cannot be a name"});
    }
    expect_refused({command, "x", "0", "1", "--variable", "sin"}, {"--variable", "a function"});
    expect_refused({command, "x", "0", "1", "--variable", "PI"}, {"--variable", "a constant"});
  }
}

TEST(Options, AreRefusedInOurWords) {
  expect_refused({"eval", "1", "--digits"}, {"--digits has no value: write --digits N"});
  expect_refused({"eval", "1", "--digits="}, {"--digits has no value"});
  expect_refused({"eval", "1", "--digits", "--format", "json"}, {"--digits has no value"});
  expect_refused({"eval", "1", "--digits", "3", "--digits=4"}, {"--digits is given twice"});
  expect_refused({"eval", "1", "--verify=3"}, {"--verify takes no value"});
  expect_refused({"check"}, {"PATH is missing"});
  for (const char* threads : {"-1", "1025", "two", "1.5"}) {
    expect_refused({"integrate", "x", "0", "1", "--threads", threads},
                   {"--threads", "whole number from 0 to 1024"});
    expect_refused({"roots", "x", "0", "1", "--threads", threads},
                   {"--threads", "whole number from 0 to 1024"});
  }
  expect_refused({"integrate", "x", "0", "1", "--boxes", "0"}, {"--boxes", "from 1 to"});
}

TEST(Options, NearestNamesAreNear) {
  expect_refused({"evla", "1"}, {"nearest is eval"});
  for (const words& far :
       std::vector<words>{{"nonsense"}, {"eval", "1", "--zzz"}, {"eval", "Inf"}, {"eval", "q"}}) {
    const outcome result = run(far);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.find("nearest"), std::string::npos) << result.err;
  }
}

TEST(Options, HelpAndVersionHaveOtherForms) {
  EXPECT_EQ(certified({"help"}), certified({"--help"}));
  EXPECT_EQ(certified({"help", "integrate"}), certified({"integrate", "--help"}));
  EXPECT_EQ(certified({"-V"}), certified({"--version"}));
  expect_refused({"help", "integrat"}, {"nearest is integrate"});
  expect_refused({"help", "eval", "roots"}, {"\"roots\""});
}

TEST(CertificateOption, CreatesNoDirectory) {
  const scratch_directory scratch;
  for (const words& command : std::vector<words>{
           {"integrate", "x", "0", "1"}, {"roots", "x-1/3", "0", "1"}, {"constants", "beta"}}) {
    words arguments = command;
    arguments.insert(arguments.end(), {"--certificate", scratch.path("new/c.json")});
    expect_refused(arguments, {"--certificate", "no directory", "create it"});
    EXPECT_TRUE(names_in(scratch.path("")).empty());
  }
}

// ---------------------------------------------------------------------------------------------
// polhode check

TEST(CheckAsJson, SaysWhatBecameOfEachFile) {
  const scratch_directory scratch;
  const std::string good = scratch.path("good.json");
  const std::string forged = scratch.path("forged.json");
  const std::string empty = scratch.path("empty.json");
  certified({"integrate", "4/(1+x^2)", "0", "1", "--certificate", good});
  std::string text = contents(good);
  text.replace(text.find("\"lower\": \"3."), 12, "\"lower\": \"2.");
  std::ofstream(forged) << text;
  std::ofstream(empty) << "{}";
  const outcome result =
      run({"check", "--format", "json", good, forged, empty, scratch.path("none.json")});
  EXPECT_EQ(result.status, 2);
  const json all = json::parse(result.out);
  EXPECT_EQ(all["format"], "polhode check");
  EXPECT_EQ(all["version"], 2);
  EXPECT_EQ(all["verified"], false);
  ASSERT_EQ(all["files"].size(), 4U);
  const json& first = all["files"][0];
  EXPECT_EQ(first["file"], good);
  EXPECT_EQ(first["verdict"], "verified");
  EXPECT_EQ(first["subject"], "integral");
  EXPECT_EQ(first["statement"][0], "the integral of 4/(1 + x^2) over x from 0 to 1");
  EXPECT_EQ(first["rests_on"][0], "enclosed");
  EXPECT_FALSE(first["facts"].empty());
  const json& second = all["files"][1];
  EXPECT_EQ(second["verdict"], "refuted");
  EXPECT_FALSE(second["place"].get<std::string>().empty());
  EXPECT_FALSE(second["reason"].get<std::string>().empty());
  EXPECT_FALSE(second.contains("statement"));
  EXPECT_EQ(all["files"][2]["verdict"], "malformed");
  EXPECT_EQ(all["files"][3]["verdict"], "not read");
  const json whole = json::parse(certified({"check", "--format", "json", good}));
  EXPECT_EQ(whole["verified"], true);
  expect_refused({"check", good, "--format", "xml"}, {"--format", "text, json"});
}

TEST(Check, ReportsEachFaultOnce) {
  const scratch_directory scratch;
  const std::string empty = scratch.path("empty.json");
  std::ofstream(empty) << "{}";
  const outcome result = run({"check", scratch.path("none.json"), empty});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "2 certificates: 0 verified\n");
  const std::vector<std::string> lines = lines_of(result.err);
  ASSERT_EQ(lines.size(), 2U) << result.err;
  EXPECT_EQ(lines[0].rfind("polhode: " + scratch.path("none.json") + ": not read: ", 0), 0U);
  EXPECT_EQ(lines[1].rfind("polhode: " + empty + ": malformed: at ", 0), 0U);
}

}  // namespace door_test
}  // namespace polhode::test

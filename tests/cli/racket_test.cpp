// polhode racket, curve and table: what is printed, exit statuses, refusals.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "program.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace racket_test {

TEST(RacketCommand, PrintsTheTwists) {
  EXPECT_EQ(certified({"racket", "--ab", "39.95,0.0629", "--digits", "12", "--c", "-0.03"}),
            "non-physical (ab + 2b > 1): no mass distribution has these moments\n"
            "epsilon(c) is not injective\n"
            "epsilon0 = 0.0128995391459...\n"
            "c0 = 0.0000418182972729...\n"
            "full turn at c = 0.00575123957004...\n"
            "points where C meets S: 2; where it crosses epsilon = pi/2: 1\n"
            "meets S at c = -0.0000419148565559..., epsilon = 0.0258170677743...\n"
            "crosses pi/2 at c = -0.00652918154567...\n"
            "meets S at c = -0.0403010291282..., epsilon = 2.21355156014...\n"
            "epsilon(c) = 2.33946528330...\n"
            "d epsilon/dc = 6.94564862500...\n"
            "oscillating, branch 1\n");
  EXPECT_EQ(certified({"racket", "--ab", "1/10,1/10", "--digits", "5"}),
            "physical (ab + 2b < 1)\nepsilon(c) is injective\nepsilon0 = 1.1074...\n"
            "c0: there is no perfect twist, since J >= 2\n"
            "there is no full turn, since J >= 1\n"
            "points where C meets S: 0; where it crosses epsilon = pi/2: 0\n");
}

TEST(RacketCommand, HardCase) {
  const json result = json::parse(certified(
      {"racket", "--ab", "1e4,0.5", "--digits", "44", "--meetings", "3", "--format", "json"}));
  EXPECT_EQ(result.at("c0").at("value"), "3.2872039529379814758201731819069049779972171e-193");
  EXPECT_EQ(result.at("intersections_with_s"), 141);
  EXPECT_EQ(result.at("crossings_of_half_pi"), 141);
  EXPECT_EQ(result.at("meetings").size(), 3U);
  EXPECT_EQ(result.at("injective"), false);
  expect_enclosure(result.at("epsilon0"), 44);
  expect_enclosure(result.at("full_turn"), 44);
  for (const json& m : result.at("meetings")) {
    expect_enclosure(m.at("c"), 44);
    EXPECT_EQ(m.contains("epsilon"), m.at("kind") == "intersection");
  }
}

TEST(RacketCommand, SaysWhatIsBeyondTheExponentsAndPrintsTheRest) {
  const outcome result =
      run({"racket", "--ab", "1e40,0.5", "--digits", "5", "--meetings", "2", "--c", "1e39"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("epsilon(c) is not injective\n"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("points where C meets S: 141421356237309504880; "), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("not certified to 5 digits: epsilon0\n  (for so large an a b it may "
                            "be below the exponents"),
            std::string::npos)
      << result.out;
  EXPECT_EQ(result.out.find("epsilon0 ="), std::string::npos);
  EXPECT_NE(result.out.find("epsilon(c) = "), std::string::npos) << result.out;
  const outcome as_json =
      run({"racket", "--ab", "1e40,0.5", "--digits", "5", "--meetings", "2", "--format", "json"});
  EXPECT_EQ(as_json.status, 1);
  const json read = json::parse(as_json.out);
  EXPECT_EQ(read.at("verdict"), "not certified");
  EXPECT_TRUE(read.at("epsilon0").is_null());
  EXPECT_EQ(read.at("not_certified")[0].at("what"), "epsilon0");
}

TEST(RacketCommand, RefusesBadInput) {
  expect_refused({"racket"}, {"no body"});
  expect_refused({"racket", "--ab", "2,1/4", "--c", "2"}, {"equilibrium about z", "a = 2"});
  expect_refused({"racket", "--ab", "2,1/4", "--c", "-1/4"}, {"equilibrium about x"});
  expect_refused({"racket", "--ab", "2,1/4", "--c", "3"}, {"--c \"3\""});
  expect_refused({"racket", "--ab", "2,1/4", "--meetings", "-1"}, {"--meetings \"-1\""});
  expect_refused({"racket", "--moments", "2,2,1"}, {"symmetric top"});
  expect_refused({"racket", "--ab", "2,1/4", "--digits", "0"}, {"--digits"});
  expect_refused({"racket", "--ab", "2,1/4", "--digits", "1000000000"}, {"GiB"});
}

TEST(CurveCommand, CsvAndJson) {
  EXPECT_EQ(
      certified({"curve", "--ab", "12.65,0.0629", "--points", "5"}),
      "c,c_exact,epsilon,radius,lower,upper,digits,epsilon_of_s,epsilon_of_s_radius,remark\n"
      "-0.05032,-629/"
      "12500,1.41955541963756,1.9e-15,1.41955541963756187,1.41955541963756188,15,1.10714871779409,"
      "5.1e-16,\n"
      "-0.02516,-629/25000,0.916008835358980,2.2e-16,0.916008835358980215,0.916008835358980216,15,"
      "0.684719203002282,9.2e-16,\n"
      "0,0,0.113594382341433,3.9e-16,0.113594382341433383,0.113594382341433384,15,0,0,\n"
      "0.02516,629/"
      "25000,-0.819202695115456,5.3e-17,-0.819202695115456053,-0.819202695115456052,15,,,no point "
      "of S at c > 0\n"
      "0.05032,629/"
      "12500,-1.63819777593649,4.4e-15,-1.63819777593649431,-1.6381977759364943,15,,,no point of S "
      "at c > 0\n");
  const json result = json::parse(
      certified({"curve", "--ab", "2,1/4", "--c", "-1/4..2", "--points", "9", "--format", "json"}));
  ASSERT_EQ(result.at("points").size(), 9U);
  EXPECT_EQ(result.at("points")[0].at("c").at("rational"), "-1/8");
  EXPECT_EQ(result.at("points")[8].at("c").at("rational"), "15/8");
  for (const json& point : result.at("points")) {
    expect_enclosure(point.at("epsilon"), 15);
    EXPECT_EQ(point.contains("epsilon_of_s"), point.at("c").at("rational") == "-1/8");
  }
  EXPECT_EQ(result.at("points")[0].at("epsilon_of_s").at("value"), "0.785398163397448");  // pi/4
}

TEST(CurveCommand, SvgWhereGnuplotIs) {
  const outcome result = run({"curve", "--ab", "2,1/4", "--points", "20", "--format", "svg"});
  if (result.status == 0) {
    EXPECT_NE(result.out.find("<svg"), std::string::npos);
    EXPECT_NE(result.out.find("</svg>"), std::string::npos);
  } else {
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("gnuplot"), std::string::npos);
  }
}

TEST(CurveCommand, RefusesBadInput) {
  expect_refused({"curve", "--ab", "2,1/4", "--points", "0"}, {"--points"});
  expect_refused({"curve", "--ab", "2,1/4", "--c", "-1..1"}, {"c = -1", "-1/4"});
  expect_refused({"curve", "--ab", "2,1/4", "--c", "1..0"}, {"below"});
  expect_refused({"curve", "--ab", "2,1/4", "--c", "0..1/x"}, {"LO..HI"});
  expect_refused({"curve", "--ab", "2,1/4", "--c", "0"}, {"LO..HI"});
  expect_refused({"curve", "--ab", "2,1/4", "--format", "svg", "--points", "1"}, {"at least 2"});
}

TEST(TableCommand, Csv) {
  EXPECT_EQ(certified({"table", "phase", "--ab", "12.65,0.0629", "--c", "-0.06..-0.01/2",
                       "--digits", "10"}),
            "a,a_exact,b,b_exact,c,c_exact,phase,radius,lower,upper,digits\n"
            "12.65,253/20,0.0629,629/10000,-0.06,-3/"
            "50,6.673109757,4.6e-10,6.67310975745,6.673109757451,10\n"
            "12.65,253/20,0.0629,629/10000,-0.035,-7/"
            "200,7.708621444,7.7e-10,7.708621444764,7.708621444765,10\n"
            "12.65,253/20,0.0629,629/10000,-0.01,-1/"
            "100,10.25608489,2e-9,10.25608489197,10.25608489198,10\n");
  // Several bodies, a third that is no decimal, and a quantity without a motion.
  EXPECT_EQ(
      certified({"table", "epsilon0", "--moments", "3,2,1", "--ab", "2,1/4", "--digits", "6"}),
      "a,a_exact,b,b_exact,epsilon0,radius,lower,upper,digits\n"
      "2,2,0.25,1/4,0.161119,4.1e-7,0.161119404,0.161119405,6\n"
      "1,1,0.3333333333333333333333333333333333333333,1/"
      "3,0.210236,3e-7,0.210236295,0.210236296,6\n");
}

TEST(TableCommand, JsonAndCpp) {
  const json result = json::parse(certified({"table", "epsilon", "--ab", "2,1/4", "--c", "0..1/3/4",
                                             "--digits", "20", "--format", "json"}));
  ASSERT_EQ(result.at("rows").size(), 5U);
  EXPECT_EQ(result.at("rows")[4].at("c").at("rational"), "1/3");
  for (const json& row : result.at("rows")) expect_enclosure(row.at("epsilon"), 20);
  const std::string cpp =
      certified({"table", "c0", "--ab", "2,1/4", "--digits", "5", "--format", "cpp"});
  EXPECT_NE(cpp.find("{2.0, 0.25, 0.0255288942837229826160811439352799112744140634152"),
            std::string::npos)
      << cpp;
  EXPECT_NE(cpp.find("\"0.025528\"},"), std::string::npos) << cpp;
}

TEST(TableCommand, RefusesWhatNoDoubleHolds) {
  expect_refused({"table", "c0", "--ab", "1e400,1e-3", "--format", "cpp"},
                 {"a = 1e400", "range of a double", "json"});
  expect_refused({"table", "epsilon0", "--ab", "1,1e-400", "--format", "cpp"}, {"b = 1e-400"});
  expect_refused({"table", "epsilon", "--ab", "2,1/4", "--c", "1e-320", "--format", "cpp"},
                 {"c = 1e-320"});
  expect_refused({"table", "epsilon0", "--ab", "1e308,1e-300", "--format", "cpp"},
                 {"epsilon0 = 3.4473"});
  // What it does hold: great numbers, and 0.
  (void)certified({"table", "epsilon0", "--ab", "1e30,1e-30", "--format", "cpp"});
  (void)certified({"table", "epsilon", "--ab", "2,1/4", "--c", "0", "--format", "cpp"});
}

TEST(RacketCommand, GivesTheLimitForChiAndBeta) {
  // epsilon0_min, and figure 8's end beyond the first turning point.
  EXPECT_NE(certified({"racket", "--limit", "1,0", "--digits", "12"})
                .find("epsilon = 0.0863740970495...\n"),
            std::string::npos);
  EXPECT_NE(certified({"racket", "--limit", "1,-1/5", "--digits", "12"})
                .find("c/b = -1/5\nepsilon = 0.625732879978...\n"),
            std::string::npos);
  const json limit =
      json::parse(certified({"racket", "--limit", "4,-0.9", "--digits", "10", "--format", "json"}));
  EXPECT_EQ(limit.at("chi").at("value"), "4");
  EXPECT_EQ(limit.at("epsilon").at("value"), "1.623230424");
  EXPECT_EQ(limit.at("verdict"), "certified");
  EXPECT_NE(certified({"racket", "--limit", "1,0"}).find("polhode certify limit_formula"),
            std::string::npos);
  expect_refused({"racket", "--limit", "1"}, {"--limit \"1\"", "CHI,BETA"});
  expect_refused({"racket", "--limit", "1,2,3"}, {"two numbers"});
  expect_refused({"racket", "--limit", "0,1"}, {"CHI", "positive"});
  expect_refused({"racket", "--limit", "1,-1"}, {"BETA", "above -1"});
  expect_refused({"racket", "--limit", "1,x"}, {"--limit"});
  expect_refused({"racket", "--limit", "1,0", "--ab", "2,1/4"}, {"no body"});
  expect_refused({"racket", "--limit", "1,0", "--c", "0"}, {"no body"});
}

TEST(TableCommand, IsInfiniteOnTheSeparatrix) {
  const std::string table = certified({"table", "phase", "--ab", "2,1/4", "--c", "-0.1..0.1/2"});
  EXPECT_NE(table.find("\n2,2,0.25,1/4,0,0,inf,0,inf,inf,0\n"), std::string::npos) << table;
  const std::string header =
      certified({"table", "phase", "--ab", "2,1/4", "--c", "-0.1..0.1/2", "--format", "cpp"});
  EXPECT_NE(header.find("{2.0, 0.25, 0.0, std::numeric_limits<double>::infinity(), \"inf\"}"),
            std::string::npos)
      << header;
  const json rows =
      json::parse(certified({"table", "phase", "--ab", "2,1/4", "--c", "0", "--format", "json"}))
          .at("rows");
  EXPECT_EQ(rows.at(0).at("phase").at("value"), "inf");
}

TEST(TableCommand, RefusesBadInput) {
  expect_refused({"table"}, {"no quantity", "epsilon0"});
  expect_refused({"table", "fase", "--ab", "2,1/4"}, {"nearest is phase"});
  expect_refused({"table", "phase", "epsilon", "--ab", "2,1/4"}, {"several quantities"});
  expect_refused({"table", "phase", "--c", "1"}, {"no body"});
  expect_refused({"table", "phase", "--ab", "2,1/4"}, {"--c LO..HI/N"});
  expect_refused({"table", "phase", "--ab", "2,1/4", "--c", "1..2/2"}, {"equilibrium about z"});
  expect_refused({"table", "phase", "--ab", "2,1/4", "--c", "1..4/2"}, {"c = 5/2"});
  expect_refused({"table", "phase", "--ab", "2,1/4", "--c", "0..1"}, {"number of steps"});
  expect_refused({"table", "phase", "--ab", "2,1/4", "--c", "0..1/x"}, {"number of steps"});
  expect_refused({"table", "phase", "--ab", "2,1/4", "--c", "x..1/3"}, {"LO..HI/N"});
  expect_refused({"table", "c0", "--ab", "2,1/4", "--c", "1"}, {"no motion"});
  expect_refused({"table", "c0", "--ab", "2,1/4", "--ab", "0.1,0.1"},
                 {"a = 1/10", "no perfect twist"});
  expect_refused({"table", "c0", "--ab", "2,1/4", "--ab", "1,1"}, {"b = 1"});
}

}  // namespace racket_test
}  // namespace polhode::test

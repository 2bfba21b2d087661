// polhode body and polhode phase: what is printed, exit statuses, refusals.

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "enclosure.hpp"
#include "program.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace body_test {

TEST(BodyCommand, PrintsKindAndConstants) {
  EXPECT_EQ(certified({"body", "--ab", "12.65,0.0629", "--digits", "12"}),
            "a = 253/20 exactly\nb = 629/10000 exactly\nI = 1.04794454120...\n"
            "J = 0.0763786457135...\nphysical (ab + 2b < 1)\n");
  EXPECT_EQ(certified({"body", "--moments", "2, 3, 1"}),
            "I_x = 3 exactly\nI_y = 2 exactly\nI_z = 1 exactly\n"
            "reordered: I_x, I_y, I_z are the 2nd, 1st, 3rd of the moments given\n"
            "a = 1 exactly\nb = 1/3 exactly\nI = 1 exactly\n"
            "J = 0.73205080756887729352744634150587236694280525381038...\n"
            "planar (ab + 2b = 1): physical, with all mass in a plane\n");
  // A non-physical body is computed, and flagged.
  EXPECT_NE(certified({"body", "--ab", "18.27,0.0629"}).find("non-physical"), std::string::npos);
  // The kind is decided where no enclosure of I would tell.
  EXPECT_NE(
      certified({"body", "--ab", "2," + ("0." + std::string(500, '0') + "1"), "--digits", "1"})
          .find("\nphysical"),
      std::string::npos);
}

TEST(BodyCommand, Json) {
  const json result =
      json::parse(certified({"body", "--moments", "7,11,9", "--digits", "30", "--format", "json"}));
  EXPECT_EQ(result.at("kind"), "physical");
  EXPECT_EQ(result.at("verdict"), "certified");
  EXPECT_EQ(result.at("order"), json({2, 3, 1}));
  EXPECT_EQ(result.at("a").at("rational"), "2/7");
  EXPECT_EQ(result.at("moments").at("x").at("value"), "11");
  expect_enclosure(result.at("geometric_constant"), 30);
  expect_enclosure(result.at("second_geometric_constant"), 30);
}

TEST(BodyCommand, UncertainMoments) {
  const outcome undecided = run({"body", "--moments", "3.01,2,1", "--sigma", "0.1,0.1,0.05"});
  EXPECT_EQ(undecided.status, 1);
  EXPECT_NE(undecided.out.find("undecided"), std::string::npos);
  EXPECT_NE(undecided.out.find("I from 0.831 to 1.21\n"), std::string::npos) << undecided.out;
  const std::string decided = certified({"body", "--moments", "2,2,2", "--sigma", "0.1,0,1/10"});
  EXPECT_EQ(decided,
            "the order of the axes is undecided, and so are a, b, I and J\nphysical: all within "
            "these ranges\n");
  const json result = json::parse(
      run({"body", "--moments", "3,2,1", "--sigma", "0.1,0.1,0.1", "--format", "json"}).out);
  EXPECT_EQ(result.at("kind"), "undecided");
  EXPECT_EQ(result.at("verdict"), "not certified");
  expect_refused({"body", "--moments", "3,2,1", "--sigma", "1,1,1"},
                 {"value - sigma = 0", "not positive"});
  expect_refused({"body", "--moments", "3,2,1", "--sigma", "1,-1,1"}, {"sigma"});
  expect_refused({"body", "--ab", "1,0.1", "--sigma", "1,1,1"}, {"--sigma is for --moments"});
}

TEST(BodyCommand, RotationalConstants) {
  // Water in its ground state.
  const json water = json::parse(certified(
      {"body", "--rotational", "9.28,14.52,27.88", "--digits", "45", "--format", "json"}));
  EXPECT_EQ(water.at("geometric_constant").at("value"),
            "0.939995686340632609491131612197346752681353788");
  EXPECT_EQ(water.at("kind"), "non-physical");
  EXPECT_EQ(water.at("moments").at("x").at("rational"), "25/232");
  expect_refused({"body", "--rotational", "9.28,0,1"},
                 {"rotational constants", "0 is not positive"});
  expect_refused({"body", "--rotational", "1,1,2"}, {"symmetric top"});
  expect_refused({"body", "--rotational", "1,2"}, {"3 numbers"});
}

TEST(BodyCommand, Tensors) {
  // The digits of PARI 2.15 at 60 digits, from the roots of the characteristic polynomial.
  const std::string tensor = "2,3,4,0.1,0,-0.2";
  const json phase = json::parse(certified(
      {"phase", "--tensor", tensor, "--c", "-0.03", "--digits", "30", "--format", "json"}));
  EXPECT_EQ(phase.at("phase").at("value"), "22.4213906194275936053102777251");
  const json racket =
      json::parse(certified({"racket", "--tensor", tensor, "--digits", "20", "--format", "json"}));
  EXPECT_EQ(racket.at("epsilon0").at("value"), "0.42624955857481017626");
  EXPECT_EQ(racket.at("c0").at("value"), "0.21511174549601286678");
  const json curve =
      json::parse(certified({"curve", "--tensor", tensor, "--points", "3", "--format", "json"}));
  EXPECT_EQ(curve.at("a").at("value").get<std::string>().substr(0, 12), "0.4932432667");
  EXPECT_FALSE(curve.at("a").contains("rational"));
  // A table has the decimal and no quotient.
  const std::string table = certified({"table", "epsilon0", "--tensor", tensor});
  EXPECT_NE(table.find("\n0.4932432667804524128970723344429371681624,,0.26"), std::string::npos)
      << table;
  expect_refused({"body", "--tensor", "1,2,3"}, {"--tensor", "6 numbers", "2,3,4,0.1,0,-0.2"});
  expect_refused({"body", "--tensor", tensor, "--ab", "1,0.1"}, {"give one of them"});
  expect_refused({"phase", "--tensor", tensor, "--c", "0.5"}, {"to a = 0.493243266780..."});
  expect_refused({"phase", "--tensor", "2,2,2,0,0,0", "--c", "0.5"}, {"moments are equal"});
}

TEST(BodyCommand, UncertaintiesStandBesideTheMoments) {
  EXPECT_EQ(run({"body", "--moments", "3.01±0.1,2,1 +- 0.05"}).out,
            run({"body", "--moments", "3.01,2,1", "--sigma", "0.1,0,0.05"}).out);
  EXPECT_EQ(run({"body", "--moments", "2.5±0.01,2,1.5"}).status, 0);
  expect_refused({"body", "--moments", "3±0.1,2,1", "--sigma", "0.1,0,0"}, {"uncertainties"});
  expect_refused({"curve", "--moments", "3±0.1,2,1"},
                 {"ranges are for body, phase, racket and scenes"});
  expect_refused({"body", "--moments", "3±-0.1,2,1"}, {"negative"});
  expect_refused({"body", "--moments", "3±,2,1"}, {"--moments"});
  expect_refused({"body", "--moments", "1±2,2,1"}, {"--moments"});
  expect_refused({"body", "--moments", "3±0.1,2,1", "--nearest"}, {"uncertainties"});
}

TEST(BodyCommand, WithUncertaintiesHasRangesOfEffects) {
  const std::vector<std::string> phase{"phase",    "--moments", "3.2±0.01,2,1.5±0.01", "--c", "0.1",
                                       "--digits", "10"};
  const outcome of_phase = run(phase);
  EXPECT_EQ(of_phase.status, 0) << of_phase.err;
  EXPECT_NE(of_phase.out.find("  phase_range from 16.322 to 16.75 rad"), std::string::npos)
      << of_phase.out;
  const outcome racket = run({"racket", "--moments", "3.2±0.01,2,1.5±0.01", "--format", "json"});
  EXPECT_EQ(racket.status, 0) << racket.err;
  EXPECT_NE(racket.out.find("\"epsilon0_range\""), std::string::npos) << racket.out;
  expect_refused({"phase", "--moments", "3±0.1,2,1", "--c", "0.1", "--excess"}, {"--excess"});
  expect_refused({"phase", "--moments", "3±0.1,2,1"}, {"--c"});
  expect_refused({"racket", "--moments", "3±0.1,2,1", "--c", "7"}, {"c"});
}

TEST(BodyCommand, NearestPhysicalTensor) {
  // 5, 2, 1 has the excess 2: 13/3, 8/3, 5/3 is planar, at the distance 2/sqrt(3).
  const std::string text = certified({"body", "--tensor", "2,5,1,0,0,0", "--nearest"});
  EXPECT_NE(text.find("at the distance 1.1547005383792515290182975610039149112952035025402...:\n"
                      "  xx = 8/3 exactly\n  yy = 13/3 exactly\n  zz = 5/3 exactly\n"),
            std::string::npos)
      << text;
  const json one = json::parse(
      certified({"body", "--tensor", "5,2,1,0.1,0,-0.2", "--nearest", "--format", "json"}));
  const json& nearest = one.at("nearest");
  // It is a body of its own, planar to all the digits that were printed.
  std::string entries;
  for (const char* name : {"xx", "yy", "zz", "xy", "xz", "yz"}) {
    entries +=
        (entries.empty() ? "" : ",") + nearest.at("tensor").at(name).at("value").get<std::string>();
  }
  const json again = json::parse(certified({"body", "--tensor", entries, "--format", "json"}));
  EXPECT_EQ(again.at("moments").at("x").at("value").get<std::string>().substr(0, 40),
            nearest.at("moments").at("x").at("value").get<std::string>().substr(0, 40));
  EXPECT_FALSE(
      json::parse(certified({"body", "--moments", "3,2.5,2", "--nearest", "--format", "json"}))
          .contains("nearest"));
  expect_refused({"body", "--ab", "1,0.9", "--nearest"}, {"--nearest", "--tensor"});
}

TEST(BodyCommand, ALinkOfARobotIsABody) {
  const scratch_directory scratch;
  const std::string path = scratch.path("robot.urdf");
  std::ofstream(path)
      << "<robot><link name=\"a\"><inertial><inertia ixx=\"3\" iyy=\"2\" izz=\"1.5\"/>"
         "</inertial></link>\n<link name=\"top\"><inertial><inertia ixx=\"1\" "
         "iyy=\"1\" izz=\"1\"/></inertial></link></robot>";
  EXPECT_EQ(certified({"racket", "--body", path + "#a"}),
            certified({"racket", "--moments", "3,2,1.5"}));
  EXPECT_EQ(certified({"table", "epsilon0", "--body", path + "#a", "--body", path + "#a"}),
            certified({"table", "epsilon0", "--moments", "3,2,1.5", "--moments", "3,2,1.5"}));
  expect_refused({"phase", "--body", path, "--c", "0.1"}, {"2 inertias", "\"a\", \"top\""});
  expect_refused({"phase", "--body", path + "#b", "--c", "0.1"}, {"no inertia of \"b\""});
  expect_refused({"phase", "--body", path + "#top", "--c", "0.1"}, {"line 2", "symmetric top"});
}

TEST(BodyCommand, EveryLinkOfARobot) {
  const scratch_directory scratch;
  const std::string path = scratch.path("robot.urdf");
  const auto link = [](const std::string& name, const std::string& inertia) {
    return "<link name=\"" + name + "\"><inertial><origin rpy=\"1 2 3\"/><inertia " + inertia +
           "/></inertial></link>\n";
  };
  const std::string arm = link("arm", R"(ixx="2e-3" iyy="3e-3" izz="4e-3" ixy="1e-4" iyz="-2e-4")");
  const std::string wheel = link("wheel", R"(ixx="1" iyy="1" izz="1.5")");
  std::ofstream(path) << "<robot>\n" << arm << wheel << "</robot>\n";
  const std::string text = certified({"body", path});
  EXPECT_NE(text.find("\nphysical       0.0009226    0.004038    0.002971    0.001989    1.644    "
                      "1.442  arm\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("        -        -  wheel\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n2 links: 2 physical, 0 planar, 0 non-physical, 0 refused\n"),
            std::string::npos)
      << text;
  std::ofstream(path) << "<robot>\n"
                      << arm << link("plank", R"(ixx="5" iyy="2" izz="1")") << "</robot>\n";
  EXPECT_EQ(run({"body", path}).status, 1);
  const json all =
      json::parse(certified({"body", path, "--allow-non-physical", "--format", "json"}));
  EXPECT_EQ(all.at("links").at(1).at("kind"), "non-physical");
  EXPECT_EQ(all.at("links").at(1).at("margin").at("value"), "-2");
  EXPECT_EQ(all.at("links").at(1).at("margin").at("unit"), "kg m^2");
  EXPECT_EQ(all.at("links").at(0).at("geometric_constant").at("digits"), 50);
  std::ofstream(path) << "<robot>\n" << arm << link("bad, \"one\"", R"(ixx="nan")") << "</robot>\n";
  const outcome csv =
      run({"body", path, "--allow-non-physical", "--format", "csv", "--digits", "8"});
  EXPECT_EQ(csv.status, 2) << csv.err;  // no XML: the name has quotes
  std::ofstream(path) << "<robot>\n" << arm << link("bad", R"(ixx="nan")") << "</robot>\n";
  const outcome one =
      run({"body", path, "--allow-non-physical", "--format", "csv", "--digits", "8"});
  EXPECT_EQ(one.status, 1);
  EXPECT_EQ(
      one.out.rfind(
          "link,line,kind,margin,I_x,I_y,I_z,I,J,remark\n\"arm\",2,physical,0.00092261466,", 0),
      0U)
      << one.out;
  EXPECT_NE(one.out.find("\n\"bad\",3,refused,,,,,,,\"line 3: "), std::string::npos) << one.out;
  expect_refused({"body", path, "--ab", "1,0.1"}, {"give no other"});
  expect_refused({"body", scratch.path("none.urdf")}, {"none.urdf"});
  expect_refused({"body", "body.json"}, {"--body FILE"});
  expect_refused({"body", "--ab", "1,0.1", "--format", "csv"}, {"robot's FILE"});
}

TEST(BodyCommand, NamesTheLinksWithoutInertia) {
  const scratch_directory scratch;
  const std::string path = scratch.path("robot.urdf");
  std::ofstream(path) << "<robot><link name='world'/><link name='a'><inertial><inertia ixx='1' "
                         "iyy='2' izz='2.5'/></inertial></link><link name='camera'><visual/></link>"
                         "</robot>\n";
  EXPECT_NE(certified({"body", path}).find("\nwithout <inertial>: world, camera\n1 link: 1 phys"),
            std::string::npos);
  const json all = json::parse(certified({"body", path, "--format", "json"}));
  EXPECT_EQ(all.at("without_inertial"), json({"world", "camera"}));
  EXPECT_NE(certified({"body", path, "--format", "csv"})
                .find("\n\"world\",,without inertial,,,,,,,\n\"camera\""),
            std::string::npos);
}

TEST(BodyCommand, Files) {
  const scratch_directory scratch;
  const std::string path = scratch.path("body.json");
  const auto write = [&](const std::string& text) { std::ofstream(path) << text; };
  const auto body_in = [&](const std::string& text) {
    write(text);
    return certified({"body", "--body", path, "--digits", "5"});
  };
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words) {
    write(text);
    expect_refused({"body", "--body", path}, words);
  };
  const std::string top = certified({"body", "--moments", "3,5/2,1", "--digits", "5"});
  EXPECT_EQ(body_in(R"({"name": "top", "moments": [3, "5/2", 1]})"), top);
  EXPECT_EQ(body_in(R"({"tensor": [[2, -1, 0], [-1, 2, 0], [0, 0, 2.50]]})"), top);
  // Numbers are exact: the decimal is not a double.
  EXPECT_NE(body_in(R"({"ab": [12.65, 0.0629]})").find("b = 629/10000 exactly"), std::string::npos);
  EXPECT_NE(body_in(R"({"ab": [2, 0.25000000000000000000000000000001]})").find("non-physical"),
            std::string::npos);
  EXPECT_NE(body_in(R"({"rotational": [27.88, 14.52, 9.28]})").find("I = 0.93999..."),
            std::string::npos);
  write(R"({"moments": [3.01, 2, 1], "sigma": [0.1, 0.1, 0.05]})");
  EXPECT_EQ(run({"body", "--body", path}).status, 1);
  expect_refused({"curve", "--body", path}, {"sigma", "ranges are for"});
  // Principal moments that are not rational.
  EXPECT_EQ(body_in(R"({"tensor": [[2, -1, 0], [-1, 2, 0.1], [0, 0.1, 2.5]]})"),
            "I_x = 3.0098...\nI_y = 2.4934...\nI_z = 0.99666...\na = 1.5018...\nb = 0.17156...\n"
            "I = 1.5461...\nJ = 0.57815...\nphysical (ab + 2b < 1)\n");
  const std::string tensor = "2,2,2.5,-1,0,0.1";
  for (const std::vector<std::string>& of : {std::vector<std::string>{"body"},
                                             {"racket", "--c", "0.1"},
                                             {"phase", "--c", "-0.1"},
                                             {"curve", "--points", "2"},
                                             {"table", "phase", "--c", "-0.1..0.1/2"}}) {
    const auto with = [&](const std::string& option, const std::string& value) {
      std::vector<std::string> words = of;
      words.insert(words.end(), {option, value, "--digits", "8"});
      return certified(words);
    };
    EXPECT_EQ(with("--body", path), with("--tensor", tensor)) << of.front();
  }
  // A lamina: one moment is the sum of the others, and I = 1.
  EXPECT_EQ(body_in(R"({"tensor": [[2, 1, 0], [1, 3, 0], [0, 0, 5]]})"),
            "I_x = 5 exactly\nI_y = 3.6180...\nI_z = 1.3819...\na = 1.6180...\nb = 0.27639...\n"
            "I = 1 exactly\nJ = 0.49534...\n"
            "planar (ab + 2b = 1): physical, with all mass in a plane\n");
  // A part in 10^300 decides.
  EXPECT_NE(body_in(R"({"tensor": [[2, 1, 0], [1, 3, 1e-300], [0, 1e-300, 5]]})").find("\nnon-"),
            std::string::npos);
  refused(R"({"tensor": [[2, 0, 0], [0, 2, 0], [0, 0, 1]]})", {"two principal moments are equal"});
  refused(R"({"tensor": [[1, 3, 0], [3, 2, 0], [0, 0, 1]]})", {"not positive"});
  refused(R"({"tensor": [[1, 3, 0], [2, 2, 0], [0, 0, 1]]})", {"symmetric"});
  refused(R"({"tensor": [[1e-2000, 0, 0], [0, 2, 0], [0, 0, 1]]})", {"bits"});
  refused(R"({"moments": [3, 2, 1], "ab": [1, 0.5]})", {"several bodies"});
  refused(R"({"moments": [3, 2, 1], "moments": [1, 2, 3]})", {"appears twice"});
  refused(R"({"moment": [3, 2, 1]})", {"\"moment\"", "not known"});
  refused(R"({"moments": [3, 2]})", {"3 numbers"});
  refused(R"({"moments": [3, 2, null]})", {"must hold numbers"});
  refused(R"({"moments": [3, 2, "x"]})", {"\"x\"", "not a number"});
  refused(R"({"moments": [1e400, 2, 1]})", {"exponent", "quotes"});
  refused(R"({"ab": [1, 0.5], "sigma": [0, 0, 0]})", {"sigma"});
  refused(R"({"moments": [3, 2, 1)", {"no JSON from byte"});
  refused("[1, 2]", {"no JSON object"});
  refused("", {"empty"});
  refused(std::string(100'000, '['), {"nested too deeply"});
  refused(std::string(5'000'000, ' '), {"longer than"});
  expect_refused({"body", "--body", scratch.path("missing.json")}, {"No such file"});
  expect_refused({"body", "--body", scratch.path("")}, {"--body"});
  expect_refused({"body", "--body", path, "--sigma", "1,1,1"}, {"--sigma is for --moments"});
}

TEST(BodyCommand, RefusesWhatIsNoBody) {
  expect_refused({"body"}, {"no body", "--ab", "--moments"});
  expect_refused({"body", "--ab", "1,1/2", "--moments", "3,2,1"}, {"one of them"});
  expect_refused({"body", "--ab", "1"}, {"\"1\"", "2 numbers", "12.65,0.0629"});
  expect_refused({"body", "--ab", "1,x"}, {"--ab", "\"1,x\""});
  expect_refused({"body", "--ab", "0,1/2"}, {"symmetric top"});
  expect_refused({"body", "--ab", "-1,1/2"}, {"a = -1", "positive"});
  expect_refused({"body", "--ab", "1,1"}, {"b = 1", "between 0 and 1"});
  expect_refused({"body", "--moments", "1,2"}, {"3 numbers", "3,2,1"});
  expect_refused({"body", "--moments", "2,2,1"}, {"two are equal", "symmetric top"});
  expect_refused({"body", "--moments", "2,0,1"}, {"0 is not positive"});
  expect_refused({"body", "--moments", "2,nan,1"}, {"nan"});
  expect_refused({"body", "--ab", "1,1/2", "--digits", "0"}, {"--digits"});
}

// ---------------------------------------------------------------------------------------------

TEST(PhaseCommand, PrintsTheDigitsOfTheHardCases) {
  const std::vector<std::string> top{"--ab", "12.65,0.0629", "--digits", "44", "--c"};
  const auto first_line = [&](const std::string& c) {
    std::vector<std::string> arguments{"phase"};
    arguments.insert(arguments.end(), top.begin(), top.end());
    arguments.push_back(c);
    return lines_of(certified(arguments)).at(0);
  };
  EXPECT_EQ(first_line("1e-20"), "phase = 102.97516428440435512242550472912352913583304...");
  EXPECT_EQ(first_line("-1e-300"), "phase = 1548.5252048506593064755949029755012390169355...");
}

TEST(PhaseCommand, SaysTheRegime) {
  const auto phase = [](const std::string& c) {
    return certified({"phase", "--ab", "2,1/4", "--digits", "10", "--c", c});
  };
  EXPECT_EQ(phase("-1/8"),
            "phase = 8.218091986...\noscillating\ngreatest lower bound 2 pi I = 6.283185307...\n");
  EXPECT_EQ(lines_of(phase("1"))[1], "rotating");
  EXPECT_EQ(phase("0"), "separatrix: the phase is infinite\n");
  EXPECT_EQ(phase("-1/4"),
            "equilibrium about x: the angular momentum does not move in the body: there is no "
            "phase, but a limit for c towards this end\nlimit 2 pi I = 6.283185307...\n");
  EXPECT_NE(phase("2").find("limit 2 pi J = 2.6"), std::string::npos) << phase("2");
  EXPECT_NE(certified({"phase", "--ab", "18.27,0.0629", "--c", "-0.01"}).find("non-physical"),
            std::string::npos);
}

TEST(PhaseCommand, JsonWithTheExcess) {
  const json result =
      json::parse(certified({"phase", "--ab", "12.65,0.0629", "--c", "-0.0628999999999999999999",
                             "--excess", "--digits", "40", "--format", "json"}));
  EXPECT_EQ(result.at("regime"), "oscillating");
  EXPECT_EQ(result.at("verdict"), "certified");
  expect_enclosure(result.at("phase"), 40);
  expect_enclosure(result.at("greatest_lower_bound"), 40);
  EXPECT_EQ(result.at("excess").at("digits"), 40);
  EXPECT_EQ(result.at("excess").at("value").get<std::string>().rfind("2.98", 0), 0U)
      << result.at("excess");
  const json infinite =
      json::parse(certified({"phase", "--ab", "2,1/4", "--c", "0", "--format", "json"}));
  EXPECT_TRUE(infinite.at("phase").is_null());
  EXPECT_EQ(infinite.at("remark"), "the phase is infinite");
}

TEST(PhaseCommand, Parts) {
  const json result = json::parse(certified(
      {"phase", "--ab", "2,1/4", "--c", "-1/8", "--parts", "--digits", "20", "--format", "json"}));
  expect_enclosure(result.at("dynamic"), 20);
  expect_enclosure(result.at("geometric"), 20);
  expect_enclosure(result.at("period"), 20);
  const auto number = [&](const char* name) {
    return parse_rational(result.at(name).at("value").get<std::string>());
  };
  const rational sum(number("dynamic") + number("geometric") - number("phase"));
  EXPECT_LT(abs(sum), parse_rational("1e-17"));
  EXPECT_LT(abs(rational(number("dynamic") - rational(7, 8) * number("period"))),
            parse_rational("1e-17"));
}

TEST(PhaseCommand, RefusesBadInput) {
  expect_refused({"phase", "--ab", "2,1/4"}, {"no motion", "--c"});
  expect_refused({"phase", "--c", "1"}, {"no body"});
  expect_refused({"phase", "--ab", "2,1/4", "--c", "3"}, {"--c \"3\"", "-1/4", "a = 2"});
  expect_refused({"phase", "--ab", "2,1/4", "--c", "-0.26"}, {"--c \"-0.26\"", "from -b = -1/4"});
  expect_refused({"phase", "--ab", "2,1/4", "--c", "inf"}, {"--c", "inf"});
  expect_refused({"phase", "--ab", "2,1/4", "--c", "1", "--digits", "1000000000"}, {"memory"});
}

}  // namespace body_test
}  // namespace polhode::test

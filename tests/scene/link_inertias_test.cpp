// Every link of a robot description.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/scene/link_inertias.hpp"
#include "support/random.hpp"

namespace polhode {
namespace link_inertias_test {

std::string link(const std::string& name, const std::string& inertia,
                 const std::string& origin = "") {
  return "<link name=\"" + name + "\">\n<inertial>" + origin + inertia + "</inertial>\n</link>\n";
}
std::string entries(const std::string& xx, const std::string& yy, const std::string& zz,
                    const std::string& xy = "0", const std::string& xz = "0",
                    const std::string& yz = "0") {
  return "<inertia ixx=\"" + xx + "\" iyy=\"" + yy + "\" izz=\"" + zz + "\" ixy=\"" + xy +
         "\" ixz=\"" + xz + "\" iyz=\"" + yz + "\"/>";
}
std::vector<link_inertia> links_of(const std::string& links) {
  return read_link_inertias("<robot>\n" + links + "</robot>\n");
}

TEST(LinkInertias, OneBadLinkCostsOnlyItself) {
  const std::vector<link_inertia> links = links_of(
      link("arm", entries("0.3", "0.2", "0.15")) +
      link("turned", entries("3", "2", "1.5"), "<origin rpy=\"0 0.7853981634 nan\"/>") +
      link("nan", entries("nan", "2", "1")) + link("negative", entries("1", "-2", "1")) +
      link("missing", "") + link("short", "<inertia ixx=\"1\" iyy=\"2\"/>") +
      link("zero", entries("0", "0", "0")) + link("huge", entries("1e308", "1e308", "1.5e308")) +
      link("last", entries("5", "2", "1")));
  ASSERT_EQ(links.size(), 9U);
  EXPECT_EQ(links[0].name, "arm");
  EXPECT_EQ(links[0].line, 3);
  EXPECT_EQ(links[0].problem, "");
  EXPECT_EQ(links[0].kind, body_kind::physical);
  EXPECT_EQ(links[0].margin.exact(), rational(1, 20));
  EXPECT_EQ(links[0].moments[0].exact(), rational(3, 10));
  // A frame that is turned, and how, is of no matter.
  EXPECT_EQ(links[1].problem, "");
  EXPECT_EQ(links[1].kind, body_kind::physical);
  const std::vector<std::string> words{"line 9: <inertia>: ", "line 12: ", "no inertia",
                                       "izz is missing", "not positive"};
  for (std::size_t i = 0; i < words.size(); ++i) {
    EXPECT_NE(links[i + 2].problem.find(words[i]), std::string::npos) << links[i + 2].problem;
  }
  EXPECT_EQ(links[7].kind, body_kind::physical);
  EXPECT_FALSE(links[7].rigid);
  EXPECT_EQ(links[8].kind, body_kind::non_physical);
  EXPECT_EQ(links[8].margin.exact(), -2);
  EXPECT_EQ(links[8].line, 27);
}

TEST(LinkInertias, HaveExactMomentsWhereTheyAreEqual) {
  support::random_source random(393);
  for (support::repeat trial(200); trial.again();) {
    // s E + t n n^T has the moments s, s, s + t |n|^2.
    const auto small = [&](long least) { return rational(random.between(least, 9)); };
    const std::array<rational, 3> n{small(-9), small(-9), small(-9)};
    const rational square(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const rational s(small(1) * 100 + 900);
    const rational t(small(-3));
    const auto at = [&](std::size_t i, std::size_t k) {
      return to_text(rational((i == k ? s : rational(0)) + t * n[i] * n[k]));
    };
    const std::vector<link_inertia> links =
        links_of(link("top", entries(at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(0, 2), at(1, 2))));
    const rational other(s + t * square);
    if (other <= 0) continue;
    ASSERT_EQ(links[0].problem, "");
    EXPECT_FALSE(links[0].rigid);
    EXPECT_EQ(links[0].moments[0].exact(), std::max(s, other));
    EXPECT_EQ(links[0].moments[1].exact(), s);
    EXPECT_EQ(links[0].moments[2].exact(), std::min(s, other));
    EXPECT_EQ(links[0].margin.exact(), 2 * s + other - 2 * std::max(s, other));
  }
  EXPECT_EQ(links_of(link("lamina", entries("1", "1", "2")))[0].kind, body_kind::planar);
}

TEST(LinkInertias, OfIrrationalMomentsAreEnclosed) {
  const std::vector<link_inertia> links =
      links_of(link("plate", entries("2", "3", "5", "1")) +
               link("part", entries("2", "3", "4", "0.1", "0", "-0.2")));
  EXPECT_EQ(links[0].kind, body_kind::planar);
  EXPECT_EQ(links[0].margin.exact(), 0);
  // (5 -+ sqrt 5)/2
  EXPECT_TRUE(overlaps(square(links[0].moments[1].at(200) * 2 - 5), ball(5, 200)));
  ASSERT_TRUE(links[1].rigid);
  const auto& [x, y, z] = links[1].moments;
  EXPECT_TRUE(overlaps((y + z - x).at(200), links[1].margin.at(200)));
  EXPECT_TRUE(overlaps((x + y + z).at(200), ball(9, 200)));
}

TEST(LinkInertias, OfSdfAndMujoco) {
  const std::vector<link_inertia> sdf = read_link_inertias(
      "<sdf><model><link name='a'><inertial><pose>0 0 0 1 2 3</pose><inertia><ixx>3</ixx>"
      "<iyy>2</iyy><izz>2</izz></inertia></inertial></link></model></sdf>");
  ASSERT_EQ(sdf.size(), 1U);
  EXPECT_EQ(sdf[0].margin.exact(), 1);
  const std::vector<link_inertia> mujoco = read_link_inertias(
      "<mujoco><body name='b'><inertial quat='1 2 3 4' diaginertia='3 2 1'/></body>"
      "<body name='c'><inertial euler='1 2 3' fullinertia='2 3 4 0.1 0 -0.2'/></body></mujoco>");
  ASSERT_EQ(mujoco.size(), 2U);
  EXPECT_EQ(mujoco[0].kind, body_kind::planar);
  EXPECT_EQ(mujoco[1].kind, body_kind::physical);
  EXPECT_THROW((void)read_link_inertias("<robot/>"), input_error);
  EXPECT_THROW((void)read_link_inertias("<robot>"), input_error);
}

TEST(LinkInertias, EveryWayToTurnAFrameLeavesTheInvariants) {
  const std::string urdf = "<inertia ixx='1' iyy='2' izz='2.5'/>";
  const std::string sdf = "<inertia><ixx>1</ixx><iyy>2</iyy><izz>2.5</izz></inertia>";
  std::vector<std::string> files;
  for (const char* origin : {"", "<origin/>", "<origin xyz='1 2 3'/>", "<origin rpy='0.1 2 -3'/>",
                             "<origin rpy='0 0 0' xyz='0 0 0'/>"}) {
    files.push_back("<robot>" + link("a", origin + urdf) + "</robot>");
  }
  for (const char* pose :
       {"<pose>1 2 3 0 0 0</pose>", "<pose degrees='true'>0 0 0 10 20 30</pose>",
        "<pose rotation_format='quat_xyzw'>0 0 0 0 0 0.1 1</pose>",
        "<pose rotation_format='euler_rpy' relative_to='b'>0 0 0 1 2 3</pose>"}) {
    files.push_back("<sdf><model><link name='a'><inertial>" + (pose + sdf) +
                    "</inertial></link></model></sdf>");
  }
  for (const char* turned : {"", "quat='1 1 0 0'", "euler='1 2 3'", "axisangle='1 0 0 0.3'",
                             "xyaxes='1 0 0 0 0 1'", "zaxis='0 1 1'"}) {
    files.push_back(
        "<mujoco><compiler angle='radian' eulerseq='zyx'/><worldbody><body name='a'>"
        "<inertial pos='0 0 1' mass='1' diaginertia='1 2 2.5' " +
        std::string(turned) + "/></body></worldbody></mujoco>");
  }
  for (const std::string& text : files) {
    const std::vector<link_inertia> links = read_link_inertias(text);
    ASSERT_EQ(links.size(), 1U) << text;
    EXPECT_EQ(links[0].problem, "") << text;
    EXPECT_EQ(links[0].margin.exact(), rational(1, 2)) << text;
    EXPECT_EQ(links[0].kind, body_kind::physical) << text;
    EXPECT_TRUE(links_without_inertia(text).empty()) << text;
  }
}

TEST(LinkInertias, BadFilesAreRefusedInOneSentence) {
  const std::string good = link("a", entries("1", "2", "2.5"));
  // Entities are not expanded, and no other file is read.
  std::string bomb = "<!DOCTYPE r [<!ENTITY a \"aaaaaaaaaa\">";
  for (char c = 'b'; c < 'z'; ++c) {
    bomb += std::string("<!ENTITY ") + c + " \"";
    for (int k = 0; k < 10; ++k) bomb += std::string("&") + static_cast<char>(c - 1) + ";";
    bomb += "\">";
  }
  bomb += "]><robot name='&y;'>" + good + "</robot>";
  EXPECT_EQ(read_link_inertias(bomb).size(), 1U);
  EXPECT_EQ(read_link_inertias("<mujoco><include file='self.xml'/><body name='b'><inertial "
                               "diaginertia='3 2 1'/></body></mujoco>")
                .size(),
            1U);
  std::string deep;
  for (int k = 0; k < 20'000; ++k) deep += "<link name='a'>";
  for (const std::string& text :
       {std::string(), std::string("no XML"), "<robot>" + good, deep, std::string("\xff\xfe<"),
        std::string(1000, '\0'), std::string("<robot><link name='a'/></robot>"),
        good.substr(0, good.size() / 2)}) {
    try {
      (void)read_link_inertias(text);
      ADD_FAILURE() << text.substr(0, 100);
    } catch (const input_error& error) {
      const std::string why = error.what();
      EXPECT_EQ(why.find('\n'), std::string::npos) << why;
      EXPECT_LT(why.size(), 300U) << why;
    }
  }
  // Numbers of any size, and none.
  const std::vector<link_inertia> links = links_of(
      link("great", entries("1e308", "2e308", "2.5e308")) +
      link("small", entries("1e-308", "2e-308", "2.5e-308")) +
      link("inf", entries("inf", "1", "1")) + link("unit", entries("1 kg", "1", "1")) +
      link("twice", entries("1", "1", "1") + entries("2", "2", "2")) +
      link("hexadecimal", entries("0x1p3", "1", "1")) + link("empty", entries("", "1", "1")));
  ASSERT_EQ(links.size(), 7U);
  EXPECT_EQ(links[0].kind, body_kind::physical);
  EXPECT_EQ(links[1].kind, body_kind::physical);
  for (std::size_t i = 2; i < links.size(); ++i) EXPECT_NE(links[i].problem, "") << links[i].name;
}

TEST(LinkInertias, LinksWithoutInertiaAreNamed) {
  EXPECT_EQ(links_without_inertia("<robot><link name='world'/><link name='a'><inertial/></link>"
                                  "<joint name='j'/></robot>"),
            std::vector<std::string>{"world"});
  EXPECT_EQ(links_without_inertia("<mujoco><worldbody><body name='b'><geom size='1'/><body "
                                  "name='c'><inertial/></body></body></worldbody></mujoco>"),
            std::vector<std::string>{"b"});
}

}  // namespace link_inertias_test
}  // namespace polhode
